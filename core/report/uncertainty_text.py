"""How sure a verdict is, in words and rows: for note, workbook and window alike."""

import math
from collections.abc import Callable
from typing import NamedTuple

from core.codes.collapse_rate import MIN_REPORTED_SHARE, StateRate
from core.codes.risk import Risk
from core.known import require_value
from core.report.verdict_words import names_in
from core.study.results import StudyResult, WallResult, WallVerdict
from core.text.sentence import Number, format_number, sentence, word
from core.units import G
from core.variation.swings import Sensitivity, Swing, TargetValue, describe_swing_end

Say = Callable[..., str]
"""Says a text of the group "report"."""


class MovedInputRow(NamedTuple):
    """A row of the moves. name : of the input; ends : (what it is moved to, zeta, whether it is surely satisfied)"""

    name: str
    ends: list[tuple[str, float | None, bool]]


def verdict_of(result: StudyResult, wall: WallResult) -> WallVerdict | None:
    """The verdict a result decides, None of any other hinge."""
    return next((verdict for verdict in result.verdicts if result.walls[verdict.governing] is wall), None)


def risk_of(result: StudyResult, wall: WallResult) -> Risk | None:
    """Risk of a wall, the least of all its hinges, where this result decides about it; else that of this hinge."""
    verdict = verdict_of(result, wall)
    if verdict is not None:
        return verdict.risk
    return wall.required_assessment.risk if wall.assessment else None


def has_certainty(result: StudyResult) -> bool:
    """Whether the site has a hazard, or inputs were moved."""
    return any(verdict.rates or verdict.sensitivity for verdict in result.verdicts)


def interval_line(say: Say, verdict: WallVerdict, language: str) -> str:
    """Sentence on what another sample of records would give; "" without an interval."""
    interval = verdict.interval
    if interval is None:
        return ""
    values = {
        "n": interval.stations,
        "low": format_number(interval.low, ".2f", language),
        "high": format_number(interval.high, ".2f", language),
    }
    if interval.open_end:
        return say(
            "With {n} other stations of the same kind ζ_E lies above {low} in 19 of 20 cases (bootstrap).", **values
        )
    return say(
        "With {n} other stations of the same kind ζ_E lies between {low} and {high} in nine of ten cases (bootstrap).",
        **values,
    )


def moved_rows(sensitivity: Sensitivity, language: str) -> list[MovedInputRow]:
    """The inputs that move zeta, the one that moves it most first."""
    return [
        MovedInputRow(
            swing_name(swing, language),
            [(describe_swing_end(swing, end).text(language), end.zeta, end.sure) for end in swing.ends],
        )
        for swing in sensitivity.swings
    ]


def swing_name(swing: Swing, language: str) -> str:
    """Name by which the report calls an input that is moved."""
    return word(f"key_{swing.key}", language)


def sensitivity_remarks(say: Say, result: StudyResult, verdict: WallVerdict, language: str) -> list[str]:
    """Sentences with which the moves are to be read: whether the verdict is one, the inputs that do not move zeta,
    those that cannot be moved so."""
    sensitivity, lines = require_value(verdict.sensitivity), []
    code = result.walls[verdict.governing].required_assessment.verdict.code
    if code in ("indicative", "undetermined"):
        lines.append(say("The verdict is indicative, and so are these values: none of them verifies the wall."))
    if sensitivity.still:
        lines.append(
            say("Without effect on ζ: {names}.", names=", ".join(word(f"key_{k}", language) for k in sensitivity.still))
        )
    for key, error in sensitivity.refused:
        why = error.text(language, names_in(language))
        lines.append(say("Not moved, {name}: {why}", name=word(f"key_{key}", language), why=why))
    return lines


REACH_FORMATS = {"thickness_m": (100.0, 1), "tie_kn_m": (1.0, 2), "ag_g": (1.0, 3)}
"""Key -> what its value is multiplied with for the unit of its words, and its decimals."""


