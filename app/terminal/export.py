"""Workbook and JSON of a result, for the batch and the window alike."""

import contextlib
import errno
import functools
import gc
import json
import os
import re
import tempfile
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path

from app.terminal.command_line import refuse_other_note
from core import atomic_write
from core.case.note_file import MAX_NOTE_BYTES, MEGABYTES, SECONDS, files_within
from core.case.schema import Case
from core.child import Refused, bounded
from core.errors import InputError, OutputError, place
from core.file_names import name_of
from core.ground import records
from core.packages import require
from core.regular_file import TooLarge, first_bytes, open_regular, read_regular
from core.report.steps import Steps
from core.study.governing import collapse_histories
from core.study.results import CollapseHistories, StudyResult

HISTORY_WALLS = 20
"""Walls whose histories and charts are drawn; the rest are listed."""

HEAD_BYTES = 1 << 20
"""Bytes of results, and of what a workbook says of itself, that are looked at."""

MAX_SUBJECT_LETTERS = 255
"""Letters that a docx can say of its subject."""

WALL_STEPS, NOTE_STEPS = 53, 90
"""Hundredths of the writing of what is made a wall at a time; the note as a document is beyond the hundred."""


def refuse_overwriting(case: Case, case_path: Path, folder: Path, stem: str, note: Path | None = None) -> None:
    """Raise InputError where a result would take the place of the case or of a file it reads. note : the calculation
    note, where one is asked for"""
    results = {(folder / (stem + end)).resolve() for end in (".xlsx", ".json", ".journal", ".parquet")}
    sources, asked = sources_of(case, case_path), results | ({note.resolve()} if note else set())
    if case.select:  # any file there may be a record
        inside = (case_path.parent / name_of(case.select.folder)).resolve()
        taken = [] if _ours(folder / f"{stem}.json") else [*results]  # else it is beside results of its own
        for path in [*taken, *([note.resolve()] if note else [])]:
            if path.exists() and inside in (path, *path.parents):
                sources.add(path)
    refuse_taking(asked, sources)


def sources_of(case: Case, case_path: Path) -> set[Path]:
    """The file of a case and those it reads by name. Raises InputError."""
    base, demand = case_path.parent, case.demand
    sources = {case_path.resolve()}
    of_demand = (demand.spectrum_file, demand.hazard_file) if demand else ()
    for name in (case.table, case.report.logo, *of_demand, *case.drawn_from):
        if name:
            sources.add((base / name_of(name)).resolve())
    for k, entry in enumerate(case.record, start=1):
        try:
            paths = records.expand(entry.file, case_path.parent)
        except InputError as error:
            raise error.at(place("record", n=k)) from None
        sources |= {path.resolve() for path in paths}
    return sources


def refuse_taking(asked: set[Path], sources: set[Path]) -> None:
    """Raise InputError where a file that is to be written is a source, OutputError where it is a folder."""
    for path in asked & sources:
        raise InputError("would_overwrite", path=path)
    for path in sorted(asked):
        if path.exists() and not path.is_file():
            raise OutputError("file_not_writable", reason=os.strerror(errno.EISDIR), place=(path,))


def _ours(path: Path) -> bool:
    """Whether results of this program are in a file, so that those beside it are its own too."""
    with contextlib.suppress(OSError):
        return first_bytes(path, 60).split()[:2] == [b"{", b'"program":']
    return False


def refuse_foreign(case: Case, folder: Path, stem: str, note: Path | None, force: bool) -> None:
    """Raise InputError where what is to be written would take the place of something else: results of another case or
    of another program, a note of another case, a workbook or note that was saved by another program since. force : it
    may"""
    if force:
        return
    own = _results_of(case, folder / f"{stem}.json")
    for path in [folder / f"{stem}{end}" for end in (".xlsx", ".json", ".parquet")]:
        if path.exists() and not (own and not _saved_since(path)):
            raise InputError("not_its_result", path=path)
    if note is not None and note.exists() and not _note_of(case, note):
        raise InputError("not_its_note", path=note)


def _results_of(case: Case, path: Path) -> bool:
    """Whether a file is results of this case: of its title and its first wall, of which those of a large case hold
    none."""
    if not _ours(path):
        return False
    head, decode = first_bytes(path, HEAD_BYTES).decode("utf-8", "ignore"), json.JSONDecoder().raw_decode
    title, wall = (re.search(pattern, head) for pattern in (r'"case": \{\s*"title": ', r'"wall": \[\s*\{\s*"name": '))
    try:
        alike = title is not None and decode(head, title.end())[0] == case.title
        return alike and (wall is None or decode(head, wall.end())[0] == case.wall[0].name)
    except ValueError:
        return False


