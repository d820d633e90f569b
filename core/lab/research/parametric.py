"""A parametric study: every cell of its grids under its motions, one row a run."""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.capacity.ida import Ida, Search, incremental_dynamic_analysis
from core.case.study_file import Cell, Group, Shape, Study, cells_of, read_record_list
from core.codes import target_spectrum
from core.codes.spectrum_codes import CODES
from core.codes.target_spectrum import CodeSpectrum
from core.errors import InputError, RecordError
from core.file_names import name_of
from core.ground import records
from core.ground.artificial import compatible_motion
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import provenance
from core.jit import cache, stamp
from core.known import require_value
from core.lab.research import natural_set
from core.rocking.methods import METHODS
from core.setting.record_input import read_records
from core.study.check_cache import run_key
from core.study.journal import Journal
from core.study.progress import OnProgress, Progress, StartTime, run_cost
from core.threads import Threads
from core.units import G
from core.version import VERSION
from core.wall.rocking_model import RockingModel, rocking_model

COPY_TOLERANCE = 1e-4
"""Largest difference of two copies of a motion that files round differently [of its peak]."""


@dataclass(frozen=True)
class StudySpectrum:
    """One target spectrum of a study. intensity : SI [m], Eq. 11."""

    name: str
    group: str
    target: CodeSpectrum
    intensity: float


@dataclass(frozen=True)
class StudyMotion:
    """One motion of a study; spectrum and group "" and seed None of a natural record, event "" of a generated one."""

    motion: GroundMotion
    spectrum: str = ""
    group: str = ""
    seed: int | None = None
    event: str = ""


class Row(NamedTuple):
    """One run: a cell under a motion of one sign. Numbers as of `Ida`; motion : index in the study."""

    cell: Cell
    motion: int
    polarity: int
    status: str
    q: float | None
    low: float | None
    q_slv: float | None
    q_slc: float | None
    q_robust: float | None
    survived_fraction: float | None
    analyses: int


@dataclass(frozen=True)
class ParametricResult:
    """A finished study.

    refused : (file, error) of the records that could not be read, or are vertical
    missing : names of the records of the named set that the folder does not hold
    restored : runs an earlier start had finished
    elapsed : [s], of this start
    """

    study: Study
    sha256: str
    quick: bool
    started: str
    spectra: tuple[StudySpectrum, ...]
    motions: tuple[StudyMotion, ...]
    rows: tuple[Row, ...]
    refused: tuple[tuple[str, RecordError], ...]
    restored: int
    elapsed: float
    missing: tuple[str, ...] = ()


def target_of(shape: Shape, pga: float) -> CodeSpectrum:
    """The spectrum of this shape with a_g S = pga [m/s2]. Raises InputError where no a_g gives it."""
    code = CODES[shape.code]
    rock = [shape.soil, *(require_value(getattr(shape, key)) for key in code.keys)]
    # S falls with a_g: from below, the fixed point comes to the smallest a_g
    ag = pga / code.make(1e-6 * G, *rock).soil
    for _ in range(2000):
        target = code.make(ag, *rock)
        if abs(target.pga - pga) <= 1e-12 * pga:
            return target
        ag = pga / target.soil
    raise InputError("study_no_pga", key="pga_g", pga=pga / G)


def spectra_of(study: Study) -> list[tuple[StudySpectrum, Shape]]:
    """The target spectra of a study and their shapes. Raises InputError."""

    def one(group: Group, shape: Shape) -> StudySpectrum:
        target = target_of(shape, group.pga_g * G)
        return StudySpectrum(shape.name, group.name, target, target_spectrum.housner_intensity(target))

    return [(one(group, shape), shape) for group in study.group for shape in group.spectrum]


def folder_records(folder: Path) -> tuple[list[GroundMotion], list[tuple[str, RecordError]]]:
    """Every acceleration record below a folder, and the files that are none."""
    motions, refused = [], []
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = path.relative_to(folder).as_posix()
        try:
            motions.append(records.read(path, name=name))
        except RecordError as error:
            refused.append((name, error))
    return motions, refused


def one_motion(first: GroundMotion, second: GroundMotion) -> bool:
    """Whether both are the same samples but for their scale and what files round."""
    if (first.time_step, first.acceleration.size) != (second.time_step, second.acceleration.size):
        return False
    apart = first.acceleration / first.pga - second.acceleration / second.pga
    return float(np.abs(apart).max()) <= COPY_TOLERANCE


def event_of(motion: GroundMotion) -> str:
    """The earthquake of a natural record, as its file names it; else its date, else how its name begins."""
    known = provenance(motion)
    return known.event or known.date or motion.name[:8]


class Natural(NamedTuple):
    """The natural records of a study.

    refused : files that are none, or vertical; missing : records of the named set that the folder does not hold
    """

    motions: list[StudyMotion]
    refused: list[tuple[str, RecordError]]
    missing: list[str]


def natural_motions(study: Study, base_dir: Path, records_from: Path | None) -> Natural:
    """The horizontal records of a study, of those of one motion the first.

    records_from : a folder, or a TOML file of [[record]] tables. Raises InputError.
    """
    motions: list[GroundMotion] = []
    refused: list[tuple[str, RecordError]] = []
    events: dict[int, str] = {}
    missing: list[natural_set.NamedRecord] = []
    if study.record:
        motions = read_records(study, base_dir)[0]
    if records_from is not None and records_from.is_dir() and study.natural:
        path = base_dir / name_of(study.natural)
        found, missing = natural_set.find(natural_set.read_set(path), records_from)
        if not found:
            raise InputError("study_no_named_record", place=(records_from,), n=len(missing), path=path)
        events = {id(motion): one.event for one, motion in found}
        motions += [motion for _, motion in found]
    elif records_from is not None and records_from.is_dir():
        more, refused = folder_records(records_from)
        if not more:
            raise InputError("study_no_record", place=(records_from,))
        motions += more
    elif records_from is not None:
        motions += read_records(read_record_list(records_from), records_from.parent)[0]
    kept: list[GroundMotion] = []
    for motion in motions:
        if any(warning.code == "vertical" for warning in motion.warnings):
            refused.append((motion.name, RecordError("vertical_component")))
        elif not any(one_motion(motion, other) for other in kept):
            kept.append(motion)
    named = [StudyMotion(motion, event=events.get(id(motion)) or event_of(motion)) for motion in kept]
    return Natural(named, refused, [one.name for one in missing])


