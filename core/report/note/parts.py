"""Parts of the calculation note as data; document.py and pdf.py write them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from core.derivation.faces import Shown
from core.derivation.quantity import Quantity
from core.report.tables import NOTE, DataTable
from core.text.sentence import format_number


@dataclass(frozen=True)
class Heading:
    """level : 1 of the note, 2 of a section, 3 within one; new_page : it begins a page; wall : number of the result it
    begins, from 0; listed : in the table of contents."""

    text: str
    level: int = 2
    new_page: bool = False
    wall: int | None = None
    listed: bool = True


@dataclass(frozen=True)
class Paragraph:
    """tone : "", quiet, strong, or the colour of a verdict: good, amber, bad."""

    text: str
    tone: str = ""


@dataclass(frozen=True)
class Item:
    """One item of a list. sign : before it"""

    text: str
    tone: str = ""
    sign: str = "•"


@dataclass(frozen=True)
class Table:
    """Cells of text. widths : of the columns, relative; tones : by (row, column), as of Paragraph; walls : number of
    the result of each row, where they have one; together : on one page."""

    heads: Sequence[str]
    rows: Sequence[Sequence[str]]
    widths: Sequence[float]
    tones: dict[tuple[int, int], str] = field(default_factory=dict)
    walls: Sequence[int] = ()
    together: bool = False


def table_of_rows(table: DataTable, rows: Sequence[Any], written: Callable[[float | None, str], str]) -> Table:
    """A table as the note has it. written : a number in its form"""
    columns = table.shown(NOTE, rows)
    heads, widths = [column.head for column in columns], [column.width for column in columns]
    return Table(heads, table.words(NOTE, rows, written), widths, table.tones(NOTE, rows))


@dataclass(frozen=True)
class Bars:
    """zeta of each check over the zeta required.

    rows : (name, clause, zeta or None, tone, whether it decides); target : the zeta required
    """

    rows: Sequence[tuple[str, str, float | None, str, bool]]
    target: float
    caption: str


@dataclass(frozen=True)
class Contents:
    """The sections and their pages."""


@dataclass(frozen=True)
class Step:
    """One line of a derivation, as "α0 = t/H = 0.90/12.50 = 0.0720".

    symbol, formula : "α0", "t/H"; formula "" for what is given or found otherwise
    numbers : the formula in numbers: words and numbers one after the other, empty where it has none
    result, form : the value and its format, as ".4f"
    cell : name of the result's cell on the sheet Check
    quantity, symbols, values : the description of the result, symbols and numbers of what it needs, for an equation
    """

    symbol: str
    result: float | str | None
    form: str = ".3f"
    unit: str = ""
    clause: str = ""
    formula: str = ""
    numbers: Sequence[str | Shown] = ()
    cell: str | None = None
    label: str = ""
    quantity: Quantity | None = None
    symbols: Mapping[str, str] = field(default_factory=dict)
    values: Mapping[str, Shown] = field(default_factory=dict)

    def in_numbers(self, language: str) -> str:
        """The formula with its numbers."""
        return "".join(piece.text(language) if isinstance(piece, Shown) else piece for piece in self.numbers)

    def written(self, language: str) -> str:
        """Text of the line without the result and its unit."""
        return " = ".join(part for part in (self.symbol, self.formula, self.in_numbers(language)) if part)

    def result_written(self, language: str) -> str:
        """Text of the result, "–" for None."""
        if self.result is None or isinstance(self.result, str):
            return self.result or "–"
        return format_number(self.result, self.form, language)


@dataclass(frozen=True)
class Derivation:
    """Steps one below the other."""

    steps: Sequence[Step]


@dataclass(frozen=True)
class Curve:
    """A line of a figure. color : ink, quiet, accent, good, amber or bad; shape : line, dash, bars or points."""

    name: str
    x: Sequence[float] | np.ndarray
    y: Sequence[float] | np.ndarray
    color: str = "accent"
    shape: str = "line"
    width: float = 1.3


def path(points, color: str, shape: str = "line", width: float = 1.3) -> Curve:
    """A line without a name through points (x, y)."""
    xs, ys = zip(*points, strict=True)
    return Curve("", xs, ys, color, shape, width)


@dataclass(frozen=True)
class Label:
    """A word at a place of a figure."""

    text: str
    x: float
    y: float


@dataclass(frozen=True)
class Figure:
    """x, y : labels of the axes, "" for a drawing without axes, whose scale is the same both ways
    x_range, y_range : of the axes
    names : below the places 0, 1, 2 … of the x axis
    least_area : height of what it shows at least, whatever the names take [cm]
    """

    caption: str
    curves: Sequence[Curve]
    x: str = ""
    y: str = ""
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    labels: Sequence[Label] = ()
    names: Sequence[str] = ()
    least_area: float = 0.0

    @property
    def is_drawing(self) -> bool:
        """Whether it is to scale."""
        return not self.x


@dataclass(frozen=True)
class Figures:
    """Up to three figures side by side."""

    figures: Sequence[Figure]


@dataclass(frozen=True)
class Mathematics:
    """A formula, in the mathematics of Typst: code of the program, never a text of a user."""

    math: str


@dataclass(frozen=True)
class Beside:
    """Parts beside a drawing, whose caption is for those who do not see it."""

    parts: "Sequence[Part]"
    figure: Figure | None


@dataclass(frozen=True)
class Box:
    """An empty frame the engineer writes into, of so many lines."""

    lines: int


@dataclass(frozen=True)
class Blanks:
    """Words with a line to write on, and room above it for a signature and a stamp."""

    labels: Sequence[str]


Part = Heading | Paragraph | Item | Table | Bars | Contents | Derivation | Figures | Mathematics | Beside | Box | Blanks
