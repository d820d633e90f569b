"""The outline around a point of a drawing whose walls are lines: a face of the arrangement of all of them."""

import itertools
import math
from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.case.drawing_outlines import Gap, Point
from core.errors import InputError
from core.wall.body import contains_point

MAX_SEGMENTS = 20_000
"""Segments of the lines among which an outline is sought, at most: each is compared with each."""

Line = tuple[str, Sequence[Point]]
"""Layer, points; a closed line ends where it begins."""


class Enclosed(NamedTuple):
    """layer : of a line of the outline; outline, holes : corners, each once; closed : the gaps that were bridged"""

    layer: str
    outline: tuple[Point, ...]
    holes: tuple[tuple[Point, ...], ...]
    closed: tuple[Gap, ...]


def find_enclosing_outline(lines: Sequence[Line], point: Point, close: float, same: float) -> Enclosed:
    """The outline around a point. close : how far a loose end may be from the line it should meet; same : how far two
    corners that are one, both in the unit of the drawing. Raises InputError where no outline closes around it."""
    layers, segments, ends = _segments(lines, same)
    if len(segments) > MAX_SEGMENTS:
        raise InputError("drawing_too_many_lines", n=len(segments), most=MAX_SEGMENTS)
    bridges, closed = _bridges(segments, ends, close, same)
    layers += [layers[k] for k, _ in bridges]
    if bridges:
        segments = np.vstack([segments, [bridge for _, bridge in bridges]])
    graph = _Graph(_split(segments, same), layers, same)
    while True:
        graph.prune()
        cycle = graph.face(point)
        if cycle is None:
            raise InputError("drawing_not_enclosed", mm=close)
        passed = set(zip(cycle, (*cycle[1:], cycle[0]), strict=True))
        twice = [(a, b) for a, b in passed if (b, a) in passed]
        if not twice:
            break
        graph.remove(twice)  # a line that leads to what is inside, or into nothing
    outline = tuple(graph.points[node] for node in cycle)
    layer = graph.layer[frozenset(cycle[:2])]
    bounds = [sorted(c[k] for c in outline)[i] for k in (0, 1) for i in (0, -1)]
    near = [
        gap
        for gap in closed
        if bounds[0] - close <= gap.at[0] <= bounds[1] + close and bounds[2] - close <= gap.at[1] <= bounds[3] + close
    ]
    return Enclosed(layer, outline, graph.holes(cycle), tuple(near))


def _segments(lines: Sequence[Line], same: float) -> tuple[list[str], np.ndarray, list[tuple[int, Point]]]:
    """(layer of each segment, x0, y0, x1, y1 of each, (number of the segment, point) of the ends of open lines)."""
    layers, segments, ends = list[str](), [], []
    for layer, points in lines:
        first = len(segments)
        for a, b in itertools.pairwise(points):
            if math.dist(a, b) > 0.0:
                layers.append(layer)
                segments.append((*a, *b))
        if len(segments) > first and math.dist(points[0], points[-1]) > same:
            ends += [(first, points[0]), (len(segments) - 1, points[-1])]
    return layers, np.array(segments).reshape(-1, 4), ends


def _bridges(segments: np.ndarray, ends, close: float, same: float) -> tuple[list, list[Gap]]:
    """((number of the segment of a loose end, the segment from it to the nearest line), ...), and these gaps."""
    start, way = segments[:, :2], segments[:, 2:] - segments[:, :2]
    square = (way**2).sum(axis=1)
    bridges, gaps, middles = [], [], set()
    for k, end in ends:
        share = np.clip(((np.array(end) - start) * way).sum(axis=1) / square, 0.0, 1.0)
        foot = start + share[:, None] * way
        off = np.hypot(*(foot - end).T)
        off[k] = np.inf
        near = int(off.argmin())
        if 1e-3 * same < off[near] <= close:
            bridges.append((k, (*end, *foot[near])))
            middle = tuple(np.round(0.5 * (foot[near] + end) / same).tolist())
            if middle not in middles:  # two ends that face each other are one gap
                middles.add(middle)
                gaps.append(Gap("", end, float(off[near])))
    return bridges, [gap for gap in gaps if gap.size > same]


def _split(segments: np.ndarray, same: float) -> list[list[Point]]:
    """Points along each segment where others cross or touch it, its ends among them."""
    start, end = segments[:, :2], segments[:, 2:]
    way = end - start
    low, high = np.minimum(start, end) - same, np.maximum(start, end) + same
    length = np.hypot(*way.T)
    shares: list[list[float]] = [[0.0, 1.0] for _ in segments]
    for k in range(len(segments) - 1):
        beside = k + 1 + np.flatnonzero(((low[k + 1 :] <= high[k]) & (high[k + 1 :] >= low[k])).all(axis=1))
        if not beside.size:
            continue
        between, other = start[beside] - start[k], way[beside]
        turn = way[k, 0] * other[:, 1] - way[k, 1] * other[:, 0]
        apart = np.abs(turn) > 1e-9 * length[k] * length[beside]
        safe = np.where(apart, turn, 1.0)
        own = (between[:, 0] * other[:, 1] - between[:, 1] * other[:, 0]) / safe
        its = (between[:, 0] * way[k, 1] - between[:, 1] * way[k, 0]) / safe
        slack, others = same / length[k], same / length[beside]
        meet = apart & (own > -slack) & (own < 1.0 + slack) & (its > -others) & (its < 1.0 + others)
        shares[k] += np.clip(own[meet], 0.0, 1.0).tolist()
        for j, share in zip(beside[meet].tolist(), np.clip(its[meet], 0.0, 1.0).tolist(), strict=True):
            shares[j].append(share)
        for j in beside[~apart].tolist():  # along one another
            for one, two in ((k, j), (j, k)):
                for corner in (start[two], end[two]):
                    share = float((corner - start[one]) @ way[one] / length[one] ** 2)
                    if 0.0 < share < 1.0 and np.hypot(*(start[one] + share * way[one] - corner)) <= same:
                        shares[one].append(share)
    placed = ([start[k] + share * way[k] for share in sorted(own)] for k, own in enumerate(shares))
    return [[(float(x), float(y)) for x, y in points] for points in placed]


