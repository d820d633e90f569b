"""What a user typed, named or started is not changed without a word."""

import os
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

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
