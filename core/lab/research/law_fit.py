"""Fits of the scale-free law to the runs of a study, and how they hold on shapes and records left out."""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from core.capacity.regression import Agreement, agreement
from core.capacity.scale_free_law import (
    Ends,
    ScaleFreeLaw,
    dimensionless_intensity,
    fit_law,
    law_value,
    limit_of,
    loss_ratio,
    scaled_intensity,
)
from core.lab.research.paper_sets import MECHANISM
from core.lab.research.set_means import QUANTITIES, MotionValue, exact
from core.wall.kinematics import kinematics
from core.wall.moment_rotation import LAWS

MIN_EVENTS = 10
"""Events from which natural records have an interval."""

STANDARD_ERRORS = 1.645
"""Standard errors of an interval that holds nine cases of ten."""

MIN_SHAPES = 4
"""Shapes from which a law is fitted."""


@dataclass(frozen=True)
class Columns:
    """Runs or sets side by side, shape (n,) each. loss : sqrt(1 - e); spectrum : "" of a natural record."""

    alpha: np.ndarray
    height: np.ndarray
    pi: np.ndarray
    loss: np.ndarray
    velocity: np.ndarray
    scaled: np.ndarray
    q: np.ndarray
    intensity: np.ndarray
    pga: np.ndarray
    spectrum: np.ndarray
    default: np.ndarray
    event: np.ndarray

    def __getitem__(self, keep) -> "Columns":
        return Columns(*(values[keep] for values in vars(self).values()))


def columns(values: list[MotionValue], mechanism: str, law: str, quantity: str, natural: bool) -> Columns:
    """Runs of a mechanism, law and quantity that have a number.

    velocity : p PGV / PGA [-]; scaled : Lambda, `scaled_intensity` [-]
    default : whether the restitution is the one that follows the mechanism
    event : earthquake of a natural record
    """
    rows, walls = [], {}
    for value in exact(values):
        cell, motion = value.cell, value.entry.motion
        number = getattr(value, quantity)
        fits = (cell.mechanism, cell.law, value.entry.seed is None) == (mechanism, law, natural)
        if not fits or number is None:
            continue
        if cell not in walls:
            wall = cell.wall
            block, restitution = wall.block(), wall.restitution_of(cell.mechanism)
            walls[cell] = (
                block.p2,
                np.sqrt(1.0 - loss_ratio(block, restitution)),
                restitution.model in ("housner", "one_sided_theoretical")
                and (restitution.model == "housner") == (kinematics(mechanism).both_ways),
            )
        p2, loss, default = walls[cell]
        rows.append(
            (
                cell.slenderness_deg,
                cell.height_m,
                dimensionless_intensity(p2, motion.housner_intensity, motion.pga),
                loss,
                np.sqrt(p2) * motion.pgv / motion.pga,
                scaled_intensity(p2, motion.velocity_integral, motion.pga, mechanism),
                number,
                motion.housner_intensity,
                motion.pga,
                value.entry.spectrum,
                default,
                value.entry.event,
            )
        )
    if not rows:
        return Columns(*(np.zeros(0) for _ in range(12)))
    return Columns(*map(np.array, zip(*rows, strict=True)))


def set_columns(runs: Columns) -> Columns:
    """Means over the motions of each wall and spectrum; of Pi and p PGV/PGA as well."""
    if not runs.q.size:
        return runs
    keys = np.column_stack([runs.alpha, runs.height, runs.loss]).round(9)
    _, wall = np.unique(keys, axis=0, return_inverse=True)
    _, shape = np.unique(runs.spectrum, return_inverse=True)
    _, first, group = np.unique(wall * (shape.max() + 1) + shape, return_index=True, return_inverse=True)
    count = np.bincount(group)
    means = {
        name: np.bincount(group, weights=getattr(runs, name)) / count
        for name in ("pi", "velocity", "scaled", "q", "intensity", "pga")
    }
    return Columns(**{name: means.get(name, values[first]) for name, values in vars(runs).items()})


