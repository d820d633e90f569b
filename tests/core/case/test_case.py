"""The case file: every rule refuses in one sentence that names place, value and what is accepted."""

import tomllib
from dataclasses import replace

import pytest

from core.case.reader import read_case
from core.case.rules import draft_case, parse_case
from core.case.writer import dumps
from core.errors import InputError

WALL = {
    "name": "w",
    "height_m": 7.0,
    "thickness_m": 0.83,
    "base_z_m": 0.0,
    "mechanism": "two_sided",
}


def case(wall=(), **rest):
    return {"wall": [{**WALL, **dict(wall)}], **rest}


def without(*keys, **more):
    return {"wall": [{k: v for k, v in {**WALL, **more}.items() if k not in keys}]}


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
            ["general block takes no"],
        ),
        (case(record=[{"file": "a.txt", "channel": 2}]), ["channel", "not built yet"]),
        (case(generate={"count": 7}), ["generate", "spectrum"]),
        (case({"law": "doherty"}, analysis={"method": "linearised"}), ["rigid law", "trilinear"]),
        (case(analysis={"method": "magic"}), ["magic", "taylor"]),
        (case(analysis={"q_step": 0.0}), ["q_step", "0.0001"]),
        (case(analysis={"q_stepp": 0.01}), ["q_step?"]),
        (case(analysis={"polarity": "none"}), ["polarity"]),
        (case(demand={"soil_factor": 1.2}), ["ag_g", "required"]),
        (case(demand={"ag_g": 0.0}), ["ag_g = 0.0", "from 0.001 to 5 g"]),
        (
            case(demand={"ag_g": 0.2, "confidence_factor": 1.2}),
            ["confidence_factor", "setback", "1.35"],
        ),
        (case(demand={"ag_g": 0.2, "spectrum": {"code": "NTC2018", "soil": "B"}}), ["needs f0"]),
        (
            case(
                demand={
                    "ag_g": 0.2,
                    "spectrum": {"code": "EN1998", "soil": "B", "type": 1, "f0": 2.5},
                }
            ),
            ["does not take f0"],
        ),
        (
            case(
                demand={
                    "ag_g": 0.2,
                    "soil_factor": 1.2,
                    "spectrum": {"code": "EN1998", "soil": "B", "type": 1},
                }
            ),
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


def test_that_defaults_follow_the_mechanism():
    both = parse_case(case({"mechanism": "both"})).wall[0]
    assert both.mechanisms() == ("two_sided", "one_sided")
    assert both.restitution_of("two_sided").model == "housner"
    assert both.restitution_of("one_sided").model == "one_sided_theoretical"
    given = parse_case(case({"velocity_ratio": 0.9})).wall[0]
    assert given.restitution_of("two_sided").ratio_at_rest == 0.9


def test_that_three_ways_to_write_a_wall_are_one_block():
    import math

    ways = [
        {"thickness_m": 0.83},
        {"slenderness_deg": math.degrees(math.atan2(0.83, 7.0))},
        {"height_over_thickness": 7.0 / 0.83},
    ]
    blocks = [
        parse_case({"wall": [{**without("thickness_m")["wall"][0], **way}]}).wall[0].block()
        for way in ways
    ]
    for block in blocks[1:]:
        assert block.slenderness == pytest.approx(blocks[0].slenderness, rel=1e-14)
        assert block.radius == pytest.approx(blocks[0].radius, rel=1e-14)


def test_that_a_case_written_and_read_again_is_the_same():
    full = case(
        {"law": {"elastic_limit": 0.05, "plateau_end": 0.3}, "velocity_ratio": 0.91},
        title='a "quoted" = title',
        record=[{"file": "*.AT2"}, {"file": "b.txt", "unit": "g", "time_step_s": 0.01}],
        analysis={"q_step": 0.01, "polarity": "reversed"},
        demand={"ag_g": 0.1, "housner_intensity_cm": 50},
        report={"language": "it", "client": "=SUM(A1)"},
    )
    first = parse_case(full)
    again = parse_case(tomllib.loads(dumps(first)))
    assert again == first
    assert again.sha256 == first.sha256


def test_that_files_that_are_no_case_are_one_sentence(tmp_path):
    for name, content, word in (
        ("a.toml", b"[[wall\n", "not TOML"),
        ("b.toml", b"\xff\xfe\x00\x01", "not UTF-8"),
        ("c.toml", b"just words", "not TOML"),
        ("d.toml", b"x = " + b"[" * 5000, "not TOML"),
        ("e.toml", b"x = 1" + b"0" * 5000, "not TOML|unknown key"),
    ):
        path = tmp_path / name
        path.write_bytes(content)
        with pytest.raises(InputError, match=word) as caught:
            read_case(path)
        assert name in str(caught.value)
    with pytest.raises(InputError, match="no such case"):
        read_case(tmp_path / "nowhere.toml")
    with pytest.raises(InputError, match="not a file"):
        read_case(tmp_path)
    (tmp_path / "date.toml").write_text(
        '[report]\ndate = 2026-01-05\n[[wall]]\nname = "w"\nheight_m = 3.0\nthickness_m = 0.3\n'
        'mechanism = "both"\n'
    )
    assert read_case(tmp_path / "date.toml").report.date == "2026-01-05"


def test_that_every_shipped_case_can_be_read():
    from tests.conftest import ROOT

    shipped = sorted((ROOT / "resources" / "cases").glob("*.toml"))
    assert shipped
    for path in shipped:
        assert read_case(path).wall


COMMENTED = """\
# the palace, north wing
title = "Palazzo"   # as in the survey

[[wall]]
# measured twice
name = "facade"
height_m = 7.0  # to the cornice
thickness_m = 0.83
mechanism = "one_sided"
base_z_m = 0

[[wall]]
name = "gable"      # of the roof
height_m = 3
thickness_m = 0.3
mechanism = "two_sided"
base_z_m = 0

[demand]
# from the map
ag_g = 0.260
confidence_factor = 1.35    # no tests of the masonry
spectrum = { code = "NTC2018", f0 = 2.4, tc_star_s = 0.33, soil = "B", topography = "T1" }
"""


def test_that_comments_order_and_stated_defaults_of_a_file_stay():
    case = parse_case(tomllib.loads(COMMENTED))
    assert dumps(case, COMMENTED) == COMMENTED
    wall = replace(case.wall[0], height_m=6.5)
    text = dumps(replace(case, wall=(wall, case.wall[1])), COMMENTED)
    assert text == COMMENTED.replace("7.0  # to", "6.5  # to")
    text = dumps(replace(case, wall=(replace(case.wall[0], name="front"), case.wall[1])), COMMENTED)
    assert text == COMMENTED.replace('"facade"', '"front"')


def test_that_no_comment_comes_to_another_wall():
    """The comment above a [[wall]] is the end of the table before, for the parser."""
    above = COMMENTED.replace("[[wall]]\n# measured twice", "# measured twice\n[[wall]]")
    for text in (COMMENTED, above):
        case = parse_case(tomllib.loads(text))
        facade, gable = case.wall
        new = replace(gable, name="new")
        for walls in ((gable,), (facade, gable, new), (gable, new), (gable, facade), ()):
            changed = replace(case, wall=walls)
            found = dumps(changed, text)
            assert "#" not in found
            assert tomllib.loads(found).get("wall", []) == tomllib.loads(dumps(changed)).get(
                "wall", []
            )
        assert "#" not in dumps(replace(case, demand=None), text)


def test_that_walls_of_one_name_keep_their_comments():
    text = COMMENTED.replace("gable", "facade")
    case = draft_case(tomllib.loads(text))
    assert dumps(case, text) == text


def test_that_a_file_of_any_kind_before_changes_no_case():
    case = parse_case(tomllib.loads(COMMENTED))
    for before in (
        "",
        "not toml [",
        "x = 1\n",
        'wall = [{name = "facade"}]\n',
        "[wall]\n[demand.x]\n",
    ):
        assert parse_case(tomllib.loads(dumps(case, before))) == case


def test_that_the_height_of_the_base_is_never_guessed(tmp_path):
    bare = {k: v for k, v in WALL.items() if k != "base_z_m"}
    assert parse_case({"wall": [bare]}).wall[0].base_z_m is None
    with pytest.raises(
        InputError, match=r'wall "w": base_z_m is missing.*0 m for a wall on the ground'
    ):
        parse_case({"wall": [bare], "demand": {"ag_g": 0.2}})
    (tmp_path / "walls.csv").write_text(
        "Parete;z;H;t;Meccanismo\n;m;m;m;\na;0;4;0.5;entrambi\nb;;4;0.5;entrambi\n"
    )
    path = tmp_path / "case.toml"
    path.write_text('walls = "walls.csv"\n[demand]\nag_g = 0.2\n')
    with pytest.raises(InputError, match="walls.csv: row 4: base_z_m is missing"):
        read_case(path)
    path.write_text('walls = "walls.csv"\n')
    assert [wall.base_z_m for wall in read_case(path).wall] == [0.0, None]


@pytest.mark.parametrize(
    ("demand", "words"),
    [
        # V_R = 50 years: SLV 474.6, SLC 974.8 (NTC 2018 3.2.0)
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "return_period_years": 975},
         "give 475 years at SLV"),
        ({"limit_state": "SLC", "return_period_years": 475}, "below the 682 years of SLC"),
        ({"limit_state": "SLC", "return_period_years": 500}, "below the 682 years of SLC"),
        ({"limit_state": "SLC", "return_period_years": 712}, "is that of SLV for V_R = 75 years"),
        ({"return_period_years": 50}, "below the 332 years of SLV"),
        ({"period_range_s": [2.0, 0.15]}, "period_range_s"),
        ({"period_range_s": [0.15]}, "two periods"),
        ({"confidence_on": "strength"}, "one of capacity, demand"),
    ],
)  # fmt: skip
def test_that_a_demand_that_contradicts_itself_is_refused(demand, words):
    with pytest.raises(InputError, match=words):
        parse_case(case(demand={"ag_g": 0.2, **demand}))


