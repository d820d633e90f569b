"""The command line in the language of the terminal: what it takes, and what it says of what it does not."""

import argparse
import contextlib
import difflib
import re
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

from app.look.language import terminal
from core.errors import InputError
from core.ooxml.package import DAMAGED
from core.packages import MAX_WALLS_IN_WORKBOOK
from core.regular_file import open_regular, read_regular

STUDIES = Path(__file__).resolve().parents[2] / "resources" / "studies"
SHIPPED_STUDIES = "paper", "law"
"""Studies that come with the program, asked for by name."""

REFUSED = (
    (re.compile(r"unrecognized arguments: (?P<words>.*)", re.DOTALL), "not known here: {words}"),
    (re.compile(r"argument (?P<words>\S+): expected .*"), "{words} takes a value"),
    (re.compile(r"argument (?P<words>\S+): ignored explicit argument .*"), "{words} takes no value"),
    (re.compile(r"ambiguous option: (?P<words>\S+) .*"), "{words} may mean several options: write it out"),
)
"""(what argparse says, the text of the terminal for it)."""


class Formatter(argparse.HelpFormatter):
    """Help whose first word is in the language of the terminal."""

    def add_usage(self, usage, actions, groups, prefix=None):
        super().add_usage(usage, actions, groups, terminal("usage: ") if prefix is None else prefix)


NOTES = (".pdf", ".docx")
"""Endings of a calculation note."""


class Parser(argparse.ArgumentParser):
    """An argument parser that refuses in the language of the terminal, with exit code 2."""

    def error(self, message: str):
        for pattern, text in REFUSED:
            match = pattern.fullmatch(message)
            if match:
                message = terminal(text, words=match["words"]) + self._nearest(match["words"])
                break
        words = terminal("error: {error}", error=message.removeprefix("argument "))
        self.exit(2, f"{self.format_usage()}{words}\n")

    def _nearest(self, words: str) -> str:
        """The known options that the unknown among these words were meant to be."""
        known = [name for action in self._actions for name in action.option_strings]
        options = [word.split("=")[0] for word in words.split() if word.startswith("-")]
        near = [name for word in options if word not in known for name in difflib.get_close_matches(word, known, 1)]
        return terminal("; did you mean {nearest}?", nearest=", ".join(near)) if near else ""


def parser() -> Parser:
    """The command line."""
    made = Parser(
        prog="ribalta",
        description=terminal("How strong an earthquake a masonry wall withstands before it overturns."),
        formatter_class=Formatter,
        add_help=False,
    )
    group = made.add_argument_group(terminal("arguments"))
    add = group.add_argument
    add("case", nargs="?", type=Path, help=terminal("case file to open in the window"))
    add("--batch", type=Path, metavar="CASE", help=terminal("run a case without a window"))
    add("--study", metavar="STUDY", help=terminal("run a parametric study: paper, law or a file"))
    add("--quick", action="store_true", help=terminal("a short form of the study"))
    add("--pack", action="store_true", help=terminal("runs, results, seeds, hashes and versions in one archive too"))
    add(
        "--records",
        type=Path,
        metavar="DIR",
        help=terminal("natural records of the study; of El Centro 1940 for --validate"),
    )
    add("--output", type=Path, metavar="DIR", help=terminal("folder of the results"))
    add("--jobs", type=_jobs, metavar="N", help=terminal("threads (default: all cores)"))
    add("--report", type=Path, metavar="FILE", help=terminal("the calculation note too, as a PDF or for Word (.docx)"))
    add("--extract", type=Path, metavar="NOTE", help=terminal("write the case and the results within a note (PDF)"))
    add("--quiet", action="store_true", help=terminal("no progress, no summary"))
    add("--resume", action="store_true", help=terminal("go on from the journal"))
    add("--part", type=_part, metavar="K/N", help=terminal("the walls of one part of the case alone, see --merge"))
    add("--merge", action="store_true", help=terminal("the results of all parts of the case"))
    add("--force", action="store_true", help=terminal("overwrite what is of another case or program, or was edited"))
    add(
        "--scheduler",
        type=_scheduler,
        metavar="WORD",
        help=terminal("walls on the workers of Dask: tcp://HOST:PORT, or local:8 for so many processes"),
    )
    contents = terminal("summarise the contents of records and drawings")
    add(
        "--verify",
        type=Path,
        metavar="REPORT",
        help=terminal("run the case within a report again and compare, see --records"),
    )
    add("--validate", action="store_true", help=terminal("the solved cases; with --data, tests on a shake table"))
    add(
        "--export-check",
        type=Path,
        metavar="CASE",
        help=terminal("write each wall as a script that checks it by scipy"),
    )
    add("--data", type=Path, metavar="DIR", help=terminal("folder of the tests"))
    add("--inspect", nargs="+", type=Path, metavar="FILE", help=contents)
    add("--version", action="store_true", help=terminal("version and commit"))
    add("-h", "--help", action="help", help=terminal("this help"))
    return made


