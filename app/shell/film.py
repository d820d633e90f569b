"""A film of a view: its frames are painted between the events of the window, made into a GIF off its thread."""

import io
import queue
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QProgressDialog, QWidget
from shiboken6 import isValid

from app.look.language import tr
from app.work.worker import Job
from core import atomic_write

MAX_FRAME_SIDE, COLOURS = 960, 48
"""Longest side of a frame [px], and its colours."""

PICTURES_AHEAD = 4
"""Frames that wait to be made into the film."""


def frame_of(picture: QImage):
    """A picture as a frame of a GIF."""
    from PIL import Image

    image = picture.convertToFormat(QImage.Format.Format_RGB888)
    wide, high, line = image.width(), image.height(), image.bytesPerLine()
    frame = Image.frombuffer("RGB", (wide, high), bytes(image.constBits()), "raw", "RGB", line, 1)
    frame.thumbnail((MAX_FRAME_SIDE, MAX_FRAME_SIDE))
    return frame.quantize(COLOURS)


def gif_of(frames: list, per_second: int) -> bytes:
    """An animated GIF in real time."""
    out = io.BytesIO()
    frames[0].save(out, "GIF", save_all=True, append_images=frames[1:], duration=round(1000 / per_second), loop=0)
    return out.getvalue()


class Film(QObject):
    """Writes a film of so many frames.

    picture(k) : the k-th frame, painted in the thread of the window
    failed(sentence) : it was not written
    """

    def __init__(
        self,
        view: QWidget,
        path: Path,
        count: int,
        per_second: int,
        picture: Callable[[int], QImage],
        failed: Callable[[str], None],
    ):
        super().__init__(view)
        self.pictures: queue.Queue[QImage | None] = queue.Queue()
        self.count, self.painted, self.picture = count, 0, picture
        self.dialog = QProgressDialog(tr("The film is made…"), tr("Cancel"), 0, count, view)
        self.dialog.setWindowModality(Qt.WindowModality.WindowModal)
        self.timer = QTimer(self)
        self.timer.timeout.connect(self._next)

        def work(job: Job) -> None:
            frames = []
            while True:
                job.check()
                try:
                    image = self.pictures.get(timeout=0.05)
                except queue.Empty:
                    continue
                if image is None:
                    break
                frames.append(frame_of(image))
                self.pictures.task_done()
                job.progress(len(frames), count)
            content = gif_of(frames, per_second)
            job.commit()
            atomic_write.write({path: content})

        self.job = Job(work)
        view.destroyed.connect(self.job.cancel)
        self.job.progressed.connect(lambda done, *_: self.dialog.setValue(min(done, count - 1)))
        self.job.failed.connect(lambda sentence, _: failed(sentence))
        self.job.finished.connect(self._end)
        self.dialog.canceled.connect(self.job.cancel)
        self.job.start()
        self.timer.start(0)

    def _next(self) -> None:
        """A frame, unless enough of them wait."""
        if self.job.cancelled():
            self.timer.stop()
        elif self.pictures.unfinished_tasks < PICTURES_AHEAD:
            if self.painted == self.count:
                self.timer.stop()
                self.pictures.put(None)
                return
            failed = True
            try:
                self.pictures.put(self.picture(self.painted))
                failed = False
            finally:  # what it raises goes to the hook of errors, once
                if failed:
                    self.timer.stop()
                    self.job.cancel()
            self.painted += 1

    def _end(self) -> None:
        if not isValid(self) or not isValid(self.dialog):  # they went with the view
            return
        self.timer.stop()
        self.dialog.canceled.disconnect(self.job.cancel)
        self.dialog.close()
        self.deleteLater()
