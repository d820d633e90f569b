"""Fits of the scale-free law to the runs of a study, and how they hold on shapes and records left out."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from core.capacity.regression import Agreement, agreement
from core.capacity.scale_free_law import (
    ScaleFreeLaw,
    dimensionless_intensity,
    fit_law,
    law_value,
    limit_of,
    loss_ratio,
    scaled_intensity,
)
from core.research.paper_sets import MECHANISM
from core.research.set_means import QUANTITIES, MotionValue, exact
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
                and (restitution.model == "housner") == (mechanism == "two_sided"),
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
    covered : `coverage` of the interval of one record
    held : (share inside, share below) of the interval of a set: of sets of a shape left out, of those of them in the
        lowest quarter of Lambda and of the others, and of single natural records
    below : `below_by_half`
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
    below: tuple[float, float] | None
    covered: tuple[float, ...] | None
    held: dict[str, tuple[float, float]]


SHARES = (0.05, 0.16, 0.95)
"""Shares of natural records below the values of one: the ends of its interval, and between them the second design
value."""


def record_ends(residuals: np.ndarray, events: np.ndarray) -> tuple[float, float, float]:
    """ln(q / law) with SHARES of the records below, each event of the same weight. shapes (n,)"""
    _, event, count = np.unique(events, return_inverse=True, return_counts=True)
    order = np.argsort(residuals)
    share = np.cumsum((1.0 / count[event])[order]) / count.size
    places = np.minimum(np.searchsorted(share, SHARES), order.size - 1)
    low, sixth, high = map(float, residuals[order][places])
    return low, sixth, high


def coverage(residuals: np.ndarray, events: np.ndarray) -> tuple[float, ...]:
    """(share inside the interval of one record, share below it, share below the value of one in six), of each event by
    the others, mean over the events."""
    inside, below = [], []
    for name in np.unique(events):
        own = events == name
        low, sixth, high = record_ends(residuals[~own], events[~own])
        inside.append(np.mean((residuals[own] >= low) & (residuals[own] <= high)))
        below.append((np.mean(residuals[own] < low), np.mean(residuals[own] < sixth)))
    return float(np.mean(inside)), *map(float, np.mean(below, axis=0))


def below_by_half(residuals: np.ndarray, scaled: np.ndarray, events: np.ndarray) -> tuple[float, float]:
    """Share of natural records below the first design value where Lambda is below its median, and where it is above;
    each event of the same weight. shapes (n,)"""
    low = record_ends(residuals, events)[0]
    shares = []
    for own in (scaled <= np.median(scaled), scaled > np.median(scaled)):
        names, event = np.unique(events[own], return_inverse=True)
        count = np.bincount(event)
        shares.append(float(np.mean(np.bincount(event, residuals[own] < low, names.size) / count)))
    return shares[0], shares[1]


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


def held_by(law: np.ndarray, q: np.ndarray, scatter: float, limit: float) -> tuple[float, float]:
    """(share inside, share below) of the interval of a set about a law. shapes (n,); scatter : of ln(law / q)"""
    factor = np.exp(STANDARD_ERRORS * scatter)
    low = np.maximum(law / factor, limit if limit == 1.0 else 0.0)
    return float(np.mean((q >= low) & (q <= law * factor))), float(np.mean(q < low))


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
    natural = natural_velocity = natural_pi = None
    lowest = sets.scaled <= np.quantile(sets.scaled, 0.25)
    parts = {"sets": np.full(lowest.size, True), "lowest_quarter": lowest, "other_quarters": ~lowest}
    held = {name: held_by(predicted[own], sets.q[own], outside.scatter, limit) for name, own in parts.items()}
    record = covered = below = None
    if other.q.size:
        of_records = law_value(coefficients, limit, other.scaled, other.loss)
        natural = agreement(of_records, other.q)
        held["records"] = held_by(of_records, other.q, outside.scatter, limit)
        natural_velocity = agreement(law_value(by_velocity, limit, other.velocity, other.loss), other.q)
        natural_pi = agreement(law_value(by_pi, limit, other.pi, other.loss), other.q)
        low, high = float(sets.scaled.min()), float(sets.scaled.max())
        within = other[(other.scaled >= low) & (other.scaled <= high)]
        if np.unique(within.event).size >= MIN_EVENTS:
            residuals = np.log(within.q / law_value(coefficients, limit, within.scaled, within.loss))
            record, covered = record_ends(residuals, within.event), coverage(residuals, within.event)
            below = below_by_half(residuals, within.scaled, within.event)
    a0, a1, b0, b1 = coefficients
    made = ScaleFreeLaw(
        (round(a0, 3), round(a1, 3), round(b0, 3), round(b1, 3)),
        limit,
        round(outside.scatter, 3),
        round(records.scatter, 3),
        (float(sets.scaled.min()), float(sets.scaled.max())),
        (float(sets.loss.min()), float(sets.loss.max())),
        record and (round(record[0], 3), round(record[1], 3), round(record[2], 3)),
    )
    return LawFit(
        made,
        tuple(map(float, errors)),
        inside,
        outside,
        records,
        natural,
        natural_velocity,
        agreement(velocity_predicted, sets.q),
        natural_pi,
        agreement(pi_predicted, sets.q),
        below,
        covered,
        held,
    )


def fits_of(values: list[MotionValue]) -> dict[tuple[str, str, str], LawFit]:
    """All laws the study holds data for."""
    fits = {key: fitted(values, *key) for key in product(MECHANISM, LAWS, QUANTITIES)}
    return {key: fit for key, fit in fits.items() if fit is not None}
