"""The frame of the window: stages, tree, what is missing, finding, the drawing under the hand, the client's view."""

import gc
import html
import os
from dataclasses import replace

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest

from app.look import theme
from app.look.hold_drawing import HoldMark, find_hold_marks
from app.shell import client_view, finder, first_run
from core.case.hold import Hold
from core.case.loads import Load
from core.case.reader import read_case
from core.case.site import Demand
from core.case.variant_names import AS_IS, DESIGNED
from tests.app.driving import run, settle


def chips(window) -> dict[str, str]:
    return {row.text: row.chip for row in window.tree.rows}


@pytest.mark.shows("window.stages")
def test_that_a_run_leads_to_the_answer_and_the_tree_says_zeta(opened, application):
    assert opened.stages.front == "input" and chips(opened)["w"] == ""
    opened.session.edit_section("report", author="N. N.")
    run(application, opened)
    zeta = opened.session.result.walls[0].assessment.verdict.zeta_e
    assert opened.navigator.page == "check" and chips(opened)["w"] == f"{zeta:.2f}"
    content = opened.pages["check"].content
    assert content.ladder.rungs[0].zeta == zeta and f"{zeta:.2f}" in content.zeta.text()
    # what is to be done is in sight; what limits the verdict, and notes, are behind their numbers
    verdict = opened.session.result.walls[0].assessment.verdict
    shown = content.to_do.words.text()
    assert verdict.to_do and all(html.escape(action.text("en").split(" (")[0]) in shown for action in verdict.to_do)
    labels = [fact.label for fact in content.drawer.facts]
    limits = content.drawer.facts[labels.index("Limits")]
    assert len(limits.lines) >= len(verdict.limits) and limits.value == str(len(limits.lines))
    assert content.drawer.panel.isHidden()
    for label in ("Limits", "Notes"):
        content.drawer.buttons[labels.index(label)].click()
        assert content.drawer.panel.isVisible()
        assert content.drawer.facts[labels.index(label)].lines[0] in content.drawer.panel.text()
    assert [button.isChecked() for button in content.drawer.buttons].count(True) == 1
    for number, name in enumerate(("input", "answer", "why", "report"), start=1):
        QTest.keyClick(opened, getattr(Qt.Key, f"Key_{number}"), Qt.KeyboardModifier.AltModifier)
        opened.navigator.show_stage(name)
        assert opened.stages.front == name and opened.header.buttons[name].isChecked()


@pytest.mark.shows("window.missing")
def test_that_all_that_is_missing_is_listed_each_with_its_field(opened, application):
    opened.walls.add()
    opened.session.edit(replace(opened.session.case, demand=Demand("")))
    opened.navigator.show_input("wall", 1)
    words = [problem.words for problem in opened.missing.problems]
    assert len(words) >= 3 and not opened.run_button.isEnabled() and opened.missing.isVisible()
    for k, problem in enumerate(opened.missing.problems):
        opened.missing.lines.linkActivated.emit(str(k))
        application.processEvents()
        assert opened.stages.front == "input", problem.words
    opened.navigator.show_stage("answer")
    assert opened.header.notice.isVisible() and str(len(words)) in opened.header.notice.text()


@pytest.mark.shows("window.find")
def test_that_a_field_a_wall_and_an_action_are_found_by_name(opened):
    found = finder.Finder(opened)
    found.line.setText("modulus")
    assert found.fitting and "modulus" in found.fitting[0].words.lower()
    found._go()
    assert opened.walls.fields["elastic_modulus_mpa"].isVisible()
    gc.collect()
    assert opened.actions_of.recent.title()  # to look through the menus takes none of them away
    for words, shown in (("paste walls", "Paste walls"), ("w", "w")):
        again = finder.Finder(opened)
        again.line.setText(words)
        assert any(entry.words.startswith(shown) for entry in again.fitting)


