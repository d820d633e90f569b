"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import datetime
import hashlib
import os
import threading
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from core import records
from core.case import Case, Wall
from core.errors import Cancelled, InputError
from core.ground_motion import GroundMotion
from core.ida import Ida, Search, incremental_dynamic_analysis
from core.journal import Journal
from core.kernel_cache import FOLDER, STAMP, record
from core.records.grammar import Options
from core.results import CollapseHistories, DemandResult, StudyResult, WallResult
from core.rocking import METHODS, RockingModel, history, rocking_model
from core.units import CM, G
from core.version import VERSION
from core.wall_result import run_result, wall_result


def read_records(case: Case, base_dir: Path) -> tuple[list[GroundMotion], list[str]]:
    """Records of the case in order, globs expanded, and their kinds. Raises InputError."""
    motions, kinds, seen = [], [], {}
    for k, entry in enumerate(case.record, start=1):
        options = Options(entry.unit, entry.time_step_s, entry.column, entry.skip_lines)
        try:
            for path in records.expand(entry.file, base_dir):
                file = _relative(path, base_dir)
                motion = replace(records.read(path, options, entry.scale), file=file)
                twin = seen.setdefault(motion.samples_sha256, file)
                if twin != file or file in [known.file for known in motions]:
                    raise InputError(
                        f"{file} is in the case twice (the same samples as {twin}): leave one out"
                    )
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
    journal: Callable[[str], Journal] | None = None,
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
    motions, kinds = read_records(case, base_dir)
    method = METHODS["taylor" if case.analysis.method == "auto" else case.analysis.method]
    chosen = case.analysis
    search = Search(chosen.q_step, chosen.q_limit, chosen.map_span, chosen.robust_window)
    walls = [(wall, mechanism) for wall in case.wall for mechanism in wall.mechanisms()]
    planned = [
        (index, record, polarity)
        for index, (_, mechanism) in enumerate(walls)
        for record in range(len(motions))
        for polarity in _polarities(mechanism, chosen.polarity)
    ]
    models = [_model(wall, mechanism) for wall, mechanism in walls]
    book = journal(f"{VERSION} {STAMP}") if journal else None
    try:
        found = _run_all(
            planned, models, motions, method, search, jobs, book, on_progress, cancelled
        )
    finally:
        record(FOLDER)
        if book:
            book.close()
    demand = _demand(case, motions)
    results = []
    for index, (wall, mechanism) in enumerate(walls):
        runs = [
            run_result(models[index], motions[record], polarity, found[index, record, polarity])
            for i, record, polarity in planned
            if i == index
        ]
        results.append(wall_result(wall, mechanism, models[index], runs, motions, search, demand))
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        case, started.isoformat(timespec="seconds"), method, search, demand,
        tuple(motions), tuple(kinds), tuple(results), elapsed,
    )  # fmt: skip


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


def _run_all(planned, models, motions, method, search, jobs, book, on_progress, cancelled):
    """Idas by (wall, record, polarity); independent runs on threads, the kernels hold no lock."""
    found, todo, keys = {}, [], {}
    for entry in planned:
        wall, record, polarity = entry
        keys[entry] = run_key(models[wall], motions[record], polarity, method, search)
        known = _restored(book.get(keys[entry])) if book else None
        if known:
            found[entry] = known
        else:
            todo.append(entry)
    stop = threading.Event()

    def one(entry) -> Ida:
        wall, record, polarity = entry
        motion = motions[record]
        return incremental_dynamic_analysis(
            motion.acceleration, motion.time_step, motion.pga, polarity, models[wall],
            method, search, lambda: stop.is_set() or cancelled(),
        )  # fmt: skip

    on_progress(len(found), len(planned))
    with ThreadPoolExecutor(max(1, jobs)) as pool:
        waiting: dict[Future, tuple] = {pool.submit(one, entry): entry for entry in todo}
        try:
            while waiting:
                done, _ = wait(waiting, timeout=0.1, return_when=FIRST_COMPLETED)
                for future in done:
                    entry = waiting.pop(future)
                    found[entry] = future.result()
                    if book:
                        book.add(keys[entry], asdict(found[entry]))
                    on_progress(len(found), len(planned))
                if cancelled():
                    raise Cancelled
        finally:
            stop.set()
            for future in waiting:
                future.cancel()
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


def _demand(case: Case, motions: list[GroundMotion]) -> DemandResult | None:
    asked = case.demand
    if asked is None:
        return None
    pga = asked.ag_g * G * asked.soil_factor
    intensity, source = None, None
    if asked.housner_intensity_cm is not None:
        intensity, source = asked.housner_intensity_cm * CM, "given"
    elif motions:
        scaled = [motion.housner_intensity * pga / motion.pga for motion in motions]
        intensity, source = float(np.mean(scaled)), "records_scaled"
    return DemandResult(
        asked.limit_state, asked.ag_g * G, asked.soil_factor, pga, intensity, source, asked.q_code
    )


def collapse_histories(result: StudyResult, wall: WallResult) -> CollapseHistories | None:
    """Integrate the governing record of a wall again on both sides of its first collapse; None
    without a collapse. The governing record is the one with the lowest q."""
    runs = [run for run in wall.runs if run.ida.q is not None]
    if not runs:
        return None
    lowest = min(runs, key=lambda run: run.ida.q)
    motion = next(motion for motion in result.motions if motion.name == lowest.record)
    to_scale = lowest.polarity * wall.block.threshold_acceleration / motion.pga
    scales = tuple(to_scale * q for q in lowest.ida.bracket)
    pair = tuple(
        history(motion.acceleration, motion.time_step, scale, wall.model, result.method)
        for scale in scales
    )
    return CollapseHistories(wall, motion, lowest.polarity, scales, pair)
