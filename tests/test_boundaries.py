"""Borders of the architecture that import-linter does not see."""

import ast
import os
import re
import subprocess
import sys
from dataclasses import fields

import pytest

from core.case.hold import Bars
from core.case.loads import Load, ReturnWalls
from core.case.solids import Opening, Solid, Step, Wedges
from core.case.wall import Wall
from tests.conftest import ROOT
from tests.trees import nodes_of, tree_of

SOURCES = sorted([*(ROOT / "core").rglob("*.py"), *(ROOT / "app").rglob("*.py")])


MAX_LINES, MAX_BRANCHES = 80, 25
BRANCHES = (ast.If, ast.For, ast.While, ast.IfExp, ast.BoolOp, ast.ExceptHandler, ast.comprehension, ast.match_case)


def _lines_of(function) -> int:
    """Lines of a function from `def` to its end, without its docstring."""
    first = function.body[0]
    described = first.end_lineno - first.lineno + 1 if ast.get_docstring(function) is not None else 0
    return function.end_lineno - function.lineno + 1 - described


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_that_no_function_is_longer_than_a_step_of_the_calculation(source):
    """A kernel alone may be longer, whose docstring says why in a sentence that begins with "Length:"."""
    functions = [n for n in nodes_of(source) if isinstance(n, ast.FunctionDef)]
    long = {function.name: _lines_of(function) for function in functions if _lines_of(function) > MAX_LINES}
    if source.is_relative_to(ROOT / "core" / "rocking"):
        reasons = {n.name for n in functions if re.search(r"^\s*Length: \w", ast.get_docstring(n) or "", re.MULTILINE)}
        assert reasons == set(long)
    else:
        assert long == {}
    branches = {function.name: sum(isinstance(n, BRANCHES) for n in ast.walk(function)) for function in functions}
    assert {name: count for name, count in branches.items() if count > MAX_BRANCHES} == {}


ONE_STEP, ORDER = "tests/validation/test_one_step.py", "tests/validation/test_method_order.py"
WORKBOOK, RUN = "tests/core/report/test_workbook.py", "tests/core/study/test_run.py"
STATED = "tests/core/report/stated/test_study.py"
LAW, LARGE = "tests/core/lab/research/test_law_study.py", "tests/core/study/test_large_case.py"
STUDY = "tests/app/test_study.py"
SELECTION = "tests/core/setting/test_record_selection.py"
SENTENCES = "tests/core/text/test_catalogue.py"
DIALECTS = "tests/core/ground/test_dialects.py"
REFUSALS = "tests/core/ground/test_record_refusals.py"
BODIES = "tests/validation/test_bodies.py"

SOLVED = "tests/core/lab/solved/test_cases.py"

