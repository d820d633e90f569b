"""The headless run of a case of more walls than a workbook holds: a Parquet file and a summary."""

import contextlib
import threading
from collections.abc import Generator, Iterator
from concurrent.futures import Executor
from pathlib import Path
from typing import Any, BinaryIO

from app.look.language import terminal
from app.terminal import export
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
    raise_if_cancelled,
    report_journal,
    results_of,
    say,
)
from app.terminal.terminal_progress import Shown, progress, tell
from core import atomic_write
from core.case.schema import Case
from core.errors import Cancelled, InputError
from core.file_names import shown
from core.packages import require
from core.report import large_report, parquet_file
from core.report.columns import columns_of
from core.report.large_report import Tally
from core.setting.plan import count_results
from core.study.case_parts import FINISHED, MergedParts, part_key, part_path
from core.study.journal import Journal, journal_key
from core.study.large_case import LargeCase, common_result, group_results, prepare_large_case, run_groups_remotely
from core.version import NAME, VERSION

MAX_WALLS_SHOWN = 20
"""Walls a terminal shows, the worst."""


def refuse(case: Case, note: Path | None = None) -> None:
    """Raise InputError for what is not made of so many walls."""
    if note is not None or case.analysis.accuracy or case.sensitivity:
        raise InputError("large_without", found=count_results(case))


def run(
    case: Case,
    case_path: Path,
    output: Path | None,
    jobs: int,
    quiet: bool,
    resume: bool,
    note: Path | None = None,
    merge: bool = False,
    force: bool = False,
    scheduler: str | None = None,
) -> int:
    """Run a case and write `<stem>.parquet` and `<stem>.json`; returns the exit code. The parameters are those of
    `batch.run`. Raises InputError for what the user can mend; nothing is written then."""
    refuse(case, note)
    require("parquet")
    folder, stem = results_of(case_path, output)
    cancel = threading.Event()
    with (
        make_folders(case_path, folder),
        cancel_on_interrupt(cancel),
        executor_of(scheduler) as executor,
        progress(quiet) as show,
    ):
        export.refuse_overwriting(case, case_path, folder, stem)
        export.refuse_foreign(case, folder, stem, None, force)
        book: Journal | MergedParts | None = None
        try:
            large = prepare_large_case(case, case_path.parent, cancel.is_set)
            if merge:
                book, mine = _merged(large, case, folder, stem), range(0)
            else:
                book = report_journal(Journal(folder / f"{stem}.journal", _key(large), resume))
                mine = range(len(large.groups))
            with contextlib.closing(_work(large, book, mine, jobs, show, cancel, executor)) as work:
                tally = _write(large, book, work, folder, stem, show, cancel)
            if isinstance(book, Journal):
                book.remove()
        except Cancelled:
            place = folder / f"{stem}.journal"
            tell("cancelled: finished runs are in {path}; go on with --resume", path=place)
            return CANCELLED
        finally:
            if book is not None:
                book.close()
    if not quiet:
        say(summary(tally, folder, stem))
    if tally.without_q:
        tell("{n} runs without a number: column runs_without_q of {path}", n=tally.without_q, path=_table(folder, stem))
    if tally.errors:
        tell("{n} rows with an error: column warnings of {path}", n=tally.errors, path=_table(folder, stem))
    return WITHOUT_NUMBER if tally.without_q or tally.errors else DONE


def run_part(case: Case, case_path: Path, output: Path | None, jobs: int, quiet: bool, k: int, n: int) -> int:
    """Every n-th group of walls of a case from the k-th on; the parameters are those of `batch.run_part`. Raises
    InputError."""
    refuse(case)
    folder, stem = results_of(case_path, output)
    cancel, path = threading.Event(), part_path(folder, stem, k, n)
    with make_folders(case_path, folder), cancel_on_interrupt(cancel), progress(quiet) as show:
        try:
            large = prepare_large_case(case, case_path.parent, cancel.is_set)
            book = Journal(path, part_key(_key(large), case, k, n), True)
            try:
                mine = range(k - 1, len(large.groups), n)
                for _ in _work(large, book, mine, jobs, show, cancel):
                    pass
                if FINISHED not in book:
                    book.add(FINISHED, {})
            finally:
                book.close()
        except Cancelled:
            tell("cancelled: finished runs are in {path}; start this part again", path=path)
            return CANCELLED
    if not quiet:
        walls = sum(len(large.groups[g]) for g in mine)
        say(terminal("part {k} of {n}: {walls} walls, {path}", k=k, n=n, walls=walls, path=path))
    return DONE


