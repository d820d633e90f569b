"""The section of the records that the program chooses from a folder."""

from dataclasses import MISSING, dataclass

from core.case.keys import choice_key, key, number_key, path_key
from core.codes.target_spectrum import SOILS

MAGNITUDES, DISTANCES, SCALES = (0.0, 10.0), (0.0, 2000.0), (0.01, 100.0)
"""Ranges of what the limits may be; distances in km."""


@dataclass(frozen=True)
class Select:
    """[select]: natural records of a folder, or of a zip, whose mean spectrum is nearest to that of the demand.

    magnitude, distance_km, soil : limits on what the files say of themselves
    """

    folder: str = path_key(MISSING)
    count: int = number_key(1, 30, 7, whole=True)
    scaling: str = choice_key("none", "common", "individual", default="common")
    scale_limits: tuple[float, float] = key("limits", (0.5, 2.0), low=SCALES[0], high=SCALES[1])
    per_station: int = number_key(1, 30, 1, whole=True)
    per_event: int = number_key(1, 30, 2, whole=True)
    magnitude: tuple[float, float] | None = key("limits", low=MAGNITUDES[0], high=MAGNITUDES[1])
    distance_km: tuple[float, float] | None = key("limits", unit="km", low=DISTANCES[0], high=DISTANCES[1])
    soil: str | None = choice_key(*SOILS, default=None)
