"""Keys of the results JSON that only some walls have: loads, tie, limit states, variants."""

from core.study.results import StudyResult, WallResult
from core.study.variants import Comparison, comparisons
from core.units import G


def loads(wall: WallResult) -> dict:
    """The key loads of a wall that has some: a and c of both sides, of a one-sided wall of its outward one."""
    if not wall.wall.load:
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


def tie_design(wall: WallResult) -> dict:
    """The key tie_design of a wall for which one is asked."""
    tie = wall.assessment.tie if wall.assessment else None
    if tie is None:
        return {}
    return {
        "tie_design": {
            "height_m": tie.height,
            "check": tie.check,
            "force_kn_m": None if tie.force is None else 1e-3 * tie.force,
            "zeta": tie.zeta,
            "largest_kn_m": 1e-3 * tie.largest,
            "hinges": tie.hinges,
            "governing_force_kn_m": None if tie.governing is None else 1e-3 * tie.governing,
            "alpha0": tie.alpha0,
            "moments_kn": [1e-3 * moment for moment in tie.holding],
            "pushing_kn": 1e-3 * tie.pushing,
        }
    }


def limit_states(wall: WallResult) -> dict:
    """The key limit_states of a wall of a site whose hazard is given."""
    if not wall.assessment or not wall.assessment.states:
        return {}
    return {
        "limit_states": [
            {
                "limit_state": one.state,
                "return_period_years": one.return_period,
                "ag_g": one.ag / G,
                "check": one.check,
                "zeta": one.zeta,
            }
            for one in wall.assessment.states
        ]
    }


def _comparison(one: Comparison) -> dict:
    before, after = ({
        "zeta_e": wall.assessment.verdict.zeta_e if wall.assessment else None,
        "governing": wall.assessment.verdict.governing if wall.assessment else None,
        "q_set": wall.q_set,
    } for wall in (one.before, one.after))  # fmt: skip
    return {
        "name": one.name,
        "mechanism": one.before.mechanism,
        "changed": list(one.changed),
        "before": before,
        "after": after,
    }


def variants(result: StudyResult) -> dict:
    """The key variants of a study with walls before and after."""
    found = comparisons(result.walls)
    return {"variants": [_comparison(one) for one in found]} if found else {}
