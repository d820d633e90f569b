"""The tab Note: the pages of the calculation note as they print, set in the background; a number leads to its check, a
heading to its wall."""

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QKeySequence, QPainter, QShortcut
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.look import theme
from app.look.labels import PlainLabel
from app.look.language import current_language, tr
from app.views.result_tab import ResultTab
from app.work.worker import Job
from core.known import require_value
from core.study.results import StudyResult, WallResult
from core.text.sentence import LANGUAGES

if TYPE_CHECKING:
    from core.report.note.pdf import Note

ZOOMS = (50, 75, 100, 125, 150, 200)
"""Sizes of a page on the screen [%], beside that as wide as the tab."""

PAGE_WIDTH = 595.3
"""Width of an A4 page [pt]."""

RESIZED_MS, TYPED_MS = 250, 800
"""Rest after which pages follow the width of the tab, and what is typed beside them [ms]."""

DOTS_PER_INCH, POINTS_PER_INCH = 96.0, 72.0
"""Dots of an inch on the screen at 100 %, and points of one in a PDF."""

GAP = 12
"""Between two pages [px]."""

MAX_CLICK_DISTANCE = 30.0
"""How far below a mark a click still belongs to it [pt]."""


@dataclass(frozen=True)
class Pages:
    """A note that is set. images : of its pages; places : of `Note.places`; note : itself; scale : points of the screen
    for a point of the paper"""

    images: list[QImage] = field(default_factory=list)
    places: list[dict] = field(default_factory=list)
    note: "Note | None" = None
    scale: float = 1.0


class Paper(QWidget):
    """The pages one below the other. clicked(page, y) : number of the page from 1, place on it from the top [pt]"""

    clicked = Signal(int, float)

    def __init__(self):
        super().__init__()
        self.images: list[QImage] = []
        self.tops = [GAP]
        self.scale = 1.0
        self.found: tuple[int, float] | None = None
        self.setMouseTracking(True)

    def show_images(self, images: list[QImage], scale: float) -> None:
        """scale : as of `Pages`"""
        self.images, self.scale, self.found = images, scale, None
        sizes = [image.deviceIndependentSize().toSize() for image in images]
        wide = max((size.width() for size in sizes), default=0)
        self.tops = list(accumulate((size.height() + GAP for size in sizes), initial=GAP))
        self.setFixedSize(QSize(wide + 2 * GAP, self.tops[-1]))
        self.update()

    def top_of(self, page: int) -> int:
        """Where a page begins [px]."""
        return self.tops[page - 1]

    def at(self, point: QPoint) -> tuple[int, float] | None:
        """Page and place on it of a point; None between the pages."""
        number = bisect_right(self.tops, point.y())
        if not 1 <= number <= len(self.images):
            return None
        y = point.y() - self.top_of(number)
        return (number, y / self.scale) if y < self.images[number - 1].deviceIndependentSize().height() else None

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        painter.fillRect(event.rect(), QColor(theme.current.window).darker(108))
        first = max(bisect_right(self.tops, event.rect().top()), 1)
        last = min(bisect_right(self.tops, event.rect().bottom()), len(self.images))
        for number in range(first, last + 1):
            image, y = self.images[number - 1], self.top_of(number)
            painter.drawImage(QPoint(GAP, y), image)
            if self.found and self.found[0] == number:
                mark = QColor(theme.current.amber)
                mark.setAlpha(90)
                wide = image.deviceIndependentSize().width()
                painter.fillRect(QRectF(GAP, y + (self.found[1] - 10.0) * self.scale, wide, 14.0 * self.scale), mark)

    def mouseReleaseEvent(self, event) -> None:
        if place := self.at(event.position().toPoint()):
            self.clicked.emit(*place)


