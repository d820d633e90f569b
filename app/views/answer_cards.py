"""The parts of the answer below its bars: what is to be done, what costs most if it is not so, and a drawer of the
rest."""

import html
from typing import NamedTuple

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QCheckBox, QFrame, QGridLayout, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from app.look import theme
from app.look.labels import PlainLabel, RichLabel
from app.look.language import tr
from app.views.answer_lines import link, required_actions
from app.views.zeta_rungs import digits
from core.case.register import LOOKED_AT, NOT_LOOKED_AT, NOT_POSSIBLE, SET_ASIDE
from core.codes.assumption import Assumption, format_value
from core.codes.outcomes import OUTCOMES
from core.known import require_value
from core.study.register import Looked, make_register
from core.study.results import StudyResult, WallResult, WallVerdict
from core.text.sentence import Sentence, format_number, localized, word

CARD = "QFrame#card {{ background: {back}; border: {edge}; border-radius: 6px; }}"
"""Style of a card, its edge that of what is to be done first."""

TITLE_POINTS, SMALL = 1.2, 0.88
"""Sizes of the title and of the label of a card beside that of the other words."""

LINKS = (
    Qt.TextInteractionFlag.LinksAccessibleByMouse
    | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
    | Qt.TextInteractionFlag.TextSelectableByMouse
)
"""What a label lets a reader do."""

CELLS_IN_ROW = 6
"""Openers of the drawer beside each other."""


class Card(QFrame):
    """A field of its own with a quiet label above what it holds. first : what is to be done stands in it"""

    def __init__(self, label: str, first: bool = False):
        super().__init__()
        self.setObjectName("card")
        edge = f"2px solid {theme.current.ink}" if first else "none"
        self.setStyleSheet(CARD.format(back=theme.current.back, edge=edge))
        self.inside = QVBoxLayout(self)
        self.inside.setContentsMargins(12, 8, 12, 8)
        self.inside.setSpacing(3)
        self.label = PlainLabel(label)
        self.label.setStyleSheet(f"color: {theme.current.quiet}; {theme.font_points(SMALL)}")
        if label:
            self.inside.addWidget(self.label)


class ToDoCard(Card):
    """What is to be done, each line a link. asked(what) : of `CheckTab`"""

    asked = Signal(str)

    def __init__(self):
        super().__init__(tr("To do"), first=True)
        self.words = RichLabel()
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(LINKS)
        self.words.setAccessibleName(tr("To do"))
        self.words.linkActivated.connect(self.asked)
        self.inside.addWidget(self.words)
        self.inside.addStretch(1)

    def show_actions(self, result: StudyResult, wall: WallResult, language: str, blocking: list[str]) -> None:
        """blocking : what makes the outcome indicative and is no action of its own, as HTML"""
        lines = [*required_actions(result, wall, language, alone=True), *blocking]
        first, *rest = sorted(lines, key=lambda line: "<a href" not in line) or [""]  # what leads somewhere is first
        # Shift+Tab never leaves a label that begins with a link (Qt 6.10): nothing to be seen stands before it
        title = f"&#8203;<span style='{theme.font_points(TITLE_POINTS)} font-weight: 600'>{first}</span>"
        self.words.setText("<br>\n".join([title, *rest]))
        self.setVisible(bool(first))


class CostCard(Card):
    """The assumption whose other end costs most, with a switch to it. turned(row) : None back to what is given"""

    turned = Signal(object)

    def __init__(self):
        super().__init__(tr("Costs most if it is not so"))
        self.title, self.shown_by = PlainLabel(), PlainLabel()
        self.title.setStyleSheet(f"font-weight: 600; {theme.font_points(TITLE_POINTS)}")
        self.shown_by.setStyleSheet(f"color: {theme.current.quiet};")
        for label in (self.title, self.shown_by):
            label.setWordWrap(True)
            self.inside.addWidget(label)
        self.switch = QCheckBox()
        self.switch.toggled.connect(lambda on: self.turned.emit(None if on else self.row))
        self.inside.addWidget(self.switch)
        self.inside.addStretch(1)
        self.row: Assumption | None = None

    def show_row(self, row: Assumption | None, zeta: float | None, language: str) -> None:
        """zeta : of the wall as it is given"""
        self.row = row
        self.setVisible(row is not None)
        self.switch.blockSignals(True)
        self.switch.setChecked(True)
        self.switch.blockSignals(False)
        if row is None:
            return
        taken, instead = format_value(row, row.value, language), format_value(row, row.other_end, language)
        self.title.setText(f"{word(f'key_{row.key}', language)}: {taken}")
        reason = row.reason.text(language) if isinstance(row.reason, Sentence) else row.reason
        self.shown_by.setText(tr("Shown: {reason}", reason=reason) if reason else tr("No document shows it."))
        outcome = word(row.outcome, language)
        values = {"zeta": digits(zeta), "instead": instead, "lower": digits(row.zeta), "outcome": outcome}
        self.switch.setText(tr("so: ζ {zeta}     {instead}: ζ {lower}, {outcome}", **values))


class Fact(NamedTuple):
    """An opener of the drawer: its label, what it says at a glance, and the lines behind it, as HTML."""

    label: str
    value: str
    lines: list[str]


