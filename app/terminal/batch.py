"""File in, files out: the headless run of a case, with progress, exit codes and a journal."""

import sys
import threading
from dataclasses import replace
from pathlib import Path

from app.look.language import current_language, terminal
from app.terminal import export, large_batch
from app.terminal.case_run import (
    CANCELLED,
    DONE,
    WITHOUT_NUMBER,
    aligned,
    cancel_on_interrupt,
    code_word,
    executor_of,
    format_short,
    make_folders,
    open_journal,
    raise_if_cancelled,
    results_of,
    say,
)
from app.terminal.terminal_progress import progress, tell
from core.case.reader import read_case
from core.case.schema import Case
from core.errors import Cancelled
from core.file_names import shown
from core.jit import cache
from core.packages import require
from core.report.steps import Steps
from core.report.verdict_words import sort_results
from core.setting.plan import is_large
from core.study.case_parts import FINISHED, open_parts, part_journal, part_path
from core.study.journal import Journal, MemoryJournal
from core.study.results import StudyResult
from core.study.run import run as run_study


def run(
    case_path: Path,
    output: Path | None,
    jobs: int,
    quiet: bool,
    resume: bool,
    report: Path | None = None,
    merge: bool = False,
    force: bool = False,
    scheduler: str | None = None,
) -> int:
    """Read a case, run it, write `<stem>.xlsx` and `<stem>.json`; returns the exit code.

    report : of the calculation note, where one is asked for
    merge : the searches and checks are those of the parts of the case, see `run_part`
    force : files of others may be overwritten
    scheduler : whose workers do the searches and checks, see `core.study.scheduler.open_dask_executor`

    Raises InputError for what the user can mend; nothing is written then.
    """
    export.check_note(report, case_path)
    case = _read(case_path)
    if is_large(case):
        return large_batch.run(case, case_path, output, jobs, quiet, resume, report, merge, force, scheduler)
    export.check_note(report, case_path, case)
    if case.analysis.accuracy:
        require("accuracy")
    folder, stem = results_of(case_path, output)
    cancel = threading.Event()
    books: list[Journal] = []

    def journal(key: str) -> Journal | MemoryJournal:
        if merge:
            return open_parts(folder, stem, case, key)
        books.append(open_journal(folder / f"{stem}.journal", key, resume))
        return books[0]

    folders = (folder, report.parent) if report else (folder,)
    with (
        make_folders(case_path, *folders),
        cancel_on_interrupt(cancel),
        executor_of(scheduler) as executor,
        progress(quiet) as show,
    ):
        export.refuse_overwriting(case, case_path, folder, stem, report)
        export.refuse_foreign(case, folder, stem, report, force)
        made_so_far = export.Report(case, raise_if_cancelled(cancel))
        try:
            result = run_study(
                case,
                base_dir=case_path.parent,
                jobs=jobs,
                journal=journal,
                on_progress=show.runs,
                cancelled=cancel.is_set,
                on_finished=made_so_far.add,
                executor=executor,
            )
            steps = Steps(
                raise_if_cancelled(cancel), show.writing, 100 - export.WALL_STEPS + (export.NOTE_STEPS if report else 0)
            )
            made_so_far.write(result, folder, stem, note=report, case_path=case_path, steps=steps)
        except Cancelled:
            place = folder / f"{stem}.journal"
            tell("cancelled: finished runs are in {path}; go on with --resume", path=place)
            return CANCELLED
        else:
            for book in books:
                book.remove()
        finally:  # the lock is held until the results are in their places
            for book in books:
                book.close()
    return _tell_results(result, folder, stem, report, quiet)


def _tell_results(result: StudyResult, folder: Path, stem: str, report: Path | None, quiet: bool) -> int:
    """Say what a run found, and what in it has no number; returns the exit code. The parameters are those of `run`."""
    _warn(result)
    failed = _write_errors(result, folder / f"{stem}.error.log")
    if not quiet:
        said = summary(result, folder, stem) + (f"\n{shown(str(report))}" if report else "")
        if _never_explained():
            said += "\n" + explanation(folder / f"{stem}.xlsx", bool(result.demand))
        say(said)
    _name_without_number(result)
    return WITHOUT_NUMBER if result.runs_without_q or failed else DONE


def _write_errors(result: StudyResult, path: Path) -> bool:
    """Write what went wrong in walls that have no number for it, and say which; whether there are any. The file of an
    earlier run goes."""
    path.unlink(missing_ok=True)
    failed = {wall.part.asked.title: wall.error for wall in result.walls if wall.error}
    if failed:
        path.write_text("".join(f"{title}\n{lines}\n" for title, lines in failed.items()), encoding="utf-8")
        text = "internal error in {walls}: without an outcome; please send {path}"
        tell(text, walls=", ".join(map(shown, failed)), path=path)
    return bool(failed)


