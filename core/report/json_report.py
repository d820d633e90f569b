"""StudyResult -> the results JSON: exact values, the contract of the program."""

import itertools
import json
import math
from dataclasses import asdict
from typing import Any

from core.capacity.accuracy import ROUNDING, Accuracy
from core.codes.dynamic_check import DemandCheck
from core.codes.eq9 import LABEL
from core.codes.kinematic import Displacement, Kinematic
from core.codes.record_compatibility import Compliance
from core.file_names import shown
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import provenance
from core.report import place_lines
from core.report.json_walls import bending, body, limit_states, loads, tie_design, ties, variants, verdicts
from core.report.selection_words import selection_keys
from core.study.results import Q_SOURCES, Assessment, Run, StudyResult, WallResult
from core.units import CM, G
from core.version import NAME, VERSION, commit

_ENCODER = json.JSONEncoder(indent=1, allow_nan=False, ensure_ascii=False)


def _text(value: Any, depth: int) -> bytes:
    """JSON text of a value that lies so deep; raises ValueError should a number not be finite."""
    return _ENCODER.encode(value).replace("\n", "\n" + " " * depth).encode()


def results(result: StudyResult) -> dict:
    """The results as a mapping of the contract's keys; numbers are exact or None."""
    walls = [_wall(wall, result) for wall in result.walls]
    return {**_head(result), **verdicts(result), "walls": walls, **variants(result)}


def _head(result: StudyResult) -> dict:
    """What stands before the verdicts."""
    return {
        "program": {"name": NAME, "version": VERSION, "commit": commit()},
        "started_utc": result.started_utc,
        "case": result.case.as_dict(),
        "case_sha256": result.case.sha256,
        **({"drawings": [dict(note.values) for note in result.case.drawings]} if result.case.drawings else {}),
        "demand": demand_keys(result) if result.demand else None,
        "records": record_keys(result),
        **({"selection": selection_keys(result.selection)} if result.selection else {}),
    }


def dumps(result: StudyResult) -> str:
    """The results as JSON text; raises ValueError should a number not be finite."""
    text = JsonReport()
    for wall in result.by_wall():
        text.add(wall)
    return text.content(result).decode()


class JsonReport:
    """The results as JSON text, made while the walls of a study finish."""

    def __init__(self):
        self._verdicts: list[bytes] = []
        self._walls: list[bytes] = []

    def add(self, result: StudyResult) -> None:
        """The next wall, see `StudyResult.by_wall`. Raises ValueError should a number not be finite."""
        self._verdicts += [_text(one, 2) for one in verdicts(result)["verdicts"]]
        self._walls += [_text(_wall(wall, result), 2) for wall in result.walls]

    def content(self, result: StudyResult) -> bytes:
        """The file, once all walls are there. Raises ValueError should a number not be finite."""
        parts = {
            **{key: [_text(value, 1)] for key, value in _head(result).items()},
            "verdicts": _listed(self._verdicts),
            "walls": _listed(self._walls),
            **{key: [_text(value, 1)] for key, value in variants(result).items()},
        }
        pieces = [b"{"]
        for key, value in parts.items():
            pieces += [b"\n " if len(pieces) == 1 else b",\n ", _text(key, 1), b": ", *value]
        return b"".join([*pieces, b"\n}\n"])


def _listed(items: list[bytes]) -> list[bytes]:
    """Pieces of a list of the first level."""
    if not items:
        return [b"[]"]
    between = (piece for item in items for piece in (b",\n  ", item))
    return [b"[\n  ", *itertools.islice(between, 1, None), b"\n ]"]


def record_keys(result: StudyResult) -> list[dict]:
    """The key records."""
    return [_record(motion, kind) for motion, kind in zip(result.motions, result.kinds, strict=True)]


