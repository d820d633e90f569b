"""Uplift, impact, rest and the end of the record, shared by every method.

Rotations are seen from the pivot, phi = side * theta >= 0, so that two-sided, one-sided and mirrored
motion are one analytic equation.
"""

import math
from typing import NamedTuple

from core.jit.decorators import subkernel
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.impact import velocity_ratio
from core.wall.moment_rotation import potential, rotation_at_potential
from core.wall.rocking_model import seen_from, sides_differ

REST_FRACTION = 1e-6
"""After an impact the block rests below this fraction of p alpha (1e-9 changes no history, no q)."""

IMPACTS_PER_SAMPLE = 10_000
"""More impacts than this within one sample end the analysis as impact_limit."""

LAST_ROTATION = 0.5 * math.pi
"""Beyond this rotation [rad] the equation of motion has no meaning: collapsed."""


class BlockState(NamedTuple):
    """The block at one instant.

    side : of the pivot, 1.0 or -1.0
    phi, speed : rotation seen from the pivot [rad] and its rate [rad/s]
    moving : False at rest
    zone : branch of the moment law
    peak : largest phi so far [rad]
    impacts, clamped : so far; clamped counts the impacts whose Eq. 7 was held at 0
    """

    side: float
    phi: float
    speed: float
    moving: bool
    zone: int
    peak: float
    impacts: int
    clamped: int


@subkernel
def uplift_thresholds(model):
    """Ground acceleration above which the resting block uplifts and, reversed, the one below which it does to the
    other side [m/s2], Eq. 2: a_RM = g (a tan(alpha) + c). 0 if trilinear; infinite where there is no other side."""
    right = left = 0.0
    if model.plateau_end == 0.0:
        tangent = math.tan(model.slenderness)
        right = G * (model.restoring.sine * tangent + model.restoring.cosine)
        tangent = math.tan(seen_from(model, -1.0).slenderness)
        left = G * (model.mirrored.sine * tangent + model.mirrored.cosine)
    return right, math.inf if model.one_sided != 0.0 else left


@subkernel
def uplift_side(ground, thresholds):
    """Side to which this ground acceleration [m/s2] uplifts the resting block: 1.0, -1.0, 0.0 if none."""
    right, left = thresholds
    if ground > right:
        return 1.0
    if ground < -left:
        return -1.0
    return 0.0


@subkernel
def next_uplift(ground, slope, start, end, thresholds):
    """First time in [start, end) at which the resting block uplifts, and to which side.

    ground : acceleration at local time 0 [m/s2]
    slope : its rate [m/s3]
    start, end : local times [s]
    Returns (time, side); time = end if the block stays at rest.
    """
    now = ground + slope * start
    side = uplift_side(now, thresholds)
    if side != 0.0:
        return start, side
    right, left = thresholds
    if slope > 0.0:
        time = (right - ground) / slope
        side = 1.0
    elif slope < 0.0:
        time = (-left - ground) / slope
        side = -1.0
    else:
        return end, 0.0
    if time < start:
        time = start
    if time >= end:
        return end, 0.0
    return time, side


@subkernel
def stops_rocking(speed, ground, model, thresholds):
    """Whether the block rests after an impact it leaves at this speed [rad/s], the ground at [m/s2]."""
    limit = REST_FRACTION * math.sqrt(model.p2) * model.slenderness
    return speed < limit and uplift_side(ground, thresholds) == 0.0


@subkernel
def leave_impact(arriving, side, ground, model, thresholds):
    """Carry the block through an impact at theta = 0 (Eq. 3, 7).

    arriving : speed before it [rad/s], not negative
    side : of the pivot it fell back to
    ground : acceleration at that instant [m/s2]
    model : RockingModel as that pivot sees it
    Returns (speed just after [rad/s], side just after, side from here on, moving, 1 if Eq. 7 was held at 0).
    """
    ratio, clamped = velocity_ratio(arriving, model)
    speed = ratio * arriving
    after = side if model.one_sided != 0.0 else -side
    if stops_rocking(speed, ground, model, thresholds):
        return speed, after, after, False, clamped
    onward = after
    if speed == 0.0 and model.one_sided == 0.0:
        onward = uplift_side(ground, thresholds)
    return speed, after, onward, True, clamped


@subkernel
def apply_impact(arriving, side, ground, model, thresholds, hop, instant, impacts, impact_time, impact_velocity):
    """Carry the block through an impact and write it down.

    arriving, side, ground, model, thresholds : of `leave_impact`
    hop : time since the step before it began [s]
    instant : of the impact [s]
    impacts : so far
    impact_time : results [s], up to its size
    impact_velocity : results just after each impact [rad/s], of the same shape
    Returns (speed just after [rad/s], side from here on, moving, 1 if Eq. 7 was held at 0, whether time must be moved
    on: pushed back by the rounding of the threshold, without a hop).
    """
    speed, after, side, moving, clamp = leave_impact(arriving, side, ground, model, thresholds)
    if impacts < impact_time.size:
        impact_time[impacts] = instant
        impact_velocity[impacts] = after * speed
    stuck = arriving == 0.0 and hop == 0.0
    moving = moving and not stuck
    return speed if moving else 0.0, side, moving, clamp, stuck


@subkernel
def retained_energy_share(ratio, left, onward, other):
    """Share of the energy over I0 p2 that an impact leaves [-]. left, onward : RockingModel as the hinges see it, of
    which I0 p2 = m g R is the same, and p2, in a symmetric wall (other None)."""
    if other is None:
        return ratio * ratio
    return ratio * ratio * left.p2 / onward.p2


@subkernel
def end_of_record(phi, speed, peak, model):
    """Decide by energy what the block does once the ground is still.

    phi : rotation seen from the pivot [rad]
    speed : its rate, outward positive [rad/s]
    peak : largest rotation so far [rad]
    model : RockingModel as that pivot sees it
    Returns (outcome, peak including the free motion).
    """
    top = model.slenderness + model.restoring.lean
    barrier = potential(top, model)
    energy = 0.5 * speed * speed / model.p2 + potential(phi, model)
    if speed >= 0.0 and energy > barrier:
        return COLLAPSED, max(peak, top)
    if phi > top and energy <= barrier:
        return COLLAPSED, peak
    if speed > 0.0:
        peak = max(peak, rotation_at_potential(energy, model))
    # to the other side and, where loads or shape make the sides differ, back
    left = model
    for side in (-1.0, 1.0):
        swing = model if model.one_sided != 0.0 else seen_from(model, side)
        impact_speed = math.sqrt(2.0 * left.p2 * energy)
        ratio, _ = velocity_ratio(impact_speed, left)
        energy *= retained_energy_share(ratio, left, swing, model.other)
        left = swing
        top = swing.slenderness + swing.restoring.lean
        if energy > potential(top, swing):
            return COLLAPSED, max(peak, top)
        if energy > 0.0:
            peak = max(peak, rotation_at_potential(energy, swing))
        if not sides_differ(model):
            break
    return STABLE, peak