def _warn(result: StudyResult) -> None:
    """Say on the error stream what is remarked on the table of walls and on the demand."""
    case = result.case
    for note in case.table_notes[1:]:
        print(f"{case.table}: {note.text(current_language())}", file=sys.stderr)
    for warning in result.demand.warnings if result.demand else ():
        print(f"[demand]: {warning.text(current_language())}", file=sys.stderr)


def _name_without_number(result: StudyResult) -> None:
    """Say on the error stream which runs have no number."""
    for wall, record, polarity, status in result.runs_without_q:
        tell(
            "no number: {wall}, {record} ({sign}): {status}",
            wall=wall,
            record=record,
            sign="+" if polarity > 0 else "-",
            status=status,
        )


def run_part(case_path: Path, output: Path | None, jobs: int, quiet: bool, k: int, n: int) -> int:
    """The searches and checks of the k-th of n parts of the walls of a case, kept beside where its results will be; a
    part that was stopped goes on. Returns the exit code. Raises InputError."""
    case = _read(case_path)
    if is_large(case):
        return large_batch.run_part(case, case_path, output, jobs, quiet, k, n)
    folder, stem = results_of(case_path, output)
    cancel = threading.Event()

    books: list[Journal] = []

    def journal(key: str) -> Journal:
        books.append(part_journal(folder, stem, case, key, k, n))
        return books[0]

    with make_folders(case_path, folder), cancel_on_interrupt(cancel), progress(quiet) as show:
        try:
            result = run_study(
                case,
                base_dir=case_path.parent,
                jobs=jobs,
                journal=journal,
                on_progress=show.runs,
                cancelled=cancel.is_set,
                share=(k - 1, n),
            )
            books[0].add(FINISHED, {})
        except Cancelled:
            tell("cancelled: finished runs are in {path}; start this part again", path=part_path(folder, stem, k, n))
            return CANCELLED
        finally:
            for book in books:
                book.close()
    if not quiet:
        walls = len({wall.part.origin for wall in result.walls})
        path = part_path(folder, stem, k, n)
        say(terminal("part {k} of {n}: {walls} walls, {path}", k=k, n=n, walls=walls, path=path))
    return DONE


def _read(case_path: Path) -> Case:
    """The case of a file; its walls at hand but where no workbook holds them."""
    case = read_case(case_path, many=True)
    return case if is_large(case) else replace(case, wall=tuple(case.wall))


def summary(result: StudyResult, folder: Path, stem: str) -> str:
    """What a terminal shows of a result: a line for each wall. With a demand its verdict, zeta and the check
    that decides; Eq. 9 stands in the files only."""
    columns = ["wall", "mechanism", "rule", "q", "robust"]
    if result.demand:
        columns += ["zeta", "verdict", "by"]
    table = [[terminal(head) for head in columns]]
    for wall in (wall for wall, decides in sort_results(result) if decides):
        row = [
            wall.name[:48],
            *map(code_word, (wall.mechanism, wall.set_rule)),
            format_short(wall.q_set),
            format_short(wall.q_robust_set),
        ]
        if wall.assessment:
            verdict = wall.assessment.verdict
            row += [format_short(verdict.zeta_e), code_word(verdict.code), code_word(verdict.governing)]
        table.append(row)
    lines = aligned(table)
    text = "{analyses} analyses in {seconds:.1f} s"
    lines.append(terminal(text, analyses=result.analyses, seconds=result.elapsed))
    lines += [shown(str(folder / (stem + end))) for end in (".xlsx", ".json")]
    return "\n".join(lines)


def explanation(workbook: Path, with_demand: bool) -> str:
    """What the words of the summary mean, a line each, and which file to open."""
    lines = [
        terminal("q: acceleration of the first motion that overturns the wall, divided by the one that lifts it"),
        terminal("robust: the q around which 16 % of the motions overturn it"),
    ]
    if with_demand:
        lines += [
            terminal("zeta: share of the demand at which the wall begins to fail; the code requires 1"),
            terminal("verdict: from the most refined check that could be made, named in the last column"),
        ]
    return "\n".join(["", *lines, terminal("open {path}: its first sheet sums up the walls", path=workbook)])


def _never_explained() -> bool:
    """Whether this user has not been told what the words mean; from now on he has."""
    try:
        cache.user_folder().mkdir(parents=True, exist_ok=True, mode=0o700)
        (cache.user_folder() / "explained").touch(exist_ok=False)
    except (OSError, RuntimeError):
        return False
    return True
