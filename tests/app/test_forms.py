"""Every form shows every state of a case: also one in the making, also where another form fails."""

import os
from dataclasses import fields, replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.input.building_form import BuildingForm
from app.input.fields import ChoiceField
from app.input.hazard_form import HazardForm
from app.input.impact_form import ImpactForm, captions, formula_of, named_models, scopes
from app.input.loads_form import LoadsForm
from app.look.language import current_language, set_language
from app.work.session import Session
from core.case.loads import Load
from core.case.site import Demand, Spectrum
from core.case.wall import Wall
from core.rocking.methods import METHODS
from core.text.catalogue import CATALOGUE
from core.wall import restitution as of_restitution
from core.wall.impact import Restitution
from core.wall.moment_rotation import LAWS
from core.wall.restitution import MODELS, Contact, Model


def choices(section, key):
    """The names a key accepts."""
    return next(entry for entry in fields(section) if entry.name == key).metadata["names"]


LOADS = [
    Load(kind, kn_m, h_m, d_m, mass)
    for kind in choices(Load, "kind")
    for kn_m in ("", 10.0)
    for h_m in ("", 5.0)
    for d_m, mass in ((None, None), (0.3, None), (None, "moving"), (0.3, "moving"))
]
"""Loads as a person enters them, some of their values still to be given."""


MECHANISMS = ["", *choices(Wall, "mechanism")]


@pytest.mark.parametrize("mechanism", MECHANISMS)
@pytest.mark.parametrize("weight", [None, *(pytest.param(one, marks=pytest.mark.long) for one in ("", 18.0))])
def test_that_a_load_in_the_making_is_shown_by_every_form(opened, faults, mechanism, weight):
    """In the short form a fifth of the loads for each mechanism, each load for one."""
    before = opened.session.case
    for load in LOADS if weight is not None else LOADS[MECHANISMS.index(mechanism) :: len(MECHANISMS)]:
        opened.session.edit_wall(0, load=(load,), unit_weight_kn_m3=weight or None, mechanism=mechanism, length_m=4.0)
        assert opened.walls.loads.list.count() == 1 and faults == [], load
        opened.session.undo()
        assert opened.session.case == before


def test_that_a_carried_mass_to_be_sized_leaves_undo_alive(opened, faults):
    before = opened.session.case
    opened.walls.loads.add("carried_mass")
    assert faults == [] and opened.actions_of.undo.isEnabled()
    assert "still missing" in opened.walls.impact.formula.text()
    opened.actions_of.undo.trigger()
    assert opened.session.case == before


@pytest.mark.parametrize(
    "form",
    [
        *(LoadsForm, BuildingForm, "walls", "tree"),
        *(
            pytest.param(form, marks=pytest.mark.long)
            for form in (ImpactForm, HazardForm, "demand", "analysis", "records")
        ),
    ],
)
def test_that_a_form_that_fails_stops_no_other(opened, faults, monkeypatch, form):
    kind = type(getattr(opened, form)) if isinstance(form, str) else form
    slots = ("_show_sizes", "_show_demand", "show_case", "show_rows")
    broken = next(name for name in slots if hasattr(kind, name))

    failing = [True]

    def fail(*_):
        if failing:
            raise RuntimeError("broken on purpose")

    monkeypatch.setattr(kind, broken, fail)
    opened.build()  # forms that fail are made
    faults.clear()
    report = replace(opened.session.case.report, client="the client")
    changed = replace(opened.session.case, report=report, building=None)
    wall = replace(changed.wall[0], name="another", load=(Load("thrust", 1.0, 4.0),))
    opened.session.edit(replace(changed, wall=(wall,), demand=replace(changed.demand, ag_g=0.31)))
    assert faults and all(str(fault) == "broken on purpose" for fault in faults)
    faults.clear()
    shown = {
        "walls": opened.walls.fields["name"].editor.text() == "another",
        LoadsForm: opened.walls.loads.list.count() == 1,
        "demand": opened.demand.fields["ag_g"].editor.text() == "0.31",
        "analysis": opened.analysis.of_report[0].editor.text() == "the client",
        "title": opened.windowTitle().startswith("*"),
        "tree": "another" in [row.text for row in opened.tree.rows],
        "undo": opened.actions_of.undo.isEnabled(),
    }
    assert {name for name, fresh in shown.items() if not fresh} <= {form}
    opened.actions_of.undo.trigger()
    assert not opened.session.dirty and opened.windowTitle().startswith("small")
    failing.clear()
    faults.clear()


