"""Formats of national networks: NSMN (Turkey, the old portal), UNAM (Mexico), CSMNC (China), BHRC (Iran).

Described by public readers and files, none of whose code is here: resources/docs/record_formats.md."""

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
    fixed_width,
    numbers,
    one_number,
    quoted,
    table_of,
    to_count,
    to_float,
    whole,
)
from core.text.sentence import Sentence, notice

_NSMN = re.compile(r"\s*STRONG GROUND MOTION RECORDS OF TURKIYE", re.IGNORECASE)
_NSMN_COLUMNS = re.compile(r"\s*N-S\s+E-W\s+U-D\s*$")
_NSMN_PEAKS = re.compile(rf"\(N-S\)\s*({NUMBER})\s*\(E-W\)\s*({NUMBER})\s*\(U-D\)\s*({NUMBER})")

_UNAM = re.compile(r"ARCHIVO ESTANDAR DE ACELERACION", re.IGNORECASE)
_UNAM_DATA = re.compile(r"DATOS DE ACELERACION", re.IGNORECASE)
_RULE = re.compile(r"[-+]{20,}\s*$")
UNAM_WIDTH, UNAM_HEAD = 10, 200

_CSMNC = re.compile(r"\s*(UN)?CORRECTED\s+(ACC+ELERATION|VELOCITY|DISPLACEMENT)\s+UNIT:\s*(\S+)", re.IGNORECASE)
_CSMNC_POINTS = re.compile(
    rf"\s*NO\. OF POINTS:\s*(\d{{1,8}})\s+EQUALLY SPACED INTERVALS OF:\s*({NUMBER})\s*SEC", re.IGNORECASE
)
_CSMNC_PEAK = re.compile(rf"\s*PEAK VALUE:\s*({NUMBER})\s+AT\s+({NUMBER})\s*SEC", re.IGNORECASE)
_CSMNC_COMPONENT = re.compile(r"\s*COMP\.\s*(\S+)", re.IGNORECASE)
CSMNC_HEAD = 40

_BHRC = re.compile(r"\*\s*VOL(\w+)\s+FILE:", re.IGNORECASE)
_BHRC_POINTS = re.compile(rf"\s*NO\. OF POINTS =\s*(\d{{1,8}})\s+DURATION =\s*({NUMBER})", re.IGNORECASE)
BHRC_TEXTS, BHRC_RATE, BHRC_DATA, BHRC_WIDTH = 13, 21, 27, 13
"""BHRC_TEXTS: lines of text of a channel. BHRC_RATE: its line from 0 whose first real is the rate. BHRC_DATA: that of
the first sample. BHRC_WIDTH: width of a sample."""

TENTH_OF_G = 0.1


def _labels(lines: list[str]) -> dict[str, str]:
    """Label -> value of the lines of a head."""
    split_lines = (line[:300].partition(":") for line in lines)
    return {label.strip(): value.strip() for label, mark, value in split_lines if mark and label.strip()}


def recognises_nsmn(lines: list[str]) -> bool:
    return any(_NSMN.match(line[:200]) for line in lines[:3])


def read_nsmn(lines: list[str], options: Options) -> Parsed:
    """`LABEL : value` lines, then three columns N-S, E-W, U-D in gal. Raw. Raises RecordError."""
    start = next((k + 1 for k, line in enumerate(lines[:60]) if _NSMN_COLUMNS.match(line)), None)
    if start is None:
        raise RecordError("head_lacks", label="N-S E-W U-D")
    head = _labels(lines[:start])
    step = one_number(head.get("SAMPLING INTERVAL (sec)", ""), "SAMPLING INTERVAL (sec)")
    declared = one_number(head.get("NUMBER OF DATA", ""), "NUMBER OF DATA")
    said = next((key for key in head if key.startswith("RAW PGA VALUES")), "")
    if "gal" not in said.lower():
        raise RecordError("head_lacks", label="RAW PGA VALUES (gal)")
    peaks = _NSMN_PEAKS.search(head[said])
    table = table_of(lines[start:], 3)
    if table is None:
        raise RecordError("columns_not", n=3)
    if len(table) != declared:
        raise RecordError("count_differs", n=len(table), declared=round(declared))
    details = (
        ("event", head.get("PLACE", "")),
        ("station", head.get("STATION ID", "")),
        ("date", head.get("EARTHQUAKE DATE", "")),
        ("magnitude", head.get("EARTHQUAKE MAGNITUDE", "")),
        ("processing", "none"),
    )

    def column(k: int) -> Parsed:
        peak = to_float(peaks[k + 1]) if peaks else None
        return _channel(table[:, k], step, peak, details, start)

    names = ("N-S", "E-W", "U-D")
    return chosen([Channel(name, name == "U-D", partial(column, k)) for k, name in enumerate(names)], options)


