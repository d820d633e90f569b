"""The menus of the window."""

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import QSettings
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QDialog, QMenu, QMessageBox

from app.look import theme
from app.look.dialogs import delete_after_use
from app.look.language import tr
from app.shell import guide
from app.shell.files import EXAMPLE
from app.shell.header import stage_names
from core.text.sentence import LANGUAGES
from core.version import NAME, VERSION

if TYPE_CHECKING:
    from app.shell.window import MainWindow


class Actions(NamedTuple):
    """Entries of the menus that a window switches on and off; recent : the menu of files opened of late."""

    recent: QMenu
    undo: QAction
    redo: QAction
    run: QAction
    cancel: QAction


def build_menus(window: "MainWindow") -> Actions:
    """The menus behind the first button, with all actions and their keys."""
    close_what_if(window)
    window.actions_with_keys = []
    key, bar = QKeySequence.StandardKey, window.header.menu
    file = bar.addMenu(tr("&File"))
    add(window, file, tr("&New"), window.files.new, key.New)
    add(window, file, tr("&Open…"), window.files.ask_open, key.Open)
    recent = file.addMenu(tr("Open &recent"))
    examples = file.addMenu(tr("Open an &example"))
    for path in sorted(EXAMPLE.parent.glob("*.toml")):
        add(window, examples, title_of(path), lambda path=path: window.files.open(path))
    add(window, file, tr("&Save"), window.files.save, key.Save)
    add(window, file, tr("Save &as…"), window.files.save_as, QKeySequence("Ctrl+Shift+S"))
    file.addSeparator()
    add(window, file, tr("&Export workbook…"), window.files.ask_export, QKeySequence("Ctrl+E"))
    add(window, file, tr("Export calculation &note…"), window.files.ask_note, QKeySequence("Ctrl+Shift+E"))
    add(window, file, tr("Export all &figures…"), window.files.ask_figures)
    add(window, file, tr("Save as &Python…"), window.files.ask_script)
    file.addSeparator()
    add(window, file, tr("&Quit"), window.close, key.Quit)
    edit = bar.addMenu(tr("&Edit"))

    def paste() -> None:
        window.navigator.then_input(window.walls.paste)

    undo = add(window, edit, tr("&Undo"), window.session.undo, key.Undo)
    redo = add(window, edit, tr("&Redo"), window.session.redo, QKeySequence("Ctrl+Y"))
    add(window, edit, tr("&Find…"), lambda: find(window), QKeySequence("Ctrl+K"))
    add(window, edit, tr("&Paste walls"), paste, QKeySequence("Ctrl+Shift+V"))
    runs = bar.addMenu(tr("&Run"))
    run = add(window, runs, tr("&Run"), window.run, QKeySequence("F5"))
    cancel = add(window, runs, tr("&Cancel"), window.runner.cancel, QKeySequence("Esc"))
    studies = bar.addMenu(tr("&Study"))
    add(window, studies, tr("&Sweep of one value…"), lambda: open_sweep_window(window))
    add(window, studies, tr("&What if…"), lambda: open_what_if_window(window), "Ctrl+I")
    add(window, studies, tr("&Parametric study…"), lambda: open_study_window(window))
    view = bar.addMenu(tr("&View"))
    for number, (name, label) in enumerate(stage_names().items(), start=1):
        add(window, view, label, lambda name=name: window.navigator.show_stage(name), QKeySequence(f"Alt+{number}"))
    view.addSeparator()
    for number, (name, label) in enumerate(window.page_labels.items(), start=1):
        add(window, view, label, lambda name=name: window.navigator.show_page(name), QKeySequence(f"Ctrl+{number}"))
    add(window, view, tr("For the &client"), lambda: open_client_view(window), QKeySequence("F11"))
    view.addSeparator()
    add(window, view, tr("&Reset layout"), window.reset_layout)
    choices(window, view, tr("Theme"), "theme", {"light": tr("light"), "dark": tr("dark")}, theme.current.name)
    choices(window, view, tr("Language"), "language", LANGUAGES, window.language)
    helps = bar.addMenu(tr("&Help"))
    add(window, helps, tr("What is this field?"), lambda: explain(window), QKeySequence("F1"))
    add(window, helps, tr("&Guide"), lambda: guide.show_guide(window))
    add(window, helps, tr("&Shortcuts"), lambda: guide.show_shortcuts(window))
    add(window, helps, tr("Save the empty table of &walls…"), lambda: guide.save_template(window))
    add(window, helps, tr("&Verify a report…"), lambda: guide.show_verification(window))
    add(window, helps, tr("Solved &cases as a PDF…"), lambda: guide.save_solved_cases(window))
    add(window, helps, tr("Tests on a shake &table…"), lambda: guide.show_validation(window))
    add(window, helps, tr("Self-t&est"), lambda: guide.show_self_test(window))
    helps.addSeparator()
    add(window, helps, tr("&About"), lambda: show_about(window))
    return Actions(recent, undo, redo, run, cancel)


