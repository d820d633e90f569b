"""`--verify REPORT`: the case within a report is run again, and what it says is compared with what comes out."""

import itertools
import json
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from app.look.language import describe_message, terminal
from app.terminal import export
from app.terminal.batch import say
from app.terminal.terminal_progress import progress
from core.case.case_files import CaseFile, choose_held, parse_entries, parse_lines
from core.case.note_file import CASE, MAX_NOTE_BYTES, NOTE_FILES, files_within, is_note, unpacked
from core.case.reader import case_of_text
from core.case.schema import Case
from core.child import Refused, bounded
from core.errors import InputError
from core.packages import require
from core.regular_file import TooLarge, read_regular
from core.report.differences import (
    Difference,
    case_of_workbook,
    compare_workbooks,
    diff_lines,
    diff_results,
    words_of_notes,
)
from core.study.results import StudyResult
from core.study.run import run as run_study
from core.version import VERSION

EXIT_EQUAL, EXIT_DIFFERS, EXIT_CANNOT = 0, 5, 6
"""Exit codes."""

MAX_DIFFERENCES_SHOWN = 40
"""Differences that are listed."""

MAX_PARTS_SHOWN = 8
"""Parts of a workbook that are named."""

SECONDS, MEGABYTES = 60.0, 2000
"""That reading the words of a note, or the cells of a workbook, may take."""


class Unverifiable(Exception):
    """Why a report cannot be verified, in words."""


def verify(report: Path, records: Path | None, jobs: int, quiet: bool) -> int:
    """Run the case within a report again and say what differs; returns the exit code. The parameters are those of
    `compared`. Raises InputError for a file that is no report."""
    with progress(quiet) as show:
        code, lines = compare_report(report, records, jobs=jobs, on_progress=show.runs)
    for line in lines:
        say(line)
    return code


def compare_report(report: Path, records: Path | None = None, **how: Any) -> tuple[int, list[str]]:
    """(exit code, what to say) of a report whose case is run again.

    records : folder of the files that the case reads, that of the report if none is given
    how : jobs, on_progress and cancelled of `core.study.run.run`
    Raises InputError for a file that is no report, Cancelled.
    """
    content, folder = _content(report), records or report.parent
    try:
        reported, case_text, files = _reported(report, content)
        made_by = reported.get("program", {}).get("version", VERSION)
        if made_by != VERSION:
            text = "made by version {made}, this is {here}: take that version"
            raise Unverifiable(terminal(text, made=made_by, here=VERSION))
        case = _case(case_text, report, folder, files)
        try:
            result = run_study(case, base_dir=folder, **how)
        except InputError as error:
            raise Unverifiable(describe_message(error)) from None
        if changed := _other_records(reported, result):
            raise Unverifiable(terminal("these records are not those of the report: {names}", names=", ".join(changed)))
        differences = list(itertools.islice(_compared(report, content, reported, result, folder), 10_000))
    except Unverifiable as reason:
        return EXIT_CANNOT, [terminal("{path}: cannot be verified: {reason}", path=report, reason=str(reason))]
    lines = [_line(difference) for difference in differences[:MAX_DIFFERENCES_SHOWN]]
    if len(differences) > MAX_DIFFERENCES_SHOWN:
        lines.append(terminal("… and {n} more", n=len(differences) - MAX_DIFFERENCES_SHOWN))
    if differences:
        return EXIT_DIFFERS, [*lines, terminal("{path}: {n} differences", path=report, n=len(differences))]
    return EXIT_EQUAL, [terminal("{path}: equal, run again by version {version}", path=report, version=VERSION)]


def _line(one: Difference) -> str:
    nothing = terminal("nothing")
    values: dict[str, Any] = {"place": one.place, "reported": one.reported or nothing, "found": one.found or nothing}
    if one.share is not None:
        return terminal(
            "{place}: reported {reported}, found {found}, different by {share:.1e}", share=one.share, **values
        )
    return terminal("{place}: reported {reported}, found {found}", **values)


