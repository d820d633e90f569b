"""Event, station, date, magnitude and filter of a motion, from what the header of each dialect says."""

from dataclasses import dataclass

from core.ground.ground_motion import GroundMotion


@dataclass(frozen=True)
class Provenance:
    """What a file says of its motion, "" where it says nothing. station : with its network; filter : the
    corner frequencies [Hz] as written."""

    event: str = ""
    station: str = ""
    date: str = ""
    magnitude: str = ""
    distance_km: str = ""
    site_class: str = ""
    filter: str = ""


def provenance(motion: GroundMotion) -> Provenance:
    """Of an ESM, AFAD or DYNA header, of a SIGMA / ITACA one, of the second line of a PEER file."""
    details = {key.lower(): " ".join(value.split()) for key, value in motion.details}

    def said(*keys: str) -> str:
        return next((details[key] for key in keys if details.get(key)), "")

    if said("station_code"):
        corners = [said("low_cut_frequency_hz"), said("high_cut_frequency_hz")]
        return Provenance(
            event=said("event_id", "event_name"),
            station=f"{said('network')} {said('station_code')}".strip(),
            date=f"{said('event_date_yyyymmdd')} {said('event_time_hhmmss')}".strip(),
            magnitude=_magnitude(said("magnitude_w"), said("magnitude_l")),
            distance_km=said("epicentral_distance_km"),
            site_class=said("site_classification_ec8"),
            filter=f"{corners[0]}-{corners[1]} Hz" if any(corners) else "",
        )
    if said("station code / name"):
        corners = said("filter cut-off frequency (hz)")
        return Provenance(
            event=said("event date & time"),
            station=said("station code / name"),
            date=said("event date & time"),
            filter=f"{corners} Hz" if corners else "",
        )
    parts = [part.strip() for part in said("line 2").split(",")]
    if motion.format == "PEER AT2" and len(parts) >= 3:
        # event, its date in one part or more, station, component
        return Provenance(event=", ".join(parts[:-2]), station=parts[-2], date=_dated(parts[:-2]))
    return Provenance(station=said("station", "station_name"))


def _magnitude(moment: str, local: str) -> str:
    return f"Mw {moment}" if moment else f"ML {local}" if local else ""


def _dated(parts: list[str]) -> str:
    """The words with a date in them, as `05/19/40 0439` or `10/18/1989`."""
    words = " ".join(parts).split()
    found = [k for k, word in enumerate(words) if word.count("/") == 2]
    return " ".join(words[found[0] :]) if found else ""


def stations(motions: list[GroundMotion]) -> set[str]:
    """Event and station of each motion: two components of one station are one. A file that names no station
    counts as a station of its own."""
    found = set()
    for k, motion in enumerate(motions):
        where = provenance(motion)
        found.add(f"{where.event} {where.station}".lower() if where.station else f"file {k}")
    return found


def unnamed(motions: list[GroundMotion]) -> int:
    """Recorded motions whose file names no station."""
    return sum(not provenance(motion).station for motion in motions if motion.format != "generated")
