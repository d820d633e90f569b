"""The answer of a wall: its outcome, the ladder of checks, its mechanisms, the peaks at the demand, what is to be
done."""

import html
import itertools

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QPushButton, QScrollArea, QStackedWidget, QVBoxLayout, QWidget

from app.look import theme
from app.look.drawing import WallDrawing
from app.look.labels import PlainLabel, RichLabel, escape_html
from app.look.language import number, tr, wall_title
from app.views.answer_cards import LINKS, Card, CostCard, Drawer, Fact, ToDoCard, lay_out_row, mechanism_lists
from app.views.answer_lines import blocking_lines, link, no_dynamic_check, verdict_limitations
from app.views.capacity_curve_chart import CapacityCurveChart
from app.views.chart import Chart
from app.views.ladder import Ladder
from app.views.result_tab import ResultTab
from app.views.runs import title_of
from app.views.table import Table
from app.views.zeta_rungs import digits, rung_of
from core.answer.answer import costliest, find_questions, ordered_runs
from core.capacity.limit_states import LIMIT_FRACTION
from core.case.schema import Generate
from core.codes.assumption import Assumption
from core.codes.outcomes import OUTCOMES
from core.known import require_value
from core.report.register_words import not_possible, reactions_line
from core.report.tie_words import tie_lines
from core.report.uncertainty_text import risk_of, verdict_of
from core.report.verdict_words import lines_of, names_in, sentence_of, tone_of, write_headline
from core.report.wall_tables import CheckRow, checks_of_wall, rows_of_checks, rows_of_comparison, rows_of_estimates
from core.report.words import Words
from core.study.results import StudyResult, WallResult
from core.study.wall_verdict import zeta_by_hinge
from core.text.sentence import localized, word
from core.units import G

MAX_PEAK_SHOWN, PEAK_AXIS_FACTOR = 1.2, 1.15
"""Largest peak over theta_c that bars show, and room above the largest bar and the limit that decides [of them]."""

BIG, HEADING, SENTENCE = 4.6, 1.75, 1.1
"""Sizes of zeta, of the outcome and of the line below it beside that of the other words."""

MIN_PEAKS_HEIGHT = 130
"""Least height of the peaks [px]: below it the page scrolls."""

OF_THE_LAW = ("no_power_law", "narrow_si")
"""Warnings that are notes of an answer."""


class Whole(QWidget):
    """A page that scrolls rather than cut its words: as high as they need, not as the chart would like."""

    def heightForWidth(self, width: int) -> int:
        return require_value(self.layout()).minimumHeightForWidth(width)


