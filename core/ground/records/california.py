"""CSMIP / USGS volumes 1 and 2 (.V1, .V2), COSMOS v01.20 (CESMD V2c included), the USC volume 1 of pairs."""

import re
from functools import partial

import numpy as np

from core.errors import RecordError
from core.ground.records.channels import Channel, chosen, is_vertical
from core.ground.records.grammar import (
    NUMBER,
    UNITS,
    Options,
    Parsed,
    block,
    check_peak,
    numbers,
    quoted,
    to_count,
    to_float,
    whole,
)
from core.ground.records.placement import structure_words
from core.text.sentence import notice

_V2 = re.compile(
    rf"\s*(\d{{1,9}}) points of (acc|vel|dis)\w* data equally spaced at\s+({NUMBER})\s+sec\.?,?\s*"
    r"(?:in units |in |\(units: ?)?(g(?![\w/*^.])|[a-z]+/[a-z/0-9]+)",
    re.IGNORECASE,
)
_V1 = re.compile(
    rf"\s*(\d{{1,9}}) (accel)erogram points at\s+({NUMBER})\s+pts/sec in units of ([a-z/0-9]+)", re.IGNORECASE
)
_COSMOS = re.compile(
    rf"\s*(\d{{1,9}})\s+(accel|veloc|displ)\w* pts, approx\s+({NUMBER})\s+secs, *units= *([a-z/0-9]+)", re.IGNORECASE
)
_OF_DATA = re.compile(r"[a-df-z&]", re.IGNORECASE)
"""A letter that no number has: the samples of a channel end there."""

_FIELD_WIDTH = re.compile(r"\(\s*\d+[fe]([1-9]\d?)\.\d+\s*\)", re.IGNORECASE)
_CHANNEL = re.compile(r"(?:sta )?chan?(?:nel)?:? +(\d{1,3}):? +(.*?)(?: {2,}|\(|$)", re.IGNORECASE)
_STATION_CHANNEL = re.compile(r"sta cha: *(\d{1,3}): *(.*?) *(?:\(|$)", re.IGNORECASE)
_COMPONENT_ALONE = re.compile(r"COMP\s+(\S+)\s*\d*\s*$", re.IGNORECASE)
"""Component of a USC volume 2, on a line of its own."""

_TITLE = re.compile(r"\s*(?:un)?corrected accel|\s*raw accel", re.IGNORECASE)
_PEAK = re.compile(
    rf"(?:peak acceleration|(?<!uncor )\bmax)\s*=\s*({NUMBER})\s*(cms?/sec/sec|cm/sec2|g)\b"
    rf"(?:\s*,?\s*at\s+({NUMBER})\s*sec)?",
    re.IGNORECASE,
)
_UNCORRECTED = re.compile(r"\s*uncorrected accelerogram", re.IGNORECASE)
_INTERVALS = re.compile(rf"equally-spaced intervals of\s+({NUMBER})\s+sec", re.IGNORECASE)
_LENGTH = re.compile(rf"record length\s*=\s*({NUMBER})\s*sec", re.IGNORECASE)
_RAW = re.compile(r"^\s*(?:raw|uncorrected) acceleration", re.IGNORECASE | re.MULTILINE)
_DATE = re.compile(
    r"^(?:Record of|Rcrd of|Origin:) ([A-Z]?[a-z]{0,3} ?[0-9A-Z][^\n(]{5,40}?)(?: {2}|\(|$)", re.MULTILINE
)
_MAGNITUDE = re.compile(rf"\b(Mw|ML|Ms) ?= ?({NUMBER})")
_PAIRS_DATE = re.compile(r"[A-Z]{3,9} [0-9]{1,2}, [0-9]{4}[^\n]{0,10}GMT", re.IGNORECASE)
_FILTER = re.compile(r"(?:filtered (?:with )?)(.*)", re.IGNORECASE)
_BAND = re.compile(
    rf"band-?pass filtered.{{0,60}}?{NUMBER}\s*(?:hz\s*)?(?:and|to)\s*({NUMBER})\s*(?:cyc|hz)", re.IGNORECASE
)
_STATION = re.compile(r"(?:station|statn)\s+no[.:]\s*(\S+)", re.IGNORECASE)
UNITS_OF = {
    "cm/sec2": "cm/s2",
    "cm/sec/sec": "cm/s2",
    "cms/sec/sec": "cm/s2",
    "g": "g",
    "mm/sec2": "mm/s2",
    "m/sec2": "m/s2",
}
"""Units as these files write them."""

MAX_HEAD_LINES = 1000
"""Lines in which the first samples must begin."""

STEP_REAL = 61
"""Place from 0 of the time step [ms] among the real headers of COSMOS."""

STATION_TYPE = 18
"""Place from 0 of the type of the station among the integer headers of COSMOS."""

STATION_TYPES = {
    5: "base of a building",
    10: "building",
    11: "bridge",
    12: "dam",
    13: "wharf",
    14: "tunnel",
    15: "lifeline structure",
    20: "structure",
    50: "geotechnical array",
}
"""Station types that are no free field (COSMOS Tables, table 6)."""

