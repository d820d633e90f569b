"""The tab Note: pages as they print, a click that leads somewhere, search, zoom, and nothing left behind."""

import pytest

from tests.app.conftest import SIZE, window_in
from tests.app.driving import run, settle

pytest.importorskip("typst")

from app.views.note_tab import Pages


def wait(application, tab):
    settle(application, lambda: not tab.is_setting)


def note_of(application, window):
    """The tab with the pages of the note of this window, run."""
    run(application, window)
    window.navigator.show_page("note")
    tab = window.pages["note"].content
    wait(application, tab)
    return tab


@pytest.fixture
def shown(opened, application):
    return note_of(application, opened)


@pytest.fixture(scope="module")
def shared(application, tmp_path_factory):
    """A window with the pages of a note, and its zoom."""
    with pytest.MonkeyPatch.context() as patch:
        made = window_in(application, tmp_path_factory.mktemp("note"), patch, [])
        window = next(made)
        yield window, note_of(application, window).zoom.currentIndex()
        next(made, None)


@pytest.fixture
def noted(shared, application):
    """That window, as it was, for tests that leave its case alone."""
    window, zoom = shared
    tab = window.pages["note"].content
    window.resize(*SIZE)
    window.navigator.show_page("note")
    tab.search.clear()
    tab.zoom.setCurrentIndex(zoom)
    application.processEvents()
    wait(application, tab)
    return window


@pytest.fixture
def pages(noted):
    """Its tab."""
    return noted.pages["note"].content


@pytest.mark.shows("window.note_pages")
def test_that_the_pages_are_those_of_the_note(noted, pages):
    assert len(pages.pages.images) == len(pages.pages.note.pages(30.0)) >= 3
    first = pages.pages.images[0]
    assert first.width() / first.height() == pytest.approx(210.0 / 297.0, rel=0.01)
    assert str(len(pages.pages.images)) in pages.word.text()


def test_that_a_click_leads_to_the_check_or_to_the_input_of_its_wall(noted, pages, application):
    places = pages.pages.places
    heading = next(place for place in places if place.get("wall") == 0 and place["page"] > 1)
    pages.paper.clicked.emit(heading["page"], heading["y"] + 8.0)
    assert noted.stages.front == "input" and noted.walls.isVisible() and noted.navigator.shown == 0
    number = next(place for place in places if "check" in place)
    pages.paper.clicked.emit(number["page"], number["y"] + 3.0)
    assert noted.navigator.page == "check" and noted.navigator.shown == 0
    noted.navigator.show_page("note")
    pages.paper.clicked.emit(1, 800.0)  # the foot of a page leads nowhere
    assert noted.navigator.page == "note"


def test_that_what_is_searched_is_found_page_after_page(noted, pages):
    pages.search.setText("FC")
    pages.find_next()
    first = pages.paper.found
    assert first is not None and pages.word.text().startswith("1 ")
    pages.find_next()
    assert pages.paper.found != first
    pages.search.setText("no such word")
    pages.find_next()
    assert pages.word.text() in ("not found", "non trovato")


def test_that_a_larger_page_is_the_same_page(noted, pages, application):
    pages.zoom.setCurrentIndex(pages.zoom.findData(100))
    wait(application, pages)
    before = pages.pages.images[0].width()
    pages.zoom.setCurrentIndex(pages.zoom.count() - 1)
    wait(application, pages)
    assert pages.pages.images[0].width() == pytest.approx(2 * before, abs=2)
    assert pages.paper.scale == pytest.approx(2.0 * 96.0 / 72.0)


def test_that_a_page_is_as_wide_as_the_tab_and_follows_it(noted, pages, application):
    bar = pages.view.horizontalScrollBar()
    assert bar.maximum() == 0 and pages.paper.width() > 0.9 * pages.view.viewport().width()
    before = pages.paper.width()
    noted.resize(noted.width() + 200, noted.height())
    settle(application, lambda: pages.paper.width() > before)


def test_that_a_note_that_is_set_for_the_first_time_while_the_window_shrinks_fits_it(noted, pages, application):
    pages.pages = Pages()  # none is there yet
    pages._set()
    noted.resize(noted.width() - 250, noted.height())
    wait(application, pages)
    assert pages.view.horizontalScrollBar().maximum() == 0


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


def test_that_pages_that_are_set_again_in_vain_leave_nothing_to_go_to(pages):
    assert pages.paper.at(pages.paper.rect().bottomRight()) is None and pages.paper.at(pages.paper.rect().center())
    pages._failed("the pages could not be set", "")
    pages.search.setText("SLV")
    pages.find_next()
    pages.show_wall(pages.result, pages.result.walls[0])
    assert pages.pages.images == [] and pages.paper.height() == pages.paper.top_of(1)


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
def test_that_a_brief_note_has_fewer_pages_than_the_full_one_and_every_wall(opened, shown, application):
    brief, text = len(shown.pages.images), " ".join(line for _, _, line in shown.pages.note.lines())
    for verdict in opened.session.result.verdicts:
        assert verdict.title in text
    opened.session.edit_section("report", extent="full")
    wait(application, shown)
    assert brief < len(shown.pages.images)
