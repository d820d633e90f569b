"""The window under test, on a small case."""

import os
import sys

import pytest

from tests.conftest import ROOT


@pytest.fixture(scope="module")
def application():
    """The Qt application; tests that need it are skipped where Qt cannot start."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    from PySide6.QtWidgets import QApplication

    from app.look import theme

    made = QApplication.instance() or QApplication([])
    theme.set_theme("light")
    yield made
    # widgets must go before the application does, or Qt crashes when Python ends
    import gc

    for widget in made.topLevelWidgets():
        widget.close()
        widget.deleteLater()
    delete_now(made)
    gc.collect()
    made.processEvents()


def delete_now(application) -> None:
    """What deleteLater asked for, which processEvents leaves undone: each window that stays makes a change of style,
    palette or font slower, and so the next window."""
    from PySide6.QtCore import QEvent

    from app.work.worker import end_jobs

    end_jobs()
    application.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def faults():
    """What slots raised, which Qt gives to the hook of errors; a test that raises on purpose empties the list."""
    return []


@pytest.fixture
def opened(application, tmp_path, monkeypatch, faults):
    """A window on a small copy of the example; message boxes answer Discard."""
    yield from window_in(application, tmp_path, monkeypatch, faults)


def window_in(application, tmp_path, monkeypatch, faults):
    """`opened` in this folder, for a fixture of any scope."""
    from PySide6.QtCore import QSettings
    from PySide6.QtWidgets import QMessageBox

    from app.look import language, theme
    from app.shell import window
    from app.views.chart_output import ChartOutput
    from app.views.table import Table
    from tests.app.driving import settle

    monkeypatch.setattr(sys, "excepthook", lambda kind, value, trace: faults.append(value))
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Discard)
    monkeypatch.setattr(QMessageBox, "information", lambda *_: None)
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: pytest.fail(f"unexpected: {a[-1]}"))
    if theme.current is not theme.THEMES["light"]:
        theme.set_theme("light")
    settings = QSettings(str(tmp_path / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("language", "en")
    language.set_language("en")
    made = window.MainWindow(settings, tmp_path / "recovery_folder")
    path = tmp_path / "small.toml"
    motion = ROOT / "resources" / "motions" / "noise_1.txt"
    path.write_text(
        f'[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0\nmechanism = "two_sided"\n'
        f'[[record]]\nfile = "{motion.as_posix()}"\nkind = "artificial"\n'
        "[analysis]\nq_step = 0.02\n[demand]\nag_g = 0.2\nsoil_factor = 1.2\n"
    )
    made.resize(1280, 800)  # the screen of the tests is smaller
    made.show()
    made.files.open(path)
    settle(application, lambda: made.records.motions)
    yield made
    made.session.saved = made.session.case
    made.close()
    made.deleteLater()
    delete_now(application)
    application.processEvents()
    ChartOutput.stale = Table.stale = False  # of the window in front, and there is none
    assert faults == []
