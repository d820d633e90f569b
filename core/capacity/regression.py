"""Regressions of q: power laws with a given exponent (Eq. 13), C1 in alpha and H (Eq. 14), other laws, shares of
agreement."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Fit:
    """Least squares. coefficients; r_squared : of what was fitted; n points."""

    coefficients: tuple[float, ...]
    r_squared: float
    n: int


def least_squares(columns, values) -> Fit:
    """Ordinary least squares of values on columns, shape (n, m).

    Raises ValueError with fewer points than columns or columns that are not independent.
    """
    matrix, values = np.asarray(columns, float), np.asarray(values, float)
    if values.size < matrix.shape[1]:
        raise ValueError("underdetermined")
    coefficients, _, rank, _ = np.linalg.lstsq(matrix, values, rcond=None)
    if rank < matrix.shape[1]:
        raise ValueError("dependent columns")
    return Fit(tuple(map(float, coefficients)), r_squared(values, matrix @ coefficients), values.size)


def least_squares_of(residual: Callable[[np.ndarray], np.ndarray], start: Sequence[float]) -> np.ndarray:
    """Coefficients of a law that is not linear in them, by Levenberg (1944) and Marquardt (1963).

    residual : of the coefficients, shape (n,); start : coefficients to begin with, finite residuals
    Raises ArithmeticError where 200 steps do not end the search.
    """
    best, damping = np.array(start, float), 1e-3
    left = residual(best)
    for _ in range(200):
        widths = 1e-6 * np.maximum(1.0, np.abs(best))
        slope = np.column_stack([(residual(best + w) - residual(best - w)) / (2.0 * w.max()) for w in np.diag(widths)])
        normal, moved = slope.T @ slope, False
        while not moved and damping < 1e12:
            change = np.linalg.solve(normal + damping * np.diag(np.maximum(normal.diagonal(), 1e-30)), -slope.T @ left)
            with np.errstate(all="ignore"):  # a step too long is taken back
                trial = residual(best + change)
            moved = bool(trial @ trial < left @ left)
            damping *= 0.1 if moved else 10.0
            if moved:
                best, left = best + change, trial
        if not moved or np.abs(change).max() <= 1e-10 * (1e-10 + np.abs(best).max()):
            return best
    raise ArithmeticError("the least squares do not settle")


def r_squared(values, fitted) -> float:
    """1 - residual over spread about the mean [-]; 1 for values without spread that are met."""
    values, fitted = np.asarray(values, float), np.asarray(fitted, float)
    spread = float(((values - values.mean()) ** 2).sum())
    residual = float(((values - fitted) ** 2).sum())
    if spread == 0.0:
        return 1.0 if residual == 0.0 else 0.0
    return 1.0 - residual / spread


def power_coefficient(x, y, exponent: float) -> Fit:
    """C1 of y = C1 x^exponent, least squares of the logarithms (Eq. 13 with C2 given)."""
    log_x, log_y = np.log(np.asarray(x, float)), np.log(np.asarray(y, float))
    level = float((log_y - exponent * log_x).mean())
    return Fit((math.exp(level),), r_squared(log_y, level + exponent * log_x), log_y.size)


def linear_c1(slenderness_deg, height, c1) -> Fit:
    """A1, A2, A3 of C1 = A1 alpha + A2 H + A3 (Eq. 14); alpha [deg], H [m]."""
    return least_squares(np.column_stack([slenderness_deg, height, np.ones(len(c1))]), c1)


BAND = 0.2
"""Band about a law, as the paper draws it in figures 21 and 22."""


@dataclass(frozen=True)
class Agreement:
    """How a law agrees with what it is to give: ratio law / truth.

    bias : mean of ln(law / truth) as a ratio minus 1 [-]
    scatter : standard deviation of ln(law / truth) [-]
    within : share of the truth in a band of 20 % about the law, |truth / law - 1| <= 0.2 [-]
    """

    bias: float
    scatter: float
    within: float
    n: int


def agreement(law, truth) -> Agreement:
    """Agreement of positive values of a law with the true ones."""
    ratio = np.asarray(law, float) / np.asarray(truth, float)
    log = np.log(ratio)
    within = float((np.abs(1.0 / ratio - 1.0) <= BAND).mean())
    return Agreement(math.expm1(float(log.mean())), float(log.std(ddof=1)) if log.size > 1 else 0.0, within, log.size)
