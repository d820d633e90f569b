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


@subkernel
def peak_displacement(ground, dt, period, damping, parts):
    """Largest |relative displacement| of an oscillator at rest under a ground motion [m].

    ground : acceleration, linear between samples [m/s2], shape (n,); dt [s]; period [s]; damping [-];
    parts : per_period taken per sample. Exact recursion of Nigam and Jennings (1969). With one look a sample, as
    is the custom, few samples a period give a peak too low (6 % at T = 0.1 s, dt = 0.02 s; 0.1 % of SI).
    The free motion after the record counts too, exactly, so that zeros appended to the record change
    little.
    """
    w = 2.0 * math.pi / period
    wd = w * math.sqrt(1.0 - damping * damping)
    h = dt / parts
    decay = math.exp(-damping * w * h)
    sine = decay * math.sin(wd * h)
    cosine = decay * math.cos(wd * h)
    w2 = w * w
    a11 = cosine + damping * w / wd * sine
    a12 = sine / wd
    a21 = -w2 / wd * sine
    a22 = cosine - damping * w / wd * sine
    u = 0.0
    v = 0.0
    peak = 0.0
    for i in range(ground.size - 1):
        # particular solution of u'' + 2 z w u' + w2 u = -(g0 + slope t)
        slope = (ground[i + 1] - ground[i]) / dt
        v_part = -slope / w2
        for k in range(parts):
            u_part = (-(ground[i] + k * h * slope) - 2.0 * damping * w * v_part) / w2
            du = u - u_part
            dv = v - v_part
            u = a11 * du + a12 * dv + u_part + v_part * h
            v = a21 * du + a22 * dv + v_part
            peak = max(peak, abs(u))
    return max(peak, free_peak(u, v, w, wd, damping))


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


@kernel
def _fill_spectrum(ground, dt, periods, damping, per_period, spectrum):
    for k in range(periods.size):
        parts = max(1, math.ceil(per_period * dt / periods[k]))
        spectrum[k] = peak_displacement(ground, dt, periods[k], damping, parts)


def displacement_spectrum(ground, dt, periods, damping, per_period):
    """Relative displacement spectrum [m], shape of periods [s]; per_period : least number of times a period the
    response is looked at, 0 for the samples alone; the rest as `peak_displacement`."""
    spectrum = np.empty(periods.size)
    _fill_spectrum(ground, dt, periods, damping, per_period, spectrum)
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