SHOWN_BY = {
    **dict.fromkeys(("study/register", "report/register_words"), "tests/core/case/test_register.py"),
    **{
        f"case/mechanisms/{name}": "tests/core/case/test_mechanisms.py"
        for name in (
            *("mechanism", "registry", "turning", "overturning", "vertical_bending", "horizontal_bending"),
            *("corner", "leaf", "part_above", "direction"),
        )
    },
    **{
        f"report/{name}": "tests/core/report/test_tables.py" for name in ("record_tables", "sheet_table", "wall_tables")
    },
    "report/words": "tests/core/report/test_tables.py",
    "decoding": "tests/core/case/test_number_rows.py",
    "wall/load_kinds": "tests/core/wall/test_kinematics.py",
    "setting/held_shares": "tests/core/case/test_held_stretches.py",
    "case/above_holds": "tests/core/case/test_held_stretches.py",
    "codes/bending_outline": "tests/core/codes/test_vertical_bending.py",
    "rocking/held_bars": "tests/core/rocking/test_held_top_with_bars.py",
    "setting/held_histories": "tests/core/mechanism/test_holds.py",
    "variation/hold_check": "tests/core/mechanism/test_holds.py",
    "variation/turning_holds": "tests/core/mechanism/test_turning_reactions.py",
    "codes/annex": "tests/core/codes/test_spectrum_codes.py",
    "report/note/plan_figure": "tests/core/report/test_key_plan.py",
    "report/note/brief": "tests/core/report/test_pdf.py",
    "report/note/record_parts": "tests/core/report/test_selection_rows.py",
    "codes/evidence": "tests/core/codes/test_verdict.py",
    "case/hold_rules": "tests/core/case/test_hold.py",
    "case/asked": "tests/core/variation/test_second_level.py",
    "case/document": "tests/core/case/test_rules.py",
    "derivation/arch": "tests/core/derivation/test_wall.py",
    "report/note/arch_figure": "tests/core/report/test_bending_figure.py",
    "case/wall_columns": "tests/core/case/test_wall_table.py",
    **dict.fromkeys(
        ("wall/bending", "rocking/side_functions", "rocking/side_series", "rocking/held_lanes"),
        "tests/core/rocking/test_held_top.py",
    ),
    **{
        f"lab/solved/{name}": SOLVED
        for name in (
            "solved",
            "walls",
            "shipped",
            "motion",
            "histories",
            "paper",
            "clauses",
            "ties",
            "bodies",
            "floors",
            "hazard",
        )
    },
    "variation/favourable_input": "tests/core/variation/test_table_of_assumptions.py",
    "variation/changes": "tests/core/variation/test_wall_evaluation.py",
    "codes/outcomes": "tests/core/variation/test_one_decision.py",
    "capacity/bisection": "tests/core/capacity/test_ida.py",
    "case/select": SELECTION,
    "ground/record_folder": SELECTION,
    "report/selection_words": "tests/core/report/test_selection_rows.py",
    "report/note/spectra_figure": "tests/core/report/test_selection_rows.py",
    "case/note_file": "tests/core/report/test_pdf.py",
    "report/note/document_subject": "tests/app/test_verification.py",
    "lab/research/pack": "tests/app/test_study.py",
    "lab/research/motion_archive": "tests/core/lab/research/test_shake_table.py",
    "report/case_text": "tests/app/test_verification.py",
    "mechanism/sections": "tests/core/mechanism/test_rest.py",
    "case/case_files": "tests/app/test_verification.py",
    "case/variant_names": "tests/core/case/test_variant_of.py",
    "report/columns": LARGE,
    "study/executors": "tests/core/study/test_scheduler.py",
    "report/parquet_file": LARGE,
    **{f"report/stated/{name}": STATED for name in ("quantity", "records", "walls", "checks", "verdicts")},
    "report/large_report": LARGE,
    "case/sensitivity": "tests/core/variation/test_sensitivity.py",
    "variation/swings": "tests/core/variation/test_sensitivity.py",
    "report/uncertainty_text": "tests/core/report/test_certainty.py",
    "report/certainty_sheet": "tests/core/report/test_certainty.py",
    "report/note/picture": "tests/core/report/test_picture.py",
    "report/note/certainty": "tests/core/report/test_certainty.py",
    "codes/verdict_sentence": "tests/core/codes/test_verdict.py",
    "atomic_write": "tests/core/test_atomic_write.py",
    "errors": SENTENCES,
    "text/start": "tests/test_run.py",
    "file_names": "tests/app/test_nothing_lost.py",
    "capacity/limit_states": "tests/validation/test_circolare_by_hand.py",
    "capacity/independent_solver": "tests/validation/test_independent_solver.py",
    "case/keys": "tests/core/case/test_schema.py",
    "case/loads": "tests/core/wall/test_ties.py",
    "case/solids": BODIES,
    "case/drawn_solids": "tests/core/case/test_drawing_file.py",
    "report/place_lines": "tests/core/case/test_place.py",
    "wall/impact": "tests/core/wall/test_restitution.py",
    "case/shape": BODIES,
    "case/above_hinge": "tests/core/case/test_hinges.py",
    "case/wall": "tests/core/case/test_schema.py",
    **dict.fromkeys(
        ("ground/records/networks", "ground/records/film", "ground/records/labview"),
        "tests/core/ground/test_networks.py",
    ),
    "ground/records/placement": "tests/core/ground/test_placement.py",
    "ground/records/signatures": "tests/core/ground/test_signatures.py",
    **dict.fromkeys(
        ("ground/records/sample_like", "ground/records/plausible"), "tests/core/ground/test_sample_like.py"
    ),
    "rocking/lanes_on_branch": "tests/core/rocking/test_oscillator.py",
    "rocking/short_series": "tests/validation/test_sine_and_cosine.py",
    "derivation/geometry": "tests/core/derivation/test_wall.py",
    "report/body_sheet": "tests/core/report/test_workbook.py",
    "report/outlines": BODIES,
    "case/schema": "tests/core/case/test_schema.py",
    "case/site": "tests/core/case/test_schema.py",
    "case/values": "tests/core/case/test_rules.py",
    "ground/records/california": DIALECTS,
    "ground/records/channels": DIALECTS,
    "ground/records/container": DIALECTS,
    "ground/records/geonet": DIALECTS,
    "ground/records/japan_taiwan": DIALECTS,
    "ground/records/smc": DIALECTS,
    "ground/records/cut": REFUSALS,
    "ground/records/grammar": REFUSALS,
    "ground/records/italian": REFUSALS,
    "ground/records/peer": REFUSALS,
    "ground/records/plain": REFUSALS,
    "ground/records/plain_head": "tests/core/ground/test_plain_head.py",
    "ground/records/head_units": "tests/core/ground/test_wordings.py",
    "ground/records/wordings": "tests/core/ground/test_wordings.py",
    "ground/records/samples": "tests/core/ground/test_samples.py",
    "jit/kernel": "tests/core/jit/test_decorators.py",
    "rocking/events": "tests/validation/test_energy.py",
    "rocking/history": "tests/validation/test_reference_histories.py",
    "rocking/lane_events": "tests/core/rocking/test_lanes.py",
    "rocking/grounds": "tests/core/rocking/test_lanes.py",
    "rocking/lane_lifecycle": "tests/core/rocking/test_lanes.py",
    "rocking/lane_scheduler": "tests/core/rocking/test_lanes.py",
    "rocking/lane_state": "tests/core/rocking/test_lanes.py",
    "rocking/methods": ORDER,
    "rocking/outcome": "tests/validation/test_energy.py",
    "rocking/taylor": ONE_STEP,
    "rocking/taylor_bounds": ONE_STEP,
    "rocking/taylor_series": ORDER,
    "capacity/scale_free_law": LAW,
    "report/floor_sheet": "tests/core/report/test_workbook.py",
    "lab/research/law_fit": LAW,
    "lab/research/set_means": "tests/core/lab/research/test_parametric.py",
    **{
        f"lab/research/{name}": STUDY
        for name in (
            "figures",
            "paper_claims",
            "paper_figures",
            "paper_sets",
            "paper_tables",
            "study_files",
            "study_report",
            "study_workbook",
        )
    },
    "study/demand_histories": "tests/core/report/test_note.py",
    "study/governing": RUN,
    "study/results": RUN,
    **{
        f"rocking/compared/{name}": ORDER
        for name in (
            "branch",
            "comparison",
            "dormand_prince",
            "linearised",
            "newmark_events",
            "newmark_paper",
            "rk4",
            "stepped",
        )
    },
    **{
        f"report/{name}": WORKBOOK
        for name in (
            "cells",
            "check_sheet",
            "derived",
            "demand_sheets",
            "json_report",
            "input_sheet",
            "load_arrows",
            "derivation_text",
            "verdict_words",
            "risk_sheet",
            "tie_words",
            "plots",
            "rows",
            "sheets",
            "summary_sheet",
        )
    },
    **{
        f"derivation/{name}": "tests/core/derivation/test_wall.py"
        for name in ("bending", "body", "checks", "closed_forms", "demand", "functions", "line", "site")
    },
    "known_internals": "tests/core/jit/test_numba_extensions.py",
    **dict.fromkeys(
        ("rocking/bar_state", "rocking/series_with_bars", "rocking/taylor_with_bars"),
        "tests/validation/test_tied_walls.py",
    ),
    "derivation/quantity": "tests/core/derivation/test_faces.py",
    **{
        f"report/note/{name}": "tests/core/report/test_note.py"
        for name in ("content", "document", "equation", "parts", "site", "wall_figures", "wall_steps")
    },
    **{f"report/note/{name}": "tests/core/report/test_pdf.py" for name in ("archive", "figure_geometry", "pdf")},
    "report/note/bending_figure": "tests/core/report/test_bending_figure.py",
    **dict.fromkeys(
        ("codes/assumption", "codes/masonry_types", "report/assumption_table"),
        "tests/core/variation/test_table_of_assumptions.py",
    ),
    "report/confirmed": "tests/core/report/test_note.py",
    "text/sentence": SENTENCES,
}
"""Module of core -> the file that shows its facts, where that has another name than the module's."""


