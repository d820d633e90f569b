"""The solids of a wall as outlines to draw: in section (x, z), turned with the wall, and in elevation (s, z)."""

from typing import NamedTuple

from core.wall.solids import Part

Points = list[tuple[float, float]]


class Outline(NamedTuple):
    """points : corners [m]; kind : solid, opening or wedge"""

    points: Points
    kind: str


def _kind(part: Part) -> str:
    return "opening" if part.weight < 0.0 else "wedge" if part.wedge else "solid"


def section_outlines(wall) -> list[Outline]:
    """The outline of each solid seen along the wall: x inward from the outer face of the base [m]; of one that is not
    extruded along the wall the hull of what is seen."""
    outlines = []
    for part in wall.parts:
        if part.plane == "section":
            points = [(part.x_of(s, 0.0), z) for s, z in part.polygon]
        else:
            points = _hull([(part.x_of(s, n), z) for s, z in part.polygon for n in part.ends])
        outlines.append(Outline(points, _kind(part)))
    return outlines


def _hull(points: Points) -> Points:
    """The convex outline of points, by Andrew's monotone chain."""

    def half(ordered: Points) -> Points:
        kept: Points = []
        for p in ordered:
            while len(kept) > 1:
                (ax, ay), (bx, by) = kept[-2], kept[-1]
                if (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) > 0.0:
                    break
                kept.pop()
            kept.append(p)
        return kept[:-1]

    ordered = sorted(set(points))
    return half(ordered) + half(ordered[::-1])


def elevation_outlines(wall) -> list[Outline]:
    """The outline of each solid seen from outside: s along the wall [m]; of one in another plane its extent."""
    outlines = []
    for part in wall.parts:
        if part.plane == "elevation":
            points = list(part.polygon)
        else:
            heights = [z for _, z in part.polygon]
            points = _box(part.ends, (min(heights), max(heights)))
        outlines.append(Outline(points, _kind(part)))
    return outlines


def _box(across: tuple[float, float], up: tuple[float, float]) -> Points:
    (left, right), (low, high) = across, up
    return [(left, low), (right, low), (right, high), (left, high)]
