"""The register: every mechanism of every wall has a row, and a row that nobody looks at blocks whatever passes."""

import random

import pytest

from core.case.hinges import count_wall_parts, make_wall_parts
from core.case.register import LOOKED_AT, NOT_LOOKED_AT, NOT_POSSIBLE, SET_ASIDE, find_left_out
from core.case.set_aside import ROWS, VERTICAL_BENDING
from core.case.wall_table import parse_wall_rows
from core.codes.outcomes import OUTCOMES, PASSES
from core.errors import InputError
from core.report import json_report
from core.report.register_words import describe_lines, describe_rows, reactions_line
from core.study.register import make_register
from core.study.run import run
from core.text.sentence import localized
from tests.clauses_alone import parse_case
from tests.conftest import ROOT
from tests.holds import aside, at_top, behind, between, carries

SPECTRUM = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "C", "topography": "T1"}
BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
WALL = {"name": "w", "mechanism": "one_sided", "height_m": 9.0, "thickness_m": 0.6, "length_m": 8.0}
WALL |= {"base_z_m": 0.0, "unit_weight_kn_m3": 18.0, "unloaded_confirmed": True, "hold": behind(to_m=9.0)}
FLOOR = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.4, "mass": "none"}
FREE = {"mechanism": "two_sided", "hold": None}
TIE = {"kind": "tie", "out_kn_m": 8.0, "h_m": 8.6, "bar_length_m": 9.0, "elongation_m": 0.3}
WEAK = TIE | {"out_kn_m": 5.0}
BENT = {"mechanism": "vertical_bending", "height_m": 3.0, "hold": at_top(3.0, 9.0)}
PUSH = {"kind": "thrust", "kn_m": -0.5, "h_m": 3.0}


def loaded(*given, hold=WALL["hold"]):
    """Keys of a wall with these loads and ties beside its holds."""
    return {"unloaded_confirmed": False} | carries(*given, hold=hold)


def studied(keys=None, building=BUILDING, ag=0.02):
    wall = WALL | (keys or {})
    wall = {key: value for key, value in wall.items() if value is not None}
    table = {"demand": {"ag_g": ag, "spectrum": SPECTRUM}, "wall": [wall]} | (
        {"building": building} if building else {}
    )
    case = parse_case(table)
    result = run(case, base_dir=ROOT)
    return result, make_register(result, result.verdicts[0])


def statuses(register):
    return {(looked.row.name, looked.row.status) for looked in register}


def floors(*heights):
    return [{"kind": "floor", "h_m": height, "evidence": {"kind": "drawing"}} for height in heights]


