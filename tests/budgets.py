"""Seconds that the tests of each folder take against its budget, which stands in the table of CONTRIBUTING.md alone."""

import re
from collections import Counter, defaultdict

from tests.conftest import ROOT

PAGE = ROOT / "CONTRIBUTING.md"
SLOWEST = 8
"""Tests that are named of a folder beyond its budget."""


def budgets(page: str) -> dict[str, float]:
    """Folder -> seconds its tests may take, of the rows "| tests/... | seconds |" of a page."""
    return {folder: float(seconds) for folder, seconds in re.findall(r"^\| (tests[\w/]*) \| (\d+) \|", page, re.M)}


def folder_of(test: str) -> str:
    """The folder of a test named as pytest does."""
    return test.partition("::")[0].rpartition("/")[0]


def summary(known: dict[str, float], parts: list[tuple[str, float]]) -> list[str]:
    """What is printed: a line for each folder, then the slowest tests of those beyond their budget.

    known : folder -> budget [s]
    parts : (test, seconds) of each set up, call and tear down; a fixture that is shared counts where it is made
    """
    tests: defaultdict[str, Counter] = defaultdict(Counter)
    for test, seconds in parts:
        tests[folder_of(test)][test] += seconds
    took = {folder: sum(tests[folder].values()) for folder in sorted({*known, *tests})}
    lines = [f"{'seconds':>8} {'budget':>7}"]
    for folder, seconds in [*took.items(), ("all", sum(took.values()))]:
        budget = known.get(folder, 0.0) if folder != "all" else sum(known.values())
        lines.append(f"{seconds:8.1f} {budget:7.0f}  {folder}" + (": beyond its budget" if seconds > budget else ""))
    for folder, seconds in took.items():
        if seconds > known.get(folder, 0.0):
            lines += ["", f"slowest of {folder}:"]
            lines += [f"{seconds:8.2f}  {test}" for test, seconds in tests[folder].most_common(SLOWEST)]
    return lines


def of_reports(stats: dict) -> list[tuple[str, float]]:
    """`parts` of the reports that pytest kept."""
    reports = [report for kept in stats.values() for report in kept if hasattr(report, "duration")]
    return [(report.nodeid, report.duration) for report in reports if hasattr(report, "when")]


def printed(stats: dict) -> list[str]:
    """`summary` of a run of pytest against the table of CONTRIBUTING.md."""
    return summary(budgets(PAGE.read_text(encoding="utf-8")), of_reports(stats))
