"""A line of a calculation: a quantity with the value the program found for it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from core.derivation.quantity import Given, Quantity

INPUT, RUN, LIVE = "input", "run", "live"
"""Where the value of a line comes from: the case, the run of the program, or the lines above it."""

FULL, SYMBOLS, VALUE, NOT = "full", "symbols", "value", ""
"""What of it the note shows: formula with symbols and numbers, with symbols alone, the value, nothing."""


class Word(str):
    """The code of a word of a result, in place of a text of the group "report"."""


@dataclass(frozen=True)
class Line:
    """of : what it is of; value : of the program, in the unit of the description; None where there is none; a text
    source : INPUT, RUN or LIVE; note : FULL, SYMBOLS, VALUE or NOT
    label : what the note says beside it, a text of the group "report"; title : of its row in the workbook in place of
        the symbol; words : what both, symbol, unit and clause are filled with
    other : names of its formula that stand for another cell
    passed : outcome of the check this is zeta of, None of another line
    run_name : name of the cell with the program's value, for what no changed input moves
    shown_by : what the note writes the formula by, where that of the workbook has branches
    """

    of: Given
    value: float | str | None
    source: str = LIVE
    note: str = NOT
    label: str = ""
    title: str = ""
    words: Mapping[str, object] = field(default_factory=dict)
    other: Mapping[str, str] = field(default_factory=dict)
    passed: bool | None = None
    run_name: str = ""
    shown_by: Quantity | None = None

    @property
    def quantity(self) -> Quantity | None:
        """The description with a formula, None of what is given or of the run."""
        return self.of if self.source == LIVE and isinstance(self.of, Quantity) else None


@dataclass(frozen=True)
class Columns:
    """Loads or modes, one a row. symbols : of the columns, by the names of the formulas; units
    rows : (word or number that names it, values); source : INPUT or RUN
    shift : name of a cell that is taken off a column, by the column: d is entered from the face of the wall
    cells : of each row the names of the cells of the workbook it shows, without the prefix of the wall
    """

    title: str
    symbols: Mapping[str, str]
    units: Sequence[str]
    rows: Sequence[tuple[str, Sequence[float]]]
    source: str
    shift: Mapping[str, str] = field(default_factory=dict)
    cells: Sequence[Sequence[str]] = ()


@dataclass(frozen=True)
class Section:
    """Lines one below the other. title : a text of the group "report" """

    title: str
    lines: Sequence[Line | Columns]
    constants: Mapping[str, float] = field(default_factory=dict)
