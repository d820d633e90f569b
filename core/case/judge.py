"""A case that is edited, judged as the batch would read it: what has not changed since is neither read nor checked
again."""

from dataclasses import replace

from core.case.rules import AcceptedWall, parse_case, parse_sections, parse_wall_entry, replace_walls
from core.case.schema import Case
from core.case.wall import Wall, find_mechanism
from core.case.writer import table_of

MAX_SPARE_WALLS = 1000
"""Walls kept beside those of the case while it cannot be accepted."""


class IncrementalParser:
    """`parse_case(table_of(case))` of one case after another that have most of their walls in common: an edit keeps
    those it does not change, as the same objects.

    read : `id` of a wall of the case -> that wall, the one that is read of it, the keys that are given
    accepted : as of `replace_walls`
    """

    def __init__(self):
        self.read: dict[int, tuple[Wall, Wall, tuple[str, ...]]] = {}
        self.accepted: dict[int, AcceptedWall] = {}

    def __call__(self, case: Case) -> Case:
        """The case as the batch would read it. Raises InputError."""
        if case.walls is not None:
            return parse_case(table_of(case))
        judged = parse_sections(table_of(replace(case, wall=())))
        rows = [self._row(wall, k, case) for k, wall in enumerate(case.wall)]
        if len(self.read) > 2 * len(rows) + MAX_SPARE_WALLS:
            self.accepted, self.read = {}, {id(row[0]): row for row in rows}
        given = {("wall", k, key) for k, (_, _, keys) in enumerate(rows) for key in keys}
        walls = [wall for _, wall, _ in rows]
        judged = replace_walls(replace(judged, given=judged.given | given), walls, self.accepted)
        self.read = {id(row[0]): row for row in rows}
        self.accepted = {id(wall): self.accepted[id(wall)] for wall in walls}
        return judged

    def _row(self, wall: Wall, k: int, case: Case) -> tuple[Wall, Wall, tuple[str, ...]]:
        """Read a wall that is not known yet. Raises InputError."""
        if id(wall) in self.read:
            return self.read[id(wall)]
        entry = table_of(Case(wall=(wall,)))["wall"][0]
        if not wall.mechanism and (case.demand or case.site):  # it follows from what holds this wall or its variant
            return wall, parse_wall_entry({**entry, "mechanism": find_mechanism(wall, case.wall)}, k), tuple(entry)
        self.read[id(wall)] = (wall, parse_wall_entry(entry, k), tuple(entry))
        return self.read[id(wall)]
