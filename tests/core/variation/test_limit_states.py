"""Demands of SLD, SLV and SLC by the hazard of the site."""

import math
from pathlib import Path

import pytest

from core.codes.kinematic import analyse_mechanism, check_displacement, check_sld
from core.errors import InputError
from core.setting.demand_input import read_demand
from core.study.run import run
from core.units import G
from core.variation.limit_states import interpolate_hazard, limit_state_demands, unused_hazard_notices
from tests.clauses_alone import parse_case
from tests.validation.test_loaded_walls import WALL

HAZARD = [
    {"return_period_years": 30.0, "ag_g": 0.08, "f0": 2.40, "tc_star_s": 0.28},
    {"return_period_years": 475.0, "ag_g": 0.26, "f0": 2.36, "tc_star_s": 0.35},
    {"return_period_years": 2475.0, "ag_g": 0.45, "f0": 2.42, "tc_star_s": 0.37},
]
NTC = {"code": "NTC2018", "soil": "C", "topography": "T1", "f0": 2.36, "tc_star_s": 0.35}


def site(**changes):
    demand = {"ag_g": 0.26, "nominal_life_years": 50.0, "use_class_factor": 1.0, "hazard": HAZARD, "spectrum": NTC}
    given = {**demand, **changes}
    return parse_case({"wall": [WALL], "demand": {k: v for k, v in given.items() if v not in (None, [])}})


def test_that_the_hazard_is_linear_in_logarithms_between_its_rows():
    """NTC 2018, Annex A, Eq. [2], by hand at T_R 50: w = ln(50/30)/ln(475/30)."""
    rows = site().demand.hazard
    share = math.log(50.0 / 30.0) / math.log(475.0 / 30.0)
    found = interpolate_hazard(rows, 50.0)
    assert found.ag_g == pytest.approx(0.08 ** (1.0 - share) * 0.26**share, rel=1e-12)
    assert found.f0 == pytest.approx(2.40 ** (1.0 - share) * 2.36**share, rel=1e-12)
    for row in rows:
        assert interpolate_hazard(rows, row.return_period_years).ag_g == pytest.approx(row.ag_g, rel=1e-12)


@pytest.mark.shows("risk.states")
def test_that_each_limit_state_has_its_return_period_and_its_own_check():
    case = site()
    demands = limit_state_demands(case, Path())
    assert [round(d.return_period) for d in demands.values()] == [50, 475, 975]
    result = run(case, base_dir=Path())
    assessment = result.walls[0].assessment
    found = assessment.states
    assert [one.state for one in found] == ["SLD", "SLV", "SLC"]
    # at the state of the demand it is the verdict itself
    assert (found[1].code, found[1].zeta) == (assessment.verdict.code, assessment.verdict.zeta_e)
    for one, demand in zip(found, demands.values(), strict=True):
        if one.state == "SLV":
            continue
        moved = analyse_mechanism(case.wall[0].in_si, "one_sided", demand)
        own = check_sld(moved, demand) if one.state == "SLD" else check_displacement(moved, demand)
        assert one.zeta == own.zeta and one.ag == demand.ag
    # the demand of the case itself is that of its own limit state, but for the rounding of T_R 474.6
    asked = read_demand(case, Path())
    assert demands["SLV"].ag == pytest.approx(asked.ag, rel=1e-3)
    assert found[1].zeta == pytest.approx(
        check_displacement(analyse_mechanism(case.wall[0].in_si, "one_sided", asked), asked).zeta, rel=3e-3
    )


def test_that_a_limit_state_outside_the_rows_has_none_and_is_said():
    case = site(hazard=HAZARD[:2], nominal_life_years=50.0)
    found = limit_state_demands(case, Path())
    assert list(found) == ["SLD", "SLV"]
    (words,) = unused_hazard_notices(read_demand(case, Path()), found)
    assert "SLC" in words.text("en")
    (words,) = unused_hazard_notices(read_demand(case, Path()), {})
    assert "V_N" in words.text("it")


