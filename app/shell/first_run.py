"""The page of a start without a case: what do you have? It leads to the first answer."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCommandLinkButton, QVBoxLayout, QWidget

from app.look import theme
from app.look.labels import PlainLabel
from app.look.language import tr
from app.shell.files import EXAMPLE
from app.work.draft import TO_BE_GIVEN
from core.case.schema import Generate
from core.case.site import Demand

if TYPE_CHECKING:
    from app.shell.window import MainWindow


class FirstRun(QWidget):
    """chosen(name) : wall, records, table, paper, example or facade; opened(path) : a file of late"""

    chosen = Signal(str)
    opened = Signal(str)

    def __init__(self, recent: list[str]):
        super().__init__()
        column = QVBoxLayout(self)
        column.setContentsMargins(60, 30, 60, 30)
        heading = PlainLabel(tr("What do you have?"))
        heading.setStyleSheet(f"{theme.font_points(1.9)} font-weight: 700;")
        column.addWidget(heading)
        self.buttons = {}
        for name, title, words in (
            ("wall", tr("A wall to check"), tr("Sizes, mechanism, a_g: first answer without records, then F5.")),
            ("table", tr("A table of walls"), tr("Excel or CSV; an empty one is in the menu Help. Then a_g and F5.")),
            ("records", tr("Records to look at"), tr("Any format: what each file is, its spectrum, its measures.")),
            ("paper", tr("The study of the paper"), tr("Force reduction factors of many walls, with figures.")),
            (
                "example",
                tr("An example"),
                tr("Two walls under {n} motions: press F5 and look around.", n=Generate().count),
            ),
            ("facade", tr("A facade"), tr("Of a church: gable, rose window, portal, wedges of the nave walls.")),
        ):
            button = QCommandLinkButton(title, words)
            button.clicked.connect(lambda _=False, name=name: self.chosen.emit(name))
            column.addWidget(button)
            self.buttons[name] = button
        if recent:
            column.addWidget(PlainLabel(tr("Opened of late")))
        for name in recent[:4]:
            button = QCommandLinkButton(Path(name).name, str(Path(name).parent))
            button.clicked.connect(lambda _=False, name=name: self.opened.emit(name))
            column.addWidget(button)
        column.addStretch(1)
        column.setAlignment(Qt.AlignmentFlag.AlignTop)


def open_first_choice(window: "MainWindow", name: str) -> None:
    """Do what was chosen."""
    from app.shell import menus

    if name == "example":
        window.navigator.show_stage("input")
        return
    if name == "facade":
        if window.files.open(EXAMPLE.with_name("facade.toml")):
            window.navigator.show_input("wall", 0)
            window.walls.sections["body"].unfold()
        return
    if name == "paper":
        window.navigator.show_stage("input")
        menus.open_study_window(window)
        return
    if not window.files.new():
        return
    if name == "wall":
        _ask_demand(window)
        window.walls.add()
        window.navigator.show_input("wall", 0)
        window.walls.fields["height_m"].editor.setFocus()
    elif name == "records":
        window.navigator.show_input("records")
        window.records.add()
    else:
        window.navigator.show_input("wall")
        window.walls.load_table()
        _ask_demand(window)  # after its rows: one without a base is taken, and its base asked for
        if window.session.case.wall:
            window.missing.lead()


def _ask_demand(window: "MainWindow") -> None:
    """a_g and the bases are asked for from the beginning: without a demand there is no answer."""
    window.session.edit(replace(window.session.case, demand=Demand(TO_BE_GIVEN)))
