"""Figures of one wall of the note: to scale, the capacity curve over the demand, histories and peaks at the demand."""

import math

import numpy as np

from core.answer.answer import ordered_runs
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.capacity_curve import capacity_curve
from core.codes.dynamic_check import model_and_scale_at_demand
from core.known import require_value
from core.report.load_arrows import arrows, tie_bars
from core.report.note import arch_figure, bending_figure
from core.report.note.parts import Curve, Figure, Label, path
from core.report.outlines import elevation_outlines, section_outlines
from core.report.plots import thinned
from core.report.words import Words
from core.study.bar_histories import bar_histories
from core.study.demand_histories import demand_histories
from core.study.results import StudyResult, WallResult
from core.units import CM, G

TURNED = math.radians(7.0)
"""Rotation of the dashed outline of the mechanism."""

FIGURE_POINTS = 500
"""Points of a history in a figure."""

GENERATED_NAME = "compatible"
"""How the name of a motion that is generated begins: its number is enough in a figure."""

FULL_BAR = 1.2
"""Height of the bar of a wall that overturns, and the top of the chart of peaks."""


def drawing(wall: WallResult, words: Words) -> Figure | None:
    """The wall to scale with its sizes, hinge, restraint, loads and the mechanism; None for a general block."""
    if wall.wall.kinematics.arches:
        return arch_figure.drawing(wall, words)
    if wall.wall.bends:
        return bending_figure.drawing(wall, words)
    h, t, u = wall.height, wall.thickness, wall.wall.setback
    if not wall.wall.height_m:
        return None
    below = wall.part.hinge
    curves = [*_outlines(wall, h, t, u), Curve("", (t - u,), (0.0,), "bad", "points")]
    if below:
        legs = [(0.0, 0.0), (0.0, -below), (t, -below), (t, 0.0)]
        curves.append(path(legs, "quiet", width=0.9))
    reach = 0.45 * (h + below)
    curves.append(Curve("", (-reach, t + reach), (-below, -below), "quiet", width=1.1))
    if wall.kinematics.one_way:
        rise, wide = 0.06 * h, 0.05 * h
        for k in range(1, 15):
            y = k * h / 15.0
            curves.append(Curve("", (-0.3 * wide, -0.3 * wide - wide), (y, y - rise), "quiet", width=0.7))
    for points in (*arrows(wall.wall, h, t), *tie_bars(wall.wall, h, t)):
        curves.append(path(points, "amber", width=1.3))
    top = h * (1.0 + 0.1) + 0.04 * h
    sweep = [TURNED * k / 6.0 for k in range(1, 7)]
    arc = [_turned(0.5 * t, 1.06 * h, t - u, angle) for angle in sweep]
    (x0, y0), (x1, y1) = arc[-2:]
    size, way = 0.05 * h, math.atan2(y1 - y0, x1 - x0)
    barbs = [(x1 - size * math.cos(way + s), y1 - size * math.sin(way + s)) for s in (0.45, 0.0, -0.45)]
    arrow = [*arc, barbs[0], (x1, y1), barbs[2]]
    curves.append(path(arrow, "bad", width=1.3))
    beside = t + math.sin(TURNED) * h + 0.10 * h
    tick = 0.02 * h
    sizes = [
        (beside - tick, 0.0),
        (beside + tick, 0.0),
        (beside, 0.0),
        (beside, h),
        (beside - tick, h),
        (beside + tick, h),
    ]
    curves.append(path(sizes, "ink", width=0.7))
    labels = [
        Label(f"H {words.number(h, '.2f')} m", beside + 0.16 * (h + below), 0.5 * h),
        Label(
            f"t {words.number(t, '.2f')} m" + (f", u {words.number(u, '.3f')} m" if u else ""),
            0.5 * t,
            -below - 0.07 * (h + below),
        ),
    ]
    labels += _sizes_of_loads(wall, words)
    caption = words.say("{wall}: sizes, hinge (red point) and mechanism (dashed)", wall=words.titled(wall.name))
    if (hold := wall.wall.held_by) and wall.kinematics.one_way:
        caption += words.say("; behind it: {restraint}", restraint=words.word(f"choice_{hold.kind}"))
    if wall.wall.is_loaded:
        caption += words.say("; loads as arrows")
    low, high = -below - 0.14 * (h + below), top
    for label in labels:
        high = max(high, label.y + 0.04 * h)
    return Figure(
        caption, curves, y_range=(low, high), labels=labels, x_range=(-0.5 * (h + below), t + 0.5 * (h + below))
    )


def _outlines(wall: WallResult, h: float, t: float, u: float) -> list[Curve]:
    """The wall in section at rest and turned, outward to the right; of a body each of its solids."""
    solids = section_outlines(wall.wall)
    if not solids:
        return [
            path(_corners(h, t, u, 0.0), "accent", width=1.8),
            path(_corners(h, t, u, TURNED), "quiet", "dash", 0.9),
        ]
    curves = []
    for points, kind in solids:
        closed = [(t - x, z) for x, z in (*points, points[0])]
        curves.append(path(closed, *(("quiet", "dash", 0.7) if kind == "opening" else ("accent", "line", 1.6))))
        if kind != "opening":
            turned = [_turned(x, z, t - u, TURNED) for x, z in closed]
            curves.append(path(turned, "quiet", "dash", 0.9))
    return curves


