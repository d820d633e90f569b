"""Plain text: one column, time and columns, `npts dt` headers, `#` comments, comma or point decimals."""

import itertools
import math
import re
from dataclasses import dataclass, field

import numpy as np

from core.errors import RecordError, place
from core.ground.ground_motion import MIN_STEP
from core.ground.records import plain_head
from core.ground.records.grammar import EMPTY_CELL, NUMBER, Options, Parsed, numbers, quoted, table_of, to_float
from core.ground.records.head_units import refuse_other_quantity, stated_unit, take_unit
from core.ground.records.sample_like import refuse_samples_in_head
from core.text.sentence import notice

_NO_NUMBER = re.compile(rf"(?:{NUMBER}|[+-]?nan|[+-]?inf(?:inity)?|\*++|[,;\s]++)++", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"[+-]?+[0-9]++(,[0-9]++)?+([EeDd][+-]?+[0-9]++)?+")
_ONE = re.compile(NUMBER)
_EMPTY_FIELD = re.compile(r"\t[ ]*\t|^[ ]*\t")
_EXCEL_ERROR = re.compile(r"#(?:N/?[AD]|DIV/0!|VAL\w+!|R[EI]F!|NUM!|N[AO]ME\?|NULL\w*!)", re.IGNORECASE)


MAX_LINE_LETTERS = 20_000
"""Characters of a line of plain text."""

MAX_HEAD = 200
"""Lines of text above the first sample."""

SEPARATORS = ",; \t"
"""What stands between cells: a line of these alone holds no sample."""

FIRST_ROWS = 8
"""Rows read one by one before the rest is tried at once."""


def recognises(lines: list[str]) -> bool:
    return True


def _row(line: str) -> list[float] | None:
    """The numbers of one line under any of the accepted separators, NaN for an empty field; None if it is text.

    Where `;` or tabs separate, each field is judged alone: `12,34` is one number. A comma separates where neither is
    there and the fields have points or are whole. Fields may stand in double quotes.
    """
    if '"' in line:
        if line.count('"') % 2:
            return None
        line = line.replace('","', "\t").replace('"', "")
    if EMPTY_CELL in line or ";" in line or "\t" in line:
        fields = [entry.strip() for entry in re.split(r"[;\t]", line)]
        row = _fields([entry.replace(",", ".") if _DECIMAL_COMMA.fullmatch(entry) else entry for entry in fields])
        if row is not None or "," in line or "" in fields:
            return row
        return numbers(re.sub(r"[;\t]", " ", line))
    if "," not in line:
        return numbers(line)
    fields = [entry.strip() for entry in line.split(",")]
    row = _fields(fields)
    return numbers(line.replace(",", " ")) if row is None and "" not in fields else row


def _fields(fields: list[str]) -> list[float] | None:
    """Read one number a field, NaN for an empty one, the empty ones of the end left out; None where one is text."""
    end = len(fields)
    while end and fields[end - 1] in ("", EMPTY_CELL):
        end -= 1
    fields = fields[:end]
    if not fields or not all(entry in ("", EMPTY_CELL) or _ONE.fullmatch(entry) for entry in fields):
        return None
    row = [math.nan if entry in ("", EMPTY_CELL) else to_float(entry) for entry in fields]
    return None if all(map(math.isnan, row)) and EMPTY_CELL not in fields else row


@dataclass
class _Content:
    """Lines of a file, told apart.

    head : the text above the first sample
    rows : numbers of the samples read one by one
    places : of each sample its line, from 1
    rest : the samples below those, read at once, shape (n, width); None where all are in rows
    head_places : of each line of the head below those the case skips, its number, from 1
    first : the first samples as they are written
    """

    head: list[str]
    rows: list[list[float]]
    places: list[int]
    rest: np.ndarray | None = None
    head_places: list[int] = field(default_factory=list)
    first: list[str] = field(default_factory=list)


