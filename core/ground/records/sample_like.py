"""Lines above the samples of a plain text that begin as the samples do: a remark beside them must not make them a head.

A line of a head may begin with numbers (`4000 0.005 NPTS, DT`). It is a sample where its numbers go on from those below
it: the times of its column are those before the first one, or its numbers are written to the very decimals of the
samples.
"""

import re

from core.errors import RecordError, place
from core.ground.records.grammar import NUMBER, quoted, to_float

_MARKS = re.compile(r"^[#%!/*'\s]+")
_BEFORE_NUMBER = re.compile(r"^[\[(]?\s*(?:[^\W\d_]{1,12}\.?\s+)?[\[(]?(?=[+-]?[0-9.])")
_NUMBER = re.compile(NUMBER)
_SAID = re.compile(r"\b(dt|d_t|npts|step|passo|interval\w*|sampl\w*|campion\w*|hz|freq\w*|sec\w*|punti|points)\b", re.I)
"""Words of a head: a line with one states a number of its own."""

MIN_DECIMALS = 3
"""Decimals from which a number is known by their count."""

MIN_ALIKE, MAX_MARK_LETTERS = 3, 8
"""Lines with fewer decimals that are samples together, and letters a mark of a gap has at most."""

MAX_SAMPLES_BACK = 100_000
"""Samples above the first one that a time may stand for."""


def _fields(text: str) -> tuple[list[str], str]:
    """(the numbers a line begins with, as they are written, the text after them); a comma is a decimal one where
    semicolons or tabs separate, and a word or an opening bracket before the first number is passed over."""
    bare = _BEFORE_NUMBER.sub("", _MARKS.sub("", text))
    if ";" in bare or "\t" in bare:
        parts = [one for part in re.split(r"[;\t]", bare) for one in (part.split() or [""])]
    else:
        parts = re.split(r",(?=\s|[^0-9])|\s*,\s*|\s+", bare)
    numbers: list[str] = []
    for k, part in enumerate(parts):
        word = part.strip().strip('"[]()')
        dotted = word.replace(",", ".") if re.fullmatch(r"[+-]?\d+,\d+([eEdD][+-]?\d+)?", word) else word
        if not _NUMBER.fullmatch(dotted):
            return numbers, " ".join(parts[k:]).strip()
        numbers.append(dotted)
    return numbers, ""


def _decimals(number: str) -> tuple[int, bool]:
    """Decimals of a number, and whether it has an exponent."""
    mantissa, *exponent = re.split(r"[eEdD]", number)
    return len(mantissa.partition(".")[2]), bool(exponent)


def refuse_samples_in_head(head: list[tuple[int, str]], samples: list[str]) -> None:
    """Refuse a line of the head that begins as the samples do.

    head : (number, text) of its lines, without those the case says to skip
    samples : the first lines below it
    Raises RecordError with the line.
    """
    below = [_fields(line)[0] for line in samples]
    width = min(map(len, below), default=0)
    if width == 0 or len(below) < 3:
        return
    below = [row[:width] for row in below]
    shapes = {tuple(map(_decimals, row)) for row in below}
    times = [to_float(row[0]) for row in below[:3]]
    step = times[1] - times[0]
    even = width > 1 and step > 0.0 and abs(times[2] - times[1] - step) <= 1e-3 * step
    alike: list[tuple[int, str]] = []
    for number, text in head:
        numbers, words = _fields(text)
        if not numbers:
            continue
        if even:
            back = (times[0] - to_float(numbers[0])) / step
            is_sample = 0.5 < back < MAX_SAMPLES_BACK and abs(back - round(back)) < 0.01 + 1e-9 * abs(back)
            of_time = {shape[0] for shape in shapes}
            is_sample &= _decimals(numbers[0]) in of_time or (to_float(numbers[0]) == 0.0 and len(numbers) >= width)
            # a time alone is one where a mark of a gap follows it: `0.02 n.d.`
            is_sample &= len(numbers) >= width or (
                len(words) < MAX_MARK_LETTERS and not _SAID.search(words) and words != ""
            )
        elif len(numbers) < width or _SAID.search(words):
            is_sample = False
        else:
            shape = tuple(map(_decimals, numbers[:width]))
            is_sample = shape in shapes and shape[-1][0] >= MIN_DECIMALS
            if shape in shapes and not is_sample and words:
                alike.append((number, text))
                is_sample = len(alike) >= MIN_ALIKE
        if is_sample:
            raise RecordError("sample_in_head", text=quoted(text), place=(place("line", n=number),))
