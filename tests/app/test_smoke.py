"""The window on a real display server: Xvfb, where the machine has it."""

import os
import shutil
import subprocess
import sys

import pytest

from tests.conftest import ROOT

SCRIPT = """
import sys
from PySide6.QtCore import QEventLoop, QStandardPaths, Qt, QTimer
QStandardPaths.setTestModeEnabled(True)
from PySide6.QtTest import QTest
from app import start, window as program
from core.case_reader import read_case
application, window = start.make([])
start.install_hook(window)
window.show()
window.session.open(start.EXAMPLE)
late = QTimer(singleShot=True, interval=100_000)
late.start()
def until(ready):
    while not ready() and late.isActive():
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents, 20)
    application.processEvents()
until(lambda: window.records.motions and window.run_button.isEnabled())
QTest.mouseClick(window.run_button, Qt.MouseButton.LeftButton)
until(lambda: window.session.result is not None and window.job is None)
for k in range(window.tabs.count()):
    window.tabs.setCurrentIndex(k)
    application.processEvents()
picture = window.screen().grabWindow(window.winId()).toImage()
colors = {picture.pixel(x, y) for x in range(0, picture.width(), 3) for y in range(0, picture.height(), 3)}
print(application.platformName(), len(window.session.result.walls), len(colors))
window.session.saved = window.session.case
window.close()
"""


def test_the_window_under_xvfb(tmp_path):
    server = shutil.which("Xvfb")
    if server is None:
        pytest.skip("no Xvfb on this machine")
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    read, write = os.pipe()
    with subprocess.Popen(
        [server, "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
        pass_fds=[write], stderr=subprocess.DEVNULL,
    ) as display:  # fmt: skip
        os.close(write)
        try:
            with os.fdopen(read) as answer:
                number = answer.readline().strip()
            if not number:
                pytest.skip("Xvfb does not start here")
            variables = {
                **os.environ, "DISPLAY": f":{number}", "QT_QPA_PLATFORM": "xcb",
                "PYTHONPATH": str(ROOT), "XDG_CONFIG_HOME": str(tmp_path),
            }  # fmt: skip
            probe = "from PySide6.QtWidgets import QApplication; QApplication([])"
            start = [sys.executable, "-P", "-c"]
            if subprocess.run([*start, probe], env=variables, capture_output=True).returncode:
                pytest.skip("Qt finds no xcb libraries here")
            found = subprocess.run(
                [*start, SCRIPT], env=variables, capture_output=True, text=True, timeout=150
            )
        finally:
            display.terminate()
    assert found.returncode == 0, found.stderr
    platform, walls, colors = found.stdout.split()
    assert platform == "xcb"
    assert int(walls) == 4
    assert int(colors) > 30