@pytest.mark.shows("free.rows")
@pytest.mark.parametrize(
    ("keys", "building", "row"),
    [
        ({}, BUILDING, ("overturning", LOOKED_AT)),
        ({}, BUILDING, (VERTICAL_BENDING, NOT_POSSIBLE)),
        ({"hinge_heights": "base"}, BUILDING, ("overturning", NOT_LOOKED_AT)),
        ({"hinge_heights": "base", "set_aside": [aside("overturning")]}, BUILDING, ("overturning", SET_ASIDE)),
        (loaded(FLOOR | {"h_m": 4.0}), None, ("overturning", NOT_LOOKED_AT)),
        (loaded(TIE), BUILDING, (VERTICAL_BENDING, LOOKED_AT)),
        (loaded(WEAK, PUSH), BUILDING, (VERTICAL_BENDING, NOT_LOOKED_AT)),
        (loaded(WEAK | {"slack_mm": 0.01}), BUILDING, (VERTICAL_BENDING, NOT_LOOKED_AT)),
        (loaded(WEAK, PUSH) | {"set_aside": [aside("vertical_bending")]}, BUILDING, (VERTICAL_BENDING, SET_ASIDE)),
        ({"mechanism": "both"} | loaded(WEAK, PUSH), BUILDING, (VERTICAL_BENDING, NOT_LOOKED_AT)),
        ({"hold": between()}, BUILDING, ("horizontal_bending", NOT_LOOKED_AT)),
        ({"hold": behind()}, None, ("part_above", NOT_LOOKED_AT)),
        ({"hold": behind()}, BUILDING, ("part_above", NOT_POSSIBLE)),
        ({"hold": behind(to_m=7.0)}, BUILDING, ("part_above", LOOKED_AT)),
        (FREE | {"length_m": 0.5}, None, ("direction", LOOKED_AT)),
        (FREE | {"length_m": 0.5} | loaded(FLOOR | {"h_m": 4.0}, hold=()), None, ("direction", NOT_LOOKED_AT)),
        (
            FREE | {"length_m": 0.5, "set_aside": [aside("direction")]} | loaded(FLOOR | {"h_m": 4.0}, hold=()),
            None,
            ("direction", SET_ASIDE),
        ),
        (FREE | {"length_m": 1.3}, None, ("direction", NOT_POSSIBLE)),
        ({"leaf": {"thickness_m": 0.25}}, BUILDING, ("leaf", LOOKED_AT)),
        (
            {"mechanism": "vertical_bending", "height_m": 3.0, "hold": at_top(3.0, 9.0)},
            None,
            ("overturning", NOT_POSSIBLE),
        ),
    ],
)
def test_that_a_mechanism_is_looked_at_not_possible_or_missing(keys, building, row):
    result, register = studied(keys, building)
    assert row in statuses(register)
    blocked = {looked.row.why.code for looked in register if looked.row.status == NOT_LOOKED_AT}
    outcome = result.walls[result.verdicts[0].governing].assessment.verdict
    codes = {limit.code for wall in result.walls for limit in wall.assessment.verdict.limits}
    assert blocked <= codes
    assert not blocked or outcome.code not in ("verified", "verified_refined", "not_activated")


def random_wall(draw):
    height = round(draw.uniform(3.0, 9.0), 1)
    keys = {"height_m": height, "thickness_m": round(height / draw.uniform(6.0, 14.0), 2)}
    keys["mechanism"] = draw.choice(("one_sided", "one_sided", "one_sided", "two_sided", "both"))
    if keys["mechanism"] == "two_sided":
        return keys | {"hold": None, "length_m": round(draw.uniform(0.2, 3.0), 2)}
    holds = (
        behind(to_m=height),
        behind(),
        between(),
        floors(round(0.5 * height, 2), height),
        behind("", to_m=0.6 * height),
    )
    keys["hold"] = draw.choice(holds)
    loads = (
        [FLOOR | {"h_m": round(0.5 * height, 2), "d_m": round(0.6 * keys["thickness_m"], 3)}]
        if draw.random() < 0.5
        else []
    )
    if keys["mechanism"] == "one_sided" and draw.random() < 0.5:
        loads.append(TIE | {"h_m": round(0.95 * height, 2), "out_kn_m": draw.choice((0.5, 3.0))})
    if loads:
        keys |= loaded(*loads, hold=keys["hold"])
    if draw.random() < 0.3:
        keys["hinge_heights"] = "base"
    return keys


@pytest.mark.shows("free.gate")
@pytest.mark.parametrize("seed", range(4))
def test_that_every_wall_has_a_row_for_every_mechanism_and_none_left_out_lets_it_pass(seed):
    draw, passed = random.Random(seed), 0
    for _ in range(10):
        try:
            keys, building = random_wall(draw), draw.choice((None, BUILDING))
            result, register = studied(keys, building, draw.choice((0.005, 0.03)))
        except InputError:
            continue
        assert {looked.row.name for looked in register} == set(ROWS)
        outcome = result.walls[result.verdicts[0].governing].assessment.verdict
        left = [looked for looked in register if looked.row.status == NOT_LOOKED_AT]
        assert not left or outcome.code == "indicative" or OUTCOMES[outcome.code].judgement != PASSES
        passed += bool(left) and outcome.code == "indicative"
        assert all(looked.row.why for looked in register if looked.row.status != LOOKED_AT)
        assert {id(looked.result) for looked in register if looked.result} == {
            id(result.walls[k]) for k in result.verdicts[0].results
        }
        wall, origin = result.case.wall[0], result.case.building
        assert count_wall_parts(wall, origin) == len(result.walls)
    assert passed


