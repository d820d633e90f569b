"""Brackets of a failure narrowed by bisection, several side by side."""

import numpy as np

BRACKET = 1e-4
"""Bisection ends when the bracket is narrower than this fraction."""

HALVINGS = 2
"""Bisections made at once: all midpoints they may ask for run side by side."""


def bisect_brackets(brackets: list[tuple[float, float]], failures) -> list[tuple[float, float] | None]:
    """Brackets of failures between low, which holds, and high, which fails, narrowed side by side until none
    is wider than BRACKET: those of arithmetic midpoints, one after the other.

    failures(points) : [(fails, unknown)], flags of each of the arrays of points. None where a midpoint a
    bisection needs is unknown.
    """
    narrowed: list[tuple[float, float] | None] = list(brackets)
    while points := midpoints(narrowed):
        narrowed = all_narrowed(narrowed, points, failures([part[1:-1] for part in points]))
    return narrowed


def midpoints(brackets: list) -> list[np.ndarray]:
    """Ends and midpoints of each bracket, of a narrow one none; empty where all are narrow."""
    wide = [bracket is not None and not _narrow(*bracket) for bracket in brackets]
    if not any(wide):
        return []
    return [_halved(*bracket) if asked else np.zeros(2) for asked, bracket in zip(wide, brackets, strict=True)]


def all_narrowed(brackets: list, points: list[np.ndarray], flags) -> list:
    """The brackets after `points` of `midpoints`, with the flags of their midpoints."""
    return [
        _narrowed(part, *part_flags) if part.size > 2 else bracket
        for bracket, part, part_flags in zip(brackets, points, flags, strict=True)
    ]


def _narrow(low: float, high: float) -> bool:
    return high / low - 1.0 <= BRACKET


def _halved(low: float, high: float) -> np.ndarray:
    """All midpoints that HALVINGS bisections may ask for, and the ends."""
    edges = np.array([low, high])
    for _ in range(HALVINGS):
        halved = np.empty(2 * edges.size - 1)
        halved[::2], halved[1::2] = edges, 0.5 * (edges[:-1] + edges[1:])
        edges = halved
    return edges


def _narrowed(edges, fails, unknown) -> tuple[float, float] | None:
    """Bracket to which bisecting between the first edge and the last leads, the midpoints known."""
    first, last = 0, edges.size - 1
    while last - first > 1 and not _narrow(edges[first], edges[last]):
        middle = (first + last) // 2
        if unknown[middle - 1]:
            return None
        if fails[middle - 1]:
            last = middle
        else:
            first = middle
    return float(edges[first]), float(edges[last])
