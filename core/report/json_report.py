"""StudyResult -> the results JSON: exact values, the contract of the program."""

import json
import math

from core.code_check import LABEL
from core.ground_motion import GroundMotion
from core.results import Q_SOURCES, DemandResult, Run, StudyResult, WallResult
from core.units import CM, G
from core.version import NAME, VERSION, commit


def results(result: StudyResult) -> dict:
    """The results as a mapping of the contract's keys; numbers are exact or None."""
    return {
        "program": {"name": NAME, "version": VERSION, "commit": commit()},
        "started_utc": result.started_utc,
        "case": result.case.as_dict(),
        "case_sha256": result.case.sha256,
        "demand": _demand(result.demand) if result.demand else None,
        "records": [
            _record(motion, kind) for motion, kind in zip(result.motions, result.kinds, strict=True)
        ],
        "walls": [_wall(wall, result) for wall in result.walls],
    }


def dumps(result: StudyResult) -> str:
    """The results as JSON text; raises ValueError should a number not be finite."""
    return json.dumps(results(result), indent=1, allow_nan=False, ensure_ascii=False) + "\n"


def _demand(demand: DemandResult) -> dict:
    return {
        "limit_state": demand.limit_state,
        "ag_g": demand.ag / G,
        "soil_factor": demand.soil_factor,
        "pga_g": demand.pga / G,
        "housner_intensity_cm": demand.intensity / CM if demand.intensity else None,
        "intensity_source": demand.intensity_source,
    }


def _record(motion: GroundMotion, kind: str) -> dict:
    return {
        "name": motion.name,
        "file": motion.file,
        "kind": kind,
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
        "housner_intensity_cm": motion.housner_intensity / CM,
        "warnings": [warning.text() for warning in motion.warnings],
    }


def _run(run: Run, result: StudyResult) -> dict:
    ida = run.ida
    return {
        "record": run.record,
        "polarity": run.polarity,
        "status": ida.status,
        "q": ida.q,
        "bracket": list(ida.bracket) if ida.bracket else None,
        "q_slv": ida.q_slv,
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
        "method": {"name": result.method.name, "order": result.method.order},
    }


def _wall(wall: WallResult, result: StudyResult) -> dict:
    block = wall.block
    law = wall.power_law
    return {
        "name": wall.name,
        "height_m": wall.height,
        "thickness_m": wall.thickness,
        "slenderness_deg": math.degrees(block.slenderness),
        "radius_m": block.radius,
        "frequency_parameter_rad_s": block.frequency_parameter,
        "threshold_acceleration_g": block.threshold_acceleration / G,
        "mechanism": wall.mechanism,
        "restitution": wall.restitution.model,
        "velocity_ratio": wall.restitution.ratio_at_rest,
        "law": wall.wall.law,
        "runs": [_run(run, result) for run in wall.runs],
        "per_record": [
            {
                "record": entry.record,
                "polarity": entry.polarity,
                "q": entry.q,
                "q_robust": entry.q_robust,
                "q_slv": entry.q_slv,
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
        "power_law": {"c1": law.c1, "c2": law.c2, "r_squared": law.r_squared, "n": law.n}
        if law
        else None,
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
                "capacity_a_rm_g": block.threshold_acceleration / G,
                "demand_g": check.demand / G if check else None,
                "ratio": check.ratio if check else None,
                "passed": check.passed if check else None,
            }
            for source, check in zip(Q_SOURCES, wall.code_check, strict=False)
        ],
        "warnings": [warning.text() for warning in wall.warnings],
    }
