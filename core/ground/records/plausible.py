"""Is it the motion of a ground? What files that were sorted, repeated, frozen or turned over on the way look like."""

import numpy as np

from core.errors import RecordError
from core.text.sentence import Sentence, notice

LEAST = 20
"""Samples below which nothing is told."""

FROZEN, FROZEN_SHARE = 50, 0.02
"""Equal samples in a row, of more than this share of the peak, that no sensor gives within the strong part."""

FILLED = 100
"""Zeros in a row within the strong part: a gap that was filled."""

STRONG = 0.05, 0.95
"""Of the sum of the squares, between which the strong part lies."""


def refuse_sorted(values: np.ndarray) -> None:
    """Raise RecordError where the samples only rise or only fall: a column that was sorted, or no acceleration.
    values : shape (n,)"""
    if values.size < 4 * LEAST or not values.any():
        return
    steps = np.diff(values)
    if (steps >= 0.0).all() or (steps <= 0.0).all():
        raise RecordError("sorted_samples", n=values.size)


def doubts(values: np.ndarray) -> list[Sentence]:
    """Warnings of samples that are no motion of a ground, though they are numbers. values : shape (n,)"""
    if values.size < 4 * LEAST or not values.any():
        return []
    return [*_repeated(values), *_frozen(values)]


def _repeated(values: np.ndarray) -> list[Sentence]:
    """That the record begins again and repeats itself to its end."""
    n = values.size
    moving = int(np.argmax(np.diff(values) != 0.0))
    probe = values[moving : moving + 8]
    if probe.size < 8:
        return []
    starts = np.flatnonzero(values[moving + LEAST : n - LEAST] == probe[0]) + moving + LEAST
    for start in starts[:2000].tolist():
        period = start - moving
        if np.array_equal(values[start : start + 8], probe) and np.array_equal(values[period:], values[: n - period]):
            return [notice("repeats", sample=period + 1)]
    return []


def _frozen(values: np.ndarray) -> list[Sentence]:
    """That samples do not change for long while the ground moves."""
    edges = np.flatnonzero(np.diff(values) != 0.0) + 1
    begins = np.concatenate([[0], edges])
    lengths = np.diff(np.concatenate([begins, [values.size]]))
    energy = np.cumsum(values**2)
    inside = (energy[begins] > STRONG[0] * energy[-1]) & (energy[begins] < STRONG[1] * energy[-1])
    size, peak = np.abs(values[begins]), float(np.abs(values).max())
    held = (lengths >= FROZEN) & (size > FROZEN_SHARE * peak)
    found = np.flatnonzero(inside & (held | (lengths >= FILLED)))
    if not found.size:
        return []
    k = int(found[0])
    return [notice("frozen", n=int(lengths[k]), sample=int(begins[k]) + 1)]
