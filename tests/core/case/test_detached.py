"""The outer leaf of a wall that comes off and turns alone."""

from pathlib import Path

import numpy as np
import pytest

from core.case.hinges import count_wall_parts, make_wall_parts
from core.case.rules import parse_case
from core.codes.kinematic_chain import sum_chain
from core.errors import InputError
from core.study.run import run
from tests.clauses_alone import parse_case as clauses_alone
from tests.holds import shown

WALL = {"name": "facade", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.6, "length_m": 8.0}
WALL |= {"unit_weight_kn_m3": 19.0, "base_z_m": 0.0, "hold": [{"kind": "cross_walls", "evidence": {"kind": "opening"}}]}
LEAF = {"thickness_m": 0.22, "connector_kn_m": 1.2, "row_spacing_m": 1.5, "slip_mm": 2.0}
FLOOR = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.4, "h_m": 3.0, "mass": "none"}
COPING = {"kind": "carried_mass", "kn_m": 0.6, "d_m": 0.1, "h_m": 6.0}
DEMAND = {"ag_g": 0.12, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def leaves_of(leaf=LEAF, **changes):
    wall = parse_case({"wall": [{**WALL, "leaf": leaf, **changes}]}).wall[0]
    parts = make_wall_parts(0, wall, None)
    assert len(parts) == count_wall_parts(wall, None)
    return [part for part in parts if part.aspect]


@pytest.mark.shows("bodies.leaf")
def test_that_a_leaf_is_a_rectangle_with_its_connectors_and_what_rests_on_it():
    rng = np.random.default_rng(2)
    for _ in range(50):
        t, pull, step = rng.uniform(0.1, 0.5), rng.uniform(0.1, 3.0), rng.uniform(0.6, 2.5)
        leaf = {"thickness_m": t, "connector_kn_m": pull, "row_spacing_m": step, "slip_mm": 2.0}
        whole = leaves_of(leaf, load=[FLOOR, COPING])[0].wall
        weight, coping = 19e3 * t * 6.0, 600.0
        rows = [step * k for k in range(1, 20) if step * k <= 5.95]
        bears = 12e3 * 0.4 if t >= 0.4 else 0.0
        # the highest row goes first: those below hold in proportion to their heights by then
        together = 1e3 * pull * sum(row**2 for row in rows) / rows[-1]
        held = weight * t / 2 + (coping * 0.1 if t >= 0.1 else 0.0) + bears + together
        pushes = weight * 3.0 + (coping * 6.0 if t >= 0.1 else 0.0)
        assert sum_chain(whole.in_si, False).start[0] == pytest.approx(held / pushes, rel=1e-9)
        assert [tie.h_m for tie in whole.ties] == pytest.approx(rows)
        # a connector is gone where it is pulled out
        assert all(tie.bar.elongation_at_yield == pytest.approx(2e-3) for tie in whole.in_si.ties)
        assert all(tie.bar.stands <= tie.bar.elongation_at_yield for tie in whole.in_si.ties)


def test_that_a_leaf_without_connectors_is_the_wall_of_its_thickness():
    bare = {"thickness_m": 0.22}
    result = run(clauses_alone({"wall": [{**WALL, "leaf": bare}], "demand": DEMAND}), base_dir=Path())
    alone = run(clauses_alone({"wall": [{**WALL, "thickness_m": 0.22}], "demand": DEMAND}), base_dir=Path())
    whole, leaf = result.walls
    assert (
        leaf.required_assessment.verdict.zeta_e
        == alone.walls[0].required_assessment.verdict.zeta_e
        < whole.required_assessment.verdict.zeta_e
    )
    (verdict,) = result.verdicts
    assert verdict.governing == 1 and leaf.name == "facade (t 0.22 m)"


def test_that_connectors_hold_no_less_the_stronger_they_are_and_strong_ones_are_not_refused():
    least = []
    for pull in (0.2, 1.0, 3.0, 10.0, 100.0):
        walls = leaves_of(LEAF | {"connector_kn_m": pull})
        least.append(min(sum_chain(part.wall.in_si, False).start[0] for part in walls if part.top is None))
        assert any(part.hinge for part in walls)  # above a row too
    assert least == sorted(least)


def test_that_the_evidence_of_cross_walls_shows_no_leaf():
    (leaf, *_), (seen, *_) = leaves_of(), leaves_of(evidence=shown(leaf="endoscopy, three holes"))
    assert leaf.wall.held_by.evidence is None and seen.wall.held_by.evidence.kind == "opening"


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"mechanism": "two_sided"}, "leaf_mechanism"),
        ({"leaf": LEAF | {"thickness_m": 0.6}}, "leaf_thickness"),
        ({"leaf": {"thickness_m": 0.2, "connector_kn_m": 1.0}}, "leaf_connectors"),
        ({"leaf": LEAF | {"row_spacing_m": 6.0}}, "leaf_rows"),
        ({"unit_weight_kn_m3": None}, "leaf_needs"),
        ({"steps": [{"from_z_m": 3.0, "thickness_m": 0.5, "flush": "inner"}]}, "leaf_shape"),
        ({"steps": [{"from_z_m": 3.0, "thickness_m": 0.2}]}, "leaf_thickness"),
    ],
)
def test_that_a_leaf_no_wall_has_is_refused(changes, code):
    table = {key: value for key, value in {**WALL, "leaf": LEAF, **changes}.items() if value is not None}
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [table]})
    assert refused.value.code == code


def test_that_what_acts_between_strong_connectors_is_refused_as_by_hand():
    """A pull inward, a mass, a slack tie below the highest row: no stretch is looked at, and no leaf passes by that."""
    strong = {"thickness_m": 0.12, "connector_kn_m": 20.0, "row_spacing_m": 5.9, "slip_mm": 5.0}
    assert any(part.top is not None for part in leaves_of(strong))
    slack = {"kind": "tie", "out_kn_m": 0.1, "h_m": 3.0, "bar_length_m": 8.0, "slack_mm": 5.0}
    between = {"kind": "thrust", "kn_m": -0.01, "h_m": 1.0}
    for keys in (
        {"load": [between]},
        {"load": [COPING | {"h_m": 1.0, "kn_m": 0.01, "d_m": 0.06}]},
        {"hold": [*WALL["hold"], slack]},
    ):
        with pytest.raises(InputError) as refused:
            leaves_of(strong, **keys)
        assert refused.value.code == "leaf_held"


def test_that_a_leaf_has_the_hinges_of_a_wall_of_its_thickness():
    tall = {"height_m": 12.0, "thickness_m": 1.2}
    building = {"height_m": 12.0, "storeys": 4, "period_s": 0.35}
    table = {"demand": DEMAND, "building": building}
    leaf = run(clauses_alone({"wall": [WALL | tall | {"leaf": {"thickness_m": 0.2}}], **table}), base_dir=Path())
    alone = run(clauses_alone({"wall": [WALL | tall | {"thickness_m": 0.2}], **table}), base_dir=Path())
    assert leaf.verdicts[0].zeta_least == alone.verdicts[0].zeta_least


@pytest.mark.parametrize(
    ("changes", "case", "code"),
    [
        ({"law": {"elastic_limit": 0.05, "plateau_end": 0.3}}, {}, "tie_needs_rigid_law"),
        ({}, {"analysis": {"method": "linearised"}}, "tie_method"),
        ({}, {"analysis": {"accuracy": True}}, "tie_accuracy"),
    ],
)
def test_that_connectors_are_ties_for_laws_and_methods(changes, case, code):
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [{**WALL, "leaf": LEAF, "hinge_heights": "base", **changes}], **case})
    assert refused.value.code == code
