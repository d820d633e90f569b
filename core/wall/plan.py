"""Horizontal section of solids at a height, by strips along the wall.

x is inward from the outer face of the base, y along the wall. A section is a list of cells: between two y the ground
between two straight edges, full of masonry. Corners and crossings of edges all lie between strips, so that areas,
what two sections share and what is connected follow from cells without rounding.
"""

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from core.wall.body import directions, shared_area, spans

MIN_CELL_SIZE = 1e-9
"""Sizes below which a cell is none [m]."""

TIP = 1e-3
"""Area of sections, added up, below which a body is a tip of another one [m2]."""

Point = tuple[float, float]
Edge = tuple[float, ...]


class Cell(NamedTuple):
    """start, end : y [m]; outer, inner : x of its edges at start, in the middle and at end [m]"""

    start: float
    end: float
    outer: Edge
    inner: Edge

    @property
    def area(self) -> float:
        return (self.end - self.start) * (self.inner[1] - self.outer[1])

    @property
    def corners(self) -> list[Point]:
        first, last = self.outer, self.inner
        return [(first[0], self.start), (last[0], self.start), (last[2], self.end), (first[2], self.end)]


class Piece(NamedTuple):
    """A solid at a height. corners : (x, y) [m], four of a parallelogram; sign : -1 of an opening"""

    corners: tuple[Point, ...]
    sign: int


def pieces_at(parts: Iterable, z: float, below: bool = False, grown: float = 0.0) -> list[Piece]:
    """Pieces of the solids just above or just below a height [m]. grown : by how much each is larger on each side
    [m]"""
    pieces = []
    for part in parts:
        (n0, n1), (cosine, sine) = part.ends, directions(part.angle)
        n0, n1 = n0 - grown, n1 + grown
        for s0, s1 in spans(part.polygon, z, below):
            s0, s1 = s0 - grown, s1 + grown
            if s1 < s0 or n1 < n0:
                continue
            if part.plane == "section":  # along its normal, whichever way
                corners = tuple((part.start + s, n) for s, n in ((s0, n0), (s1, n0), (s1, n1), (s0, n1)))
            else:
                corners = tuple(
                    (part.start + s * cosine + n * sine, s * sine - n * cosine)
                    for s, n in ((s0, n0), (s1, n0), (s1, n1), (s0, n1))
                )
            pieces.append(Piece(corners, 1 if part.weight > 0.0 else -1))
    return pieces


def _edges(piece: Piece) -> list[tuple[Point, Point]]:
    return list(zip(piece.corners, (*piece.corners[1:], piece.corners[0]), strict=True))


def _levels(pieces: Sequence[Piece], same: float) -> list[float]:
    """y of all corners, and of all crossings of edges [m], no two nearer than `same`."""
    levels = {y for piece in pieces for _, y in piece.corners}
    slanted = any(
        abs(a[0] - b[0]) > MIN_CELL_SIZE and abs(a[1] - b[1]) > MIN_CELL_SIZE
        for piece in pieces
        for a, b in _edges(piece)
    )
    for one, other in itertools.combinations(pieces, 2) if slanted else ():
        for (a, b), (c, d) in itertools.product(_edges(one), _edges(other)):
            turn = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
            if turn != 0.0:
                share = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / turn
                if 0.0 < share < 1.0:
                    levels.add(a[1] + share * (b[1] - a[1]))
    ordered = sorted(levels)
    kept: list[float] = []
    for y in ordered:
        if not kept or y - kept[-1] > same:
            kept.append(y)
    return kept


def _within(piece: Piece, start: float, end: float) -> tuple[Edge, Edge] | None:
    """Outer and inner edge of a piece in a strip without corners; None where the piece is not there."""
    middle = 0.5 * (start + end)
    sides = []
    for a, b in _edges(piece):
        if (a[1] > middle) != (b[1] > middle):
            slope = (b[0] - a[0]) / (b[1] - a[1])
            sides.append(tuple(a[0] + slope * (y - a[1]) for y in (start, middle, end)))
    return (min(sides, key=_middle), max(sides, key=_middle)) if len(sides) == 2 else None


def _middle(edge: Edge) -> float:
    return edge[1]


