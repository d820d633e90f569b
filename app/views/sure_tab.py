"""The tab How sure: each input moved on its own, another sample of records, the rates of the limit states."""

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QSplitter, QVBoxLayout

from app.look import theme
from app.look.labels import PlainLabel
from app.look.language import number, tr
from app.views.chart import Chart
from app.views.result_tab import ResultTab
from app.views.table import Table
from core.known import require_value
from core.report import uncertainty_text
from core.study.results import StudyResult, WallResult
from core.text.sentence import localized
from core.variation.swings import Sensitivity


class SureTab(ResultTab):
    """What stands beside the verdict of a wall, never part of it.

    asked(what) : sensitivity, where the inputs are to be moved
    """

    asked = Signal(str)

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.button = QPushButton(tr("Move each input"))
        self.button.setToolTip(tr("Adds [sensitivity] to the case and runs it: a second a wall, with ties some ten"))
        self.button.clicked.connect(lambda: self.asked.emit("sensitivity"))
        self.chart = Chart("ζ_E", "", tr("ζ_E with each input moved on its own"))
        heads = [tr("Input value"), tr("moved to"), "ζ_E", tr("moved to"), "ζ_E"]
        self.moves = Table(tr("Inputs moved"), heads)
        self.reach = Table(tr("For the ζ required"), [tr("For the ζ required"), tr("now"), "", "", "", ""])
        self.rates = Table(tr("Rates of the limit states"), uncertainty_text.rate_heads(self._say, None))
        tables = QSplitter(Qt.Orientation.Vertical)
        for table in (self.moves, self.reach, self.rates):
            tables.addWidget(table)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.chart)
        split.addWidget(tables)
        split.setSizes([400, 600])
        head = QHBoxLayout()
        head.addWidget(self.words, 1)
        head.addWidget(self.button, 0, Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self)
        layout.addLayout(head)
        layout.addWidget(split, 1)

    @property
    def _say(self) -> Callable[..., str]:
        return lambda english, **values: localized("report", english, self.language, **values)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from the verdict of the wall a result is of."""
        self.chart.clear()
        verdict = next((one for one in result.verdicts if result.walls.index(wall) in one.results), None)
        sensitivity = verdict.sensitivity if verdict else None
        self.button.setVisible(verdict is not None and sensitivity is None)
        self.chart.caption = verdict.title if verdict else wall.name
        lines = []
        if verdict:
            lines.append(uncertainty_text.interval_line(self._say, verdict, self.language))
            lines += (
                uncertainty_text.sensitivity_remarks(self._say, result, verdict, self.language) if sensitivity else []
            )
            lines += uncertainty_text.rate_lines(self._say, result, verdict.rates)
            if not verdict.rates and result.demand and not result.demand.hazard:
                lines.append(tr("The rates need the hazard of the site: give the place, or the rows of the hazard."))
        none = tr("No interval: too few stations, or no histories.")
        empty = none if verdict else tr("No demand: nothing to be sure of.")
        self.words.setText("\n".join(line for line in lines if line) or empty)
        self._show_moves(sensitivity, result)
        self._show_reach(sensitivity, result)
        self.rates.setVisible(bool(verdict and verdict.rates))
        self.rates.show_rows(
            [uncertainty_text.rate_row(self._say, rate, self.language) for rate in (verdict.rates if verdict else ())]
        )

    def _show_moves(self, sensitivity: Sensitivity | None, result: StudyResult) -> None:
        """The chart, the widest on top, and its numbers."""
        self.moves.setVisible(bool(sensitivity and sensitivity.swings))
        if not sensitivity or not sensitivity.swings:
            why = tr("No input moves ζ.") if sensitivity else tr("Press “Move each input”: ζ with each input moved.")
            self.chart.say_why(why)
            self.moves.show_rows([])
            return
        base, bad = sensitivity.base or 0.0, theme.current.bad
        count = len(sensitivity.swings)
        lines, below, above = [], [], []
        for k, swing in enumerate(sensitivity.swings):
            at = float(count - 1 - k)
            zetas = [0.0 if end.zeta is None else end.zeta for end in swing.ends]
            below += [(min(base, *zetas), at), (base, at), (np.nan, np.nan)]
            above += [(base, at), (max(base, *zetas), at), (np.nan, np.nan)]
            lines.append((at, uncertainty_text.swing_name(swing, self.language)))
        for name, points, color in ((tr("lower"), below, "bad"), (tr("higher"), above, 0)):
            x, y = zip(*points, strict=True)
            self.chart.curve(name, x, y, color, 9.0, path=True)
        self.chart.level(base, f"ζ_E {number(base, '.2f')}", "ink", vertical=True, place=0.97)
        target = require_value(result.demand).zeta_target
        self.chart.level(target, tr("required {zeta}", zeta=number(target, ".2f")), "amber", vertical=True, place=0.03)
        self.chart.names_beside(lines[::-1])
        drawn = [base, target, *(x for x, _ in below + above if not np.isnan(x))]
        room = 0.05 * (max(drawn) - min(drawn)) or 0.1
        self.chart.reset()
        self.chart.set_range(x=(min(drawn) - room, max(drawn) + room))  # ζ required in sight
        rows, colors = [], []
        for row in uncertainty_text.moved_rows(sensitivity, self.language):
            ends = [part for said, zeta, _ in row.ends for part in (said, number(zeta, ".2f"))]
            marks = [mark for _, _, sure in row.ends for mark in (None, None if sure else bad)]
            rows.append([row.name, *ends, *[""] * (4 - len(ends))])
            colors.append([None, *marks, *[None] * (4 - len(marks))])
        self.moves.show_rows(rows, colors)

    def _show_reach(self, sensitivity: Sensitivity | None, result: StudyResult) -> None:
        """What the zeta required asks of thickness, ties and a_g, by every check."""
        labels = uncertainty_text.reach_labels(sensitivity) if sensitivity else []
        self.reach.setVisible(bool(labels))
        if sensitivity is None or not labels:
            return
        heads = [tr("For the ζ required"), tr("now"), *uncertainty_text.check_names(result, labels, self.language)]
        self.reach.setColumnCount(len(heads))
        self.reach.setHorizontalHeaderLabels(heads)
        self.reach.show_rows(
            [uncertainty_text.reach_row(self._say, one, labels, self.language) for one in sensitivity.reach]
        )
