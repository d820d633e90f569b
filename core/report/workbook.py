"""StudyResult -> workbook: the sheets in order."""

from collections.abc import Callable

from openpyxl.worksheet.worksheet import Worksheet

from core.report import (
    body_sheet,
    certainty_sheet,
    check_sheet,
    demand_sheets,
    floor_sheet,
    input_sheet,
    plots,
    risk_sheet,
    sheets,
    summary_sheet,
    uncertainty_text,
)
from core.report.cells import ACCENT, QUIET, Book
from core.report.rows import follow_changes
from core.report.steps import Steps
from core.study.results import CollapseHistories, StudyResult

FIRST_PACKED = 5
"""Row from which on the rows of a sheet are packed: those before are changed to the last."""

SHEET_STEPS, SAVING_STEPS = (0, 0, 1, 0, 0, 0, 1, 10, 5, 0, 0, 1, 12, 3, 1), 13
"""Hundredths of the writing that each sheet after Check in its order, and the file, take with 300 walls."""


class WorkbookReport:
    """The workbook of a study, whose sheet Check is made while the walls finish.

    language : of its words
    check : called at every part, may raise to end the work
    """

    def __init__(self, language: str, check: Callable[[], None] = lambda: None):
        self.book = Book(language, Steps(check))
        self.book.workbook.remove(self.book.workbook.active)
        self._check: check_sheet.CheckSheet | None = None

    def add(self, result: StudyResult) -> None:
        """The next wall, see `StudyResult.by_wall`."""
        if self._check is None:
            self._check = check_sheet.CheckSheet(self.book, result)
        self._check.add(result)

    def content(self, result: StudyResult, histories: list[CollapseHistories], steps: Steps) -> bytes:
        """The xlsx file, once all walls are there.

        histories : of the walls whose histories are drawn; the rest are listed
        steps : how far it is
        """
        book = self.build(result, histories, steps)
        steps.take(SAVING_STEPS)
        return book.content()

    def build(self, result: StudyResult, histories: list[CollapseHistories], steps: Steps) -> Book:
        """The workbook before it is saved; the parameters are those of `content`."""
        book, check = self.book, self._check or check_sheet.CheckSheet(self.book, result)
        book.steps = steps
        steps.take(sum(SHEET_STEPS))
        _finish(book, check.close())
        sheets_in_order = (
            body_sheet.bodies,
            summary_sheet.summary,
            summary_sheet.overview,
            risk_sheet.risk,
            certainty_sheet.certainty,
            input_sheet.inputs,
            sheets.records,
            sheets.results,
            demand_sheets.dynamic_check,
            demand_sheets.spectral_compatibility,
            floor_sheet.floors,
            plots.q_against_si,
            lambda book, result: plots.histories(book, result, histories),
            plots.survival_map,
            sheets.method,
        )
        for sheet in steps.each(sheets_in_order, SHEET_STEPS):
            if sheet is summary_sheet.overview and summary_sheet.lists_all(result):
                continue
            if sheet is body_sheet.bodies and not body_sheet.has_bodies(result):
                continue
            if sheet is risk_sheet.risk and not risk_sheet.has_risk(result):
                continue
            if sheet is certainty_sheet.certainty and not uncertainty_text.has_certainty(result):
                continue
            if sheet is floor_sheet.floors and not floor_sheet.floors_of(result):
                continue
            before = len(book.workbook.worksheets)
            sheet(book, result)
            for made in book.workbook.worksheets[before:]:
                _finish(book, made)
        # made first, for the others show its cells: it stands behind the results, its bodies behind it
        if body_sheet.has_bodies(result):
            place = book.workbook.sheetnames.index(book.say("Results"))
            book.workbook.move_sheet(book.say("Bodies"), place - 1)
        place = book.workbook.sheetnames.index(book.say("Results"))
        book.workbook.move_sheet(book.say("Check"), place)
        return book


def _finish(book: Book, sheet: Worksheet) -> None:
    """Give a sheet what every one has, once it is made; from then on its rows are kept packed."""
    front = sheet.title in (book.say("Summary"), book.say("Overview"))
    sheet.sheet_properties.tabColor = ACCENT if front else QUIET
    if sheet.title not in {book.say(name) for name in ("Check", "Input", "Records", "Method")}:
        follow_changes(book, sheet, titled=sheet.title != book.say("Summary"))
    book.rows_of(sheet).pack(FIRST_PACKED, sheet.max_row)