def cells_of(*groups: Sequence[Piece], same: float = MIN_CELL_SIZE) -> list[Cell]:
    """Cells of masonry in each of these groups of pieces: of one its section, of two what both share. same : width of a
    strip that is none [m]"""
    if not all(groups):
        return []
    levels = _levels([piece for group in groups for piece in group], same)
    each = [(k, piece, [y for _, y in piece.corners]) for k, group in enumerate(groups) for piece in group]
    waiting = sorted(((min(ys), max(ys), k, piece) for k, piece, ys in each), key=lambda one: -one[0])
    active: list = []
    cells = []
    for start, end in itertools.pairwise(levels):
        middle = 0.5 * (start + end)
        while waiting and waiting[-1][0] < middle:
            active.append(waiting.pop())
        active = [one for one in active if one[1] > middle]
        changes = []  # (edge, group, by how much there is more from here inward)
        for _, _, k, piece in active:
            edges = _within(piece, start, end)
            if edges is not None:
                changes += [(edges[0], k, piece.sign), (edges[1], k, -piece.sign)]
        changes.sort(key=lambda change: change[0][1])
        there, outer = [0] * len(groups), None
        for n, (edge, k, more) in enumerate(changes):
            there[k] += more
            if n + 1 < len(changes) and changes[n + 1][0][1] - edge[1] <= MIN_CELL_SIZE:
                continue
            full = min(there) > 0
            if full and outer is None:
                outer = edge
            elif not full and outer is not None:
                cells.append(Cell(start, end, outer, edge))
                outer = None
    return cells


def section_at(parts: Iterable, z: float, below: bool = False) -> list[Cell]:
    """The section of solids less their openings just above or below a height [m]."""
    return cells_of(pieces_at(parts, z, below))


def area_of(cells: Iterable[Cell]) -> float:
    """[m2]"""
    return math.fsum(cell.area for cell in cells)


def edge_reached(cells: Sequence[Cell], share: float, inner: bool = False) -> float:
    """x [m] of the line along the wall that this share of the length of a section reaches from inside, its outermost
    one; inner : of the inner face."""
    strips = []
    for (start, end), group in itertools.groupby(cells, key=lambda cell: cell[:2]):
        own = list(group)
        strips.append((-max(max(c.inner) for c in own) if inner else min(min(c.outer) for c in own), end - start))
    strips.sort()
    needed = share * math.fsum(length for _, length in strips) * (1.0 - MIN_CELL_SIZE)
    reached = itertools.accumulate(length for _, length in strips)
    x = next(x for (x, _), length in zip(strips, reached, strict=True) if length >= needed)
    return -x if inner else x


def length_of(cells: Iterable[Cell]) -> float:
    """Length along the wall over which there is something [m]."""
    return math.fsum(end - start for start, end in {cell[:2] for cell in cells})


class Bodies:
    """Sections one above the other as cells that touch: how many bodies they are."""

    def __init__(self, sections: Sequence[list[Cell]], touch: float, least: float):
        """touch : least length of a contact in a section [m]; least : least size of one between two sections [m]"""
        numbered = [(k, n, cell) for k, cells in enumerate(sections) for n, cell in enumerate(cells)]
        self._sizes = {(k, n): cell.area for k, n, cell in numbered if cell.inner[1] - cell.outer[1] > 2.0 * least}
        self._of = {(k, n): (k, n) for k, cells in enumerate(sections) for n in range(len(cells))}
        for k, cells in enumerate(sections):
            for a, b in _near(cells, cells, least):
                one, other = cells[a], cells[b]
                shared = min(one.inner[2], other.inner[0]) - max(one.outer[2], other.outer[0])
                if abs(one.end - other.start) <= least and shared > touch:
                    self._join((k, a), (k, b))
            for a, b in _near(sections[k - 1], cells, 0.0) if k else ():
                if _touch(sections[k - 1][a], cells[b], least):
                    self._join((k - 1, a), (k, b))

    def _root(self, key: tuple[int, int]) -> tuple[int, int]:
        while self._of[key] != key:
            self._of[key] = self._of[self._of[key]]
            key = self._of[key]
        return key

    def _join(self, one: tuple[int, int], other: tuple[int, int]) -> None:
        self._of[self._root(one)] = self._root(other)

    @property
    def count(self) -> int:
        """Bodies, tips of a few square centimetres left out: what is above them joins them."""
        whole: dict[tuple[int, int], float] = {}
        for key, size in self._sizes.items():
            root = self._root(key)
            whole[root] = whole.get(root, 0.0) + size
        return sum(size > TIP for size in whole.values())


def _near(ones: Sequence[Cell], others: Sequence[Cell], least: float) -> Iterator[tuple[int, int]]:
    """Numbers of cells, which follow each other along the wall, whose stretches meet."""
    first = 0
    for a, one in enumerate(ones):
        while first < len(others) and others[first].end < one.start - least:
            first += 1
        for b in range(first, len(others)):
            if others[b].start > one.end + least:
                break
            yield a, b


def _touch(one: Cell, other: Cell, least: float) -> bool:
    """Whether a cell stands on another one."""
    along = min(one.end, other.end) - max(one.start, other.start)
    across = min(max(one.inner), max(other.inner)) - max(min(one.outer), min(other.outer))
    if along <= least or across <= least:
        return False
    upright = all(len({*edge}) == 1 for cell in (one, other) for edge in (cell.outer, cell.inner))
    return upright or shared_area(one.corners, other.corners) > least * least
