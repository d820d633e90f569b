"""The key plan of a building as a chart: each wall in the colour of its outcome; a click opens it."""

import math
from functools import partial

from PySide6.QtCore import Signal

from app.look import theme
from app.look.charting import pg
from app.look.language import tr, wall_title
from app.views.chart import Chart
from app.views.zeta_rungs import digits
from core.report.key_plan import Placed, centre_of, key_plan, size_of
from core.study.results import StudyResult

AWAY, NEAR = 0.05, 0.06
"""Distance of the words from their wall, and how near a click is on it, of the size of the plan."""


class PlanChart(Chart):
    """The walls that have a place in plan. picked(k) : the result that decides about a wall that was clicked"""

    picked = Signal(int)

    def __init__(self):
        super().__init__("x [m]", "y [m]", tr("Key plan"))
        self.plot.setAspectLocked(True)
        self.placed: list[Placed] = []
        self.clicked.connect(self._clicked)

    def show_result(self, result: StudyResult) -> bool:
        """Draw the plan; whether there is one."""
        self.clear()
        self.placed = key_plan(result)
        if len(self.placed) < 2:
            return False
        centre, size = centre_of(self.placed), size_of(self.placed)
        for one in self.placed:
            (x1, y1), (x2, y2) = one.ends
            name = f"{wall_title(one.name)} ζ {digits(one.zeta)}"
            self.curve(name, [x1, x2], [y1, y2], one.tone or "ink", 5.0, legend=False, path=True)
            label = pg.TextItem(name, anchor=(0.5, 0.5), angle=_along(one))
            self.add(label, partial(_colour, label))
            label.setPos(*one.beside(centre, AWAY * size))
        self.fit()
        return True

    def _clicked(self, x: float, y: float) -> None:
        """Open the wall nearest to a place."""
        near = min(self.placed, key=lambda one: _distance(one, x, y), default=None)
        if near is not None and _distance(near, x, y) <= NEAR * size_of(self.placed):
            self.picked.emit(near.result)


def _along(one: Placed) -> float:
    """Angle of a wall, along which its name is read from below or from the right [deg]."""
    (x1, y1), (x2, y2) = one.ends
    angle = math.degrees(math.atan2(y2 - y1, x2 - x1))
    return angle - 180.0 if angle > 90.0 else angle + 180.0 if angle <= -90.0 else angle


def _colour(label: pg.TextItem, chosen: theme.Theme, scale: float) -> None:
    """Words in the ink of a theme."""
    label.setColor(chosen.ink)


def _distance(one: Placed, x: float, y: float) -> float:
    """How far a place lies from a wall [m]."""
    (x1, y1), (x2, y2) = one.ends
    along = (x2 - x1) ** 2 + (y2 - y1) ** 2 or 1.0
    share = min(max(((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / along, 0.0), 1.0)
    return math.hypot(x - x1 - share * (x2 - x1), y - y1 - share * (y2 - y1))