@pytest.mark.shows("window.drawing")
def test_that_the_drawing_leads_to_fields_and_drags_a_load(opened, application):
    load = Load("vertical", 5.0, 3.0, 0.25, "none")
    opened.session.edit_wall(0, load=(load,), unit_weight_kn_m3=18.0)
    opened.navigator.show_input("wall", 0)
    application.processEvents()
    drawing = opened.walls.drawing
    drawing.grab()
    area = next(area for area, kind, _ in drawing.spots if kind == "load")
    at = area.center().toPoint()
    QTest.mousePress(drawing, Qt.MouseButton.LeftButton, pos=at)
    assert opened.walls.sections["loads"].head.isChecked()
    level = QPoint(at.x(), round(drawing.base_y - 4.2 * drawing.scale))
    event = QTest.mouseMove
    event(drawing, level)
    drawing.dragged = "load", 0
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QMouseEvent

    left = Qt.MouseButton.LeftButton
    moved = QMouseEvent(QEvent.Type.MouseMove, QPointF(level), QPointF(level), left, left, Qt.KeyboardModifier(0))
    application.sendEvent(drawing, moved)
    QTest.mouseRelease(drawing, left, pos=level)
    assert opened.session.case.wall[0].load[0].h_m == pytest.approx(4.2, abs=0.05)
    opened.session.undo()
    assert opened.session.case.wall[0].load[0].h_m == 3.0


@pytest.mark.shows("window.drawing")
def test_that_holds_are_drawn_where_they_are_dashed_without_a_strength_and_dragged(opened, application):
    held = Hold("floor", h_m=3.0, out_kn_m=12.0), Hold("roof", h_m=6.0), Hold("contact", from_m=1.0, to_m=2.0)
    opened.session.edit_wall(0, mechanism="one_sided", hold=held)
    opened.navigator.show_input("wall", 0)
    application.processEvents()
    drawing = opened.walls.drawing
    drawing.grab()
    assert [(mark.low, mark.high, mark.words) for mark in drawing.holds] == [
        (3.0, 3.0, "12 kN/m"),
        (6.0, 6.0, ""),
        (1.0, 2.0, ""),
    ]
    area = next(area for area, *spot in drawing.spots if spot == ["hold", 1])
    assert abs(area.center().y() - (drawing.base_y - 6.0 * drawing.scale)) < 1.0
    drawing.picked.emit("hold", 1)
    assert opened.walls.holds.list.currentRow() == 1 and opened.walls.sections["holds"].head.isChecked()
    drawing.moved.emit("hold", 1, 5.5)
    drawing.moved.emit("hold", 2, 2.5)
    assert [(hold.h_m, hold.to_m) for hold in opened.session.case.wall[0].hold] == [
        (3.0, None),
        (5.5, None),
        (None, 2.5),
    ]
    assert find_hold_marks(replace(opened.session.case.wall[0], hold=()), 7.0) == [HoldMark(None, 0.0, 7.0)]
    assert find_hold_marks(replace(opened.session.case.wall[0], mechanism="two_sided"), 7.0) == []


@pytest.mark.shows("window.client")
def test_that_a_variant_is_one_click_and_the_client_sees_before_and_after(opened, application, tmp_path):
    opened.walls.add_variant()
    assert [wall.variant for wall in opened.session.case.wall] == [AS_IS, DESIGNED]
    assert opened.walls.current == 1
    opened.session.edit_wall(1, thickness_m=0.8)
    record = opened.session.case.record[0]
    assert record.include
    run(application, opened)
    opened.navigator.pick(0)
    found = opened.session.result  # of records as they are given, which are no share of the demand
    assert [side.share for side in client_view.sides_of(found, opened.navigator.wall)] == [None, None]
    at_demand = replace(found, demand=replace(found.demand, record_scaling="pga"))
    sides = client_view.sides_of(at_demand, opened.navigator.wall)
    verdicts = [wall.assessment.verdict for wall in opened.session.result.walls]
    assert [side.share for side in sides] == [verdict.zeta_e / verdict.zeta_target for verdict in verdicts]
    view = client_view.ClientView(opened, "title", sides)
    view.resize(700, 500)
    view.write(tmp_path / "v.png")
    view.write(tmp_path / "v.pdf")
    assert QImage(str(tmp_path / "v.png")).width() > 500
    assert (tmp_path / "v.pdf").read_bytes()[:5] == b"%PDF-"
    assert f"{100 * sides[0].share:.0f} %" in client_view.words_of(sides[0])
    before = view.drawings[0].rotation
    view.set_time(0.0)
    assert view.drawings[0].rotation == 0.0 and before == pytest.approx(
        sides[0].rotation[abs(sides[0].rotation).argmax()], abs=1.5
    )
    view.deleteLater()