def read(lines: list[str], options: Options) -> Parsed:
    """Raises RecordError for spectra, uneven or unsorted time, several columns without a choice,
    and rows that are not numbers."""
    _refuse_spectrum_above(lines, options.skip_lines or 0)
    content = _told_apart(_with_points(lines), options.skip_lines or 0)
    if content.rows:
        above = zip(content.head_places, content.head[options.skip_lines or 0 :], strict=True)
        refuse_samples_in_head(list(above), content.first)
    said = "\n".join(content.head[_end_of_spectrum(lines[: options.skip_lines or 0]) :])
    refuse_other_quantity(said)
    if not content.rows:
        raise RecordError("no_numbers")
    if options.column is not None:
        plain_head.refuse_column(said, len(content.rows[-1]), options.column)
    unit = stated_unit(said)
    declared = _take_count_and_step(content)
    table = _table(content)
    if options.column is None and _is_wrapped(table):
        return _unwrapped(table, options.time_step or (declared[1] if declared else None), unit, content)
    if plain_head.are_components(said, *table.shape) and not _rises(table[:, 0]):
        values, from_time, taken = _component(table, content.places, options)
    else:
        step = options.time_step or (declared[1] if declared else plain_head.first_step(said))
        values, from_time, taken = _columns(table, content.places, options, plain_head.seconds_of_time(said), step)
    if taken != options.column:
        plain_head.refuse_column(said, table.shape[1], taken)
    parsed = Parsed(values, from_time, None, counted=declared is not None)
    take_unit(parsed, unit)
    plain_head.apply_head_statements(parsed, said, declared[1] if declared else None, options.time_step)
    parsed.stated_peak = plain_head.stated_peak(said, parsed.unit or options.unit)
    parsed.told = len(content.head), len(content.places)
    parsed.details = tuple((f"line {k + 1}", text) for k, text in enumerate(content.head[:6]))
    parsed.vertical = plain_head.vertical(said, table.shape[1], taken)
    parsed.standing = plain_head.standing(said, table.shape[1], taken)
    return parsed


_HEAD_OF_SPECTRUM = re.compile(
    r"\s*\"?(?:period|periodo)\b.*\b(?:psa|psv|sd|sa|sv|spectr\w*|spettr\w*)\b", re.IGNORECASE
)
_HEAD_OF_HISTORY = re.compile(r"\s*\"?(?:time|tempo|t)\b.*\bacc", re.IGNORECASE)


def _refuse_spectrum_above(lines: list[str], skip: int) -> None:
    """Raise RecordError where the table of a spectrum stands above that of a history, as exports of programs have
    both: with the lines to skip. skip : that the case skips already"""
    at = next((k for k, line in enumerate(lines[:MAX_HEAD]) if k >= skip and _HEAD_OF_SPECTRUM.match(line)), None)
    if at is None:
        return
    below = next((k for k in range(at + 1, len(lines)) if _HEAD_OF_HISTORY.match(lines[k])), None)
    if below is not None:
        raise RecordError("spectrum_above", skip=below, key="skip_lines", place=(place("line", n=at + 1),))


def _end_of_spectrum(skipped: list[str]) -> int:
    """Number of the lines that are skipped up to the last row of a table of a spectrum among them, 0 without one."""
    if not any(map(_HEAD_OF_SPECTRUM.match, skipped)):
        return 0
    return 1 + max((k for k, line in enumerate(skipped) if _NO_NUMBER.fullmatch(line.strip() or "-")), default=-1)


_LONE_COMMA = re.compile(r"\s*[+-]?[0-9]+,[0-9]+(?:[Ee][+-]?[0-9]+)?\s*")


def _with_points(lines: list[str]) -> list[str]:
    """True minus signs as they are typed; lines of one column with decimal commas with points: where nearly all have
    one comma between digits, and what stands before it does not rise as a time."""
    lines = [line.replace("−", "-") if "−" in line else line for line in lines]
    lone = [line for line in lines if _LONE_COMMA.fullmatch(line)]
    if len(lone) < 20 or len(lone) < 0.8 * sum(1 for line in lines if line.strip()):
        return lines
    before = [float(line.split(",")[0]) for line in lone]
    rising = sum(one < other for one, other in itertools.pairwise(before))
    if rising > 0.5 * len(before):
        return lines
    return [line.replace(",", ".") if _LONE_COMMA.fullmatch(line) else line for line in lines]


