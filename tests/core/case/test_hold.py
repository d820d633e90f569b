"""What holds a wall: its rules, its place, how the older keys are written now, and its columns in a table of walls."""

import math
import random

import pytest

from core.case.document import PRESENCE, STRENGTH
from core.case.hinges import highest_hold, make_wall_parts
from core.case.hold import HOLD_KINDS, hold_kind
from core.case.hold_rules import OLD_KEYS
from core.case.rules import parse_case, parse_draft
from core.case.schema import Case
from core.case.wall_table import parse_wall_rows, text_rows
from core.case.writer import dumps, table_of
from core.errors import InputError
from tests.holds import at_top, behind, between, sought

WALL = {"name": "w", "height_m": 5.0, "thickness_m": 0.5, "mechanism": "one_sided", "base_z_m": 0.0}
WALL |= {"unit_weight_kn_m3": 18.0}
ENDS = {"shoulder_length_m": 2.0, "shoulder_thickness_m": 0.5}
TIE = {"out_kn_m": 0.5, "bar_length_m": 8.0}


def case_of(**keys) -> Case:
    return parse_case({"wall": [WALL | keys], "building": {"height_m": 9.0, "storeys": 3, "period_s": 0.3}})


@pytest.mark.parametrize("kind", HOLD_KINDS)
def test_that_a_hold_of_every_kind_is_read_and_written_again(kind):
    place = {"h_m": 3.0} if hold_kind(kind).has_height else {"from_m": 1.0, "to_m": 4.0}
    place |= TIE if kind == "tie" else {}
    shown = {"kind": "test", "reference": "PT-04", "date": "2026-03-12", "note": "pulled to 12 kN"}
    case = case_of(hold=[{"kind": kind, "name": "x", "evidence": shown, **place}])
    (hold,) = case.wall[0].hold
    assert (hold.kind, hold.evidence.reference, hold.evidence.date) == (kind, "PT-04", "2026-03-12")
    assert parse_case(table_of(case)) == case
    import tomllib

    assert parse_case(tomllib.loads(dumps(case))) == case


@pytest.mark.parametrize(
    ("hold", "code", "key"),
    [
        ({"kind": "floor"}, "hold_needs", "h_m"),
        ({"kind": "roof", "h_m": 5.5}, "hold_outside", "h_m"),
        ({"kind": "floor", "h_m": 3.0, "to_m": 4.0}, "hold_key", "to_m"),
        ({"kind": "contact", "h_m": 3.0}, "hold_key", "h_m"),
        ({"kind": "contact", "out_kn_m": 3.0}, "hold_key", "out_kn_m"),
        ({"kind": "contact", "spacing_m": 3.0}, "hold_key", "spacing_m"),
        ({"kind": "anchor", "h_m": 3.0, "tie_kn_m": 3.0}, "hold_key", "tie_kn_m"),
        ({"kind": "cross_walls", "out_kn_m": 3.0}, "hold_needs_spacing", "out_kn_m"),
        ({"kind": "buttress", **ENDS}, "hold_needs_spacing", "shoulder_length_m"),
        ({"kind": "contact", "from_m": 4.0, "to_m": 3.0}, "hold_reversed", "to_m"),
        ({"kind": "contact", "to_m": 6.0}, "hold_outside", "to_m"),
        ({"kind": "anchor", "h_m": 0.5, "out_kn_m": 5.0}, "hold_not_counted", "out_kn_m"),
        ({"kind": "wire"}, "not_accepted", "kind"),
        ({"kind": "floor", "h_m": 4.5, "base": 5.0}, "hold_above_building", "h_m"),
        ({"kind": "floor", "h_m": 3.0, "evidence": {"kind": "hearsay"}}, "not_accepted", "kind"),
        ({"kind": "floor", "h_m": 3.0, "evidence": {"kind": "test"}}, "document_reference", "reference"),
    ],
)
def test_that_a_hold_that_cannot_be_is_refused_by_its_number_and_its_key(hold, code, key):
    base = {key: hold[key] for key in ("base",) if key in hold}
    hold = {key: value for key, value in hold.items() if key not in base}
    with pytest.raises(InputError) as refused:
        case_of(hold=[*behind(), hold], base_z_m=base.get("base", 0.0))
    assert refused.value.code == code and refused.value.key == key
    assert "2" in refused.value.text("en") and "w" in refused.value.text("it")


def test_that_a_wall_spans_between_cross_walls_of_one_spacing():
    with pytest.raises(InputError) as refused:
        case_of(compressive_strength_mpa=2.0, hold=between(4.0, **ENDS) + between(5.0, **ENDS))
    assert refused.value.code == "hold_two_spacings"


