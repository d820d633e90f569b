"""How sure a verdict is: what another sample of records would give, how often its limit states are exceeded, what each
input does to zeta; and what would make a wall that fails pass. Beside the verdict, never part of it."""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from core.capacity.ida import multiplier_of
from core.case.site import Demand
from core.codes.collapse_rate import RATE_STATES, StateRate, state_rate, typical_rate
from core.codes.demand import SeismicDemand
from core.codes.dynamic_check import run_dynamic_check
from core.codes.outcomes import FAILS, OUTCOMES, min_if_all_known
from core.codes.record_sample import RecordPeaks, SampleInterval, record_peaks, sample_interval
from core.errors import InputError
from core.ground.provenance import MIN_STATIONS, station_of
from core.setting.demand_input import rescaled_pga
from core.setting.plan import FloorCache, Plan
from core.study.check_cache import CheckCache, check_key
from core.study.journal import dataclass_from_json
from core.study.progress import Progress
from core.study.results import WallResult, WallVerdict
from core.text.sentence import Number, sentence
from core.threads import Batch, Work
from core.variation.inverse_design import design_keys, find_target_value
from core.variation.measures import find_measures
from core.variation.sensitivity import evaluate_move, leave_one_out_moves, list_input_moves, summarise_sensitivity
from core.variation.swings import Sensitivity, describe_swing_end
from core.variation.wall_evaluation import WallContext, evaluate_wall, make_wall_context, replace_wall

AG_RANGE = 0.01, 100.0
"""Least and largest multiple of a_g between which S follows it."""

MAX_WALLS_WITH_INTERVAL = 50
"""Walls of a case up to which the interval is made without being asked for: a tenth of the time of a wall."""


def add_uncertainty(
    plan: Plan,
    base_dir: Path,
    demand: SeismicDemand,
    ag: Callable[[float], float] | None,
    results: Sequence[WallResult],
    verdict: WallVerdict,
    journal,
    progress: Progress,
) -> Work:
    """The work whose result is the verdict of a wall with what is beside it.

    base_dir, journal, progress : as `core.study.run.run_plan` takes them
    demand : with what the records add
    ag : of `make_ag_function`, made once for all walls; None without a hazard
    results : of the wall, to which the verdict points
    """
    verdict = yield from _with_interval(plan, demand, results, verdict, journal)
    if ag is not None:
        verdict = replace(verdict, rates=_worst_rates(plan, demand, [results[k] for k in verdict.results], ag))
    if plan.case.sensitivity is not None:
        verdict = yield from _with_sensitivity(plan, base_dir, demand, results, verdict, journal, progress)
    return verdict


def add_measures(
    plan: Plan, base_dir: Path, demand: SeismicDemand, results: Sequence[WallResult], verdict: WallVerdict, journal
) -> Work:
    """The work whose result is the verdict of a wall, of one that fails with what would make it pass, of another one
    with what it would come to but for what is set aside; the parameters are those of `add_uncertainty`."""
    worst = results[verdict.governing]
    kept = CheckCache(journal) if journal else run_dynamic_check
    setting = make_wall_context(plan.case, worst.part.origin, base_dir, (demand, plan.motions, plan.kinds), kept)
    if OUTCOMES[worst.required_assessment.verdict.code].judgement != FAILS:
        lower = _zeta_with_set_aside(setting, verdict) if verdict.wall.set_aside else None
        told = () if lower is None else (sentence("reason", "set_aside_has", zeta=Number(lower)),)
        return replace(verdict, extra=(*verdict.extra, *told))
    sought = plan.case.wall[worst.part.origin].sought
    found = yield Batch({"measures": functools.partial(find_measures, setting, sought=sought)})
    return replace(verdict, measures=found["measures"])


def _zeta_with_set_aside(setting: WallContext, verdict: WallVerdict) -> float | None:
    """zeta of a wall by the checks of the clauses, what is set aside looked at; None where it is no lower than the
    lowest there is, or not known."""
    whole = replace(setting.case.wall[0], set_aside=(), hinge_heights=None)
    try:
        changed = replace(replace_wall(setting, whole), inputs=(setting.demand, [], []))
        zeta = evaluate_wall(changed).zeta
    except InputError:
        return None
    least = verdict.zeta_least
    return zeta if zeta is not None and (least is None or zeta < least) else None


