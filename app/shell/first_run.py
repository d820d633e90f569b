"""The page of a start without a case: the question the program answers, three ways to it, and what it does not do."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QFrame, QHBoxLayout, QPushButton, QScrollArea, QVBoxLayout, QWidget

from app.look import theme
from app.look.drawing import outline
from app.look.labels import PlainLabel, escape_html
from app.look.language import tr
from app.shell.files import EXAMPLE
from app.work.draft import TO_BE_GIVEN
from core.case.schema import Generate
from core.case.site import Demand

if TYPE_CHECKING:
    from app.shell.window import MainWindow

TURNS = 0.0, 0.10, 0.24
"""Rotations at which the picture shows the wall [rad]."""

GROUND_SHAKES = 0, 2, -1, -6, -4, -9, 2, 14, 0, -24, -20, 8, 24, 4, -25, -4, 25, 22, -18, -24, -3, 9, 3, -5, 1, 0
"""The motion of the ground in the picture."""


class Rocking(QWidget):
    """A wall that rocks about its hinge beside the motion of the ground."""

    def __init__(self):
        super().__init__()
        self.setMinimumSize(300, 170)
        self.setAccessibleName(tr("A wall that overturns about its hinge"))

    def paintEvent(self, event) -> None:
        painter, shades = QPainter(self), theme.current
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        floor, left, high = self.height() - 24.0, 0.28 * self.width(), 0.78 * self.height() - 24.0
        painter.setPen(QPen(QColor(shades.ink), 1.4))
        painter.drawLine(QPointF(0.0, floor), QPointF(self.width(), floor))
        for rotation, shade in zip(TURNS, (shades.curves[0], shades.quiet, shades.bad), strict=True):
            fill = QColor(shade)
            fill.setAlpha(45 if rotation != TURNS[1] else 15)
            painter.setBrush(fill)
            style = Qt.PenStyle.SolidLine if rotation == 0.0 else Qt.PenStyle.DashLine
            painter.setPen(QPen(QColor(shades.ink if rotation == 0.0 else shade), 1.2, style))
            corners = outline(high, 0.16 * high, 0.0, rotation)
            painter.drawPolygon(QPolygonF([QPointF(left - p.x(), floor - p.y()) for p in corners]))
        painter.setBrush(QColor(shades.bad))
        painter.setPen(Qt.PenStyle.NoPen)
        hinge = QPointF(left - 0.08 * high, floor)
        painter.drawEllipse(hinge, 4.5, 4.5)
        painter.setPen(QPen(QColor(shades.quiet), 1.4))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        middle, start, step = floor - 0.5 * high, 0.52 * self.width(), 0.44 * self.width() / len(GROUND_SHAKES)
        points = [QPointF(start + k * step, middle + 0.018 * high * u) for k, u in enumerate(GROUND_SHAKES)]
        painter.drawPolyline(QPolygonF(points))
        painter.drawText(QPointF(hinge.x() + 8.0, floor + 16.0), tr("hinge"))
        painter.drawText(QPointF(start + 0.15 * self.width(), floor + 16.0), tr("the ground"))
        painter.end()


class WayIn(QFrame):
    """A card with what it leads to and its button. first : the one that is meant for most"""

    def __init__(self, title: str, words: str, hint: str, label: str, chosen: Callable[[], None], first: bool):
        super().__init__()
        shades = theme.current
        self.setObjectName("way")
        edge = f"2px solid {shades.ink if first else shades.back}"
        self.setMaximumHeight(16 * self.fontMetrics().height())
        self.setStyleSheet(f"QFrame#way {{ background: {shades.back}; border: {edge}; border-radius: 6px; }}")
        inside = QVBoxLayout(self)
        inside.setContentsMargins(18, 14, 18, 16)
        for text, look in (
            (title, f"{theme.font_points(1.5)} font-weight: 700;"),
            (words, ""),
            (hint, f"color: {shades.quiet}; {theme.font_points(0.92)}"),
        ):
            line = PlainLabel(text)
            line.setWordWrap(True)
            line.setStyleSheet(look)
            inside.addWidget(line)
        inside.addStretch(1)
        self.button = QPushButton(label)
        self.button.setAccessibleDescription(words)
        back, ink = (shades.ink, shades.back) if first else (shades.back, shades.ink)
        self.button.setStyleSheet(
            f"QPushButton {{ background: {back}; color: {ink}; border: 1px solid {shades.edge}; border-radius: 4px;"
            f" font-weight: 600; padding: 5px 14px; }} QPushButton:focus {{ border: 2px solid {shades.curves[0]}; }}"
        )
        self.button.clicked.connect(lambda: chosen())
        inside.addWidget(self.button, 0, Qt.AlignmentFlag.AlignLeft)


class FirstRun(QScrollArea):
    """chosen(name) : wall, table, example, records, paper or facade; opened(path) : a file of late"""

    chosen = Signal(str)
    opened = Signal(str)

    def __init__(self, recent: list[str]):
        super().__init__()
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.buttons: dict[str, QPushButton] = {}
        page = QWidget()
        self.setWidget(page)
        column = QVBoxLayout(page)
        column.setContentsMargins(50, 24, 50, 14)
        column.setSpacing(14)
        head, question = QHBoxLayout(), QVBoxLayout()
        for text, size in ((tr("Does this wall stand the earthquake, or overturn?"), 2.4), (_promise(), 1.1)):
            line = PlainLabel(text)
            line.setWordWrap(True)
            line.setStyleSheet(theme.font_points(size) + ("font-weight: 700;" if size > 2.0 else ""))
            question.addWidget(line)
        question.addStretch(1)
        head.addLayout(question, 5)
        head.addWidget(Rocking(), 4)
        column.addLayout(head, 2)
        column.addLayout(self._ways(), 2)
        column.addLayout(self._links(_others(), tr("Also"), self.chosen.emit))
        if recent:
            links = {name: Path(name).name for name in recent[:4]}
            column.addLayout(self._links(links, tr("Lately"), self.opened.emit))
        column.addStretch(1)
        foot = PlainLabel(
            tr(
                "Rigid blocks, out of plane; no sliding, no vertical motion. The records are generated unless you give "
                "your own."
            )
        )
        foot.setWordWrap(True)
        foot.setStyleSheet(f"color: {theme.current.quiet}; border-top: 1px solid {theme.current.grid}; padding: 6px;")
        column.addWidget(foot)

    def _ways(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(18)
        for name, title, words, hint, label in (
            (
                "wall",
                tr("One wall"),
                tr("Draw it: three numbers, what holds it, what it carries."),
                tr("Height 7 m, thickness 60 cm …"),
                tr("New wall"),
            ),
            (
                "table",
                tr("A building"),
                tr("Bring its walls: a table, Excel or CSV."),
                tr("An empty one is in the menu Help."),
                tr("Open a table"),
            ),
            (
                "example",
                tr("An example"),
                tr("Two walls under {n} motions: press F5 and look around.", n=Generate().count),
                tr("Change it and press F5 again."),
                tr("Open the example"),
            ),
        ):
            way = WayIn(title, words, hint, label, partial(self.chosen.emit, name), name == "wall")
            self.buttons[name] = way.button
            row.addWidget(way, 1)
        return row

    def _links(self, names: dict[str, str], label: str, follow: Callable[[str], None]) -> QHBoxLayout:
        """A row of words that lead somewhere."""
        row, quiet = QHBoxLayout(), PlainLabel(label)
        quiet.setStyleSheet(f"color: {theme.current.quiet};")
        row.addWidget(quiet)
        for name, text in names.items():
            button = QPushButton(text)
            button.setFlat(True)
            button.setToolTip(escape_html(name if label == tr("Lately") else text))
            button.setStyleSheet(f"QPushButton {{ color: {theme.current.curves[0]}; padding: 2px 6px; }}")
            button.clicked.connect(lambda _=False, name=name: follow(name))
            self.buttons[name] = button
            row.addWidget(button)
        row.addStretch(1)
        return row


def _promise() -> str:
    return tr(
        "Give height, thickness and what holds the wall: in seconds its ζ by the Circolare 7/2019, C8.7.1.2, and by "
        "time histories."
    )


def _others() -> dict[str, str]:
    return {
        "records": tr("Records to look at"),
        "paper": tr("The study of the paper"),
        "facade": tr("The facade of a church"),
    }


def open_first_choice(window: "MainWindow", name: str) -> None:
    """Do what was chosen."""
    from app.shell import menus

    if name == "example":
        window.navigator.show_stage("input")
        return
    if name == "facade":
        if window.files.open(EXAMPLE.with_name("facade.toml")):
            window.navigator.show_input("wall", 0)
            window.walls.sections["body"].unfold()
        return
    if name == "paper":
        window.navigator.show_stage("input")
        menus.open_study_window(window)
        return
    if not window.files.new():
        return
    if name == "wall":
        _ask_demand(window)
        window.walls.add()
        window.navigator.show_input("wall", 0)
        window.walls.fields["height_m"].editor.setFocus()
    elif name == "records":
        window.navigator.show_input("records")
        window.records.add()
    else:
        window.navigator.show_input("wall")
        window.walls.load_table()
        _ask_demand(window)  # after its rows: one without a base is taken, and its base asked for
        if window.session.case.wall:
            window.missing.lead()


def _ask_demand(window: "MainWindow") -> None:
    """a_g and the bases are asked for from the beginning: without a demand there is no answer."""
    window.session.edit(replace(window.session.case, demand=Demand(TO_BE_GIVEN)))