def test_that_the_first_page_asks_what_there_is_and_goes_with_the_first_choice(opened, application):
    opened.show_first_run()
    page = opened.stages.first
    assert set(page.buttons) >= {"wall", "table", "records", "paper", "example", "facade"}
    page.buttons["wall"].click()
    assert opened.stages.first is None and opened.stages.front == "input"
    assert len(opened.session.case.wall) == 1 and opened.walls.fields["height_m"].isVisible()
    opened.show_first_run()
    first_run.open_first_choice(opened, "example")
    assert opened.stages.front == "input"
    opened.show_first_run()
    opened.stages.first.buttons["facade"].click()
    assert len(opened.walls.wall.openings) == 2 and opened.walls.body.isVisible()
    entry = next(one for one in finder.entries_of(opened) if "rose window" in one.words)
    entry.go()
    assert opened.session.path.name == "facade.toml"


@pytest.mark.shows("window.themes")
@pytest.mark.parametrize("name", ["light", "dark"])
def test_that_words_stand_out_from_what_is_behind_them(name):
    """WCAG 2: at least 4.5 for text, 3 for what is chosen."""
    chosen = theme.THEMES[name]

    def light(color: str) -> float:
        parts = [QColor(color).redF(), QColor(color).greenF(), QColor(color).blueF()]
        linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    def contrast(one: str, other: str) -> float:
        low, high = sorted((light(one), light(other)))
        return (high + 0.05) / (low + 0.05)

    for tone in ("good", "amber", "bad", "quiet", "ink"):
        assert contrast(getattr(chosen, tone), chosen.back) >= 4.5, tone
        assert contrast(getattr(chosen, tone), chosen.window) >= 4.5, tone
    assert contrast(chosen.curves[0], chosen.back) >= 3.0


def test_that_a_complete_case_reads_back_from_the_forms(opened):
    opened.files.save()
    assert read_case(opened.session.path) == opened.session.case


def test_that_a_wide_window_shows_the_rocking_wall_beside_the_answer(opened, application):
    run(application, opened)
    opened.resize(1920, 1040)
    settle(application, lambda: opened.stages.answer.has_beside())
    assert opened.navigator.beside.content.history is not None
    opened.resize(1280, 800)
    settle(application, lambda: not opened.stages.answer.has_beside())


def test_that_a_variant_by_one_click_says_beside_it_what_differs(opened):
    opened.walls.add_variant()
    rows = {row.text: row for row in opened.tree.rows}
    assert {"as it is", "as designed"} <= set(rows) and opened.walls.wall.variant == "progetto"
    assert opened.walls.differs.text() == ""
    opened.session.edit_wall(1, thickness_m=0.625, mechanism="one_sided", hold=(Hold("contact"),))
    opened.walls.holds.add("tie")
    said = [row.text for row in opened.tree.rows if row.kind == "wall"]
    assert said[0] == "as it is" and said[1].startswith("as designed: ")
    for words in ("thickness 50 → 62.5 cm", "two-sided → one-sided", "+ tie"):
        assert words in said[1] and words in opened.walls.differs.text()
    opened.walls.select(0)
    assert opened.walls.differs.text() == ""
