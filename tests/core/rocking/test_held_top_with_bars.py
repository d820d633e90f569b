"""Histories of a wall held at its top with ties along it that have yielded, against an integration from coordinates
alone in which each bar is followed from event to event, and what must not change."""

import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.codes.vertical_bending import model_of_bending
from core.rocking.grounds import Grounds
from core.rocking.history import integrate_history, scan_records
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.bars import TieBar
from tests.core.rocking.test_held_top import Coordinates, random_wall, strips

DUCTILE = TieBar(1.4, 1500.0, 0.009, 0.0, 0.4)


class TiedCoordinates(Coordinates):
    """The wall of `Coordinates` with one bar. place : of the bar from the outer face of the base, x outward, z up"""

    bar: TieBar

    def elongation(self, theta):
        """Way outward of the point of the bar."""
        height, t = self.bar.height, self.thickness
        c, s = np.cos(theta), np.sin(theta)
        if height <= self.h1:
            return height * s  # the base turns about the outer face
        above = self.height - self.h1
        hinge_x = t * c - self.h1 * s
        phi = np.arctan2(t, above) - np.arcsin(hinge_x / np.hypot(t, above))
        return -(hinge_x - t * np.cos(phi) + (height - self.h1) * np.sin(phi))

    def held(self, theta, force):
        """Work of the bar by a unit of theta."""
        return force * (self.elongation(theta + 1e-30j).imag / 1e-30)


def follow(sides, ground_of, start, end, kept):
    """Peaks of each hop, from the uplift outward at `start` on, and what the bar has left: its residual elongation."""
    (tied, other), bar = sides, sides[0].bar
    found, outward, state, residual = [], True, [1e-13, 0.0], bar.slack
    phase = "slack" if residual > 0.0 else "taut"
    for _ in range(400):
        wall, sign = (tied, 1.0) if outward else (other, -1.0)
        doing = phase if outward else "gone"
        stiffness = bar.strength / bar.elongation_at_yield

        def force(theta, doing=doing, residual=residual, stiffness=stiffness):
            if doing == "taut":
                return stiffness * (tied.elongation(theta) - residual)
            return bar.strength if doing == "yields" else 0.0

        def rhs(time, state, wall=wall, sign=sign, force=force, outward=outward):
            inertia, slope, held, moved = wall.parts(state[0])
            held += tied.held(state[0], force(state[0])) if outward else 0.0
            return [state[1], (sign * ground_of(time) / G * moved - held - 0.5 * slope * state[1] ** 2) / inertia]

        reached = {
            "lands": (lambda time, state: state[0], -1),
            "turns": (lambda time, state: state[1], -1),
            "slack": (lambda time, state, r=residual: tied.elongation(state[0]) - r, -1),
            "taut": (lambda time, state, r=residual: tied.elongation(state[0]) - r, 1),
            "yields": (lambda time, state, r=residual: tied.elongation(state[0]) - r - bar.elongation_at_yield, 1),
            "breaks": (lambda time, state: tied.elongation(state[0]) - bar.breaks_at, 1),
        }
        of_phase = {"gone": (), "slack": ("taut",), "taut": ("slack", "yields", "breaks"), "yields": ("breaks",)}
        names = ("lands", "turns", *of_phase[doing])
        events = []
        for name in names:
            event, direction = reached[name]
            event = partial(event)
            event.terminal, event.direction = name != "turns" or doing == "yields", direction
            events.append(event)
        made = solve_ivp(rhs, (start, end), state, events=events, rtol=1e-10, atol=1e-13, max_step=0.02)
        found += [sign * top[0] for top in made.y_events[1] if not found or sign * top[0] != found[-1]]
        if made.status != 1:
            break
        start, (theta, speed) = made.t[-1], made.y[:, -1]
        ended = {name for name, times in zip(names, made.t_events, strict=True) if times.size and times[-1] == start}
        state = [theta, speed]
        if "lands" in ended:
            state, outward = [0.0, -speed * kept], not outward
        elif "breaks" in ended:
            phase = "gone"
        elif "turns" in ended:  # it has yielded
            phase, residual = "taut", tied.elongation(theta) - bar.elongation_at_yield
        else:
            phase = next(name for name in ("slack", "taut", "yields") if name in ended)
        if "lands" in ended and phase != "gone":
            phase = "slack" if residual > 0.0 else "taut"
    return found, residual if phase != "gone" else math.inf


