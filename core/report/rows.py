"""Rows of the vertical lists of the Check sheet: label, equation, live value, program's value, unit."""

import math

from core.report.cells import EXACT, QUIET, Book, header, number, rule, text

LIVE, ENGINE = 3, 4
"""Columns of the live value and of the program's value."""


def input_row(book: Book, sheet, row, label, value, unit, name=None, shape=EXACT) -> int:
    """A number of the case, which the formulas refer to by its name; returns the next row."""
    text(sheet, row, 1, label)
    text(sheet, row, 2, book.say("input"), color=QUIET)
    number(sheet, row, LIVE, value, shape)
    text(sheet, row, 5, unit, color=QUIET, align="center")
    if name and value is not None:
        book.name(name, sheet.cell(row, LIVE))
    rule(sheet, row, 1, 5)
    return row + 1


def live_row(
    book: Book, sheet, row, label, equation, formula, value, unit, name=None, shape=EXACT
) -> int:
    """A live formula and the program's value beside it; returns the next row."""
    text(sheet, row, 1, label)
    text(sheet, row, 2, equation, color=QUIET)
    if value is None:
        number(sheet, row, LIVE, None, shape)
    else:
        book.formula(sheet.cell(row, LIVE), formula, value, shape)
        if name:
            book.name(name, sheet.cell(row, LIVE))
    number(sheet, row, ENGINE, value, shape, color=QUIET)
    text(sheet, row, 5, unit, color=QUIET, align="center")
    rule(sheet, row, 1, 5)
    return row + 1


def heads(book: Book, sheet, row: int, label: str) -> int:
    """The header of a vertical list; returns the next row."""
    say = book.say
    height = 18 * math.ceil(len(label) / 30)
    header(sheet, row, [label, say("Equation"), say("Sheet"),
                        say("Program"), say("Unit")], 1, height)  # fmt: skip
    return row + 1
