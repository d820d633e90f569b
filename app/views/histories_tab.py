"""The page Histories, which integrates under the hand: the rocking wall beside ground, rotation and energy."""

import math

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QSlider, QSplitter, QTabWidget, QVBoxLayout

from app.look.charting import pg
from app.look.labels import PlainLabel
from app.look.language import current_language, number, result_word, tr
from app.look.whole_text import tell_whole
from app.views.chart import Chart
from app.views.moving_walls import Film, MovingWalls
from app.views.result_tab import ResultTab
from app.views.runs import index_of, run_name, title_of
from core.answer.answer import run_shown_first
from core.capacity.ida import multiplier_of, threshold_of
from core.codes.dynamic_check import model_and_scale_at_demand
from core.known import require_value
from core.rocking.energy import energy_ratios
from core.rocking.history import History, integrate_history
from core.rocking.outcome import COLLAPSED
from core.study.bar_histories import BarHistory, bar_histories, work_of_impacts
from core.study.results import StudyResult, WallResult
from core.text.sentence import format_number
from core.units import G
from core.wall.rocking_model import RockingModel, weakened

SLIDER = 2000
REPEAT_PAUSE = 5.0
"""Rest between a motion and the same motion again [s]."""

GROUND_HEIGHT, AXIS = 200, 3.6
"""Height of the ground with its axis in a window of 800 [px], 120 of it the motion; width of all axes [lines]."""

MAX_RATIO_SHOWN, MIN_RATIO_SHOWN, ROTATION_AXIS_FACTOR, EMPTIED = 1.4, 0.01, 1.15, 0.4
"""Largest and smallest rotation over theta_c that the axis ends at, its room above the peak, and the share of it below
which a peak lets it shrink."""

AFTER_FALL, OTHER_FALL = 1.03, 0.1
"""Time shown of a motion over that of the fall, and by how much another fall differs for the axis to follow."""

SLIDER_RANGE = (0.5, 2.0)
"""Range of the multiplier slider about q [-]."""