def test_that_the_test_of_each_module_is_found_by_its_name():
    facts = {path.name for path in (ROOT / "tests").rglob("test_*.py")}
    for source in sorted((ROOT / "core").rglob("*.py")):
        module = source.relative_to(ROOT / "core").with_suffix("").as_posix()
        if source.stem in ("__init__", "units", "version"):
            continue
        mirrored = ROOT / "tests" / "core" / f"{module}.py"
        mirrored = mirrored.with_name(f"test_{mirrored.name}")
        named = ROOT / SHOWN_BY.get(module, "")
        words = f"core/{module}.py has no test: add {mirrored.relative_to(ROOT)}, or say in SHOWN_BY which one shows it"
        assert mirrored.exists() or named.is_file(), words
    assert {path.rsplit("/", 1)[-1] for path in SHOWN_BY.values()} <= facts
    modules = {path.relative_to(ROOT / "core").with_suffix("").as_posix() for path in (ROOT / "core").rglob("*.py")}
    assert set(SHOWN_BY) <= modules
    for module in SHOWN_BY:
        folder, _, name = module.rpartition("/")
        own = ROOT / "tests" / "core" / folder / f"test_{name}.py"
        assert not own.exists() or own == ROOT / SHOWN_BY[module], module


def test_that_the_mutants_have_their_tests_and_their_fixed_stamp():
    from tests.mutation.mutate import BESIDE, FIXED_STAMP, deciding_modules, tests_of

    modules = deciding_modules()
    assert set(BESIDE) <= set(modules)
    for name in {file for module in modules for file in tests_of(module)}:
        path, _, fact = name.partition("::")
        assert f"def {fact}" in (ROOT / path).read_text(encoding="utf-8"), name
    assert FIXED_STAMP[0] in (ROOT / "core" / "jit" / "stamp.py").read_text()


