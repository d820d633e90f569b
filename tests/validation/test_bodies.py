"""Bodies of any shape: worked values, quadrature, invariances, histories written from coordinates."""

import itertools
import math

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.kinematic import elastic_period
from core.errors import InputError
from core.report.outlines import elevation_outlines, section_outlines
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS
from core.rocking.outcome import STABLE
from core.setting.check_input import make_rocking_model
from core.study.run import run
from core.wall.body import Body, extruded, polygon_sums, sum_bodies
from core.wall.masonry import base_length, inner_of
from core.wall.rocking_model import OtherSide, RockingModel
from core.wall.solids import clipped
from tests.conftest import ROOT
from tests.core.variation.one_evaluation import looked_at
from tests.validation import loaded_walls

G = 9.80665

RECTANGLE = {"plane": "elevation", "polygon_m": [[0, 0], [4, 0], [4, 6], [0, 6]], "to_m": 0.5}
GABLED = {"plane": "elevation", "polygon_m": [[0, 0], [6, 0], [6, 5], [3, 7], [0, 5]], "to_m": 0.5}
DOOR = {"plane": "elevation", "opening": True, "polygon_m": [[2.3, 0], [3.7, 0], [3.7, 2.6], [2.3, 2.6]], "to_m": 0.5}
TURN = 2.0 * math.pi / 16
ROSE = {
    "plane": "elevation",
    "opening": True,
    "polygon_m": [[3.0 + 0.8 * math.cos(TURN * k), 4.2 + 0.8 * math.sin(TURN * k)] for k in range(16)],
    "to_m": 0.5,
}


def section_of(corners, width):
    return {"plane": "section", "polygon_m": corners, "to_m": width}


STEPPED = [
    section_of([[0, 0], [0.6, 0], [0.6, 4], [0, 4]], 5.0),
    section_of([[0, 4], [0.45, 4], [0.45, 8], [0, 8]], 5.0),
]
WEDGES = section_of([[0.5, 0], [2.5, 6], [0.5, 6]], 0.8)
CORNER = [
    {"plane": "oblique", "angle_deg": 45.0, "polygon_m": [[0, 0], [3, 4], [0, 4]], "to_m": 0.5},
    {
        "plane": "oblique",
        "angle_deg": -45.0,
        "polygon_m": [[0.5, 2 / 3], [3, 4], [0.5, 4]],
        "from_m": -0.5,
        "to_m": 0.0,
    },
]


def wall_of(solids=(), height=6.0, thickness=0.5, length=4.0, mechanism="one_sided", **more):
    """The wall of a case with these solids."""
    table = {"name": "w", "mechanism": mechanism, "height_m": height, "thickness_m": thickness, "length_m": length}
    table |= {"unit_weight_kn_m3": 18.0, **more}
    if solids:
        table["solid"] = list(solids)
    return parse_case({"title": "t", "wall": [table]}).wall[0]


COPING = {"kind": "carried_mass", "kn_m": 0.3 * G / 4.0, "d_m": 0.25, "h_m": 6.0}
ROOF = {"kind": "carried_mass", "kn_m": 1.5 * G / 4.0, "d_m": 0.10, "h_m": 5.8}


def test_that_a_body_behind_its_base_has_no_inner_hinge():
    for wall in (wall_of([RECTANGLE, WEDGES]), wall_of(CORNER, 4.0, 0.5, 4.0)):
        assert inner_of(wall.in_si, wall.block()) is None