def _jobs(word: str) -> int:
    if not word.isascii() or not word.isdigit() or not 1 <= int(word) <= 1024:
        raise argparse.ArgumentTypeError(terminal("{word!r} is not a number of threads from 1 to 1024", word=word))
    return int(word)


def _part(word: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", word)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(terminal("{word!r} is not a part such as 2/8", word=word))
    return int(match[1]), int(match[2])


def _scheduler(word: str) -> str:
    known = re.fullmatch(r"local:[0-9]{1,4}|(tcp|tls)://[^\s/]+:[0-9]{1,5}", word, re.ASCII)
    most = 1024 if word.startswith("local:") else 65535
    if not known or not 1 <= int(word.rsplit(":", 1)[1]) <= most:
        text = "{word!r} is neither a scheduler such as tcp://host:8786 nor processes here such as local:8"
        raise argparse.ArgumentTypeError(terminal(text, word=word))
    return word


def parse(arguments: list[str] | None) -> argparse.Namespace:
    """What is asked. Ends the program with exit code 2 where words do not go together."""
    line = parser()
    options = line.parse_args(arguments)
    for apart, words in _apart(options):
        if apart:
            line.error(words)
    return options


def _apart(asked: argparse.Namespace) -> Iterator[tuple[object, str]]:
    """What does not go together: whether it is so, and what is said then."""
    jobs = (asked.batch, asked.inspect, asked.study, asked.extract, asked.validate, asked.verify, asked.export_check)
    text = "--batch, --study, --inspect, --extract, --validate, --verify and --export-check do not go together"
    yield sum(map(bool, jobs)) > 1, terminal(text)
    yield asked.force and (asked.part or not asked.batch), terminal("--force goes with --batch")
    yield asked.data and not asked.validate, terminal("--data goes with --validate")
    runs = asked.batch or asked.study
    with_threads = asked.jobs and not asked.verify
    yield not runs and (asked.resume or with_threads), terminal("--jobs and --resume go with --batch or --study")
    writes = runs or asked.extract or asked.validate or asked.export_check
    text = "--output goes with --batch, --study, --extract, --validate or --export-check"
    yield asked.output and not writes, terminal(text)
    yield asked.report and not asked.batch, terminal("--report goes with --batch")
    yield (asked.part or asked.merge) and not asked.batch, terminal("--part and --merge go with --batch")
    text = "--scheduler goes with --batch, without --part and --merge"
    yield asked.scheduler and (not asked.batch or asked.part or asked.merge), terminal(text)
    text = "--part goes on by itself and writes no results: leave out --merge, --report and --resume"
    yield asked.part and (asked.merge or asked.report or asked.resume), terminal(text)
    takes_records = asked.study or asked.verify or asked.validate
    text = "--quick and --pack go with --study, --records with --study, --verify or --validate"
    yield ((asked.quick or asked.pack) and not asked.study) or (asked.records and not takes_records), terminal(text)


def study_file(asked: str) -> Path:
    """The file of a study: a name of those that come with the program, or a path."""
    return STUDIES / f"{asked}.toml" if asked in SHIPPED_STUDIES else Path(asked)


def refuse_missing(options: argparse.Namespace) -> None:
    """Raise InputError for a file that is not there or a note that is no Word document: before anything is installed
    or imported for it."""
    for case in (options.case, options.batch, options.extract, options.export_check):
        if case is not None and not case.exists():
            raise InputError("no_case_file", place=(case,))
    if options.data is not None and not options.data.is_dir():
        raise InputError("no_data_folder", place=(options.data,))
    if options.study and not study_file(options.study).exists():
        raise InputError("no_study_file", place=(options.study,))
    if options.report:
        refuse_other_note(options.report, options.batch)


def refuse_other_note(path: Path, case: Path) -> None:
    """Raise InputError for a calculation note in another form than a PDF or a Word document."""
    if path.suffix.lower() not in NOTES:
        raise InputError("note_is_pdf", path=path, place=(case,))


def extras(options: argparse.Namespace) -> list[str]:
    """Groups of packages that what is asked needs beside the base."""
    if options.inspect:
        return ["dxf"] if any(is_drawing(file) for path in options.inspect for file in files_of(path)) else []
    if options.validate:
        return ["report"] if options.output else []
    if options.verify:
        return ["report", "accuracy", "dxf"]
    if options.study:
        return ["study"]
    if options.extract:
        return ["report"]
    if options.export_check:
        of_note = options.export_check.suffix.lower() == ".pdf"
        drawn = _states(options.export_check, lambda case: any("drawing" in wall for wall in case["wall"]))
        return ["report"] * of_note + ["dxf"] * drawn
    if not options.batch:
        return ["gui", "accuracy", "study", "report", "dxf"]
    of_note = options.batch.suffix.lower() == ".pdf"
    asked = {
        "accuracy": _states(options.batch, lambda case: case["analysis"]["accuracy"] is True),
        "dxf": _states(options.batch, lambda case: any("drawing" in wall for wall in case["wall"])),
        "report": options.report or of_note,
        "scheduler": bool(options.scheduler),
        "parquet": not options.part and _may_be_large(options.batch),
    }
    return [extra for extra, wanted in asked.items() if wanted]


def files_of(path: Path) -> list[Path]:
    """The files of a folder by name; a file, what is not there, and an empty folder as it is."""
    with contextlib.suppress(OSError):
        return sorted(file for file in path.iterdir() if file.is_file()) or [path]
    return [path]


def is_drawing(path: Path) -> bool:
    """Whether a file is a drawing, by its name."""
    return path.suffix.lower() == ".dxf"


def _states(case: Path, asked: Callable[[dict], bool]) -> bool:
    """Whether a case asks for something; False also for one that cannot be read."""
    try:
        return asked(tomllib.loads(read_regular(case, MAX_CASE_BYTES).decode("utf-8-sig")))
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return False


MAX_CASE_BYTES, LONGEST_HEAD, MAX_SHEET_BYTES = 2_000_000, 1_000_000, 500_000_000
"""Bytes looked at before packages are there: of a case, of the first row of a table, of a sheet."""

HINGES_OF_ROW, MAX_HINGES_LISTED, MECHANISMS_OF_HINGE = 6, 14, 2
"""A row of a table has hinges at its base, its loads and its tie, beside those of the storeys; most that are listed;
mechanisms of each."""


def _may_be_large(case: Path) -> bool:
    """Whether a case can have more results than a workbook holds, by the rows of its files alone; False also for one
    that cannot be read."""
    try:
        text = read_regular(case, MAX_CASE_BYTES).decode("utf-8-sig")
        content = tomllib.loads(text)
        walls, head = text.count("[[wall]]"), text
        if "walls" in content:
            table = case.parent / content["walls"].replace("\\", "/")
            rows, first = _rows_of_workbook(table) if table.suffix.lower() == ".xlsx" else _rows_of_text(table)
            walls, head = walls + rows, head + first
        hinges = HINGES_OF_ROW + content.get("building", {}).get("storeys", 0)
        hinges += MAX_HINGES_LISTED if "hinge" in head or "cernier" in head else 0
        return MECHANISMS_OF_HINGE * walls * hinges > MAX_WALLS_IN_WORKBOOK
    except (*DAMAGED, AttributeError, RecursionError):
        return False


def _rows_of_text(table: Path) -> tuple[int, str]:
    """(rows, the first in small letters) of a table of walls as text. Raises OSError."""
    with open_regular(table) as stream:
        first = stream.readline(LONGEST_HEAD)
        rows = sum(piece.count(b"\n") for piece in iter(lambda: stream.read(1 << 20), b"")) + 1
    return rows, first.decode("utf-8", "replace").lower()


def _rows_of_workbook(table: Path) -> tuple[int, str]:
    """(rows of all sheets, up to those that tell, what stands for the heads: hinges may be listed) of a workbook, of
    which no package is needed. Raises what a damaged one does."""
    rows = 0
    with open_regular(table) as stream, zipfile.ZipFile(stream) as package:
        for name in package.namelist():
            if "sheet" not in name.lower() or not name.lower().endswith(".xml"):
                continue
            with package.open(name) as part:
                end, left = b"", MAX_SHEET_BYTES
                while rows <= MAX_WALLS_IN_WORKBOOK and left > 0 and (piece := part.read(1 << 16)):
                    left -= len(piece)
                    rows += len(re.findall(rb"<(?:\w+:)?row[\s>]", end + piece))
                    end = piece[-8:]  # of a tag cut in two; one that is whole there counts twice, on the safe side
    return rows, "hinge"
