"""The reasons of the engineer, the level of knowledge and the hinges in the forms."""

import tomllib
from dataclasses import fields, replace

import pytest

pytest.importorskip("PySide6")

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.input.reasons_form import favourable_demand_keys, favourable_wall_keys
from core.case.hold import Bars, Hold
from core.case.loads import Load, ReturnWalls
from core.case.rules import parse_case, parse_draft
from core.case.site import Building, BuildingMode, DemandJustification, HazardRow, Spectrum
from core.case.solids import Corner, Leaf, Wedges
from core.case.wall import WallJustification
from core.case.writer import dumps
from core.study.run import run
from tests.app.driving import rest, type_into
from tests.conftest import ROOT


def rows(form) -> set[str]:
    return {field.key for field in form.fields if not field.isHidden()}


def test_that_reasons_are_asked_where_a_value_raises_zeta_and_nowhere_else(opened, application):
    session, walls, demand = opened.session, opened.walls, opened.demand
    assert walls.reasons.isHidden() and rows(demand.reasons) == {"scatter"}  # its records are artificial
    mode = BuildingMode(0.26, 0.1, 0.3)
    session.edit(replace(session.case, building=Building(9.0, 3, modes=(mode,))))
    session.edit_section("demand", q_code=4.0, confidence_factor=1.2)
    of_others = {"histories", "count", "limit_state", "zeta_target", "soil_factor", "storeys"}
    of_the_place = {"nominal_life_years", "f0", "tc_star_s", "spectrum"}
    of_others |= of_the_place
    assert rows(demand.reasons) == {entry.name for entry in fields(DemandJustification)} - of_others
    session.edit_section("demand", limit_state="SLC", zeta_target=0.8, soil_factor=0.9)
    session.edit(replace(session.case, building=Building(9.0, 1, period_s=0.3)))
    session.edit(replace(session.case, analysis=replace(session.case.analysis, histories=False)))
    assert of_others - {"count"} - of_the_place <= rows(demand.reasons)
    hazard = (HazardRow(30.0, 0.06, 2.4, 0.3), HazardRow(2475.0, 0.4, 2.5, 0.35))
    spectrum = Spectrum("NTC2018", "B", 2.1, 0.06, "T1")
    session.edit_section("demand", nominal_life_years=50.0, use_class_factor=0.7, hazard=hazard, spectrum=spectrum)
    assert of_the_place - {"spectrum"} <= rows(demand.reasons)
    session.edit_section("demand", spectrum=Spectrum("EN1998", "B", type=1))
    assert of_the_place & rows(demand.reasons) == {"nominal_life_years", "spectrum"}
    session.edit(replace(session.case, building=Building(9.0, 3, modes=(mode,))))
    session.edit_wall(
        0,
        restitution="costa_upper",
        velocity_ratio=0.9,
        law="doherty",
        free_element=False,
        mechanism="both",
        hinge_heights="base",
        compressive_strength_mpa=2.0,
        unit_weight_kn_m3=18.0,
        return_walls=ReturnWalls(2, 0.4, 0.2, 0.3),
        return_wedges=Wedges(2, 0.4, 2.0),
        corner=Corner(2.0, 2.0, 0.4),
        leaf=Leaf(0.2),
        hold=(
            Hold("tie", h_m=2.0, out_kn_m=1.0, bar_length_m=8.0, elongation_m=0.1, prestress=0.2),
            Hold("tie", h_m=2.0, bar_length_m=8.0, bar=Bars(2, 16.0), slack_mm=2.0),
        ),
        load=(Load("thrust", -0.1, 2.0), Load("vertical", 5.0, 2.0, d_m=0.2, mass="none")),
    )
    assert rows(walls.reasons) == {entry.name for entry in fields(WallJustification)} - {"base_z_m", "contact"}
    session.edit(replace(session.case, building=Building(9.0, 3)))
    session.edit_wall(0, base_z_m=6.0)
    assert "base_z_m" in rows(walls.reasons) and "building" not in rows(demand.reasons)


def test_that_a_reason_is_typed_saved_read_and_taken_back(opened, application):
    session = opened.session
    session.edit_wall(0, restitution=None, velocity_ratio=0.9)
    session.edit_section("demand", q_code=4.0)
    for form, key in ((opened.walls.reasons, "velocity_ratio"), (opened.demand.reasons, "q_code")):
        (field,) = (one for one in form.fields if one.key == key)
        type_into(field, "tests of this masonry")
    case = session.case
    assert case.wall[0].justification.velocity_ratio == "tests of this masonry"
    assert case.demand.justification.q_code == "tests of this masonry"
    read = parse_draft(tomllib.loads(dumps(case)))
    assert read.wall[0].justification == case.wall[0].justification
    assert read.demand.justification == case.demand.justification
    # a reason that is given stays in sight when its value is gone
    session.edit_section("demand", q_code=2.0)
    assert rows(opened.demand.reasons) == {"q_code", "scatter"}
    field.editor.selectAll()
    QTest.keyClick(field.editor, Qt.Key.Key_Delete)
    rest(field)
    assert session.case.demand.justification is None and rows(opened.demand.reasons) == {"scatter"}
    session.undo()
    assert session.case.demand.justification.q_code == "tests of this masonry"


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
    "wall, demand, asked",
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
def test_that_every_reason_the_verdict_asks_for_has_its_row(wall, demand, asked):
    spectral = "spectrum" in demand
    table = {"wall": [{**WALL, **wall}], "demand": {"ag_g": 0.2, **demand}, "analysis": {"q_step": 0.05}}
    if spectral:
        table["generate"] = {"scatter": 0.0, "count": 3, "seed": 1}
    else:
        table["demand"]["soil_factor"] = 1.2
    case = parse_case(table)
    verdict = run(case, base_dir=ROOT).walls[0].assessment.verdict
    keys = {str(dict(one.values)["key"]) for one in verdict.to_do if one.code == "give_reason"}
    assert keys == {asked}
    assert keys <= favourable_wall_keys(case, case.wall[0]) | favourable_demand_keys(case)
