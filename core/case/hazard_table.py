"""The hazard of a site as text: T_R [years], a_g [g], F_0, T_C* [s] in each row, as tables of NTC 2018 give it."""

import itertools
from pathlib import Path

from core.case.number_rows import read_number_rows
from core.case.site import HazardRow
from core.case.values import check_value
from core.decoding import NoText, decode_text
from core.errors import InputError, place
from core.quantities import foreign_unit
from core.regular_file import TooLarge, read_regular

KEYS = ("return_period_years", "ag_g", "f0", "tc_star_s")
COLUMN_UNITS = ("anni", "years", "yr", "g", "ag/g", "s", "sec", "-", "–")
"""Units of its columns, as they are written."""

MAX_BYTES, MAX_ROWS = 100_000, 100


def parse_hazard(text: str) -> tuple[HazardRow, ...]:
    """The rows of a text: two or four numbers each, with spaces, tabs or semicolons between them, and a head of words
    above, no line of which begins with a number. Raises InputError."""
    table, rows = read_number_rows(text), []
    for number, line in table.head:
        if foreign := foreign_unit(line, COLUMN_UNITS):
            raise InputError("hazard_units", unit=foreign[:40], place=(place("line", n=number),))
    if table.wrong is not None:
        number, line = table.wrong
        raise InputError("hazard_line", text=line.strip()[:60], place=(place("line", n=number),))
    for number, line, values in table.rows:
        here = place("line", n=number)
        if len(values) not in (2, 4) or len(rows) == MAX_ROWS:
            raise InputError("hazard_line", text=line.strip()[:60], place=(here,))
        try:
            checked = [check_value(HazardRow, key, value) for key, value in zip(KEYS, values, strict=False)]
        except InputError as error:
            raise error.at(here) from None
        rows.append(HazardRow(*checked))
    if not rows:
        raise InputError("no_hazard_rows")
    check_rising(rows)
    return tuple(rows)


def check_rising(rows) -> None:
    """Refuse a hazard of one row, or one that does not rise from row to row."""
    pairs = list(itertools.pairwise(rows))
    rising = all(low.return_period_years < high.return_period_years and low.ag_g < high.ag_g for low, high in pairs)
    if not pairs or not rising:
        raise InputError("hazard_not_rising", key="hazard")


def read_hazard(path: Path) -> tuple[HazardRow, ...]:
    """The rows of a file. Raises InputError."""
    try:
        if not path.is_file():
            raise InputError("no_hazard_file")
        return parse_hazard(decode_text(read_regular(path, MAX_BYTES)))
    except NoText:
        raise InputError("no_hazard_rows", place=(path,)) from None
    except TooLarge:
        raise InputError("hazard_too_large", place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    except InputError as error:
        raise error.at(path) from None
