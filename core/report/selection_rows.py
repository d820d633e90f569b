"""The choice of records on the sheet Records: the sets found, the files left out."""

from core.file_names import shown
from core.report.cells import QUIET, Book, paragraph
from core.report.record_tables import numbered_sets, sets_of_selection
from core.report.selection_words import lines_of
from core.report.sheet_table import write_table
from core.setting.record_selection import Selection


def selection_rows(book: Book, sheet, selection: Selection, row: int) -> int:
    """The rows from this one on; returns the next."""
    say = book.say
    for line in lines_of(selection, say, book.language):
        row = paragraph(sheet, row, line, 13, 150)
    row = write_table(book, sheet, row + 1, sets_of_selection(book), numbered_sets(selection))
    row += 2
    for one in selection.left_out:
        line = f"{shown(one.file.name)} {one.channel}".strip() + f": {one.reason.text(book.language)}"
        row = paragraph(sheet, row, line, 13, 150, color=QUIET)
    return row
