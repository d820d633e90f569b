"""Words of the report for what a tie must hold, and for what the ties of a wall hold."""

import math
from collections.abc import Callable

from core.known import require_value
from core.study.results import WallResult
from core.text.sentence import format_number, localized, word
from core.variation.tie_design import FORCE_NAMES, TieDesign
from core.wall.bars import TieBar


def force_words(tie: TieDesign, name: str, language: str) -> str:
    """A force of the design [kN/m], "–" where there is none."""
    force = tie.forces[name]
    return "–" if force is None else format_number(1e-3 * force, ".2f", language)


def tie_words(say: Callable[..., str], wall: WallResult, language: str) -> str:
    """Sentences on what a tie must hold, for a wall for which one is designed."""
    tie = require_value(wall.required_assessment.tie)
    names = [name for name in FORCE_NAMES if tie.forces[name] is not None]
    forces = "; ".join(f"{word(f'tie_{name}', language)} {force_words(tie, name, language)}" for name in names)
    values = {"h": tie.height, "forces": forces, "largest": 1e-3 * tie.largest}
    if tie.at_least is not None:
        words = [
            say(
                "The force of a tie {h:.2f} m above the base is not known: the time histories decide, and need the "
                "length of its bar. [kN/m] {forces}.",
                **values,
            )
        ]
    elif tie.asked is None:
        words = [
            say(
                "No tie {h:.2f} m above the base brings every hinge of the one-sided mechanism to the ζ required. "
                "[kN/m] {forces}.",
                **values,
            )
        ]
    elif tie.force is None:
        words = [
            say(
                "{asked:.2f} kN/m would be needed {h:.2f} m above the base, but above {largest:.2f} kN/m the wall "
                "bends between tie and base and is no longer one block: no single tie here. [kN/m] {forces}.",
                asked=1e-3 * tie.asked,
                **values,
            )
        ]
    elif tie.force == 0.0:
        words = [say("No tie {h:.2f} m above the base is needed. [kN/m] {forces}.", **values)]
    else:
        values |= {"force": 1e-3 * tie.force, "by": word(f"tie_{tie.check}", language)}
        if wall.wall.ties:
            first = say(
                "A further tie {h:.2f} m above the base must hold {force:.2f} kN/m ({by}), for the one-sided "
                "mechanism. [kN/m] {forces}.",
                **values,
            )
        else:
            first = say(
                "A tie {h:.2f} m above the base must hold {force:.2f} kN/m ({by}), for the one-sided mechanism. "
                "[kN/m] {forces}.",
                **values,
            )
        words = [first]
    if tie.at_least:
        words.append(say("It is not below {at_least:.2f} kN/m.", at_least=1e-3 * tie.at_least))
    if tie.missing == "bar":
        words.append(say("The displacement check is for a bar that does not break."))
    elif tie.missing == "histories":
        words.append(say("The time histories give none: there are no records."))
    elif tie.missing == "none":
        words.append(say("The time histories give none: up to the largest force the rule does not hold."))
    if tie.bending is not None and tie.force is not None and tie.force > tie.largest:
        words.append(
            say(
                "Above {largest:.2f} kN/m the wall bends between its base and the tie: ζ {zeta}.",
                zeta=format_number(tie.bending, ".2f", language),
                **values,
            )
        )
    if tie.force:
        words += _of_the_bar(say, tie)
    return " ".join(words)


def tie_lines(wall: WallResult, language: str) -> list[str]:
    """Sentences on the ties of a wall, and on the one to be designed."""

    def say(english: str, /, **values) -> str:
        return localized("report", english, language, **values)

    tie = wall.required_assessment.tie if wall.assessment else None
    asked = wall.part.asked.sought is not None and wall.part.hinge == 0.0 and wall.kinematics.one_way
    if tie is None and wall.assessment and asked:
        return [
            *describe_ties(say, wall, language),
            say("No tie is designed: a hinge of the wall has no check. See its verdict."),
        ]
    return [*describe_ties(say, wall, language), *([] if tie is None else [tie_words(say, wall, language)])]


