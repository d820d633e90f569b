"""How sure a verdict is: what another sample of records would give, how often its limit states are exceeded, and what
each input does to zeta. Beside the verdict, never part of it."""

import functools
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from core.capacity.ida import multiplier_of
from core.codes.collapse_rate import STATES, StateRate, state_rate
from core.codes.demand import DemandResult
from core.codes.dynamic_check import demand_check
from core.codes.record_sample import RecordPeaks, record_peaks, sample_interval
from core.ground.provenance import station_of
from core.study.kept_checks import KeptChecks
from core.study.plan import Plan
from core.study.progress import Progress
from core.study.results import WallResult, WallVerdict
from core.study.sensitivity import moves, sensitivity_of
from core.study.swings import move_words
from core.study.threads import Threads
from core.study.turned_round import keys_of, reach_of
from core.study.what_if import setting_of
from core.text.sentence import sentence

MOST_INTERVALS = 50
"""Walls of a case up to which the interval is made without being asked for: a tenth of the time of a wall."""


def with_certainty(
    plan: Plan,
    base_dir: Path,
    demand: DemandResult | None,
    results: Sequence[WallResult],
    verdicts: Sequence[WallVerdict],
    book,
    threads: Threads,
    progress: Progress,
) -> tuple[WallVerdict, ...]:
    """The verdicts with what is beside them.

    base_dir, book, threads, progress : as `core.study.run.result_of` takes them
    demand : with what the records add
    Raises Cancelled.
    """
    if demand is None or not verdicts:
        return tuple(verdicts)
    ranges = plan.case.sensitivity
    few = ranges or len(verdicts) <= MOST_INTERVALS
    asked = {k for one in verdicts for k in (one.results if ranges else one.results[:1]) if few}
    tasks = {k: functools.partial(_peaks_of, plan, results[k], demand) for k in sorted(asked)}
    peaks = threads.run(tasks, lambda k, found: None)
    found = []
    for verdict in verdicts:
        worst, known = results[verdict.governing], peaks.get(verdict.governing)
        zeta = worst.assessment.dynamic.zeta if known is not None else 0.0
        interval = sample_interval(known, _felt(plan, worst), zeta) if known is not None else None
        rates = _worst_rates(plan, demand, [results[k] for k in verdict.results])
        found.append(replace(verdict, interval=interval, rates=rates))
    if ranges is None:
        return tuple(found)
    settings = {
        n: setting_of(
            plan.case,
            results[one.governing].part.origin,
            base_dir,
            (demand, plan.motions, plan.kinds),
            KeptChecks(book) if book else demand_check,
        )
        for n, one in enumerate(found)
    }
    made = {n: moves(setting, ranges) for n, setting in settings.items()}
    turned = {n: keys_of(setting) for n, setting in settings.items()}
    left = {n: len(one) + len(turned[n]) for n, one in made.items()}

    def told(place: tuple[int, int | str], _) -> None:
        n = place[0]
        left[n] -= 1
        if not left[n]:
            progress.done(("sensitivity", results[found[n].governing].part.origin))

    work: dict[tuple[int, int | str], Callable] = {(n, m): o.task for n, one in made.items() for m, o in enumerate(one)}
    for n, keys in turned.items():
        work |= {(n, key): functools.partial(reach_of, settings[n], key, given) for key, given in keys.items()}
    zetas = threads.run(work, told)
    for n, verdict in enumerate(found):
        of_it = {m: zetas[n, m] for m in range(len(made[n]))}
        known = [one for k in verdict.results if (one := peaks[k]) is not None]
        hinges = [results[k] for k in verdict.results]
        moved = sensitivity_of(settings[n], ranges, made[n], of_it, hinges, known)
        moved = replace(moved, reach=tuple(zetas[n, key] for key in turned[n]))
        turning = tuple(move_words(one, one.lowest) for one in moved.swings if one.key in moved.turning)
        extra = (sentence("reason", "turned", moves=turning),) if turning else ()
        found[n] = replace(verdict, sensitivity=moved, extra=(*verdict.extra, *extra))
    return tuple(found)


def _felt(plan: Plan, wall: WallResult) -> list:
    """The records as they move a wall."""
    return list(wall.floor.motions) if wall.floor else plan.motions


def _peaks_of(plan: Plan, wall: WallResult, demand: DemandResult, stop) -> RecordPeaks | None:
    """The peaks of a wall under each record; None without a zeta of histories."""
    dynamic = wall.assessment.dynamic if wall.assessment else None
    if dynamic is None or dynamic.zeta is None:
        return None
    signs = tuple(dict.fromkeys(run.polarity for run in dynamic.runs))
    return record_peaks(wall.model, _felt(plan, wall), signs, demand, plan.method, dynamic.zeta, stop)


def capacities(wall: WallResult, motions: list, demand: DemandResult, end: float) -> dict[str, list[float]] | None:
    """a_g on rock [m/s2] at which each record first brings a wall to each limit state, of both signs the lower; a
    search in vain stands for its end. None where a run has no number.

    motions : that move it; end : q_limit of the search
    """
    found: dict[str, list[float]] = {state: [] for state in STATES}
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
            if None in values:
                return None
            multiplier = multiplier_of(min(values), motion.pga, wall.threshold) / demand.scaling(motion)
            found[state].append(float(multiplier) * demand.ag)
    return found


def rates_of(
    wall: WallResult, motions: list, demand: DemandResult, end: float, life: float | None
) -> tuple[StateRate, ...]:
    """How often each limit state of a wall about one hinge is exceeded; empty without hazard, records or a number.
    end, life : q_limit of the search, nominal life [years]"""
    if not demand.hazard or not wall.runs:
        return ()
    found = capacities(wall, motions, demand, end)
    if found is None:
        return ()
    stations = [station_of(motion, k) for k, motion in enumerate(motions)]
    rates = [
        state_rate(state, values, stations, demand.hazard, demand.confidence_factor, life)
        for state, values in found.items()
    ]
    return tuple(rate for rate in rates if rate is not None)


def _worst_rates(plan: Plan, demand: DemandResult, hinges: list[WallResult]) -> tuple[StateRate, ...]:
    """Of the hinge that collapses most often; empty where one has none."""
    asked = plan.case.demand
    life, end = asked.nominal_life_years if asked else None, plan.search.q_limit
    found = [rates_of(one, _felt(plan, one), demand, end, life) for one in hinges]
    return max(found, key=lambda rates: rates[-1].rate) if found and all(found) else ()
