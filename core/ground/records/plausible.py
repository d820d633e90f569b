"""Is it the motion of a ground? What files that were sorted, repeated, cut or turned over on the way look like."""

from collections.abc import Iterator

import numpy as np

from core.errors import RecordError
from core.text.sentence import Sentence, notice

WARNING_CODES = (
    *("repeats", "frozen", "coarse", "clipped", "one_sided_samples", "velocity_left", "rough", "spike"),
    *("late", "pace", "content", "long_step", "peak_elsewhere", "beyond_nyquist"),
)
"""Codes of the warnings given here."""

MIN_SAMPLES = 80
"""Samples below which nothing is told."""

FROZEN, FROZEN_SHARE = 50, 0.02
"""Equal samples in a row, of more than this share of the peak, that no sensor gives within the strong part."""

FILLED = 100
"""Zeros in a row within the strong part: a gap that was filled."""

STRONG = 0.02, 0.98
"""Shares of the sum of the squares between which the strong part lies."""

WINDOW, FINE = (8, 16), 0.5
"""Different samples in a row that no ground repeats: the shorter ones where so many of all samples differ."""

REPEATED_SHARE = 0.05
"""Share of the peak that samples said to be repeated reach."""

TOPS, DROP = 3, 3.0
"""Equal samples in a row at the peak: a sensor at its end, or a trace that was cut, where they stand there so often or
the neighbours are so many steps of the digitiser lower; rounded peaks are natural."""

ONE_SIDED = 0.7
"""(largest + smallest) / (largest - smallest) sample; 0.50 at most on the shelf."""

VELOCITY_LEFT = 0.2
"""Share of its peak that the velocity keeps at the end; 0.08 at most on the shelf but where the mean is not removed."""

MAX_ROUGHNESS, WOVEN = 1.5, 0.8
"""Squared steps over squared samples, 2 of noise, and over squared steps across two samples, 1 of noise and more of two
columns read as one; 1.1 and 0.46 at most on the shelf."""

MIN_LEVELS = 40
"""Values below which the samples are rounded until the motion is lost; 62 at least on the shelf."""

SPIKE, SPIKE_RANK = 4.5, 8
"""Largest second difference over that of this rank; 3.6 at most on the shelf."""

LATE = 0.75
"""Share of the record that passes before half of the squares; 0.60 at most on the shelf."""

SLOWEST, PLAIN_SLOWEST, FASTEST = 0.4, 1.1, 30.0
"""Cycles a second of the strong part by its changes of sign; 1.2 to 23 on the shelf, 0.5 on the clay of Mexico City; in
a plain column, which may be of another quantity, SLOWEST is PLAIN_SLOWEST."""

LOWEST_CONTENT, PLAIN_CONTENT, HIGHEST_CONTENT, BELOW = 1.0, 2.7, 40.0, 0.95
"""Frequency [Hz] below which BELOW of the squared spectrum lies: 2.8 to 38 on the shelf, 1 on the clay of Mexico City,
less of a velocity or of a step ten times too long, more of one ten times too short; in a plain column, which may be of
another quantity, LOWEST_CONTENT is PLAIN_CONTENT."""

LONGEST_STEP = 0.05
"""Time step [s] above which no accelerogram is printed; 0.02 on the shelf, 0.04 of old films."""

MOST_VELOCITY = 0.6
"""Peak velocity over peak acceleration [s] of a plain column; 0.38 at most on the shelf, 0.57 of Chi-Chi's TCU068."""

PEAK_TIME, NEAR_PEAK = 0.1, 0.02
"""How far from the time of the head [s] the peak is looked for, and by which share a sample there may be lower."""


def refuse_sorted(values: np.ndarray) -> None:
    """Raise RecordError where the samples only rise or only fall: a column that was sorted, or no acceleration.
    values : shape (n,)"""
    if values.size < MIN_SAMPLES or not values.any():
        return
    steps = np.diff(values)
    if (steps >= 0.0).all() or (steps <= 0.0).all():
        raise RecordError("sorted_samples", n=values.size)


