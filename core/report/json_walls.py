"""Keys of the results JSON that only some walls have: loads, ties, limit states, variants."""

import math
from dataclasses import asdict

from core.codes.assumption import Assumption, Shown
from core.codes.kinematic import Kinematic
from core.report.tie_words import elongations
from core.report.verdict_words import outcome_of
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.variants import comparisons, wall_comparisons
from core.study.wall_verdict import assumptions_of, deciding, where
from core.text.sentence import Sentence
from core.units import G
from core.variation.limit_states import STATES
from core.variation.swings import Sensitivity, move_words


def loads(wall: WallResult) -> dict:
    """The key loads of a wall that has some: a and c of both sides, of a one-sided wall of its outward one."""
    if not wall.wall.load or wall.wall.bends:
        return {}
    model = wall.model
    sides = [model.restoring, model.mirrored][: 1 if model.one_sided else 2]
    return {
        "loads": {
            "a": sides[0].sine,
            "c": sides[0].cosine,
            "collapse_rotation_rad": model.collapse_rotation,
            "uplift_g": model.threshold / G,
            "sides": [{"a": side.sine, "c": side.cosine} for side in sides],
        }
    }


def bending(mechanism: Kinematic) -> dict:
    """The key bending of a wall held at its top: the hinge between, of each check, and where the
    multiplier of the displacement check is zero."""
    found, moved = mechanism.chain.bending, mechanism.moved.bending
    if found is None or moved is None:
        return {}
    return {
        "bending": {
            "hinge_m": found.h1,
            "hinge_of_displacement_m": moved.h1,
            "d_c0_m": moved.d_c0,
            "theta_0_rad": moved.theta0,
            "top_kn_m": 1e-3 * found.top_force,
        }
    }


def tie_design(wall: WallResult) -> dict:
    """The key tie_design of the base hinge of a wall for which one is asked."""
    tie = wall.assessed.tie if wall.assessment else None
    if tie is None:
        return {}

    def kilo(force: float | None) -> float | None:
        return None if force is None else 1e-3 * force

    return {
        "tie_design": {
            "height_m": tie.height,
            "forces_kn_m": {name: kilo(force) for name, force in tie.forces.items()},
            "histories_missing": tie.missing,
            "force_kn_m": kilo(tie.force),
            "asked_kn_m": kilo(tie.asked),
            "at_least_kn_m": kilo(tie.at_least),
            "check": tie.check,
            "largest_kn_m": kilo(tie.largest),
            "elongation_m": tie.elongation,
            "stands_m": tie.stands,
            "zeta": tie.zeta,
            "hinges": tie.hinges,
            "spacing_m": tie.spacing,
            "diameter_mm": tie.diameter,
            "thread_mm": tie.thread,
            "heights": [{"height_m": height, "nonlinear_kn_m": kilo(force)} for height, force in tie.curve],
        }
    }


def ties(wall: WallResult) -> dict:
    """The key ties of a wall that has some: what each holds and stands, and how far it is stretched."""
    found = wall.wall.in_si.ties
    if not found:
        return {}
    return {
        "ties": [
            {
                "height_m": tie.bar.height,
                "strength_kn_m": 1e-3 * tie.bar.strength,
                "per_bar_kn": None if tie.per_bar is None else 1e-3 * tie.per_bar,
                "parts_kn": {name: 1e-3 * held for name, held in tie.parts},
                "weakest": tie.weakest or None,
                "elongation_at_yield_m": tie.bar.elongation_at_yield,
                "stands_m": tie.bar.stands,
                "elongation_m": elongations(wall, tie.bar),
            }
            for tie in found
        ]
    }


def limit_states(wall: WallResult) -> dict:
    """The key limit_states of a wall of a site whose hazard is given."""
    if not wall.assessment or not wall.assessed.states:
        return {}
    return {
        "limit_states": [
            {
                "limit_state": one.state,
                "return_period_years": one.return_period,
                "ag_g": one.ag / G,
                "check": one.check,
                "zeta": one.zeta,
                "code": one.code,
            }
            for one in wall.assessed.states
        ]
    }


def body(wall: WallResult) -> dict:
    """The key body of a wall that is no rectangle: about the outer edge of its base, without what it carries."""
    found = wall.wall.in_si.body
    if found is None:
        return {}
    x, z = found.centroid
    solids = [
        {
            "plane": part.plane,
            "opening": part.weight < 0.0,
            "wedge": part.wedge,
            "polygon_m": [list(corner) for corner in part.polygon],
            "from_m": part.ends[0],
            "to_m": part.ends[1],
            "x0_m": part.start,
            "angle_deg": math.degrees(part.angle),
            "unit_weight_kn_m3": 1e-3 * abs(part.weight),
            "mass_kg": part.body.mass,
        }
        for part in wall.wall.parts
    ]
    about: dict[str, object] = {"mass_kg": found.mass, "x_g_m": x, "z_g_m": z, "i_o_kgm2": found.inertia}
    if wall.model.other is not None:
        far = wall.model.other
        about["inner"] = {
            "slenderness_deg": math.degrees(far.slenderness),
            "frequency_parameter_rad_s": math.sqrt(far.p2),
            "velocity_ratio": far.ratio_at_rest,
        }
    return {"body": about | {"solids": solids}}


