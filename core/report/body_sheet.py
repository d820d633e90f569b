"""The sheet Bodies: the corners of each solid, and from them its mass, centroid and moment of inertia as formulas."""

import itertools
import math

from core.derivation.geometry import solid_name
from core.report.cells import QUIET, Book, header, number, paragraph, rule, text, title
from core.report.derived import cell_prefix
from core.report.rows import formula_row, heads
from core.study.results import StudyResult, WallResult
from core.units import G
from core.wall.solids import Part

LENGTH_FORMAT, CROSS = "0.0000", "0.000000"


def has_bodies(result: StudyResult) -> bool:
    """Whether a wall is no rectangle."""
    return any(wall.wall.parts for wall in result.walls)


def bodies(book: Book, result: StudyResult) -> None:
    """Write one block a wall, in it one a solid; the sheet Check takes its masses from here."""
    say = book.say
    sheet = book.sheet("Bodies", [34, 13, 13, 13, 13, 13, 13, 13])
    title(sheet, 1, say("Bodies from their solids"))
    words = say(
        "Green's theorem over the corners (s, z) of each polygon, extruded from n1 to n2; x from the outer face of the "
        "base inward, z above the hinge. The columns are s0 z1 - s1 z0 and what is summed for each edge."
    )
    row = paragraph(sheet, 2, words, 8, 120, color=QUIET)
    for wall in result.walls:
        if parts := wall.wall.parts:
            row = heads(book, sheet, row + 1, book.titled(wall.name))
            for k, part in enumerate(parts, start=1):
                row = _solid(book, sheet, result, wall, part, k, row + 1)


def _solid(book: Book, sheet, result: StudyResult, wall: WallResult, part: Part, k: int, row: int) -> int:
    """The corners of a solid, an edge a row, the sums below."""
    say, name = book.say, f"{cell_prefix(result, wall)}solid{k}_"
    kind = say("opening") if part.weight < 0.0 else say("wedge") if part.wedge else say("solid")
    labels = [f"{solid_name(part, k)} {kind}", "s [m]", "z [m]", "s0 z1 - s1 z0", "s", "z", "s²", "z²"]
    header(sheet, row, labels, 1, 18)
    first = row + 1
    corners = (*part.polygon, part.polygon[0])
    for s, z in corners:
        row += 1
        number(sheet, row, 2, s, LENGTH_FORMAT)
        number(sheet, row, 3, z, LENGTH_FORMAT)
    for j, ((s0, z0), (s1, z1)) in enumerate(itertools.pairwise(corners)):
        at, cross = first + j, s0 * z1 - s1 * z0
        a, b = f"B{at}", f"B{at + 1}"
        c, d = f"C{at}", f"C{at + 1}"
        edge = (
            (f"={a}*{d}-{b}*{c}", cross),
            (f"=D{at}*({a}+{b})/6", cross * (s0 + s1) / 6.0),
            (f"=D{at}*({c}+{d})/6", cross * (z0 + z1) / 6.0),
            (f"=D{at}*({a}^2+{a}*{b}+{b}^2)/12", cross * (s0 * s0 + s0 * s1 + s1 * s1) / 12.0),
            (f"=D{at}*({c}^2+{c}*{d}+{d}^2)/12", cross * (z0 * z0 + z0 * z1 + z1 * z1) / 12.0),
        )
        for column, (live, value) in enumerate(edge, start=4):
            book.formula(sheet.cell(at, column), live, value, CROSS)
    rule(sheet, row, 1, 8)
    return _sums(book, sheet, part, name, first, row - 1, row + 1)


def _sums(book: Book, sheet, part: Part, name: str, first: int, last: int, row: int) -> int:
    """Write the sums of a solid, by its edges in these rows."""
    say, body = book.say, part.body
    x, z = body.centroid
    given = (
        ("n1", "m", part.ends[0]),
        ("n2", "m", part.ends[1]),
        ("x0", "m", part.start),
        (say("plan angle"), "°", math.degrees(part.angle)),
        (say("unit weight"), "kN/m³", 1e-3 * part.weight),
    )
    at = {}
    for (label, unit, value), key in zip(given, ("n1", "n2", "x0", "angle", "weight"), strict=True):
        text(sheet, row, 1, label)
        number(sheet, row, 3, value, "General")
        text(sheet, row, 5, unit, color=QUIET, align="center")
        at[key] = f"C{row}"
        row += 1
    of = {key: f"SUM({letter}{first}:{letter}{last})" for key, letter in zip("dsz", "DEF", strict=True)}
    turn = f"SIGN({of['d']})"
    one = f"({at['n2']}-{at['n1']})"
    two, three = f"({at['n2']}^2-{at['n1']}^2)/2", f"({at['n2']}^3-{at['n1']}^3)/3"
    cosine, sine = (f"{f}(RADIANS({at['angle']}))" for f in ("COS", "SIN"))
    density = f"1000*{at['weight']}/{G!r}"
    area, ss, zz = f"{turn}*{of['d']}/2", f"{turn}*SUM(G{first}:G{last})", f"{turn}*SUM(H{first}:H{last})"
    s, z_sum = f"{turn}*{of['s']}", f"{turn}*{of['z']}"
    across = f"({cosine}*{s}*{one}+{sine}*{two}*{area})"
    squares = f"({cosine}^2*{ss}*{one}+2*{sine}*{cosine}*{s}*{two}+{sine}^2*{three}*{area})"
    x0 = at["x0"]
    inertia = f"{density}*({x0}^2*{area}*{one}+2*{x0}*{across}+{squares}+{zz}*{one})"
    mass = f"{name}m"
    row = formula_row(book, sheet, row, "M", "", f"={density}*{area}*{one}", body.mass, "kg", mass, "0.0")
    live = f"={density}*({x0}*{area}*{one}+{across})/{mass}"
    row = formula_row(book, sheet, row, "x", "", live, x, "m", f"{name}x")
    row = formula_row(book, sheet, row, "z", "", f"={density}*{z_sum}*{one}/{mass}", z, "m", f"{name}z")
    return formula_row(book, sheet, row, "I", "", f"={inertia}", body.inertia, "kg m²", f"{name}i", "0.0")
