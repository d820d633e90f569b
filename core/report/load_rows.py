"""Live formulas of a wall with loads on the Check sheet: one block, a and c, the sums of the kinematic chain."""

import math

from core.report.cells import RATIO, Book, fill, header, number, rule, text
from core.report.rows import CHANGED, INPUT_FILL, found_row, input_row, live_row, mark_changed
from core.study.results import WallResult
from core.text.sentence import word
from core.units import G
from core.wall import wall_loads

SIZE = "0.000"


MOMENTS = {"wx": "W x", "nd": "ΣN d", "fh": "ΣF h", "wy": "W y", "qh": "ΣQ h"}
"""Moments of alpha_0: end of the name of the cell -> as it is written."""


def moments(wall: WallResult) -> dict[str, float]:
    """The same with their values [N], about the governing hinge."""
    return dict(zip(MOMENTS, wall_loads.start_moments(wall.wall, governing_side(wall)), strict=True))


def governing_side(wall: WallResult) -> float:
    """The hinge the formulas are written about: 1.0 the outer one, -1.0 the inner one where that is the weaker."""
    tangent = math.tan(wall.block.slenderness)
    outer, inner = (s.sine * tangent + s.cosine for s in (wall.model.restoring, wall.model.mirrored))
    return -1.0 if not wall.model.one_sided and inner < outer else 1.0


def sides_agree(wall: WallResult) -> bool:
    """Whether the side that lifts first is the one that overturns first, so that d_0 is of the same formulas."""
    model = wall.model
    shown = model.restoring if governing_side(wall) > 0.0 else model.mirrored
    return model.one_sided != 0.0 or shown.lean == model.lean


def geometry_rows(book: Book, sheet, wall: WallResult, name: str, row: int) -> int:
    """Sizes, loads and what follows from them, up to a_RM."""
    say, asked, block = book.say, wall.wall, wall.block
    side = governing_side(wall)
    row = input_row(book, sheet, row, "H", wall.height, "m", f"{name}_height", RATIO)
    row = input_row(book, sheet, row, "t", wall.thickness, "m", f"{name}_thickness", SIZE)
    setback_row = found_row if asked.compressive_strength_mpa else input_row
    row = setback_row(book, sheet, row, say("hinge setback u"), asked.setback, "m", f"{name}_setback")
    row = input_row(book, sheet, row, say("unit weight"), asked.unit_weight_kn_m3, "kN/m³", f"{name}_weight", RATIO)
    weight = wall_loads.weight_per_metre(asked) / 1e3
    row = live_row(
        book,
        sheet,
        row,
        "W = w t H",
        "",
        f"={name}_weight*{name}_thickness*{name}_height",
        weight,
        "kN/m",
        f"{name}_w",
        SIZE,
    )
    bare = asked.bare_block()
    row = live_row(
        book,
        sheet,
        row,
        "x = t/2 − u",
        "",
        f"={name}_thickness/2-{name}_setback",
        bare.centroid[0],
        "m",
        f"{name}_x",
        SIZE,
    )
    row = live_row(book, sheet, row, "y = H/2", "", f"={name}_height/2", bare.centroid[1], "m", f"{name}_y", SIZE)
    where = say("about the outer hinge") if side > 0.0 else say("about the inner hinge")
    header(sheet, row, [f"{say('Loads')}, {where}", "N [kN/m]", "F [kN/m]", "d [m]", "h [m]", "Q [kN/m]"], 1, 18)
    first = row + 1
    for load in asked.load:
        row += 1
        force = wall_loads.as_force(load, asked, side)
        text(sheet, row, 1, word(f"load_{load.kind}", book.language))
        pushed = load.kn_m if load.pushes else 0.0
        # d is entered from the face of this hinge: the formulas take off u
        values = (1e-3 * force.vertical, 1e-3 * force.horizontal, force.distance + asked.setback, force.height, pushed)
        for column, value in enumerate(values, start=2):
            fill(number(sheet, row, column, value, SIZE), INPUT_FILL)
            number(sheet, row, CHANGED + column - 1, value, SIZE)
        mark_changed(book, sheet, row, f"B{row}:F{row}", f"P{row}:T{row}")
        rule(sheet, row, 1, 6)
    ranges = {key: f"${column}${first}:${column}${row}" for key, column in zip("NFdhQ", "BCDEF", strict=True)}
    ranges["d"] = f"({ranges['d']}-{name}_setback)"
    model = wall.model
    restoring = model.restoring if side > 0.0 else model.mirrored
    return _block_rows(book, sheet, name, ranges, row + 1, block, model, restoring)