def verdicts(result: StudyResult) -> dict:
    """The key verdicts: one a wall of the case, empty without a demand."""
    return {"verdicts": [_verdict(one, result) for one in result.verdicts]}


def _said(sentences: tuple[Sentence, ...]) -> list[dict]:
    return [{"key": one.code, "text_it": one.text("it"), "text_en": one.text("en")} for one in sentences]


def _assumption(row: Assumption) -> dict:
    """A row of the table of assumptions; what has words is in English."""

    def plain(value: Shown) -> float | str:
        return value.text("en") if isinstance(value, Sentence) else value

    return {
        "key": row.key,
        "value": plain(row.value),
        "source": row.source,
        "other_end": plain(row.other_end),
        "zeta": row.zeta,
        "outcome": row.outcome,
        "turns": row.turns,
        "reason": row.reason,
        "text_it": row.words.text("it"),
        "text_en": row.words.text("en"),
    }


def _verdict(one: WallVerdict, result: StudyResult) -> dict:
    wall = result.walls[one.governing]
    found, check = wall.assessed.verdict, deciding(wall)
    return {
        "wall": one.wall.name,
        "variant": one.wall.variant,
        "code": found.code,
        "zeta_e": found.zeta_e,
        "zeta_least": one.zeta_least,
        "zeta_target": found.zeta_target,
        "pga_c_g": one.risk.pga / G if one.risk else None,
        "return_period_c_years": one.risk.return_period if one.risk else None,
        "is_v": one.risk.index if one.risk else None,
        "is_v_letter": one.risk.letter if one.risk else None,
        "hinge_m": wall.part.hinge,
        "mechanism": wall.mechanism,
        "check": found.governing,
        "clause": check.clause if check else None,
        "text_it": found.text("it", one.title, where(wall)),
        "text_en": found.text("en", one.title, where(wall)),
        "decides": found.decides.text("en") if found.decides else "",
        "to_do": _said(found.to_do),
        "assumptions": [_assumption(row) for row in assumptions_of(result, one)],
        "limits": _said((*found.limits, *one.extra)),
        "notes": _said(found.notes),
        "hinges": [
            {
                "hinge_m": result.walls[k].part.hinge,
                "mechanism": result.walls[k].mechanism,
                "code": result.walls[k].assessed.verdict.code,
                "zeta_e": result.walls[k].assessed.verdict.zeta_e,
                "check": result.walls[k].assessed.verdict.governing,
            }
            for k in one.results
        ],
        "states": {
            state: {"code": of.code, "zeta_e": of.zeta, "check": of.check}
            for state in STATES
            for of in [one.states[state]]
        },
        "interval": asdict(one.interval) if one.interval else None,
        "rates": [asdict(rate) for rate in one.rates],
        "sensitivity": _sensitivity(one.sensitivity) if one.sensitivity else None,
    }


def _sensitivity(found: Sensitivity) -> dict:
    return {
        "base_zeta": found.base,
        "moves": [
            {
                "input": one.key,
                "given": one.given,
                "ends": [
                    {
                        "value": end.value,
                        "record": end.name or None,
                        "zeta": end.zeta,
                        "satisfied": end.sure,
                        "text_it": move_words(one, end).text("it"),
                        "text_en": move_words(one, end).text("en"),
                    }
                    for end in one.ends
                ],
            }
            for one in found.swings
        ],
        "without_effect": list(found.still),
        "refused": [
            {"input": key, "text_it": error.text("it"), "text_en": error.text("en")} for key, error in found.refused
        ],
        "turning": list(found.turning),
        "at_target": [
            {
                "input": one.key,
                "given": one.given,
                "by_check": one.by_check,
                "satisfied_throughout": list(one.throughout),
            }
            for one in found.reach
        ],
    }


def _compared(result: StudyResult, one: WallVerdict) -> dict:
    wall = result.walls[one.governing]
    code, check = outcome_of(result, one)
    zeta = wall.assessed.verdict.zeta_e if wall.assessment else None
    return {"code": code, "zeta_e": zeta, "zeta_least": one.zeta_least, "check": check, "q_set": wall.q_set}


def variants(result: StudyResult) -> dict:
    """The key variants of a study with walls before and after, each by the hinge that decides; without a demand by q of
    each hinge and mechanism."""
    found: list[dict] = [
        {
            "name": one.name,
            "changed": list(one.changed),
            "before": _compared(result, one.before),
            "after": _compared(result, one.after),
        }
        for one in wall_comparisons(result.verdicts)
    ]
    if not result.verdicts:
        found = [
            {
                "name": pair.name,
                "changed": list(pair.changed),
                "before": {"q_set": pair.before.q_set},
                "after": {"q_set": pair.after.q_set},
            }
            for pair in comparisons(result.walls)
        ]
    return {"variants": found} if found else {}
