"""Quantities of a wall about one hinge: its sizes, its runs, its set, its body, loads and ties."""

import math
from typing import Any, NamedTuple

from core.codes.eq9 import LABEL
from core.known import require_value
from core.report.stated.checks import AT_DEMAND, FLOOR, KINEMATIC, RISK, UNCERTAINTY, VERDICT_OF_HINGE
from core.report.stated.quantity import (
    Quantity,
    flag,
    list_quantity,
    number,
    numbers,
    object_quantity,
    scaled_reader,
    text,
    texts,
    untyped_quantity,
    whole,
)
from core.report.tie_words import elongations
from core.study.results import Q_SOURCES, Run, StudyResult, WallResult
from core.units import CM, G


class RunSource(NamedTuple):
    """What the quantities of a run are read from."""

    run: Run
    wall: WallResult
    result: StudyResult

    @property
    def ida(self):
        return self.run.ida

    @property
    def method(self):
        return self.result.method_of(self.wall, self.run.motion)


RUN = (
    text("record", "record", "run.record"),
    whole("polarity", "1 as recorded, -1 reversed", "run.polarity"),
    text("status", "collapse_found, no_collapse_found or impact_limit", "ida.status"),
    number("q", "-", "first multiplier that overturns the wall, over that which starts the motion, Eq. 10", "ida.q"),
    numbers("bracket", "-", "multipliers between which it was found", lambda of: of.ida.bracket or None),
    number("q_slv", "-", "first peak at 0.40 theta_c", "ida.q_slv"),
    number("q_slv_low", "-", "lower end of its spread", "ida.q_slv_low"),
    number("q_slv_robust", "-", "first q around which 16 % of a window reach 0.40 theta_c", "ida.q_slv_robust"),
    number("q_slc", "-", "first peak at 0.60 theta_c", "ida.q_slc"),
    number("q_robust", "-", "first q around which 16 % of a window collapse", "ida.q_robust"),
    number("collapse_scale", "-", "multiplier of the record at q", "run.scale"),
    number("q_eff", "-", "q of Eq. 12", "run.q_eff"),
    number("q_last_survival", "-", "largest multiplier survived", "ida.q_last_survival"),
    number("survived_fraction", "-", "share of the map that survives", "ida.survived_fraction"),
    Quantity(
        "survival_windows",
        "pairs",
        "from and to of each range beyond q that survives",
        lambda of: [list(edges) for edges in of.ida.survival_windows],
        "-",
    ),
    number("q_step", "-", "step of the search", "result.search.q_step"),
    whole("analyses", "integrations made", "ida.analyses"),
    whole("impact_limited", "points of unknown outcome", "ida.impact_limited"),
    whole("clamped", "impacts with Eq. 7 held at 0", "ida.clamped"),
    object_quantity("method", "method of integration", (text("name", "name"), whole("order", "order"))),
)
"""Quantities read from OfRun."""

PER_RECORD = (
    text("record", "record"),
    whole("polarity", "sign that governs, null where no run has a number"),
    number("q", "-", "lower q of both signs"),
    number("q_robust", "-", "lower q_robust"),
    number("q_slv", "-", "lower q_slv"),
    number("q_slv_low", "-", "lower end of its spread"),
    number("q_slv_robust", "-", "lower q_slv_robust"),
    number("q_slv_safe", "-", "the lower of both, which the linear check takes"),
    number("q_eff", "-", "lower q_eff"),
    number("housner_intensity_cm", "cm", "SI of the record", scaled_reader(CM, "intensity")),
    number("closed_form_q_eff", "-", "Eq. 15 or 16"),
    number("closed_form_q", "-", "the same as q"),
)

ESTIMATE = (
    text("quantity", "q or q_slv"),
    number("q", "-", "value of the law"),
    number("low", "-", "lower end for nine sets of ten"),
    number("high", "-", "upper end"),
    number("scaled", "-", "Lambda: p2/PGA times the pseudo-velocity over the band of the wall"),
    flag("within", "whether the wall is within the range of the fit"),
    number("record_low", "-", "lower end for nine natural records of ten"),
    number("record_sixth", "-", "one natural record in six is below: with record_low the design values of q_slv"),
    number("record_high", "-", "upper end"),
)

EQ_9 = (
    text("check", "Eq. 9", lambda of: LABEL),
    text("q_source", "where q is from", lambda of: of[1]),
    number("q", "-", "q", lambda of: of[2].q if of[2] else None),
    number("capacity_a_rm_g", "g", "a_RM", lambda of: of[0].model.threshold / G),
    number("demand_g", "g", "S a_g over q", lambda of: of[2].demand / G if of[2] else None),
    number("ratio", "-", "capacity over demand", lambda of: of[2].ratio if of[2] else None),
    flag("passed", "whether the inequality holds", lambda of: of[2].passed if of[2] else None),
)
"""Quantities read from (WallResult, source of q, Inequality)."""