@pytest.mark.parametrize(
    ("demand", "years"),
    [
        ({"nominal_life_years": 50, "use_class_factor": 1.0}, 474.56),
        ({"nominal_life_years": 50, "use_class_factor": 1.5, "limit_state": "SLC"}, 1462.2),
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "limit_state": "SLD"}, 50.29),
        ({"nominal_life_years": 50, "use_class_factor": 1.0, "return_period_years": 475}, 475.0),
        ({"limit_state": "SLC", "return_period_years": 975}, 975.0),
        ({"limit_state": "SLC", "nominal_life_years": 100, "use_class_factor": 1.5,
          "return_period_years": 2475}, 2475.0),
        ({"limit_state": "SLC", "nominal_life_years": 75, "use_class_factor": 1.3,
          "return_period_years": 1901}, 1901.0),
        ({}, None),
    ],
)  # fmt: skip
def test_that_t_r_follows_from_v_n_and_c_u(demand, years):
    found = parse_case(case(demand={"ag_g": 0.2, **demand})).demand.return_period
    assert found == (None if years is None else pytest.approx(years, rel=1e-4))


def test_that_a_range_of_periods_is_written_and_read_again():
    first = parse_case(case(demand={"ag_g": 0.2, "period_range_s": [0.2, 3]}))
    assert first.demand.period_range_s == (0.2, 3.0)
    assert parse_case(tomllib.loads(dumps(first))) == first


def test_that_a_key_of_thousands_of_parts_is_refused_at_once(tmp_path):
    path = tmp_path / "c.toml"
    for text in ("a." * 30000 + "b = 1", "[" + "a." * 30000 + "b]", "[[" + "a . " * 9000 + "b]]"):
        path.write_text(f'title = "x"\n{text}\n')
        with pytest.raises(InputError, match="more than 50 parts"):
            read_case(path)
