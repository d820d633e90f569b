"""StudyResult -> workbook: the sheets in order."""

from core.report import check_sheet, demand_sheets, plots, sheets, summary_sheet
from core.report.cells import Book
from core.results import CollapseHistories, StudyResult

HISTORY_WALLS = 20
"""Walls whose histories and charts are drawn; the rest are listed."""


def content(result: StudyResult, histories: list[CollapseHistories]) -> bytes:
    """The xlsx file of a study. histories : of the first HISTORY_WALLS walls with a collapse."""
    return build(result, histories).content()


def build(result: StudyResult, histories: list[CollapseHistories]) -> Book:
    """The workbook before it is saved, and the values of its formulas."""
    book = Book(result.case.report.language)
    book.workbook.remove(book.workbook.active)
    summary_sheet.summary(book, result)
    if len(result.walls) > summary_sheet.SUMMARY_WALLS:
        summary_sheet.overview(book, result)
    sheets.inputs(book, result)
    sheets.records(book, result)
    sheets.results(book, result)
    check_sheet.check(book, result)
    demand_sheets.dynamic_check(book, result)
    demand_sheets.spectral_compatibility(book, result)
    plots.q_against_si(book, result)
    plots.histories(book, result, histories)
    plots.survival_map(book, result)
    sheets.method(book, result)
    return book
