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


def quiet(monkeypatch, faults) -> None:
    """What slots raise goes into the list; message boxes answer Discard, none warns."""
    from PySide6.QtWidgets import QMessageBox

    monkeypatch.setattr(sys, "excepthook", lambda kind, value, trace: faults.append(value))
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Discard)
    monkeypatch.setattr(QMessageBox, "information", lambda *_: None)
    monkeypatch.setattr(QMessageBox, "warning", lambda *a: pytest.fail(f"unexpected: {a[-1]}"))


def open_small(application, made, folder) -> None:
    """A small copy of the example, written in this folder and opened, its record read."""
    from tests.app.driving import settle

    path = folder / "small.toml"
    motion = ROOT / "resources" / "motions" / "noise_1.txt"
    path.write_text(
        f'[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0\nmechanism = "two_sided"\n'
        f'[[record]]\nfile = "{motion.as_posix()}"\nkind = "artificial"\n'
        "[analysis]\nq_step = 0.02\n[demand]\nag_g = 0.2\nsoil_factor = 1.2\n"
    )
    made.files.open(path)
    settle(application, lambda: made.records.motions and not made.records.pending)


def window_in(application, tmp_path, monkeypatch, faults):
    """`opened` in this folder, for a fixture of any scope."""
    from PySide6.QtCore import QSettings

    from app.look import language, theme
    from app.shell import window
    from app.views.chart_output import ChartOutput
    from app.views.table import Table

    quiet(monkeypatch, faults)
    if theme.current is not theme.THEMES["light"]:
        theme.set_theme("light")
    settings = QSettings(str(tmp_path / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("language", "en")
    language.set_language("en")
    made = window.MainWindow(settings, tmp_path / "recovery_folder")
    made.resize(1280, 800)  # the screen of the tests is smaller
    made.show()
    open_small(application, made, tmp_path)
    yield made
    made.session.saved = made.session.case
    made.close()
    made.deleteLater()
    delete_now(application)
    application.processEvents()
    ChartOutput.stale = Table.stale = False  # of the window in front, and there is none
    assert faults == []


@pytest.fixture(scope="module")
def one_window(application, tmp_path_factory):
    """A window for all tests of a module."""
    with pytest.MonkeyPatch.context() as patch:
        yield from window_in(application, tmp_path_factory.mktemp("one_window"), patch, [])


@pytest.fixture
def reopened(application, one_window, tmp_path, monkeypatch, faults):
    """`opened` without a window of its own: the one of the module, on a case that is opened anew. For tests of forms,
    which leave nothing but the case behind; a window costs half a second."""
    from app.look import language

    quiet(monkeypatch, faults)
    assert language.current_language() == "en", "a test before left another language"
    one_window.session.saved = one_window.session.case
    one_window.resize(1280, 800)
    open_small(application, one_window, tmp_path)
    one_window.show_input("wall", 0)
    yield one_window
    application.processEvents()
    assert faults == []