SOLID = (
    text("plane", "elevation, section or oblique"),
    flag("opening", "whether it is taken away", lambda part: part.weight < 0.0),
    flag("wedge", "whether it is a wedge of return walls"),
    Quantity("polygon_m", "pairs", "corners (s, z)", lambda part: [list(corner) for corner in part.polygon], "m"),
    number("from_m", "m", "its beginning along the normal", lambda part: part.ends[0]),
    number("to_m", "m", "its end", lambda part: part.ends[1]),
    number("x0_m", "m", "from the outer face to s = n = 0", "start"),
    number("angle_deg", "deg", "from the section in plan", lambda part: math.degrees(part.angle)),
    number("unit_weight_kn_m3", "kN/m3", "unit weight", lambda part: 1e-3 * abs(part.weight)),
    number("mass_kg", "kg", "mass, negative of an opening", "body.mass"),
)

INNER = (
    number("slenderness_deg", "deg", "alpha", lambda far: math.degrees(far.slenderness)),
    number("frequency_parameter_rad_s", "rad/s", "p", lambda far: math.sqrt(far.p2)),
    number("velocity_ratio", "-", "of an impact that leaves it", "ratio_at_rest"),
)

BODY = (
    number("mass_kg", "kg", "mass", "wall.in_si.body.mass", line="body_mass"),
    number(
        "x_g_m",
        "m",
        "centroid from the outer edge of the base",
        lambda wall: wall.wall.in_si.body.centroid[0],
        line="x_g",
    ),
    number("z_g_m", "m", "centroid above the base", lambda wall: wall.wall.in_si.body.centroid[1], line="z_g"),
    number(
        "i_o_kgm2", "kg m2", "moment of inertia about the outer edge of the base", "wall.in_si.body.inertia", line="i_o"
    ),
    object_quantity("inner", "about the inner hinge, where it is another block", INNER, "model.other").optional(),
    list_quantity("solids", "its solids", SOLID, "wall.parts"),
)

SIDE = (number("a", "-", "sine of the restoring moment", "sine"), number("c", "-", "its cosine", "cosine"))


def _sides(wall: WallResult) -> list:
    return [wall.model.restoring, wall.model.mirrored][: 1 if wall.model.one_sided else 2]


LOADS = (
    number("a", "-", "sine of the restoring moment, outward", "model.restoring.sine"),
    number("c", "-", "its cosine", "model.restoring.cosine"),
    number("collapse_rotation_rad", "rad", "theta_c", "model.collapse_rotation", line="theta_c"),
    number("uplift_g", "g", "a_RM", scaled_reader(G, "model.threshold")),
    list_quantity("sides", "a and c of each side", SIDE, _sides),
)

TIE = (
    number("height_m", "m", "height above the hinge", lambda of: of[1].bar.height),
    number("strength_kn_m", "kN/m", "force at yield", lambda of: 1e-3 * of[1].bar.strength),
    number("per_bar_kn", "kN", "of a bar", lambda of: None if of[1].per_bar is None else 1e-3 * of[1].per_bar),
    untyped_quantity(
        "parts_kn", "resistance of each part [kN]", lambda of: {name: 1e-3 * held for name, held in of[1].parts}
    ),
    text("weakest", "part that governs", lambda of: of[1].weakest or None),
    number("elongation_at_yield_m", "m", "elongation at yield", lambda of: of[1].bar.elongation_at_yield),
    number("stands_m", "m", "elongation beyond which it is gone", lambda of: of[1].bar.stands),
    untyped_quantity(
        "elongation_m", "elongation at the demand and at the limits [m]", lambda of: elongations(of[0], of[1].bar)
    ),
)
"""Quantities read from (WallResult, Tie)."""


LIMIT_STATE = (
    text("limit_state", "limit state", "state"),
    number("return_period_years", "years", "its return period", "return_period"),
    number("ag_g", "g", "a_g on rock", scaled_reader(G, "ag")),
    text("check", "check that decides"),
    number("zeta", "-", "zeta_E"),
    text("code", "outcome"),
)


FRAGILITY = (
    number("q_05", "-", "q at which 5 % of the runs collapse"),
    number("q_16", "-", "q at which 16 % do"),
    number("q_50", "-", "q at which half of them do"),
    whole("n", "runs"),
)


class WallResultSource(NamedTuple):
    """What the quantities of a wall are read from. result : None while the study runs"""

    wall: WallResult
    result: StudyResult | None

    @property
    def runs(self) -> list[RunSource]:
        return [RunSource(run, self.wall, require_value(self.result)) for run in self.wall.runs]

    @property
    def found(self) -> Any:
        return self.wall.assessment


class OfAssessment:
    """An Assessment and FC, for what is read of both."""

    def __init__(self, assessment: Any, confidence_factor: float):
        self.found, self.confidence_factor = assessment, confidence_factor

    def __getattr__(self, name: str) -> Any:
        return getattr(self.found, name)


def _with_factor(of: WallResultSource) -> OfAssessment | None:
    if of.found is None or of.found.kinematic is None:
        return None
    return OfAssessment(of.found, require_value(of.result).demand_required.confidence_factor)


