"""What a wall that bends between two holds hands to them, moving or about to move (resources/docs/physics.md, 19).

The lower block turns by theta about the outer edge of the base, the upper one by -phi about the hinge between. Per
metre of wall; x inward from the outer face, z up, a reaction is positive where it holds the wall outward.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.rocking.history import History
from core.units import G
from core.wall.bending import Motion, Strip, Turning, blocks_of, masses_of, outer_face

TINY, STEP = 1e-30, 1e-5
"""Imaginary step of a first derivative, which is exact, and step between two of them for a second one [rad]."""


class Points(NamedTuple):
    """Weights and masses of a block, each at a point; arrays of shape (n,).

    x, z : [m]; force : that does work as the block rises [N/m]; mass : that moves with it [kg/m]
    own : inertia about its own centre [kg m]; thrust : that pushes it outward [N/m]
    bar : number of the bar that pulls there, -1 : none
    """

    x: np.ndarray
    z: np.ndarray
    force: np.ndarray
    mass: np.ndarray
    own: np.ndarray
    thrust: np.ndarray
    bar: np.ndarray

    def pushes(self, pulls: np.ndarray | None) -> np.ndarray:
        """Force outward at each point [N/m]. pulls : of the bars [N/m], shape (..., bars), None : they are slack"""
        if pulls is None or pulls.shape[-1] == 0:
            return self.thrust
        return self.thrust - np.where(self.bar >= 0, pulls[..., self.bar.astype(int)], 0.0)


class Way(NamedTuple):
    """Points of a block at rotations of the lower one: x, z [m] and their first and second derivatives by theta, each
    of the shape of theta and n."""

    x: np.ndarray
    z: np.ndarray
    x1: np.ndarray
    z1: np.ndarray
    x2: np.ndarray
    z2: np.ndarray


@dataclass(frozen=True)
class MovingStrip:
    """A strip whose middle hinge is at h1 [m], to one of its sides. Rotations may be arrays."""

    strip: Strip
    h1: float

    @cached_property
    def turning(self) -> Turning:
        """Both blocks."""
        return Turning.of(self.strip, self.h1)

    @cached_property
    def points(self) -> tuple[Points, Points]:
        """Collect what the lower and the upper block weigh; a weight that is held elsewhere has no mass."""
        both = zip(blocks_of(self.strip, self.h1), masses_of(self.strip, self.h1), strict=True)
        acting = [(push.x, push.z, 0.0, 0.0, 0.0, push.force, -1) for push in self.strip.thrusts]
        bars = enumerate(self.strip.bars)
        acting += [(outer_face(self.strip, bar.height), bar.height, 0.0, 0.0, 0.0, 0.0, n) for n, bar in bars]
        pushes = [row for row in acting if row[1] <= self.h1], [row for row in acting if row[1] > self.h1]
        rows = [
            [(w.x, w.z, w.lifted, 0.0, 0.0, 0.0, -1) for w in weights]
            + [(m.x, m.z, 0.0, m.mass, m.own, 0.0, -1) for m in masses]
            + pushed
            for (weights, masses), pushed in zip(both, pushes, strict=True)
        ]
        lower, upper = (Points(*np.array(block).T) for block in rows)
        return lower, upper

    def phi(self, theta):
        """Rotation of the upper block [rad]."""
        of = self.turning
        reach = of.at.base + of.width * np.cos(theta) - of.h1 * np.sin(theta) - of.at.top
        return math.atan2(of.edge, of.above) - np.arcsin(reach / math.hypot(of.edge, of.above))

    def hinge(self, theta):
        """x and z [m] of the hinge between."""
        of, cos, sin = self.turning, np.cos(theta), np.sin(theta)
        return of.at.base + of.width * cos - of.h1 * sin, of.h1 * cos + of.width * sin

    def _placed(self, theta, upper: bool):
        """x and z [m] of the points of a block."""
        of, points = self.turning, self.points[upper]
        theta = np.asarray(theta)[..., None]
        if not upper:
            a, b, cos, sin = points.x - of.at.base, points.z, np.cos(theta), np.sin(theta)
            return of.at.base + a * cos - b * sin, b * cos + a * sin
        phi, (x, z) = self.phi(theta), self.hinge(theta)
        a, b, cos, sin = points.x - of.at.between, points.z - of.h1, np.cos(phi), np.sin(phi)
        return x + a * cos + b * sin, z + b * cos - a * sin

    def way(self, theta, upper: bool) -> Way:
        """Where the points of a block are, and how they move with theta."""
        x, z = self._placed(theta, upper)
        (x1, z1), early, late = (
            [np.imag(part) / TINY for part in self._placed(np.asarray(theta) + shift + 1j * TINY, upper)]
            for shift in (0.0, -STEP, STEP)
        )
        x2, z2 = ((after - before) / (2.0 * STEP) for before, after in zip(early, late, strict=True))
        return Way(x, z, x1, z1, x2, z2)

    def phi_rates(self, theta):
        """First and second derivative of phi by theta."""
        rate, early, late = (
            np.imag(self.phi(np.asarray(theta) + shift + 1j * TINY)) / TINY for shift in (0.0, -STEP, STEP)
        )
        return rate, (late - early) / (2.0 * STEP)

    def _ways(self, theta):
        """(points, way, rate of the turn) of both blocks."""
        rate, _ = self.phi_rates(theta)
        return (self.points[0], self.way(theta, False), 1.0), (self.points[1], self.way(theta, True), rate)

    def multiplier(self, theta=0.0):
        """alpha [-] with which the wall is in equilibrium (C8.7.1.1, C8.7.1.2)."""
        held = pushed = 0.0
        for points, way, _ in self._ways(theta):
            held = held + (points.force * way.z1 + points.thrust * way.x1).sum(-1)
            pushed = pushed - G * (points.mass * way.x1).sum(-1)
        return held / pushed

    def acceleration(self, theta, speed, alpha, pulls=None):
        """theta'' [1/s2] under an outward push alpha [-] (Lagrange). speed : theta' [rad/s]; pulls : of the bars"""
        held = pushed = inertia = change = 0.0
        _, twist = self.phi_rates(theta)
        for (points, way, turn), more in zip(self._ways(theta), (0.0, twist), strict=True):
            held = held + (points.force * way.z1 + points.pushes(pulls) * way.x1).sum(-1)
            pushed = pushed - (points.mass * way.x1).sum(-1)
            inertia = inertia + (points.mass * (way.x1**2 + way.z1**2)).sum(-1) + points.own.sum() * turn**2
            change = change + (points.mass * (way.x1 * way.x2 + way.z1 * way.z2)).sum(-1)
            change = change + points.own.sum() * turn * more
        return (alpha * G * pushed - held - change * speed**2) / inertia

    def reactions(self, theta, speed, alpha, acceleration=None, pulls=None):
        """(R at the top, T at the base) [N/m]: R by the moments of the upper block about the hinge between, T by what
        moves sideways.

        theta, speed : of the lower block [rad], [rad/s]; alpha : outward push over g [-]
        acceleration : theta'' [1/s2], None : of the equation of motion; pulls : of `Points.pushes`
        """
        if acceleration is None:
            acceleration = self.acceleration(theta, speed, alpha, pulls)
        of, points, way = self.turning, self.points[1], self.way(theta, True)
        x, z = self.hinge(np.asarray(theta)[..., None])

        def along(rate, change):
            return rate * np.asarray(acceleration)[..., None] + change * np.asarray(speed)[..., None] ** 2

        push = points.mass * (np.asarray(alpha)[..., None] * G + along(way.x1, way.x2)) + points.pushes(pulls)
        falls = points.force + points.mass * along(way.z1, way.z2)
        rate, change = self.phi_rates(theta)
        turned = points.own.sum() * (rate * acceleration + change * np.asarray(speed) ** 2)
        phi = self.phi(np.asarray(theta))
        top = of.above * np.cos(phi) + of.edge * np.sin(phi)
        held = (((way.z - z) * push - (way.x - x) * falls).sum(-1) + turned) / top
        low = self.way(theta, False)
        below = self.points[0]
        sideways = below.mass * (np.asarray(alpha)[..., None] * G + along(low.x1, low.x2)) + below.pushes(pulls)
        return held, push.sum(-1) + sideways.sum(-1) - held

    @cached_property
    def alpha0(self) -> float:
        """Multiplier at which the wall begins to move."""
        return float(self.multiplier())

    @cached_property
    def starts(self) -> tuple[float, float]:
        """(R_0, T_0) [N/m]: reactions at the top and at the base as the wall begins to move."""
        held, base = self.reactions(0.0, 0.0, self.alpha0, 0.0)
        return float(held), float(base)

    @cached_property
    def growths(self) -> tuple[float, float]:
        """kappa at the top and at the base [N/m]: growth of a reaction with the push on a wall that moves, at rest."""
        held, base = self.reactions(0.0, 0.0, self.alpha0 + 1.0)
        return float(held) - self.starts[0], float(base) - self.starts[1]

    def bound(self, alpha: float, at_base: bool = False) -> float:
        """Largest reaction [N/m] of a wall that moves, under pushes up to alpha [-]: R_0 + kappa (alpha - alpha_0). Of
        380 random walls under 28 motions each the largest at the top was 1.000 of it, of 200 under 480 pulses the
        largest at the base too (tests/core/mechanism)."""
        return self.starts[at_base] + self.growths[at_base] * max(0.0, alpha - self.alpha0)

    def momentum(self, about: float) -> float:
        """Angular momentum of both blocks about a point of the base at x = about [m], by a unit of theta' at rest [kg
        m]."""
        total = 0.0
        for (points, way, turn), sense in zip(self._ways(0.0), (1.0, -1.0), strict=True):
            spin = (points.x - about) * way.z1 - points.z * way.x1
            total += float((points.mass * spin).sum() + sense * turn * points.own.sum())
        return total

    @cached_property
    def top_mass(self) -> float:
        """m_T [kg/m]: mass felt by a force across the top where it is released, so that both blocks turn apart."""
        of, (lower, upper), matrix = self.turning, self.points, np.zeros((2, 2))
        nil = np.zeros(lower.x.size)
        ways = (
            (lower, ((-lower.z, lower.x - of.at.base), (nil, nil)), (1.0, 0.0)),
            (upper, ((nil[:1] - of.h1, nil[:1] + of.width), (upper.z - of.h1, of.at.between - upper.x)), (0.0, 1.0)),
        )
        for points, velocities, turns in ways:
            for i, j in np.ndindex(2, 2):
                together = velocities[i][0] * velocities[j][0] + velocities[i][1] * velocities[j][1]
                matrix[i, j] += float((points.mass * together).sum() + points.own.sum() * turns[i] * turns[j])
        top = np.array([-of.h1, of.above])
        return float(1.0 / (top @ np.linalg.solve(matrix, top)))


