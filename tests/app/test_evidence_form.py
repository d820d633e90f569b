"""The documents that show what raises zeta, the level of knowledge and the hinges in the forms."""

import tomllib

import pytest

pytest.importorskip("PySide6")

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from core.case import asked
from core.case.asked import ASKED, evidence_keys
from core.case.document import DemandEvidence, WallEvidence
from core.case.rules import parse_case, parse_draft
from core.case.writer import dumps
from core.study.run import run
from tests.app.driving import type_into
from tests.conftest import ROOT


def field(form, key):
    return next(one for one in form.fields if one.key == key)


@pytest.mark.parametrize("section", [asked.WALL, asked.DEMAND])
def test_that_a_document_can_be_given_in_the_window_for_every_key_that_the_table_asks_about(opened, section):
    """Whatever a verdict asks for is in the menu of its form, and is one that the file takes."""
    form = opened.walls.evidence if section == asked.WALL else opened.demand.evidence
    assert form.keys == evidence_keys(section)
    offered = [action.text() for action in form.add_button.menu().actions()]
    assert len(offered) == len(form.keys) == len(set(offered))
    assert {key for row in ASKED.values() if row.section == section for key in row.keys} <= set(form.keys)
    for key in form.keys:
        kinds = form.kind("", of=key).kinds
        assert kinds and set(kinds) <= set(field(form, "kind").entry.metadata["names"])


def test_that_a_document_is_given_saved_read_and_taken_back(opened, application):
    session = opened.session
    for form, key in ((opened.walls.evidence, "velocity_ratio"), (opened.demand.evidence, "q_code")):
        form.add(key)
        field(form, "kind").offer("test")
        type_into(field(form, "reference"), "PT-04")
        form.add(key)  # of a key there is one
    case = session.case
    assert case.wall[0].evidence == (WallEvidence("test", "PT-04", of="velocity_ratio"),)
    assert case.demand.evidence == (DemandEvidence("test", "PT-04", of="q_code"),)
    read = parse_draft(tomllib.loads(dumps(case)))
    assert read.wall[0].evidence == case.wall[0].evidence and read.demand.evidence == case.demand.evidence
    opened.demand.evidence.delete()
    assert session.case.demand.evidence == ()
    session.undo()
    assert session.case.demand.evidence == case.demand.evidence


def test_that_an_answer_leads_to_the_document_it_asks_for(opened):
    for form, key in ((opened.walls.evidence, "mass"), (opened.demand.evidence, "building")):
        opened.navigator.ask(f"reason:{key}")
        assert form.entry.of == key and field(form, "kind").isVisibleTo(opened)
        opened.navigator.ask(f"reason:{key}")
        assert [entry.of for entry in form.entries].count(key) == 1


def test_that_a_photograph_shows_no_strength_at_its_field(opened):
    form = opened.walls.evidence
    form.add("compressive_strength_mpa")
    field(form, "kind").offer("photograph")
    type_into(field(form, "reference"), "foto 7")
    assert opened.session.problem().code == "evidence_kind"
    field(form, "kind").offer("test")
    problem = opened.session.problem()
    assert problem is None or not problem.code.startswith("evidence")


@pytest.mark.parametrize("text, value", [("base", "base"), ("floors", "floors"), ("", None), ("3 6", (3.0, 6.0))])
def test_that_the_field_of_hinges_takes_words_and_heights(opened, text, value):
    field = opened.walls.fields["hinge_heights"]
    type_into(field, "4.5")
    field.editor.clear()
    type_into(field, text)
    if not text:
        type_into(field, "4")
        QTest.keyClick(field.editor, Qt.Key.Key_Backspace)
    assert opened.session.case.wall[0].hinge_heights == value
    field.editor.clearFocus()
    opened.walls.show_case()
    assert field.editor.text().replace(";", "") == text


WALL = {
    "name": "w",
    "height_m": 6.0,
    "thickness_m": 0.6,
    "mechanism": "one_sided",
    "base_z_m": 0.0,
    "unit_weight_kn_m3": 18.0,
    "hold": [{"kind": "cross_walls"}],
    "unloaded_confirmed": True,
}
ACROSS = {"number": 4, "thickness_m": 0.5, "brick_height_m": 0.2, "brick_length_m": 0.4}


@pytest.mark.parametrize(
    "wall, demand, wanted",
    [
        ({}, {"q_code": 5.0}, "q_code"),
        ({"return_walls": ACROSS, "length_m": 4.0}, {"ag_g": 0.125}, "return_walls"),
        (
            {"velocity_ratio": 0.0},
            {"ag_g": 0.32, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
            "velocity_ratio",
        ),
    ],
)
def test_that_every_document_the_verdict_asks_for_has_its_place(wall, demand, wanted):
    spectral = "spectrum" in demand
    table = {"wall": [{**WALL, **wall}], "demand": {"ag_g": 0.2, **demand}, "analysis": {"q_step": 0.05}}
    if spectral:
        table["generate"] = {"scatter": 0.0, "count": 3, "seed": 1}
    else:
        table["demand"]["soil_factor"] = 1.2
    case = parse_case(table)
    verdict = run(case, base_dir=ROOT).walls[0].assessment.verdict
    keys = {str(dict(one.values)["key"]) for one in verdict.to_do if one.code == "give_reason"}
    assert keys == {wanted} and keys <= {*evidence_keys(asked.WALL), *evidence_keys(asked.DEMAND)}
