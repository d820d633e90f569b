"""What of the loads of a wall raises zeta: which rows are asked about, and the wall at their other ends."""

import itertools
import math

import pytest

from core.variation.evaluate import evaluate
from core.variation.favourable_loads import favourable_ties_and_forces, favourable_weights
from tests.core.variation.one_evaluation import BARE, SOIL, WALL, scene_of
from tests.holds import carries

WEIGHT = {"kind": "vertical", "kn_m": 20.0, "d_m": 0.2, "h_m": 4.0, "mass": "none"}
TIE = {"kind": "tie", "out_kn_m": 1.0, "h_m": 4.0, "bar_length_m": 6.0}
THRUST = {"kind": "thrust", "kn_m": -0.2, "h_m": 3.0}
CARRIED = {"kind": "carried_mass", "kn_m": 5.0, "h_m": 3.0, "d_m": 0.2}
BOTH_PARTS = {"kind": "vertical", "g_kn_m": 12.0, "q_kn_m": 10.0, "psi_2": 0.6, "d_m": 0.2, "h_m": 4.0, "mass": "none"}


def rows_of(*given, demand=SOIL, clauses=True, building=None, **wall):
    """Code of its words -> the row, of the loads and ties of a wall; its wall."""
    scene = scene_of(carries(*given, **BARE | wall), demand, **({"building": building} if building else {}))
    rows = itertools.chain(favourable_ties_and_forces(scene, clauses), favourable_weights(scene))
    return {row.code: row for row in rows}, scene


def loads_at(row, scene, k=0):
    """The loads of a wall at an end of a row."""
    return row.ends[k].change(scene).wall.load


def ties_at(row, scene, k=0):
    """The ties of a wall at an end of a row."""
    return row.ends[k].change(scene).wall.ties


# ties


@pytest.mark.shows("lifts.elongation", "lifts.brittle")
@pytest.mark.parametrize("clauses", [True, False])
@pytest.mark.parametrize("state, share", [("SLV", 0.4), ("SLC", 0.6), ("SLD", 0.4)])
def test_that_a_tie_that_breaks_before_the_rotation_it_is_counted_up_to_is_asked_about(state, share, clauses):
    """alpha = atan(0.1 / 2); d = share d_0 at alpha - asin((1 - share) sin alpha); at 4 m the bar has then stretched by
    0.0800 m, at SLC by 0.1199 m."""
    alpha = math.atan(0.1 / 2.0)
    there = 4.0 * math.sin(max(alpha - math.asin((1.0 - share) * math.sin(alpha)), 0.4 * alpha))
    for elongation, breaks in ((there * 0.999, True), (there * 1.001, False)):
        found, scene = rows_of(
            TIE | {"elongation_m": elongation},
            WEIGHT | {"kn_m": 1e-9, "d_m": 0.1},
            demand=SOIL | {"limit_state": state},
            clauses=clauses,
        )
        assert ("lift_brittle" in found) == breaks
        assert "lift_elongation" in found
        assert [tie.elongation_m for tie in ties_at(found["lift_elongation"], scene)] == [None]
        if breaks:
            row = found["lift_brittle"]
            assert (row.key, row.histories) == ("elongation_m", clauses)
            assert [load.kind for load in loads_at(row, scene)] == ["vertical"] and ties_at(row, scene) == ()


@pytest.mark.shows("lifts.elongation")
def test_that_a_tie_that_stands_no_more_than_its_yield_has_no_row_of_its_elongation():
    """u_y = 235 / 205000 x 6 m = 6.88 mm."""
    for elongation, said in ((None, False), (0.0070, True)):
        tie = TIE | ({} if elongation is None else {"elongation_m": elongation})
        assert ("lift_elongation" in rows_of(tie)[0]) == said
    assert not rows_of(WEIGHT)[0].keys() & {"lift_elongation", "lift_brittle", "lift_anchorage", "lift_slack"}


def test_that_slack_is_shown_taut_and_without_the_ties_that_have_it():
    found, scene = rows_of(TIE | {"slack_mm": 3.0}, TIE | {"h_m": 3.5}, WEIGHT)
    row = found["lift_slack"]
    assert row.key == "slack_mm" and [one.slack_mm for one in ties_at(row, scene, 0)] == [None, None]
    assert [one.h_m for one in ties_at(row, scene, 1)] == [3.5]
    assert [loads_at(row, scene, k) for k in (0, 1)] == [scene.wall.load] * 2
    assert "lift_slack" not in rows_of(TIE | {"slack_mm": 0.0})[0]


@pytest.mark.shows("lifts.prestress")
def test_that_a_prestress_is_shown_without_it():
    found, scene = rows_of(TIE | {"prestress": 0.3}, WEIGHT)
    assert [one.prestress for one in ties_at(found["lift_prestress"], scene)] == [None]
    assert loads_at(found["lift_prestress"], scene) == scene.wall.load
    assert "lift_prestress" not in rows_of(TIE | {"prestress": 0.0})[0] and "lift_prestress" not in rows_of(TIE)[0]


def test_that_a_tie_of_whose_anchorage_nothing_is_said_is_shown_without_it():
    bar = {"number": 2, "diameter_mm": 16.0}
    tie = {"kind": "tie", "h_m": 4.0, "bar_length_m": 6.0}
    found, scene = rows_of(tie | {"bar": bar}, WEIGHT, length_m=80.0)
    assert found["lift_anchorage"].source == "left_out"
    assert [one.kind for one in loads_at(found["lift_anchorage"], scene)] == ["vertical"]
    assert ties_at(found["lift_anchorage"], scene) == ()
    given = tie | {"h_m": 3.5, "bar": bar | {"anchorage_kn": 90.0}}
    assert "lift_anchorage" not in rows_of(given, WEIGHT, length_m=80.0)[0]
    both, scene = rows_of(given, TIE | {"out_kn_m": 0.5}, WEIGHT, length_m=80.0)
    assert [one.h_m for one in ties_at(both["lift_anchorage"], scene)] == [3.5]