def demand_keys(result: StudyResult) -> dict:
    """The key demand of a study that has one."""
    demand = result.required
    return {
        "limit_state": demand.limit_state,
        "ag_g": demand.ag / G,
        "soil_factor": demand.soil_factor,
        "pga_g": demand.pga / G,
        "housner_intensity_cm": demand.intensity / CM if demand.intensity else None,
        "intensity_source": demand.intensity_source,
        "spectrum": demand.target.name if demand.target else None,
        "confidence_factor": demand.confidence_factor,
        "zeta_target": demand.zeta_target,
        "confidence_on": demand.confidence_on,
        "return_period_years": demand.return_period,
        "hazard": [{"return_period_years": years, "ag_g": ag / G} for years, ag in demand.hazard],
        "demand_scaling": demand.record_scaling,
        "compliance": _compliance(result.compliance) if result.compliance else None,
        "warnings": [warning.text() for warning in demand.warnings],
        **({"site": place_lines.as_json(result.case.site)} if result.case.site else {}),
    }


def _compliance(compliance: Compliance) -> dict:
    return {
        "compatible": compliance.compatible,
        "period_range_s": list(compliance.period_range),
        "stations": compliance.stations,
        "rules": [asdict(rule) for rule in compliance.rules],
    }


def _demand_check(check: DemandCheck | None) -> dict | None:
    if check is None:
        return None
    runs = [asdict(run) for run in check.runs]
    for run in runs:
        del run["motion"]  # the file names its records
    branch = check.branch
    stated = branch and {
        "modulus_mpa": 1e-6 * branch.modulus,
        "assumed": branch.assumed,
        "period_s": branch.period,
        "limit": branch.limit,
        "own_period_s": branch.own_period,
    }
    return {**asdict(check), "runs": runs, "branch": stated}


def _without_friction(mechanism: Kinematic, confidence: float) -> dict | None:
    """alpha0, e*, M* and a0* of the whole wall, where those beside them are of its upper part with the friction of
    return walls."""
    sums = mechanism.chain
    if sums.alpha0_friction is None:
        return None
    return {
        "alpha0": sums.alpha0,
        "e_star": sums.e_star,
        "m_star": None if sums.mass is None else sums.e_star * sums.mass,
        "a0_star_g": sums.alpha0 / (sums.e_star * confidence),
    }


def _displacement(found: Displacement) -> dict:
    """The displacement check of a wall without its ties."""
    values = {"d_limit_m": found.limit, "a_limit_m_s2": found.capacity, "period_s": found.period}
    return {**values, "s_de_m": found.demand, "zeta": found.ratio}


def _assessment(assessment: Assessment | None, confidence: float) -> dict:
    """The keys demand_check, lower_bound_check, kinematic_check and verdict of a wall. confidence : FC."""
    if assessment is None:
        return {"demand_check": None, "kinematic_check": None, "verdict": None}
    verdict = assessment.verdict
    mechanism = assessment.kinematic
    return {
        "demand_check": _demand_check(assessment.dynamic),
        "lower_bound_check": _demand_check(assessment.lower_bound),
        "kinematic_check": {
            "alpha0": mechanism.alpha0,
            "alpha0_without_ties": mechanism.chain.alpha0_bare,
            "e_star": mechanism.e_star,
            "m_star": mechanism.m_star,
            "a0_star_g": mechanism.a0 / G,
            "friction_height_m": mechanism.chain.friction_height,
            "without_friction": _without_friction(mechanism, confidence),
            "d0_m": mechanism.d0,
            "d0_with_ties_m": mechanism.chain.d0_with_ties,
            "d_limit_m": mechanism.d_limit,
            **bending(mechanism),
            "period_s": mechanism.period,
            "s_de_m": mechanism.s_de,
            "without_ties": None if mechanism.without_ties is None else _displacement(mechanism.without_ties),
            "free_element": mechanism.free_element,
            "period_0_s": mechanism.period_0,
            "acceleration_demand_g": mechanism.acceleration_demand / G
            if mechanism.acceleration_demand is not None
            else None,
            "zeta_sld": mechanism.zeta_sld,
            "missing": list(mechanism.missing),
            "checks": [
                {
                    "check": check.name,
                    "clause": check.clause,
                    "q": check.q,
                    "unit": check.unit,
                    "capacity": check.capacity,
                    "demand": check.demand,
                    "zeta": check.zeta,
                    "passed": check.passed,
                }
                for check in assessment.checks
            ],
        }
        if mechanism
        else None,
        "verdict": {
            "code": verdict.code,
            "governing": verdict.governing,
            "zeta_e": verdict.zeta_e,
            "zeta_target": verdict.zeta_target,
            "reasons": [reason.text() for reason in verdict.reasons],
            "text_it": verdict.text("it"),
            "text_en": verdict.text("en"),
            "lower_bound_zeta": verdict.lower_bound,
        },
    }


