"""Quantities of the checks of a wall: at the demand, by the clauses, its risk, its floor, how exact its q is."""

import math
from typing import Any

from core.capacity.accuracy import RECORD_ROUNDING
from core.codes.dynamic_check import DynamicCheck
from core.codes.elastic_branch import Branch
from core.codes.vertical_bending import HingeAt
from core.report.stated.quantity import (
    Quantity,
    flag,
    identity,
    list_quantity,
    number,
    numbers,
    object_quantity,
    scaled_reader,
    text,
    texts,
    whole,
)
from core.units import G


def _elastic(check: DynamicCheck) -> Branch | None:
    return check.branch if isinstance(check.branch, Branch) else None


def _hinge(check: DynamicCheck) -> float | None:
    return check.branch.h1 if isinstance(check.branch, HingeAt) else None


RUN_AT_DEMAND = (
    text("record", "record"),
    whole("polarity", "1 as recorded, -1 reversed"),
    number("factor", "-", "multiplier of the record, scaling and an FC on the demand included"),
    number("peak_ratio", "-", "largest rotation over theta_c, null unless stable"),
    flag("exceeded", "whether theta_c was exceeded"),
    text("status", "stable, overturned or impact_limit"),
)

OTHER_SIDE = (
    text("confidence_on", "where FC acts"),
    number("zeta", "-", "zeta_E", line="zeta_other"),
    flag("passed", "whether the check passes"),
    numbers("spread", "-", "multipliers around which 45 and 55 % fail"),
)

BRANCH = (
    number("modulus_mpa", "MPa", "E it follows from", scaled_reader(1e6, "modulus")),
    flag("assumed", "whether E is an end of the range of the table"),
    number("period_s", "s", "T_0 of C8.7.1.7", "period"),
    number("limit", "-", "its end over theta_c"),
    number("own_period_s", "s", "period of small rotations by the equation of motion", "own_period"),
)

AT_DEMAND = (
    text("limit_state", "limit state"),
    list_quantity("runs", "each record and sign", RUN_AT_DEMAND),
    whole("n_exceeded", "runs that exceed theta_c"),
    number("mean_peak_ratio", "-", "mean of the peaks over theta_c, null where a run overturns"),
    number("max_peak_ratio", "-", "largest of them"),
    text("set_rule", "mean, or maximum below seven stations"),
    number("limit_ratio", "-", "share of theta_c that the clause allows", line="peak_limit"),
    number("zeta", "-", "zeta_E: multiplier of the demand around which half of them fail", line="dynamic_zeta"),
    flag("holds", "whether the rule holds at the demand"),
    flag("passed", "whether it holds at the zeta required, and zeta_E reaches it"),
    flag("holds_at_target", "whether it holds at the zeta required"),
    flag("fails_at_target", "whether it fails there by runs that have a number"),
    text("confidence_on", "where FC acts: capacity or demand"),
    numbers("zeta_spread", "-", "multipliers around which 45 and 55 % fail"),
    number("zeta_16", "-", "multiplier around which 16 % fail", line="zeta_16"),
    number("zeta_first", "-", "first failure on the grid"),
    number("share_failing_at_demand", "-", "failing multipliers within 10 % of the zeta required"),
    object_quantity("zeta_other", "the check with FC on the other side, null where FC is 1", OTHER_SIDE),
    texts("not_counted", "records too weak beside the others to count"),
    object_quantity("branch", "the elastic branch that decides, null without one", BRANCH, _elastic),
    number("hinge_between_m", "m", "height of the hinge of a wall held at its top that decides", _hinge),
)
"""Quantities read from DemandCheck."""

CHECK = (
    text("check", "dynamic, nonlinear, linear_q_slv or linear_q_code", "name"),
    text("clause", "clause of the Circolare"),
    number("q", "-", "q of the row"),
    text("unit", "of capacity and demand"),
    number("capacity", "see unit", "capacity"),
    number("demand", "see unit", "demand"),
    number("zeta", "-", "zeta_E of the check"),
    flag("passed", "whether it passes"),
)


