"""Where two results, two workbooks or the words of two notes differ."""

import contextlib
import difflib
import io
import zipfile
from collections.abc import Iterator
from typing import Any, NamedTuple

from core.text.sentence import LANGUAGES, localized

OF_THE_RUN = ("started_utc", "seconds", "commit")
"""Keys of the results that are of one run alone."""

WHEN_WRITTEN = "docProps/core.xml"
"""Part of a workbook that says when it was written."""

MAX_LETTERS_SHOWN = 80
"""Letters of a value that are quoted."""


class Difference(NamedTuple):
    """place : path of a key, cell or line; reported, found : as text, "" where there is none; share : of two numbers"""

    place: str
    reported: str
    found: str
    share: float | None = None


def diff_results(reported: Any, rerun: Any, place: str = "") -> Iterator[Difference]:
    """Compare two results as read from their JSON, key by key."""
    if isinstance(reported, dict) and isinstance(rerun, dict):
        for key in [*reported, *(key for key in rerun if key not in reported)]:
            if key not in OF_THE_RUN:
                path = f"{place}.{key}" if place else key
                yield from diff_results(reported.get(key, ...), rerun.get(key, ...), path)
    elif isinstance(reported, list) and isinstance(rerun, list) and len(reported) == len(rerun):
        for n, (one, other) in enumerate(zip(reported, rerun, strict=True)):
            yield from diff_results(one, other, f"{place}[{n}]")
    elif not _same(reported, rerun):
        share = None
        if _is_number(reported) and _is_number(rerun):
            with contextlib.suppress(OverflowError):  # a whole number beyond what a float holds
                share = abs(rerun - reported) / max(abs(rerun), abs(reported))
        yield Difference(place, _text(reported), _text(rerun), share)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _same(reported: Any, rerun: Any) -> bool:
    if _is_number(reported) and _is_number(rerun):
        return reported == rerun
    return type(reported) is type(rerun) and reported == rerun


def _text(value: Any) -> str:
    return "" if value is ... else str(value)[:MAX_LETTERS_SHOWN]


def case_of_workbook(content: bytes) -> tuple[str, list[str]]:
    """The text of the case within a workbook, "" if there is none, and the lines of the files it names
    (core/case/case_files.py)."""
    import openpyxl

    book = openpyxl.load_workbook(io.BytesIO(content), read_only=True)  # this sheet alone
    for language in LANGUAGES:

        def say(text: str, language: str = language) -> str:
            return localized("report", text, language)

        name, heading = say("Input"), say("The case as it was run")
        files_heading = say("The files it names, as they were read")
        if name in book.sheetnames:
            book[name].reset_dimensions()  # a file may claim another size
            column = [row[0] if row else None for row in book[name].iter_rows(values_only=True)]
            if heading in column:
                lines = ["" if line is None else str(line) for line in column[column.index(heading) + 1 :]]
                end = lines.index(files_heading) if files_heading in lines else len(lines)
                return "\n".join(lines[:end]).rstrip("\n") + "\n", list(filter(None, lines[end + 1 :]))
    return "", []


class WorkbookComparison(NamedTuple):
    """parts : names of those of a workbook that are others than those that are written here: formats, hidden rows and
    sheets, pictures, comments, links as well as cells; cells : what differs in these"""

    parts: list[str]
    cells: list[Difference]


def compare_workbooks(reported: bytes, rerun: bytes) -> WorkbookComparison:
    """Compare two workbooks part by part, and where parts differ cell by cell. Raises what openpyxl raises of a file
    that is none."""
    found, made = _parts(reported), _parts(rerun)
    if found == made:
        return WorkbookComparison([], [])
    each = [dict(parts) for parts in (found, made)]
    names = list(dict.fromkeys(name for parts in each for name in parts))
    changed = [name for name in names if each[0].get(name) != each[1].get(name)]
    return WorkbookComparison(changed or ["[order]"], _diff_cells(reported, rerun))


def _diff_cells(reported: bytes, rerun: bytes) -> list[Difference]:
    """The differences of two workbooks, cell by cell: formulas, and the values that are kept beside them."""
    import openpyxl

    differences: list[Difference] = []
    for live in (True, False):  # values, then formulas
        books = [openpyxl.load_workbook(io.BytesIO(one), data_only=live) for one in (reported, rerun)]
        names = [book.sheetnames for book in books]
        if live and names[0] != names[1]:
            differences.append(Difference("", ", ".join(names[0]), ", ".join(names[1])))
        for name in [name for name in names[0] if name in names[1]]:
            cells = [_cells(book[name]) for book in books]
            for place in [*cells[0], *(place for place in cells[1] if place not in cells[0])]:
                one, other = (_of_cell(sheet_cells.get(place)) for sheet_cells in cells)
                if one != other and not (live is False and not _is_formula(one) and not _is_formula(other)):
                    differences += diff_results(one, other, f"{name}!{place}")
    return differences


def _parts(content: bytes) -> list[tuple[str, bytes]]:
    """Name and content of the parts of a workbook, but for the one that says when it was written."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        return [(one.filename, archive.read(one)) for one in archive.infolist() if one.filename != WHEN_WRITTEN]


def _cells(sheet) -> dict[str, Any]:
    """Coordinate -> value of the cells of a sheet that hold one."""
    return {cell.coordinate: cell.value for row in sheet.iter_rows() for cell in row if cell.value is not None}


def _of_cell(value: Any) -> Any:
    """What a cell holds; of a formula of an array its text."""
    value = getattr(value, "text", value)
    return ... if value is None else value if isinstance(value, (str, int, float, bool)) else str(value)


def _is_formula(value: Any) -> bool:
    return isinstance(value, str) and value.startswith("=")


def words_of_notes(contents: list[bytes]) -> list[list[str]]:
    """Lines of each of these notes, page after page, in a child process. Raises what pypdf raises of a file that is
    none."""
    import pypdf

    readers = [pypdf.PdfReader(io.BytesIO(content)) for content in contents]
    return [[line for page in reader.pages for line in page.extract_text().splitlines()] for reader in readers]


def diff_lines(reported: list[str], rerun: list[str]) -> Iterator[Difference]:
    """Compare the lines of two notes; places are numbers of lines of the reported one, from 1."""
    matcher = difflib.SequenceMatcher(None, reported, rerun, autojunk=False)
    for kind, start, end, first, last in matcher.get_opcodes():
        if kind != "equal":
            place = f"{start + 1}" if end <= start + 1 else f"{start + 1}-{end}"
            yield Difference(
                place,
                " / ".join(reported[start:end])[:MAX_LETTERS_SHOWN],
                " / ".join(rerun[first:last])[:MAX_LETTERS_SHOWN],
            )