def _saved_since(path: Path) -> bool:
    """Whether another program saved a workbook: each of them notes who did, this one does not."""
    if path.suffix != ".xlsx":
        return False
    try:
        with open_regular(path) as stream, zipfile.ZipFile(stream) as book, book.open("docProps/core.xml") as about:
            return b"lastModifiedBy" in about.read(HEAD_BYTES)
    except (OSError, ValueError, LookupError, NotImplementedError, RuntimeError, zlib.error, zipfile.BadZipFile):
        return True


def _note_of(case: Case, path: Path) -> bool:
    """Whether a file is a calculation note of this case: of its title and its first wall."""
    from core.report.note.document_subject import subject_in

    try:
        if path.suffix.lower() == ".pdf":
            said = _subject(json.loads(files_within(path)["results.json"])["case"])
        else:
            said = bounded(subject_in, read_regular(path, MAX_NOTE_BYTES), seconds=SECONDS, megabytes=MEGABYTES)
    except (InputError, Refused, OSError, TooLarge, LookupError, TypeError, ValueError):
        return False
    return said == _subject(case.as_dict())


def _subject(case: dict) -> str:
    """What a note is told by. case : by its keys"""
    from core.report.xml_text import escape_for_xml

    return escape_for_xml(f"{case['title']} – {case['wall'][0]['name']}")[:MAX_SUBJECT_LETTERS]


def check_note(path: Path | None, case_path: Path, case: Case | None = None) -> None:
    """Raise InputError before the run where the calculation note could not be written: another ending, packages that
    are missing, a logo or a font that is not there."""
    if path is None:
        return
    refuse_other_note(path, case_path)
    require("report")
    if case is not None:
        from core.report.note.archive import office_of
        from core.report.note.pdf import check_font

        office_of(case.report, case_path.parent)
        if case.report.font:
            check_font(case.report.font)


class Report:
    """Workbook and JSON of a study, made while its walls finish.

    case : of the study
    check : called at every part, to cancel
    """

    def __init__(self, case: Case, check: Callable[[], None] = lambda: None):
        self.case, self.check = case, check
        self._histories: list[CollapseHistories] = []

    @functools.cached_property
    def _files(self):
        """(JsonReport, WorkbookReport), whose packages are not needed before the first wall."""
        from core.report.json_report import JsonReport
        from core.report.workbook import WorkbookReport

        return JsonReport(), WorkbookReport(self.case.report.language, self.check)

    def add(self, result: StudyResult) -> None:
        """The next wall, see `StudyResult.by_wall`."""
        text, book = self._files
        with _no_collector():
            text.add(result)
            book.add(result)
        for wall in result.walls:
            self.check()
            if len(self._histories) < HISTORY_WALLS and (histories := collapse_histories(result, wall)):
                self._histories.append(histories)

    def write(
        self,
        result: StudyResult,
        folder: Path,
        stem: str,
        ready: Callable[[], None] = lambda: None,
        note: Path | None = None,
        case_path: Path | None = None,
        steps: Steps | None = None,
    ) -> None:
        """The files of a study all of whose walls are there, and the calculation note where a file is named for it: all
        or none.

        case_path : of the case, beside which its logo is
        ready : called when all is made and nothing written yet
        steps : how far it is
        Raises OutputError and what check and ready raise.
        """
        steps, (text, workbook) = steps or Steps(self.check), self._files
        try:
            with _no_collector():
                book = workbook.content(result, self._histories, steps)
        except OSError as error:  # openpyxl makes the sheets in the folder of temporary files
            raise OutputError("workbook_not_made", reason=error.strerror, folder=tempfile.gettempdir()) from None
        files = {folder / f"{stem}.xlsx": book, folder / f"{stem}.json": text.content(result)}
        if note is not None:
            steps.take(NOTE_STEPS)
            files[note] = note_content(result, note, case_path, steps)
        ready()
        atomic_write.write(files)


def write(
    result: StudyResult,
    folder: Path,
    stem: str,
    check: Callable[[], None] = lambda: None,
    ready: Callable[[], None] = lambda: None,
    tell: Callable[[int, int], None] = lambda done, planned: None,
) -> None:
    """Workbook and JSON of a result.

    check : called at every part, to cancel; ready : as `Report.write` takes it
    tell(done, planned) : how far it is
    Raises as `Report.write`.
    """
    report, steps = Report(result.case, check), Steps(check, tell)
    steps.take(WALL_STEPS)
    for wall in steps.each(result.split_by_wall()):
        report.add(wall)
    report.write(result, folder, stem, ready, steps=steps)


def note_content(result: StudyResult, path: Path, case_path: Path | None, steps: Steps | None = None) -> bytes:
    """The calculation note as the ending of its path asks. case_path : of the case, also where nothing lies there yet
    Raises InputError, OutputError."""
    if path.suffix.lower() == ".pdf":
        from core.report.note.archive import note_as_pdf

        return note_as_pdf(result, case_path.parent if case_path else Path(), steps)
    from core.report.note.brief import note
    from core.report.note.document import document

    language = result.case.report.language
    return document(note(result, language), language, steps, _subject(result.case.as_dict()))


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
