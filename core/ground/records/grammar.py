"""What every text format shares: bytes to lines, the strict number grammar, the count check."""

import contextlib
import math
import re
from dataclasses import dataclass, field

import numpy as np

from core.decoding import NoText, decode_text
from core.errors import RecordError, place
from core.text.sentence import Sentence, notice
from core.units import G

NUMBER = r"[+-]?+(?:[0-9]++(?:\.[0-9]*+)?+|\.[0-9]++)(?:[EeDd][+-]?+[0-9]++)?+"
"""A number: plain ASCII, as Fortran and C write it; no nan, inf, underscores or other digits. Possessive, so
that no text makes the match go back and try again: linear time."""

_TOKEN = re.compile(NUMBER)
_NUMBERS_ONLY = re.compile(rf"\s*+(?:{NUMBER}(?=[\s+-]|\Z)\s*+)*+")
_NAN = re.compile(r"[+-]?nan", re.IGNORECASE)

EMPTY_CELL = "∅"
"""An empty cell of a workbook, in its place."""

HEAD_LINE = 500
"""Characters of a line of a header that are looked at."""

MAX_QUOTED = 60
"""Characters of a file repeated in a sentence."""

UNITS = {"g": G, "m/s2": 1.0, "cm/s2": 0.01, "mm/s2": 0.001}
"""Units of acceleration a user may name, in m/s2."""


@dataclass
class Parsed:
    """What a reader found: values in the file's unit, shape (n,); time step [s] and unit, or None where the file does
    not say; details and warnings; counted : the file declares its count of samples; channel : its name, "" where the
    file has none; vertical : its direction is; several : the file has others; factor : (what the samples have still to
    be multiplied by, the error where the case does not), None where the file states none; lines : key of the case ->
    the line of the head that states it, quoted; told : lines above the samples and lines of samples. What a head says
    of the motion, or None: stated_peak in the unit of the samples, peak_time from the first sample [s], corner, the
    upper one of the filter [Hz]. written : the samples of which values are drawn on a grid, else None. standing : words
    of the head of this channel that place its sensor in a structure, "" where it has none, None where the head of the
    file speaks for all."""

    values: np.ndarray
    time_step: float | None
    unit: str | None
    factor: tuple[float, RecordError] | None = None
    lines: dict[str, str] = field(default_factory=dict)
    details: tuple[tuple[str, str], ...] = ()
    warnings: list[Sentence] = field(default_factory=list)
    stated_peak: float | None = None
    peak_time: float | None = None
    corner: float | None = None
    counted: bool = False
    channel: str = ""
    vertical: bool = False
    several: bool = False
    told: tuple[int, int] | None = None
    written: np.ndarray | None = None
    standing: str | None = None


@dataclass(frozen=True)
class Options:
    """Statements of the user on a file, only where the file makes none: unit (a key of UNITS), time_step [s], column
    (counted from 1, time included), skip_lines (text lines on top), channel (its name, or its number from 1)."""

    unit: str | None = None
    time_step: float | None = None
    column: int | None = None
    skip_lines: int | None = None
    channel: str | None = None


def quoted(text: str) -> str:
    """A piece of a file in a sentence: its first characters."""
    text = text.strip()
    return repr(text if len(text) <= MAX_QUOTED else text[:MAX_QUOTED] + "…")


def head_lines(head: str) -> list[str]:
    """Lines of a header, blanks folded: what is looked at of each is short, so that no line takes long."""
    return [re.sub(r"[ \t]{3,}", "  ", line[: 4 * HEAD_LINE])[:HEAD_LINE] for line in head.splitlines()]


def decode(content: bytes) -> list[str]:
    """Lines of a text file. Raises RecordError for a binary file."""
    try:
        return decode_text(content).rstrip("\n").split("\n")
    except NoText:
        raise RecordError("binary_file") from None


GLUED = re.compile(r"(?<=[0-9.])(?=[+-])")
NUMBER_LETTERS = str.maketrans("", "", "0123456789+-.eE \t\n")


def to_float(token: str) -> float:
    """Read one number of the grammar, D exponents included; raises RecordError for another text and beyond the
    doubles."""
    if not _TOKEN.fullmatch(token.strip()):
        raise RecordError("not_numbers", text=quoted(token))
    try:
        value = float(token)
    except ValueError:
        value = float(token.replace("D", "E").replace("d", "e"))
    if not math.isfinite(value):
        raise RecordError("token_too_large", text=quoted(token))
    return value


def to_count(digits: str) -> int:
    """A count as a header writes it; of more digits than any file has samples the first, which agree with no file."""
    return int(digits[:18])


def numbers(line: str) -> list[float] | None:
    """All numbers of a line, also those glued by a sign (`1.0E-08-2.0E-08`); None if anything else is there:
    `1.52.5` is not two numbers."""
    if not line.translate(NUMBER_LETTERS):
        with contextlib.suppress(ValueError):
            row = list(map(float, GLUED.sub(" ", line).split()))
            if row and all(map(math.isfinite, row)):
                return row
    if not _NUMBERS_ONLY.fullmatch(line):
        return None
    return [to_float(token) for token in _TOKEN.findall(line)]


def fixed_width(line: str, width: int) -> list[float] | None:
    """Numbers in columns of this width; None unless every column holds exactly one."""
    line = line.rstrip()
    fields = [line[k : k + width].strip() for k in range(0, len(line), width)]
    if not all(_TOKEN.fullmatch(entry) for entry in fields):
        return None
    return [to_float(entry) for entry in fields]