def _risk(wall: WallResult) -> dict:
    """The key risk of a wall that has a zeta."""
    found = wall.assessed.risk if wall.assessment else None
    if found is None:
        return {}
    decides = wall.assessed.verdict.governing == "dynamic"
    dynamic = wall.assessed.dynamic if decides else None
    return {
        "risk": {
            "pga_c_g": found.pga / G,
            "return_period_c_years": found.return_period,
            "other_return_period_c_years": found.other_return_period,
            "zeta_16": dynamic.zeta_16 if dynamic else None,
            "zeta_first": dynamic.zeta_first if dynamic else None,
            "return_period_c_shown": found.years,
            "is_v": found.index,
            "is_v_letter": found.letter,
        }
    }


def _floor(wall: WallResult) -> dict:
    """The key floor of a wall above the ground; period, damping and participation of each mode."""
    floor, found = wall.floor, wall.assessment
    if floor is None:
        return {}
    return {
        "floor": {
            "z_m": floor.z,
            "a_z_g": floor.spectrum.a_z / G if floor.spectrum else None,
            "period_s": [mode.period for mode in floor.modes],
            "period_estimated": floor.estimated,
            "damping": [mode.damping for mode in floor.modes],
            "participation": [mode.participation for mode in floor.modes],
            "motions": [{"record": m.name, "pfa_g": m.pga / G, "time_step_s": m.time_step} for m in floor.motions],
            "code_over_records_min": found.code_over_records if found else None,
            "sensitivity": found.sensitivity if found else {},
        }
    }


def _uncertainty(accuracy: Accuracy | None) -> dict:
    """The key uncertainty of a wall, where it was asked for: solver and definition kept apart."""
    if accuracy is None:
        return {}
    return {
        "uncertainty": {
            "record": accuracy.record,
            "polarity": accuracy.polarity,
            "solver": {
                "method": accuracy.method,
                "q": accuracy.q,
                "q_reference": accuracy.q_reference,
                "reference": "dormand_prince",
                "q_difference": accuracy.solver_q_difference,
                "history_difference": accuracy.history_difference,
                "history_bound": accuracy.history_bound,
                "noise_effect": accuracy.noise_effect if math.isfinite(accuracy.noise_effect) else None,
                "scale": accuracy.scale,
                "histories": [
                    {"method": p.name, "option": p.option, "seconds": p.seconds, "error": p.error}
                    for p in accuracy.points
                ],
            },
            "definition": {
                "steps": [{"q_step": s, "q": q, "q_robust": r} for s, q, r in accuracy.steps],
                "step_spread": accuracy.spread(1, accuracy.steps),
                "step_spread_robust": accuracy.spread(2, accuracy.steps),
                "rounding": ROUNDING,
                "rounded": [{"q": q, "q_robust": r} for q, r in accuracy.rounded],
                "rounding_spread": accuracy.spread(0, accuracy.rounded),
                "rounding_spread_robust": accuracy.spread(1, accuracy.rounded),
                "polarities": list(accuracy.polarities) if accuracy.polarities else None,
            },
        }
    }


def _record(motion: GroundMotion, kind: str) -> dict:
    return {"name": motion.name, "kind": kind, "scale": motion.scale, **record_measures(motion)}


def record_measures(motion: GroundMotion) -> dict:
    """Source and measures of a motion, in the units of the contract."""
    return {
        "file": shown(motion.file),
        "file_sha256": motion.file_sha256,
        "samples_sha256": motion.samples_sha256,
        "format": motion.format,
        "time_step_s": motion.time_step,
        "samples": int(motion.acceleration.size),
        "unit": motion.unit,
        "pga_g": motion.pga / G,
        "pgv_cm_s": motion.pgv / CM,
        "pgd_cm": motion.pgd / CM,
        "arias_m_s": motion.arias,
        "duration_5_95_s": motion.duration_5_95,
        "provenance": asdict(provenance(motion)),
        "housner_intensity_cm": motion.housner_intensity / CM,
        "lines": dict(zip(("head", "samples", "others"), motion.lines, strict=True)) if motion.lines else None,
        "warnings": [warning.text() for warning in motion.warnings],
    }