def _with_interval(
    plan: Plan, demand: SeismicDemand, results: Sequence[WallResult], verdict: WallVerdict, journal
) -> Work:
    """Add to a verdict the interval of its records, that of the worst hinge; kept in the journal."""
    worst = results[verdict.governing]
    decides = worst.assessment is not None and worst.assessment.verdict.governing == "dynamic"
    dynamic = worst.assessment.dynamic if worst.assessment is not None and decides else None
    # where a wall fails at what is required and stands above, the share of multipliers around says nothing of a sample
    if dynamic is None or dynamic.zeta is None or dynamic.limited:
        return verdict
    if len(plan.case.wall) > MAX_WALLS_WITH_INTERVAL and plan.case.sensitivity is None:
        return verdict
    by_name = yield Batch({"interval": lambda stop: _interval(plan, worst, demand, journal, stop)})
    return replace(verdict, interval=by_name["interval"])


def _interval(plan: Plan, wall: WallResult, demand: SeismicDemand, journal, stop) -> SampleInterval | None:
    """Interval of zeta of one hinge whose histories have a zeta; taken from the journal where it is there."""
    motions, zeta = _felt(plan, wall), _zeta(wall)
    assert zeta is not None
    parts = wall.governing_model, motions, _signs(wall), demand, plan.method, zeta, "interval"
    key = check_key(*parts) if journal else ""
    known = dataclass_from_json(SampleInterval, journal.get(key)) if journal else None
    if known is not None:
        return known
    interval = sample_interval(_peaks_of(plan, wall, demand, zeta, stop), motions, zeta)
    if journal and interval:
        journal.add(key, asdict(interval))
    return interval


def _with_sensitivity(
    plan: Plan,
    base_dir: Path,
    demand: SeismicDemand,
    results: Sequence[WallResult],
    verdict: WallVerdict,
    journal,
    progress: Progress,
) -> Work:
    """Add to a verdict the moves of its inputs; the parameters are those of `add_uncertainty`."""
    ranges, origin = plan.case.sensitivity, results[0].part.origin
    assert ranges is not None
    kept = CheckCache(journal) if journal else run_dynamic_check
    setting = make_wall_context(plan.case, origin, base_dir, (demand, plan.motions, plan.kinds), kept)
    hinges = [results[k] for k in verdict.results]
    known = [hinge.assessment for hinge in hinges if hinge.assessment is not None]
    if min_if_all_known(one.verdict.zeta_e for one in known) is None:
        progress.done(("sensitivity", origin))
        return replace(verdict, sensitivity=Sensitivity(None, (), (), ()))
    made, turned = list_input_moves(setting, ranges), design_keys(setting)
    zetas = [zeta for hinge in hinges if (zeta := _zeta(hinge)) is not None]
    if ranges.record_left_out and len(zetas) == len(hinges) and len(plan.motions) > 1:
        tasks = enumerate(zip(hinges, zetas, strict=True))
        peaks = yield Batch({k: functools.partial(_peaks_of, plan, one, demand, zeta) for k, (one, zeta) in tasks})
        made += leave_one_out_moves([peaks[k] for k in range(len(hinges))])
    floors = FloorCache()
    work: dict[tuple[str, int | str], Callable] = {
        ("move", m): functools.partial(evaluate_move, setting, move, floors) for m, move in enumerate(made)
    }
    work |= {("reach", key): functools.partial(find_target_value, setting, key, given) for key, given in turned.items()}
    done = yield Batch(work)
    progress.done(("sensitivity", origin))
    moved = summarise_sensitivity(setting, ranges, made, [done["move", m] for m in range(len(made))], known)
    moved = replace(moved, reach=tuple(done["reach", key] for key in turned))
    turning = tuple(describe_swing_end(swing, swing.turning) for swing in moved.swings if swing.key in moved.turning)
    extra = (sentence("reason", "turned", moves=turning),) if turning else ()
    return replace(verdict, sensitivity=moved, extra=(*verdict.extra, *extra))


def _felt(plan: Plan, wall: WallResult) -> list:
    """The records as they move a wall."""
    return list(wall.floor.motions) if wall.floor else plan.motions