class _Graph:
    """The arrangement: corners that are one are one node; the neighbours of each in order of their direction."""

    def __init__(self, lines: list[list[Point]], layers: list[str], same: float):
        self.points: list[Point] = []
        self.layer: dict[frozenset[int], str] = {}
        self.beside: dict[int, set[int]] = defaultdict(set)
        cells: dict[tuple[int, int], list[int]] = defaultdict(list)
        for line, layer in zip(lines, layers, strict=True):
            nodes = [self._node(point, cells, same) for point in line]
            for a, b in itertools.pairwise(nodes):
                if a != b:
                    self.beside[a].add(b)
                    self.beside[b].add(a)
                    self.layer[frozenset((a, b))] = layer

    def _node(self, point: Point, cells: dict, same: float) -> int:
        i, j = (math.floor(x / same) for x in point)
        for cell in ((i + a, j + b) for a in (0, -1, 1) for b in (0, -1, 1)):
            for node in cells.get(cell, ()):
                if math.dist(self.points[node], point) <= same:
                    return node
        self.points.append(point)
        cells[i, j].append(len(self.points) - 1)
        return len(self.points) - 1

    def prune(self) -> None:
        """Take away lines that end in nothing."""
        loose = [node for node, others in self.beside.items() if len(others) == 1]
        while loose:
            node = loose.pop()
            for other in self.beside.pop(node, ()):
                self.beside[other].discard(node)
                if len(self.beside[other]) == 1:
                    loose.append(other)

    def remove(self, edges) -> None:
        for a, b in edges:
            self.beside[a].discard(b)

    def _after(self, a: int, b: int) -> int:
        """Node that follows b on the face to the left of the edge from a to b."""
        x, y = self.points[b]

        def direction(node: int) -> float:
            return math.atan2(self.points[node][1] - y, self.points[node][0] - x)

        back = direction(a)
        return min(self.beside[b], key=lambda node: (back - direction(node)) % (2.0 * math.pi) or 2.0 * math.pi)

    def cycle(self, a: int, b: int) -> list[int]:
        """Nodes of the face to the left of the edge from a to b."""
        nodes, here = [a], (a, b)
        while True:
            here = here[1], self._after(*here)
            if here == (a, b):
                return nodes
            nodes.append(here[0])

    def _area(self, cycle: list[int]) -> float:
        corners = [self.points[node] for node in cycle]
        return 0.5 * sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(corners, (*corners[1:], corners[0]), strict=True))

    def face(self, point: Point) -> list[int] | None:
        """The boundary of the face a point is in; None outside all lines."""
        x, y = point
        crossed = []
        for a, others in self.beside.items():
            for b in others:
                (x0, y0), (x1, y1) = self.points[a], self.points[b]
                if y0 <= y < y1 and (at := x0 + (x1 - x0) * (y - y0) / (y1 - y0)) > x:
                    crossed.append((at, a, b))
        for _, a, b in sorted(crossed):  # upward: the point is to the left
            cycle = self.cycle(a, b)
            if self._area(cycle) > 0.0 and contains_point([self.points[node] for node in cycle], point):
                return cycle
        return None

    def holes(self, cycle: list[int]) -> tuple[tuple[Point, ...], ...]:
        """Outlines of what stands apart within a face."""
        outline = [self.points[node] for node in cycle]
        left, outlines = set(self.beside) - self._joined(cycle[0]), []
        while left:
            own = self._joined(next(iter(left)))
            left -= own
            first = min(own, key=lambda node: self.points[node])  # its leftmost: below it is the face around
            if not self.beside[first] or not contains_point(outline, self.points[first]):
                continue
            x, y = self.points[first]
            after = min(self.beside[first], key=lambda n: math.atan2(self.points[n][1] - y, self.points[n][0] - x))
            around = self.cycle(after, first)
            around = around if self._area(around) < 0.0 else self.cycle(first, after)
            outlines.append(tuple(self.points[node] for node in reversed(around)))
        return tuple(
            one for one in outlines if not any(one is not other and contains_point(other, one[0]) for other in outlines)
        )

    def _joined(self, node: int) -> set[int]:
        """All nodes connected with this one by lines."""
        reached, new = {node}, [node]
        while new:
            fresh = self.beside[new.pop()] - reached
            reached |= fresh
            new += fresh
        return reached