def test_that_a_wall_held_at_its_top_has_no_hold_below_it():
    bends = {"mechanism": "vertical_bending"}
    assert case_of(**bends, hold=at_top(5.0, 12.0)).wall[0].in_si.declared.strength == 12e3
    with pytest.raises(InputError) as refused:
        case_of(**bends, hold=at_top(3.0, 12.0))
    assert refused.value.code == "hold_below_top"
    assert case_of(**bends, hold=behind()).wall[0].held_by is None


@pytest.mark.shows("free.above")
@pytest.mark.parametrize(
    ("hold", "keys", "found"),
    [
        (behind(), {"height_m": 12.0}, 9.0),
        (behind(to_m=6.0), {"height_m": 12.0}, 6.0),
        (behind(to_m=6.0), {"height_m": 8.0}, 6.0),
        (behind(kind="floor", h_m=3.0), {"height_m": 8.0}, 3.0),
        (behind(kind="floor", h_m=3.0) + behind(kind="roof", h_m=7.0), {"height_m": 8.0}, 7.0),
        (between() + behind(kind="floor", h_m=3.0), {"height_m": 8.0}, 3.0),
        (between(), {"height_m": 11.0, "gable_m": 3.0, "length_m": 8.0}, 8.0),
        (between(), {"height_m": 8.0}, None),
        (behind(kind="floor", h_m=7.8), {"height_m": 8.0}, None),
    ],
)
def test_that_a_wall_is_held_up_to_its_highest_hold(hold, keys, found):
    """The lowest of highest floor or roof, eaves and top of the building is where cross walls and contact end."""
    case = case_of(hold=hold, **keys)
    held = highest_hold(case.wall[0], case.building)
    assert held == (None if found is None else pytest.approx(found))
    free = {
        part.hinge for part in make_wall_parts(0, case.wall[0], case.building) if part.wall.mechanism == "two_sided"
    }
    assert (found in free) == (found is not None)


def test_that_a_part_above_a_hinge_has_the_holds_above_it_at_their_height_from_there():
    holds = behind(kind="floor", h_m=3.0) + behind(kind="roof", h_m=7.0) + between(to_m=6.5)
    case = case_of(height_m=8.0, hold=holds, hinge_heights=[3.0])
    part = next(part for part in make_wall_parts(0, case.wall[0], case.building) if part.hinge == 3.0)
    assert [(hold.kind, hold.h_m, hold.to_m) for hold in part.wall.hold] == [
        ("roof", 4.0, None),
        ("cross_walls", None, 3.5),
    ]


OLDER = {
    "back_restraint": "tied_floors",
    "restraint_evidence": "drawing",
    "restraint_note": "beams tied",
    "restraint_kn_m": 12.0,
    "arch": {"spacing_m": 4.0, **ENDS},
    "tie_height_m": 4.0,
    "tie_bar_length_m": 8.0,
    "tie_elongation_m": 0.4,
    "tie_spacing_m": 1.5,
}


@pytest.mark.shows("free.older")
@pytest.mark.parametrize("key", OLD_KEYS)
def test_that_an_older_key_is_refused_with_the_new_writing_of_what_it_says(key):
    for read in (parse_case, parse_draft):
        with pytest.raises(InputError) as refused:
            read({"wall": [WALL | {key: OLDER[key]}]})
        assert refused.value.code == "old_key" and "hold = [{" in refused.value.text("en")
        with pytest.raises(InputError) as refused:
            read({"wall": [WALL | {"free_element": False}]})
        assert refused.value.code == "old_free" and "hold = [{" in refused.value.text("en")


@pytest.mark.parametrize(
    ("older", "keys"),
    [
        ({"back_restraint": "cross_walls", "restraint_evidence": "photograph"}, {}),
        ({"back_restraint": "other", "restraint_note": 'a "house"', "restraint_evidence": "drawing"}, {}),
        ({"back_restraint": "buttress", "restraint_evidence": "none"}, {}),
        ({"back_restraint": "tied_floors", "restraint_kn_m": 12.0}, {"mechanism": "vertical_bending"}),
        ({"back_restraint": "cross_walls", "arch": {"spacing_m": 4.0, **ENDS}}, {"compressive_strength_mpa": 2.0}),
        ({"arch": {"spacing_m": 4.0, **ENDS}, "restraint_evidence": "test"}, {"compressive_strength_mpa": 2.0}),
    ],
)
def test_that_the_new_writing_can_be_pasted_in_the_place_of_the_older_keys(older, keys):
    import tomllib

    with pytest.raises(InputError) as refused:
        case_of(**keys, **older)
    line = refused.value.text("en").partition("now: ")[2]
    hold = tomllib.loads(line.replace('"..."', '"PT-1"'))["hold"]  # the document is the engineer's to name
    found = case_of(**keys, hold=hold).wall[0]
    assert found.hold[0].kind in (older.get("back_restraint"), "contact", "cross_walls", "floor")
    assert (found.hold[0].evidence is not None) == (older.get("restraint_evidence") not in (None, "none"))
    assert (found.arch is not None) == ("arch" in older)