def test_that_importing_a_module_does_no_work(tmp_path):
    """No folder, no variable, no hash of the sources, no compiler: only the import itself."""
    script = (
        "import os, sys; before = dict(os.environ);"
        "import importlib, pathlib;"
        "files = sorted(pathlib.Path('core').rglob('*.py'));"
        "names = ['.'.join(p.with_suffix('').parts) for p in files if p.stem not in ('__init__', 'numba_extensions')];"
        "[importlib.import_module(name) for name in names]; import app.terminal.batch;"
        "from core.jit import cache, stamp;"
        "assert os.environ == before and 'numba' not in sys.modules;"
        "assert not stamp.stamp.is_made() and not cache.folder.is_made();"
        "print(os.listdir(sys.argv[1]))"
    )
    variables = {**os.environ, "RIBALTA_CACHE": str(tmp_path), "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-P", "-c", script, str(tmp_path)], env=variables, cwd=ROOT, capture_output=True, text=True
    )
    assert done.stdout == "[]\n", done.stderr


def test_that_every_public_function_and_class_says_what_it_is():
    bare = []
    for source in SOURCES:
        tree = tree_of(source)
        for node in nodes_of(source):
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
                body = [n for n in node.body if not isinstance(n, ast.Expr)]
                if not ast.get_docstring(node) and len(body) > 6:
                    bare.append(f"{source.name}:{node.name}")
        assert ast.get_docstring(tree) or not tree.body, source
    assert bare == []


