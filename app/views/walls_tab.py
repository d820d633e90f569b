"""The tab Overview: every wall of the study, the lowest zeta first, and walls before beside walls after."""

import html
from collections import Counter
from typing import Any, NamedTuple

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QSplitter, QStyledItemDelegate, QVBoxLayout, QWidget

from app.look import theme
from app.look.labels import PlainLabel, RichLabel
from app.look.language import number, tr, wall_title
from app.views.answer_cards import TITLE_POINTS, Card
from app.views.answer_lines import link, say_in_window, verdict_color
from app.views.result_tab import ResultTab
from app.views.table import Table
from app.views.zeta_rungs import digits
from core.answer.answer import Answer, answers_worst_first, collect_actions, worst_so_far
from core.codes.assumption import format_value
from core.codes.outcomes import OUTCOMES
from core.known import require_value
from core.report.columns import BY_KEY, Row
from core.report.stated.quantity import select_quantities, serialize
from core.report.stated.verdicts import VERDICT, VerdictSource
from core.report.verdict_words import names_in, tone_of
from core.report.wall_tables import variants_of_walls
from core.report.words import Words
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.variants import compare_walls
from core.text.sentence import localized, sentence, word
from core.variation.limit_states import LIMIT_STATES
from core.variation.measures import Measure

OF_HINGE = ("name", "mechanism", "zeta_e", "verdict", "check")
HANGS_ON = "hangs_on"
OF_WALL = ("pga_c_g", "return_period_c_years", "is_v")
KEYS = (*OF_HINGE[:-1], HANGS_ON, OF_HINGE[-1], *OF_WALL, *LIMIT_STATES)
"""Quantities of the results in the columns: about the hinge that decides, and of the whole wall."""
MOST_IN_PLAN = 1000
"""Walls of a case among which one with a place in the key plan is looked for."""
HEADING = 1.5
"""Size of the heading beside that of the other words."""
BAR_END, BAR_HEIGHT, BAR_WIDTH = 1.25, 5.0, 110
"""Length of a bar over the zeta required, its height and least width [px]."""
WIDTHS = [720, 340]
"""Widths that the table and what is beside it begin with [px]."""
ZETA, RISK = KEYS.index("zeta_e"), KEYS.index("pga_c_g")


def steps() -> list[str]:
    """How to begin, in three steps."""
    return [
        tr("1. Walls: dimensions, mechanism, what stands behind them (+ wall below the tree, or table… for many)."),
        tr("2. Demand: a_g, spectrum, confidence factor; records: drop files, or Generate…"),
        tr("3. F5. Then this overview, the answer of each wall, and File → Export."),
    ]


def values_of(wall: WallResult, verdict: WallVerdict | None, result: StudyResult | None) -> dict[str, Any]:
    """The quantities of a row, as the results have them. verdict, result : None while the study runs"""
    row = Row(wall, wall.part.origin + 1, verdict, True, result)
    values = {key: BY_KEY[key].of(row) for key in OF_HINGE}
    if verdict is not None and result is not None:
        values |= serialize(select_quantities(VERDICT, *OF_WALL, "is_v_letter"), VerdictSource(verdict, result))
        values |= {state: one.zeta for state, one in verdict.states.items()}
    return values


def method_of(wall: WallResult, language: str) -> str:
    """The check that decides, in words."""
    assessment = wall.assessment
    if assessment is None:
        return "–"
    labels = [check.label for check in assessment.checks if check.name == assessment.verdict.governing]
    return word(labels[0], language) if labels else "–"


class ZetaMark(NamedTuple):
    """zeta as a bar: its size and the one required [-], colour."""

    size: float
    target: float
    shade: str


