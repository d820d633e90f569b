"""The horizontal records of a folder: what each file says of itself, its spectrum, or why it is left out."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from core.errors import InputError, RecordError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import Provenance, provenance
from core.ground.records import plausible
from core.ground.records.container import names_vertical
from core.ground.records.grammar import Options
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.text.sentence import Key, Sentence

SAME_MOTION = 1e-3
"""Two records whose spectra over their PGA differ nowhere by more are one motion, scaled or printed otherwise."""

DOUBTED = {
    "small_pga",
    "large_pga",
    "offset",
    "jump",
    "peak_differs",
    "partial_last_line",
    "ends_moving",
    *plausible.WARNING_CODES,
}
"""Notices that doubt the samples of a record: a person may know better of one record, a search does not."""

NOT_HORIZONTAL = {"in_structure", "borehole", "vertical"}
"""Notices of records that are no horizontal motion of the ground's surface."""


def is_doubtful(motion: GroundMotion) -> bool:
    """Whether a notice of a record says that its samples are no motion of the ground in the open, or may not be."""
    return any(notice.code in DOUBTED or notice.code in NOT_HORIZONTAL for notice in motion.warnings)


_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_MATCHED = re.compile(r"\bmatched\b", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class Candidate:
    """A horizontal record of a folder, unscaled.

    file : its path; channel : of a file that has several
    said : what the file says of itself
    pga : [m/s2]
    raw : not processed
    spectrum : 5 % pseudo-acceleration at the periods asked for [m/s2], shape (periods,)
    """

    file: Path
    channel: str
    name: str
    file_sha256: str
    samples_sha256: str
    said: Provenance
    pga: float
    raw: bool
    spectrum: np.ndarray

    @property
    def place(self) -> str:
        return f"{self.file.name} {self.channel}".strip()

    @property
    def station(self) -> str:
        """Two components of a recording have one; of a file that names none all channels do."""
        return self.said.station.casefold() or f"file {self.file_sha256}"

    @property
    def event(self) -> str:
        return self.said.event.casefold() or f"of {self.station}"


@dataclass(frozen=True)
class ExcludedRecord:
    """A file, or a channel of one, that is no candidate. reason : of the group "error" """

    file: Path
    channel: str
    reason: Sentence


@dataclass(frozen=True)
class Limits:
    """Limits on what a file has to say of itself; None where nothing is asked. magnitude, distance_km : (least,
    most)"""

    magnitude: tuple[float, float] | None = None
    distance_km: tuple[float, float] | None = None
    soil: str | None = None


def files_in(folder: Path) -> list[Path]:
    """The files below a folder by their names, or the one file it is. Raises InputError."""
    if folder.is_file():
        return [folder]
    if not folder.is_dir():
        raise InputError("no_select_folder", place=(folder,))
    return sorted(path for path in folder.rglob("*") if path.is_file())


def read_file(path: Path, periods: np.ndarray, limits: Limits) -> list[Candidate | ExcludedRecord]:
    """Every record of one file, all channels of it and all members of a zip. periods [s]"""
    results: list[Candidate | ExcludedRecord] = []
    asked: list[str | None] = [None]
    while asked:
        channel = asked.pop(0)
        try:
            results.append(_read(path, channel, periods, limits))
        except RecordError as error:
            if error.code == "which_channel":
                asked = [*error.values["names"], *asked]
            else:
                results.append(ExcludedRecord(path, channel or "", error.without_place))
    return results


def _read(path: Path, channel: str | None, periods: np.ndarray, limits: Limits) -> Candidate:
    """Read one record as a candidate. Raises RecordError where it is none, not horizontal, no recording of the surface
    as it was, or beyond the limits."""
    if names_vertical(channel or path.name):
        raise RecordError("vertical_component")
    motion = records.read(path, replace(Options(), channel=channel))
    notices = {warning.code: warning for warning in motion.warnings}
    if "vertical" in notices:
        raise RecordError("vertical_component")
    if "borehole" in notices:
        raise RecordError("borehole_component")
    if "in_structure" in notices:
        raise RecordError("structure_component", why=notices["in_structure"])
    if any(_MATCHED.search(value) for _, value in motion.details):
        raise RecordError("matched_record")
    for code, why in notices.items():
        if code in DOUBTED:
            raise RecordError("doubted_record", why=why)
    said = provenance(motion)
    _refuse_outside(said, limits)
    spectrum = pseudo_acceleration_spectrum(motion.acceleration, motion.time_step, periods)
    return Candidate(
        path,
        motion.channel,
        motion.name,
        motion.file_sha256,
        motion.samples_sha256,
        said,
        motion.pga,
        "unprocessed" in notices,
        spectrum,
    )


def _refuse_outside(said: Provenance, limits: Limits) -> None:
    """Raise RecordError for a record beyond a limit, or whose file does not say what is limited."""
    for key, text, asked in (
        ("magnitude", said.magnitude, limits.magnitude),
        ("distance_km", said.distance_km, limits.distance_km),
    ):
        if asked is None:
            continue
        number = _NUMBER.search(text)
        if number is None:
            raise RecordError("selected_unsaid", what=Key(key))
        if not asked[0] <= float(number[0]) <= asked[1]:
            raise RecordError("selected_beyond", what=Key(key), found=text)
    if limits.soil is not None:
        if not said.site_class:
            raise RecordError("selected_unsaid", what=Key("soil"))
        if said.site_class[0].upper() != limits.soil:
            raise RecordError("selected_beyond", what=Key("soil"), found=said.site_class)


def drop_duplicate_records(candidates: list[Candidate]) -> tuple[list[Candidate], list[ExcludedRecord]]:
    """Keep one record of each motion: (the records kept by the hash of their samples, those left out). Of one motion
    the first by name stays, whatever its scale; of a recording in both forms the processed one."""
    ordered = sorted(candidates, key=lambda candidate: (str(candidate.file), candidate.channel))
    processed = {(one.station, one.event): one for one in reversed(ordered) if not one.raw}
    kept, left = [], []
    for one in ordered:
        twin = processed.get((one.station, one.event)) if one.raw else None
        if twin is not None:
            left.append(_left_out(one, RecordError("processed_beside", twin=twin.place)))
        else:
            kept.append(one)
    copies = _copies(kept)
    for copy, first in sorted(copies.items()):
        left.append(_left_out(kept[copy], RecordError("same_motion", twin=kept[first].place)))
    kept = [one for k, one in enumerate(kept) if k not in copies]
    return sorted(kept, key=lambda one: one.samples_sha256), left


def _left_out(one: Candidate, error: RecordError) -> ExcludedRecord:
    return ExcludedRecord(one.file, one.channel, error.without_place)


def _copies(candidates: list[Candidate]) -> dict[int, int]:
    """Index of each record that is the motion of an earlier one -> index of that."""
    shapes = np.array([candidate.spectrum / candidate.pga for candidate in candidates])
    order = np.argsort(shapes[:, 0], kind="stable") if candidates else ()
    copies: dict[int, int] = {}
    for place, k in enumerate(order):
        for other in order[place + 1 :]:
            if shapes[other, 0] > shapes[k, 0] * (1.0 + SAME_MOTION):
                break
            if np.abs(shapes[other] / shapes[k] - 1.0).max() <= SAME_MOTION:
                first, second = sorted((int(k), int(other)))
                copies[second] = min(first, copies.get(second, first))
    return copies
