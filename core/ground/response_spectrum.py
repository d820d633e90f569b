"""Exact elastic response of the damped oscillator, response spectra, Housner intensity (Eq. 11)."""

import math

import numpy as np

from core.jit.decorators import kernel, subkernel

SPECTRUM_DAMPING = 0.05
"""Damping ratio of the spectra [-]."""

SAMPLES_PER_PERIOD = 40
"""Looks a period at which a peak is seen within 1 - cos(pi / 40) = 0.3 %."""

HOUSNER_PERIODS = np.linspace(0.1, 2.5, 121)
"""Periods of the Housner intensity [s], every 0.02 s; a 0.1 s step would lose 1.1 %."""


SCALED_PERIODS = np.geomspace(0.02, 12.0, 160)
"""Periods [s] over which the pseudo-velocity is integrated for walls whose band of it follows their own time."""

LANES = 32
"""Oscillators that follow the motion side by side."""

UNLIKE = 8
"""Oscillators that follow it side by side where they are looked at unlike often between two samples."""

WORK_SIZE = 14 * LANES
A11, A12, A21, A22, STIFFNESS, VISCOUS, LOOKS, LOOK, V_PART, U, V, U_NEXT, V_NEXT, PEAK = range(0, WORK_SIZE, LANES)
"""Where the rows of the oscillators begin in their room: their recursion, w^2, 2 z w, looks a sample and from one to
the next [s], the particular solution, where they are and where they are next, and their largest displacement."""


@subkernel
def _fill_peaks(ground, dt, periods, damping, per_period, rows, peaks):
    """Largest |relative displacement| of oscillators at rest under a ground motion [m], each as if alone.

    ground, dt, periods, damping, per_period : of `displacement_spectrum`, periods in any order, shape (m,)
    rows : room for the oscillators, shape (WORK_SIZE,)
    peaks : results, shape (m,)

    Exact recursion of Nigam and Jennings (1969). With one look a sample, as is the custom, few samples a period give a
    peak too low (6 % at T = 0.1 s, dt = 0.02 s; 0.1 % of SI). The free motion after the record counts too, exactly, so
    that zeros appended to the record change little.
    """
    most = 1
    for j in range(periods.size):
        parts = _parts(dt, periods[j], per_period)
        h = dt / parts
        w = 2.0 * math.pi / periods[j]
        wd = w * math.sqrt(1.0 - damping * damping)
        decay = math.exp(-damping * w * h)
        sine = decay * math.sin(wd * h)
        cosine = decay * math.cos(wd * h)
        rows[A11 + j] = cosine + damping * w / wd * sine
        rows[A12 + j] = sine / wd
        rows[A21 + j] = -w * w / wd * sine
        rows[A22 + j] = cosine - damping * w / wd * sine
        rows[STIFFNESS + j] = w * w
        rows[VISCOUS + j] = 2.0 * damping * w
        rows[LOOKS + j] = parts
        rows[LOOK + j] = h
        rows[U + j] = 0.0
        rows[V + j] = 0.0
        rows[PEAK + j] = 0.0
        most = max(most, parts)
    for i in range(ground.size - 1):
        # particular solution of u'' + 2 z w u' + w2 u = -(g0 + slope t)
        slope = (ground[i + 1] - ground[i]) / dt
        for j in range(periods.size):
            rows[V_PART + j] = -slope / rows[STIFFNESS + j]
        for k in range(most):
            for j in range(periods.size):
                v_part = rows[V_PART + j]
                push = -(ground[i] + k * rows[LOOK + j] * slope)
                u_part = (push - rows[VISCOUS + j] * v_part) / rows[STIFFNESS + j]
                u, v = rows[U + j], rows[V + j]
                du, dv = u - u_part, v - v_part
                u_next = rows[A11 + j] * du + rows[A12 + j] * dv + u_part + v_part * rows[LOOK + j]
                v_next = rows[A21 + j] * du + rows[A22 + j] * dv + v_part
                waits = k >= rows[LOOKS + j]  # for the next sample
                rows[U_NEXT + j] = u if waits else u_next
                rows[V_NEXT + j] = v if waits else v_next
            for j in range(periods.size):
                rows[U + j] = rows[U_NEXT + j]
                rows[V + j] = rows[V_NEXT + j]
                rows[PEAK + j] = max(rows[PEAK + j], abs(rows[U_NEXT + j]))
    for j in range(periods.size):
        w = 2.0 * math.pi / periods[j]
        wd = w * math.sqrt(1.0 - damping * damping)
        peaks[j] = max(rows[PEAK + j], free_peak(rows[U + j], rows[V + j], w, wd, damping))


