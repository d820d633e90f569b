"""What the shipped cases cost and what they come to: analyses, processor time, outcome and zeta of each wall; with
another tree, what it says of the same cases and of random walls, every difference in a line.

    python3 run.py bench --outcomes                                    # verdict, building and palazzo.toml
    python3 run.py bench --outcomes --against OTHER_TREE [--cases N] [--walls N]   # and random walls, 200 without N

The random walls are judged with four generated motions each, in a process of either tree.
"""

import json
import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from core.known import require_value
from tests.benchmarks.inputs import Command
from tests.conftest import ROOT
from tests.core.variation.random_walls import random_tables

CASES = "verdict", "building", "palazzo"
"""Shipped cases, of resources/cases."""

JUDGE = """
import json, sys
from pathlib import Path
from core.case.rules import parse_case
from core.errors import InputError
from core.study.run import run
for table in json.load(sys.stdin):
    try:
        (verdict,), walls = (result := run(parse_case(table), base_dir=Path())).verdicts, result.walls
        found = walls[verdict.governing].assessment.verdict
        print(json.dumps([found.code, found.zeta_e, found.governing]), flush=True)
    except InputError as error:
        print(json.dumps(["refused", None, error.code]), flush=True)
"""
"""Program of a process that judges the cases it reads, a line each."""


class Ran(NamedTuple):
    """A case that was run. analyses, processor : count and seconds; outcomes : wall -> (outcome, zeta)"""

    analyses: int
    processor: float
    outcomes: dict[str, tuple[str, float | None]]


def run_case(tree: Path, name: str, folder: Path) -> Ran:
    """A shipped case by a tree, in a process of its own."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    words = [sys.executable, str(tree / "run.py"), "--batch", str(tree / "resources" / "cases" / f"{name}.toml")]
    words += ["--output", str(folder)]
    ran = subprocess.run(words, check=True, capture_output=True, text=True, env=_variables(tree))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = json.loads((folder / f"{name}.json").read_text())
    names = [" ".join(filter(None, (entry["wall"], entry["variant"]))) for entry in result["verdicts"]]
    outcomes = {name: (entry["code"], entry["zeta_e"]) for name, entry in zip(names, result["verdicts"], strict=True)}
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    analyses = int(require_value(re.search(r"(\d+) (?:analyses|integrazioni|analisi)", ran.stdout))[1])
    return Ran(analyses, seconds, outcomes)


def _variables(tree: Path) -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(tree), "RIBALTA_ENV": sys.prefix}


def judge(tree: Path, tables: list[dict]) -> list[list]:
    """Outcome, zeta and check of each case by a tree."""
    made = subprocess.run(
        [sys.executable, "-c", JUDGE],
        input=json.dumps(tables),
        cwd=tree,
        env=_variables(tree),
        capture_output=True,
        text=True,
        check=True,
    )
    return [json.loads(line) for line in made.stdout.splitlines()]


def _differs(here: tuple | list, there: tuple | list) -> bool:
    """Whether outcome or zeta, of two digits, differ."""
    zetas = [None if zeta is None else round(zeta, 2) for zeta in (here[1], there[1])]
    return here[0] != there[0] or zetas[0] != zetas[1]


def main(options: Command) -> None:
    trees = [ROOT, *([options.against] if options.against else [])]
    for name in options.few(CASES[: options.cases or len(CASES)]):
        with tempfile.TemporaryDirectory() as folder:
            ran = [run_case(tree, name, Path(folder)) for tree in trees]
        for each, tree in zip(ran, ("this tree", "the other"), strict=False):
            print(f"{name}.toml, {tree}: {each.analyses} analyses, {each.processor:.1f} s of the processor", flush=True)
        assert all(each.outcomes for each in ran)
        for title, found in ran[0].outcomes.items():
            there = ran[-1].outcomes.get(title, ("absent", None))
            print(f"    {title}: {found}" + (f", the other {there}" if _differs(found, there) else ""))
    if options.against is None:
        return
    tables = random_tables(options.number(options.walls or 200, 2), histories=True)
    tables = [table | {"generate": {"count": 4, "seed": 1}} for table in tables]
    here, there = (judge(tree, tables) for tree in trees)
    different = [k for k in range(len(tables)) if _differs(here[k], there[k])]
    for k in different:
        print(f"wall {k}: {here[k]}, the other {there[k]}\n    {json.dumps(tables[k]['wall'][0])}")
    print(f"{len(tables)} random walls, {len(different)} differ in outcome or zeta")
