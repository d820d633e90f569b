"""The tab Validation: how sure the numbers of a wall are."""

import math

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout

from app.look.labels import PlainLabel
from app.look.language import number, result_word, tr
from app.views.chart import Chart
from app.views.result_tab import ResultTab
from app.views.runs import title_of
from core.study.results import StudyResult, WallResult


class ValidationTab(ResultTab):
    """Accuracy of the methods on the governing history, phase portrait, moment against rotation.

    asked() : the user wants the accuracy statement of the wall shown.
    """

    asked = Signal()

    def __init__(self):
        super().__init__()
        self.button = QPushButton(tr("State the accuracy for this wall (some seconds)"))
        self.button.clicked.connect(self.asked)
        self.words = PlainLabel(
            tr("What the solver leaves, and the spread of q by definition, for this wall and its governing record.")
        )
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.chart = Chart(
            tr("time per history [ms]"), tr("error / α [-]"), tr("Accuracy against speed"), legend="beside"
        )
        self.chart.set_log(True)
        self.phase = Chart("θ/θc [-]", "θ'/(p θc) [-]", tr("Phase portrait"))
        self.moment = Chart("θ/θc [-]", "M/M₀ [-]", tr("Moment against rotation"))
        lower = QHBoxLayout()
        lower.addWidget(self.phase, 1)
        lower.addWidget(self.moment, 1)
        layout = QVBoxLayout(self)
        layout.addWidget(self.button)
        layout.addWidget(self.words)
        layout.addWidget(self.chart, 1)
        layout.addLayout(lower, 1)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from one wall of a result."""
        from core.study.governing import collapse_histories
        from core.wall.moment_rotation import moment

        self.phase.clear()
        self.moment.clear()
        self.show_accuracy(wall.accuracy)
        alpha = wall.model.collapse_rotation
        ratio = np.linspace(0.0, 1.2, 121)
        law = np.array([moment(x * alpha, wall.model) for x in ratio])
        law = law / (wall.model.amplitude * math.sin(alpha))
        self.moment.curve(tr("law"), ratio, law, 0, 2.0)
        self.moment.reset()
        for chart in (self.chart, self.phase, self.moment):
            chart.caption = title_of(wall)
        pair = collapse_histories(result, wall)
        if pair is None:
            self.phase.say_why(tr("No record with a q."))
            return
        speed = wall.block.frequency_parameter * alpha
        for one, name, color in zip(pair.histories, (tr("survives"), result_word("overturned")), (0, 1), strict=True):
            inside = np.abs(one.rotation) < 1.5 * alpha
            self.phase.curve(name, one.rotation[inside] / alpha, one.velocity[inside] / speed, color, 1.0, path=True)
        self.phase.reset()

    def show_accuracy(self, accuracy) -> None:
        """The chart and the two statements; nothing before they are asked for."""
        self.chart.clear()
        if accuracy is None:
            self.chart.say_why(tr("Not stated yet for this wall: press the button above."))
            return
        for k, point in enumerate(accuracy.points):
            if point.error is not None:
                name = f"{point.name}: {point.error:.0e}"
                mark = "ost"[k // 7]  # colours come again after seven
                self.chart.points(name, [1e3 * point.seconds], [max(point.error, 1e-16)], k, 11, symbol=mark)
        self.chart.reset()
        self.chart.say_why("" if accuracy.points else tr("No other method follows this wall."))

        def share(value: float | None) -> str:
            return "–" if value is None else f"{number(100 * value, '.2g' if value < 0.995 else '.0f')} %"

        def power(value: float | None) -> str:
            return "–" if value is None else f"{value:.0e}"

        self.words.setText(
            "\n".join(
                (
                    tr(
                        "Solver ({method}): no other follows this wall; bound of its error {bound} θc ({record}).",
                        method=accuracy.method,
                        bound=power(accuracy.history_bound),
                        record=accuracy.record,
                    )
                    if not accuracy.points
                    else tr(
                        "Solver ({method}): differs from another in q by {q}, in the history by {history} θc; bound of "
                        "its error {bound} θc ({record}).",
                        method=accuracy.method,
                        q=share(accuracy.solver_q_difference),
                        history=power(accuracy.history_difference),
                        bound=power(accuracy.history_bound),
                        record=accuracy.record,
                    ),
                    tr(
                        "Definition: by the step of the search q spreads {q}, q robust {robust}, q SLV robust {slv}; "
                        "by rounding the record to five figures {rounded}, {rounded_robust}, {rounded_slv}.",
                        q=share(accuracy.spread(1, accuracy.steps)),
                        robust=share(accuracy.spread(2, accuracy.steps)),
                        rounded=share(accuracy.spread(0, accuracy.rounded)),
                        rounded_robust=share(accuracy.spread(1, accuracy.rounded)),
                        slv=share(accuracy.spread(3, accuracy.steps)),
                        rounded_slv=share(accuracy.spread(2, accuracy.rounded)),
                    ),
                )
            )
        )
