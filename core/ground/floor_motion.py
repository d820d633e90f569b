"""The motion of a floor from that of the ground, by the modes of a linear building."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.ground.ground_motion import GroundMotion
from core.jit.decorators import kernel

TAIL = 1e-3
"""Share of its peak below which the free motion of a mode after the record is left out."""

LINEAR = 1e-3
"""Share of its peak within which the motion of a floor is linear between its samples."""

PER_PERIOD, MAX_START = 8, 64
"""Samples in the shortest period from which on it is seen how linear the motion is, as far as MAX_START parts of a
sample of the record give them: modes so short that they do not, shorter than a case takes, move with the ground."""


@dataclass(frozen=True)
class Mode:
    """A mode of the building at one floor. period : T_k [s]; damping : xi_k; participation : gamma_k psi_k(z) [-]."""

    period: float
    damping: float
    participation: float


@kernel
def _sum_of_ramps(ramps, gain, turn, decay, moved):
    """moved = ramps less the filter gain (z - 1)^2 / (z^2 - turn z + decay) of them."""
    first = second = 0.0
    for k in range(ramps.size):
        value = first + gain * ramps[k]
        first = second - 2.0 * gain * ramps[k] + turn * value
        second = gain * ramps[k] - decay * value
        moved[k] = ramps[k] - value


def modal_acceleration(ground: np.ndarray, dt: float, period: float, damping: float) -> np.ndarray:
    """Absolute acceleration A = -(2 xi w D' + w^2 D) of an oscillator at rest under a ground motion [m/s2], exact for
    a ground linear between samples; both terms of A, since a floor feels the damping force too.

    ground : [m/s2], shape (n,); dt, period [s]; damping [-]
    """
    omega = 2.0 * math.pi / period
    damped = omega * math.sqrt(1.0 - damping * damping)
    # under the ground t the oscillator answers t - exp(-xi w t) sin(w_d t) / w_d; a ground linear between samples is a
    # sum of such ramps, which the z-transform sums as 1 - gain (z - 1)^2 / (z^2 - 2 E cos(w_d dt) z + E^2)
    fades = math.exp(-damping * omega * dt)
    gain = fades * math.sin(damped * dt) / (damped * dt)
    ramps = ground - ground[0]
    moved = np.empty(ground.size)
    _sum_of_ramps(ramps, gain, 2.0 * fades * math.cos(damped * dt), fades * fades, moved)
    # the first value is a step
    times = dt * np.arange(ground.size)
    decay = np.exp(-damping * omega * times)
    swing = np.cos(damped * times) - damping * omega / damped * np.sin(damped * times)
    return moved + ground[0] * (1.0 - decay * swing)


def floor_acceleration(ground: np.ndarray, dt: float, modes: Sequence[Mode]) -> tuple[np.ndarray, float]:
    """(absolute acceleration of the floor [m/s2], its time step [s]): (1 - sum gamma psi) u'' + sum gamma psi A_k, what
    the modes leave out moving with the ground (resources/docs/physics.md, section 16), its samples so close that it is
    linear between them within LINEAR of its peak. The record itself where no mode takes part. ground : [m/s2],
    shape (n,); dt [s].
    """
    modes = [mode for mode in modes if mode.participation != 0.0]
    if not modes:
        return ground, dt
    parts = min(math.ceil(PER_PERIOD * dt / min(mode.period for mode in modes)), MAX_START)
    floor, finer = (_sampled(ground, dt, modes, n) for n in (parts, 2 * parts))
    while not _is_linear(floor, finer):
        parts *= 2
        floor, finer = finer, _sampled(ground, dt, modes, 2 * parts)
    return floor, dt / parts


def _is_linear(floor: np.ndarray, finer: np.ndarray) -> bool:
    """Whether a motion is linear between its samples, seen half way between them."""
    size = min(floor.size, (finer.size + 1) // 2)
    middles = 0.5 * (floor[: size - 1] + floor[1:size])
    return bool(np.abs(finer[1 : 2 * size - 1 : 2] - middles).max() <= LINEAR * np.abs(finer).max())


def _sampled(ground: np.ndarray, dt: float, modes: Sequence[Mode], parts: int) -> np.ndarray:
    """Sample the acceleration of the floor [m/s2] `parts` times a time step, over the record and after it until the
    modes have died down."""
    # after the record the ground is still; the envelope falls from above the peak, by no more than within a period
    tail = max(mode.period + math.log(1.0 / TAIL) / (mode.damping * 2.0 * math.pi / mode.period) for mode in modes)
    samples = np.arange((ground.size + math.ceil(tail / dt)) * parts) / parts
    moving = np.interp(samples, np.arange(ground.size + 1), np.append(ground, 0.0))
    floor = (1.0 - sum(mode.participation for mode in modes)) * moving
    last = (ground.size - 1) * parts
    for mode in modes:
        part = modal_acceleration(moving, dt / parts, mode.period, mode.damping)
        floor += mode.participation * part
        above = np.nonzero(np.abs(part) > TAIL * np.abs(part).max())[0]
        last = max(last, int(above[-1]))
    return floor[: last + 1].copy()


def floor_motion(motion: GroundMotion, modes: Sequence[Mode]) -> GroundMotion:
    """The motion of the floor under a record, under its name; see `floor_acceleration`."""
    acceleration, dt = floor_acceleration(motion.acceleration, motion.time_step, modes)
    if acceleration is motion.acceleration:
        return motion
    return replace(motion, acceleration=acceleration, time_step=dt, ground_pga=motion.pga)
