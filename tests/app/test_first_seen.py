"""What is made, imported and drawn when it is first seen, and no sooner."""

import os
import subprocess
import sys
from dataclasses import replace

import pytest

from core.case.schema import Record
from core.case.site import Spectrum
from tests.conftest import ROOT

START = """
import sys
from app.look.quick_imports import quicken
quicken()
from PySide6.QtCore import QStandardPaths
QStandardPaths.setTestModeEnabled(True)
from app.shell import start as program
application, window = program.make([])
program.show(window)
application.processEvents()
window.session.open(program.EXAMPLE)
application.processEvents()
print(*(name for name, page in window.pages.items() if page.made is not None))
late = ("pyqtgraph", "openpyxl", "core.report.note", "core.ground.records.plain_head", "app.views.chart",
        "app.views.histories_tab", "app.input.import_dialog", "app.shell.sweep_window", "scipy", "matplotlib")
# scipy comes with numba, which the thread asks for that prepares the answer as one types
print(*(name for name in late if name in sys.modules and not (name == "scipy" and "numba" in sys.modules)))
window.close()
"""


def test_that_the_first_show_makes_no_page_and_imports_no_charts_no_readers_and_no_note(tmp_path):
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    variables = dict(os.environ, PYTHONPATH=str(ROOT), QT_QPA_PLATFORM="offscreen", XDG_DATA_HOME=str(tmp_path))
    found = subprocess.run([sys.executable, "-P", "-c", START], capture_output=True, text=True, env=variables)
    assert found.stdout.splitlines() == ["", ""], found.stderr


def test_that_a_spectrum_that_is_not_seen_is_drawn_when_it_is_looked_at_again(opened):
    opened.session.edit_section("demand", spectrum=Spectrum("EN1998", "B", type=1), soil_factor=None)
    opened.navigator.show_input("demand")
    curve = opened.demand.curve
    drawn = curve.shown
    opened.navigator.show_input("wall", 0)
    opened.session.edit_section("demand", ag_g=0.123)
    assert curve.shown is drawn
    opened.navigator.show_input("demand")
    assert curve.shown is not drawn and curve.shown != drawn


def test_that_a_spectrum_that_stays_the_same_is_not_drawn_again(opened):
    opened.session.edit_section("demand", spectrum=Spectrum("EN1998", "B", type=1), soil_factor=None)
    opened.navigator.show_input("demand")
    drawn = opened.demand.curve.shown
    opened.session.edit_wall(0, height_m=6.6)
    opened.session.edit(replace(opened.session.case, record=(*opened.session.case.record, Record("b.txt"))))
    assert opened.demand.curve.shown is drawn


def test_that_a_law_is_drawn_while_its_section_is_open(opened, application):
    opened.navigator.show_input("wall", 0)
    impact, section = opened.walls.impact, opened.walls.sections["impact"]
    section.head.setChecked(False)
    opened.session.edit_wall(0, law="doherty")
    section.unfold()
    points = impact.law_curve.curve.getData()[0].size
    section.head.setChecked(False)
    opened.session.edit_wall(0, law="rigid")
    assert impact.law_curve.curve.getData()[0].size == points
    section.unfold()
    assert impact.law_curve.curve.getData()[0].size != points


def test_that_what_is_kept_for_a_crash_is_kept_once(opened, monkeypatch):
    kept = []
    autosave = opened.session.autosave
    monkeypatch.setattr(opened.session, "autosave", lambda: kept.append(autosave()) or kept[-1])
    opened.session.edit_wall(0, height_m=6.1)
    for _ in range(3):
        opened.timer.timeout.emit()
    assert kept == [True]
    opened.session.edit_wall(0, height_m=6.2)
    opened.timer.timeout.emit()
    assert kept == [True, True]
    monkeypatch.setattr(opened.session, "autosave", lambda: kept.append(False) or False)  # a disk that is full
    opened.session.edit_wall(0, height_m=6.3)
    opened.timer.timeout.emit()
    opened.timer.timeout.emit()
    assert kept == [True, True, False, False]


def test_that_work_taken_back_and_done_again_is_kept_for_a_crash(opened):
    opened.session.edit_wall(0, height_m=6.1)
    opened.timer.timeout.emit()
    opened.session.undo()
    opened.timer.timeout.emit()
    assert not opened.session.recovery_file.exists()
    opened.session.redo()
    opened.timer.timeout.emit()
    assert opened.session.recovery_file.exists()


def test_that_of_many_finished_walls_those_of_a_moment_are_shown_together(opened, monkeypatch):
    shown = []
    with monkeypatch.context() as patch:
        patch.setattr(opened.navigator, "show_finished", lambda: shown.append(len(opened.runner.finished_walls)))
        patch.setattr(opened, "_show_tree", lambda: None)
        patch.setattr(opened.runner, "job", object())
        patch.setattr(opened.runner, "finished_walls", [])
        for _ in range(60):
            opened.runner.finished_walls.append(object())
            opened.runner.found.emit()
        assert shown == list(range(1, 21)) and opened.finished_timer.isActive()
        opened.finished_timer.timeout.emit()
        assert shown[20:] == [60]
        opened.finished_timer.stop()
