"""An SVG of Qt with every shape and stroke in the units of its page.

Qt leaves what is drawn with a pen of so many pixels in the units of the axes, under a matrix, and asks the reader for a
stroke that does not scale: `vector-effect="non-scaling-stroke"`. Qt's own reader does so. Others draw the stroke in the
units of the axes (a bar of 0.23 stands as high as 0.73); where it is honoured it is a hair line in print."""

import re

FIXED_STROKE = 'vector-effect="non-scaling-stroke"'

_NUMBER = r"-?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"
_GROUP = re.compile(r'transform="matrix\(([^)]*)\)"([^>]*>)((?:(?!<g\b).)*?)</g>', re.DOTALL)
_ELEMENT = re.compile(r"<text\b.*?</text>|<(?P<name>\w+)\b(?P<written>[^>]*?)/>", re.DOTALL)
_POINTS = re.compile(r'\b(?:d|points)="[^"]*"')
_PAIR = re.compile(rf"({_NUMBER}),({_NUMBER})")

QUARTER = 4.0 / 3.0 * (2.0**0.5 - 1.0)
"""Arm, over the radius, of a cubic curve that is a quarter of a circle within 0.0003 of its radius."""


def convert_to_page_units(drawing: str) -> str:
    """The drawing without strokes that do not scale: the matrix of such a group moves the points of its shapes."""
    moved = _GROUP.sub(_moved, drawing)
    return moved.replace(FIXED_STROKE, 'vector-effect="none"')  # of what has no matrix: a clip


def _moved(group: re.Match) -> str:
    text, rest, inside = group.groups()
    if FIXED_STROKE not in inside:
        return group[0]
    matrix = [float(number) for number in text.split(",")]

    def place(element: re.Match) -> str:
        shape = element["name"] and _shape(element["name"], element["written"], matrix)
        return shape or f'<g transform="matrix({text})">{element[0]}</g>'  # words and pictures keep their matrix

    return f'transform="matrix(1,0,0,1,0,0)"{rest}{_ELEMENT.sub(place, inside)}</g>'


def _at(matrix: list[float], x: float, y: float) -> str:
    a, b, c, d, e, f = matrix
    return f"{a * x + c * y + e:.8g},{b * x + d * y + f:.8g}"


def _shape(name: str, written: str, matrix: list[float]) -> str | None:
    """A shape whose points a matrix has moved, None where it is none. written : its attributes"""

    def value(key: str) -> float:
        match = re.search(rf'\b{key}="({_NUMBER})"', written)
        return float(match[1]) if match else 0.0

    def points(*places: tuple[float, float]) -> str:
        return " ".join(_at(matrix, *place) for place in places)

    others = re.sub(rf' ?\b(?:x|y|width|height|[xyr][12xy]|c[xy]|r)="{_NUMBER}"', "", written)
    if name in ("polyline", "polygon", "path"):

        def place(match: re.Match) -> str:
            return _PAIR.sub(lambda pair: points((float(pair[1]), float(pair[2]))), match[0])

        return f"<{name}{_POINTS.sub(place, written)}/>"
    if name == "rect":
        x, y, width, height = map(value, ("x", "y", "width", "height"))
        corners = points((x, y), (x + width, y), (x + width, y + height), (x, y + height))
        return f'<polygon points="{corners}"{others}/>'
    if name == "line":
        ends = points((value("x1"), value("y1")), (value("x2"), value("y2")))
        return f'<polyline points="{ends}"{others}/>'
    if name in ("circle", "ellipse"):
        x, y, a, b = value("cx"), value("cy"), value("rx") or value("r"), value("ry") or value("r")
        first = ((1.0, QUARTER), (QUARTER, 1.0), (0.0, 1.0))
        curves = [
            points(*((x + a * (c * u - s * v), y + b * (s * u + c * v)) for u, v in first))
            for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))
        ]
        return f'<path d="M{points((x + a, y))} C{" C".join(curves)} Z"{others}/>'
    return None
