"""The choice of records on the sheet Records: the sets found, the files left out."""

from core.file_names import shown
from core.report.cells import BAD, GOOD, QUIET, RATIO, Book, header, heighten, number, paragraph, rule, text
from core.report.selection_words import lines_of
from core.setting.record_selection import Selection


def selection_rows(book: Book, sheet, selection: Selection, row: int) -> int:
    """The rows from this one on; returns the next."""
    say = book.say
    for line in lines_of(selection, say, book.language):
        row = paragraph(sheet, row, line, 13, 150)
    row += 1
    labels = [
        say("Set"),
        say("Records and factors"),
        say("Rule"),
        say("deviation"),
        "min",
        "T [s]",
        "max",
        "T [s]",
        "PGA",
    ]
    header(sheet, row, labels, 1, 18)
    for n, one in enumerate(selection.sets, start=1):
        row += 1
        number(sheet, row, 1, n, "0", bold=n == 1)
        names = "; ".join(
            f"{shown(record.file).rpartition('/')[2]} {record.channel}".strip() + f" × {book.digits(record.scale, 'g')}"
            for record in one.records
        )
        text(sheet, row, 2, names, size=8, wrap=True)
        heighten(sheet, row, (names, 40))
        text(sheet, row, 3, say("kept") if one.fits else say("not kept"), color=GOOD if one.fits else BAD)
        number(sheet, row, 4, one.deviation, "0.0%")
        (at_low, low), (at_high, high) = one.lowest, one.highest
        for column, value in ((5, low), (6, at_low), (7, high), (8, at_high), (9, one.pga_ratio)):
            number(sheet, row, column, value, RATIO)
        rule(sheet, row, 1, 9)
    row += 2
    for one in selection.left_out:
        line = f"{shown(one.file.name)} {one.channel}".strip() + f": {one.reason.text(book.language)}"
        row = paragraph(sheet, row, line, 13, 150, color=QUIET)
    return row
