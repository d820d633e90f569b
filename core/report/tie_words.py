"""What a tie must hold, in the words of the report."""

from collections.abc import Callable

from core.study.tie_design import TieDesign


def tie_words(say: Callable[..., str], tie: TieDesign) -> str:
    """What a tie must hold, in one or two sentences."""
    words = _own_tie(say, tie)
    if tie.hinges == 1:
        return words
    if tie.governing is None:
        return f"{words} {say('One of its {n} hinges does not reach the ζ required with any tie.', n=tie.hinges)}"
    force = 1e-3 * tie.governing
    more = say("The weakest of its {n} hinges requires {force:.2f} kN/m.", n=tie.hinges, force=force)
    return f"{words} {more}"


def _own_tie(say: Callable[..., str], tie: TieDesign) -> str:
    """The same of one hinge."""
    values = {"h": tie.height, "largest": 1e-3 * tie.largest, "zeta": tie.zeta or 0.0}
    if tie.force is None:
        return say(
            "No tie {h:.2f} m above this hinge reaches the ζ required: the largest, {largest:.2f} kN/m, "
            "gives {zeta:.2f}.",
            **values,
        )
    if tie.force == 0.0:
        return say("No tie {h:.2f} m above this hinge is needed: ζ {zeta:.2f}.", **values)
    force = 1e-3 * tie.force
    found = say(
        "A tie {h:.2f} m above this hinge that holds {force:.2f} kN/m up to collapse gives ζ {zeta:.2f}.",
        force=force,
        **values,
    )
    caution = say(
        "Not for sizing a tie: a bar yields and is slack when the wall comes back, and other checks require more."
    )
    return f"{found} {caution}"