@subkernel
def free_peak(u, v, w, wd, damping):
    """Largest |displacement| of the free motion from (u, v): at its first turning point."""
    sine = -w * w * u / wd - damping * w / wd * v
    # u'(t) ~ v cos(wd t) + sine sin(wd t)
    time = math.atan2(-v, sine) / wd
    if time < 0.0:
        time += math.pi / wd
    decay = math.exp(-damping * w * time)
    moved = u * math.cos(wd * time) + (v + damping * w * u) / wd * math.sin(wd * time)
    return abs(decay * moved)


@subkernel
def _parts(dt, period, per_period):
    return max(1, math.ceil(per_period * dt / period))


@kernel
def _fill_spectrum(ground, dt, periods, damping, per_period, rows, spectrum):
    """`displacement_spectrum` of neighbours: LANES with the same number of looks a sample, or UNLIKE ones.

    ground, dt, periods, damping, per_period : of `displacement_spectrum`
    rows : room, shape (WORK_SIZE,)
    spectrum : results, shape of periods
    """
    first = 0
    while first < periods.size:
        end = min(first + LANES, periods.size)
        if _parts(dt, periods[first], per_period) != _parts(dt, periods[end - 1], per_period):
            end = min(first + UNLIKE, periods.size)
        _fill_peaks(ground, dt, periods[first:end], damping, per_period, rows, spectrum[first:end])
        first = end


def displacement_spectrum(ground, dt, periods, damping, per_period):
    """Relative displacement spectrum [m], shape of periods [s]; per_period : least number of times a period the
    response is looked at, 0 for the samples alone; the rest as `_fill_peaks`."""
    spectrum, rows = np.empty(periods.size), np.empty(WORK_SIZE)
    _fill_spectrum(ground, dt, periods, damping, per_period, rows, spectrum)
    return spectrum


def pseudo_velocity_spectrum(ground, dt, periods, damping=SPECTRUM_DAMPING):
    """Pseudo-velocity spectrum omega Sd, peaks at the samples [m/s]; ground [m/s2], dt, periods [s]."""
    return 2.0 * math.pi / periods * displacement_spectrum(ground, dt, periods, damping, 0)


def pseudo_acceleration_spectrum(ground, dt, periods, damping=SPECTRUM_DAMPING, per_period=SAMPLES_PER_PERIOD):
    """Pseudo-acceleration spectrum omega^2 Sd [m/s2]; ground [m/s2], dt, periods [s].

    Peaks between the samples are seen (within 0.3 %), unlike in SI, whose custom is the samples.
    """
    omega = 2.0 * math.pi / periods
    return omega * omega * displacement_spectrum(ground, dt, periods, damping, per_period)


def housner_intensity(ground, dt) -> float:
    """SI [m], Eq. 11: integral of the 5 % pseudo-velocity from 0.1 to 2.5 s, not divided by 2.4."""
    velocity = pseudo_velocity_spectrum(ground, dt, HOUSNER_PERIODS)
    return float(np.trapezoid(velocity, HOUSNER_PERIODS))


def velocity_integral(ground, dt) -> np.ndarray:
    """Integral of the 5 % pseudo-velocity from the first of SCALED_PERIODS to each of them [m]."""
    return integral_of(pseudo_velocity_spectrum(ground, dt, SCALED_PERIODS))


def integral_of(velocity) -> np.ndarray:
    """Integral of a pseudo-velocity [m/s] at SCALED_PERIODS from the first of them to each [m]."""
    return np.concatenate([[0.0], np.cumsum(0.5 * (velocity[1:] + velocity[:-1]) * np.diff(SCALED_PERIODS))])
