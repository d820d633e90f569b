"""Histories of a wall held at its top, against the worked values of the block near rest, an integration from
coordinates alone, and what must not change."""

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.capacity.accuracy import HELD_TRIED, NOISE, NOISES, PROMISED, TIMES_NOISE
from core.codes.vertical_bending import model_of_bending
from core.rocking.grounds import Grounds
from core.rocking.history import integrate_history, scan_records
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, STABLE
from core.rocking.side_functions import POTENTIAL, THETA, V, X, side_of, sides_of
from core.units import G
from core.wall.bending import Motion, Strip, near_rest
from core.wall.rocking_model import weakened

UNIT_WEIGHT = 18e3


def strips(height, thickness, load=0.0, depth=0.0, setback=0.0):
    """The wall outward and inward. load : N [N/m] on the top at this depth from the outer face [m]"""
    weight = UNIT_WEIGHT * height * thickness
    return [Strip(height, thickness, setback, weight, ((load, d),) if load else ()) for d in (depth, thickness - depth)]


def random_wall(rng):
    """A wall that stands to both sides, and its model; about any hinge."""
    while True:
        height = rng.uniform(2.4, 6.0)
        thickness = height / rng.uniform(6.0, 16.0)
        load, depth = rng.choice([0.0, 8e3, 40e3]), thickness * rng.uniform(0.35, 0.65)
        pair = strips(height, thickness, load, depth, thickness * rng.choice([0.0, 0.05]))
        try:
            return pair, model_of_bending(*pair, rng.uniform(0.4 * height, height - thickness))
        except ValueError:
            continue


WORKED = (
    ((3.0, 0.30), 1.5, 0.40000, 0.74138, 8.49617, (2.01980, 0.19802), (2.01980, 0.19802)),
    ((3.0, 0.30, 10e3, 0.15), 2.088, 0.66779, 0.82442, 6.38315, (6.25005, 0.04279), (6.25005, 0.04279)),
    ((3.0, 0.30, 10e3, 0.22), 2.2744, 0.56276, 0.83176, 5.87305, (7.36184, -0.17342), (7.65996, 0.03497)),
    ((4.5, 0.45, 30e3, 0.225), 3.05, 0.79338, 0.82063, 4.36237, (7.29453, 0.06392), (7.29453, 0.06392)),
)


@pytest.mark.parametrize(("wall", "h1", "alpha0", "kept", "p2", "outward", "inward"), WORKED)
def test_that_the_block_near_rest_is_the_worked_one(wall, h1, alpha0, kept, p2, outward, inward):
    model = model_of_bending(*strips(*wall), h1)
    assert model.ratio_at_rest == pytest.approx(kept, abs=6e-6)
    assert model.p2 == pytest.approx(p2, abs=6e-6)
    sides = (model.restoring, model.mirrored)
    for side, expected in zip(sides, (outward, inward), strict=True):
        assert (side.sine, side.cosine) == pytest.approx(expected, abs=6e-6)
    assert sides[0].sine * math.tan(model.slenderness) + sides[0].cosine == pytest.approx(alpha0, abs=6e-6)
    assert model.threshold <= alpha0 * G + 1e-4


