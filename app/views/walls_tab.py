"""The tab Overview: every wall of the study, the lowest zeta first, and walls before beside walls after."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSplitter, QVBoxLayout, QWidget

from app.look.labels import Plain
from app.look.language import called, number, tr
from app.views.check_tab import digits, verdict_color
from app.views.result_tab import ResultTab
from app.views.table import Table
from core.report.verdict_words import outcome_of
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.variants import WallComparison, wall_comparisons
from core.text.sentence import word
from core.units import G
from core.variation.limit_states import STATES

ZETA, RISK = 2, 6
"""Column of zeta, and first one of what a mechanism withstands."""


def steps() -> list[str]:
    """How to begin, in three steps."""
    return [
        tr("1. Walls: dimensions, mechanism, what stands behind them (+ wall below the tree, or table… for many)."),
        tr("2. Demand: a_g, spectrum, confidence factor; records: drop files, or Generate…"),
        tr("3. F5. Then this overview, the answer of each wall, and File → Export."),
    ]


def zeta_of(wall: WallResult) -> float | None:
    """zeta of the check that decides."""
    return wall.assessment.verdict.zeta_e if wall.assessment else None


def method_of(wall: WallResult, language: str) -> str:
    """The check that decides, in words."""
    found = wall.assessment
    if found is None:
        return "–"
    labels = [check.label for check in found.checks if check.name == found.verdict.governing]
    return word(labels[0], language) if labels else "–"


class WallsTab(ResultTab):
    """One row a wall and mechanism. picked(k) : the row of the result's k-th wall was clicked twice, its name once."""

    picked = Signal(int)

    def __init__(self, language: str):
        super().__init__()
        self.language = language
        self.order: list[int] = []
        self.shown: tuple[StudyResult, WallResult] | None = None
        self.by, self.falling = ZETA, False
        self.words = Plain(tr("No result yet: press F5.") + "\n\n" + "\n".join(steps()))
        self.words.setWordWrap(True)
        self.table = Table(
            tr("Walls of the study"),
            [
                tr("Wall"),
                tr("Mechanism"),
                "ζ",
                tr("Outcome"),
                tr("by"),
                "q",
                "PGA_C [g]",
                "T_R,C",
                "IS-V",
                *(f"ζ {state}" for state in STATES),
            ],
        )
        self.table.cellDoubleClicked.connect(lambda row, _: self._picked(row))
        self.table.cellClicked.connect(lambda row, column: self._picked(row) if column == 0 else None)
        self.table.setToolTip(tr("Click the name of a wall to open it, a column title to sort."))
        self.table.horizontalHeader().setSectionsClickable(True)
        self.table.horizontalHeader().sectionClicked.connect(self._sort)
        self.pairs = Table(
            tr("Before and after"),
            [
                tr("Wall"),
                *(tr("before"), tr("ζ before"), tr("by")),
                *(tr("after"), tr("ζ after"), tr("by")),
                tr("changed"),
            ],
        )
        self.pairs_title = Plain(tr("Before and after"))
        below = QWidget()
        inside = QVBoxLayout(below)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.addWidget(self.pairs_title)
        inside.addWidget(self.pairs, 1)
        self.below = below
        split = QSplitter(Qt.Orientation.Vertical)
        split.addWidget(self.table)
        split.addWidget(below)
        self.split = split
        split.setVisible(False)
        layout = QVBoxLayout(self)
        layout.addWidget(self.words)
        layout.addWidget(split, 1)
        layout.addStretch(0)

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Fill the tables from a result; the row of the wall is marked."""
        self.shown = (result, wall)
        self.split.setVisible(True)
        self.words.setText(tr("Lowest ζ first. Click the name of a wall to open it."))
        rows, colors = [], []
        verdicts = {one.governing: one for one in result.verdicts}
        deciding = [one.governing for one in result.verdicts] or range(len(result.walls))
        self.order = sorted(deciding, key=lambda k: self._rank(result.walls[k]), reverse=self.falling)
        for k in self.order:
            rows.append(self._row(result.walls[k], verdicts.get(k)))
            shade = verdict_color(result, result.walls[k]) if result.walls[k].assessment else None
            colors.append([None, None, shade, shade] + [None] * (len(rows[-1]) - 4))
        for column in range(RISK, self.table.columnCount()):  # what no wall has takes no room
            self.table.setColumnHidden(column, all(row[column] == "–" for row in rows))
        self.table.show_rows(rows, colors)
        shown = next((k for k in self.order if result.walls[k].part.origin == wall.part.origin), None)
        if shown is not None:
            self.table.selectRow(self.order.index(shown))
        found = wall_comparisons(result.verdicts)
        self.below.setVisible(bool(found))
        self.pairs.show_rows([self._pair(result, one) for one in found])

    def _row(self, wall: WallResult, verdict: WallVerdict | None = None) -> list[str]:
        """A wall by the hinge that decides about it. verdict : of the wall, None before all its hinges are known"""
        found, language = wall.assessment, self.language
        risk = verdict.risk if verdict else None
        states = {state: one.zeta for state, one in verdict.states.items()} if verdict else {}
        return [
            called(wall.name),
            word(wall.mechanism, language),
            digits(zeta_of(wall)),
            word(found.verdict.code, language) if found else "–",
            method_of(wall, language),
            digits(wall.q_set),
            digits(risk.pga / G, 3) if risk else "–",
            (risk.years if risk else None) or "–",
            f"{number(risk.index, '.2f')} {risk.letter}" if risk and risk.index is not None else "–",
            *(digits(states.get(state)) for state in STATES),
        ]

    def _pair(self, result: StudyResult, one: WallComparison) -> list[str]:
        language = self.language
        changed = ", ".join(word(f"key_{key}", language) for key in one.changed) or tr("nothing")
        row = [called(one.name)]
        for verdict in (one.before, one.after):
            code, label = outcome_of(result, verdict)
            row += [word(code, language), digits(verdict.zeta_least), word(label, language) if label else "–"]
        return [*row, changed]

    def _rank(self, wall: WallResult) -> tuple:
        """By the column chosen: numbers by their size, what has none last."""
        if self.by == ZETA:
            value = zeta_of(wall)
        else:
            word_or_number = self._row(wall, self._verdict_of(wall))[self.by]
            try:
                value = float(word_or_number.split()[0].replace(",", "."))
            except ValueError:
                return (word_or_number == "–", 0.0, word_or_number)
        return (value is None) != self.falling, value or 0.0, ""

    def _verdict_of(self, wall: WallResult) -> WallVerdict | None:
        if self.shown is None:
            return None
        result = self.shown[0]
        return next((one for one in result.verdicts if result.walls[one.governing] is wall), None)

    def _sort(self, column: int) -> None:
        self.falling = not self.falling if column == self.by else False
        self.by = column
        if self.shown:
            self.show_wall(*self.shown)

    def show_running(self, walls: list[WallResult], zetas: dict[int, tuple[float | None, bool]]) -> None:
        """What is known while others run: of each wall the worst result that is there, no verdict before all are.
        zetas : row of a wall -> (zeta so far, whether all its results are there)"""
        self.split.setVisible(True)
        self.below.setVisible(False)
        self.order = []
        self.words.setText(tr("Running, walls finished: {n}", n=sum(whole for _, whole in zetas.values())))
        rows, seen = [], set()
        for wall in sorted(walls, key=lambda wall: (zeta_of(wall) is None, zeta_of(wall) or 0.0)):
            k = wall.part.origin
            if k in seen:
                continue
            seen.add(k)
            rows.append(self._row(wall))
            if not zetas[k][1]:
                rows[-1][ZETA : ZETA + 2] = [f"≤ {rows[-1][ZETA]}", "…"]
        self.table.show_rows(rows, [[None] * len(row) for row in rows])

    def _picked(self, row: int) -> None:
        if row < len(self.order):
            self.picked.emit(self.order[row])