def _row_or_nan(line: str, width: int | None, number: int) -> list[float]:
    """The numbers of a line, NaN among them. Raises RecordError naming the line where anything else is there."""
    row = _row(line, width)
    if row is None:
        tokens = line.replace(",", " ").split()
        if not all(_NAN.fullmatch(token) or _TOKEN.fullmatch(token) for token in tokens):
            raise RecordError("not_numbers", text=quoted(line), place=(place("line", n=number),))
        row = [math.nan if _NAN.fullmatch(token) else to_float(token) for token in tokens]
    return row


CONTRADICTION = 1.5
"""Ratio of the peak read to the one stated beyond which unit or scale is wrong; less is warned of."""


def check_peak(parsed: Parsed, stated: float | None) -> None:
    """Keep the peak a header states, in the unit of the samples; raise RecordError where they are of another size."""
    parsed.stated_peak = abs(stated) if stated else None
    peak = float(np.abs(parsed.values).max()) if parsed.values.size else 0.0
    if parsed.stated_peak and peak:
        ratio = peak / parsed.stated_peak
        if not 1.0 / CONTRADICTION < ratio < CONTRADICTION:
            raise RecordError("peak_contradicts", read=peak, stated=parsed.stated_peak)


def one_number(text: str, label: str) -> float:
    """The number that a text is. Raises RecordError naming the label."""
    values = numbers(text[:HEAD_LINE])
    if not values or len(values) != 1:
        raise RecordError("not_one_number", label=label, text=quoted(text))
    return values[0]


def whole(parsed: Parsed) -> Parsed:
    """Refuse what `block` only warns of, where the samples depend on one another or end inside the file."""
    if parsed.warnings:
        raise RecordError("not_whole", n=parsed.values.size)
    return parsed


LINES_PER_BLOCK = 50_000
"""Lines whose words are in memory at once."""


def plain_numbers(lines: list[str], count: int | None = None) -> np.ndarray | None:
    """All numbers of lines that hold nothing but numbers with blanks between them, fast; None for all others, which
    are read line by line. count : how many there must be.

    Of these letters alone `float` takes the very numbers of the grammar."""
    glued = count is not None and bool(GLUED.search("\n".join(lines[:50])))
    parts = []
    for k in range(0, len(lines), LINES_PER_BLOCK):
        text = "\n".join(lines[k : k + LINES_PER_BLOCK])
        if text.translate(NUMBER_LETTERS):
            return None
        words = (GLUED.sub(" ", text) if glued else text).split()
        try:
            parts.append(np.fromiter(map(float, words), float, len(words)))
        except ValueError:
            return None
    values = np.concatenate(parts) if parts else np.zeros(0)
    if (count is not None and values.size != count) or not np.isfinite(values).all():
        return None
    return values


def table_of(lines: list[str], width: int) -> np.ndarray | None:
    """Rows of so many numbers with blanks between, all at once, shape (n, width); None where any line is another."""
    end = len(lines)
    while end and not lines[end - 1].strip():
        end -= 1
    if set(map(len, map(str.split, lines[:end]))) != {width}:
        return None
    values = plain_numbers(lines)
    return None if values is None else values.reshape(-1, width)


def _row(line: str, width: int | None) -> list[float] | None:
    """The numbers of a line, in columns of this width where they stand in such; None if anything else is there."""
    row = fixed_width(line, width) if width else None
    return numbers(line) if row is None else row


def block(lines: list[str], first_line: int, declared: int, width: int | None = None) -> Parsed:
    """Samples of a wrapped block with a declared count.

    first_line : number of the block's first line in the file, from 1, for messages.
    Accepts a short last line and surplus zeros or NaN, with a warning; raises RecordError otherwise.
    """
    whole_block = plain_numbers(lines, declared)
    if whole_block is not None and whole_block.size:
        return Parsed(whole_block, None, None, counted=True, told=(first_line - 1, len(lines)))
    odd = (k for k, line in enumerate(lines) if line.translate(NUMBER_LETTERS))
    for k in odd:  # a line that is none is found before the others are read one by one
        _row_or_nan(lines[k], width, first_line + k)
    rows, not_numbers = [], 0
    for k, line in enumerate(lines):
        if line.strip():
            rows.append(_row_or_nan(line, width, first_line + k))
    values = np.array([value for row in rows for value in row])
    while values.size and math.isnan(values[-1]):
        values = values[:-1]
        not_numbers += 1
    if np.isnan(values).any():
        raise RecordError("sample_nan", n=int(np.argmax(np.isnan(values))) + 1)
    warnings = []
    surplus = values[declared:]
    if surplus.any():
        raise RecordError("count_differs", n=values.size, declared=declared)
    if surplus.size or not_numbers:
        warnings.append(notice("surplus_dropped", count=surplus.size + not_numbers))
    values = values[:declared]
    missing = declared - values.size
    if missing:
        widest = max((len(row) for row in rows), default=0)
        if not rows or missing >= widest or not (not_numbers or len(rows[-1]) < widest):
            raise RecordError("fewer_than_declared", n=values.size, declared=declared)
        warnings.append(notice("partial_last_line", found=values.size, declared=declared))
    return Parsed(values, None, None, warnings=warnings, counted=True, told=(first_line - 1, len(rows)))
