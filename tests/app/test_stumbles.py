"""Where a reader who timed an engineer's tasks stumbled: each was so once."""

import os
import re
from dataclasses import replace

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.look import language
from app.shell import client_view, finder
from app.views import answer_lines
from app.views.runs import time_before_motion
from core.case.hold import Bars, Hold
from core.case.loads import Load
from core.case.schema import Generate
from core.case.site import Spectrum
from core.case.variant_names import DESIGNED
from core.codes.national_hazard import municipality
from core.codes.outcomes import OUTCOMES
from core.errors import InputError
from core.text.sentence import Sentence
from tests.app.driving import run, settle, type_into
from tests.conftest import ROOT


def choose(field, name) -> None:
    """A name of a list, as a click has it."""
    field.editor.setCurrentIndex(field.editor.findData(name))
    field.editor.activated.emit(field.editor.currentIndex())


def test_that_a_level_of_knowledge_proposes_its_confidence_factor_and_none_below_it(opened):
    fields, session = opened.demand.fields, opened.session
    for level, factor in (("LC2", 1.2), ("LC3", 1.0), ("LC1", 1.35), ("LC3", 1.0)):
        choose(fields["knowledge_level"], level)
        assert session.case.demand.confidence_factor == factor
    type_into(fields["confidence_factor"], "1.1")
    choose(fields["knowledge_level"], "LC2")
    assert session.case.demand.confidence_factor == 1.2
    type_into(fields["confidence_factor"], "1.3")
    choose(fields["knowledge_level"], "LC3")
    assert session.case.demand.confidence_factor == 1.3
    session.undo()
    assert (session.case.demand.knowledge_level, session.case.demand.confidence_factor) == ("LC2", 1.3)


def test_that_a_table_of_walls_asks_for_its_demand_too(opened, monkeypatch):
    from app.shell import first_run

    monkeypatch.setattr(opened.walls, "load_table", opened.walls.add)
    opened.show_first_run()
    opened.activateWindow()
    first_run.open_first_choice(opened, "table")
    assert opened.focusWidget() is opened.demand.fields["ag_g"].editor
    words = " ".join(problem.words for problem in opened.missing.problems)
    assert "a_g" in words and opened.walls.fields["base_z_m"].caption.text() in words


def test_that_a_base_above_the_ground_asks_for_its_building_before_the_run_and_in_the_answer(opened, application):
    opened.session.edit_wall(0, base_z_m=6.0)
    opened.navigator.show_input("wall", 0)
    (problem,) = opened.missing.problems
    assert "building" in problem.words and opened.run_button.isEnabled()
    opened.activateWindow()
    problem.lead()
    assert opened.stages.input.kind == "building" and opened.session.case.building.height_m == ""
    assert opened.focusWidget() is opened.demand.building.fields[0].editor
    opened.session.undo()
    run(application, opened)
    opened.navigator.show_page("check")
    content = opened.pages["check"].content
    assert "building" in content.no_peaks.text() and "records" not in content.no_peaks.text()
    content.to_do.words.linkActivated.emit(re.findall(r"href='([^']*)'", content.to_do.words.text())[0])
    assert opened.stages.input.kind == "building" and opened.session.case.building is not None
    assert not any("motion above the ground" in one.words for one in opened.missing.problems)


def test_that_a_restraint_that_is_asked_for_is_named_as_its_field_and_found(opened, application):
    opened.session.edit_wall(0, mechanism="one_sided")
    run(application, opened)
    content = opened.pages["check"].content
    words = content.to_do.words.text()
    assert "href='holds'" in words
    opened.activateWindow()
    content.to_do.words.linkActivated.emit("holds")
    assert opened.stages.front == "input" and opened.focusWidget() is opened.walls.holds.add_button


@pytest.mark.parametrize("bar", [None, Bars(2, 20.0)])
def test_that_a_tie_that_is_too_strong_is_marked_and_led_to(opened, bar):
    load = Load("vertical", 5.0, 5.0, 0.25, "none")
    tie = Hold("tie", h_m=2.5, out_kn_m=None if bar else 400.0, bar_length_m=5.0)
    holds = Hold("contact"), replace(tie, bar=bar and replace(bar, number=60))
    opened.session.edit_wall(0, load=(load,), hold=holds, unit_weight_kn_m3=18.0, length_m=2.0)
    opened.navigator.show_input("wall", 0)
    (problem,) = opened.missing.problems
    assert "lower the force" in problem.words and "missing" not in opened.missing.heading.text()
    opened.activateWindow()
    problem.lead()
    form = opened.walls.holds
    key = "diameter_mm" if bar else "out_kn_m"
    field = next(field for field in (*form.fields, *form.bars.fields) if field.key == key)
    assert form.list.currentRow() == 1 and opened.focusWidget() is field.editor and field.rule


