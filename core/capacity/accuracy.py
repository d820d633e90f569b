"""How sure a q is, in two statements kept apart: what its solver leaves, the spread of its definition."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from core.capacity import independent_solver
from core.capacity.ida import Ida, Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.errors import Cancelled
from core.ground.ground_motion import GroundMotion
from core.packages import require
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS, Method, resolve_auto
from core.wall.impact import velocity_ratio
from core.wall.rocking_model import RockingModel

RECORD_ROUNDING = 1e-5
"""Noise put on the samples, as a fraction of PGA: a record written with five figures."""

NOISES = 8

NOISE = 1e-15
"""Noise on the samples, of each, that no solver in double precision can tell from none."""

PROMISED, TIMES_NOISE = 1e-9, 300.0
"""A history, also of a wall with ties, is wrong by no more than the larger of the first, of theta_c, and so many times
the effect of NOISE on it, but where a landing is tangent to the last digit: one in a thousand built so exceeds it
(resources/docs/speed.md, measured by tests/benchmarks/noise_promise.py). The tolerance of a step
allows it a hundred times what NOISE does to it (core/rocking/taylor_bounds.py); the largest measured is 170."""

HELD_TRIED = 200
"""Random histories of walls held at their top of which none exceeds it; of landings that are tangent none was tried
(tests/core/rocking/test_held_top.py)."""

STEP_FACTORS = (4.0, 2.0, 0.5, 0.2)
"""Steps of the search tried, as multiples of the one asked."""

REPEATS = 5


@dataclass(frozen=True)
class MethodPoint:
    """One method on the governing history. seconds : per history; error : largest |difference| of theta
    over theta_c against the independent solver up to its end [-], None where the method overturns the wall
    that survives."""

    name: str
    option: int
    seconds: float
    error: float | None


Numbers = tuple[float | None, float | None, float | None]
"""q, q_robust, q_slv_robust of a search."""


def _numbers(ida: Ida) -> Numbers:
    return ida.q, ida.q_robust, ida.q_slv_robust


@dataclass(frozen=True)
class Accuracy:
    """Accuracy statement for one wall, on its governing record and sign.

    scale : multiplier of the histories, the last survived one; points : the methods on it, none for a wall that
    `has_single_solver` alone follows;
    solver_q_difference : |q / q_reference - 1| [-], q_reference : of the same search by dormand_prince;
    noise_effect : of NOISE on the history, over theta_c, infinite where it overturns the wall [-];
    held : whether the wall is held at its top, of which fewer histories were tried;
    steps : (q_step, q, q_robust, q_slv_robust); rounded : (q, q_robust, q_slv_robust) of the record with noise of
    RECORD_ROUNDING;
    polarities : (q as recorded, q reversed), None where both are alike.
    """

    record: str
    polarity: int
    scale: float
    method: str
    q: float
    q_reference: float | None
    points: tuple[MethodPoint, ...]
    steps: tuple[tuple[float, *Numbers], ...]
    rounded: tuple[Numbers, ...]
    polarities: tuple[float | None, float | None] | None
    noise_effect: float
    held: bool = False

    @property
    def solver_q_difference(self) -> float | None:
        return None if self.q_reference is None else abs(self.q / self.q_reference - 1.0)

    @property
    def history_difference(self) -> float | None:
        """Largest difference of the governing history by the method used from the independent solver, over theta_c
        [-]. Neither is without error: the bound is `history_bound`."""
        return next((point.error for point in self.points if point.name == self.method), None)

    @property
    def history_bound(self) -> float | None:
        """Bound of the error of the governing history by the Taylor series, over theta_c, rounded up to one figure [-];
        None where noise in the last digit of the samples decides whether the wall stands, and for other methods."""
        if self.method not in ("taylor", "taylor_6") or not math.isfinite(self.noise_effect):
            return None
        bound = max(PROMISED, TIMES_NOISE * self.noise_effect)
        size = 10.0 ** math.floor(math.log10(bound))
        return float(f"{math.ceil(bound / size - 1e-9) * size:.0e}")

    def spread(self, index: int, rows: tuple) -> float | None:
        """Spread of a column: largest over smallest, less one [-]; None with fewer than two numbers."""
        known = [row[index] for row in rows if row[index] is not None]
        return max(known) / min(known) - 1.0 if len(known) > 1 else None


def has_single_solver(model: RockingModel) -> bool:
    """Whether only the series of order 8 follow a wall, whatever is asked for: with bars, of unlike sides, held at its
    top."""
    return bool(model.bars) or model.other is not None or model.bending is not None


def methods(model: RockingModel) -> list[Method]:
    """Methods of the chart, cheapest settings first."""
    chosen = list(METHODS.values())
    chosen += [replace(METHODS[name], option=4) for name in ("newmark_events", "rk4")]
    if model.plateau_end > 0.0:
        chosen = [method for method in chosen if method.name != "linearised"]
    return chosen


def reference_history(motion: GroundMotion, scale: float, model: RockingModel, cancelled) -> np.ndarray:
    """theta [rad] of one history by the independent solver, up to its stop. Raises Cancelled."""
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    theta, _ = independent_solver.history(
        scale * motion.acceleration,
        motion.time_step,
        model.slenderness,
        model.p2,
        model.one_sided != 0.0,
        lambda speed: velocity_ratio(speed, model)[0],
        kinks,
        cancelled,
        tuple((s.sine, s.cosine) for s in (model.restoring, model.mirrored)),
    )
    return theta


def point(motion, scale, model, method: Method, theta: np.ndarray) -> MethodPoint:
    """Time and error of one method on one history."""
    ground, dt = motion.acceleration, motion.time_step
    one = integrate_history(ground, dt, scale, model, method)
    seconds = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        integrate_history(ground, dt, scale, model, method)
        seconds.append(time.perf_counter() - start)
    name = method.name
    if method.name in ("newmark_events", "rk4") and method.option > 1:
        name += f", {method.option} steps"
    error = None
    if one.rotation.size >= theta.size:
        error = float(np.abs(one.rotation[: theta.size] - theta).max() / model.collapse_rotation)
    return MethodPoint(name, method.option, min(seconds), error)


def effect_of_noise(motion: GroundMotion, scale: float, model: RockingModel, method: Method) -> float:
    """Largest deviation of a history over theta_c by NOISES draws of NOISE on each sample [-]; infinite where one of
    them overturns the wall or takes it elsewhere for good."""
    ground, dt = motion.acceleration, motion.time_step
    once, draw, largest = integrate_history(ground, dt, scale, model, method).rotation, np.random.default_rng(1), 0.0
    for _ in range(NOISES):
        moved = integrate_history(
            ground * (1.0 + NOISE * draw.uniform(-1.0, 1.0, ground.size)), dt, scale, model, method
        )
        if moved.rotation.size < ground.size <= once.size:
            return math.inf
        both = min(once.size, moved.rotation.size)
        largest = max(largest, float(np.abs(moved.rotation[:both] - once[:both]).max(initial=0.0)))
    return largest / model.collapse_rotation


def make_accuracy(
    motion: GroundMotion,
    polarity: int,
    ida: Ida,
    other_sign: float | None,
    model: RockingModel,
    method: Method,
    search: Search,
    cancelled: Callable[[], bool] = lambda: False,
) -> Accuracy:
    """Make the accuracy statement for one run with a q: a history of the independent solver and 14 searches, some
    seconds.

    motion : the record
    polarity : 1 as recorded, -1 reversed
    ida : result of the search of this run
    other_sign : q of the same record reversed, None if not searched [-]
    model : of the wall
    method : how the motion is integrated
    search : settings of the search
    cancelled : asked between two analyses
    Raises Cancelled, and OutputError without scipy.
    """
    require("accuracy")
    assert ida.q is not None and ida.bracket is not None
    alone = has_single_solver(model)
    method = METHODS["taylor"] if alone else resolve_auto(method, model, motion.time_step)

    def searched(ground, asked: Search, by: Method) -> Ida:
        return incremental_dynamic_analysis(ground, motion.time_step, motion.pga, polarity, model, by, asked, cancelled)

    scale = polarity * multiplier_of(ida.bracket[0], motion.pga, threshold_of(model))
    points, q_reference = [], None
    if not alone:
        theta = reference_history(motion, scale, model, cancelled)
        for each in methods(model):
            if cancelled():
                raise Cancelled
            points.append(point(motion, scale, model, each, theta))
        q_reference = searched(motion.acceleration, search, METHODS["dormand_prince"]).q
    ground = motion.acceleration
    steps = [(search.q_step, *_numbers(ida))]
    for factor in STEP_FACTORS:
        step = factor * search.q_step
        if 1e-4 <= step <= 0.05:
            result = searched(ground, replace(search, q_step=step), method)
            steps.append((step, *_numbers(result)))
    noise = np.random.Generator(np.random.PCG64(1))
    rounded = [_numbers(ida)]
    for _ in range(NOISES):
        moved = ground + RECORD_ROUNDING * motion.pga * noise.uniform(-1.0, 1.0, ground.size)
        result = searched(moved, search, method)
        rounded.append(_numbers(result))
    pair = (ida.q, other_sign) if polarity > 0 else (other_sign, ida.q)
    return Accuracy(
        record=motion.name,
        polarity=polarity,
        scale=float(scale),
        method=method.name,
        q=ida.q,
        q_reference=q_reference,
        points=tuple(points),
        steps=tuple(sorted(steps)),
        rounded=tuple(rounded),
        polarities=None if model.both_signs_alike else pair,
        noise_effect=effect_of_noise(motion, scale, model, method),
        held=model.bending is not None,
    )
