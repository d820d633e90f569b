"""Error against time of every method and peer, over the scenes: a CSV and a chart.

    python3 run.py bench --work-precision [--output DIR]

Truth is the 30-digit solver of tests/validation/high_precision.py, never a method of the program.
Failing points are drawn: an error above 1 alpha stands at the top.
"""

import csv
import platform
import statistics
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS, Method
from tests.benchmarks import peers as peer_solvers
from tests.benchmarks.inputs import Command
from tests.benchmarks.made_by import save_chart
from tests.benchmarks.scenes import Scene, scenes

OWN = (
    [Method(f"taylor {order}", 0, order, order) for order in (6, 8)]
    + [METHODS["newmark_paper"], METHODS["newmark_paper_reset"]]
    + [Method("newmark_events", 2, steps, 2) for steps in (1, 2, 4, 8, 16)]
    + [Method("rk4", 3, steps, 4) for steps in (1, 2, 4, 8, 16)]
    + [METHODS["dormand_prince"], METHODS["linearised"]]
)

LANES = 64

TOLERANCES = (0.0, 1e-12, 1e-9, 1e-6, 1e-4)
"""Of heyoka: its own, that of a double, and looser ones; its order falls with them."""

EXACT = 1e-3
"""Error / alpha above which a method that claims to be exact, ours or a peer, was not driven as it is meant to be."""

EXACT_SOLVERS = ("taylor", "scipy DOP853 restarted", "heyoka", "diffrax")
"""How the names of those begin."""


Solver = Callable[[Scene], np.ndarray]


def peers(options: Command) -> list[tuple[str, Solver]]:
    """(label, solver) of what imports; what does not is named."""
    found: list[tuple[str, Solver]] = [("scipy DOP853 restarted", peer_solvers.scipy_restarted)]
    found += [
        (f"scipy DOP853 naive {r:g}", partial(peer_solvers.scipy_naive, rtol=r)) for r in options.few((1e-6, 1e-10))
    ]
    try:
        for tolerance in options.few(TOLERANCES):
            name = f"{tolerance or 'eps'}"
            found.append((f"heyoka {name}", peer_solvers.Heyoka(tolerance)))
            found.append((f"heyoka batch of 8 {name}", peer_solvers.Heyoka(tolerance, 8)))
    except ImportError:
        print("heyoka is not installed: left out")
    try:
        for parts in options.few((4, 1)):
            found.append((f"diffrax dt/{parts}", peer_solvers.Diffrax(parts)))
            found.append((f"diffrax vmap of 8 dt/{parts}", peer_solvers.Diffrax(parts, 8)))
    except ImportError:
        print("diffrax is not installed: left out")
    try:
        import numbalsoda  # noqa: F401
    except ImportError:
        print("numbalsoda has no wheel here (needs a Fortran compiler): left out")
    return found


def timed(call, most: int, least: float = 0.02) -> float:
    """Median time of a call [s]. most : repeats, fewer for slow ones"""
    start = time.perf_counter()
    call()
    once = time.perf_counter() - start
    repeats = 1 if once > 1.0 else most
    inner = max(1, int(least / max(once, 1e-7)))
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        for _ in range(inner):
            call()
        times.append((time.perf_counter() - start) / inner)
    return statistics.median(times)


def error(found: np.ndarray, scene: Scene) -> float:
    """Largest |error| / alpha; a history that stops early fails entirely."""
    if found.size != scene.truth.size or not np.isfinite(found).all():
        return float("inf")
    return float(np.abs(found - scene.truth).max())


def measure(scene: Scene, others: list[tuple[str, Solver]], repeats: int) -> list[dict]:
    """Rows of a scene."""
    rows: list[dict] = []
    for method in OWN:
        if method.name == "linearised" and scene.model.plateau_end > 0.0:
            continue

        def call(m=method):
            return integrate_history(scene.ground, scene.dt, 1.0, scene.model, m)

        found = call().rotation / scene.model.slenderness
        rows.append(row(scene, method.name, method.option, error(found, scene), timed(call, repeats)))
        if method.name.startswith("taylor"):
            seconds = timed(lambda m=method: lanes(scene, m), repeats) / LANES
            rows.append(row(scene, f"{LANES} lanes", method.option, rows[-1]["error_alpha"], seconds))
    for label, solver in others:
        if label.startswith(("heyoka", "diffrax")) and scene.model.plateau_end > 0.0:
            continue
        if isinstance(solver, peer_solvers.Diffrax):
            solver(scene)  # compiles
        start = time.perf_counter()
        found = solver(scene)
        once = time.perf_counter() - start
        seconds = once if once > 0.5 else timed(lambda s=solver: s(scene), repeats)
        rows.append(row(scene, label, "", error(found, scene), seconds))
        if isinstance(solver, (peer_solvers.Heyoka, peer_solvers.Diffrax)):
            # of its batch the first history is the scene, the others are of other multipliers
            rows[-1]["seconds"] /= solver.lanes
            rows[-1]["ns_per_sample"] /= solver.lanes
        if isinstance(solver, peer_solvers.Heyoka):
            steps = scene.ground.size - 1
            alone, together = solver.compiled(scene.dt), solver.in_ensemble(scene.dt)
            rows.append(row(scene, f"{label}, its compiled steps alone", "", rows[-1]["error_alpha"], alone * steps))
            rows.append(row(scene, f"{label}, its ensemble alone", "", rows[-2]["error_alpha"], together * steps))
    return rows