def _run(run: Run, wall: WallResult, result: StudyResult) -> dict:
    ida = run.ida
    method = result.method_of(wall, run.motion)
    return {
        "record": run.record,
        "polarity": run.polarity,
        "status": ida.status,
        "q": ida.q,
        "bracket": list(ida.bracket) if ida.bracket else None,
        "q_slv": ida.q_slv,
        "q_slv_low": ida.q_slv_low,
        "q_slc": ida.q_slc,
        "q_robust": ida.q_robust,
        "collapse_scale": run.scale,
        "q_eff": run.q_eff,
        "q_last_survival": ida.q_last_survival,
        "survived_fraction": ida.survived_fraction,
        "survival_windows": [list(edges) for edges in ida.survival_windows],
        "q_step": result.search.q_step,
        "analyses": ida.analyses,
        "impact_limited": ida.impact_limited,
        "clamped": ida.clamped,
        "method": {"name": method.name, "order": method.order},
    }


def _wall(wall: WallResult, result: StudyResult) -> dict:
    block, bends = wall.block, wall.wall.bends
    law = wall.power_law
    return {
        "name": wall.name,
        "height_m": wall.height,
        "thickness_m": wall.thickness,
        "slenderness_deg": math.degrees(block.slenderness),
        "radius_m": None if bends else block.radius,
        "frequency_parameter_rad_s": None if bends else block.frequency_parameter,
        "threshold_acceleration_g": wall.threshold / G,
        "mechanism": wall.mechanism,
        "restitution": None if bends else wall.restitution.model,
        "velocity_ratio": None if bends else wall.restitution.ratio_at_rest,
        "law": None if bends else wall.wall.law,
        "runs": [_run(run, wall, result) for run in wall.runs],
        "per_record": [
            {
                "record": entry.record,
                "polarity": entry.polarity,
                "q": entry.q,
                "q_robust": entry.q_robust,
                "q_slv": entry.q_slv,
                "q_slv_low": entry.q_slv_low,
                "q_eff": entry.q_eff,
                "housner_intensity_cm": entry.intensity / CM,
                "closed_form_q_eff": entry.closed_form_q_eff,
                "closed_form_q": entry.closed_form_q,
            }
            for entry in wall.per_record
        ],
        "set_rule": wall.set_rule,
        "q_set": wall.q_set,
        "q_min": wall.q_min,
        "q_robust_set": wall.q_robust_set,
        "q_slv_set": wall.q_slv_set,
        "q_slv_low_set": wall.q_slv_low_set,
        "power_law": {"c1": law.c1, "c2": law.c2, "r_squared": law.r_squared, "n": law.n} if law else None,
        "fragility": {
            "q_05": wall.fragility.q_05,
            "q_16": wall.fragility.q_16,
            "q_50": wall.fragility.q_50,
            "n": wall.fragility.n,
        }
        if wall.fragility
        else None,
        "code_check": [
            {
                "check": LABEL,
                "q_source": source,
                "q": check.q if check else None,
                "capacity_a_rm_g": wall.model.threshold / G,
                "demand_g": check.demand / G if check else None,
                "ratio": check.ratio if check else None,
                "passed": check.passed if check else None,
            }
            for source, check in zip(Q_SOURCES, wall.code_check, strict=False)
        ],
        "scale_free_law": [asdict(estimate) for estimate in wall.estimates],
        **body(wall),
        **loads(wall),
        **ties(wall),
        **tie_design(wall),
        **limit_states(wall),
        **_assessment(wall.assessment, result.required.confidence_factor if result.demand else 1.0),
        **_floor(wall),
        **_risk(wall),
        **_uncertainty(wall.accuracy),
        "warnings": [warning.text() for warning in wall.warnings],
    }
