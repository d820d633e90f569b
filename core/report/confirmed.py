"""What the engineer confirms by ticking."""

from core.wall.masonry import ARCHES, BENDS

ASSUMPTIONS = (
    "monolithic",
    "no_load",
    "no_ties",
    "loads_as_given",
    "ties_as_given",
    "held_top",
    "held_ends",
    "no_sliding",
    "no_vertical_motion",
)
"""Assumptions the engineer confirms, in their order; no_load is ticked where every wall says unloaded_confirmed."""


def confirmation_codes(walls) -> list[str]:
    """Codes of the assumptions: the loads as given where a wall has some, else that there are none."""
    loaded = any(wall.load for wall in walls)
    tied = any(load.kind == "tie" for wall in walls for load in wall.load)
    mechanisms = {wall.mechanism for wall in walls}
    left_out = {
        "" if BENDS in mechanisms else "held_top",
        "" if ARCHES in mechanisms else "held_ends",
        "no_load" if loaded else "loads_as_given",
        "no_ties" if tied else "ties_as_given",
    }
    return [code for code in ASSUMPTIONS if code not in left_out]
