"""Seconds of the tests by folder against their budgets, as `run.py test --durations` prints them."""

from types import SimpleNamespace

from tests.budgets import PAGE, budgets, of_reports, summary
from tests.conftest import ROOT
from tests.test_run import load

TOGETHER = 2 * 5 * 60
"""Seconds of two cores in five minutes, of which ruff, import contracts and mypy take a part."""


def test_that_every_folder_of_tests_has_a_budget_and_all_go_into_five_minutes_of_two_cores():
    known = budgets(PAGE.read_text(encoding="utf-8"))
    folders = {path.parent.relative_to(ROOT).as_posix() for path in (ROOT / "tests").rglob("test_*.py")}
    assert set(known) == folders
    assert sum(known.values()) <= TOGETHER


def test_that_seconds_are_summed_by_folder_and_what_is_beyond_its_budget_is_named():
    known = budgets("| folder | seconds |\n|---|---|\n| tests | 2 |\n| tests/app | 9 |\n| tests/core/ground | 30 |\n")
    parts = [
        ("tests/app/test_a.py::test_that_it_is[tests/core/x]", 6.0),
        ("tests/app/test_a.py::test_that_it_is[tests/core/x]", 1.5),
        ("tests/app/test_b.py::test_that_it_runs", 2.0),
        ("tests/core/ground/test_c.py::test_that_it_reads", 29.0),
        ("tests/new/test_d.py::test_that_it_has_no_budget", 0.5),
    ]
    assert summary(known, parts) == [
        " seconds  budget",
        "     0.0       2  tests",
        "     9.5       9  tests/app: beyond its budget",
        "    29.0      30  tests/core/ground",
        "     0.5       0  tests/new: beyond its budget",
        "    39.0      41  all",
        "",
        "slowest of tests/app:",
        "    7.50  tests/app/test_a.py::test_that_it_is[tests/core/x]",
        "    2.00  tests/app/test_b.py::test_that_it_runs",
        "",
        "slowest of tests/new:",
        "    0.50  tests/new/test_d.py::test_that_it_has_no_budget",
    ]


def test_that_set_up_and_tear_down_count_and_what_was_not_run_does_not():
    when = [
        SimpleNamespace(nodeid="tests/test_a.py::test_x", duration=n, when=w)
        for n, w in ((1.0, "setup"), (2.0, "call"))
    ]
    assert of_reports({"passed": when[1:], "": when[:1], "deselected": [object()]}) == [
        ("tests/test_a.py::test_x", 2.0),
        ("tests/test_a.py::test_x", 1.0),
    ]


def test_that_durations_without_a_number_asks_for_the_budgets():
    """With a number it is pytest's own; alone it is the whole suite on every core, style and types before it: a style
    at fault once passed a whole run by it."""
    run = load()

    def arguments(*words):
        return run.test_steps(list(words))[-1][3:]

    assert len(run.test_steps(["--durations"])) == len(run.test_steps([])) > len(run.test_steps(["tests/app"])) == 1
    every_core = run.test_steps([])[-1][3:]
    assert arguments("--durations") == [*every_core, "--budgets"]
    assert arguments("tests/app", "--durations", "-n", "2") == ["tests/app", "--budgets", "-n", "2"]
    assert arguments("--durations", "5", "tests/app") == ["--durations", "5", "tests/app"]
    assert arguments("--durations=5") == ["--durations=5"]