def _told_apart(lines: list[str], skip: int) -> _Content:
    """Head and samples of a file, the first `skip` lines head whatever they hold."""
    content = _Content(list(lines[:skip]), [], [])
    head, rows, tried, blank = content.head, content.rows, False, 0
    for k, line in enumerate(lines[skip:], start=skip + 1):
        if len(rows) == FIRST_ROWS and not tried:
            tried = True
            content.rest = _rest(lines[k - 1 :], len(rows[-1]))
            if content.rest is not None:
                break
        if len(line) > MAX_LINE_LETTERS:
            raise RecordError("line_too_long", n=len(line), place=(place("line", n=k),))
        if len(head) > MAX_HEAD:
            raise RecordError("head_too_long", n=MAX_HEAD)
        text = line.strip()
        if not text.strip(SEPARATORS):  # empty cells, which a spreadsheet leaves after the last sample
            blank = blank or (k if _are_samples(rows) else 0)
            continue
        if blank:
            raise RecordError("blank_among_samples", place=(place("line", n=blank),))
        try:
            row = _sample(text, rows)
        except RecordError as error:
            raise error.at(place("line", n=k)) from None
        if row is None:
            head.append(text)
            content.head_places.append(k)
        else:
            rows.append(row)
            content.places.append(k)
            if len(content.first) < FIRST_ROWS:
                content.first.append(text)
    return content


def _rest(lines: list[str], width: int) -> np.ndarray | None:
    """The samples of these lines read at once, shape (n, width); None where they must be read one by one."""
    spaced = any("\t" in line and _EMPTY_FIELD.search(line) for line in lines)
    return None if spaced else table_of(lines, width)


def _are_samples(rows: list[list[float]]) -> bool:
    """Whether these first rows are samples, not a count and a step alone."""
    return len(rows) > 1 or (len(rows) == 1 and not _count_and_step(rows[0]))


def _sample(text: str, above: list[list[float]]) -> list[float] | None:
    """The numbers of a line below these rows; None if it belongs to the head. Raises RecordError."""
    if above and _EXCEL_ERROR.search(text):
        raise RecordError("gap", text=quoted(text))
    if text.startswith(("#", "%", "//", "!")):
        if _are_samples(above):
            raise RecordError("text_among_samples", text=quoted(text))
        return None
    row = _row(text)
    if row is None and (_NO_NUMBER.fullmatch(text) or (above and text == EMPTY_CELL)):
        raise RecordError("gap", text=quoted(text))
    if row and (above or not all(map(math.isnan, row))):
        return row
    if above:
        raise RecordError("not_numbers", text=quoted(text))
    return None


def _take_count_and_step(content: _Content) -> list[float] | None:
    """`npts dt` [-], [s] of the first row, which is then no sample; None where it is one. Raises RecordError."""
    first, *rows = content.rows
    if not _count_and_step(first):
        return None
    n = len(rows) + (0 if content.rest is None else len(content.rest))
    if rows and len(rows[0]) > 2 and (n - 1) * len(rows[0]) < first[0] <= n * len(rows[0]):  # wrapped
        content.rows, content.places = rows, content.places[1:]
        return first
    if abs(n - first[0]) > 1 and not (rows and len(rows[0]) == 1):
        return None
    if n != first[0]:
        raise RecordError("count_differs", n=n, declared=int(first[0]))
    content.rows, content.places = rows, content.places[1:]
    return first