def title_of(path: Path) -> str:
    """What a case is called."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("title"):
            return line.split("=", 1)[1].strip().strip('"')
    return path.stem


def explain(window: "MainWindow") -> None:
    """What the field in focus is."""
    guide.explain(window)


def find(window: "MainWindow") -> None:
    """Find a field, an action, a wall, a page by its name."""
    from app.shell.finder import Finder

    with delete_after_use(Finder(window)) as finder:
        finder.exec()


def open_client_view(window: "MainWindow") -> None:
    """The walls before and after, for one who knows no symbols."""
    from app.shell.client_view import show

    show(window)


def open_study_window(window: "MainWindow") -> None:
    """The window of a parametric study, imported here: few starts of the program need it."""
    from app.shell.study_window import StudyWindow

    opened = window.findChild(StudyWindow) or StudyWindow(window)
    opened.show()
    opened.raise_()


def open_sweep_window(window: "MainWindow") -> None:
    """The window of a sweep, with what it found; made again in another language or theme."""
    from app.shell.sweep_window import SweepWindow

    opened = window.findChild(SweepWindow)
    if opened is not None and opened.look != (window.language, theme.current.name) and opened.job is None:
        opened.setParent(None)
        opened.deleteLater()
        opened = None
    opened = opened or SweepWindow(window)
    opened.show_case()
    opened.show()
    opened.raise_()


def open_what_if_window(window: "MainWindow") -> None:
    """The sliders of the wall of the form."""
    from app.shell.what_if_window import WhatIfWindow

    close_what_if(window)
    WhatIfWindow(window).show()


def close_what_if(window: "MainWindow") -> None:
    """Also where the window is built again: its words and colours are of the language and theme before."""
    old = window.findChild(QDialog, "what_if")
    if old is not None:
        old.reject()
        old.setParent(None)


def show_recent(window: "MainWindow", menu: QMenu) -> None:
    """Fill the menu of files opened or saved of late."""
    menu.clear()
    for name in window.files.recent:
        add(window, menu, name, lambda name=name: window.files.open(Path(name)))


def add(window: "MainWindow", menu, label: str, slot, keys=None) -> QAction:
    """An entry of a menu."""
    action = QAction(label, menu)  # it goes with its menu
    action.triggered.connect(lambda _=False: slot())
    if keys is not None:
        action.setShortcut(QKeySequence(keys))
        window.addAction(action)  # its keys work though its menu is closed
        window.actions_with_keys.append(action)
    menu.addAction(action)
    return action


def choices(window: "MainWindow", menu, label: str, setting: str, names: dict, current: str) -> None:
    """A menu of which one entry is ticked."""
    inside = menu.addMenu(label)
    group = QActionGroup(inside)
    for name, shown in names.items():
        action = add(window, inside, shown, lambda name=name: window.set_choice(setting, name))
        action.setCheckable(True)
        action.setChecked(name == current)
        group.addAction(action)


def chosen(settings: QSettings, key: str, names) -> str | None:
    """A setting that is one of these names; None for anything else a file may hold."""
    value = settings.value(key)
    return value if isinstance(value, str) and value in names else None


def show_about(window: "MainWindow") -> None:
    """What this program is."""
    QMessageBox.about(
        window,
        NAME,
        tr(
            "{name} {version}\nOut-of-plane overturning of masonry walls (Coccia, Di Carlo, Imperatore 2016; "
            "Circolare 7/2019 C8.7.1.2.1). The results are the engineer's responsibility.",
            name=NAME,
            version=VERSION,
        )
        + f"\n{guide.self_test_words(window)}",
    )
