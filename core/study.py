"""The one call that makes results: a case in, a frozen StudyResult out. Window, batch, tests use it."""

import datetime
import hashlib
import os
import threading
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

import numpy as np

from core import closed_forms, records
from core.block import Block
from core.case import Case, Wall
from core.closed_forms import PowerLaw
from core.code_check import Inequality, inequality
from core.errors import Cancelled, InputError
from core.ground_motion import GroundMotion
from core.ida import Fragility, Ida, Search, fragility, incremental_dynamic_analysis
from core.journal import Journal
from core.moment_rotation import MomentLaw
from core.notices import Notice, notice
from core.records.grammar import Options
from core.restitution import Restitution
from core.rocking import METHODS, History, Method, RockingModel, history, rocking_model
from core.units import CM, G
from core.version import VERSION

MEAN_FROM = 7
MINIMUM_FROM = 3
"""Records with a number from which the set takes the mean, and from which the minimum (EN 1998-1
4.3.3.4.3(3): 7 records mean, 3 to 6 the most unfavourable)."""

LARGE_SCALE = 10.0


@dataclass(frozen=True)
class DemandResult:
    """Demand in SI units. pga : a_g S [m/s2]; intensity : SI [m] or None; intensity_source :
    given, records_scaled or None."""

    limit_state: str
    ag: float
    soil_factor: float
    pga: float
    intensity: float | None
    intensity_source: str | None
    q_code: float


@dataclass(frozen=True)
class Run:
    """One wall under one record of one sign. scale : multiplier of the record at q; q_eff : Eq. 12."""

    record: str
    polarity: int
    ida: Ida
    scale: float | None
    q_eff: float | None


@dataclass(frozen=True)
class PerRecord:
    """Governing values of one record: the lower of both signs, quantity by quantity. polarity : of q."""

    record: str
    polarity: int | None
    q: float | None
    q_robust: float | None
    q_slv: float | None
    q_eff: float | None
    intensity: float
    pga: float
    closed_form_q_eff: float
    closed_form_q: float


@dataclass(frozen=True)
class WallResult:
    """Results of one wall and mechanism; set values are None where the set has none."""

    name: str
    wall: Wall
    block: Block
    mechanism: str
    restitution: Restitution
    law: MomentLaw
    model: RockingModel
    runs: tuple[Run, ...]
    per_record: tuple[PerRecord, ...]
    set_rule: str | None
    q_set: float | None
    q_min: float | None
    q_robust_set: float | None
    q_slv_set: float | None
    power_law: PowerLaw | None
    fragility: Fragility | None
    closed_form_q_eff: float | None
    closed_form_q: float | None
    code_check: tuple[Inequality | None, ...]
    warnings: tuple[Notice, ...]

    @property
    def height(self) -> float:
        """H [m] as given, else of the equivalent rectangle."""
        return self.wall.height_m or self.block.height

    @property
    def thickness(self) -> float:
        """t [m] as given, else H tan(alpha)."""
        return self.wall.thickness_m or self.block.thickness


@dataclass(frozen=True)
class StudyResult:
    """Everything that decides. motions : the records, SI units; walls : one entry per mechanism."""

    case: Case
    started_utc: str
    method: Method
    search: Search
    demand: DemandResult | None
    motions: tuple[GroundMotion, ...]
    kinds: tuple[str, ...]
    walls: tuple[WallResult, ...]
    elapsed: float = field(compare=False, default=0.0)

    @property
    def without_number(self) -> list[tuple[str, str, int, str]]:
        """(wall, record, polarity, status) of the runs that end without a q."""
        return [
            (f"{wall.name} ({wall.mechanism})", run.record, run.polarity, run.ida.status)
            for wall in self.walls
            for run in wall.runs
            if run.ida.q is None
        ]


Q_SOURCES = (
    "code",
    "closed_form",
    "time_histories",
    "time_histories_slv",
    "time_histories_robust",
)
"""Sources of q in the checks of Eq. 9, in the order of WallResult.code_check."""


def read_records(case: Case, base_dir: Path) -> tuple[list[GroundMotion], list[str]]:
    """Records of the case in order, globs expanded, and their kinds. Raises InputError."""
    motions, kinds = [], []
    for entry in case.record:
        options = Options(entry.unit, entry.time_step_s, entry.column, entry.skip_lines)
        for path in records.expand(entry.file, base_dir):
            file = _relative(path, base_dir)
            if file in [motion.file for motion in motions]:
                raise InputError(f"record file {file} is in the case twice: leave one out")
            motions.append(replace(records.read(path, options, entry.scale), file=file))
            kinds.append(entry.kind)
    names = [motion.name for motion in motions]
    motions = [
        motion if names.count(motion.name) == 1 else replace(motion, name=motion.file)
        for motion in motions
    ]
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
    book = journal(study_key(case, motions)) if journal else None
    try:
        found = _run_all(
            planned, models, motions, method, search, jobs, book, on_progress, cancelled
        )
    finally:
        if book:
            book.close()
    demand = _demand(case, motions)
    results = []
    for index, (wall, mechanism) in enumerate(walls):
        runs = [
            _run_result(models[index], motions[record], polarity, found[index, record, polarity])
            for i, record, polarity in planned
            if i == index
        ]
        results.append(_wall_result(wall, mechanism, models[index], runs, motions, search, demand))
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return StudyResult(
        case, started.isoformat(timespec="seconds"), method, search, demand,
        tuple(motions), tuple(kinds), tuple(results), elapsed,
    )  # fmt: skip


