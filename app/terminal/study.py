"""`--study`: a parametric study without a window, and what it writes for the window too."""

import contextlib
import hashlib
import re
import threading
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from app.look.language import terminal
from app.terminal.batch import (
    CANCELLED,
    DONE,
    WITHOUT_NUMBER,
    cancel_on_interrupt,
    open_journal,
    raise_if_cancelled,
    say,
)
from app.terminal.command_line import STUDIES, study_file
from app.terminal.terminal_progress import progress, tell
from core import atomic_write
from core.case.study_file import Study, quick_study, read_record_list, read_study
from core.errors import Cancelled, InputError, place
from core.file_names import shown
from core.ground import records as accelerograms
from core.lab.research import pack, parametric
from core.lab.research.figures import StudyReport
from core.lab.research.parametric import ParametricResult
from core.lab.research.study_files import CSV_COLUMNS
from core.lab.research.study_report import report_of
from core.packages import require
from core.regular_file import first_bytes
from core.study.journal import Journal

MAX_NAMED = 20
"""Runs without a number that are named on the terminal."""

FIGURE_STEPS = 50
"""Hundredths of the writing that the figures take."""

FIGURE_NAME = re.compile(r"(fig\d\d|q|q_eff|eq14|law)_\w[\w.]*\.(png|svg)")
"""Names of the figures of a study."""


def stem_of(path: Path, quick: bool) -> str:
    """Name of the results; a short run never takes the place of a whole one."""
    return path.stem + ("_quick" if quick else "")


def load(path: Path, quick: bool) -> tuple[Study, str]:
    """The study of a file, shortened where asked. Raises InputError."""
    study, digest = read_study(path)
    return (quick_study(study) if quick else study), digest


def refuse_overwriting(study: Study, path: Path, records: Path | None, folder: Path, stem: str) -> None:
    """Raise InputError where a result would take the place of a file the study reads, or of a folder."""
    figures = folder / f"{stem}_figures"
    if figures.exists() and not figures.is_dir():
        raise InputError("would_overwrite", path=figures)
    ends = (".xlsx", ".json", ".csv", ".journal", "_pack.zip")
    targets = {(folder / (stem + end)).resolve() for end in ends}
    sources = {path.resolve()}
    listed = [(study.record, path.parent)]
    if records is not None and records.is_file():
        sources.add(records.resolve())
        listed.append((read_record_list(records).record, records.parent))
    elif records is not None:
        sources |= {file.resolve() for file in records.rglob("*") if file.is_file()}
        # results of this study in the folder of records are no records
        sources -= {target for target in targets if ours(target)}
    for entries, base in listed:
        for k, entry in enumerate(entries, start=1):
            try:
                sources |= {file.resolve() for file in accelerograms.expand(entry.file, base)}
            except InputError as error:
                raise error.at(place("record", n=k)) from None
    for target in targets & sources:
        raise InputError("would_overwrite", path=target)


def ours(target: Path) -> bool:
    """Whether this file was written by a study: a record would not be."""
    try:
        start = first_bytes(target, 200)
    except OSError:
        return False
    heads = (",".join([*CSV_COLUMNS][:4]).encode(), b'{\n "program"', b"PK", b'{"Ribalta journal"')
    return start.startswith(heads)


class Made(NamedTuple):
    """A study that ran: its result, the stem of its files, and the journal, which goes when they are written."""

    result: ParametricResult
    stem: str
    book: Journal


def results(
    asked: str, folder: Path, records: Path | None, jobs: int, quick: bool, resume: bool, on_progress, cancelled
) -> Made:
    """Run a study with its journal in this folder. Raises InputError and Cancelled, with no new folder left."""
    require("study")
    path = study_file(asked)
    study, digest = load(path, quick)
    stem = stem_of(path, quick)
    refuse_overwriting(study, path, records, folder, stem)
    made = atomic_write.check_folder(folder)
    books: list[Journal] = []

    def journal(key: str) -> Journal:
        books.append(open_journal(folder / f"{stem}.journal", key, resume))
        return books[0]

    try:
        result = parametric.run(
            study,
            digest,
            base_dir=path.parent,
            records_from=records,
            quick=quick,
            jobs=jobs,
            journal=journal,
            on_progress=on_progress,
            cancelled=cancelled,
        )
        return Made(result, stem, books.pop())
    except (InputError, Cancelled):
        for new in made:  # a folder that holds a journal stays
            with contextlib.suppress(OSError):
                new.rmdir()
        raise
    finally:  # of a study that did not end
        for book in books:
            book.close()


