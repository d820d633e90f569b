"""A parametric study: every cell of its grids under its motions, one row a run."""

import datetime
import hashlib
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NamedTuple

from core.capacity.ida import Ida, Search, incremental_dynamic_analysis
from core.case.study_file import Cell, Group, Shape, Study, cells_of, read_record_list
from core.codes import target_spectrum
from core.codes.target_spectrum import CodeSpectrum
from core.errors import InputError, RecordError
from core.ground import records
from core.ground.artificial import compatible_motion
from core.ground.ground_motion import GroundMotion
from core.jit import cache
from core.rocking.methods import METHODS
from core.study.journal import Journal
from core.study.record_input import read_records
from core.study.run import run_key
from core.study.threads import Threads
from core.units import G
from core.version import VERSION
from core.wall.rocking_model import RockingModel, rocking_model


@dataclass(frozen=True)
class StudySpectrum:
    """One target spectrum of a study. intensity : SI [m], Eq. 11."""

    name: str
    group: str
    target: CodeSpectrum
    intensity: float


@dataclass(frozen=True)
class StudyMotion:
    """One motion of a study; spectrum and group "" and seed None of a natural record."""

    motion: GroundMotion
    spectrum: str = ""
    group: str = ""
    seed: int | None = None


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
    """A finished study. refused : (file, error) of the records that could not be read; elapsed [s]."""

    study: Study
    sha256: str
    quick: bool
    started: str
    spectra: tuple[StudySpectrum, ...]
    motions: tuple[StudyMotion, ...]
    rows: tuple[Row, ...]
    refused: tuple[tuple[str, RecordError], ...]
    elapsed: float


def target_of(shape: Shape, pga: float) -> CodeSpectrum:
    """The spectrum of this shape with a_g S = pga [m/s2]. Raises InputError where no a_g gives it."""
    if shape.code == "EN1998":
        soil = target_spectrum.en1998(G, shape.type, shape.soil).soil
        return target_spectrum.en1998(pga / soil, shape.type, shape.soil)
    ag = pga
    for _ in range(200):  # S falls with a_g: a fixed point
        target = target_spectrum.ntc2018(
            ag, shape.f0, shape.tc_star_s, shape.soil, shape.topography
        )
        if abs(target.pga - pga) <= 1e-12 * pga:
            return target
        ag = pga / target.soil
    raise InputError("study_no_pga", key="pga_g", pga=pga / G)


def spectra_of(study: Study) -> list[tuple[StudySpectrum, Shape]]:
    """The target spectra of a study and their shapes. Raises InputError."""

    def one(group: Group, shape: Shape) -> StudySpectrum:
        target = target_of(shape, group.pga_g * G)
        return StudySpectrum(
            shape.name, group.name, target, target_spectrum.housner_intensity(target)
        )

    return [(one(group, shape), shape) for group in study.group for shape in group.spectrum]


def folder_records(folder: Path) -> tuple[list[StudyMotion], list[tuple[str, RecordError]]]:
    """Every acceleration record below a folder, one of equal ones, and the files that are none.

    Raises InputError for a folder without a record.
    """
    motions, refused, seen = [], [], set()
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        name = path.relative_to(folder).as_posix()
        try:
            motion = records.read(path, name=name)
        except RecordError as error:
            refused.append((name, error))
            continue
        if motion.samples_sha256 not in seen:
            seen.add(motion.samples_sha256)
            motions.append(StudyMotion(motion))
    if not motions:
        raise InputError("study_no_record", place=(folder,))
    return motions, refused


def listed_records(listed, base_dir: Path) -> list[StudyMotion]:
    """The records of [[record]] tables: `listed.record`. Raises InputError."""
    return [StudyMotion(motion) for motion in read_records(listed, base_dir)[0]]


def model_of(cell: Cell) -> RockingModel:
    """The numbers of a cell's wall for the kernels."""
    wall = cell.wall
    restitution = wall.restitution_of(cell.mechanism)
    return rocking_model(
        wall.block(), cell.mechanism == "one_sided", restitution, wall.moment_law()
    )


def run(
    study: Study,
    sha256: str,
    *,
    base_dir: Path,
    records_from: Path | None = None,
    quick: bool = False,
    jobs: int = 1,
    journal: Callable[[str], Journal] | None = None,
    on_progress: Callable[[int, int], None] = lambda done, planned: None,
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
    started = datetime.datetime.now(datetime.UTC)
    threads = Threads(jobs, cancelled)
    spectra = spectra_of(study)
    natural, refused = [], []
    if study.record:
        natural = listed_records(study, base_dir)
    if records_from is not None and records_from.is_dir():
        found, refused = folder_records(records_from)
        natural += found
    elif records_from is not None:
        natural += listed_records(read_record_list(records_from), records_from.parent)
    motions = _generated(study, spectra, threads) + natural
    threads.run({k: entry.motion.measure for k, entry in enumerate(motions)}, lambda k, _: None)
    book = journal(f"{VERSION} {cache.stamp()}") if journal else None
    try:
        rows = _rows(study, motions, threads, book, on_progress)
    finally:
        cache.record(cache.folder())
        if book:
            book.close()
    elapsed = (datetime.datetime.now(datetime.UTC) - started).total_seconds()
    return ParametricResult(
        study,
        sha256,
        quick,
        started.isoformat(timespec="seconds"),
        tuple(entry for entry, _ in spectra),
        tuple(motions),
        rows,
        tuple(refused),
        elapsed,
    )


def _generated(study: Study, spectra, threads: Threads) -> list[StudyMotion]:
    """The motions of every spectrum, in order."""
    wanted = [
        (spectrum, seed)
        for spectrum, shape in spectra
        for seed in range(shape.seed, shape.seed + study.count)
    ]
    tasks = {
        k: lambda stop, target=spectrum.target, seed=seed: compatible_motion(target, seed)
        for k, (spectrum, seed) in enumerate(wanted)
    }
    made = threads.run(tasks, lambda k, _: None)
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


def _rows(study, motions, threads, book, on_progress) -> tuple[Row, ...]:
    """The runs of all cells, those of the journal as they were."""
    planned = []
    for cell in cells_of(study):
        for k, entry in enumerate(motions):
            natural = entry.seed is None
            if cell.motions == "all" or (cell.motions == "records") == natural:
                signs = (1, -1) if cell.mechanism == "one_sided" else (1,)
                planned += [(cell, k, sign) for sign in signs]
    models = {cell: model_of(cell) for cell, _, _ in planned}
    known: dict = {}
    keys, tasks = {}, {}
    for entry in planned:
        cell, k, sign = entry
        motion, method, search = motions[k].motion, METHODS[cell.method], Search(q_step=cell.q_step)
        keys[entry] = run_key(models[cell], motion, sign, method, search)
        row = _restored(entry, book.get(keys[entry])) if book else None
        if row:
            known[entry] = row
            continue
        tasks[entry] = lambda stop, entry=entry, m=motion, method=method, search=search: _row(
            entry,
            incremental_dynamic_analysis(
                m.acceleration, m.time_step, m.pga, entry[2], models[entry[0]], method, search, stop
            ),
        )
    restored, total = len(known), len(planned)
    on_progress(restored, total)

    def keep(entry, row: Row) -> None:
        if book:
            book.add(keys[entry], row._asdict() | {"cell": asdict(row.cell)})

    known.update(threads.run(tasks, keep, lambda done: on_progress(restored + done, total)))
    return tuple(known[entry] for entry in planned)


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


def key_of(study: Study, quick: bool) -> str:
    """What the journal of a study belongs to."""
    return hashlib.sha256(repr((study, quick)).encode()).hexdigest()
