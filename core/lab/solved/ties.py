"""Walls held by tie bars, and walls held at their top that bend."""

import math
from functools import cache
from typing import NamedTuple

import numpy as np

from core.codes.vertical_bending import mechanism, start_multiplier
from core.known import require_value
from core.lab.solved.clauses import ROOF, loaded
from core.lab.solved.motion import SINE
from core.lab.solved.solved import Answer, Head, Kind, Sketch, Solved, printed, row, worded
from core.lab.solved.walls import Asked
from core.rocking.history import History, integrate_history
from core.rocking.outcome import COLLAPSED
from core.units import G
from core.wall.bars import TieBar
from core.wall.bending import Strip
from core.wall.ties import elongation_at_yield, stress_area

SINE_STEP = 1e-4
"""Time step of the ground [s]: at 5e-4 the straight lines between its samples move the peaks by a ten-thousandth."""


class Tied(NamedTuple):
    """A wall on a bar under three sines.

    height, thickness : [m]; loads : as [[wall.load]] has them
    force : F_y [kN/m]; level : of the bar above the hinge [m]; stands : its elongation when it goes [m]
    amplitude, period : of the sines [g], [s]
    rigid : largest rotation with a bar that does not stretch before it yields [rad]; None where none was worked
    values : by TIED_HEADS
    """

    key: str
    height: float
    thickness: float
    loads: tuple[dict, ...]
    force: float
    level: float
    stands: float
    amplitude: float
    period: float
    rigid: float | None
    values: str


TIED = (
    Tied("low", 3.0, 0.45, (), 1.5, 2.8, 0.40, 0.30, 0.6, 0.0122914, "0.017851 40.81 0.035443"),
    Tied("weak", 3.0, 0.45, (), 1.0, 2.8, 0.40, 0.30, 0.4, 0.0059858, "0.01142 22.80 0.012712"),
    Tied("roof", 3.0, 0.45, (ROOF,), 2.0, 2.8, 0.40, 0.40, 0.5, 0.0030685, "0.008657 15.07 0.011241"),
    Tied("tall", 7.0, 0.83, (), 4.0, 6.5, 0.60, 0.25, 1.0, 0.0240060, "0.028315 174.86 0.078924"),
    Tied("saved", 7.0, 0.83, (), 8.0, 6.5, 0.60, 0.30, 1.5, 0.0540081, "0.091962 587.74 -"),
    Tied("broken", 7.0, 0.83, (), 8.0, 6.5, 0.30, 0.30, 1.5, None, "0.130346 - -"),
)
TIED_HEADS: tuple[Head, ...] = (
    (worded("largest rotation"), "rad"),
    (worded("elongation that stays"), "mm"),
    (worded("largest rotation without the tie"), "rad"),
)


def sines(amplitude: float, period: float) -> np.ndarray:
    """Three periods of a sine of the ground [m/s2]. amplitude : [g]"""
    t = np.arange(round(3.0 * period / SINE_STEP) + 1) * SINE_STEP
    return amplitude * G * np.sin(2.0 * np.pi * t / period)


def tied(one: Tied) -> Solved:
    """The case of a wall with and without its bar."""
    tie = {"kind": "tie", "out_kn_m": one.force, "h_m": one.level, "bar_length_m": 8.0, "elongation_m": one.stands}
    keys = {"height_m": one.height, "thickness_m": one.thickness, "velocity_ratio": 0.5}
    bare = Asked(keys | ({"load": list(one.loads)} if one.loads else {}), None)
    held = Asked(keys | ({"load": list(one.loads)} if one.loads else {}) | {"hold": [tie]}, None)

    @cache
    def motion(asked: Asked) -> History:
        return integrate_history(sines(one.amplitude, one.period), SINE_STEP, 1.0, asked.model)

    def found() -> tuple[float, ...]:
        return motion(held).peak, 1e3 * one.level * motion(held).residual[0, -1], motion(bare).peak

    def without_elongation() -> float:
        """The largest rotation with a bar that does not stretch before it yields."""
        block = held.wall.block()
        moment = 18e3 * one.height * one.thickness * block.radius
        bar = TieBar(one.level, 1e3 * one.force, 1e-9, 0.0, one.stands).scaled(moment)
        return integrate_history(
            sines(one.amplitude, one.period), SINE_STEP, 1.0, held.model._replace(bars=(bar,))
        ).peak

    answers = row(TIED_HEADS, one.values, found, 1.5)  # by as much the two integrators differ
    if one.rigid is not None:
        # the bar of a nanometre is stiff, not rigid
        answers = (
            *answers,
            Answer(worded("largest rotation, rigid bar"), "rad", one.rigid, 2e-4, without_elongation, 7),
        )
    if one.values.endswith("-"):
        fallen = Answer(
            worded("overturns without the tie (1 yes)"), "", 1.0, 0.0, lambda: motion(bare).outcome == COLLAPSED
        )
        answers = (*answers, fallen)
    if one.key == "broken":
        gone = Answer(worded("the bar is gone (1 yes)"), "", 1.0, 0.0, lambda: np.isinf(motion(held).residual[0, -1]))
        answers = (*answers, gone)
    return Solved(
        f"tie_{one.key}",
        Kind.HAND,
        worded("Wall {h:g} × {t:g} m on a tie of {force:g} kN/m", h=one.height, t=one.thickness, force=one.force),
        "AlShawa, Liberatore, Liberatore, Mollaioli, Sorrentino (2019), Int. J. Archit. Herit.; physics.md, 18",
        answers,
        "F = cases(0 & u <= u_p, k (u - u_p) & u_p < u < u_p + u_y, F_y & u >= u_p + u_y), quad u = h sin theta",
        lambda: Sketch(held.sketch().outline, held.sketch().loads, SINE * 3),
        worded(
            "Bar of 8 m and 235 MPa at {h:g} m, it stands {stands:g} m; e = 0.5, three sines of {a:g} g "
            "and {period:g} s, then none. Two integrators of steps of their own, one of them of the "
            "fourth order of Runge and Kutta.",
            h=one.level,
            stands=one.stands,
            a=one.amplitude,
            period=one.period,
        ),
    )