REACTION = (
    text("hold", "top, base, foot (a floor there), ends, tie or behind: what holds the wall"),
    text("direction", "outward or inward: the motion that asks most of it"),
    text("check", "kinematic (linear and displacement check alike) or dynamic: whose push asks it"),
    number("at_demand_kn_m", "kN/m", "what it takes at the demand", scaled_reader(1e3, "at_demand")),
    number("at_zeta_kn_m", "kN/m", "what it takes at zeta of the check that decides", scaled_reader(1e3, "at_zeta")),
    number("stands_kn_m", "kN/m", "what it stands, null where it is not compared", scaled_reader(1e3, "stands")),
    number("gives_way", "-", "share of the demand up to which it holds"),
    number("impulse_n_s_m", "N s/m", "impulse that pulls at it at the demand, where it has to take it", "impulse"),
)
"""Quantities read from Reaction."""


def _bending(kinematic: Any) -> Any:
    """(mechanism of the start, mechanism of the displacement check) of a wall held at its top."""
    start, moved = kinematic.chain.bending, kinematic.moved.bending
    of_arch = kinematic.wall.arch is not None
    return None if start is None or moved is None or of_arch else (start, moved)


def _parted(kinematic: Any) -> float | None:
    """By how much the ends have parted at d_SLV or d_SLC [m]."""
    moved = kinematic.moved.bending
    return None if kinematic.d_limit is None else moved.parted(moved.rotation(kinematic.d_limit))


ARCH = (
    number("spacing_m", "m", "clear distance of the transverse walls", "wall.arch.spacing", line="spacing"),
    number(
        "thrust_kn_m",
        "kN/m",
        "H of its ends, for each metre of height",
        scaled_reader(1e3, "wall.arch.thrust"),
        line="thrust",
    ),
    text("limited_by", "arch_tie, arch_shoulder or arch_crushing: what H is limited by", "wall.arch.by"),
    number("setback_m", "m", "u of its hinges", "wall.arch.setback", line="setback"),
    number("parted_m", "m", "by how much its ends have parted at d_SLV or d_SLC", _parted),
)


BENDING = (
    number("hinge_m", "m", "height of the hinge between, where it opens first", lambda pair: pair[0].h1, line="h1"),
    number("hinge_of_displacement_m", "m", "the same of the displacement check", lambda pair: pair[1].h1, line="h1_d"),
    number(
        "d_c0_m",
        "m",
        "displacement of that hinge at which nothing holds the wall",
        lambda pair: pair[1].d_c0,
        line="d_c0",
    ),
    number("theta_0_rad", "rad", "rotation of the lower block there", lambda pair: pair[1].theta0),
    number(
        "top_kn_m",
        "kN/m",
        "force that holds the top at the start",
        lambda pair: 1e-3 * pair[0].top_force,
        line="top_force",
    ),
)

DISPLACEMENT = (
    number("d_limit_m", "m", "d_SLV or d_SLC", "limit", line="d_limit_bare"),
    number("a_limit_m_s2", "m/s2", "capacity there", "capacity", line="a_limit_bare"),
    number("period_s", "s", "T_SLV or T_SLC", "period", line="period_bare"),
    number("s_de_m", "m", "displacement demand", "demand", line="s_de_bare"),
    number("zeta", "-", "their ratio", "ratio", line="displacement_ratio_bare"),
)

START: tuple[Quantity, ...] = (
    number("alpha0", "-", "multiplier that starts the mechanism, C8.7.1.1", lambda pair: pair[0].chain.alpha0),
    number("e_star", "-", "share of the mass that takes part, C8.7.1.5", lambda pair: pair[0].chain.e_star),
    number("m_star", "kg/m", "mass that takes part, null without a unit weight", lambda pair: _own_mass(pair[0].chain)),
    number(
        "a0_star_g",
        "g",
        "spectral acceleration that starts it, C8.7.1.3",
        lambda pair: pair[0].chain.alpha0 / (pair[0].chain.e_star * pair[1]),
    ),
)
"""Quantities read from (Kinematic, FC): the whole wall, without the friction of return walls."""


def _own_mass(chain: Any) -> float | None:
    return None if chain.mass is None else chain.e_star * chain.mass