class NoteTab(ResultTab):
    """The pages of the note of a result.

    base_dir : tells the folder of the case
    checked(k), picked(k) : a number of the k-th wall of the result was clicked, or its heading; exported : the note is
        to be written
    """

    checked = Signal(int)
    picked = Signal(int)
    exported = Signal()

    def __init__(self, base_dir: Callable[[], Path]):
        super().__init__()
        self.base_dir = base_dir
        self.result: StudyResult | None = None
        self.pages = Pages()
        self.job: Job | None = None
        self.lines: list[tuple[int, float, str]] | None = None
        self.hit = -1
        self.zoom = QComboBox()
        self.zoom.addItem(tr("page width"), None)
        for percent in ZOOMS:
            self.zoom.addItem(f"{percent} %", percent)
        self.zoom.setAccessibleName(tr("Size of the pages"))
        self.zoom.currentIndexChanged.connect(lambda _: self._set())
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Find in the note"))
        self.search.setAccessibleName(tr("Find in the note"))
        self.search.setClearButtonEnabled(True)
        self.search.returnPressed.connect(self.find_next)
        QShortcut(QKeySequence.StandardKey.Find, self, self.search.setFocus)
        self.word = PlainLabel()
        self.word.setWordWrap(True)  # a sentence that the note is not set by is long
        self.word.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        export = QPushButton(tr("Export…"))
        export.clicked.connect(self.exported)
        bar = QHBoxLayout()
        for widget in (self.zoom, self.search, export):
            bar.addWidget(widget)
        bar.insertWidget(2, self.word, 1)
        self.resized = QTimer(self)
        self.resized.setSingleShot(True)
        self.resized.timeout.connect(self._set)
        self.paper = Paper()
        self.paper.clicked.connect(self._clicked)
        self.view = QScrollArea()
        self.view.setWidget(self.paper)
        self.view.setAccessibleName(tr("Note"))
        self.view.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        layout = QVBoxLayout(self)
        layout.addLayout(bar)
        layout.addWidget(self.view, 1)

    @property
    def is_setting(self) -> bool:
        """Whether pages are on their way."""
        return self.job is not None or self.resized.isActive()

    def show_wall(self, result: StudyResult, wall: WallResult) -> None:
        """Set the note of a result, where it is not yet, and go to the section of a wall."""
        if result is not self.result:
            typed = self.result is not None and self.result.walls is result.walls
            self.result, self.pages = result, Pages()
            self.resized.start(TYPED_MS if typed else 0)  # when the tab has its size
        else:
            self._to_wall(result.walls.index(wall))

    def _set(self) -> None:
        """Set the pages off this thread; what was being set before is left."""
        if self.job is not None:
            self.job.cancel()
        if self.result is None:
            return
        result, base, note = self.result, self.base_dir(), self.pages.note
        ratio = self.devicePixelRatioF()
        dots = self._dots()

        def work(job: Job) -> Pages:
            from core.report.note.archive import note_of
            from core.report.steps import Steps

            made = note or note_of(result, base, Steps(job.check), within=False)
            job.check()
            images = [QImage.fromData(page) for page in made.pages(dots * ratio)]
            for image in images:
                image.setDevicePixelRatio(ratio)
            job.check()
            return Pages(images, made.places(), made, dots / POINTS_PER_INCH)

        job = self.job = Job(work)
        job.done.connect(self._arrived)
        job.failed.connect(self._failed)
        self.word.setText(tr("Setting the pages…"))
        job.start()

    def _dots(self) -> float:
        """Count the dots of an inch on the screen."""
        percent = self.zoom.currentData()
        if percent is not None:
            return DOTS_PER_INCH * percent / 100.0
        room = self.view.width() - self.view.verticalScrollBar().sizeHint().width() - 2 * GAP - 4
        return POINTS_PER_INCH * max(room, 200) / PAGE_WIDTH

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        if self.zoom.currentData() is None and (self.pages.images or self.job is not None):
            self.resized.start(RESIZED_MS)

    def _arrived(self, pages: Pages) -> None:
        if self.sender() is not self.job:
            return
        bar = self.view.verticalScrollBar()
        share = bar.value() / max(bar.maximum(), 1)
        self.job, self.pages, self.lines = None, pages, None
        self.paper.show_images(pages.images, pages.scale)
        bar.setValue(round(share * bar.maximum()))
        words = tr("Pages: {n}", n=len(pages.images))
        tongue = require_value(self.result).case.report.language
        if tongue != current_language():
            words += ", " + tr("in the language of the report ({language})", language=LANGUAGES[tongue])
        self.word.setText(words)

    def _failed(self, words: str, _log: str) -> None:
        if self.sender() is not self.job:
            return
        self.job, self.pages = None, Pages()
        self.paper.show_images([], 1.0)
        self.word.setText(words)

    def _to_wall(self, k: int) -> None:
        for place in self.pages.places:
            if place.get("wall") == k and place["page"] > 1:
                self._go(place["page"], place["y"])
                return

    def _go(self, page: int, y: float) -> None:
        self.view.verticalScrollBar().setValue(round(self.paper.top_of(page) + y * self.paper.scale) - 4 * GAP)

    def _clicked(self, page: int, y: float) -> None:
        """A number leads to its check, a heading or a row of the first page to its wall."""
        wall, nearest = None, None
        for place in self.pages.places:  # in the order of the text
            if (place["page"], place["y"]) > (page, y + 4.0):
                break
            wall = place.get("wall", wall)
            nearest = place
        if wall is None or nearest is None or nearest["page"] != page or y - nearest["y"] > MAX_CLICK_DISTANCE:
            return
        (self.picked if "wall" in nearest else self.checked).emit(wall)

    def find_next(self) -> None:
        """Go to the next line that holds what is asked for, from the first again after the last."""
        wanted = self.search.text().strip().casefold()
        if not wanted or self.pages.note is None:
            return
        if self.lines is None:
            self.lines = self.pages.note.lines()
        hits = [k for k, (_, _, text) in enumerate(self.lines) if wanted in text.casefold()]
        if not hits:
            self.word.setText(tr("not found"))
            return
        self.hit = next((k for k in hits if k > self.hit), hits[0])
        page, y, _ = self.lines[self.hit]
        self.word.setText(tr("{n} of {all}", n=hits.index(self.hit) + 1, all=len(hits)))
        self.paper.found = (page, y)
        self.paper.update()
        self._go(page, y)