class CheckTab(ResultTab):
    """The answer of a wall at a glance: zeta and outcome in one line, the wall with the zeta of each hinge beside its
    checks, its mechanisms and its peaks; what is to be done and what costs most if it is not so; the rest in a drawer.

    asked(what) : variant, generate, a form by its kind, "key:" and "reason:" with a key
    record_picked(run) : the bar of a run was clicked, its (motion, polarity)
    """

    asked = Signal(str)
    record_picked = Signal(object)

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.shown: tuple[StudyResult, WallResult] | None = None
        self.drawing = WallDrawing()
        self.drawing.setMinimumWidth(170)
        self.no_peaks = RichLabel()
        self.no_peaks.setWordWrap(True)
        self.no_peaks.setTextInteractionFlags(LINKS)
        self.no_peaks.linkActivated.connect(self.asked)
        self.to_do, self.cost, self.drawer = ToDoCard(), CostCard(), Drawer()
        self.to_do.asked.connect(self.asked)
        self.drawer.asked.connect(self.asked)
        self.cost.turned.connect(self._show_turned)
        page = Whole()
        layout = QVBoxLayout(page)
        layout.setContentsMargins(10, 6, 10, 4)
        layout.setSpacing(8)
        layout.addLayout(self._head())
        middle = QHBoxLayout()  # the wall as high as checks and peaks together
        middle.setSpacing(10)
        wall = Card("")
        wall.inside.addWidget(self.drawing, 1)
        middle.addWidget(wall, 2)
        middle.addWidget(self._checks_card(), 5)
        layout.addLayout(middle, 1)
        layout.addLayout(lay_out_row(self.to_do, self.cost))
        layout.addWidget(self.drawer)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidget(page)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(area)

    def _head(self) -> QHBoxLayout:
        """zeta beside the outcome and one line on what decides."""
        self.zeta, self.heading = PlainLabel(), PlainLabel()
        self.sentence = PlainLabel(tr("No result yet: press F5."))
        self.sentence.setStyleSheet(theme.font_points(SENTENCE))
        for label in (self.heading, self.sentence):
            label.setWordWrap(True)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        head, beside = QHBoxLayout(), QVBoxLayout()
        head.setSpacing(20)
        beside.setSpacing(0)
        beside.addStretch(1)
        beside.addWidget(self.heading)
        beside.addWidget(self.sentence)
        beside.addStretch(1)
        head.addWidget(self.zeta, 0, Qt.AlignmentFlag.AlignVCenter)
        head.addLayout(beside, 1)
        return head

    def _checks_card(self) -> Card:
        """The checks as bars or as a table, the mechanisms in three lists, the peaks."""
        self.table = Table(tr("Checks"), [])
        self.ladder = Ladder()
        self.more = QPushButton(tr("Table, Eq. 9 and research ▸"))
        self.more.setCheckable(True)
        self.more.setFlat(True)
        shade = theme.current.curves[0]
        self.more.setStyleSheet(f"QPushButton {{ color: {shade}; text-align: left; padding: 2px; }}")
        self.checks = QStackedWidget()
        self.checks.addWidget(self.ladder)
        self.checks.addWidget(self.table)
        self.more.toggled.connect(lambda on: self.checks.setCurrentIndex(int(on)))
        self.mechanisms = RichLabel()
        self.mechanisms.setWordWrap(True)
        self.mechanisms.setTextInteractionFlags(LINKS)
        self.mechanisms.setAccessibleName(tr("Mechanisms"))
        self.mechanisms.linkActivated.connect(self.asked)
        self.peaks = Chart(tr("record"), "θmax/θc [-]", tr("Peaks at the demand"))
        self.peaks.setMinimumHeight(max(MIN_PEAKS_HEIGHT, 11 * self.fontMetrics().height()))
        self.peaks.setToolTip(tr("Click a bar for the history of its record."))
        self.peaks.clicked.connect(self._clicked)
        self.runs: list[tuple[int, int]] = []
        self.curve = CapacityCurveChart()
        card = Card("")
        for widget in (self.checks, self.mechanisms, self.no_peaks, self.peaks, self.curve):
            card.inside.addWidget(widget, 1 if widget in (self.peaks, self.curve) else 0)
        card.inside.insertWidget(1, self.more, 0, Qt.AlignmentFlag.AlignRight)
        return card

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the page from one hinge of a wall of a result."""
        self.shown, assessment = (result, wall), wall.assessment
        self.peaks.clear()
        self.curve.show_in_place_of(self.peaks, result, wall)
        at, moves = (wall.part.hinge, tone_of(result, wall)), wall.part if assessment is not None else None
        self.drawing.show_wall(wall.part.body, zeta_by_hinge(result, wall), at if moves else None, moves)
        for widget in (self.checks, self.more, self.zeta):
            widget.setVisible(assessment is not None)
        origin = wall.part.origin
        decided = next((each for each in result.verdicts if result.walls[each.governing].part.origin == origin), None)
        self.mechanisms.setText(mechanism_lists(result, decided, self.language) if decided else "")
        self.mechanisms.setVisible(decided is not None)
        self.mechanisms.setToolTip(escape_html(not_possible(result, decided, self.language) if decided else ""))
        if assessment is None:
            self.to_do.hide()
            self.cost.show_row(None, None, self.language)
            self.heading.setText(wall_title(wall.name))
            self.heading.setStyleSheet(f"{theme.font_points(HEADING)} font-weight: 700;")
            self.sentence.setText(tr("No demand: no check. q of the wall: {q}", q=digits(wall.q_set)))
            notes = self._warnings(result, wall) + self._warnings(result, wall, True)
            self.drawer.show_facts([Fact(tr("Notes"), str(len(notes)), notes)] if notes else [])
            self.table.show_rows([])
            self._show_peaks(tr("No demand: nothing to compare the peaks with."), "demand")
            return
        verdict, demand = assessment.verdict, result.demand
        self._show_head(verdict.zeta_e, verdict.code, tone_of(result, wall))
        self.sentence.setText(wall_title(write_headline(wall, self.language)))
        self.sentence.setToolTip(escape_html(wall_title(sentence_of(wall, self.language))))
        limits = verdict_limitations(result, wall, self.language, self._warnings(result, wall), alone=True)
        questions = [*(find_questions(result, decided) if decided else ()), *(demand.warnings if demand else ())]
        questions = [html.escape(line.text(self.language, names_in(self.language)), quote=False) for line in questions]
        self.to_do.show_actions(result, wall, self.language, [*blocking_lines(wall, limits), *questions])
        self.cost.show_row(costliest(verdict.assumptions), verdict.zeta_e, self.language)
        self.drawer.show_facts(self._facts(result, wall, limits))
        rungs = [rung_of(check, check.name == verdict.governing, assessment.dynamic) for check in assessment.checks]
        self.ladder.show_rungs(rungs, verdict.zeta_target)
        self.table.show_table(checks_of_wall(Words(self.language)), self._rows(result, wall))
        self.peaks.caption = title_of(wall)
        if assessment.dynamic:
            self._show_peaks()
            self._bars(assessment.dynamic)
        else:
            self._show_peaks(*no_dynamic_check(result, wall))

    def _show_head(self, zeta: float | None, code: str, tone: str) -> None:
        """zeta and an outcome in its colour."""
        shade = getattr(theme.current, tone)
        self.zeta.setText(f"ζ {digits(zeta)}")
        self.zeta.setStyleSheet(f"{theme.font_points(BIG)} font-weight: 700; color: {shade};")
        title = wall_title(require_value(self.shown)[1].name)
        self.heading.setText(f"{title}: {theme.add_tone_mark(tone, word(code, self.language))}")
        self.heading.setStyleSheet(f"{theme.font_points(HEADING)} font-weight: 700; color: {shade};")

    def _show_turned(self, row: Assumption | None) -> None:
        """The head as the assumption that costs most is not so; None as it is given."""
        result, wall = require_value(self.shown)
        verdict = wall.required_assessment.verdict
        if row is None:
            self._show_head(verdict.zeta_e, verdict.code, tone_of(result, wall))
        else:
            self._show_head(row.zeta, row.outcome, OUTCOMES[row.outcome].tone)

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

    def _rows(self, result: StudyResult, wall: WallResult) -> list[CheckRow]:
        """Rows of the table: checks, Eq. 9, what research estimates."""
        compared = rows_of_comparison(wall, self.language), rows_of_estimates(result, wall, self.language)
        return [*rows_of_checks(wall, self.language), *itertools.chain(*compared)]

    def _mechanism(self, assessment) -> str:
        """Free to vibrate or restrained, T_0, and the side of FC."""
        kinematic = assessment.kinematic
        parts = [tr("Element free to vibrate") if kinematic.free_element else tr("Not free to vibrate")]
        if kinematic.period_0 is not None:
            parts.append(f"T_0 {number(kinematic.period_0, '.3f')} s")
        parts.append(f"e* {number(kinematic.e_star, '.3g')}, a0* {number(kinematic.a0 / G, '.3f')} g")
        if kinematic.chain.friction_height is not None:
            height = kinematic.chain.friction_height
            parts.append(tr("of the upper {h:.2f} m with friction", h=height))
        if assessment.dynamic:
            parts.append(word(f"confidence_{assessment.dynamic.confidence_on}", self.language))
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
        warnings = (*(result.demand.warnings if result.demand else ()), *wall.warnings)
        return [warning.text(self.language) for warning in warnings if (warning.code in OF_THE_LAW) == of_the_law]

    def _facts(self, result: StudyResult, wall: WallResult, limits: list[str]) -> list[Fact]:
        """What stands in the drawer: how sure zeta is, the records, other states, what the wall withstands, what limits
        the outcome, notes."""
        assessment = require_value(wall.assessment)
        verdict, dynamic, rules = verdict_of(result, wall), assessment.dynamic, result.compliance
        sure = self._how_sure(result, wall)
        kind = "" if rules is None else ", " + (tr("compatible") if rules.compatible else tr("not compatible"))
        facts = [Fact(tr("What else moves ζ"), sure[0].split(" · ")[0], sure)] if sure else []
        if dynamic or result.motions:
            failing = [] if dynamic is None else self._failing(dynamic)
            facts.append(Fact(tr("Records"), f"{len(result.motions)}{kind}", failing))
        states = {} if verdict is None else verdict.states
        others = [f"{state} {digits(found.zeta)}" for state, found in states.items() if found.zeta is not None]
        if others:
            facts.append(Fact(tr("ζ of all states"), " · ".join(others), []))
        if risk := risk_of(result, wall):
            lines = self._risk(risk)
            facts.append(Fact(tr("It withstands"), lines[0], lines[1:]))
        notes = lines_of(result, wall, self.language, ("note", "reason")) + tie_lines(wall, self.language)
        notes += self._warnings(result, wall, True)
        if assessment.kinematic:
            notes.insert(0, self._mechanism(assessment))
        if verdict and (taken := reactions_line(result, verdict, self._report_words, self.language)):
            notes.insert(0, taken)
        behind = [html.escape(line, quote=False) for line in notes]
        told = ((tr("Limits"), limits), (tr("Notes"), behind))
        return facts + [Fact(label, str(len(lines)), lines) for label, lines in told if lines]

    def _how_sure(self, result: StudyResult, wall: WallResult) -> list[str]:
        """What else zeta hangs on: other stations, scatter, the other side of FC, the wall without what holds it."""
        assessment, facts = require_value(wall.assessment), []
        dynamic, verdict = assessment.dynamic, verdict_of(result, wall)
        if verdict and (interval := verdict.interval):
            ends = digits(interval.low), "…" if interval.open_end else digits(interval.high)
            facts.append((tr("Other stations, nine of ten"), f"ζ {ends[0]} – {ends[1]}"))
        if dynamic and dynamic.zeta is not None:
            between = f"ζ {digits(dynamic.zeta_16)} – {digits(dynamic.zeta)}"
            facts.append((tr("Scatter: one multiplier in six fails"), between))
        if assessment.lower_bound is not None:
            facts.append((tr("If the restraint behind fails"), f"ζ {digits(assessment.lower_bound.zeta)}"))
        elif assessment.verdict.lower_bound is not None:
            facts.append((tr("If what holds the top fails"), f"ζ {digits(assessment.verdict.lower_bound)}"))
        if dynamic and dynamic.zeta_other:
            side = word(f"confidence_{dynamic.zeta_other.confidence_on}", self.language)
            facts.append((side, f"ζ {digits(dynamic.zeta_other.zeta)}"))
        return [f"{html.escape(value)} · {html.escape(name)}" for name, value in facts]

    def _failing(self, dynamic) -> list[str]:
        """How near to the demand the rule of the records fails."""
        share = number(dynamic.share_failing_at_demand, ".0%")
        return [f"ζ_16 {digits(dynamic.zeta_16)}; " + tr("failing within ±10 % of the demand: {share}", share=share)]

    def _report_words(self, english: str, **values) -> str:
        return localized("report", english, self.language, **values)

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
