"""The window on a real display server: Xvfb, where the machine has it."""

import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT
from tests.xvfb import display

EXAMPLE = ROOT / "resources" / "cases" / "example.toml"

SCRIPT = """
import sys
from pathlib import Path
from app.look.quick_imports import quicken
quicken()
from PySide6.QtCore import QEventLoop, QStandardPaths, Qt, QTimer
QStandardPaths.setTestModeEnabled(True)
from PySide6.QtTest import QTest
from app.shell import start, window as program
from core.case.reader import read_case
application, window = start.make([])
start.install_hook(window)
window.show()
window.session.open(Path(sys.argv[1]))
late = QTimer(singleShot=True, interval=100_000)
late.start()
def until(ready):
    beat = QTimer()
    beat.start(20)
    while not ready() and late.isActive():
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
    application.processEvents()
until(lambda: window.records.motions and window.run_button.isEnabled())
QTest.mouseClick(window.run_button, Qt.MouseButton.LeftButton)
until(lambda: window.session.result is not None and window.runner.job is None)
for name in window.pages:
    window.navigator.show_page(name)
    application.processEvents()
picture = window.screen().grabWindow(window.winId()).toImage()
colors = {picture.pixel(x, y) for x in range(0, picture.width(), 3) for y in range(0, picture.height(), 3)}
print(application.platformName(), len(window.session.result.walls), len(colors))
window.session.saved = window.session.case
window.close()
"""


def test_that_pyqtgraph_has_all_of_qt_where_its_import_is_quickened():
    script = (
        "from app.look.quick_imports import quicken; quicken();"
        "from app.look.charting import Mirror; import pyqtgraph.Qt as Q;"
        "from PySide6 import QtCore, QtGui, QtWidgets;"
        "pairs = ((Q.QtCore, QtCore), (Q.QtGui, QtGui), (Q.QtWidgets, QtWidgets));"
        "print(all(type(a) is Mirror and len(dir(b)) > 100 for a, b in pairs),"
        "all(getattr(a, n) is getattr(b, n) for a, b in pairs for n in dir(b) if n[0] != '_' and '.' not in n))"
    )
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    found = subprocess.run(
        [sys.executable, "-P", "-c", script], capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=str(ROOT))
    )
    assert found.stdout.split() == ["True", "True"], found.stderr


@pytest.mark.parametrize("package", ["PySide6", "pyqtgraph"])
def test_that_an_unknown_version_is_imported_as_it_is_by_itself(package):
    script = (
        f"from core.known_internals import KNOWN; KNOWN[{package!r}] = ('9.0', '9.9');"
        "from app.look.quick_imports import quicken; quicken();"
        "from app.look.charting import Mirror; import pyqtgraph.Qt as Q;"
        "print(isinstance(Q.QtCore, Mirror), Q.QtCore.QPointF(1.0, 2.0).x())"
    )
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    found = subprocess.run(
        [sys.executable, "-P", "-c", script], capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=str(ROOT))
    )
    assert found.stdout.split() == ["False", "1.0"], found.stderr


@pytest.mark.parametrize("motions", [2, pytest.param(14, marks=pytest.mark.long)])
def test_the_window_under_xvfb(tmp_path, motions):
    """motions : generated for the example"""
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    with display(PYTHONPATH=str(ROOT), XDG_CONFIG_HOME=str(tmp_path)) as variables:
        if isinstance(variables, str):
            pytest.skip(variables)
        case = tmp_path / "example.toml"
        case.write_text(EXAMPLE.read_text(encoding="utf-8").replace("seed = 1", f"seed = 1\ncount = {motions}"))
        start = [sys.executable, "-P", "-c", SCRIPT, str(case)]
        found = subprocess.run(start, env=variables, capture_output=True, text=True, timeout=150)
    assert found.returncode == 0, found.stderr
    platform, walls, colors = found.stdout.split()
    assert platform == "xcb"
    assert int(walls) == 4
    assert int(colors) > 30
