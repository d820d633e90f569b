"""The rule of a set of records, and the return period of a limit state."""

import math
from collections.abc import Iterable, Sequence
from statistics import fmean

from core.codes.demand import SeismicDemand
from core.errors import InputError, section
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import station_of

MIN_STATIONS_FOR_MEAN = 7
MIN_STATIONS_FOR_MINIMUM = 3
"""Stations from which a set takes the mean, and from which the most unfavourable (EN 1998-1 4.3.3.4.3(3))."""

MIN_PGA_SHARE = 0.2
"""PGA of a record at the demand over the mean PGA of its set from which its station counts: a record far below the
others hardly moves a wall, yet as a seventh station it would put the mean in the place of the most unfavourable, and
lower that mean. Records of sets that follow a spectrum keep above it."""

EXCEEDANCE = {"SLO": 0.81, "SLD": 0.63, "SLV": 0.10, "SLC": 0.05}
"""P_VR, probability that a limit state's motion is exceeded in V_R (NTC 2018 Tab. 3.2.I)."""

SAME_PERIOD = 0.01
"""T_R of tables are rounded: 475 years for 474.6."""

USUAL_LIVES = (35.0, 50.0, 75.0, 100.0, 150.0, 200.0)
"""V_R = V_N C_U [years] of the classes of NTC 2018 2.4."""

ORDINARY_LIFE = 50.0
"""V_R [years] of ordinary works of class II (NTC 2018 Tab. 2.4.I, 2.4.II)."""


def set_rule(stations: set[str]) -> str:
    """Rule of a set of records from the stations of those that give a number (EN 1998-1 4.3.3.4.3(3)): "mean" of all
    files; below 7 stations "minimum", the most unfavourable file; below 3 "too_few", the same, flagged.

    stations : of `core.ground.provenance.stations`: two components of one station are one
    """
    if len(stations) >= MIN_STATIONS_FOR_MEAN:
        return "mean"
    return "minimum" if len(stations) >= MIN_STATIONS_FOR_MINIMUM else "too_few"


def counted_mask(motions: Sequence[GroundMotion], demand: SeismicDemand) -> list[bool]:
    """Which records count for the rule of their set, by their PGA on the ground at the demand."""
    peaks = [demand.scaling(motion) * (motion.ground_pga or motion.pga) for motion in motions]
    least = MIN_PGA_SHARE * fmean(peaks) if peaks else 0.0
    return [peak >= least for peak in peaks]


def counted_stations(motions: Sequence[GroundMotion], demand: SeismicDemand) -> set[str]:
    """Stations with a record that counts for the rule of the set."""
    return {station_of(motions[k], k) for k, counts in enumerate(counted_mask(motions, demand)) if counts}


def set_capacity(values: Iterable[float | None], rule: str | None) -> float | None:
    """Capacity of a set under its rule, files without a number left out; None where the set is incomplete or has
    none."""
    known = [value for value in values if value is not None]
    if not known or rule in (None, "incomplete"):
        return None
    return fmean(known) if rule == "mean" else min(known)


def return_period(reference_period: float, limit_state: str) -> float:
    """T_R = -V_R / ln(1 - P_VR) [years] (NTC 2018 Eq. 3.2.0); reference_period : V_R = V_N C_U [years]."""
    return -reference_period / math.log1p(-EXCEEDANCE[limit_state])


def check_return_period(state: str, stated: float, own: float | None) -> None:
    """T_R stated [years] must be that of the limit state (NTC 2018 Eq. 3.2.0): `own`, by V_N and C_U, where they
    are given, else not the one that a weaker limit state has in the usual V_R. Raises InputError."""
    if own is not None:
        # the hazard is given from 30 to 2475 years
        if not any(math.isclose(stated, years, rel_tol=SAME_PERIOD) for years in (own, min(max(own, 30.0), 2475.0))):
            raise InputError(
                "return_period_contradicts", stated=stated, own=own, state=state, place=(section("[demand]"),)
            )
        return
    shortest = return_period(USUAL_LIVES[0], state)
    if stated < (1.0 - SAME_PERIOD) * shortest:
        raise InputError(
            "return_period_short",
            stated=stated,
            shortest=shortest,
            state=state,
            life=USUAL_LIVES[0],
            place=(section("[demand]"),),
        )
    states = list(EXCEEDANCE)
    for weaker in states[: states.index(state)]:
        for life in USUAL_LIVES:
            if math.isclose(stated, return_period(life, weaker), rel_tol=SAME_PERIOD):
                raise InputError(
                    "return_period_of_other",
                    stated=stated,
                    weaker=weaker,
                    life=life,
                    state=state,
                    own=return_period(life, state),
                    place=(section("[demand]"),),
                )