class Coordinates:
    """Both blocks of rectangles placed by their corners alone, any number at once; velocities and work by an imaginary
    step."""

    def __init__(self, height, thickness, load, depth, h1):
        self.height, self.thickness, self.h1, self.load, self.depth = height, thickness, h1, load, depth
        per = UNIT_WEIGHT / G * thickness
        self.masses = per * h1, per * (height - h1)
        sizes = h1, height - h1
        self.turning = [m * (high**2 + thickness**2) / 12.0 for m, high in zip(self.masses, sizes, strict=True)]

    def placed(self, theta):
        """Outward and upward place of both centroids, turn of both, rise of the load: shape (7, ...)."""
        t, above = self.thickness, self.height - self.h1
        c, s = np.cos(theta), np.sin(theta)
        hinge_x, hinge_z = t * c - self.h1 * s, self.h1 * c + t * s
        phi = np.arctan2(t, above) - np.arcsin(hinge_x / np.hypot(t, above))  # the outer edge of the top stays
        cp, sp = np.cos(phi), np.sin(phi)

        def upper(x, z):  # from the hinge, x outward
            return hinge_x - x * cp + z * sp, hinge_z + z * cp + x * sp

        x1, z1 = 0.5 * t * c - 0.5 * self.h1 * s, 0.5 * self.h1 * c + 0.5 * t * s
        x2, z2 = upper(0.5 * t, 0.5 * above)
        return np.array([-x1, z1, -x2, z2, theta + 0.0 * phi, -phi, upper(t - self.depth, above)[1]])

    def rate(self, theta):
        return self.placed(theta + 1e-30j).imag / 1e-30

    def inertia(self, theta):
        v = self.rate(theta)
        (m1, m2), (j1, j2) = self.masses, self.turning
        return m1 * (v[0] ** 2 + v[1] ** 2) + m2 * (v[2] ** 2 + v[3] ** 2) + j1 * v[4] ** 2 + j2 * v[5] ** 2

    def parts(self, theta):
        """I, I', V', X' g."""
        v, step = self.rate(theta), 1e-5
        slope = (self.inertia(theta + step) - self.inertia(theta - step)) / (2.0 * step)
        held = G * (self.masses[0] * v[1] + self.masses[1] * v[3]) + self.load * v[6]
        return self.inertia(theta), slope, held, G * (self.masses[0] * v[0] + self.masses[1] * v[2])

    def pushed(self, theta, speed, beta):
        """theta'' under u''/g = beta from this side."""
        inertia, slope, held, moved = self.parts(theta)
        return (beta * moved - held - 0.5 * slope * speed * speed) / inertia

    def impact(self, other):
        """Velocity of the mechanism that opens over that which closes."""
        one, two = self.rate(0.0), other.rate(0.0)
        (m1, m2), (j1, j2) = self.masses, self.turning
        weights = np.array([m1, m1, m2, m2, j1, j2])
        mirror = np.array([-1, 1, -1, 1, -1, -1]).reshape(6, *[1] * (one.ndim - 1))
        one, two = -one[:6], two[:6] * mirror  # the mirrored wall, in the axes of this one
        return (weights * one * two).sum(0) / (weights * two * two).sum(0)


def by_coordinates(sides, ground_of, start, end, kept):
    """Peaks of each hop, from the uplift outward at `start` on."""
    found, side, state = [], 0, [1e-13, 0.0]
    while start < end and len(found) < 12:
        wall, sign = sides[side], 1.0 - 2.0 * side

        def rhs(time, state, wall=wall, sign=sign):
            inertia, slope, held, pushed = wall.parts(state[0])
            push = sign * ground_of(time) / G * pushed
            return [state[1], (push - held - 0.5 * slope * state[1] ** 2) / inertia]

        def lands(time, state):
            return state[0]

        lands.terminal, lands.direction = True, -1
        turns = lambda time, state: state[1]  # noqa: E731 : its attribute is set below
        turns.direction = -1
        made = solve_ivp(rhs, (start, end), state, events=(lands, turns), rtol=1e-9, atol=1e-12, max_step=0.02)
        found += [sign * peak[0] for peak in made.y_events[1]]
        if made.status != 1:
            break
        start, state, side = made.t[-1], [0.0, -made.y[1, -1] * kept], 1 - side
    return found