class HistoriesTab(ResultTab):
    """theta/alpha under a multiplier that follows the slider, with the ground above it and a rocking wall."""

    def __init__(self):
        super().__init__()
        self.record = QComboBox()
        self.record.setAccessibleName(tr("Record"))
        self.record.activated.connect(lambda _: self._chosen())
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, SLIDER)
        self.slider.setAccessibleName(tr("Multiplier of the record"))
        self.slider.valueChanged.connect(lambda _: self._slid())
        self.preset = QComboBox()
        self.preset.setAccessibleName(tr("Multiplier at once"))
        self.preset.addItems(
            [
                tr("Set to…"),
                tr("the demand"),
                tr("the demand with FC"),
                tr("just before collapse"),
                tr("just after collapse"),
                "q = 2",
            ]
        )
        self.preset.activated.connect(self._set_to)
        self.chosen_q: float | None = None
        self.strength_factor = 1.0
        self.words = PlainLabel()
        self.words.setMinimumWidth(120)
        self.words.setToolTip(
            tr(
                "C multiplies the record as it is given; "
                "q is its peak then over the acceleration at which the wall moves."
            )
        )
        self.ground = Chart("t [s]", "u'' [g]", tr("Ground motion"))
        self.rotation = Chart("t [s]", "θ/θc [-]", tr("Rotation"))
        self.rotation.plot.setXLink(self.ground.plot)
        self.force = Chart("t [s]", "F [kN/m]", tr("Force of the ties"))
        self.elongation = Chart("t [s]", "u [mm]", tr("Elongation of the ties"))
        self.again = QCheckBox(tr("the same motion again"))
        self.again.setToolTip(tr("After five seconds at rest: a second motion meets the ties as the first left them."))
        self.again.toggled.connect(lambda _: self._chosen())
        self.energy = Chart("t [s]", "E/E(θc) [-]", tr("Energy"))
        self.energy.plot.setXLink(self.ground.plot)
        self.walls = MovingWalls()
        self.walls.asked.connect(self.set_time)
        self.other = self.walls.other
        self.other.activated.connect(lambda _: self.integrate())
        for box in (self.record, self.preset):
            tell_whole(box)
        self._lay_out()
        self.shown: tuple[StudyResult, WallResult] | None = None
        self.history: History | None = None
        self.second: History | None = None
        self.model: RockingModel
        self.cursors: list[pg.InfiniteLine] = []

    def _lay_out(self) -> None:
        """The walls beside the panels, what is chosen above them."""
        bar = QHBoxLayout()
        self.record.setMinimumWidth(60)
        bar.addWidget(self.record, 1)
        bar.addWidget(self.slider, 2)
        bar.addWidget(self.preset)
        bar.addWidget(self.again)
        charts = QSplitter(Qt.Orientation.Vertical)
        self.below = QTabWidget()
        self.below.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # its bar has the focus, where it is shown
        for chart in (self.energy, self.force, self.elongation):
            self.below.addTab(chart, chart.name)
        for part in (self.ground, self.rotation, self.below):
            charts.addWidget(part)
        charts.setSizes([GROUND_HEIGHT, 260, 200])
        for chart in (self.ground, self.rotation, self.energy):  # a time stands at one place in all of them
            chart.plot.getAxis("left").setWidth(round(AXIS * self.fontMetrics().height()))
        row = QSplitter(Qt.Orientation.Horizontal)
        row.addWidget(self.walls)
        row.addWidget(charts)
        row.setSizes([320, 720])
        row.setStretchFactor(0, 3)
        row.setStretchFactor(1, 7)
        layout = QVBoxLayout(self)
        layout.addLayout(bar)
        self.words.setWordWrap(True)
        layout.addWidget(self.words)
        layout.addWidget(row, 1)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from one wall of a result."""
        self.walls.show_wall(wall)
        self.shown, self.history, self.cursors = (result, wall), None, []
        self.model = wall.model
        self.again.setVisible(bool(wall.model.bars))
        self.below.tabBar().setVisible(bool(wall.model.bars))
        self.below.setCurrentIndex(1 if wall.model.bars else 0)
        if not wall.model.bars:
            with QSignalBlocker(self.again):
                self.again.setChecked(False)
        self.record.clear()
        self.other.clear()
        self.other.addItem(tr("no second record"))
        for run in wall.runs:
            for box in (self.record, self.other):
                box.addItem(run_name(run))
        self.record.setCurrentIndex(run_shown_first(wall) if wall.runs else -1)
        self._begin()

    def show_run(self, run: tuple[int, int]) -> None:
        """The history of this (motion, polarity)."""
        k = index_of(self.shown[1], *run) if self.shown else None
        if k is not None:
            self.record.setCurrentIndex(k)
            self._begin()

    def _begin(self) -> None:
        """A record at the demand as the dynamic check has it; without a demand at the last survived multiplier."""
        self._chosen()
        if self.shown is not None and self.shown[0].demand is not None and self.run is not None:
            self._set_to(2)

    @property
    def run(self):
        k = self.record.currentIndex()
        return self.shown[1].runs[k] if self.shown and k >= 0 else None

    def _chosen(self) -> None:
        """A record: its ground motion, and charts whose curves are then only given new data."""
        self.ground.clear()
        self.rotation.clear()
        if self.shown is None or self.record.currentIndex() < 0:
            for chart in (self.energy, self.force, self.elongation):
                chart.clear()
            self.words.setText(tr("No histories are made of this wall.") if self.shown else "")
            return
        result, wall = require_value(self.shown)
        self.motion = result.motion_of(wall, self.run.motion)
        self.acceleration = self.motion.acceleration
        if self.again.isChecked():
            rest = np.zeros(round(REPEAT_PAUSE / self.motion.time_step))
            self.acceleration = np.concatenate([self.acceleration, rest, self.acceleration])
        self.times = np.arange(self.acceleration.size) * self.motion.time_step
        name, self.ground.name = tr("ground"), tr("Ground motion")
        if wall.floor:
            name, self.ground.name = tr("floor"), tr("Motion of the floor")
        self.ground_name = name  # no legend, which would take a third of its height: it stands at the axis
        self.ground_curve = self.ground.curve(name, self.times, self.acceleration / G, 6, 1.4, legend=False)
        self.ground.level(0.0)
        self.curve = self.rotation.curve("θ/θc", [0.0, 1.0], [0.0, 0.0], 0, 1.8)
        self.marks = self.rotation.points(tr("impacts"), [], [], 1, 5)
        both_ways = wall.model.one_sided == 0.0
        for level in (-1.0, 1.0) if both_ways else (1.0,):
            self.rotation.level(level, "θc" if level > 0 else "−θc", "bad")
        self.energy.clear()
        self.energy_curve = self.energy.curve(tr("energy"), [0.0, 1.0], [0.0, 0.0], 2, 1.4, legend=False)
        self.energy.level(1.0, "", "bad")
        self.second_curve = self.rotation.curve(tr("second record"), [0.0, 1.0], [0.0, 0.0], 4, 1.2, legend=False)
        panels = (self.ground, self.rotation, self.energy)
        self.cursors = [chart.level(0.0, "", "ink", vertical=True) for chart in panels]
        for line in self.cursors:
            line.setMovable(True)
            line.sigDragged.connect(lambda line: self.set_time(line.value()))
        self.below_rest = -1.0 if both_ways else -0.14
        self.rotation.set_range((0.0, float(self.times[-1])), (self.below_rest * MAX_RATIO_SHOWN, MAX_RATIO_SHOWN))
        self.energy.set_range((0.0, float(self.times[-1])), (0.0, 1.3))
        self._show_until(float(self.times[-1]))
        self._set_q(self.middle)

    def _show_until(self, end: float) -> None:
        """The times of all panels, to this one [s]."""
        self.until = end
        for chart in (self.rotation, self.energy):
            chart.ranges["x"] = (0.0, end)
        # last: linked charts move each other by what their axes take of the width
        self.ground.set_range((0.0, end))

    def _follow_fall(self) -> None:
        """Where the wall overturns what comes after is not shown."""
        end = float(self.times[-1])
        shown = [(require_value(self.history), self.motion.time_step)]
        shown += [(self.second, self.second_step)] if self.second is not None else []
        if all(one.outcome == COLLAPSED for one, _ in shown):
            end = min(end, AFTER_FALL * max((one.rotation.size - 1) * step for one, step in shown))
        if end > self.until or end < (1.0 - OTHER_FALL) * self.until:
            self._show_until(end)

    def _follow_peak(self) -> None:
        """The axis of rotations ends above the peak: it grows with it, and shrinks only where much of it is empty."""
        shown = [float(np.abs(ratio).max(initial=0.0)) for _, _, ratio in self.rotation.data]
        end = min(max(ROTATION_AXIS_FACTOR * max(shown), MIN_RATIO_SHOWN), MAX_RATIO_SHOWN)
        if not EMPTIED * self.rotation.ranges["y"][1] <= end <= self.rotation.ranges["y"][1]:
            self.rotation.ranges["y"] = (self.below_rest * end, end)
            self.rotation.plot.setYRange(*self.rotation.ranges["y"], padding=0.0)  # times are shared, and stay

    @property
    def middle(self) -> float:
        """q in the middle of the slider: the last survived one."""
        return (self.run.ida.bracket or (2.0, 2.0))[0]

    @property
    def q(self) -> float:
        if self.chosen_q is not None:
            return self.chosen_q
        low, high = (math.log(end) for end in SLIDER_RANGE)
        return self.middle * math.exp(low + (high - low) * self.slider.value() / SLIDER)

    def _slid(self) -> None:
        self.chosen_q, self.strength_factor = None, 1.0
        self.integrate()

    def _set_q(self, q: float, strength_factor: float = 1.0) -> None:
        """This q exactly, the slider as near to it as it goes. strength_factor : FC on the strength of the wall"""
        self.strength_factor = strength_factor
        low, high = (math.log(end) for end in SLIDER_RANGE)
        at = (math.log(q / self.middle) - low) / (high - low)
        self.slider.blockSignals(True)
        self.slider.setValue(round(SLIDER * min(1.0, max(0.0, at))))
        self.slider.blockSignals(False)
        self.chosen_q = q
        self.integrate()

    def _set_to(self, k: int) -> None:
        """A multiplier that an engineer asks for by name."""
        self.preset.setCurrentIndex(0)
        if self.run is None:
            return
        result, wall = require_value(self.shown)
        demand, bracket = result.demand, self.run.ida.bracket
        if (k in (1, 2) and demand is None) or (k in (3, 4) and bracket is None):
            self.words.setText(tr("Not known here: no demand, or no collapse of this record."))
            return
        # the check at the demand has the elastic branch, or the hinge, that fares worst; q is searched without
        strength_factor, self.model = 1.0, wall.governing_model if k in (1, 2) else wall.model
        if k == 1:
            q = require_value(demand).scaling(self.motion) * self.motion.pga / threshold_of(wall.model)
        elif k == 2:  # as the dynamic check has it
            demand = require_value(demand)
            model, factor = model_and_scale_at_demand(self.model, demand, demand.confidence_on, self.motion)
            strength_factor = self.model.p2 / model.p2
            q = factor / strength_factor * self.motion.pga / threshold_of(wall.model)
        else:
            q = {3: bracket and bracket[0], 4: bracket and bracket[1], 5: 2.0}.get(k)
        if q:
            self._set_q(q, strength_factor)

    def integrate(self) -> None:
        """The history at the slider's multiplier: a fraction of a millisecond, then drawn."""
        if self.run is None:
            return
        result, wall = require_value(self.shown)
        scale = self.run.polarity * multiplier_of(self.q, self.motion.pga, threshold_of(wall.model))
        ground, dt = self.acceleration, self.motion.time_step
        # strength over FC is p^2 / FC under the ground times FC (core/codes/dynamic_check.py)
        model = weakened(self.model, self.strength_factor)
        self.history = integrate_history(ground, dt, self.strength_factor * scale, model, result.method)
        ratio = self.history.rotation / model.collapse_rotation
        self.curve.setData(self.times[: ratio.size], ratio)
        felt = scale * ground / G  # multiplier and sign in use
        self.ground_curve.setData(self.times, felt)
        peak = 1.05 * float(np.abs(felt).max())
        self.ground.ranges["y"] = (-peak, peak)
        self.ground.plot.setYRange(-peak, peak, padding=0.0)
        self.ground.data = [(self.ground_name, self.times, felt)]
        hits = self.history.impact_time[:2000]
        self.marks.setData(hits, np.zeros(hits.size))
        self.rotation.data = [
            ("θ/θc", self.times[: ratio.size], ratio),
            (tr("impacts"), self.history.impact_time, np.zeros(self.history.impact_time.size)),
        ]
        energy = energy_ratios(self.history, model)
        self.energy_curve.setData(self.times[: energy.size], np.minimum(energy, 9.0))
        self.energy.data = [(tr("energy"), self.times[: energy.size], energy)]
        self._integrate_second(model)
        self._follow_fall()
        self._follow_peak()
        if self.history.outcome == COLLAPSED:  # its largest rotation is where the analysis ended
            outcome = result_word("overturned")
        else:
            peak = format_number(self.history.peak / model.collapse_rotation, ".2f", current_language())
            outcome = f"{tr('stands')}   θmax/θc {peak}"
        which = self._wall_in_words()
        wall_and_c = (title_of(wall), f"C {number(abs(scale), '.3f')}")
        bars = bar_histories(wall.wall, self.history, self.strength_factor) if wall.model.bars else []
        words = (*wall_and_c, f"q {number(self.q, '.3f')}", outcome, *which, *self._show_bars(bars))
        self.words.setText("   ".join(words))
        for chart in (self.ground, self.rotation, self.energy, self.force, self.elongation):
            chart.caption = ", ".join((wall_and_c[0], run_name(self.run), wall_and_c[1], *which))
        films = [Film(self.history.rotation, self.motion.time_step)]
        self.walls.take(films + ([Film(self.second.rotation, self.second_step)] if self.second else []), bars)
        self.set_time(self.cursors[0].value())

    def _integrate_second(self, model) -> None:
        """Integrate the wall under another record, at the same multiple of it. model : FC on the strength included"""
        result, wall = require_value(self.shown)
        k = self.other.currentIndex() - 1
        self.second = None
        self.second_curve.setVisible(k >= 0)
        if k < 0:
            return
        run, motion = wall.runs[k], result.motion_of(wall, wall.runs[k].motion)
        factor = multiplier_of(self.q, self.motion.pga, threshold_of(wall.model)) * self.strength_factor
        self.second = integrate_history(
            motion.acceleration, motion.time_step, run.polarity * factor, model, result.method
        )
        self.second_step = motion.time_step
        ratio = self.second.rotation / model.collapse_rotation
        times = np.arange(ratio.size) * motion.time_step
        self.second_curve.setData(times, ratio)
        self.rotation.data.append((tr("second record"), times, ratio))

    def _show_bars(self, bars: list[BarHistory]) -> tuple[str, ...]:
        """Force and elongation of each tie, and what they and the impacts took."""
        history_now, (_, wall) = require_value(self.history), require_value(self.shown)
        if not bars:
            return ()
        self.force.clear()
        self.elongation.clear()
        times = self.times[: history_now.rotation.size]
        for k, one in enumerate(bars):
            name = f"h {number(one.bar.height, '.2f')} m"
            self.force.curve(name, times, 1e-3 * one.force, k, 1.4)
            self.elongation.curve(f"u, {name}", times, 1e3 * one.elongation, k, 1.4)
            self.elongation.curve(f"u_p, {name}", times, 1e3 * one.residual, k + 3, 1.0)
        for chart in (self.force, self.elongation):
            chart.reset()
            chart.set_range((0.0, float(self.times[-1])))
            self.cursors.append(chart.level(0.0, "", "ink", vertical=True))
        del self.cursors[3:-2]
        lost = work_of_impacts(wall.wall, wall.model, history_now)
        words = [tr("ties took {work} kJ/m", work=number(1e-3 * sum(bar.work for bar in bars), ".2f"))]
        if lost is not None:
            words.append(tr("impacts {work} kJ/m", work=number(1e-3 * lost, ".2f")))
        return tuple(words)

    def _wall_in_words(self) -> tuple[str, ...]:
        """Strength and multiplier of what is drawn: FC on the strength or not, and how many times the demand."""
        result, wall = require_value(self.shown)
        if self.strength_factor == 1.0:
            words = [tr("strength as it is, without FC")]
        else:
            words = [f"{result_word('confidence_capacity')}: {number(self.strength_factor, '.2f')}"]
        if self.model != wall.model:
            words.append(tr("elastic branch or hinge of the check"))
        if result.demand is not None:
            factor = multiplier_of(self.q, self.motion.pga, threshold_of(wall.model))
            words.append(
                tr("{times} times the demand", times=number(factor / result.demand.scaling(self.motion), ".2f"))
            )
        return tuple(words)

    def set_time(self, time: float) -> None:
        """All cursors and the walls at this time [s]."""
        for line in self.cursors:
            line.setValue(time)
        self.walls.show_time(time)
