"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import datetime
import hashlib
import os
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from core import compile_beside, records
from core.accuracy import Accuracy, accuracy
from core.assessment import assess
from core.case import Case, Wall
from core.compliance import compliance, period_range
from core.demand import demand_of, generated, with_records
from core.errors import InputError
from core.ground_motion import GroundMotion
from core.ida import Ida, Search, incremental_dynamic_analysis, threshold_of
from core.journal import Journal, Memory
from core.kernel_cache import FOLDER, STAMP, record
from core.kinematic import kinematic
from core.limits import multiplier_of
from core.records.grammar import Options
from core.results import CollapseHistories, Run, StudyResult, WallResult
from core.rocking import AUTO, METHODS, RockingModel, concrete, history, rocking_model, scan
from core.threads import Threads
from core.version import VERSION
from core.wall_result import run_result, wall_result


def twice(file: str, twin: str) -> str:
    """The sentence about a record that another one of the case repeats."""
    return f"{file} is in the case twice (the same samples as {twin}): leave one out"


def read_records(case: Case, base_dir: Path) -> tuple[list[GroundMotion], list[str]]:
    """Records of the case in order, globs expanded, and their kinds. Raises InputError."""
    motions, kinds, seen = [], [], {}
    for k, entry in enumerate(case.record, start=1):
        if not entry.include:
            continue
        options = Options(entry.unit, entry.time_step_s, entry.column, entry.skip_lines)
        try:
            for path in records.expand(entry.file, base_dir):
                file = _relative(path, base_dir)
                motion = replace(records.read(path, options, entry.scale), file=file)
                twin = seen.setdefault(motion.samples_sha256, file)
                if twin != file or file in [known.file for known in motions]:
                    raise InputError(twice(file, twin))
                motions.append(motion)
                kinds.append(entry.kind)
        except InputError as error:
            raise InputError(f"record {k}: {error}") from None
    names = [motion.name for motion in motions]
    if len(set(names)) < len(names):
        motions = [replace(motion, name=motion.file) for motion in motions]
    return motions, kinds


def _relative(path: Path, base_dir: Path) -> str:
    try:
        return Path(os.path.relpath(path, base_dir)).as_posix()
    except ValueError:  # another drive
        return path.as_posix()


