"""What the pages of a result have in common."""

from PySide6.QtWidgets import QWidget

from core.study.results import StudyResult, WallResult


class ResultTab(QWidget):
    """Shows one wall of a result at a time."""

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        raise NotImplementedError
