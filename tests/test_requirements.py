"""Each promise has a test that carries its key; pages and columns made of them are those that are there."""

import ast
import json
import re

import pytest

from app.terminal import command_line
from core.codes.outcomes import OUTCOMES
from core.ground.records import readers
from tests import requirements
from tests.conftest import ROOT
from tests.requirements import Promise, Shown

ANEW = "write it anew: .venv/bin/python -m tests.requirements"

MARKED = """
import pytest
pytestmark = [pytest.mark.shows("of.all")]
@pytest.mark.shows("of.one", "of.two")
@pytest.mark.long
def test_a(): ...
@pytest.mark.parametrize("x", [1, pytest.param(2, marks=[pytest.mark.shows("of.two"), pytest.mark.long])])
def test_b(x): ...
"""


@pytest.fixture(scope="module")
def tests():
    return requirements.tests_by_key()


def test_that_every_promise_has_a_test_and_every_mark_its_promise(tests):
    assert requirements.faults(requirements.promises(), tests) == []


def test_that_the_matrix_and_the_column_of_the_clauses_are_those_of_the_marks(tests):
    assert requirements.MATRIX.read_text(encoding="utf-8") == requirements.matrix(requirements.sections(), tests), ANEW
    page = requirements.CLAUSES.read_text(encoding="utf-8")
    assert page == requirements.with_tests(page, requirements.promises(), tests), ANEW


def test_that_a_promise_is_a_sentence_of_a_page_that_is_there():
    for one in requirements.promises().values():
        assert one.promise.endswith(".") and " " in one.promise and one.source, one.key
        assert not one.page or any((folder / one.page).is_file() for folder in (requirements.DOCS, ROOT)), one.key


def test_that_equations_options_codes_outcomes_and_formats_are_promised():
    """Each Eq. 1 to 16, option and exit code; each outcome and reader stands in a page that a promise is about."""
    known = requirements.promises().values()
    sources = {one.source for one in known}
    assert {f"Eq. {n}" for n in range(1, 17)} <= sources
    said = " ".join(one.promise for one in known)
    options = {name for action in command_line.parser()._actions for name in action.option_strings if name[:2] == "--"}
    assert {option for option in options - {"--help"} if not re.search(rf"{option}\b", said)} == set()
    codes = re.findall(r"(\d+) [a-z]", re.search(r"^Exit codes: (.*?\.) On", page_of("run.md"), re.S | re.M)[1])
    assert {code for code in codes if f"Exit code {code}:" not in said} == set() and len(codes) == 6
    assert {code for code in OUTCOMES if f"`{code}`" not in page_of("verdict.md") + page_of("codes.md")} <= {
        "no_hazard"
    }
    names = {title.split()[0].strip(",") for title, _, _ in readers()} - {"plain"}
    assert {name for name in names if name not in said} == set()


def page_of(name: str) -> str:
    return (requirements.DOCS / name).read_text(encoding="utf-8")


def test_that_marks_are_found_by_decorators_their_points_and_the_file():
    found = requirements.marks_of(ast.parse(MARKED), "f.py")
    a, b = Shown("f.py", "test_a", True), Shown("f.py", "test_b", False)
    assert found == [("of.one", a), ("of.two", a), ("of.all", a), ("of.two", b), ("of.all", b)]
    for lost in ('KEY = "x"\n@pytest.mark.shows(KEY)\ndef test_a(): ...', 'MARK = pytest.mark.shows("of.one")'):
        with pytest.raises(ValueError, match="a key is written as a text|no test carries"):
            requirements.marks_of(ast.parse(lost), "f.py")


def test_that_a_promise_without_a_test_and_a_mark_of_none_are_named():
    tests = {"of.one": [Shown("f.py", "test_a", False)]}
    assert requirements.faults({"of.two"}, tests) == [
        "no test shows of.two: mark one, or write it",
        "f.py test_a: there is no promise of.one",
    ]


def test_that_a_row_of_the_clauses_without_a_promise_is_refused():
    page = "# Page\n## Two\nShown by nobody.\n\n| clause | shown by |\n|---|---|\n| .1 | old |\n"
    known = {
        "of.one": Promise("of.one", "It is.", ".1", "codes.md", ".1"),
        "of.two": Promise("of.two", "", "", "", "Two"),
    }
    tests = {"of.one": [Shown("f.py", "test_a", True)], "of.two": [Shown("g.py", "test_b", False)]}
    made = requirements.with_tests(page, known, tests)
    assert made == page.replace("nobody", "g.py").replace("old", "f.py `test_a` (long)")
    assert requirements.with_tests(made, known, tests) == made
    with pytest.raises(ValueError, match=r"no promise of the rows \['Two'\]"):
        requirements.with_tests(page, {"of.one": known["of.one"]}, tests)
    with pytest.raises(ValueError, match=r"has no rows \['Two'\]"):
        requirements.with_tests(page.replace("Shown by", "By"), known, tests)


JUNIT = """<testsuites><testsuite>
<testcase classname="tests.f" name="test_a[1]"/><testcase classname="tests.f" name="test_a[2]"><failure/></testcase>
<testcase classname="tests.f" name="test_b[1]"><skipped/></testcase><testcase classname="tests.f" name="test_b[2]"/>
<testcase classname="tests.f" name="test_c"><skipped/></testcase>
</testsuite></testsuites>"""


def test_that_the_report_says_of_each_promise_the_worst_of_its_tests(tmp_path):
    (tmp_path / "r.xml").write_text(JUNIT)
    ran = requirements.outcomes(tmp_path / "r.xml")
    assert ran == {
        ("tests/f.py", f"test_{name}"): state
        for name, state in zip("abc", ("failed", "passed", "skipped"), strict=True)
    }
    shown = {name: Shown("tests/f.py", f"test_{name}", name == "d") for name in "abcde"}
    tests = {key: [shown[name] for name in key] for key in ("ab", "bc", "bd", "be", "d")}
    known = {key: Promise(key, "It is.", "Eq. 1", "", "") for key in tests}
    report = requirements.verification(known, tests, ran)
    states = {row["key"]: row["state"] for row in report["promises"]}
    assert states == {"ab": "failed", "bc": "skipped", "bd": "passed", "be": "not run", "d": "long"}
    page = requirements.as_page(json.loads(json.dumps(report)))
    assert "promises: 1 failed, 1 skipped, 1 not run, 1 passed, 1 long" in page and "| failed | `ab` | It is. |" in page
