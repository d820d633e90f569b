"""K-NET and KiK-net ASCII (NIED), Taiwan CWA free format: raw counts or gal, one channel or three."""

import re
from functools import partial

import numpy as np

from core.errors import RecordError
from core.ground.records.channels import Channel, chosen, is_vertical
from core.ground.records.grammar import (
    NUMBER,
    Options,
    Parsed,
    block,
    check_peak,
    one_number,
    quoted,
    table_of,
    to_float,
    whole,
)
from core.text.sentence import notice

_LABEL = 18
"""Columns of a K-NET header line before its value."""

_SCALE = re.compile(rf"({NUMBER})\(gal\)/({NUMBER})", re.IGNORECASE)
_RATE = re.compile(rf"({NUMBER})\s*Hz", re.IGNORECASE)
_HEAD_LINES = 30
_CWA_KEY = re.compile(r"#([^:]+):(.*)")
_CWA_PEAK = re.compile(rf"\s*({NUMBER})\s*~\s*({NUMBER})\s*")
_CWA_COLUMN = re.compile(r"([UNEZ])\(\+\)")


def recognises_knet(lines: list[str]) -> bool:
    return any(line.startswith("Sampling Freq(Hz)") for line in lines[:_HEAD_LINES])


def read_knet(lines: list[str], options: Options) -> Parsed:
    """Counts times the scale factor [gal], less their mean, as NIED prints the peak. Raw."""
    header, start = {}, None
    for k, line in enumerate(lines[:_HEAD_LINES]):
        header[line[:_LABEL].strip()] = line[_LABEL:].strip()
        if line.startswith("Memo."):
            start = k + 1
            break
    if start is None:
        raise RecordError("head_lacks", label="Memo.")
    (rate,) = _positive(_RATE.fullmatch(header.get("Sampling Freq(Hz)", "")), "Sampling Freq(Hz)")
    gals, counts = _positive(_SCALE.fullmatch(header.get("Scale Factor", "").replace(" ", "")), "Scale Factor")
    duration = one_number(header.get("Duration Time(s)", ""), "Duration Time(s)")
    declared = duration * rate
    if not 0.0 < declared < 1e8 or declared != round(declared):
        raise RecordError("head_lacks", label="Duration Time(s)")
    parsed = whole(block(lines[start:], start + 1, round(declared)))
    if np.any(parsed.values != np.round(parsed.values)):
        raise RecordError("counts_not_whole")
    gal = parsed.values * (gals / counts)
    parsed.values = gal - gal.mean()
    parsed.time_step, parsed.unit = 1.0 / rate, "cm/s2"
    check_peak(parsed, one_number(header.get("Max. Acc. (gal)", ""), "Max. Acc. (gal)"))
    direction = header.get("Dir.", "")
    parsed.channel = direction
    parsed.vertical = is_vertical(direction) or direction in ("3", "6")
    parsed.warnings.append(notice("unprocessed"))
    if direction in ("1", "2", "3"):  # KiK-net: 1 to 3 at the bottom of the borehole
        parsed.warnings.append(notice("borehole"))
    parsed.details = (
        ("event", header.get("Origin Time", "")),
        ("station", header.get("Station Code", "")),
        ("date", header.get("Record Time", "")),
        ("magnitude", header.get("Mag.", "")),
        ("component", direction),
        ("processing", "none"),
    )
    return parsed


def _positive(match: re.Match[str] | None, label: str) -> list[float]:
    """The numbers of what a label says. Raises RecordError where it says nothing, or one is not above zero."""
    if not match or not all(to_float(part) > 0.0 for part in match.groups()):
        raise RecordError("head_lacks", label=label)
    return [to_float(part) for part in match.groups()]


def recognises_cwa(lines: list[str]) -> bool:
    head = lines[:60]
    return any(line.startswith("#SampleRate(Hz)") for line in head) and any(
        line.startswith("#DataSequence") for line in head
    )


def read_cwa(lines: list[str], options: Options) -> Parsed:
    """`#Key: value` lines, then time and three components, 4F10.3, in gal."""
    header, start = {}, 0
    while start < len(lines) and (lines[start].startswith("#") or not lines[start].strip()):
        match = _CWA_KEY.match(lines[start][:500])
        if match:
            header[match[1].strip()] = match[2].strip()
        start += 1
    rate = one_number(header.get("SampleRate(Hz)", ""), "SampleRate(Hz)")
    names = _CWA_COLUMN.findall(header.get("DataSequence", ""))
    if not rate > 0.0 or not names or len(set(names)) != len(names):
        raise RecordError("head_lacks", label="DataSequence")
    if not header.get("AmplitudeUnit", "").lower().startswith("gal"):
        raise RecordError("unit_not_acceleration", unit=quoted(header.get("AmplitudeUnit", "")))
    width = len(names) + 1
    table = table_of(lines[start:], width)
    if table is None:
        raise RecordError("columns_not", n=width)
    steps = np.diff(table[:, 0])
    if np.abs(steps - 1.0 / rate).max(initial=0.0) > 0.6e-3:
        raise RecordError("head_lacks", label="SampleRate(Hz)")
    length = one_number(header.get("RecordLength(sec)", ""), "RecordLength(sec)")
    if table.shape[0] - round(length * rate) not in (0, 1):  # with or without the end
        raise RecordError("count_differs", n=table.shape[0], declared=round(length * rate))

    def column(k: int) -> Parsed:
        parsed = Parsed(table[:, k + 1], 1.0 / rate, "cm/s2", counted=True)
        peak = _CWA_PEAK.fullmatch(header.get(f"AmplitudeMAX. {names[k]}", ""))
        check_peak(parsed, max(map(abs, map(to_float, peak.groups()))) if peak else None)
        parsed.warnings.append(notice("unprocessed"))
        parsed.details = (
            ("event", next((header[key] for key in header if key.startswith("Origin Time")), "")),
            ("station", header.get("StationCode", "")),
            ("date", next((header[key] for key in header if key.startswith("StartTime")), "")),
            ("magnitude", next((header[key] for key in header if key.startswith("Magnitude")), "")),
            ("component", names[k]),
            ("processing", "none"),
        )
        return parsed

    channels = [Channel(name, name in "UZ", partial(column, k)) for k, name in enumerate(names)]
    return chosen(channels, options)