def kept_rate(leaving: MovingStrip, entering: MovingStrip) -> float:
    """theta' after an impact over theta' before it: the momentum projected on the mechanism that opens."""
    cross = own = 0.0
    for (points, out, turn), (same, back, other) in zip(leaving._ways(0.0), entering._ways(0.0), strict=True):
        here, there = points.mass > 0.0, same.mass > 0.0  # thrusts and bars act to one side alone
        mass, x1, z1 = points.mass[here], back.x1[there], back.z1[there]
        cross += float((mass * (out.x1[here] * x1 - out.z1[here] * z1)).sum() + points.own.sum() * turn * other)
        own += float((mass * (x1**2 + z1**2)).sum() + points.own.sum() * other**2)
    return cross / own


def impulse(leaving: MovingStrip, entering: MovingStrip, speed: float) -> float:
    """Impulse of the hold at the top [N s/m] as a wall passes from one side to the other, positive towards the side it
    comes from: on a wall that returns from inward the hold pulls.

    leaving, entering : each seen from its own outer face; speed : theta' before the impact [rad/s]
    """
    strip = leaving.strip
    before = leaving.momentum(strip.thickness - strip.setback)
    after = max(0.0, kept_rate(leaving, entering)) * entering.momentum(entering.strip.setback)
    return speed * (before - after) / strip.height


