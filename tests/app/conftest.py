"""The window under test, on a small case."""

import os
import sys
from dataclasses import replace

import pytest

from tests.conftest import ROOT, SEVEN

SIZE = 1280, 800
"""Of the window [px]; the screen of the tests is smaller."""


@pytest.fixture(scope="session")
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

    for widget in own_windows(made):
        widget.close()
        widget.deleteLater()
    delete_now(made)
    gc.collect()
    made.processEvents()


def own_windows(application) -> list:
    """The top-level widgets that Python made. Qt's own are not ours to delete: a layout of a chart deletes the one that
    it measures its margins with a second time, and the process ends by a fault of memory."""
    from shiboken6 import Shiboken

    return [one for one in application.topLevelWidgets() if Shiboken.createdByPython(one)]


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
def opened(shared_window, tmp_path, monkeypatch, faults):
    """The window that the tests of a process share, on a small copy of the example; message boxes answer Discard."""
    quiet(monkeypatch, faults)
    made = shared_window.lend(tmp_path)
    yield made
    shared_window.take_back()
    assert faults == []


@pytest.fixture
def fresh(application, tmp_path, monkeypatch, faults):
    """`opened`, of a window that no other test has had: for tests of its beginning, its end and its settings."""
    yield from window_in(application, tmp_path, monkeypatch, faults)


@pytest.fixture(scope="session")
def accuracy(of_seven, kept):
    """The statement of accuracy of the first wall of verdict.toml, made once: it takes seconds."""
    from core.study.wall_tasks import make_accuracy_statement

    result = of_seven
    arguments = result.walls[0], result.motions, result.method, result.search
    return kept("accuracy", lambda: make_accuracy_statement(*arguments, lambda: False))


@pytest.fixture(scope="module")
def of_verdict(application, tmp_path_factory, of_seven, accuracy):
    """A window of the module on the two walls of verdict.toml with their result and the accuracy of the first."""
    with pytest.MonkeyPatch.context() as patch:
        made = window_in(application, tmp_path_factory.mktemp("verdict"), patch, [])
        result = of_seven
        first, *others = result.walls
        walls = (replace(first, accuracy=accuracy), *others)
        yield with_verdict(application, next(made), replace(result, walls=walls))
        next(made, None)


@pytest.fixture(scope="session")
def shared_window(application):
    """Lends the window of this process: see `SharedWindow`."""
    shared = SharedWindow(application)
    yield shared
    shared.give_up()


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
    motion = ROOT / "tests" / "cases" / "noise_1.txt"  # the first twelve seconds
    path.write_text(
        f'[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0\nmechanism = "two_sided"\n'
        f'[[record]]\nfile = "{motion.as_posix()}"\nkind = "artificial"\n'
        "[analysis]\nq_step = 0.02\n[demand]\nag_g = 0.2\nsoil_factor = 1.2\n"
    )
    made.files.open(path)
    settle(application, lambda: made.records.motions and not made.records.pending)


def with_verdict(application, window, result):
    """This window on verdict.toml and this result of it, as after a run."""
    from tests.app.driving import settle

    assert window.files.open(SEVEN)
    settle(application, lambda: window.records.motions and not window.records.pending)
    window.navigator.show_page("walls")
    window.navigator.take(result)
    assert not window.session.stale
    return window


def new_window(folder):
    """A window whose settings and recovery files are in this folder."""
    from PySide6.QtCore import QSettings

    from app.look import language
    from app.shell import window

    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("language", "en")
    settings.setValue("live", False)  # it would compute beside each test
    language.set_language("en")
    made = window.MainWindow(settings, folder / "recovery_folder")
    made.resize(*SIZE)
    made.show()
    return made


def end(application, made) -> None:
    """Close a window and delete it, nothing asked; the next is light and in English."""
    from app.look import language, theme
    from app.views.table import Table

    made.session.saved = made.session.case
    made.close()
    made.deleteLater()
    delete_now(application)
    application.processEvents()
    Table.stale = False  # of the window in front, and there is none
    language.set_language("en")
    if theme.current is not theme.THEMES["light"]:
        theme.set_theme("light")


def window_in(application, tmp_path, monkeypatch, faults):
    """`fresh` in this folder, for a fixture of any scope."""
    quiet(monkeypatch, faults)
    made = new_window(tmp_path)
    open_small(application, made, tmp_path)
    yield made
    end(application, made)
    assert faults == []


