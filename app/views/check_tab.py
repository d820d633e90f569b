"""The answer of a wall: its verdict, the ladder of checks, its hinges, the peaks at the demand, facts of trust."""

import html

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.look import theme
from app.look.drawing import WallDrawing
from app.look.labels import PlainLabel, RichLabel
from app.look.language import number, tr, wall_title
from app.views.answer_lines import (
    assumption_rows,
    link,
    no_dynamic_check,
    required_actions,
    verdict_color,
    verdict_limitations,
)
from app.views.capacity_curve_chart import CapacityCurveChart
from app.views.chart import Chart
from app.views.ladder import Ladder
from app.views.result_tab import ResultTab
from app.views.runs import title_of
from app.views.table import Table
from app.views.zeta_rungs import digits, rung_of
from core.answer.answer import ordered_runs
from core.capacity.limit_states import LIMIT_FRACTION
from core.case.schema import Generate
from core.codes.eq9 import LABEL
from core.known import require_value
from core.report.register_words import describe_lines
from core.report.tie_words import tie_lines
from core.report.uncertainty_text import risk_of, verdict_of
from core.report.verdict_words import lines_of, sentence_of, tone_of
from core.study.results import Q_SOURCES, StudyResult, WallResult
from core.study.wall_verdict import zeta_by_hinge
from core.text.sentence import localized, word
from core.units import G

MAX_PEAK_SHOWN, PEAK_AXIS_FACTOR = 1.2, 1.15
"""Largest peak over theta_c that bars show, and room above the largest bar and the limit that decides [of them]."""

BIG = 3.2
"""Size of zeta beside that of the other words."""

MAX_LIMITS_SHOWN = 3
"""Lines of limits that are always shown; what makes a verdict indicative is among them, however much it is."""

MIN_LADDER_HEIGHT = 340
"""Least height of ladder and peaks together [px]: below it the page scrolls."""

OF_THE_LAW = ("no_power_law", "narrow_si")
"""Warnings that are notes of an answer."""

LAW_WORDS = {"q": "law_q", "q_slv": "law_q_slv"}


class Whole(QWidget):
    """A page that scrolls rather than cut its words: as high as they need, not as the chart would like."""

    def heightForWidth(self, width: int) -> int:
        return require_value(self.layout()).minimumHeightForWidth(width)


