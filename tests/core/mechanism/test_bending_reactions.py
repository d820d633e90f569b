"""Reactions of a wall that bends and moves: worked values of Newton's equations and of an own integration."""

import math
import random

import numpy as np
import pytest

from core.codes.vertical_bending import lowest_hinge, mechanism, model_of_bending
from core.mechanism.bending_reactions import MovingStrip, impulse, kept_rate, reactions_of_history, spring_force
from core.rocking.history import integrate_history
from core.units import G
from core.wall.bending import Motion, Strip, kept_at_impact

OUTWARD = Strip(3.0, 0.8, 0.0, 18e3 * 2.4, ((20e3, 0.30),))
INWARD = OUTWARD._replace(loads=((20e3, 0.50),))
H1 = lowest_hinge(OUTWARD)
ALPHA = 2.0093143055789797
"""Largest push of the fourteen motions under which the worked wall was followed [-]."""


@pytest.fixture(scope="module")
def sides():
    return MovingStrip(OUTWARD, H1), MovingStrip(INWARD, H1)


MANY = pytest.mark.parametrize("count", [200, pytest.param(2000, marks=pytest.mark.long)])


def random_strip(draw):
    height = draw.uniform(2.5, 6.0)
    thickness = height / draw.uniform(3.5, 12.0)
    loads = ((draw.uniform(0.0, 40e3), draw.uniform(0.15, 0.85) * thickness),)
    return Strip(height, thickness, 0.0, draw.uniform(14e3, 22e3) * height * thickness, loads)


def test_that_a_wall_that_begins_to_bend_hands_the_worked_force_to_its_hold(sides):
    outward, inward = sides
    assert outward.multiplier() == pytest.approx(1.628566, rel=1e-6)
    assert outward.starts[0] == pytest.approx(27417.034, rel=1e-7)
    assert inward.multiplier() == pytest.approx(1.428038, rel=1e-6)
    assert inward.starts[0] == pytest.approx(21752.294, rel=1e-7)
    assert outward.growths[0] == pytest.approx(9456.202, rel=1e-7)
    assert outward.bound(ALPHA) == pytest.approx(31017.463, rel=1e-7)
    assert inward.bound(ALPHA) == pytest.approx(27248.957, rel=1e-7)


def test_that_the_force_falls_along_the_curve_of_capacity(sides):
    outward = sides[0]
    alpha = outward.multiplier(0.12)
    assert alpha == pytest.approx(0.934670, rel=1e-6)
    assert outward.reactions(0.12, 0.0, alpha, 0.0)[0] == pytest.approx(14199.838, rel=1e-7)


def test_that_impulses_and_the_mass_at_the_top_are_the_worked_ones(sides):
    outward, inward = sides
    assert outward.top_mass == pytest.approx(747.105, rel=1e-6)
    # the two worked impulses are of two speeds of one wall, which are not printed
    per_speed = impulse(outward, inward, 1.0)
    assert impulse(inward, outward, 436.688 / per_speed) == pytest.approx(436.688)
    assert spring_force(436.688, 3.2712e6, 747.105) == pytest.approx(28895.7, rel=2e-6)
    assert spring_force(731.482, 3.2712e6, 747.105) == pytest.approx(48402.2, rel=5e-6)
    assert kept_rate(outward, inward) == pytest.approx(kept_at_impact(OUTWARD, INWARD, H1), rel=1e-12)


@MANY
def test_that_multiplier_and_motion_are_those_of_the_kinematic_check_and_of_the_histories(count):
    """Two derivations: virtual work by rates in closed form, and points that are placed."""
    draw = random.Random(3)
    for _ in range(count):
        strip = random_strip(draw)
        h1 = lowest_hinge(strip)
        moving, motion = MovingStrip(strip, h1), Motion(strip, h1)
        assert moving.multiplier() == pytest.approx(mechanism(strip, h1).alpha0, rel=1e-12)
        assert moving.starts[0] == pytest.approx(mechanism(strip, h1).top_force, rel=1e-9)
        theta = draw.uniform(0.0, 0.3) * mechanism(strip, h1).theta0
        inertia, risen, moved = (float(part[0].real) for part in motion.parts(np.array([theta + 0j])))
        assert moving.multiplier(theta) == pytest.approx(risen / moved, rel=1e-10)
        assert moving.acceleration(theta, 0.0, 0.7) == pytest.approx((0.7 * moved - risen) / inertia, rel=1e-9)


@MANY
def test_that_the_reactions_of_a_moving_wall_are_in_equilibrium_with_its_accelerations(count):
    """Moments of both blocks about the base, from their coordinates: the hold's lever is the height of the top."""
    draw = random.Random(4)
    for _ in range(count):
        strip = random_strip(draw)
        moving = MovingStrip(strip, lowest_hinge(strip))
        theta, speed, alpha = draw.uniform(0.001, 0.05), draw.uniform(-0.5, 0.5), draw.uniform(-1.0, 2.0)
        acceleration = float(moving.acceleration(theta, speed, alpha))
        step, total = 1e-4, 0.0

        def momentum(at, rate, moving=moving):
            whole = 0.0
            for (points, way, turn), sense in zip(moving._ways(at), (1.0, -1.0), strict=True):
                spin = way.x * way.z1 - way.z * way.x1
                whole += rate * float((points.mass * spin).sum() + sense * turn * points.own.sum())
            return whole

        late = momentum(theta + speed * step + 0.5 * acceleration * step**2, speed + acceleration * step)
        early = momentum(theta - speed * step + 0.5 * acceleration * step**2, speed - acceleration * step)
        change = (late - early) / (2.0 * step)
        for upper in (False, True):
            points, way = moving.points[upper], moving.way(theta, upper)
            total += float((-way.x * points.force + way.z * points.mass * alpha * G).sum())
        hinge_z, phi = float(moving.hinge(theta)[1]), float(moving.phi(theta))
        top = hinge_z + moving.turning.above * math.cos(phi) + moving.turning.edge * math.sin(phi)
        held = float(moving.reactions(theta, speed, alpha)[0])
        # moments about the origin; the base hinge lies on it, the hold pushes inward at the top
        assert total - held * top == pytest.approx(change, rel=1e-4, abs=1e-4 * abs(held * top))


@pytest.mark.parametrize("seed", range(3))
def test_that_no_history_exceeds_the_bound_of_a_moving_hold(seed):
    """Random walls under random pulses, at the top and at the base: the largest of 200 walls is 1.000 of the bound."""
    draw = random.Random(seed)
    strip = random_strip(draw)
    mirrored = strip._replace(loads=tuple((force, strip.thickness - depth) for force, depth in strip.loads))
    model = model_of_bending(strip, mirrored)
    held = model.bending
    outward, inward = MovingStrip(held.outward, held.h1), MovingStrip(held.inward, held.h1)
    for _ in range(4):
        alpha, period = draw.uniform(1.1, 1.8) * outward.multiplier(), draw.uniform(0.15, 0.5)
        time = np.arange(0.0, 4.0 * period, 0.005)
        ground = alpha * G * np.sin(2.0 * math.pi * time / period) * (time < 3.0 * period)
        motion = integrate_history(ground, 0.005, 1.0, model)
        if motion.peak > 0.8 * strip.thickness / strip.height:
            continue
        largest = float(np.abs(ground).max()) / G
        for at_base in (False, True):
            pulled, pushed = reactions_of_history(outward, inward, motion, ground / G, 0.005, at_base)
            most = 1.001 * max(strip.bound(largest, at_base) for strip in (outward, inward))
            assert 0.0 < pulled <= most and pushed <= most