class ZetaBar(QStyledItemDelegate):
    """A number with a bar below it, its end at BAR_END times the zeta required, and a line at that."""

    def paint(self, painter, option, index) -> None:
        """The cell, then the bar at its lower edge."""
        super().paint(painter, option, index)
        bar = index.data(Qt.ItemDataRole.UserRole)
        if not isinstance(bar, ZetaMark):
            return
        inside = QRectF(option.rect).adjusted(4.0, 0.0, -4.0, -3.0)
        per_unit = inside.width() / (BAR_END * bar.target)
        wide = min(bar.size * per_unit, inside.width())
        top = inside.bottom() - BAR_HEIGHT
        painter.fillRect(QRectF(inside.left(), top, inside.width(), BAR_HEIGHT), QColor(theme.current.grid))
        painter.fillRect(QRectF(inside.left(), top, wide, BAR_HEIGHT), QColor(bar.shade))
        line = inside.left() + bar.target * per_unit
        painter.fillRect(QRectF(line - 1.0, top - 2.0, 2.0, BAR_HEIGHT + 4.0), QColor(theme.current.ink))

    def sizeHint(self, option, index) -> QSize:
        """Room for the bar."""
        words = super().sizeHint(option, index)
        return QSize(max(BAR_WIDTH, words.width()), words.height() + round(BAR_HEIGHT) + 8)