_PAIRS = re.compile(r"FILE\s+\d+ OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:", re.IGNORECASE)
_POINTS = re.compile(r"NO\. OF POINTS =\s*(\d{1,7})\s+DURATION =\s*([0-9]{1,6}\.[0-9]{0,6}) SEC", re.IGNORECASE)
_COMPONENT = re.compile(r"COMP\s+(\S+)", re.IGNORECASE)
PAIRS_A_LINE, GRID = 5, 0.001
"""PAIRS_A_LINE: pairs in a line of volume 1. GRID: step [s] on which all its printed times stand."""


def _data_line(line: str):
    """The line above the samples of a channel, None for any other."""
    if len(line) > 300 or "p" not in line.lower():
        return None
    return _V2.match(line) or _V1.match(line) or _COSMOS.match(line)


def recognises(lines: list[str]) -> bool:
    return any(_data_line(line) for line in lines[:MAX_HEAD_LINES])


def read(lines: list[str], options: Options) -> Parsed:
    """The acceleration of one channel. Raises RecordError."""
    places = [k for k, line in enumerate(lines) if (match := _data_line(line)) and match[2].lower()[:3] == "acc"]
    if not places:
        quantity = next(match[2] for line in lines[:MAX_HEAD_LINES] if (match := _data_line(line)))
        raise RecordError("peer_quantity", quantity={"v": "velocity"}.get(quantity[0].lower(), "displacement"))
    ends = [_end(lines, k + 1) for k in places]
    channels = []
    for k, place in enumerate(places):
        head = [line[:300] for line in lines[ends[k - 1] if k else 0 : place + 1]]
        head = _own(head)
        name = _name(head, k + 1)
        channels.append(Channel(name, is_vertical(name), partial(_channel, lines, place, ends[k], head)))
    return chosen(channels, options)


def _own(head: list[str]) -> list[str]:
    """The head of a channel without the end of the one before: from its first title."""
    titles = [k for k, line in enumerate(head) if _TITLE.match(line)]
    if titles:  # the second line of a volume 2 is a title too
        first = titles[-2] if len(titles) > 1 and titles[-2] == titles[-1] - 1 else titles[-1]
        return head[first:]
    return [line for line in head[-MAX_HEAD_LINES:] if not numbers(line)]


def _end(lines: list[str], start: int) -> int:
    """The line after the samples that begin at this one."""
    for k in range(start, len(lines)):
        if _OF_DATA.search(lines[k]):
            return k
    return len(lines)


def _name(head: list[str], number: int) -> str:
    """Number and direction of a channel, "1: 360 Deg"."""
    for line in head:
        match = _STATION_CHANNEL.match(line) or _CHANNEL.match(line)
        if match:
            return f"{match[1]}: {match[2].strip()}"
    component = next((match[1] for line in head if (match := _COMPONENT_ALONE.match(line))), None)
    return component or str(number)


def _channel(lines: list[str], place: int, end: int, head: list[str]) -> Parsed:
    match = _data_line(lines[place])
    declared, rate, written = to_count(match[1]), to_float(match[3]), match[4].lower()
    if written not in UNITS_OF:
        raise RecordError("unit_not_acceleration", unit=quoted(match[4]))
    width = _FIELD_WIDTH.search(lines[place])
    size = int(width[1]) if width else _width(lines[place + 1] if place + 1 < end else "")
    parsed = whole(block(lines[place + 1 : end], place + 2, declared, size))
    parsed.unit = UNITS_OF[written]
    parsed.standing = structure_words(head, "")
    if _COSMOS.match(lines[place]):
        parsed.standing = parsed.standing or _cosmos_standing(head)
        parsed.time_step = _cosmos_step(head)
        if abs(parsed.time_step * declared - rate) > max(0.02 * rate, 1.0):
            raise RecordError("head_lacks", label="100 Real-header values, 62")
    elif not rate > 0.0:
        raise RecordError("head_lacks", label="sec")
    else:
        parsed.time_step = 1.0 / rate if _V1.match(lines[place]) else rate
    text = "\n".join(head)
    said, length = _INTERVALS.search(text), _LENGTH.search(text)
    step, covered = parsed.time_step, parsed.time_step * declared
    if said and abs(to_float(said[1]) - step) > 1e-6 * step:
        raise RecordError("head_lacks", label="intervals of ... sec")
    raw_length = _COSMOS.match(lines[place])  # of COSMOS it is that of the raw record
    if length and not raw_length and abs(to_float(length[1]) - covered) > max(0.02 * covered, 1.0):
        raise RecordError("head_lacks", label="record length")
    _take_statements(parsed, text)
    raw = bool(_V1.match(lines[place]) or _RAW.search(text) or (head and _UNCORRECTED.match(head[0])))
    if raw:
        parsed.warnings.append(notice("unprocessed"))
    station, filtered, date = _STATION.search(text), _FILTER.search(text), _DATE.search(text)
    magnitude = max(_MAGNITUDE.findall(text), key=lambda one: one[0] == "Mw", default=None)
    titled = [line.strip() for line in head if line.strip() and not (_TITLE.match(line) or numbers(line))]
    parsed.details = (
        (
            "event",
            next(
                (line for line in titled if re.match(r"(?:rcrd|record) of|.*earthquake", line, re.I)),
                titled[0] if titled else "",
            ),
        ),
        ("station", station[1] if station else ""),
        ("date", date[1].strip() if date else ""),
        ("magnitude", " ".join(magnitude) if magnitude else ""),
        ("filter", filtered[1].strip() if filtered else ""),
        ("processing", "none" if raw else "corrected"),
    )
    return parsed


