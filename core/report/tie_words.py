"""Words of the report for what the ties of a wall hold."""

import math

from core.study.results import WallResult
from core.text.sentence import format_number, localized, word
from core.wall.bars import TieBar


def tie_lines(wall: WallResult, language: str) -> list[str]:
    """A sentence for each tie of a wall: what it holds, how far it is stretched, and what governs."""

    def say(english: str, /, **values) -> str:
        return localized("report", english, language, **values)

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