def test_that_one_fault_is_one_dialog_until_it_is_closed(opened, faults, monkeypatch, application):
    from app.shell import start

    said = []
    monkeypatch.setattr(opened.runner, "fail", lambda sentence, log: said.append(sentence))
    start.install_hook(opened)
    import sys

    for text in ("one", "one", "two"):
        sys.excepthook(ValueError, ValueError(text), None)
    application.processEvents()
    assert said == ["ValueError: one", "ValueError: two"]
    sys.excepthook(ValueError, ValueError("one"), None)
    application.processEvents()
    assert said[-1] == "ValueError: one" and len(said) == 3


def test_that_a_wall_held_at_its_top_shows_only_what_it_needs(opened, faults):
    form = opened.walls
    opened.session.edit_wall(0, height_m=3.0, thickness_m=0.3, slenderness_deg=None, height_over_thickness=None)
    form.mechanisms["vertical_bending"].click()
    assert form.wall.bends and faults == []
    assert all(form.sections[name].isHidden() for name in ("held", "hinges", "impact"))
    assert form.holds.isVisibleTo(form)
    opened.session.edit_wall(0, unit_weight_kn_m3=18.0)
    assert "h₁ 2.70 m" in form.summary.text() and len(form.drawing.bent.hinges) == 3
    opened.session.edit_wall(0, hinge_heights="base")  # what stands there all the same is shown, and named
    assert not form.sections["hinges"].isHidden()
    assert [error.code for error in opened.session.problems()] == ["bending_finds_hinge"]
    opened.session.edit_wall(0, hinge_heights=None)
    form.mechanisms["one_sided"].click()
    assert not form.sections["impact"].isHidden() and form.drawing.bent.hinges == () and faults == []


# what is added to the core is complete in the forms


@pytest.mark.parametrize("language", ["en", "it"])
@pytest.mark.parametrize("model", MODELS)
def test_that_every_restitution_model_has_its_words_in_the_form(application, tmp_path, model, language):
    set_language(language)
    try:
        assert captions()[model] and scopes()[model]
        assert f"choice_{model}" in CATALOGUE["word"]
        session = Session(tmp_path)
        form = ImpactForm(session, lambda: 0)
        ratio = 0.9 if model == "user" else None
        mechanism = "one_sided" if MODELS[model].one_sided else "two_sided"
        wall = Wall("w", mechanism, 7.0, 0.83, restitution=model, velocity_ratio=ratio)
        session.edit(replace(session.case, wall=(wall,)))
        form.show_case()
        assert form.model.editor.currentData() == model
        assert form.model.editor.currentText() == named_models()[model]
        found = wall.restitution_of(mechanism).ratio_at_rest
        assert f"{found:.4f}" in form.formula.text().replace(",", ".")
        assert scopes()[model] in form.formula.text()
        form.deleteLater()
    finally:
        set_language("en")


def test_that_the_form_has_the_formula_of_the_note_in_numbers(application):
    """The block of 7.0 x 0.83 m: 2 R^2 m / I_0 is 1.5 of every rectangle."""
    block = Wall("w", "two_sided", 7.0, 0.83).block()
    inner, top = "(1 − 1.5 sin²α)", "|1 − 1.5 cos²α|"
    assert formula_of("sorrentino_experimental", block) == f"e = 0.95 {inner} (Eq. 5, α = 6.7621°)"
    assert formula_of("one_sided_experimental", block).startswith(f"e = 1.18 {inner}² {top} (Eq. 7, v = 0")
    assert formula_of("costa_upper", block) == "e (Costa et al. 2013)" and formula_of("user", block) == "e"
    moved = formula_of("one_sided_theoretical", block, Contact(0.83, 7.0))
    assert moved == "e = min((1 − 0.020796)² |1 − 1.4792|, 1) (Eq. 6, α = 6.7621°)"
    set_language("it")
    try:
        assert formula_of("housner", block) == "e = (1 − 1,5 sin²α) (Eq. 4, α = 6,7621°)"
    finally:
        set_language("en")


def test_that_the_form_has_words_for_no_model_that_is_not_there():
    assert set(captions()) - {None} == set(scopes()) == set(MODELS)


