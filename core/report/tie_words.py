"""What a tie must hold, and what the ties of a wall hold, in the words of the report."""

from collections.abc import Callable

from core.study.results import WallResult
from core.study.tie_design import NAMES, TieDesign
from core.text.sentence import localized, numeral, word
from core.wall.ties import ties_of


def force_words(tie: TieDesign, name: str, language: str) -> str:
    """A force of the design [kN/m], "–" where there is none."""
    force = tie.forces[name]
    return "–" if force is None else numeral(1e-3 * force, ".2f", language)


def tie_words(say: Callable[..., str], tie: TieDesign, language: str) -> str:
    """What a tie must hold, in some sentences."""
    forces = "; ".join(f"{word(f'tie_{name}', language)} {force_words(tie, name, language)}" for name in NAMES)
    values = {"h": tie.height, "forces": forces, "largest": 1e-3 * tie.largest}
    if tie.force is None:
        words = [
            say("No tie {h:.2f} m above the base brings every hinge to the ζ required. [kN/m] {forces}.", **values)
        ]
    elif tie.force == 0.0:
        words = [say("No tie {h:.2f} m above the base is needed. [kN/m] {forces}.", **values)]
    else:
        by, force = word(f"tie_{tie.check}", language), 1e-3 * tie.force
        values |= {"force": force, "by": by}
        words = [say("A tie {h:.2f} m above the base must hold {force:.2f} kN/m ({by}). [kN/m] {forces}.", **values)]
    if tie.missing == "bar":
        words.append(say("The time histories give none: the length of its bar is not given."))
    elif tie.missing == "histories":
        words.append(say("The time histories give none: there are no records."))
    elif tie.missing == "none":
        words.append(say("The time histories give none: up to the largest force the rule does not hold."))
    if tie.force is not None and tie.force > tie.largest:
        words.append(
            say("Above {largest:.2f} kN/m the wall bends between tie and base and is no longer one block.", **values)
        )
    if tie.force:
        words += _of_the_bar(say, tie)
    return " ".join(words)


def tie_lines(wall: WallResult, language: str) -> list[str]:
    """Sentences on the ties of a wall, and on the one to be designed."""

    def say(english: str, /, **values) -> str:
        return localized("report", english, language, **values)

    tie = wall.assessment.tie if wall.assessment else None
    return [*of_ties(say, wall, language), *([] if tie is None else [tie_words(say, tie, language)])]


def _of_the_bar(say: Callable[..., str], tie: TieDesign) -> list[str]:
    """How far the bar with the force named is stretched, and which bar holds it."""
    peak, at_limit, stands = tie.elongation["demand"], tie.elongation["d_slv"], tie.stands
    words = []
    if peak is not None:
        words.append(say("Elongation of its bar at the largest peak {mm:.0f} mm.", mm=1e3 * peak))
    if at_limit is not None:
        words.append(say("At d_SLV it is {mm:.0f} mm.", mm=1e3 * at_limit))
    if stands is not None:
        words.append(say("It stands {mm:.0f} mm.", mm=1e3 * stands))
    if tie.diameter is not None:
        values = {"spacing": tie.spacing, "d": tie.diameter, "thread": tie.thread}
        words.append(say("Bars of S 235 every {spacing:g} m: diameter {d} mm, thread M{thread}.", **values))
    elif tie.spacing is not None:
        words.append(say("No bar of S 235 up to 40 mm every {spacing:g} m holds it.", spacing=tie.spacing))
    return words


def of_ties(say: Callable[..., str], wall: WallResult, language: str) -> list[str]:
    """A sentence for each tie of a wall: what it holds and stands, and what governs."""
    found = []
    for tie in ties_of(wall.wall) if wall.wall.load else ():
        bar = tie.bar
        values = {
            "h": bar.height,
            "force": 1e-3 * bar.strength,
            "at_yield": 1e3 * bar.elongation_at_yield,
            "stands": 1e3 * bar.stands,
        }
        words = say(
            "Tie at {h:.2f} m: {force:.2f} kN/m at yield, {at_yield:.1f} mm; it stands {stands:.0f} mm.", **values
        )
        if tie.per_bar is not None:
            parts = "; ".join(
                f"{word(f'part_{name}', language)} {numeral(1e-3 * n, '.1f', language)}" for name, n in tie.parts
            )
            weakest = word(f"part_{tie.weakest}", language)
            words += " " + say("Per bar [kN]: {parts}; {weakest} governs.", parts=parts, weakest=weakest)
        if not tie.stands_more:
            words += " " + say("It is gone at yield: no elongation is counted on.")
        found.append(words)
    return found
