"""The program: `--batch` without a window, else the window; wrong input is one line and exit code 1."""

import argparse
import contextlib
import faulthandler
import os
import sys
import tempfile
import traceback
import warnings
from pathlib import Path

from app.look.language import quoted_from_file, set_language, terminal
from app.terminal import system_libraries
from app.terminal.command_line import parse, refuse_missing
from app.terminal.display import refuse_without_display
from core.errors import InputError
from core.file_names import shown
from core.jit import cache, trial
from core.packages import way_to_get
from core.text.start import system_language
from core.version import line


def window(case: Path | None) -> int:
    """The window, imported here so that nothing else needs Qt. Raises InputError where Qt cannot start."""
    if sys.platform.startswith("linux"):  # Qt would end the process
        refuse_without_display(os.environ)
        if not getattr(sys, "frozen", False):  # the frozen program brings them along
            system_libraries.refuse_without()
    try:
        from app.look.quick_imports import quicken

        quicken()
        from app.shell import start as qt
    except ImportError as error:
        way = way_to_get("PySide6-Essentials pyqtgraph")
        raise InputError("window_needs_qt", reason=str(error), way=way) from None
    return qt.main(case)


def _machine_code_is_right() -> bool:
    from core.study.self_test import numbers_are_right

    return numbers_are_right()


def tell(text: str) -> None:
    """A sentence on the terminal; in a dialog where there is none, as of the window's own program on Windows."""
    if sys.stderr is not None:
        print(text, file=sys.stderr)
        return
    from app.shell import start as qt

    qt.show_start_error(text)


def extract(note: Path, folder: Path | None) -> int:
    """Write the files within a note; returns the exit code."""
    from core.case import note_file

    for path in note_file.extract(note, folder or note.parent):
        print(shown(str(path)))
    return 0


def carry_out(options: argparse.Namespace) -> int:
    """Do what the command line asks for; returns the exit code."""
    if options.version:
        print(line())
        return 0
    refuse_missing(options)
    if options.extract:
        return extract(options.extract, options.output)
    if options.inspect:
        from app.terminal.inspection import inspect

        return inspect(options.inspect)
    if options.verify:
        from app.terminal import verification

        return verification.verify(options.verify, options.records, options.jobs or os.cpu_count() or 1, options.quiet)
    if options.validate:
        from app.terminal import solved_cases

        return solved_cases.run(options.output, options.records, options.data)
    if options.export_check:
        from app.terminal import check_export

        return check_export.run(options.export_check, options.output)
    jobs = options.jobs or os.cpu_count() or 1
    if options.study:
        from app.terminal import study

        how = (options.quiet, options.quick, options.resume, options.pack)
        return study.run(options.study, options.output, options.records, jobs, *how)
    if options.batch:
        from app.terminal import batch

        if options.part:
            return batch.run_part(options.batch, options.output, jobs, options.quiet, *options.part)
        how = (options.quiet, options.resume, options.report, options.merge, options.force, options.scheduler)
        return batch.run(options.batch, options.output, jobs, *how)
    return window(options.case)


def main(arguments: list[str] | None = None) -> int:
    """Run the program; returns its exit code."""
    with contextlib.suppress(OSError, AttributeError, RuntimeError):  # no stderr: ribaltaw, a test
        if not faulthandler.is_enabled():  # whoever started it may be told of faults elsewhere
            faulthandler.enable()
    cache.own_process()
    os.environ.setdefault("OPENPYXL_LXML", "False")  # else a workbook is written in another way where lxml is installed
    set_language(system_language())
    trial.self_test[:] = [_machine_code_is_right]
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # a name the terminal cannot show must not end a run
            stream.reconfigure(errors="replace")
    options = parse(arguments)
    windowless = (
        options.batch
        or options.study
        or options.inspect
        or options.extract
        or options.validate
        or options.verify
        or options.export_check
    )  # nothing is said in a dialog
    if windowless and not (sys.stdout and sys.stderr):
        nowhere = open(os.devnull, "w")  # noqa: SIM115
        sys.stdout, sys.stderr = sys.stdout or nowhere, sys.stderr or nowhere
    try:
        return carry_out(options)
    except InputError as error:
        tell(terminal("error: {error}", error=quoted_from_file(error)))
        return 1
    except BrokenPipeError:
        sys.stdout = None
        return 0
    except KeyboardInterrupt:
        print(terminal("stopped"), file=sys.stderr)
        return 130
    except Exception as error:  # an internal error: its traceback goes to a file the user can send
        with tempfile.NamedTemporaryFile("w", prefix="ribalta-error-", suffix=".log", delete=False) as log:
            traceback.print_exc(file=log)
        for note in getattr(error, "__notes__", ()):
            tell(note)
        tell(terminal("internal error: no file was left half written; please send {path}", path=log.name))
        return 4


if __name__ == "__main__":
    warnings.simplefilter("ignore")  # of libraries, to developers; the tests take each for an error
    sys.exit(main())