def test_that_of_several_fields_the_empty_one_is_led_to_and_its_section_unfolds(opened):
    opened.session.edit_wall(0, load=(Load("thrust", 2.0, 5.0),))
    opened.navigator.show_input("wall", 0)
    (problem,) = opened.missing.problems
    opened.activateWindow()
    problem.lead()
    assert opened.focusWidget() is opened.walls.fields["unit_weight_kn_m3"].editor
    assert opened.walls.fields["unit_weight_kn_m3"].isVisible()


def test_that_the_answer_leads_to_the_bars_it_asks_for(opened, application):
    tie = Hold("tie", h_m=4.5, out_kn_m=4.0, bar_length_m=5.0, elongation_m=0.25)
    opened.session.edit_wall(0, hold=(tie,), unit_weight_kn_m3=18.0, mechanism="one_sided")
    assert answer_lines._target(Sentence("reason", "lift_anchorage")) == "holds"
    assert answer_lines._target(Sentence("reason", "lift_mass")) == "reason:mass"
    opened.activateWindow()
    opened.navigator.ask("key:anchorage_kn")
    assert opened.focusWidget() is opened.walls.holds.bars and opened.walls.holds.bars.isVisible()
    opened.navigator.ask("reason:velocity_ratio")
    assert opened.walls.evidence.isAncestorOf(opened.focusWidget())


@pytest.mark.parametrize("text", ["grid", "municip", "coordinates", "latitude", "town"])
def test_that_the_place_is_found(opened, text):
    found = finder.Finder(opened)
    found.line.setText(text)
    assert {"Municipality", "Coordinates", "From the place (national grid)"} & {one.words for one in found.fitting}


@pytest.mark.parametrize("language", ["en", "it"])
@pytest.mark.parametrize(("typed", "first"), [("ag", "a_g"), ("a_g", "a_g"), ("fc", "FC")])
def test_that_a_symbol_finds_its_field(opened, language, typed, first):
    opened.set_choice("language", language)
    found = finder.Finder(opened)
    found._look(typed)
    assert found.fitting[0].words.split()[0] == first
    opened.set_choice("language", "en")


def test_that_a_municipality_that_is_found_gives_the_demand_and_leads_to_the_soil(opened):
    opened.session.edit(replace(opened.session.case, demand=None))
    opened.activateWindow()
    found = finder.Finder(opened)
    found.line.setText("laquila")
    assert found.fitting[0].words.startswith("L'Aquila (AQ)")
    found._go()
    case = opened.session.case
    assert case.site.municipality == "L'Aquila" and case.demand.ag_g == pytest.approx(0.261, abs=0.001)
    assert opened.stages.input.kind == "demand"
    assert opened.focusWidget() is opened.demand.fields["soil"].editor
    opened.session.undo()
    assert opened.session.case.site is None and opened.session.case.demand is None


def test_that_title_client_and_logo_stand_beside_the_pages_of_the_note(opened):
    form = opened.stages.note_form
    type_into(form.title_field, "South wall")
    type_into(next(field for field in form.fields if field.key == "client"), "Town of L'Aquila")
    assert opened.session.case.title == "South wall" and opened.session.case.report.client == "Town of L'Aquila"
    assert opened.analysis.title_field.editor.text() == "South wall"
    titles = [one for one in finder.entries_of(opened) if one.words.startswith("Title")]
    assert len(titles) == 1


def test_that_an_animation_begins_as_the_wall_begins_to_move_and_its_button_says_what_it_does(opened, application):
    run(application, opened)
    opened.navigator.show_page("histories")
    content = opened.pages["histories"].content
    first = np.flatnonzero(content.history.rotation)[0] * content.motion.time_step
    content.set_time(0.0)
    content.walls.play.click()
    assert content.walls.started == pytest.approx(max(0.0, first - 0.5)) and content.walls.play.text() == "Pause"
    content.walls.play.click()
    assert content.walls.play.text() == "Play"
    assert time_before_motion(np.zeros(9), 0.01) == 0.0


@pytest.mark.parametrize("tongue", ["en", "it"])
def test_that_the_client_reads_no_word_of_the_code(opened, application, tongue):
    run(application, opened)
    side = client_view.sides_of(opened.session.result, opened.navigator.wall)[0]
    language.set_language(tongue)
    for code in OUTCOMES:
        verdict = replace(side.wall.assessment.verdict, code=code)
        wall = replace(side.wall, assessment=replace(side.wall.assessment, verdict=verdict))
        for tone in ("good", "amber", "bad"):
            words = client_view.words_of(replace(side, wall=wall, tone=tone))
            assert not {"refined", "raffinato", "q", "indicative", "indicativa"} & set(re.findall(r"\w+", words))
            if OUTCOMES[code].tone == "bad":
                assert "not sufficient" in words or "non sufficiente" in words
    language.set_language("en")