# forces that pull inward


@pytest.mark.shows("lifts.prestress")
@pytest.mark.parametrize("kn_m, said", [(-0.2, True), (-0.001, True), (0.05, False), (0.3, False)])
def test_that_a_force_that_always_pulls_inward_is_shown_without_it(kn_m, said):
    found, scene = rows_of(THRUST | {"kn_m": kn_m}, WEIGHT)
    assert ("lift_inward" in found) == said
    if said:
        assert found["lift_inward"].key == "inward" and [one.kind for one in loads_at(found["lift_inward"], scene)] == [
            "vertical"
        ]
    assert "lift_inward" not in rows_of(TIE, CARRIED)[0]


# where weights stand, and what their mass does


@pytest.mark.shows("lifts.weights")
def test_that_the_mass_of_a_weight_is_shown_as_each_of_the_two_others():
    for mass, others in (("none", ["horizontal", "moving"]), ("horizontal", ["none", "moving"])):
        found, scene = rows_of(WEIGHT | {"mass": mass}, TIE)
        row = found["lift_mass"]
        assert row.key == "mass" and [end.value.code for end in row.ends] == [f"choice_{one}" for one in others]
        assert [loads_at(row, scene, k)[0].mass for k in (0, 1)] == others and row.value.code == f"choice_{mass}"
        assert ties_at(row, scene, 0) == scene.wall.ties and len(scene.wall.ties) == 1


def test_that_walls_without_weights_have_no_rows_of_them():
    assert not rows_of(TIE)[0].keys() & {"lift_mass", "lift_low_load"}
    carried = rows_of(CARRIED)[0]
    assert "lift_mass" not in carried and "lift_carried" in carried
    assert list(favourable_weights(scene_of(WALL))) == []


# weights that may not be there


@pytest.mark.shows("lifts.weights")
@pytest.mark.parametrize(
    "height, h, said",
    [
        (4.0, 2.0, True),
        (4.0, 2.01, False),
        (3.0, 1.5, True),
        (3.0, 1.51, False),
        (1.5, 1.0, True),
        (1.5, 1.01, False),
        (6.0, 2.0, True),
        (6.0, 2.01, False),
    ],
)
def test_that_a_weight_lower_than_any_floor_is_asked_about(height, h, said):
    """Up to 1 m above the hinge, and up to 2 m in the lower half of the wall."""
    for load in (WEIGHT, CARRIED):
        found, scene = rows_of(
            load | {"h_m": h, "kn_m": 1.0}, WEIGHT | {"h_m": height}, height_m=height, hinge_heights="base"
        )
        assert ("lift_low_load" in found) == said
        if said:
            row = found["lift_low_load"]
            assert (row.key, row.ends[0].value.code) == ("h_m", "below_hinge")
            assert [one.h_m for one in loads_at(row, scene)] == [height]
            words = dict(row.phrase([1.0], evaluate(scene).checks[0]).values)
            assert words["height"].value == h
    low = TIE | {"h_m": h, "out_kn_m": 0.1}
    assert "lift_low_load" not in rows_of(low, WEIGHT | {"h_m": height}, height_m=height)[0]


@pytest.mark.shows("lifts.weights")
def test_that_without_its_variable_part_a_weight_is_its_permanent_one():
    found, scene = rows_of(BOTH_PARTS, CARRIED)
    row = found["lift_variable"]
    left, carried = loads_at(row, scene)
    assert scene.wall.load[0].kn_m == pytest.approx(18.0)
    assert (left.kn_m, left.q_kn_m, left.psi_2) == (12.0, None, None) and carried.kind == "carried_mass"
    assert "lift_carried" in found and row.ends[0].value.code == "permanent"
    alone, scene = rows_of({**BOTH_PARTS, "g_kn_m": 0.0}, WEIGHT)
    assert [one.kn_m for one in loads_at(alone["lift_variable"], scene)] == [20.0]


@pytest.mark.parametrize("part", [{"q_kn_m": 0.0}, {"psi_2": 0.0}])
def test_that_a_weight_without_a_variable_part_has_no_row_of_it(part):
    found, scene = rows_of(BOTH_PARTS | part, CARRIED)
    assert "lift_variable" not in found
    assert [one.kind for one in loads_at(found["lift_carried"], scene)] == ["vertical"]
    assert "lift_variable" not in rows_of(WEIGHT)[0] and "lift_carried" not in rows_of(WEIGHT)[0]


def test_that_a_weight_without_which_the_wall_falls_is_asked_about():
    """The worst that its other end can say; the thrust may be less than it is said to be.

    W 28.8 kN/m at 0.1 m; a thrust of 1 kN/m at 4 m needs 4 kNm/m: 20 kN/m 0.1 m inside the hinge hold it."""
    thrust = {"kind": "thrust", "kn_m": 1.0, "h_m": 4.0}
    held = rows_of(CARRIED | {"kn_m": 20.0, "h_m": 3.0}, thrust)[0]
    assert "lift_carried" in held
    low = rows_of(WEIGHT | {"h_m": 1.0}, thrust, hinge_heights="base")[0]
    assert "lift_low_load" in low and "lift_low_load" in rows_of(WEIGHT | {"h_m": 1.0}, hinge_heights="base")[0]
    variable = rows_of(BOTH_PARTS | {"g_kn_m": 1.0, "q_kn_m": 30.0}, thrust)[0]
    assert "lift_variable" in variable
