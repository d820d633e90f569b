"""GeoNet V1A and V2A (New Zealand): blocks of one component, mm/s2, ten fields of eight."""

import math
import re
from functools import partial

from core.errors import RecordError
from core.ground.records.channels import Channel, chosen, is_vertical
from core.ground.records.grammar import NUMBER, Options, Parsed, block, check_peak, to_float, whole
from core.ground.records.placement import structure_words
from core.text.sentence import notice

_BEGIN = re.compile(r"(Unc|C)orrected accelerogram ")
_POINTS = re.compile(r"Number of points +(\d{1,9})\b")
_RAW_STEP = re.compile(rf"in units of ({NUMBER}) mm/s/s +at intervals of ({NUMBER}) s\b")
_TIME_STEP = re.compile(rf"data at ({NUMBER}) sec intervals")
_DURATION = re.compile(rf"Duration +({NUMBER}) s")
_PEAK = re.compile(rf"Acceleration: +[Pp]eak +({NUMBER}) mm/s/s")
_CORNER = re.compile(rf"filter transition bands are .{{0,40}}?Hz and ({NUMBER})-", re.IGNORECASE)
_FILTER = re.compile(r"filter transition bands are (.*?)\s*$", re.MULTILINE)
_MAGNITUDE = re.compile(r"\bM(w?) +([0-9.]+)")
_DISTANCE = re.compile(r"\bDist +([0-9]+)km")
TEXT_LINES, DATA_LINE = 16, 26
"""Lines of text of a block, and the line from 0 at which its samples begin."""

ROW, FIELD_WIDTH = 10, 8


def recognises(lines: list[str]) -> bool:
    head = "\n".join(lines[:TEXT_LINES])
    return bool(_BEGIN.match(head) and _POINTS.search(head))


def read(lines: list[str], options: Options) -> Parsed:
    """The acceleration of one component. Raises RecordError."""
    places = [k for k, line in enumerate(lines) if _BEGIN.match(line)]
    channels = []
    for k, place in enumerate(places):
        head = "\n".join(line[:200] for line in lines[place : place + TEXT_LINES])
        component = re.search(r"^Component +(\S+)", head, re.MULTILINE)
        name = component[1] if component else str(k + 1)
        end = places[k + 1] if k + 1 < len(places) else len(lines)
        channels.append(Channel(name, is_vertical(name), partial(_component, lines, place, end, head)))
    return chosen(channels, options)


def _component(lines: list[str], place: int, end: int, head: str) -> Parsed:
    points, raw, step = _POINTS.search(head), _RAW_STEP.search(head), _TIME_STEP.search(head)
    stated = raw[2] if raw else step and step[1]
    if not points or not stated:
        raise RecordError("head_lacks", label="Number of points, intervals")
    if raw and to_float(raw[1]) != 1.0:
        raise RecordError("unit_not_acceleration", unit=f"{raw[1][:20]} mm/s/s")
    declared = int(points[1])
    rows = math.ceil(declared / ROW)
    start = place + DATA_LINE
    kinds = 1 if raw else 3  # velocity and displacement follow
    filled = sum(1 for line in lines[start:end] if line.strip())
    if filled != kinds * rows:
        raise RecordError("rows_differ", n=filled, declared=kinds * rows)
    parsed = whole(block(lines[start : start + rows], start + 1, declared, FIELD_WIDTH))
    parsed.time_step = to_float(stated)
    parsed.unit = "mm/s2"
    parsed.standing = structure_words(head.splitlines(), "")
    duration = _DURATION.search(head)
    covered = parsed.time_step * declared
    if duration and abs(to_float(duration[1]) - covered) > max(0.02 * covered, 1.0):
        raise RecordError("head_lacks", label="Duration")
    peak = _PEAK.search(head)
    check_peak(parsed, to_float(peak[1]) if peak else None)
    corner = _CORNER.search(head)
    parsed.corner = to_float(corner[1]) if corner else None
    if raw:
        parsed.warnings.append(notice("unprocessed"))
    titles = head.splitlines()
    site = titles[1].split() if len(titles) > 1 else []
    magnitude, distance, filtered = (_MAGNITUDE.search(head), _DISTANCE.search(head), _FILTER.search(head))
    parsed.details = (
        ("event", titles[7].strip() if len(titles) > 7 else ""),
        ("station", site[1] if len(site) > 1 else ""),
        ("date", titles[7].strip() if len(titles) > 7 else ""),
        ("magnitude", f"M{magnitude[1]} {magnitude[2]}" if magnitude else ""),
        ("distance_km", distance[1] if distance else ""),
        ("filter", filtered[1] if filtered else ""),
        ("processing", "none" if raw else "corrected"),
    )
    return parsed