@dataclass(frozen=True)
class LawFit:
    """A fitted law with its quality.

    errors : of the coefficients, delete-one-shape jackknife
    inside : agreement of the fit itself; outside : of every shape by the fit without it
    records, natural : of single motions
    natural_pi, outside_pi : of the same form in Pi
    covered : `coverage` of the interval of one record, of events left out
    held : the same of the interval of a set, of shapes left out
    of_records : (share inside, share below) of the interval of a set, of single natural records
    """

    law: ScaleFreeLaw
    errors: tuple[float, ...]
    inside: Agreement
    outside: Agreement
    records: Agreement
    natural: Agreement | None
    natural_velocity: Agreement | None
    outside_velocity: Agreement
    natural_pi: Agreement | None
    outside_pi: Agreement
    covered: "Coverage | None"
    held: "Coverage"
    of_records: tuple[float, float] | None


OF_SETS, OF_RECORDS = (0.05, 0.95), (0.05, 0.16, 0.95)
"""Shares of cases below the ends of an interval; of records between them that below the second design value."""

FIFTHS, FOURTHS = 5, 4
"""Parts of the range of Lambda, and of s, in which the shares are counted."""

RECORD_LOSS = {"two_sided": 1.0, "one_sided": 0.80}
"""s up to which natural records have an interval: one-sided walls of 15 degrees and more whose restitution is that of
Eq. 6 lie up to 30 % below the law (e below 0.36)."""


def weighted_ends(residuals: np.ndarray, groups: np.ndarray, shares: tuple[float, ...]) -> tuple[float, ...]:
    """ln(q / law) with these shares of the cases below, each group of the same weight. shapes (n,)"""
    _, group, count = np.unique(groups, return_inverse=True, return_counts=True)
    order = np.argsort(residuals)
    share = np.cumsum((1.0 / count[group])[order]) / count.size
    places = np.minimum(np.searchsorted(share, shares), order.size - 1)
    return tuple(map(float, residuals[order][places]))


def part_of(values: np.ndarray, parts: int) -> np.ndarray:
    """Number of the part of its range, of as many cases each, that each value is in."""
    return np.searchsorted(np.quantile(values, np.arange(1, parts) / parts), values, side="left")


def ends_of(cases: "Cases", shares: tuple[float, ...]) -> Ends:
    """The ends by parts of Lambda and of s."""

    def counted(values: np.ndarray, parts: int) -> tuple[tuple[float, ...], tuple[tuple[float, ...], ...]]:
        part, found = part_of(values, parts), {}
        for k in np.unique(part):
            own = part == k
            found.setdefault(
                round(float(np.median(values[own])), 3), weighted_ends(cases.residuals[own], cases.groups[own], shares)
            )
        nodes = sorted(found)
        return tuple(nodes), tuple(tuple(round(end, 3) for end in found[node]) for node in nodes)

    return Ends(*counted(cases.scaled, FIFTHS), *counted(cases.loss, FOURTHS))


@dataclass(frozen=True)
class Cases:
    """ln(q / law) of cases, with their Lambda, s, and the event or shape they are of. shapes (n,)"""

    residuals: np.ndarray
    scaled: np.ndarray
    loss: np.ndarray
    groups: np.ndarray

    def __getitem__(self, keep) -> "Cases":
        return Cases(*(values[keep] for values in vars(self).values()))


Coverage = dict[str, list[list[float]]]
""""all", "scaled", "loss" -> of all cases, of each part of Lambda, of each part of s: share inside, and shares below
each end but the last."""


def coverage(cases: Cases, shares: tuple[float, ...]) -> Coverage:
    """What the ends hold of each group, counted on the others."""
    flags = np.empty((len(shares), cases.residuals.size))
    for name in np.unique(cases.groups):
        own = cases.groups == name
        ends = ends_of(cases[~own], shares)
        at = np.array([ends.at(*one) for one in zip(cases.scaled[own], cases.loss[own], strict=True)]).T
        inside = (cases.residuals[own] >= at[0]) & (cases.residuals[own] <= at[-1])
        flags[:, own] = [inside, *(cases.residuals[own] < low for low in at[:-1])]

    def means(own: np.ndarray) -> list[float]:
        each = [flags[:, own & (cases.groups == name)].mean(axis=1) for name in np.unique(cases.groups[own])]
        return [float(one) for one in np.mean(each, axis=0)]

    parts = {"scaled": part_of(cases.scaled, FIFTHS), "loss": part_of(cases.loss, FOURTHS)}
    found = {name: [means(part == k) for k in np.unique(part)] for name, part in parts.items()}
    return {"all": [means(np.full(cases.groups.size, True))], **found}