@pytest.mark.shows("held.histories")
@pytest.mark.parametrize(
    ("wall", "h1", "amplitude", "period"),
    [
        ((3.0, 0.30, 0.0, 0.0), 1.5, 1.3, 0.5),
        ((3.0, 0.30, 10e3, 0.22), 2.2744, 2.0, 0.4),
        pytest.param((3.0, 0.30, 0.0, 0.0), 1.5, 2.5, 0.3, marks=pytest.mark.long),
    ],
)
def test_that_a_history_is_that_of_coordinates(wall, h1, amplitude, period):
    outward, inward = strips(*wall)
    model = model_of_bending(outward, inward, h1)
    pair = [
        Coordinates(*wall[:2], strip.loads[0][0] if strip.loads else 0.0, depth, h1)
        for strip, depth in ((outward, wall[3]), (inward, wall[1] - wall[3]))
    ]
    kept = pair[0].impact(pair[1])
    assert kept == pytest.approx(model.ratio_at_rest, abs=1e-9)
    own = model.restoring.sine * math.tan(model.slenderness) + model.restoring.cosine
    strength, omega = amplitude * own * G, 2.0 * math.pi / period
    uplift = math.asin(1.0 / amplitude) / omega

    def ground_of(time):
        return strength * math.sin(omega * time) if time < 3.0 * period else 0.0

    expected = by_coordinates(pair, ground_of, uplift, 3.0 * period + 0.4, kept)
    step = period / 2000.0
    times = np.arange(round((3.0 * period + 3.0) / step)) * step
    ground = np.where(times < 3.0 * period - 0.5 * step, strength * np.sin(omega * times), 0.0)
    turned = integrate_history(ground, step, 1.0, model).rotation
    tops = (
        np.nonzero((np.abs(turned[1:-1]) > np.abs(turned[:-2])) & (np.abs(turned[1:-1]) >= np.abs(turned[2:])))[0] + 1
    )
    assert len(expected) >= 4
    assert turned[tops[: len(expected)]] == pytest.approx(expected, rel=2e-4, abs=2e-7)


def runge_kutta(pair, side, theta, speed, start, step, ground_of):
    """A step of each wall on its side, shape (n,), by the fourth order. step : of each [s]"""

    def push(x, v, time):
        sign = 1.0 - 2.0 * side
        both = [wall.pushed(x, v, sign * ground_of(time) / G) for wall in pair]
        return np.where(side == 0, *both)

    a1 = push(theta, speed, start)
    x2, v2 = theta + 0.5 * step * speed, speed + 0.5 * step * a1
    a2 = push(x2, v2, start + 0.5 * step)
    x3, v3 = theta + 0.5 * step * v2, speed + 0.5 * step * a2
    a3 = push(x3, v3, start + 0.5 * step)
    x4, v4 = theta + step * v3, speed + step * a3
    a4 = push(x4, v4, start + step)
    found = theta + step / 6.0 * (speed + 2.0 * (v2 + v3) + v4)
    return found, speed + step / 6.0 * (a1 + 2.0 * (a2 + a3) + a4)


