"""Walls held by tie bars, against the worked values of the mechanics and against an integrator of the tests' own."""

import math

import numpy as np
import pytest

from core.case.loads import Load
from core.case.wall import Wall
from core.rocking.events import REST_FRACTION
from core.rocking.history import integrate_history
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.bars import TieBar
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model
from tests.validation import tied_walls

AT_YIELD = 9.171e-3
"""Elongation at yield of 8 m of 235 MPa [m]."""


def held_wall(height, thickness, loads, bars, ratio=0.5, one_sided=True):
    """RockingModel of a wall of 18 kN/m3. bars : TieBars"""
    wall = Wall(
        name="w", mechanism="one_sided", height_m=height, thickness_m=thickness, unit_weight_kn_m3=18.0, load=loads
    )
    block = wall.block()
    moment = 18e3 * height * thickness * block.radius
    return rocking_model(
        block,
        one_sided,
        restitution(block, "user", ratio),
        LAWS["rigid"],
        wall.in_si.restoring,
        tuple(bar.scaled(moment) for bar in bars),
    )


def sines(amplitude, period, dt):
    """Three periods of a sine of the ground [m/s2] at dt [s], then none."""
    t = np.arange(round(3.0 * period / dt) + 1) * dt
    return amplitude * G * np.sin(2.0 * np.pi * t / period)


def drawn(rng):
    """(ground [m/s2], dt [s], wall, loads, TieBars, one-sided, ratio) of a random wall with one to three bars."""
    height = rng.uniform(2.0, 12.0)
    thickness = height / rng.uniform(5.0, 15.0)
    loads = ()
    if rng.uniform() < 0.4:
        loads = (Load("vertical", rng.uniform(1.0, 30.0), height * rng.uniform(0.3, 1.0), 0.6 * thickness, "none"),)
    one_sided = bool(rng.uniform() < 0.7)
    bars = []
    weight = 18e3 * height * thickness
    for _ in range(rng.integers(1, 4)):
        h = height * rng.uniform(0.3, 1.0)
        strength = weight * 0.5 * thickness / h * 10.0 ** rng.uniform(-1.3, 0.5)
        at_yield = h * 10.0 ** rng.uniform(-4.0, -2.3)
        kind = rng.uniform()
        slack = rng.uniform(0.0, 2.0) * at_yield if kind < 0.3 else 0.0
        if kind > 0.7 and one_sided:
            slack = -rng.uniform(0.0, 1.0) * at_yield
        bars.append(TieBar(h, strength, at_yield, slack, at_yield * 10.0 ** rng.uniform(0.0, 2.0)))
    dt = rng.choice([0.005, 0.01])
    size = int(3.0 / dt)
    t = np.arange(size) * dt
    shape = rng.normal(size=size) * np.hanning(size)
    shape = np.convolve(shape, np.hanning(int(0.15 / dt)), "same") + np.sin(2.0 * np.pi * t / rng.uniform(0.3, 1.5))
    ground = shape / np.abs(shape).max() * G * thickness / height * 10.0 ** rng.uniform(0.1, 0.9)
    ground[-1] = 0.0  # still from there on for both
    return ground, dt, (height, thickness, 18e3), loads, bars, one_sided, rng.uniform(0.3, 0.9)


def of_both(case, small=100, after=8.0):
    """(History, what the integrator of the tests finds) of a random wall; small : steps a sample; after : [s] of still
    ground."""
    ground, dt, wall, loads, bars, one_sided, ratio = case
    model = held_wall(wall[0], wall[1], loads, bars, ratio, one_sided)
    rest = REST_FRACTION * math.sqrt(model.p2) * model.slenderness
    forces = np.array([[1e3 * load.kn_m, load.d_m, load.h_m] for load in loads]).reshape(-1, 3)
    held = [[b.height, b.strength / b.elongation_at_yield, b.strength, b.breaks_at, b.slack] for b in bars]
    arguments = (ground, dt, wall, forces, np.array(held), one_sided, ratio, rest)
    return model, integrate_history(ground, dt, 1.0, model), tied_walls.run(*arguments, small, after)


def differ(model, found, small_steps) -> str:
    """How program and integrator differ on a random wall, "" where they do not. As `of_both` gives them."""
    _, both, _, _, _, fallen = small_steps
    # one that leans on its bar beyond theta_c when the integrator ends has collapsed, and has not fallen
    if fallen != (found.outcome == COLLAPSED) and not both > model.collapse_rotation:
        return f"outcome {found.outcome}, {fallen}"
    if found.outcome == STABLE and abs(found.peak - both) > 1e-6 * model.slenderness:
        return f"peak {found.peak}, {both}"
    return ""