def study_key(case: Case, motions: list[GroundMotion]) -> str:
    """Key of a study in the journal: version, what is asked, and the samples."""
    parts = [VERSION, repr(case.as_dict())] + [motion.samples_sha256 for motion in motions]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _polarities(mechanism: str, asked: str) -> tuple[int, ...]:
    if mechanism == "two_sided" or asked == "as_recorded":
        return (1,)
    return (-1,) if asked == "reversed" else (1, -1)


def _model(wall: Wall, mechanism: str) -> RockingModel:
    one_sided = mechanism == "one_sided"
    return rocking_model(wall.block(), one_sided, wall.restitution_of(mechanism), wall.moment_law())


def _run_all(planned, models, motions, method, search, jobs, book, on_progress, cancelled):
    """Idas by (wall, record, polarity); independent runs on threads, the kernels hold no lock."""
    found, todo = {}, []
    for entry in planned:
        known = book.get("/".join(map(str, entry))) if book else None
        if known:
            found[entry] = _restored(known)
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
                        book.add("/".join(map(str, entry)), asdict(found[entry]))
                    on_progress(len(found), len(planned))
                if cancelled():
                    raise Cancelled
        finally:
            stop.set()
            for future in waiting:
                future.cancel()
    return found


def _restored(entry: dict) -> Ida:
    """An Ida of the journal; JSON keeps doubles exactly but turns tuples into lists."""
    entry["bracket"] = tuple(entry["bracket"]) if entry["bracket"] else None
    entry["survival_windows"] = tuple(tuple(edges) for edges in entry["survival_windows"])
    return Ida(**entry)


def _run_result(model: RockingModel, motion: GroundMotion, polarity: int, ida: Ida) -> Run:
    scale = q_eff = None
    if ida.q is not None:
        scale = ida.q * G * np.tan(model.slenderness) / motion.pga
        q_eff = closed_forms.effective_q(ida.q, motion.pga)
        scale = float(scale)
    return Run(motion.name, polarity, ida, scale, q_eff)


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