@pytest.mark.shows("held.histories")
@pytest.mark.parametrize(("count", "steps"), [(8, 1500), pytest.param(1000, 3000, marks=pytest.mark.long)])
def test_that_random_walls_do_as_their_coordinates_do(count, steps):
    """Let go at a rotation, under a sine; until the second impact or for a second and a half."""
    rng = np.random.default_rng(12)
    height = rng.uniform(2.4, 6.0, count)
    thickness = height / rng.uniform(6.0, 16.0, count)
    load, depth = rng.choice([0.0, 8e3, 40e3], count), thickness * rng.uniform(0.35, 0.65, count)
    h1 = rng.uniform(0.4 * height, height - thickness)
    pair = [Coordinates(height, thickness, load, d, h1) for d in (depth, thickness - depth)]
    models = [
        model_of_bending(*strips(*row[:4]), row[4]) for row in zip(height, thickness, load, depth, h1, strict=True)
    ]
    kept = [pair[0].impact(pair[1]), pair[1].impact(pair[0])]
    period, strength = rng.uniform(0.3, 1.0, count), 0.5 * G * thickness / height
    theta = rng.uniform(0.1, 0.5, count) * np.array([model.collapse_rotation for model in models])
    begin, speed, side = theta.copy(), np.zeros(count), np.zeros(count, int)
    step = 1.5 / steps
    time, hits = np.zeros(count), np.zeros(count, int)
    on = np.full(count, True)
    reached = [begin.copy()]
    for _ in range(steps):

        def ground_of(at):
            return strength * np.sin(2.0 * math.pi * at / period)

        x, v = runge_kutta(pair, side, theta, speed, time, step, ground_of)
        lands = on & (x < 0.0)
        part = np.where(lands, np.clip(theta / np.where(theta - x > 0.0, theta - x, 1.0), 0.0, 1.0), 1.0)
        for _ in range(4 if lands.any() else 0):  # Newton on the step itself
            y, u = runge_kutta(pair, side, theta, speed, time, part * step, ground_of)
            part = np.where(lands, np.clip(part - y / np.where(lands, u * step, 1.0), 0.0, 1.0), 1.0)
        if lands.any():
            y, u = runge_kutta(pair, side, theta, speed, time, part * step, ground_of)
            after = np.where(side == 0, *kept) * -u
            other = 1 - side
            rest_x, rest_v = runge_kutta(
                pair, other, np.zeros(count), after, time + part * step, (1.0 - part) * step, ground_of
            )
            x, v, side = np.where(lands, rest_x, x), np.where(lands, rest_v, v), np.where(lands, other, side)
            hits += lands
        theta, speed = np.where(on, x, theta), np.where(on, v, speed)
        time = time + step
        reached.append(np.where(side == 0, theta, -theta))
        on &= (hits < 2) & (np.abs(theta) < 1.5 * begin + 0.3 * thickness / height)
    reached = np.array(reached)
    fine = 20
    instants = np.arange(steps * fine + 1) * (step / fine)
    checked = 0
    for k, model in enumerate(models):
        ground = strength[k] * np.sin(2.0 * math.pi * instants / period[k])
        found = integrate_history(ground, step / fine, 1.0, model, start=(begin[k], 0.0)).rotation[::fine]
        last = int(np.argmax(~np.isfinite(reached[:, k]))) or steps
        moved = np.nonzero(np.diff(reached[:, k]) == 0.0)[0]
        last = min(last, int(moved[0]) if moved.size else steps, found.size - 1)
        assert found[:last] == pytest.approx(reached[:last, k], abs=2e-6 * model.collapse_rotation), k
        checked += last > 100
    assert checked > 0.9 * count


def by_another_solver(model, ground, dt, theta):
    """theta at the samples, let go outward at `theta`, by DOP853 on the functions of the wall themselves, until it has
    overturned or an impact leaves it all but still: theta' = w / r and w' = F / (I_0 r), where r = sqrt(I / I_0) and F
    is the work of all forces by theta."""
    sides = [model.bending.side(sign) for sign in (1.0, -1.0)]
    first = float(sides[0].parts(np.zeros(1))[0][0])
    found, side, state = [theta], 0, np.array([theta, 0.0])
    for low, high in itertools.pairwise(ground):
        t = 0.0
        while t < dt:

            def rhs(time, state, side=side, low=low, slope=(high - low) / dt):
                inertia, risen, moved = (float(part[0]) for part in sides[side].parts(state[:1]))
                r = math.sqrt(inertia / first)
                push = (1.0 - 2.0 * side) * (low + slope * time) / G
                return [state[1] / r, (push * moved - risen) / (first * r)]

            def lands(time, state):
                return state[0]

            lands.terminal, lands.direction = True, -1
            fine = {"rtol": 1e-13, "atol": 1e-16, "max_step": 0.25 * dt}
            made = solve_ivp(rhs, (t, dt), state, "DOP853", events=lands, **fine)
            t, state = made.t[-1], made.y[:, -1]
            if made.status == 1:
                side, state = 1 - side, np.array([0.0, -model.ratio_at_rest * state[1]])
                if state[1] < 1e-2 * math.sqrt(model.p2) * model.collapse_rotation:
                    return np.array(found)
        found.append((1.0 - 2.0 * side) * state[0])
        if state[0] > 1.2 * model.collapse_rotation:
            break
    return np.array(found)


