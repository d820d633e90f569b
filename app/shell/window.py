"""The window: a bar with four stages, the tree of the project, and the stage in front."""

from pathlib import Path

import pyqtgraph as pg
from PySide6.QtCore import QByteArray, QEvent, QSettings, QSize, QTimer
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from app.input.fields import Field
from app.look import language, theme
from app.look.focus import FocusFrame
from app.look.language import tr
from app.look.parts import Parts
from app.shell import menus, stages, tabs, tree
from app.shell.files import Files
from app.shell.header import Header
from app.shell.pages import Page
from app.shell.refused_texts import RefusedTexts
from app.shell.staged_window import StagedWindow
from app.shell.tree import ProjectTree
from app.views.chart_output import ChartOutput
from app.views.histories_tab import HistoriesTab
from app.views.note_tab import NoteTab
from app.views.table import Table
from app.views.validation_tab import ValidationTab
from app.work.preparation import Preparation
from app.work.session import Session
from app.work.worker import Collector
from core.study.journal import Memory
from core.text.sentence import LANGUAGES
from core.text.start import system_language
from core.version import NAME

AUTOSAVE_MS = 4000

FIRST_SIZE, FRAME = QSize(1280, 800), QSize(8, 40)
"""Of the window at first, and of what the desktop puts around it [px]."""


