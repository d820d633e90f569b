"""Mechanisms, kinds of loads and of holds are asked what they do: nobody compares their names."""

import ast
from pathlib import Path

import pytest

from core.case import hold as holds
from core.case.hold import HOLD_KINDS, HoldKind
from core.case.rules import parse_case
from core.study.run import run
from core.text.catalogue import CATALOGUE
from core.wall import kinematics as mechanisms
from core.wall import load_kinds
from core.wall.kinematics import MECHANISMS, Kinematics, kinematics
from core.wall.load_kinds import LOAD_KINDS, LoadKind

ROOT = Path(__file__).resolve().parents[3]

OTHER_MEANINGS = {"vertical", "both", *HOLD_KINDS}
"""Words that are also a direction of a record, a rule of two codes, a part of a scene: they count beside a mechanism or
a kind alone."""

WALL = {"name": "w", "height_m": 4.0, "thickness_m": 0.4, "unit_weight_kn_m3": 18.0, "base_z_m": 0.0}
WALL |= {"hold": [{"kind": "contact", "to_m": 4.0}]}
DEMAND = {"ag_g": 0.12, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}


def comparisons():
    """Places in core and app in which the name of a mechanism or of a kind of load or hold is compared."""
    names = {*MECHANISMS, *LOAD_KINDS, *HOLD_KINDS}
    for path in sorted([*(ROOT / "core").rglob("*.py"), *(ROOT / "app").rglob("*.py")]):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Compare):
                continue
            parts = list(ast.walk(node))
            words = {part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)}
            called = {part.attr for part in parts if isinstance(part, ast.Attribute)}
            called |= {part.id for part in parts if isinstance(part, ast.Name)}
            beside = names if called & {"mechanism", "kind"} else names - OTHER_MEANINGS
            if words & beside or called & {"BENDS", "ARCHES", "TIE"}:
                yield f"{path.relative_to(ROOT)}:{node.lineno}"


def test_that_no_name_of_a_mechanism_a_load_or_a_hold_is_compared():
    assert list(comparisons()) == []


def outcome(mechanism, **changes):
    table = {"wall": [WALL | {"mechanism": mechanism} | changes], "demand": DEMAND, "analysis": {"histories": False}}
    (wall,) = run(parse_case(table), base_dir=ROOT).walls
    return {check.name: check.zeta for check in wall.required_assessment.checks}


def test_that_a_mechanism_of_a_test_is_one_entry(monkeypatch):
    """It is refused by name with those there are; in the registry it is read and does what it says it does."""
    with pytest.raises(Exception, match="'made_up'.*one_sided"):
        outcome("made_up")
    monkeypatch.setitem(mechanisms.MECHANISMS, "made_up", Kinematics("made_up", one_way=True))
    assert outcome("made_up", restitution="one_sided_theoretical") == outcome("one_sided")
    monkeypatch.setitem(mechanisms.MECHANISMS, "made_up", Kinematics("made_up", both_ways=True))
    assert outcome("made_up") == outcome("two_sided") != outcome("one_sided")


def test_that_a_kind_of_hold_of_a_test_is_one_entry(monkeypatch):
    hold = {"h_m": 4.0, "evidence": {"kind": "survey"}}
    with pytest.raises(Exception, match="'made_up'.*ring_beam"):
        outcome("one_sided", hold=[hold | {"kind": "made_up"}])
    monkeypatch.setitem(CATALOGUE["word"], "choice_made_up", ("made up", "inventato"))
    monkeypatch.setitem(holds.HOLD_KINDS, "made_up", HoldKind("made_up", has_height=True))
    assert outcome("one_sided", hold=[hold | {"kind": "made_up"}]) == outcome("one_sided")
    monkeypatch.setitem(holds.HOLD_KINDS, "made_up", HoldKind("made_up", has_height=True, pulls=True))
    case = parse_case({"wall": [WALL | {"hold": [hold | {"kind": "made_up"}]}], "demand": DEMAND})
    assert case.wall[0].mechanism == "two_sided"  # it leans on nothing


def test_that_a_kind_of_load_of_a_test_is_one_entry(monkeypatch):
    load = {"kn_m": 8.0, "h_m": 4.0, "d_m": 0.2}
    with pytest.raises(Exception, match="'made_up'.*carried_mass"):
        outcome("one_sided", load=[load | {"kind": "made_up"}])
    monkeypatch.setitem(load_kinds.LOAD_KINDS, "made_up", LoadKind("made_up", is_weight=True, is_carried=True))
    carried = outcome("one_sided", load=[load | {"kind": "carried_mass"}])
    assert outcome("one_sided", load=[load | {"kind": "made_up"}]) == carried != outcome("one_sided")


@pytest.mark.parametrize("kind", MECHANISMS.values(), ids=str)
def test_that_a_mechanism_does_one_thing_or_stands_for_others(kind):
    does = [kind.one_way, kind.both_ways, kind.bends_up, kind.arches]
    assert sum(does) == (0 if kind.stands_for else 1)
    assert all(kinematics(name).name == name for name in kind.stands_for)
    assert kind.members == tuple(kinematics(name) for name in kind.stands_for or (kind.name,))


def test_that_a_draft_without_a_mechanism_does_nothing():
    kind = kinematics("")
    assert not (kind.turns_one_way or kind.rocks_both_ways or kind.bends)
