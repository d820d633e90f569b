"""Bodies of any shape about their hinges: mass, centroid, inertia, velocity ratios; by formula and by quadrature."""

import math
from collections.abc import Callable

from core.known import require_value
from core.lab.solved.solved import Head, Kind, Sketch, Solved, row, worded
from core.lab.solved.walls import Asked
from core.report.outlines import elevation_outlines
from core.text.sentence import Sentence
from core.units import G

RECTANGLE_SOLID = {"plane": "elevation", "polygon_m": [[0, 0], [4, 0], [4, 6], [0, 6]], "to_m": 0.5}
GABLED = {"plane": "elevation", "polygon_m": [[0, 0], [6, 0], [6, 5], [3, 7], [0, 5]], "to_m": 0.5}
DOOR = {"plane": "elevation", "opening": True, "polygon_m": [[2.3, 0], [3.7, 0], [3.7, 2.6], [2.3, 2.6]], "to_m": 0.5}
ROSE = {
    "plane": "elevation",
    "opening": True,
    "polygon_m": [[3.0 + 0.8 * math.cos(math.pi / 8 * k), 4.2 + 0.8 * math.sin(math.pi / 8 * k)] for k in range(16)],
    "to_m": 0.5,
}


def section_of(corners: list[list[float]], width: float) -> dict:
    """A solid by its section. width : along the wall [m]"""
    return {"plane": "section", "polygon_m": corners, "to_m": width}


def corner_of(
    height: float, lengths: tuple[float, float], thicknesses: tuple[float, float], angle: float
) -> list[dict]:
    """Two walls of a corner, dragged along cracks to `lengths` at the top, turning towards `angle` [deg]."""
    (l1, l2), (t1, t2) = lengths, thicknesses
    first = {"plane": "oblique", "angle_deg": angle, "polygon_m": [[0, 0], [l1, height], [0, height]], "to_m": t1}
    polygon = [[t1, height * t1 / l2], [l2, height], [t1, height]]
    return [first, {"plane": "oblique", "angle_deg": angle - 90.0, "polygon_m": polygon, "from_m": -t2, "to_m": 0.0}]


STEPPED_SOLIDS = [
    section_of([[0, 0], [0.6, 0], [0.6, 4], [0, 4]], 5.0),
    section_of([[0, 4], [0.45, 4], [0.45, 8], [0, 8]], 5.0),
]
WEDGES = section_of([[0.5, 0], [2.5, 6], [0.5, 6]], 0.8)
COPING = {"kind": "carried_mass", "kn_m": 0.3 * 9.80665 / 4.0, "d_m": 0.25, "h_m": 6.0}
ROOF = {"kind": "carried_mass", "kn_m": 1.5 * 9.80665 / 4.0, "d_m": 0.10, "h_m": 5.8}

HEADS: tuple[Head, ...] = (
    ("M", "kg"),
    ("x_G", "m"),
    ("z_G", "m"),
    ("α", "°"),
    ("R", "m"),
    ("p²", "1/s²"),
    (worded("e one-sided"), ""),
    (worded("α about the inner hinge"), "°"),
    (worded("p² about the inner hinge"), "1/s²"),
    (worded("e outer to inner hinge"), ""),
    (worded("e inner to outer hinge"), ""),
)


def body(
    key: str,
    title: Sentence,
    sizes: tuple[float, float, float],
    values: str,
    solids: list[dict],
    loads: tuple[dict, ...] = (),
) -> Solved:
    """sizes : H, t, L [m]; values : by HEADS"""
    height, thickness, length = sizes
    keys: dict[str, object] = {"height_m": height, "thickness_m": thickness, "length_m": length}
    keys |= ({"solid": solids} if solids else {}) | ({"load": list(loads)} if loads else {})
    asked = Asked(keys, None)

    def found() -> tuple[float, ...]:
        """The numbers by HEADS."""
        wall = asked.wall
        block = wall.block()
        mass = require_value(wall.weight) / G + sum(1e3 * (load.kn_m or 0.0) * length / G for load in wall.load)
        outer = *block.centroid, math.degrees(block.slenderness), block.radius, block.p2
        ratio = wall.restitution_of("one_sided").ratio_at_rest
        if values.split()[7] == "-":  # an inner hinge it does not turn about
            return mass, *outer, ratio, *[math.nan] * 4
        inner, both = wall.in_si.inner_block or block, wall.restitution_of("two_sided")
        back = both.ratio_at_rest if both.ratio_inward is None else both.ratio_inward
        return mass, *outer, ratio, math.degrees(inner.slenderness), inner.p2, both.ratio_at_rest, back

    return Solved(
        f"body_{key}",
        Kind.HAND,
        title,
        "physics.md, 20",
        row(HEADS, values, found),
        "M = rho A T, quad tan alpha = x_G/z_G, quad p^2 = (M g R)/I_O, quad e_(P Q) = (I_G + M thin bold(G P) dot "
        "bold(G Q))/(I_G + M thin G Q^2)",
        elevation(asked) if solids and all(solid["plane"] == "elevation" for solid in solids) else asked.sketch,
        worded(
            "18 kN/m³, {h:g} × {t:g} m, length {length:g} m; worked by Green's theorem and by quadrature.",
            h=height,
            t=thickness,
            length=length,
        ),
        asked.table,
    )