def _table(content: _Content) -> np.ndarray:
    """All samples, shape (n, width), and their places complete. Raises RecordError for rows of another width."""
    width = len(content.rows[0])
    short = width - len(content.rows[-1])
    if width > 2 and short > 0 and content.rest is None and len(content.rows) > FIRST_ROWS:  # where samples are wrapped
        filled = [*content.rows[:-1], [*content.rows[-1], *[math.nan] * short]]
        if all(len(row) == width for row in filled) and _is_wrapped(np.array(filled)):
            return np.array(filled)
    for row, line in zip(content.rows, content.places, strict=True):
        if len(row) != width:
            raise RecordError("columns_differ", n=len(row), above=width, place=(place("line", n=line),))
    table, rest = np.array(content.rows), content.rest
    if rest is None:
        return table
    content.places += range(content.places[-1] + 1, content.places[-1] + 1 + len(rest))
    return np.concatenate([table, rest])


def _is_wrapped(table: np.ndarray) -> bool:
    """Whether the samples of a record stand side by side in rows, shape (n, width) with empty cells at the end alone:
    none of the columns rises, and a sample is as near to the last one of the row above as to its neighbours in its own
    row, nearer than to the sample above it, which components side by side never are."""
    n, width = table.shape
    filled = table.ravel()[: table.size - int(np.isnan(table[-1]).sum())]
    if width < 3 or n < FIRST_ROWS or not np.isfinite(filled).all() or any(_rises(table[:-1, k]) for k in range(width)):
        return False
    whole = table[:-1]
    inside, across = np.abs(np.diff(whole, axis=1)).mean(), np.abs(np.diff(whole, axis=0)).mean()
    joins = np.abs(whole[1:, 0] - whole[:-1, -1]).mean()
    return bool(inside > 0.0 and 0.5 * inside < joins < 1.5 * inside and inside < 0.8 * across)


def _unwrapped(table: np.ndarray, step: float | None, unit, content: _Content) -> Parsed:
    """The record of rows of samples. step : time step that is given or stated [s]. Raises RecordError without one, and
    where the head states another number of samples."""
    values = table.ravel()[: table.size - int(np.isnan(table[-1]).sum())]
    if step is None:
        raise RecordError("wrapped_rows", n=values.size, width=table.shape[1], key="time_step_s")
    parsed = Parsed(values, step, None)
    take_unit(parsed, unit)
    parsed.told = len(content.head), len(content.places)
    parsed.details = tuple((f"line {k + 1}", text) for k, text in enumerate(content.head[:6]))
    parsed.warnings.append(notice("wrapped_rows", n=values.size, width=table.shape[1]))
    return parsed


def _count_and_step(row: list[float]) -> bool:
    """Whether a first row is `npts dt`."""
    return len(row) == 2 and row[0] >= 10 and row[0].is_integer() and 0 < row[1] < 1


def _rises(column: np.ndarray) -> bool:
    """Whether a column may be a time: it rises at nearly all samples."""
    return column.size > 2 and bool(np.mean(np.diff(column) > 0.0) > 0.9)


def _component(table, places, options: Options):
    """Choose the component as `_columns` does, of components side by side without a time column."""
    width = table.shape[1]
    if options.column is None:
        raise RecordError("which_component", n=width)
    if options.column > width:
        raise RecordError("component_out_of_range", given=options.column, most=width)
    return _without_gap(table[:, options.column - 1], places), None, options.column


def _columns(table, places, options: Options, seconds: float, stated: float | None):
    """(the acceleration column, the time step of the time column or None, its number from 1). Columns that are empty
    throughout stay in their places and are none; an empty cell in the one taken is a gap. seconds : of one unit of
    the time column; stated : time step that is given or stated [s]: then a first column that counts is no time."""
    filled = [k for k in range(table.shape[1]) if not np.isnan(table[:, k]).all()]
    if len(filled) == 1:
        if options.column not in (None, 1, filled[0] + 1):
            raise RecordError("one_column", given=options.column)
        values = _without_gap(table[:, filled[0]], places)
        steps = np.diff(values)
        if values.size > 3 and np.ptp(steps) < 1e-6 * steps.max():
            raise RecordError("time_as_acceleration")
        for first in values[:2]:
            if values.size > 20 and first in (values.size - 1, values.size - 2):
                raise RecordError("count_on_top", first=first)
        return values, None, filled[0] + 1
    if options.column is not None and options.column - 1 not in filled[1:]:
        raise RecordError("column_out_of_range", given=options.column, most=filled[-1] + 1)
    if not _rises(table[:, filled[0]]):
        raise RecordError("no_time_column")
    times = _without_gap(table[:, filled[0]], places) * seconds
    if any(_goes_on(times, table[:, k] * seconds) for k in filled[2:]):
        raise RecordError("pairs_in_line")
    if len(filled) > 2 and options.column is None:
        raise RecordError("which_column", n=len(filled), most=filled[-1] + 1)
    taken = options.column or filled[1] + 1
    numbers = table[:, filled[0]]
    if stated and stated != 1.0 and numbers[0] in (0.0, 1.0) and (np.diff(numbers) == 1.0).all():
        return _without_gap(table[:, taken - 1], places), None, taken
    step = _even_step(times, places, options.time_step)
    return _without_gap(table[:, taken - 1], places), step, taken


