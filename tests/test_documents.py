"""What documents say is what the program does: options, figures, names of what can be chosen. Their commands:
test_documented_commands.py."""

import importlib
import math
import pkgutil
import re
from dataclasses import fields

import pytest

import core.codes
from app.terminal import command_line
from core.case.reader import read_case
from core.case.schema import sections
from core.codes.kinematic import CHECKS
from core.derivation import body, checks, closed_forms, demand
from core.derivation.quantity import Given
from core.ground.records import readers
from core.ground.records.container import is_zip
from core.ground.records.grammar import decode
from core.rocking.methods import METHODS
from core.setting.plan import read_inputs
from core.text.catalogue import CATALOGUE
from core.variation.measures import find_measure, measure_kinds
from core.variation.wall_evaluation import make_wall_context
from core.version import VERSION
from core.wall.moment_rotation import LAWS
from core.wall.restitution import MODELS
from tests.conftest import ROOT
from tests.reference_of_asked import with_tables
from tests.reference_of_keys import with_reference, word_of

CASES = ROOT / "resources" / "cases"


def text_of(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.mark.shows("batch.commands")
def test_that_every_option_is_in_the_page_of_running_it():
    known = [name for action in command_line.parser()._actions for name in action.option_strings]
    for name in known:
        assert name in ("-h", "--help") or name in text_of("resources/docs/run.md"), name


def test_that_seconds_of_the_fuzzer_are_said_as_they_are_meant():
    """Of each target: an hour of all is not `--seconds 3600`."""
    from tests.fuzz import fuzz

    line = next(line for line in text_of("CONTRIBUTING.md").split("\n") if "fuzz --seconds" in line)
    assert "for each target" in line and "for each target" in (ROOT / fuzz.__file__).read_text()


# figures


def test_that_the_documents_name_this_version():
    for name in ("resources/docs/run.md", "packaging/README.md"):
        assert set(re.findall(r"ribalta_rocking-(\d+\.\d+\.\d+)-py3", text_of(name))) <= {VERSION}
    assert f"ribalta_rocking-{VERSION}-py3" in text_of("resources/docs/run.md")


def test_that_the_limits_of_functions_are_those_that_are_tested():
    tests, page = text_of("tests/test_boundaries.py"), " ".join(text_of("CONTRIBUTING.md").split())
    lines, branches = re.search(r"MAX_LINES, MAX_BRANCHES = (\d+), (\d+)", tests).groups()
    assert f"functions are limited to {lines} lines and {branches} branches (a test enforces it)" in page


@pytest.fixture(scope="module")
def first_trial(shipped):
    """The result of the case the first trial of the guide is about."""
    return shipped("verdict")


@pytest.fixture(scope="module")
def facade(shipped):
    """The result of the case of a facade as a body."""
    return shipped("facade")


@pytest.mark.parametrize("name", ["guide/2_facade.md", "guida/2_facciata.md"])
def test_that_the_numbers_of_the_first_trial_come_out(first_trial, name):
    text = text_of(f"resources/docs/{name}")
    facade, gable = first_trial.walls
    check = {one.name: one for one in facade.assessment.checks}
    numbers = [
        facade.assessment.verdict.zeta_e,
        gable.assessment.verdict.zeta_e,
        check["nonlinear"].zeta,
        check["linear_q_code"].zeta,
        facade.q_set,
        facade.q_robust_set,
        gable.q_set,
    ]
    for number in numbers:
        said = f"{number:.2f}"
        assert (said.replace(".", ",") if "guida" in name else said) in text, said


@pytest.mark.long
@pytest.mark.parametrize("name", ["guide/7_bodies.md", "guida/7_corpi.md"])
def test_that_the_numbers_of_the_facade_come_out(facade, name):
    text, rows = text_of(f"resources/docs/{name}"), []
    for check in ("dynamic", "nonlinear", "linear_q_code"):
        bases = [wall for wall in facade.walls if wall.part.turns and wall.part.hinge == 0.0]
        zetas = [next(one.zeta for one in wall.assessment.checks if one.name == check) for wall in bases]
        rows.append(" | ".join(f"{zeta:.2f}" for zeta in zetas))
    alpha = f"{math.degrees(facade.walls[0].wall.block().slenderness):.2f}°"
    for said in (*rows, alpha):
        assert (said.replace(".", ",") if "guida" in name else said) in text, said


@pytest.mark.long
@pytest.mark.parametrize("name", ["guide/3_parapet.md", "guida/3_parapetto.md"])
def test_that_the_numbers_of_the_building_come_out(shipped, fine, name):
    text, walls = text_of(f"resources/docs/{name}"), shipped("building").walls
    turning = [wall for wall in walls if wall.part.turns]
    before, after = ([wall for wall in turning if wall.wall.variant == one] for one in ("stato di fatto", "progetto"))
    pairs = zip(before, after, strict=True)
    said = [" | ".join(f"{one.assessment.verdict.zeta_e:.2f}" for one in pair) for pair in pairs]
    parapet = next(wall for wall in walls if wall.wall.name == "parapet").assessment
    said += [f"{parapet.verdict.zeta_e:.2f} "]
    said += [f"{check.zeta:.2f} " for check in parapet.checks if check.name == "nonlinear"]
    case = read_case(CASES / "building.toml")
    k = next(k for k, wall in enumerate(case.wall) if wall.sought)
    setting = make_wall_context(case, k, CASES, read_inputs(case, CASES))
    kinds = {kind.code: kind for kind in measure_kinds(setting, case.wall[k].sought)}
    assert find_measure(setting, kinds["measure_tie"], lambda: False) is None
    measure = find_measure(setting, kinds["measure_hold"], lambda: False)
    said += [f"{measure.size:g}", f"{measure.zeta:.2f}", *(f"{height:g}" for height in measure.heights)]
    for number in said:
        assert (number.replace(".", ",") if "guida" in name else number) in text, number


# names of what can be chosen


def names_in(page: str) -> set[str]:
    return set(re.findall(r"[a-zA-Z][\w]*", text_of(page)))


def test_that_a_key_without_a_word_is_named_with_what_to_do():
    with pytest.raises(SystemExit, match=r"the key colour_rgb of \[\[wall\]\] has no word: add it to .*key.json"):
        word_of("[[wall]]", "colour_rgb")


@pytest.mark.shows("verdict.documents")
def test_that_the_page_of_the_verdict_has_what_a_clause_asks_as_it_is():
    page = text_of("resources/docs/verdict.md")
    assert page == with_tables(page), "write it anew: .venv/bin/python -m tests.reference_of_asked"


@pytest.mark.shows("case.every_key")
def test_that_the_page_of_the_case_has_every_key_as_it_is():
    page = text_of("resources/docs/case.md")
    assert page == with_reference(page), "write it anew: .venv/bin/python -m tests.reference_of_keys"
    for name, section in sections().items():
        (rows,) = re.findall(rf"\n`{re.escape(name)}`\n\n(.*?)(?:\n\n|\Z)", page, re.S)
        assert [row.split(" | ")[0] for row in rows.splitlines()[2:]] == [
            f"| {field.name}" for field in fields(section)
        ]
    assert {"title", "walls"} <= names_in("resources/docs/case.md")


def test_that_every_model_law_and_method_is_in_the_page_of_the_case():
    assert {*MODELS, *LAWS, *METHODS} <= names_in("resources/docs/case.md")
    assert {"newmark_paper_reset"} <= names_in("resources/docs/study.md")


@pytest.mark.parametrize("title", [title for title, _, _ in readers()])
def test_that_every_format_of_records_is_in_the_documents(title):
    name = title.split(" / ")[0].removesuffix(" AT2").removesuffix(" ASCII").removesuffix(" acc")
    for page in ("README.md", "resources/docs/case.md"):
        assert name in text_of(page), page


def test_that_every_format_of_records_is_fuzzed(tmp_path):
    from tests.fuzz.fuzz import TARGETS, _record, seeds

    reached = set()
    for name, contents in seeds(tmp_path).items():
        if TARGETS[name] is _record:
            for content in contents:
                if not is_zip(content):
                    lines = decode(content)
                    reached.add(next(title for title, knows, _ in readers() if knows(lines)))
    assert reached == {title for title, _, _ in readers()}


CLAUSES = {
    value
    for module in pkgutil.iter_modules(core.codes.__path__, "core.codes.")
    for name, value in vars(importlib.import_module(module.name)).items()
    if name == "CLAUSE" or name.endswith("_CLAUSE")
}
"""Of the checks of a verdict."""


def test_that_every_check_has_its_words_and_its_clause_in_the_documents():
    labels = {*CHECKS, "linear_sld"}
    assert labels <= set(CATALOGUE["word"]) and labels <= set(CATALOGUE["short"])
    assert {f"by_{label}" for label in labels} <= set(CATALOGUE["added"])
    codes = text_of("resources/docs/codes.md")
    for name in CHECKS:
        assert f"`{name}`" in codes and f"`{name}`" in text_of("README.md"), name
    assert len(CLAUSES) > 3
    for clause in CLAUSES:
        assert clause in codes or f".{clause.rsplit('.', 1)[1]}" in codes, clause


def test_that_every_verdict_and_every_check_is_in_the_page_of_the_verdict():
    text = text_of("resources/docs/verdict.md")
    for code in set(CATALOGUE["verdict"]) & set(CATALOGUE["word"]):
        assert f"`{code}`" in text, code
    for clause in CLAUSES:
        last = clause.removeprefix("C8.7.1.2.1")
        assert clause in text or f", {last} |" in text, clause


def test_that_every_clause_of_a_derivation_is_in_the_page_of_the_clauses():
    page = text_of("resources/docs/codes.md")
    modules = [body, checks, closed_forms, demand]
    described = [value for module in modules for value in vars(module).values() if isinstance(value, Given)]
    clauses = {value.clause for value in described if value.clause.startswith(("C8", "C7", "3.2"))}
    assert len(clauses) > 12
    for clause in clauses:
        last = clause.removeprefix("C8.7.1.2.1")
        assert clause in page or f"| {last}" in page or f", {last}" in page, clause


# the page of Python


@pytest.mark.shows("batch.commands")
def test_that_every_block_of_the_page_of_python_runs_after_those_before_it(tmp_path, monkeypatch, capsys):
    """As a reader types them, one after another, in the folder of the program; what they write goes elsewhere."""
    blocks = re.findall(r"```python\n(.*?)```", text_of("resources/docs/python.md"), re.S)
    (tmp_path / "resources").symlink_to(ROOT / "resources", target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    for block in blocks:
        exec(compile(block, "python.md", "exec"), names)
    said = capsys.readouterr().out
    assert "verified" in said and "alpha 5.711 deg" in said and "PGA 0.100 g" in said and len(blocks) == 5
