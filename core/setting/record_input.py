"""The records of a case, read in order."""

import os
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from core.case.schema import Record
from core.errors import InputError, place
from core.file_names import name_of
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options


class HasRecords(Protocol):
    """A case, study or list: what has [[record]] tables."""

    @property
    def record(self) -> tuple[Record, ...]: ...


def record_options(entry: Record) -> Options:
    """What a record says that its file does not."""
    return Options(entry.unit, entry.time_step_s, entry.column, entry.skip_lines, entry.channel or None)


def read_records(case: HasRecords, base_dir: Path) -> tuple[list[GroundMotion], list[str]]:
    """Records of a case, study or list in order, globs expanded, and their kinds. Raises InputError."""
    motions, kinds, seen = [], [], {}
    for k, entry in enumerate(case.record, start=1):
        if not entry.include:
            continue
        options = record_options(entry)
        try:
            for path in records.expand(entry.file, base_dir):
                file = case_relative_path(path, base_dir, entry.file)
                motion = replace(records.read(path, options, entry.scale), file=file)
                here = (file, motion.channel)
                twin, of_it = seen.setdefault(motion.samples_sha256, here)
                known = [(other.file, other.channel) for other in motions]
                if (twin, of_it) != here or here in known:
                    raise InputError("record_twice", file=file, twin=twin)
                motions.append(motion)
                kinds.append(entry.kind)
        except InputError as error:
            raise error.at(place("record", n=k)) from None
    return _told_apart(motions), kinds


def join_motions(motions: list[GroundMotion], made: list[GroundMotion]) -> list[GroundMotion]:
    """Join the records of a case and the motions generated for it. Raises InputError where a record is one of these."""
    files = {motion.samples_sha256: motion.file for motion in motions}
    for motion in made:
        if (twin := files.get(motion.samples_sha256)) is not None:
            raise InputError("record_twice", file=twin, twin=motion.file)
    return _told_apart([*motions, *made])


def _told_apart(motions: list[GroundMotion]) -> list[GroundMotion]:
    """The motions, all named by file and channel where two have one name: for people, who see no index."""
    if len({motion.name for motion in motions}) == len(motions):
        return motions
    return [replace(m, name=f"{m.file} {m.channel}".strip()) for m in motions]


def case_relative_path(path: Path, base_dir: Path, given: str) -> str:
    """Path of a file as a case of this folder names it: from its folder, absolute where it is so given, by which a
    report says the same wherever its case is run again.

    given : what led to the file in the case
    """
    if Path(name_of(given)).is_absolute():
        return path.as_posix()
    try:
        return Path(os.path.relpath(path, base_dir)).as_posix()
    except ValueError:  # another drive
        return path.as_posix()
