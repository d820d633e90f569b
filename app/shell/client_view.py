"""For the client (F11): the wall before and after, side by side, under the same record in real time; how much of the
required earthquake each withstands. No symbols."""

import html
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QElapsedTimer, QRectF, Qt, QTimer
from PySide6.QtGui import QColor, QFont, QImage, QKeySequence, QPainter, QPen, QShortcut
from PySide6.QtWidgets import QDialog, QHBoxLayout, QMessageBox, QPushButton, QVBoxLayout, QWidget

from app.look import theme
from app.look.dialogs import delete_after_use
from app.look.drawing import WallDrawing
from app.look.file_dialogs import path_to_write, plain_name
from app.look.labels import PlainLabel, RichLabel, escape_html
from app.look.language import describe_message, result_word, tr
from app.shell.film import Film
from app.views.runs import time_before_motion
from core import atomic_write
from core.answer.answer import Answer
from core.case.variant_names import AS_IS
from core.codes.outcomes import OUTCOMES
from core.errors import InputError, OutputError
from core.known import require_value
from core.report.verdict_words import tone_of
from core.study.demand_histories import history_at_demand
from core.study.results import StudyResult, WallResult, WallVerdict
from core.study.variants import OTHER_VARIANT

if TYPE_CHECKING:
    from app.shell.window import MainWindow

FRAME_MS, FILM_FPS, MAX_SECONDS = 33, 20, 20.0
"""Time of a frame on the screen [ms], frames of a film [1/s], and the longest of both [s]."""

SHARE_AXIS_FACTOR = 1.2
"""Length of the axis over the longest bar."""


@dataclass(frozen=True)
class Side:
    """One wall of the view.

    title : for a client; share : of the required earthquake it withstands, None where that is not known
    rotation : its motion [rad], every `time_step` [s]
    """

    title: str
    wall: WallResult
    share: float | None
    tone: str
    rotation: np.ndarray
    time_step: float


def sides_of(result: StudyResult, wall: WallResult) -> list[Side]:
    """Before and after, or the wall alone, each with the outcome of the wall and the lowest share of its hinges, and as
    the hinge that decides moves; under the record at the demand that turns the first one most."""
    answers = [Answer(result, verdict) for verdict in walls_beside(result, wall)]
    if not all(answer.records for answer in answers):
        return []
    sides = []
    for answer in answers:
        worst = answers[0].records[0]
        # a mechanism that takes each record with one sign alone has the other one by it
        same = [run for run in answer.records if run.motion == worst.motion]
        run = next((run for run in same if run.polarity == worst.polarity), same[0])
        motion, moved = history_at_demand(result, answer.decides, run)
        alone, before = len(answers) == 1, answer.wall.variant == AS_IS
        title = tr("The wall") if alone else tr("As it is") if before else tr("As designed")
        tone = tone_of(result, answer.decides)
        sides.append(Side(title, answer.decides, answer.share, tone, moved.rotation, motion.time_step))
    return sides


def walls_beside(result: StudyResult, wall: WallResult) -> list[WallVerdict]:
    """The verdict of the wall a result is of, or both of the wall before and after."""
    shown = next(
        (verdict for verdict in result.verdicts if result.walls[verdict.governing].part.origin == wall.part.origin),
        None,
    )
    if shown is None:
        return []
    other = OTHER_VARIANT.get(shown.wall.variant or "")
    pair = [
        verdict for verdict in result.verdicts if verdict.wall.name == shown.wall.name and verdict.wall.variant == other
    ]
    return sorted([shown, *pair[: other is not None]], key=lambda one: one.wall.variant != AS_IS)


