"""Small curves beside the forms: the moment-rotation law of a wall, the spectrum of the demand."""

import numpy as np
from PySide6.QtCore import Qt

from app.look import theme
from app.look.charting import pg
from app.views.axis import Axis
from core.case.wall import Wall
from core.errors import InputError
from core.units import G
from core.wall.impact import Restitution
from core.wall.moment_rotation import moment
from core.wall.rocking_model import rocking_model

MAX_PERIOD = 3.0
"""Period up to which a spectrum is drawn [s]."""


class SmallCurve(pg.PlotWidget):
    """One curve to look at, not to work with."""

    def __init__(self, x: str, y: str):
        super().__init__(axisItems={side: Axis(side) for side in ("bottom", "left")})
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setBackground(theme.current.back)
        self.setMinimumSize(110, 90)
        self.setMaximumHeight(120)
        self.setMouseEnabled(False, False)
        self.hideButtons()
        self.setMenuEnabled(False)
        self.curve = self.plot(pen=pg.mkPen(theme.current.curves[0], width=2))
        for side, label in (("bottom", x), ("left", y)):
            axis = self.getAxis(side)
            axis.setSIPrefixEnableRanges(())
            axis.enableAutoSIPrefix(False)
            axis.setPen(theme.current.quiet)
            axis.setTextPen(theme.current.ink)
            self.setLabel(side, label)


class SpectrumCurve(SmallCurve):
    """Elastic 5 % spectrum of the demand [g] over the period [s]."""

    def __init__(self):
        super().__init__("T [s]", "Se [g]")
        self.shown: tuple | None = None
        self.others: dict[str, tuple[pg.PlotDataItem, pg.TextItem]] = {}

    def show_target(self, target, others: dict) -> None:
        """Draw this target, nothing where there is none. others : name -> target, drawn thin beside it"""
        if (target, others) == self.shown:
            return
        self.shown = (target, others)
        self.setVisible(target is not None)
        for name in self.others.keys() - others.keys():
            for item in self.others.pop(name):
                self.removeItem(item)
        periods = np.linspace(0.0, MAX_PERIOD, 151)
        for name, other in others.items():
            line, words = self.others.get(name) or self._another(name)
            values = np.asarray(other.acceleration(periods)) / G
            line.setData(periods, values)
            words.setPos(periods[30], values[30])
        if target is not None:
            self.curve.setData(periods, np.asarray(target.acceleration(periods)) / G)

    def _another(self, name: str) -> tuple[pg.PlotDataItem, pg.TextItem]:
        """A thin line and its name."""
        line = self.plot(pen=pg.mkPen(theme.current.quiet, width=1))
        words = pg.TextItem(name, color=theme.current.quiet, anchor=(0.0, 1.0))
        self.addItem(words)
        self.others[name] = line, words
        return line, words


class LawCurve(SmallCurve):
    """Moment over that at rest against theta/theta_c, outward."""

    def __init__(self):
        super().__init__("θ/θc", "M/M₀")

    def show_wall(self, wall: Wall | None) -> None:
        """Draw the law of this wall, nothing while it is not complete."""
        if wall is None:
            self.curve.setData([], [])
            return
        try:
            block, law, loads = wall.block(), wall.moment_law(), wall.in_si.restoring
        except (InputError, TypeError):
            self.curve.setData([], [])
            return
        model = rocking_model(block, False, Restitution("user", 1.0), law, loads)
        ratio = np.array(sorted({law.elastic_limit, law.plateau_end, *np.linspace(0.0, 1.0, 21)}))
        end = model.slenderness + model.restoring.lean
        top = model.restoring.amplitude * np.sin(end)
        values = [moment(float(x) * end, model) / top for x in ratio]
        if law.is_rigid:
            ratio, values = np.insert(ratio, 0, 0.0), np.insert(values, 0, 0.0)
        self.curve.setData(np.asarray(ratio, float), np.asarray(values, float))
