"""What the head of plain text says of its samples, in the words such heads use: time step, count, units, direction."""

import re
from collections.abc import Iterator

from core.errors import RecordError
from core.ground.records.channels import is_vertical
from core.ground.records.grammar import (
    NUMBER,
    head_lines,
    refuse_other_quantity,
    stated_unit,
    to_count,
    to_float,
)

_NUMBER = rf"([0-9]+,[0-9]+|{NUMBER})"
_STEP = re.compile(
    r"\b(?:dt|time step|(?:time|sampling) interval|sampling period|passo(?: temporale| di campionamento)?)\b"
    rf"[ \t]*+[(\[]?(ms|s|sec)?[)\]]?[ \t]*+[:=]?[ \t]*+{_NUMBER}[ \t]*+(ms\b)?", re.IGNORECASE,
)  # fmt: skip
_RATE = re.compile(
    r"\b(?:sampl\w{0,6} (?:rate|freq\w{0,6})|frequenza di campionamento)\b[^0-9\n]{0,20}"
    rf"{_NUMBER}[ \t]*+(?:hz|sps)\b", re.IGNORECASE,
)  # fmt: skip
_COUNT = re.compile(
    r"\b(?:npts\b[ \t]*+[:=]?|(?:n(?:umber|o\.|r\.)? of (?:points|samples|data)|numero (?:di )?(?:campioni|punti|dati))"
    r"[ \t]*+[:=])[ \t]*+([0-9]{1,18})(?![\w.,])", re.IGNORECASE,
)  # fmt: skip
_TIME_UNIT = re.compile(
    r"\b(?:time|tempo|t)[ \t]*+[(\[][ \t]*+(ms|msec|min)[ \t]*+[)\]]", re.IGNORECASE
)
_UNIT_NOT_READ = re.compile(
    r"[(\[][ \t]*+((?:ft|in|dm|um|µm|nm)/s(?:ec)?(?:/s(?:ec)?|\^?[2²])|m(?:illi-?)?g|%[ \t]*+g|(?:raw )?counts?|volts?"
    r"|mV)[ \t]*+[)\]]|^#?[ \t]*+(?:units?[ \t]*+[:=][ \t]*+)?((?:raw )?counts)[ \t]*+$", re.IGNORECASE,
)  # fmt: skip
_COMPONENT = re.compile(r"\bcomp(?:onente?|\.)?[ \t]*[:=][ \t]*(\S{1,20})", re.IGNORECASE)


def time_step(head: str) -> float | None:
    """The time step stated, or that of a sampling rate [s]; None where neither is."""
    match = _STEP.search(head)
    if match:
        milli = "ms" in (match[1] or "").lower() or bool(match[3])
        return to_float(match[2].replace(",", ".")) * (0.001 if milli else 1.0)
    match = _RATE.search(head)
    rate = to_float(match[1].replace(",", ".")) if match else 0.0
    return 1.0 / rate if rate > 0.0 else None


def agrees_with_count(head: str, n: int) -> bool:
    """Whether the head declares n samples. Raises RecordError where it declares another number than n or n +- 1."""
    match = _COUNT.search(head)
    if match and abs(to_count(match[1]) - n) > 1:
        raise RecordError("count_differs", n=n, declared=to_count(match[1]))
    return bool(match) and to_count(match[1]) == n


def seconds_of_time(head: str) -> float:
    """Seconds of one unit of the time column: of a head `Time (ms)`, `Time (min)`; else 1."""
    match = _TIME_UNIT.search(head)
    if not match:
        return 1.0
    return 60.0 if match[1].lower() == "min" else 0.001


def refuse_unit_not_read(head: str) -> None:
    """Raise RecordError where the only unit a head states is one that no option names: ft/s2, mg, counts."""
    if stated_unit(head) is not None:
        return
    for line in head_lines(head):
        match = _UNIT_NOT_READ.search(line)
        if match:
            raise RecordError("unit_not_read", unit=match[1] or match[2])


def _named(head: str, width: int, column: int) -> Iterator[str]:
    """What lines of a head write above a column of the table (counted from 1)."""
    for line in head_lines(head):
        for fields, apart in ((re.split(r"[;,\t]", line), True), (re.split(r" {2,}", line.strip()), False),
                              (line.split(), False)):  # fmt: skip
            named = len(fields) >= column if apart else len(fields) == width
            if len(fields) > 1 and named and 1 <= column <= len(fields):
                yield fields[column - 1]


def refuse_column(head: str, width: int, column: int) -> None:
    """Raise RecordError where a head names another quantity above the column that is asked for."""
    for field in _named(head, width, column):
        refuse_other_quantity(field)


def vertical(head: str, width: int, column: int) -> bool:
    """Whether a head names a vertical direction, of the column or of the file."""
    directions = [match[1] for line in head_lines(head) if (match := _COMPONENT.search(line))]
    return any(map(is_vertical, [*directions, *_named(head, width, column)]))