@pytest.mark.shows("held.bars")
@pytest.mark.parametrize(
    ("wall", "h1", "bar", "amplitude", "period"),
    [
        ((3.0, 0.30, 0.0, 0.0), 1.5, DUCTILE, 1.6, 0.5),
        ((3.0, 0.30, 0.0, 0.0), 1.5, replace(DUCTILE, height=2.1, stands=0.03), 2.0, 0.4),
        ((3.0, 0.30, 10e3, 0.22), 2.2744, replace(DUCTILE, height=1.9, slack=0.004), 2.0, 0.4),
    ],
)
def test_that_a_history_is_that_of_coordinates(wall, h1, bar, amplitude, period):
    outward, inward = strips(*wall)
    model = model_of_bending(outward._replace(bars=(bar,)), inward, h1)
    pair = [
        TiedCoordinates(*wall[:2], strip.loads[0][0] if strip.loads else 0.0, depth, h1)
        for strip, depth in ((outward, wall[3]), (inward, wall[1] - wall[3]))
    ]
    pair[0].bar = bar
    own = model.restoring.sine * math.tan(model.slenderness) + model.restoring.cosine
    strength, omega = amplitude * own * G, 2.0 * math.pi / period
    uplift, last = math.asin(1.0 / amplitude) / omega, 3.0 * period + 0.4

    def ground_of(time):
        return strength * math.sin(omega * time) if time < 3.0 * period else 0.0

    expected, residual = follow(pair, ground_of, uplift, last, pair[0].impact(pair[1]))
    step = period / 2000.0
    times = np.arange(round(last / step) + 1) * step
    ground = np.where(times < 3.0 * period - 0.5 * step, strength * np.sin(omega * times), 0.0)
    made = integrate_history(ground, step, 1.0, model)
    turned = made.rotation
    tops = (
        np.nonzero((np.abs(turned[1:-1]) > np.abs(turned[:-2])) & (np.abs(turned[1:-1]) >= np.abs(turned[2:])))[0] + 1
    )
    assert len(expected) >= 4
    assert turned[tops[: len(expected)]] == pytest.approx(expected, rel=3e-4, abs=3e-7)
    assert made.of_bars[0, -1] == pytest.approx(residual, rel=1e-3)


def random_case(rng):
    """A model with one or two bars, the same without, and a motion that moves it."""
    (outward, inward), bare = random_wall(rng)
    h1 = bare.bending.h1
    weight = outward.weight + sum(n for n, _ in outward.loads)
    bars = tuple(
        TieBar(
            outward.height * rng.uniform(0.2, 0.9), weight * rng.uniform(0.02, 0.6), 0.004, 0.0, rng.uniform(0.01, 0.3)
        )
        for _ in range(rng.integers(1, 3))
    )
    model = model_of_bending(outward._replace(bars=bars), inward, h1)
    ground = np.convolve(rng.normal(size=600), np.ones(8) / 8.0)
    own = bare.restoring.sine * math.tan(bare.slenderness) + bare.restoring.cosine
    return model, bare, ground * own * G / np.abs(ground).max()


def test_that_scanned_analyses_are_histories():
    rng = np.random.default_rng(3)
    for _ in range(6):
        model, _, ground = random_case(rng)
        scales = np.concatenate([rng.uniform(0.5, 6.0, 6), -rng.uniform(0.5, 6.0, 6)])
        outcomes, peaks = np.zeros(12, np.int64), np.zeros(12)
        scan_records(
            METHODS["taylor"], Grounds.of([ground], 0.01), np.zeros(12, np.int64), scales, model, outcomes, peaks
        )
        for scale, outcome, peak in zip(scales, outcomes, peaks, strict=True):
            made = integrate_history(ground, 0.01, scale, model)
            assert (made.outcome, made.peak) == (outcome, peak)


def test_that_bars_without_strength_change_nothing():
    rng = np.random.default_rng(4)
    for _ in range(6):
        model, bare, ground = random_case(rng)
        held = model.bending
        weak = tuple(replace(bar, strength=1e-9) for bar in held.outward.bars)
        model = model._replace(bending=held._replace(outward=held.outward._replace(bars=weak)))
        for scale in (1.5, -2.5, 4.0):
            one, two = (integrate_history(ground, 0.01, scale, each) for each in (model, bare))
            assert one.outcome == two.outcome
            # the first bounces off rest, of 1e-6 rad, are cut into other steps
            assert one.rotation == pytest.approx(two.rotation[: one.rotation.size], abs=1e-4 * bare.slenderness)
            if one.outcome == STABLE:
                assert one.peak == pytest.approx(two.peak, rel=1e-4)


def test_that_a_bar_never_grows_shorter():
    rng = np.random.default_rng(5)
    outcomes = []
    for _ in range(8):
        model, _, ground = random_case(rng)
        for scale in (2.0, -3.0):
            made = integrate_history(ground, 0.01, scale, model)
            outcomes.append(made.outcome)
            whole = made.of_bars[np.isfinite(made.of_bars)]
            assert made.outcome in (STABLE, COLLAPSED)
            assert np.all(whole >= 0.0)
            assert all(np.all(np.diff(row[np.isfinite(row)]) >= -1e-9) for row in made.of_bars)  # none grows shorter
    assert set(outcomes) == {STABLE, COLLAPSED}
