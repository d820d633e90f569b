"""Work off the window's thread, cancelled by a flag. What a cancelled job still does arrives nowhere."""

import atexit
import gc
import tempfile
import threading
import traceback
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QThread, QTimer, Signal

from app.look.language import describe_message
from core.errors import Cancelled, InputError
from core.known import require_value

RUNNING_JOBS: set["Job"] = set()
"""Jobs whose threads have not ended: a thread's object must outlive it."""


@atexit.register
def end_jobs() -> None:
    """Wait for the threads: Qt aborts where one outlives Python."""
    for job in list(RUNNING_JOBS):
        job.cancel()
        job.wait()


class Job(QThread):
    """Runs `work(job)` in a thread. `work` looks at `job.cancelled` and calls `job.progress`; what cannot be
    taken back, as writing files, it does after `job.commit()`.

    done(result), failed(sentence: str, log: str; no log for wrong input) : one of them, none if it stops;
    progressed(done, planned, left) : the time left [s], None where it is not known; found(part) : a part of the
        result, before it is whole. A job that was cancelled may be left: its thread ends by itself.
    """

    done = Signal(object)
    failed = Signal(str, str)
    progressed = Signal(int, int, object)
    found = Signal(object)

    def __init__(self, work: Callable[["Job"], Any]):
        super().__init__()
        self._work: Callable[[Job], Any] | None = work
        self._flag, self._commits = threading.Event(), threading.Lock()
        self.committed = False
        self.error: InputError | None = None

    def start(self, priority: QThread.Priority = QThread.Priority.InheritPriority) -> None:
        RUNNING_JOBS.add(self)
        self.finished.connect(self._ended)
        super().start(priority)

    def _ended(self) -> None:
        """Nothing is kept of it, its result least of all."""
        RUNNING_JOBS.discard(self)
        self._work = None
        self.deleteLater()

    def cancel(self) -> bool:
        """Ask the work to stop; False if it is too late for that."""
        with self._commits:
            if not self.committed:
                self._flag.set()
        return not self.committed

    def commit(self) -> None:
        """From here on nothing is cancelled any more. Raises Cancelled."""
        with self._commits:
            if self._flag.is_set():
                raise Cancelled
            self.committed = True

    def cancelled(self) -> bool:
        return self._flag.is_set()

    def check(self) -> None:
        """Raises Cancelled where it is."""
        if self._flag.is_set():
            raise Cancelled

    def progress(self, done: int, planned: int, left: float | None = None) -> None:
        self.progressed.emit(done, planned, left)

    def run(self) -> None:
        try:
            result = require_value(self._work)(self)
        except Cancelled:
            pass
        except InputError as error:
            self.error = error
            self.failed.emit(describe_message(error), "")
        except Exception as error:  # the worker's: an internal error must not be silent
            self.failed.emit(f"{type(error).__name__}: {error}", write_log(traceback.format_exc()))
        else:
            self.done.emit(result)


class Collector(QObject):
    """Python's collector of cycles, in the thread of the window alone: started by an allocation in a job it would
    destroy widgets there, and Qt waits for ever or crashes."""

    INTERVAL_MS = 500

    def __init__(self, parent: QObject):
        super().__init__(parent)
        gc.disable()
        self.timer = QTimer(self)
        self.timer.timeout.connect(self.look)
        self.timer.start(self.INTERVAL_MS)

    @staticmethod
    def look() -> None:
        """Collect the oldest generation that is due."""
        limits = gc.get_threshold()
        for k in (2, 1, 0):
            if gc.get_count()[k] > limits[k] > 0:
                gc.collect(k)
                return


def write_log(text: str) -> str:
    """Path of a log file with this traceback."""
    with tempfile.NamedTemporaryFile(
        "w", prefix="ribalta-error-", suffix=".log", delete=False, encoding="utf-8"
    ) as log:
        log.write(text)
    return log.name
