"""What follows a key at once, and what waits until the hand rests."""

import pytest
from PySide6.QtTest import QTest

from tests.app.driving import run, settle, type_into


def texts(window) -> tuple:
    """What the parts that wait show."""
    rules = tuple(field.rule for field in window.stages.fields)
    return [row.text for row in window.tree.rows], [problem.words for problem in window.missing.problems], rules


def typed(window, text: str) -> None:
    """Type into the height of the wall, in a form in front."""
    window.navigator.show_input("wall")
    height = window.walls.fields["height_m"]
    height.editor.setFocus()
    height.editor.selectAll()
    QTest.keyClicks(height.editor, text)


def test_that_a_key_is_in_the_case_and_old_results_are_veiled_before_the_hand_rests(opened, application):
    run(application, opened)
    opened.navigator.show_page("histories")
    before, height = texts(opened), opened.walls.fields["height_m"]
    assert opened.stages.veil.isHidden()
    QTest.keyClicks(height.editor, "1")
    assert opened.session.stale and not opened.stages.veil.isHidden()
    assert texts(opened) == before and opened.windowTitle().startswith("*")
    chips = [row.tone for row in opened.tree.rows if row.kind == "wall"]
    settle(application, lambda: [row.tone for row in opened.tree.rows if row.kind == "wall"] != chips)
    assert "quiet" in {row.tone for row in opened.tree.rows if row.kind == "wall"}


@pytest.mark.parametrize("text", ["", "high", "-3"])
def test_that_nothing_runs_with_what_was_just_typed_wrong(opened, application, text):
    opened.navigator.show_input("wall")
    height = opened.walls.fields["height_m"]
    height.editor.setFocus()
    height.editor.selectAll()
    QTest.keyClicks(height.editor, text or "\b")
    application.processEvents()
    assert not opened.run_action.isEnabled() and not opened.run_button.isEnabled()
    opened.run()
    assert opened.runner.job is None
    settle(application, lambda: opened.missing.problems)
    typed(opened, "4.2")
    assert opened.run_action.isEnabled(), "F5 right after the last key"
    settle(application, lambda: not opened.missing.problems)


@pytest.mark.parametrize("change", ["theme", "language", "another case", "undo"])
def test_that_what_waits_outlives_no_window_and_no_case(opened, application, change):
    typed(opened, "4.25")
    opened.demand.fields["ag_g"].editor.setFocus()
    QTest.keyClicks(opened.demand.fields["ag_g"].editor, "x")
    if change == "theme":
        opened.set_choice("theme", "dark")
        opened.set_choice("theme", "light")
    elif change == "language":
        opened.set_choice("language", "it")
    elif change == "undo":
        opened.session.undo()
    else:
        opened.session.saved = opened.session.case
        opened.start_afresh(lambda: opened.session.open(opened.session.path))
    QTest.qWait(200)
    shown = texts(opened)
    opened.refresh()
    assert texts(opened) == shown


def test_that_a_case_is_kept_for_a_crash_between_no_two_keys(opened, application):
    settle(application, lambda: not opened.session.recovery_file.exists())
    typed(opened, "4.4")
    opened.timer.timeout.emit()
    assert not opened.session.recovery_file.exists()
    settle(application, opened.session.recovery_file.exists)
    assert opened.session.case.wall[0].height_m == 4.4


def test_that_a_hand_that_never_rests_waits_a_second_at_most(opened, application):
    run(application, opened)
    typed(opened, "4")
    for key in "1234567890123456789012345678901234567890":
        QTest.keyClicks(opened.walls.fields["name"].editor, key)
        QTest.qWait(50)
        if any(row.kind == "wall" and row.text.startswith("1234") for row in opened.tree.rows):
            break
    else:
        raise AssertionError("the tree is still that before the first key")


@pytest.mark.parametrize("hidden_first", [True, False])
def test_that_a_form_behind_that_hides_or_shows_a_red_text_decides_whether_the_case_may_run(
    opened, application, hidden_first
):
    """Undone from another stage, a mechanism hides or shows the field of E, in which what stands is in no case."""
    modulus, button = opened.walls.fields["elastic_modulus_mpa"], opened.walls.mechanisms["two_sided"]
    mechanism = "two_sided" if hidden_first else "vertical_bending"
    opened.session.edit_wall(0, mechanism=mechanism, unit_weight_kn_m3=18.0)
    if not hidden_first:
        button.click()
    opened.navigator.show_input("wall")
    type_into(modulus, "abc")
    assert modulus.wrong
    if hidden_first:
        opened.walls.mechanisms["vertical_bending"].click()
        assert modulus.isHidden()
    opened.navigator.show_stage("answer")
    application.processEvents()
    opened.session.undo()  # and no event after it
    stopped = any(problem.stops for problem in opened.missing.problems)
    assert stopped == modulus.wrong == hidden_first, opened.missing.text()
    assert opened.run_action.isEnabled() == opened.run_button.isEnabled() == (not stopped)
    opened.run()
    assert (opened.runner.job is None) == stopped
    settle(application, lambda: opened.runner.job is None)
