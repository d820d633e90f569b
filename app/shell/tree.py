"""The tree of the project: what can be given and what was found, each with a chip."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPalette
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QStyle,
    QStyledItemDelegate,
    QToolButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.input.wall_text import differences
from app.look import theme
from app.look.labels import escape_html
from app.look.language import number, result_word, tr, variant_word
from core.answer.answer import worst_row
from core.case.problems import wall_of
from core.case.schema import Case
from core.errors import InputError
from core.known import require_value
from core.report.verdict_words import tone_of
from core.study.results import StudyResult, WallResult

TREE_WIDTH, WIDE_TREE_WIDTH = 216, 280
"""Width of the tree in a window of 1280 and of 1920 [px]."""

MAX_SHARE_OF_WINDOW = 0.20
"""Share of the width of the window that the tree takes for the words of its first level."""

WIDE_FROM = 1600
"""Width of the window from which the tree is wide [px]."""

TO_COME, ROW_SEPARATOR = "…", "  "
"""In the place of a number to come; between the name of a row and what it says."""


@dataclass(frozen=True)
class Row:
    """A row of the tree.

    kind : demand, records, building, walls, wall, hinge, report, group (walls of one name)
    chip, tone : what the chip says and its colour, good, amber, bad or quiet
    wall : row of the wall in the case; result : index of the result it shows, None where there is none
    """

    depth: int
    kind: str
    text: str
    chip: str = ""
    tone: str = "quiet"
    wall: int = -1
    result: int | None = None

    @property
    def key(self) -> tuple:
        """What is the same row after a change."""
        named = self.kind in ("hinge", "group")
        return (self.kind, -1 if self.kind == "group" else self.wall, self.text if named else "")


@dataclass(frozen=True)
class State:
    """What the tree shows.

    of_row(row) : indices of the results of a wall of the case, the one that decides first
    unread : whether a record in use cannot be read; motions : records in use
    finished : while something runs, of each wall the zeta so far and whether all its results are there; else None
    """

    case: Case
    result: StudyResult | None
    stale: bool
    problems: Sequence[InputError]
    motions: int
    unread: bool
    of_row: dict[int, list[int]]
    finished: dict[int, tuple[float | None, bool]] | None = None


def rows_of(state: State) -> list[Row]:
    """The rows in their order."""
    case = state.case
    sections = {error.section or "" for error in state.problems if error.wall is None}
    walls = {wall_of(case, error) for error in state.problems}

    def mark(*names: str) -> tuple[str, str]:
        return (
            ("!", "amber") if any(section.startswith(name) for section in sections for name in names) else ("", "quiet")
        )

    demand = f"{tr('Demand')}{ROW_SEPARATOR}{case.demand.limit_state}" if case.demand else tr("Demand: none")
    compliance = state.result.compliance if state.result and not state.stale else None
    records, tone = ("✓", "good") if compliance and compliance.compatible else ("", "quiet")
    if state.unread:
        records, tone = "!", "bad"
    building = tr("storeys: {n}", n=case.building.storeys) if case.building else tr("none")
    rows = [
        Row(0, "demand", demand, *mark("[demand")),
        Row(0, "records", f"{tr('Records')}{ROW_SEPARATOR}{state.motions}", records, tone),
        Row(0, "building", f"{tr('Building')}{ROW_SEPARATOR}{building}", *mark("[building")),
        Row(0, "walls", tr("Walls"), "" if case.wall else "!", "amber"),
        *_walls(state, walls),
    ]
    if case.report.author:
        return [*rows, Row(0, "report", tr("Report"))]
    return [*rows, Row(0, "report", f"{tr('Report')}{ROW_SEPARATOR}{tr('author missing')}", "!", "amber")]


def _walls(state: State, broken: set[int | None]) -> Iterable[Row]:
    walls = state.case.wall
    of_name: dict[str, list[int]] = {}
    for k, wall in enumerate(walls):
        of_name.setdefault(wall.name, []).append(k)
    for name, alike in of_name.items():
        if len(alike) == 1:
            yield _wall(state, alike[0], name, 1, broken)
            yield from _hinges(state, alike[0], 2)
            continue
        worst = _worst(state, alike)
        group = _wall(state, worst, name, 1, broken)
        yield Row(1, "group", name, group.chip, group.tone, worst, group.result)
        for k in alike:
            words = ", ".join(differences(state.case, walls[k]))
            variant = variant_word(walls[k].variant) or name
            yield _wall(state, k, f"{variant}: {words}" if words else variant, 2, broken)
            yield from _hinges(state, k, 3)


def _worst(state: State, alike: list[int]) -> int:
    """The row that a group shows: of variants the one with the worst answer, while they run that which is there."""
    if state.finished is not None:
        return next((k for k in alike if k in require_value(state.finished)), alike[0])
    worst = worst_row(state.result, alike) if state.result else None
    return alike[0] if worst is None else worst


def _wall(state: State, k: int, text: str, depth: int, broken: set[int | None]) -> Row:
    if state.finished is not None:
        zeta, whole = state.finished.get(k, (None, False))
        chip = number(zeta, ".2f") if whole else TO_COME if zeta is None else f"≤ {number(zeta, '.2f')}"
        return Row(depth, "wall", text, chip, "quiet", k)
    if k in broken:
        return Row(depth, "wall", text, "!", "amber", k)
    results = state.of_row.get(k, [])
    if state.result is None or not results:
        return Row(depth, "wall", text, wall=k)
    return Row(depth, "wall", text, *_chip(state, results[0]), wall=k, result=results[0])


def _chip(state: State, k: int) -> tuple[str, str]:
    """What a result comes to, and its colour; grey where it is of an earlier input."""
    result = require_value(state.result)
    wall = result.walls[k]
    if wall.assessment is None:
        return (f"q {number(wall.q_set, '.2f')}" if wall.q_set else "–"), "quiet"
    zeta = wall.assessment.verdict.zeta_e
    shown = "–" if zeta is None else number(zeta, ".2f")
    return shown, "quiet" if state.stale else tone_of(result, wall)


def hinge_text(wall: WallResult) -> str:
    """Where a result turns, and how."""
    if (arch := wall.wall.in_si.arch) is not None:
        return f"L {number(arch.spacing, 'g')} m, {result_word(wall.mechanism)}"
    ends = [round(height, 2) for height in (wall.part.hinge, wall.part.top) if height is not None]
    where = f"+{'–'.join(number(end, 'g') for end in ends)} m, {result_word(wall.mechanism)}"
    return f"{wall.part.aspect}, {where}" if wall.part.aspect else where


def _hinges(state: State, k: int, depth: int) -> Iterable[Row]:
    results = state.of_row.get(k, [])
    if state.result is None or state.finished is not None or len(results) < 2:
        return
    walls = state.result.walls
    for n in sorted(results, key=lambda n: (walls[n].part.aspect, walls[n].part.hinge, walls[n].mechanism)):
        text = hinge_text(walls[n])
        yield Row(depth, "hinge", text, *_chip(state, n), wall=k, result=n)


def chip_width(font: QFont, words: str) -> float:
    return max(28.0, QFontMetricsF(font).horizontalAdvance(words) + 16)


class Chips(QStyledItemDelegate):
    """Paints a row with its chip at the right."""

    def sizeHint(self, option, index) -> QSize:
        return QSize(60, round(1.75 * option.fontMetrics.height()))

    def paint(self, painter: QPainter, option, index) -> None:
        """The mark of the chosen row, the chip, then the words in what room is left."""
        row: Row = index.data(Qt.ItemDataRole.UserRole)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(option.rect)
        if option.state & QStyle.StateFlag.State_Selected:
            shade = QColor(theme.current.curves[0])
            shade.setAlpha(45)
            painter.fillRect(area, shade)
            painter.fillRect(QRectF(0, area.top(), 3, area.height()), QColor(theme.current.curves[0]))
        if option.state & QStyle.StateFlag.State_HasFocus:
            painter.setPen(QColor(theme.current.curves[0]))
            painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5))
        font = option.font
        font.setBold(row.depth == 0)
        right = area.right() - 4
        chip_words = theme.add_tone_mark(row.tone, row.chip)
        if chip_words:
            font.setBold(True)
            painter.setFont(font)
            wide = chip_width(font, chip_words)
            chip = QRectF(right - wide, area.center().y() - 0.68 * option.fontMetrics.height(), wide, 0)
            chip.setHeight(1.36 * option.fontMetrics.height())
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(getattr(theme.current, row.tone)))
            painter.drawRoundedRect(chip, 9, 9)
            painter.setPen(QColor(theme.current.back))
            painter.drawText(chip, Qt.AlignmentFlag.AlignCenter, chip_words)
            right = chip.left() - 4
            font.setBold(row.depth == 0)
        painter.setFont(font)
        painter.setPen(QColor(theme.current.ink))
        room = right - area.left() - 4
        metrics, text = QFontMetricsF(font), row.text
        if metrics.horizontalAdvance(text) > room and row.depth == 0:  # without what follows the name, not with half
            text = text.split(ROW_SEPARATOR)[0]
        text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, room)
        painter.drawText(QRectF(area.left() + 4, area.top(), room, area.height()), Qt.AlignmentFlag.AlignVCenter, text)
        painter.restore()


class Item(QTreeWidgetItem):
    """A row in its place: another row there costs no signals, which of 200 walls are half of a key's time."""

    def __init__(self, row: Row):
        super().__init__()
        self.row = row

    def data(self, column: int, role: int) -> object:
        """Its words, with those of its chip: for a screen reader, the delegate paints."""
        if role == Qt.ItemDataRole.UserRole:
            return self.row
        if role == Qt.ItemDataRole.DisplayRole:
            return f"{self.row.text} {theme.add_tone_mark(self.row.tone, self.row.chip)}".strip()
        return escape_html(self.row.text) if role == Qt.ItemDataRole.ToolTipRole else super().data(column, role)


