"""What of the demand and of the building raises zeta: the rows that are asked about, and their other ends."""

import pytest

from core.codes.kinematic import Check
from core.study.run import run
from core.units import G
from core.variation.favourable_site import favourable_building, favourable_demand
from tests.clauses_alone import parse_case
from tests.core.variation.one_evaluation import NTC, SOIL, WALL, scene_of
from tests.holds import shown

CHECK = Check("nonlinear", "C8.7.1.2.1.8", "m", 0.1, 0.1, 1.0, True)


AT_975 = [{"return_period_years": 475.0, "ag_g": 0.075}, {"return_period_years": 975.0, "ag_g": 0.1}]


def rows_of(demand, wall=WALL):
    """(key -> row of what is required, the scene) of a demand."""
    scene = scene_of(wall, demand)
    return {row.key: row for row in favourable_demand(scene)}, scene


def there(row, scene, k=0):
    """The demand at an end of a row."""
    return row.ends[k].change(scene).demand


def values(row, zetas):
    return dict(row.phrase(zetas, CHECK).values)


# what is required


@pytest.mark.shows("lifts.site")
@pytest.mark.parametrize(
    "years, reasons, reason",
    [
        ({}, {}, ""),
        ({"return_period_years": 975.0}, {}, ""),
        ({"return_period_years": 975.0, "hazard": AT_975}, {}, "T_R 975"),
        ({"nominal_life_years": 50.0, "use_class_factor": 1.0, "hazard": AT_975}, {}, "T_R 975"),
        ({"nominal_life_years": 50.0, "use_class_factor": 1.0}, {}, ""),
        (
            {"return_period_years": 975.0},
            {"limit_state": "works for SLC, report 12/2024"},
            "works for SLC, report 12/2024",
        ),
        ({}, {"limit_state": "works for SLC, report 12/2024"}, "works for SLC, report 12/2024"),
        ({"return_period_years": 975.0}, {"soil_factor": "downhole test, report 3/2023"}, ""),
    ],
)
def test_that_slc_is_founded_by_the_hazard_at_its_return_period_or_by_the_words_of_the_engineer(years, reasons, reason):
    """P_VR 5 % in 50 years: T_R 975."""
    rows, scene = rows_of(SOIL | {"limit_state": "SLC", **years, **({"evidence": shown(**reasons)} if reasons else {})})
    row = rows["limit_state"]
    reference = row.reason and dict(row.reason.values)["more"]
    assert (reference, row.value, there(row, scene).limit_state) == (reason, "SLC", "SLV")
    assert "limit_state" not in rows_of(SOIL | {"limit_state": "SLD"})[0] and "limit_state" not in rows_of(SOIL)[0]


@pytest.mark.shows("lifts.site")
def test_that_a_zeta_required_below_1_and_a_soil_factor_below_1_are_shown_with_1():
    rows, scene = rows_of(SOIL | {"zeta_target": 0.99, "soil_factor": 0.99})
    assert rows["zeta_target"].value == 0.99 and there(rows["zeta_target"], scene).zeta_target == 1.0
    rock = there(rows["soil_factor"], scene)
    assert rows["soil_factor"].value == 0.99 and rock.soil_factor == 1.0
    assert rock.pga == rock.ag == pytest.approx(0.1 * G) and scene.demand.pga == pytest.approx(0.099 * G)
    assert not rows_of(SOIL)[0] and not rows_of(SOIL | {"soil_factor": 1.2})[0]
    assert not rows_of({"ag_g": 0.1, "spectrum": NTC})[0]


@pytest.mark.shows("lifts.site")
@pytest.mark.parametrize("state, years", [("SLV", 474.56), ("SLC", 974.79)])
def test_that_a_short_reference_period_is_shown_with_a_g_of_fifty_years_by_the_hazard(state, years):
    """a_g = 0.03 (T_R / 30)^0.5, a straight line in the logarithms: T_R = -50 / ln(1 - P_VR)."""
    hazard = [{"return_period_years": t, "ag_g": 0.03 * (t / 30.0) ** 0.5} for t in (30.0, 300.0, 2475.0)]
    ag = {"SLV": 332.2, "SLC": 682.4}[state]
    demand = {"ag_g": round(0.03 * (ag / 30.0) ** 0.5, 5), "soil_factor": 1.2, "limit_state": state}
    demand |= {"nominal_life_years": 50.0, "use_class_factor": 0.7, "hazard": hazard}
    rows, scene = rows_of(demand)
    row, ordinary = rows["nominal_life_years"], 0.03 * (years / 30.0) ** 0.5
    assert there(row, scene).ag == pytest.approx(ordinary * G, rel=1e-4)
    assert there(row, scene).pga == pytest.approx(1.2 * ordinary * G, rel=1e-4)
    said = values(row, [0.8])
    assert (said["years"], said["least"]) == (35.0, 50.0) and said["ag"] == pytest.approx(ordinary, rel=1e-4)
    shown = dict(row.value.values), dict(row.ends[0].value.values)
    assert shown == ({"years": 35.0}, {"years": 50.0})


