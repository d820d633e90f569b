"""The case file: every rule refuses in one sentence that names place, value and what is accepted."""

import pytest

from core.case.reader import read_case
from core.case.rules import parse_case, parse_draft, parse_wall
from core.case.schema import Wall
from core.case.select import Select
from core.case.sensitivity import Ranges
from core.case.site import Demand
from core.case.solids import Solid
from core.case.values import check_value, parse_corners
from core.errors import InputError
from tests.core.case.tables import WALL, case, without
from tests.holds import shown

TESTED = {
    "ag_g": 0.2,
    "confidence_factor": 1.2,
    "knowledge_level": "LC2",
    "evidence": shown(confidence_factor="cores, double flat jacks"),
}
CHOSEN = {"demand": {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}}
SCALED = {"demand": {**CHOSEN["demand"], "demand_scaling": "pga"}}
STRENGTH = {"compressive_strength_mpa": 2.0, "unit_weight_kn_m3": 18.0}


@pytest.mark.shows("kinematic.knowledge", "case.refused", "case.never_guessed")
@pytest.mark.parametrize(
    "table, words",
    [
        ({}, ["no [[wall]]"]),
        ({"wall": []}, ["no [[wall]]"]),
        ({"wall": WALL}, ["[[wall]]"]),
        ({"wall": ["x"]}, ["table"]),
        (without("mechanism"), ["mechanism", "required", "one_sided"]),
        (without("name"), ["name", "required"]),
        (case({"mechanism": "sideways"}), ["sideways", "two_sided"]),
        (case({"heigth_m": 3}), ["heigth_m", "height_m?"]),
        (case({"height_m": float("nan")}), ["height_m", "nan", "0.1 to 60 m"]),
        (case({"height_m": float("inf")}), ["height_m", "60"]),
        (case({"height_m": 10**400}), ["height_m", "60"]),
        (case(analysis={"q_step": 0.1, "robust_window": 0.01}), ["narrower than one step"]),
        (case({"height_m": -7.0}), ["height_m = -7.0", "0.1"]),
        (case({"height_m": "7"}), ["height_m = '7'"]),
        (case({"height_m": True}), ["height_m"]),
        (case({"slenderness_deg": 6.8}), ["exactly one", "thickness_m, slenderness_deg"]),
        (without("thickness_m"), ["exactly one", "none"]),
        (without("height_m"), ["height_m missing"]),
        (case({"radius_m": 3.0}), ["general block"]),
        (without("height_m", "thickness_m", radius_m=3.0, slenderness_deg=7.0), ["inertia"]),
        (case({"restitution": "bouncy"}), ["bouncy", "housner"]),
        (case({"restitution": "user"}), ["velocity_ratio"]),
        (case({"restitution": "housner", "velocity_ratio": 0.9}), ["velocity_ratio"]),
        (case({"velocity_ratio": 1.2}), ["velocity_ratio", "0 to 1"]),
        (case({"restitution": "one_sided_theoretical"}), ["one_sided"]),
        (case({"law": {"elastic_limit": 1e-9, "plateau_end": 0.28}}), ["0.001 <="]),
        (case({"slenderness_deg": 59.0, "thickness_m": None}), ["thickness_m = None"]),
        (without("thickness_m", slenderness_deg=59.0), ['wall "w"', "too stocky"]),
        (case({"law": "quadrilinear"}), ["quadrilinear", "doherty"]),
        (case({"law": {"elastic_limit": 0.3, "plateau_end": 0.2}}), ["elastic_limit <="]),
        (case({"law": {"elastic_limit": 0.3}}), ["plateau_end"]),
        (case({"name": "a\u0007b"}), ["control characters"]),
        (case({"name": "x" * 600}), ["500"]),
        (case({"hinge_setback_m": 0.5}), ["hinge setback 0.500 m", "40 %"]),
        (case({"compressive_strength_mpa": 2.0}), ["compressive_strength_mpa", "unit_weight"]),
        (
            {
                "wall": [
                    {
                        "name": "w",
                        "radius_m": 3.5,
                        "slenderness_deg": 6.8,
                        "inertia_over_mass_m2": 16.5,
                        "mechanism": "two_sided",
                        "hinge_setback_m": 0.3,
                    }
                ]
            },
            ["general block accepts neither"],
        ),
        (
            without("thickness_m", "height_m", slenderness_deg=5.0, radius_m=3.0, inertia_over_mass_m2=400.0),
            ["inertia_over_mass_m2 400", "up to 18"],
        ),
        (case(record=[{"file": "a.txt", "channel": 0}]), ["channel", "name of a channel, or its number"]),
        (case(generate={"scatter": 0.0, "count": 7}), ["generate", "spectrum"]),
        (case(select={"folder": "x"}), ["[select]", "spectrum of the demand"]),
        (case(select={"count": 7}, **CHOSEN), ["folder", "required"]),
        (case(select={"folder": "x", "count": 31}, **CHOSEN), ["count", "1 to 30"]),
        (case(select={"folder": "x", "scale_limits": [2.0, 0.5]}, **CHOSEN), ["scale_limits", "two rising numbers"]),
        (case(select={"folder": "x"}, generate={"scatter": 0.0, "count": 7}, **CHOSEN), ["[select]", "as a whole"]),
        (case(select={"folder": "x"}, record=[{"file": "a.txt"}], **CHOSEN), ["[select]", "as a whole"]),
        (case(select={"folder": "x"}, **SCALED), ["[select]", "demand_scaling"]),
        (case({"law": "doherty"}, analysis={"method": "linearised"}), ["rigid law", "trilinear"]),
        (case(analysis={"method": "magic"}), ["magic", "taylor"]),
        (case(analysis={"q_step": 0.0}), ["q_step", "0.0001"]),
        (case(analysis={"q_stepp": 0.01}), ["q_step?"]),
        (case(analysis={"polarity": "none"}), ["polarity"]),
        (case(demand={"soil_factor": 1.2}), ["ag_g", "required"]),
        (case(demand={"ag_g": 0.0}), ["ag_g = 0.0", "from 0.001 to 5 g"]),
        (
            case(demand={"ag_g": 0.2, "confidence_factor": 1.2}),
            ["confidence_factor", "knowledge_level", "evidence", "1.35"],
        ),
        (case(demand={"ag_g": 0.2, "investigations": "flat jacks"}), ["investigations", 'of = "confidence_factor"']),
        (case({"hinge_setback_m": 0.000001}, demand=TESTED), ["compressive_strength_mpa", "0.5 to 10"]),
        (case({**STRENGTH, "compressive_strength_mpa": 50.0}, demand=TESTED), ["0.5 to 10", "50"]),
        (case(STRENGTH, demand={**TESTED, "confidence_factor": 1.0}), ["LC2", "1.20"]),
        (case({"hold": [{"kind": "x."}]}), ["hold", "kind", "cross_walls"]),
        (case({"back_restraint": "cross_walls"}), ["back_restraint", "hold = [{ kind"]),
        (case(STRENGTH, demand={key: TESTED[key] for key in TESTED if key != "evidence"}), ["evidence"]),
        (case(demand={"ag_g": 0.2, "soil_factor": 0.5}), ["soil_factor = 0.5", "from 0.9"]),
        (case({"evidence": shown(restitution=" ")}), ["restitution", "reference"]),
        (case({"evidence": shown(law="a") * 2}), ["law", "two documents"]),
        (case({"evidence": [{"of": "law", "kind": "photograph", "reference": "7"}]}), ["photograph", "law", "test"]),
        (case(demand={"ag_g": 0.2, "justification": {"q_code": "12"}}), ["[demand]", 'of = "q_code"']),
        (case({"justification": {"mass": "seen"}}), ["justification", 'of = "mass"', 'reference = "seen"']),
        (case({"evidence": shown(thickness_m="so")}), ["thickness_m", "velocity_ratio"]),
        (case(demand={"ag_g": 0.2, "spectrum": {"code": "NTC2018", "soil": "B"}}), ["needs f0"]),
        (
            case(demand={"ag_g": 0.2, "spectrum": {"code": "EN1998", "soil": "B", "type": 1, "f0": 2.5}}),
            ["does not take f0"],
        ),
        (
            case(demand={"ag_g": 0.2, "soil_factor": 1.2, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}),
            ["soil_factor follows"],
        ),
        (case(analysis={"accuracy": 1}), ["accuracy", "true or false"]),
        (case(demand=0.2), ["[demand] must be a table"]),
        (case(record=[{"file": "a.txt", "unit": "knots"}]), ["knots", "m/s2"]),
        (case(record=[{"unit": "g"}]), ["file", "required"]),
        (case(record=[{"file": "a.txt", "scale": 0.0}]), ["scale = 0"]),
        (case(record=[{"file": "a.txt", "column": 1.5}]), ["column", "whole number"]),
        (case(report={"language": "de"}), ["language", "en, it"]),
        (case(colour="red"), ["colour"]),
        ({"wall": [WALL, WALL]}, ["same name"]),
    ],
)
def test_that_a_wrong_case_is_refused_in_one_sentence(table, words):
    with pytest.raises(InputError) as caught:
        parse_case(table)
    for word in words:
        assert word in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.shows("case.never_guessed")