def doubts(values: np.ndarray, time_step: float, plain: bool = True) -> list[Sentence]:
    """Warnings of samples that are no motion of a ground, though they are numbers.

    values : in the unit of the file, shape (n,)
    time_step : [s]
    plain : a column of which no format says that it is an acceleration
    """
    if values.size < MIN_SAMPLES or not np.abs(values).max() > 0.0:
        return []
    values = values / np.abs(values).max()
    strong = np.searchsorted(np.cumsum(values**2), np.array(STRONG) * np.sum(values**2))
    return [
        *_repeated(values),
        *_held(values, *strong),
        *_one_sided(values),
        *_torn(values),
        *(_pace(values, time_step, plain, *strong) or _content(values, time_step, plain)),
    ]


def misplaced(values: np.ndarray, time_step: float, peak_time: float | None) -> list[Sentence]:
    """A warning where the peak does not stand where the head says. peak_time : from the first sample [s]"""
    if peak_time is None or not np.abs(values).max(initial=0.0) > 0.0:
        return []
    size = np.abs(values)
    reach = max(2.0 * time_step, PEAK_TIME)
    first, last = np.clip(((peak_time - reach) / time_step, (peak_time + reach) / time_step + 2.0), 0, values.size)
    if size[int(first) : int(last)].max(initial=0.0) >= (1.0 - NEAR_PEAK) * size.max():
        return []
    return [notice("peak_elsewhere", stated=peak_time, read=float(size.argmax() * time_step))]


def beyond_nyquist(time_step: float, corner: float | None) -> list[Sentence]:
    """A warning where the head names a filter beyond half the rate of the samples. corner [Hz]"""
    nyquist = 0.5 / time_step
    if corner is None or corner <= 1.02 * nyquist:
        return []
    return [notice("beyond_nyquist", corner=corner, nyquist=nyquist, step=time_step)]


def _repeated(values: np.ndarray) -> Iterator[Sentence]:
    """That a piece of the record stands in it twice."""
    n = WINDOW[0] if np.unique(values).size >= FINE * values.size else WINDOW[1]
    windows, bits = np.lib.stride_tricks.sliding_window_view(values, n), values.view(np.uint64)
    factors = np.random.default_rng(1).integers(1, 2**63, n, dtype=np.uint64)
    marks = np.zeros(bits.size - n + 1, dtype=np.uint64)
    for k in range(n):
        marks += bits[k : bits.size - n + 1 + k] * factors[k]
    order = np.argsort(marks, kind="stable")
    same = np.flatnonzero(marks[order][1:] == marks[order][:-1])
    pairs = np.sort(np.column_stack([order[same], order[same + 1]]), axis=1)
    strong = np.abs(windows[pairs[:, 0]]).max(axis=1) > REPEATED_SHARE
    apart = (np.diff(np.sort(windows[pairs[:, 0]], axis=1), axis=1) > 0.0).all(axis=1)
    pairs = pairs[strong & apart]
    for first, second in pairs[np.argsort(pairs[:, 1], kind="stable")]:
        if (windows[first] == windows[second]).all():
            yield notice("repeats", sample=int(second) + 1, first=int(first) + 1)
            return


