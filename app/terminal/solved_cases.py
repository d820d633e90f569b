"""`--validate`: the solved cases, in a table on the terminal, as a PDF and as JSON (NTC 2018, 10.2); with `--data`
tests on a shake table as well."""

import json
from pathlib import Path

from app.look.language import current_language
from app.terminal.batch import say
from core import atomic_write
from core.errors import InputError
from core.lab.research.shake_table import as_json as as_json_of_tests
from core.lab.research.shake_table import compared, read_tests
from core.lab.solved import shaken
from core.lab.solved.cases import cases_of, solve, subjects
from core.lab.solved.pack import NAME_OF_JSON, NAME_OF_PDF, as_json, called, pdf, summary, written
from core.lab.solved.solved import Solved, worded
from core.packages import require
from core.regular_file import first_bytes

NAME_OF_TESTS = "validation.json"

SEED = 1
"""Seed that draws the halves of the events."""

EXIT_DIFFERS = 5
"""Exit code where a case does not agree with its source, as of --verify."""

BEGINS = b'{\n "program": "Ribalta"'
"""How the results of an earlier run begin."""


def run(output: Path | None, records: Path | None, data: Path | None = None) -> int:
    """Ask the program for every answer, compare it with tests on a shake table, say what is found, and write the pack
    into a folder where one is named.

    records : folder whose record of El Centro 1940 adds its cases; data : folder of the tests, None where there are
        none. Raises InputError, OutputError.
    """
    if output is not None:
        require("report")
        _refuse_overwriting(output)
        if data is not None and (output / NAME_OF_TESTS).resolve() in {file.resolve() for file in data.iterdir()}:
            raise InputError("would_overwrite", path=output / NAME_OF_TESTS)
        atomic_write.check_folder(output)
    chosen, language = subjects(records), current_language()
    tests = read_tests(data) if data is not None else None
    cases = cases_of(chosen)
    differing = solve(cases)
    for line in lines(cases):
        say(line)
    files, more = {}, []
    if tests is not None:
        bodies, left_out = compared(tests, SEED), len(tests.left_out)
        for line in shaken.lines(bodies, left_out, language):
            say(line)
        more = shaken.chapter(bodies, left_out, language)
        content = json.dumps(as_json_of_tests(tests, bodies, SEED), indent=1, allow_nan=False, ensure_ascii=False)
        files = {NAME_OF_TESTS: f"{content}\n".encode()}
    if output is not None:
        files = {NAME_OF_PDF: pdf(chosen, language, more), NAME_OF_JSON: as_json(cases), **files}
        atomic_write.write({output / name: content for name, content in files.items()})
        for name in files:
            say(str(output / name))
    return EXIT_DIFFERS if differing else 0


def _refuse_overwriting(output: Path) -> None:
    """Raise InputError where a file of these names is no pack of an earlier run, which writes both."""
    pack, data = output / NAME_OF_PDF, output / NAME_OF_JSON
    own = data.is_file() and first_bytes(data, len(BEGINS)) == BEGINS
    for path in (data, pack):
        if path.exists() and not own:
            raise InputError("would_overwrite", path=path)


def lines(cases: list[Solved]) -> list[str]:
    """The table: of each case the answer nearest to its tolerance, or those beyond; then how many cases agree."""
    language = current_language()
    heads = (
        worded("Case"),
        worded("Answer"),
        worded("Expected"),
        worded("Found"),
        worded("Difference"),
        worded("Agrees"),
    )
    rows = [tuple(head.text(language) for head in heads)]
    for case in cases:
        for answer in [one for one in case.answers if not one.agrees] or [case.furthest]:
            agrees = worded("yes") if answer.agrees else worded("NO")
            rows.append((case.key, called(answer, language), *written(answer, language), agrees.text(language)))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    table = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    return [*table, summary(cases).text(language)]
