"""Uplift, impact, rest and the end of the record, shared by every method.

Rotations are seen from the pivot, phi = side * theta >= 0, so that two-sided, one-sided and mirrored
motion are one analytic equation.
"""

import math

import numpy as np

from core.kernel_cache import inner_kernel, subkernel
from core.moment_rotation import potential, rotation_at_potential
from core.restitution import velocity_ratio
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G

REST_FRACTION = 1e-6
"""After an impact the block rests below this fraction of p alpha (PHYSICS: 1e-9 changes nothing)."""

IMPACTS_PER_SAMPLE = 10_000
"""More impacts than this within one sample end the analysis as impact_limit."""

MOST_BOUNCES = 20.0
"""More than the bounces of a dying chatter to its rest, times the velocity ratio's distance from 1: the
logarithm of its speed over that of rest."""

LOOK_EVERY = 64
"""Samples between two looks at whether an analysis is settled."""

LOST_EVERY = 8
"""Samples between two looks at whether a block beyond alpha is lost."""

QUIET = 8
"""Samples of the ground looked at ahead of a dying chatter, the present one among them."""

LAST_ROTATION = 0.5 * math.pi
"""Beyond this rotation [rad] the equation of motion has no meaning: collapsed."""


@subkernel
def lift_threshold(model):
    """Ground acceleration above which the resting block lifts [m/s2], Eq. 2; 0 if trilinear."""
    if model.plateau_end > 0.0:
        return 0.0
    return G * math.tan(model.slenderness)


@subkernel
def ground_lifts(ground, model, threshold):
    """Side to which this ground acceleration [m/s2] lifts the resting block: 1.0, -1.0, 0.0 if none."""
    if ground > threshold:
        return 1.0
    if ground < -threshold and model.one_sided == 0.0:
        return -1.0
    return 0.0


@subkernel
def next_uplift(ground, slope, start, end, model, threshold):
    """First time in [start, end) at which the resting block lifts, and to which side.

    ground : acceleration at local time 0 [m/s2]; slope : its rate [m/s3]; start, end : local times [s].
    Returns (time, side); time = end if the block stays at rest.
    """
    now = ground + slope * start
    side = ground_lifts(now, model, threshold)
    if side != 0.0:
        return start, side
    if slope > 0.0:
        time = (threshold - ground) / slope
        side = 1.0
    elif slope < 0.0 and model.one_sided == 0.0:
        time = (-threshold - ground) / slope
        side = -1.0
    else:
        return end, 0.0
    if time < start:
        time = start
    if time >= end:
        return end, 0.0
    return time, side


@subkernel
def stops_rocking(speed, ground, model, threshold):
    """Whether the block rests after an impact it leaves at this speed [rad/s], the ground at [m/s2]."""
    limit = REST_FRACTION * math.sqrt(model.p2) * model.slenderness
    return speed < limit and ground_lifts(ground, model, threshold) == 0.0


@subkernel
def leave_impact(arriving, side, ground, model, threshold):
    """What the block does after an impact at theta = 0 (Eq. 3, 7).

    arriving : speed before it [rad/s], not negative; side : of the pivot it fell back to;
    ground : acceleration at that instant [m/s2]. Returns (speed just after [rad/s], side just after,
    side from here on, moving, 1 if Eq. 7 was held at 0).
    """
    ratio, clamped = velocity_ratio(arriving, model)
    speed = ratio * arriving
    after = side if model.one_sided != 0.0 else -side
    if stops_rocking(speed, ground, model, threshold):
        return speed, after, after, False, clamped
    onward = after
    if speed == 0.0 and model.one_sided == 0.0:
        onward = ground_lifts(ground, model, threshold)
    return speed, after, onward, True, clamped


