"""Figure of a wall that spans between transverse walls: its plan, both halves as they turn, and their three hinges."""

from core.codes.bending_outline import outlines, shown_rotation
from core.codes.vertical_bending import bending
from core.known import require_value
from core.report.note.parts import Curve, Figure, Label, path
from core.report.words import Words
from core.study.results import WallResult
from core.wall.bending import hinges_of


def drawing(wall: WallResult, words: Words) -> Figure:
    """The plan to scale, outside below: sizes, transverse walls, hinges at rest, the halves turned (dashed), and the
    thrust of the ends."""
    mechanism, arch = bending(wall.wall.in_si), require_value(wall.wall.in_si.arch)
    span, t, h1 = arch.spacing, mechanism.strip.thickness, mechanism.h1
    at, beyond = hinges_of(mechanism.strip, h1), 0.18 * span

    def in_plan(points):
        return [(z, x) for x, z in points]

    curves = [
        *(path(in_plan(corners), "accent", width=1.8) for corners in outlines(mechanism.strip, h1, 0.0)),
        *(
            path(in_plan(corners), "quiet", "dash", 0.9)
            for corners in outlines(mechanism.strip, h1, shown_rotation(mechanism))
        ),
        Curve("", (0.0, h1, span), (at.base, at.between, at.top), "bad", "points"),
    ]
    for end, way in ((0.0, -1.0), (span, 1.0)):
        wide = 0.6 * beyond * way
        crossing = [(end, 0.0), (end + wide, 0.0), (end + wide, 3.0 * beyond), (end, 3.0 * beyond), (end, 0.0)]
        curves.append(path(crossing, "ink", width=1.1))
        tip, size = end + 0.1 * beyond * way, 0.05 * span
        arrow = [(tip + 1.4 * size * way, at.base), (tip, at.base)]
        barb = [(tip + 0.4 * size * way, at.base + 0.3 * size), (tip, at.base)]
        curves += [path(arrow, "bad"), path([*barb, (tip + 0.4 * size * way, at.base - 0.3 * size)], "bad")]
    low = -0.16 * span
    sides = [[(z, low - 0.01 * span), (z, low + 0.01 * span), (z, low)] for z in (0.0, span)]
    curves.append(path([*sides[0], *reversed(sides[1])], "ink", width=0.7))
    thrust = f"H {words.number(1e-3 * arch.thrust, '.1f')} kN/m"
    labels = [
        Label(f"L {words.number(span, '.2f')} m", 0.5 * span, low - 0.06 * span),
        Label(f"t {words.number(t, '.2f')} m, u {words.number(arch.setback, '.3f')} m", 0.5 * span, t + 0.08 * span),
        Label(thrust, 0.5 * span, t + 0.2 * span),
    ]
    caption = words.say(
        "{wall}: in plan, sizes, hinges (red points) and mechanism (dashed), between its transverse walls",
        wall=words.titled(wall.name),
    )
    y_range, x_range = (-0.3 * span, 3.2 * beyond), (-beyond, span + beyond)
    return Figure(caption, curves, y_range=y_range, labels=labels, x_range=x_range)
