"""LabVIEW measurement files (.lvm): a head of tags, then a table, which is read as any plain one."""

import re
from dataclasses import dataclass, replace
from functools import partial

from core.errors import RecordError
from core.ground.ground_motion import check_step
from core.ground.records import plain
from core.ground.records.channels import Channel, chosen, is_vertical
from core.ground.records.grammar import Options, Parsed, quoted, to_count, to_float

_BEGIN = re.compile(r"LabVIEW Measurement", re.IGNORECASE)
_ACCELERATION = re.compile(r"g|gal|[cm]?m/s(?:\^?2|²|/s)", re.IGNORECASE)
_END = "***End_of_Header***"
MAX_COLUMNS_READ = 500
"""Channels that are looked at."""


def recognises(lines: list[str]) -> bool:
    return bool(lines and _BEGIN.match(lines[0]))


@dataclass(frozen=True)
class _Segment:
    """What a file holds: names of the columns; rows of cells; places of the channels among the columns and their
    units, "" where the head has none; times of the rows as text; mark : between cells; comma : it is that of decimals;
    options : of the user."""

    names: list[str]
    rows: list[list[str]]
    places: list[int]
    unit_of: dict[int, str]
    times: list[str]
    mark: str
    comma: bool
    options: Options

    def channel(self, place: int) -> Parsed:
        """The samples of one column, as a plain table of two. Raises RecordError."""
        unit, values = self.unit_of[place], [row[place].strip() if place < len(row) else "" for row in self.rows]
        if "" in values:
            raise RecordError("blank_among_samples", text=quoted(self.mark.join(self.rows[values.index("")])))
        made = [f"Time (s)\tAcceleration ({unit})" if unit else "Time (s)\tAcceleration"]
        values = [value.replace(",", ".") for value in values] if self.comma else values
        return plain.read([*made, *map("{}\t{}".format, self.times, values), ""], self.options)


def read(lines: list[str], options: Options) -> Parsed:
    """The channel asked for, with the unit of its head. Raises RecordError for several segments and for times that
    differ from channel to channel."""
    segment, first = _segment(lines, replace(options, channel=None))
    named = [(segment.names[k], partial(segment.channel, k)) for k in segment.places]
    parsed = chosen([Channel(name, is_vertical(name), samples) for name, samples in named], options)
    parsed.told = (first, len(segment.rows))
    return parsed


def _segment(lines: list[str], options: Options) -> tuple[_Segment, int]:
    """The only segment of a file, and how many lines stand above its first row. Raises RecordError."""
    ends = [k for k, line in enumerate(lines) if line.startswith(_END)]
    if len(ends) != 2:
        raise RecordError("lvm_segments", n=max(len(ends) - 1, 0))
    tags = dict(re.split(r"[\t,]", line + "\t", maxsplit=1) for line in lines[1 : ends[0]])
    mark = "," if tags.get("Separator", "Tab").strip("\t, ").lower() == "comma" else "\t"
    comma = tags.get("Decimal_Separator", "").strip("\t ")[:1] == ","
    if comma and mark == ",":
        raise RecordError("lvm_marks")
    cells = [[cell.strip() for cell in line.split(mark)] for line in lines]
    head = {row[0]: row[1:] for row in cells[ends[0] + 1 : ends[1]] if row[0]}
    names, *rows = cells[ends[1] + 1 :] or [[]]
    filled = [k for k, row in enumerate(rows) if any(row)]
    rows = rows[: filled[-1] + 1] if filled else []
    if len(filled) < len(rows):  # a blank line begins another segment
        raise RecordError("lvm_segments", n=2)
    said = (head.get("Channels") or [""])[0]
    many = to_count(said) if said.isascii() and said.isdigit() else 0
    own = tags.get("X_Columns", "One").strip("\t, ").lower()
    places = (
        [2 * k + 1 for k in range(min(many, MAX_COLUMNS_READ))]
        if own == "multi"
        else list(range(1, min(many, MAX_COLUMNS_READ) + 1))
    )
    if not many or any(place >= len(names) for place in places):
        raise RecordError("head_lacks", label="Channels")
    units = head.get("Y_Unit_Label", [])
    unit_of = {place: units[place - 1] if place - 1 < len(units) else "" for place in places}
    if any(map(_ACCELERATION.fullmatch, unit_of.values())):  # forces and voltages beside them are none
        places = [place for place in places if _ACCELERATION.fullmatch(unit_of[place])]
    _agree(head, places, len(rows))
    times = _times(rows, head, own, places, comma)
    return _Segment(names, rows, places, unit_of, times, mark, comma, options), ends[1] + 2


def _agree(head: dict[str, list[str]], places: list[int], n: int) -> None:
    """Raise RecordError where the head counts other rows, packets of as many among them, or its X is no time in
    seconds. places : of the channels; n : rows"""
    for key, accepted in (("X_Dimension", ("", "time")), ("X_Unit_Label", ("", "s", "sec", "second", "seconds"))):
        if other := next((cell for cell in head.get(key, []) if cell.lower() not in accepted), ""):
            raise RecordError("lvm_abscissa", found=quoted(other))
    samples = head.get("Samples", [])
    for place in places:
        said = samples[place - 1] if place - 1 < len(samples) else ""
        if said.isascii() and said.isdigit() and (declared := to_count(said)) and n % declared:
            raise RecordError("count_differs", n=n, declared=declared)


def _times(rows: list[list[str]], head: dict[str, list[str]], own: str, places: list[int], comma: bool) -> list[str]:
    """The time of each row as text: as written, else by X0 and Delta_X, which all channels must share.
    Raises RecordError."""

    def written(text: str) -> str:
        return text.strip().replace(",", ".") if comma else text.strip()

    if own == "no":
        known = [head.get(key, []) for key in ("X0", "Delta_X")]
        said = [[written(values[place - 1]) for place in places if place <= len(values)] for values in known]
        if not all(said):
            raise RecordError("head_lacks", label="Delta_X, X0")
        if any(len(set(values)) > 1 for values in said):
            raise RecordError("lvm_times")
        first, step = (to_float(values[0]) for values in said)
        check_step(step)
        return [repr(first + k * step) for k in range(len(rows))]
    if own == "multi":
        for row in rows:
            if any(written(row[place - 1]) != written(row[0]) for place in places if place < len(row)):
                raise RecordError("lvm_times")
    return [written(row[0]) for row in rows]