def elevation(wall: WallResult, words: Words) -> Figure | None:
    """A body seen from outside; None of a rectangle."""
    outlines = elevation_outlines(wall.wall)
    if not outlines:
        return None
    curves = [
        path([*points, points[0]], *(("bad", "line", 1.0) if kind == "opening" else ("accent", "line", 1.6)))
        for points, kind in outlines
        if kind != "wedge"
    ]
    across, up = ([p[k] for points, _ in outlines for p in points] for k in (0, 1))
    margin = 0.08 * max(max(up), max(across) - min(across))
    middle, half = 0.5 * (min(across) + max(across)), 0.5 * max(max(across) - min(across), max(up)) + margin
    pierced = any(kind == "opening" for _, kind in outlines)
    caption = words.say(
        "{wall}: elevation, openings in red" if pierced else "{wall}: elevation", wall=words.titled(wall.name)
    )
    curves.append(Curve("", (middle - half, middle + half), (0.0, 0.0), "quiet", width=1.1))
    return Figure(caption, curves, y_range=(-margin, max(up) + margin), x_range=(middle - half, middle + half))


def _sizes_of_loads(wall: WallResult, words: Words) -> list[Label]:
    """The size of each load at the tail of its arrow, or above that of a load at the same place, of a tie below."""
    h, labels = wall.height, list[Label]()
    high = h + wall.part.hinge  # what the figure shows: a text takes the same part of every figure
    lines = [*arrows(wall.wall, h, wall.thickness), *tie_bars(wall.wall, h, wall.thickness)]
    for load, points in zip(wall.wall.in_si.loads, lines, strict=True):
        up = load.is_weight
        x, y = points[0] if up else min(points)
        x, y = (x, y + 0.05 * high) if up else (x - 0.15 * high, y)
        while any(abs(x - label.x) < 0.3 * high and abs(y - label.y) < 0.055 * high for label in labels):
            y += (-0.03 if load.tie else 0.03) * high
        labels.append(Label(f"{words.number(1e-3 * load.force, '.2f')} kN/m", x, y))
    return labels


def _turned(x: float, y: float, hinge: float, angle: float) -> tuple[float, float]:
    """A point turned outward about the hinge."""
    c, s = math.cos(angle), math.sin(angle)
    return hinge + c * (x - hinge) + s * y, -s * (x - hinge) + c * y


def _corners(h: float, t: float, u: float, angle: float) -> list[tuple[float, float]]:
    """The closed outline of the wall, x from its inner face outward."""
    around = ((0.0, 0.0), (t, 0.0), (t, h), (0.0, h), (0.0, 0.0))
    return [_turned(x, y, t - u, angle) for x, y in around]


def capacity(result: StudyResult, wall: WallResult, words: Words) -> Figure | None:
    """The capacity curve over the demand; None where the nonlinear check is not made."""
    mechanism, state = wall.mechanics, result.demand_required.limit_state
    curve = capacity_curve(mechanism, result.demand_required)
    if curve is None:
        return None
    percent = words.number(100.0 * curve.damping, "g")
    along, across = zip(*curve.capacity, strict=True)
    a0 = max(across)
    d, a, s_de, period = map(require_value, (mechanism.d_limit, mechanism.a_limit, mechanism.s_de, mechanism.period))
    curves = [
        Curve(words.say("demand {percent} %", percent=percent), curve.demand_d / CM, curve.demand_a / G, "bad"),
        Curve(words.say("capacity"), tuple(d / CM for d in along), tuple(a / G for a in across), "accent", width=1.8),
    ]
    if curve.floor_d.size:
        curves.insert(
            1, Curve(words.say("floor {percent} %", percent=percent), curve.floor_d / CM, curve.floor_a / G, "amber")
        )
    high = 1.1 * max(a0, *curve.demand_a, *curve.floor_a) / G
    slope = (2.0 * math.pi / period) ** 2
    end = max(1.15 * d, s_de)
    curves += [
        Curve(f"T_{state}", (0.0, end / CM), (0.0, slope * end / G), "quiet", "dash", 0.9),
        Curve(f"d_{state}", (d / CM,), (a / G,), "accent", "points"),
        Curve("S_De", (s_de / CM,), (slope * s_de / G,), "bad", "points"),
    ]
    caption = words.say("Capacity curve (C8.7.1.3) over the demand, spectral displacement and acceleration")
    return Figure(caption, curves, "d [cm]", "a [g]", (0.0, 1.05 * max(mechanism.d0, s_de) / CM), (0.0, high))


