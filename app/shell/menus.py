"""The menus of the window."""

from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QSettings
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QDockWidget, QMenu, QMessageBox

from app.look import theme
from app.look.language import tr
from app.shell import guide
from app.shell.files import EXAMPLE
from core.text.sentence import LANGUAGES
from core.version import NAME, VERSION


class Actions(NamedTuple):
    """Entries of the menus that a window switches on and off; recent : the menu of files opened of late."""

    recent: QMenu
    undo: QAction
    redo: QAction
    run: QAction
    cancel: QAction


def build(window) -> Actions:
    """Menu bar with all actions and their keys."""
    window.actions_with_keys = []
    key = QKeySequence.StandardKey
    file = window.menuBar().addMenu(tr("&File"))
    add(window, file, tr("&New"), window.files.new, key.New)
    add(window, file, tr("&Open…"), window.files.ask_open, key.Open)
    recent = file.addMenu(tr("Open &recent"))
    add(window, file, tr("Open the &example"), lambda: window.files.open(EXAMPLE))
    add(window, file, tr("&Save"), window.files.save, key.Save)
    add(window, file, tr("Save &as…"), window.files.save_as, QKeySequence("Ctrl+Shift+S"))
    file.addSeparator()
    add(window, file, tr("&Export workbook…"), window.files.ask_export, QKeySequence("Ctrl+E"))
    add(window, file, tr("Export calculation &note…"), window.files.ask_note, QKeySequence("Ctrl+Shift+E"))
    add(window, file, tr("Export all &figures…"), window.files.ask_figures)
    file.addSeparator()
    add(window, file, tr("&Quit"), window.close, key.Quit)
    edit = window.menuBar().addMenu(tr("&Edit"))
    undo = add(window, edit, tr("&Undo"), window.session.undo, key.Undo)
    redo = add(window, edit, tr("&Redo"), window.session.redo, QKeySequence("Ctrl+Y"))
    add(window, edit, tr("&Paste walls"), lambda: window.walls.paste(), QKeySequence("Ctrl+Shift+V"))
    runs = window.menuBar().addMenu(tr("&Run"))
    run = add(window, runs, tr("&Run"), window.run, QKeySequence("F5"))
    cancel = add(window, runs, tr("&Cancel"), window.cancel, QKeySequence("Esc"))
    studies = window.menuBar().addMenu(tr("&Study"))
    add(window, studies, tr("&Parametric study…"), lambda: study(window))
    view = window.menuBar().addMenu(tr("&View"))
    for dock in window.findChildren(QDockWidget):
        view.addAction(dock.toggleViewAction())
    view.addSeparator()
    for k, label in enumerate(window.tab_labels):
        add(window, view, label, lambda k=k: window.tabs.setCurrentIndex(k), QKeySequence(f"Ctrl+{k + 1}"))
    view.addSeparator()
    add(window, view, tr("&Reset layout"), window.reset_layout)
    choices(window, view, tr("Theme"), "theme", {"light": tr("light"), "dark": tr("dark")}, theme.current.name)
    choices(window, view, tr("Language"), "language", LANGUAGES, window.language)
    helps = window.menuBar().addMenu(tr("&Help"))
    add(window, helps, tr("What is this field?"), lambda: guide.explain(window), QKeySequence("F1"))
    add(window, helps, tr("&Guide"), lambda: guide.show_guide(window))
    add(window, helps, tr("&Shortcuts"), lambda: guide.show_shortcuts(window))
    add(window, helps, tr("Save the empty table of &walls…"), lambda: guide.save_template(window))
    helps.addSeparator()
    add(window, helps, tr("&About"), lambda: about(window))
    return Actions(recent, undo, redo, run, cancel)


def study(window) -> None:
    """The window of a parametric study, imported here: few starts of the program need it."""
    from app.shell.study_window import StudyWindow

    opened = window.findChild(StudyWindow) or StudyWindow(window)
    opened.show()
    opened.raise_()


def show_recent(window, menu: QMenu) -> None:
    """Fill the menu of files opened or saved of late."""
    menu.clear()
    for name in window.files.recent:
        add(window, menu, name, lambda name=name: window.files.open(Path(name)))


def add(window, menu, label: str, slot, keys=None) -> QAction:
    """An entry of a menu."""
    action = QAction(label, menu)  # it goes with its menu
    action.triggered.connect(lambda _=False: slot())
    if keys is not None:
        action.setShortcut(QKeySequence(keys))
        window.actions_with_keys.append(action)
    menu.addAction(action)
    return action


def choices(window, menu, label: str, setting: str, names: dict, current: str) -> None:
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


def about(window) -> None:
    """What this program is."""
    QMessageBox.about(
        window,
        NAME,
        tr(
            "{name} {version}\nOut-of-plane overturning of masonry walls (Coccia, Di Carlo, Imperatore 2016; "
            "Circolare 7/2019 C8.7.1.2.1). The results are the engineer's responsibility.",
            name=NAME,
            version=VERSION,
        ),
    )