class WallsTab(ResultTab):
    """One row a wall and mechanism. picked(k) : the row of the result's k-th wall was clicked twice, its name once;
    row_picked(row) : of a wall of the case, of those that are finished while others run"""

    picked, row_picked = Signal(int), Signal(int)

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.order: list[int] = []
        self.finished, self.finished_rows = 0, []
        self.shown: tuple[StudyResult, WallResult] | None = None
        self.by, self.falling = ZETA, False
        self.heading = PlainLabel()
        self.heading.setWordWrap(True)
        self.words = PlainLabel(tr("No result yet: press F5.") + "\n\n" + "\n".join(steps()))
        self.words.setWordWrap(True)
        self.table = Table(
            tr("Walls of the study"),
            [
                tr("Wall"),
                tr("Mechanism"),
                "ζ",
                tr("Outcome"),
                tr("hangs on, or lacks"),
                tr("by"),
                "PGA_C [g]",
                "T_R,C",
                "IS-V",
                *(f"ζ {state}" for state in LIMIT_STATES),
            ],
        )
        self.table.setItemDelegateForColumn(ZETA, ZetaBar(self.table))
        self._lay_out()

    def _lay_out(self) -> None:
        """The table beside the key plan, pairs below it, what is to be done at the foot."""
        self.table.cellDoubleClicked.connect(lambda row, _: self._picked(row))
        self.table.cellClicked.connect(lambda row, column: self._picked(row) if column == 0 else None)
        self.table.setToolTip(tr("Click the name of a wall to open it, a column title to sort."))
        self.table.horizontalHeader().setSectionsClickable(True)
        self.table.horizontalHeader().sectionClicked.connect(self._sort)
        self.pairs = Table(tr("Before and after"), [])
        self.pairs_title = PlainLabel(tr("Before and after"))
        below = QWidget()
        inside = QVBoxLayout(below)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.addWidget(self.pairs_title)
        inside.addWidget(self.pairs, 1)
        self.below = below
        split = QSplitter(Qt.Orientation.Vertical)
        beside = QSplitter(Qt.Orientation.Horizontal)
        self.beside = beside
        self.plan: Any = None  # charts are slow to import
        beside.addWidget(self.table)
        self.to_do = Card(tr("To do"), first=True)
        self.action = RichLabel()
        self.action.setWordWrap(True)
        self.action.linkActivated.connect(lambda k: self.picked.emit(int(k)))
        self.to_do.inside.addWidget(self.action)
        split.addWidget(beside)
        split.addWidget(below)
        self.split = split
        split.setVisible(False)
        layout = QVBoxLayout(self)
        layout.addWidget(self.heading)
        layout.addWidget(self.words)
        layout.addWidget(split, 1)
        layout.addWidget(self.to_do)
        self.to_do.hide()
        layout.addStretch(0)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tables from a result; the row of the wall is marked."""
        self.shown = (result, wall)
        self.split.setVisible(True)
        self.words.setText(tr("Lowest ζ first. Click the name of a wall to open it."))
        self._show_heading(result)
        self._show_action(result)
        rows, colors = [], []
        verdicts = {verdict.governing: verdict for verdict in result.verdicts}
        deciding = [verdict.governing for verdict in result.verdicts] or range(len(result.walls))
        self.order = sorted(deciding, key=lambda k: self._rank(result.walls[k]), reverse=self.falling)
        for k in self.order:
            rows.append(self._row(result.walls[k], verdicts.get(k), result))
            shade = verdict_color(result, result.walls[k]) if result.walls[k].assessment else None
            colors.append([None, None, shade, shade] + [None] * (len(rows[-1]) - 4))
        for column in range(RISK, self.table.columnCount()):  # what no wall has takes no room
            self.table.setColumnHidden(column, all(row[column] == "–" for row in rows))
        self.table.show_rows(rows, colors)
        self._show_bars(result)
        shown = next((k for k in self.order if result.walls[k].part.origin == wall.part.origin), None)
        if shown is not None:
            self.table.selectRow(self.order.index(shown))
        self._show_plan(result)
        pairs = compare_walls(result.verdicts)
        self.below.setVisible(bool(pairs))
        self.pairs.show_table(variants_of_walls(Words(self.language), result), pairs)

    def _show_heading(self, result: StudyResult) -> None:
        """How many walls have each outcome, in the colour of the worst."""
        deciding = [result.walls[verdict.governing] for verdict in result.verdicts]
        self.heading.setVisible(bool(deciding))
        if not deciding:
            return
        codes = Counter(require_value(wall.assessment).verdict.code for wall in deciding)
        counted = ", ".join(f"{word(code, self.language)}: {codes[code]}" for code in OUTCOMES if code in codes)
        tones = {tone_of(result, wall) for wall in deciding}
        worst = next(tone for tone in ("bad", "amber", "good") if tone in tones)
        self.heading.setText(
            localized("report", "Walls: {n}; {counted}.", self.language, n=len(deciding), counted=counted)
        )
        shade = getattr(theme.current, worst)
        self.heading.setStyleSheet(f"{theme.font_points(HEADING)} font-weight: 700; color: {shade};")

    def _show_action(self, result: StudyResult) -> None:
        """What is to be done for most walls, with the walls it is of, and how much else there is."""
        found = collect_actions(result, [answer.verdict for answer in answers_worst_first(result)])
        self.to_do.setVisible(bool(found))
        if not found:
            return
        first = next(action for action, walls in found.items() if len(walls) == len(max(found.values(), key=len)))
        words = html.escape(say_in_window(first).text(self.language, names_in(self.language)), quote=False)
        names = ", ".join(link(str(each.governing), html.escape(wall_title(each.title))) for each in found[first])
        left = len(found) - 1
        more = [tr("and {n} more, at its wall", n=left)] if left else []
        title = f"<span style='{theme.font_points(TITLE_POINTS)} font-weight: 600'>{words}</span>"
        self.action.setText("<br>".join([title, names, *more]))

    def _show_bars(self, result: StudyResult) -> None:
        """zeta of each wall as a bar."""
        target = 1.0 if result.demand is None else result.demand.zeta_target
        for row, k in enumerate(self.order):
            assessment = result.walls[k].assessment
            if assessment is not None and (item := self.table.item(row, ZETA)) is not None:
                shade = verdict_color(result, result.walls[k])
                item.setData(Qt.ItemDataRole.UserRole, ZetaMark(assessment.verdict.zeta_e or 0.0, target, shade))

    def _show_plan(self, result: StudyResult) -> None:
        """The key plan, where walls have a place in one."""
        if self.plan is None:
            if not any(wall.plan for wall in result.case.wall[:MOST_IN_PLAN]):
                return
            from app.views.plan_chart import PlanChart

            self.plan = PlanChart()
            self.plan.picked.connect(self.picked)
            self.plan.setMinimumWidth(300)
            self.beside.addWidget(self.plan)
            self.beside.setSizes(WIDTHS)
        self.plan.setVisible(self.plan.show_result(result))

    def _row(
        self, wall: WallResult, verdict: WallVerdict | None = None, result: StudyResult | None = None
    ) -> list[str]:
        """A wall by the hinge that decides about it. verdict, result : None before all its hinges are known"""
        values, language = values_of(wall, verdict, result), self.language
        risk, index = verdict.risk if verdict else None, values.get("is_v")
        return [
            wall_title(values["name"]),
            word(values["mechanism"], language),
            digits(values["zeta_e"]),
            word(values["verdict"], language) if values["verdict"] else "–",
            self._hangs_on(Answer(result, verdict)) if verdict and result else "–",
            method_of(wall, language),
            digits(values.get("pga_c_g"), 3),
            (risk.years if risk else None) or "–",
            "–" if index is None else f"{number(index, '.2f')} {values['is_v_letter']}",
            *(digits(values.get(state)) for state in LIMIT_STATES),
        ]

    def _hangs_on(self, answer: Answer) -> str:
        """The first measure of a wall that fails, else the input that costs most, with zeta at its other end."""
        thing = answer.hangs_on
        if isinstance(thing, Measure):
            return thing.short.text(self.language)
        if thing is not None:
            other_end = format_value(thing, thing.other_end, self.language)
            return f"{word(f'key_{thing.key}', self.language)}, {other_end}: ζ {digits(thing.zeta)}"
        return sentence("short", "no_measure").text(self.language) if answer.verdict.measures == () else "–"

    def _rank(self, wall: WallResult) -> tuple:
        """By the column chosen: numbers by their size, words as they are shown, what has none last."""
        result, verdict = self.shown[0] if self.shown else None, self._verdict_of(wall)
        value = values_of(wall, verdict, result).get(KEYS[self.by])
        if isinstance(value, str) or KEYS[self.by] == HANGS_ON:
            return self.falling, 0.0, self._row(wall, verdict, result)[self.by]
        return (value is None) != self.falling, value or 0.0, ""

    def _verdict_of(self, wall: WallResult) -> WallVerdict | None:
        if self.shown is None:
            return None
        result = self.shown[0]
        return next((verdict for verdict in result.verdicts if result.walls[verdict.governing] is wall), None)

    def _sort(self, column: int) -> None:
        self.falling = not self.falling if column == self.by else False
        self.by = column
        if self.shown:
            self.show_wall(*self.shown)

    def show_running(self, walls: list[WallResult], zetas: dict[int, tuple[float | None, bool]]) -> None:
        """What is known while others run: of each wall the worst result that is there, no verdict before all are.
        zetas : row of a wall -> (zeta so far, whether all its results are there)"""
        self.split.setVisible(True)
        self.heading.hide()
        self.to_do.hide()
        self.below.setVisible(False)
        if self.plan is not None:
            self.plan.hide()
        self.order, self.shown = [], None  # a click on a title is not to bring back the result before
        self.finished = sum(whole for _, whole in zetas.values())
        self.words.setText(tr("Running, walls finished: {n}", n=self.finished))
        rows, worst = [], worst_so_far(walls)
        for wall in worst:
            rows.append(self._row(wall, None, None))
            if not zetas[wall.part.origin][1]:
                rows[-1][ZETA : ZETA + 2] = [f"≤ {rows[-1][ZETA]}", "…"]
        self.finished_rows = [wall.part.origin for wall in worst]
        self.table.show_rows(rows, [[None] * len(row) for row in rows])

    def say_cancelled(self) -> None:
        """The walls of `show_running` are all there will be."""
        self.words.setText(tr("Cancelled, walls finished: {n}. F5 goes on from here.", n=self.finished))

    def _picked(self, row: int) -> None:
        if row < len(self.order):
            self.picked.emit(self.order[row])
        elif not self.order and row < len(self.finished_rows):
            self.row_picked.emit(self.finished_rows[row])