def reach_written(key: str, value: float | None, language: str) -> str:
    """A value of what is turned round in its unit, rounded to the safe side: of a_g down, else up."""
    factor, decimals = REACH_FORMATS[key]
    if value is None:
        return format_number(None, "", language)
    whole = factor * value * 10.0**decimals
    whole = math.floor(whole + 1e-9) if key == "ag_g" else math.ceil(whole - 1e-9)
    return format_number(whole / 10.0**decimals, f".{decimals}f", language)


def reach_labels(sensitivity: Sensitivity) -> list[str]:
    """The checks of what is turned round, the most refined first."""
    return list(dict.fromkeys(label for one in sensitivity.reach for label in one.by_check))


def check_names(result: StudyResult, labels: list[str], language: str) -> list[str]:
    """Names by which a table calls these checks."""
    q = Number(result.case.demand.q_code if result.case.demand else None, "g")
    return [sentence("short", label, q=q).text(language) for label in labels]


def reach_names(say: Say) -> dict[str, str]:
    """Names by which the report calls the inputs of inverse design."""
    return {"thickness_m": say("thickness [cm]"), "tie_kn_m": say("ties together [kN/m]"), "ag_g": "a_g [g]"}


def reach_row(say: Say, reach: TargetValue, labels: list[str], language: str) -> list[str]:
    """Row of an input of inverse design: its value now, and the value each check needs."""
    values = [reach_written(reach.key, reach.by_check.get(label), language) for label in labels]
    by_check = [say("any") if label in reach.throughout else value for label, value in zip(labels, values, strict=True)]
    factor, decimals = REACH_FORMATS[reach.key]
    return [reach_names(say)[reach.key], format_number(factor * reach.given, f".{decimals}f", language), *by_check]


def rate_heads(say: Say, life: float | None) -> list[str]:
    """Heads of the columns of `rate_row`."""
    years = say("in {n:g} years", n=life) if life else say("in V_N")
    return [
        say("exceeded"),
        say("median a_g [g]"),
        "β",
        say("9 of 10 within"),
        say("a year"),
        say("once in [years]"),
        years,
        say("a year, FC = 1"),
    ]


def rate_row(say: Say, rate: StateRate, language: str) -> list[str]:
    """A limit state with its fragility and its rate."""
    state = rate.state if rate.state != "collapse" else say("collapse")

    def said(value: float | None, form: str) -> str:
        return format_number(value, form, language)

    ends = f"{said(rate.low, '.1e')} – {said(rate.high, '.1e')}"
    share = None if rate.in_life is None else 100.0 * rate.in_life
    in_life = "–" if share is None else f"{said(share, '.2g' if share < 99.5 else '.0f')} %"
    fragility = rate.fragility
    return [
        state,
        said(fragility.median / G, ".3f"),
        said(fragility.deviation, ".2f"),
        ends,
        said(rate.rate, ".1e"),
        said(1.0 / rate.rate, ".0f"),
        in_life,
        said(rate.without_factor, ".1e"),
    ]


def rate_lines(say: Say, result: StudyResult, rates: tuple[StateRate, ...]) -> list[str]:
    """Sentences with which the rates are to be read."""
    if not rates:
        return []
    lines = [
        say(
            "Mean annual frequency by the fragility of the wall under its records and the hazard of the site, FC on "
            "the capacity. Beyond the code, not part of the verdict."
        )
    ]
    if result.compliance is None or not result.compliance.compatible:
        lines.append(
            say("The records are not compatible with the spectrum: the fragility is of other motions than the hazard.")
        )
    if "artificial" in result.kinds:
        lines.append(say("Generated motions scatter less than natural ones: the frequencies may be too low."))
    if states := _states(say, [rate for rate in rates if rate.beyond > MIN_REPORTED_SHARE]):
        lines.append(
            say(
                "Beyond the hazard's rows by more than one step the wall is taken to fail: a part of {states}.",
                states=states,
            )
        )
    if states := _states(say, [rate for rate in rates if rate.weaker > MIN_REPORTED_SHARE]):
        lines.append(
            say("Also under motions weaker than the hazard tells, which are not counted: {states}.", states=states)
        )
    return lines


def _states(say: Say, rates: list[StateRate]) -> str:
    return ", ".join(say("collapse") if rate.state == "collapse" else rate.state for rate in rates)
