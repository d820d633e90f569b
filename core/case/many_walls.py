"""More walls than are held at once: those of a long table, each read from its text when it is asked for."""

import csv
import hashlib
from array import array
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from core.case.floor_loads import WallSetChecker, check_floors
from core.case.hinges import make_wall_parts
from core.case.rules import check_part, check_wall, refuse_modes
from core.case.schema import Case
from core.case.wall import Wall
from core.errors import InputError

LONGEST_ROW = 1_000_000
"""Letters of a row."""


class LazyWalls(Sequence):
    """The walls of a text with one row a wall: of each only where its row begins is kept.

    text : of the table; mark : between its cells
    wall_of(number, cells) : the wall of a row, which may raise InputError
    ahead : walls before those of the table
    """

    def __init__(self, text: str, mark: str):
        self.text, self.mark = text, mark
        self.ahead: tuple[Wall, ...] = ()
        self.wall_of: Callable[[int, list[str]], Wall] = lambda number, cells: Wall("", "")
        self._starts, self._numbers = array("q"), array("q")
        self._from = 0

    def scan(self) -> Iterator[tuple[int, list[str]]]:
        """(number from 1, cells) of the rows of the text. Raises csv.Error."""
        self._end = 0
        rows = csv.reader(self._lines(0), delimiter=self.mark, strict=True)
        for number, cells in enumerate(rows, start=1):
            yield number, cells
            self._from = self._end

    def keep(self, number: int) -> None:
        """The row `scan` gave last, of this number, is a wall."""
        self._starts.append(self._from)
        self._numbers.append(number)

    def _lines(self, start: int) -> Iterator[str]:
        """The lines of the text from a place on, and how far they were taken."""
        text, first, end = self.text, start, start
        while end < len(text):
            start, end = end, text.find("\n", end) + 1 or len(text)
            self._end = end
            if end - max(first, self._from) > LONGEST_ROW:  # all its cells would be made at once, lines in quotes too
                raise InputError("row_too_long", most=LONGEST_ROW)
            yield text[start:end]

    def __len__(self) -> int:
        return len(self.ahead) + len(self._starts)

    def __getitem__(self, k):
        if not 0 <= k < len(self):
            raise IndexError(k)
        if k < len(self.ahead):
            return self.ahead[k]
        k -= len(self.ahead)
        cells = next(csv.reader(self._lines(self._starts[k]), delimiter=self.mark))
        return self.wall_of(self._numbers[k], [cell.strip() for cell in cells])


def attach_walls(case: Case, walls: LazyWalls) -> Case:
    """`replace_walls` of a case whose walls are not held at once: of a name eight bytes are. Raises InputError."""
    walls.ahead = case.wall
    check_floors(case.building)
    titles, above = array("Q"), array("Q")
    low, high = np.inf, -np.inf
    together = WallSetChecker(case.building)
    for k, wall in enumerate(walls):
        together.saw(wall)
        titles.append(_digest(wall.title))
        check_wall(case, wall)
        for part in make_wall_parts(k, wall, case.building):
            if not part.is_whole:
                above.append(_digest(part.wall.name))
            check_part(part)
            if (z := part.wall.demand_height_m) is not None and part.wall.above_ground:
                low, high = min(low, z), max(high, z)
    known, counts = np.unique(np.array(titles), return_counts=True)
    twice = {*known[counts > 1].tolist(), *np.intersect1d(known, np.array(above, np.uint64)).tolist()}
    if twice:
        _refuse_same_names(case, walls, twice)
    together.check()
    if high > low:
        refuse_modes(case, low, high)
    in_place: Any = walls
    return replace(case, wall=in_place, walls=None)


def _digest(name: str) -> int:
    return int.from_bytes(hashlib.blake2b(name.encode(errors="surrogatepass"), digest_size=8).digest(), "big")


def _refuse_same_names(case: Case, walls: LazyWalls, digests: set[int]) -> None:
    """Raise InputError where two names are the same, not only their digests."""
    titles: set[str] = set()
    for wall in walls:
        if _digest(wall.title) in digests:
            if wall.title in titles:
                raise InputError("same_name", key="name", wall=wall.title)
            titles.add(wall.title)
    for k, wall in enumerate(walls):
        for part in make_wall_parts(k, wall, case.building):
            if not part.is_whole and part.wall.name in titles:
                raise InputError("same_name", key="name", wall=part.wall.name)


def group_walls(walls: Sequence[Wall], size: int) -> list[list[int]]:
    """Indices of the walls, in groups of about so many: in their order, but walls of one name, which are variants of
    each other, side by side and never in two groups."""
    names = np.fromiter((_digest(wall.name) for wall in walls), np.uint64, len(walls))
    _, first, inverse = np.unique(names, return_index=True, return_inverse=True)
    place = first[inverse]
    order = np.argsort(place, kind="stable")
    groups: list[list[int]] = []
    for k in order.tolist():
        if groups and (len(groups[-1]) < size or place[groups[-1][-1]] == place[k]):
            groups[-1].append(k)
        else:
            groups.append([k])
    return groups