class ProjectTree(QFrame):
    """The tree and the buttons that add to it. chosen(row) : a Row was chosen by mouse or key"""

    chosen = Signal(object)

    def __init__(self):
        super().__init__()
        self.rows: list[Row] = []
        self.items: list[Item] = []
        self.tree = QTreeWidget()
        self.tree.setUniformRowHeights(True)
        self.tree.setHeaderHidden(True)
        self.tree.setIndentation(13)
        self.tree.setItemDelegate(Chips(self.tree))
        self.tree.setAccessibleName(tr("Project"))
        self.tree.setFrameShape(QFrame.Shape.NoFrame)
        plain = QPalette(self.tree.palette())
        plain.setColor(QPalette.ColorRole.Highlight, QColor(theme.current.back))  # the delegate marks what is chosen
        self.tree.setPalette(plain)
        self.tree.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.tree.currentItemChanged.connect(self._changed)
        self.tree.itemClicked.connect(lambda item, _: self.chosen.emit(item.data(0, Qt.ItemDataRole.UserRole)))
        self.buttons = QWidget()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.tree, 1)
        layout.addWidget(self.buttons)
        self.least, self.window_width = TREE_WIDTH, 0
        self.filling = False

    def set_buttons(self, buttons: Sequence[tuple]) -> None:
        """Buttons below the tree: (label, tip, slot) of each, three a line, two where their words are long."""
        column = QVBoxLayout(self.buttons)
        column.setContentsMargins(4, 4, 4, 4)
        column.setSpacing(2)
        made = []
        for label, tip, slot in buttons:
            button = QToolButton()
            button.setText(label)
            button.setToolTip(escape_html(tip))
            button.setAutoRaise(True)
            button.clicked.connect(lambda _=False, slot=slot: slot())
            made.append(button)
        for count in (3, 2):
            lines = [made[k : k + count] for k in range(0, len(made), count)]
            wide = max(sum(button.sizeHint().width() + 2 for button in line) for line in lines) + 8
            if wide <= TREE_WIDTH:
                break
        for line in lines:
            row = QHBoxLayout()
            row.setSpacing(2)
            for button in line:
                row.addWidget(button)
            row.addStretch(1)
            column.addLayout(row)
        self.least = wide

    def fit(self, window: int) -> None:
        """As wide as a window of this width [px] gives it, and its buttons and the words of its first level need."""
        self.window_width, font = window, self.tree.font()
        font.setBold(True)
        # not those of the report, or all would move with the first letter of an author
        first = [row.text for row in self.rows if row.depth == 0 and row.kind != "report"]
        words = max((QFontMetricsF(font).horizontalAdvance(text) for text in first), default=0.0)
        around = self.tree.indentation() + chip_width(font, "✓") + 16  # edges, and the chip that may come
        wanted = min(math.ceil(words + around), round(MAX_SHARE_OF_WINDOW * window))
        self.setFixedWidth(max(self.least, WIDE_TREE_WIDTH if window >= WIDE_FROM else TREE_WIDTH, wanted))

    def show_rows(self, rows: list[Row]) -> None:
        """The rows in place of those before; the chosen one stays chosen, what was open stays open."""
        if rows == self.rows:
            return
        alike = [(row.depth, row.key) for row in rows] == [(row.depth, row.key) for row in self.rows]
        before, self.rows = self.current, rows
        self.filling = True
        if alike:
            for item, row in zip(self.items, rows, strict=True):
                item.row = row
        else:
            opened = {item.row.key for item in self.items if item.isExpanded()}
            self.items = []
            self.tree.clear()
            above: list[Item] = []
            for row in rows:
                item = Item(row)
                self.items.append(item)
                del above[row.depth :]
                if above:
                    above[-1].addChild(item)
                else:
                    self.tree.addTopLevelItem(item)
                above.append(item)
                item.setExpanded(row.kind in ("walls", "group") or row.key in opened)
            if before is not None:
                self.select(before.key)
        self.filling = False
        self.fit(self.window_width)
        self.tree.viewport().update()

    @property
    def current(self) -> Row | None:
        item = self.tree.currentItem()
        return item.data(0, Qt.ItemDataRole.UserRole) if item is not None else None

    def select(self, key: tuple) -> None:
        """Choose the row of this key without telling anyone."""
        filling, self.filling = self.filling, True
        for item in self.items:
            if item.row.key == key:
                self.tree.setCurrentItem(item)
        self.filling = filling

    def _changed(self, item, _) -> None:
        """By the keys; a click tells by itself, also of the row that is chosen already."""
        if item is not None and not self.filling and self.tree.hasFocus():
            self.chosen.emit(item.data(0, Qt.ItemDataRole.UserRole))
