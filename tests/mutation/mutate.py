"""Are the tests awake? Small faults put into the modules that decide, one at a time; each must fail a test.

    python3 run.py mutate [--faults N] [--journal FILE] [--open] [MODULE ...]

A tool of our own, since mutmut and cosmic-ray run the whole suite for each fault: here a module knows its tests, the
file that mirrors it or shows its facts (tests/test_boundaries.py), and compiled kernels are kept for all runs but those
of faults in a kernel. Faults are drawn by a fixed seed from all places of all modules: comparisons at their limit,
signs, factors, limits moved by a tenth, conditions turned. Those that change nothing are named in `survivors.txt`, each
with its reason, and those that nobody has judged in `open.txt`, which `--open` tries again. With a journal a run that
was stopped goes on where it ended.
"""

import argparse
import ast
import json
import math
import os
import queue
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[2]
HAND = "tests/validation/test_circolare_by_hand.py"
DISPLACEMENT = "tests/validation/test_displacement_demand.py"
READERS = ("tests/core/ground/test_records.py", "tests/core/ground/test_record_refusals.py")
PACKAGES = ("wall", "codes", "case", "setting", "variation", "capacity", "ground")
"""Of core: they decide an outcome."""

SEED = "ribalta"
GOAL = 0.92
"""Share of the faults that the tests of their module are to find."""

PRINTED = "tests/core/codes/test_printed_tables.py"
KEYS = "tests/test_documents.py::test_that_the_page_of_the_case_has_every_key_as_it_is"
CONTACT = "tests/core/case/test_contact.py"
BODIES = "tests/validation/test_bodies.py"
TIES = "tests/core/codes/test_ties_in_the_clauses.py"
LOADS = "tests/core/case/test_load_rules.py"
ASSUMED = "tests/core/variation/test_table_of_assumptions.py"

BESIDE: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(
        [f"core/case/{name}.py" for name in ("place", "schema", "site", "values", "select", "study_file")], (KEYS,)
    ),
    "core/case/drawing_outlines.py": ("tests/core/case/test_drawing_file.py",),
    "core/case/loads.py": (KEYS, LOADS),
    "core/case/solids.py": (KEYS, CONTACT),
    "core/case/wall_table.py": ("tests/core/case/test_many_walls.py", "tests/core/case/test_wall_table_units.py"),
    "core/case/wall_columns.py": ("tests/core/case/test_wall_table.py", "tests/core/case/test_wall_table_units.py"),
    **dict.fromkeys(
        [
            f"core/codes/{name}.py"
            for name in ("floor_spectrum", "masonry_types", "national_hazard", "record_compatibility", "risk")
        ],
        (PRINTED,),
    ),
    "core/codes/target_spectrum.py": (PRINTED,),
    "core/codes/kinematic_chain.py": (TIES, LOADS),
    "core/wall/bars.py": ("tests/validation/test_tied_walls.py",),
    "core/wall/body.py": (BODIES,),
    "core/wall/solids.py": (BODIES, CONTACT),
    "core/case/one_body.py": (CONTACT,),
    "core/case/wall.py": (KEYS, LOADS, "tests/core/wall/test_masonry.py"),
    "core/case/above_hinge.py": (CONTACT,),
    "core/case/shape.py": ("tests/core/case/test_schema.py",),
    "core/case/shape_rules.py": (BODIES,),
    "core/setting/demand_input.py": ("tests/core/codes/test_target_spectrum.py",),
    "core/setting/plan.py": ("tests/core/study/test_run.py",),
    "core/setting/check_input.py": ("tests/core/variation/test_written_is_the_run.py",),
    "core/codes/kinematic.py": (HAND, DISPLACEMENT, PRINTED, TIES),
    "core/codes/dynamic_check.py": (HAND, "tests/core/codes/test_verdict.py", "tests/core/study/test_run.py"),
    "core/codes/verdict.py": (HAND, "tests/core/setting/test_floors.py"),
    "core/codes/evidence.py": (HAND, "tests/core/setting/test_floors.py"),
    "core/codes/limits.py": (PRINTED, "tests/core/case/test_rules.py", "tests/core/case/test_schema.py", HAND),
    "core/codes/collapse_rate.py": ("tests/core/report/test_certainty.py",),
    "core/variation/wall_evaluation.py": (
        "tests/core/variation/test_sensitivity.py",
        "tests/core/variation/test_inverse_design.py",
    ),
    **dict.fromkeys([f"core/variation/favourable_{name}.py" for name in ("wall_inputs", "loads", "site")], (ASSUMED,)),
    "core/variation/assessment.py": ("tests/core/codes/test_verdict.py",),
    "core/variation/evaluate.py": ("tests/core/variation/test_written_is_the_run.py",),
    "core/variation/swings.py": ("tests/core/variation/test_sensitivity.py", "tests/core/report/test_certainty.py"),
    "core/ground/records/grammar.py": READERS,
    "core/ground/records/plain.py": READERS,
    "core/ground/records/cut.py": READERS,
}
"""Module -> tests of its facts in other files than its own."""

