"""What runs off the thread of the window: a case, an export, an accuracy statement; one at a time."""

import os
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.look.language import tr
from app.work.session import Session
from app.work.worker import Job
from core.answer.answer import zetas_so_far
from core.capacity.accuracy import Accuracy
from core.case.schema import Case
from core.errors import InputError
from core.known import require_value
from core.setting.plan import count_results_by_wall
from core.study.journal import MemoryJournal
from core.study.results import StudyResult, WallResult

TICK_MS = 500
"""Between two words of the clock while nothing else is told."""

MIN_UPDATE_SECONDS = 0.1
"""Least time between two states of the progress bar [s]: each paints the window at once."""


def progress_word(done: int, planned: int, elapsed: float, left: float | None, walls: str = "") -> str:
    """How much is done, and the time left [s] where it is known. walls : how many of them, in words"""
    values: dict = {"done": done, "planned": planned, "elapsed": elapsed}
    words = tr("{done} of {planned}, {elapsed:.0f} s", **values)
    if left is not None:
        words = tr("{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left", left=left, **values)
    return f"{walls}   {words}" if walls else words


class Runner(QObject):
    """Starts jobs of a session, one at a time, tells how far they are and hands on what they bring.

    case_starts : a case is about to run; started : a job has
    told(text, kind) : the word of the status line; kind : what it is about, for who may take it away again
    progressed(done, planned, words)
    found, judged : a hinge of a wall, a wall has its verdict while others run
    arrived(result) : of the case, which is still the one of the session
    accuracy_stated(k, accuracy) : of the k-th result
    refused(sentence) : why the job brings nothing
    ended(partly) : no job is left; partly : verdicts were told one by one
    """

    case_starts = Signal()
    started = Signal()
    told = Signal(str, str)
    progressed = Signal(int, int, str)
    found = Signal()
    judged = Signal()
    result_ready = Signal(object)
    accuracy_stated = Signal(int, object)
    refused = Signal(str)
    ended = Signal(bool)

    def __init__(self, session: Session, parent: QObject):
        super().__init__(parent)
        self.session = session
        self.finished_runs = MemoryJournal()
        self.job: Job | None = None
        self.is_uncancellable = self.cancelled = False
        self.finished_walls: list[WallResult] = []
        self.finished_results: dict[int, StudyResult] = {}
        """Row of a wall of what runs, all of which is there -> its results alone."""
        self.case: Case | None = None
        """That runs, or was cancelled: what was finished of it stays until another starts."""
        self.planned_results: dict[int, int] = {}
        """Row of a wall of what runs -> how many results it will have."""
        self.last_refusal: tuple[Case | None, InputError | None] = (None, None)
        """(case, what the last run of it refused)."""
        self._began = self._told_at = 0.0
        self._said: tuple[int, int, float | None, float] | None = None
        self.ticks = QTimer(self, interval=TICK_MS)
        self.ticks.timeout.connect(self._tick)

    def run(self) -> None:
        """Run the case off this thread; the window stays alive."""
        case = self.session.checked()
        if case is None or self.job is not None:
            return
        generation = self.session.generation
        base = self.session.base_dir
        self.planned_results = dict(enumerate(count_results_by_wall(case)))
        asked = case

        def arrived(result: StudyResult) -> None:
            if generation != self.session.generation:
                self.told.emit(tr("The input has changed: press F5."), "message")
                return
            if base != self.session.base_dir:  # saved elsewhere meanwhile
                result = self.session.relocate_result(result, base)
            self.result_ready.emit(result)
            text = "{n} analyses in {seconds:.1f} s"
            self.told.emit(tr(text, n=result.analyses, seconds=result.elapsed), "message")

        from core.study.run import run

        self.case_starts.emit()
        self.start(
            lambda job: run(
                case,
                base_dir=base,
                jobs=os.cpu_count() or 1,
                journal=lambda _: self.finished_runs,
                on_progress=job.progress,
                cancelled=job.cancelled,
                on_wall=job.found.emit,
                on_finished=job.found.emit,
            ),
            arrived,
        )
        self.case = asked

    def start(self, work: Callable[[Job], Any], arrived: Callable[[Any], None], to_end: bool = False) -> None:
        """Work off this thread, one at a time; `arrived(result)` unless it is cancelled before. to_end : the
        window does not close before its end."""
        if self.job is not None:
            return
        job = self.job = Job(work)
        self.is_uncancellable = to_end

        def unless_left(slot: Callable[..., None]) -> Callable[..., None]:
            return lambda *values: slot(*values) if self.job is job else None

        job.done.connect(unless_left(arrived))
        job.failed.connect(unless_left(self.fail))
        job.progressed.connect(unless_left(self._progressed))
        job.found.connect(unless_left(self._found))
        job.finished.connect(unless_left(self._ended))
        self._began, self._said, self.cancelled = time.monotonic(), None, False
        self.finished_walls, self.finished_results, self.case = [], {}, None
        self.ticks.start()
        self.told.emit(tr("Running…"), "message")
        job.start()
        self.started.emit()

    def zetas_so_far(self) -> dict[int, tuple[float | None, bool]]:
        """Row of a wall -> (the smallest zeta of its results that are there, whether these are all)."""
        return zetas_so_far(self.finished_walls, self.planned_results)

    def _found(self, part: WallResult | StudyResult) -> None:
        if isinstance(part, StudyResult):
            self.finished_results[part.walls[0].part.origin] = part
            self.judged.emit()
        else:
            self.finished_walls.append(part)
            self.found.emit()

    def _progressed(self, done: int, planned: int, left: float | None) -> None:
        from core.jit import native

        now = time.monotonic()
        if done and now - self._told_at < MIN_UPDATE_SECONDS:  # each paints the bar at once
            return
        self._told_at = now
        if done == 0 and native.lacks_lanes():
            words = tr("The solver is being compiled, once for each version: some seconds.")
            self.told.emit(words, "message")
        else:
            self._said = (done, planned, left, now)
            self._say(left)

    def _say(self, left: float | None) -> None:
        """How far the job is. left : time [s], None where it is not known"""
        done, planned, _, _ = require_value(self._said)
        whole = sum(all_there for _, all_there in self.zetas_so_far().values())
        walls = tr("Walls {n} of {m}", n=whole, m=len(self.planned_results)) if self.finished_walls else ""
        words = progress_word(done, planned, time.monotonic() - self._began, left, walls)
        self.progressed.emit(done, planned, words)
        self.told.emit(words, "message")

    def _tick(self) -> None:
        """The clock goes on while nothing is told: the time that is left shrinks with it."""
        if self._said is not None:
            _, _, left, at = self._said
            self._say(None if left is None else max(1.0, left - (time.monotonic() - at)))

    def _ended(self) -> None:
        self.ticks.stop()
        self.job, partly = None, bool(self.finished_walls)
        if not self.cancelled:
            self.forget_finished()
        self.ended.emit(partly)

    def forget_finished(self) -> None:
        """What was finished of a run that ended otherwise is of no use any more."""
        self.finished_walls, self.finished_results, self.case = [], {}, None

    @property
    def is_of_input(self) -> bool:
        """Whether what runs, or was cancelled, is the case as it stands."""
        return self.case is not None and self.case == self.session.checked()

    def fail(self, sentence: str, log: str) -> None:
        """Tell why there is no result. log : file with the details, empty for wrong input"""
        if log:
            sentence += "\n" + tr("Details are in {log}", log=log)
        self.last_refusal = (self.session.case, self.job.error if self.job else None)
        self.told.emit(tr("Not done."), "message")
        self.refused.emit(sentence)

    def cancel(self) -> None:
        """Stop what runs: at once here, its thread ends when it can. What is being written is written."""
        if self.job is not None and self.job.cancel():
            self.cancelled = True
            self._ended()
            self.told.emit(tr("Cancelled."), "message")
        elif self.job is not None:
            self.told.emit(tr("It is being written."), "message")

    def state_accuracy(self, k: int) -> None:
        """The accuracy statement of the k-th result, off this thread."""
        result = self.session.result
        if result is None or not 0 <= k < len(result.walls) or self.job is not None or self.session.stale:
            return
        from core.study.wall_tasks import make_accuracy_statement

        wall, motions, method, search = result.walls[k], result.motions, result.method, result.search

        def arrived(accuracy: Accuracy | None) -> None:
            self.told.emit("", "")
            now = self.session.result
            if now is not None and now.walls is result.walls:
                walls = list(now.walls)
                walls[k] = replace(walls[k], accuracy=accuracy)
                self.session.result = replace(now, walls=tuple(walls))
                self.accuracy_stated.emit(k, accuracy)

        self.start(lambda job: make_accuracy_statement(wall, motions, method, search, job.cancelled), arrived)