def _width(line: str) -> int:
    """Width of a sample [characters], by a full line of eight; ten where the line is not full."""
    line, row = line.rstrip(), numbers(line[:300])
    return len(line) // 8 if row and len(row) == 8 and len(line) % 8 == 0 else 10


def _take_statements(parsed: Parsed, head: str) -> None:
    """Keep peak, its time and the filter as the head states them. Raises RecordError where the peak contradicts."""
    assert parsed.unit is not None
    peak, band = _PEAK.search(head), _BAND.search(head)
    ratio = UNITS[UNITS_OF[peak[2].lower()]] / UNITS[parsed.unit] if peak else 1.0
    check_peak(parsed, to_float(peak[1]) * ratio if peak else None)
    parsed.peak_time = to_float(peak[3]) if peak and peak[3] else None
    parsed.corner = to_float(band[1]) if band else None


def _cosmos_step(head: list[str]) -> float:
    """Real header 62 [ms] as a time step [s]. Raises RecordError."""
    reals = _values_below(head, "real-header values")
    if len(reals) <= STEP_REAL or not reals[STEP_REAL] > 0.0:
        raise RecordError("head_lacks", label="100 Real-header values, 62")
    return reals[STEP_REAL] / 1000.0


def _cosmos_standing(head: list[str]) -> str:
    """Text of integer header 19 for a station that is in a structure, "" where it is on the ground or the header says
    nothing."""
    integers = _values_below(head, "integer-header values")
    return STATION_TYPES.get(int(integers[STATION_TYPE]), "") if len(integers) > STATION_TYPE else ""


def _values_below(head: list[str], title: str) -> list[float]:
    """The hundred values of COSMOS below the line that names them."""
    said = (k for k, line in enumerate(head) if title in line.lower())
    values: list[float] = []
    for line in head[next(said, len(head)) + 1 :]:
        row = numbers(line)
        if not row or len(values) >= 100:
            break
        values += row
    return values


def recognises_pairs(lines: list[str]) -> bool:
    return bool(lines and _PAIRS.match(lines[0][:200]))


def read_pairs(lines: list[str], options: Options) -> Parsed:
    """Times and samples in G/10 at uneven times printed to 0.001 s: drawn on a grid of 0.001 s the motion, linear
    between samples, is the same. Uncorrected."""
    places = [k for k, line in enumerate(lines) if _PAIRS.match(line[:200])]
    channels = []
    for k, place in enumerate(places):
        end = places[k + 1] if k + 1 < len(places) else len(lines)
        head = "\n".join(line[:200] for line in lines[place : place + 30])
        component = _COMPONENT.search(head)
        name = component[1] if component else str(k + 1)
        reader = partial(_pairs, lines, place, end, head)
        channels.append(Channel(name, is_vertical(name), reader))
    return chosen(channels, options)


def _pairs(lines: list[str], place: int, end: int, head: str) -> Parsed:
    points = _POINTS.search(head)
    if not points or "G/10" not in head:
        raise RecordError("head_lacks", label="NO. OF POINTS, G/10")
    declared = to_count(points[1])
    if declared < 3:
        raise RecordError("head_lacks", label="NO. OF POINTS")
    while end > place and not lines[end - 1].strip("/&- \t"):
        end -= 1
    # the reals of the head look like pairs: counted from the end, in lines of five
    start = max(end - -(-declared // PAIRS_A_LINE), place)
    parsed = whole(block(lines[start:end], start + 1, 2 * declared))
    times, samples = parsed.values[::2], parsed.values[1::2]
    steps = np.diff(times)
    if times[0] != 0.0 or not (steps > 0.0).all() or steps.max() > 0.1:
        raise RecordError("uneven_pairs")
    if not times[-1] < 1000.0 or abs(times[-1] - to_float(points[2])) > 0.1:
        raise RecordError("uneven_pairs")
    grid = np.arange(round(times[-1] / GRID) + 1) * GRID
    parsed.values, parsed.time_step, parsed.unit = np.interp(grid, times, samples) * 0.1, GRID, "g"
    parsed.written = samples
    parsed.warnings += [notice("drawn_on_grid"), notice("unprocessed")]
    component, titled = _COMPONENT.search(head), head.splitlines()
    station = re.search(r"STATION\s+(\S+ \S+)", head, re.IGNORECASE)
    parsed.details = (
        ("event", titled[1][:50].strip() if len(titled) > 1 else ""),
        ("station", station[1].rstrip(",") if station else ""),
        ("date", date[0] if (date := _PAIRS_DATE.search(head)) else ""),
        ("component", component[1] if component else ""),
        ("processing", "none"),
    )
    return parsed