def left_out(sets: Columns, variable: np.ndarray, limit: float) -> tuple[np.ndarray, np.ndarray]:
    """Leave out each shape in turn: (coefficients without each shape, law of every set by the fit without its
    shape)."""
    shapes = list(dict.fromkeys(sets.spectrum))
    coefficients, predicted = [], np.empty(sets.q.size)
    for shape in shapes:
        own = sets.spectrum == shape
        coefficients.append(fit_law(variable[~own], sets.loss[~own], sets.q[~own], limit))
        predicted[own] = law_value(coefficients[-1], limit, variable[own], sets.loss[own])
    return np.array(coefficients), predicted


def fitted(values: list[MotionValue], mechanism: str, law: str, quantity: str) -> LawFit | None:
    """The law of one mechanism, moment law and quantity; None with fewer than four shapes."""
    runs = columns(values, mechanism, law, quantity, False)
    if np.unique(runs.spectrum).size < MIN_SHAPES:
        return None
    sets, limit = set_columns(runs), limit_of(LAWS[law])
    coefficients = fit_law(sets.scaled, sets.loss, sets.q, limit)
    without, predicted = left_out(sets, sets.scaled, limit)
    n = len(without)
    errors = np.sqrt((n - 1) / n * ((without - without.mean(axis=0)) ** 2).sum(axis=0))
    by_velocity = fit_law(sets.velocity, sets.loss, sets.q, limit)
    _, velocity_predicted = left_out(sets, sets.velocity, limit)
    by_pi = fit_law(sets.pi, sets.loss, sets.q, limit)
    _, pi_predicted = left_out(sets, sets.pi, limit)
    inside = agreement(law_value(coefficients, limit, sets.scaled, sets.loss), sets.q)
    outside = agreement(predicted, sets.q)
    records = agreement(law_value(coefficients, limit, runs.scaled, runs.loss), runs.q)
    other = columns(values, mechanism, law, quantity, True)
    natural = natural_velocity = natural_pi = covered = of_records = record = None
    of_sets = Cases(np.log(sets.q / predicted), sets.scaled, sets.loss, sets.spectrum)
    loss = float(sets.loss.min()), float(sets.loss.max())
    a0, a1, b0, b1 = coefficients
    made = ScaleFreeLaw(
        (round(a0, 3), round(a1, 3), round(b0, 3), round(b1, 3)),
        limit,
        (round(float(sets.scaled.min()), 3), round(float(sets.scaled.max()), 3)),
        (round(loss[0], 3), round(loss[1], 3)),
        ends_of(of_sets, OF_SETS),
        record_loss=(round(loss[0], 3), round(min(loss[1], RECORD_LOSS[mechanism]), 3)),
    )
    if other.q.size:
        of_law = law_value(coefficients, limit, other.scaled, other.loss)
        natural = agreement(of_law, other.q)
        ranges = np.array([made.interval(x, 1.0 - s * s) for x, s in zip(other.scaled, other.loss, strict=True)]).T
        below = other.q < ranges[0]
        of_records = float(np.mean(~below & (other.q <= ranges[1]))), float(np.mean(below))
        natural_velocity = agreement(law_value(by_velocity, limit, other.velocity, other.loss), other.q)
        natural_pi = agreement(law_value(by_pi, limit, other.pi, other.loss), other.q)
        low, high = made.scaled_range
        (least, most), x, s = made.record_loss, other.scaled, other.loss
        own = (x >= low) & (x <= high) & (s >= least - 1e-3) & (s <= most + 1e-3)
        if np.unique(other.event[own]).size >= MIN_EVENTS:
            cases = Cases(np.log(other.q / of_law), x, s, other.event)[own]
            record, covered = ends_of(cases, OF_RECORDS), coverage(cases, OF_RECORDS)
    return LawFit(
        replace(made, record=record),
        tuple(map(float, errors)),
        inside,
        outside,
        records,
        natural,
        natural_velocity,
        agreement(velocity_predicted, sets.q),
        natural_pi,
        agreement(pi_predicted, sets.q),
        covered,
        coverage(of_sets, OF_SETS),
        of_records,
    )


def fits_of(values: list[MotionValue]) -> dict[tuple[str, str, str], LawFit]:
    """All laws the study holds data for."""
    fits = {key: fitted(values, *key) for key in product(MECHANISM, LAWS, QUANTITIES)}
    return {key: fit for key, fit in fits.items() if fit is not None}
