"""What the program promises and the tests that show it. `.venv/bin/python -m tests.requirements` writes the matrix
resources/docs/requirements.md and the column "shown by" of codes.md, or both into the folder it is given;
`--run FILE` runs the tests that show the promises and writes the verification report FILE and, beside it, its JSON."""

import argparse
import ast
import json
import os
import platform
import re
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from collections.abc import Iterable
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from core.version import line
from tests.conftest import ROOT, shelf_folder
from tests.trees import tree_of

PROMISES = ROOT / "tests" / "requirements.toml"
DOCS = ROOT / "resources" / "docs"
MATRIX, CLAUSES = DOCS / "requirements.md", DOCS / "codes.md"
PACKAGES = ("numpy", "numba", "llvmlite", "openpyxl", "scipy", "typst", "PySide6-Essentials", "ezdxf")
STATES = ("failed", "skipped", "not run", "passed", "long")
"""Of a test and of a promise, which has the first of these that one of its tests has; "long" : not run, see
CONTRIBUTING.md."""

HEAD = """# What the program promises, and the tests that show it

Each promise stands in tests/requirements.toml; a test that shows it carries its key, `@pytest.mark.shows("{key}")`.
This page is written by `.venv/bin/python -m tests.requirements`; a promise without a test stops the suite. Tests named
long run by `python3 run.py test -m long`. The state of each promise on a machine, a report to attach:
`.venv/bin/python -m tests.requirements --run report.md`.

{count} promises, {tests} tests.
"""


class Promise(NamedTuple):
    """One promise of a document.

    source : clause, equation or contract it comes from
    page : of resources/docs, or README.md, CONTRIBUTING.md, ...; "" where only the contract makes it
    row : first cell of a row of codes.md, or a heading of it, whose tests are those of the promise; "" of another page
    """

    key: str
    promise: str
    source: str
    page: str
    row: str


class Shown(NamedTuple):
    """A test that shows a promise; long : run by `-m long` alone."""

    file: str
    test: str
    long: bool


Tests = dict[str, list[Shown]]
"""Key of a promise -> the tests that carry it."""


def sections(path: Path = PROMISES) -> dict[str, list[Promise]]:
    """Title of a section -> its promises."""
    made = {}
    for name, section in tomllib.loads(path.read_text(encoding="utf-8")).items():
        title, page = section.pop("title"), section.pop("page")
        made[title] = [
            Promise(f"{name}.{key}", one["promise"], one["from"], one.get("page", page), one.get("row", ""))
            for key, one in section.items()
        ]
    return made


def promises() -> dict[str, Promise]:
    """Every promise by its key."""
    return {one.key: one for section in sections().values() for one in section}


def _is_mark(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.Attribute) and ast.unparse(node) == f"pytest.mark.{name}"


def _keys_in(tree: ast.AST) -> list[str]:
    """Keys of the marks `pytest.mark.shows` anywhere in a tree. Raises ValueError for one that is no literal text."""
    keys = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _is_mark(node.func, "shows"):
            for key in node.args:
                if not (isinstance(key, ast.Constant) and isinstance(key.value, str)):
                    raise ValueError(f"{ast.unparse(node)}: a key is written as a text")
                keys.append(key.value)
    return keys


def marks_of(tree: ast.Module, file: str) -> list[tuple[str, Shown]]:
    """(key, test) of each mark of a file: of a test by its decorators, those within `parametrize` among them, and of
    all by `pytestmark`. Raises ValueError for a mark elsewhere."""
    every: list[str] = []
    long = False
    for node in tree.body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "pytestmark":
            every += _keys_in(node.value)
            long |= any(_is_mark(part, "long") for part in ast.walk(node.value))
    found, seen = [], len(every)
    for test in tree.body:
        if isinstance(test, ast.FunctionDef) and test.name.startswith("test_"):
            own = [key for decorator in test.decorator_list for key in _keys_in(decorator)]
            seen += len(own)
            shown = Shown(file, test.name, long or any(_is_mark(one, "long") for one in test.decorator_list))
            found += [(key, shown) for key in (*own, *every)]
    if seen != len(_keys_in(tree)):
        raise ValueError(f"{file}: a mark `shows` that no test carries")
    return found