@pytest.mark.shows("free.inward")
def test_that_a_wall_held_back_bends_inward_between_its_floors_where_that_starts_soon():
    """A tie strong enough at the top leaves the stretches below it to bend; pressed inward they do so between the
    floors, which are no ties."""
    strong, building = TIE | {"out_kn_m": 40.0}, parse_case({"building": BUILDING, "wall": [WALL]}).building
    for keys, inward in ((loaded(strong, hold=floors(4.0, 9.0)), True), ({"hold": floors(4.0, 9.0)}, False)):
        wall = parse_case({"building": BUILDING, "wall": [WALL | keys]}).wall[0]
        parts = [part for part in make_wall_parts(0, wall, building) if part.inward]
        assert bool(parts) == inward
        for part in parts:
            assert (part.hinge, part.top) in ((0.0, 4.0), (4.0, 9.0)) and part.wall.bends


def test_that_the_register_stands_in_json_and_in_words_of_both_languages():
    result, register = studied(loaded(WEAK, PUSH))
    (entry,) = json_report.results(result)["verdicts"]
    assert [row["name"] for row in entry["mechanisms"]] == [looked.row.name for looked in register]
    first = entry["mechanisms"][0]
    assert (first["code"], first["zeta"], first["check"]) == (entry["code"], entry["zeta_e"], entry["check"])
    missing = next(row for row in entry["mechanisms"] if row["status"] == NOT_LOOKED_AT)
    assert missing["code"] is None and missing["why_en"] and missing["why_it"] != missing["why_en"]
    for language in ("en", "it"):

        def say(english, language=language, **values):
            return localized("report", english, language, **values)

        rows = describe_rows(result, result.verdicts[0], say, language)
        assert len(rows) == sum(looked.row.status != NOT_POSSIBLE for looked in register)
        lines = describe_lines(result, result.verdicts[0], say, language)
        taken = reactions_line(result, result.verdicts[0], say, language)
        assert len(lines) == len(rows) + 2 and taken in lines and all("{" not in line for line in lines)


def test_that_only_a_part_about_the_base_says_what_is_left_out():
    wall = parse_case({"building": BUILDING, "wall": [WALL | {"hold": between()}]}).wall[0]
    parts = make_wall_parts(0, wall, None)
    assert [code for part in parts for code in find_left_out(part, None)] == list(find_left_out(parts[0], None))


@pytest.mark.shows("free.found")
def test_that_the_mechanism_need_not_be_given_beside_a_demand():
    """With a hold a wall leans, without one it stands free; a bare block without a demand says what it does."""
    bare = {key: value for key, value in WALL.items() if key not in ("mechanism", "hold")}
    table = {"demand": {"ag_g": 0.02, "spectrum": SPECTRUM}, "building": BUILDING}
    held = bare | {"hold": floors(3.0, 9.0)}
    for wall, found in ((bare, "two_sided"), (held, "one_sided"), (held | {"mechanism": "both"}, "both")):
        assert parse_case(table | {"wall": [wall]}).wall[0].mechanism == found
    with pytest.raises(InputError) as refused:
        parse_case({"wall": [bare]})
    assert refused.value.key == "mechanism"
    rows = [["name", "base_z_m", "height_m", "thickness_m", "hold1_kind", "hold1_h_m"], ["", "m", "m", "m", "", "m"]]
    rows += [["a", "0", "3", "0.3", "floor", "3"], ["b", "0", "3", "0.3", "", ""]]
    walls = parse_wall_rows(rows, with_demand=True)
    assert [wall.mechanism for wall in walls] == ["one_sided", "two_sided"]
