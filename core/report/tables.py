"""A table once: columns over rows of objects. Sheet, note and window are faces of it."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

CellValue = float | str | None

SHEET, NOTE, WINDOW = "sheet", "note", "window"
"""Names of the faces."""

NO_VALUE = "–"
"""What stands where a row has nothing."""


class Speaker(Protocol):
    """Who knows the language of a face: `Book`, `Words`."""

    @property
    def language(self) -> str: ...

    def say(self, english: str, /, **values) -> str: ...


@dataclass(frozen=True)
class DataColumn:
    """A column.

    head : as people read it, with the unit
    of : number or words of a row, None or "" where it has none
    form : of a number, as ".3f" or ".1%"; of a row where they differ
    width : letters
    tone : good, bad, quiet or "" of a row
    only : faces that show it, empty : all
    """

    head: str
    of: Callable[[Any], CellValue]
    form: str | Callable[[Any], str] = ""
    width: float = 10.0
    tone: Callable[[Any], str] = lambda row: ""
    only: tuple[str, ...] = ()

    def number_form(self, row: Any) -> str:
        """The form of the number of a row."""
        return self.form if isinstance(self.form, str) else self.form(row)


@dataclass(frozen=True)
class DataTable:
    """Columns over rows. folds : a column without a value in any row is left out, but on a sheet"""

    columns: Sequence[DataColumn]
    folds: bool = False

    def shown(self, face: str, rows: Sequence[Any] = ()) -> list[DataColumn]:
        """The columns that a face shows of these rows."""
        columns = [column for column in self.columns if not column.only or face in column.only]
        if not self.folds or face == SHEET:
            return columns
        return [column for column in columns if any(column.of(row) not in (None, "") for row in rows)]

    def folded(self, face: str, rows: Sequence[Any]) -> list[str]:
        """Heads of the columns that a face leaves out, for no row has them."""
        shown = self.shown(face, rows)
        return [column.head for column in self.shown(SHEET) if column not in shown and face in (column.only or (face,))]

    def words(self, face: str, rows: Sequence[Any], written: Callable[[float | None, str], str]) -> list[list[str]]:
        """The cells of a face in words. written : a number in its form"""
        columns = self.shown(face, rows)
        return [[_cell_words(column.of(row), column.number_form(row), written) for column in columns] for row in rows]

    def tones(self, face: str, rows: Sequence[Any]) -> dict[tuple[int, int], str]:
        """(row, column) -> tone of the cells of a face that have one."""
        columns = self.shown(face, rows)
        tones = {(n, k): column.tone(row) for n, row in enumerate(rows) for k, column in enumerate(columns)}
        return {place: tone for place, tone in tones.items() if tone}


def _cell_words(value: CellValue, form: str, written: Callable[[float | None, str], str]) -> str:
    if value is None or value == "":
        return NO_VALUE
    if isinstance(value, str):
        return value
    if form.endswith("%"):
        return f"{written(100.0 * value, form[:-1] + 'f')} %" if math.isfinite(value) else NO_VALUE
    return written(value, form)