TIE = {"kind": "tie", "out_kn_m": 5.0, "h_m": 2.8, "bar_length_m": 8.0, "elongation_m": 0.4}


def by_clauses(share: float, factor: float, state: str) -> tuple[Answer, ...]:
    """The wall with its roof and a tie at yield: the tie in alpha_0 and in a(d), not in d_0."""
    from core.lab.solved.walls import EN_B

    asked = Asked(
        {"height_m": 3.0, "thickness_m": 0.45, "velocity_ratio": 0.6, "load": [ROOF], "hold": [TIE]},
        EN_B | {"limit_state": state},
    )
    bare, held = (24.3 * 0.225 + 3.0) / 36.45, 5.0 * 2.8 / 36.45
    alpha, radius = math.atan(0.15), math.hypot(0.225, 1.5)
    collapse = math.atan2(24.3 * 0.225 + 3.0, 36.45 + 30.0)
    d0 = radius * (math.sin(alpha) - math.sin(alpha - collapse))
    a = ((1.0 - share) * bare + held) * 9.80665 / 1.35
    return (
        Answer(f"α_0 ({state})", "", bare + held, 1e-9, lambda: asked.checked.alpha0),
        Answer(f"d_0 ({state})", "m", d0, 1e-9, lambda: asked.checked.d0),
        Answer(f"d_{state}", "m", share * d0, 1e-9, lambda: require_value(asked.checked.d_limit)),
        Answer(f"a(d_{state})", "m/s²", a, 1e-9, lambda: require_value(asked.checked.a_limit)),
        Answer(
            f"T_{state}",
            "s",
            factor * math.pi * math.sqrt(share * d0 / a),
            1e-9,
            lambda: require_value(asked.checked.period),
        ),
    )


def thread(diameter: int, area: str) -> Answer:
    expected = float(area)  # the table is rounded, and of the core of the thread
    return Answer(f"A_res (M{diameter})", "mm²", expected, 5e-3, lambda: 1e6 * stress_area(1e-3 * diameter))


def strip(*loads: tuple[float, float]) -> Strip:
    """3.0 x 0.30 m, 18 kN/m3. loads : (N [kN/m], distance from the outer face [m])"""
    return Strip(3.0, 0.30, 0.0, 18.0 * 0.30 * 3.0, loads)


def bent(key: str, load: tuple[float, float], values: str) -> tuple[Answer, ...]:
    def found() -> tuple[float, ...]:
        one = mechanism(strip(load))
        return one.alpha0, one.h1, one.d_c0, one.e_star

    name = f"N {load[0]:g} kN/m, d {load[1]:g} m"
    heads = ((f"α_0 ({name})", ""), (f"h_1 ({name})", "m"), (f"d_C,0 ({name})", "m"), (f"e* ({name})", ""))
    return row(heads, values, found, 1.0)


def spanning(thrust: float, thickness: float, spacing: float, weight: float, alpha0: str) -> tuple[Answer, ...]:
    """alpha_0 and d_C,0 of a wall between transverse walls. thrust : H [kN/m]; weight : [kN/m3]"""

    def found() -> tuple[float, float]:
        ends = ((1e3 * thrust, 0.0),)
        one = mechanism(Strip(spacing, thickness, 0.0, 1e3 * weight * thickness * spacing, ends, lies=True))
        return one.alpha0, one.d_c0

    heads = ((f"α_0 (H {thrust:g} kN/m, L {spacing:g} m)", ""), (f"d_C,0 (t {thickness:g} m)", "m"))
    return row(heads, f"{alpha0} {thickness:.2f}", found, 1.0)


