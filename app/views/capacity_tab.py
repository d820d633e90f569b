"""The tab Capacity: peak rotation against q, survival map, fragility."""

import math

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QVBoxLayout

from app.look import theme
from app.look.charting import pg
from app.look.labels import PlainLabel
from app.look.language import number, result_word, tr
from app.look.whole_text import tell_whole
from app.views.chart import Chart
from app.views.hatch import Hatch, hatched_square
from app.views.result_tab import ResultTab
from app.views.runs import run_name, title_of
from core.answer.answer import run_shown_first
from core.capacity.fragility import fragility_curve
from core.capacity.ida import grid_point, multiplier_of, threshold_of
from core.known import require_value
from core.rocking.history import scan_multipliers
from core.rocking.outcome import COLLAPSED, STABLE
from core.study.results import Run, StudyResult, WallResult

OVERTURNED_AT = 1.25
"""Where a point that overturned is drawn, at the upper edge: it has no number."""

Q_TICKS = (0.5, 0.7, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 40, 60, 100)
"""Ticks of q of the survival map."""


class CapacityTab(ResultTab):
    """Peak rotation against q of one record or of all, survival strips of all, fragility of the wall."""

    def __init__(self):
        super().__init__()
        self.record, self.other = QComboBox(), QComboBox()
        self.record.setAccessibleName(tr("Record"))
        self.record.activated.connect(lambda _: self._show_peaks())
        self.other.setAccessibleName(tr("Compare with"))
        self.other.activated.connect(lambda _: self._show_fragility())
        self.peaks = Chart("q [-]", "θmax/θc [-]", tr("Peak rotation against q"))
        self.strips = Chart("q [-]", tr("run"), tr("Survival map"))
        self.strips.column = tr("outcome (0 stands, 1 overturned, 2 and 3 none)")
        self.fragility = Chart("q [-]", tr("share collapsed [-]"), tr("Fragility"))
        choices, top = QHBoxLayout(), QHBoxLayout()
        self.title = PlainLabel()
        self.title.setWordWrap(True)
        for box in (self.record, self.other):
            box.setMinimumWidth(60)
            tell_whole(box)
            choices.addWidget(box, 1)
        top.addWidget(self.peaks, 1)
        top.addWidget(self.fragility, 1)
        layout = QVBoxLayout(self)
        layout.addWidget(self.title)
        layout.addLayout(choices)
        layout.addLayout(top, 1)
        layout.addWidget(self.strips, 1)
        self.shown: tuple[StudyResult, WallResult] | None = None

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from one wall of a result."""
        self.shown = (result, wall)
        self.title.setText(title_of(wall))
        self.record.clear()
        for run in wall.runs:
            self.record.addItem(run_name(run))
        self.record.setCurrentIndex(run_shown_first(wall))
        if len(wall.runs) > 1:
            self.record.addItem(tr("all records, with their mean"))
        self.other.clear()
        self.other.addItem(tr("compare with no other wall"))
        for other in result.walls:
            self.other.addItem(tr("compare with {wall}", wall=f"{other.name}, {result_word(other.mechanism)}"))
        self._show_peaks()
        self._show_strips(wall)
        self._show_fragility()

    # fragility

    def _show_fragility(self) -> None:
        """Draw the curve of the wall, and dashed that of another."""
        result, wall = require_value(self.shown)
        self.fragility.clear()
        self.fragility.caption = title_of(wall)
        other = self.other.currentIndex() - 1
        drawn = self._fragility_of(wall, 0, False, "")
        if other >= 0:
            name = f", {title_of(result.walls[other])}"
            drawn = self._fragility_of(result.walls[other], 1, True, name) or drawn
            self.fragility.caption += name
        if not drawn:
            why = tr("No record with a q.")
            self.fragility.say_why(why)
            return
        self.fragility.set_range(y=(0.0, 1.05))

    def _fragility_of(self, wall: WallResult, color: int, dash: bool, name: str) -> bool:
        result = require_value(self.shown)[0]
        q, count, n = fragility_curve([run.ida for run in wall.runs], result.search)
        if not n:
            return False
        share = count / (n * (2 * result.search.half_window + 1))
        whole = slice(0, q.size - result.search.half_window)  # beyond it the window is not whole
        self.fragility.curve(tr("fragility") + name, q[whole], share[whole], color, 2.0, dash)
        for k, (label, value) in enumerate(
            (("q", wall.q_set), ("q SLV", wall.q_slv_set), (tr("q robust"), wall.q_robust_set))
        ):
            if value is not None and not dash:
                self.fragility.level(value, label, "ink", vertical=True, place=0.94 - 0.13 * k)
        return True

    # peaks

    def _show_peaks(self) -> None:
        """Peaks at the points of the search, integrated again: some ten milliseconds a record."""
        self.peaks.clear()
        if self.shown is None or self.record.currentIndex() < 0:
            return
        result, wall = require_value(self.shown)
        k = self.record.currentIndex()
        if k == len(wall.runs):
            self._overlay(result, wall)
        else:
            run = wall.runs[k]
            q, ratio = _peaks(result, wall, run)
            self.peaks.curve(run_name(run), q, ratio, 0)
            fell = q[np.isnan(ratio)]
            none = np.full(fell.size, np.nan)
            self.peaks.points(result_word("overturned"), fell, np.full(fell.size, OVERTURNED_AT), 1, 4, values=none)
            if run.ida.q:
                self.peaks.level(run.ida.q, "q", "bad", vertical=True, place=0.75)
            self.peaks.caption = f"{title_of(wall)}, {run_name(run)}"
        for level in (0.40, 0.60, 1.0):
            label = "θc" if level == 1.0 else number(level, ".2f")
            self.peaks.level(level, label)
        self.peaks.set_range(y=(0.0, 1.45))

    def _overlay(self, result: StudyResult, wall: WallResult) -> None:
        """All records, with mean and scatter as long as none has overturned."""
        curves = [_peaks(result, wall, run) for run in wall.runs]
        self.peaks.bundle([run_name(run) for run in wall.runs], curves)
        first = min((q[np.isnan(ratio)][0] if np.isnan(ratio).any() else q[-1]) for q, ratio in curves)
        low = max(q[0] for q, _ in curves)
        if first > low:
            grid = np.geomspace(low, 0.999 * first, 200)
            values = np.array([np.interp(grid, q, ratio) for q, ratio in curves])
            mean, scatter = values.mean(axis=0), values.std(axis=0)
            self.peaks.band(grid, np.maximum(mean - scatter, 0.0), mean + scatter, 0)
            name = tr("mean and standard deviation, until a record overturns")
            self.peaks.curve(name, grid, mean, 0, 2.4)
        self.peaks.caption = f"{title_of(wall)}, {tr('all records, with their mean')}"

    # survival map

    def _show_strips(self, wall: WallResult) -> None:
        self.strips.clear()
        if not wall.runs:
            self.strips.say_why(tr("No records."))
            return
        self.strips.caption = title_of(wall)
        first = min(run.ida.first_index for run in wall.runs)
        last = max(run.ida.first_index + len(run.ida.outcomes) for run in wall.runs)
        image = np.full((len(wall.runs), last - first), np.nan)
        for k, run in enumerate(wall.runs):
            start = run.ida.first_index - first
            image[k, start : start + len(run.ida.outcomes)] = [int(d) for d in run.ida.outcomes]
        step = math.log1p(require_value(self.shown)[0].search.q_step)
        low = math.log(wall.runs[0].ida.q_start) + first * step
        # what was not searched, or ended without an outcome, is neither: hatched, seen through the map
        shades = np.select([image == STABLE, image == COLLAPSED], [0.0, 1.0], 0.5)
        area = QRectF(low, -0.5, image.shape[1] * step, image.shape[0])
        hatched = Hatch(area)
        item = pg.ImageItem(np.ascontiguousarray(shades.T), levels=(0.0, 1.0))
        item.setRect(area)
        legend = [
            (tr("stands"), pg.ScatterPlotItem(symbol="s", size=11)),
            (result_word("overturned"), pg.ScatterPlotItem(symbol="s", size=11)),
            (tr("not searched"), pg.ScatterPlotItem(symbol=hatched_square(), size=11)),
        ]

        def recolor(chosen: theme.Theme, scale: float) -> None:
            back, fell = QColor(chosen.back), QColor(chosen.curves[1])
            clear = QColor(0, 0, 0, 0)
            item.setColorMap(pg.ColorMap([0.0, 0.5, 1.0], [back, clear, fell]))
            pen = pg.mkPen(chosen.quiet, width=scale)
            hatched.set_pen(pen)
            for (_, mark), brush in zip(legend, (back, fell, clear), strict=True):
                mark.setBrush(brush)
                mark.setPen(pen)

        self.strips.add(hatched)
        self.strips.add(item, recolor)
        self.strips.set_range((area.left(), area.right()), (area.top(), area.bottom()))
        for name, mark in legend:
            self.strips.entry(mark, name)
        grid = np.exp(low + step * np.arange(image.shape[1]))
        for k, run in enumerate(wall.runs):
            searched = ~np.isnan(image[k])
            self.strips.data.append((run_name(run), grid[searched], image[k][searched]))
        names = [(float(k), run_name(run)) for k, run in enumerate(wall.runs)]
        self.strips.names_beside(names)
        marks = [q for q in Q_TICKS if math.log(q) >= low - 0.1]
        self.strips.ticks("bottom", [(math.log(q), f"{number(q, 'g')}") for q in marks])
        self.strips.reset()


def _peaks(result: StudyResult, wall: WallResult, run: Run) -> tuple[np.ndarray, np.ndarray]:
    """(q, largest rotation over theta_c, NaN where it overturns) at the points of the search itself, so that the first
    that overturns is the one q was bisected from."""
    motion = result.motion_of(wall, run.motion)
    step, last = result.search.q_step, run.ida.first_index + len(run.ida.outcomes)
    q = np.array([grid_point(run.ida.q_start, step, k) for k in range(run.ida.first_index, last)])
    q = q[q <= 1.6 * (run.ida.q or 5.0)]
    outcomes, peaks = np.zeros(q.size, np.int64), np.zeros(q.size)
    scales = run.polarity * multiplier_of(q, motion.pga, threshold_of(wall.model))
    scan_multipliers(result.method, motion.acceleration, motion.time_step, scales, wall.model, outcomes, peaks)
    return q, np.where(outcomes == COLLAPSED, np.nan, peaks / wall.model.collapse_rotation)
