"""The program: `--batch` without a window, else the window; wrong input is one line and exit code 1."""

import argparse
import contextlib
import faulthandler
import os
import sys
import tempfile
import traceback
from pathlib import Path

from app.language import quoted_from_file, set_language, system_language, terminal
from core.errors import InputError


def parser() -> argparse.ArgumentParser:
    """The command line."""
    made = argparse.ArgumentParser(
        prog="ribalta",
        description=terminal(
            "How strong an earthquake a masonry wall withstands before it overturns."
        ),
    )
    made.add_argument(
        "case", nargs="?", type=Path, help=terminal("case file to open in the window")
    )
    made.add_argument(
        "--batch", type=Path, metavar="CASE", help=terminal("run a case without a window")
    )
    made.add_argument(
        "--study", metavar="STUDY", help=terminal("run a parametric study: paper, law or a file")
    )
    made.add_argument("--quick", action="store_true", help=terminal("a short form of the study"))
    made.add_argument(
        "--records", type=Path, metavar="DIR", help=terminal("natural records of the study")
    )
    made.add_argument("--output", type=Path, metavar="DIR", help=terminal("folder of the results"))
    made.add_argument(
        "--jobs", type=_jobs, metavar="N", help=terminal("threads (default: all cores)")
    )
    made.add_argument(
        "--report",
        type=Path,
        metavar="FILE",
        help=terminal("the calculation note too, as a Word document (.docx)"),
    )
    made.add_argument("--quiet", action="store_true", help=terminal("no progress, no summary"))
    made.add_argument("--resume", action="store_true", help=terminal("go on from the journal"))
    made.add_argument(
        "--inspect", nargs="+", type=Path, metavar="FILE", help=terminal("say what records hold")
    )
    made.add_argument("--version", action="store_true", help=terminal("version and commit"))
    return made


def _jobs(word: str) -> int:
    if not word.isascii() or not word.isdigit() or not 1 <= int(word) <= 1024:
        raise argparse.ArgumentTypeError(
            terminal("{word!r} is not a number of threads from 1 to 1024", word=word)
        )
    return int(word)


def window(case: Path | None) -> int:
    """The window, imported here so that nothing else needs Qt. Raises InputError where Qt cannot start."""
    try:
        from app.quick_imports import quicken

        quicken()
        from app import start as qt
    except ImportError as error:
        raise InputError("window_needs_qt", reason=str(error)) from None
    if case is not None and not case.exists():
        raise InputError("no_case_file", place=(case,))
    return qt.main(case)


def main(arguments: list[str] | None = None) -> int:
    """Run the program; returns its exit code."""
    with contextlib.suppress(OSError, AttributeError):  # no stderr: a windowed program, a test
        faulthandler.enable()
    set_language(system_language())
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # a name the terminal cannot show must not end a run
            stream.reconfigure(errors="replace")
    options = parser().parse_args(arguments)
    if sum(map(bool, (options.batch, options.inspect, options.study))) > 1:
        parser().error(terminal("--batch, --study and --inspect do not go together"))
    if not (options.batch or options.study) and (options.output or options.resume or options.jobs):
        parser().error(terminal("--output, --jobs and --resume go with --batch or --study"))
    if options.report and not options.batch:
        parser().error(terminal("--report goes with --batch"))
    if not options.study and (options.quick or options.records):
        parser().error(terminal("--quick and --records go with --study"))
    try:
        if options.version:
            from core.version import NAME, VERSION, commit

            print(f"{NAME} {VERSION} {commit()[:12]}".strip())
            return 0
        if options.inspect:
            from app.inspection import inspect

            return inspect(options.inspect)
        jobs = options.jobs or os.cpu_count() or 1
        if options.study:
            from app import study

            return study.run(
                options.study, options.output, options.records, jobs, options.quiet, options.quick,
                options.resume,
            )  # fmt: skip
        if options.batch:
            from app import batch

            return batch.run(
                options.batch, options.output, jobs, options.quiet, options.resume, options.report
            )
        return window(options.case)
    except InputError as error:
        print(terminal("error: {error}", error=quoted_from_file(error)), file=sys.stderr)
        return 1
    except BrokenPipeError:
        sys.stdout = None
        return 0
    except KeyboardInterrupt:
        print(terminal("stopped"), file=sys.stderr)
        return 130
    except Exception:  # an internal error: its traceback goes to a file the user can send
        with tempfile.NamedTemporaryFile(
            "w", prefix="ribalta-error-", suffix=".log", delete=False
        ) as log:
            traceback.print_exc(file=log)
        print(
            terminal("internal error, nothing was written; please send {path}", path=log.name),
            file=sys.stderr,
        )
        return 4


if __name__ == "__main__":
    sys.exit(main())