def _of_the_bar(say: Callable[..., str], tie: TieDesign) -> list[str]:
    """How far the bar with the force named is stretched, and which bar holds it."""
    peak, at_limit, stands = tie.elongation["demand"], tie.elongation["d_slv"], tie.stands
    words = []
    if peak is not None:
        words.append(say("Elongation of its bar at the largest peak {mm:.0f} mm.", mm=1e3 * peak))
    if at_limit is not None:
        words.append(say("At the limit of the displacement check it is {mm:.0f} mm.", mm=1e3 * at_limit))
    if stands is not None:
        words.append(say("Its ultimate elongation is {mm:.0f} mm.", mm=1e3 * stands))
    if tie.diameter is not None:
        values = {"spacing": tie.spacing, "d": tie.diameter, "thread": tie.thread}
        words.append(say("Bars of S 235 every {spacing:g} m: diameter {d} mm, thread M{thread}.", **values))
    elif tie.spacing is not None:
        words.append(say("No bar of S 235 up to 40 mm every {spacing:g} m holds it.", spacing=tie.spacing))
    if tie.stands is None or tie.stands_more:
        words.append(say("The verdict with it asks what shows its anchorage, and its elongation beyond yield."))
    else:
        words.append(
            say(
                "Its bar fails at yield, as no elongation is given: the verdict with it asks why it holds, and what "
                "shows its anchorage."
            )
        )
    return words


def describe_ties(say: Callable[..., str], wall: WallResult, language: str) -> list[str]:
    """A sentence for each tie of a wall: what it holds, how far it is stretched, and what governs."""
    given = wall.wall.ties
    sentences = []
    for load, tie in zip(given, wall.wall.in_si.ties if given else (), strict=True):
        bar = tie.bar
        values = {
            "h": bar.height,
            "force": 1e-3 * bar.strength,
            "length": load.bar_length_m,
            "at_yield": 1e3 * bar.elongation_at_yield,
            "ultimate": 1e3 * bar.stands,
        }
        words = [
            say(
                "Tie at {h:.2f} m: {force:.2f} kN/m at yield, bar of {length:g} m, elongation at yield {at_yield:.1f} "
                "mm, ultimate {ultimate:.0f} mm.",
                **values,
            )
        ]
        if load.slack_mm:
            words.append(say("Slack {mm:g} mm.", mm=load.slack_mm))
        if load.prestress:
            words.append(say("Prestress {share:.0%} of its force at yield.", share=load.prestress))
        if not tie.stands_more:
            words.append(say("It fails at yield: no elongation beyond is counted on."))
        stretched = elongations(wall, bar)
        if stretched["demand"] is not None:
            words.append(say("Elongation {mm:.0f} mm at the largest peak.", mm=1e3 * stretched["demand"]))
        if stretched["d_limit"] is not None:
            at_limit = 1e3 * stretched["d_limit"]
            words.append(say("Elongation {mm:.0f} mm at the limit of the displacement check.", mm=at_limit))
        if tie.per_bar is not None:
            held = {word(f"part_{name}", language): format_number(1e-3 * n, ".1f", language) for name, n in tie.parts}
            parts = "; ".join(f"{part} {n}" for part, n in held.items())
            weakest = word(f"part_{tie.weakest}", language)
            words.append(say("Per bar [kN]: {parts}; {weakest} governs.", parts=parts, weakest=weakest))
        sentences.append(" ".join(words))
    return sentences


def elongations(wall: WallResult, bar: TieBar) -> dict[str, float | None]:
    """Elongation of a bar at the largest peak of the histories, at the limit of the displacement check and at d_0 [m];
    None where that is not made, or a wall overturns."""
    kinematic = wall.required_assessment.kinematic if wall.assessment else None
    dynamic = wall.required_assessment.dynamic if wall.assessment else None
    rotations: dict[str, float | None] = {"demand": None, "d_limit": None, "d_0": wall.model.collapse_rotation}
    if kinematic and kinematic.d_limit is not None:
        rotations["d_limit"] = kinematic.chain.rotation(kinematic.d_limit)
    if dynamic and dynamic.max_peak_ratio is not None:
        rotations["demand"] = dynamic.max_peak_ratio * wall.model.collapse_rotation
    return {name: None if theta is None else bar.height * math.sin(theta) for name, theta in rotations.items()}
