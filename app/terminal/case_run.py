"""What surrounds every run of a case without a window: exit codes, folders, Ctrl-C, what a terminal shows."""

import contextlib
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

from app.look.language import current_language, terminal
from app.terminal.terminal_progress import tell
from core import atomic_write
from core.errors import Cancelled, InputError
from core.study.journal import SYNC_SECONDS, Journal
from core.study.scheduler import DaskExecutor, open_dask_executor
from core.text.sentence import format_number, word

DONE, WITHOUT_NUMBER, CANCELLED = 0, 3, 130
"""Exit codes; 1 input or output error and 2 wrong usage are of __main__, 4 an internal error."""

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "cases"
"""Cases that come with the program: their results land in the folder one stands in."""


def results_of(case_path: Path, output: Path | None) -> tuple[Path, str]:
    """(folder, stem) of the results of a case."""
    shipped = case_path.resolve().parent == EXAMPLES
    return output or (Path() if shipped else case_path.parent), case_path.stem


@contextlib.contextmanager
def make_folders(case_path: Path, *folders: Path):
    """These folders, made where they are missing. An InputError inside names the case, and those just made go."""
    new: list[Path] = []
    try:
        for folder in folders:
            new += atomic_write.check_folder(folder)
        yield
    except InputError as error:
        for one in new:
            with contextlib.suppress(OSError):
                one.rmdir()
        raise error.at(case_path) from None


def open_journal(path: Path, key: str, resume: bool) -> Journal:
    """The journal of a batch or a study; what became of an earlier one is said on stderr."""
    return report_journal(Journal(path, key, resume, SYNC_SECONDS))


def report_journal(book: Journal) -> Journal:
    """A journal; what became of an earlier one is said on stderr."""
    if book.set_aside:
        tell(
            "finished runs of an earlier start are in {path}: to go on with them, rename it and add --resume",
            path=book.set_aside,
        )
    if book.dropped:
        tell("{n} damaged line(s) of the journal were dropped: these runs are repeated", n=book.dropped)
    return book


def say(text: str) -> None:
    """Print what a closed or full stdout may refuse: the results are on disk already."""
    try:
        print(text, flush=True)
    except OSError:
        sys.stdout = None


@contextlib.contextmanager
def executor_of(word: str | None) -> Iterator[DaskExecutor | None]:
    """The executor of --scheduler, none without a word. Raises InputError where no scheduler answers."""
    if word is None:
        yield None
        return
    with open_dask_executor(word) as executor:
        if not executor.threads():
            tell("{address} has no worker yet: waiting for the first", address=word)
        yield executor


RULES = ("minimum", "too_few", "incomplete")
"""Rules of a set whose words are the terminal's own."""


def aligned(table: list[list[str]], numbers: tuple[int, ...] = (3, 4, 5)) -> list[str]:
    """The lines of a table with a head, each column as wide as it needs. numbers : columns that end in line"""
    least = (24, 10, 10, 6, 7, 6, 16, 0)
    widths = [
        max(wide, *(len(row[k]) if k < len(row) else 0 for row in table))
        for k, wide in enumerate(least[: len(table[0])])
    ]
    return [
        " ".join(
            f"{cell:>{wide}}" if k in numbers else f"{cell:{wide}}"
            for k, (cell, wide) in enumerate(zip(row, widths, strict=False))
        ).rstrip()
        for row in table
    ]


def code_word(code: str | None) -> str:
    """A code of the results; in words where the terminal speaks another language than the codes."""
    if code is None or current_language() == "en":
        return code or "-"
    return terminal(code) if code in RULES else word(code, current_language())


def format_short(value: float | None) -> str:
    """A number of the summary."""
    return "-" if value is None else format_number(value, ".2f", current_language())


def raise_if_cancelled(cancel: threading.Event) -> Callable[[], None]:
    """A look whether Ctrl-C was pressed: raises Cancelled."""

    def check() -> None:
        if cancel.is_set():
            raise Cancelled

    return check


@contextlib.contextmanager
def cancel_on_interrupt(cancel: threading.Event):
    """Ctrl-C asks the run to stop between two analyses; a second one stops at once."""

    def handler(number, frame):
        if cancel.is_set():
            raise KeyboardInterrupt
        cancel.set()

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    old = signal.signal(signal.SIGINT, handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, old)
