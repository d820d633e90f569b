"""The capacity curve of a wall over the demand, displacement against acceleration (Circolare 7/2019 C8.7.1.3)."""

from app.look.language import current_language, tr
from app.views.chart import Chart
from app.views.runs import title_of
from core.report.note.wall_figures import capacity
from core.report.words import Words
from core.study.results import StudyResult, WallResult


class CapacityCurveChart(Chart):
    """Draws the capacity curve of a wall without time histories, in the place of the peaks at the demand."""

    def __init__(self):
        super().__init__("d [cm]", "a [g]", tr("Capacity curve"))
        self.hide()

    def show_in_place_of(self, other: Chart, result: StudyResult, wall: WallResult) -> None:
        """Draw the curves of a wall that bends and has no histories in the place of another chart, which is shown for
        any other wall."""
        here = wall.wall.bends and not (wall.assessment and wall.assessment.dynamic)
        other.setVisible(not here)
        self.setVisible(here)
        if here:
            self.show_wall(result, wall)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Draw the curves; says why where the displacement check is not made."""
        self.clear()
        self.caption, kinematic = title_of(wall), wall.assessment.kinematic if wall.assessment else None
        figure = capacity(result, wall, Words(current_language())) if kinematic and result.demand else None
        if figure is None:
            self.say_why(tr("No displacement check: it needs a spectrum and a demand at SLV or SLC."))
            return
        self.show_figure(figure)