@pytest.mark.parametrize("years, said", [(49.9, True), (50.0, False), (50.1, False), (None, False)])
def test_that_a_reference_period_of_ordinary_works_has_no_row(years, said):
    hazard = [{"return_period_years": t, "ag_g": ag} for t, ag in ((30.0, 0.0999), (2475.0, 0.1001))]
    life = {} if years is None else {"nominal_life_years": years, "use_class_factor": 1.0}
    assert ("nominal_life_years" in rows_of(SOIL | life | {"hazard": hazard})[0]) == said
    assert "nominal_life_years" not in rows_of(SOIL | life)[0]


@pytest.mark.shows("lifts.site")
@pytest.mark.parametrize(
    "key, given, most",
    [
        ("f0", 2.2021 * 0.9989, 3.27),
        ("f0", 2.2021 * (1.0 - 1e-3), None),
        ("f0", 2.2021, None),
        ("f0", 2.203, None),
        ("tc_star_s", 0.095464 * 0.9989, 0.60122),
        ("tc_star_s", 0.0954642 * 0.9991, None),
        ("tc_star_s", 0.0955, None),
    ],
)
def test_that_f0_and_tc_star_a_thousandth_below_those_of_italy_are_shown_with_its_largest(key, given, most):
    """F_0 2.2021 to 3.27 and T_C* 0.095464 to 0.60122 s, read from Annexes A and B of NTC 2018."""
    rows, scene = rows_of({"ag_g": 0.1, "spectrum": NTC | {key: given}})
    assert rows.keys() == ({key} if most else set())
    if most:
        found, own = there(rows[key], scene), there_of({key: most})
        assert found.target == own.target and found.pga == pytest.approx(own.pga)
        assert (found.ag, found.soil_factor) == pytest.approx((0.1 * G, own.soil_factor))
        assert found.intensity == pytest.approx(own.intensity) and found.spectrum_code == "NTC2018"


def there_of(spectrum):
    """The demand of this spectrum."""
    return scene_of(demand={"ag_g": 0.1, "spectrum": NTC | spectrum}).demand


HAZARD = [
    {"return_period_years": 30.0, "ag_g": 0.03, "f0": 2.4, "tc_star_s": 0.28},
    {"return_period_years": 475.0, "ag_g": 0.10, "f0": 2.45, "tc_star_s": 0.33},
    {"return_period_years": 2475.0, "ag_g": 0.19, "f0": 2.5, "tc_star_s": 0.36},
]
EUROPEAN = {"code": "EN1998", "type": 2, "soil": "B"}


@pytest.mark.shows("lifts.site")
def test_that_another_spectrum_than_that_of_ntc_is_shown_with_it_where_the_hazard_gives_it():
    asked = {"ag_g": 0.1, "return_period_years": 475.0, "hazard": HAZARD, "spectrum": EUROPEAN}
    rows, scene = rows_of(asked)
    found = there(rows["spectrum"], scene)
    assert found.target == there_of({}).target and found.spectrum_code == "NTC2018"
    assert rows["spectrum"].value == "EN 1998-1" and values(rows["spectrum"], [0.8])["soil"] == "B"
    for changes in (
        {"return_period_years": None},
        {"hazard": None},
        {"hazard": [{key: row[key] for key in ("return_period_years", "ag_g")} for row in HAZARD]},
        {"hazard": [row | {"f0": None} for row in HAZARD]},
        {"hazard": HAZARD[:2], "return_period_years": 975.0},
    ):
        other = {key: value for key, value in (asked | changes).items() if value is not None}
        if "hazard" in other:
            other["hazard"] = [{key: v for key, v in row.items() if v is not None} for row in other["hazard"]]
        rows, scene = rows_of(other)  # of type 2 without the hazard that of type 1
        assert there(rows["spectrum"], scene).target.name == "EN 1998-1 type 1, B"
        first = other | {"spectrum": EUROPEAN | {"type": 1}}
        assert "spectrum" not in rows_of(first)[0]


