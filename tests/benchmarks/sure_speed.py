"""Seconds of what stands beside a verdict: the moves of the inputs of a design wall, and of the sliders of What if.

python3 run.py bench --sure
"""

import functools
import os
import statistics
import time
from dataclasses import replace
from pathlib import Path

from core.case.reader import read_case
from core.case.schema import Case
from core.case.sensitivity import Ranges
from core.setting.plan import read_inputs
from core.study.journal import MemoryJournal
from core.study.run import UNLIMITED, run
from core.variation.evaluate import COARSE_PRECISION, Precision
from core.variation.wall_evaluation import evaluate_wall, make_wall_context
from tests.benchmarks.inputs import Command

CASES = Path(__file__).resolve().parents[2] / "resources" / "cases"


def beside(case: Case) -> float:
    """Seconds that [sensitivity] adds to a run whose searches and checks are known, on all cores."""
    book = MemoryJournal(UNLIMITED)
    run_with = functools.partial(run, base_dir=CASES, jobs=os.cpu_count() or 1)
    plain = replace(case, sensitivity=None)
    run_with(plain, journal=lambda _: book)
    start = time.perf_counter()
    run_with(plain, journal=lambda _: book)
    middle = time.perf_counter()
    run_with(replace(plain, sensitivity=Ranges()), journal=lambda _: book)
    return time.perf_counter() - middle - (middle - start)


def under_the_hand(case: Case, repeats: int) -> tuple[float, float]:
    """(seconds of the checks of the clauses, of these and the histories) of one place of a slider: medians."""
    setting = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    times: dict[Precision | None, list[float]] = {None: [], COARSE_PRECISION: []}
    for _ in range(repeats + 1):
        for precision, taken in times.items():
            start = time.perf_counter()
            evaluate_wall(setting, precision)
            taken.append(time.perf_counter() - start)
    return statistics.median(times[None][1:]), statistics.median(times[COARSE_PRECISION][1:])


def main(options: Command) -> None:
    """Print the table."""
    repeats = options.number(5, 1)
    print(f"{'motions of its case':44} {'moves [s]':>10} {'clauses [ms]':>13} {'histories [ms]':>15}", flush=True)
    walls = (
        ("building.toml", 3, "parapet on a floor, two-sided"),
        ("facade.toml", 0, "facade with openings, on the ground"),
        ("building.toml", 0, "three storeys, three hinges, loads"),
        ("building.toml", 1, "the same with a tie"),
    )
    for name, k, label in options.few(walls):
        case = read_case(CASES / name)
        assert case.generate is not None
        made = replace(case.generate, count=options.number(case.generate.count, 1))
        case = replace(case, wall=(case.wall[k].without_sought(),), generate=made)
        moves, (clauses, histories) = beside(case), under_the_hand(case, repeats)
        print(f"{label:44} {moves:10.2f} {1e3 * clauses:13.1f} {1e3 * histories:15.0f}", flush=True)
