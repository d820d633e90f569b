"""Are the records compatible with the target spectrum? NTC 2018 3.2.3.6 and EN 1998-1 3.2.3.1.2."""

from dataclasses import dataclass

import numpy as np

from core.demand import DemandResult
from core.ground_motion import GroundMotion
from core.spectrum import HOUSNER_PERIODS, pseudo_acceleration_spectrum
from core.units import G

RANGE = (0.15, 2.0)
"""Periods of the rules [s]: a rigid block has no period T that could narrow them."""

LOWER = {"artificial": -0.10, "simulated": -0.20, "natural": -0.10}
UPPER = {"natural": 0.30}
"""Mean 5 % spectrum against the target (NTC 2018 3.2.3.6)."""

LEAST_RECORDS = 3
STRONG_PART, WHOLE_LENGTH = 10.0, 25.0
"""Pseudo-stationary part and total duration of artificial motions [s]."""


@dataclass(frozen=True)
class Rule:
    """One rule: code (NTC, EN or shown), clause, name, value, limit, passed (None: shown only); unit of
    both: %, g, s or empty."""

    code: str
    clause: str
    name: str
    value: float
    limit: float | None
    unit: str
    passed: bool | None


@dataclass(frozen=True)
class Compliance:
    """The set against its target. periods [s]; spectra : S_a of each record at the demand [m/s2], FC
    apart, shape (records, periods); mean, target [m/s2]; stations : counted once each; compatible : by
    the code of the spectrum."""

    periods: np.ndarray
    spectra: np.ndarray
    mean: np.ndarray
    target: np.ndarray
    rules: tuple[Rule, ...]
    stations: int
    compatible: bool


def station_of(motion: GroundMotion) -> str | None:
    """What the file says of event and station, without the component; None where it says nothing."""
    details = dict(motion.details)
    if details.get("STATION_CODE"):
        event = details.get("EVENT_ID") or details.get("EVENT_NAME", "")
        return f"{event} {details.get('NETWORK', '')} {details['STATION_CODE']}".strip()
    if motion.format == "PEER AT2" and "," in details.get("line 2", ""):
        return details["line 2"].rsplit(",", 1)[0].strip()
    for key in ("STATION", "Station", "station", "station_name"):
        if details.get(key):
            return details[key]
    return None


def strong_duration(motion: GroundMotion) -> float:
    """Time [s] the power of a motion, smoothed over 2 s, is at least a fifth of its largest."""
    size = max(1, round(2.0 / motion.time_step))
    power = np.convolve(motion.acceleration**2, np.full(size, 1.0 / size), "same")
    return float(np.count_nonzero(power >= 0.2 * power.max()) * motion.time_step)


def compliance(
    motions: list[GroundMotion], kinds: list[str], demand: DemandResult
) -> Compliance | None:
    """The rules one by one; None without records or without a target spectrum."""
    if not motions or demand.target is None:
        return None
    factors = [demand.scaling(motion) for motion in motions]
    spectra = np.array(
        [
            factor * pseudo_acceleration_spectrum(m.acceleration, m.time_step, HOUSNER_PERIODS)
            for m, factor in zip(motions, factors, strict=True)
        ]
    )
    mean = spectra.mean(axis=0)
    target = demand.target.acceleration(HOUSNER_PERIODS)
    difference = mean / target - 1.0
    inside = (RANGE[0] - 1e-9 <= HOUSNER_PERIODS) & (RANGE[1] + 1e-9 >= HOUSNER_PERIODS)
    low, high = float(difference[inside].min()), float(difference[inside].max())
    stations = {station_of(m) or f"file {k}" for k, m in enumerate(motions)}
    count = float(len(stations))
    pga = float(np.mean([f * m.pga for m, f in zip(motions, factors, strict=True)]))
    lower = max(LOWER[kind] for kind in kinds)
    upper = UPPER["natural"] if "natural" in kinds else None
    ntc = "NTC 2018 3.2.3.6"
    en = "EN 1998-1 3.2.3.1.2"
    rules = [
        Rule("NTC", ntc, "mean_lower", low, lower, "%", low >= lower),
        Rule("NTC", ntc, "mean_upper", high, upper, "%", None if upper is None else high <= upper),
        Rule("EN", en + "(4)a", "records", count, LEAST_RECORDS, "", count >= LEAST_RECORDS),
        Rule("EN", en + "(4)b", "mean_pga", pga / G, demand.pga / G, "g",
             pga >= demand.pga * (1.0 - 1e-6)),
        Rule("EN", en + "(4)c", "mean_lower", low, -0.10, "%", low >= -0.10),
    ]  # fmt: skip
    made = [m for m, kind in zip(motions, kinds, strict=True) if kind == "artificial"]
    if made:
        strong = min(strong_duration(motion) for motion in made)
        whole = min(motion.duration for motion in made)
        rules += [
            Rule("both", f"{ntc}, {en}(3)", "strong_part", strong, STRONG_PART, "s",
                 strong >= STRONG_PART - 1e-6),
            Rule("NTC", ntc, "duration", whole, WHOLE_LENGTH, "s", whole >= WHOLE_LENGTH - 1e-6),
        ]  # fmt: skip
    rules += [
        Rule("shown", "0.1-2.5 s", "mean_lower", float(difference.min()), None, "%", None),
        Rule("shown", "0.1-2.5 s", "mean_upper", float(difference.max()), None, "%", None),
    ]
    asked = demand.asked.spectrum  # a spectrum of a file names no code: both must be met
    codes = {"EN", "NTC"} if asked is None else {asked.code[:-4]}
    decides = [rule.passed for rule in rules if rule.code in (*codes, "both")]
    return Compliance(
        HOUSNER_PERIODS, spectra, mean, target, tuple(rules), len(stations),
        all(passed is not False for passed in decides),
    )  # fmt: skip
