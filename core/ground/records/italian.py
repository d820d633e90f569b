"""ESM / ITACA DYNA ASCII (AFAD dialect included) and the SIGMA / ITACA .acc files."""

import re

import numpy as np

from core.errors import RecordError
from core.ground.records.channels import is_vertical
from core.ground.records.grammar import (
    CONTRADICTION,
    UNITS,
    Options,
    Parsed,
    block,
    numbers,
    quoted,
    to_count,
    to_float,
)
from core.text.sentence import notice

RAW = "UNPROCESSED ACCELERATION"
"""DATA_TYPE of ITACA before 2014, beside PROCESSED ACCELERATION."""

_KEY = re.compile(r"^([A-Z][A-Z0-9_/^]*):\s?(.*)$")
_SIGMA_DATA = re.compile(r"^\s*accel\w* time series", re.IGNORECASE)
_ESM_DETAILS = (
    "EVENT_NAME",
    "EVENT_ID",
    "EVENT_DATE_YYYYMMDD",
    "EVENT_TIME_HHMMSS",
    "MAGNITUDE_W",
    "MAGNITUDE_L",
    "NETWORK",
    "STATION_CODE",
    "STREAM",
    "COMPONENT",
    "EPICENTRAL_DISTANCE_KM",
    "SITE_CLASSIFICATION_EC8",
    "LOW_CUT_FREQUENCY_HZ",
    "HIGH_CUT_FREQUENCY_HZ",
    "PROCESSING",
    "DATA_LICENSE",
)


def recognises_esm(lines: list[str]) -> bool:
    keys = [match[1] for line in lines[:80] if (match := _KEY.match(line))]
    return "SAMPLING_INTERVAL_S" in keys and "NDATA" in keys


def read_esm(lines: list[str], options: Options) -> Parsed:
    """KEY: value lines up to the first bare number. Raises RecordError for other than acceleration."""
    header, start = {}, len(lines)
    for k, line in enumerate(lines):
        if numbers(line):
            start = k
            break
        match = _KEY.match(line)
        if match:
            header[match[1]] = match[2].strip()
    kind = header.get("DATA_TYPE", "ACCELERATION").upper()
    if kind not in ("ACCELERATION", "PROCESSED ACCELERATION", RAW):
        raise RecordError("esm_data_type", kind=quoted(kind))
    parsed = block(lines[start:], start + 1, _count(header.get("NDATA", ""), "NDATA"))
    parsed.time_step = _positive(header.get("SAMPLING_INTERVAL_S", ""), "SAMPLING_INTERVAL_S")
    parsed.unit = _unit(header.get("UNITS", ""))
    parsed.stated_peak = _optional(header.get("PGA_CM/S^2", ""))
    parsed.peak_time = _optional(header.get("TIME_PGA_S", ""))
    parsed.corner = _optional(header.get("HIGH_CUT_FREQUENCY_HZ", ""))
    _agree(parsed, header)
    if kind == RAW or header.get("PROCESSING", "").lower().startswith("none"):
        parsed.warnings.append(notice("unprocessed"))
    direction = header.get("COMPONENT") or header.get("STREAM", "")
    parsed.channel, parsed.vertical = direction, direction.upper().endswith(("Z", "UP", "UD"))
    parsed.details = tuple((key, header[key]) for key in _ESM_DETAILS if header.get(key))
    return parsed


def _agree(parsed: Parsed, header: dict[str, str]) -> None:
    """Raise RecordError where UNITS and PGA_CM/S^2, or DURATION_S and the time step, contradict each other."""
    peak = float(np.abs(parsed.values).max()) if parsed.values.size else 0.0
    stated = parsed.stated_peak
    assert parsed.unit is not None and parsed.time_step is not None
    read = peak * UNITS[parsed.unit] / UNITS["cm/s2"]
    if stated and peak and not 1.0 / CONTRADICTION < read / stated < CONTRADICTION:
        raise RecordError("esm_peak", unit=header.get("UNITS", "")[:20], read=read, stated=stated)
    parsed.stated_peak = stated and stated * UNITS["cm/s2"] / UNITS[parsed.unit]
    duration, covered = (_optional(header.get("DURATION_S", "")), parsed.values.size * parsed.time_step)
    if duration and abs(duration - covered) > max(0.02 * covered, 2.0 * parsed.time_step):
        raise RecordError(
            "esm_duration", duration=duration, n=parsed.values.size, step=parsed.time_step, covered=covered
        )


def recognises_sigma(lines: list[str]) -> bool:
    head = "\n".join(lines[:12])
    return "Time Increment (s)" in head and "Number of Data" in head


def read_sigma(lines: list[str], options: Options) -> Parsed:
    """`Label : value` lines, `Accelaration time series in m/s/s`, then five glued fields of 14."""
    header, start = {}, None
    for k, line in enumerate(lines[:20]):
        if _SIGMA_DATA.match(line):
            start = k + 1
            break
        label, _, value = line.partition(":")
        header[label.strip()] = value.strip()
    if start is None:
        raise RecordError("sigma_no_acceleration")
    declared = _count(header.get("Number of Data", ""), "Number of Data")
    parsed = block(lines[start:], start + 1, declared, 14)
    parsed.time_step = _positive(header.get("Time Increment (s)", ""), "Time Increment (s)")
    parsed.unit = _unit(lines[start - 1].split()[-1])
    parsed.stated_peak = _optional(header.get("PGA (m/s/s)", ""))
    parsed.vertical = is_vertical(header.get("Orientation", ""))
    parsed.details = tuple(header.items())
    return parsed


def _unit(text: str) -> str:
    word = text.strip().lower().replace("^", "").replace("m/s/s", "m/s2")
    if word not in ("cm/s2", "m/s2", "mm/s2", "g"):
        raise RecordError("unit_not_acceleration", unit=quoted(text))
    return word


def _count(text: str, label: str) -> int:
    if not re.fullmatch(r"[0-9]+", text.strip()):
        raise RecordError("not_a_count", label=label, text=quoted(text))
    return to_count(text.strip())


def _positive(text: str, label: str) -> float:
    values = numbers(text)
    if not values or len(values) != 1 or not values[0] > 0.0:
        raise RecordError("not_a_time_step", label=label, text=quoted(text))
    return values[0]


def _optional(text: str) -> float | None:
    values = numbers(text)
    return abs(to_float(text.strip())) if values and len(values) == 1 else None
