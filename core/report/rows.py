"""Rows of the vertical lists of the Check sheet: label, equation, live value, program's value, unit."""

import math
from copy import copy

from openpyxl.formatting.rule import FormulaRule
from openpyxl.styles import Font
from openpyxl.utils import get_column_letter

from core.report.cells import BAD, EXACT, QUIET, Book, fill, header, number, rule, style, text

LIVE_COLUMN, ENGINE_COLUMN = 3, 4
"""Columns of the live value and of the program's value."""

CHANGED_COLUMN = 15
"""Hidden column of the sheet Check: 1 in the row of an input that differs from that of the run."""

OLD = "A9B2BB"
"""Colour of what is of the run and not of a changed input."""

INPUT_FILL = "FFF6D5"
"""Colour of the cells a person may change."""


def input_row(book: Book, sheet, row, label, value, unit, name=None, shape=EXACT) -> int:
    """A number of the case, which a person may change and the formulas refer to by its name; returns the next row."""
    row = run_value_row(book, sheet, row, label, value, unit, name, shape, book.say("input"))
    if value is not None:
        fill(sheet.cell(row - 1, LIVE_COLUMN), INPUT_FILL)
        number(sheet, row - 1, ENGINE_COLUMN, value, shape, color=QUIET)
        mark_changed(book, sheet, row - 1, f"C{row - 1}", f"D{row - 1}")
    return row


def run_value_row(book: Book, sheet, row, label, value, unit, name=None, shape=EXACT, source=None) -> int:
    """A number of the run that no formula of the sheet gives. source : word of column B, "of the run" by default."""
    text(sheet, row, 1, label)
    text(sheet, row, 2, source or book.say("of the run"), color=QUIET)
    number(sheet, row, LIVE_COLUMN, value, shape)
    text(sheet, row, 5, unit, color=QUIET, align="center")
    if name and value is not None:
        book.name(name, sheet.cell(row, LIVE_COLUMN))
        if source is None:
            book.of_run.add(name)
    rule(sheet, row, 1, 5)
    return row + 1


def mark_changed(book: Book, sheet, row: int, now: str, then: str) -> None:
    """The hidden mark of a row whose inputs are the cells `now`, in the run the cells `then`."""
    formula = f"=IF(IFERROR(SUMPRODUCT(ABS({now}-{then})),1)>1E-9,1,0)"
    book.formula(sheet.cell(row, CHANGED_COLUMN), formula, 0.0, "0")


def close_inputs(book: Book, sheet) -> None:
    """After the last row: the cell `inputs_changed` counts the inputs that differ from those of the run; what does not
    follow turns grey."""
    letter = sheet.cell(1, CHANGED_COLUMN).column_letter
    last = sheet.max_row
    _when_changed(sheet, f"C4:C{last}", f'$B4="{book.say("of the run")}"', OLD)
    own = "AND(NOT(_xlfn.ISFORMULA(D4)),ISNUMBER(D4),NOT(ISNUMBER($P4)))"
    _when_changed(sheet, f"D4:M{last}", own, OLD)  # P holds what loads were: theirs are inputs
    cell = sheet.cell(1, CHANGED_COLUMN)
    book.formula(cell, f"=SUM({letter}2:{letter}{sheet.max_row})", 0.0, "0")
    book.name("inputs_changed", cell)
    for column in range(CHANGED_COLUMN, CHANGED_COLUMN + 7):
        sheet.column_dimensions[sheet.cell(1, column).column_letter].hidden = True


def changed_cell(book: Book, sheet, row: int, column: int) -> None:
    """A cell that states plainly that an input is no longer that of the run."""
    words = book.say(
        "Input changed since the run: q and ζ of the histories, and all that is marked 'of the run', are of the "
        "old wall. Run the case again."
    )
    cell = sheet.cell(row, column)
    book.formula(cell, f'=IF(inputs_changed>0,"{words}","")', "")
    style(cell, bold=True, color=BAD, size=11)


def follow_changes(book: Book, sheet, titled: bool) -> None:
    """A sheet of the run: once an input is changed its title says so in red, and what does not follow turns grey.
    titled : by a text of the program, which a formula can hold; else the sheet has its own line"""
    head = sheet.cell(1, 1)
    if titled and head.data_type == "s":
        old = book.say("Input changed since the run, grey is of the old wall: {title}", title=head.value)
        texts = ('"' + words.replace('"', '""') + '"' for words in (old, head.value))
        look = copy(head._style)
        book.formula(head, "=IF(inputs_changed>0,{},{})".format(*texts), head.value, "General")
        head._style = look
        _when_changed(sheet, "A1", "TRUE", BAD)
    last = f"{get_column_letter(sheet.max_column)}{max(sheet.max_row, 2)}"
    _when_changed(sheet, f"A2:{last}", "NOT(_xlfn.ISFORMULA(A2))", OLD)
    old = {f"={name}" for name in book.of_run}
    cells = [cell.coordinate for cell in sheet._cells.values() if cell.value in old]
    if cells:
        _when_changed(sheet, " ".join(cells), "TRUE", OLD)


def _when_changed(sheet, cells: str, condition: str, color: str) -> None:
    """The colour of cells once an input is changed. condition : of the first of them"""
    formula = f"AND(inputs_changed>0,{condition})"
    sheet.conditional_formatting.add(cells, FormulaRule([formula], font=Font(color=color)))


def formula_row(book: Book, sheet, row, label, equation, formula, value, unit, name=None, shape=EXACT, run=None) -> int:
    """A live formula and the program's value beside it; returns the next row.

    book : Book
    sheet : the sheet
    row : its row, from 1 on
    label : what the row gives
    equation : where it comes from
    formula : of the cell
    value : the program's, None where it has none
    unit : of both
    name : of the live cell, None without
    shape : format of the numbers
    run : name of the program's value, for what the histories found and no changed input moves
    """
    text(sheet, row, 1, label)
    text(sheet, row, 2, equation, color=QUIET)
    if value is None:
        number(sheet, row, LIVE_COLUMN, None, shape)
    else:
        book.formula(sheet.cell(row, LIVE_COLUMN), formula, value, shape)
        if name:
            book.name(name, sheet.cell(row, LIVE_COLUMN))
    number(sheet, row, ENGINE_COLUMN, value, shape, color=QUIET)
    if run and value is not None:
        book.name(run, sheet.cell(row, ENGINE_COLUMN))
    text(sheet, row, 5, unit, color=QUIET, align="center")
    rule(sheet, row, 1, 5)
    return row + 1


def heads(book: Book, sheet, row: int, label: str) -> int:
    """The header of a vertical list; returns the next row."""
    say = book.say
    height = 18 * math.ceil(len(label) / 30)
    header(sheet, row, [label, say("Equation"), say("Sheet"), say("Program"), say("Unit")], 1, height)
    return row + 1