COMPARED = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
}
REPLACED = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.And: ast.Or,
    ast.Or: ast.And,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}
SECONDS, SECONDS_WITHOUT = 120, 400
"""Of the tests of a module with a fault, which may have no end, and without one."""

FIXED_STAMP = ('return build().get("kernels") or', 'import os; return os.environ.get("MUTANT_KERNELS") or')
"""Replaced in core/jit/stamp.py: kernels are compiled once for all faults but those put into one."""


class Fault(NamedTuple):
    """place : number of the place among those of its module"""

    module: str
    place: int


def deciding_modules() -> list[str]:
    """All modules of PACKAGES, but those that are empty."""
    files = sorted(file for name in PACKAGES for file in (ROOT / "core" / name).rglob("*.py"))
    return [file.relative_to(ROOT).as_posix() for file in files if file.stem != "__init__"]


def tests_of(module: str) -> list[str]:
    """Files of tests that hold the facts of a module."""
    from tests.test_boundaries import SHOWN_BY, SOLVED

    path = Path(module)
    own = Path("tests") / path.with_name(f"test_{path.name}")
    shown = own.as_posix() if (ROOT / own).exists() else SHOWN_BY[path.relative_to("core").with_suffix("").as_posix()]
    return [shown, *(name for name in BESIDE.get(module, ()) if name != shown), SOLVED]


def faults(tree: ast.Module) -> list[tuple[Any, str]]:
    """(node, attribute) of every place a fault can be put."""
    passed_over = {
        id(part)
        for node in ast.walk(tree)
        for name in ("annotation", "returns")
        if getattr(node, name, None)
        for part in ast.walk(getattr(node, name))
    }
    # nothing assigns to a frozen class: whether it is one no test can see
    passed_over |= {
        id(part)
        for node in ast.walk(tree)
        for decorator in getattr(node, "decorator_list", [])
        for part in ast.walk(decorator)
    }
    found: list[tuple[Any, str]] = []
    for node in ast.walk(tree):
        if id(node) in passed_over:
            continue
        if isinstance(node, ast.Compare) and type(node.ops[0]) in COMPARED:
            found.append((node, "ops"))
        elif isinstance(node, (ast.BinOp, ast.BoolOp)) and type(node.op) in REPLACED:
            texts = isinstance(node, ast.BinOp) and any(
                isinstance(side, (ast.JoinedStr, ast.List)) or isinstance(getattr(side, "value", 0), str)
                for side in (node.left, node.right)
            )
            if not texts:
                found.append((node, "op"))
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            found.append((node, "operand"))
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float, bool):
            found.append((node, "value"))
    return found


def put(node: Any, attribute: str) -> None:
    """Put the fault."""
    if attribute == "ops":
        node.ops[0] = COMPARED[type(node.ops[0])]()
    elif attribute == "op":
        node.op = REPLACED[type(node.op)]()
    elif attribute == "operand":
        node.op = ast.UAdd()
        node.operand = ast.Call(ast.Name("bool", ast.Load()), [node.operand], [])
    elif isinstance(node.value, bool):
        node.value = not node.value
    else:
        node.value = node.value + 1 if isinstance(node.value, int) else node.value * 1.1 or 0.1


def parsed(module: str) -> ast.Module:
    """Syntax tree of a module."""
    return ast.parse((ROOT / module).read_text(encoding="utf-8"))


def drawn(modules: list[str], count: int) -> list[Fault]:
    """At least so many faults of these modules, in each by its share of the places and the seed: a change of another
    module draws no others. All places where there are fewer."""
    places = {module: len(faults(parsed(module))) for module in modules}
    share = count / max(1, sum(places.values()))
    return [
        Fault(module, place)
        for module, n in places.items()
        for place in sorted(random.Random(f"{SEED} {module}").sample(range(n), min(n, math.ceil(n * share))))
    ]


def still_open(modules: list[str]) -> list[Fault]:
    """The faults of these modules that open.txt names, where their lines still stand."""
    listed = set((Path(__file__).parent / "open.txt").read_text(encoding="utf-8").splitlines())
    named = [module for module in modules if any(line.startswith(f"{module}: ") for line in listed)]
    places = [Fault(module, place) for module in named for place in range(len(faults(parsed(module))))]
    return [fault for fault in places if with_fault(fault)[0] in listed]


