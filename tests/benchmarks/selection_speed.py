"""Seconds of the choice of seven records from a thousand, and how near the search comes to the best of all sets.

python3 run.py bench --selection
"""

import tempfile
import time
from pathlib import Path
from unittest import mock

import numpy as np

from core.ground import selection
from core.ground.record_folder import Limits, files_in, read_file
from core.ground.selection import Bounds, nearest_sets
from tests.benchmarks.inputs import Command
from tests.core.ground.test_selection import EN, FREE, NTC, ratios_of
from tests.core.study.folder_of_records import write_esm

RECORDS, SIZE, PERIODS = 1000, 7, 263
UNMET = Bounds(0.995, 1.005, 0.0, (1.0, 1.0))
"""Bounds that no set keeps: the mean spectrum of every exchange is made."""


def seconds(count: int, bounds: Bounds) -> tuple[float, selection.RankedSet]:
    """Time of the search among so many records, two a station and eight an event, and the best set."""
    ratios, number = ratios_of(count, 1, PERIODS), np.arange(count)
    start = time.perf_counter()
    found, every = nearest_sets(ratios, SIZE, number // 2, number // 8, (1, 2), bounds)
    assert found and not every
    return time.perf_counter() - start, found[0]


def above_best(folders: int, count: int, starts: int) -> list[float]:
    """Deviation of the set the search finds over that of the best of all, less 1, of so many small folders."""
    more = []
    for seed in range(folders):
        ratios, number = ratios_of(count, seed, PERIODS), np.arange(count)
        best, found = (_best(ratios, number, *bounds) for bounds in ((10**12, 0), (0, starts)))
        assert (found.miss, found.deviation) >= (best.miss, best.deviation)
        more.append(found.deviation / best.deviation - 1.0)
    return more


def _best(ratios: np.ndarray, number: np.ndarray, sets: int, starts: int) -> selection.RankedSet:
    with mock.patch.multiple(selection, MAX_SETS=sets, MAX_STARTS=starts):
        return nearest_sets(ratios, SIZE, number // 2, number // 8, (1, 2), FREE)[0][0]


def main(options: Command) -> None:
    """Print the table."""
    count, few = options.number(RECORDS, 60), options.number(44, 28)
    folders, files = options.number(20, 2), options.number(200, 3)
    seconds(60, NTC)  # compiled
    every = (("NTC, unscaled", NTC), ("NTC, one factor", FREE), ("EN, one factor", EN), ("unmet", UNMET))
    for name, bounds in options.few(every):
        took, best = seconds(count, bounds)
        print(f"{count} records, {name:16} {took:5.1f} s, deviation {100 * best.deviation:.2f} %, miss {best.miss:.4f}")
    for starts in options.few((1000, selection.MAX_STARTS)):
        more = above_best(folders, few, starts)
        same = sum(one == 0.0 for one in more)
        print(
            f"{few} records, {starts} starts: best of all sets {same} of {folders}, else {100 * max(more):.1f} % above"
        )
    with tempfile.TemporaryDirectory() as folder:
        for k in range(files):
            write_esm(Path(folder) / f"{k}.ASC", k, f"S{k}", f"EV{k}")
        start = time.perf_counter()
        read = [
            one for path in files_in(Path(folder)) for one in read_file(path, np.geomspace(0.15, 2.0, 262), Limits())
        ]
        assert len(read) == files
        print(
            f"{files} files of 2001 samples read with their spectra: {time.perf_counter() - start:.1f} s on one thread"
        )