def test_that_a_stage_without_a_result_says_what_to_do_and_leads_there(opened, application):
    for name in ("check", "histories", "capacity", "intensity", "validation"):
        opened.navigator.show_page(name)
        page = opened.pages[name]
        assert page.made is None and page.word.isVisible() and "F5" in page.word.text(), name
    opened.session.edit_wall(0, base_z_m=None)
    assert "base above ground" in opened.pages["validation"].word.text().lower()
    opened.activateWindow()
    opened.pages["validation"].word.linkActivated.emit("do")
    assert opened.stages.front == "input" and opened.focusWidget() is opened.walls.fields["base_z_m"].editor
    opened.session.undo()
    opened.navigator.show_page("histories")
    opened.pages["histories"].word.linkActivated.emit("do")
    settle(application, lambda: opened.runner.job is None and opened.session.result is not None)
    opened.navigator.show_page("histories")
    application.processEvents()
    assert not opened.pages["histories"].word.isVisible() and opened.pages["histories"].made.isVisible()


def test_that_hinges_that_are_not_given_are_said_in_their_field(opened):
    field = opened.walls.fields["hinge_heights"]
    assert field.editor.placeholderText() == "the usual ones: 0 m"
    opened.session.edit_wall(0, load=(Load("vertical", 5.0, 2.5, 0.25, "none"),), unit_weight_kn_m3=18.0)
    assert field.editor.placeholderText() == "the usual ones: 0; 2.5 m" and field.value is None
    opened.session.edit_wall(0, height_m="")
    assert field.editor.placeholderText() == ""


def test_that_scaling_can_be_pressed_only_where_it_can_do_something(opened):
    button = opened.records.scale_button
    assert not button.isEnabled() and "spectrum" in button.toolTip()
    opened.session.edit_section("demand", soil_factor=None, spectrum=Spectrum("EN1998", "B", type=1))
    assert button.isEnabled()
    opened.session.edit_section("demand", demand_scaling="pga")
    assert not button.isEnabled() and "PGA" in button.toolTip()
    opened.session.undo()
    opened.session.edit(replace(opened.session.case, record=(), generate=Generate(2, scatter=0.0)))
    assert not button.isEnabled() and "from files" in button.toolTip()


def test_that_a_variant_is_named_in_the_language_of_the_window(opened, application):
    opened.walls.add_variant()
    opened.session.edit_wall(1, thickness_m=0.6)
    run(application, opened)
    for tongue, words in (("en", "as designed"), ("it", "progetto")):
        opened.set_choice("language", tongue)
        opened.navigator.pick(1)
        shown = [opened.pages["check"].content.heading.text(), *(row.text for row in opened.tree.rows)]
        opened.navigator.show_page("histories")
        shown += [opened.pages["histories"].content.words.text(), *(one.words for one in finder.entries_of(opened))]
        assert sum(words in one for one in shown) >= 4
        assert tongue == "it" or not any(DESIGNED in one for one in shown)


def test_that_to_strengthen_leads_to_the_holds_of_the_variant(opened):
    opened.activateWindow()
    opened.navigator.ask("variant")
    assert opened.walls.wall.variant == DESIGNED and opened.walls.holds.isVisible()
    assert opened.focusWidget() is opened.walls.holds.add_button


def test_that_an_unknown_municipality_names_none_near_where_there_is_none():
    with pytest.raises(InputError) as caught:
        municipality("Zzyzx")
    assert "near" not in str(caught.value) and "simili" not in caught.value.text("it")
    with pytest.raises(InputError) as caught:
        municipality("Norciaa")
    assert "Norcia" in str(caught.value)


def test_that_what_limits_a_verdict_says_nothing_of_the_law_of_research(opened, application):
    motions = sorted((ROOT / "tests" / "motions").glob("noise_[23].txt"))
    opened.records.take(motions, ask=False)
    settle(application, lambda: len(opened.records.motions) == 3)
    run(application, opened)
    assert {warning.code for warning in opened.navigator.wall.warnings} & {"no_power_law", "narrow_si"}
    content = opened.pages["check"].content
    behind = {fact.label: "".join(fact.lines) for fact in content.drawer.facts}
    assert "q_eff" not in content.to_do.words.text() + behind["Limits"]
    assert "q_eff" in behind["Notes"]


def test_that_an_answer_without_a_check_leads_to_what_makes_one(opened, application):
    opened.session.edit(replace(opened.session.case, record=()))
    settle(application, lambda: not opened.records.pending)
    run(application, opened)
    assert opened.navigator.wall.assessment.verdict.code == "undetermined"
    content = opened.pages["check"].content
    words = content.to_do.words.text()
    assert content.to_do.isVisibleTo(content) and "href='demand'" in words


def test_that_a_spectrum_without_records_offers_motions_for_it(opened, application):
    offer = opened.demand.no_records
    opened.navigator.show_input("demand")
    opened.session.edit(replace(opened.session.case, record=()))
    assert not offer.isVisible()
    opened.session.edit_section("demand", soil_factor=None, spectrum=Spectrum("EN1998", "B", type=1))
    assert offer.isVisible()
    offer.click()
    assert opened.session.case.generate.count == 14 and not offer.isVisibleTo(opened.demand.view)
    settle(application, lambda: not opened.records.pending)
