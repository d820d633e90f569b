"""What a wall costs in cases of one wall and of many, and the memory it takes: a CSV and a chart.

    python3 run.py bench --scale [--walls N] [--output DIR]     # by powers of ten up to N walls, 1000 without it

Each point is a batch in a process of its own whose result is a Parquet file, on one thread, on two workers of Dask, and
on one thread that analyses its first group alone and takes its rows for those of each other: the start of the program,
the check of all walls, the journal and the file are in all of them, and in the third one little else, ten times as
many walls.
"""

import csv
import tempfile
from pathlib import Path

from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_chart
from tests.benchmarks.memory import AS_TABLE, table, walls

FIRST_GROUP_ALONE = """
from app.terminal import large_batch
real = large_batch.group_results
def again(large, todo, *how):
    first = next(real(large, todo[:1], *how))[1]
    for g in todo:
        same = len(large.groups[g]) == len(large.groups[todo[0]])
        yield (g, first) if same else next(real(large, [g], *how))
large_batch.group_results = again
"""
"""What the program of the third way begins with."""

WITHOUT = "analyses left out"
WAYS = {"one thread": ("--jobs", "1"), "local:2": ("--jobs", "1", "--scheduler", "local:2"), WITHOUT: ("--jobs", "1")}
"""Words of the command line by what they are called."""

MOST = 1000
"""Walls, where no number of them is asked for."""


def points(most: int) -> list[int]:
    """Powers of ten up to so many walls, and that number."""
    found, count = [], 1
    while count < most:
        found.append(count)
        count *= 10
    return [*found, most]


def measure(most: int) -> list[dict]:
    """A row for each way and number of walls."""
    rows: list[dict] = []
    with tempfile.TemporaryDirectory() as name:
        for count in points(10 * most):
            case = walls(Path(name), count, 0)
            for way, words in WAYS.items():
                if count > most and way != WITHOUT:
                    continue
                used = table(case, count, *words, program=(FIRST_GROUP_ALONE if way == WITHOUT else "") + AS_TABLE)
                rows.append({"walls": count, "way": way, **used._asdict()})
                print(
                    f"{count:8} walls {way:12} {used.seconds:9.1f} s, {used.processor:9.1f} s of the processor,"
                    f" {1e3 * used.processor / count:9.1f} ms a wall {used.megabytes:6.0f} MB",
                    flush=True,
                )
    return rows


def chart(rows: list[dict], path: Path) -> None:
    """Time of a core and wall, and largest memory of a process, against the number of walls."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (time, memory) = plt.subplots(1, 2, figsize=(9, 3.6))
    for way in WAYS:
        mine = [row for row in rows if row["way"] == way]
        count = [row["walls"] for row in mine]
        time.loglog(count, [1e3 * row["processor"] / row["walls"] for row in mine], marker="o", label=way)
        memory.semilogx(count, [row["megabytes"] for row in mine], marker="o", label=way)
    time.set_ylabel("ms of a core and wall, start included")
    memory.set_ylabel("largest memory of a process [MB]")
    memory.set_ylim(bottom=0.0)
    for axis in (time, memory):
        axis.set_xlabel("walls of the case")
        axis.grid(True, which="major", color="0.92")
    time.legend(frameon=False)
    figure.tight_layout()
    save_chart(figure, path)


def main(options: Command) -> None:
    """Print the rows; write them and their chart."""
    rows = measure(options.number(options.walls or MOST, 3))
    folder = options.folder()
    with open(folder / "cost_per_wall.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    chart(rows, folder / "cost_per_wall.png")