def elevation(asked: Asked) -> Callable[[], Sketch]:
    def drawn() -> Sketch:
        outlines = [tuple(points) for points, _ in elevation_outlines(asked.wall)]
        return Sketch(outlines[0], others=tuple(outlines[1:])) if outlines else asked.sketch()  # none of a rectangle

    return drawn


CASES: tuple[Solved, ...] = (
    body(
        "rectangle",
        worded("A rectangle written as a solid"),
        (6.0, 0.5, 4.0),
        "22025.9 0.25000 3.00000 4.7636 3.01040 2.44319 0.47958 4.7636 2.44319 0.98966 0.98966",
        [RECTANGLE_SOLID],
    ),
    body(
        "gable",
        worded("A gable"),
        (2.4, 0.3, 6.0),
        "3964.7 0.15000 0.80000 10.6197 0.81394 8.06266 0.29119 10.6197 8.06266 0.95455 0.95455",
        [{"plane": "elevation", "polygon_m": [[0, 0], [6, 0], [3, 2.4]], "to_m": 0.3}],
    ),
    body(
        "gabled_wall",
        worded("A wall with a gable"),
        (7.0, 0.5, 6.0),
        "33038.8 0.25000 3.02778 4.7201 3.03808 2.39947 0.45207 4.7201 2.39947 0.98993 0.98993",
        [GABLED],
    ),
    body(
        "openings",
        worded("A wall with a gable, a door and a rose window"),
        (7.0, 0.5, 6.0),
        "27900.0 0.25000 3.15910 4.5248 3.16898 2.34164 0.48084 4.5248 2.34164 0.99058 0.99058",
        [GABLED, DOOR, ROSE],
    ),
    body(
        "stepped",
        worded("A stepped wall"),
        (8.0, 0.6, 5.0),
        "38545.3 0.26786 3.71429 4.1248 3.72393 1.90750 0.43414 5.1100 1.90631 0.98961 0.99161",
        STEPPED_SOLIDS,
    ),
    body(
        "battered",
        worded("A battered wall"),
        (5.0, 0.8, 1.0),
        "5506.5 0.48889 2.22222 12.4074 2.27536 3.09054 0.38097 7.9696 3.10904 0.96484 0.94583",
        [section_of([[0, 0], [0.8, 0], [0.8, 5], [0.4, 5]], 1.0)],
    ),
    body(
        "wedges",
        worded("A wall with wedges of its return walls"),
        (6.0, 0.5, 4.0),
        "30836.2 0.51190 3.28571 8.8553 3.32535 2.29229 0.54623 - - - -",
        [RECTANGLE_SOLID, WEDGES],
    ),
    body(
        "corner",
        worded("A corner of two walls"),
        (4.0, 0.5, 4.0),
        "9330.4 0.98048 2.75774 19.5722 2.92686 2.99031 0.81310 - - - -",
        corner_of(4.0, (3.0, 3.0), (0.5, 0.5), 45.0),
    ),
    body(
        "corner_crack",
        worded("A corner dragged along steep cracks"),
        (6.0, 0.6, 1.0),
        "12389.6 - - 11.8839 - 2.07817 - - - - -",
        corner_of(6.0, (2.4, 2.4), (0.6, 0.6), 45.0),
    ),
    body(
        "corner_unlike",
        worded("A corner of unlike walls"),
        (6.0, 0.45, 1.0),
        "9267.4 - - 10.4230 - 2.10026 - - - - -",
        corner_of(6.0, (2.4, 1.5), (0.6, 0.45), 50.0),
    ),
    body(
        "coping",
        worded("A wall with a coping"),
        (6.0, 0.5, 4.0),
        "22325.9 0.25000 3.04031 4.7008 3.05057 2.41149 0.47973 4.7008 2.41149 0.98992 0.98992",
        [],
        (COPING,),
    ),
    body(
        "roof",
        worded("A wall with a roof that moves with it"),
        (6.0, 0.5, 4.0),
        "23525.9 0.24044 3.17853 4.3258 3.18761 2.32269 0.48524 4.6685 2.32213 0.99036 0.99107",
        [],
        (ROOF,),
    ),
    *(
        body(
            f"leaning_{key}",
            worded("A wall out of plumb by {f:g} m", f=lean),
            (height, thickness, 1.0),
            f"- - - {values[0]} - {values[1]} {values[2]} {values[3]} {values[4]} - -",
            [section_of([[0, 0], [thickness, 0], [thickness - lean, height], [-lean, height]], 1.0)],
        )
        for key, height, thickness, lean, values in (
            ("tall", 7.0, 0.83, 0.10, ["5.9536", "2.08834", "0.45338", "7.5678", "2.08486"]),
            ("storey", 3.0, 0.45, 0.06, ["7.4069", "4.85525", "0.42638", "9.6480", "4.84103"]),
            ("church", 11.0, 0.90, 0.15, ["3.9005", "1.33343", "0.47602", "5.4526", "1.33196"]),
        )
    ),
)