def _content(report: Path) -> bytes:
    try:
        return read_regular(report, MAX_NOTE_BYTES)
    except FileNotFoundError:
        raise InputError("no_report_file", place=(report,)) from None
    except TooLarge as error:
        raise InputError("case_too_large", mb=error.size / 1e6, most=MAX_NOTE_BYTES / 1e6, place=(report,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(report,)) from None


def _reported(report: Path, content: bytes) -> tuple[dict, str, tuple[CaseFile, ...]]:
    """Results and text of the case within a report, and the files that the case names. Raises InputError for another
    file, Unverifiable for one without the text of its case."""
    if is_note(content):
        files = files_within(report)
        table = _loaded(files.get("results.json", b""), report)
        return table, table.get("case_toml") or files[CASE].decode("utf-8"), _files(parse_entries, table, report)
    if content.startswith(b"PK"):
        require("report")
        text, lines = _bounded(report, case_of_workbook, content)
        if not text:
            raise Unverifiable(terminal("it does not hold the text of its case"))
        beside = report.with_suffix(".json")  # it says which records; without it the sheet of them tells
        table = _loaded(_content(beside), beside) if beside.exists() else {"records": []}
        return table, text, _files(parse_lines, lines, report)
    table = _loaded(content, report)
    if not table.get("case_toml"):
        raise Unverifiable(terminal("it does not hold the text of its case"))
    return table, table["case_toml"], _files(parse_entries, table, report)


def _files(parse: Callable[[Any], tuple[CaseFile, ...]], content: Any, report: Path) -> tuple[CaseFile, ...]:
    """The files of a case within a report: of the table of the results, or of lines of a workbook."""
    try:
        return parse(content.get("files", ()) if isinstance(content, dict) else content)
    except (ValueError, RecursionError):
        raise InputError("not_a_report", place=(report,)) from None


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """The mapping of an object of a JSON. Raises ValueError for a key that stands twice: one reader takes the first,
    another the last."""
    table = dict(pairs)
    if len(table) < len(pairs):
        raise ValueError("key")
    return table


def _refuse_constant(name: str) -> None:
    """Raise ValueError for NaN and Infinity, which no JSON holds."""
    raise ValueError(name)


def _loaded(content: bytes, place: Path) -> dict:
    try:
        report = json.loads(content, object_pairs_hook=_unique, parse_constant=_refuse_constant)
    except (ValueError, RecursionError):
        report = None
    text = report.get("case_toml") if isinstance(report, dict) else None
    kinds = {"program": dict, "records": list}
    if not isinstance(report, dict) or not all(isinstance(report.get(key), kind) for key, kind in kinds.items()):
        raise InputError("not_a_report", place=(place,))
    if not isinstance(text, (str, type(None))) or not all(isinstance(one, dict) for one in report["records"]):
        raise InputError("not_a_report", place=(place,))
    return report


def _bounded(report: Path, work: Callable, *given: Any) -> Any:
    try:
        return bounded(work, *given, seconds=SECONDS, megabytes=MEGABYTES)
    except Refused:
        raise InputError("not_a_report", place=(report,)) from None


def _case(text: str, report: Path, folder: Path, files: tuple[CaseFile, ...]) -> Case:
    """The case of its text, beside the files it reads that the report does not hold."""
    try:
        return case_of_text(text, folder / report.name, choose_held(files, folder))
    except InputError as error:
        raise Unverifiable(describe_message(error)) from None


def _other_records(reported: dict, result: StudyResult) -> list[str]:
    """Names of the records whose file is not the one of the report."""
    hashes = {one.get("name"): one.get("file_sha256") for one in reported.get("records", [])}
    return [
        motion.name for motion in result.motions if hashes.get(motion.name, motion.file_sha256) != motion.file_sha256
    ]


def _compared(report: Path, content: bytes, reported: dict, result: StudyResult, folder: Path) -> Iterator[Difference]:
    """What of a report differs from the same case run again."""
    if is_note(content):
        from core.report.note.archive import note_as_pdf

        again = note_as_pdf(result, folder)
        if again == content:
            return
        within = json.loads(files_of(again)["results.json"])
        yield from diff_results(reported, within)
        words = _bounded(report, words_of_notes, [content, again])
        lines = list(diff_lines(*words))
        yield from lines
        if not lines:
            yield Difference(terminal("file"), terminal("written again by another program"), terminal("other bytes"))
        return
    made = export.Report(result.case)
    for wall in result.split_by_wall():
        made.add(wall)
    with tempfile.TemporaryDirectory() as name:
        made.write(result, Path(name), report.stem)
        if content.startswith(b"PK"):
            again = (Path(name) / f"{report.stem}.xlsx").read_bytes()
            parts, cells = _bounded(report, compare_workbooks, content, again)
            yield from cells
            if parts and not cells:  # what a reader sees is more than cells: formats, hidden rows, charts
                text = "every cell is equal, but saved by another program: {parts} are not as written here"
                raise Unverifiable(terminal(text, parts=", ".join(parts[:MAX_PARTS_SHOWN])))
        else:
            yield from diff_results(reported, json.loads((Path(name) / f"{report.stem}.json").read_bytes()))


def files_of(content: bytes) -> dict[str, bytes]:
    """The files within a note that was made here."""
    return unpacked(content, NOTE_FILES)