def tests_by_key() -> Tests:
    """The tests of every promise, by a look at their sources: none is imported."""
    found: Tests = {}
    for path in sorted((ROOT / "tests").rglob("test_*.py")):
        for key, shown in marks_of(tree_of(path), path.relative_to(ROOT).as_posix()):
            found.setdefault(key, []).append(shown)
    return found


def faults(known: Iterable[str], tests: Tests) -> list[str]:
    """Promises without a test and marks of no promise, a sentence each."""
    known = set(known)
    return [f"no test shows {key}: mark one, or write it" for key in sorted(known - tests.keys())] + [
        f"{shown.file} {shown.test}: there is no promise {key}"
        for key in sorted(tests.keys() - known)
        for shown in tests[key]
    ]


def named(tests: Iterable[Shown]) -> str:
    """Tests by their files, in a cell."""
    files: dict[str, list[str]] = {}
    for one in dict.fromkeys(tests):
        files.setdefault(one.file, []).append(f"`{one.test}`" + (" (long)" if one.long else ""))
    return "; ".join(f"{file} {', '.join(names)}" for file, names in files.items())


def cell(text: str) -> str:
    return text.replace("|", "\\|")


def matrix(known: dict[str, list[Promise]], tests: Tests) -> str:
    """The page of all promises."""
    shown = {one for many in tests.values() for one in many}
    lines = [HEAD.format(key="kinematic.alpha0", count=sum(map(len, known.values())), tests=len(shown))]
    for title, section in known.items():
        lines += [
            f"## {title}",
            "| key | promise | clause, equation or contract | page | tests |",
            "|---|---|---|---|---|",
        ]
        for one in section:
            cells = (f"`{one.key}`", cell(one.promise), cell(one.source), one.page or "–", named(tests[one.key]))
            lines.append(f"| {' | '.join(cells)} |")
        lines.append("")
    return "\n".join(lines)


def with_tests(page: str, known: dict[str, Promise], tests: Tests) -> str:
    """The page of the clauses with the tests of each row in its column "shown by", and of each section in its
    paragraph "Shown by": the tests of the promises that name the row or the heading. Raises ValueError for a row
    without a promise, and for a promise of no row."""
    rows: dict[str, list[Shown]] = {}
    for one in known.values():
        if one.row:
            rows.setdefault(one.row, []).extend(tests[one.key])
    used, lines, heading, column = set(), [], "", False
    for text in page.split("\n"):
        if text.startswith("#"):
            heading = text.lstrip("# ")
        is_row = text.startswith("| ") and column and not text.endswith("shown by |")
        column = text.startswith("|") and (column or text.endswith("| shown by |"))
        if is_row:
            cells = text.removesuffix(" |").split(" | ")
            name = cells[0].removeprefix("| ")
            used.add(name)
            text = f"{' | '.join(cells[:-1])} | {named(rows.get(name, []))} |"
        elif text.startswith("Shown by "):
            name = heading
            used.add(name)
            text = f"Shown by {', '.join(dict.fromkeys(one.file for one in rows.get(name, [])))}."
        lines.append(text)
    if missing := sorted(used - rows.keys()):
        raise ValueError(f"codes.md: no promise of the rows {missing}")
    if other := sorted(rows.keys() - used):
        raise ValueError(f"codes.md has no rows {other}")
    return "\n".join(lines)


# the verification report


def outcomes(report: Path) -> dict[tuple[str, str], str]:
    """(file, test) -> its state, of a report in the form of JUnit; of a test of many points the worst."""
    found: dict[tuple[str, str], str] = {}
    for case in ElementTree.parse(report).iter("testcase"):
        kinds = {child.tag for child in case}
        state = "failed" if kinds & {"failure", "error"} else "skipped" if "skipped" in kinds else "passed"
        place = (f"{case.get('classname', '').replace('.', '/')}.py", re.split(r"\[", case.get("name", ""))[0])
        known = found.get(place, state)
        # points that are skipped beside others that passed leave the test passed
        found[place] = "failed" if "failed" in (state, known) else "passed" if "passed" in (state, known) else state
    return found