def _held(values: np.ndarray, begin: int, end: int) -> Iterator[Sentence]:
    """That samples do not change while the ground moves, or not at the peak. begin, end : of the strong part"""
    begins = np.concatenate([[0], np.flatnonzero(np.diff(values) != 0.0) + 1])
    lengths = np.diff(np.concatenate([begins, [values.size]]))
    size = np.abs(values[begins])
    inside = (begins >= begin) & (begins <= end + FILLED)  # a gap ends the strong part where it begins
    frozen = np.flatnonzero(inside & ((lengths >= FROZEN) & (size > FROZEN_SHARE) | (lengths >= FILLED)))
    if frozen.size:
        k = int(frozen[0])
        yield notice("frozen", n=int(lengths[k]), sample=int(begins[k]) + 1)
    elif np.unique(values).size < MIN_LEVELS:
        yield notice("coarse", n=int(np.unique(values).size))
    elif (tops := np.flatnonzero((size > 1.0 - 1e-9) & (lengths >= TOPS))).size:
        k = int(tops[0])
        apart = np.diff(np.unique(size))
        step = float(apart[apart > 1e-9].min(initial=1.0))
        beside = size[[max(k - 1, 0), min(k + 1, size.size - 1)]].max()
        if tops.size < TOPS and size[k] - beside < DROP * step:
            return
        yield notice("clipped", n=int(lengths[k]), sample=int(begins[k]) + 1)


def _one_sided(values: np.ndarray) -> Iterator[Sentence]:
    """That the motion goes one way, or is left with a velocity."""
    high, low = float(values.max()), float(values.min())
    velocity = np.cumsum(0.5 * (values[1:] + values[:-1]))
    most = float(np.abs(velocity).max())
    left = abs(float(velocity[-1])) / most if most > 0.0 else 0.0
    if abs(high + low) > ONE_SIDED * (high - low):
        yield notice("one_sided_samples", other=max(min(high, -low), 0.0))
    elif left > VELOCITY_LEFT:
        yield notice("velocity_left", share=left)


def _torn(values: np.ndarray) -> Iterator[Sentence]:
    """That neighbours do not belong together: noise, two columns in one, one number with its point out of place."""
    steps = np.sum(np.diff(values) ** 2)
    if steps > MAX_ROUGHNESS * np.sum(values**2) or steps > WOVEN * np.sum((values[2:] - values[:-2]) ** 2):
        yield notice("rough")
        return
    bend = np.abs(np.diff(values, 2))
    if bend.max() > SPIKE * np.partition(bend, -SPIKE_RANK)[-SPIKE_RANK]:
        yield notice("spike", sample=int(bend.argmax()) + 2)


def _pace(values: np.ndarray, time_step: float, plain: bool, begin: int, end: int) -> list[Sentence]:
    """That no ground moves so slowly or fast, or that the end is strongest. begin, end : of the strong part"""
    found = []
    middle = int(np.searchsorted(np.cumsum(values**2), 0.5 * np.sum(values**2)))
    if middle > LATE * values.size:
        found.append(notice("late", share=middle / values.size))
    signs = np.sign(values[begin : end + 1] - values.mean())
    cycles = 0.5 * np.count_nonzero(signs[1:] * signs[:-1] < 0.0) / (max(signs.size - 1, 1) * time_step)
    slowest = PLAIN_SLOWEST if plain else SLOWEST
    if not slowest <= cycles <= FASTEST:
        found.append(notice("pace", cycles=cycles, low=slowest, high=FASTEST))
    return found


def _content(values: np.ndarray, time_step: float, plain: bool) -> list[Sentence]:
    """That the step is none of an accelerogram, or that what is read is another quantity, by the spectrum and by the
    velocity."""
    if time_step > LONGEST_STEP:
        return [notice("long_step", step=time_step, most=LONGEST_STEP)]
    squares = np.cumsum(np.abs(np.fft.rfft(values)) ** 2)
    place = int(np.searchsorted(squares, BELOW * squares[-1]))
    content, least = place / (values.size * time_step), PLAIN_CONTENT if plain else LOWEST_CONTENT
    velocity = time_step * float(np.abs(np.cumsum(0.5 * (values[1:] + values[:-1]))).max())  # of a peak of 1
    if least <= content <= HIGHEST_CONTENT and not (plain and velocity > MOST_VELOCITY):
        return []
    return [notice("content", content=content, low=least, high=HIGHEST_CONTENT, velocity=velocity)]
