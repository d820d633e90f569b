"""PEER .AT2, old and NGA dialects, and the tab matrix `acceleration, dt, npts`."""

import re

from core.errors import RecordError
from core.ground.records.channels import is_vertical
from core.ground.records.grammar import NUMBER, Options, Parsed, block, numbers, to_count, to_float
from core.ground.records.head_units import refuse_other_quantity, stated_unit, take_unit
from core.text.sentence import notice

_KEYED = re.compile(rf"NPTS\s*+=\s*+(\d++)\s*+,?\s*+DT\s*+=\s*+({NUMBER})(?![\w.])", re.IGNORECASE)
_TRAILING = re.compile(rf"^\s*+(\d++)\s++({NUMBER})\s++NPTS", re.IGNORECASE)
_NOT_ACCELERATION = re.compile(r"\b(VELOCITY|DISPLACEMENT)\b", re.IGNORECASE)
_SCALE = re.compile(rf"scale factor\s*=\s*({NUMBER})", re.IGNORECASE)


def _header(lines: list[str]) -> tuple[int, int, float] | None:
    """Line of the head that states the count and the time step [s], and both."""
    for k, line in enumerate(lines[:12]):
        match = _KEYED.search(line) or _TRAILING.search(line)
        if match:
            return k, to_count(match[1]), to_float(match[2])
    return None


def recognises(lines: list[str]) -> bool:
    return _header(lines) is not None


def read(lines: list[str], options: Options) -> Parsed:
    """Raises RecordError for velocity, displacement, and counts that do not agree."""
    stated = _header(lines)
    assert stated is not None
    row, declared, time_step = stated
    head = lines[: row + 1]
    other = _NOT_ACCELERATION.search(" ".join(head))
    if other:
        raise RecordError("peer_quantity", quantity=other[1].lower())
    refuse_other_quantity("\n".join(line for line in head[2:] if re.search(r"\bunits?\b", line, re.I)))
    if any(_KEYED.search(line) or _TRAILING.search(line) for line in lines[row + 1 :]):
        raise RecordError("second_header")
    parsed = block(lines[row + 1 :], row + 2, declared)
    parsed.time_step = time_step
    take_unit(parsed, stated_unit("\n".join(head)))
    parsed.details = tuple((f"line {k + 1}", line.strip()) for k, line in enumerate(head[:-1]))
    component = head[1].rpartition(",")[2].split() if len(head) > 1 else []
    parsed.vertical = bool(component) and is_vertical(component[0])
    scaled = _SCALE.search("\n".join(head))
    if scaled:
        parsed.warnings.append(notice("already_scaled", factor=scaled[1]))
    return parsed


def recognises_matrix(lines: list[str]) -> bool:
    try:
        rows = [numbers(line) or [] for line in lines[:4]]
    except RecordError:
        return False
    return (
        len(rows) == 4
        and all(len(row) == 3 for row in rows)
        and 0.0 < rows[0][1] < 1.0
        and rows[0][2] > 10
        and rows[0][2].is_integer()
        and all(row[1:] == [0.0, 0.0] for row in rows[1:])
    )


def read_matrix(lines: list[str], options: Options) -> Parsed:
    """First column acceleration, time step and count beside the first sample; the unit is not said."""
    first = numbers(lines[0])
    assert first is not None
    _, time_step, declared = first
    column = [line.split()[0] if line.split() else "" for line in lines]
    parsed = block(column, 1, int(declared))
    parsed.time_step = time_step
    return parsed
