"""Worked examples of rocking blocks, and their numbers again by integrators of scipy: none of the program."""

import math

import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from core.lab.solved.published_rocking import (
    CASES,
    ENERGIES,
    OVERTURNING_PEAKS,
    PULSE,
    PULSE_ALPHA,
    PUSH,
    edges_of_sine,
)


def expected(key: str, first: int = 0) -> list[float]:
    (case,) = (case for case in CASES if case.key == key)
    return [answer.expected for answer in case.answers[first:]]


def energy_at_end(alpha, p2, ratio, ground, end, start=0.0):
    """Energy over that of the fall as a motion ends; 1 where the block has fallen before, 0 where it rests.

    alpha : [rad]; p2 : [1/s2]; ratio : of velocities at an impact; ground : u''/g by time; end, start : [s]
    """
    barrier, side, time, state = 1.0 - math.cos(alpha), math.copysign(1.0, -ground(start + 1e-9)), start, [0.0, 0.0]
    while time < end:

        def moved(t, y, side=side):
            lean = side * alpha - y[0]
            return [y[1], -p2 * (math.sin(lean) + ground(t) * math.cos(lean))]

        def lands(t, y, side=side):
            return side * y[0]

        def falls(t, y):
            return abs(y[0]) - alpha

        lands.terminal, lands.direction, falls.terminal = True, -1, True
        found = solve_ivp(moved, (time, end), state, "DOP853", rtol=1e-11, atol=1e-13, events=(lands, falls))
        time, state = float(found.t[-1]), [float(value) for value in found.y[:, -1]]
        if found.t_events[1].size:
            return 1.0
        if found.t_events[0].size:
            state, side = [0.0, ratio * state[1]], -side
    left = (0.5 * state[1] ** 2 / p2 + math.cos(alpha - abs(state[0])) - math.cos(alpha)) / barrier
    return left if side * state[1] > 0.0 else ratio**2 * left  # it lands once more before it could fall


def energy_of_sine(amplitude, radius, share=1.0):
    """Of a block of alpha 0.2 rad after a full sine of a peak over g tan alpha. radius : R [m]"""
    omega, p2 = 2.0 * math.pi / PULSE, 0.75 * 9.80665 / radius
    peak, uplift = amplitude * math.tan(PULSE_ALPHA), math.asin(1.0 / amplitude) / omega
    ratio = share * (1.0 - 1.5 * math.sin(PULSE_ALPHA) ** 2)
    return energy_at_end(PULSE_ALPHA, p2, ratio, lambda t: peak * math.sin(omega * t), PULSE, uplift)


@pytest.mark.parametrize(("radius", "printed"), OVERTURNING_PEAKS)
def test_that_a_full_sine_overturns_each_size_from_the_peak_printed(radius, printed):
    peak = float(printed)
    assert energy_of_sine(peak - 2e-5, radius) < 1.0 <= energy_of_sine(peak + 2e-5, radius)


@pytest.mark.parametrize(("share", "radius", "printed"), ENERGIES)
def test_that_the_energy_as_the_sine_ends_is_the_one_printed(share, radius, printed):
    assert energy_of_sine(2.0, radius, share) == pytest.approx(float(printed), abs=6e-6)


def test_that_rectangles_overturn_by_energy_and_exceed_the_linear_formula_by_a_ten_thousandth():
    """After the pulse the block has the energy that the pulse gave it: at its end theta is the one whose work
    u'' R [sin alpha - sin(alpha - theta)] is what lacks to the top, and the time to it is a quadrature."""
    alpha, p2 = 0.02, 1.0
    for length, printed in zip((0.5, 1.0, 2.0), expected("published_rectangles"), strict=True):

        def time_to_spare(height, length=length):
            push = height * alpha
            work = (1.0 - math.cos(alpha)) / push
            theta = alpha - math.asin(math.sin(alpha) - work)

            def pace(root):  # theta = root^2 takes the singularity of the start away
                half = 0.5 * root * root
                gained = 2.0 * math.sin(half) * (push * math.cos(alpha - half) - math.sin(alpha - half))
                return 2.0 * root / math.sqrt(2.0 * p2 * gained)

            return quad(pace, 0.0, math.sqrt(theta), epsabs=0.0, epsrel=1e-10)[0] - length

        exact, linear = brentq(time_to_spare, 1.01, 4.0, xtol=1e-12), 1.0 / (1.0 - math.exp(-length))
        assert exact == pytest.approx(printed, rel=5e-6)
        assert 1.0e-4 < exact / linear - 1.0 < 2.0e-4


def test_that_the_push_is_an_equation_of_energy_and_the_peaks_are_those_of_its_shares():
    alpha, p2 = 0.35, 0.75
    ratio = 1.0 - 1.5 * math.sin(alpha) ** 2

    def left(push):
        return energy_at_end(alpha, p2, ratio, lambda t: -push, 1.0)

    def peak(push):
        """First rotation at which the block stands still after the push [rad]."""
        return alpha - math.acos(left(push) * (1.0 - math.cos(alpha)) + math.cos(alpha))

    push = brentq(lambda one: left(one) - 1.0, 0.5, 0.64, xtol=1e-12)
    assert push == pytest.approx(0.63096, abs=5e-6) and push == pytest.approx(PUSH, rel=3e-4)
    assert [peak(share * push) for share in (0.80, 0.99)] == pytest.approx([0.08316, 0.28584], abs=6e-6)


def test_that_a_half_sine_overturns_by_the_integral_of_its_decay():
    """p Integral exp(-p t) u''/(g alpha) dt = 1 from uplift on: no impact, linear block."""

    def excess(amplitude, ratio):
        uplift, end = math.asin(1.0 / amplitude) / ratio, math.pi / ratio

        def primitive(t):
            return math.exp(-t) * (-math.sin(ratio * t) - ratio * math.cos(ratio * t)) / (1.0 + ratio**2)

        return amplitude * math.exp(uplift) * (primitive(end) - primitive(uplift)) - 1.0

    printed = expected("published_housner_pulses", 1)
    for ratio, amplitude in zip((2.0, 4.0, 8.0), printed, strict=True):
        assert brentq(excess, 1.0001, 10.0, args=(ratio,)) == pytest.approx(amplitude, rel=1e-5)
    assert math.hypot(1.0, 2.0) / printed[0] == pytest.approx(1.24, abs=0.005)


def test_that_the_exact_equation_moves_the_edges_of_the_full_sine():
    assert edges_of_sine(0.25) == pytest.approx([3.04, 6.75, 7.50], abs=0.011)
