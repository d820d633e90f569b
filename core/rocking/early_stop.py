"""When an analysis may end before its record: the rest of the ground cannot change what it is asked for
(resources/docs/physics.md, section 9)."""

import math

import numpy as np

from core.jit.decorators import inner_kernel, subkernel
from core.rocking.events import IMPACTS_PER_SAMPLE, LAST_ROTATION
from core.units import G
from core.wall.moment_rotation import potential
from core.wall.rocking_model import seen_from, sides_differ

MAX_BOUNCES = 20.0
"""Upper bound of the bounces of a chatter that dies, to its rest, times the distance of the velocity ratio from 1: the
logarithm of its speed over that of rest."""

MAX_SETTLED_RATIO = 0.999
"""Velocity ratio up to which a block that bounces to its rest within a sample stays below the limit of impacts:
their number is at most ln(0.5e6 (1 - e) p dt) / (1 - e), 7300 at p dt = 3 (section 9)."""

SETTLED_EVERY = 64
"""Samples between two checks of whether an analysis is settled."""

RECOVERY_EVERY = 8
"""Samples between two checks of whether a block beyond alpha can still recover."""

LOOKAHEAD = 8
"""Samples of the ground whose bounds are known ahead of each sample, that sample among them."""


@subkernel
def cannot_recover(phi, speed, strongest, model):
    """Whether the block surely overturns: even under the strongest ground, pushing inward all the time, its energy
    exceeds the barrier (Eq. 1 beyond theta_c, resources/docs/physics.md, section 9).

    phi [rad]; speed : outward positive [rad/s]
    strongest : bound of |u''|/g; with FAR only the rotation decides
    model : RockingModel as the pivot sees it
    """
    if phi > LAST_ROTATION:
        return True
    restoring = model.restoring
    lean = phi - (model.slenderness + restoring.lean)
    if lean <= 0.0 or speed <= 0.0:
        return False
    # outward over p2 : along sin(lean) - across cos(lean), from a sin + c cos and the ground at alpha - phi
    ground = strongest / restoring.amplitude
    along = restoring.amplitude + ground * restoring.cosine
    across = ground * restoring.sine
    if along <= 0.0:
        return False
    if math.tan(lean) * along >= across:
        return True
    top = math.sqrt(along * along + across * across)
    barrier = top - along * math.cos(lean) - across * math.sin(lean)
    return speed * speed > 2.0 * model.p2 * barrier


def lookahead_bounds(ground: np.ndarray, dt: float) -> np.ndarray:
    """Bounds of the ground from each sample on, shape (4, n): highest and lowest ground acceleration and largest
    change from sample to sample over LOOKAHEAD samples [m/s2], a bound of the integral of |u''| to the end [m/s].

    Beyond the record the ground is still. Computed once for all analyses of a record.
    """
    longer = np.concatenate([ground, np.zeros(LOOKAHEAD)])
    windows = np.array([longer, -longer, np.abs(np.diff(longer, append=0.0))])
    shift = LOOKAHEAD // 2
    while shift > 0:
        np.maximum(windows[:, :-shift], windows[:, shift:], out=windows[:, :-shift])
        shift //= 2
    size = np.abs(longer)
    push = np.cumsum((0.5 * dt * (size[1:] + size[:-1]))[::-1])[::-1]
    return np.vstack([windows[0], -windows[1], windows[2], np.append(push, 0.0)])[:, : ground.size].copy()


@inner_kernel
def chatter_ends(speed, scale, ahead, i, dt, time, impacts, peak, model, constants):
    """Whether ever smaller bounces surely bring the block to rest within this time, rigid law.

    A bound, so that the bounces need not be integrated: over the window the restoring acceleration exceeds 0.9 of
    that under the strongest ground; each flight lasts at most twice its speed over that acceleration, lands with
    the energy it left with plus what the change of the ground adds, and leaves by the velocity ratio (Eq. 1, 3),
    which must not depend on the speed. Beyond the record the ground is still, as in `end_of_record`.

    speed : just after an impact [rad/s]
    scale : multiplier [-]
    ahead : of `lookahead_bounds`, shape (4, n)
    i : the sample
    dt : its length [s]
    time : to the end of the window [s]
    impacts : in this sample
    peak : largest rotation so far [rad]
    model : RockingModel
    constants : WallConstants
    """
    right, left = constants.thresholds
    highest = max(scale * ahead[0, i], scale * ahead[1, i])
    lowest = min(scale * ahead[0, i], scale * ahead[1, i])
    strongest = max(highest, -lowest)
    free = constants.cosine * min(right - highest, left + lowest) / G
    if not free > 0.0 or model.ratio_drop != 0.0:
        return False
    pull = 0.9 * model.p2 * free
    per_pull = 1.0 / pull
    height = 0.5 * speed * speed * per_pull
    flight = 2.0 * speed * per_pull
    gain = 0.5 * model.p2 * abs(scale) * ahead[2, i] * (1.0 / G) * (flight * per_pull)
    loss = dt - model.ratio_at_rest * (dt + gain)
    return (
        height * (constants.strength + strongest * (1.0 / G)) <= 0.1 * free
        and height <= peak
        and flight * dt <= 0.999 * loss * time
        and loss * (IMPACTS_PER_SAMPLE - impacts) >= MAX_BOUNCES * dt
    )


@subkernel
def settled(phi, speed, peak, push, model):
    """Whether the rest of the record can neither overturn the block nor move it beyond its peak so far.

    From Eq. 1 the root of twice the energy over I0 grows at most with p2 |u''| / g, impacts only lower it,
    and below the barrier the energy bounds the rotation. phi, peak [rad]; speed [rad/s]; push : the last of
    `lookahead_bounds`, times the multiplier [m/s]; model : RockingModel as the pivot sees it.
    """
    top = model.slenderness + model.restoring.lean
    if phi >= top:
        return False
    energy = speed * speed + 2.0 * model.p2 * potential(phi, model)
    reach = math.sqrt(energy) + model.p2 / G * push
    allowed = potential(min(peak, top), model)
    if sides_differ(model):
        other = seen_from(model, -1.0)
        top = other.slenderness + other.restoring.lean
        allowed = min(allowed, potential(min(peak, top), other))
    return reach * reach < 1.999999 * model.p2 * allowed
