"""Rows of numbers as text, of spectra and hazards: what parts the numbers, their decimal mark, the words above."""

import re
from typing import NamedTuple

from core.case.number import parse_number
from core.errors import InputError

_NUMBER_FIRST = re.compile(r"[+−-]?[.,]?[0-9]")
"""The beginning of a row: a head does not begin with a number."""

_BETWEEN = re.compile(r"[;\t]|,(?=\s)")


class NumberRow(NamedTuple):
    """A row. number : of its line, from 1"""

    number: int
    text: str
    values: tuple[float, ...]


class NumberRows(NamedTuple):
    """A table of numbers. head : (number, text) of the lines above the rows; wrong : (number, text) of the first line
    that is neither, None without one"""

    head: list[tuple[int, str]]
    rows: list[NumberRow]
    wrong: tuple[int, str] | None


def split_cells(line: str) -> list[str]:
    """The cells of a line: between them a semicolon, a tab, blanks, or a comma where its numbers have points or a blank
    follows it; empty ones at its end left out."""
    parted = _BETWEEN.sub(" ", line.replace(",", " ") if "." in line else line)
    return parted.split()


def read_number_rows(text: str) -> NumberRows:
    """The rows of a text, up to the first line that is wrong. Lines without a cell are passed over."""
    found = NumberRows([], [], None)
    for number, line in enumerate(text.splitlines(), start=1):
        cells = split_cells(line)
        if not cells:
            continue
        try:
            values = tuple(parse_number(cell) for cell in cells)
        except InputError:
            if found.rows or _NUMBER_FIRST.match(cells[0]):
                return found._replace(wrong=(number, line))
            found.head.append((number, line))
            continue
        found.rows.append(NumberRow(number, line, values))
    return found
