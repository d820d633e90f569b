"""A table on a sheet."""

from collections.abc import Iterable
from typing import Any

from core.report.cells import BAD, GOOD, INK, QUIET, Book, header, heighten, number, rule, text
from core.report.tables import NO_VALUE, SHEET, DataTable

COLORS = {"": INK, "good": GOOD, "bad": BAD, "quiet": QUIET}
"""Tone of a cell -> its colour."""

WRAPS_FROM = 18.0
"""Letters from which the words of a column wrap."""


def column_widths(table: DataTable) -> list[float]:
    """Letters of the columns of a table that is the first of its sheet."""
    return [column.width for column in table.shown(SHEET)]


def write_table(book: Book, sheet, row: int, table: DataTable, rows: Iterable[Any], height: int = 32) -> int:
    """The head of a table in a row, and its rows below; returns the last."""
    columns = table.shown(SHEET)
    header(sheet, row, [column.head for column in columns], 1, height)
    for each in book.steps.each(list(rows)):
        row += 1
        wrapped = []
        for k, column in enumerate(columns, start=1):
            value, color, wraps = column.of(each), COLORS[column.tone(each)], column.width >= WRAPS_FROM
            if isinstance(value, str):
                align = None if wraps else "center"  # apart from a number beside it
                text(sheet, row, k, value or NO_VALUE, wrap=wraps, color=color, align=align)
                wrapped += [(value, column.width)] if wraps else []
            else:
                number(sheet, row, k, value, _format(column.number_form(each)), color=color)
        if wrapped:
            heighten(sheet, row, *wrapped)
        rule(sheet, row, 1, len(columns))
    return row


def _format(form: str) -> str:
    """The format of a number in a cell, of one as of format(): ".3f", ".1%", "g"."""
    if not form.startswith("."):
        return "General"
    digits = int(form[1:-1])
    return "0" + ("." + "0" * digits if digits else "") + ("%" if form.endswith("%") else "")