@pytest.mark.shows("held.histories", "search.accuracy")
@pytest.mark.parametrize("count", [4, pytest.param(HELD_TRIED, marks=pytest.mark.long)])
def test_that_a_history_is_within_the_bound_that_its_accuracy_states(count):
    rng, dt, checked = np.random.default_rng(8), 0.01, 0
    for _ in range(count):
        _, model = random_wall(rng)
        strength = rng.uniform(0.3, 1.5) * G * math.tan(model.slenderness)
        ground = strength * np.convolve(rng.standard_normal(220), np.hanning(21) / 3.0, "valid")
        begin = rng.uniform(0.05, 0.4) * model.collapse_rotation
        expected = by_another_solver(model, ground, dt, begin)

        def turned(samples, model=model, start=(begin, 0.0), n=expected.size):
            return integrate_history(samples, dt, 1.0, model, start=start).rotation[:n]

        once = turned(ground)
        assert once.size == expected.size
        moved = [turned(ground * (1.0 + NOISE * rng.uniform(-1.0, 1.0, ground.size))) for _ in range(NOISES)]
        noise = max(float(np.abs(one - once).max()) for one in moved if one.size == once.size)
        error = float(np.abs(once - expected).max())
        assert error <= max(PROMISED * model.collapse_rotation, TIMES_NOISE * noise)
        checked += expected.size > 60
    assert checked >= 0.5 * count


def test_that_pieces_are_the_functions_of_the_wall():
    rng = np.random.default_rng(3)
    for _ in range(20):
        pair, model = random_wall(rng)
        for strip, lean in zip(pair, (model.restoring.lean, model.mirrored.lean), strict=True):
            motion = Motion(strip, model.bending.h1)
            inertia = float(motion.parts(np.zeros(1))[0][0])
            side = side_of(motion, inertia, model.p2, model.slenderness + lean)
            y = rng.uniform(0.0, side.end, 200)
            piece = (y * side.scale).astype(int)
            s = 2.0 * (y * side.scale - piece) - 1.0
            v, x, stored, theta = (
                np.array([side.values[piece, n, k] * s**k for k in range(8)]).sum(0) for n in (V, X, POTENTIAL, THETA)
            )
            inertias, held, pushed = motion.parts(theta)
            slope = np.sqrt(inertias * inertia) * model.p2
            assert v == pytest.approx(held / slope, abs=1e-11 * np.abs(v).max())
            assert x == pytest.approx(pushed / slope, abs=1e-11 * np.abs(x).max())
            ends = np.sort(rng.uniform(0.0, side.top, 2))
            nodes = np.linspace(*ends, 2001)
            at = np.minimum((nodes * side.scale).astype(int), 31)
            along = np.polynomial.polynomial.polyval
            q = 2.0 * (nodes * side.scale - at) - 1.0
            held_along = np.array([along(q[k], side.values[at[k], V]) for k in range(q.size)])
            gained = [float(along(q[k], side.values[at[k], POTENTIAL])) for k in (0, -1)]
            assert np.trapezoid(held_along, nodes) == pytest.approx(gained[1] - gained[0], rel=1e-5)
            assert theta.max() <= motion.last and stored.max() > 0.0


def test_that_a_mirrored_wall_does_the_mirrored_thing():
    rng = np.random.default_rng(4)
    for _ in range(10):
        (outward, inward), model = random_wall(rng)
        mirrored = model_of_bending(inward, outward, model.bending.h1)
        ground = model.threshold * rng.standard_normal(600) * np.hanning(600)
        for scale in (0.8, 1.5, 3.0):
            one, other = (
                integrate_history(ground, 0.01, scale, model),
                integrate_history(ground, 0.01, -scale, mirrored),
            )
            assert one.outcome == other.outcome
            assert one.peak == pytest.approx(other.peak, rel=1e-6)


