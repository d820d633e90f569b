"""Tabs of a result: q against SI, Spectra."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QSplitter, QVBoxLayout, QWidget

from app.look.charting import pg
from app.look.labels import PlainLabel
from app.look.language import number, tr
from app.views.chart import Chart
from app.views.result_tab import ResultTab
from app.views.runs import title_of
from app.views.table import Table
from app.views.zeta_rungs import digits
from core.capacity.closed_forms import closed_form_q_eff
from core.capacity.scale_free_law import law_of, loss_ratio, within
from core.ground.response_spectrum import HOUSNER_PERIODS, pseudo_acceleration_spectrum
from core.report.record_tables import rules_of_codes
from core.report.words import Words
from core.setting.floors import CHART_PERIODS
from core.study.results import StudyResult, WallResult
from core.units import CM, G

DRAWN_PERIODS = np.linspace(0.0, 4.0, 401)
"""At which a target is drawn [s]."""


class IntensityTab(ResultTab):
    """q_eff against SI: points, power law, Eq. 15/16 with a band of 20 %."""

    def __init__(self):
        super().__init__()
        self.shown: tuple[StudyResult, WallResult] | None = None
        self.log = QCheckBox(tr("Logarithmic axes"))
        self.log.toggled.connect(lambda on: self.show_wall(*self.shown) if self.shown else None)
        self.chart = Chart("SI [cm]", "q_eff [-]", tr("q against SI"))
        self.scale_free = Chart("Λ [-]", "q [-]", tr("q against Λ"))
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        layout = QVBoxLayout(self)
        row = QHBoxLayout()
        row.addWidget(self.log)
        row.addWidget(self.words, 1)
        layout.addLayout(row)
        charts = QHBoxLayout()
        charts.addWidget(self.chart, 1)
        charts.addWidget(self.scale_free, 1)
        layout.addLayout(charts, 1)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from one wall of a result."""
        self.shown = (result, wall)
        self.chart.clear()
        self.scale_free.clear()
        self.chart.set_log(self.log.isChecked())
        known = [entry for entry in wall.per_record if entry.q is not None]
        why = ""
        if not known:
            why = tr("No record with a q.")
        elif not wall.wall.has_closed_forms:
            why = tr("Not drawn above the ground and with loads, where Eq. 15 and 16 do not hold.")
        for chart in (self.chart, self.scale_free):
            chart.caption = title_of(wall)
            chart.say_why(why)
        self.words.setText("")
        if why:
            return
        si = np.array([entry.intensity for entry in known])
        self.chart.points(tr("time histories"), si / CM, [entry.q_eff for entry in known], 0, 9)
        x = np.geomspace(0.7 * si.min(), 1.4 * si.max(), 60)
        one_sided = wall.kinematics.one_way
        form = "Eq. 16" if one_sided else "Eq. 15"
        y = np.array([closed_form_q_eff(wall.block.slenderness, wall.block.height, v, one_sided) for v in x])
        if not self.log.isChecked():
            self.chart.band(x / CM, 0.8 * y, 1.2 * y, 1)
        self.chart.curve(form, x / CM, y, 1, 2.0)
        law = wall.power_law
        text = tr(
            "set: q {q}, robust {robust}; q SLV {slv}, robust {slv_robust}",
            q=digits(wall.q_set),
            robust=digits(wall.q_robust_set),
            slv=digits(wall.q_slv_set),
            slv_robust=digits(wall.q_slv_robust_set),
        )
        if law:
            inside = np.geomspace(si.min(), si.max(), 60)  # where the records are, no further
            fit = [law.q_eff(v) for v in inside]
            self.chart.curve("C1 SI^C2", inside / CM, fit, 0, 1.6, dash=True)
            text += f"   C1 {number(law.c1, '.3g')}, C2 {number(law.c2, '.2f')}, R² {number(law.r_squared, '.2f')}"
        self.words.setText(text)
        self._show_law(wall, known)
        self.chart.reset()

    def _show_law(self, wall: WallResult, known: list) -> None:
        """Ribalta's law: at each record in the chart of SI; in that of Lambda as a curve with the interval of the mean
        of a set as a band, and the ends of that of one natural record."""
        self.scale_free.clear()
        self.scale_free.set_log(self.log.isChecked())
        block = wall.block
        known = [entry for entry in known if entry.scaled is not None]
        scaled = np.array([entry.scaled for entry in known])
        self.scale_free.points(tr("time histories"), scaled, [entry.q for entry in known], 0, 9)
        law = law_of(wall.kinematics.one_way, wall.law, "q")
        if law is not None:
            ratio = loss_ratio(block, wall.restitution)
            pga = np.array([entry.pga for entry in known])
            si = np.array([entry.intensity for entry in known])
            name = tr("Ribalta's law (research)")
            own = np.array([within(law, wall.mechanism, block.p2, one, ratio) for one in scaled])
            if not own.any():  # nothing of it is drawn where it does not hold
                self.scale_free.reset()
                return
            self.chart.points(name, si[own] / CM, law.q(scaled[own], ratio) * G / pga[own], 2, 8, symbol="d")
            low, high = law.scaled_range
            x = np.geomspace(max(0.7 * scaled[own].min(), low), min(1.4 * scaled[own].max(), high), 60)
            y = law.q(x, ratio)
            low, high = np.array([law.interval(one, ratio) for one in x]).T
            if not self.log.isChecked():
                self.scale_free.band(x, low, high, 2)
            self.scale_free.curve(f"{name}, {tr('band: of the mean of a set')}", x, y, 2, 2.0)
            of_one = [values for one in x if (values := law.record_values(one, ratio)) is not None]
            if of_one:
                ends = np.array(of_one)
                of_records = tr("nine natural records of ten")
                self.scale_free.curve(of_records, x, ends[:, 0], 2, 1.2, dash=True)
                self.scale_free.curve(of_records, x, ends[:, 2], 2, 1.2, dash=True, legend=False)
        self.scale_free.reset()


