"""A case written: the same case, and the comments of its file."""

import tomllib
from dataclasses import replace

import pytest

from core.case.rules import parse_case, parse_draft
from core.case.writer import dumps
from core.errors import InputError
from tests.core.case.tables import case
from tests.holds import sought


@pytest.mark.shows("case.written")
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


def test_that_loads_ties_return_walls_and_hazard_are_written_and_read_again():
    wall = {
        "load": [{"kind": "vertical", "kn_m": 10.0, "h_m": 7.0, "d_m": 0.4, "mass": "none"}],
        "hold": [{"kind": "tie", "out_kn_m": 2.0, "h_m": 6.5, "bar_length_m": 8.0}, sought(6.0)],
        "unit_weight_kn_m3": 18.0,
        "length_m": 5.0,
        "variant": "progetto",
        "mechanism": "one_sided",
        "hinge_heights": [2.0],
        "return_walls": {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3},
    }
    hazard = [{"return_period_years": 30.0, "ag_g": 0.08}, {"return_period_years": 475.0, "ag_g": 0.2}]
    first = parse_case(case(wall, demand={"ag_g": 0.1, "hazard": hazard}))
    assert parse_case(tomllib.loads(dumps(first))) == first
    assert parse_draft(tomllib.loads(dumps(first))).wall == first.wall
    # a load whose size is still to be given is kept out of the file, and said to be missing
    open_load = replace(first.wall[0].load[0], kn_m="")
    draft = replace(first, wall=(replace(first.wall[0], load=(open_load,)),))
    with pytest.raises(InputError) as caught:
        parse_case(tomllib.loads(dumps(draft)))
    assert (caught.value.code, caught.value.key) == ("load_size_missing", "kn_m")


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


@pytest.mark.shows("case.written")
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
            assert tomllib.loads(found).get("wall", []) == tomllib.loads(dumps(changed)).get("wall", [])
        assert "#" not in dumps(replace(case, demand=None), text)


def test_that_walls_of_one_name_keep_their_comments():
    text = COMMENTED.replace("gable", "facade")
    case = parse_draft(tomllib.loads(text))
    assert dumps(case, text) == text


def test_that_a_file_of_any_kind_before_changes_no_case():
    case = parse_case(tomllib.loads(COMMENTED))
    for before in ("", "not toml [", "x = 1\n", 'wall = [{name = "facade"}]\n', "[wall]\n[demand.x]\n"):
        assert parse_case(tomllib.loads(dumps(case, before))) == case


def test_that_a_range_of_periods_is_written_and_read_again():
    first = parse_case(case(demand={"ag_g": 0.2, "period_range_s": [0.2, 3]}))
    assert first.demand.period_range_s == (0.2, 3.0)
    assert parse_case(tomllib.loads(dumps(first))) == first
