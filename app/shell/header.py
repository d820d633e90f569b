"""The bar at the top: menus, title of the case, stages, Run or Cancel, undo, find."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QMenu, QPushButton, QSizePolicy, QToolButton

from app.look import theme
from app.look.labels import PlainLabel, escape_html
from app.look.language import tr

STAGES = ("input", "answer", "why", "report")

MIN_WORDS = 60
"""Least width of the title and of the notice [px]: a screen of 1280 x 800 at 150 % has 853 x 533."""


def stage_names() -> dict[str, str]:
    return {"input": tr("Input"), "answer": tr("Answer"), "why": tr("Why"), "report": tr("Report")}


class Header(QFrame):
    """staged(name) : a stage was chosen; pressed(href) : the notice was clicked"""

    staged = Signal(str)
    noticed = Signal()

    def __init__(self):
        super().__init__()
        chosen, back, edge = theme.current.curves[0], theme.current.back, theme.current.edge
        self.menu_button = QToolButton()
        self.menu_button.setText("☰")
        self.menu_button.setToolTip(tr("Menus (F10)"))
        self.menu_button.setAccessibleName(tr("Menus"))
        self.menu_button.setAutoRaise(True)
        self.menu_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu_button.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        self.menu = QMenu(self.menu_button)
        self.menu_button.setMenu(self.menu)
        QShortcut(QKeySequence("F10"), self).activated.connect(self.menu_button.showMenu)
        self.title = PlainLabel()
        self.title.setStyleSheet(f"font-weight: 600; {theme.font_points(1.2)}")
        self.title.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.title.setMinimumWidth(MIN_WORDS)
        self.stages = QButtonGroup(self)
        self.notice = QPushButton()
        self.notice.setFlat(True)
        self.notice.setStyleSheet(
            f"QPushButton {{ color: {theme.current.amber}; font-weight: 600; padding: 2px 6px; text-align: right; }}"
        )
        # its place is kept: what comes and goes there moves no button
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        policy.setRetainSizeWhenHidden(True)
        self.notice.setSizePolicy(policy)
        self.notice.setMinimumWidth(MIN_WORDS)
        self.notice.clicked.connect(self.noticed)
        self.run_button = QPushButton(tr("Run (F5)"))
        self.cancel_button = QPushButton(tr("Cancel (Esc)"))
        for button, shade in ((self.run_button, theme.current.good), (self.cancel_button, theme.current.amber)):
            button.setStyleSheet(
                f"QPushButton {{ background: {shade}; color: {back}; border: 2px solid {shade}; border-radius: 4px;"
                f" font-weight: 600; padding: 4px 10px; }}"
                f"QPushButton:disabled {{ background: {theme.current.window}; color: {theme.current.quiet};"
                f" border-color: {edge}; }} QPushButton:focus {{ border-color: {chosen}; }}"
            )
        widest = max(self.run_button.sizeHint().width(), self.cancel_button.sizeHint().width())
        for button in (self.run_button, self.cancel_button):
            button.setMinimumWidth(widest)
        self.undo_button, self.find_button, self.help_button = (QToolButton() for _ in range(3))
        for button, label, tip in (
            (self.undo_button, "↶", tr("Undo (Ctrl+Z)")),
            (self.find_button, tr("Find"), tr("Find a field, an action or a wall (Ctrl+K)")),
            (self.help_button, "?", tr("What is this field? (F1)")),
        ):
            button.setText(label)
            button.setToolTip(escape_html(tip))
            button.setAccessibleName(tip)
            button.setAutoRaise(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(6, 4, 8, 4)
        row.setSpacing(6)
        row.addWidget(self.menu_button)
        row.addWidget(self.title, 1)
        self.buttons: dict[str, QPushButton] = {}
        for number, (name, label) in enumerate(stage_names().items(), start=1):
            button = QPushButton(f"{number} {label}")
            button.setCheckable(True)
            button.setToolTip(escape_html(f"{label} (Alt+{number})"))
            button.setStyleSheet(
                f"QPushButton {{ border: 1px solid {edge}; border-radius: 11px; padding: 4px 14px;"
                f" background: {back}; color: {theme.current.ink}; font-weight: 600; }}"
                f"QPushButton:checked {{ background: {chosen}; color: {back}; }}"
                f"QPushButton:focus {{ border: 2px solid {theme.current.ink}; padding: 3px 13px; }}"
            )
            button.clicked.connect(lambda _=False, name=name: self.staged.emit(name))
            self.stages.addButton(button)
            self.buttons[name] = button
            row.addWidget(button)
        row.addWidget(self.notice, 2)
        for widget in (self.run_button, self.cancel_button, self.undo_button, self.find_button):
            row.addWidget(widget)
        row.addWidget(self.help_button)
        self.words = self.notice_words = ""
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def say(self, title: str) -> None:
        """The title of the case, cut where the room is short."""
        self.words = title
        self.title.setToolTip(escape_html(title))
        self._cut()

    def show_stage(self, name: str) -> None:
        self.buttons[name].setChecked(True)

    def show_notice(self, words: str, tip: str = "") -> None:
        self.notice_words = words
        self.notice.setToolTip(escape_html(tip or words))
        self.notice.setAccessibleName(words)
        self.notice.setVisible(bool(words))
        self._cut()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self._cut()

    def _cut(self) -> None:
        for widget, words, beside in ((self.title, self.words, 0), (self.notice, self.notice_words, 16)):
            room = max(widget.width(), MIN_WORDS) - beside
            widget.setText(widget.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, room))