class Bars(QWidget):
    """What each side withstands, in per cent of what is required."""

    def __init__(self, sides: list[Side]):
        super().__init__()
        self.sides = sides
        self.setMinimumHeight(56 * len(sides) + 40)
        self.setAccessibleName("; ".join(words_of(side) for side in sides))

    def paintEvent(self, event) -> None:
        """A bar a side, its words behind it, the line of what is required."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        font = QFont(self.font())
        font.setPointSizeF(1.25 * font.pointSizeF())
        painter.setFont(font)
        left, right = 170.0, self.width() - 470.0
        longest = SHARE_AXIS_FACTOR * max(1.0, *(side.share or 0.0 for side in self.sides))
        required = left + (right - left) / longest
        for k, side in enumerate(self.sides):
            y = 8.0 + 52.0 * k
            painter.setPen(QColor(theme.current.ink))
            painter.drawText(QRectF(4.0, y, left - 10.0, 34.0), Qt.AlignmentFlag.AlignVCenter, side.title)
            bar = QRectF(left, y, (side.share or 0.0) / longest * (right - left), 34.0)
            painter.fillRect(bar, QColor(getattr(theme.current, side.tone)))
            painter.setPen(QColor(getattr(theme.current, side.tone)))
            at = max(bar.right(), required if bar.right() < required + 8.0 else bar.right()) + 10.0
            painter.drawText(QRectF(at, y, self.width() - at, 34.0), Qt.AlignmentFlag.AlignVCenter, words_of(side))
        bottom = 8.0 + 52.0 * len(self.sides)
        painter.setPen(QPen(QColor(theme.current.ink), 3.0))
        painter.drawLine(int(required), 0, int(required), int(bottom))
        painter.drawText(QRectF(required - 100.0, bottom, 200.0, 28.0), Qt.AlignmentFlag.AlignCenter, tr("required"))


def words_of(side: Side) -> str:
    """What a side withstands, in words."""
    if side.share is None:
        return f"{tr('not known')} ({outcome_of(side)})"
    share = tr("{percent} % of the required earthquake", percent=f"{100.0 * side.share:.0f}")
    return f"{share} ({outcome_of(side)})"  # a share alone is no verification


def outcome_of(side: Side) -> str:
    """A verdict in words of every day: only one that nothing limits is called safe."""
    code = require_value(side.wall.assessment).verdict.code
    limited = OUTCOMES[code].tone == "good" and side.tone != "good"
    return result_word("client_with_reservations" if limited else f"client_{code}")


class ClientView(QDialog):
    """Both walls rocking, the bars below them."""

    def __init__(self, parent, title: str, sides: list[Side]):
        super().__init__(parent)
        self.setWindowTitle(title)
        self.title, self.sides = title, sides
        self.begin = min(time_before_motion(side.rotation, side.time_step) for side in sides)
        self.drawings: list[WallDrawing] = []
        heading = PlainLabel(title)
        heading.setWordWrap(True)
        heading.setStyleSheet(f"{theme.font_points(2.2)} font-weight: 700;")
        leave = PlainLabel(tr("Esc leaves"))
        top = QHBoxLayout()
        top.addWidget(heading, 1)
        top.addWidget(leave)
        row = QHBoxLayout()
        for side in sides:
            drawing = WallDrawing(with_sizes=False)
            drawing.show_wall(side.wall.wall)
            drawing.one_sided = side.wall.kinematics.one_way
            drawing.bars = [(tie.bar.height, 0) for tie in side.wall.wall.in_si.ties]
            drawing.setAccessibleName(f"{side.title}: {words_of(side)}")
            label = RichLabel(
                f"<span style='{theme.font_points(1.65)} font-weight:600'>{html.escape(side.title)}</span>"
            )
            column = QVBoxLayout()
            column.addWidget(label)
            column.addWidget(drawing, 1)
            row.addLayout(column, 1)
            self.drawings.append(drawing)
        tops, reaches = zip(*(drawing.extent for drawing in self.drawings), strict=True)
        for drawing in self.drawings:
            drawing.least_extent = (max(tops), max(reaches))
        self.scene = QWidget()
        self.scene.setAutoFillBackground(True)
        inside = QVBoxLayout(self.scene)
        inside.addLayout(top)
        inside.addLayout(row, 1)
        inside.addWidget(Bars(sides))
        buttons = QHBoxLayout()
        self.play = QPushButton(tr("Play"))
        self.play.setCheckable(True)
        self.play.toggled.connect(self._toggled)
        buttons.addWidget(self.play)
        for label, slot in (
            (tr("Save the picture…"), lambda: self.ask("PNG (*.png)", ".png")),
            (tr("Save as a page…"), lambda: self.ask("PDF (*.pdf)", ".pdf")),
            (tr("Save as a film…"), lambda: self.ask("GIF (*.gif)", ".gif")),
        ):
            button = QPushButton(label)
            button.clicked.connect(lambda _=False, slot=slot: slot())
            buttons.addWidget(button)
        buttons.addStretch(1)
        layout = QVBoxLayout(self)
        layout.addWidget(self.scene, 1)
        layout.addLayout(buttons)
        QShortcut(QKeySequence("F11"), self).activated.connect(self.reject)
        self.timer, self.clock = QTimer(self), QElapsedTimer()
        self.timer.setInterval(FRAME_MS)
        self.timer.timeout.connect(self._frame)
        self.set_time(self._moment())

    @property
    def seconds(self) -> float:
        """Length of the motion that is shown."""
        last = max(side.rotation.size * side.time_step for side in self.sides)
        return min(MAX_SECONDS, last - self.begin)

    def _moment(self) -> float:
        """When the first wall turns most [s]."""
        first = self.sides[0]
        return float(np.argmax(np.abs(first.rotation)) * first.time_step)

    def set_time(self, time: float) -> None:
        """Both walls at this time [s]; one that has fallen stays down."""
        for side, drawing in zip(self.sides, self.drawings, strict=True):
            sample = min(int(time / side.time_step), side.rotation.size - 1)
            drawing.set_rotation(float(np.clip(side.rotation[sample], -1.5, 1.5)))

    def _toggled(self, on: bool) -> None:
        self.play.setText(tr("Pause") if on else tr("Play"))
        if on:
            self.clock.start()
            self.timer.start()
        else:
            self.timer.stop()

    def _frame(self) -> None:
        time = self.begin + 0.001 * self.clock.elapsed()
        self.set_time(time)
        if time > self.begin + self.seconds:
            self.play.setChecked(False)

    # what leaves it

    def picture(self) -> QImage:
        """The scene as it stands."""
        return self.scene.grab().toImage()

    def film(self, path: Path) -> Film:
        """Write an animated GIF in real time, off this thread."""
        self.play.setChecked(False)

        def picture(k: int) -> QImage:
            self.set_time(self.begin + k / FILM_FPS)
            return self.picture()

        def failed(sentence: str) -> None:
            QMessageBox.warning(self, tr("Not saved"), escape_html(sentence))

        return Film(self, path, max(1, int(self.seconds * FILM_FPS)), FILM_FPS, picture, failed)

    def page(self) -> bytes:
        """A page of its own for the note: both walls to scale, the bars."""
        from app.look.language import current_language
        from core.report.note import wall_figures
        from core.report.note.parts import Bars as PageBars
        from core.report.note.parts import Figures, Heading, Part
        from core.report.note.pdf import Note
        from core.report.words import Words

        words = Words(current_language())
        figures = [one for side in self.sides if (one := wall_figures.drawing(side.wall, words))]
        rows = [(side.title, words_of(side), side.share, side.tone, False) for side in self.sides]
        parts: list[Part] = [Heading(self.title, 1), *([Figures(figures)] if figures else [])]
        parts.append(PageBars(rows, 1.0, tr("The mark is what is required.")))
        return Note(parts, words.language).pdf()

    def content(self, end: str) -> bytes:
        """The file .png or .pdf."""
        if end == ".pdf":
            return self.page()
        from app.views.figure_file import png

        return png(self.picture())

    def ask(self, kinds: str, end: str) -> None:
        """Write it to a place the user names."""
        path = path_to_write(self, tr("Save"), f"{plain_name(self.title)}{end}", kinds, (end,))
        if path is not None:
            self.write(path)

    def write(self, path: Path) -> None:
        """Write a film, or a file of `content`, by the end of its name."""
        if path.suffix.lower() == ".gif":
            self.film(path)
            return
        try:
            atomic_write.write({path: self.content(path.suffix.lower())})
        except (InputError, OutputError) as error:
            QMessageBox.warning(self, tr("Not saved"), escape_html(describe_message(error)))


def show(window: "MainWindow") -> None:
    """Open the view of the wall that is shown; says why where there is nothing to show."""
    result, wall = window.session.result, window.navigator.wall
    sides = sides_of(result, wall) if result and wall and not window.session.stale else []
    if not sides:
        window.show_word(tr("For this view a wall needs time histories at a demand: run it first (F5)."))
        return
    state = require_value(require_value(result).demand).limit_state
    title = tr("{wall} under the earthquake of the code ({state})", wall=sides[0].wall.part.own_name, state=state)
    with delete_after_use(ClientView(window, title, sides)) as view:
        view.resize(window.size())
        view.exec()
