"""A corner of two walls: the short form is the solids it stands for."""

from dataclasses import replace
from pathlib import Path

import pytest

from core.case.rules import parse_case
from core.errors import InputError
from core.lab.solved.bodies import corner_of
from core.study.run import run
from tests.clauses_alone import parse_case as clauses_alone
from tests.core.variation.one_evaluation import looked_at
from tests.holds import shown

WALL = {"name": "corner", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.6, "length_m": 2.0}
WALL |= {"unit_weight_kn_m3": 18.0, "base_z_m": 0.0, "hold": [{"kind": "contact"}]}
CORNER = {"length_1_m": 2.4, "length_2_m": 2.4, "thickness_2_m": 0.6}


def wall_of(**changes):
    return parse_case({"wall": [{**WALL, "corner": CORNER, **changes}]}).wall[0]


@pytest.mark.shows("bodies.corner")
@pytest.mark.parametrize(
    ("lengths", "thicknesses", "angle", "printed"),
    [
        ((2.4, 2.4), (0.6, 0.6), 45.0, (12389.6, 11.8839, 2.07817, 0.21044)),
        ((2.4, 1.5), (0.6, 0.45), 50.0, (9267.4, 10.4230, 2.10026, 0.18395)),
    ],
)
def test_that_the_short_form_is_the_two_solids_with_the_printed_values(lengths, thicknesses, angle, printed):
    corner = {"length_1_m": lengths[0], "length_2_m": lengths[1], "thickness_2_m": thicknesses[1], "angle_deg": angle}
    size = {"thickness_m": thicknesses[0], "length_m": 1.2}
    short = wall_of(corner=corner, **size)
    solids = corner_of(6.0, lengths, thicknesses, angle)
    table = {key: value for key, value in {**WALL, **size}.items() if key != "corner"} | {"solid": solids}
    written = parse_case({"wall": [table]}).wall[0]
    for one, other in zip(short.in_si.body, written.in_si.body, strict=True):
        assert one == pytest.approx(other, rel=1e-12)
    block = short.in_si.block
    found = (short.in_si.body.mass, block.slenderness * 57.29577951308232, block.p2, short.in_si.uplift_multiplier(""))
    assert found == pytest.approx(printed, rel=3e-5)


@pytest.mark.shows("bodies.corner")
def test_that_cracks_half_as_long_are_a_row_and_turn_what_rests_on_them():
    spectrum = {"code": "EN1998", "type": 1, "soil": "B"}
    hip = {"kind": "thrust", "kn_m": 1.0, "h_m": 6.0}
    for loads, reason in (([], None), ([hip], None), ([hip], "cracks surveyed, sheet 3")):
        length = round(2.4 * 0.5**0.5 + 0.6 * 0.5**0.5, 3) if not loads else 2.4 * 2.0**0.5
        wall = {**WALL, "corner": CORNER, "length_m": length} | ({"load": loads} if loads else {})
        wall |= {"evidence": shown(corner=reason)} if reason else {}
        table = {"wall": [wall | ({} if loads else {"unloaded_confirmed": True})]}
        table["demand"] = {"ag_g": 0.12, "spectrum": spectrum}
        result = run(clauses_alone(table), base_dir=Path())
        verdict, row = result.walls[0].required_assessment.verdict, looked_at(result)["lift_corner"]
        assert row.zeta < verdict.zeta_e and bool(row.reason) == bool(reason)
        assert all("ζ" in row.words.text(language) for language in ("en", "it"))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"gable_m": 1.0}, "does not go with gable_m"),
        ({"corner": {**CORNER, "length_2_m": 0.5}}, "beyond the thickness"),
        ({"corner": {**CORNER, "length_1_m": 0.5}}, "beyond the thickness"),
        ({"corner": {**CORNER, "angle_deg": 85.0}}, "angle_deg"),
        ({"mechanism": "vertical_bending"}, "corner"),
    ],
)
def test_that_what_does_not_go_with_a_corner_is_refused_in_one_sentence(changes, words):
    with pytest.raises(InputError) as caught:
        wall_of(**changes)
    assert words in str(caught.value)


@pytest.mark.shows("bodies.corner")
def test_that_above_a_hinge_the_cracks_begin_there_with_their_inclination():
    """The corner of the top storey is a wall of its own with the same cracks: what was dragged from below is not."""
    from core.case.above_hinge import cut_above_hinge

    part = cut_above_hinge(wall_of(length_m=1.2), 2.0)
    own = wall_of(height_m=4.0, length_m=1.2, corner={**CORNER, "length_1_m": 1.6, "length_2_m": 1.6})
    assert part.in_si.body == pytest.approx(own.in_si.body, rel=1e-12)
    high = cut_above_hinge(wall_of(length_m=1.2), 5.0)  # there the second wall is within the first
    assert len(high.parts) == 1


def test_that_no_wall_of_a_corner_is_higher_than_it():
    for second in (0.61, 0.7, 1.0, 2.4):
        corner = wall_of(corner={**CORNER, "length_2_m": second}, length_m=0.9).corner
        half = replace(wall_of(length_m=0.9), corner=replace(corner, length_2_m=0.5 * second))
        assert max(z for part in half.parts for _, z in part.polygon) == 6.0
