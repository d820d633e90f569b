"""What is found by search gives the zeta required when the case is run with it, and a little less of it does not."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from core.case.held_top import move_top_loads
from core.case.hold import Hold
from core.errors import InputError
from core.setting.plan import read_inputs
from core.study.run import run
from core.variation import inverse_design
from core.variation.evaluate import COARSE_PRECISION, FULL_PRECISION
from core.variation.inverse_design import design_keys, find_target_value, slider_keys
from core.variation.wall_evaluation import evaluate_wall, make_wall_context
from tests.clauses_alone import parse_case
from tests.core.variation.test_sensitivity import CASES, LOADED, case_of, moved

TIE = {"kind": "tie", "out_kn_m": 4.0, "h_m": 5.0, "bar_length_m": 6.0, "elongation_m": 0.3}
TIED = LOADED | {"hold": [*LOADED["hold"], TIE]}
PLACES = {
    "thickness_m": ("wall", 0, "thickness_m"),
    "ag_g": ("demand", "ag_g"),
    "tie_kn_m": ("wall", 0, "hold", 1, "out_kn_m"),
}


def setting(table):
    case = parse_case(table)
    return make_wall_context(case, 0, CASES, read_inputs(case, CASES))


def checks_of(table):
    result = run(parse_case(table), base_dir=CASES)
    return {check.label: check.zeta for check in result.walls[0].assessment.checks}


def with_thickness(table, key, value):
    """The loads of a thinner wall keep their share of it."""
    changed = moved(table, PLACES[key], value)
    if key == "thickness_m":
        changed = moved(changed, ("wall", 0, "load", 0, "d_m"), 0.35 * value / 0.5)
    return changed


@pytest.mark.shows("search.inverse")
@pytest.mark.parametrize("wall, keys", [(LOADED, ["ag_g", "thickness_m"]), (TIED, ["ag_g", "thickness_m", "tie_kn_m"])])
def test_that_the_value_found_gives_what_is_required(wall, keys):
    table = case_of(wall, demand={"ag_g": 0.2})
    here = setting(table)
    assert sorted(design_keys(here)) == sorted(keys)
    found = 0
    for key, given in design_keys(here).items():
        for label, value in find_target_value(here, key, given).by_check.items():
            if value is None:
                continue
            zeta = checks_of(with_thickness(table, key, value))[label]
            beyond = value * 1.01 if key == "ag_g" else value / 1.01
            assert 1.0 - 1e-12 <= zeta < 1.02, (key, label)
            assert checks_of(with_thickness(table, key, beyond))[label] < 1.0, (key, label)
            found += 1
    assert found >= 2 * len(keys) - 1


@pytest.mark.parametrize("count", [3, pytest.param(7, marks=pytest.mark.long)])
def test_that_histories_hold_in_the_run_at_what_is_found(count):
    wall = {key: value for key, value in LOADED.items() if key not in ("load", "elastic_modulus_mpa")}
    generate = {"scatter": 0.0, "count": count}
    table = case_of(wall | {"unloaded_confirmed": True}, demand={"ag_g": 0.35}, generate=generate)
    table["demand"]["spectrum"] = {**table["demand"]["spectrum"], "soil": "A"}
    table["analysis"] = {"q_step": 0.05}
    here = setting(table)
    thickness = find_target_value(here, "thickness_m", 0.5).by_check["dynamic"]
    found = run(parse_case(moved(table, PLACES["thickness_m"], thickness)), base_dir=CASES).walls[0].assessment.dynamic
    assert found.passed and not found.within_spread(1.0)
    thinner = run(parse_case(moved(table, PLACES["thickness_m"], 0.85 * thickness)), base_dir=CASES)
    assert not thinner.walls[0].assessment.dynamic.passed
    of_ag = find_target_value(here, "ag_g", 0.35)
    ag = of_ag.by_check["dynamic"]
    assert of_ag.throughout == ()
    now = evaluate_wall(here, COARSE_PRECISION).by_check["dynamic"]
    assert 0.75 * now < ag / 0.35 < 1.03 * now


@pytest.mark.shows("search.inverse")
def test_that_what_no_value_reaches_is_none():
    """A thin wall on which nothing but its own height acts: no tie, and a_g far beyond the search."""
    bare = {key: value for key, value in LOADED.items() if key != "load"}
    table = case_of(bare | {"thickness_m": 0.12, "height_m": 12.0, "unloaded_confirmed": True}, demand={"ag_g": 1.9})
    found = find_target_value(setting(table), "thickness_m", 0.12).by_check
    assert found["linear_q_code"] is None


def test_that_a_check_satisfied_throughout_has_no_value_and_a_refused_one_is_no_limit():
    """A facade whose wedges hold it at any thickness; a setback that is refused before zeta falls to the target."""
    from core.case.reader import read_case

    case = read_case(CASES / "facade.toml")
    case = replace(case, generate=replace(case.generate, scatter=0.0, count=3), demand=replace(case.demand, ag_g=0.15))
    held = (Hold("cross_walls"),)
    bonded = replace(case.wall[1], hinge_heights="base", hold=held, masonry=None, mechanism="one_sided")
    case = replace(case, wall=(bonded,), building=None)
    wedges = make_wall_context(case, 0, CASES, read_inputs(case, CASES))
    found = find_target_value(wedges, "thickness_m", 0.9)
    assert found.by_check["nonlinear"] is None and found.by_check["dynamic"] is None
    assert set(found.throughout) == {"nonlinear", "dynamic"} and found.by_check["linear_q_code"] > 0.9
    bare = {key: value for key, value in LOADED.items() if key != "load"}
    back = bare | {"unloaded_confirmed": True, "hinge_setback_m": 0.15}
    low = find_target_value(setting(case_of(back, demand={"ag_g": 0.01})), "thickness_m", 0.5)
    assert low.by_check == {"nonlinear": None, "linear_q_code": None}
    assert low.throughout == ("nonlinear", "linear_q_code")


@pytest.fixture
def found_where(monkeypatch):
    """What is found of one check that holds at some values; sure : at which the run is surely satisfied; accepted : at
    which the wall stands."""

    def found(key, given, holds, sure=None, accepted=lambda value: True, label="nonlinear"):
        def change(_, value):
            if not accepted(value):
                raise InputError("unstable_under_loads")
            return value

        def known(value, precision, *, cancelled):
            there = (sure or holds) if precision == FULL_PRECISION else holds
            return SimpleNamespace(hinges=(1,), by_check={label: 1.0}, satisfied={label: there(value)})

        monkeypatch.setattr(inverse_design, "VALUE_SETTERS", {key: change})
        monkeypatch.setattr(inverse_design, "evaluate_wall", known)
        reach = find_target_value(SimpleNamespace(), key, given)
        assert (reach.key, reach.given) == (key, given) and set(reach.throughout) <= {label}
        return reach.by_check[label], bool(reach.throughout)

    return found


@pytest.mark.shows("search.inverse")
@pytest.mark.parametrize("key, widest", [("thickness_m", 4.0), ("tie_kn_m", 64.0), ("ag_g", 16.0)])
def test_that_a_value_is_sought_within_the_range_stated_and_found_to_two_thousandths(found_where, key, widest):
    """So many times the value given and its inverse; of a_g the largest value at which the check holds."""
    for share in (1.5, 1.0 / 1.5, 0.999 * widest, 1.0 / (0.999 * widest)):
        limit = 0.3 * share
        value, everywhere = found_where(key, 0.3, lambda v: v <= limit if key == "ag_g" else v >= limit)  # noqa: B023
        assert not everywhere
        unit = inverse_design.ROUNDING_STEPS[key]
        assert 1.0 <= (limit / value if key == "ag_g" else value / limit) <= 1.003 + unit / limit
    for share in (1.001 * widest, 1.0 / (1.001 * widest)):
        limit = 0.3 * share
        value, everywhere = found_where(key, 0.3, lambda v: v <= limit if key == "ag_g" else v >= limit)  # noqa: B023
        assert value is None and everywhere == ((share > 1.0) == (key == "ag_g"))


def test_that_the_value_found_is_one_from_which_on_the_check_holds(found_where):
    """A value with a failing one less than a half beyond is passed over; one further away is another matter."""

    def holds(value):
        return 0.3 <= value <= 0.5 or value >= 0.8

    for given in (1.0, 0.6, 0.4):
        assert 1.0 <= found_where("thickness_m", given, holds)[0] / 0.8 <= 1.005
    far = found_where("thickness_m", 0.4, lambda value: 0.3 <= value <= 0.9 or value >= 2.0)
    assert 1.0 <= far[0] / 0.3 <= 1.005


def test_that_a_check_of_the_clauses_holds_at_half_as_much_more_and_is_not_asked_beyond(found_where):
    """A gap at 1.55 to 1.75 times the value is beyond what is looked at; one at 1.45 to 1.55 is not."""
    far = found_where("thickness_m", 0.305, lambda value: 0.3 <= value <= 0.465 or value >= 0.525)
    assert 1.0 <= far[0] / 0.3 <= 1.005
    near = found_where("thickness_m", 0.305, lambda value: 0.3 <= value <= 0.435 or value >= 0.465)
    assert 1.0 <= near[0] / 0.465 <= 1.005


@pytest.mark.parametrize("factor", [1.05, 1.1, 1.2, 1.3, 1.5])
def test_that_a_value_is_passed_over_where_one_that_many_times_as_large_fails(found_where, factor):
    gap = 0.3 * (factor - 0.01), 0.3 * (factor + 0.04)
    value, _ = found_where("thickness_m", 0.305, lambda v: v >= 0.3 and not gap[0] < v < gap[1])
    assert value >= 0.999 * gap[1]


def test_that_a_value_of_a_check_of_the_clauses_that_fails_as_it_is_written_is_none(found_where):
    """It holds from 800.0 to 800.5 mm and from 805 on, not at the 801 it would be written as."""
    value, everywhere = found_where("thickness_m", 1.0003125, lambda v: 0.8 <= v <= 0.8005 or v >= 0.805)
    assert value is None and not everywhere
    assert found_where("thickness_m", 1.0003125, lambda v: v >= 0.8)[0] == pytest.approx(0.801)


def test_that_a_value_whose_neighbours_are_refused_holds_throughout(found_where):
    """The last that is accepted is no limit of the check; a limit among accepted ones is."""
    assert found_where("thickness_m", 1.0, lambda v: True, accepted=lambda v: v > 0.6) == (None, True)
    value, everywhere = found_where("thickness_m", 1.0, lambda v: v >= 0.8, accepted=lambda v: v > 0.6)
    assert 1.0 <= value / 0.8 <= 1.003 and not everywhere


def test_that_histories_hold_a_little_beyond_and_surely_in_the_run(found_where):
    """A value at which they hold by chance, less than two hundredths wide, is passed over; a wider one is not."""
    for end, limit in ((0.71, 0.9), (0.76, 0.7)):
        value, _ = found_where("thickness_m", 0.705, lambda v: 0.7 <= v <= end or v >= 0.9, label="dynamic")  # noqa: B023
        assert 1.0 <= value / limit <= 1.004
    value, _ = found_where("thickness_m", 1.0, lambda v: v >= 0.8, lambda v: v >= 1.0, label="dynamic")
    assert 1.0 <= value < 1.012
    # thirty steps of one hundredth
    assert found_where("thickness_m", 1.0, lambda v: v >= 0.8, lambda v: v >= 0.8 * 1.36, label="dynamic")[0] is None


def test_that_loads_are_moved_where_something_but_a_tie_acts():
    assert slider_keys(setting(case_of(LOADED)))["load_factor"] == 1.0
    tied = {key: value for key, value in TIED.items() if key != "load"}
    keys = slider_keys(setting(case_of(tied)))
    assert "load_factor" not in keys and keys["tie_kn_m"] == 4.0 and keys["height_m"] == 6.0


def test_that_what_holds_a_wall_at_its_top_follows_its_height():
    holds = [{"kind": "contact", "to_m": 6.0}, {"kind": "floor", "h_m": 6.0}, {"kind": "floor", "h_m": 3.0}]
    keys = {"name": "w", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.5, "hold": holds}
    wall = parse_case({"wall": [keys]}).wall[0]
    lower = move_top_loads(wall, replace(wall, height_m=5.5))
    assert [(hold.to_m, hold.h_m) for hold in lower.hold] == [(5.5, None), (None, 5.5), (None, 3.0)]
