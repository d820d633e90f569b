"""Volume 1 of CSMIP and RENADIC (Chile): times and samples in g/10 as they were digitised, five pairs in a line."""

import re
from functools import partial

import numpy as np

from core.errors import RecordError
from core.ground.records.california import GRID, PAIRS_A_LINE
from core.ground.records.channels import Channel, chosen, is_vertical
from core.ground.records.grammar import NUMBER, Options, Parsed, block, check_peak, to_count, to_float, whole
from core.ground.records.placement import structure_words
from core.text.sentence import notice

_BEGIN = re.compile(r"\s*UNCORRECTED ACCELEROGRAM DATA\s+PROCESSED", re.IGNORECASE)
_POINTS = re.compile(rf"\s*NO\. OF POINTS =\s*(\d{{1,7}})\s+RECORD LENGTH =\s*({NUMBER})\s*SEC", re.IGNORECASE)
_PEAK = re.compile(rf"SEC AND G/10\.?\s+MAX\s*=\s*({NUMBER})\s*G", re.IGNORECASE)
_CHANNEL = re.compile(r"\s*CHAN\s+(\d{1,3}):\s*(.*?)\s*(?:\(|$)", re.IGNORECASE)
TEXT_LINES, DATA_LINE, FIELD_WIDTH = 13, 27, 7
"""Lines of text of a channel, the line from 0 at which its pairs begin, and the width of a number."""

PEAK_ROUNDING = 0.0006
"""Peaks are printed to three decimals of g."""


def recognises(lines: list[str]) -> bool:
    tenths = any("SEC AND G/10" in line.upper() for line in lines[:TEXT_LINES])
    return bool(lines and _BEGIN.match(lines[0]) and tenths)


def read(lines: list[str], options: Options) -> Parsed:
    """The channel asked for; uneven times are drawn on a grid of 0.001 s, even ones are their own. Raw.
    Raises RecordError."""
    places = [k for k, line in enumerate(lines) if _BEGIN.match(line)]
    channels = []
    for k, place in enumerate(places):
        end = places[k + 1] if k + 1 < len(places) else len(lines)
        head = [line[:200] for line in lines[place : place + TEXT_LINES]]
        match = next((channel for line in head if (channel := _CHANNEL.match(line))), None)
        name = f"{match[1]}: {match[2]}" if match else str(k + 1)
        channels.append(Channel(name, is_vertical(match[2] if match else ""), partial(_pairs, lines, place, end, head)))
    return chosen(channels, options)


def _pairs(lines: list[str], place: int, end: int, head: list[str]) -> Parsed:
    points = next((match for line in head if (match := _POINTS.match(line))), None)
    if points is None or to_count(points[1]) < 3:
        raise RecordError("head_lacks", label="NO. OF POINTS, RECORD LENGTH")
    declared, length = to_count(points[1]), to_float(points[2])
    start = place + DATA_LINE
    end = min(end, start + -(-declared // PAIRS_A_LINE))
    parsed = whole(block(lines[start:end], start + 1, 2 * declared, FIELD_WIDTH))
    times, samples = parsed.values[::2], parsed.values[1::2]
    steps = np.diff(times)
    if times[0] != 0.0 or not (steps > 0.0).all() or steps.max() > 0.1 or not times[-1] < 1000.0:
        raise RecordError("uneven_pairs")
    if abs(times[-1] - length) > max(0.1, 2.0 * steps.max()):
        raise RecordError("uneven_pairs")
    parsed.unit = "g"
    parsed.standing = structure_words(head, "")
    if np.ptp(steps) < 0.1 * GRID:
        parsed.values, parsed.time_step = samples * 0.1, float(round(steps.mean(), 6))
    else:
        grid = np.arange(round(times[-1] / GRID) + 1) * GRID
        parsed.values, parsed.time_step = np.interp(grid, times, samples) * 0.1, GRID
        parsed.warnings.append(notice("drawn_on_grid"))
        parsed.written = samples
    stated = next((match for line in head if (match := _PEAK.search(line))), None)
    peak, read = to_float(stated[1]) if stated else None, float(np.abs(samples).max()) * 0.1
    if peak is not None:
        check_peak(parsed, read if abs(abs(peak) - read) <= PEAK_ROUNDING else peak)
    parsed.warnings.append(notice("unprocessed"))
    titles = [line.strip() for line in head]
    parsed.details = (("event", titles[1]), ("station", titles[5]), ("date", titles[2]), ("processing", "none"))
    return parsed