WALL = (
    text("name", "name, with the height of the hinge above the base", "wall.name"),
    number("height_m", "m", "height above the hinge", "wall.height", line="height"),
    number("thickness_m", "m", "thickness", "wall.thickness", line="thickness"),
    number(
        "slenderness_deg",
        "deg",
        "alpha about the outer hinge",
        lambda of: math.degrees(of.wall.block.slenderness),
        line="slenderness",
    ),
    number(
        "radius_m",
        "m",
        "R, null of a wall held at its top",
        lambda of: None if of.wall.wall.bends else of.wall.block.radius,
        line="radius",
    ),
    number(
        "frequency_parameter_rad_s",
        "rad/s",
        "p",
        lambda of: math.sqrt(of.wall.model.p2) if of.wall.wall.bends else of.wall.block.frequency_parameter,
        line="p",
    ),
    number(
        "threshold_acceleration_g",
        "g",
        "acceleration that starts the motion",
        lambda of: of.wall.threshold / G,
        line="a_rm",
    ),
    text("mechanism", "one_sided, two_sided, vertical_bending or horizontal_bending", "wall.mechanism"),
    text("restitution", "model of restitution", "wall.restitution.model"),
    number("velocity_ratio", "-", "at rest", "wall.restitution.ratio_at_rest", line="velocity_ratio"),
    Quantity("law", "any", "moment-rotation law", lambda of: of.wall.wall.law),
    list_quantity("runs", "each record and sign", RUN),
    list_quantity("per_record", "the lower of both signs of each record", PER_RECORD, "wall.per_record"),
    text("set_rule", "mean, minimum, too_few or incomplete", "wall.set_rule"),
    number("q_set", "-", "q of the set by that rule", "wall.q_set"),
    number("q_min", "-", "lowest q", "wall.q_min"),
    number("q_robust_set", "-", "q_robust of the set", "wall.q_robust_set"),
    number("q_slv_set", "-", "q_slv of the set", "wall.q_slv_set", line="q_slv"),
    number("q_slv_low_set", "-", "the same of its lower ends", "wall.q_slv_low_set", line="q_slv_low"),
    number("q_slv_robust_set", "-", "the same of q_slv_robust", "wall.q_slv_robust_set", line="q_slv_robust"),
    number("q_slv_safe_set", "-", "the same of q_slv_safe", "wall.q_slv_safe_set", line="q_slv_safe"),
    object_quantity(
        "power_law",
        "q_eff = C1 SI^C2, Eq. 13",
        (
            number("c1", "-", "C1"),
            number("c2", "-", "C2"),
            number("r_squared", "-", "R squared"),
            whole("n", "records"),
        ),
        lambda of: of.wall.power_law or None,
    ),
    object_quantity(
        "fragility", "q at which shares of the runs collapse", FRAGILITY, lambda of: of.wall.fragility or None
    ),
    list_quantity(
        "code_check",
        "Eq. 9 by the q of each source",
        EQ_9,
        lambda of: [(of.wall, source, check) for source, check in zip(Q_SOURCES, of.wall.code_check, strict=False)],
    ),
    list_quantity("scale_free_law", "Ribalta's law, a research output", ESTIMATE, "wall.estimates"),
    object_quantity(
        "body",
        "of a wall that is no rectangle, about the outer edge of its base",
        BODY,
        lambda of: None if of.wall.wall.in_si.body is None else of.wall,
    ).optional(),
    object_quantity(
        "loads",
        "of a wall with loads",
        LOADS,
        lambda of: of.wall if of.wall.wall.is_loaded and not of.wall.wall.bends else None,
    ).optional(),
    list_quantity(
        "ties", "its ties", TIE, lambda of: [(of.wall, tie) for tie in of.wall.wall.in_si.ties] or None
    ).optional(),
    list_quantity(
        "limit_states", "the limit states", LIMIT_STATE, lambda of: (of.found.states or None) if of.found else None
    ).optional(),
    object_quantity(
        "demand_check", "the histories at the demand", AT_DEMAND, lambda of: of.found.dynamic if of.found else None
    ),
    object_quantity(
        "lower_bound_check",
        "the histories where what holds the wall fails",
        [quantity._replace(line="") for quantity in AT_DEMAND],
        lambda of: of.found.lower_bound if of.found else None,
    ),
    object_quantity("kinematic_check", "the checks of the clauses", KINEMATIC, _with_factor),
    object_quantity(
        "verdict", "outcome about this hinge", VERDICT_OF_HINGE, lambda of: of.found.verdict if of.found else None
    ),
    object_quantity(
        "floor", "of a wall above the ground", FLOOR, lambda of: of.wall if of.wall.floor else None
    ).optional(),
    object_quantity(
        "risk", "what it withstands", RISK, lambda of: of.found if of.found and of.found.risk else None
    ).optional(),
    object_quantity("uncertainty", "how exact its q is, where asked for", UNCERTAINTY, "wall.accuracy").optional(),
    texts("warnings", "remarks on the run", lambda of: [warning.text() for warning in of.wall.warnings]),
)
"""Quantities read from OfWallResult."""
