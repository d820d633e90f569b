"""What stands above the highest hold is free and rocks to both sides; a stretch that nobody looks at blocks."""

import random

import pytest

from core.case.above_hinge import MIN_HEIGHT_ABOVE
from core.case.hinges import count_wall_parts, highest_hold, make_wall_parts
from core.case.rules import parse_case
from core.study.run import run
from tests.conftest import ROOT
from tests.holds import aside, carries

BUILDING = {"height_m": 7.5, "storeys": 2, "period_s": 0.227}
SPECTRUM = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "C", "topography": "T1"}
FACADE = {
    "name": "facade",
    "height_m": 9.0,
    "thickness_m": 0.9,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "length_m": 8.0,
    "hold": [{"kind": "contact", "evidence": {"kind": "drawing"}}],
    "unloaded_confirmed": True,
}
STEP = {"steps": [{"from_z_m": 7.5, "thickness_m": 0.3, "flush": "outer"}]}
TIE = {"kind": "tie", "out_kn_m": 1.3, "h_m": 6.8, "bar_length_m": 9.0, "elongation_m": 0.1}


def parts_of_wall(**keys):
    case = parse_case({"building": BUILDING, "wall": [FACADE | keys]})
    parts = make_wall_parts(0, case.wall[0], case.building)
    assert sum(len(part.wall.mechanisms()) for part in parts) == count_wall_parts(case.wall[0], case.building)
    return {part.hinge: part.wall for part in parts if part.turns}


@pytest.mark.shows("free.above")
def test_that_a_parapet_above_the_roof_is_judged_as_it_is_alone():
    alone = {key: FACADE[key] for key in ("mechanism", "unit_weight_kn_m3", "unloaded_confirmed")}
    alone |= {"name": "alone", "mechanism": "two_sided", "height_m": 1.5, "thickness_m": 0.3, "base_z_m": 7.5}
    table = {"building": BUILDING, "demand": {"ag_g": 0.075, "spectrum": SPECTRUM}, "analysis": {"histories": False}}
    found = run(parse_case(table | {"wall": [FACADE | STEP, alone]}), base_dir=ROOT)
    by_name = {wall.wall.name: wall.assessment for wall in found.walls}
    above, lone = by_name["facade (+7.5 m)"], by_name["alone"]
    assert above.kinematic.alpha0 == pytest.approx(lone.kinematic.alpha0) and above.kinematic.free_element
    assert [(check.name, check.zeta) for check in above.checks] == [(check.name, check.zeta) for check in lone.checks]


@pytest.mark.shows("free.above")
def test_that_what_stands_above_the_highest_hold_is_free_at_any_height_over_thickness():
    draw = random.Random(6)
    for _ in range(40):
        over = draw.uniform(0.0, 3.0)
        thickness = draw.uniform(0.25, 1.2)
        asked = draw.choice([None, "base", "floors"])
        keys = {"height_m": 7.5 + over, "thickness_m": thickness}
        walls = parts_of_wall(**keys, **({} if asked is None else {"hinge_heights": asked}))
        if over <= max(MIN_HEIGHT_ABOVE, 0.5 * thickness):
            assert {wall.mechanism for wall in walls.values()} == {"one_sided"}
            continue
        assert {hinge: wall.mechanism for hinge, wall in walls.items() if hinge >= 7.5}[7.5] == "two_sided"
        assert {wall.mechanism for hinge, wall in walls.items() if hinge < 7.45} == {"one_sided"}
        assert walls[7.5].hold == () and walls[7.5].height_m == pytest.approx(over)


@pytest.mark.shows("free.above")
def test_that_a_tie_above_the_building_stops_nothing_and_a_wall_that_begins_there_is_as_it_is_given():
    tied = parse_case({"building": BUILDING, "wall": [carries(TIE | {"h_m": 7.9}, **FACADE)]}).wall[0]
    assert highest_hold(tied, parse_case({"building": BUILDING, "wall": [FACADE]}).building) == 7.5
    gable = FACADE | {"base_z_m": 7.5, "height_m": 2.0}
    assert set(parts_of_wall(**gable)) == {0.0} and parts_of_wall(**gable)[0.0].mechanism == "one_sided"
    assert highest_hold(tied, None) is None


@pytest.mark.shows("free.stretches")
@pytest.mark.parametrize(
    ("load", "left_out"),
    [
        ([], False),
        ([TIE], False),
        ([TIE, {"kind": "thrust", "kn_m": 0.001, "h_m": 3.0}], False),  # it bends the stretch
        ([TIE, {"kind": "thrust", "kn_m": -0.001, "h_m": 3.0}], True),
        ([TIE | {"slack_mm": 0.01}], True),
        (
            [TIE | {"h_m": 0.8, "out_kn_m": 0.1}, {"kind": "thrust", "kn_m": 0.001, "h_m": 0.5}],
            False,
        ),  # stocky below it
    ],
)
def test_that_a_stretch_below_a_tie_that_is_not_looked_at_blocks_what_passes(load, left_out):
    bare = {key: value for key, value in FACADE.items() if key != "unloaded_confirmed"}
    wall = carries(*load, **(bare | {"height_m": 7.0, "thickness_m": 0.3}))
    table = {"building": BUILDING, "demand": {"ag_g": 0.02, "spectrum": SPECTRUM}, "analysis": {"histories": False}}
    case = parse_case(table | {"wall": [wall]})
    verdict = run(case, base_dir=ROOT).walls[0].assessment.verdict
    assert ("stretches_left_out" in [limit.code for limit in verdict.limits]) == left_out
    assert not left_out or verdict.code not in ("verified", "verified_refined", "not_activated")
    shown = wall | {"set_aside": [aside("vertical_bending")]}
    verdict = run(parse_case(table | {"wall": [shown]}), base_dir=ROOT).walls[0].assessment.verdict
    assert "stretches_left_out" not in [limit.code for limit in verdict.limits]
