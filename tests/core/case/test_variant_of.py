"""A wall written as what differs from another."""

import tomllib
from dataclasses import replace

import pytest

from core.case.reader import read_case
from core.case.rules import parse_case, parse_draft
from core.case.variant_names import AS_IS, DESIGNED
from core.case.wall_table import parse_wall_rows, text_rows
from core.case.writer import dumps
from core.errors import InputError
from core.study.variants import changed_keys

WALL = """\
[[wall]]
name = "South wall"
height_m = 5.0
thickness_m = 0.5
mechanism = "one_sided"
unit_weight_kn_m3 = 18.0
length_m = 4.0
velocity_ratio = 0.9
[[wall.load]]
kind = "vertical"
kn_m = 10.0
h_m = 5.0
d_m = 0.2
mass = "none"
"""


def case_of(text: str):
    return parse_case(tomllib.loads(text))


@pytest.mark.shows("case.variant")
def test_that_a_variant_is_the_named_wall_with_what_differs():
    before, after = case_of(WALL + '[[wall]]\nvariant_of = "South wall"  # cut back\nheight_m = 5.5').wall
    assert before == replace(case_of(WALL).wall[0], variant=AS_IS)
    assert after == replace(before, variant=DESIGNED, height_m=5.5)
    assert changed_keys(before, after) == ("height_m",)


def test_that_the_order_of_the_walls_is_free_and_a_stated_variant_stays():
    first, second = case_of(
        '[[wall]]\nvariant_of = "South wall"\nvariant = "stato di fatto"\nlength_m = 3.0\n'
        + (WALL.replace("height_m", 'variant = "progetto"\nheight_m', 1))
    ).wall
    assert (first.variant, first.length_m, second.variant, second.length_m) == (AS_IS, 3.0, DESIGNED, 4.0)


@pytest.mark.parametrize(
    "keys, expected",
    [
        ("slenderness_deg = 6.0", {"slenderness_deg": 6.0, "thickness_m": None}),
        ("height_over_thickness = 9.0", {"height_over_thickness": 9.0, "thickness_m": None}),
        ('restitution = "housner"', {"restitution": "housner", "velocity_ratio": None}),
        ('load = ""', {"load": ()}),
        ("load = []", {"load": ()}),
        ('velocity_ratio = ""', {"velocity_ratio": None}),
        ('thickness_m = ""\nheight_over_thickness = 9.0', {"height_over_thickness": 9.0, "thickness_m": None}),
    ],
)
def test_that_a_key_replaces_or_takes_away_what_it_stands_for(keys, expected):
    before, after = case_of(f'{WALL}[[wall]]\nvariant_of = "South wall"\n{keys}').wall
    assert after == replace(before, variant=DESIGNED, **expected)


@pytest.mark.parametrize(
    "text, code",
    [
        ('variant_of = "North wall"', "variant_of_unknown"),
        ("variant_of = 3", "variant_of_unknown"),
        ("variant_of = [1]", "variant_of_unknown"),
        (f"variant_of = 0x{'f' * 5000}", "variant_of_unknown"),
        (f'variant_of = "South wall"\nname = 0x{"f" * 5000}', "variant_name"),
        (f'variant_of = "South wall"\nvariant = 0x{"f" * 5000}', "not_accepted"),
        ('variant_of = "South wall"\n[[wall]]\nvariant_of = "South wall (progetto)"', "variant_of_variant"),
        ('name = "B"\nvariant_of = "B"', "variant_of_variant"),
        ('variant_of = "South wall"\nname = "North wall"', "variant_name"),
        ('variant_of = "South wall"\nthickness_m = ""', "one_geometry"),
        ('variant_of = "South wall"\nthickness_m = 0.4\nslenderness_deg = 5.0', "one_geometry"),
        ('variant_of = "South wall"\nmechanism = ""', "missing"),
        ('variant_of = "South wall"\nheight_m = ""', "one_geometry"),
        ('variant_of = "South wall"\nvariant = "stato di fatto"', "same_name"),
        ('variant_of = "South wall"\n[[wall]]\nvariant_of = "South wall"', "same_name"),
        ('variant_of = "South wall"\ncolour = "red"', "unknown_key"),
    ],
)
def test_that_a_contradiction_is_refused_in_one_sentence(text, code):
    with pytest.raises(InputError) as caught:
        case_of(f"{WALL}[[wall]]\n{text}\n")
    assert caught.value.code == code
    for language in ("en", "it"):
        said = caught.value.text(language)
        assert "\n" not in said and "{" not in said


def test_that_the_base_a_demand_needs_is_not_taken_away():
    text = WALL.replace("length_m", "base_z_m = 0.0\nlength_m", 1)
    with pytest.raises(InputError) as caught:
        case_of(f'{text}[[wall]]\nvariant_of = "South wall"\nbase_z_m = ""\n[demand]\nag_g = 0.2\nsoil_factor = 1.2\n')
    assert caught.value.code == "base_missing"


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"height_m": 6.0},
        {"load": ()},
        {"thickness_m": None, "slenderness_deg": 7.0},
        {"velocity_ratio": None},
        {"unit_weight_kn_m3": 20.0, "notes": "new", "thickness_m": 0.6},
    ],
)
def test_that_the_writer_keeps_a_variant_as_what_differs(values, tmp_path):
    text = f'# of mine\n{WALL}[[wall]]\nvariant_of = "South wall"  # with a tie\nheight_m = 5.5\n'
    case = case_of(text)
    changed = replace(case, wall=(case.wall[0], replace(case.wall[1], **values)))
    written = dumps(changed, text)
    assert parse_draft(tomllib.loads(written)).wall == changed.wall
    path = tmp_path / "c.toml"
    path.write_text(written, encoding="utf-8")
    assert read_case(path).wall == changed.wall
    if "load" not in values:  # a table that goes takes the comments with it
        assert "# of mine" in written and 'variant_of = "South wall"  # with a tie' in written
        assert written.count("name =") == 1


def test_that_what_no_longer_is_a_variant_is_written_whole():
    text = f'{WALL}[[wall]]\nvariant_of = "South wall"\nheight_m = 5.5\n'
    case = case_of(text)
    for walls in (
        case.wall[::-1],
        case.wall[1:],
        (replace(case.wall[0], name="x"), case.wall[1]),
        (case.wall[0], replace(case.wall[1], name="y", variant=None)),
        (replace(case.wall[0], variant=DESIGNED), replace(case.wall[1], variant=AS_IS)),
    ):
        changed = replace(case, wall=walls)
        assert parse_case(tomllib.loads(dumps(changed, text))) == changed


def test_that_a_table_of_walls_says_how_variants_are_given_there():
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows("name;variant of\n;\nA;B\n"))
    assert caught.value.code == "variant_of_in_table"