def test_that_energy_is_kept_between_impacts_and_lost_by_e_squared():
    rng = np.random.default_rng(5)
    for _ in range(10):
        _, model = random_wall(rng)
        alpha = model.slenderness
        collapse = alpha + model.restoring.lean, alpha + model.mirrored.lean
        sides = sides_of(model.bending, alpha, collapse)
        start = 0.5 * min(collapse)
        found = integrate_history(np.zeros(4000), 0.002, 1.0, model, start=(start, 0.0))
        tops = [abs(found.rotation[:1]).max()]
        for first, last in itertools.pairwise(found.impact_time):
            span = found.rotation[round(first / 0.002) : round(last / 0.002) + 1]
            if span.size > 40:
                tops.append(np.abs(span).max())
        energies = []
        for n, top in enumerate(tops[:3]):
            motion = Motion((model.bending.outward, model.bending.inward)[n % 2], model.bending.h1)
            angles = np.linspace(0.0, top, 2001)
            energies.append(np.trapezoid(motion.parts(angles)[1], angles))
        assert found.outcome == STABLE and len(energies) == 3 and sides[0].barrier > 0.0
        for one, other in itertools.pairwise(energies):
            assert other / one == pytest.approx(model.ratio_at_rest**2, rel=2e-3)


@pytest.mark.shows("mechanics.lanes")
@pytest.mark.parametrize("count", [6, pytest.param(200, marks=pytest.mark.long)])
def test_that_a_scan_is_its_histories_and_a_still_wall_rests(count):
    """More analyses than there are lanes, of records of several lengths, both signs, some beyond all bounds, some at
    the threshold; steps of 0.04 and 0.4 s among them, which a series does not hold for."""
    rng = np.random.default_rng(6)
    for _ in range(count):
        _, model = random_wall(rng)
        lengths, dt = rng.integers(2, 700, 5), float(rng.choice([0.0025, 0.01, 0.04, 0.4]))
        records = [model.threshold * rng.standard_normal(n) * np.hanning(n + 2)[1:-1] for n in lengths]
        level = model.threshold * rng.choice([1.0, 1.0 - 1e-9, -1.0, 1.2])
        records += [np.full(40, level), np.append(np.zeros(30), 2.0 * level)]  # still lifting at its end
        grounds = Grounds.of(records, dt)
        which = rng.integers(0, len(records), 90)
        scales = rng.choice([-1.0, 1.0], 90) * rng.uniform(0.0, 6.0, 90) ** 2
        which[0], scales[0] = 0, 0.99 / (grounds.strongest[0] / model.threshold)
        scales[1], which[2], scales[2] = 0.0, 5, 1.0
        outcomes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
        scan_records(METHODS["taylor"], grounds, which, scales, model, outcomes, peaks)
        assert (outcomes[0], peaks[0]) == (outcomes[1], peaks[1]) == (STABLE, 0.0) and COLLAPSED in outcomes
        for k, scale, outcome, peak in zip(which, scales, outcomes, peaks, strict=True):
            one = integrate_history(records[k], dt, scale, model)
            assert (one.outcome, one.peak) == (outcome, peak)
            if outcome == STABLE:
                assert one.peak <= model.collapse_rotation * 2.5


def test_that_strength_over_a_factor_is_the_weights_over_it():
    """V'/F under the ground times one, as a wall F times as light on the ground times F."""
    pair, model = random_wall(np.random.default_rng(7))
    ground = 1.5 * model.threshold * np.sin(np.arange(400) * 0.1)
    one = integrate_history(ground, 0.01, 1.2, weakened(model, 1.2))
    slower = integrate_history(ground, 0.01 / math.sqrt(1.2), 1.2, model)  # time measured by 1/p
    assert one.rotation == pytest.approx(slower.rotation, abs=1e-9)
    assert near_rest(Motion(pair[0], model.bending.h1), model.slenderness)[0] == model.p2


def test_that_a_wall_pushed_to_its_collapse_falls_and_below_it_does_not():
    for start, outcome in ((0.999, STABLE), (1.001, COLLAPSED)):
        _, model = random_wall(np.random.default_rng(8))
        found = integrate_history(
            np.zeros(2000), 0.01, 1.0, model, start=(start * (model.slenderness + model.restoring.lean), 0.0)
        )
        assert found.outcome == outcome
