"""Peak memory and time of large work: many walls, a record of a million samples.

python3 run.py bench --memory
python3 run.py bench --memory --walls N     # so many walls, 10 000 or not, as a Parquet file, one thread
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

from tests.benchmarks.inputs import Command

ROOT = Path(__file__).resolve().parents[2]
DEMAND = """[demand]
ag_g = 0.2
[demand.spectrum]
code = "NTC2018"
f0 = 2.4
tc_star_s = 0.33
soil = "B"
topography = "T1"
"""


PROGRAM = "import sys; from app.__main__ import main; sys.exit(main())"
AS_TABLE = f"from core.setting import plan; plan.MAX_WALLS_IN_WORKBOOK = 0; {PROGRAM}"
"""The program, and the program that holds every case for too large for a workbook."""


class Used(NamedTuple):
    """What a batch took, as a process of its own.

    seconds : of the clock; processor : of all its processes
    megabytes : most that one of them held
    """

    seconds: float
    processor: float
    megabytes: float


def measured(case: Path, *words: str, program: str = PROGRAM) -> Used:
    """What a batch of a case takes. words : of its command line"""
    start = time.perf_counter()
    variables = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-P", "-c", program, "--batch", str(case), "--quiet", *words]
    with subprocess.Popen(command, cwd=ROOT, env=variables) as run:
        _, status, used = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
    assert run.returncode in (0, 3), f"the batch ended with {run.returncode}"
    return Used(time.perf_counter() - start, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024.0)


def batch(case: Path, walls: int) -> Used:
    """What a batch of so many walls takes."""
    found = measured(case)
    results = json.loads(case.with_suffix(".json").read_text())["walls"]
    numbers = [run["q"] is not None for wall in results for run in wall["runs"]]
    assert len(results) == walls and sum(numbers) > 0.9 * len(numbers), "runs without a number"
    return found


def table(case: Path, walls: int, *words: str, program: str = AS_TABLE) -> Used:
    """What a batch of so many walls takes whose result is a Parquet file. words : of its command line"""
    found = measured(case, *words, program=program)
    summary = json.loads(case.with_suffix(".json").read_text())
    assert summary["table"]["rows"] == summary["walls"] == walls, "rows that are missing"
    assert summary["runs_without_q"] < 0.1 * walls, "runs without a number"
    return found


def short_record(folder: Path) -> str:
    """[[record]] of a motion of 3 s, and [analysis] of a coarse search."""
    from core.ground.artificial import filtered_noise

    lines = [f"{value:.5f}" for value in filtered_noise(1, 2.0)[200:500]]
    (folder / "short.txt").write_text("\n".join(lines))
    return (
        '[[record]]\nfile = "short.txt"\nunit = "m/s2"\ntime_step_s = 0.01\nkind = "artificial"\n'
        "[analysis]\nq_step = 0.05\n"
    )


def walls(folder: Path, count: int, motions: int) -> Path:
    """A case of many different walls, half of them one-sided, under so many compatible motions; under one short record
    where that number is 0."""
    chance = random.Random(1)
    rows = ["Parete;z;H;t;Meccanismo", ";m;m;m;"]
    for k in range(count):
        mechanism = "two_sided" if k % 2 else "one_sided"
        rows.append(f"w{k};0;{chance.uniform(3, 8):.2f};{chance.uniform(0.3, 0.9):.2f};{mechanism}")
    (folder / f"walls_{count}.csv").write_text("\n".join(rows))
    case = folder / f"walls_{count}.toml"
    ground = f"[generate]\nscatter = 0\ncount = {motions}\n" if motions else short_record(folder)
    case.write_text(f'walls = "walls_{count}.csv"\n{ground}{DEMAND}')
    return case


def long_record(folder: Path, count: int) -> Path:
    """A case of one wall under a record of so many samples."""
    from core.ground.artificial import filtered_noise

    one = filtered_noise(1, 2.0)
    samples = (one[k % one.size] for k in range(count))
    (folder / "long.txt").write_text("\n".join(f"{value:.5f}" for value in samples))
    case = folder / "long.toml"
    case.write_text(
        '[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nmechanism = "two_sided"\n'
        '[[record]]\nfile = "long.txt"\nunit = "m/s2"\ntime_step_s = 0.01\n[analysis]\nq_step = 0.02\n'
    )
    return case


def main(options: Command) -> None:
    """Print the table."""
    if options.walls:
        count = options.number(options.walls, 12)
        with tempfile.TemporaryDirectory() as name:
            seconds, _, megabytes = table(walls(Path(name), count, 0), count, "--jobs", "1")
        print(f"{f'{count} walls x 1 record of 3 s, Parquet':40} {seconds:8.1f} s {megabytes:8.0f} MB", flush=True)
        return
    many = [options.number(count, 2) for count in options.few((500, 1000))]
    motions, samples = options.number(7, 1), options.number(1_000_000, 2000)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for label, case, number in (
            *((f"{n} walls x {motions} records, all checks", walls(folder, n, motions), n) for n in many),
            (f"one record of {samples} samples", long_record(folder, samples), 1),
        ):
            seconds, _, megabytes = batch(case, number)
            print(f"{label:40} {seconds:8.1f} s {megabytes:8.0f} MB", flush=True)