def _goes_on(times, column) -> bool:
    """Whether a column is the time of the same line's next sample: as even as the times and later than them."""
    later, step = column - times, float(np.median(np.diff(times))) if times.size > 3 else 0.0
    return bool(0.05 * step < later[0] < step and np.ptp(later) <= 0.26 * step)


def _without_gap(values, places):
    """A column without empty cells. Raises RecordError naming the first line that has one."""
    empty = np.isnan(values)
    if empty.any():
        k = int(np.argmax(empty))
        raise RecordError("gap", text="''", place=(place("line", n=places[k]),))
    return values


def _rounding(times: np.ndarray, mean: float) -> np.ndarray:
    """How far each printed time may lie from what it stands for [s], shape of times: half of its last decimal, or of
    its last significant digit, as programs print that keep six of them. mean : of the steps [s]"""
    decimals = next((d for d in range(1, 12) if np.allclose(times, times.round(d), rtol=0, atol=1e-13)), 12)
    least = max(min(0.51 * 10.0**-decimals, 0.25 * abs(mean)), 1e-3 * abs(mean))
    sizes = np.floor(np.log10(np.maximum(np.abs(times), 1e-12)))
    for digits in range(4, 10):
        unit = 10.0 ** (sizes + 1.0 - digits)
        if np.allclose(times / unit, np.round(times / unit), rtol=0, atol=1e-6):
            return np.maximum(least, np.minimum(0.51 * unit, 0.25 * abs(mean)))
    return np.full(times.size, least)


def _even_step(times, places, given: float | None) -> float:
    """Time step of a time column [s]: the shortest number that reproduces every printed time within
    its rounding, or the given one if it does. Raises RecordError naming the first line that fails."""
    if times.size < 3:
        raise RecordError("too_few_samples", n=times.size)
    steps = np.diff(times)
    if (steps <= 0.0).all() or not np.median(steps) > 0.0:
        raise RecordError("no_time_column")
    mean = float((times[-1] - times[0]) / (times.size - 1))
    printed = _rounding(times, mean)
    rounding = float(printed.max())
    index = np.arange(times.size)
    usual = float(np.median(steps))
    # a step that nearly all pairs show and the rest break is a gap, not the rounding of another step
    broken = np.abs(steps - usual) > 1e-6 * usual
    gap = 0 < broken.sum() <= 0.05 * steps.size
    candidates = [given] if given else []
    candidates += [float(f"{usual:.9g}")] if gap else [float(f"{mean:.{d}g}") for d in range(1, 12)]
    candidates += [] if gap else [1.0 / max(1, round(1.0 / mean))] if MIN_STEP < mean < 1 else []
    for dt in candidates:
        if (np.abs(times - times[0] - dt * index) <= printed).all() and (steps >= 0.0).all():
            return dt
    k = int(np.argmax(np.abs(steps - usual) > max(2.0 * rounding, 1e-3 * usual)))
    if (steps < 0.0).any():
        k = int(np.argmax(steps < 0.0))
    elif gap:
        k = int(np.argmax(broken))
    raise RecordError(
        "uneven_times", start=times[k], end=times[k + 1], usual=usual, place=(place("line", n=places[k + 1]),)
    )