def run(
    case: Case,
    *,
    base_dir: Path,
    jobs: int = 1,
    journal: Callable[[str], Journal | Memory] | None = None,
    on_progress: Callable[[int, int], None] = lambda done, planned: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> StudyResult:
    """Run a study.

    base_dir : folder record paths start from; jobs : threads, which change no result; journal : makes
    the Journal of finished runs from the study's key; on_progress(done, planned) and cancelled() are
    called from this thread, the latter from the workers as well.
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started = datetime.datetime.now(datetime.UTC)
    demand = demand_of(case, base_dir)
    motions, kinds = read_records(case, base_dir)
    made = generated(case, demand) if demand else []
    motions, kinds = motions + made, kinds + ["artificial"] * len(made)
    method = METHODS.get(case.analysis.method, AUTO)
    chosen = case.analysis
    search = Search(chosen.q_step, chosen.q_limit, chosen.map_span, chosen.robust_window)
    walls = [(wall, mechanism) for wall in case.wall for mechanism in wall.mechanisms()]
    signs = [_polarities(mechanism, chosen.polarity) for _, mechanism in walls]
    planned = [
        (index, record, polarity)
        for index in range(len(walls))
        for record in range(len(motions))
        for polarity in signs[index]
    ]
    models = [_model(wall, mechanism) for wall, mechanism in walls]
    mechanisms = [
        kinematic(wall, mechanism, demand) if demand and not wall.above_ground else None
        for wall, mechanism in walls
    ]
    longest = max((found.period or 0.0 for found in mechanisms if found), default=0.0)
    if demand and demand.target and motions:
        period_range(kinds, longest, demand)  # refused before hours of work, not after
    _compile_beside(method, models, motions)
    book = journal(f"{VERSION} {STAMP}") if journal else None
    assessed = len(walls) if demand else 0
    total = len(planned) + assessed
    try:
        threads = Threads(jobs, cancelled)
        threads.run({k: motion.measure for k, motion in enumerate(motions)}, lambda k, _: None)
        found = _run_all(planned, models, motions, method, search, threads, book,
                         lambda done: on_progress(done, total))  # fmt: skip
        if demand:
            demand = with_records(demand, motions)
        rules = compliance(motions, kinds, demand, longest) if demand else None
        by_wall: dict[int, list] = {}
        for entry in planned:
            wall, number, polarity = entry
            one = run_result(models[wall], motions[number], polarity, found[entry])
            by_wall.setdefault(wall, []).append(one)
        results = [
            wall_result(wall, mechanism, models[k], by_wall.get(k, []), motions, search, demand)
            for k, (wall, mechanism) in enumerate(walls)
        ]
        if demand:
            checks = {
                k: lambda stop, k=k: assess(
                    results[k],
                    mechanisms[k],
                    motions,
                    signs[k],
                    demand,
                    rules,
                    method,
                    search,
                    stop,
                )
                for k in range(len(walls))
            }
            done = threads.run(
                checks, lambda k, _: None, lambda n: on_progress(len(planned) + n, total)
            )
            results = [replace(wall, assessment=done[k]) for k, wall in enumerate(results)]
        if chosen.accuracy:
            statements = {
                k: lambda stop, wall=wall: accuracy_of(wall, motions, method, search, stop)
                for k, wall in enumerate(results)
            }
            said = threads.run(statements, lambda k, _: None)
            results = [replace(wall, accuracy=said[k]) for k, wall in enumerate(results)]
    finally:
        record(FOLDER)
        if book:
            book.close()
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        case, started.isoformat(timespec="seconds"), method, search, demand,
        tuple(motions), tuple(kinds), tuple(results), rules, elapsed,
    )  # fmt: skip


def accuracy_of(wall: WallResult, motions, method, search, cancelled) -> Accuracy | None:
    """The statement on the governing run of a wall; None without a q."""
    lowest = lowest_run(wall)
    if lowest is None:
        return None
    motion = next(motion for motion in motions if motion.name == lowest.record)
    other = next(
        (r.ida.q for r in wall.runs if r.record == lowest.record and r.polarity != lowest.polarity),
        None,
    )
    return accuracy(
        motion, lowest.polarity, lowest.ida, other, wall.model, method, search, cancelled
    )


def lowest_run(wall: WallResult) -> Run | None:
    """The run with the lowest q of a wall; None without a collapse."""
    runs = [run for run in wall.runs if run.ida.q is not None]
    return min(runs, key=lambda run: run.ida.q) if runs else None


def warm(case: Case, motion: GroundMotion) -> None:
    """Make the kernels of a case ready: a few analyses of its first wall."""
    wall = case.wall[0]
    model = _model(wall, wall.mechanisms()[0])
    method = METHODS.get(case.analysis.method, AUTO)
    _compile_beside(method, [model], [motion])
    ground, dt = motion.acceleration, motion.time_step
    scales = np.full(16, multiplier_of(1.1, motion.pga, threshold_of(model)))
    scan(method, ground, dt, scales, model, np.zeros(16, np.int64), np.zeros(16))
    history(ground, dt, scales[0], model, method)


def _compile_beside(method, models, motions) -> None:
    steps = {motion.time_step for motion in motions}
    compile_beside.start({concrete(method, model, dt).name for model in models for dt in steps})


def run_key(model: RockingModel, motion: GroundMotion, polarity: int, method, search) -> str:
    """Key of a run in the journal: all that decides its result, and nothing else."""
    parts = (tuple(model), motion.samples_sha256, polarity, method, search)
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def _polarities(mechanism: str, asked: str) -> tuple[int, ...]:
    if mechanism == "two_sided" or asked == "as_recorded":
        return (1,)
    return (-1,) if asked == "reversed" else (1, -1)


def _model(wall: Wall, mechanism: str) -> RockingModel:
    one_sided = mechanism == "one_sided"
    return rocking_model(wall.block(), one_sided, wall.restitution_of(mechanism), wall.moment_law())


def _run_all(planned, models, motions, method, search, threads, book, on_progress):
    """Idas by (wall, record, polarity)."""
    found, todo, keys = {}, {}, {}

    def search_of(entry):
        wall, record, polarity = entry
        motion = motions[record]
        return lambda stop: incremental_dynamic_analysis(
            motion.acceleration, motion.time_step, motion.pga, polarity, models[wall], method, search,
            stop,
        )  # fmt: skip

    for entry in planned:
        wall, record, polarity = entry
        keys[entry] = run_key(models[wall], motions[record], polarity, method, search)
        known = _restored(book.get(keys[entry])) if book else None
        if known:
            found[entry] = known
        else:
            todo[entry] = search_of(entry)

    def keep(entry, ida: Ida) -> None:
        if book:
            book.add(keys[entry], asdict(ida))

    on_progress(len(found))
    restored = len(found)
    found.update(threads.run(todo, keep, lambda done: on_progress(restored + done)))
    return found


def _restored(entry: dict | None) -> Ida | None:
    """An Ida of the journal, None where there is none or its line is damaged; JSON keeps doubles
    exactly but turns tuples into lists."""
    if entry is None:
        return None
    try:
        windows = tuple(tuple(edges) for edges in entry["survival_windows"])
        bracket = tuple(entry["bracket"]) if entry["bracket"] else None
        return Ida(**{**entry, "bracket": bracket, "survival_windows": windows})
    except (TypeError, KeyError):
        return None


def collapse_histories(result: StudyResult, wall: WallResult) -> CollapseHistories | None:
    """Integrate the governing record of a wall again on both sides of its first collapse; None
    without a collapse. The governing record is the one with the lowest q."""
    lowest = lowest_run(wall)
    if lowest is None:
        return None
    motion = next(motion for motion in result.motions if motion.name == lowest.record)
    scales = tuple(
        lowest.polarity * multiplier_of(q, motion.pga, threshold_of(wall.model))
        for q in lowest.ida.bracket
    )
    pair = tuple(
        history(motion.acceleration, motion.time_step, scale, wall.model, result.method)
        for scale in scales
    )
    return CollapseHistories(wall, motion, lowest.polarity, scales, pair)
