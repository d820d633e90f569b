"""How far a batch or a study is, on stderr: a bar on a terminal, else a line every ten seconds."""

import contextlib
import sys
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

from app.look.language import terminal
from core.jit import native

BETWEEN_LINES = 10.0
"""Least time between two lines [s]."""

BAR, CLEAR = 24, "\x1b[K"
"""Characters of the bar; what deletes the rest of a line."""


def tell(text: str, /, **values) -> None:
    """A line on stderr."""
    print(terminal(text, **values), file=sys.stderr, flush=True)


class Shown(NamedTuple):
    """What shows how far it is.

    runs(done, planned, left) : runs and checks, and the time left [s], None where it is not known yet
    writing(done, planned) : of the files
    """

    runs: Callable[[int, int, float | None], None]
    writing: Callable[[int, int], None]


@contextlib.contextmanager
def progress(quiet: bool) -> Iterator[Shown]:
    """Shows progress; the first call says that the solver is compiled, where it is."""
    if quiet:
        yield Shown(lambda done, planned, left: None, lambda done, planned: None)
        return
    with _bars() if sys.stderr.isatty() else _lines() as shown:
        said = False

        def runs(done: int, planned: int, left: float | None) -> None:
            nonlocal said
            if not said and done < planned and native.lacks_lanes():
                tell("the solver is being compiled, once for each version: it takes some seconds")
            said = True
            shown.runs(done, planned, left)

        yield shown._replace(runs=runs)


@contextlib.contextmanager
def _bars() -> Iterator[Shown]:
    """One line of the terminal, written anew each time and gone at the end."""

    def show(done: int, planned: int, words: str) -> None:
        full = round(BAR * done / max(planned, 1))
        bar = "█" * full + "░" * (BAR - full)
        print(f"\r{bar} {words}{CLEAR}", file=sys.stderr, flush=True, end="")

    def writing(done: int, planned: int) -> None:
        show(done, planned, terminal("writing the results: {share:.0f} %", share=100 * done / planned))

    try:
        yield Shown(lambda done, planned, left: show(done, planned, _counted(done, planned, left)), writing)
    finally:
        print(f"\r{CLEAR}", file=sys.stderr, flush=True, end="")


@contextlib.contextmanager
def _lines() -> Iterator[Shown]:
    last = time.monotonic()

    def due() -> bool:
        nonlocal last
        now = time.monotonic()
        if now - last < BETWEEN_LINES:
            return False
        last = now
        return True

    def runs(done: int, planned: int, left: float | None) -> None:
        if done and due():
            print(_counted(done, planned, left), file=sys.stderr, flush=True)

    def writing(done: int, planned: int) -> None:
        if due():
            tell("writing the results: {share:.0f} %", share=100 * done / planned)

    yield Shown(runs, writing)


def _counted(done: int, planned: int, left: float | None) -> str:
    """How many runs and checks are done, and the time left where it is known."""
    if left is None:
        return terminal("{done}/{planned} runs and checks", done=done, planned=planned)
    return terminal("{done}/{planned} runs and checks, about {left:.0f} s left", done=done, planned=planned, left=left)