def model_of(cell: Cell) -> RockingModel:
    """The numbers of a cell's wall for the kernels."""
    wall = cell.wall
    restitution = wall.restitution_of(cell.mechanism)
    return rocking_model(wall.block(), cell.kinematics.one_way, restitution, wall.moment_law())


def run(
    study: Study,
    sha256: str,
    *,
    base_dir: Path,
    records_from: Path | None = None,
    quick: bool = False,
    jobs: int = 1,
    journal: Callable[[str], Journal] | None = None,
    on_progress: OnProgress = lambda done, planned, left: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> ParametricResult:
    """Run a parametric study.

    sha256 : of the study's file
    base_dir : folder the records of the file start from
    records_from : natural records beside those of the file: a folder, or a TOML file of [[record]] tables
    quick : only said in the result; the study is already the shortened one
    jobs : threads, which change no result
    journal, on_progress, cancelled : as of `core.study.run.run`
    Raises InputError for what the user can mend, Cancelled when cancelled() is true.
    """
    started = StartTime()
    threads = Threads(jobs, cancelled)
    spectra = spectra_of(study)
    natural = natural_motions(study, base_dir, records_from)
    motions = _generated(study, spectra, threads) + natural.motions
    threads.run({k: entry.motion.measure for k, entry in enumerate(motions)})
    finished = journal(f"{VERSION} {stamp.source_stamp()}") if journal else None
    try:
        rows, restored = _rows(study, motions, threads, finished, on_progress)
    finally:
        cache.record(cache.folder())
    return ParametricResult(
        study,
        sha256,
        quick,
        started.utc,
        tuple(entry for entry, _ in spectra),
        tuple(motions),
        rows,
        tuple(natural.refused),
        restored,
        started.elapsed,
        missing=tuple(natural.missing),
    )


def _generated(study: Study, spectra, threads: Threads) -> list[StudyMotion]:
    """The motions of every spectrum, in order."""
    wanted = [(spectrum, seed) for spectrum, shape in spectra for seed in range(shape.seed, shape.seed + study.count)]
    tasks = {
        k: lambda stop, target=spectrum.target, seed=seed: compatible_motion(target, seed)
        for k, (spectrum, seed) in enumerate(wanted)
    }
    made = threads.run(tasks)
    return [
        StudyMotion(
            GroundMotion(
                name=f"{spectrum.name} {seed}",
                acceleration=made[k],
                time_step=0.01,
                file=f"generated, seed {seed}",
                format="generated",
            ),
            spectrum.name,
            spectrum.group,
            seed,
        )
        for k, (spectrum, seed) in enumerate(wanted)
    ]


def _rows(study, motions, threads, journal, on_progress) -> tuple[tuple[Row, ...], int]:
    """The runs of all cells, those of the journal as they were, and how many these are. Raises InputError."""
    planned = []
    for cell, kinds in cells_of(study).items():
        for k, entry in enumerate(motions):
            if ("records" if entry.seed is None else "generated") in kinds:
                signs = (1, -1) if cell.kinematics.one_way else (1,)
                planned += [(cell, k, sign) for sign in signs]
    if not planned:
        raise InputError("study_no_runs")
    models = {cell: model_of(cell) for cell, _, _ in planned}
    known: dict = {}
    keys, tasks = {}, {}
    for entry in planned:
        cell, k, sign = entry
        motion, method, search = motions[k].motion, METHODS[cell.method], Search(q_step=cell.q_step)
        keys[entry] = run_key(models[cell], motion, sign, method, search)
        row = _restored(entry, journal.get(keys[entry])) if journal else None
        if row:
            known[entry] = row
            continue
        tasks[entry] = lambda stop, entry=entry, m=motion, method=method, search=search: _row(
            entry,
            incremental_dynamic_analysis(
                m.acceleration, m.time_step, m.pga, entry[2], models[entry[0]], method, search, stop
            ),
        )
    restored = len(known)
    costs = {entry: run_cost(motions[entry[1]].motion, Search(q_step=entry[0].q_step)) for entry in planned}
    progress = Progress(costs, on_progress)
    progress.known(known)

    def keep(entry, row: Row) -> None:
        if journal:
            journal.add(keys[entry], row._asdict() | {"cell": asdict(row.cell)})
        progress.done(entry)

    known.update(threads.run(tasks, keep))
    return tuple(known[entry] for entry in planned), restored


def _row(entry: tuple[Cell, int, int], ida: Ida) -> Row:
    cell, motion, polarity = entry
    return Row(
        cell=cell,
        motion=motion,
        polarity=polarity,
        status=ida.status,
        q=ida.q,
        low=ida.bracket[0] if ida.bracket else None,
        q_slv=ida.q_slv,
        q_slc=ida.q_slc,
        q_robust=ida.q_robust,
        survived_fraction=ida.survived_fraction,
        analyses=ida.analyses,
    )


def _restored(entry, line: dict | None) -> Row | None:
    """A run of the journal; None without one or where its line is not of this program."""
    try:
        return Row(**{**line, "cell": entry[0], "motion": entry[1]}) if line else None
    except TypeError:
        return None
