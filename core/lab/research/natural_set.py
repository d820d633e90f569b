"""A named set of natural records: each by its event, station, component and the SHA-256 of its file, which a folder may
hold under any name. The records are of others, the names can be published."""

import hashlib
import re
from dataclasses import MISSING, dataclass, replace
from pathlib import Path

from core.case.keys import channel_key, choice_key, number_key, path_key, text_key
from core.case.reader import read_toml
from core.case.study_file import tables_key
from core.case.values import parse_section
from core.errors import InputError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.regular_file import read_regular

MAX_BYTES = 50_000_000
"""Bytes up to which a file of a folder is looked at: what is larger is no record."""


@dataclass(frozen=True)
class NamedRecord:
    """[[record]]: a file by its hash, and what it does not say."""

    event: str = text_key(MISSING)
    station: str = text_key(MISSING)
    component: str = text_key(MISSING)
    file: str = path_key(MISSING)
    file_sha256: str = text_key(MISSING)
    unit: str | None = choice_key("g", "m/s2", "cm/s2", "mm/s2", default=None)
    time_step_s: float | None = number_key(1e-5, 0.5, unit="s")
    channel: str = channel_key()

    @property
    def name(self) -> str:
        """Event, station and component."""
        return f"{self.event}, {self.station}, {self.component}"


@dataclass(frozen=True)
class LeftOut:
    """[[left_out]]: a file that was looked at and is not of the set."""

    file: str = path_key(MISSING)
    file_sha256: str = text_key(MISSING)
    reason: str = text_key(MISSING)


@dataclass(frozen=True)
class NaturalSet:
    """A file of [[record]] and [[left_out]] tables."""

    record: tuple[NamedRecord, ...] = tables_key(NamedRecord)
    left_out: tuple[LeftOut, ...] = tables_key(LeftOut)


def read_set(path: Path) -> NaturalSet:
    """The set of a TOML file. Raises InputError."""
    if not path.exists():
        raise InputError("study_no_records", place=(path,))
    table, _ = read_toml(path)
    try:
        found = parse_section(NaturalSet, table, "records", "records")
        for one in (*found.record, *found.left_out):
            if not re.fullmatch("[0-9a-f]{64}", one.file_sha256):
                raise InputError("natural_hash", key="file_sha256", found=one.file_sha256, file=one.file)
        return found
    except InputError as error:
        raise error.at(path) from None


def find(named: NaturalSet, folder: Path) -> tuple[list[tuple[NamedRecord, GroundMotion]], list[NamedRecord]]:
    """The records of a set that a folder holds, in the order of the set, and those that it does not. Raises RecordError
    for a file of the right content that this program does not read."""
    by_hash: dict[str, Path] = {}
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        try:
            by_hash.setdefault(hashlib.sha256(read_regular(path, MAX_BYTES)).hexdigest(), path)
        except OSError:  # too large, or not readable: none of them
            continue
    found = [
        (record, _read(record, by_hash[record.file_sha256])) for record in named.record if record.file_sha256 in by_hash
    ]
    return found, [record for record in named.record if record.file_sha256 not in by_hash]


def _read(one: NamedRecord, path: Path) -> GroundMotion:
    options = Options(one.unit, one.time_step_s, channel=one.channel or None)
    return replace(records.read(path, options), name=one.name)  # without the name of a channel