def test_that_a_model_whose_words_are_still_missing_is_shown_with_its_source(opened, faults, monkeypatch):
    """The first step of "Add a restitution model": in MODELS and in `restitution`, nowhere else."""
    monkeypatch.setitem(MODELS, "mine", Model("Eq. 1 of mine", one_sided=False, by_theory=False))
    real = of_restitution.restitution

    def with_mine(block, model, *rest):
        return Restitution("mine", 0.7531) if model == "mine" else real(block, model, *rest)

    monkeypatch.setattr("core.case.wall.restitution", with_mine)
    opened.build()
    opened.session.edit_wall(0, restitution="mine")
    words = opened.walls.impact.formula.text()
    assert faults == [] and "0.7531" in words and "Eq. 1 of mine" in words
    editor = opened.walls.impact.model.editor
    assert editor.currentData() == "mine" and "mine" in editor.currentText()


@pytest.mark.parametrize("name", LAWS)
def test_that_every_law_is_in_the_form_with_its_ends(opened, name):
    opened.session.edit_wall(0, law=name)
    law = opened.walls.impact.law
    assert law.currentData() == name
    ends = LAWS[name].elastic_limit, LAWS[name].plateau_end
    if not LAWS[name].is_rigid:
        assert f"{ends[0]:g}, {ends[1]:g}" in law.currentText()
    assert opened.walls.impact.law_curve.curve.getData()[0].size > 2
    law.activated.emit(law.findData("own"))
    law.activated.emit(law.findData(name))
    assert opened.session.case.wall[0].law == name


def test_that_every_mechanism_has_its_button(opened):
    assert set(opened.walls.mechanisms) == set(choices(Wall, "mechanism"))
    for name, button in opened.walls.mechanisms.items():
        button.click()
        assert opened.session.case.wall[0].mechanism == name
        assert button.text() and button.toolTip() and not button.icon().isNull()


def test_that_every_kind_of_load_is_in_the_menu_and_in_the_list(opened):
    form = opened.walls.loads
    for action in form.add_button.menu().actions():
        action.trigger()
    assert [load.kind for load in opened.session.case.wall[0].load] == list(choices(Load, "kind"))
    words = [form.list.item(k).text().split(",")[0] for k in range(form.list.count())]
    assert len(set(words)) == len(words)


def test_that_every_method_is_in_the_form(opened):
    method = next(analysi for analysi in opened.analysis.of_analysis if analysi.key == "method")
    assert set(method.words) == {"auto", *METHODS}
    for name in METHODS:
        opened.session.edit_section("analysis", method=name)
        assert method.editor.currentData() == name


@pytest.mark.parametrize("language", ["en", "it"])
def test_that_every_list_of_a_form_offers_what_its_key_accepts(opened, language):
    opened.set_choice("language", language)
    lists = opened.findChildren(ChoiceField)
    assert len(lists) > 12 and current_language() == language
    for field in lists:
        if field.section is not None:
            rule = next(e for e in fields(field.section) if e.name == field.key).metadata
            names = set(rule["names"]) if "names" in rule else {1, 2}
            assert set(field.words) - {None} == names, field.key
        assert all(field.words.values()) and len(set(field.words.values())) == len(field.words)


def test_that_a_list_shows_nothing_for_what_is_not_in_it(opened):
    """A spectrum without its topography comes back from a file as None: the first of the list is not it."""
    opened.demand._kind_chosen(opened.demand.kind.findData("NTC2018"))
    spectrum = replace(opened.session.case.demand.spectrum, topography=None, soil="")
    opened.session.edit_section("demand", spectrum=spectrum)
    assert opened.demand.fields["topography"].editor.currentIndex() == -1
    assert opened.demand.fields["soil"].editor.currentIndex() == -1


def test_that_a_wall_without_a_mechanism_has_no_estimate(opened):
    """Its restitution may be given by a number, which asks for no mechanism."""
    spectrum = Spectrum("EN1998", type=1, soil="B")
    opened.session.edit(replace(opened.session.case, demand=Demand(0.2, spectrum=spectrum)))
    opened.session.edit_wall(0, restitution=None, velocity_ratio=0.9)
    with_one = opened.walls.summary.text()
    opened.session.edit_wall(0, mechanism="")
    assert "α" in opened.walls.summary.text() and "q SLV" in with_one
    assert "q SLV" not in opened.walls.summary.text()
