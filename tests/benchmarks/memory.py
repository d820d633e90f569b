"""Peak memory and time of large work: many walls, a record of a million samples.

python3 run.py bench --memory
"""

import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

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


def batch(case: Path) -> tuple[float, float]:
    """(seconds, MB) of a batch as a process of its own."""
    start = time.perf_counter()
    with subprocess.Popen(
        [sys.executable, "-P", "-m", "app", "--batch", case, "--quiet"], cwd=ROOT
    ) as run:
        _, _, used = os.wait4(run.pid, 0)
        run.returncode = 0
    return time.perf_counter() - start, used.ru_maxrss / 1024.0


def walls(folder: Path, count: int) -> Path:
    """A case of many different walls, half of them one-sided, under seven compatible motions."""
    chance = random.Random(1)
    rows = ["Parete;z;H;t;Meccanismo", ";m;m;m;"]
    for k in range(count):
        mechanism = "two_sided" if k % 2 else "one_sided"
        rows.append(f"w{k};0;{chance.uniform(3, 8):.2f};{chance.uniform(0.3, 0.9):.2f};{mechanism}")
    (folder / f"walls_{count}.csv").write_text("\n".join(rows))
    case = folder / f"walls_{count}.toml"
    case.write_text(f'walls = "walls_{count}.csv"\n[generate]\ncount = 7\n{DEMAND}')
    return case


def long_record(folder: Path) -> Path:
    """A case of one wall under a record of a million samples."""
    from core.ground.artificial import filtered_noise

    one = filtered_noise(1, 2.0)
    samples = (one[k % one.size] for k in range(1_000_000))
    (folder / "long.txt").write_text("\n".join(f"{value:.5f}" for value in samples))
    case = folder / "long.toml"
    case.write_text(
        '[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nmechanism = "two_sided"\n'
        '[[record]]\nfile = "long.txt"\nunit = "m/s2"\ntime_step_s = 0.01\n[analysis]\nq_step = 0.02\n'
    )
    return case


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for label, case in (
            ("500 walls x 7 records, all checks", walls(folder, 500)),
            ("1000 walls x 7 records, all checks", walls(folder, 1000)),
            ("one record of 1e6 samples", long_record(folder)),
        ):
            seconds, megabytes = batch(case)
            print(f"{label:40} {seconds:8.1f} s {megabytes:8.0f} MB", flush=True)
