"""The command line in the language of the terminal: what it takes, and what it says of what it does not."""

import argparse
import re
from pathlib import Path

from app.language import terminal

REFUSED = (
    (re.compile(r"unrecognized arguments: (?P<words>.*)", re.DOTALL), "not known here: {words}"),
    (re.compile(r"argument (?P<words>\S+): expected .*"), "{words} takes a value"),
    (re.compile(r"argument (?P<words>\S+): ignored explicit argument .*"), "{words} takes no value"),
    (re.compile(r"ambiguous option: (?P<words>\S+) .*"), "{words} may mean several options: write it out"),
)  # fmt: skip
"""(what argparse says, the text of the terminal for it)."""


class Formatter(argparse.HelpFormatter):
    """Help whose first word is in the language of the terminal."""

    def add_usage(self, usage, actions, groups, prefix=None):
        super().add_usage(usage, actions, groups, terminal("usage: ") if prefix is None else prefix)


class Parser(argparse.ArgumentParser):
    """An argument parser that refuses in the language of the terminal, with exit code 2."""

    def error(self, message: str):
        for pattern, text in REFUSED:
            found = pattern.fullmatch(message)
            if found:
                message = terminal(text, words=found["words"])
                break
        words = terminal("error: {error}", error=message.removeprefix("argument "))
        self.exit(2, f"{self.format_usage()}{words}\n")


def parser() -> Parser:
    """The command line."""
    made = Parser(
        prog="ribalta",
        description=terminal(
            "How strong an earthquake a masonry wall withstands before it overturns."
        ),
        formatter_class=Formatter,
        add_help=False,
    )
    group = made.add_argument_group(terminal("arguments"))
    add = group.add_argument
    add("case", nargs="?", type=Path, help=terminal("case file to open in the window"))
    add("--batch", type=Path, metavar="CASE", help=terminal("run a case without a window"))
    add("--study", metavar="STUDY", help=terminal("run a parametric study: paper, law or a file"))
    add("--quick", action="store_true", help=terminal("a short form of the study"))
    add("--records", type=Path, metavar="DIR", help=terminal("natural records of the study"))
    add("--output", type=Path, metavar="DIR", help=terminal("folder of the results"))
    add("--jobs", type=_jobs, metavar="N", help=terminal("threads (default: all cores)"))
    add("--report", type=Path, metavar="FILE",
        help=terminal("the calculation note too, as a Word document (.docx)"))  # fmt: skip
    add("--quiet", action="store_true", help=terminal("no progress, no summary"))
    add("--resume", action="store_true", help=terminal("go on from the journal"))
    add("--inspect", nargs="+", type=Path, metavar="FILE", help=terminal("say what records hold"))
    add("--version", action="store_true", help=terminal("version and commit"))
    add("-h", "--help", action="help", help=terminal("this help"))
    return made


def _jobs(word: str) -> int:
    if not word.isascii() or not word.isdigit() or not 1 <= int(word) <= 1024:
        raise argparse.ArgumentTypeError(
            terminal("{word!r} is not a number of threads from 1 to 1024", word=word)
        )
    return int(word)
