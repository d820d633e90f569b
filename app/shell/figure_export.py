"""All figures of the wall shown, to a folder: drawn strip by strip between the events of the window, which alone may
paint; made into files and written off its thread."""

import queue
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QImage

from app.look.file_dialogs import plain_name
from app.look.labels import PlainLabel
from app.look.language import result_word, tr
from app.shell.pages import LazyPage, delete
from app.shell.stages import stage_of
from app.views.axis import SPARE_PLOTS, plot_widget
from app.views.chart import Chart
from app.views.figure_file import FigureSize, png, raster
from app.views.histories_tab import HistoriesTab
from core import atomic_write
from core.known import require_value

if TYPE_CHECKING:
    from app.shell.window import MainWindow

MAX_CHARTS_OF_PAGE = 5
"""The most of a page: their plots are made ahead, one in a turn."""


def beginning(wall) -> str:
    """How the names of the files of a wall begin."""
    return f"{plain_name(f'{wall.name} {result_word(wall.mechanism)}')} - "


class FigureExport(QObject):
    """Exports the figures of one wall; a change of the input, of the wall or of the window cancels it. All files are
    written, or none."""

    def __init__(self, window: "MainWindow", folder: Path, size: FigureSize):
        super().__init__(window)
        self.window, self.size, self.figures = window, size, queue.Queue()
        self.navigator = window.navigator
        self.shown, self.drawing = self.navigator.shown, self._draw()
        self.timer = QTimer(self, singleShot=True)
        self.timer.timeout.connect(self._next)
        start = beginning(self.navigator.wall)

        def work(job) -> int:
            files: dict[Path, bytes] = {}
            while True:
                job.check()
                try:
                    figure = self.figures.get(timeout=0.05)
                except queue.Empty:
                    continue
                if figure is None:
                    break
                files[folder / f"{start}{plain_name(figure[0])}.png"] = png(figure[1])
                self.figures.task_done()
            job.commit()
            atomic_write.write(files)
            return len(files)

        def arrived(count: int) -> None:
            window.show_word(tr("Figures written to {folder}: {n}", n=count, folder=folder))

        window.runner.start(work, arrived)
        self.job = window.runner.job
        self.timer.start(0)

    def _next(self) -> None:
        """A page, or a strip of a figure; then the window's turn."""
        window = self.window
        same = window.navigator is self.navigator and self.navigator.shown == self.shown
        if window.runner.job is self.job and (not same or window.session.stale):
            window.runner.cancel()
        if window.runner.job is not self.job:
            self._end()
            return
        self.timer.start(1)
        if not self.figures.unfinished_tasks:  # while a file is made, painting would wait for it and take memory
            failed, ended = True, False
            try:
                ended = next(self.drawing, self) is self  # at its end
                failed = False
            finally:
                if failed:
                    window.runner.cancel()
                if failed or ended:
                    self._end()
            if ended:
                self.figures.put(None)

    def _end(self) -> None:
        self.timer.stop()
        self.drawing.close()
        self.deleteLater()

    @staticmethod
    def _make(page: LazyPage) -> Iterator[None]:
        """A page that is not made yet, its plots one by one before it."""
        while page.made is None and len(SPARE_PLOTS) < MAX_CHARTS_OF_PAGE:
            SPARE_PLOTS.append(plot_widget())
            yield None
        page.content  # noqa: B018
        yield None

    def _draw(self) -> Generator[QImage | None, None, None]:
        """Qt lays nothing out that was not once in front: each page is, behind a picture of the stage as it was."""
        navigator, stages = self.navigator, self.navigator.stages
        shown, stage = navigator.page, stages.front
        cover = PlainLabel(parent=stages.stack)
        cover.setPixmap(stages.stack.grab())
        cover.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)  # what is behind it is not painted
        cover.setGeometry(stages.stack.rect())
        cover.show()
        frozen = (stages.stack, navigator.tree)
        for part in frozen:
            part.setEnabled(False)
        try:
            drawn = {name: page for name, page in navigator.pages.items() if stage_of(name) != "report"}
            for k, (name, page) in enumerate(drawn.items()):  # the note has no figure, and takes a second to be set
                yield from self._make(page)
                content = page.content
                if isinstance(content, HistoriesTab):
                    content.walls.play.setChecked(False)  # nothing moves between two strips of a figure
                to_fill = {page, navigator.beside} - navigator.fresh
                navigator.fresh |= to_fill  # to the front now, filled in turns of their own
                navigator.show_page(name)
                cover.raise_()
                navigator.fresh -= to_fill
                yield None
                navigator.fill(name)
                yield None
                if stages.answer.has_beside():
                    yield from self._make(navigator.beside)
                    navigator.show_result()
                    yield None
                for chart in content.findChildren(Chart):
                    if chart.data:
                        for image in raster(chart, self.size):
                            yield image
                        self.figures.put((chart.name, image))
                        yield None
                require_value(self.job).progress(k + 1, len(drawn))
        finally:
            while SPARE_PLOTS:
                delete(SPARE_PLOTS.pop())
            if self.window.navigator is navigator:
                for part in frozen:
                    part.setEnabled(True)
                navigator.show_page(shown) if shown is not None else navigator.show_stage(stage)
                cover.deleteLater()
