"""The walls of the page Histories as they rock, at the time of its charts or played."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QElapsedTimer, QTimer, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from app.look.drawing import WallDrawing
from app.look.language import tr
from app.look.whole_text import tell_whole
from app.views.runs import time_before_motion
from core.study.bar_histories import BarHistory
from core.study.results import WallResult

EVERY_MS = 33
"""Time between two pictures of a wall that rocks [ms]."""

MAX_ROTATION_SHOWN = 1.5
"""Largest rotation drawn, also of a wall that has fallen [rad]."""


class Film(NamedTuple):
    """Rotation of a wall [rad] at every sample, and the time between two [s]."""

    rotation: np.ndarray
    time_step: float

    def at(self, time: float) -> int:
        """The sample that is shown at this time [s]; the last one after the end."""
        return min(max(0, int(time / self.time_step)), self.rotation.size - 1)


class MovingWalls(QWidget):
    """One wall, or beside it the same wall under a second record.

    asked : a time to be shown [s], while it plays
    """

    asked = Signal(float)

    def __init__(self):
        super().__init__()
        self.drawings = WallDrawing(with_sizes=False), WallDrawing(with_sizes=False)
        self.play = QPushButton(tr("Play"))
        self.play.setCheckable(True)
        self.play.toggled.connect(self._toggled)
        self.speed = QComboBox()
        self.speed.setAccessibleName(tr("Speed"))
        for name, speed in (("1×", 1.0), ("½×", 0.5), ("¼×", 0.25), ("1⁄10×", 0.1)):
            self.speed.addItem(name, speed)
        self.speed.activated.connect(lambda _: self._again_from_here())
        self.other = QComboBox()
        self.other.setAccessibleName(tr("Second record"))
        self.other.setToolTip(tr("A second record at the same multiplier, beside the first"))
        self.other.setMinimumWidth(60)
        tell_whole(self.other)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        row = QHBoxLayout()
        for drawing in self.drawings:
            row.addWidget(drawing, 1)
        column.addLayout(row, 1)
        below = QHBoxLayout()
        below.addWidget(self.play)
        below.addWidget(self.speed)
        below.addWidget(self.other, 1)
        column.addLayout(below)
        self.setMinimumWidth(190)
        self.timer = QTimer(self)
        self.timer.setInterval(EVERY_MS)
        self.timer.timeout.connect(self._next)
        self.clock, self.started, self.time = QElapsedTimer(), 0.0, 0.0
        self.films: list[Film] = []
        self.bars: Sequence[BarHistory] = ()

    def show_wall(self, wall: WallResult) -> None:
        """Draw another wall, at rest."""
        self.play.setChecked(False)
        self.films = []
        self.drawings[1].setVisible(False)
        for drawing in self.drawings:
            drawing.show_wall(wall.wall)
            drawing.one_sided = wall.kinematics.one_way

    def take(self, films: list[Film], bars: Sequence[BarHistory]) -> None:
        """Take other histories. films : of the record, and of the second one where there is one;
        bars : the ties of the first"""
        self.films, self.bars = films, bars
        self.drawings[1].setVisible(len(films) > 1)

    def show_time(self, time: float) -> None:
        """Draw the walls as they stand at this time [s]."""
        self.time = time
        for drawing, film in zip(self.drawings, self.films, strict=False):
            sample = film.at(time)
            if drawing is self.drawings[0]:
                drawing.bars = [(bar.bar.height, int(bar.phase[sample])) for bar in self.bars]
            drawing.set_rotation(float(np.clip(film.rotation[sample], -MAX_ROTATION_SHOWN, MAX_ROTATION_SHOWN)))

    def _again_from_here(self) -> None:
        """Another speed, from the moment that is shown."""
        if self.play.isChecked():
            self.started = self.time
            self.clock.restart()

    def _toggled(self, on: bool) -> None:
        self.play.setText(tr("Pause") if on else tr("Play"))
        self.timer.stop()
        if on and self.films:
            film = self.films[0]
            begin = time_before_motion(film.rotation, film.time_step)
            ended = self.time >= (film.rotation.size - 1) * film.time_step
            self.started = begin if ended else max(self.time, begin)
            self.clock.start()
            self.timer.start()

    def _next(self) -> None:
        film = self.films[0]
        time = self.started + 0.001 * self.speed.currentData() * self.clock.elapsed()
        self.asked.emit(time)
        if time >= (film.rotation.size - 1) * film.time_step:
            self.play.setChecked(False)
