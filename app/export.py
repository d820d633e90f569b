"""Workbook and JSON of a result, for the batch and the window alike."""

import contextlib
import gc
import tempfile
from collections.abc import Callable
from pathlib import Path

from app.command_line import refuse_other_note
from core import atomic_write
from core.case.schema import Case
from core.errors import InputError, OutputError, place
from core.file_names import name_of
from core.ground import records
from core.packages import require
from core.study.governing import collapse_histories
from core.study.results import StudyResult


def refuse_overwriting(case: Case, case_path: Path, folder: Path, stem: str) -> None:
    """Raise InputError where a result would take the place of the case or of a file it reads."""
    results = {(folder / (stem + end)).resolve() for end in (".xlsx", ".json", ".journal")}
    sources = {case_path.resolve()}
    for name in (case.table, case.demand.spectrum_file if case.demand else None):
        if name:
            sources.add((case_path.parent / name_of(name)).resolve())
    for k, entry in enumerate(case.record, start=1):
        try:
            paths = records.expand(entry.file, case_path.parent)
        except InputError as error:
            raise error.at(place("record", n=k)) from None
        sources |= {path.resolve() for path in paths}
    for path in results & sources:
        raise InputError("would_overwrite", path=path)


def check_note_path(path: Path | None, case_path: Path) -> None:
    """Raise InputError before the run where the calculation note could not be written: another ending than .docx, or
    packages that are missing."""
    if path is not None:
        refuse_other_note(path, case_path)
        require("report")


def write(
    result: StudyResult,
    folder: Path,
    stem: str,
    check: Callable[[], None] = lambda: None,
    ready: Callable[[], None] = lambda: None,
    note: Path | None = None,
) -> None:
    """Workbook and JSON of a result, and the calculation note as a Word document where a file is named for it: all or
    none. check : called now and then, ready when all is made and
    nothing written yet. Raises OutputError and what these two raise."""
    from core.report import json_report, workbook

    drawn = (collapse_histories(result, wall) for wall in result.walls)
    histories = []
    for entry in drawn:
        if entry:
            histories.append(entry)
        check()
        if len(histories) == workbook.HISTORY_WALLS:
            break
    # first the JSON: the cells of the workbook take the most memory
    text = json_report.dumps(result).encode()
    check()
    try:
        with _no_collector():
            book = workbook.content(result, histories, check)
    except OSError as error:  # openpyxl makes the sheets in the folder of temporary files
        raise OutputError(
            "workbook_not_made", reason=error.strerror, folder=tempfile.gettempdir()
        ) from None
    files = {folder / f"{stem}.xlsx": book, folder / f"{stem}.json": text}
    if note is not None:
        check()
        files[note] = note_content(result)
    ready()
    atomic_write.write(files)


def note_content(result: StudyResult) -> bytes:
    """The calculation note as a Word document. Raises OutputError."""
    from core.report.note.content import note
    from core.report.note.document import document

    language = result.case.report.language
    return document(note(result, language), language)


@contextlib.contextmanager
def _no_collector():
    """Python's collector would look through the cells of a workbook again and again, which are no garbage."""
    was_on = gc.isenabled()  # not in the window, which collects in its own thread
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()
