"""The capacity curve of a wall over the demand, displacement against acceleration (Circolare 7/2019 C8.7.1.3)."""

import math

import numpy as np

from app.look.language import number, tr
from app.views.chart import Chart
from app.views.runs import title_of
from core.codes.capacity_curve import capacity_curve
from core.known import require_value
from core.study.results import StudyResult, WallResult
from core.units import CM, G


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
        self.caption = title_of(wall)
        kinematic, demand = wall.assessment.kinematic if wall.assessment else None, result.demand
        curve = capacity_curve(kinematic, demand) if kinematic and demand else None
        if kinematic is None or demand is None or curve is None:
            self.say_why(tr("No displacement check: it needs a spectrum and a demand at SLV or SLC."))
            return
        percent = number(100.0 * curve.damping, "g")
        self.curve(tr("demand {percent} %", percent=percent), curve.demand_d / CM, curve.demand_a / G, 1, path=True)
        if curve.floor_d.size:
            name = tr("floor {percent} %", percent=percent)
            self.curve(name, curve.floor_d / CM, curve.floor_a / G, 2, path=True)
        along, across = (np.array(values) for values in zip(*curve.capacity, strict=True))
        self.curve(tr("capacity"), along / CM, across / G, 0, 2.4)
        state, slope = demand.limit_state, (2.0 * math.pi / require_value(kinematic.period)) ** 2
        d_limit, a_limit, s_de = (
            require_value(kinematic.d_limit),
            require_value(kinematic.a_limit),
            require_value(kinematic.s_de),
        )
        self.points(f"d_{state}", [d_limit / CM], [a_limit / G], 0)
        self.points("S_De", [s_de / CM], [slope * s_de / G], 1)
        end = max(1.15 * d_limit, s_de)
        self.curve(f"T_{state}", [0.0, end / CM], [0.0, slope * end / G], "quiet", 1.0, dash=True)
        high = 1.1 * max(across[0], *curve.demand_a, *curve.floor_a) / G
        self.set_range((0.0, 1.05 * max(require_value(kinematic.d0), s_de) / CM), (0.0, high))