def _key(large: LargeCase) -> str:
    return f"{journal_key()} {large.key}"


def _merged(large: LargeCase, case: Case, folder: Path, stem: str) -> MergedParts:
    """The groups of all parts. Raises InputError as MergedParts, and for a part without one of its groups."""
    book = MergedParts(folder, stem, lambda k, n: part_key(_key(large), case, k, n))
    missing = next((g for g in range(len(large.groups)) if book.get(g) is None), None)
    if missing is None:
        return book
    book.close()
    n = len(book.streams)
    raise InputError("part_damaged", k=missing % n + 1, n=n, path=part_path(folder, stem, missing % n + 1, n))


def _work(
    large: LargeCase,
    book: Any,
    mine: range,
    jobs: int,
    show: Shown,
    cancel: threading.Event,
    executor: Executor | None = None,
) -> Generator[int]:
    """The groups that are not in a journal, as they come into it: from the executor, and what that loses, or all where
    there is none, from here."""
    todo = [g for g in mine if g not in book]
    if executor is not None:
        for g, rows in run_groups_remotely(large, todo, executor, columns_of, show.runs, cancel.is_set):
            book.add(g, rows)
            yield g
        todo = [g for g in todo if g not in book]
    for g, result in group_results(large, todo, jobs, show.runs, cancel.is_set):
        book.add(g, columns_of(result, large.groups[g]))
        yield g


def _table(folder: Path, stem: str) -> Path:
    return folder / f"{stem}.parquet"


def _write(
    large: LargeCase, book: Any, work: Iterator[int], folder: Path, stem: str, show: Shown, cancel: threading.Event
) -> Tally:
    """Write table and summary, both or none, a group as soon as it and those before it are there; what was counted.
    work : groups as they come"""
    tally, count, table = Tally(), len(large.groups), _table(folder, stem)

    def rows() -> Iterator[dict[str, list]]:
        worked = False
        for g in range(count):
            raise_if_cancelled(cancel)()
            while (group_rows := book.get(g)) is None:
                next(work)
                worked = True
            if not worked:
                show.writing(g, count)
            tally.add(group_rows)
            yield group_rows

    def put_table(stream: BinaryIO) -> None:
        parquet_file.write(stream, rows(), {"program": f"{NAME} {VERSION}", "case_sha256": large.case.sha256})

    def put_summary(stream: BinaryIO) -> None:  # after the table, whose rows it counts
        content = large_report.summary(large.case, common_result(large), tally, table.name)
        stream.write(large_report.dumps(content).encode())

    atomic_write.write({table: put_table, folder / f"{stem}.json": put_summary})
    return tally


def summary(tally: Tally, folder: Path, stem: str) -> str:
    """What a terminal shows: the worst walls, how many have which verdict, the files."""
    columns = ["wall", "mechanism", "q"]
    with_demand = bool(tally.verdicts)
    if with_demand:
        columns += ["zeta", "verdict", "by"]
    table = [[terminal(head) for head in columns]]
    for row in tally.worst[:MAX_WALLS_SHOWN]:
        cells = [row["name"][:48], code_word(row["mechanism"]), format_short(row["q_set"])]
        if with_demand:
            cells += [format_short(row["zeta_e"]), code_word(row["verdict"]), code_word(row["check"])]
        table.append(cells)
    lines = aligned(table, (2, 3))
    counts = ", ".join(f"{code_word(code)} {n}" for code, n in sorted(tally.verdicts.items()))
    lines.append(terminal("{walls} walls, the worst above", walls=tally.walls) + (f": {counts}" if counts else ""))
    return "\n".join([*lines, shown(str(_table(folder, stem))), shown(str(folder / f"{stem}.json"))])