def run(
    asked: str,
    output: Path | None,
    records: Path | None,
    jobs: int,
    quiet: bool,
    quick: bool,
    resume: bool,
    packed: bool = False,
) -> int:
    """Run a study and write `<stem>.xlsx`, `.json`, `.csv` and a folder of figures; returns the exit code.

    output : else beside the file, of a study that comes with the program the current folder
    records : folder of natural records, or a TOML list of them
    packed : write `<stem>_pack.zip` too, an archive that can be deposited
    Raises InputError for what the user can mend; nothing is written then.
    """
    path = study_file(asked)
    folder = output or (Path() if path.parent == STUDIES else path.parent)
    cancel, made = threading.Event(), None
    if packed:
        pack.refuse_outside(load(path, quick)[0])
    with cancel_on_interrupt(cancel), progress(quiet) as show:
        try:
            made = results(asked, folder, records, jobs, quick, resume, show.runs, cancel.is_set)
            report = report_of(made.result)
            source = (path, records) if packed else None
            write(made.result, report, folder, made.stem, raise_if_cancelled(cancel), tell=show.writing, source=source)
        except Cancelled:
            journal = folder / f"{stem_of(path, quick)}.journal"
            if journal.exists():
                tell("cancelled: finished runs are in {path}; go on with --resume", path=journal)
            else:
                tell("stopped")
            return CANCELLED
        else:
            made.book.remove()
        finally:  # the lock is held until the results are in their places
            if made is not None:
                made.book.close()
    if not quiet:
        say(summary(made.result, report, folder, made.stem))
        if packed:
            say(shown(f"{folder / made.stem}_pack.zip"))
    without = [row for row in made.result.rows if row.q is None]
    for row in without[:MAX_NAMED]:
        tell(
            "no number: {wall}, {record} ({sign}): {status}",
            wall=f"{row.cell.wall.name} {row.cell.mechanism}",
            record=made.result.motions[row.motion].motion.name,
            sign="+" if row.polarity > 0 else "-",
            status=row.status,
        )
    if len(without) > MAX_NAMED:
        tell("and {n} more, in the CSV", n=len(without) - MAX_NAMED)
    return WITHOUT_NUMBER if without else DONE


def write(
    result: ParametricResult,
    report: StudyReport,
    folder: Path,
    stem: str,
    check: Callable[[], None] = lambda: None,
    ready: Callable[[], None] = lambda: None,
    tell: Callable[[int, int], None] = lambda done, planned: None,
    source: tuple[Path, Path | None] | None = None,
) -> None:
    """All files of a study. check : called at every part, to cancel; ready : when all is made and nothing written yet;
    tell(done, planned) : how far it is; source : the file of the study and the records given, of which an archive is
    made too. Raises OutputError; what a figure raises, when the other files are written."""
    from core.lab.research import study_files, study_workbook
    from core.report.steps import Steps

    steps = Steps(check, tell)
    steps.take(0)
    runs = study_files.csv_text(result).encode()
    digest = hashlib.sha256(runs).hexdigest()
    files = {
        folder / f"{stem}.xlsx": study_workbook.content(result, report, steps),
        folder / f"{stem}.json": study_files.json_text(result, report, f"{stem}.csv", digest).encode(),
        folder / f"{stem}.csv": runs,
    }
    drawn: dict[Path, bytes] = {}
    steps.take(FIGURE_STEPS)
    fault = None
    try:
        for figure in steps.each(report.figures):
            for name, content in study_files.figure_files(figure).items():
                drawn[folder / f"{stem}_figures" / name] = content
    except Cancelled:
        raise
    except Exception as error:  # the numbers of hours do not go with a figure: raised when they are written
        fault = error
    if source is not None and not fault:
        tables = {path.name: one for path, one in files.items() if path.suffix in (".csv", ".json")}
        figures_of = {path.name: one for path, one in drawn.items()}
        files[folder / f"{stem}_pack.zip"] = pack.content(result, *source, tables, figures_of)
    ready()
    if fault:
        atomic_write.write(files)
        fault.add_note(terminal("workbook, JSON and CSV are written: {path}", path=folder / stem))
        raise fault
    figures = folder / f"{stem}_figures"
    atomic_write.check_folder(figures)
    atomic_write.write({**drawn, **files})
    for path in figures.iterdir():  # of an earlier run of this study
        if FIGURE_NAME.fullmatch(path.name) and path not in drawn:
            path.unlink()


def summary(result: ParametricResult, report: StudyReport, folder: Path, stem: str) -> str:
    """What a terminal shows of a study: notes, claims as counts, and where the files are."""
    lines = [report.title, *report.notes]
    lines += [
        f"{claim.held:5d} / {claim.tried:<5d} {claim.claim}" + (f" ({claim.found})" if claim.found else "")
        for claim in report.claims
    ]
    analyses = sum(row.analyses for row in result.rows)
    lines.append(
        terminal(
            "{runs} runs, {analyses} analyses in {seconds:.1f} s",
            runs=len(result.rows),
            analyses=analyses,
            seconds=result.elapsed,
        )
    )
    lines += [shown(f"{folder / stem}{end}") for end in (".xlsx", ".json", ".csv", "_figures")]
    return "\n".join(lines)
