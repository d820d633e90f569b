"""Histories by the double-double solver, of a RockingModel: its numbers are read, nothing more."""

from fractions import Fraction
from typing import NamedTuple

import mpmath as mp
import numpy as np

from core.wall.rocking_model import RockingModel
from tests.validation.double_double import BROKEN, ORDER, run

GRAVITY = Fraction("9.80665")
"""[m/s2]"""


class Wall(NamedTuple):
    """The numbers of a wall; pairs are double-doubles.

    sine, cosine : of alpha [-]; minus_p2 : [1/s2]; one_sided, ratio, drop : as of RockingModel
    rest : speed below which it rests after an impact [rad/s]
    phi1, phi2 : ends of elastic branch and plateau [rad], (0, 0) if rigid; plateau : moment of it [-]
    a, c : of positive and of negative rotations [-]; right, left : ground that uplifts it [g]
    """

    sine: tuple[float, float]
    cosine: tuple[float, float]
    minus_p2: tuple[float, float]
    one_sided: bool
    ratio: float
    drop: float
    rest: float
    phi1: tuple[float, float]
    phi2: tuple[float, float]
    plateau: tuple[float, float]
    a: tuple[float, float]
    c: tuple[float, float]
    right: tuple[float, float]
    left: tuple[float, float]


class Exact(NamedTuple):
    """A history of the double-double solver.

    rotation : at the samples, up to beyond 90 degrees or more impacts in a sample than the limit [rad]
    impacts : count
    residual : of each bar, its residual elongation over its height at its last turn [-]; broken : whether it has gone
    """

    rotation: np.ndarray
    impacts: int
    residual: np.ndarray
    broken: np.ndarray


def split(value) -> tuple[float, float]:
    """The double-double next to a number of mpmath."""
    return float(value), float(value - mp.mpf(float(value)))


def wall_of(model: RockingModel) -> Wall:
    """The numbers of a wall; under a trilinear law its loads are alike on both sides."""
    with mp.workdps(40):
        alpha, phi2, sides = mp.mpf(model.slenderness), mp.mpf(model.plateau_end), (model.restoring, model.mirrored)
        right, left = (mp.mpf(0) if phi2 else side.sine * mp.tan(alpha) + side.cosine for side in sides)
        return Wall(
            sine=split(mp.sin(alpha)),
            cosine=split(mp.cos(alpha)),
            minus_p2=(-model.p2, 0.0),
            one_sided=model.one_sided != 0.0,
            ratio=model.ratio_at_rest,
            drop=model.ratio_drop,
            rest=float(mp.sqrt(model.p2) * alpha / 10**6),
            phi1=(model.elastic_end, 0.0),
            phi2=(model.plateau_end, 0.0),
            plateau=split(sides[0].sine * mp.sin(alpha - phi2) + sides[0].cosine * mp.cos(alpha - phi2)),
            a=(sides[0].sine, sides[1].sine),
            c=(sides[0].cosine, sides[1].cosine),
            right=split(right),
            left=split(left),
        )


def history(ground: np.ndarray, dt: float, model: RockingModel) -> Exact:
    """The history from rest of a wall under a ground [m/s2] at dt [s]."""
    per_g = float(1 / GRAVITY), float(1 / GRAVITY - Fraction(float(1 / GRAVITY)))
    bars = np.array(model.bars, float).reshape(len(model.bars), 5)
    rotation, count = np.zeros(ground.size), len(bars)
    residual, phase, at = np.zeros((count, 2)), np.zeros(count, np.int64), np.zeros(count, np.int64)
    series, terms = np.zeros((5, ORDER + 1, 2)), np.zeros((7, 2))
    done, impacts = run(ground, dt, per_g, wall_of(model), bars, rotation, series, terms, residual, phase, at)
    return Exact(rotation[:done], impacts, residual[:, 0], phase == BROKEN)
