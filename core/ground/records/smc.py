"""SMC, the format of the USGS: 11 lines of text, 48 integers, 50 reals, comments, samples in cm/s2."""

import re

from core.errors import RecordError
from core.ground.records.channels import is_vertical
from core.ground.records.grammar import NUMBER, Options, Parsed, block, check_peak, fixed_width, numbers, to_float
from core.text.sentence import notice

_KIND = re.compile(r"\s?([0-9]) ([A-Z]+)")
_PEAK = re.compile(rf"\bpk(?:\s+\w+)?\s*=\s*({NUMBER})")
_WHEN = re.compile(r"\s*([0-9]{4} +[0-9]{1,2} +[0-9]{1,2} +[0-9]{1,6}) (.*)")
_STATION = re.compile(r"station\s*=\s*(.*?)\s*(?:component\s*=\s*(.*?))?\s*$")
TEXT_LINES, INTEGERS, REALS = 11, 6, 10
"""Lines of each part of the head."""

EXTREMES = 28
"""Place from 0 among the reals of the time of the largest sample, that sample, and both of the smallest one."""

FIELD_WIDTHS = (10, 14)
"""Widths of a sample [characters]: eight or five samples in a line."""


def recognises(lines: list[str]) -> bool:
    if len(lines) < TEXT_LINES + INTEGERS + REALS or not _KIND.match(lines[0]):
        return False
    rows = [fixed_width(line, 10) for line in lines[TEXT_LINES : TEXT_LINES + INTEGERS]]
    return all(row is not None and len(row) == 8 for row in rows)


def read(lines: list[str], options: Options) -> Parsed:
    """Raises RecordError for velocities, spectra and counts that do not agree."""
    match = _KIND.match(lines[0])
    assert match is not None
    kind = match[2]
    if kind not in ("CORRECTED", "UNCORRECTED", "UNKNOWN"):
        raise RecordError("peer_quantity", quantity=kind.lower())
    start, declared, rate, reals = _layout(lines)
    width = next((w for w in FIELD_WIDTHS if fixed_width(lines[start], w)), None)
    parsed = block(lines[start:], start + 1, declared, width)
    parsed.time_step = 1.0 / rate
    parsed.unit = "cm/s2" if kind != "UNKNOWN" else None
    head = [line[:500] for line in lines[:TEXT_LINES]]
    peak = _PEAK.search(" ".join(head))
    if parsed.unit:
        check_peak(parsed, to_float(peak[1]) if peak else None)
        parsed.peak_time = _peak_time(reals)
    if kind == "UNCORRECTED":
        parsed.warnings.append(notice("unprocessed"))
    _describe(parsed, head, kind)
    return parsed


def _layout(lines: list[str]) -> tuple[int, int, float, list[float]]:
    """(line of the first sample from 0, count of samples, samples a second, all reals) by the numbers of the head."""
    start = TEXT_LINES + INTEGERS
    integers = [n for line in lines[TEXT_LINES:start] for n in numbers(line) or ()]
    reals = [n for line in lines[start : start + REALS] for n in numbers(line) or ()]
    comments, declared, rate = integers[15], integers[16], reals[1] if len(reals) > 1 else 0.0
    start += REALS
    if not 0 <= comments < len(lines) - start or not 0 < declared < 1e8 or not 0.0 < rate < 1e6:
        raise RecordError("head_lacks", label="SMC, 16, 17, 2")
    start += int(comments)
    if start >= len(lines) or any(line[:1] != "|" for line in lines[start - int(comments) : start]):
        raise RecordError("head_lacks", label="|")
    return start, int(declared), rate, reals


def _peak_time(reals: list[float]) -> float | None:
    """Time [s] of the larger of the two extremes that the reals state; None where they do not."""
    if len(reals) < EXTREMES + 4 or max(map(abs, reals[EXTREMES : EXTREMES + 4])) > 1e30:
        return None
    first, largest, second, smallest = reals[EXTREMES : EXTREMES + 4]
    return first if abs(largest) >= abs(smallest) else second


def _describe(parsed: Parsed, head: list[str], kind: str) -> None:
    """Channel and details by the texts of the head."""
    where = next((match for line in head if (match := _STATION.match(line))), None)
    component = (where[2] or "") if where else ""
    parsed.channel, parsed.vertical = component, is_vertical(component)
    written = _WHEN.match(head[3])
    event, text = (written[2] if written else head[3]).strip(), " ".join(head)
    magnitude = re.search(rf"Moment Mag=\s*({NUMBER})", text)
    distance = re.search(rf"epicentral dist =\s*({NUMBER})", text)
    parsed.details = (
        ("event", "" if event.startswith("*") else event),
        ("station", where[1] if where else ""),
        ("component", component),
        ("date", " ".join(written[1].split()) if written else ""),
        ("magnitude", f"Mw {magnitude[1]}" if magnitude else ""),
        ("distance_km", distance[1] if distance else ""),
        ("processing", "none" if kind == "UNCORRECTED" else ""),
    )
