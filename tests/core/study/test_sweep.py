"""A sweep of one number is the run of the case with each value."""

import itertools
from dataclasses import replace

import numpy as np
import pytest

from core.case.hold import Hold
from core.case.loads import Load
from core.case.reader import read_case
from core.case.rules import parse_case
from core.case.site import Demand
from core.case.wall import Wall
from core.case.writer import table_of
from core.errors import Cancelled
from core.study.run import run
from core.study.sweep import SweepKey, make_sweep_point, set_swept_value, sweep, sweep_keys, value_at
from tests.conftest import ROOT

CASES, SHIPPED = ROOT / "tests" / "cases", ROOT / "resources" / "cases"
THICKNESS = SweepKey(Wall, "thickness_m")


@pytest.fixture(scope="module")
def case():
    whole = read_case(CASES / "records.toml")
    few = replace(whole, record=whole.record[:1], analysis=replace(whole.analysis, q_step=0.05))
    return parse_case(table_of(few))


def points(case, key, values, k=0, **options):
    return list(sweep(case, k, key, values, base_dir=CASES, **options))


@pytest.mark.shows("window.sweep")
def test_that_the_point_of_the_value_at_hand_is_the_run_of_the_wall(case):
    before = table_of(case)
    now = value_at(case, 0, THICKNESS)
    (point,) = points(case, THICKNESS, [now])
    alone = parse_case(table_of(replace(case, wall=case.wall[:1])))
    assert point == make_sweep_point(now, run(alone, base_dir=CASES))
    assert point.zeta and point.q and point.verdict and table_of(case) == before


def test_that_a_thicker_wall_withstands_more_and_a_larger_a_g_leaves_less(case):
    case = replace(case, record=())  # of a check that asks for none
    thicker = points(case, THICKNESS, np.linspace(0.4, 1.0, 4))
    assert all(a.zeta["linear_q_code"] < b.zeta["linear_q_code"] for a, b in itertools.pairwise(thicker))
    stronger = points(case, SweepKey(Demand, "ag_g"), [0.1, 0.2, 0.4])
    zetas = [one.zeta["linear_q_code"] for one in stronger]
    assert zetas[0] == pytest.approx(2.0 * zetas[1]) and zetas[1] == pytest.approx(2.0 * zetas[2])


def test_that_a_refused_value_is_named_and_the_others_have_numbers(case):
    loaded = replace(
        case.wall[0], unit_weight_kn_m3=18.0, unloaded_confirmed=False, load=(Load("vertical", 5.0, 5.0, 0.1, "none"),)
    )
    case = replace(case, wall=(loaded,))
    low, high = points(case, SweepKey(Wall, "height_m"), [4.0, 7.0])
    assert low.error.code == "load_outside" and low.zeta == {} and low.q is None
    assert high.error is None and high.q
    keys = sweep_keys(case, 0)
    size = SweepKey(Load, "kn_m", 0)
    assert size in keys and value_at(case, 0, size) == 5.0
    assert set_swept_value(case, 0, size, 8.0).wall[0].load[0].kn_m == 8.0


def test_that_one_way_to_give_a_size_replaces_the_other_and_no_tie_is_sought(case):
    tie = Hold("tie", h_m=3.0, design=True)
    by_angle = replace(case.wall[0], thickness_m=None, slenderness_deg=6.0, hold=(*case.wall[0].hold, tie))
    changed = set_swept_value(replace(case, wall=(by_angle,)), 0, THICKNESS, 0.5).wall[0]
    assert (changed.thickness_m, changed.slenderness_deg, changed.sought) == (0.5, None, None)


@pytest.mark.parametrize("name", ["building.toml", "verdict.toml", "example.toml"])
def test_that_every_key_offered_of_a_shipped_case_can_be_changed(name):
    """With the value it has, where there is one, the case is the same."""
    case = read_case(SHIPPED / name)
    for k, wall in enumerate(case.wall):
        keys = sweep_keys(case, k)
        assert len(set(keys)) == len(keys)
        assert {key.name for key in keys}.isdisjoint({"radius_m", "inertia_over_mass_m2", "zeta_target", "q_code"})
        for key in keys:
            value = value_at(case, k, key)
            if value is not None and getattr(wall, key.name, value) is not None:
                same = set_swept_value(case, k, key, value)
                assert value_at(same, 0, key) == value


def test_that_a_sweep_is_cancelled_between_two_values_and_tells_how_far_it_is(case):
    told, stop = [], []
    found = sweep(
        case,
        0,
        THICKNESS,
        [0.6, 0.7, 0.8],
        base_dir=CASES,
        on_progress=lambda n, share: told.append((n, share)),
        cancelled=lambda: bool(stop),
    )
    next(found)
    stop.append(True)
    with pytest.raises(Cancelled):
        next(found)
    assert {n for n, _ in told} <= {0, 1} and all(0.0 <= share <= 1.0 for _, share in told)
