"""How first collapse and q_robust hang on the step of the search, over more than 100 pairs.

    python3 run.py bench --steps [--output DIR]

One map at 0.02 % a pair; coarser grids are its every k-th point, so that nothing but the step differs.
"""

import contextlib
import csv
import math
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from core.capacity.ida import ROBUST_SHARE, Search, collapse_count, incremental_dynamic_analysis
from core.errors import InputError
from core.ground import records
from core.ground.records.grammar import Options
from core.rocking.methods import METHODS
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_chart
from tests.conftest import shelf_folder

ROOT = Path(__file__).resolve().parents[2]
FINE = 0.0002
EVERY = (1, 2, 5, 10, 25, 50, 100)
"""Steps 0.02, 0.04, 0.1, 0.2, 0.5, 1 and 2 %."""

WALLS = ((3.0, 6.8), (5.0, 11.3), (7.0, 6.8))
REAL = (
    "IELC180",
    "A-ELC180",
    "NIS090",
    "CPM000",
    "ARL360",
    "RSN175_IMPVALL.H_H-E12140",
    "RSN763_LOMAP_GIL067",
    "RSN57_SFERN_ORR021",
    "RSN1633_MANJIL_ABBAR--L",
    "RSN164_IMPVALL.H_H-CPE147",
    "RSN4843_CHUETSU_65006NS",
)


def motions():
    found = [records.read(path) for path in sorted((ROOT / "tests/motions").glob("*.txt"))]
    shelf = shelf_folder()
    if shelf:
        for name in REAL:
            path = next(shelf.glob(f"PEER_AT2/{name}.[aA][tT]2"))
            found.append(records.read(path, Options()))
    return found


WALLS_APART = ((2.5, 4.0), (4.0, 9.0), (6.0, 3.5), (9.0, 5.0), (12.0, 12.0))
"""H [m] and alpha [deg] of walls on which neither the share nor the window of q_robust was chosen."""

RECORDS_APART = 30


def motions_apart():
    """Records of the shelf that are not among REAL, as many as RECORDS_APART, those of the largest PGA."""
    shelf, found = shelf_folder(), {}
    if shelf is None:
        return []
    with (shelf / "INDEX.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        path = shelf / row["file"]
        if not row["pga_g"] or path.stem in REAL:
            continue
        for options in (Options(), Options(row["units_in_file"].split(" ")[0], float(row["dt_s"]))):
            with contextlib.suppress(InputError):
                motion = records.read(path, options)
                found.setdefault(motion.samples_sha256, motion)
                break
    known = {motion.samples_sha256 for motion in motions()}
    apart = [motion for key, motion in found.items() if key not in known]
    return sorted(apart, key=lambda motion: -motion.pga)[:RECORDS_APART]


def fine_map(motion, height, alpha, one_sided, fine: float) -> np.ndarray | None:
    """Collapse flags from q = 1 at this step; None without a collapse."""
    block = Block.rectangle(height, math.radians(alpha))
    model = "one_sided_theoretical" if one_sided else "housner"
    found = incremental_dynamic_analysis(
        motion.acceleration,
        motion.time_step,
        motion.pga,
        1,
        rocking_model(block, one_sided, restitution(block, model), LAWS["rigid"]),
        METHODS["taylor"],
        Search(q_step=fine, map_span=1.8),
    )
    if found.status != "collapse_found":
        return None
    return np.array([digit == "1" for digit in found.outcomes])


def first_collapse(flags: np.ndarray, every: int, fine: float) -> float:
    """ln q of first collapse on every k-th point, bisected down to the finest."""
    high = int(np.argmax(flags[::every])) * every
    low = high - every
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if flags[middle] else (middle, high)
    return high * math.log1p(fine)


def robust(flags: np.ndarray, every: int, fine: float) -> float:
    """ln of q_robust on every k-th point; NaN where the map ends before it."""
    coarse = flags[::every]
    half = round(0.10 / (every * math.log1p(fine)))
    share = collapse_count(coarse, half)
    hits = np.nonzero(share >= ROBUST_SHARE * (2 * half + 1))[0]
    return int(hits[0]) * every * math.log1p(fine) if hits.size else math.nan


def main(options: Command) -> None:
    """Print the tables; write them and their charts."""
    table(options, motions(), WALLS, "q_step")
    if shelf_folder():
        table(options, motions_apart(), WALLS_APART, "q_step_apart")


def table(options: Command, records_of, walls, name: str) -> None:
    """One table of these records and walls, as CSV and picture."""
    folder, fine = options.folder(), FINE
    pairs = [
        (motion, height, alpha, one_sided, fine)
        for motion in options.few(records_of)
        for height, alpha in options.few(walls)
        for one_sided in (False, True)
    ]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        maps = [flags for flags in pool.map(lambda pair: fine_map(*pair), pairs) if flags is not None]
    assert maps, "no wall overturned"
    rows = []
    print(
        f"{name}: {len(maps)} pairs; ratio to {100 * fine:g} %: "
        "median, mean, then p90 and max of the modulus of the difference"
    )
    print(f"{'step':>7} {'first collapse':>40} {'q_robust':>40}")
    finest = [(first_collapse(flags, 1, fine), robust(flags, 1, fine)) for flags in maps]
    for every in EVERY:
        row = {"step_percent": 100 * fine * every, "pairs": len(maps)}
        for k, (kind, rule) in enumerate((("first", first_collapse), ("robust", robust))):
            moved = np.array([rule(f, every, fine) - base[k] for f, base in zip(maps, finest, strict=True)])
            ratio = np.exp(moved[np.isfinite(moved)])
            row[f"{kind}_median_percent"] = 100 * (np.median(ratio) - 1)
            row[f"{kind}_mean_percent"] = 100 * (ratio.mean() - 1)
            row[f"{kind}_p90_percent"] = 100 * np.quantile(np.abs(ratio - 1), 0.9)
            row[f"{kind}_max_percent"] = 100 * np.abs(ratio - 1).max()
        rows.append(row)
        print(
            f"{row['step_percent']:6.2f}% "
            + " ".join(
                f"{row[f'{n}_median_percent']:+9.2f} {row[f'{n}_mean_percent']:+9.2f} "
                f"{row[f'{n}_p90_percent']:9.2f} {row[f'{n}_max_percent']:9.2f}"
                for n in ("first", "robust")
            )
        )
    with open(folder / f"{name}.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    chart(rows, folder / f"{name}.png")


def chart(rows: list[dict], path: Path) -> None:
    """Bias and scatter of both definitions against the step."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    steps = [row["step_percent"] for row in rows[1:]]
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), sharex=True)
    for name, label, color in (("first", "first collapse", "#B3421B"), ("robust", "q_robust", "#2B5C8A")):
        axes[0].semilogx(steps, [row[f"{name}_median_percent"] for row in rows[1:]], "o-", color=color, label=label)
        axes[1].semilogx(steps, [row[f"{name}_p90_percent"] for row in rows[1:]], "o-", color=color)
    axes[0].set_ylabel("median against 0.02 % [%]")
    axes[1].set_ylabel("90 % of pairs within [%]")
    for axis in axes:
        axis.set_xlabel("step of the search [%]")
        axis.grid(True, color="0.92")
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    save_chart(figure, path)
