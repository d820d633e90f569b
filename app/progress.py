"""Progress of a batch on a terminal, and the time left of a stage of the work."""

import contextlib
import sys
import time
from collections.abc import Callable, Iterator

from app.language import current_language, terminal
from core.jit import cache
from core.text.sentence import word

BETWEEN_LINES = 10.0
"""Seconds between two lines where no terminal is."""

BAR = 24
"""Characters of the bar."""


class Pace:
    """Time left of one stage by the pace of what it finished itself; other stages take another time for each."""

    def __init__(self, clock: Callable[[], float] = time.monotonic):
        self.clock, self.stage = clock, ""
        self.known, self.first = 0, (0.0, 0)

    def left(self, done: int, planned: int, stage: str) -> float | None:
        """[s]; None until two have been finished, since the first waits for the compiler, and what the journal knew
        takes no time."""
        if stage != self.stage:
            self.stage, self.known, self.first = stage, done, (0.0, done)
        if done > self.known == self.first[1]:
            self.first = self.clock(), done
        since, count = self.first
        if done <= max(count, self.known):
            return None
        return (self.clock() - since) / (done - count) * (planned - done)

    def sentence(self, done: int, planned: int, stage: str) -> str:
        """What is done, of how many, and the time left where it is known."""
        left = self.left(done, planned, stage)
        what = word(stage, current_language())
        if left is None:
            return terminal("{what}: {done} of {planned}", what=what, done=done, planned=planned)
        return terminal(
            "{what}: {done} of {planned}, about {left:.0f} s for the others",
            what=what, done=done, planned=planned, left=left,
        )  # fmt: skip


@contextlib.contextmanager
def progress(quiet: bool) -> Iterator[Callable[[int, int, str], None]]:
    """A callback that shows progress on stderr: a bar on a terminal, else a line every ten seconds; its first call
    says that the solver is compiled, where it is."""
    pace = Pace()
    last = [time.monotonic()]
    compiled: list[bool] = []
    on_terminal = not quiet and sys.stderr.isatty()

    def show(done: int, planned: int, stage: str) -> None:
        if quiet:
            return
        if not compiled and done < planned and cache.lacks_lanes():
            _print(
                terminal(
                    "the solver is being compiled, once for each version: it takes some seconds"
                )
            )
        compiled.append(True)
        sentence = pace.sentence(done, planned, stage)
        if on_terminal:
            full = round(BAR * done / max(planned, 1))
            _print(f"\r\x1b[K{'█' * full}{'░' * (BAR - full)} {sentence}", end="")
        elif done and time.monotonic() - last[0] >= BETWEEN_LINES:
            last[0] = time.monotonic()
            _print(sentence)

    try:
        yield show
    finally:
        if on_terminal:
            _print("\r\x1b[K", end="")


def _print(text: str, end: str = "\n") -> None:
    print(text, file=sys.stderr, flush=True, end=end)