def run(tests: Iterable[Shown], long: bool) -> dict[tuple[str, str], str]:
    """`outcomes` of these tests, run here. Raises SystemExit where pytest cannot."""
    names = sorted({f"{one.file}::{one.test}" for one in tests})
    variables = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    processes = ["-n", "auto", "--dist", "worksteal"] if len(names) > 20 else []
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        words = ["-q", *processes, *(["-m", ""] if long else []), f"--junitxml={report}", *names]
        code = subprocess.call(
            [sys.executable, "-m", "pytest", *words], cwd=ROOT, env=variables | {"PYTHONPATH": str(ROOT)}
        )
        if code not in (0, 1, 5):  # all passed, some failed, none but long ones
            sys.exit(code)
        return outcomes(report)


def machine() -> dict[str, str]:
    """What the tests ran on."""
    packages = []
    for name in PACKAGES:
        try:
            packages.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            packages.append(f"{name} absent")
    return {
        "program": line(),
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "platform": platform.platform(),
        "processor": platform.processor() or platform.machine(),
        "python": f"{platform.python_implementation()} {platform.python_version()}",
        "packages": ", ".join(packages),
        "real records": "given" if shelf_folder() else "not given: their tests are skipped",
    }


def state_of(one: Shown, ran: dict[tuple[str, str], str]) -> str:
    return ran.get((one.file, one.test), "long" if one.long else "not run")


def verification(known: dict[str, Promise], tests: Tests, ran: dict[tuple[str, str], str]) -> dict:
    """The report as it is written to JSON."""
    rows = []
    for one in known.values():
        states = {f"{test.file}::{test.test}": state_of(test, ran) for test in dict.fromkeys(tests[one.key])}
        state = next(state for state in STATES if state in states.values())
        rows.append({"key": one.key, "promise": one.promise, "from": one.source, "state": state, "tests": states})
    return {**machine(), "counts": dict(Counter(row["state"] for row in rows)), "promises": rows}


def as_page(report: dict) -> str:
    """The report for a reader."""
    lines = ["# Verification report", ""]
    lines += [f"- {name}: {value}" for name, value in report.items() if isinstance(value, str)]
    lines += ["- promises: " + ", ".join(f"{report['counts'].get(state, 0)} {state}" for state in STATES), ""]
    lines += ["| state | key | promise | clause, equation or contract | tests |", "|---|---|---|---|---|"]
    for row in report["promises"]:
        tests = "; ".join(f"`{test}` {state}" for test, state in row["tests"].items())
        lines.append(f"| {row['state']} | `{row['key']}` | {cell(row['promise'])} | {cell(row['from'])} | {tests} |")
    return "\n".join(lines) + "\n"


def main(arguments: list[str]) -> int:
    words = argparse.ArgumentParser(prog="tests.requirements", description=__doc__)
    words.add_argument("folder", nargs="?", type=Path, default=DOCS, help="of the pages that are written")
    words.add_argument("--run", type=Path, metavar="FILE", help="run the tests, write the report FILE and its JSON")
    words.add_argument("--only", metavar="KEY", default="", help="promises whose key begins so")
    words.add_argument("--long", action="store_true", help="the long tests too")
    asked = words.parse_args(arguments)
    tests, known = tests_by_key(), promises()
    if wrong := faults(known, tests):
        sys.exit("\n".join(wrong))
    if asked.run:
        known = {key: one for key, one in known.items() if key.startswith(asked.only)}
        if not known or not asked.run.parent.is_dir() or asked.run.suffix == ".json":
            sys.exit(f"{asked.only or asked.run}: no promise begins so, no such folder, or the name of its own JSON")
        ran = run((one for key in known for one in tests[key]), asked.long)
        report = verification(known, tests, ran)
        asked.run.write_text(as_page(report), encoding="utf-8")
        asked.run.with_suffix(".json").write_text(json.dumps(report, indent=1, ensure_ascii=False) + "\n", "utf-8")
        return 0 if set(report["counts"]) <= {"passed", "long"} else 1
    (asked.folder / MATRIX.name).write_text(matrix(sections(), tests), encoding="utf-8")
    clauses = with_tests(CLAUSES.read_text(encoding="utf-8"), known, tests)
    (asked.folder / CLAUSES.name).write_text(clauses, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
