"""Kernels compiled or loaded in the background, as soon as a case needs them, and the self-test of them; then what sets
a note."""

import contextlib
from typing import TYPE_CHECKING

from app.look.language import tr
from app.work.worker import Job
from core.errors import InputError
from core.jit import cache, native

if TYPE_CHECKING:
    from app.shell.window import MainWindow
    from core.study.self_test import Outcome


class Preparation:
    """Makes the kernels of the case's method ready, once for each method, while the window has no job.

    outcome : of the self-test, None before it
    """

    def __init__(self, window: "MainWindow"):
        self.window = window
        self.started = False
        self.methods: set[str] = set()
        self.job: Job | None = None
        self.outcome: Outcome | None = None

    def begin(self) -> None:
        """From now on; before it the window is still being made."""
        self.started = True
        self.prepare_next()

    def prepare_next(self) -> None:
        """Prepare what the case at hand needs, if it is not prepared and nothing else runs."""
        window = self.window
        if not self.started or self.job or window.runner.job or not window.records.motions:
            return
        case = window.session.checked()
        if case is None or case.analysis.method in self.methods:
            return
        motion = window.records.motions[0]
        self.methods.add(case.analysis.method)
        if window.word_kind in ("", "ready"):
            window.show_word(
                tr("Compiling the solver, once for each version: some seconds…")
                if native.lacks_lanes()
                else tr("Preparing the solver…"),
                "preparing",
            )

        def work(job):
            from core.study.run import warm_kernels
            from core.study.self_test import compare_answers

            ready = warm_kernels(case, motion)
            cache.record(cache.folder())
            if ready:
                job.found.emit(compare_answers(ready))
            with contextlib.suppress(InputError):  # without its packages the note says so itself
                from core.report.note.archive import Note
                from core.report.note.parts import Paragraph

                Note([Paragraph("-")], "en").pages(30.0)

        def ended() -> None:
            self.job = None
            if window.word_kind == "preparing":
                window.show_word(tr("Ready."), "ready")
            self.prepare_next()

        self.job = Job(work)
        self.job.failed.connect(lambda sentence, log: window.show_word(f"{sentence} {log}"))
        self.job.found.connect(self.tested)
        self.job.finished.connect(ended)
        self.job.start()

    def tested(self, outcome: "Outcome") -> None:
        """Keep what the self-test tells; a failure is said at once, and stays."""
        if not (self.outcome and self.outcome.wrong):
            self.outcome = outcome
        if outcome.wrong:
            self.window.warn_of_self_test()