def _channel(
    values, step: float, peak: float | None, details, first: int, warnings: tuple[Sentence, ...] = ()
) -> Parsed:
    """Read one column [cm/s2] of a table whose count was checked, raw. first : lines above it"""
    parsed = Parsed(np.asarray(values), step, "cm/s2", counted=True, details=details, told=(first, len(values)))
    check_peak(parsed, peak)
    parsed.warnings += [*warnings, notice("unprocessed")]
    return parsed


def recognises_unam(lines: list[str]) -> bool:
    return any(_UNAM.match(line[:200]) for line in lines[:12])


def read_unam(lines: list[str], options: Options) -> Parsed:
    """The standard file of accelerations of the Instituto de Ingenieria, version 2: labels, then as many columns of
    ten characters as it has channels, in gal, in the order of ORIENTACION. Raises RecordError."""
    place = next((k for k, line in enumerate(lines[:UNAM_HEAD]) if _UNAM_DATA.match(line)), None)
    if place is None:
        raise RecordError("head_lacks", label="DATOS DE ACELERACION")
    head = _labels(lines[:place])
    rules = [k for k in range(place + 1, min(place + 12, len(lines))) if _RULE.match(lines[k])]
    if len(rules) < 2:
        raise RecordError("head_lacks", label="DATOS DE ACELERACION")
    names, step, most, peaks = _unam_channels(head)
    table = [fixed_width(line, UNAM_WIDTH) for line in lines[rules[1] + 1 :] if line.strip()]
    if any(row is None or len(row) != len(names) for row in table):
        raise RecordError("columns_not", n=len(names))
    warnings: tuple[Sentence, ...] = ()
    if len(table) > most and all(row == table[most - 1] for row in table[most:]):
        warnings, table = (notice("surplus_dropped", count=len(table) - most),), table[:most]
    if len(table) != most:
        raise RecordError("count_differs", n=len(table), declared=most)
    values = np.array(table)
    details = (
        ("event", head.get("MAGNITUD(ES)", "").strip("/ ")),
        ("station", head.get("CLAVE DE LA ESTACION", "")),
        ("date", head.get("FECHA DEL SISMO [GMT]", "")),
        ("processing", "none"),
    )

    def column(k: int) -> Parsed:
        peak = peaks[k] if len(peaks) == len(names) else None
        return _channel(values[:, k], step, peak, details, rules[1] + 1, warnings)

    return chosen([Channel(name, is_vertical(name), partial(column, k)) for k, name in enumerate(names)], options)


def _unam_channels(head: dict[str, str]) -> tuple[list[str], float, int, list[float]]:
    """(names of the channels, step [s], count of samples, peaks [gal]) by the labels of a head, one step and one count
    for all. Raises RecordError."""

    def listed(label: str) -> list[str]:
        said = next((value for key, value in head.items() if key.startswith(label)), "")
        return [part.strip() for part in said.split("/") if part.strip()]

    def numbers_of(label: str) -> list[float]:
        return [one_number(text, label) for text in listed(label)]

    unit = head.get("UNIDADES DE LOS DATOS", "")
    if not unit.lower().startswith("gal"):
        raise RecordError("unit_not_acceleration", unit=quoted(unit))
    if head.get("FACTOR DE DECIMACION", "1") not in ("1", "1.0", ""):
        raise RecordError("head_lacks", label="FACTOR DE DECIMACION 1")
    names = listed("ORIENTACION C1-C6")
    steps, counts = numbers_of("INTERVALO DE MUESTREO, C1-C6"), numbers_of("NUM. TOTAL DE MUESTRAS, C1-C6")
    if not names or len(set(names)) != len(names) or not len(names) == len(steps) == len(counts):
        raise RecordError("head_lacks", label="ORIENTACION, INTERVALO DE MUESTREO, NUM. TOTAL DE MUESTRAS")
    if len(set(counts)) != 1 or not (counts[0] >= 1 and counts[0].is_integer()):
        raise RecordError("head_lacks", label="NUM. TOTAL DE MUESTRAS")
    rates = numbers_of("VEL. DE MUESTREO, C1-C6")
    if len(set(steps)) != 1 or any(abs(rate * steps[0] - 1.0) > 1e-3 for rate in rates):
        raise RecordError("head_lacks", label="INTERVALO DE MUESTREO, VEL. DE MUESTREO")
    return names, steps[0], int(counts[0]), numbers_of("ACEL. MAX.(Gal), C1-C6")


def recognises_csmnc(lines: list[str]) -> bool:
    head = lines[:CSMNC_HEAD]
    return any(_CSMNC.match(line[:200]) for line in head) and any(_CSMNC_POINTS.match(line[:200]) for line in head)