def speeds_at_return(motion: History, dt: float, back: float) -> np.ndarray:
    """abs(theta') [rad/s] of a wall that comes back from inward, just before each impact: from what it keeps, or, where
    it keeps nothing, from the samples before. dt : [s]; back : `kept_rate` from inward to outward"""
    if back > 0.0:
        return motion.impact_velocity[motion.impact_velocity > 0.0] / back
    last = np.minimum(motion.impact_time // dt, motion.rotation.size - 1).astype(int)
    before = np.maximum(last - 1, 0)
    here, late = motion.velocity[last], motion.impact_time / dt - last
    return np.abs(here + late * (here - motion.velocity[before]))[motion.rotation[last] < 0.0]


def reactions_of_history(
    outward: MovingStrip, inward: MovingStrip, motion: History, push: np.ndarray, dt: float, at_base: bool = False
) -> tuple[float, float]:
    """Largest reactions [N/m] of the hold at the top, or of the base, along a history, outward-holding and
    inward-holding: at every sample while the wall moves, and on both sides of each impact.

    outward, inward : the wall to its two sides; motion : its history; push : outward, over g [-], shape (n,); dt : [s]
    """
    largest = [0.0, 0.0]
    rotation, speed = motion.rotation, motion.velocity
    times, bars = np.arange(rotation.size) * dt, outward.strip.bars
    pulled = bar_forces(outward, motion)
    at_impacts = np.interp(motion.impact_time, times, push[: rotation.size])
    for k, (strip, other, sign) in enumerate(((outward, inward, 1.0), (inward, outward, -1.0))):
        moving = sign * rotation > 0.0
        entered = sign * motion.impact_velocity > 0.0
        after = sign * motion.impact_velocity[entered]
        left = -sign * motion.impact_velocity[~entered] / kept_rate(strip, other)  # it comes in with -left
        theta = np.concatenate([sign * rotation[moving], np.zeros(after.size + left.size)])
        speeds = np.concatenate([sign * speed[moving], after, left])
        pushes = sign * np.concatenate([push[: rotation.size][moving], at_impacts[entered], at_impacts[~entered]])
        if theta.size:
            pulls = np.zeros((theta.size, len(bars)))
            if k == 0:
                pulls[: moving.sum()] = pulled[moving]
            held = strip.reactions(theta, speeds, pushes, pulls=pulls if k == 0 else None)[at_base]
            largest[k] = max(largest[k], float(held.max()))
            largest[1 - k] = max(largest[1 - k], -float(held.min()))
    return largest[0], largest[1]


def bar_forces(outward: MovingStrip, motion: History) -> np.ndarray:
    """Forces of the bars of a wall along its history [N/m], shape (samples, bars)."""
    strip, theta = outward.strip, np.maximum(motion.rotation, 0.0)
    of = Motion(strip, outward.h1)
    rows = [
        bar.strength * np.clip((of.stretched(theta, bar)[0] - residual) / bar.elongation_at_yield, 0.0, 1.0)
        for bar, residual in zip(strip.bars, motion.of_bars, strict=True)
    ]
    return np.array(rows).T.reshape(theta.size, len(rows))


def spring_force(momentum: float, stiffness: float, mass: float) -> float:
    """Force [N/m] of an elastic hold that takes an impulse: J sqrt(k/m_T).

    momentum : J [N s/m]; stiffness : k [N/m2]; mass : m_T [kg/m]
    """
    return momentum * math.sqrt(stiffness / mass)
