"""Sections of solids against shapely, and what is one body."""

import itertools
import math

import numpy as np
import pytest

from core.wall.plan import Bodies, Cell, Piece, area_of, cells_of, edge_reached, length_of, pieces_at
from core.wall.solids import Part

shapely = pytest.importorskip("shapely", reason="no wheel of shapely")

from shapely.geometry import Polygon  # noqa: E402


def pieces(rng: np.random.Generator, count: int, slanted: bool, sign: int = 1) -> list[Piece]:
    found = []
    for _ in range(count):
        x, y, a, b = np.round(rng.uniform([0.0, 0.0, 0.2, 0.2], [2.0, 3.0, 1.5, 2.0]), 2)
        turn = rng.uniform(-1.2, 1.2) if slanted else 0.0
        corners = ((0.0, 0.0), (a, 0.0), (a, b), (0.0, b))
        turned = (
            (p * math.cos(turn) - q * math.sin(turn), p * math.sin(turn) + q * math.cos(turn)) for p, q in corners
        )
        found.append(Piece(tuple((float(x + p), float(y + q)) for p, q in turned), sign))
    return found


def union(group: list[Piece]):
    return shapely.union_all([Polygon(piece.corners) for piece in group])


@pytest.mark.shows("bodies.one")
@pytest.mark.parametrize("slanted", [False, True])
@pytest.mark.parametrize("seed", range(30))
def test_that_areas_of_sections_and_of_what_they_share_are_those_of_shapely(seed, slanted):
    rng = np.random.default_rng(seed)
    one, other = pieces(rng, 4, slanted), pieces(rng, 3, slanted)
    assert area_of(cells_of(one)) == pytest.approx(union(one).area, rel=1e-9)
    both = cells_of(one, other)
    assert area_of(both) == pytest.approx(union(one).intersection(union(other)).area, rel=1e-8, abs=1e-9)
    for cell in both:
        middle = 0.5 * (cell.start + cell.end), 0.5 * (cell.outer[1] + cell.inner[1])
        assert union(one).buffer(1e-9).contains(shapely.Point(middle[1], middle[0]))
    if both:
        ends = union(one).intersection(union(other)).bounds
        assert edge_reached(both, 0.0) == pytest.approx(ends[0], abs=1e-9)
        assert edge_reached(both, 0.0, inner=True) == pytest.approx(ends[2], abs=1e-9)


@pytest.mark.parametrize("seed", range(30))
def test_that_the_edge_is_the_line_that_a_share_of_the_length_reaches(seed):
    """Lines along the wall against the section, by shapely."""
    rng = np.random.default_rng(seed)
    group = pieces(rng, 4, slanted=False)
    cells = cells_of(group)
    shape, whole = union(group), length_of(cells)

    def reaches(x: float) -> float:
        """Length along the wall of what lies before x."""
        seen = shapely.get_parts(shape.intersection(shapely.box(-9.0, -9.0, x, 9.0)))
        seen = [one.bounds for one in seen if one.area > 0.0]
        return shapely.union_all([shapely.LineString([(0.0, low), (0.0, high)]) for _, low, _, high in seen]).length

    assert whole == pytest.approx(reaches(9.0), rel=1e-9)
    edge = edge_reached(cells, 0.5)
    assert reaches(edge + 1e-6) >= 0.5 * whole - 1e-9 and reaches(edge - 1e-6) < 0.5 * whole


def part(plane: str, polygon, ends, angle: float, start: float = 0.0, weight: float = 18.0) -> Part:
    return Part(tuple(polygon), ends, angle, start, weight, plane)


def test_that_an_oblique_solid_lies_where_its_body_has_its_mass():
    """Area times x of the section is M x of a thin slice."""
    for angle in (-0.9, -0.3, 0.4, 1.1):
        one = part("oblique", ((0.2, 0.0), (2.0, 0.0), (2.0, 1.0), (0.2, 1.0)), (-0.3, 0.4), angle, 0.1)
        (piece,) = pieces_at([one], 0.5)
        shape = Polygon(piece.corners)
        assert shape.area == pytest.approx(1.8 * 0.7, rel=1e-12)
        assert shape.centroid.x == pytest.approx(one.body.centroid[0], rel=1e-12)


def box(s0, s1, z0, z1):
    return ((s0, z0), (s1, z0), (s1, z1), (s0, z1))


def test_that_cells_that_touch_at_a_corner_are_two_bodies_and_along_a_face_one():
    def count(*boxes):
        solids = [part("elevation", box(*sizes), (0.0, 0.5), 0.5 * math.pi) for sizes in boxes]
        levels = sorted({z for sizes in boxes for z in sizes[2:]})
        middles = [0.5 * (a + b) for a, b in itertools.pairwise(levels)]
        return Bodies([cells_of(pieces_at(solids, z, grown=5e-4), same=2e-3) for z in middles], 0.01, 2e-3).count

    assert count((0, 2, 0, 3), (2, 4, 3, 6)) == 2
    assert count((0, 2, 0, 3), (2, 4, 0, 6)) == 1
    assert count((0, 2, 0, 3), (2.005, 4, 0, 6)) == 2
    assert count((0, 2, 0, 3), (0, 2, 3, 6)) == 1
    assert count((0, 2, 0, 3), (1, 4, 3, 6), (3, 5, 0, 3)) == 1


def test_that_a_section_at_a_joint_is_that_just_above_it():
    solids = [part("section", box(0.0, 0.6, 0.0, 4.0), (0.0, 5.0), 0.0)]
    solids += [part("section", box(0.0, 0.4, 4.0, 9.0), (0.0, 5.0), 0.0)]
    assert area_of(cells_of(pieces_at(solids, 4.0))) == pytest.approx(2.0, rel=1e-12)
    assert area_of(cells_of(pieces_at(solids, 4.0, below=True))) == pytest.approx(3.0, rel=1e-12)


def test_that_a_leaf_no_thicker_than_what_solids_are_grown_by_is_no_body():
    """Twice 2 mm, along 2 m: 80 cm2 would be more than a tip."""
    for thickness, count in ((0.0041, 1), (0.0039, 0)):
        leaf = Cell(0.0, 2.0, (0.0,) * 3, (thickness,) * 3)
        assert Bodies([[leaf]], 0.01, 2e-3).count == count


@pytest.mark.parametrize(
    "outer, inner",
    [
        ((0.0, 0.0, 0.0), (0.2, 0.1, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, 0.1, 0.2)),
        ((0.2, 0.1, 0.0), (0.2, 0.2, 0.2)),
        ((0.0, 0.1, 0.2), (0.2, 0.2, 0.2)),
    ],
)
def test_that_a_wedge_is_a_body_whichever_end_is_its_point(outer, inner):
    assert Bodies([[Cell(0.0, 2.0, outer, inner)]], 0.01, 2e-3).count == 1


@pytest.mark.parametrize("plane, angle", [("section", 0.0), ("elevation", 0.5 * math.pi), ("oblique", 0.4)])
def test_that_a_solid_that_is_grown_is_larger_by_as_much_on_each_side(plane, angle):
    one = part(plane, box(0.2, 1.0, 0.0, 2.0), (0.1, 0.7), angle, 0.3)
    (piece,), (larger,) = pieces_at([one], 1.0), pieces_at([one], 1.0, grown=0.05)
    shape = Polygon(piece.corners)
    assert Polygon(larger.corners).symmetric_difference(shape.buffer(0.05, join_style="mitre")).area < 1e-12
    assert shape.area == pytest.approx(0.8 * 0.6, rel=1e-12)