@pytest.mark.shows("ties.histories")
@pytest.mark.parametrize(
    "seed, count",
    [(5, 20), pytest.param(5, 150, marks=pytest.mark.long), pytest.param(6, 2000, marks=pytest.mark.long)],
)
def test_random_walls_against_an_integrator_of_small_steps(seed, count):
    rng = np.random.default_rng(seed)
    results = [of_both(drawn(rng)) for _ in range(count)]
    differences = {k: words for k, one in enumerate(results) if (words := differ(*one))}
    assert not differences
    # bars were taut, yielded and broke, walls fell
    assert sum(found.outcome == COLLAPSED for _, found, _ in results) > 0.02 * count
    assert sum(bool(np.isinf(found.residual[:, -1]).any()) for _, found, _ in results) > 0.1 * count
    assert sum(bool(work > 0.0) for _, _, (*_, work, _) in results) > 0.3 * count


@pytest.mark.shows("ties.work")
def test_the_work_of_a_bar_is_its_yield_force_times_its_plastic_elongation():
    bars = [TieBar(2.8, 3e3, 2e-3, 0.0, 9.0), TieBar(2.0, 1e3, 4e-3, 1e-3, 9.0)]
    model, bare = held_wall(3.0, 0.45, (), bars), held_wall(3.0, 0.45, (), [])
    alpha, moment = model.slenderness, 18e3 * 3.0 * 0.45 * math.hypot(1.5, 0.225)
    speed = 0.3
    found = integrate_history(np.zeros(400), 1e-3, 0.0, model, start=(0.0, speed))
    free = integrate_history(np.zeros(400), 1e-3, 0.0, bare, start=(0.0, speed))
    assert found.peak < 0.9 * free.peak

    def lifted(theta):
        return moment * (math.cos(alpha - theta) - math.cos(alpha))

    kinetic = 0.5 * speed**2 * moment / model.p2
    # at the peak bars are at yield: what is not lifted nor stored is plastic
    stored = sum(0.5 * bar.strength * bar.elongation_at_yield for bar in bars)
    last = found.residual[:, -1]
    plastic = sum(bar.strength * (bar.height * last[k] - max(bar.slack, 0.0)) for k, bar in enumerate(bars))
    assert last.min() > 0.0
    assert kinetic - lifted(found.peak) - stored == pytest.approx(plastic, rel=1e-9)


def test_a_wall_and_its_time_scaled_together_are_the_same_wall():
    rng = np.random.default_rng(3)
    ground, dt, wall, loads, bars, one_sided, ratio = drawn(rng)
    model = held_wall(wall[0], wall[1], loads, bars, ratio, one_sided)
    slower = model._replace(p2=model.p2 / 4.0)
    one, other = integrate_history(ground, dt, 1.0, model), integrate_history(ground, 2.0 * dt, 1.0, slower)
    assert other.peak == pytest.approx(one.peak, rel=1e-11)
    assert np.allclose(other.residual, one.residual, rtol=1e-10, atol=1e-14)


def test_a_slack_bar_is_no_bar_and_a_second_motion_meets_a_slack_one():
    ground = sines(0.3, 0.6, 1e-3)
    bare = integrate_history(ground, 1e-3, 1.0, held_wall(3.0, 0.45, (), []))
    far = integrate_history(ground, 1e-3, 1.0, held_wall(3.0, 0.45, (), [TieBar(2.8, 1.5e3, AT_YIELD, 1.0, 2.0)]))
    assert np.abs(far.rotation - bare.rotation).max() < 1e-13
    ground = sines(0.25, 1.0, 1e-3)
    held = held_wall(7.0, 0.83, (), [TieBar(6.5, 4e3, AT_YIELD, 0.0, 0.60)])
    once = integrate_history(ground, 1e-3, 1.0, held)
    twice = integrate_history(np.concatenate([ground, np.zeros(4000), ground]), 1e-3, 1.0, held)
    assert twice.peak > 3.0 * once.peak


@pytest.mark.shows("ties.prestress")
def test_a_prestress_raises_the_ground_that_uplifts_the_wall_and_no_other_bar_does():
    still = held_wall(3.0, 0.45, (), [])
    for slack, held in ((0.0, 0.0), (-0.5 * AT_YIELD, 0.5)):
        model = held_wall(3.0, 0.45, (), [TieBar(2.8, 1.5e3, AT_YIELD, slack, 0.40)])
        weight = 18e3 * 3.0 * 0.45
        uplift = still.threshold + held * 1.5e3 * 2.8 / (weight / G * 1.5)
        for factor in (0.999999, 1.000001):
            found = integrate_history(np.full(50, factor * uplift), 1e-3, 1.0, model)
            assert bool(found.peak > 0.0) == (factor > 1.0)
