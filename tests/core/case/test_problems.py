"""Everything that keeps a case from running, at once."""

from dataclasses import replace

from core.case.document import DemandEvidence
from core.case.hold import Hold
from core.case.loads import Load
from core.case.problems import _with_sizes, _without, find_problems, load_of
from core.case.reader import read_case
from core.case.schema import Case, Record
from core.case.site import Building, Demand, Spectrum
from core.case.wall import Wall
from core.errors import InputError, place
from tests.conftest import ROOT


def keys(case: Case) -> list[str | None]:
    return [error.key for error in find_problems(case)]


def test_that_a_case_that_runs_has_none():
    assert find_problems(read_case(ROOT / "resources" / "cases" / "building.toml")) == []


def test_that_each_value_that_is_missing_is_named_once():
    tie, sizes = Hold("tie", h_m="", out_kn_m=""), {"height_m": 4.0, "thickness_m": 0.4}
    wall = Wall("w", "", **sizes, load=(Load("vertical", None, 3.0),), hold=(tie,))
    case = Case(wall=(wall, Wall("v", "two_sided", height_m=3.0, thickness_m=0.3)), demand=Demand(""))
    found = find_problems(case)
    assert [(error.key, error.wall) for error in found if error.key == "base_z_m"] == [
        ("base_z_m", "w"),
        ("base_z_m", "v"),
    ]
    assert {"ag_g", "h_m", "kn_m", "out_kn_m"} <= set(keys(case))
    assert len({(error.code, error.key, error.wall, error.place) for error in found}) == len(found)


def test_that_sizes_still_to_be_given_hide_nothing_else_that_is_missing():
    load = (Load("vertical", None, 3.0),)
    for sizes in ({}, {"height_m": 4.0}, {"thickness_m": 0.4}, {"slenderness_deg": 5.0}):
        case = Case(wall=(Wall("w", "", load=load, **sizes),), demand=Demand(""))
        found = [(error.code, error.key) for error in find_problems(case)]
        assert [code for code, _ in found].count("one_geometry") == 1
        assert {"ag_g", "base_z_m"} <= {key for _, key in found}, (sizes, found)


def test_that_a_broken_rule_of_one_wall_hides_none_of_another():
    broken = Wall("a", "two_sided", height_m=4.0, thickness_m=0.4, slenderness_deg=5.0)
    rule = Wall("b", "two_sided", height_m=4.0, thickness_m=0.4, velocity_ratio=0.9, restitution="housner")
    found = find_problems(Case(wall=(broken, rule, Wall("c", "", height_m=4.0, thickness_m=0.4))))
    assert [(error.code, error.wall) for error in found] == [
        ("missing", "c"),
        ("one_geometry", "a"),
        ("velocity_ratio_user", "b"),
    ]


def test_that_sections_of_the_site_are_asked_for_too():
    demand = Demand("", spectrum=Spectrum("NTC2018", "", f0="", tc_star_s="", topography=""))
    case = replace(read_case(ROOT / "resources" / "cases" / "example.toml"), demand=demand, building=Building("", ""))
    assert {"ag_g", "soil", "f0", "tc_star_s", "topography", "height_m", "storeys"} <= set(keys(case))


def test_that_an_empty_case_asks_for_a_wall():
    assert [error.code for error in find_problems(Case())] == ["no_wall"]


def test_that_a_building_whose_height_is_empty_is_not_said_to_be_lower_than_a_wall():
    case = replace(read_case(ROOT / "resources" / "cases" / "building.toml"), building=Building("", 3))
    assert [(error.code, error.key) for error in find_problems(case)] == [("missing", "height_m")]


def test_that_a_strength_still_to_be_given_is_one_problem_and_no_other_is_made_of_it():
    """The strength that is assumed to look further gives a setback that no wall has: nobody gave it."""
    wall = Wall("w", "two_sided", height_m=3.0, thickness_m=0.4, base_z_m=0.0, unit_weight_kn_m3=18.0)
    of_tests = DemandEvidence("test", "flat jacks", of="confidence_factor")
    demand = Demand(0.2, soil_factor=1.2, confidence_factor=1.2, knowledge_level="LC2", evidence=(of_tests,))
    for variant in (None, "progetto"):
        tall = replace(wall, variant=variant, unloaded_confirmed=True, height_m=8.0, thickness_m=0.3)
        found = find_problems(Case(wall=(tall,), demand=demand))
        assert [error.code for error in found] == ["confidence_needs_strength"]
        assert "None" not in str(found[0])


def test_that_an_error_of_a_variant_says_its_wall_once():
    wall = Wall("w", "two_sided", height_m=3.0, thickness_m=0.4, variant="progetto")
    hold = (Hold("tie", h_m=2.5, out_kn_m=4.0),)
    for changed in (
        replace(wall, compressive_strength_mpa=2.0),
        replace(wall, hold=hold, unit_weight_kn_m3=18.0),
        replace(wall, hold=hold),
    ):
        found = [str(error) for error in find_problems(Case(wall=(changed,)))]
        assert found and all(words.count('wall "w') == 1 and '"w (progetto)"' in words for words in found), found


def test_that_a_wall_whose_weight_is_missing_is_not_said_to_be_unstable():
    """Under 2 kN/m outward at the top it is with the weight that is assumed, 1 kN/m3, and with 18 it is not."""
    wall = Wall("w", "two_sided", height_m=5.0, thickness_m=0.5, load=(Load("thrust", 2.0, 5.0),))
    (error,) = find_problems(Case(wall=(wall,)))
    assert "unit_weight_kn_m3" in error.keys
    assert find_problems(Case(wall=(replace(wall, unit_weight_kn_m3=18.0),))) == []


def test_that_of_a_size_that_is_missing_a_plausible_one_stands():
    """Ten times the thickness, at most 60 m."""
    heights = [_with_sizes(Wall("w", "one_sided", thickness_m=t)).height_m for t in (0.5, 2.0, 7.0)]
    assert heights == [5.0, 20.0, 60.0]


def test_that_an_error_within_a_load_is_of_that_load():
    for where in (place("section", name="[[load]] 3"), place("load", n=3)):
        assert load_of(InputError("missing", place=(where,))) == 2


def test_that_an_error_of_a_record_leaves_the_others():
    records = tuple(Record(f"{name}.txt") for name in "abc")
    error = InputError("no_record", place=(place("record", n=2),))
    assert _without(Case(record=records), error).record == (records[0], records[2])