def lanes(scene: Scene, method: Method) -> None:
    """The scene and LANES - 1 histories of other multipliers, in lanes."""
    outcomes, peaks = np.zeros(LANES, np.int64), np.zeros(LANES)
    scan_multipliers(method, scene.ground, scene.dt, np.linspace(1.0, 0.9, LANES), scene.model, outcomes, peaks)
    assert (peaks > 0.0).all(), "a wall that did not move"


def row(scene, name, option, err, seconds) -> dict:
    return {
        "scene": scene.name,
        "impacts": scene.impacts,
        "samples": scene.ground.size,
        "method": name,
        "option": option,
        "error_alpha": err,
        "seconds": seconds,
        "ns_per_sample": 1e9 * seconds / (scene.ground.size - 1),
    }


def chart(rows: list[dict], path: Path) -> None:
    """One panel a scene, log time against log error, failures at the top edge."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    names = list(dict.fromkeys(r["scene"] for r in rows))
    families = list(dict.fromkeys(family(r["method"]) for r in rows))
    colours = dict(zip(families, plt.get_cmap("tab20")(range(20)), strict=False))
    columns = 3
    lines = -(-(len(names) + 1) // columns)
    figure, axes = plt.subplots(lines, columns, figsize=(13, 3.6 * lines), squeeze=False)
    for axis, name in zip(axes.flat, names, strict=False):
        for family_name in families:
            points = [r for r in rows if r["scene"] == name and family(r["method"]) == family_name]
            if not points:
                continue
            x = [1e6 * r["seconds"] for r in points]
            y = [min(max(r["error_alpha"], 1e-16), 3.0) for r in points]
            line = "-" if family_name in ("rk4", "newmark_events", "taylor") else "none"
            marker = "o" if family_name in (*METHODS, f"{LANES} lanes") else "s"
            axis.loglog(
                x, y, marker=marker, linestyle=line, color=colours[family_name], label=family_name, markersize=5
            )
        impacts = next(r["impacts"] for r in rows if r["scene"] == name)
        axis.set_title(f"{name}  ({impacts} impacts)", fontsize=10)
        axis.axhspan(1.0, 5.0, color="0.9")
        axis.set_ylim(1e-16, 5.0)
        axis.set_xlabel("time per history [µs]", fontsize=8)
        axis.set_ylabel("largest error / α", fontsize=8)
        axis.grid(True, which="major", color="0.92")
        axis.tick_params(labelsize=7)
    handles, labels = axes.flat[0].get_legend_handles_labels()
    for axis in list(axes.flat)[len(names) :]:
        axis.axis("off")
    list(axes.flat)[-1].legend(handles, labels, fontsize=8, loc="center", frameon=False)
    figure.tight_layout()
    save_chart(figure, path)


def family(name: str) -> str:
    """Name in the legend: that of a method without its option or tolerance."""
    if name.startswith("heyoka"):
        batch = "heyoka, batch of 8" if "batch" in name else "heyoka"
        driven = next((way for way in ("compiled steps", "ensemble") if way in name), "from Python")
        return f"{batch}, {driven}"
    if name.startswith("diffrax vmap"):
        return "diffrax, vmap of 8"
    if name.startswith(f"{LANES} "):
        return name
    return "scipy naive" if "naive" in name else name.split(" ")[0]


def exact_table(rows: list[dict]) -> list[str]:
    """Lines of a table of the methods with exact impacts: ns a sample over the scenes (least, median, most), the same
    over one history of Ribalta in the same scene, and the errors."""
    own = {r["scene"]: r["seconds"] for r in rows if r["method"] == "taylor 8"}
    lines = [
        "| exact impacts | scenes | ns a sample: least, median, most | over `taylor` | error / α |",
        "|---|---|---|---|---|",
    ]
    named = dict.fromkeys(f"{r['method']} {r['option']}".strip() for r in rows)
    for name in named:
        of = [r for r in rows if f"{r['method']} {r['option']}".strip() == name]
        if not of[0]["method"].startswith((*EXACT_SOLVERS, f"{LANES} lanes", "dormand_prince")):
            continue
        times, errors = [r["ns_per_sample"] for r in of], [r["error_alpha"] for r in of]
        over = [r["seconds"] / own[r["scene"]] for r in of]
        middle = statistics.median
        lines.append(
            f"| {name} | {len(of)} | {min(times):.3g}, {middle(times):.3g}, {max(times):.3g} "
            f"| {min(over):.2g}, {middle(over):.2g}, {max(over):.2g} | {min(errors):.0e} to {max(errors):.0e} |"
        )
    return lines


def main(options: Command) -> None:
    """Print the rows and the table of exact methods; write them and their chart."""
    folder, repeats, others = options.folder(), options.number(5, 1), peers(options)
    rows: list[dict] = []
    for scene in scenes(options):
        rows += measure(scene, others, repeats)
        print(f"{scene.name}: {scene.ground.size} samples, {scene.impacts} impacts")
        for r in rows:
            if r["scene"] == scene.name:
                print(
                    f"  {r['method']:46} {r['option']!s:3} {r['error_alpha']:10.2e} alpha {1e6 * r['seconds']:12.1f} us"
                )
    with open(folder / "work_precision.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    chart(rows, folder / "work_precision.png")
    print("\n".join(exact_table(rows)))
    print(f"{platform.machine()}, Python {platform.python_version()}: {folder}/work_precision.png")
    far = [r for r in rows if r["method"].startswith(EXACT_SOLVERS) and not r["error_alpha"] < EXACT]
    assert not far, f"not driven as they are meant to be: {far}"