def _zeta(wall: WallResult) -> float | None:
    """zeta of the histories of a wall; None without them."""
    dynamic = wall.assessment.dynamic if wall.assessment else None
    return dynamic.zeta if dynamic else None


def _signs(wall: WallResult) -> tuple[int, ...]:
    """Signs each record was taken with."""
    dynamic = wall.assessment.dynamic if wall.assessment else None
    return tuple(dict.fromkeys(run.polarity for run in dynamic.runs)) if dynamic else ()


def _peaks_of(plan: Plan, wall: WallResult, demand: SeismicDemand, zeta: float, stop) -> RecordPeaks:
    """The peaks of a wall under each record. zeta : of its histories"""
    return record_peaks(wall.governing_model, _felt(plan, wall), _signs(wall), demand, plan.method, zeta, stop)


def make_ag_function(demand: SeismicDemand, asked: Demand | None, base_dir: Path) -> Callable[[float], float]:
    """a_g on rock [m/s2] of a multiplier of the demand: that whose a_g S is as many times as large, for S of NTC 2018
    follows a_g. asked : of the case"""
    if asked is None or demand.target is None:
        return lambda multiplier: multiplier * demand.ag
    factors = np.geomspace(*AG_RANGE, 400)
    shares = [rescaled_pga(demand, asked, base_dir, float(factor)) / demand.pga for factor in factors]

    def found(multiplier: float) -> float:
        inside = float(np.clip(multiplier, shares[0], shares[-1]))
        factor = math.exp(np.interp(math.log(inside), np.log(shares), np.log(factors)))
        return factor * multiplier / inside * demand.ag

    return found


def record_capacities(
    wall: WallResult, motions: list, demand: SeismicDemand, end: float, ag: Callable[[float], float]
) -> dict[str, list[float]] | None:
    """a_g on rock [m/s2] at which each record first brings a wall to each limit state, of both signs the lower; a
    search in vain stands for its end. None where a run has no number.

    motions : that move it; end : q_limit of the search; ag : of `make_ag_function`
    """
    ag_values: dict[str, list[float]] = {state: [] for state in RATE_STATES}
    for k, motion in enumerate(motions):
        idas = [run.ida for run in wall.runs if run.motion == k]
        if not idas or any(ida.status not in ("collapse_found", "no_collapse_found") for ida in idas):
            return None
        by_state = {"SLD": [1.0]} | {
            state: [end if value is None and ida.q is None else value for ida, value in values]
            for state, values in (
                ("SLV", [(ida, ida.q_slv) for ida in idas]),
                ("SLC", [(ida, ida.q_slc) for ida in idas]),
                ("collapse", [(ida, ida.q) for ida in idas]),
            )
        }
        for state, values in by_state.items():
            known = [value for value in values if value is not None]
            if len(known) < len(values):
                return None
            multiplier = multiplier_of(min(known), motion.pga, wall.threshold) / demand.scaling(motion)
            ag_values[state].append(ag(float(multiplier)))
    return ag_values


def _worst_rates(
    plan: Plan, demand: SeismicDemand, hinges: list[WallResult], ag: Callable[[float], float]
) -> tuple[StateRate, ...]:
    """How often each limit state is exceeded, of the hinge where that is most often; empty without hazard and records,
    and where a hinge has no number. ag : of `make_ag_function`"""
    if not demand.hazard or not all(hinge.runs for hinge in hinges):
        return ()
    by_hinge = [record_capacities(hinge, _felt(plan, hinge), demand, plan.search.q_limit, ag) for hinge in hinges]
    known = [one for one in by_hinge if one is not None]
    names = [station_of(motion, k) for k, motion in enumerate(_felt(plan, hinges[0]))]
    if len(known) < len(by_hinge) or len(set(names)) < MIN_STATIONS:
        return ()
    asked = plan.case.demand
    life = asked.nominal_life_years if asked else None
    rates = []
    for state in RATE_STATES:
        worst = max((one[state] for one in known), key=lambda values: typical_rate(values, demand.hazard))
        rates.append(state_rate(state, worst, names, demand.hazard, demand.confidence_factor, life))
    return tuple(rate for rate in rates if rate is not None)
