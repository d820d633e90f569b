"""What a clause asks of an input that raises zeta, and what none asks: the one table of both.

An input is known by the code of its sentence: a key of a case may stand for several.
"""

from typing import NamedTuple

WALL, DEMAND, HOLD = "wall", "demand", "hold"
"""Sections whose evidence shows the value of a key: [[wall.evidence]], [[demand.evidence]], evidence of the ties."""

EVIDENCE_TABLES = {WALL: "[[wall.evidence]]", DEMAND: "[[demand.evidence]]", HOLD: "[[wall.hold]]"}
"""Section -> the table of a case its evidence stands in; of a tie it is a key of the tie."""

SEEN, MEASURED, TESTED, STATED, ORDERED = "seen", "measured", "tested", "stated", "ordered"
"""What a document has to be: one that shows that a thing is there, one that shows what is measured on it, one that
shows a property that no drawing has, one that states what is asked of a wall, one with which others decide that."""


class AskedInput(NamedTuple):
    """A row of the table.

    clause : that asks, of the Circolare 7/2019 where it begins with C
    section : WALL, DEMAND or HOLD, whose evidence answers; "" of what a clause permits without any
    keys : of the case, and `of` that evidence
    shown_by : SEEN, MEASURED or STATED
    """

    clause: str
    section: str
    keys: tuple[str, ...]
    shown_by: str = SEEN


ASKED = {
    "lift_velocity_ratio": AskedInput("C8.7.1.2.1.9", WALL, ("velocity_ratio", "restitution"), TESTED),
    "lift_law": AskedInput("C8.7.1.2.1.3", WALL, ("law",), TESTED),
    "lift_rigid": AskedInput("C8.7.1.2.1.3", WALL, ("law",), TESTED),
    "lift_return_walls": AskedInput("C8.7.1.2.1.1", WALL, ("return_walls",)),
    "lift_elongation": AskedInput("C8.7.1.2.1.6", HOLD, ("evidence",), MEASURED),
    "lift_brittle": AskedInput("C8.7.1.2.1.6", HOLD, ("evidence",), MEASURED),
    "lift_slack": AskedInput("C8.7.1.2.1.6", HOLD, ("evidence",), MEASURED),
    "lift_anchorage": AskedInput("C8.7.1.2.1.6", HOLD, ("evidence",), MEASURED),
    "lift_prestress": AskedInput("C8.7.1.2.1.1", HOLD, ("evidence",), MEASURED),
    "lift_inward": AskedInput("C8.7.1.2.1.1", WALL, ("inward",), MEASURED),
    "lift_carried": AskedInput("C8.7.1.2.1.1", WALL, ("load",)),
    "lift_variable": AskedInput("NTC 2018 2.5.3", WALL, ("variable",), STATED),
    "lift_low_load": AskedInput("C8.7.1.2.1.1", WALL, ("h_m",)),
    "lift_mass": AskedInput("C8.7.1.2.1.1", WALL, ("mass",)),
    "lift_corner": AskedInput("C8.7.1.2.1.1", WALL, ("corner",)),
    "lift_return_wedges": AskedInput("C8.7.1.2.1.1", WALL, ("return_wedges",), MEASURED),
    "lift_contact": AskedInput("C8.7.1.2.1.1", WALL, ("contact",)),
    "lift_inertia": AskedInput("C8.7.1.2.1.1", WALL, ("inertia_over_mass_m2",), MEASURED),
    "lift_solid_weight": AskedInput("C8.5.3", WALL, ("unit_weight_kn_m3",), TESTED),
    "lift_edge": AskedInput("C8.7.1.2.1.3", "", ("hinge_setback_m",)),
    "lift_edge_of_body": AskedInput("C8.7.1.2.1.3", "", ("hinge_setback_m",)),
    "lift_unit_weight": AskedInput("C8.5.3", WALL, ("unit_weight_kn_m3",), TESTED),
    "lift_strength": AskedInput("C8.5.3", WALL, ("compressive_strength_mpa",), TESTED),
    "lift_modulus": AskedInput("C8.5.3", WALL, ("elastic_modulus_mpa",), TESTED),
    "lift_confidence_factor": AskedInput("C8.5.4", DEMAND, ("confidence_factor",), TESTED),
    "lift_q_code": AskedInput("C8.7.1.2.1.7", DEMAND, ("q_code",), TESTED),
    "lift_limit_state": AskedInput("C8.3", DEMAND, ("limit_state",), STATED),
    "lift_zeta_target": AskedInput("NTC 2018 8.4.2", DEMAND, ("zeta_target",), ORDERED),
    "lift_soil_factor": AskedInput("NTC 2018 3.2.3.2", DEMAND, ("soil_factor",), TESTED),
    "lift_life": AskedInput("NTC 2018 2.4", DEMAND, ("nominal_life_years",), STATED),
    "lift_outside_italy": AskedInput("NTC 2018 3.2", DEMAND, ("f0", "tc_star_s"), TESTED),
    "lift_spectrum": AskedInput("NTC 2018 3.2.3.2", DEMAND, ("spectrum",), STATED),
    "lift_annex": AskedInput("EN 1998-1 3.2.2.2", DEMAND, ("spectrum",), STATED),
    "lift_type": AskedInput("EN 1998-1 3.2.2.2", DEMAND, ("spectrum",), STATED),
    "lift_scatter": AskedInput("NTC 2018 3.2.3.6", DEMAND, ("scatter",), STATED),
    "lift_alike": AskedInput("NTC 2018 3.2.3.6", DEMAND, ("scatter",), STATED),
    "other_building": AskedInput("C8.7.1.2.1.4", DEMAND, ("building",), TESTED),
    "lift_period": AskedInput("C7.2.3", DEMAND, ("period_s",), TESTED),
    "lift_modes": AskedInput("C7.2.3", DEMAND, ("participation",), TESTED),
    "lift_participation": AskedInput("C7.2.3", DEMAND, ("participation",), TESTED),
}
"""Code of an input that raises zeta -> what asks for it."""


OF_LEAF = AskedInput("C8.7.1.2.1.1", WALL, ("leaf",), MEASURED)
"""What asks for a leaf and its connectors, which stand for themselves in a wall of its own."""


def evidence_keys(section: str) -> tuple[str, ...]:
    """Keys whose values the evidence of a section shows, in the order of the table."""
    rows = (row for row in (*ASKED.values(), OF_LEAF) if row.section == section)
    return tuple(dict.fromkeys(key for row in rows for key in row.keys))


def shown_by(section: str, key: str) -> str:
    """What the document of a key has to be."""
    return next(row.shown_by for row in (*ASKED.values(), OF_LEAF) if row.section == section and key in row.keys)


NOT_ASKED = {
    "period_range": "a period by the formula of NTC 2018 7.3.3.2, or one that is shown, is what the clause takes",
    "at_centroid": "C8.7.1.2.1.5 takes the demand at the line about which the body turns",
    "lift_storeys": "C7.2.3 counts them, and a building has those it has",
    "lift_lever": "where a floor bears is drawn; 5 % of the thickness is how well one knows it",
    "weight_within_table": "Table C8.5.I gives the weights of the type, all of them means",
    "modulus_within_table": "Table C8.5.I gives the moduli of the type, all of them means",
    "lift_masonry": "the engineer names the type of masonry; its weakest is asked about by the hinge",
}
"""Code of an input -> why no clause asks for it: it moves zeta, and never holds an outcome back."""