@pytest.mark.shows("lifts.site")
def test_that_a_spectrum_of_a_file_is_shown_with_that_of_rock(tmp_path):
    file = tmp_path / "soft.txt"
    file.write_text("0 0.1\n0.1 0.23\n0.2 0.23\n0.5 0.05\n4 0.01\n")
    rows, scene = rows_of(
        {"ag_g": 0.1, "return_period_years": 475.0, "hazard": HAZARD, "spectrum_file": str(file), "soil_factor": 1.0}
    )
    assert there(rows["spectrum"], scene).target == there_of({"soil": "A"}).target
    assert rows["spectrum"].value == str(file)


# the building


BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
HIGH = WALL | {"base_z_m": 3.0, "hinge_heights": "base"}
ESTIMATED = 0.05 * 9.0**0.75
MODES = [
    {"period_s": 0.26, "damping": 0.1, "participation": 0.5},
    {"period_s": 0.1, "damping": 0.08, "participation": -0.2},
]


def of_building(building, wall=HIGH, state="SLV"):
    """(key -> row, the scene) of a wall in a building."""
    scene = scene_of(wall, {"ag_g": 0.05, "spectrum": NTC, "limit_state": state}, building=building)
    return {row.key: row for row in favourable_building(scene, scene.building)}, scene


def buildings(row, scene):
    return [end.change(scene).building for end in row.ends]


@pytest.mark.shows("lifts.building")
@pytest.mark.parametrize(("over", "said"), [(1.0, False), (1.009, False), (1.011, True), (2.0, True), (0.5, True)])
def test_that_a_period_that_is_given_is_shown_with_that_of_the_formula(over, said):
    """T = 0.05 H^0.75; one within a hundredth of it is it."""
    rows, scene = of_building(BUILDING | {"period_s": over * ESTIMATED})
    assert ("period_s" in rows) == said
    if said:
        assert [one.period_s for one in buildings(rows["period_s"], scene)] == pytest.approx([ESTIMATED])
    modes = [{**MODES[0], "period_s": over * ESTIMATED}, {**MODES[1], "period_s": 0.4 * over * ESTIMATED}]
    by_modes, scene = of_building({"height_m": 9.0, "storeys": 3, "modes": modes})
    assert ("period_s" in by_modes) == said
    if said:
        (there,) = buildings(by_modes["period_s"], scene)
        assert [mode.period_s / ESTIMATED for mode in there.modes] == pytest.approx([1.0, 0.4])


@pytest.mark.shows("lifts.building")
@pytest.mark.parametrize(
    "given, state, ends, source",
    [
        ({}, "SLV", [(1.5, 0.2), (2.0, 0.1), (2.0, 0.2)], "default"),
        ({"period_factor": 1.5, "damping": 0.1}, "SLV", [(1.5, 0.2), (2.0, 0.1), (2.0, 0.2)], "given"),
        ({"damping": 0.2}, "SLV", [(1.5, 0.1), (2.0, 0.1), (2.0, 0.2)], "given"),
        ({"period_factor": 2.0}, "SLV", [(1.5, 0.1), (1.5, 0.2), (2.0, 0.2)], "given"),
        ({"period_factor": 1.7, "damping": 0.12}, "SLV", [(1.5, 0.1), (1.5, 0.2), (2.0, 0.1), (2.0, 0.2)], "given"),
        ({"damping": 0.1}, "SLD", [(1.0, 0.05)], "given"),
        ({}, "SLD", [], ""),
    ],
)
def test_that_a_damaged_building_is_shown_at_the_corners_of_what_the_clause_allows(given, state, ends, source):
    """C8.7.1.2.1.4: 1.5 to 2 times the elastic period, 10 to 20 % of damping; elastic at SLD."""
    rows, scene = of_building(BUILDING | given, state=state)
    if not ends:
        assert "building" not in rows
        return
    row = rows["building"]
    assert [(one.period_factor, one.damping) for one in buildings(row, scene)] == ends
    assert [tuple(dict(end.value.values).values()) for end in row.ends] == ends
    assert (row.source, row.permitted) == (source, False)
    for k, (factor, damping) in enumerate(ends):
        zetas = [1.0] * len(ends)
        zetas[k] = 0.7
        said = values(row, zetas)
        assert (said["factor"], said["damping"], said["zeta"].value) == (factor, damping, 0.7)
    said = values(row, [None] + [0.7] * (len(ends) - 1))
    assert (said["factor"], said["zeta"].value) == (ends[0][0], None)