def test_that_the_height_of_the_base_is_never_guessed(tmp_path):
    bare = {k: v for k, v in WALL.items() if k != "base_z_m"}
    assert parse_case({"wall": [bare]}).wall[0].base_z_m is None
    with pytest.raises(InputError, match=r'wall "w": base_z_m is missing.*0 m for a wall on the ground'):
        parse_case({"wall": [bare], "demand": {"ag_g": 0.2}})
    (tmp_path / "walls.csv").write_text("Parete;z;H;t;Meccanismo\n;m;m;m;\na;0;4;0.5;entrambi\nb;;4;0.5;entrambi\n")
    path = tmp_path / "case.toml"
    path.write_text('walls = "walls.csv"\n[demand]\nag_g = 0.2\n')
    with pytest.raises(InputError, match="walls.csv: row 4, z: base_z_m is missing"):
        read_case(path)
    path.write_text('walls = "walls.csv"\n')
    assert [wall.base_z_m for wall in read_case(path).wall] == [0.0, None]


@pytest.mark.shows("demand.return_period")
@pytest.mark.parametrize(
    ("demand", "words"),
    [
        # V_R = 50 years: SLV 474.6, SLC 974.8 (NTC 2018 3.2.0)
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "return_period_years": 975}, "give 475 years at SLV"),
        ({"limit_state": "SLC", "return_period_years": 475}, "below the 682 years of SLC"),
        ({"limit_state": "SLC", "return_period_years": 500}, "below the 682 years of SLC"),
        ({"limit_state": "SLC", "return_period_years": 712}, "is that of SLV for V_R = 75 years"),
        ({"return_period_years": 50}, "below the 332 years of SLV"),
        ({"period_range_s": [2.0, 0.15]}, "period_range_s"),
        ({"period_range_s": [0.15]}, "two periods"),
        ({"confidence_on": "strength"}, "one of capacity, demand"),
    ],
)
def test_that_a_demand_that_contradicts_itself_is_refused(demand, words):
    with pytest.raises(InputError, match=words):
        parse_case(case(demand={"ag_g": 0.2, **demand}))