@pytest.mark.shows("risk.hazard_agrees")
@pytest.mark.parametrize(
    ("key", "value", "refused"),
    [
        ("ag_g", 0.26, False),
        ("ag_g", 0.262, False),
        ("ag_g", 0.30, True),
        ("ag_g", 0.10, True),
        ("f0", 2.41, False),
        ("f0", 2.6, True),
        ("tc_star_s", 0.35, False),
        ("tc_star_s", 0.29, True),
    ],
)
def test_that_a_demand_that_contradicts_the_hazard_of_the_case_is_refused(key, value, refused):
    """Beyond the digits both are printed with."""
    hazard = [{**row, "f0": 2.41, "tc_star_s": 0.347} for row in HAZARD]
    spectrum = {"code": "NTC2018", "f0": 2.41, "tc_star_s": 0.347, "soil": "B", "topography": "T1"}
    changes = {"ag_g": 0.26, "hazard": hazard, "spectrum": spectrum}
    if key in spectrum:
        changes["spectrum"] = {**spectrum, key: value}
    else:
        changes[key] = value
    case = site(**changes)
    if not refused:
        read_demand(case, Path())
        return
    with pytest.raises(InputError) as caught:
        read_demand(case, Path())
    for language in ("en", "it"):
        text = caught.value.text(language)
        assert "SLV" in text and "475" in text and f"{value:g}".replace(".", ",") in text.replace(".", ",")


@pytest.mark.parametrize(("ag", "refused"), [(0.09, True), (0.229, False), (0.26, False), (0.4, False)])
def test_that_without_a_return_period_a_demand_below_the_shortest_of_the_state_is_refused(ag, refused):
    """T_R of SLV is 332 years for V_R = 35: log-linear between 30 and 475 years, a_g 0.228 g."""
    case = site(ag_g=ag, nominal_life_years=None, spectrum=None, soil_factor=1.2)
    if not refused:
        read_demand(case, Path())
        return
    with pytest.raises(InputError, match=r"0\.09 is below the 0\.22.* 332 years.* nominal_life_years"):
        read_demand(case, Path())


def test_that_a_scale_that_has_no_effect_is_refused():
    demand = {"ag_g": 0.2, "soil_factor": 1.2, "demand_scaling": "pga"}
    record = {"file": "r.txt", "scale": 1.3}
    with pytest.raises(InputError, match=r"1\.3 has no effect"):
        parse_case({"wall": [WALL], "record": [record], "demand": demand})


@pytest.mark.parametrize(
    "changes",
    [
        {"hazard": []},
        {"nominal_life_years": None},
        {"use_class_factor": None},
        {"hazard": [{k: row[k] for k in ("return_period_years", "ag_g")} for row in HAZARD]},
    ],
)
def test_that_without_what_it_takes_there_is_none(changes):
    assert limit_state_demands(site(**changes), Path()) == {}


def test_that_a_file_of_the_hazard_is_the_same_as_its_rows(tmp_path):
    lines = [" ".join(str(value) for value in row.values()) for row in HAZARD]
    (tmp_path / "site.txt").write_text("\n".join(lines))
    given = limit_state_demands(site(), Path())
    read = limit_state_demands(
        parse_case(
            {
                "wall": [WALL],
                "demand": {
                    "ag_g": 0.26,
                    "nominal_life_years": 50.0,
                    "use_class_factor": 1.0,
                    "hazard_file": "site.txt",
                    "spectrum": NTC,
                },
            }
        ),
        tmp_path,
    )
    assert {state: d.ag / G for state, d in read.items()} == {state: d.ag / G for state, d in given.items()}


@pytest.mark.shows("risk.states")
def test_that_a_state_asked_for_has_its_time_histories(tmp_path):
    """Under the motions of the case times the ratio of the peaks; at SLD the clause has no rule for them."""
    wall = {key: value for key, value in WALL.items() if key != "velocity_ratio"}
    demand = {
        "ag_g": 0.26,
        "nominal_life_years": 50.0,
        "use_class_factor": 1.0,
        "hazard": HAZARD,
        "spectrum": NTC,
        "limit_states": ["SLC", "SLD"],
    }
    table = {"wall": [wall], "generate": {"scatter": 0.0, "count": 3}, "analysis": {"q_step": 0.05}, "demand": demand}
    found = {state.state: state for state in run(parse_case(table), base_dir=tmp_path).walls[0].assessment.states}
    assert found["SLC"].check == "dynamic" and found["SLC"].zeta is not None
    assert found["SLD"].check == "linear_sld" and found["SLV"].check == "dynamic"
    del demand["limit_states"]
    without = run(parse_case(table), base_dir=tmp_path).walls[0].assessment
    plain = {state.state: state for state in without.states}
    assert plain["SLC"].check == "nonlinear"
    # at the state of the demand it is the verdict itself
    assert plain["SLV"].checks == without.checks and plain["SLV"].code == without.verdict.code
