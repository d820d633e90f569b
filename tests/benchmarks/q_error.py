"""Error of q against time per search: every method at the default step, the default at every step.

    python3 run.py bench --q-error [--output DIR]

Also how far the linearised block is enough: its error of q against alpha.

Truth of the methods is the default method on the same grid, so that only the integration differs; truth of
the steps is the default at 0.05 %. A verdict changes where Eq. 9 with this q passes and the true one
does not, or the other way round, at a demand of 0.2 g.
"""

import csv
import math
import statistics
import time
from pathlib import Path

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.rocking.methods import AUTO, METHODS, Method
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model
from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_chart
from tests.benchmarks.scenes import wall
from tests.benchmarks.step_study import motions

DEMAND = 0.2 * G
STEPS = (0.02, 0.01, 0.005, 0.002, 0.001)
FINEST = 0.0005
HEIGHTS = (3.0, 7.0)


def search(motion, model: RockingModel, method: Method, step: float):
    """(q, q_robust, seconds) of one search; None where it has no number."""
    start = time.perf_counter()
    found = incremental_dynamic_analysis(
        motion.acceleration, motion.time_step, motion.pga, 1, model, method, Search(q_step=step)
    )
    return found.q, found.q_robust, time.perf_counter() - start


def row(kind: str, name: str, found: list, truth: list, models: list) -> dict:
    known = [k for k in range(len(found)) if found[k][0] and truth[k][0]]
    assert known, f"{name}: no search with a number"
    first = np.array([abs(found[k][0] / truth[k][0] - 1.0) for k in known])
    robust = np.array([abs(found[k][1] / truth[k][1] - 1.0) for k in known])
    thresholds = [G * np.tan(models[k].slenderness) for k in known]
    changed = [
        (found[k][0] * a >= DEMAND) != (truth[k][0] * a >= DEMAND) for k, a in zip(known, thresholds, strict=True)
    ]
    return {
        "kind": kind,
        "name": name,
        "pairs": len(known),
        "median_ms": 1e3 * statistics.median(entry[2] for entry in found),
        "q_median_percent": 100 * np.median(first),
        "q_p90_percent": 100 * np.quantile(first, 0.9),
        "robust_median_percent": 100 * np.median(robust),
        "robust_p90_percent": 100 * np.quantile(robust, 0.9),
        "verdicts_changed_percent": 100 * np.mean(changed),
    }


def chart(rows: list[dict], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 2, figsize=(11, 4), sharey=True)
    for axis, kind in zip(axes, ("method", "step"), strict=True):
        for entry in (entry for entry in rows if entry["kind"] == kind):
            x = entry["median_ms"]
            low, high = (max(entry[k], 1e-3) for k in ("q_median_percent", "q_p90_percent"))
            axis.plot([x, x], [low, high], color="0.6")
            axis.loglog([x], [low], "o", color="#2B5C8A")
            axis.annotate(entry["name"], (x, low), fontsize=7, xytext=(4, 3), textcoords="offset points")
        low, high = axis.get_xlim()
        ticks = [tick for tick in (5, 10, 20, 50, 100, 200, 500, 1000, 2000) if low < tick < high]
        axis.set_xticks(ticks, [f"{tick}" for tick in ticks])
        axis.minorticks_off()
        axis.margins(x=0.15)
        axis.set_xlabel("time per search [ms]")
        axis.grid(True, color="0.92")
    axes[0].set_ylabel("error of q [%], median to 90 %")
    axes[0].set_title("methods, q_step 0.5 %", fontsize=10)
    axes[1].set_title("steps, taylor 8", fontsize=10)
    figure.tight_layout()
    save_chart(figure, path)


SLENDERNESS = (2.0, 4.0, 6.8, 10.0, 15.0, 20.0, 30.0)


def linearised_by_slenderness(records: list, slendernesses: tuple[float, ...]) -> list[dict]:
    """Error of q of the linearised equation against alpha [deg], two-sided walls of 5 m, these motions."""
    rows = []
    for alpha in slendernesses:
        block = Block.rectangle(5.0, math.radians(alpha))
        model = rocking_model(block, False, restitution(block, "housner"), LAWS["rigid"])
        errors = []
        for motion in records:
            true, _, _ = search(motion, model, METHODS["taylor"], 0.01)
            found, _, _ = search(motion, model, METHODS["linearised"], 0.01)
            if true and found:
                errors.append(100.0 * abs(found / true - 1.0))
        assert errors, f"alpha {alpha}: no search with a number"
        rows.append(
            {
                "alpha_deg": alpha,
                "pairs": len(errors),
                "q_median_percent": float(np.median(errors)),
                "q_p90_percent": float(np.quantile(errors, 0.9)),
                "q_max_percent": max(errors),
            }
        )
        print(" ".join(f"{key} {value:.3g}" for key, value in rows[-1].items()))
    return rows


def main(options: Command) -> None:
    """Print the rows; write them and their chart."""
    folder, records, grid = options.folder(), options.few(motions()), 0.005
    models = [
        (m, wall(one, height=h)) for m in records for h in options.few(HEIGHTS) for one in options.few((False, True))
    ]
    only = [model for _, model in models]
    truth = [search(m, w, METHODS["taylor"], grid) for m, w in models]
    rows = [row("method", "taylor 8", truth, truth, only)]
    for method in (AUTO, *list(METHODS.values())[1:]):
        found = [search(m, w, method, grid) for m, w in models]
        rows.append(row("method", method.name, found, truth, only))
    fine = [search(m, w, METHODS["taylor"], FINEST) for m, w in models]
    for step in options.few(STEPS):
        found = [search(m, w, METHODS["taylor"], step) for m, w in models]
        rows.append(row("step", f"{100 * step:g} %", found, fine, only))
    for entry in rows:
        print(
            f"{entry['kind']:7}{entry['name']:22}{entry['median_ms']:9.1f} ms  q "
            f"{entry['q_median_percent']:8.3f} {entry['q_p90_percent']:8.2f} %  robust "
            f"{entry['robust_median_percent']:7.3f} {entry['robust_p90_percent']:7.2f} %  verdicts "
            f"{entry['verdicts_changed_percent']:5.1f} %"
        )
    with open(folder / "q_error.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    chart(rows, folder / "q_error.png")
    alphas = linearised_by_slenderness(records, options.few(SLENDERNESS))
    with open(folder / "linearised.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(alphas[0]))
        writer.writeheader()
        writer.writerows(alphas)
