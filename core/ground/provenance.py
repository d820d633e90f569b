"""Event, station, date, magnitude and filter of a motion, from what the header of each dialect says."""

from dataclasses import dataclass

import numpy as np

from core.ground.ground_motion import GroundMotion

SEED = 1
"""Seed of the sets of stations that are drawn, the same in every run."""

INTERVAL_SHARE = 0.90
"""Share of the drawn sets within an interval."""

MIN_STATIONS = 3
"""Stations below which nothing is drawn."""


@dataclass(frozen=True)
class Provenance:
    """What a file says of its motion, "" where it says nothing.

    station : with its network
    filter : the corner frequencies [Hz] as written
    processing : as the file names it
    """

    event: str = ""
    station: str = ""
    date: str = ""
    magnitude: str = ""
    distance_km: str = ""
    site_class: str = ""
    filter: str = ""
    processing: str = ""

    @property
    def filter_and_processing(self) -> str:
        return ", ".join(part for part in (self.filter, self.processing) if part)


def provenance(motion: GroundMotion) -> Provenance:
    """Provenance of a motion from its ESM, AFAD or DYNA header, its SIGMA / ITACA one, the second line of its PEER
    file, or the labels that the readers of other dialects give."""
    details = {key.lower(): " ".join(value.split()) for key, value in motion.details}

    def header_value(*keys: str) -> str:
        return next((details[key] for key in keys if details.get(key)), "")

    if header_value("station_code"):
        corners = [header_value("low_cut_frequency_hz"), header_value("high_cut_frequency_hz")]
        return Provenance(
            event=header_value("event_id", "event_name"),
            station=f"{header_value('network')} {header_value('station_code')}".strip(),
            date=f"{header_value('event_date_yyyymmdd')} {header_value('event_time_hhmmss')}".strip(),
            magnitude=_magnitude(header_value("magnitude_w"), header_value("magnitude_l")),
            distance_km=header_value("epicentral_distance_km"),
            site_class=header_value("site_classification_ec8"),
            filter=f"{corners[0]}-{corners[1]} Hz" if any(corners) else "",
            processing=header_value("processing"),
        )
    if header_value("station code / name"):
        corners = header_value("filter cut-off frequency (hz)")
        return Provenance(
            event=header_value("event date & time"),
            station=header_value("station code / name"),
            date=header_value("event date & time"),
            filter=f"{corners} Hz" if corners else "",
        )
    parts = [part.strip() for part in header_value("line 2").split(",")]
    if motion.format.endswith("PEER AT2") and len(parts) >= 3:
        # event, its date in one part or more, station, component
        return Provenance(event=", ".join(parts[:-2]), station=parts[-2], date=_dated(parts[:-2]))
    return Provenance(
        event=header_value("event"),
        station=header_value("station", "station_name"),
        date=header_value("date"),
        magnitude=header_value("magnitude"),
        distance_km=header_value("distance_km"),
        filter=header_value("filter"),
        processing=header_value("processing"),
    )


def _magnitude(moment: str, local: str) -> str:
    return f"Mw {moment}" if moment else f"ML {local}" if local else ""


def _dated(parts: list[str]) -> str:
    """The words with a date in them, as `05/19/40 0439` or `10/18/1989`."""
    words = " ".join(parts).split()
    dates = [k for k, word in enumerate(words) if word.count("/") == 2]
    return " ".join(words[dates[0] :]) if dates else ""


def stations(motions: list[GroundMotion]) -> set[str]:
    """Event and station of each motion: two components of one station are one. A file that names no station
    counts as a station of its own."""
    return {station_of(motion, k) for k, motion in enumerate(motions)}


def station_of(motion: GroundMotion, k: int) -> str:
    """Event and station of the k-th motion of a set."""
    where = provenance(motion)
    return f"{where.event} {where.station}".lower() if where.station else f"file {k}"


def bootstrap_counts(names: list[str], count: int) -> np.ndarray:
    """How often each motion is in each of so many sets of as many stations, drawn from them with replacement and a
    fixed seed (bootstrap, Efron 1979), shape (count, motions): the components of a station go together.

    names : of `station_of`, of each motion
    """
    known = sorted(set(names))
    drawn = np.random.default_rng(SEED).integers(len(known), size=(count, len(known)))
    times = np.array([np.bincount(row, minlength=len(known)) for row in drawn])
    return times[:, [known.index(name) for name in names]]


def unnamed(motions: list[GroundMotion]) -> int:
    """Recorded motions whose file names no station."""
    return sum(not provenance(motion).station for motion in motions if motion.format != "generated")
