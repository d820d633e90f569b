"""What the engineer confirms by ticking."""

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


def unconfirmed_holds(walls) -> set[str]:
    """Codes of what is assumed of holds that none of these walls has."""
    kinds = [wall.kinematics for wall in walls]
    held_top, held_ends = any(kind.bends_up for kind in kinds), any(kind.arches for kind in kinds)
    return {code for code, has in (("held_top", held_top), ("held_ends", held_ends)) if not has}


def confirmation_codes(walls) -> list[str]:
    """Codes of the assumptions: the loads as given where a wall has some, else that there are none."""
    loaded = any(wall.load for wall in walls)
    tied = any(hold.is_tie for wall in walls for hold in wall.hold)
    left_out = {
        *unconfirmed_holds(walls),
        "no_load" if loaded else "loads_as_given",
        "no_ties" if tied else "ties_as_given",
    }
    return [code for code in ASSUMPTIONS if code not in left_out]
