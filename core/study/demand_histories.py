"""Histories of a wall at the demand: those that decide its dynamic check."""

import math
from dataclasses import dataclass

import numpy as np

from core.codes.dynamic_check import DemandRun, model_and_scale_at_demand
from core.ground.ground_motion import GroundMotion
from core.rocking.history import History, integrate_history
from core.study.results import StudyResult, WallResult


@dataclass(frozen=True)
class DemandHistory:
    """One record and sign at the demand, FC included as in the check.

    displacement : of the control point, d_0 where nothing holds the wall [m], at the samples of the motion
    """

    run: DemandRun
    motion: GroundMotion
    history: History
    displacement: np.ndarray


def deciding_runs(wall: WallResult) -> list[DemandRun]:
    """The run of the largest rotation (or that overturns); where the mean decides also that nearest to it."""
    check = wall.assessment.dynamic if wall.assessment else None
    if check is None:
        return []
    worst = max(check.runs, key=lambda run: math.inf if run.peak_ratio is None else run.peak_ratio)
    mean = check.mean_peak_ratio
    if check.set_rule != "mean" or mean is None:
        return [worst]
    nearest = min(check.runs, key=lambda run: math.inf if run.peak_ratio is None else abs(run.peak_ratio - mean))
    return [worst] if nearest is worst else [worst, nearest]


def demand_histories(result: StudyResult, wall: WallResult) -> list[DemandHistory]:
    """The deciding runs of the dynamic check, integrated again; empty without that check."""
    histories = []
    for run in deciding_runs(wall):
        motion, one = history_at_demand(result, wall, run)
        histories.append(DemandHistory(run, motion, one, control_displacement(wall, one.rotation)))
    return histories


def history_at_demand(result: StudyResult, wall: WallResult, run: DemandRun) -> tuple[GroundMotion, History]:
    """The motion of a run of the dynamic check and the history of the wall under it, with FC and the elastic branch
    as in the check."""
    motion, demand, check = result.motion_of(wall, run.motion), result.demand, wall.required_assessment.dynamic
    assert demand is not None and check is not None
    model, factor = model_and_scale_at_demand(wall.governing_model, demand, check.confidence_on, motion)
    return motion, integrate_history(motion.acceleration, motion.time_step, run.polarity * factor, model, result.method)


def control_displacement(wall: WallResult, rotation: np.ndarray) -> np.ndarray:
    """d [m] of the control point (C8.7.1.4)."""
    kinematic = wall.required_assessment.kinematic
    assert kinematic is not None
    return np.sign(rotation) * kinematic.chain.displacement(np.abs(rotation))
