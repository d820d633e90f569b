"""The text of a case within its reports: what is run again to verify them."""

from dataclasses import replace

from core.case.writer import dumps
from core.study.results import StudyResult


def text_of(result: StudyResult) -> str:
    """The file of a case as it was read; of one that was edited since, or never was a file, what would be saved."""
    return result.case.source or dumps(replace(result.case, walls=None))