@pytest.mark.parametrize("k", [1, 2, 3])
def test_that_the_load_that_is_named_is_the_one_that_is_wrong(k):
    loads = [{"kind": "vertical", "kn_m": 2.0, "h_m": 2.0, "d_m": 0.2} for _ in range(3)]
    loads[k - 1]["kn_m"] = "two"
    wall = {"name": "w", "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.4, "unit_weight_kn_m3": 18.0}
    with pytest.raises(InputError) as refused:
        parse_wall(wall | {"load": loads})
    assert f"[[load]] {k}:" in str(refused.value)


MODE = {"period_s": 0.3, "damping": 0.05, "participation": 1.2}
STOREYS = {"height_m": 12.0, "storeys": 3, "modes": [MODE]}


def test_that_modes_state_the_period_and_the_damping_of_the_building():
    assert len(parse_case(case(building=STOREYS)).building.modes) == 1
    for more in ({"period_s": 0.4}, {"damping": 0.1}, {"period_s": 0.4, "damping": 0.1}):
        with pytest.raises(InputError, match="the modes state their period and damping"):
            parse_case(case(building=STOREYS | more))
        without_modes = {key: value for key, value in STOREYS.items() if key != "modes"}
        assert parse_case(case(building=without_modes | more)).building.modes == ()


def test_that_a_draft_keeps_what_is_not_complete_and_has_no_section_that_is_not_there():
    draft = parse_draft({"demand": {"limit_state": "SLC"}, "building": {"storeys": 3}, "report": {"client": "Comune"}})
    assert (draft.demand.ag_g, draft.demand.limit_state) == ("", "SLC")
    assert (draft.building.height_m, draft.building.storeys, draft.report.client) == ("", 3, "Comune")
    assert (draft.generate, draft.select, draft.site, draft.sensitivity, draft.wall) == (None, None, None, None, ())


PAIRS = {
    "periods": (Demand, "period_range_s", (0.02, 10.0), (0.019, 10.1)),
    "factors": (Ranges, "ag_factor", (0.1, 10.0), (0.09, 10.1)),
    "added lengths": (Ranges, "setback_m", (0.0, 0.3), (-0.01, 0.31)),
    "limits": (Select, "scale_limits", (0.01, 100.0), (0.009, 101.0)),
}


@pytest.mark.parametrize("kind", PAIRS)
def test_that_a_pair_is_two_numbers_within_its_range_the_lower_first(kind):
    section, key, widest, beyond = PAIRS[kind]
    low, high = widest
    assert check_value(section, key, [low, high]) == check_value(section, key, (low, high)) == widest
    wrong = [[low], [low, high, high], [high, low], [low, "1"], [low, True], [beyond[0], high], [low, beyond[1]]]
    for value in (*wrong, low, "", None, []):
        with pytest.raises(InputError) as refused:
            check_value(section, key, value)
        assert refused.value.code == "not_accepted"


def test_that_a_text_is_empty_only_where_it_may_be_left_out():
    assert check_value(Wall, "notes", "") == "" and check_value(Wall, "name", "w") == "w"
    assert check_value(Wall, "notes", "x" * 500) == "x" * 500
    for key, value in (("name", ""), ("notes", "x" * 501)):
        with pytest.raises(InputError) as refused:
            check_value(Wall, key, value)
        assert refused.value.code == "not_accepted"


TRIANGLE = [[0.0, 0.0], [3, 0], [0, 4.5]]


def test_that_a_corner_is_two_numbers():
    assert check_value(Solid, "polygon_m", TRIANGLE) == ((0.0, 0.0), (3.0, 0.0), (0.0, 4.5))
    assert check_value(Solid, "polygon_m", "0 0; 3 0; 0 4,5") == ((0.0, 0.0), (3.0, 0.0), (0.0, 4.5))
    for corner in ([0], [0, 1, 2], [0, "1"], [0, True], [0, None], 5, "01", None):
        assert parse_corners([*TRIANGLE, corner]) is None
        with pytest.raises(InputError, match="polygon_m = .* is not accepted"):
            check_value(Solid, "polygon_m", [*TRIANGLE, corner])
    assert parse_corners("0 0; 3 0 1; 0 4") is None and parse_corners("0 0; 3; 0 4") is None


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("0 0; 1 1; 1 0; 0 1", ((0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0))),
        ([[0, 0], [2, 1]], ((0.0, 0.0), (2.0, 1.0))),
        ("1e9 0; 0 1; 1 1", ((1e9, 0.0), (0.0, 1.0), (1.0, 1.0))),
    ],
)
def test_that_a_draft_keeps_corners_that_break_a_rule(given, kept):
    """Work in progress: an outline that crosses itself, two corners of it, one far away."""
    solid = {"plane": "section", "polygon_m": given}
    made = parse_draft({"wall": [{"name": "w", "mechanism": "one_sided", "solid": [solid]}]})
    assert made.wall[0].solid[0].polygon_m == kept