def _lower(values: list[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return min(known) if known else None


def set_value(values: list[float | None]) -> float | None:
    """Value of a set: mean of 7 or more numbers, else their minimum; None without numbers."""
    known = [value for value in values if value is not None]
    if len(known) >= MEAN_FROM:
        return float(np.mean(known))
    return min(known) if known else None


def _per_record(motion: GroundMotion, runs: list[Run], block: Block, one_sided: bool) -> PerRecord:
    with_q = [run for run in runs if run.ida.q is not None]
    lowest = min(with_q, key=lambda run: run.ida.q) if with_q else None
    si = motion.housner_intensity
    shape = (block.slenderness, block.height, si)
    return PerRecord(
        record=motion.name,
        polarity=lowest.polarity if lowest else None,
        q=lowest.ida.q if lowest else None,
        q_robust=_lower([run.ida.q_robust for run in runs]),
        q_slv=_lower([run.ida.q_slv for run in runs]),
        q_eff=lowest.q_eff if lowest else None,
        intensity=si,
        pga=motion.pga,
        closed_form_q_eff=closed_forms.closed_form_q_eff(*shape, one_sided),
        closed_form_q=closed_forms.closed_form_q(*shape, motion.pga, one_sided),
    )


def _wall_result(wall, mechanism, model, runs, motions, search, demand) -> WallResult:
    block, law = wall.block(), wall.moment_law()
    one_sided = mechanism == "one_sided"
    per_record = [
        _per_record(motion, [r for r in runs if r.record == motion.name], block, one_sided)
        for motion in motions
    ]
    numbers = [entry.q for entry in per_record if entry.q is not None]
    incomplete = [run for run in runs if run.ida.status == "impact_limit"]
    rule = None
    if incomplete:
        rule = "incomplete"
    elif runs:
        few = "minimum" if len(numbers) >= MINIMUM_FROM else "too_few"
        rule = "mean" if len(numbers) >= MEAN_FROM else few
    sets = {
        name: None if incomplete else set_value([getattr(entry, name) for entry in per_record])
        for name in ("q", "q_robust", "q_slv")
    }
    with_q = [entry for entry in per_record if entry.q is not None]
    closed_q_eff = closed_q = None
    if demand and demand.intensity:
        shape = (block.slenderness, block.height, demand.intensity)
        closed_q_eff = closed_forms.closed_form_q_eff(*shape, one_sided)
        closed_q = closed_forms.closed_form_q(*shape, demand.pga, one_sided)
    checks = ()
    if demand:
        sources = (demand.q_code, closed_q, sets["q"], sets["q_slv"], sets["q_robust"])
        checks = tuple(
            inequality(source, q, block.threshold_acceleration, demand.pga) if q else None
            for source, q in zip(Q_SOURCES, sources, strict=True)
        )
    restitution = wall.restitution_of(mechanism)
    fragile = fragility([run.ida for run in runs], search)
    return WallResult(
        name=wall.name,
        wall=wall,
        block=block,
        mechanism=mechanism,
        restitution=restitution,
        law=law,
        model=model,
        runs=tuple(runs),
        per_record=tuple(per_record),
        set_rule=rule,
        q_set=sets["q"],
        q_min=min(numbers) if numbers else None,
        q_robust_set=sets["q_robust"],
        q_slv_set=sets["q_slv"],
        power_law=closed_forms.fit_power_law(
            [entry.intensity for entry in with_q], [entry.q_eff for entry in with_q]
        ),
        fragility=fragile,
        closed_form_q_eff=closed_q_eff,
        closed_form_q=closed_q,
        code_check=checks,
        warnings=tuple(
            _model_notices(wall, block, mechanism, restitution, law)
            + _set_notices(runs, numbers, incomplete, fragile, search)
            + _form_notices(block, mechanism, restitution, law, per_record, demand, checks)
        ),
    )


def _model_notices(wall, block, mechanism, restitution, law) -> list[Notice]:
    found = []
    if restitution.model == "costa_upper" and restitution.ratio_at_rest > _housner(block):
        found.append(notice("costa_above_housner", alpha=float(np.degrees(block.slenderness))))
    if mechanism == "one_sided" and not restitution.model.startswith(("one_sided", "user")):
        found.append(notice("hogan", model=restitution.model))
    if not block.is_rectangle:
        found.append(notice("general_height", height=block.height))
        if restitution.model.startswith("one_sided"):
            found.append(notice("general_contact"))
    if not law.is_rigid:
        share = np.sin((1.0 - law.plateau_end) * block.slenderness) / np.sin(block.slenderness)
        found.append(notice("trilinear_threshold", plateau=float(share)))
    return found


def _housner(block: Block) -> float:
    return 1.0 - 2.0 * block.radius**2 / block.inertia_over_mass * np.sin(block.slenderness) ** 2


def _set_notices(runs, numbers, incomplete, fragile, search) -> list[Notice]:
    found = []
    if incomplete:
        found.append(notice("incomplete", n=len(incomplete)))
    elif runs and len(numbers) < MINIMUM_FROM:
        found.append(notice("too_few", n=len(numbers)))
    standing = sum(run.ida.status == "no_collapse_found" for run in runs)
    if standing:
        found.append(notice("no_collapse", n=standing, limit=search.q_limit))
    clamped = sum(run.ida.clamped for run in runs)
    if clamped:
        found.append(notice("clamped", n=clamped))
    if fragile and fragile.n < MEAN_FROM:
        found.append(notice("few_runs", n=fragile.n))
    large = {run.record for run in runs if run.scale and abs(run.scale) > LARGE_SCALE}
    if large:
        found.append(notice("pga_too_small", n=len(large)))
    return found


def _form_notices(block, mechanism, restitution, law, per_record, demand, checks) -> list[Notice]:
    pgas = [(entry.record, entry.pga) for entry in per_record]
    if demand:
        pgas.append(("demand", demand.pga))
    found = closed_forms.range_notices(block.slenderness, block.height, pgas)
    fitted = "one_sided_theoretical" if mechanism == "one_sided" else "housner"
    if restitution.model != fitted or not law.is_rigid:
        used = restitution.model + ("" if law.is_rigid else ", trilinear")
        found.append(notice("eq15_model", fitted=fitted, used=used))
    if demand and demand.intensity_source == "records_scaled":
        found.append(notice("si_from_records", si=demand.intensity / CM))
    if checks:
        histories, robust = checks[2], checks[4]
        if robust and robust.passed and not (histories and histories.passed):
            found.append(notice("only_robust"))
    return found


@dataclass(frozen=True)
class CollapseHistories:
    """Governing record of a wall at its last survived and its collapsing multiplier.

    scales : (survived, collapsing) [-]; histories : of the same; motion : the record.
    """

    wall: WallResult
    motion: GroundMotion
    polarity: int
    scales: tuple[float, float]
    histories: tuple[History, History]


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
