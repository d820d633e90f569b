"""The workbook of a result, all walls of which are there."""

from core.report.cells import Book
from core.report.steps import Steps
from core.report.workbook import WorkbookReport
from core.study.results import CollapseHistories, StudyResult


def content(result: StudyResult, histories: list[CollapseHistories]) -> bytes:
    """Its xlsx file; the parameters are those of `WorkbookReport.content`."""
    return _made(result).content(result, histories, Steps())


def build(result: StudyResult, histories: list[CollapseHistories]) -> Book:
    """The same before it is saved, and the values of its formulas."""
    return _made(result).build(result, histories, Steps())


def _made(result: StudyResult) -> WorkbookReport:
    made = WorkbookReport(result.case.report.language)
    for wall in result.split_by_wall():
        made.add(wall)
    return made
