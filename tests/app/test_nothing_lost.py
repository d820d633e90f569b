"""What a user typed, named or started is not changed without a word."""

import os
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QMessageBox

from app import files
from app.plots.chart import Chart
from tests.app.driving import settle, type_into


def test_that_a_refused_number_stays_and_keeps_the_run_back(opened, application):
    """Its first digits are in the case already: they must not pass for what was meant."""
    height = opened.walls.height
    thickness = opened.walls.thickness
    type_into(height, "99999")
    type_into(thickness, "60")
    assert height.editor.text() == "99999" and height.wrong
    assert not opened.run_button.isEnabled()
    type_into(height, "6")
    assert not height.wrong and opened.session.case.wall[0].height_m == 6.0


def test_that_another_case_does_not_take_over_what_was_wrong(opened, application):
    height = opened.walls.height
    type_into(height, "abc")
    opened.files.open(opened.session.path)
    assert not height.wrong and height.editor.text() == "5"


@pytest.mark.parametrize("answer, written", [("Yes", True), ("No", False)])
def test_that_an_ending_added_to_a_name_overwrites_nothing_unasked(
    opened,
    tmp_path,
    monkeypatch,
    answer,
    written,
):
    (tmp_path / "v1.2.toml").write_text("another")
    (tmp_path / "v1.toml").write_text("a third")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "v1.2"), ""))
    monkeypatch.setattr(
        QMessageBox, "question", lambda *_: getattr(QMessageBox.StandardButton, answer)
    )
    assert opened.files.save_as() is written
    assert ((tmp_path / "v1.2.toml").read_text() == "another") is not written
    assert (tmp_path / "v1.toml").read_text() == "a third"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: ("", ""))
    assert files.path_to_write(opened, "", "", "", ".toml") is None


def test_that_a_new_language_does_not_stop_the_run(opened, application):
    opened.run()
    opened.set_choice("language", "it")
    settle(application, lambda: opened.job is None)
    assert opened.session.result is not None
    opened.set_choice("language", "en")


def test_that_a_chart_not_written_says_so(opened, monkeypatch):
    said = []
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: said.append(a[-1]))
    target = Path("/nowhere/at/all.png")
    monkeypatch.setattr("app.plots.chart.path_to_write", lambda *_: target)
    opened.findChildren(Chart)[0]._save("png")
    assert said == [f"{target}: No such file or directory"]


def test_that_rules_between_fields_stand_at_the_fields(opened, application):
    walls = opened.walls
    walls.impact.law.setCurrentIndex(walls.impact.law.findData("own"))
    walls.impact._law_chosen(walls.impact.law.currentIndex())
    type_into(walls.impact.first, "0.5")
    application.processEvents()
    for field in (walls.impact.first, walls.impact.last):
        assert "0.5" in field.message.text() and "{" not in field.message.text()
    assert not opened.run_action.isEnabled()
    type_into(walls.impact.last, "0.6")
    application.processEvents()
    assert not walls.impact.first.message.text() and opened.run_action.isEnabled()
    type_into(walls.setback, "45")
    application.processEvents()
    assert "hinge setback" in walls.setback.message.text()
    type_into(walls.setback, "0")
    walls.duplicate()
    type_into(walls.name, "w")
    application.processEvents()
    assert "same name" in walls.name.message.text()
    type_into(walls.name, "v")
    type_into(opened.demand.factor, "1")
    application.processEvents()
    assert "compressive strength" in opened.demand.factor.message.text()


def test_that_undo_in_a_field_is_that_of_the_case_and_takes_refused_text_back_first(
    opened, application
):
    field = opened.walls.thickness
    before = opened.session.case.wall[0].thickness_m
    opened.activateWindow()
    type_into(field, "60")
    type_into(opened.walls.height, "6")
    QTest.keyClick(opened.walls.height.editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].height_m == 5.0
    assert opened.session.case.wall[0].thickness_m == 0.6
    type_into(field, "70x")
    assert field.wrong
    QTest.keyClick(field.editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    application.processEvents()
    assert not field.wrong and field.editor.text() == "70"
    for _ in range(3):
        QTest.keyClick(field.editor, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].thickness_m == before
    QTest.keyClick(field.editor, Qt.Key.Key_Y, Qt.KeyboardModifier.ControlModifier)
    assert opened.session.case.wall[0].thickness_m != before
