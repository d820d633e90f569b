"""The moment-rotation law of a wall as a small curve."""

import numpy as np
import pyqtgraph as pg

from app import theme
from core.case import Wall
from core.errors import InputError
from core.moment_rotation import moment
from core.restitution import Restitution
from core.rocking import rocking_model


class LawCurve(pg.PlotWidget):
    """Moment over m g R sin(alpha) against theta/alpha."""

    def __init__(self):
        super().__init__()
        self.setBackground(theme.current.back)
        self.setMinimumSize(110, 90)
        self.setMaximumHeight(120)
        self.setMouseEnabled(False, False)
        self.hideButtons()
        self.setMenuEnabled(False)
        self.curve = self.plot(pen=pg.mkPen(theme.current.curves[0], width=2))
        for side, label in (("bottom", "θ/α"), ("left", "M/M₀")):
            axis = self.getAxis(side)
            axis.setPen(theme.current.quiet)
            axis.setTextPen(theme.current.ink)
            self.setLabel(side, label)

    def show_wall(self, wall: Wall) -> None:
        """Draw the law of this wall, nothing while it is not complete."""
        try:
            block, law = wall.block(), wall.moment_law()
        except (InputError, TypeError):
            self.curve.setData([], [])
            return
        model = rocking_model(block, False, Restitution("user", 1.0), law)
        ratio = np.unique([0.0, 1.0, law.elastic_limit, law.plateau_end, *np.linspace(0, 1, 21)])
        top = np.sin(block.slenderness)
        values = [moment(float(x) * block.slenderness, model) / top for x in ratio]
        if law.is_rigid:
            ratio, values = np.insert(ratio, 0, 0.0), np.insert(values, 0, 0.0)
        self.curve.setData(np.asarray(ratio, float), np.asarray(values, float))