class SpectraTab(QWidget):
    """5 % acceleration spectra of the records, their mean, the target; the band of SI shaded. Above the ground beside
    them the floor spectrum of the code and the mean of the floor motions, at the damping of the mechanism."""

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.chart = Chart("T [s]", "S_a [g]", tr("Spectra"), live=True)
        self.table = Table(tr("Compatibility"), [])
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        self.floor = Chart("T [s]", "S_a [g]", tr("Floor spectra"))
        charts = QSplitter(Qt.Orientation.Horizontal)
        charts.addWidget(self.chart)
        charts.addWidget(self.floor)
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(charts)
        split.addWidget(self.table)
        split.setSizes([420, 180])
        layout = QVBoxLayout(self)
        layout.addWidget(self.words)
        layout.addWidget(split, 1)
        self.known: dict[str, np.ndarray] = {}
        self.drawn: tuple | None = None
        self.of = -1
        self.rules_shown = self.floor_shown = None
        self._show_floor(None)
        self._show_rules(None)

    def _show_floor(self, floor) -> None:
        """The consistency of the code with the records at the floor."""
        self.floor.clear()
        self.floor.setVisible(floor is not None)
        if floor is None:
            return
        self.floor.caption = tr("motion of the floor at {z} m", z=number(floor.z, "g"))
        if floor.spectrum is not None:
            name = tr("code, z {z:g} m, ξ {damping:.0f} %", z=floor.z, damping=100.0 * floor.damping)
            self.floor.curve(name, CHART_PERIODS, floor.code_spectrum / G, 1, 2.4)
        if floor.motions:
            self.floor.curve(tr("mean of the floors"), CHART_PERIODS, floor.mean_spectrum / G, 0, 2.4)
        self.floor.reset()

    def show_records(self, motions, target, rules, floor=None, of: int = -1) -> None:
        """motions : as loaded
        target : of the demand or None
        rules : Compliance or None
        floor : Floor of a wall above the ground
        of : index of the wall shown; another one shows the curves whole
        """
        wanted = target and (target.name, target.acceleration(DRAWN_PERIODS).tobytes())
        drawn = [(motion.name, motion.samples_sha256) for motion in motions], wanted
        if floor is not self.floor_shown:
            self._show_floor(floor)
            self.floor_shown = floor
        if drawn != self.drawn:  # else a key typed costs the curves of all records
            self.drawn = drawn
            self._show_spectra(motions, target)
        elif of != self.of:
            self.chart.reset()
        self.of = of
        if rules is not self.rules_shown:
            self._show_rules(rules)
            self.rules_shown = rules

    def _show_spectra(self, motions, target) -> None:
        """Draw the spectra of the records, their mean, the target."""
        self.chart.clear()
        spectra = []
        for motion in motions:
            key = motion.samples_sha256
            if key not in self.known:
                self.known[key] = pseudo_acceleration_spectrum(motion.acceleration, motion.time_step, HOUSNER_PERIODS)
            spectra.append(self.known[key] / G)
        region = pg.LinearRegionItem((0.1, 2.5), movable=False, brush=pg.mkBrush(128, 128, 128, 18))
        self.chart.add(region)
        self.chart.bundle([motion.name for motion in motions], [(HOUSNER_PERIODS, values) for values in spectra])
        if spectra:
            self.chart.curve(tr("mean of the records"), HOUSNER_PERIODS, np.mean(spectra, axis=0), 0, 2.4)
        if target is not None:
            self.chart.curve(
                tr("target: {name}", name=target.name), DRAWN_PERIODS, target.acceleration(DRAWN_PERIODS) / G, 1, 2.4
            )
        self.words.setText(tr("SI is the area under the pseudo-velocity from 0.1 to 2.5 s (shaded)."))
        self.chart.reset()

    def _show_rules(self, rules) -> None:
        rows = rules.rules if rules else ()
        self.table.show_table(rules_of_codes(Words(self.language)), rows)
        self.table.setVisible(bool(rows))
