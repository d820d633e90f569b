"""Walls above the ground in a study: what moves them, what their verdict says."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.report.verdict_words import names_in
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.setting import floors
from core.study.run import run
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.core.variation.one_evaluation import looked_at
from tests.holds import BOUND

BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
DEMAND = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
TABLE = {"record": [{"file": "tests/motions/noise_1.txt", "scale": 0.05}]}
WALL = {"name": "top", "height_m": 3.0, "thickness_m": 0.45, "mechanism": "one_sided"}


def case(base_z, building=BUILDING, records=3, **keys):
    table = {
        "wall": [{**WALL, "base_z_m": base_z, "hold": [{"kind": "cross_walls"}]}],
        "record": [{"file": f"tests/motions/noise_{k}.txt"} for k in range(1, records + 1)],
        "demand": {"ag_g": 0.26, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        "analysis": {"q_step": 0.01},
        **keys,
    }
    if building:
        table["building"] = building
    return parse_case(table)


@pytest.fixture(scope="module")
def result():
    return run(case(6.0), base_dir=ROOT)


@pytest.mark.shows("mechanics.floor_search")
def test_that_the_search_multiplies_the_ground_record(result):
    """q = C PFA / a_RM, and the wall collapses under C times the floor motion."""
    wall = result.walls[0]
    felt = {motion.name: motion for motion in wall.floor.motions}
    for one in wall.runs:
        motion = felt[one.record]
        assert one.scale == pytest.approx(one.ida.q * wall.block.threshold_acceleration / motion.pga, rel=1e-12)
        scale = one.polarity * abs(one.scale) * (1.0 + 1e-9)
        made = integrate_history(motion.acceleration, motion.time_step, scale, wall.model, METHODS["taylor"])
        assert made.outcome == 1


@pytest.mark.shows("paper.eq_16")
def test_that_the_checks_are_made_at_height_and_eq_9_15_16_are_not_shown(result):
    wall = result.walls[0]
    names = [check.name for check in wall.assessment.checks]
    assert {"dynamic", "nonlinear", "linear_q_code"} <= set(names)
    assert wall.code_check == () and wall.closed_form_q is None and wall.estimates == ()
    assert all(entry.closed_form_q is None for entry in wall.per_record)
    assert "upper_floor" not in [reason.code for reason in wall.assessment.verdict.reasons]
    assert "other_building" in looked_at(result) and "base_z_m" in wall.assessment.unasked.keys


@pytest.mark.shows("mechanics.floor_search")
def test_that_compatibility_is_that_of_the_ground_records(result):
    ground = run(case(0.0), base_dir=ROOT)
    assert np.array_equal(result.compliance.spectra, ground.compliance.spectra)
    assert result.compliance.rules == ground.compliance.rules
    assert [m.pga for m in result.motions] == [m.pga for m in ground.motions]


@pytest.mark.shows("kinematic.without_building")
def test_that_without_a_building_the_wall_is_undetermined_and_names_what_is_missing():
    verdict = run(case(6.0, None), base_dir=ROOT).walls[0].assessment.verdict
    assert verdict.code == "undetermined"
    words = verdict.text("en")
    assert all(key in words for key in ("height_m", "storeys", "period_s"))
    words = verdict.text("it", form=names_in("it"))  # the report has no keys
    assert words.endswith("indicare edificio (altezza, piani e, se noto, periodo).")


@pytest.mark.shows("kinematic.estimated_period")
def test_that_an_estimated_period_is_said():
    building = {"height_m": 9.0, "storeys": 3}
    found = run(case(6.0, building, records=1), base_dir=ROOT).walls[0]
    assert found.floor.estimated
    assert found.floor.modes[0].period == pytest.approx(1.5 * 0.05 * 9.0**0.75)


@pytest.mark.shows("kinematic.participation", "kinematic.damaged_building")
def test_the_damaged_building_of_each_limit_state():
    asked = case(6.0).building
    assert floors.modes_at(asked, 6.0, "SLV")[0] == floors.Mode(0.39, 0.10, 9.0 / 7.0 * 6.0 / 9.0)
    assert floors.modes_at(asked, 6.0, "SLD")[0].period == pytest.approx(0.26)
    assert floors.modes_at(asked, 6.0, "SLD")[0].damping == 0.05
    assert floors.period_and_damping_bounds(asked, "SLV") == floors.CORNERS[1:]


def test_that_given_modes_are_taken_as_they_are():
    modes = [
        {"period_s": 0.3, "damping": 0.1, "participation": 1.1},
        {"period_s": 0.1, "damping": 0.05, "participation": -0.2},
    ]
    building = {"height_m": 9.0, "storeys": 3, "modes": modes, "period_factor": 1.0}
    found = run(case(6.0, building, records=1), base_dir=ROOT).walls[0]
    assert [mode.participation for mode in found.floor.modes] == [1.1, -0.2]


def test_that_the_spectrum_of_the_code_is_compared_with_the_floor_motions(result):
    floor, mechanism = result.walls[0].floor, result.walls[0].assessment.kinematic
    assert floor.mean_spectrum.shape == floor.code_spectrum.shape == floors.CHART_PERIODS.shape
    ratio = floor.code_over_records(mechanism)
    inside = mechanism.period >= floors.CHART_PERIODS
    assert ratio == pytest.approx((floor.code_spectrum / floor.mean_spectrum)[inside].min())
    assert result.walls[0].assessment.code_over_records == ratio


@pytest.mark.parametrize(
    "building, code",
    [
        ({"height_m": 5.0, "storeys": 2, "period_s": 0.2}, "base_above_building"),
        ({"height_m": 9.0, "period_s": 0.2}, "missing"),
        ({"height_m": 9.0, "storeys": 3, "period_s": -1.0}, "not_accepted"),
        ({**BUILDING, "modes": [{"period_s": 0.3, "damping": 0.1, "participation": 1.0}]}, "modes_or_period"),
        ({**BUILDING, "storys": 3}, "unknown_key_near"),
    ],
)
def test_that_a_wrong_building_is_refused(building, code):
    with pytest.raises(InputError) as caught:
        case(6.0, building)
    assert caught.value.code == code


def test_that_demand_scaling_is_of_the_record_of_the_ground():
    found = run(case(6.0, records=1, demand={"ag_g": 0.26, "soil_factor": 1.2, "demand_scaling": "pga"}), base_dir=ROOT)
    wall, motion = found.walls[0], found.motions[0]
    factors = {abs(entry.factor) for entry in wall.assessment.dynamic.runs}
    assert factors == {found.demand.pga / motion.pga}


@pytest.mark.shows("kinematic.at_height", "kinematic.displacement_at_height")
def test_that_no_demand_of_the_floor_is_below_that_of_the_ground():
    """The spectra of the floor go to zero with its height: a wall a centimetre up had zeta 324."""
    building = {"height_m": 30.0, "storeys": 8, "period_s": 0.8}
    for free in (True, False):
        keys = {"height_m": 1.0, "thickness_m": 0.2, "unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 600.0} | (
            {} if free else BOUND
        )
        found = []
        for z in (0.0, 0.01, 1.0, 3.0):
            wall = parse_case({"wall": [{**WALL, **keys, "base_z_m": z}], "building": building, "demand": DEMAND})
            found.append(run(wall, base_dir=ROOT).walls[0].assessment)
        zetas = np.array([[check.zeta for check in one.checks] for one in found])
        assert np.all(zetas <= zetas[0] + 1e-12)


def test_that_the_search_is_on_the_floor_without_a_demand_too(result):
    made = case(6.0)
    alone = run(replace(made, demand=None), base_dir=ROOT).walls[0]
    assert [run.ida.q for run in alone.runs] == [run.ida.q for run in result.walls[0].runs]
    assert alone.assessment is None and alone.floor.spectrum is None


def test_that_modes_hold_for_one_height():
    modes = [{"period_s": 0.3, "damping": 0.1, "participation": 1.1}]
    walls = [{**WALL, "base_z_m": 6.0}, {**WALL, "name": "other", "base_z_m": 9.0}]
    with pytest.raises(InputError) as caught:
        parse_case({"wall": walls, "building": {"height_m": 9.0, "storeys": 3, "modes": modes}})
    assert caught.value.code == "modes_at_one_height"


def test_that_records_are_compared_at_the_demand():
    """With demand_scaling = "pga" the mean spectrum is of the scaled records."""
    found = {}
    for scaling in ("as_given", "pga"):
        demand = {**DEMAND, "demand_scaling": scaling}
        made = run(case(6.0, records=1, demand=demand), base_dir=ROOT)
        found[scaling] = made.walls[0].floor.mean_spectrum
    factor = made.demand.pga / made.motions[0].pga
    assert found["pga"] == pytest.approx(factor * found["as_given"])


def test_the_other_ends_of_what_the_clause_allows():
    def ends(state, **given):
        return floors.period_and_damping_bounds(case(6.0, {**BUILDING, **given}).building, state)

    assert ends("SLV") == ((1.5, 0.2), (2.0, 0.1), (2.0, 0.2))
    assert ends("SLC", period_factor=2.0, damping=0.2) == ((1.5, 0.1), (1.5, 0.2), (2.0, 0.1))
    # between or beyond them all corners are looked at: more damping than the clause has lowers the demand
    assert ends("SLV", period_factor=1.9, damping=0.3) == floors.CORNERS
    # at SLD the building is not damaged
    assert ends("SLD") == ()
    assert ends("SLD", damping=0.3) == (floors.DEFAULTS["SLD"],)


@pytest.mark.parametrize(
    "building, codes",
    [
        (BUILDING, []),
        ({**BUILDING, "storeys": 1}, ["odd_storeys"]),
        ({**BUILDING, "period_s": 5.0}, ["odd_building_period"]),
        (
            {"height_m": 9.0, "storeys": 3, "modes": [{"period_s": 3.0, "damping": 0.1, "participation": 0.9}]},
            ["odd_building_period"],
        ),
        ({**BUILDING, "period_factor": 1.0}, ["stiff_building"]),
        ({**BUILDING, "damping": 0.05}, ["stiff_building"]),
    ],
)
def test_that_an_odd_building_is_questioned(building, codes):
    notes = floors.building_notes(case(6.0, building).building, "SLV")
    assert [note.code for note in notes] == codes
    assert floors.building_notes(case(6.0, building).building, "SLD")[:1] == [
        note for note in notes[:1] if note.code != "stiff_building"
    ]


def test_that_a_wall_at_rest_is_told_the_acceleration_of_its_floor():
    keys = {"height_m": 1.0, "thickness_m": 0.35, "mechanism": "two_sided"} | BOUND
    wall = parse_case(
        {
            **{key: value for key, value in TABLE.items() if key != "record"},
            "wall": [{**WALL, **keys, "base_z_m": 6.0}],
            "building": BUILDING,
            "demand": {**DEMAND, "ag_g": 0.01},
            "analysis": {"histories": False},
        }
    )
    found = run(wall, base_dir=ROOT)
    verdict = found.walls[0].assessment.verdict
    assert verdict.code == "not_activated" and "floor" in verdict.text("en")
    said, of_the_ground = dict(verdict.values)["demand"], 1.35 * found.demand.pga / 9.80665
    assert said >= 1.35 * found.walls[0].assessment.kinematic.floor.a_z / 9.80665 > 1.2 * of_the_ground


def test_that_a_floor_at_the_ground_is_the_ground():
    motion = GroundMotion("a", np.sin(np.arange(200) * 0.1), 0.01)
    modes = floors.modes_at(case(6.0).building, 0.0, "SLV")
    assert modes[0].participation == 0.0
    assert floors.floor_motion(motion, modes) is motion
    assert math.isclose(motion.pga, 1.0, rel_tol=1e-3)