def read_csmnc(lines: list[str], options: Options) -> Parsed:
    """Read one component in cm/s2, eight samples in a line. Raises RecordError for velocities and displacements."""
    said = next(match for line in lines[:CSMNC_HEAD] if (match := _CSMNC.match(line[:200])))
    matches = ((k, _CSMNC_POINTS.match(line)) for k, line in enumerate(lines[:CSMNC_HEAD]))
    place, points = next((k, match) for k, match in matches if match)
    if not said[2].upper().startswith("ACC"):
        raise RecordError("peer_quantity", quantity=said[2].lower())
    if said[3].upper() not in ("CM/SEC/SEC", "GAL"):
        raise RecordError("unit_not_acceleration", unit=quoted(said[3]))
    start = next((k for k in range(place + 1, min(place + 12, len(lines))) if numbers(lines[k])), len(lines))
    parsed = whole(block(lines[start:], start + 1, to_count(points[1])))
    head = lines[:start]
    peak = next((match for line in head if (match := _CSMNC_PEAK.match(line))), None)
    component = next((match[1] for line in head if (match := _CSMNC_COMPONENT.match(line))), "")
    parsed.time_step, parsed.unit = to_float(points[2]), "cm/s2"
    parsed.peak_time = to_float(peak[2]) if peak else None
    check_peak(parsed, to_float(peak[1]) if peak else None)
    parsed.channel, parsed.vertical = component, is_vertical(component)
    labels = _labels(head)
    standing = labels.get("OBSERVING POINT", "")
    if standing and not standing.upper().startswith(("G", "FREE")):
        parsed.warnings.append(notice("in_structure", words=quoted(standing)))
    if said[1]:
        parsed.warnings.append(notice("unprocessed"))
    titled = [line.strip() for line in head[1:4]]
    parsed.details = (
        ("event", titled[1] if len(titled) > 1 else ""),
        ("station", labels.get("STATION", "").split(" ")[0]),
        ("component", component),
        ("processing", "none" if said[1] else "corrected"),
    )
    return parsed


def recognises_bhrc(lines: list[str]) -> bool:
    return bool(lines and _BHRC.match(lines[0][:100]))


def read_bhrc(lines: list[str], options: Options) -> Parsed:
    """VOL1DS: channels L, V and T of ten samples a line in g/10, without times. Raw.
    Raises RecordError, for any other volume as well."""
    places = [k for k, line in enumerate(lines) if _BHRC.match(line[:100])]
    channels = []
    for k, place in enumerate(places):
        volume = _BHRC.match(lines[place])
        if volume and volume[1].upper() != "1DS":
            raise RecordError("bhrc_volume", volume=quoted(volume[1]))
        end = places[k + 1] if k + 1 < len(places) else len(lines)
        head = lines[place : place + BHRC_TEXTS]
        name = next((line.split()[1] for line in head if line.startswith("COMP") and len(line.split()) > 1), str(k + 1))
        channels.append(Channel(name, name[:1].upper() == "V", partial(_bhrc_channel, lines, place, end)))
    return chosen(channels, options)


def _bhrc_channel(lines: list[str], place: int, end: int) -> Parsed:
    head = lines[place : place + BHRC_TEXTS]
    points = next((match for line in head if (match := _BHRC_POINTS.match(line))), None)
    tenths = any("SECONDS AND G/10" in line.upper() for line in head)
    rate = numbers(lines[place + BHRC_RATE][:BHRC_WIDTH]) if place + BHRC_RATE < end else None
    if points is None or not tenths or not rate or not rate[0] > 0.0:
        raise RecordError("head_lacks", label="NO. OF POINTS, G/10")
    declared, duration = to_count(points[1]), to_float(points[2])
    if abs(declared / rate[0] - duration) > 2.0 / rate[0] + 1e-3:
        raise RecordError("head_lacks", label="DURATION")
    while end > place and not lines[end - 1].strip("/& \t"):
        end -= 1
    parsed = whole(block(lines[place + BHRC_DATA : end], place + BHRC_DATA + 1, declared, BHRC_WIDTH))
    parsed.values, parsed.time_step, parsed.unit = parsed.values * TENTH_OF_G, 1.0 / rate[0], "g"
    parsed.warnings.append(notice("unprocessed"))
    where = next((line for line in head if "Station" in line), "")
    parsed.details = (
        ("event", next((line.strip() for line in head if line.startswith("Epicenter")), "")),
        ("station", where.split("Station")[0].strip()),
        ("date", _labels(head).get("Origin Time", "")),
        ("processing", "none"),
    )
    return parsed
