"""Deliberately wrong variants of the product's kernels: the same code with one name replaced.

A kernel's Python source runs with its own globals but for the replacements, so that each variant
differs from the product in exactly the mistake it shows.
"""

import math
import types

import numpy as np

from core.rocking import taylor
from core.rocking.compared import comparison, stepped
from core.rocking.events import leave_impact, uplift_side
from core.rocking.methods import NO_TABLE
from core.rocking.outcome import COLLAPSED, STABLE
from core.wall.moment_rotation import NEVER_REACHED, moment, moment_branch


def variant(kernel, **replacements):
    """The kernel's Python function with some of its globals replaced."""
    source = getattr(kernel, "py_func", kernel)
    known = {**source.__globals__, **replacements}
    return types.FunctionType(source.__code__, known, source.__name__, source.__defaults__, source.__closure__)


def taylor_history(integrate, ground, dt, model):
    """theta at the samples, and (outcome, peak, impacts, clamped, samples done)."""
    rotation, none = np.zeros(len(ground)), np.empty(0)
    result = integrate(
        np.asarray(ground, float), dt, 1.0, model, (0.0, 0.0), rotation, np.zeros(len(ground)), none, none
    )
    return rotation, result


def stepped_history(integrate, code, ground, dt, model, option=1):
    rotation, none = np.zeros(len(ground)), np.empty(0)
    result = integrate(
        code,
        np.asarray(ground, float),
        dt,
        1.0,
        model,
        option,
        (0.0, 0.0),
        rotation,
        np.zeros(len(ground)),
        none,
        none,
        NO_TABLE,
    )
    return rotation, result


def _uplift_at_sample(ground, slope, start, end, thresholds):
    side = uplift_side(ground + slope * start, thresholds)
    return (start, side) if side != 0.0 else (end, 0.0)


def _crossing_at_end(v, gap, sign, h):
    after = gap + taylor.increment(v, h)
    return h if sign * after <= 0.0 else -1.0


def _landing_at_end(v, gap, h):
    return h, -1.0, gap + taylor.increment(v, h) <= 0.0


def _crossing_by_sign_change(v, gap, sign, h):
    """Located, but only where the end of the step lies beyond the level."""
    after = gap + taylor.increment(v, h)
    return taylor.first_crossing(v, gap, sign, h) if sign * after <= 0.0 else -1.0


def _rotation_decides(phi, speed, peak, model):
    return (COLLAPSED if phi > model.slenderness else STABLE), max(peak, phi)


def _never_rests(speed, ground, model, thresholds):
    return False


def _one_branch(zone, model):
    _, _, *branch = moment_branch(zone, model)
    return 0.0, NEVER_REACHED, *branch


def _rk4_through_kinks(code, phi, speed, beta, slope, h, model, zone, *rest):
    """Runge-Kutta of order 4 on the law as it stands, kinks inside the step."""

    def push(x, t):
        return model.p2 * ((beta + t * slope) * math.cos(model.slenderness - x) - moment(x, model))

    half = 0.5 * h
    a1 = push(phi, 0.0)
    a2 = push(phi + half * speed, half)
    a3 = push(phi + half * (speed + half * a1), half)
    a4 = push(phi + h * (speed + half * a2), h)
    new = phi + h * speed + h * h / 6.0 * (a1 + a2 + a3)
    return new, speed + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4)


def taylor_variant(**replacements):
    """`integrate` of order 8 with names replaced in the sample it repeats, its parts, and its end."""
    parts = {
        name: variant(getattr(taylor, name), **replacements) for name in ("converged_step", "first_event", "impact")
    }
    return variant(
        taylor.INTEGRATE[8],
        through_sample=variant(taylor.through_sample, **replacements, **parts),
        at_end=variant(taylor.at_end, **replacements),
    )


def _whole_step(tail, growth, order, tolerance, relative):
    """Steps that are not cut, so that both crossings lie in one of them."""
    return 1.0


uplift_at_next_sample = taylor_variant(next_uplift=_uplift_at_sample)
impact_at_end_of_step = taylor_variant(first_crossing=_crossing_at_end, landing=_landing_at_end)
double_crossing_missed = taylor_variant(first_crossing=_crossing_by_sign_change, converged_part=_whole_step)
rotation_decides_at_the_end = taylor_variant(end_of_record=_rotation_decides)
no_rest = variant(
    taylor_variant(leave_impact=variant(leave_impact, stops_rocking=_never_rests)),
    IMPACTS_PER_SAMPLE=1_000,  # of 10 000: enough to see that there is no end
)
kinks_ignored = variant(
    comparison.COMPARISON[False][0],
    stepped=types.SimpleNamespace(
        through_sample=variant(stepped.through_sample, advance=_rk4_through_kinks, moment_branch=_one_branch)
    ),
)