class MainWindow(StagedWindow):
    """One session in a window.

    settings : where its state is remembered
    recovery : folder of recovery files
    """

    def __init__(self, settings: QSettings, recovery: Path):
        super().__init__()
        self.settings = settings
        self.setAcceptDrops(True)
        self.collector = Collector(self)
        self.session = Session(recovery)
        self.session.listeners.append(self.refresh)
        self.files = Files(self, self.session, settings)
        self.preparation = Preparation(self)
        self.parts = Parts(self)
        self.focus_frame = FocusFrame(self)
        self.finished_runs = Memory()
        self.build()
        geometry = settings.value("geometry")
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        else:
            self._first_size()
        self.timer = QTimer(self)
        self.timer.timeout.connect(self.session.autosave)
        self.timer.start(AUTOSAVE_MS)

    # building

    def build(self) -> None:
        """Everything that speaks or has a colour; again after a change of language or theme."""
        pg.setConfigOptions(antialias=True, exitCleanup=False)
        asked = menus.chosen(self.settings, "language", LANGUAGES)
        self.language = asked or system_language()
        stages.remove(self)
        self.shown, self.fresh = -1, set()
        self._known_rows: tuple = (None, None, {})
        made = tabs.pages(self.language, self._validation, self.pick, self._note, self.ask, self.pick_run)
        self.pages = {name: page for name, (page, _) in made.items()}
        self.page_labels = {name: label for name, (_, label) in made.items()}
        self.beside = Page(HistoriesTab)
        self.stages = stages.Stages(self, self.session, made, self.beside)
        self._name_parts()
        self._frame()
        self.actions_of = menus.build(self)
        self.run_action = self.actions_of.run
        self.word = stages.build_status(self)
        self.word_kind = ""
        self.show_running(self.job is not None)
        for field in self.fields:
            field.judged.connect(self.refresh)
        self.parts.deleteLater()
        self.parts = Parts(
            self,
            self._show_state,
            self.walls.show_case,
            self.demand.show_case,
            self.demand.building.show_case,
            self.analysis.show_case,
            self.records.show_case,
            self.stages.note_form.show_case,
            self._show_stale,
            self._show_note,
            self._show_problem,
            self._show_tree,
            self._show_input,
            self._show_recent,
            self.preparation.prepare_next,
        )
        self.stages.input.show_kind("wall")
        self.show_stage("input")
        self.refresh()

    def _name_parts(self) -> None:
        """Parts of the stages that others ask for."""
        given = self.stages.input
        self.walls, self.demand, self.analysis, self.records = given.walls, given.demand, given.analysis, given.records
        self.forms, self.missing = given.forms, given.missing
        self.why, self.veil, self.bar = self.stages.why, self.stages.veil, self.stages.bar
        self.records.loaded.connect(self.records_loaded)
        for page in self.pages.values():
            page.asked.connect(self._notice_clicked)
        self.demand.motions_asked.connect(lambda: self.ask("generate"))
        self.walls.selected.connect(self._wall_selected)
        self.walls.told.connect(self.show_word)
        self.why.currentChanged.connect(lambda _: self.show_result())
        self.stages.answer.widened.connect(self._show_beside)
        self.pages["walls"].content  # noqa: B018  (the first page is there at once)

    def _frame(self) -> None:
        """The bar above, the tree at the left, the stage."""
        self.header, self.tree = Header(), ProjectTree()
        self.header.staged.connect(self.show_stage)
        self.header.noticed.connect(self._notice_clicked)
        self.run_button, self.cancel_button = self.header.run_button, self.header.cancel_button
        for button, slot in (
            (self.run_button, self.run),
            (self.cancel_button, self.cancel),
            (self.header.undo_button, self.session.undo),
            (self.header.find_button, lambda: menus.find(self)),
            (self.header.help_button, lambda: menus.explain(self)),
        ):
            button.clicked.connect(lambda _=False, slot=slot: slot())
        walls = self.walls
        self.tree.set_buttons(
            [
                (tr("+ wall"), tr("Add a wall"), lambda: self._then_input(walls.add)),
                (
                    tr("+ variant"),
                    tr("The wall as it is and, beside it, to be changed"),
                    lambda: self._then_input(walls.add_variant),
                ),
                (tr("copy"), tr("Copy this wall"), lambda: self._then_input(walls.duplicate)),
                (tr("paste"), tr("Paste rows copied from Excel"), lambda: self._then_input(walls.paste)),
                (tr("table…"), tr("Read walls from .xlsx or .csv"), lambda: self._then_input(walls.load_table)),
                (tr("delete"), tr("Delete this wall"), walls.delete),
            ]
        )
        self.tree.chosen.connect(self.choose_row)
        centre = QWidget()
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.header)
        row = QHBoxLayout()
        row.setSpacing(0)
        row.addWidget(self.tree)
        row.addWidget(self.stages, 1)
        column.addLayout(row, 1)
        self.setCentralWidget(centre)
        self.tree.fit(self.width())

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.tree.fit(self.width())

    def _validation(self) -> ValidationTab:
        tab = ValidationTab()
        tab.asked.connect(self.state_accuracy)
        return tab

    def _note(self) -> NoteTab:
        tab = NoteTab(lambda: self.session.base_dir)
        tab.checked.connect(self.pick)
        tab.picked.connect(self.pick_input)
        tab.exported.connect(self.files.ask_note)
        return tab

    def set_choice(self, setting: str, name: str) -> None:
        """Change the theme or the language, and build the window again where it is another."""
        self.settings.setValue(setting, name)
        shown = {theme.current.name} if setting == "theme" else {language.current_language(), self.language}
        if shown == {name}:
            return
        if setting == "theme":
            theme.set_theme(name)
        else:
            language.set_language(name)
        page, stage, shown, row = self.page, self.stages.front, self.shown, self.walls.row
        chosen, refused = self.tree.current, RefusedTexts(self)
        self.build()
        self.walls.row = row
        self.result_arrived(self.session.result)
        if chosen is not None:
            self.tree.select(chosen.key)
        self.shown = shown
        self.refresh()
        refused.type_into(self)
        if page is not None:
            self.show_page(page)
        else:
            self.show_stage(stage)

    def reset_layout(self) -> None:
        """The size of the first start."""
        self.settings.remove("geometry")
        self.showNormal()
        self._first_size()

    def _first_size(self) -> None:
        """As large as its contents want, no larger than the screen."""
        free = self.screen().availableGeometry()
        self.resize(FIRST_SIZE.boundedTo(free.size() - FRAME))
        if not free.contains(self.frameGeometry()):
            self.move(free.topLeft())

    # what is shown

    @property
    def fields(self) -> list[Field]:
        """The fields of the case; those of a dialog are not among them."""
        forms = (self.walls, self.demand, self.demand.building, self.analysis, self.stages.note_form)
        return [field for form in forms for field in form.findChildren(Field)]

    def refresh(self) -> None:
        """After every change of the session."""
        self.parts.show()

    def _show_state(self) -> None:
        mark = "*" if self.session.dirty else ""
        name = self.session.path.name if self.session.path else tr("untitled")
        self.setWindowTitle(f"{mark}{name} – {NAME}")
        self.header.say(f"{mark}{self.session.case.title}")
        self.actions_of.undo.setEnabled(bool(self.session.past))
        self.header.undo_button.setEnabled(bool(self.session.past))
        self.actions_of.redo.setEnabled(bool(self.session.future))

    def _show_stale(self) -> None:
        ChartOutput.stale = Table.stale = self.session.stale
        self._cover_pages()

    def _show_note(self) -> None:
        """The pages hold what is typed beside them."""
        page = self.pages["note"]
        if page.made is not None and page.content.result is not self.session.result:
            self.fresh.discard(page)
            self.show_result()

    def _show_problem(self) -> None:
        runs = self.missing.show_problems()
        can_run = runs and self.job is None
        self.run_action.setEnabled(can_run)
        self.run_button.setEnabled(can_run)
        count, words = len(self.missing.problems), ""
        if count and self.stages.front != "input":
            words = tr("Before F5: {n}", n=count)
        elif not count and self.session.stale and self.job is None:
            words = tr("The input has changed: press F5.")
        self.header.show_notice(words, self.missing.text())
        self._say_empty()

    def _show_tree(self) -> None:
        finished = self.zetas_so_far() if self.job is not None and self.finished_walls else None
        state = tree.State(
            self.session.case,
            self.session.result,
            self.session.stale,
            self.session.problems(),
            len(self.records.motions),
            self.records.unreadable_row() is not None,
            self.results_of(),
            finished,
        )
        self.tree.show_rows(tree.rows_of(state))
        self.follow_tree()

    def _show_input(self) -> None:
        """What a page shows of the input as it stands."""
        if self.page == "spectra":
            self._show_spectra()

    def _show_recent(self) -> None:
        menus.show_recent(self, self.actions_of.recent)

    def changeEvent(self, event) -> None:
        """Back from another program: has it changed a record?"""
        super().changeEvent(event)
        back = event.type() == QEvent.Type.ActivationChange and self.isActiveWindow()
        if back and self.job is None and not self.records.pending:
            self.records.read_again()

    def dragEnterEvent(self, event) -> None:
        """Records are taken wherever they are dropped."""
        self.records.dragEnterEvent(event)

    def dropEvent(self, event) -> None:
        self.show_input("records")
        self.records.dropEvent(event)

    def records_loaded(self) -> None:
        self.refresh()

    def start_afresh(self) -> None:
        """Another case is open: nothing of the last one stays."""
        self.cancel()
        self.walls.row = 0
        self.records.read_again()
        for field in self.fields:
            field.forget()
        for form in (self.walls, self.demand, self.demand.building):
            form.forget()
        self.result_arrived(None)
        self.show_input("wall", 0)

    def result_arrived(self, result) -> None:
        """Show a result of study.run, None while there is none."""
        self.session.result = result
        self.fresh.clear()
        if result is None:
            self.shown = -1
            for page in (*self.pages.values(), self.beside):
                page.empty()
            self.pages["walls"].content  # noqa: B018  (it says what to do)
        else:
            known = self.results_of().get(self.walls.current, [])
            if self.shown not in known:
                self.shown = known[0] if known else 0
        self.refresh()
        self.show_result()

    def closeEvent(self, event) -> None:
        if not self.closing and not self.files.give_up():
            event.ignore()
            return
        if not self.to_end:
            self.cancel()
        if self.job is not None:
            # it writes files: the window goes when they are there, and stays to say if they are not
            self.closing = True
            event.ignore()
            return
        self.timer.stop()
        self.session.drop_recovery_file()
        self.session.close()
        self.settings.setValue("geometry", self.saveGeometry())
        event.accept()