def _block_rows(book: Book, sheet, name, r, row, block, model, restoring) -> int:
    """From the sums over the loads to a_RM. r : ranges of N, F, d, h and Q."""
    q, d, h = r["Q"], r["d"], r["h"]
    x, y = f"({name}_w*{name}_x+SUMPRODUCT({q},{d}))", f"({name}_w*{name}_y+SUMPRODUCT({q},{h}))"
    total = f"({name}_w+SUM({q}))"
    degrees = math.degrees(block.slenderness)
    row = live_row(book, sheet, row, "α", "Fig. 1", f"=DEGREES(ATAN({x}/{y}))", degrees, "°", f"{name}_slenderness")
    row = live_row(book, sheet, row, "R", "Fig. 1", f"=SQRT({x}^2+{y}^2)/{total}", block.radius, "m", f"{name}_radius")
    own = f"{name}_w*(({name}_height^2+{name}_thickness^2)/12+{name}_x^2+{name}_y^2)"
    row = live_row(
        book,
        sheet,
        row,
        "I0/m",
        "Fig. 1",
        f"=({own}+SUMPRODUCT({q},{d}^2+{h}^2))/{total}",
        block.inertia_over_mass,
        "m²",
        f"{name}_inertia",
    )
    row = live_row(
        book,
        sheet,
        row,
        "p",
        "Eq. 1",
        f"=SQRT(gravity*{name}_radius/{name}_inertia)",
        block.frequency_parameter,
        "rad/s",
        f"{name}_p",
    )
    sine, cosine = (f"{way}(RADIANS({name}_slenderness))" for way in ("SIN", "COS"))
    along, across = f"({h}*{cosine}+{d}*{sine})", f"({d}*{cosine}-{h}*{sine})"
    held, force, scale = f"({r['N']}-{q})", r["F"], f"({total}*{name}_radius)"
    row = live_row(
        book,
        sheet,
        row,
        "a",
        "Eq. 1",
        f"=1+(SUMPRODUCT({held},{along})-SUMPRODUCT({force},{across}))/{scale}",
        restoring.sine,
        "–",
        f"{name}_a",
    )
    row = live_row(
        book,
        sheet,
        row,
        "c",
        "Eq. 1",
        f"=(SUMPRODUCT({held},{across})+SUMPRODUCT({force},{along}))/{scale}",
        restoring.cosine,
        "–",
        f"{name}_c",
    )
    row = live_row(
        book,
        sheet,
        row,
        "θ_c = α + arctan(c/a)",
        "Eq. 1",
        f"=RADIANS({name}_slenderness)+ATAN({name}_c/{name}_a)",
        block.slenderness + restoring.lean,
        "rad",
        f"{name}_theta_c",
    )
    row = live_row(
        book,
        sheet,
        row,
        "a_RM / g = a tan α + c",
        "Eq. 2",
        f"={name}_a*TAN(RADIANS({name}_slenderness))+{name}_c",
        model.threshold / G,
        "g",
        f"{name}_a_rm",
        "0.000",
        f"{name}_a_rm_run",
    )
    book.sums[name] = r
    return row


def impact_formulas(name: str) -> tuple[str, str]:
    """The ratios of the impacts of a wall with masses that move with it, as formulas: outer to inner hinge, and inner
    hinge to the top of the inner face (`restitution.impact_ratio`)."""
    sine, cosine = (f"{name}_radius*{way}(RADIANS({name}_slenderness))" for way in ("SIN", "COS"))
    own = f"{name}_inertia-{name}_radius^2"
    inward = f"({name}_thickness-2*{name}_setback-{sine})"
    above = f"({name}_height-{cosine})"
    outer = f"(({own}-{sine}*{inward}+({cosine})^2)/({own}+{inward}^2+({cosine})^2))"
    top = f"ABS(({own}+{inward}^2-{cosine}*{above})/({own}+{inward}^2+{above}^2))"
    return outer, top


def chain_formulas(book: Book, name: str) -> dict[str, str]:
    """alpha_0, e* and d_0 of a wall with loads as formulas (C8.7.1.1, .5, .4)."""
    r = book.sums[name]
    n, f, d, h, q = (r[key] for key in "NFdhQ")
    first = f"({name}_w*{name}_y+SUMPRODUCT({q},{h}))"
    second = f"({name}_w*{name}_y^2+SUMPRODUCT({q},{h}^2))"
    holding = f"({name}_w*{name}_x+SUMPRODUCT({n},{d})+SUMPRODUCT({f},{h}))"
    radius = f"SQRT({name}_x^2+{name}_y^2)"
    centroid = f"({name}_x-{radius}*SIN(ATAN({name}_x/{name}_y)-{name}_theta_c))"
    return {
        "wx": f"={name}_w*{name}_x",
        "nd": f"=SUMPRODUCT({n},{d})",
        "fh": f"=SUMPRODUCT({f},{h})",
        "wy": f"={name}_w*{name}_y",
        "qh": f"=SUMPRODUCT({q},{h})",
        "alpha0": f"={holding}/{first}",
        "e_star": f"={first}^2/(({name}_w+SUM({q}))*{second})",
        "d0": f"={centroid}*{second}/({name}_y*{first})",
        "period": f"16*PI()^2*SUMPRODUCT({q},{h}^3)/(1000*gravity*{name}_modulus*{name}_thickness^3)",
    }
