"""The start of the window: where its data lie, what a fault leaves behind, words where there is no terminal."""

import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

FAULT = """
import faulthandler, sys
from pathlib import Path
from app.shell import start
with start.logged_crash(Path(sys.argv[1])) as earlier:
    print([file.name for file in earlier])
    if sys.argv[2] == "fault":
        def reading_a_record(): faulthandler._sigsegv()
        reading_a_record()
"""


def start(folder, kind):
    return subprocess.run(
        [sys.executable, "-P", "-c", FAULT, folder, kind],
        capture_output=True,
        text=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT), QT_QPA_PLATFORM="offscreen"),
    )


def test_that_a_fault_leaves_a_log_that_the_next_start_names_once(tmp_path):
    assert start(tmp_path, "fault").returncode != 0
    (log,) = tmp_path.iterdir()
    assert log.name.startswith("crash-") and "reading_a_record" in log.read_text()
    named = log.with_suffix(".txt").name
    assert start(tmp_path, "none").stdout == f"['{named}']\n"
    assert [file.name for file in tmp_path.iterdir()] == [named]  # its own log is gone, the other not named again


def test_that_a_user_without_a_writable_home_has_a_folder_of_data(tmp_path, monkeypatch):
    from app.shell import start

    (tmp_path / "file").touch()
    monkeypatch.setattr(start.QStandardPaths, "writableLocation", lambda _: str(tmp_path / "file" / "data"))
    monkeypatch.setattr(start.tempfile, "tempdir", str(tmp_path))
    folder = start.data_folder()
    assert folder.parent == tmp_path and folder.name.startswith("ribalta-data-") and folder.is_dir()


def test_that_words_without_a_terminal_come_in_a_dialog(application, tmp_path, monkeypatch):
    from app import __main__ as program
    from app.shell import start

    words = []
    monkeypatch.setattr(start.QMessageBox, "critical", lambda *given: words.append(given[-1]))
    monkeypatch.setattr(sys, "stderr", None)
    assert program.main([str(tmp_path / "absent.ribalta")]) == 1
    assert len(words) == 1 and "absent.ribalta" in words[0]


def test_that_a_case_of_the_own_extension_opens_saves_and_runs_as_batch(opened, tmp_path, monkeypatch):
    from app.shell import files

    path = tmp_path / "parete.ribalta"
    monkeypatch.setattr(files, "path_to_write", lambda *given: path if given[-1] == files.CASE_ENDS else None)
    assert opened.files.save_as() and path.exists()
    assert opened.files.open(path) and opened.session.path == path
    from app.__main__ import main

    assert main(["--batch", str(path), "--quiet"]) == 0 and path.with_suffix(".json").exists()


OPENED = """
import sys
from PySide6.QtGui import QFileOpenEvent
from app.shell import start
application, window = start.make([])
application.opens = window.files.open
application.sendEvent(application, QFileOpenEvent(sys.argv[1]))
print(window.session.path)
"""


def test_that_a_file_the_system_asks_to_open_opens(tmp_path):
    path = tmp_path / "wall of the client.ribalta"
    example = (ROOT / "resources" / "cases" / "example.toml").read_text(encoding="utf-8")
    path.write_text(example.replace('"../', f'"{ROOT.as_posix()}/resources/'), encoding="utf-8")
    words = subprocess.run(
        [sys.executable, "-P", "-c", OPENED, path],
        capture_output=True,
        text=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT), QT_QPA_PLATFORM="offscreen", HOME=str(tmp_path)),
    )
    assert words.stdout.strip() == str(path), words.stderr


@pytest.mark.shows("install.refused")
@pytest.mark.parametrize(
    ("platform", "displays", "said"),
    [
        ("", {}, "there is no display for the window"),
        ("xcb", {"WAYLAND_DISPLAY": "w"}, "there is no display for the window"),
        ("", {"DISPLAY": ":4711"}, "the display of DISPLAY=:4711 does not answer"),
        ("xcb", {"DISPLAY": "nowhere"}, "the display of DISPLAY=nowhere does not answer"),
        ("", {"DISPLAY": ":4711", "WAYLAND_DISPLAY": "w"}, "the display of WAYLAND_DISPLAY=w, DISPLAY=:4711 does not"),
    ],
)
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="displays are of Linux")
def test_that_a_display_that_is_missing_or_silent_is_said_in_a_sentence(platform, displays, said):
    screens = ("DISPLAY", "WAYLAND_DISPLAY")
    none = {key: value for key, value in os.environ.items() if key not in screens}
    words = subprocess.run(
        [sys.executable, "-P", "-m", "app"],
        capture_output=True,
        text=True,
        env=none | displays | {"PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": platform, "LC_ALL": "C"},
    )
    assert words.returncode == 1
    assert words.stderr.startswith(f"error: {said}")
    assert words.stderr.count("\n") == 1