def test_that_the_new_writing_of_a_tie_to_be_designed_is_pasted_beside_that_of_a_restraint():
    import tomllib

    tie = sought(4.0, bar_length_m=8.0, elongation_m=0.4, spacing_m=1.5)
    of_tie = {key: value for key, value in OLDER.items() if key.startswith("tie_")}
    for older, holds in ((of_tie, [tie]), (of_tie | {"back_restraint": "cross_walls"}, [{"kind": "cross_walls"}, tie])):
        with pytest.raises(InputError) as refused:
            case_of(**older)
        assert tomllib.loads(refused.value.text("it").partition("vincolo: ")[2])["hold"] == holds
        assert case_of(hold=holds).wall[0].sought.spacing_m == 1.5


def test_that_the_columns_of_a_table_say_it_in_both_languages_and_older_ones_are_refused():
    head = "Parete;H [m];t [m];Meccanismo;vincolo 1;vincolo 1 prova;hold1_evidence_reference;hold2_kind;hold2_h_m [m]"
    rows = text_rows(head + "\na;5;0,5;un lato;muri trasversali;rilievo;tav. 4;solaio;3")
    first, second = parse_wall_rows(rows)[0].hold
    assert (first.kind, first.evidence.kind, first.evidence.reference) == ("cross_walls", "survey", "tav. 4")
    assert (second.kind, second.h_m, second.evidence) == ("floor", 3.0, None)
    of_ties = ("tie_height_m", "tie_spacing_m [m]", "load1_bar_length_m [m]", "load1_slack_mm")
    for title in ("Vincolo", "back_restraint", "restraint", "tenuta", "arco L [m]", "arch_tie_kn_m", *of_ties):
        with pytest.raises(InputError) as refused:
            parse_wall_rows(text_rows(f"Parete;H [m];t [m];Meccanismo;{title}\na;5;0,5;un lato;x"))
        assert refused.value.code == "old_column" and "hold1_" in refused.value.text("it")


def test_that_of_several_holds_the_one_that_nothing_shows_is_asked_for():
    """A floor that nobody shows would lift the part above the others out of sight."""
    for hold in (behind() + behind("", "floor", h_m=5.0), behind("", "floor", h_m=5.0) + behind()):
        assert case_of(hold=hold).wall[0].in_si.declared.evidence is None
    assert case_of(hold=behind() + behind("", "cross_walls")).wall[0].in_si.declared.evidence == "drawing"


@pytest.mark.parametrize("seed", range(40))
def test_that_any_holds_go_with_hinges_a_leaf_and_the_wall_unheld(seed):
    """Every part of a wall with any holds is a wall, with the holds that are above its foot; without any it is free."""
    draw = random.Random(seed)
    height = draw.uniform(5.0, 9.0)
    holds = []
    for kind in draw.choices(tuple(HOLD_KINDS), k=draw.randint(1, 4)):
        low, high = sorted(round(draw.uniform(0.3, height - 0.1), 2) for _ in "ab")
        ends = draw.choice(({}, {"to_m": high}, {"from_m": low, "to_m": high + 0.05}))
        keys = ({"h_m": high} if hold_kind(kind).has_height else ends) | (TIE if kind == "tie" else {})
        holds += behind(draw.choice(("drawing", "")), kind, **keys)
    leaf = {"thickness_m": 0.2, "connector_kn_m": 1.5, "row_spacing_m": 1.0, "slip_mm": 2.0}
    height = max(height, 3.0 * math.ceil(height / 3.0 - 1.0) + 0.5)  # no stub above a floor that is too stocky to rock
    case = case_of(height_m=height, hold=holds, leaf=draw.choice((leaf, {"thickness_m": 0.2})), hinge_heights="floors")
    for part in make_wall_parts(0, case.wall[0], case.building):
        tops = [hold.h_m or hold.to_m for hold in part.wall.hold]
        assert all(top is None or 0.0 < top <= height - part.hinge + 1e-6 for top in tops)
        assert part.wall.in_si.declared.restraint in (None, *HOLD_KINDS)
        assert part.wall.hold or part.wall.mechanism == "two_sided"


def test_that_the_kinds_are_told_apart():
    assert not any(kind.has_height and kind.is_local for kind in HOLD_KINDS.values())
    assert all(kind.has_height for kind in HOLD_KINDS.values() if kind.pulls or kind.is_bar or kind.of_building)
    assert not {*PRESENCE} & {*STRENGTH}
    assert between(4.0, "test")[0]["evidence"]["kind"] in STRENGTH
