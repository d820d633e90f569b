"""The tab Note: pages as they print, a click that leads somewhere, search, zoom, and nothing left behind."""

import pytest

from tests.app.driving import run, settle

pytest.importorskip("typst")

from app.views.note_tab import Pages


@pytest.fixture
def shown(opened, application):
    run(application, opened)
    opened.navigator.show_page("note")
    tab = opened.pages["note"].content
    wait(application, tab)
    return tab


def wait(application, tab):
    settle(application, lambda: not tab.is_setting)


@pytest.mark.shows("window.note_pages")
def test_that_the_pages_are_those_of_the_note(opened, shown):
    assert len(shown.pages.images) == len(shown.pages.note.pages(30.0)) >= 3
    first = shown.pages.images[0]
    assert first.width() / first.height() == pytest.approx(210.0 / 297.0, rel=0.01)
    assert str(len(shown.pages.images)) in shown.word.text()


def test_that_a_click_leads_to_the_check_or_to_the_input_of_its_wall(opened, shown, application):
    places = shown.pages.places
    heading = next(place for place in places if place.get("wall") == 0 and place["page"] > 1)
    shown.paper.clicked.emit(heading["page"], heading["y"] + 8.0)
    assert opened.stages.front == "input" and opened.walls.isVisible() and opened.navigator.shown == 0
    number = next(place for place in places if "check" in place)
    shown.paper.clicked.emit(number["page"], number["y"] + 3.0)
    assert opened.navigator.page == "check" and opened.navigator.shown == 0
    opened.navigator.show_page("note")
    shown.paper.clicked.emit(1, 800.0)  # the foot of a page leads nowhere
    assert opened.navigator.page == "note"


def test_that_what_is_searched_is_found_page_after_page(opened, shown):
    shown.search.setText("FC")
    shown.find_next()
    first = shown.paper.found
    assert first is not None and shown.word.text().startswith("1 ")
    shown.find_next()
    assert shown.paper.found != first
    shown.search.setText("no such word")
    shown.find_next()
    assert shown.word.text() in ("not found", "non trovato")


def test_that_a_larger_page_is_the_same_page(opened, shown, application):
    shown.zoom.setCurrentIndex(shown.zoom.findData(100))
    wait(application, shown)
    before = shown.pages.images[0].width()
    shown.zoom.setCurrentIndex(shown.zoom.count() - 1)
    wait(application, shown)
    assert shown.pages.images[0].width() == pytest.approx(2 * before, abs=2)
    assert shown.paper.scale == pytest.approx(2.0 * 96.0 / 72.0)


def test_that_a_page_is_as_wide_as_the_tab_and_follows_it(opened, shown, application):
    bar = shown.view.horizontalScrollBar()
    assert bar.maximum() == 0 and shown.paper.width() > 0.9 * shown.view.viewport().width()
    before = shown.paper.width()
    opened.resize(opened.width() + 200, opened.height())
    settle(application, lambda: shown.paper.width() > before)


def test_that_a_note_that_is_set_for_the_first_time_while_the_window_shrinks_fits_it(opened, shown, application):
    shown.pages = Pages()  # none is there yet
    shown._set()
    opened.resize(opened.width() - 250, opened.height())
    wait(application, shown)
    assert shown.view.horizontalScrollBar().maximum() == 0


def test_that_a_note_on_its_way_is_left_when_another_result_comes(opened, shown, application, faults):
    shown.zoom.setCurrentIndex(0)
    left = shown.job
    opened.navigator.take(None)
    application.processEvents()
    assert opened.pages["note"].made is None or opened.pages["note"].made is not shown
    if left is not None:
        left.wait()
    application.processEvents()
    assert faults == []


def test_that_a_note_that_cannot_be_set_says_why(opened, application):
    opened.session.edit_section("report", logo="none.png")
    run(application, opened)
    opened.navigator.show_page("note")
    tab = opened.pages["note"].content
    wait(application, tab)
    assert "none.png" in tab.word.text() and tab.pages.images == []


@pytest.mark.shows("window.note_pages")
def test_that_a_judgement_typed_beside_the_pages_is_in_them_without_another_run(opened, shown, application):
    before = opened.session.result
    judgement = next(field for field in opened.stages.note_form.fields if field.key == "judgement")
    judgement.editor.setPlainText("The results agree with a static check by hand.\nThe wall is to be tied.")
    assert not opened.session.stale and opened.session.result.walls is before.walls
    wait(application, shown)
    text = " ".join(line for _, _, line in shown.pages.note.lines())
    assert "agree with a static check by hand" in text and "is to be tied" in text
    opened.session.undo()
    assert judgement.editor.toPlainText() == "" and not opened.session.stale


@pytest.mark.shows("note.office")
def test_that_a_short_note_has_fewer_pages_and_every_verdict(opened, shown, application):
    full = len(shown.pages.images)
    opened.session.edit_section("report", extent="short")
    wait(application, shown)
    assert len(shown.pages.images) < full
    text = " ".join(line for _, _, line in shown.pages.note.lines())
    for wall in opened.session.result.walls:
        assert wall.name in text