class Drawer(QWidget):
    """Facts beside each other, each a button that opens what is behind it. asked(what) : of `CheckTab`"""

    asked = Signal(str)

    def __init__(self):
        super().__init__()
        self.grid = QGridLayout()
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.panel = RichLabel()
        self.panel.setWordWrap(True)
        self.panel.setTextInteractionFlags(LINKS)
        self.panel.linkActivated.connect(self.asked)
        self.panel.hide()
        self.facts: list[Fact] = []
        self.buttons: list[QPushButton] = []
        self.cells: list[QWidget] = []
        self.columns = CELLS_IN_ROW
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 4, 0, 0)
        column.addLayout(self.grid)
        column.addWidget(self.panel)

    def show_facts(self, facts: list[Fact]) -> None:
        """Those behind which there is nothing only say what they say."""
        for cell in self.cells:
            self.grid.removeWidget(cell)
            cell.hide()
            cell.deleteLater()
        self.facts, self.buttons, self.cells = facts, [], []
        self.panel.hide()
        for k, fact in enumerate(facts):
            cell, button = QWidget(), QPushButton(f"{fact.value}{' ▸' if fact.lines else ''}")
            label = PlainLabel(fact.label)
            label.setStyleSheet(f"color: {theme.current.quiet}; padding: 0 4px; {theme.font_points(SMALL)}")
            button.setFlat(True)
            button.setAccessibleName(f"{fact.label}: {fact.value}")
            button.setCheckable(bool(fact.lines))
            style = f"color: {theme.current.ink}; text-align: left; padding: 1px 4px; font-weight: 600;"
            button.setStyleSheet(f"QPushButton {{ {style} }}")
            button.toggled.connect(lambda on, k=k: self._open(k, on))
            inside = QVBoxLayout(cell)
            inside.setContentsMargins(0, 0, 0, 0)
            inside.setSpacing(0)
            inside.addWidget(label)
            inside.addWidget(button)
            self.buttons.append(button)
            self.cells.append(cell)
        self._place()

    def _place(self) -> None:
        """As many cells beside each other as there is room for."""
        widest = max((cell.sizeHint().width() for cell in self.cells), default=1)
        columns = min(CELLS_IN_ROW, max(1, self.width() // (widest + self.grid.horizontalSpacing())))
        if columns == self.columns and self.grid.count() == len(self.cells):
            return
        self.columns = columns
        for k, cell in enumerate(self.cells):
            self.grid.addWidget(cell, k // columns, k % columns)
        self.updateGeometry()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self._place()

    def minimumSizeHint(self) -> QSize:
        """As narrow as its widest cell."""
        widest = max((cell.sizeHint().width() for cell in self.cells), default=1)
        return QSize(widest, super().minimumSizeHint().height())

    def _open(self, k: int, on: bool) -> None:
        for n, button in enumerate(self.buttons):
            if n != k and on:
                button.setChecked(False)
        if on:
            self.panel.setText("<br>\n".join(self.facts[k].lines))
        self.panel.setVisible(any(button.isChecked() for button in self.buttons))

    @property
    def words(self) -> str:
        """All that is behind the openers."""
        return "\n".join(line for fact in self.facts for line in fact.lines)


def mechanism_lists(result: StudyResult, verdict: WallVerdict, language: str) -> str:
    """The mechanisms of a wall in three lists: looked at, not possible, not looked at, as HTML. Why something is not
    possible stands in the tip."""
    rows = make_register(result, verdict)
    looked = [row for row in rows if row.row.status == LOOKED_AT]
    lists = (
        (LOOKED_AT, " · ".join(_looked_words(looked, result.walls[verdict.governing], language))),
        (NOT_POSSIBLE, _names(rows, NOT_POSSIBLE, language)),
        (SET_ASIDE, _names(rows, SET_ASIDE, language)),
        (NOT_LOOKED_AT, _left_words(rows, language)),
    )
    cells = "".join(
        f"<tr><td style='color:{theme.current.quiet}; padding-right: 14px; white-space: nowrap'>"
        f"{html.escape(localized('mechanism', status, language))}</td><td>{words}</td></tr>"
        for status, words in lists
        if words
    )
    return f"<table>{cells}</table>"


MOST_LOOKED = 6
"""Mechanisms that are looked at of which zeta is written, the worst first."""


def _looked_words(looked: list[Looked], decides: WallResult, language: str) -> list[str]:
    """What is looked at, each with its zeta in the colour of its outcome, what decides in bold; of one name the first
    alone with it."""
    words, before = [], ""
    ordered = sorted(looked, key=lambda each: each.result is not decides)
    for each in ordered[:MOST_LOOKED]:
        row, verdict = each.row, require_value(each.result).required_assessment.verdict
        name = localized("mechanism", row.name, language)
        where = f"+{format_number(row.low, '.3g', language)}"
        if row.hinge is None:
            where = f"{format_number(row.low, '.3g', language)}–{format_number(row.high, '.3g', language)}"
        shade = QColor(getattr(theme.current, OUTCOMES[verdict.code].tone)).name()
        zeta = f"<b style='color:{shade}'>{digits(verdict.zeta_e)}</b>"
        head = "" if name == before else f"{html.escape(name)} "
        told = f"{head}{where} m {zeta}"
        words.append(f"<b>{told}</b>" if each.result is decides else told)
        before = name
    left = len(ordered) - MOST_LOOKED
    return [*words, tr("{n} more", n=left)] if left > 0 else words


def _names(rows: list[Looked], status: str, language: str) -> str:
    """Names of the mechanisms of a status."""
    names = dict.fromkeys(localized("mechanism", each.row.name, language) for each in rows if each.row.status == status)
    return html.escape(", ".join(names))


def _left_words(rows: list[Looked], language: str) -> str:
    """What is not looked at, with where it is given."""
    names = _names(rows, NOT_LOOKED_AT, language)
    return f"{names} {link('holds', tr('give what is missing'))}" if names else ""


def lay_out_row(*widgets: QWidget) -> QHBoxLayout:
    """Cards beside each other."""
    row = QHBoxLayout()
    row.setSpacing(10)
    for widget in widgets:
        row.addWidget(widget, 1)
    return row