def histories(result: StudyResult, wall: WallResult, words: Words) -> Figure | None:
    """Displacement of the control point under the records that decide; None without a dynamic check."""
    deciding = demand_histories(result, wall)
    if not deciding:
        return None
    d0, curves, last = wall.mechanics.d0 / CM, [], 0.0
    for one, color in zip(deciding, ("bad", "accent"), strict=False):
        size = min(one.displacement.size, one.motion.acceleration.size)
        overturned = np.nonzero(np.abs(one.displacement) > 1.5 * wall.mechanics.d0)[0]
        if overturned.size:  # it overturned: what follows is no part of the check
            size = min(size, int(overturned[0]) + 1)
        moved = one.displacement[:size]
        chosen = thinned(moved, FIGURE_POINTS)
        sign = "+" if one.run.polarity > 0 else "−"
        times = [k * one.motion.time_step for k in chosen]
        curves.append(Curve(f"{one.run.record} ({sign})", times, (moved[chosen] / CM).tolist(), color, width=0.9))
        last = max(last, times[-1])
    state = result.demand_required.limit_state
    limit = LIMIT_FRACTION[state] * d0
    both_ways = wall.model.one_sided == 0.0
    for level, name, color in ((limit, f"d_{state}", "amber"), (d0, "d_0", "ink")):
        curves.append(Curve(name, (0.0, last), (level, level), color, "dash", 0.9))
        if both_ways:
            curves.append(Curve("", (0.0, last), (-level, -level), color, "dash", 0.9))
    caption = words.say("Control point at the demand: largest peak")
    if len(deciding) > 1:
        caption += words.say(", and nearest to the mean")
    return Figure(caption, curves, "t [s]", "d [cm]", (0.0, last), (-1.3 * d0 if both_ways else -0.2 * d0, 1.3 * d0))


def forces_of_ties(result: StudyResult, wall: WallResult, words: Words) -> Figure | None:
    """Force of each tie under the record of the largest peak; None of a wall without ties or histories."""
    deciding = demand_histories(result, wall) if wall.model.bars else []
    if not deciding:
        return None
    worst, curves, last = deciding[0], [], 0.0
    weakened, _ = model_and_scale_at_demand(
        wall.model, result.demand_required, require_value(wall.required_assessment.dynamic).confidence_on, worst.motion
    )
    of_bars = bar_histories(wall.wall, worst.history, wall.model.p2 / weakened.p2)
    for one, color in zip(of_bars, ("accent", "bad", "amber", "ink") * 9, strict=False):
        size = min(one.force.size, worst.motion.acceleration.size)
        chosen = thinned(one.force[:size], FIGURE_POINTS)
        times = [k * worst.motion.time_step for k in chosen]
        name = f"h {words.number(one.bar.height, '.2f')} m"
        curves.append(Curve(name, times, (1e-3 * one.force[chosen]).tolist(), color, width=0.9))
        last = max(last, times[-1])
    high = 1.2e-3 * max(tie.bar.strength for tie in wall.wall.in_si.ties)
    caption = words.say("Force of the ties at the demand, under the record of the largest peak")
    return Figure(caption, curves, "t [s]", "F [kN/m]", (0.0, last), (-0.1 * high, high))


def peaks(wall: WallResult, words: Words, named: bool = True) -> Figure | None:
    """Largest rotation of each record at the demand, what overturns and the largest first; None without a dynamic
    check. named : with the names of the records"""
    check = wall.required_assessment.dynamic
    if check is None:
        return None
    both = len({run.polarity for run in check.runs}) > 1
    runs = ordered_runs(check)
    short = [run.record.removeprefix(f"{GENERATED_NAME} ")[-14:] for run in runs]
    names = [
        name + ("" if not both else "+" if run.polarity > 0 else "−") for name, run in zip(short, runs, strict=True)
    ]
    stands = [(k, run.peak_ratio) for k, run in enumerate(runs) if not run.exceeded]
    falls = [k for k, run in enumerate(runs) if run.exceeded]
    curves = []
    if stands:
        places, heights = zip(*stands, strict=True)
        curves.append(Curve(words.say("stands"), places, heights, "accent", "bars"))
    if falls:
        name = words.say("exceeds θc or overturns")
        # what overturned has no number: its bar goes to the top of the chart
        heights = [runs[k].peak_ratio or FULL_BAR for k in falls]
        curves.append(Curve(name, falls, heights, "bad", "bars"))
    ends = (-0.6, len(names) - 0.4)
    if check.set_rule == "mean" and check.mean_peak_ratio is not None:
        mean = check.mean_peak_ratio
        name = words.say("mean {value:.2f}, which decides", value=mean)
        curves.append(Curve(name, ends, (mean, mean), "ink", width=1.6))
    limit = check.limit_ratio
    name = f"{check.limit_state}: {words.number(limit, '.2f')}"
    curves.append(Curve(name, ends, (limit, limit), "amber", "dash"))
    caption = words.say("Largest rotation of each record at the demand over θc")
    return Figure(caption, curves, " ", "θmax/θc", ends, (0.0, FULL_BAR), names=names if named else ())