KINEMATIC = (
    number("alpha0", "-", "multiplier that starts the mechanism, C8.7.1.1", "kinematic.alpha0", line="alpha0"),
    number("alpha0_without_ties", "-", "the same without its ties", "kinematic.chain.alpha0_bare", line="alpha0_bare"),
    number("e_star", "-", "share of the mass that takes part, C8.7.1.5", "kinematic.e_star", line="e_star"),
    number("m_star", "kg/m", "mass that takes part, null without a unit weight", "kinematic.m_star", line="m_star"),
    number(
        "a0_star_g",
        "g",
        "spectral acceleration that starts it, C8.7.1.3",
        scaled_reader(G, "kinematic.a0"),
        line="a0_star",
    ),
    number("friction_height_m", "m", "part that turns with the friction", "kinematic.chain.friction_height"),
    object_quantity(
        "without_friction",
        "the whole wall, where the values above are of its upper part with friction",
        START,
        lambda of: None if of.kinematic.chain.alpha0_friction is None else (of.kinematic, of.confidence_factor),
    ),
    number("d0_m", "m", "displacement of the control point at which nothing holds the wall", "kinematic.d0", line="d0"),
    number(
        "d0_with_ties_m",
        "m",
        "the same, were its ties forces up to collapse",
        "kinematic.chain.d0_with_ties",
        line="d0_with_ties",
    ),
    number("d_limit_m", "m", "d_SLV or d_SLC", "kinematic.d_limit", line="d_limit"),
    object_quantity(
        "arch",
        "of a wall that spans between transverse walls",
        ARCH,
        lambda of: of.kinematic if of.kinematic.wall.arch else None,
    ).optional(),
    object_quantity("bending", "of a wall held at its top", BENDING, lambda of: _bending(of.kinematic)).optional(),
    number("period_s", "s", "T_SLV or T_SLC, C8.7.1.10 and .11", "kinematic.period", line="period"),
    number("s_de_m", "m", "displacement demand", "kinematic.s_de", line="s_de"),
    object_quantity(
        "without_ties", "the displacement check of the wall without its ties", DISPLACEMENT, "kinematic.without_ties"
    ),
    flag("free_element", "whether it is free to vibrate before it moves", "kinematic.free_element"),
    number("period_0_s", "s", "T_0 of a free element, C8.7.1.7", "kinematic.period_0", line="period_0"),
    number(
        "acceleration_demand_g",
        "g",
        "a_g S, or S_e(T_0)",
        scaled_reader(G, "kinematic.acceleration_demand"),
        line="se_t0",
    ),
    number("zeta_sld", "-", "a_g,SLD over a_g, C8.7.1.8 and .9", "kinematic.zeta_sld", line="zeta_sld"),
    texts("missing", "keys without which a free element has no linear check", "kinematic.missing"),
    list_quantity("checks", "the rows of the table of methods", CHECK),
)
"""Quantities read from Assessment with closed forms."""

VERDICT_OF_HINGE = (
    text("code", "outcome"),
    text("governing", "check that decides"),
    number("zeta_e", "-", "zeta_E of it"),
    number("zeta_target", "-", "zeta_E required"),
    texts("reasons", "what the outcome rests on", lambda verdict: [reason.text() for reason in verdict.reasons]),
    text("text_it", "the sentence in Italian", lambda verdict: verdict.text("it")),
    text("text_en", "the sentence in English", lambda verdict: verdict.text("en")),
    number("lower_bound_zeta", "-", "zeta_E where what holds the wall fails", "lower_bound"),
)

RISK = (
    number("pga_c_g", "g", "PGA_C", scaled_reader(G, "risk.pga"), line="pga_c"),
    number("return_period_c_years", "years", "T_R,C", "risk.return_period", line="tr_c"),
    number(
        "other_return_period_c_years",
        "years",
        "T_R,C by the other exponent",
        "risk.other_return_period",
        line="tr_c_longer",
    ),
    number("zeta_16", "-", "of the histories, where they decide", lambda of: _decided_by(of, "zeta_16")),
    number("zeta_first", "-", "of the histories, where they decide", lambda of: _decided_by(of, "zeta_first")),
    text("return_period_c_shown", "T_R,C as it is written", "risk.years"),
    number("is_v", "-", "IS-V of this mechanism", "risk.index", line="is_v"),
    text("is_v_letter", "its letter", "risk.letter"),
)
"""Quantities read from Assessment."""


