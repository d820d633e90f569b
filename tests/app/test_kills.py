"""The window killed while it is edited, autosaved, saved: the last acknowledged value is in the file or in a draft."""

import contextlib
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.work import recovery
from app.work.session import Session
from core.case.reader import read_case
from core.errors import InputError
from tests.conftest import ROOT

CASE = '[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0\nmechanism = "two_sided"\n'

WINDOW = """
import random, sys
from pathlib import Path
from PySide6.QtWidgets import QApplication
from tests.app.conftest import new_window

folder, first = Path(sys.argv[1]), int(sys.argv[2])
application = QApplication([])
window, draw = new_window(folder), random.Random(first)
window.files.open(folder / "c.toml")
for k in range(first, first + 10_000):
    window.session.edit_wall(0, height_m=2.0 + k * 1e-4)
    if draw.random() < 0.3:
        window.files.save()
    window.session.autosave()
    application.processEvents()
    print(k, flush=True)
"""
"""A window on c.toml whose wall is made higher at each turn, saved at some, autosaved at all; each is acknowledged."""


def counted(height: float) -> int:
    """The turn that gave a wall its height."""
    return round((height - 2.0) / 1e-4)


def left(folder: Path) -> int:
    """The latest turn that file and drafts hold. Raises InputError where the file does not read."""
    found = [counted(read_case(folder / "c.toml").wall[0].height_m)]
    session = Session(folder / "recovery_folder")
    for file in session.recoverable():
        found.append(counted(recovery.newest(file).case.wall[0].height_m))
    session.close()
    return max(found)


def killed_at_random_times(folder: Path, kills: int, seed: int = 1) -> int:
    """Kill so many windows; returns how many lost what was acknowledged, or left a file that does not read."""
    draw, lost, first = random.Random(seed), 0, 1
    (folder / "c.toml").write_text(CASE.replace("5.0", "2.0"))
    variables = {**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    for _ in range(kills):
        command = [sys.executable, "-c", WINDOW, str(folder), str(first)]
        process = subprocess.Popen(command, cwd=ROOT, env=variables, stdout=subprocess.PIPE, text=True)
        last = int(process.stdout.readline())
        end = time.monotonic() + draw.uniform(0.0, 0.4)
        while time.monotonic() < end:
            last = int(process.stdout.readline())
        process.kill()
        rest = process.communicate()[0].split("\n")[:-1]
        last = int(rest[-1]) if rest else last
        with contextlib.suppress(InputError):
            if left(folder) >= last:
                first = last + 2
                continue
        lost += 1
    return lost


@pytest.mark.shows("window.autosave")
@pytest.mark.parametrize("kills", [1, pytest.param(40, marks=pytest.mark.long)])
def test_that_a_kill_of_the_window_loses_nothing_it_acknowledged(tmp_path, kills):
    assert killed_at_random_times(tmp_path, kills) == 0
