"""What a parametric study shows: figures, tables and claims as data, for window, workbook and files alike."""

from dataclasses import dataclass, field

POINTS, LINE, DASHED, LINE_POINTS = "points", "line", "dashed", "line_points"


@dataclass(frozen=True)
class Series:
    """One curve or cloud of a figure. color : index into the palette of whoever draws."""

    name: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    look: str = POINTS
    color: int = 0


@dataclass(frozen=True)
class Figure:
    """A chart. key : of the file; log_x, log_y : logarithmic axes; note : below it."""

    key: str
    title: str
    x: str
    y: str
    series: tuple[Series, ...]
    log_x: bool = False
    log_y: bool = False
    note: str = ""


def marker_of(figure: Figure, index: int) -> int:
    """Which marker a series takes: as many series with points of its colour stand before it."""
    looks = (POINTS, LINE_POINTS)
    own = figure.series[index]
    return sum(other.color == own.color and other.look in looks for other in figure.series[:index] if other.name)


@dataclass(frozen=True)
class Table:
    """A table. head : of the columns; rows of numbers, None and words."""

    key: str
    title: str
    head: tuple[str, ...]
    rows: tuple[tuple, ...]
    note: str = ""


@dataclass(frozen=True)
class Claim:
    """A claim of the paper and what is found: it holds in `held` of `tried` cases, or `found` says it."""

    source: str
    claim: str
    held: int | None
    tried: int | None
    found: str = ""


@dataclass(frozen=True)
class StudyReport:
    """Everything a study shows, in one language. notes : what the reader must know before the numbers."""

    title: str
    notes: tuple[str, ...]
    figures: tuple[Figure, ...] = ()
    tables: tuple[Table, ...] = ()
    claims: tuple[Claim, ...] = ()
    fits: dict = field(default_factory=dict)
