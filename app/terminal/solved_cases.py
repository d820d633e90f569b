"""`--validate`: the solved cases, in a table on the terminal, as a PDF and as JSON (NTC 2018, 10.2)."""

from pathlib import Path

from app.look.language import current_language
from app.terminal.batch import say
from core import atomic_write
from core.errors import InputError
from core.packages import require
from core.regular_file import first_bytes
from core.solved.cases import cases_of, solve, subjects
from core.solved.pack import NAME_OF_JSON, NAME_OF_PDF, as_json, called, pdf, summary, written
from core.solved.solved import Solved, worded

DIFFERS = 5
"""Exit code where a case does not agree with its source, as of --verify."""

BEGINS = b'{\n "program": "Ribalta"'
"""How the results of an earlier run begin."""


def run(output: Path | None, records: Path | None) -> int:
    """Ask the program for every answer, say what it finds, and write the pack into a folder where one is named.

    records : folder whose record of El Centro 1940 adds its cases. Raises InputError, OutputError.
    """
    if output is not None:
        require("report")
        _refuse_overwriting(output)
        atomic_write.check_folder(output)
    found = subjects(records)
    cases = cases_of(found)
    differing = solve(cases)
    for line in lines(cases):
        say(line)
    if output is not None:
        atomic_write.write(
            {output / NAME_OF_PDF: pdf(found, current_language()), output / NAME_OF_JSON: as_json(cases)}
        )
        say(str(output / NAME_OF_PDF))
        say(str(output / NAME_OF_JSON))
    return DIFFERS if differing else 0


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