def bending_sketch(*loads: tuple[float, float]) -> Sketch:
    box = ((0.0, 0.0), (0.3, 0.0), (0.3, 3.0), (0.0, 3.0))
    return Sketch(box, tuple((d, 3.0, 0.0, -1.0) for _, d in loads), others=(((0.0, 2.088), (0.3, 2.088)),))


CASES: tuple[Solved, ...] = (
    *map(tied, TIED),
    Solved(
        "tie_clauses",
        Kind.HAND,
        worded("A tie in the clauses"),
        "Circolare 7/2019, C8.7.1.1, C8.7.1.2.1.6, C8.7.1.10, C8.7.1.11",
        by_clauses(0.40, 1.68, "SLV") + by_clauses(0.60, 1.56, "SLC"),
        "alpha_0 = (W t\\/2 + N d + F_y h)/(W H\\/2), quad a(d) = [(1 - d\\/d_0) alpha_(0,b) + F_y "
        'h/(W H\\/2)] g/("FC")',
        loaded(ROOF, hold=[TIE]).sketch,
        worded(
            "3.0 × 0.45 m with its roof and a tie of 5 kN/m at 2.8 m: the force at yield counts in α_0 "
            "and in the capacity, d_0 is of the wall without it."
        ),
        loaded(ROOF, hold=[TIE]).table,
    ),
    Solved(
        "tie_elongation",
        Kind.HAND,
        worded("Elongation of a bar at yield"),
        "E 205 GPa",
        (printed(("u_y", "mm"), "9.171", lambda: 1e3 * elongation_at_yield(8.0)),),
        "u_y = f_y L/E",
        loaded(ROOF, hold=[TIE]).sketch,
        worded("8 m of 235 MPa."),
    ),
    Solved(
        "tie_threads",
        Kind.PRINTED,
        worded("Stress area of threads"),
        "NTC 2018, Tab. 4.2.XVI",
        tuple(
            thread(diameter, area)
            for diameter, area in (
                (12, "84.3"),
                (14, "115"),
                (16, "157"),
                (18, "192"),
                (20, "245"),
                (22, "303"),
                (24, "353"),
                (30, "561"),
                (48, "1473"),
                (64, "2676"),
            )
        ),
        'A_"res" = pi/4 (d - 0.9382 P)^2',
        comment=worded("The table gives three digits: half a per cent is the tolerance."),
    ),
    Solved(
        "bending_loaded",
        Kind.HAND,
        worded("Vertical bending of a wall held at its top, with a load"),
        "Circolare 7/2019, C8.7.1.1, C8.7.1.4, C8.7.1.5; physics.md, 19",
        bent("middle", (10.0, 0.15), "0.66779 2.088 0.2333 1") + bent("outer", (10.0, 0.0), "0.84658 1.854 0.30000 1"),
        "alpha_0 (h_1) = [W_1 t\\/2 + W_2 (t + k t\\/2) + N (t + k (t - d))]/((W_1 + W_2) h_1\\/2), "
        "quad k = h_1/(H - h_1)",
        bending_sketch((10.0, 0.15)),
        worded(
            "3.0 × 0.30 m, 18 kN/m³: the lowest over the height h_1 of the hinge; d_C,0 by the finite "
            "geometry of both blocks."
        ),
    ),
    Solved(
        "arch",
        Kind.HAND,
        worded("Horizontal bending of a wall between transverse walls"),
        "Circolare 7/2019, C8.7.1.1; physics.md, 19",
        spanning(30.0, 0.45, 5.0, 18.0, "0.53333")
        + spanning(20.0, 0.30, 4.0, 18.0, "0.55556")
        + spanning(60.0, 0.60, 8.0, 20.0, "0.37500"),
        "alpha_0 = (8 H)/(w L^2), quad d_(C,0) = t",
        comment=worded("Three walls, hinges at the faces: H per metre of height, w L t between the transverse walls."),
    ),
    Solved(
        "bending_free",
        Kind.HAND,
        worded("Vertical bending with the hinge in the middle"),
        "Circolare 7/2019, C8.7.1.1; physics.md, 19",
        (
            Answer("α_0 (h_1 = 1.5 m)", "", 0.4, 1e-12, lambda: start_multiplier(strip(), 1.5)),
            Answer("d_C,0 (h_1 = 1.5 m)", "m", 0.3, 1e-6, lambda: mechanism(strip(), 1.5).d_c0),
        ),
        "alpha_0 = (2 t)/h_1",
        bending_sketch(),
        worded("3.0 × 0.30 m without load."),
    ),
)
