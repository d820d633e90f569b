"""A mechanism that is not looked at is set aside by a document, over the heights it names, and nothing else is."""

import random

import pytest

from core.case.register import SET_ASIDE
from core.case.rules import parse_case
from core.case.set_aside import ROWS, SetAside
from core.errors import InputError
from core.study.register import make_register
from core.study.run import run
from tests.holds import behind

SHOWN = {"kind": "calculation", "reference": "sheet 4", "note": "courses toothed over the whole height"}
FLOORS = [{"kind": "vertical", "kn_m": 3.0, "d_m": 0.3, "h_m": height, "mass": "none"} for height in (3.0, 4.0)]
WALL = {"name": "w", "mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.6, "unit_weight_kn_m3": 18.0}
WALL |= {"base_z_m": 0.0, "hold": behind(to_m=6.0), "hinge_heights": "base", "load": FLOORS}
CASE = {"demand": {"ag_g": 0.02, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}}
CASE |= {"building": {"height_m": 6.0, "storeys": 2, "period_s": 0.2}, "analysis": {"histories": False}}


def entry_of(mechanism, shown=SHOWN, **heights):
    return {"mechanism": mechanism, **heights, **({"evidence": shown} if shown else {})}


def study(*entries, **wall):
    keys = {"set_aside": list(entries)} if entries else {}
    return run(parse_case(CASE | {"wall": [WALL | keys | wall]}), base_dir=".")


def outcome(result):
    return result.walls[result.verdicts[0].governing].required_assessment.verdict.code


def rows(result):
    return [looked.row for looked in make_register(result, result.verdicts[0])]


@pytest.mark.shows("free.set_aside")
@pytest.mark.parametrize(
    ("entries", "passes"),
    [
        ([], False),
        ([entry_of("overturning", from_m=3.0, to_m=3.0)], False),
        ([entry_of("overturning", from_m=3.0, to_m=4.0)], True),
        ([entry_of("overturning", from_m=3.0, to_m=3.0), entry_of("overturning", from_m=4.0)], True),
        ([entry_of("overturning")], True),
        ([entry_of("overturning", from_m=3.5)], False),
        ([entry_of("leaf"), entry_of("vertical_bending"), entry_of("direction")], False),
    ],
)
def test_that_every_hinge_left_out_needs_its_document(entries, passes):
    assert outcome(study(*entries)) == ("not_activated" if passes else "indicative")


def test_that_what_is_set_aside_has_its_row_with_its_document():
    found = {row.hinge: row for row in rows(study(entry_of("overturning", from_m=3.0, to_m=3.0)))}
    assert found[3.0].status == SET_ASIDE
    assert "sheet 4, courses toothed" in found[3.0].why.text("en")
    assert found[4.0].status == "not_looked_at"


@pytest.mark.parametrize(
    ("entry", "code", "key"),
    [
        (entry_of("overturning", None), "set_aside_evidence", "evidence"),
        (entry_of("overturning", {"kind": "survey"}), "set_aside_reference", "reference"),
        (entry_of("overturning", {"kind": "survey", "reference": "  "}), "set_aside_reference", "reference"),
        (entry_of("overturning", {"kind": "photograph", "reference": "f1"}), "set_aside_kind", "kind"),
        (entry_of("vertical_bending", {"kind": "survey", "reference": "R1"}), "set_aside_kind", "kind"),
        (entry_of("overturning", from_m=3.0, to_m=2.0), "set_aside_heights", "to_m"),
        (entry_of("overturning", from_m=6.5), "set_aside_heights", "from_m"),
        (entry_of("overturning", to_m=6.5), "set_aside_heights", "to_m"),
        (entry_of("sliding"), "not_accepted", "mechanism"),
    ],
)
def test_that_what_is_set_aside_is_said_whole(entry, code, key):
    with pytest.raises(InputError) as refused:
        study(entry)
    assert (refused.value.code, refused.value.key) == (code, key)


@pytest.mark.shows("free.gate")
def test_that_one_height_set_aside_hides_no_other_where_the_building_is_not_known():
    """A step at 3 m and a part above its holds from 5.5 m: 1.35 and verified with the latter alone set aside; with its
    building the wall fails at the step."""
    step = {"steps": [{"from_z_m": 3.0, "thickness_m": 0.3}], "height_m": 7.0, "length_m": 10.0}
    held = {"hold": behind("survey", to_m=5.5), "unloaded_confirmed": True}
    wall = {key: value for key, value in WALL.items() if key not in ("load", "hinge_heights")} | step | held
    wall |= {"set_aside": [entry_of("part_above", from_m=5.5)]}
    demand = {"demand": CASE["demand"] | {"ag_g": 0.12}, "analysis": CASE["analysis"]}
    result = run(parse_case(demand | {"wall": [wall]}), base_dir=".")
    assert outcome(result) == "indicative"
    found = {(row.name, row.hinge): row.status for row in rows(result)}
    assert found["overturning", 3.0] == "not_looked_at" and found["part_above", 5.5] == SET_ASIDE


def test_that_the_part_above_is_set_aside_where_nobody_says_where_it_begins():
    wall = {"hold": behind(), "set_aside": [entry_of("part_above", from_m=5.0, to_m=6.0)], "hinge_heights": None}
    case = {key: value for key, value in CASE.items() if key != "building"}
    table = {key: value for key, value in (WALL | wall).items() if value is not None}
    result = run(parse_case(case | {"wall": [table]}), base_dir=".")
    assert {row.status for row in rows(result) if row.name == "part_above"} == {SET_ASIDE}


def test_that_the_older_reason_is_refused_with_its_new_line():
    with pytest.raises(InputError) as refused:
        study(justification={"hinge_heights": "toothed"})
    assert "set_aside = [{" in refused.value.text("en")


def test_that_an_entry_covers_its_own_mechanism_within_its_heights_alone():
    draw = random.Random(3)
    for _ in range(300):
        low, high = sorted(round(draw.uniform(0.0, 9.0), 2) for _ in range(2))
        entry = SetAside(draw.choice(ROWS), draw.choice((None, low)), draw.choice((None, high)))
        name, at = draw.choice(ROWS), round(draw.uniform(0.0, 9.0), 2)
        inside = (entry.from_m or 0.0) - 0.01 <= at <= (9.0 if entry.to_m is None else entry.to_m) + 0.01
        edge = any(abs(abs(at - end) - 0.01) < 1e-9 for end in (entry.from_m, entry.to_m) if end is not None)
        assert edge or entry.covers(name, at, at) == (name == entry.mechanism and inside)
        if entry.to_m is not None:
            assert not entry.covers(entry.mechanism, 0.0, None) or (entry.from_m or 0.0) <= 0.01
