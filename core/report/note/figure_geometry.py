"""A figure of the note as lines, points, bars and words at their places on the paper."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from core.report.note.parts import Figure
from core.report.words import Words

FIGURE_SIZES = {1: (8.1, 4.7), 2: (8.1, 4.7), 3: (5.5, 4.1), 4: (4.4, 3.0)}
"""Width and height of a figure by how many stand side by side [cm]."""

TICKS = 5
"""Marks of an axis, about."""

FIGURE_LETTER_WIDTH = 0.15
"""Width of a letter of a figure, about [cm]."""


def ticks(low: float, high: float) -> list[float]:
    """Round numbers between the ends of an axis."""
    size = (high - low) / TICKS
    power = 10.0 ** math.floor(math.log10(size))
    step = next(step * power for step in (1.0, 2.0, 2.5, 5.0, 10.0) if step * power >= size * (1.0 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def _range(given: tuple[float, float] | None, values: Sequence[np.ndarray]) -> tuple[float, float]:
    if given:
        return given
    low, high = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    room = 0.04 * (high - low) or 1.0
    return low - room, high + room


def laid_out(figure: Figure, words: Words, side_by_side: int = 2) -> dict[str, Any]:
    """Lay out a figure, lengths in cm from its upper left corner; lines go beyond the area and are cut."""
    width, height = FIGURE_SIZES[side_by_side]
    named = [curve for curve in figure.curves if curve.name]
    rows = _legend_rows([curve.name for curve in named], width - 1.4)
    (x0, x1) = _range(figure.x_range, [np.asarray(curve.x, float) for curve in figure.curves])
    (y0, y1) = _range(figure.y_range, [np.asarray(curve.y, float) for curve in figure.curves])
    left, top, right, bottom = 0.0, 0.0, width, height
    if not figure.is_drawing:
        below = 0.75 if not figure.names else 0.35 + 0.75 * FIGURE_LETTER_WIDTH * max(map(len, figure.names))
        top = 0.15 + 0.36 * len(rows)
        height = max(height, top + figure.least_area + below)
        left, right, bottom = 1.2, width - 0.2, height - below
    wide, high = right - left, bottom - top
    if figure.is_drawing:  # the same scale both ways
        scale = min(wide / (x1 - x0), high / (y1 - y0))
        x0, x1 = (0.5 * (x0 + x1) + side * 0.5 * wide / scale for side in (-1.0, 1.0))
        y0, y1 = (0.5 * (y0 + y1) + side * 0.5 * high / scale for side in (-1.0, 1.0))

    def place(x, y) -> list[list[float]]:
        xs = (np.asarray(x, float) - x0) / (x1 - x0) * wide
        ys = high - (np.asarray(y, float) - y0) / (y1 - y0) * high
        return np.round(np.column_stack([np.clip(xs, -wide, 2 * wide), np.clip(ys, -high, 2 * high)]), 3).tolist()

    marks = []
    for curve in figure.curves:
        points = place(curve.x, curve.y)
        if curve.shape == "bars":
            half, foot = 0.35 * wide / (x1 - x0), place([0.0], [0.0])[0][1]
            points = [[x - half, min(y, foot), 2.0 * half, abs(foot - y)] for x, y in points]
        marks.append({"shape": curve.shape, "color": curve.color, "width": curve.width, "points": points})
    layout = {"size": [width, height], "area": [left, top, wide, high], "marks": marks, "caption": figure.caption}
    layout["texts"] = [[*place([label.x], [label.y])[0], label.text] for label in figure.labels]
    layout["framed"] = not figure.is_drawing
    if not figure.is_drawing:
        layout |= {"x": figure.x.strip(), "y": figure.y, "names": [], "x_ticks": []}
        layout["y_ticks"] = [[place([x0], [y])[0][1], words.number(y, "g")] for y in _clean(ticks(y0, y1))]
        if figure.names:
            layout["names"] = [[place([k], [y0])[0][0], name] for k, name in enumerate(figure.names)]
        else:
            layout["x_ticks"] = [[place([x], [y0])[0][0], words.number(x, "g")] for x in _clean(ticks(x0, x1))]
        layout["legend"] = [[[named[k].name, named[k].color, named[k].shape] for k in row] for row in rows]
    return layout


def _clean(values: list[float]) -> list[float]:
    """Values without the rounding of sums: 0.3, not 0.30000000000000004."""
    return [float(f"{value:.10g}") + 0.0 for value in values]


def _legend_rows(names: Sequence[str], width: float) -> list[list[int]]:
    """Names that stand side by side above a figure of this width [cm]."""
    rows: list[list[int]] = []
    room = 0.0
    for k, name in enumerate(names):
        need = 0.8 + FIGURE_LETTER_WIDTH * len(name)
        if not rows or need > room:
            rows.append([])
            room = width
        rows[-1].append(k)
        room -= need
    return rows
