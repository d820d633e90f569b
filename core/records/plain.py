"""Plain text: one column, time and columns, `npts dt` headers, `#` comments, comma or point decimals."""

import re

import numpy as np

from core.errors import RecordError
from core.records.grammar import NUMBER, Options, Parsed, numbers, to_float

_TIME_STEP = re.compile(rf"\bdt\s*=\s*({NUMBER})", re.IGNORECASE)
_UNIT = re.compile(
    r"accel\w*\.?\s*[\[(]\s*(g|mm/s\^?2|mm/s/s|cm/s\^?2|cm/s/s|gal|m/s\^?2|m/s/s)\s*[\])]",
    re.IGNORECASE,
)
_REFUSED = re.compile(r"\b(velocity|displacement|spectrum|spectra|period)\b", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"[+-]?[0-9]+(,[0-9]+)?([EeDd][+-]?[0-9]+)?")
_INTEGER = re.compile(r"[0-9]+")


def recognises(lines: list[str]) -> bool:
    return True


def _row(line: str) -> list[float] | None:
    """The numbers of one line under any of the accepted separators, None if it is text."""
    fields = [entry.strip() for entry in re.split(r"[;\t]", line.strip()) if entry.strip()]
    if "," in line:
        if fields and all(_DECIMAL_COMMA.fullmatch(entry) for entry in fields):
            # one comma in every field and `;` or tab between: decimal commas
            if len(fields) > 1 or ";" in line or "\t" in line:
                return [to_float(entry.replace(",", ".")) for entry in fields]
            parts = [part.strip() for part in line.split(",")]
            return [to_float(part) for part in parts] if len(parts) > 1 else None
        line = line.replace(",", " ")
    return numbers(line.replace(";", " "))


def read(lines: list[str], options: Options) -> Parsed:
    """Raises RecordError for spectra, uneven or unsorted time, several columns without a choice,
    and rows that are not numbers."""
    skip = options.skip_lines or 0
    head, rows, places = list(lines[:skip]), [], []
    for k, line in enumerate(lines[skip:], start=skip + 1):
        text = line.strip()
        if not text:
            continue
        if text.startswith(("#", "%", "//", "!")):
            head.append(text)
            continue
        row = _row(text)
        if row:
            rows.append(row)
            places.append(k)
        elif not rows or (len(rows) == 1 and len(rows[0]) <= 2):
            # a title; a `npts dt` line above it belongs to the head as well
            head.append(text)
            if rows:
                raise RecordError(f"line {k}: {text[:60]!r} is not numbers")
        else:
            raise RecordError(f"line {k}: {text[:60]!r} is not numbers")
    refused = _REFUSED.search("\n".join(head))
    if refused and not _UNIT.search("\n".join(head)):
        raise RecordError(
            f"the header speaks of {refused[1].lower()}: this is not an accelerogram; "
            "take the acceleration file"
        )
    if not rows:
        raise RecordError("no numbers in this file")
    time_step, counted = None, None
    first = rows[0]
    if len(first) == 2 and len(rows) > 2 and first[0] == int(first[0]) >= 10 and 0 < first[1] < 1:
        counted = int(first[0])
        if abs(len(rows) - 1 - counted) <= 1 or len(rows[1]) == 1:
            time_step = first[1]
            rows, places = rows[1:], places[1:]
            if len(rows) != counted:
                raise RecordError(f"{len(rows)} samples, but the header declares {counted}")
    width = len(rows[0])
    for row, place in zip(rows, places, strict=True):
        if len(row) != width:
            raise RecordError(
                f"line {place}: {len(row)} columns, {width} above it; text lines on top can be "
                "passed over with skip_lines"
            )
    table = np.array(rows)
    comment_step = _TIME_STEP.search("\n".join(head))
    if comment_step and time_step is None:
        time_step = to_float(comment_step[1])
    unit = _UNIT.search("\n".join(head))
    word = unit[1].lower().replace("^", "").replace("/s/s", "/s2") if unit else None
    values, from_time = _columns(table, places, options, time_step)
    stated = from_time if time_step is None else time_step
    if from_time is not None and abs(from_time - stated) > 1e-3 * stated:
        raise RecordError(
            f"the header states a time step of {stated:g} s, the time column {from_time:g} s"
        )
    return Parsed(
        values,
        stated,
        "cm/s2" if word == "gal" else word,
        details=tuple((f"line {k + 1}", text) for k, text in enumerate(head[:6])),
    )


def _columns(table, places, options: Options, time_step):
    """The acceleration column and the time step of the time column, if there is one."""
    if table.shape[1] == 1:
        if options.column not in (None, 1):
            raise RecordError(f"column {options.column} asked for, but there is one column")
        values = table[:, 0]
        steps = np.diff(values)
        if values.size > 3 and steps[0] > 0 and np.allclose(steps, steps[0], rtol=1e-6, atol=0):
            raise RecordError("this column grows evenly: it is a time column, not an acceleration")
        return values, None
    if options.column is not None and not 2 <= options.column <= table.shape[1]:
        raise RecordError(
            f"column = {options.column} is not accepted: 2 to {table.shape[1]} (column 1 is time)"
        )
    if table.shape[1] > 2 and options.column is None:
        raise RecordError(
            f"{table.shape[1]} columns: say which holds the acceleration with column = 2 to "
            f"{table.shape[1]} (column 1 is time)"
        )
    return table[:, (options.column or 2) - 1], _even_step(table[:, 0], places)


def _even_step(times, places) -> float:
    """Time step of a time column [s]: every printed time within its own rounding of an even grid.

    Raises RecordError naming the first line that is not.
    """
    if times.size < 3:
        raise RecordError(f"{times.size} samples are too few for a record: at least 10")
    steps = np.diff(times)
    dt = float((times[-1] - times[0]) / (times.size - 1))
    decimals = next(
        (d for d in range(1, 12) if np.allclose(times, times.round(d), rtol=0, atol=1e-13)), 12
    )
    rounding = 0.51 * 10.0**-decimals + 1e-9 * abs(times[-1])
    away = np.abs(times - times[0] - dt * np.arange(times.size))
    if not dt > 0.0 or away.max() > max(rounding, 1e-3 * dt) or (steps < 0.0).any():
        usual = float(np.median(steps))
        k = int(np.argmax(np.abs(steps - usual) > max(2.0 * rounding, 1e-3 * abs(usual))))
        if (steps < 0.0).any():
            k = int(np.argmax(steps < 0.0))
        raise RecordError(
            f"line {places[k + 1]}: the time goes from {times[k]:g} to {times[k + 1]:g} s, "
            f"elsewhere by {usual:g} s: times must be sorted and even, without gaps"
        )
    usual = round_step(float(np.median(steps)))
    even = np.abs(times - times[0] - usual * np.arange(times.size)).max() <= rounding
    return usual if even else round_step(dt)


def round_step(dt: float) -> float:
    """A time step freed of the rounding of subtracted times: 0.00999999999999979 is 0.01 [s]."""
    return float(f"{dt:.9g}")
