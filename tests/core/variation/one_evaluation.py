"""Walls that are evaluated in a millisecond: by the checks of the clauses alone, or with histories that are stated."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.codes.dynamic_check import DynamicCheck
from core.ground.ground_motion import GroundMotion
from core.setting.plan import make_plan, read_inputs
from core.variation.assumptions import look_at
from core.variation.evaluate import evaluate
from core.variation.favourable_wall_inputs import favourable_inputs
from tests.clauses_alone import parse_case

NTC = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
BARE = {"name": "w", "height_m": 4.0, "thickness_m": 0.4, "mechanism": "one_sided", "base_z_m": 0.0}
BARE |= {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "contact", "evidence": {"kind": "opening"}}]}
BARE |= {"hinge_setback_m": 0.1}
"""A wall whose hinge lies deeper inside its edge than that of any masonry: alpha_0 is 0.1 / 2."""

WALL = BARE | {"unloaded_confirmed": True}
SOIL = {"ag_g": 0.1, "soil_factor": 1.0}
"""A demand without a spectrum: the linear check alone, zeta = q alpha_0 / (FC 0.1)."""

MOTION = GroundMotion("r", np.sin(np.arange(200) / 10.0), 0.01)


def scene_of(wall=WALL, demand=SOIL, k=0, **more):
    """The k-th scene of a case with one wall."""
    case = parse_case({"wall": [wall], "demand": demand, **more})
    inputs = read_inputs(case, Path())
    return make_plan(case, inputs).scene(k, inputs[0])


def history(zeta, passed=True, **values):
    """What histories say."""
    return DynamicCheck("SLV", (), 0, 0.1, 0.2, "mean", 0.4, zeta, passed, passed, **values)


def with_histories(scene, found, ground=(MOTION,), **changes):
    """A scene whose histories are stated. found(model, motions, demand) : what they say"""

    def stated(model, motions, signs, demand, *_):
        return found(model, motions, demand)

    return replace(scene, **({"ground": ground, "histories": stated, "histories_off": False} | changes))


def looked_at(result, k=0):
    """Code of an input that a clause asks about -> its row, whether it turns anything or not, of a wall that fails too;
    the k-th result of a run."""
    plan = make_plan(result.case, (result.demand, list(result.motions), list(result.kinds)))
    wall = result.walls[k]
    scene = replace(plan.scene(k, result.demand, result.compliance), q_slv=(wall.q_slv_safe_set, wall.q_slv_set))
    evaluation = evaluate(scene)
    looked = ((one.code, look_at(evaluation, one, True)) for one in favourable_inputs(evaluation))
    return {code: found.row for code, found in looked if found is not None}
