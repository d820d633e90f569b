"""What runs off the thread of the window: a case, an export, an accuracy statement; one at a time."""

import os
import time
from dataclasses import replace

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QMainWindow, QMessageBox

from app.look.labels import plain
from app.look.language import tr
from app.work.worker import Job
from core.case.hinges import hinges_of
from core.case.schema import Case

BETWEEN_WORDS = 0.1
"""Least time between two states of the progress bar [s]: each paints the window at once."""


def progress_word(done: int, planned: int, elapsed: float, left: float | None) -> str:
    """How much is done, and the time left [s] where it is known."""
    values: dict = {"done": done, "planned": planned, "elapsed": elapsed}
    if left is None:
        return tr("{done} of {planned}, {elapsed:.0f} s", **values)
    return tr("{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left", left=left, **values)


def results_planned(case: Case) -> list[int]:
    """Of each wall of a case one for each of its hinges and mechanisms."""
    return [(1 + len(hinges_of(wall, case.building))) * len(wall.mechanisms()) for wall in case.wall]


class RunningWindow(QMainWindow):
    """The part of the window that starts jobs, shows how far they are and takes what they bring."""

    job: Job | None = None
    began = told = 0.0
    closing = to_end = False
    finished_walls: list = []
    planned_results: dict[int, int] = {}
    """Row of a wall of what runs -> how many results it will have."""
    refused: tuple = (None, None)
    """(case, what the last run of it refused: an InputError or None)."""

    def show_word(self, text: str, kind: str = "message") -> None:
        """The word of the status line. kind : what it is about, for who may take it away again."""
        self.word.setText(text)
        self.word.setToolTip(plain(text))
        self.word_kind = kind

    def show_running(self, on: bool) -> None:
        """Progress over the stage, and Cancel in the place of Run, while there is something to cancel."""
        self.bar.setVisible(on)
        self.cancel_button.setVisible(on)
        self.run_button.setVisible(not on)
        self.actions_of.cancel.setEnabled(on)

    def run(self) -> None:
        """Run the case off this thread; the window stays alive."""
        case = self.session.checked()
        if case is None or self.job is not None or not self.run_action.isEnabled():
            return
        generation, made = self.session.generation, self.finished_runs.analyses
        base = self.session.base_dir
        self.planned_results = dict(enumerate(results_planned(case)))

        def arrived(result) -> None:
            if generation != self.session.generation:
                self.show_word(tr("The input has changed: press F5."))
            else:
                if base != self.session.base_dir:  # saved elsewhere meanwhile
                    result = self.session.moved_result(result, base)
                self.result_arrived(result)
                self.show_answer()
                self.show_word(
                    tr("{n} analyses in {seconds:.1f} s", n=self.finished_runs.analyses - made, seconds=result.elapsed)
                )

        from core.study.run import run

        self.records.read_again()
        self.show_page("walls")
        self.start(
            lambda job: run(
                case,
                base_dir=base,
                jobs=os.cpu_count() or 1,
                journal=lambda _: self.finished_runs,
                on_progress=job.progress,
                cancelled=job.cancelled,
                on_wall=job.found.emit,
            ),
            arrived,
        )

    def start(self, work, arrived, to_end: bool = False) -> None:
        """Work off this thread, one at a time; `arrived(result)` unless it is cancelled before. to_end : the
        window does not close before its end."""
        if self.job is not None:
            return
        job = self.job = Job(work)
        self.to_end = to_end

        def unless_left(slot):
            return lambda *values: slot(*values) if self.job is job else None

        job.done.connect(unless_left(arrived))
        job.failed.connect(unless_left(self.failed))
        job.progressed.connect(unless_left(self._progressed))
        job.found.connect(unless_left(self._found))
        job.finished.connect(unless_left(self._ended))
        self.began = time.monotonic()
        self.bar.setRange(0, 0)
        self.finished_walls = []
        self.show_word(tr("Running…"))
        self.show_running(True)
        job.start()
        self.refresh()

    def zetas_so_far(self) -> dict[int, tuple[float | None, bool]]:
        """Row of a wall -> (the smallest zeta of its results that are there, whether these are all)."""
        of_row: dict[int, list] = {}
        for wall in self.finished_walls:
            of_row.setdefault(wall.part.origin, []).append(wall.assessment.verdict.zeta_e if wall.assessment else None)
        return {
            row: (
                min((zeta for zeta in found if zeta is not None), default=None),
                len(found) >= self.planned_results[row],
            )
            for row, found in of_row.items()
        }

    def _found(self, wall) -> None:
        """A wall has its verdict while others run."""
        self.finished_walls.append(wall)
        self.show_finished(self.finished_walls)

    def _progressed(self, done: int, planned: int, left: float | None) -> None:
        from core.jit import cache

        now = time.monotonic()
        if done and now - self.told < BETWEEN_WORDS:  # each paints the bar at once
            return
        self.told = now
        if done == 0 and cache.lacks_lanes():
            self.show_word(tr("The solver is being compiled, once for each version: some seconds."))
            return
        self.bar.setRange(0, max(planned, 1))
        self.bar.setValue(done)
        words = progress_word(done, planned, now - self.began, left)
        self.bar.setFormat(words.replace("%", "%%"))
        self.show_word(words)

    def _ended(self) -> None:
        self.job = None
        self.bar.setFormat("")
        if self.finished_walls:  # cancelled, failed or of an earlier input: the last result again, or none
            self.fresh.discard(self.pages["walls"])
            if self.session.result is None:
                self.pages["walls"].empty()
            self.show_result()
        self.finished_walls = []
        self.show_running(False)
        self.refresh()
        if self.closing:
            QTimer.singleShot(0, self.close)

    def failed(self, sentence: str, log: str) -> None:
        if log:
            sentence += "\n" + tr("Details are in {log}", log=log)
        self.closing = False
        self.refused = (self.session.case, self.job.error if self.job else None)
        self.show_word(tr("Not done."))
        QMessageBox.warning(self, tr("Not done"), plain(sentence))

    def cancel(self) -> None:
        """Stop what runs: at once here, its thread ends when it can. What is being written is written."""
        if self.job is not None and self.job.cancel():
            self._ended()
            self.show_word(tr("Cancelled."))
        elif self.job is not None:
            self.show_word(tr("It is being written."))

    def state_accuracy(self) -> None:
        """The accuracy statement of the wall shown, off this thread."""
        result, k = self.session.result, self.shown
        if self.wall is None or self.job is not None or self.session.stale:
            return
        from core.study.wall_work import accuracy_of

        def arrived(accuracy) -> None:
            self.show_word("", "")
            shown = self.session.result
            if shown is not None and shown.walls is result.walls:
                walls = list(shown.walls)
                walls[k] = replace(walls[k], accuracy=accuracy)
                self.session.result = replace(shown, walls=tuple(walls))
                if self.shown == k:
                    self.pages["validation"].content.show_accuracy(accuracy)

        wall = result.walls[k]
        self.start(lambda job: accuracy_of(wall, result.motions, result.method, result.search, job.cancelled), arrived)
