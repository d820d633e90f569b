"""Figure of a wall held at its top: both blocks as they turn, and their three hinges."""

from core.codes.bending_outline import outlines, shown_rotation
from core.codes.vertical_bending import bending
from core.report.load_arrows import arrows
from core.report.note.parts import Curve, Figure, Label, path
from core.report.words import Words
from core.study.results import WallResult
from core.wall.bending import hinges_of


def _clear(height: float, others: list[float], h: float) -> float:
    """A height for a label near this one [m], below the labels of loads that would stand on it."""
    while any(abs(height - other) < 0.06 * h for other in others):
        height -= 0.02 * h
    return height


def drawing(wall: WallResult, words: Words) -> Figure:
    """The wall to scale with its sizes, its hinges at rest, what holds its top and the blocks turned (dashed)."""
    asked, mechanism = wall.wall, bending(wall.wall.in_si)
    h, t, u, h1 = wall.height, wall.thickness, asked.setback, mechanism.h1
    at = hinges_of(mechanism.strip, h1)

    def outward(points):
        return [(t - x, z) for x, z in points]

    blocks = [outward(corners) for corners in outlines(mechanism.strip, h1, shown_rotation(mechanism))]
    curves = [
        *(path(outward(corners), "accent", width=1.8) for corners in outlines(mechanism.strip, h1, 0.0)),
        *(path(corners, "quiet", "dash", 0.9) for corners in blocks),
        Curve("", (t - at.base, t - at.between, t - at.top), (0.0, h1, h), "bad", "points"),
        Curve("", (-0.45 * h, t + 0.45 * h), (0.0, 0.0), "quiet", width=1.1),
    ]
    foot, wide = 0.03 * h, 0.05 * h  # the top is held outward, and free to rise
    support = [(t, h), (t + wide, h + foot), (t + wide, h - foot), (t, h)]
    curves += [path(support, "ink", width=0.9)]
    curves += [path([(t + 1.3 * wide, h - 1.6 * foot), (t + 1.3 * wide, h + 1.6 * foot)], "ink", width=0.9)]
    curves += [path(points, "amber", width=1.3) for points in arrows(asked, h, t)]
    beside, tick = t + 0.30 * h, 0.02 * h
    low, high = ([(beside - tick, z), (beside + tick, z), (beside, z)] for z in (0.0, h))
    curves.append(path([*low, *reversed(high)], "ink", width=0.7))
    on = arrows(asked, h, t)
    labels = [
        Label(f"H {words.number(h, '.2f')} m", beside + 0.20 * h, 0.5 * h),
        Label(f"h₁ {words.number(h1, '.2f')} m", -0.26 * h, _clear(h1, [points[0][1] + 0.05 * h for points in on], h)),
        Label(f"t {words.number(t, '.2f')} m" + (f", u {words.number(u, '.3f')} m" if u else ""), 0.5 * t, -0.07 * h),
    ]
    for load, points in zip(asked.load, on, strict=True):
        x, y = points[0]
        labels.append(Label(f"{words.number(1e-3 * load.in_si.force, '.2f')} kN/m", x, y + 0.05 * h))
    caption = words.say(
        "{wall}: sizes, hinges (red points) and mechanism (dashed), held at its top", wall=words.titled(wall.name)
    )
    if asked.held_by:
        caption += words.say("; at its top: {restraint}", restraint=words.word(f"choice_{asked.held_by.kind}"))
    if asked.load:
        caption += words.say("; loads as arrows")
    top = max([1.08 * h, *(label.y + 0.04 * h for label in labels)])
    return Figure(caption, curves, y_range=(-0.14 * h, top), labels=labels, x_range=(-0.5 * h, t + 0.65 * h))
