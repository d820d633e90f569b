"""The tab Check: the table of methods, the peaks at the demand, the verdict."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QSplitter, QVBoxLayout, QWidget

from app.look import theme
from app.look.language import number, tr
from app.views.chart import Chart
from app.views.table import Table
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.eq9 import LABEL
from core.report.tie_words import tie_lines
from core.report.verdict_words import lines_of, sentence_of, tone_of
from core.study.results import Q_SOURCES, StudyResult, WallResult
from core.text.sentence import word
from core.units import G

LAW_WORDS = {"q": "law_q", "q_slv": "law_q_slv"}


def verdict_color(result: StudyResult, wall: WallResult) -> str:
    """Green only where nothing is left to read."""
    return getattr(theme.current, tone_of(result, wall))


def digits(value: float | None, figures: int = 2) -> str:
    """A number with so many decimals."""
    return number(value, f".{figures}f")


class CheckTab(QWidget):
    """The table of methods, the peaks at the demand, the verdict."""

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.sentence = QLabel(tr("No result yet: press F5."))
        self.sentence.setWordWrap(True)
        self.sentence.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.reasons = QLabel()
        self.reasons.setWordWrap(True)
        self.reasons.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.table = Table(
            tr("Checks"),
            [tr("Method"), "ζ", tr("Outcome"), tr("Clause"), "q", tr("Capacity"), tr("Demand"), tr("Unit")],
        )
        self.peaks = Chart(tr("record"), "θmax/θc [-]", tr("Peaks at the demand"))
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(self.table)
        split.addWidget(self.peaks)
        layout = QVBoxLayout(self)
        layout.addWidget(self.sentence)
        layout.addWidget(self.reasons)
        layout.addWidget(split, 1)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tab from one wall of a result."""
        assessment = wall.assessment
        self.peaks.clear()
        rows, colors = [], []
        if assessment is None:
            self.sentence.setText(tr("No demand: no check. q of the wall: {q}", q=digits(wall.q_set)))
            self.sentence.setStyleSheet("font-size: 12pt;")
            self.reasons.setText(self._warnings(result, wall))
            self.table.show_rows([])
            self.peaks.say_why(tr("No demand: nothing to compare the peaks with."))
            return
        self.sentence.setText(sentence_of(result, wall, self.language))
        self.sentence.setStyleSheet(f"font-size: 12pt; font-weight: 600; color: {verdict_color(result, wall)};")
        reasons = lines_of(result, wall, self.language)
        reasons += tie_lines(wall, self.language)
        if assessment.kinematic:
            reasons.insert(0, self._mechanism(assessment))
        lines = [f"• {reason}" for reason in reasons] + [self._warnings(result, wall)]
        self.reasons.setText("\n".join(line for line in lines if line))
        for check, decides in assessment.shown:
            color = theme.current.good if check.passed else theme.current.bad
            outcome = "no_number" if check.passed is None else "passed" if check.passed else "not_passed"
            if check.name == "floor_sld":
                outcome = "shown"
            rows.append(
                [
                    word(check.label, self.language),
                    digits(check.zeta),
                    word(outcome, self.language),
                    check.clause,
                    digits(check.q),
                    digits(check.capacity, 3),
                    digits(check.demand, 3),
                    check.unit,
                ]
            )
            colors.append([None, color, color] + [None] * 5 if decides else [theme.current.quiet] * 8)
        for source, check in zip(Q_SOURCES, wall.code_check, strict=False):
            if check:
                outcome = word("passed" if check.passed else "not_passed", self.language)
                rows.append(
                    [
                        word(source, self.language),
                        digits(check.ratio),
                        f"{outcome} ({word('comparison', self.language)})",
                        LABEL,
                        digits(check.q),
                        digits(check.capacity / G, 3),
                        digits(check.demand / G, 3),
                        "g",
                    ]
                )
                colors.append([theme.current.quiet] * 8)
        for estimate in wall.estimates:
            capacity = wall.model.threshold / G
            wanted = result.demand.pga / G / estimate.q
            between = f"q {number(estimate.low, '.2f')} – {number(estimate.high, '.2f')}"
            if not estimate.within:
                between += ", " + tr("outside its range")
            rows.append(
                [
                    word(LAW_WORDS[estimate.quantity], self.language),
                    digits(capacity / wanted),
                    between,
                    LABEL,
                    digits(estimate.q),
                    digits(capacity, 3),
                    digits(wanted, 3),
                    "g",
                ]
            )
            colors.append([theme.current.quiet] * 8)
        self.table.show_rows(rows, colors)
        self.peaks.caption = f"{wall.name}, {word(wall.mechanism, self.language)}"
        if assessment.dynamic:
            self._bars(assessment.dynamic)
        else:
            self.peaks.say_why(tr("No dynamic check: it needs records and a demand at SLV or SLC."))

    def _mechanism(self, assessment) -> str:
        """Free to vibrate or restrained, T_0, and what the dynamic check says beside zeta_E."""
        kinematic, dynamic = assessment.kinematic, assessment.dynamic
        parts = [tr("Element free to vibrate") if kinematic.free_element else tr("Not free to vibrate")]
        if kinematic.period_0 is not None:
            parts.append(f"T_0 {number(kinematic.period_0, '.3f')} s")
        parts.append(f"e* {number(kinematic.e_star, '.3g')}, a0* {number(kinematic.a0 / G, '.3f')} g")
        if kinematic.chain.friction_height is not None:
            height = kinematic.chain.friction_height
            parts.append(tr("of the upper {h:.2f} m with friction", h=height))
        if dynamic:
            parts.append(word(f"confidence_{dynamic.confidence_on}", self.language))
            parts.append(f"ζ_16 {digits(dynamic.zeta_16)}")
            share = f"{number(dynamic.share_failing_at_demand, '.0%')}"
            parts.append(tr("failing within ±10 % of the demand: {share}", share=share))
        if assessment.risk:
            parts += self._risk(assessment.risk)
        return "; ".join(parts)

    @staticmethod
    def _risk(risk) -> list[str]:
        """What the mechanism withstands."""
        parts = [f"PGA_C {number(risk.pga / G, '.3f')} g"]
        if risk.years is not None:
            parts.append(tr("T_R,C {years} years", years=risk.years))
        if risk.index is not None:
            parts.append(tr("IS-V of this mechanism {index:.2f}, class {letter}", index=risk.index, letter=risk.letter))
        return parts

    def _warnings(self, result: StudyResult, wall: WallResult) -> str:
        """What is said of the demand and of the wall."""
        demand = result.demand.warnings if result.demand else ()
        return "\n".join(f"• {warning.text(self.language)}" for warning in (*demand, *wall.warnings))

    def _bars(self, check) -> None:
        top = 1.2
        values = np.array([np.nan if run.peak_ratio is None else run.peak_ratio for run in check.runs])
        drawn = np.minimum(np.nan_to_num(values, nan=top), top)  # to the edge: no number of its own
        places, exceeds = (np.arange(values.size, dtype=float), np.array([run.exceeded for run in check.runs]))
        for chosen, name, color in ((~exceeds, tr("within θc"), 0), (exceeds, tr("exceeds θc or overturns"), 1)):
            self.peaks.bars(name, places[chosen], drawn[chosen], color, values=values[chosen])
        ends = np.array([-0.6, values.size - 0.4])
        if check.set_rule == "mean" and check.mean_peak_ratio is not None:
            mean = check.mean_peak_ratio  # in the legend: no word of it lies on the bars
            name = tr("mean {value:.2f}, which decides", value=mean)
            self.peaks.curve(name, ends, [mean, mean], "ink", 2.0)
        for fraction, label in ((0.40, "SLV"), (0.60, "SLC"), (1.00, "θc")):
            wanted = LIMIT_FRACTION.get(check.limit_state) == fraction
            self.peaks.level(
                fraction, f"{number(fraction, '.2f')} {label}", "bad" if wanted or fraction == 1.0 else "quiet"
            )
        signs = {run.polarity for run in check.runs}
        names = [run.record + ("" if len(signs) == 1 else " +" if run.polarity > 0 else " −") for run in check.runs]
        self.peaks.names_below(names)
        self.peaks.set_range((-0.6, len(names) - 0.4), (0.0, top))
