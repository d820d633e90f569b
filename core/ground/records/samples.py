"""Are the samples those of a motion? Marks of missing ones, lines written twice, places where nothing fits."""

import re

import numpy as np

from core.errors import RecordError, place
from core.ground.records.grammar import NUMBER_LETTERS, quoted
from core.text.sentence import Sentence, notice

MIN_EXTREME_RATIO = 3.0
"""How many times all other samples equal extreme ones must be to be marks of gaps; in the records tried the largest
sample is up to 1.5 times the next one."""

ENOUGH = 50
"""Samples from which on equal extreme ones that are written like no mark are marks: of fewer, that is chance."""

_MARK = re.compile(r"9+(\.9+)?|9+0+|32768|32767|8388608|8388607|2147483648|12345|7777|8888|1e\+\d+")
"""How a mark of a missing sample is usually written; of these one alone is enough."""

_MARKS_INSIDE = (-1, -9, *(sign * x for sign in (1, -1) for x in (99, 999, 9999, 99.99, 999.9, 999.99)))
MIN_EQUAL_SAMPLES, MIN_STEP_SHARE = 3, 0.05
"""Equal samples in a row that are a mark within the range of the others, and share of the peak by which the record
jumps to them or back."""

DIFFERENCE_ORDER, COMPARED_SAMPLES, JUMP_SAMPLES, MIN_JUMP_RATIO = 4, 32, 8, 12.0
"""DIFFERENCE_ORDER: order of the difference that shows a jump. COMPARED_SAMPLES: samples around it that are compared.
JUMP_SAMPLES: those it spoils itself. MIN_JUMP_RATIO: its ratio to the largest of those around it; in the records tried
the ratio is below 10 away from their ends, but for one that breaks off."""


def refuse_marks(values: np.ndarray) -> None:
    """Raise RecordError where samples are marks of missing ones: equal, extreme and apart from all others, or equal
    in a row where the record jumps to them or back. values : in the unit of the file, shape (n,)."""
    if values.size < 10 or not np.isfinite(values).all():
        return
    size = np.abs(values)
    top = float(size.max())
    marks = size == top
    others = float(size[~marks].max(initial=0.0))
    usual = bool(_MARK.fullmatch(f"{top:.12g}"))
    several = marks.sum() > 1 and values.size >= ENOUGH
    if others and top >= MIN_EXTREME_RATIO * others and (usual or several):
        _refuse(values, marks)
    steps = np.abs(np.diff(values))
    for mark in _MARKS_INSIDE:
        marks = values == mark
        if marks.sum() >= MIN_EQUAL_SAMPLES and marks.sum() < 0.5 * values.size and (values % 1.0).any():
            edges = np.diff(np.concatenate([[0], marks.view(np.int8), [0]]))
            begins, ends = np.flatnonzero(edges > 0), np.flatnonzero(edges < 0)
            there = np.where(begins > 0, steps[np.maximum(begins - 1, 0)], 0.0)
            back = np.where(ends < values.size, steps[np.minimum(ends - 1, steps.size - 1)], 0.0)
            if ((ends - begins >= MIN_EQUAL_SAMPLES) & (np.maximum(there, back) > MIN_STEP_SHARE * top)).any():
                _refuse(values, marks)


def _refuse(values: np.ndarray, marks: np.ndarray) -> None:
    k = int(np.argmax(marks))
    others = float(np.abs(values[~marks]).max())
    raise RecordError("marks_of_gaps", mark=float(values[k]), n=int(marks.sum()), sample=k + 1, others=others)


def refuse_repeated_line(lines: list[str]) -> None:
    """Raise RecordError where a line of several different numbers stands twice, one below the other: not where the
    motion itself repeats from line to line."""
    twice = [
        k
        for k in range(1, len(lines))
        if lines[k] == lines[k - 1]
        and not lines[k].translate(NUMBER_LETTERS)
        and len(words := lines[k].split()) > 3
        and len(set(words)) == len(words)
    ]
    if twice and len(twice) <= max(1, len(lines) // 20):
        raise RecordError("line_twice", text=quoted(lines[twice[0]]), place=(place("line", n=twice[0] + 1),))


def jumps(values: np.ndarray) -> list[Sentence]:
    """A warning where a smooth record jumps at one place as nowhere around it: lines doubled, swapped or gone?"""
    steps = np.abs(np.diff(values, DIFFERENCE_ORDER))
    if steps.size < 8 * COMPARED_SAMPLES or not steps.any():
        return []
    padded = np.concatenate([steps, np.zeros(-steps.size % JUMP_SAMPLES)])
    blocks = padded.reshape(-1, JUMP_SAMPLES).max(axis=1)
    reach = COMPARED_SAMPLES // JUMP_SAMPLES
    around = np.zeros(blocks.size)
    for shift in range(2, 2 + reach):
        around[shift:] = np.maximum(around[shift:], blocks[:-shift])
        around[:-shift] = np.maximum(around[:-shift], blocks[shift:])
    inside = blocks[reach + 2 : -reach - 2]
    ratio = inside / np.maximum(around[reach + 2 : -reach - 2], 1e-3 * blocks.max())
    if not ratio.size or not ratio.max() > MIN_JUMP_RATIO:
        return []
    k = (int(ratio.argmax()) + reach + 2) * JUMP_SAMPLES
    k += int(steps[k : k + JUMP_SAMPLES].argmax()) + DIFFERENCE_ORDER // 2 + 1
    return [notice("jump", sample=k)]