def test_that_the_modes_of_a_building_take_the_damping_of_the_ends():
    rows, scene = of_building({"height_m": 9.0, "storeys": 3, "modes": MODES})
    there = buildings(rows["building"], scene)[-1]
    assert [mode.damping for mode in there.modes] == [0.2, 0.2] and (there.period_factor, there.damping) == (2.0, None)
    assert [mode.period_s for mode in there.modes] == [0.26, 0.1] and rows["building"].source == "given"


@pytest.mark.shows("lifts.participation")
@pytest.mark.parametrize(
    "share, said", [(0.4285, True), (-0.4285, True), (0.42858, False), (-0.42858, False), (1.2, False)]
)
def test_that_a_first_mode_that_takes_less_part_than_the_clause_says_is_shown_with_its_share(share, said):
    """C7.2.10: gamma = 3 n / (2 n + 1) = 9/7, psi = z / H = 3 / 9."""
    modes = [MODES[0] | {"participation": share}]
    rows, scene = of_building({"height_m": 9.0, "storeys": 3, "modes": modes})
    assert ("participation" in rows) == said
    if said:
        (there,) = buildings(rows["participation"], scene)
        assert [mode.participation for mode in there.modes] == pytest.approx([9.0 / 7.0 / 3.0])
        told = values(rows["participation"], [0.8])
        assert told["given"] == share and told["expected"] == pytest.approx(3.0 / 7.0)
    assert "participation" not in of_building(BUILDING)[0]


@pytest.mark.parametrize("share", [0.2, 3.0 / 7.0, 0.8])
def test_that_several_modes_are_shown_as_the_first_alone(share):
    """Two of one period and opposite signs gave a parapet the motion of the ground."""
    modes = [MODES[0] | {"participation": share}, MODES[0] | {"participation": -share}]
    rows, scene = of_building({"height_m": 9.0, "storeys": 3, "modes": modes})
    (there,) = buildings(rows["participation"], scene)
    assert [mode.participation for mode in there.modes] == pytest.approx([max(share, 3.0 / 7.0)])
    assert rows["participation"].phrase([0.8], None).code == "lift_modes"


@pytest.mark.shows("verdict.documents")
def test_that_the_spectrum_of_a_file_of_no_known_place_is_asked_about(tmp_path):
    """It falls with the square of the period from 0.15 s on, so that its displacement stays 3 mm: beside it stand
    those of NTC 2018 with the largest F_0 and T_C* of Italy."""
    periods = [0.02 * k for k in range(1, 201)]
    lines = [f"{t:.2f} {0.3 + 0.39 * min(t, 0.1) / 0.1 if t < 0.15 else 0.69 * (0.15 / t) ** 2:.6f}" for t in periods]
    (tmp_path / "sp.txt").write_text("T[s] Sa[g]\n" + "\n".join(lines), encoding="utf-8")
    demand = {"ag_g": 0.25, "soil_factor": 1.2, "spectrum_file": str(tmp_path / "sp.txt")}
    wall = {"name": "w", "height_m": 7.0, "thickness_m": 0.3, "base_z_m": 0.0, "mechanism": "one_sided"}
    wall |= {"hold": [{"kind": "contact", "to_m": 7.0, "evidence": {"kind": "survey", "reference": "R1"}}]}
    table = {"wall": [wall], "demand": demand, "analysis": {"histories": False}}
    found = run(parse_case(table), base_dir=tmp_path).walls[0].assessment.verdict
    assert found.code == "indicative" and "spectrum" in {row.key for row in found.assumptions if row.turns}
    table["demand"] = demand | {"evidence": shown(spectrum="site study, 3/2024")}
    assert run(parse_case(table), base_dir=tmp_path).walls[0].assessment.verdict.code == "verified_refined"