@subkernel
def end_of_record(phi, speed, peak, model):
    """Decide by energy what the block does once the ground is still.

    phi : rotation seen from the pivot [rad]; speed : its rate, outward positive [rad/s];
    peak : largest rotation so far [rad]. Returns (outcome, peak including the free motion).
    """
    barrier = potential(model.slenderness, model)
    energy = 0.5 * speed * speed / model.p2 + potential(phi, model)
    if speed >= 0.0 and energy > barrier:
        return COLLAPSED, max(peak, model.slenderness)
    if phi > model.slenderness and energy <= barrier:
        return COLLAPSED, peak
    if speed > 0.0:
        peak = max(peak, rotation_at_potential(energy, model))
    impact_speed = math.sqrt(2.0 * model.p2 * energy)
    ratio, _ = velocity_ratio(impact_speed, model)
    energy *= ratio * ratio
    if energy > barrier:
        return COLLAPSED, max(peak, model.slenderness)
    if energy > 0.0:
        peak = max(peak, rotation_at_potential(energy, model))
    return STABLE, peak


def look_ahead(ground: np.ndarray, dt: float) -> np.ndarray:
    """What is to come from each sample on, shape (4, n): highest and lowest ground acceleration and largest
    change from sample to sample over QUIET samples [m/s2], a bound of the integral of |u''| to the end [m/s].

    Beyond the record the ground is still. One call does for all analyses of a record.
    """
    longer = np.concatenate([ground, np.zeros(QUIET)])
    windows = np.array([longer, -longer, np.abs(np.diff(longer, append=0.0))])
    shift = QUIET // 2
    while shift > 0:
        np.maximum(windows[:, :-shift], windows[:, shift:], out=windows[:, :-shift])
        shift //= 2
    size = np.abs(longer)
    push = np.cumsum((0.5 * dt * (size[1:] + size[:-1]))[::-1])[::-1]
    return np.vstack([windows[0], -windows[1], windows[2], np.append(push, 0.0)])[
        :, : ground.size
    ].copy()


@inner_kernel
def dies_down(speed, scale, ahead, i, dt, time, impacts, peak, model, constants):
    """Whether bounces of less and less height bring the block to rest within this time, rigid law.

    Rigorous, so that the bounces need not be followed: over the window the pull back exceeds 0.9 of that
    under the strongest ground, each flight lasts at most twice its speed over the pull, lands with the
    energy it left with plus what the change of the ground adds, and leaves by the velocity ratio (Eq. 1, 3),
    which must not depend on the speed. Beyond the record the ground is still, as `end_of_record` has it.
    speed : just after an impact [rad/s]; scale : multiplier [-]; ahead, i : of `look_ahead`, the sample;
    time : to the end of the window [s]; impacts : in this sample; constants : of `taylor.upright`.
    """
    threshold, _, _, cosine_upright = constants
    highest = max(scale * ahead[0, i], scale * ahead[1, i])
    lowest = min(scale * ahead[0, i], scale * ahead[1, i])
    strongest = max(highest, -lowest)
    free = cosine_upright * (threshold - (highest if model.one_sided != 0.0 else strongest)) / G
    if not free > 0.0 or model.ratio_drop != 0.0:
        return False
    pull = 0.9 * model.p2 * free
    per_pull = 1.0 / pull
    height = 0.5 * speed * speed * per_pull
    flight = 2.0 * speed * per_pull
    gain = 0.5 * model.p2 * abs(scale) * ahead[2, i] * (1.0 / G) * (flight * per_pull)
    loss = dt - model.ratio_at_rest * (dt + gain)
    return (
        height * (1.0 + strongest * (1.0 / G)) <= 0.1 * free
        and height <= peak
        and flight * dt <= 0.999 * loss * time
        and loss * (IMPACTS_PER_SAMPLE - impacts) >= MOST_BOUNCES * dt
    )


@subkernel
def settled(phi, speed, peak, push, model):
    """Whether the rest of the record can neither overturn the block nor move it beyond its peak so far.

    From Eq. 1 the root of twice the energy over I0 grows at most with p2 |u''| / g, impacts only lower it,
    and below the barrier the energy bounds the rotation. phi, peak [rad]; speed [rad/s]; push : the last of
    `look_ahead`, times the multiplier [m/s].
    """
    if phi >= model.slenderness:
        return False
    energy = speed * speed + 2.0 * model.p2 * potential(phi, model)
    reach = math.sqrt(energy) + model.p2 / G * push
    return reach * reach < 1.999999 * model.p2 * potential(min(peak, model.slenderness), model)