def with_fault(fault: Fault) -> tuple[str, str]:
    """(words that name a fault, source with it)."""
    source = (ROOT / fault.module).read_text(encoding="utf-8")
    tree = ast.parse(source)
    node, attribute = faults(tree)[fault.place]
    line, before = source.splitlines()[node.lineno - 1].strip(), ast.unparse(node)
    put(node, attribute)
    words = f"{fault.module}: {before} -> {ast.unparse(node)} in {line}"
    return words, ast.unparse(ast.fix_missing_locations(tree))


class Trees:
    """Copies of the project in which tests run side by side, and what each fault came to."""

    def __init__(self, folder: Path, jobs: int):
        self.free: queue.Queue[Path] = queue.Queue()
        for k in range(jobs):
            tree = folder / f"tree{k}"
            shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns(".git", ".venv*", "dist", "build"))
            stamp = tree / "core" / "jit" / "stamp.py"
            stamp.write_text(stamp.read_text().replace(*FIXED_STAMP))
            self.free.put(tree)
        self.environment = {
            "RIBALTA_RECORDS": str(ROOT.parent / "shared" / "records"),
            **os.environ,
            "RIBALTA_CACHE": str(folder / "cache"),
        }

    def passes(self, tests: list[str], module: str = "", source: str = "", kernels: str = "all") -> bool:
        """Whether tests pass in a tree where a module has this source. kernels : what their machine code is kept by"""
        tree = self.free.get()
        try:
            if module:
                (tree / module).write_text(source, encoding="utf-8")
            command = [sys.executable, "-m", "pytest", "-x", "-q", *tests]
            variables = {**self.environment, "PYTHONPATH": str(tree), "MUTANT_KERNELS": kernels}
            seconds = SECONDS if module else SECONDS_WITHOUT
            found = subprocess.run(command, cwd=tree, env=variables, capture_output=True, timeout=seconds)
            return found.returncode == 0
        except subprocess.TimeoutExpired:
            print(f"{module or ' '.join(tests)}: ended by the clock", file=sys.stderr, flush=True)
            return False
        finally:
            if module:
                shutil.copyfile(ROOT / module, tree / module)
            self.free.put(tree)


def tried(asked: list[Fault], folder: Path, jobs: int, done: dict[str, bool]) -> Iterator[tuple[str, bool]]:
    """(words, whether a test failed) of each fault that is not done. Raises SystemExit where tests fail without one."""
    todo = [(fault, *with_fault(fault)) for fault in asked]
    todo = [(fault, words, source) for fault, words, source in todo if words not in done]
    trees, tests = Trees(folder, jobs), {module: tests_of(module) for module in {fault.module for fault, _, _ in todo}}

    def found(item: tuple[Fault, str, str]) -> tuple[str, bool]:
        fault, words, source = item
        is_kernel = "core.jit.decorators" in source
        return words, not trees.passes(tests[fault.module], fault.module, source, words[:200] if is_kernel else "all")

    with ThreadPoolExecutor(jobs) as pool:
        sets = sorted({tuple(files) for files in tests.values()})
        for files, passed in zip(sets, pool.map(lambda files: trees.passes(list(files)), sets), strict=True):
            if not passed:
                sys.exit(f"{' '.join(files)}: fails without a fault")
        yield from pool.map(found, todo)


def main() -> int:
    words = argparse.ArgumentParser()
    words.add_argument("modules", nargs="*")
    words.add_argument("--faults", type=int, default=600, help="drawn from all places of the modules")
    words.add_argument("--open", action="store_true", help="in place of drawn ones the faults that open.txt names")
    words.add_argument("--journal", type=Path, help="what was found so far; a run that was stopped goes on with it")
    words.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = words.parse_args()
    known = (Path(__file__).parent / "survivors.txt").read_text(encoding="utf-8").splitlines()
    modules = options.modules or deciding_modules()
    asked = still_open(modules) if options.open else drawn(modules, options.faults)
    done: dict[str, bool] = {}
    if options.journal and options.journal.exists():
        done = dict(json.loads(line) for line in options.journal.read_text(encoding="utf-8").splitlines())
    with tempfile.TemporaryDirectory() as name:
        for fault, killed in tried(asked, Path(name), options.jobs, done):
            done[fault] = killed and done.get(fault, True)  # equal places of a line have the same words
            if options.journal:
                with options.journal.open("a", encoding="utf-8") as stream:
                    stream.write(json.dumps([fault, killed]) + "\n")
            if not killed and fault not in known:
                print(fault, flush=True)
    results = [done[with_fault(fault)[0]] for fault in asked]
    excused = sum(with_fault(fault)[0] in known and not done[with_fault(fault)[0]] for fault in asked)
    killed, total = sum(results), len(results) - excused
    print(f"{killed} of {total} faults found ({killed / max(total, 1):.0%}); {excused} change nothing, as stated")
    return 0 if killed >= GOAL * total else 1


if __name__ == "__main__":
    sys.exit(main())