class SharedWindow:
    """A window lent to one test after another: to make one takes eight times as long as to open a case in it.

    What a test can leave in it is put back: case, undo, result, pages, forms, settings, recovery files. What it has
    computed stays: a run that another test repeats takes its searches and checks from there.
    What cannot be ends it, and the next test has a new one: it is closed or busy, was built again (in another language,
    in large letters) or holds what a test put into it.
    """

    def __init__(self, application):
        from core.study.journal import MemoryJournal

        self.application, self.made = application, None
        self.finished_runs = MemoryJournal()

    def lend(self, folder):
        """The window on the small case of this folder."""
        from app.look.language import FORM_NAMES

        if self.made is not None:
            if self.is_idle():
                put_back_attributes(self.made, self.known)
            if not (self.is_idle() and self.is_whole()):
                self.give_up()
        if self.made is None:
            self.made = new_window(folder)
            self.centre, self.known = self.made.centralWidget(), attributes_of(self.made)
            self.sections, self.captions = sections_of(self.made), dict(FORM_NAMES.captions)
            self.folds = [section.head.isChecked() for section in self.sections]
        else:
            FORM_NAMES.captions.update(self.captions)  # a window in Italian has come between
            self.put_back(folder)
        self.made.runner.finished_runs = self.finished_runs
        open_small(self.application, self.made, folder)
        self.made.navigator.show_input("wall", 0)
        self.application.processEvents()
        return self.made

    def put_back(self, folder) -> None:
        """All that opening a case leaves as it is."""
        made, session = self.made, self.made.session
        made.settings.clear()
        made.settings.setValue("language", "en")
        made.settings.setValue("live", False)
        session.saved = session.case
        session.drop_recovery_file()
        session.close()
        session.recovery_folder = folder / "recovery_folder"
        made.runner.last_refusal = (None, None)
        made.preparation.started = False
        made.preparation.methods.clear()
        made.preparation.outcome = None
        made.timer.start()
        made.show_word("", "")
        made.resize(*SIZE)
        if (focus := made.focusWidget()) is not None:
            focus.clearFocus()
        for section, unfolded in zip(self.sections, self.folds, strict=True):
            section.head.setChecked(unfolded)
        for area in made.stages.input.areas.values():
            area.verticalScrollBar().setValue(0)
        made.stages.input.kind = ""  # forms and drawing share the width anew
        made.stages.show_stage("input")  # no page is made by what follows
        made.stages.why.setCurrentIndex(0)
        made.stages.answer.stack.setCurrentIndex(0)
        made.tree.rows = []
        made.activateWindow()

    def take_back(self) -> None:
        """End what the test began, and the window where it cannot be put back: in another language or theme."""
        from app.look import theme
        from app.look.language import current_language
        from app.views.table import Table

        made = self.made
        for one in windows_over(made):
            one.close()
            one.deleteLater()
        made.runner.cancel()
        delete_now(self.application)
        self.application.processEvents()
        Table.stale = False
        if (current_language(), theme.current) != ("en", theme.THEMES["light"]):
            self.give_up()

    def is_idle(self) -> bool:
        made = self.made
        return (
            made.runner.job is None and made.preparation.job is None and not made.records.pending and not made.closing
        )

    def is_whole(self) -> bool:
        made = self.made
        seen = made.isVisible() and not made.isMaximized() and not made.isFullScreen() and not windows_over(made)
        return seen and made.centralWidget() is self.centre and attributes_of(made) == self.known

    def give_up(self) -> None:
        """End the window, where there is one."""
        made, self.made = self.made, None
        if made is not None:
            end(self.application, made)


def parts_of(made) -> tuple:
    """A window and its parts that tests put functions of their own into."""
    windows = made, made.runner, made.navigator, made.files, made.session, made.preparation
    return *windows, made.records, made.demand, made.analysis, made.walls


def attributes_of(made) -> list[set[str]]:
    """Names that a window and its parts have: a test that puts its own function in the place of one adds to them."""
    return [set(vars(part)) for part in parts_of(made)]


def put_back_attributes(made, known: list[set[str]]) -> None:
    """Delete what a window and its parts have beyond the known names and their classes have as well: values that a run
    sets in the place of those of the class, and methods that `monkeypatch` put back."""
    for part, names in zip(parts_of(made), known, strict=True):
        for name in set(vars(part)) - names:
            of_class, method = getattr(type(part), name, parts_of), getattr(vars(part)[name], "__func__", None)
            if of_class is method or not callable(of_class):
                delattr(part, name)


def sections_of(made) -> list:
    """The parts of its forms that fold."""
    from app.look.section import FoldingSection

    return made.findChildren(FoldingSection)


def windows_over(made) -> list:
    """Windows and dialogs that belong to a window; menus and lists that fold out do too, and stay."""
    from PySide6.QtCore import Qt
    from PySide6.QtWidgets import QApplication

    kinds = (Qt.WindowType.Window, Qt.WindowType.Dialog)
    return [one for one in QApplication.topLevelWidgets() if one.windowType() in kinds and is_over(one, made)]


def is_over(one, made) -> bool:
    """Whether a window belongs to another one, directly or not."""
    while (one := one.parentWidget()) is not None:
        if one is made:
            return True
    return False