KERNELS = ("rocking", "wall", "capacity", "codes", "ground")
"""Packages of core whose functions take numbers and arrays."""


def test_that_a_function_of_many_parameters_gives_each_its_meaning():
    """A line `name : meaning [unit]` of the docstring for each of seven or more, of ten in the rest of core."""
    silent = []
    for source in sorted((ROOT / "core").rglob("*.py")):
        many = 7 if source.relative_to(ROOT / "core").parts[0] in KERNELS else 10
        for node in nodes_of(source):
            if not isinstance(node, ast.FunctionDef):
                continue
            names = {one.arg for one in [*node.args.posonlyargs, *node.args.args]} - {"self", "cls"}
            lines = re.findall(r"^([\w, ]+) : \S", ast.get_docstring(node) or "", re.MULTILINE)
            said = {name for line in lines for name in line.split(", ")}
            if len(names) >= many and names - said:
                silent.append((source.name, node.name, sorted(names - said)))
    assert silent == []


@pytest.mark.shows("records.none_bundled")
def test_that_no_record_of_the_shelf_is_in_the_project(shelf, index):
    import hashlib

    known = {row["sha256"] for row in index.values()}
    for path in ROOT.rglob("*"):
        if path.is_file() and ".git" not in path.parts and ".venv" not in path.parts:
            assert hashlib.sha256(path.read_bytes()).hexdigest() not in known, path


@pytest.mark.shows("records.none_bundled")
def test_that_the_motions_of_the_tests_are_those_the_program_makes(tmp_path):
    from tests.example_motions import write_example_records

    write_example_records(tmp_path)
    for path in sorted((ROOT / "tests" / "motions").glob("*.txt")):
        assert path.read_text() == (tmp_path / path.name).read_text()


PAGE = (ROOT / "resources" / "docs" / "architecture.md").read_text(encoding="utf-8")


def test_that_every_function_the_page_of_the_architecture_names_is_where_it_says():
    rows = re.findall(r"^\| [^|]+ \| (core/[^|]+|app/[^|]+) \|$", PAGE, re.MULTILINE)
    named = 0
    for row in rows:
        file = None
        for path, name in re.findall(r"([\w/]+\.py)|`([\w.]+)`", row):
            if path:
                file = ROOT / path if "/" in path else file.parent / path
                assert file.is_file(), row
            elif file:
                *_, last = name.split(".")
                defined = rf"^\s*(?:def|class) {last}\b|^{last}\b.* = "
                assert re.search(defined, file.read_text(), re.MULTILINE), (row, name)
                named += 1
    assert named > 60


@pytest.mark.parametrize(
    "subject",
    [
        "(NaN) is refused",
        "a cut file is found out",
        "a lane falls back to single steps",
        "exponents of the law",
        "cell formula of zeta",
    ],
)
def test_that_the_page_of_the_architecture_says_where(subject):
    assert re.search(rf"^\| [^|]*{re.escape(subject)}[^|]* \| core/", PAGE, re.MULTILINE)


BELOW_THE_CASE = ("wall", "codes", "ground", "capacity", "rocking")
"""Of core: what knows a wall by its SI quantities alone."""


def test_that_the_mechanics_read_no_key_of_a_wall_of_the_case_and_take_nothing_untyped():
    """A wall in SI is built once, by core/case/wall.py: whoever reads a key below it sees a unit the types do not."""
    of_walls = (Wall, Load, Bars, ReturnWalls, Solid, Opening, Step, Wedges)
    keys = {field.name for of in of_walls for field in fields(of) if field.metadata.get("unit")}
    found = []
    for path in (path for name in BELOW_THE_CASE for path in (ROOT / "core" / name).rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute) and node.attr in keys:
                found.append(f"{path.name}:{node.lineno}: .{node.attr}")
            if isinstance(node, ast.FunctionDef):
                untyped = [arg.arg for arg in node.args.args if arg.annotation is None]
                found += [f"{path.name}:{node.lineno}: {name}" for name in untyped if name in ("wall", "load", "solid")]
    assert found == []