class CheckTab(ResultTab):
    """The verdict of a wall in one line, what is to be done and what limits it, the ladder of checks, the wall with the
    zeta of each hinge, the peaks at the demand, four facts of trust; the table and the comparisons by a click.

    asked(what) : variant, generate, a form by its kind, "key:" and "reason:" with a key
    record_picked(run) : the bar of a run was clicked, its (motion, polarity)
    """

    asked = Signal(str)
    record_picked = Signal(object)

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self._make_banner()
        self.table = Table(
            tr("Checks"),
            [tr("Method"), "ζ", tr("Outcome"), tr("Clause"), "q", tr("Capacity"), tr("Demand"), tr("Unit")],
        )
        self.ladder = Ladder()
        self.drawing = WallDrawing()
        self.drawing.setMinimumWidth(170)
        self.more = self._opener(self._show_table)
        self.more.setText(tr("Table, Eq. 9 and research ▸"))
        self.checks = QStackedWidget()
        self.checks.addWidget(self.ladder)
        self.checks.addWidget(self.table)
        above = QWidget()
        column = QVBoxLayout(above)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.checks, 1)
        column.addWidget(self.more, 0, Qt.AlignmentFlag.AlignRight)
        self.peaks = Chart(tr("record"), "θmax/θc [-]", tr("Peaks at the demand"))
        self.peaks.setMinimumHeight(max(150, 12 * self.fontMetrics().height()))  # its levels apart in large letters
        self.peaks.setToolTip(tr("Click a bar for the history of its record."))
        self.peaks.clicked.connect(self._clicked)
        self.runs: list[tuple[int, int]] = []
        self.split = QSplitter(Qt.Orientation.Vertical)
        self.split.addWidget(above)
        self.curve = CapacityCurveChart()
        self.split.addWidget(self.peaks)
        self.split.addWidget(self.curve)
        self.split.setStretchFactor(1, 1)
        self.split.setStretchFactor(2, 1)
        # what the words above leave, else the page scrolls by the chart's wish
        self.split.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Ignored)
        self.facts = RichLabel()
        self.facts.setWordWrap(True)
        self.facts.setAccessibleName(tr("Why the result may be trusted"))
        page = Whole()
        layout = QVBoxLayout(page)
        layout.setContentsMargins(6, 6, 6, 4)
        layout.addWidget(self.banner)
        middle = QHBoxLayout()  # the wall as high as checks and peaks together
        middle.addWidget(self.split, 5)
        middle.addWidget(self.drawing, 2)
        layout.addLayout(middle, 1)
        layout.addWidget(self.no_peaks)
        layout.addWidget(self.facts)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidget(page)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(area)

    def _make_banner(self) -> None:
        """The verdict, what is to be done, what limits it and notes, in a frame."""
        self.heading, self.sentence = PlainLabel(), PlainLabel(tr("No result yet: press F5."))
        self.zeta = PlainLabel()
        self.important, self.reasons = RichLabel(), PlainLabel()
        for label in (self.heading, self.sentence, self.important, self.reasons):
            label.setWordWrap(True)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        links = Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        self.no_peaks = RichLabel()
        self.others = RichLabel()
        self.others.setWordWrap(True)
        self.assumed = RichLabel()
        self.assumed.setWordWrap(True)
        self.all_limits = self._opener(self.others.setVisible)
        for label in (self.important, self.others, self.no_peaks):
            label.setTextInteractionFlags(label.textInteractionFlags() | links)
            label.linkActivated.connect(self.asked)
        self.no_peaks.setWordWrap(True)
        self.notes = self._opener(self.reasons.setVisible)
        self.banner = QFrame()
        self.banner.setObjectName("verdict")
        across, inside = QHBoxLayout(self.banner), QVBoxLayout()
        across.setContentsMargins(14, 6, 10, 6)
        across.setSpacing(16)
        across.addWidget(self.zeta, 0, Qt.AlignmentFlag.AlignTop)
        across.addLayout(inside, 1)
        inside.setSpacing(2)
        said = (self.important, self.assumed, self.all_limits, self.others)
        for widget in (self.heading, self.sentence, *said, self.notes, self.reasons):
            inside.addWidget(widget)
        for widget in (self.all_limits, self.others, self.reasons):
            widget.hide()

    def _show_table(self, on: bool) -> None:
        """The table in the place of the ladder."""
        self.checks.setCurrentIndex(int(on))

    @staticmethod
    def _opener(slot) -> QPushButton:
        button = QPushButton()
        button.setCheckable(True)
        button.setFlat(True)
        button.setStyleSheet(f"QPushButton {{ color: {theme.current.curves[0]}; text-align: left; padding: 2px; }}")
        button.toggled.connect(slot)
        return button

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the page from one hinge of a wall of a result."""
        assessment = wall.assessment
        self.peaks.clear()
        self.curve.show_in_place_of(self.peaks, result, wall)
        self.drawing.show_wall(wall.part.body, zeta_by_hinge(result, wall))
        shade = verdict_color(result, wall) if assessment else theme.current.edge
        tint = QColor(shade)
        tint.setAlpha(26)
        edges = f"border: 1px solid {shade}; border-left: 8px solid {shade};"
        self.banner.setStyleSheet(f"QFrame#verdict {{ {edges} background: {tint.name(QColor.NameFormat.HexArgb)}; }}")
        for widget in (self.ladder, self.more, self.important, self.zeta):
            widget.setVisible(assessment is not None)
        if assessment is None:
            self.all_limits.hide()
            self.assumed.hide()
            self.others.hide()
            self.heading.setText(wall_title(wall.name))
            self.sentence.setText(tr("No demand: no check. q of the wall: {q}", q=digits(wall.q_set)))
            self._fold(self._warnings(result, wall) + self._warnings(result, wall, True))
            self.facts.setText("")
            self.table.show_rows([])
            self._show_peaks(tr("No demand: nothing to compare the peaks with."), "demand")
            return
        verdict = assessment.verdict
        self.zeta.setText(f"ζ {digits(verdict.zeta_e)}")
        self.zeta.setStyleSheet(f"{theme.font_points(BIG)} font-weight: 700; color: {shade};")
        outcome = theme.add_tone_mark(tone_of(result, wall), word(verdict.code, self.language))
        self.heading.setText(f"{wall_title(wall.name)}: {outcome}")
        self.heading.setStyleSheet(f"{theme.font_points(1.75)} font-weight: 700; color: {shade};")
        self.sentence.setText(wall_title(sentence_of(wall, self.language)))
        lines = verdict_limitations(result, wall, self.language, self._warnings(result, wall))
        shown = max(MAX_LIMITS_SHOWN, verdict.blocking) if len(lines) > MAX_LIMITS_SHOWN + 1 else len(lines)
        self.important.setText("<br>\n".join([*required_actions(result, wall, self.language), *lines[:shown]]))
        self.others.setText("<br>\n".join(lines[shown:]))
        self.assumed.setText(assumption_rows(result, wall, self.language))
        self.assumed.setVisible(bool(self.assumed.text()))
        self.all_limits.setText(tr("All {n} limits ▾", n=len(lines)))
        self.all_limits.setVisible(len(lines) > shown)
        self.others.setVisible(len(lines) > shown and self.all_limits.isChecked())
        others = lines_of(result, wall, self.language, ("note", "reason")) + tie_lines(wall, self.language)
        others += self._warnings(result, wall, True)
        if decided := verdict_of(result, wall):
            others += describe_lines(result, decided, self._report_words, self.language)
        if assessment.kinematic:
            others.insert(0, self._mechanism(assessment))
        self._fold(others)
        rungs = [rung_of(check, check.name == verdict.governing, assessment.dynamic) for check in assessment.checks]
        self.ladder.show_rungs(rungs, verdict.zeta_target)
        self.split.setMinimumHeight(max(MIN_LADDER_HEIGHT, self.split.minimumSizeHint().height()))
        self.facts.setText(self._facts(result, wall))
        self.table.show_rows(*self._rows(result, wall))
        self.peaks.caption = title_of(wall)
        if assessment.dynamic:
            self._show_peaks()
            self._bars(assessment.dynamic)
        else:
            self._show_peaks(*no_dynamic_check(result, wall))

    def _report_words(self, english: str, **values) -> str:
        return localized("report", english, self.language, **values)

    def _show_peaks(self, why: str = "", lead: str = "") -> None:
        """The chart of the peaks, or why there is none and what leads to it. lead : as of `ask`, or nothing"""
        self.peaks.setVisible(not why)
        self.no_peaks.setVisible(bool(why))
        words = {
            "demand": tr("Give the demand"),
            "building": tr("Give the building"),
            "generate": tr("Generate {n} motions", n=Generate().count),
        }.get(lead)
        self.no_peaks.setText(f"{html.escape(why)} {link(lead, words)}" if words else html.escape(why))

    def _clicked(self, x: float, _: float) -> None:
        """A bar of the peaks leads to its history."""
        if 0 <= round(x) < len(self.runs):
            self.record_picked.emit(self.runs[round(x)])

    def _rows(self, result: StudyResult, wall: WallResult) -> tuple[list, list]:
        """Rows of the table and their colours: checks, Eq. 9, what research estimates."""
        rows, colors = [], []
        for check, decides in require_value(wall.assessment).shown:
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
            wanted = require_value(result.demand).pga / G / estimate.q
            between = ", ".join(said.text(self.language) for said in estimate.ranges)
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
        return rows, colors

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

    def _warnings(self, result: StudyResult, wall: WallResult, of_the_law: bool = False) -> list[str]:
        """What is said of the demand and of the wall; of_the_law : of the law of q_eff, on which no verdict rests"""
        said = (*(result.demand.warnings if result.demand else ()), *wall.warnings)
        return [one.text(self.language) for one in said if (one.code in OF_THE_LAW) == of_the_law]

    def _fold(self, lines: list[str]) -> None:
        """Notes behind their number."""
        self.notes.setText(tr("Notes: {n} ▾", n=len(lines)))
        self.notes.setVisible(bool(lines))
        self.reasons.setText("\n".join(f"• {line}" for line in lines))

    def _facts(self, result: StudyResult, wall: WallResult) -> str:
        """Five facts by which a reader judges how far the verdict goes."""
        assessment = require_value(wall.assessment)
        dynamic, facts = assessment.dynamic, []
        if dynamic and dynamic.zeta is not None:
            other = f"ζ {digits(dynamic.zeta_16)} – {digits(dynamic.zeta)}"
            facts.append((tr("Scatter: one multiplier in six fails"), other))
        rules = result.compliance
        kind = "" if rules is None else ", " + (tr("compatible") if rules.compatible else tr("not compatible"))
        facts.append((tr("Set of records"), f"{len(result.motions)}{kind}"))
        verdict = verdict_of(result, wall)
        if verdict and (interval := verdict.interval):
            ends = digits(interval.low), "…" if interval.open_end else digits(interval.high)
            facts.append((tr("Other stations, nine of ten"), f"ζ {ends[0]} – {ends[1]}"))
        if assessment.lower_bound is not None:
            facts.append((tr("If the restraint behind fails"), f"ζ {digits(assessment.lower_bound.zeta)}"))
        elif assessment.verdict.lower_bound is not None:
            facts.append((tr("If what holds the top fails"), f"ζ {digits(assessment.verdict.lower_bound)}"))
        elif dynamic and dynamic.zeta_other:
            side = word(f"confidence_{dynamic.zeta_other.confidence_on}", self.language)
            facts.append((side, f"ζ {digits(dynamic.zeta_other.zeta)}"))
        if risk := risk_of(result, wall):
            facts.append(("PGA_C", f"{number(risk.pga / G, '.3f')} g"))
        quiet = theme.current.quiet
        cells = "".join(
            f"<td style='padding-right: 34px'><span style='color:{quiet}'>{html.escape(name)}</span><br>"
            f"<b>{html.escape(value)}</b></td>"
            for name, value in facts
        )
        return f"<table><tr>{cells}</tr></table>"

    def _bars(self, check) -> None:
        runs = ordered_runs(check)
        values = np.array([np.nan if run.peak_ratio is None else run.peak_ratio for run in runs])
        limit = LIMIT_FRACTION.get(check.limit_state, 1.0)
        top = min(MAX_PEAK_SHOWN, PEAK_AXIS_FACTOR * max(limit, *np.nan_to_num(values, nan=MAX_PEAK_SHOWN)))
        drawn = np.minimum(np.nan_to_num(values, nan=top), top)  # to the edge: no number of its own
        places, exceeds = (np.arange(values.size, dtype=float), np.array([run.exceeded for run in runs]))
        for chosen, name, color in ((~exceeds, tr("within θc"), 0), (exceeds, tr("exceeds θc or overturns"), 1)):
            self.peaks.bars(name, places[chosen], drawn[chosen], color, values=values[chosen])
        ends = np.array([-0.6, values.size - 0.4])
        if check.set_rule == "mean" and check.mean_peak_ratio is not None:
            mean = check.mean_peak_ratio  # in the legend: no word of it lies on the bars
            name = tr("mean {value:.2f}, which decides", value=mean)
            self.peaks.curve(name, ends, [mean, mean], "ink", 2.0)
        for fraction, label in ((0.40, "SLV"), (0.60, "SLC"), (1.00, "θc")):
            wanted = limit == fraction
            self.peaks.level(
                fraction,
                f"{number(fraction, '.2f')} {label}",
                "bad" if wanted or fraction == 1.0 else "quiet",
                place=0.95,  # the largest bars are on the left
            )
        self.runs = [(run.motion, run.polarity) for run in runs]
        signs = {run.polarity for run in runs}
        names = [run.record + ("" if len(signs) == 1 else " +" if run.polarity > 0 else " −") for run in runs]
        self.peaks.names_below(names)
        self.peaks.set_range((-0.6, len(names) - 0.4), (0.0, top))
