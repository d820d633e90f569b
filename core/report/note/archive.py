"""Files within a note: the case as it was run, its results, the list of its records, not the records (PDF/A-3)."""

import csv
import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

from core.case.note_file import CASE
from core.case.schema import Report
from core.case.writer import dumps
from core.errors import InputError, section
from core.file_names import name_of, shown
from core.regular_file import TooLarge, read_regular
from core.report import json_report
from core.report.note.brief import note
from core.report.note.pdf import STANDARDS, Attachment, Note, Office
from core.report.note.picture import MEGABYTES, SECONDS, TOO_MUCH, fault_of
from core.report.plain_cell import plain_cell
from core.report.steps import Steps
from core.report.words import Words
from core.study.results import StudyResult
from core.version import line

MEASURED = ("started_utc", "seconds")
"""Keys of the results that are of this run alone: the same case gives the same note."""

MAX_LOGO_BYTES = 2_000_000
"""Size of a picture [bytes]."""

HASH = 16
"""Letters of the hash of a case at the foot of a page."""


def note_of(result: StudyResult, base_dir: Path, steps: Steps | None = None, within: bool = True) -> Note:
    """The note of a result, ready to be set.

    base_dir : folder of the case, which the name of the logo is relative to
    within : with its files
    Raises InputError for a logo or a font that is not there, OutputError without the packages of the group `report`.
    """
    report = result.case.report
    parts = list((steps or Steps()).each(note(result, report.language)))
    foot = f"{line()}   SHA-256 {result.case.sha256[:HASH]}"
    office, files = office_of(report, base_dir), note_attachments(result) if within else ()
    return Note(parts, report.language, foot, report.date, office, files, report.font)


def note_as_pdf(result: StudyResult, base_dir: Path, steps: Steps | None = None) -> bytes:
    """The file of `note_of`."""
    return note_of(result, base_dir, steps).pdf(result.case.report.pdf_standard)


def office_of(report: Report, base_dir: Path) -> Office:
    """Whose note it is. Raises InputError for a logo that cannot be shown."""
    lines = tuple(text.strip() for text in report.letterhead.replace("|", "\n").splitlines() if text.strip())
    if not report.logo:
        return Office(report.author, lines)
    path = base_dir / name_of(report.logo)
    here = (section("[report]"),)
    try:
        content = read_regular(path, MAX_LOGO_BYTES)
    except TooLarge:
        raise InputError("logo_too_large", place=here, key="logo", path=path, mb=MAX_LOGO_BYTES / 1e6) from None
    except OSError as error:
        raise InputError("logo_unreadable", place=here, key="logo", path=path, reason=error.strerror) from None
    fault = fault_of(content, tuple(STANDARDS[report.pdf_standard]))
    if fault == TOO_MUCH:
        raise InputError("logo_too_much", place=here, key="logo", path=path, seconds=SECONDS, gb=1e-3 * MEGABYTES)
    if fault:
        raise InputError("logo_not_set", place=here, key="logo", path=path, reason=fault)
    return Office(report.author, lines, content)


def note_attachments(result: StudyResult) -> tuple[Attachment, ...]:
    """The files within the note."""
    case = replace(result.case, walls=None)  # those of a table stand in the case itself
    table = _settled(json_report.results(result))
    say = Words(result.case.report.language).say
    rows = io.StringIO()
    writer = csv.writer(rows, lineterminator="\n")
    writer.writerow(("name", "file", "file_sha256", "samples_sha256"))
    for motion in result.motions:
        named = plain_cell(motion.name), plain_cell(shown(motion.file))
        writer.writerow((*named, motion.file_sha256, motion.samples_sha256))
    kept = result.case.source if not result.case.table else ""
    results = json.dumps(table, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    return (
        Attachment(CASE, dumps(case, kept), "application/toml", "source", say("The case as it was run")),
        Attachment("results.json", results, "application/json", "data", say("Its results")),
        Attachment("records.csv", rows.getvalue(), "text/csv", "supplement", say("Its records by their SHA-256")),
    )


def _settled(value: Any) -> Any:
    """Results without the keys MEASURED, so that two runs of a case give the same file."""
    if isinstance(value, dict):
        return {key: _settled(entry) for key, entry in value.items() if key not in MEASURED}
    return [_settled(entry) for entry in value] if isinstance(value, (list, tuple)) else value
