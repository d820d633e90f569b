"""What a case gives that raises zeta: which rows are asked about, and the wall at their other ends."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from core.case.schema import Generate
from core.setting import demand_input
from core.variation.evaluate import evaluate
from core.variation.favourable_wall_inputs import favourable_inputs
from tests.core.variation.one_evaluation import BARE, MOTION, NTC, SOIL, WALL, history, scene_of, with_histories
from tests.holds import BOUND, carries, shown

SPECTRUM = {"ag_g": 0.05, "spectrum": NTC}
PARAPET = {"name": "p", "height_m": 1.2, "thickness_m": 0.25, "mechanism": "two_sided", "base_z_m": 0.0}
PARAPET |= {"unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 1000.0, "unloaded_confirmed": True}
TWO_SIDED = {"mechanism": "two_sided", "hold": None}
WEIGHT = {"kind": "vertical", "kn_m": 1.0, "d_m": 0.2, "h_m": 4.0, "mass": "none"}


def without_none(table):
    return {key: value for key, value in table.items() if value is not None}


def rows_of(wall=WALL, demand=SOIL, zeta=None, ground=(MOTION,), scene=None, **values):
    """(code of its words -> row, the scene) of a wall; zeta : of its histories, which it has where one is given"""
    scene = scene or scene_of(without_none(wall), demand)
    if zeta is not None:
        scene = with_histories(scene, lambda *_: history(zeta, **values), ground)
    found = evaluate(scene)
    return {row.code: row for row in favourable_inputs(found)}, found.scene


def wall_at(row, scene, k=0):
    return row.ends[k].change(scene).wall


def values(row, zetas, demand=SOIL):
    return dict(row.phrase(zetas, evaluate(scene_of(demand=demand)).checks[0]).values)


# the impact


@pytest.mark.parametrize("given, more", [(0.3, 0.4), (0.0, 0.1), (0.95, 1.0)])
def test_that_a_given_velocity_ratio_is_shown_with_a_tenth_more_and_by_theory(given, more):
    """Eq. 6 of a wall of 0.4 x 4.0 m, hinge at its edge: 1 - 3/2 sin^2(alpha), then reduced: less than 1."""
    rows, scene = rows_of(WALL | {"velocity_ratio": given}, zeta=1.2)
    row = rows["lift_velocity_ratio"]
    theory = scene_of().wall.restitution_of("one_sided").ratio_at_rest
    assert (row.key, row.value) == ("velocity_ratio", given)
    assert [end.value for end in row.ends] == pytest.approx([more, theory])
    assert [wall_at(row, scene, k).velocity_ratio for k in (0, 1)] == [pytest.approx(more), None]
    said = values(row, [1.1, 0.9])
    assert (said["e"], said["zeta_more"].value, said["zeta_theory"].value) == (given, 1.1, 0.9)
    assert (said["more"], said["theory"]) == pytest.approx((more, theory))


def test_that_a_model_of_tests_is_shown_by_theory_and_one_by_theory_or_without_histories_has_no_row():
    rows, scene = rows_of(WALL | {"restitution": "one_sided_experimental"}, zeta=1.2)
    assert rows["lift_velocity_ratio"].key == "restitution"
    assert [wall_at(rows["lift_velocity_ratio"], scene, k).restitution for k in (0, 1)] == [None, None]
    assert "lift_velocity_ratio" not in rows_of(zeta=1.2)[0]
    assert "lift_velocity_ratio" not in rows_of(WALL | {"velocity_ratio": 0.3})[0]


# ties


def test_that_a_bar_that_breaks_is_left_out_of_the_clauses_alone_where_histories_are_made():
    """They follow its breaking; at 4 m and the rotation the clauses count on it stretches by 8 cm."""
    tie = {"kind": "tie", "out_kn_m": 1.0, "h_m": 4.0, "bar_length_m": 6.0, "elongation_m": 0.02}
    tied = carries(tie, **BARE)
    assert not rows_of(tied, zeta=1.2)[0]["lift_brittle"].histories
    assert rows_of(tied)[0]["lift_brittle"].histories


# what is required


@pytest.mark.parametrize("fc, said", [(1.34, True), (1.35, False)])
def test_that_a_confidence_factor_below_1_35_is_shown_with_it(fc, said):
    demand = SOIL | {"confidence_factor": fc}
    if said:
        demand |= {"knowledge_level": "LC2", "evidence": shown(confidence_factor="flat jacks, report 3/2024")}
    strong = WALL | {"hinge_setback_m": None, "compressive_strength_mpa": 4.0}
    rows, scene = rows_of(strong, demand)
    assert ("lift_confidence_factor" in rows) == said
    if said:
        row = rows["lift_confidence_factor"]
        assert row.ends[0].change(scene).demand.confidence_factor == 1.35
        told = values(row, [0.9])
        assert (told["fc"], told["level"]) == (fc, "LC2") and "flat jacks" in row.reason.text("en")


@pytest.mark.parametrize(
    "q, state, said", [(2.1, "SLV", True), (2.0, "SLV", False), (5.0, "SLD", False), (5.0, "SLC", False)]
)
def test_that_a_q_above_2_is_shown_with_2_where_a_check_takes_it(q, state, said):
    demand = {"ag_g": 0.05, "spectrum": NTC, "q_code": q, "limit_state": state}
    rows, scene = rows_of(demand=demand)
    assert ("lift_q_code" in rows) == said
    if said:
        row = rows["lift_q_code"]
        assert (row.key, row.value, row.ends[0].value, row.histories) == ("q_code", q, 2.0, False)
        assert row.ends[0].change(scene).demand.q_code == 2.0 and values(row, [0.9])["q"] == q


def test_that_return_walls_are_shown_without_their_friction_where_a_linear_check_counts_it():
    across = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
    wall = WALL | {"return_walls": across, "length_m": 5.0}
    rows, scene = rows_of(wall)
    assert not rows["lift_return_walls"].histories and wall_at(rows["lift_return_walls"], scene).return_walls is None
    assert "lift_return_walls" not in rows_of()[0]
    assert "lift_return_walls" not in rows_of(wall, SPECTRUM | {"limit_state": "SLC"})[0]


# generated sets


@pytest.fixture
def usual(monkeypatch):
    """The set by default is one of ten motions of seed 1, whose scatter is 0.65."""
    monkeypatch.setattr(demand_input, "DEFAULT_SET", Generate(count=10, seed=1, scatter=0.65))


def generated(count=10, seed=1, scatter=0.65):
    return tuple(
        replace(MOTION, format="generated", details=(("seed", str(seed + k)), ("scatter", f"{scatter:g}")))
        for k in range(count)
    )


def set_rows(zeta=1.2, demand=SOIL, by_default=False, ground=None, **asked):
    ground = ground or generated(**asked)
    scene = replace(scene_of(demand=demand), by_default=by_default)
    rows, _ = rows_of(scene=scene, zeta=zeta, ground=ground, passed=zeta >= 1.0)
    return {row.key: row for row in rows.values() if row.key == "scatter"}


def asked_at(row):
    """The set at the other end of a row."""
    return row.ends[0].change(SimpleNamespace(regenerate_motions=lambda asked: asked))


@pytest.mark.shows("lifts.motions")
def test_that_a_set_that_scatters_less_than_nature_is_shown_with_its_scatter(usual):
    row = set_rows(scatter=0.64)["scatter"]
    assert (row.value, row.ends[0].value, asked_at(row)) == (0.64, 0.65, Generate(10, 1, 0.65))
    assert not set_rows(scatter=0.65) and not set_rows(scatter=0.7)


def test_that_the_set_of_a_wall_that_fails_or_is_there_by_default_has_no_rows(usual):
    odd = {"count": 5, "seed": 4, "scatter": 0.1}
    assert set_rows(**odd).keys() == {"scatter"} and not set_rows(count=5, seed=4)
    assert not set_rows(zeta=0.9, **odd) and not set_rows(by_default=True, **odd)


@pytest.mark.shows("lifts.motions")
@pytest.mark.parametrize("spread, n, said", [(0.31, 3, True), (0.33, 3, False), (0.31, 2, False)])
def test_that_given_records_that_scatter_less_than_half_as_much_as_natural_ones_are_shown_with_a_set(
    usual, spread, n, said
):
    """Half of 0.65, the standard deviation of ln S_a with n - 1, its mean over the periods."""
    row = spread * np.array([-1.0, 0.0, 1.0] if n == 3 else [-(0.5**0.5), 0.5**0.5])
    spectra = np.exp(np.outer(row, [1.0, 0.5, 1.5]))
    scene = replace(
        scene_of(), compliance=SimpleNamespace(spectra=spectra, stations=n, compatible=True, narrow=False, longest=0.0)
    )
    rows, _ = rows_of(scene=scene, zeta=1.2, ground=(MOTION,) * n)
    assert ("lift_alike" in rows) == said
    if said:
        row = rows["lift_alike"]
        assert row.key == "scatter" and row.value == pytest.approx(spread) and row.ends[0].value == 0.65
        assert asked_at(row) == Generate(10, 1, 0.65)
        assert values(row, [0.9])["usual"] == 0.65
    assert "lift_alike" not in rows_of(zeta=1.2)[0]


# free to vibrate, the law, the branch


def test_that_a_trilinear_law_is_shown_rigid():
    for law, named in (("doherty", "doherty"), ({"elastic_limit": 0.05, "plateau_end": 0.25}, "D1 0.05, D2 0.25")):
        rows, scene = rows_of(WALL | {"law": law}, zeta=1.2)
        assert rows["lift_law"].value == named and wall_at(rows["lift_law"], scene).law == "rigid"
        assert "lift_law" not in rows_of(WALL | {"law": law})[0]
    assert "lift_law" not in rows_of(WALL | {"law": "rigid"}, zeta=1.2)[0]


def test_that_a_rigid_law_of_a_free_element_that_passes_is_shown_with_its_branch():
    rigid = PARAPET | {"law": "rigid"}
    rows, scene = rows_of(rigid, zeta=1.2)
    assert wall_at(rows["lift_rigid"], scene).law == "elastic" and rows["lift_rigid"].value.code == "choice_rigid"
    for wall, zeta in ((rigid, 0.9), (PARAPET, 1.2), (WALL | {"law": "rigid"}, 1.2)):
        assert "lift_rigid" not in rows_of(wall, zeta=zeta, passed=zeta > 1.0)[0]
    tie = {"kind": "tie", "out_kn_m": 0.5, "h_m": 4.0, "bar_length_m": 6.0}
    tied = carries(tie | {"h_m": 1.0}, **PARAPET | {"law": "rigid"})
    assert "lift_rigid" not in rows_of(tied, zeta=1.2)[0]


# the edge and the masonry

AT_EDGE = {key: value for key, value in WALL.items() if key != "hinge_setback_m"}


@pytest.mark.shows("lifts.hinge")
@pytest.mark.parametrize(
    "given, weight, end",
    [
        (None, 18.0, 2.0 * 28.8e3 / 3e6),
        (0.0191, 18.0, 2.0 * 28.8e3 / 3e6),
        (0.0192, 18.0, None),
        (0.02, 18.0, None),
        (None, None, 2.0 * 1.6 * 22e3 / 3e6),
    ],
)
def test_that_a_hinge_nearer_to_the_edge_than_the_weakest_masonry_lets_it_is_shown_there(given, weight, end):
    """u = 2 N / (3 f), f = 1 MPa; N = 1.6 m2 of 18 kN/m3, of 22 kN/m3 where no weight is given."""
    rows, scene = rows_of(AT_EDGE | {"hinge_setback_m": given, "unit_weight_kn_m3": weight})
    assert ("lift_edge" in rows) == (end is not None)
    if end:
        row = rows["lift_edge"]
        assert row.ends[0].value == wall_at(row, scene).hinge_setback_m == pytest.approx(end)
        assert (row.key, row.value, row.permitted) == ("hinge_setback_m", given or 0.0, True)
        assert row.source == ("given" if given else "default")
        said = values(row, [0.9])
        assert (said["given"], said["cm"], said["f"]) == pytest.approx((100.0 * (given or 0.0), 100.0 * end, 1.0))


@pytest.mark.shows("lifts.hinge")
def test_that_a_hinge_is_at_least_a_centimetre_inside_the_edge_of_any_masonry():
    low = AT_EDGE | {"height_m": 1.0}
    rows, scene = rows_of(low)
    assert wall_at(rows["lift_edge"], scene).hinge_setback_m == 0.01
    assert "lift_edge" not in rows_of(low | {"hinge_setback_m": 0.01})[0]


@pytest.mark.parametrize(
    "f, masonry, least", [(4.0, None, 1.0), (4.0, "solid_brick", 2.6), (1.0, None, None), (2.6, "solid_brick", None)]
)
def test_that_a_strength_above_the_lowest_of_its_masonry_is_shown_with_that(f, masonry, least):
    """u = 2 x 28.8 / (3 f): 19.2 mm at 1 MPa, of solid brick 7.4 mm, and 10 mm at least."""
    rows, scene = rows_of(AT_EDGE | {"compressive_strength_mpa": f, "masonry": masonry})
    assert ("lift_strength" in rows) == (least is not None)
    if least:
        row = rows["lift_strength"]
        setback = max(0.01, 2.0 * 28.8e3 / (3e6 * least))
        assert (row.value, row.ends[0].value) == (f, least)
        assert wall_at(row, scene).setback == pytest.approx(setback)
        said = values(row, [0.9])
        assert (said["given"], said["f"]) == (f, least) and said["cm"] == pytest.approx(100.0 * setback)
    assert "lift_edge" not in rows


def test_that_a_strength_that_was_tested_has_the_tests_for_its_reason():
    tested = SOIL | {
        "confidence_factor": 1.2,
        "knowledge_level": "LC2",
        "evidence": shown(confidence_factor="flat jacks, report 3/2024"),
    }
    wall = AT_EDGE | {"compressive_strength_mpa": 4.0}
    assert rows_of(wall, tested)[0]["lift_strength"].reason.text("en") == "by a study: flat jacks, report 3/2024"
    assert rows_of(wall)[0]["lift_strength"].reason == ""
    own = wall | {"evidence": shown(compressive_strength_mpa="cores of 2019, report 7")}
    for demand in (tested, SOIL):
        assert rows_of(own, demand)[0]["lift_strength"].reason.text("en") == "by a study: cores of 2019, report 7"


GENERAL = {"name": "g", "mechanism": "one_sided", "base_z_m": 0.0, "hold": [{"kind": "cross_walls"}]}
GENERAL |= {"radius_m": 2.0, "slenderness_deg": 5.0, "inertia_over_mass_m2": 16.0 / 3.0, "unit_weight_kn_m3": 18.0}
GENERAL |= {"unloaded_confirmed": True}


def test_that_a_body_by_its_radius_turns_about_a_point_farther_inside():
    """t H = 2 R^2 sin 2 alpha = 1.389 m2; u = 2 x 25.0 / 3 mm; its centroid stays, I_0 moves by Steiner."""
    rows, scene = rows_of(GENERAL, SPECTRUM)
    row = rows["lift_edge_of_body"]
    alpha = math.radians(5.0)
    setback = 2.0 * 18e3 * 2.0 * 4.0 * math.sin(2.0 * alpha) / 3e6
    x, z = 2.0 * math.sin(alpha) - setback, 2.0 * math.cos(alpha)
    there = wall_at(row, scene)
    assert row.ends[0].value == pytest.approx(setback) and row.key == "hinge_setback_m"
    assert there.radius_m == pytest.approx(math.hypot(x, z))
    assert there.slenderness_deg == pytest.approx(math.degrees(math.atan2(x, z)))
    assert there.inertia_over_mass_m2 == pytest.approx(16.0 / 3.0 - 4.0 + x**2 + z**2)
    slender = scene.replace_parts(wall=replace(scene.wall, slenderness_deg=1.0))
    assert wall_at(row, slender) == slender.wall  # whatever has moved it farther


# the body


@pytest.mark.shows("lifts.weights")
@pytest.mark.parametrize("over, said", [(1.001, True), (1.0, False), (0.9, False)])
def test_that_a_moment_of_inertia_above_that_of_a_rectangle_is_shown_with_it(over, said):
    rows, scene = rows_of(GENERAL | {"inertia_over_mass_m2": over * 16.0 / 3.0}, SPECTRUM)
    assert ("lift_inertia" in rows) == said
    if said:
        assert wall_at(rows["lift_inertia"], scene).inertia_over_mass_m2 == pytest.approx(16.0 / 3.0)
        assert values(rows["lift_inertia"], [0.9])["least"] == pytest.approx(16.0 / 3.0)
    assert "lift_inertia" not in rows_of()[0]


@pytest.mark.shows("lifts.weights")
@pytest.mark.parametrize("modulus, said", [(1801.0, True), (1800.0, False), (1200.0, False), (900.0, False)])
def test_that_a_modulus_beyond_that_of_its_masonry_is_shown_with_the_lowest(modulus, said):
    """Solid brick: 1200 to 1800 MPa."""
    wall = PARAPET | {"elastic_modulus_mpa": modulus, "masonry": "solid_brick"}
    rows, scene = rows_of(wall, SPECTRUM)
    assert ("lift_modulus" in rows) == said
    if said:
        row = rows["lift_modulus"]
        assert (row.permitted, wall_at(row, scene).elastic_modulus_mpa) == (False, 1200.0)
        found = values(row, [0.9])
        assert (found["given"], found["least"], found["most"]) == (modulus, 1200.0, 1800.0)
    assert "lift_modulus" not in rows_of(WALL | {"elastic_modulus_mpa": modulus})[0]


@pytest.mark.shows("lifts.weights")
@pytest.mark.parametrize(
    "given, masonry, ends",
    [
        (12.9, "regular_soft_stone", (13.0, 16.0)),
        (16.1, "regular_soft_stone", (13.0, 16.0)),
        (14.0, "regular_soft_stone", ()),
        (40.0, "solid_brick", (18.0,)),
        (18.0, "solid_brick", ()),
        (22.1, None, (13.0, 22.0)),
    ],
)
def test_that_a_unit_weight_that_its_masonry_has_not_is_shown_at_the_ends_of_the_table(given, masonry, ends):
    wall = BARE | {"load": [WEIGHT], "unit_weight_kn_m3": given, "masonry": masonry}
    rows, scene = rows_of(wall)
    assert ("lift_unit_weight" in rows) == bool(ends)
    if ends:
        row = rows["lift_unit_weight"]
        assert tuple(wall_at(row, scene, k).unit_weight_kn_m3 for k in range(len(ends))) == ends
    assert "lift_unit_weight" not in rows_of(WALL | {"unit_weight_kn_m3": given})[0]


# the shape


@pytest.mark.shows("lifts.bodies")
def test_that_wedges_of_return_walls_are_shown_cut_off_behind_the_base():
    wall = WALL | {"length_m": 5.0, "return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 0.5}}
    rows, scene = rows_of(wall)
    row = rows["lift_return_wedges"]
    there = wall_at(row, scene)
    assert (row.key, there.return_wedges, there.solid) == ("return_wedges", None, ())
    solid = {"plane": "section", "polygon_m": [[0.0, 0.0], [0.4, 0.0], [0.7, 4.0], [0.0, 4.0]], "to_m": 5.0}
    solids = WALL | {"length_m": 5.0, "solid": [solid]}
    rows, scene = rows_of(solids)
    (cut,) = wall_at(rows["lift_return_wedges"], scene).solid
    assert max(x for x, _ in cut.polygon_m) == pytest.approx(0.4) and (cut.from_m, cut.to_m) == (0.0, 5.0)
    assert {x for x, _ in cut.polygon_m} >= {0.0}
    inside = solid | {"polygon_m": [[0.0, 0.0], [0.4, 0.0], [0.2, 4.0], [0.0, 4.0]]}
    assert "lift_return_wedges" not in rows_of(solids | {"solid": [inside]})[0]
    assert "lift_return_wedges" not in rows_of()[0]


@pytest.mark.shows("lifts.bodies")
@pytest.mark.parametrize("h, said", [(4.0, True), (4.49, True), (4.496, False), (4.5, False)])
def test_that_a_restraint_that_meets_a_body_below_its_top_is_shown_at_it(h, said):
    """A body of 4.5 m whose restraint reaches h: beyond 99.9 % of it is its top."""
    solid = {"plane": "section", "polygon_m": [[0.0, 0.0], [0.4, 0.0], [0.3, 4.5], [0.0, 4.5]], "to_m": 5.0}
    wall = WALL | {"length_m": 5.0, "height_m": h, "solid": [solid]}
    rows, scene = rows_of(wall, zeta=1.2)
    assert ("lift_contact" in rows) == said
    if said:
        row = rows["lift_contact"]
        assert (row.key, row.value, wall_at(row, scene).height_m) == ("contact", h, pytest.approx(4.5))
        assert values(row, [0.9])["h"] == h and values(row, [0.9])["top"] == pytest.approx(4.5)
    for other in ({"restitution": "costa_upper"}, {"velocity_ratio": 0.3}, TWO_SIDED | BOUND):
        assert "lift_contact" not in rows_of(wall | other, zeta=1.2)[0]


def test_that_the_building_is_asked_about_of_a_wall_in_it_alone():
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    above = scene_of(WALL | {"base_z_m": 3.0}, SPECTRUM, building=building)
    assert "other_building" in rows_of(scene=above)[0]
    assert "other_building" not in rows_of(scene=scene_of(WALL, SPECTRUM, building=building))[0]