def _decided_by(assessment: Any, name: str) -> float | None:
    """A number of the histories where they decide."""
    dynamic = assessment.dynamic if assessment.verdict.governing == "dynamic" else None
    return getattr(dynamic, name) if dynamic else None


FLOOR = (
    number("z_m", "m", "height above the ground", "floor.z"),
    number(
        "a_z_g",
        "g",
        "a_Z of C7.2.3",
        lambda wall: wall.floor.spectrum.a_z / G if wall.floor.spectrum else None,
        line="a_z",
    ),
    numbers("period_s", "s", "of each mode", lambda wall: [mode.period for mode in wall.floor.modes]),
    flag("period_estimated", "whether the period was not given", "floor.estimated"),
    numbers("damping", "-", "of each mode", lambda wall: [mode.damping for mode in wall.floor.modes]),
    numbers("participation", "-", "of each mode there", lambda wall: [mode.participation for mode in wall.floor.modes]),
    list_quantity(
        "motions",
        "of the floor",
        (
            text("record", "record", "name"),
            number("pfa_g", "g", "largest acceleration of the floor", scaled_reader(G, "pga")),
            number("time_step_s", "s", "time between samples", "time_step"),
        ),
        "floor.motions",
    ),
    number(
        "code_over_records_min",
        "-",
        "least spectrum of the clause over that of the records",
        lambda wall: wall.assessment.code_over_records if wall.assessment else None,
    ),
)
"""Quantities read from WallResult above the ground."""

SOLVER = (
    text("method", "method of the run"),
    number("q", "-", "q by it"),
    number("q_reference", "-", "q by the reference"),
    text("reference", "method of the reference", lambda _: "dormand_prince"),
    number("q_difference", "-", "their difference", "solver_q_difference"),
    number("history_difference", "-", "of the governing history from an independent solver, over theta_c"),
    number("history_bound", "-", "bound of its error, over theta_c"),
    number(
        "noise_effect",
        "-",
        "of noise on the samples on the history, null where it overturns the wall",
        lambda of: of.noise_effect if math.isfinite(of.noise_effect) else None,
    ),
    number("scale", "-", "multiplier of the histories"),
    list_quantity(
        "histories",
        "other methods on the governing history",
        (
            text("method", "method", "name"),
            whole("option", "its option"),
            number("seconds", "s", "time it takes"),
            number("error", "-", "over theta_c, null where it overturns the wall"),
        ),
        "points",
    ),
)

DEFINITION = (
    list_quantity(
        "steps",
        "q by the step of the search",
        (
            number("q_step", "-", "step", lambda row: row[0]),
            number("q", "-", "q", lambda row: row[1]),
            number("q_robust", "-", "q_robust", lambda row: row[2]),
            number("q_slv_robust", "-", "q_slv_robust", lambda row: row[3]),
        ),
    ),
    number("step_spread", "-", "spread of q", lambda of: of.spread(1, of.steps)),
    number("step_spread_robust", "-", "spread of q_robust", lambda of: of.spread(2, of.steps)),
    number("step_spread_slv_robust", "-", "spread of q_slv_robust", lambda of: of.spread(3, of.steps)),
    number("rounding", "-", "rounding of the samples", lambda _: RECORD_ROUNDING),
    list_quantity(
        "rounded",
        "q of the rounded record",
        (
            number("q", "-", "q", lambda row: row[0]),
            number("q_robust", "-", "q_robust", lambda row: row[1]),
            number("q_slv_robust", "-", "q_slv_robust", lambda row: row[2]),
        ),
    ),
    number("rounding_spread", "-", "spread of q", lambda of: of.spread(0, of.rounded)),
    number("rounding_spread_robust", "-", "spread of q_robust", lambda of: of.spread(1, of.rounded)),
    number("rounding_spread_slv_robust", "-", "spread of q_slv_robust", lambda of: of.spread(2, of.rounded)),
    numbers("polarities", "-", "q as recorded and reversed", lambda of: of.polarities or None),
)

UNCERTAINTY = (
    text("record", "governing record"),
    whole("polarity", "its sign"),
    object_quantity("solver", "how exact the solver is", SOLVER, identity),
    object_quantity("definition", "how much q depends on its definition", DEFINITION, identity),
)
"""Quantities read from Accuracy."""
