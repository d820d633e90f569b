"""The sheet Input: the case in words, what the user did not write marked as default."""

from dataclasses import fields

from core.case.case_files import as_lines
from core.case.keys import format_unit
from core.case.schema import Case, sections
from core.report.case_text import text_of
from core.report.cells import QUIET, Book, header, heighten, number, paragraph, rule, text, title
from core.study.results import StudyResult
from core.text.sentence import capital, choice, word

UNIT_OF_KEY = {
    entry.name: entry.metadata["unit"]
    for section in sections().values()
    for entry in fields(section)
    if entry.metadata.get("unit")
}
"""Key -> its unit."""


def inputs(book: Book, result: StudyResult) -> None:
    """The case section by section, wall by wall."""
    say, case = book.say, result.case
    sheet = book.sheet("Input", [40, 44, 9, 14])
    title(sheet, 1, say("Input as read"))
    text(sheet, 2, 1, f"SHA-256 {case.sha256}", color=QUIET, size=8)
    row = _line(book, sheet, 3, "title", case.title, None)
    from_table = case.differing() if case.table else frozenset()
    for section, index, heading, values in book.steps.each(_sections(book, case)):
        header(sheet, row, [heading, "", "", ""], 1, 15)
        row += 1
        for key, value in values.items():
            if value is None or value in ("", ()):
                continue
            place = (section, index, key)
            source = None
            if place not in case.given:
                in_table = section == "wall" and place in from_table
                source = say("table of walls") if in_table else say("default")
            row = _line(book, sheet, row, key, value, source)
    for note in (*case.table_notes, *case.drawings):
        row = paragraph(sheet, row, f"• {note.text(book.language)}", 4, 110, color=QUIET)
    title(sheet, row + 1, book.say("The case as it was run"), 12)
    for row, line in enumerate(text_of(result).splitlines(), start=row + 2):  # noqa: B020  (the row above is done)
        text(sheet, row, 1, line)
    title(sheet, row + 2, book.say("The files it names, as they were read"), 12)
    for n, line in enumerate(as_lines(case.files), start=row + 3):
        text(sheet, n, 1, line, size=8, color=QUIET)
    sheet.freeze_panes = "A3"


def _line(book: Book, sheet, row: int, key: str, value, source: str | None) -> int:
    """A key in words, its value and unit, where it comes from; returns the next row."""
    language = book.language
    label = word(f"key_{key}", language)
    text(sheet, row, 1, capital(label))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        # the word of "none" is that of a mass
        shown = book.say("as recorded") if (key, value) == ("scaling", "none") else spelled(value, book)
        text(sheet, row, 2, shown, wrap=True)
        heighten(sheet, row, (shown, 50))
    else:
        number(sheet, row, 2, value, "General", align="left")
        text(sheet, row, 3, format_unit(UNIT_OF_KEY.get(key, "")), color=QUIET)
    if source:
        text(sheet, row, 4, source, color=QUIET, italic=True)
    rule(sheet, row, 1, 4)
    return row + 1


def spelled(value, book: Book) -> str:
    """A value of any key in words, a list or a table of them in one line."""
    if isinstance(value, bool):
        return book.say("yes") if value else book.say("no")
    if isinstance(value, dict):
        parts = ((word(f"key_{name}", book.language), end) for name, end in value.items() if end not in (None, ""))
        return ", ".join(f"{name} {spelled(end, book)}" for name, end in parts)
    if isinstance(value, tuple):
        return "; ".join(spelled(part, book) for part in value)
    if isinstance(value, float):
        return book.digits(value, "g")
    return choice(str(value), book.language)


def _sections(book: Book, case: Case):
    """(section, index, heading, keys and values)"""
    content = case.as_dict()
    for section in ("report", "demand", "building", "wall", "record", "generate", "select", "analysis", "sensitivity"):
        items = content[section]
        heading = word(f"section_{section}", book.language)
        if isinstance(items, dict):
            yield section, 0, heading, items
        else:
            for index, item in enumerate(items or ()):
                name = f": {item['name']}" if section == "wall" else ""
                yield section, index, f"{heading} {index + 1}{name}", item