SHORT = [
    ({"gable_m": 2.0}, (7.0, 0.5, 6.0), [GABLED]),
    (
        {"gable_m": 2.0, "openings": [{"s_m": 2.3, "z_m": 0.0, "width_m": 1.4, "height_m": 2.6}]},
        (7.0, 0.5, 6.0),
        [GABLED, DOOR],
    ),
    ({"steps": [{"from_z_m": 4.0, "thickness_m": 0.45}]}, (8.0, 0.6, 5.0), STEPPED),
    (
        {"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0}},
        (6.0, 0.5, 4.0),
        [RECTANGLE, WEDGES],
    ),
]


@pytest.mark.parametrize(("short", "sizes", "solids"), SHORT)
def test_that_a_short_form_is_the_same_body_as_its_solids(short, sizes, solids):
    found, written = wall_of((), *sizes, **short).in_si.body, wall_of(solids, *sizes).in_si.body
    assert tuple(found) == pytest.approx(tuple(written), rel=1e-14)


def test_that_an_opening_through_a_step_is_cut_with_it():
    opening = {"s_m": 1.0, "z_m": 3.0, "width_m": 1.0, "height_m": 2.0}
    wall = wall_of((), 8.0, 0.6, 5.0, steps=[{"from_z_m": 4.0, "thickness_m": 0.45}], openings=[opening])
    lost = 18e3 / G * (1.0 * 0.6 + 1.0 * 0.45)
    whole = wall_of(STEPPED, 8.0, 0.6, 5.0).in_si.body
    assert whole.mass - wall.in_si.body.mass == pytest.approx(lost, rel=1e-12)


def test_that_a_round_opening_has_the_area_of_its_circle():
    wall = wall_of((), 7.0, 0.5, 6.0, openings=[{"s_m": 3.0, "z_m": 4.0, "diameter_m": 1.6}])
    assert wall.weight == pytest.approx(18e3 * 0.5 * (42.0 - math.pi * 0.64), rel=1e-13)


def random_polygon(random, corners):
    """A star of so many corners about a point, simple by construction."""
    angles = np.sort(random.uniform(0.0, 2.0 * np.pi, corners))
    radii = random.uniform(0.3, 1.5, corners)
    return [
        (float(a), float(b)) for a, b in zip(2.0 + radii * np.cos(angles), 2.0 + radii * np.sin(angles), strict=True)
    ]


def quadrature(polygon, ends, angle, start, density):
    """M, M x, M z, I of a solid by Gauss-Legendre over its triangles from one corner, signed, and over n."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    nodes, weights = 0.5 * (nodes + 1.0), 0.5 * weights
    first = np.array(polygon[0])
    total = np.zeros(4)
    for b, c in itertools.pairwise(polygon[1:]):
        u, v = np.array(b) - first, np.array(c) - first
        doubled = u[0] * v[1] - u[1] * v[0]
        for i, a in enumerate(nodes):
            for j, share in enumerate(nodes):
                s, z = first + a * (1.0 - share) * u + a * share * v
                for k, part in enumerate(nodes):
                    n = ends[0] + part * (ends[1] - ends[0])
                    x = start + s * math.cos(angle) + n * math.sin(angle)
                    w = density * doubled * a * weights[i] * weights[j] * weights[k] * (ends[1] - ends[0])
                    total += w * np.array([1.0, x, z, x * x + z * z])
    return total * math.copysign(1.0, total[0] * density)


@pytest.mark.shows("bodies.integrals")
@pytest.mark.parametrize("bodies", [300, pytest.param(1000, marks=pytest.mark.long)])
def test_that_random_bodies_agree_with_quadrature(bodies):
    random = np.random.default_rng(38)
    for _ in range(bodies):
        polygon = random_polygon(random, int(random.integers(3, 12)))
        ends = tuple(np.sort(random.uniform(-3.0, 3.0, 2)))
        given = (ends, random.uniform(-1.5, 1.5), random.uniform(-2.0, 2.0), random.uniform(1000.0, 2500.0))
        found = extruded(polygon, *given)
        expected = quadrature(polygon, *given)
        scale = expected[0] * np.array([1.0, 6.0, 6.0, 40.0])
        assert np.abs(np.array(found) - expected).max() <= 1e-12 * scale.max()


def test_that_a_body_cut_in_two_is_the_whole_body():
    random = np.random.default_rng(5)
    for _ in range(200):
        cut = random.uniform(0.3, 5.7)
        lower, upper = [(0, 0), (4, 0), (4, cut), (0, cut)], [(0, cut), (4, cut), (4, 6), (0, 6)]
        whole = extruded([(0, 0), (4, 0), (4, 6), (0, 6)], (0.0, 0.5), 0.5 * math.pi, 0.0, 1800.0)
        parts = sum_bodies(extruded(p, (0.0, 0.5), 0.5 * math.pi, 0.0, 1800.0) for p in (lower, upper))
        assert tuple(parts) == pytest.approx(tuple(whole), rel=1e-14)


@pytest.mark.shows("bodies.integrals")
@pytest.mark.parametrize(
    "solid",
    [
        RECTANGLE,
        section_of([[0, 0], [0.5, 0], [0.5, 6], [0, 6]], 4.0),
        {**RECTANGLE, "polygon_m": [[4, 6], [0, 6], [0, 0], [4, 0]]},
    ],
)
def test_that_a_rectangle_written_as_a_solid_is_the_rectangle_bit_for_bit(solid):
    plain, written = wall_of(mechanism="both"), wall_of([solid], mechanism="both")
    assert written.parts == ()
    for mechanism in ("one_sided", "two_sided"):
        assert make_rocking_model(plain, mechanism) == make_rocking_model(written, mechanism)


def motion(size=1500):
    t = np.arange(size) * 0.01
    random = np.random.default_rng(3)
    return 3.0 * np.sin(2.0 * np.pi * t / 0.9) * np.exp(-(((t - 5.0) / 3.0) ** 2)) + random.normal(0.0, 0.5, size)


BATTERED = section_of([[0, 0], [0.8, 0], [0.8, 5], [0.4, 5]], 1.0)
TURNED = section_of([[0, 0], [0.8, 0], [0.4, 5], [0, 5]], 1.0)


def test_that_a_body_turned_round_is_its_mirror():
    one, other = (make_rocking_model(wall_of([s], 5.0, 0.8, 1.0, "two_sided"), "two_sided") for s in (BATTERED, TURNED))
    assert one.other is not None
    numbers = [
        (m.slenderness, m.p2, m.ratio_at_rest, m.other.slenderness, m.other.p2, m.other.ratio_at_rest)
        for m in (one, other)
    ]
    assert numbers[0] == pytest.approx((*numbers[1][3:], *numbers[1][:3]), rel=1e-12)
    ground = motion()
    far = one.other
    mirrored = RockingModel(far.slenderness, far.p2, 0.0, far.ratio_at_rest, 0.0, 0.0, 0.0)._replace(
        lean=one.slenderness + one.lean - far.slenderness,
        other=OtherSide.of(one.slenderness, one.p2, one.ratio_at_rest),
    )
    first, second = integrate_history(ground, 0.01, 0.9, one), integrate_history(-ground, 0.01, 0.9, mirrored)
    assert first.outcome == second.outcome and first.impact_time.size > 10
    assert np.array_equal(first.rotation, -second.rotation)


def lumps(wall):
    """(mass, x, z, inertia about its own centroid) of each solid."""
    found = []
    for part in wall.parts:
        mass, first_x, first_z, inertia = quadrature(
            part.polygon, part.ends, part.angle, part.start, 1e3 * part.weight / G
        )
        found.append((mass, first_x / mass, first_z / mass, inertia - (first_x**2 + first_z**2) / mass))
    return found


def moment_of_lumps(theta, side, wall, loads):
    """As loaded_walls.moment, of masses at their places. wall : (lumps, width)"""
    masses, width = wall
    c, s = math.cos(theta), math.sin(theta)
    restoring = pushed = inertia = 0.0
    for mass, x, z, own in masses:
        d = x if side > 0 else width - x
        restoring += mass * G * (d * c - z * s)
        pushed += mass * (z * c + d * s)
        inertia += own + mass * (d * d + z * z)
    return restoring, pushed, inertia


@pytest.mark.shows("bodies.histories")
@pytest.mark.parametrize(
    ("wall", "scale"),
    [
        (wall_of([BATTERED], 5.0, 0.8, 1.0, "two_sided"), 0.9),
        (wall_of(STEPPED, 8.0, 0.6, 5.0, "two_sided"), 0.5),
        (wall_of([GABLED, DOOR, ROSE], 7.0, 0.5, 6.0), 0.6),
        (wall_of([RECTANGLE, WEDGES]), 0.9),
    ],
)
def test_that_histories_agree_with_a_solver_written_from_coordinates(wall, scale):
    mechanism = wall.mechanisms()[0]
    model = make_rocking_model(wall, mechanism)
    ground = scale * motion(500)
    one_sided = mechanism == "one_sided"
    ratio = (
        model.ratio_at_rest
        if one_sided or model.other is None
        else {1.0: model.ratio_at_rest, -1.0: model.other.ratio_at_rest}
    )
    rest = 1e-6 * math.sqrt(model.p2) * model.slenderness
    truth = loaded_walls.history(
        ground, 0.01, (lumps(wall), wall.thickness), (), one_sided, ratio, rest, moment=moment_of_lumps
    )
    found = integrate_history(ground, 0.01, 1.0, model)
    assert found.outcome == STABLE and found.impact_time.size >= 2
    assert np.abs(found.rotation - truth).max() <= 1e-9 * model.slenderness


@pytest.mark.shows("bodies.histories")
def test_that_many_analyses_are_single_histories():
    model = make_rocking_model(wall_of(STEPPED, 8.0, 0.6, 5.0, "two_sided"), "two_sided")
    scales = np.linspace(-1.5, 1.5, 61)
    outcomes, peaks = np.zeros(61, np.int64), np.zeros(61)
    scan_multipliers(METHODS["taylor"], motion(), 0.01, scales, model, outcomes, peaks)
    whole = [integrate_history(motion(), 0.01, float(scale), model) for scale in scales]
    assert [one.outcome for one in whole] == outcomes.tolist()
    stable = outcomes == STABLE
    assert 10 < stable.sum() < 61
    assert [one.peak for one, kept in zip(whole, stable, strict=True) if kept] == peaks[stable].tolist()


@pytest.mark.shows("bodies.histories")
def test_that_energy_is_kept_between_impacts_and_angular_momentum_across_them():
    wall = wall_of([BATTERED], 5.0, 0.8, 1.0, "two_sided")
    model, body = make_rocking_model(wall, "two_sided"), wall.in_si.body
    still = np.zeros(400)
    swing = integrate_history(still, 0.01, 1.0, model, start=(0.1, 0.0))
    outer = body.about(0.0)
    x, z = outer.centroid
    falling = int(np.argmax(swing.rotation <= 0.0)) - 1
    energy = 0.5 * outer.inertia_over_mass * swing.velocity[:falling] ** 2 + G * (
        x * np.sin(swing.rotation[:falling]) + z * np.cos(swing.rotation[:falling])
    )
    assert np.abs(energy / energy[0] - 1.0).max() < 1e-13
    # about the new hinge: I_G w + M (r x v) before, I_O' w' after
    before = -math.sqrt(2.0 * (energy[0] - G * z) / outer.inertia_over_mass)
    own = outer.inertia_over_mass - outer.radius**2
    momentum = own * before + (z * z - x * (0.8 - x)) * before
    inner = own + (0.8 - x) ** 2 + z * z
    assert swing.impact_velocity[0] == pytest.approx(momentum / inner, rel=1e-9)


PORTAL = {"s_m": 0.5, "z_m": 3.0, "width_m": 2.0, "height_m": 2.9}
NOTCHED = {**RECTANGLE, "polygon_m": [[0, 0], [4, 0], [4, 6], [3, 6], [3, 3], [1, 3], [1, 6], [0, 6]]}

SHORT_WEDGES = {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0}
LOW = {**RECTANGLE, "polygon_m": [[0, 0], [4, 0], [4, 3], [0, 3]]}
PIER = {**RECTANGLE, "polygon_m": [[0, 0], [1, 0], [1, 6], [0, 6]]}
LEAN_TO = {**RECTANGLE, "from_m": 0.5, "to_m": 0.8}
LEAVES = [{**RECTANGLE, "to_m": 0.25}, {**RECTANGLE, "from_m": 0.25, "unit_weight_kn_m3": 17.0}]
PORTALLED = {**RECTANGLE, "polygon_m": [[0, 0], [1, 0], [1, 3], [3, 3], [3, 0], [4, 0], [4, 6], [0, 6]]}
BUTTRESSED = [RECTANGLE, section_of([[0.5, 0], [1.5, 0], [0.5, 6]], 0.8)]


@pytest.mark.parametrize(
    ("solids", "length"), [(LEAVES, 4.0), ([PORTALLED], 2.0), (STEPPED, 5.0), (BUTTRESSED, 4.0), ([GABLED, DOOR], 4.6)]
)
def test_that_the_base_is_the_area_of_its_section_over_the_thickness(solids, length):
    whole = max(max(s for s, _ in solid["polygon_m"]) for solid in solids)
    sizes = (8.0, 0.6, 5.0) if solids is STEPPED else (7.0, 0.5, 6.0) if whole == 6 else (6.0, 0.5, 4.0)
    wall = wall_of(solids, *sizes, compressive_strength_mpa=2.0)
    assert base_length(wall.parts, wall.length_m, wall.thickness) == pytest.approx(length, rel=1e-12)
    assert wall.setback == pytest.approx(2.0 * wall.weight / (3.0 * 2e6 * length), rel=1e-12)


REFUSED = [
    ("polygon_crosses", [{**RECTANGLE, "polygon_m": [[0, 0], [4, 6], [4, 0], [0, 6]]}], {}),
    ("opening_outside", [RECTANGLE, {**DOOR, "polygon_m": [[3, 1], [5, 1], [5, 2], [3, 2]]}], {}),
    ("opening_outside", [RECTANGLE, {**DOOR, "to_m": 0.7}], {}),
    ("body_falls", [{**RECTANGLE, "from_m": -1.0, "to_m": 0.2}], {"thickness": 0.2}),
    ("body_leans_back", [RECTANGLE, WEDGES], {"mechanism": "two_sided"}),
    ("solid_ends", [{**RECTANGLE, "to_m": 0.0}], {}),
    ("solid_below", [{**RECTANGLE, "polygon_m": [[0, -1], [4, 0], [4, 6], [0, 6]]}], {}),
    ("solid_angle", [{**RECTANGLE, "angle_deg": 45.0}], {}),
    ("solid_angle", [{**RECTANGLE, "plane": "oblique"}], {}),
    ("solids_overlap", [RECTANGLE, {**RECTANGLE, "from_m": 0.2}], {}),
    ("contact_outside", [RECTANGLE, {**WEDGES}], {"height": 6.5}),
    ("contact_outside", [RECTANGLE, {**WEDGES}], {"height": 2.5}),
    ("hinge_off_body", [{**RECTANGLE, "from_m": 0.2, "to_m": 0.7}], {}),
    ("hinge_off_body", [{**RECTANGLE, "polygon_m": [[0, 1], [4, 1], [4, 6], [0, 6]]}], {}),
    ("base_beyond_body", [RECTANGLE, WEDGES], {"thickness": 0.8}),
    ("length_beyond_body", [GABLED], {"height": 7.0, "length": 8.0}),
    ("nothing_at_base", [RECTANGLE, {**DOOR, "polygon_m": [[0, 0], [4, 0], [4, 2], [0, 2]]}], {}),
    ("openings_overlap", [], {"openings": [PORTAL, {**PORTAL, "s_m": 1.5}]}),
    ("openings_overlap", [], {"openings": [PORTAL, PORTAL]}),
    ("opening_outside", [NOTCHED, {**DOOR, "polygon_m": [[1, 3], [3, 3], [3, 6], [1, 6]]}], {}),
    ("opening_outside", [NOTCHED, {**DOOR, "polygon_m": [[1, 2], [3, 2], [3, 6], [1, 6]]}], {}),
    ("solids_overlap", [GABLED, {**GABLED, "polygon_m": [[0, 5], [6, 5], [3, 12]]}], {"height": 7.0, "length": 6.0}),
    ("base_beyond_body", CORNER, {"height": 4.0, "thickness": 3.0}),
    ("length_beyond_body", CORNER, {"height": 4.0, "length": 200.0}),
    ("solid_angle_right", [{**RECTANGLE, "plane": "oblique", "angle_deg": 89.9}], {"thickness": 2.0}),
    ("solid_angle_right", [{**RECTANGLE, "plane": "oblique", "angle_deg": -0.5}], {}),
    ("length_of_loads", [GABLED], {"height": 7.0, "length": 1.0, "load": [COPING]}),
    ("planes_overlap", [RECTANGLE, section_of([[0.49, 0], [2.5, 6], [0.49, 6]], 0.8)], {}),
    ("step_thicker", [], {"steps": [{"from_z_m": 3.0, "thickness_m": 0.8}]}),
    ("wedges_too_long", [], {"return_wedges": {"number": 9, "thickness_m": 0.5, "length_at_top_m": 2.0}}),
    ("crack_too_flat", [], {"return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 7.0}}),
    ("wedges_off_step", [], {"return_wedges": SHORT_WEDGES, "steps": [{"from_z_m": 3.0, "thickness_m": 0.3}]}),
    ("body_in_pieces", [RECTANGLE, section_of([[0.6, 0], [2.5, 6], [0.6, 6]], 0.8)], {}),
    ("body_cut_through", [LOW, {**RECTANGLE, "polygon_m": [[0, 4], [4, 4], [4, 6], [0, 6]]}], {}),
    ("body_cut_through", [RECTANGLE, {**DOOR, "polygon_m": [[0, 2], [4, 2], [4, 3], [0, 3]]}], {}),
    ("body_cut_through", [], {"openings": [{"s_m": 0.0, "z_m": 2.0, "width_m": 4.0, "height_m": 1.0}]}),
    ("foot_alone", [section_of([[0, 0], [0.5, 0], [0.5, 6], [0.3, 6], [0.3, 0.1], [0, 0.1]], 4.0)], {}),
    ("foot_short", [PIER, {**RECTANGLE, "polygon_m": [[1, 0], [4, 0], [4, 6], [1, 6]], "from_m": 0.2}], {}),
    ("setback_too_large", [RECTANGLE, LEAN_TO], {"hinge_setback_m": 0.45}),
    ("solids_or_short", [RECTANGLE], {"gable_m": 1.0}),
    ("gable_too_high", [], {"gable_m": 7.0}),
    ("steps_not_rising", [], {"steps": [{"from_z_m": 4.0, "thickness_m": 0.4}, {"from_z_m": 3.0, "thickness_m": 0.3}]}),
    ("opening_shape", [], {"openings": [{"s_m": 1.0, "z_m": 1.0, "width_m": 1.0}]}),
    ("two_sided_loads_rigid", STEPPED, {"height": 8.0, "thickness": 0.6, "mechanism": "two_sided", "law": "doherty"}),
]  # fmt: skip


@pytest.mark.shows("bodies.refused")
@pytest.mark.parametrize(("code", "solids", "changes"), REFUSED)
def test_that_a_body_that_is_none_is_refused_in_a_sentence(code, solids, changes):
    with pytest.raises(InputError) as refused:
        wall_of(solids, **changes)
    assert refused.value.code == code


def study_of(*walls, **sections):
    """A study of these walls with two generated motions."""
    demand = {"ag_g": 0.15, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
    case = {
        "wall": list(walls),
        "demand": demand,
        "generate": {"scatter": 0.0, "count": 2},
        "analysis": {"q_step": 0.05},
    }
    return run(parse_case(case | sections), base_dir=ROOT)


STEPPED_WALL = {
    "name": "stepped",
    "mechanism": "one_sided",
    "height_m": 8.0,
    "thickness_m": 0.6,
    "length_m": 5.0,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 0.0,
    "steps": [{"from_z_m": 4.0, "thickness_m": 0.45}],
}
PLAIN_WALL = {key: value for key, value in STEPPED_WALL.items() if key != "steps"}


@pytest.mark.shows("bodies.above")
def test_that_the_part_above_a_hinge_is_the_body_cut_there():
    found = study_of({**STEPPED_WALL, "hinge_heights": [2.0, 4.0]})
    whole, low, high = found.walls
    assert [wall.part.hinge for wall in found.walls] == [0.0, 2.0, 4.0]
    # above the step a rectangle of 4 x 0.45 m is left, with what rests on it
    assert high.wall.thickness == 0.45 and high.wall.in_si.body is None
    assert high.block.is_rectangle and high.wall.weight == pytest.approx(18e3 * 4.0 * 0.45 * 5.0, rel=1e-12)
    rest = extruded([(0, 0), (0.6, 0), (0.6, 2), (0, 2)], (0.0, 5.0), 0.0, 0.0, 18e3 / G)
    top = extruded([(0, 2), (0.45, 2), (0.45, 6), (0, 6)], (0.0, 5.0), 0.0, 0.0, 18e3 / G)
    assert tuple(low.wall.in_si.body) == pytest.approx(tuple(sum_bodies((rest, top))), rel=1e-13)
    assert whole.q_set and low.q_set and high.q_set


def test_that_wedges_begin_at_the_hinge_with_the_same_crack():
    wedges = {"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0, "from_z_m": 1.0}
    changes = {"return_wedges": wedges, "hinge_heights": [0.5, 3.0], "height_m": 5.0}
    base, low, high = study_of(PLAIN_WALL | changes).walls
    assert base.wall.return_wedges.length_at_top_m == 2.0 and low.wall.return_wedges is None
    assert low.wall.solid[-1].polygon_m == ((0.6, 0.5), (2.6, 4.5), (0.6, 4.5))
    assert high.wall.solid[-1].polygon_m == ((0.6, 0.0), (1.6, 2.0), (0.6, 2.0))
    # below a gable the wedge ends at the eaves
    _, part = study_of(PLAIN_WALL | {**changes, "gable_m": 1.5, "hinge_heights": [1.5]}).walls
    assert part.wall.solid[-1].polygon_m[1] == pytest.approx((0.6 + 2.0 * 2.0 / 2.5, 2.0))


def test_that_a_rectangle_written_as_a_solid_is_cut_above_a_hinge_like_the_rectangle():
    solid = {"plane": "section", "polygon_m": [[0, 0], [0.6, 0], [0.6, 8], [0, 8]], "to_m": 5.0}
    plain, written = (
        study_of(PLAIN_WALL | {"hinge_heights": [3.0], **more}).walls[1] for more in ({}, {"solid": [solid]})
    )
    assert written.wall.solid == () and written.model == plain.model


def test_that_loads_keep_their_place_above_a_step():
    """From the face of the wall there: d 0.65 from the outer face of the base is 0.25 in a wall from 0.4 to 0.9."""
    steps = [{"from_z_m": 4.0, "thickness_m": 0.5, "flush": "inner"}]
    load = {"kind": "vertical", "kn_m": 20.0, "d_m": 0.65, "h_m": 7.5, "mass": "none"}
    changes = {"thickness_m": 0.9, "steps": steps, "hinge_heights": [4.0]}
    _, part = study_of(PLAIN_WALL | changes | {"load": [load]}).walls
    assert part.wall.load[0].d_m == pytest.approx(0.25) and part.wall.load[0].h_m == 3.5
    for d in (0.30, 0.95):
        with pytest.raises(InputError) as refused:
            study_of(PLAIN_WALL | changes | {"load": [{**load, "d_m": d}]})
        assert refused.value.code in ("load_off_body", "load_outside")


def test_that_a_thin_storey_and_the_eaves_are_hinges_of_their_own():
    steps = [{"from_z_m": 3.0, "thickness_m": 0.75}, {"from_z_m": 6.0, "thickness_m": 0.25}]
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    found = study_of(PLAIN_WALL | {"thickness_m": 0.9, "steps": steps}, building=building).walls
    assert [wall.part.hinge for wall in found] == [0.0, 3.0, 6.0]
    gabled = study_of(PLAIN_WALL | {"gable_m": 3.0}, building=building).walls
    assert 5.0 in [wall.part.hinge for wall in gabled]


def test_that_a_stepped_wall_that_rocks_both_ways_has_q_by_the_exact_method_alone():
    found = study_of({**STEPPED_WALL, "mechanism": "two_sided"})
    (wall,) = found.walls
    assert wall.model.other is not None and wall.q_set > 1.0 and not wall.wall.has_closed_forms
    for change, code in (({"method": "rk4"}, "unlike_method"), ({"accuracy": True}, "unlike_accuracy")):
        with pytest.raises(InputError) as refused:
            study_of({**STEPPED_WALL, "mechanism": "two_sided"}, analysis=change)
        assert refused.value.code == code


@pytest.mark.shows("bodies.checks")
def test_that_the_checks_are_those_of_the_whole_body():
    """alpha_0, e*, M*, d_0 by hand: one body, W x_G / (W z_G) and the displacement of its centroid."""
    (wall,) = study_of(STEPPED_WALL | {"hinge_heights": "base"}).walls
    kinematic, (x, z) = wall.assessment.kinematic, wall.wall.in_si.body.centroid
    assert kinematic.alpha0 == pytest.approx(x / z, rel=1e-13) and kinematic.e_star == 1.0
    assert kinematic.d0 == pytest.approx(x, rel=1e-13)
    assert kinematic.m_star == pytest.approx(38545.3 / 5.0, rel=1e-6)


@pytest.mark.shows("lifts.bodies")
def test_that_wedges_and_a_low_restraint_are_shown_with_zeta_without_them():
    wedges = {"number": 2, "thickness_m": 0.6, "length_at_top_m": 2.0}
    wedged = study_of({**PLAIN_WALL, "return_wedges": wedges, "hinge_heights": "base"})
    (bare,) = study_of({**PLAIN_WALL, "hinge_heights": "base"}).walls
    # of histories it is searched on a coarser grid
    row = looked_at(wedged)["lift_return_wedges"]
    found = {check.name: check.zeta for check in bare.assessment.checks}
    assert row.zeta == pytest.approx(found[row.check or bare.assessment.verdict.governing], rel=0.05)
    gabled = {**PLAIN_WALL, "length_m": 6.0, "thickness_m": 0.5, "hinge_heights": "base"}
    low = study_of({**gabled, "height_m": 5.0, "solid": [GABLED]})
    (high,) = study_of({**gabled, "height_m": 7.0, "solid": [GABLED]}).walls
    assert looked_at(low)["lift_contact"].zeta == pytest.approx(high.assessment.verdict.zeta_e, rel=0.05)


def test_that_what_lies_beyond_the_base_is_left_out_also_of_one_polygon_and_with_its_openings():
    kept = clipped(wall_of([section_of([[0, 0], [0.5, 0], [2.5, 6], [0, 6]], 4.0)]).parts[0], 0.5)
    assert kept.body.mass == pytest.approx(18e3 / G * 0.5 * 6.0 * 4.0, rel=1e-12)
    behind = {**RECTANGLE, "from_m": 0.5, "to_m": 1.0}
    opening = {**DOOR, "from_m": 0.5, "to_m": 1.0}
    wall = wall_of([RECTANGLE, behind, opening])
    assert [clipped(part, 0.5) is not None for part in wall.parts] == [True, False, False]


@pytest.mark.shows("paper.eq_6")
def test_that_a_body_whose_eq_6_exceeds_1_loses_nothing_and_says_so_and_that_it_leans_inward():
    heavy = section_of([[0.5, 0], [1.5, 6], [0.5, 6]], 3.9)
    table = {**PLAIN_WALL, "height_m": 3.0, "thickness_m": 0.5, "length_m": 4.0, "hinge_heights": "base"}
    table |= {"solid": [RECTANGLE, {**heavy, "unit_weight_kn_m3": 36.0}]}
    (free,) = study_of(table).walls
    assert free.restitution.ratio_at_rest == 1.0 and "eq6_above_one" in {warning.code for warning in free.warnings}
    (one,) = study_of(table | {"velocity_ratio": 1.0}).walls
    assert one.assessment.verdict.zeta_e == free.assessment.verdict.zeta_e
    result = study_of(table | {"velocity_ratio": 0.8})
    (less,) = result.walls
    assert "leans_inward" in {limit.code for limit in less.assessment.verdict.limits}
    assert "lift_velocity_ratio" in looked_at(result) and "odd_weight" in {warning.code for warning in less.warnings}


@pytest.mark.parametrize("seed", [*range(10), *(pytest.param(k, marks=pytest.mark.long) for k in range(10, 20))])
def test_that_no_corner_is_refused_for_its_velocity_ratio(seed):
    """Two walls dragged along cracks, of random sizes (MECHANISMS 8)."""
    rng = np.random.default_rng(seed)
    high, t1, t2 = rng.uniform(3.0, 9.0), rng.uniform(0.4, 0.9), rng.uniform(0.4, 0.9)
    l1, l2 = rng.uniform(1.2, 0.5 * high + 1.0, 2).tolist()
    phi = math.degrees(math.atan2(l2, l1)) if seed % 2 else 45.0
    first = {"plane": "oblique", "angle_deg": phi, "to_m": t1, "polygon_m": [[0, 0], [l1, high], [0, high]]}
    polygon = [[t1, high * t1 / l2], [l2, high], [t1, high]]
    second = {"plane": "oblique", "angle_deg": phi - 90.0, "from_m": -t2, "to_m": 0.0, "polygon_m": polygon}
    wall = wall_of([first, second], high, min(t1, t2), 1.0)
    assert 0.0 < wall.restitution_of("one_sided").ratio_at_rest <= 1.0


def test_that_the_period_of_a_body_is_that_of_its_rectangle_where_it_is_nearly_one():
    """Rayleigh's quotient over the mass of the body, against a beam of 400 elements with the mass of each slice."""
    wall = wall_of(STEPPED, 8.0, 0.6, 5.0, elastic_modulus_mpa=1000.0)
    rectangle = wall_of((), 8.0, 0.6, 5.0, elastic_modulus_mpa=1000.0)
    whole = wall_of(
        [section_of([[0, 0], [0.6, 0], [0.6, 8], [0, 8.0001]], 5.0)], 8.0, 0.6, 5.0, elastic_modulus_mpa=1000.0
    )
    assert elastic_period(whole.in_si) == pytest.approx(elastic_period(rectangle.in_si), rel=1e-4)
    # flexibility of a cantilever of constant section, masses of the slices
    n, z = 200, (np.arange(200) + 0.5) * 8.0 / 200
    mass = 18e3 / G * 8.0 / n * np.where(z < 4.0, 0.6, 0.45)
    low, high = np.minimum.outer(z, z), np.maximum.outer(z, z)
    flexibility = low**2 * (3.0 * high - low) / (6.0 * 1e9 * 0.6**3 / 12.0)
    largest = np.linalg.eigvals(flexibility * mass[None, :]).real.max()
    assert elastic_period(wall.in_si) == pytest.approx(2.0 * np.pi * math.sqrt(largest), rel=0.01)
    assert elastic_period(wall.in_si) < elastic_period(rectangle.in_si)


def test_that_the_outlines_are_those_of_the_solids():
    wall = wall_of([GABLED, DOOR, ROSE], 7.0, 0.5, 6.0)
    assert [one.kind for one in elevation_outlines(wall)] == ["solid", "opening", "opening"]
    assert elevation_outlines(wall)[0].points == [tuple(map(float, corner)) for corner in GABLED["polygon_m"]]
    assert sorted(section_outlines(wall)[0].points) == [(0.0, 0.0), (0.0, 7.0), (0.5, 0.0), (0.5, 7.0)]
    wedges = wall_of((), return_wedges={"number": 2, "thickness_m": 0.4, "length_at_top_m": 2.0})
    assert section_outlines(wedges)[1] == ([(0.5, 0.0), (2.5, 6.0), (0.5, 6.0)], "wedge")


@pytest.mark.parametrize("hinge", [0.0, 0.05, 0.12])
def test_that_a_block_about_a_hinge_is_that_of_its_rectangle(hinge):
    """A rectangle of 0.6 x 4 m about a line inside its edge: angle, radius and inertia by hand."""
    corners = ((0.0, 0.0), (0.6, 0.0), (0.6, 4.0), (0.0, 4.0))
    sums = polygon_sums(corners)
    body = Body(sums.area, sums.s, sums.z, sums.ss + sums.zz)
    block = body.about(hinge)
    lever = 0.3 - hinge
    assert block.slenderness == pytest.approx(math.atan2(lever, 2.0), rel=1e-14)
    assert block.radius == pytest.approx(math.hypot(lever, 2.0), rel=1e-14)
    own = (0.6**2 + 4.0**2) / 12.0  # about the centroid, over the mass
    assert block.inertia_over_mass == pytest.approx(own + lever**2 + 4.0, rel=1e-13)
