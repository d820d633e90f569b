"""Outlines of a drawing: pieces joined end to end, arcs divided, what is above a line. Coordinates are of the plane, in
any unit."""

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

from core.errors import InputError

Point = tuple[float, float]

LOOSE = 200
"""Loose ends of a layer of which the nearest other one is sought: of more, the other end of their line is named."""


CROWD = 32
"""Ends around a point within three gaps: of more none goes on, as of three that meet."""

MAX_POINTS = 400_000
"""Points of all lines of a drawing once they are divided, at most."""

MAX_CHORDS = 20_000
"""Chords of an arc, at most: a circle with a radius of 80 km has as many."""


class Gap(NamedTuple):
    """An outline that does not close. at : one of its ends; size : how far the nearest other loose end is"""

    layer: str
    at: Point
    size: float


def arc(start: Point, end: Point, bulge: float, tolerance: float) -> list[Point]:
    """An arc without its start, divided so that no chord is farther from it than a tolerance.

    bulge : tan of a quarter of its angle, positive to the left of the chord's direction turning counter-clockwise
    """
    chord = math.dist(start, end)
    if 0.5 * abs(bulge) * chord <= tolerance:
        return [end]
    angle = 4.0 * math.atan(bulge)
    radius = chord / (2.0 * abs(math.sin(0.5 * angle)))
    to_centre = (1.0 / bulge - bulge) / 4.0
    x = 0.5 * (start[0] + end[0]) - to_centre * (end[1] - start[1])
    y = 0.5 * (start[1] + end[1]) + to_centre * (end[0] - start[0])
    first = math.atan2(start[1] - y, start[0] - x)
    count = math.ceil(abs(angle) / (2.0 * math.acos(max(0.0, 1.0 - tolerance / radius))))
    if count > MAX_CHORDS:
        raise ValueError("bulge")
    turns = (first + angle * k / count for k in range(1, count))
    return [*((x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns), end]


def expand_bulges(corners: Sequence[tuple[float, float, float]], closed: bool, tolerance: float) -> list[Point]:
    """The points of a polyline of (x, y, bulge of the edge that begins there)."""
    corners = [(float(x), float(y), float(bulge)) for x, y, bulge in corners]
    points = [(x, y) for x, y, _ in corners[:1]]
    follow = [*corners[1:], *(corners[:1] if closed else ())]
    for (x, y, bulge), (next_x, next_y, _) in zip(corners, follow, strict=False):
        points += arc((x, y), (next_x, next_y), bulge, tolerance)
        refuse_many(len(points))
    return points


def refuse_many(points: int) -> None:
    """Raise InputError for more points than a drawing may have."""
    if points > MAX_POINTS:
        raise InputError("drawing_too_many_points", most=MAX_POINTS)


def drop_duplicates(lines: Sequence[list[Point]]) -> list[list[Point]]:
    """Lines without those that another one repeats from either end, and without lines of no length: CAD draws over
    itself unseen, and of three ends that meet none goes on."""
    kept = {min(tuple(line), tuple(reversed(line))): line for line in lines if len(set(line)) > 1}
    return list(kept.values())


def join_lines(pieces: Sequence[list[Point]], join: float) -> tuple[list[list[Point]], list[list[Point]]]:
    """(closed outlines, each corner once; lines that do not close) of pieces whose ends are nearer than `join`. Where
    three ends meet nothing goes on: which two belong together is not known."""
    ends: dict[tuple[int, int], list[tuple[int, int]]] = {}

    def cell(point: Point) -> tuple[int, int]:
        return math.floor(point[0] / join), math.floor(point[1] / join)

    closed, loose = [], []
    for k, piece in enumerate(pieces):
        if len(piece) > 2 and math.dist(piece[0], piece[-1]) <= join:
            closed.append(piece[:-1])
        else:
            for end in (0, -1):
                ends.setdefault(cell(piece[end]), []).append((k, end))
    free = {k for of_cell in ends.values() for k, _ in of_cell}

    def following(line: list[Point], last: tuple[int, int]) -> list[tuple[int, int]]:
        (i, j), tip = cell(line[-1]), line[-1]
        cells = [ends.get((i + a, j + b), []) for a in (-1, 0, 1) for b in (-1, 0, 1)]
        around = itertools.chain(*cells)
        if sum(map(len, cells)) > CROWD:
            return list(itertools.islice(around, 2))
        return [(k, end) for k, end in around if (k, end) != last and math.dist(pieces[k][end], tip) <= join]

    while free:
        first = free.pop()
        line, last = list(pieces[first]), [(first, 0), (first, -1)]
        for _ in range(2):
            while len(next_ends := following(line, last[-1])) == 1 and next_ends[0][0] in free:
                k, end = next_ends[0]
                free.discard(k)
                line += pieces[k][1:] if end == 0 else pieces[k][-2::-1]
                last[-1] = (k, -1 - end)
            line.reverse()
            last.reverse()
        if len(line) > 3 and math.dist(line[0], line[-1]) <= join:
            closed.append(line[:-1])
        else:
            loose.append(line)
    return closed, loose


def is_longer(line: Sequence[Point], least: float) -> bool:
    """Whether a line spans more than this."""
    spans = (max(point[k] for point in line) - min(point[k] for point in line) for k in (0, 1))
    return math.hypot(*spans) > least


def gaps_of(layer: str, loose: list[list[Point]]) -> list[Gap]:
    """Gaps at which the lines of a layer do not close."""
    ends = [(k, line[end]) for k, line in enumerate(loose) for end in (0, -1)]
    gaps = []
    for k, line in enumerate(loose):
        best = Gap(layer, line[-1], math.dist(line[0], line[-1]))
        for end in (0, -1) if len(ends) <= LOOSE else ():
            near = min((math.dist(point, line[end]) for n, point in ends if n != k), default=math.inf)
            best = min(best, Gap(layer, line[end], near), key=lambda gap: gap.size)
        gaps.append(best)
    return gaps


def simple(points: Sequence[Point], least: float) -> list[Point]:
    """A closed outline without corners nearer to the one before than `least`."""
    kept: list[Point] = []
    for point in points:
        if not kept or math.dist(point, kept[-1]) > least:
            kept.append(point)
    while len(kept) > 1 and math.dist(kept[0], kept[-1]) <= least:
        kept.pop()
    return kept


def parts_above(polygon: Sequence[Point], y: float) -> list[list[Point]]:
    """Parts of a polygon that does not cross itself above a line, each a polygon of its own."""
    twice = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True))
    corners = list(polygon) if twice > 0.0 else list(reversed(polygon))
    start = next((k for k, corner in enumerate(corners) if corner[1] <= y), None)
    if start is None:
        return [corners]
    corners = corners[start:] + corners[: start + 1]
    chains: list[list[Point]] = []
    for one, other in itertools.pairwise(corners):
        if (one[1] > y) != (other[1] > y):
            at = (one[0] + (other[0] - one[0]) * (y - one[1]) / (other[1] - one[1]), y)
            if one[1] <= y:
                chains.append([at])
            else:
                chains[-1].append(at)
        if other[1] > y:
            chains[-1].append(other)
    # counter-clockwise the line is followed to the right, from where a chain ends to where the next one begins
    leaving = sorted(range(len(chains)), key=lambda k: chains[k][-1][0])
    entering = sorted(range(len(chains)), key=lambda k: chains[k][0][0])
    after = dict(zip(leaving, entering, strict=True))
    parts = []
    while after:
        first = k = next(iter(after))
        part: list[Point] = []
        while k in after:
            part += chains[k]
            k = after.pop(k)
        parts.append(part)
        assert k == first
    return parts
