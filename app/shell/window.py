"""The window: a bar with four stages, the tree of the project, and the stage in front."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QByteArray, QEvent, QSettings, QSize, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QMainWindow, QMessageBox, QVBoxLayout, QWidget

from app.input.entries_form import EntriesForm
from app.look import language, theme
from app.look.case_views import TYPING_PAUSE_MS, CaseViews, VisibleForm, typed_edit
from app.look.focus import FocusFrame
from app.look.labels import escape_html
from app.look.language import tr
from app.shell import guide, menus, stages, tabs, tree
from app.shell.files import Files
from app.shell.first_run import FirstRun, open_first_choice
from app.shell.header import Header
from app.shell.navigator import Navigator
from app.shell.pages import LazyPage
from app.shell.refused_texts import RefusedTexts
from app.shell.tree import ProjectTree
from app.views.table import Table
from app.work.preparation import Preparation
from app.work.runner import Runner
from app.work.session import Session
from app.work.worker import Collector
from core.case.schema import Case
from core.study.results import StudyResult
from core.text.sentence import LANGUAGES
from core.text.start import system_language
from core.version import NAME

AUTOSAVE_MS = 4000

FINISHED_AT_ONCE, BETWEEN_FINISHED = 20, 250
"""Least time between two tables of more finished walls than these [ms]: of 200 each takes 50 ms."""

FIRST_SIZE, FRAME = QSize(1280, 800), QSize(8, 40)
"""Size of the window at first, and of what the desktop puts around it [px]."""


class MainWindow(QMainWindow):
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
        self.parts = CaseViews(self)
        self.focus_frame = FocusFrame(self)
        self.closing = False
        self.autosaved: Case | None = None
        self.actions_with_keys: list[QAction] = []
        self.runner = Runner(self.session, self)
        self._follow_runner()
        self.build()
        geometry = settings.value("geometry")
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        else:
            self._first_size()
        self.finished_timer = QTimer(self, singleShot=True)
        self.finished_timer.timeout.connect(self._show_finished)
        self.timer = QTimer(self)
        self.timer.timeout.connect(self._autosave)
        self.timer.start(AUTOSAVE_MS)

    # building

    def build(self) -> None:
        """Everything that speaks or has a colour; again after a change of language or theme."""
        asked = menus.chosen(self.settings, "language", LANGUAGES)
        self.language = asked or system_language()
        stages.remove(self)
        made = tabs.pages(self.language, lambda: self.navigator, self.files.ask_note)
        self.page_labels = {name: label for name, (_, label) in made.items()}
        self.stages = stages.Stages(self, self.session, made, LazyPage(tabs.histories))
        self.pages = self.stages.pages
        self._name_parts()
        self._frame()
        self.navigator = Navigator(self.session, self.runner, self.stages, self.header, self.tree)
        self.navigator.staged.connect(self._show_problem)
        self.navigator.staged.connect(self._show_input)
        self.navigator.moved.connect(self.refresh)
        self.navigator.run_asked.connect(self.run)
        self.actions_of = menus.build_menus(self)
        self.run_action = self.actions_of.run
        self.word = stages.build_status(self)
        self.word_kind = ""
        self.show_running(self.runner.job is not None)
        for field in self.stages.fields:
            field.judged.connect(self._judged)
        for entries in self.walls.findChildren(EntriesForm):
            entries.chosen.connect(self._show_problem)
        self.parts.deleteLater()
        building, note = self.demand.building, self.stages.note_form
        forms = [VisibleForm(one, one.show_case) for one in (self.walls, self.demand, building, self.analysis, note)]
        self.forms = forms  # a signal keeps none of them
        self.parts = CaseViews(
            self,
            self._show_state,
            *(form.at_once for form in forms),
            self.records.show_case,  # it reads what it shows, whatever is in front
            self._show_stale,
            self._may_run,
            self.stages.input.live.follow,
            resting=(
                *(form.at_rest for form in forms),
                self._show_note,
                self._show_problem,
                self._may_run,  # again: forms that followed hide and show fields
                self.stages.input.live.follow,
                self._show_tree,
                self._show_input,
                self.preparation.prepare_next,
            ),
        )
        self.stages.input.show_kind("wall")
        self.navigator.show_stage("input")
        self.show_recent()
        self.refresh()

    def _name_parts(self) -> None:
        """Parts of the stages that others ask for."""
        given = self.stages.input
        self.walls, self.demand, self.analysis, self.records = given.walls, given.demand, given.analysis, given.records
        self.missing = given.missing
        self.records.loaded.connect(self.refresh)
        self.walls.told.connect(self.show_word)

    def _frame(self) -> None:
        """The bar above, the tree at the left, the stage."""
        self.header, self.tree = Header(), ProjectTree()
        self.run_button, self.cancel_button = self.header.run_button, self.header.cancel_button
        for button, slot in (
            (self.run_button, self.run),
            (self.cancel_button, self.runner.cancel),
            (self.header.undo_button, self.session.undo),
            (self.header.find_button, lambda: menus.find(self)),
            (self.header.help_button, lambda: menus.explain(self)),
        ):
            button.clicked.connect(lambda _=False, slot=slot: slot())
        walls = self.walls

        def then_shown(change: Callable[[], object]) -> Callable[[], None]:
            return lambda: self.navigator.then_input(change)

        self.tree.set_buttons(
            [
                (tr("+ wall"), tr("Add a wall"), then_shown(walls.add)),
                (tr("+ variant"), tr("The wall as it is and, beside it, to be changed"), then_shown(walls.add_variant)),
                (tr("copy"), tr("Copy this wall"), then_shown(walls.duplicate)),
                (tr("paste"), tr("Paste rows copied from Excel"), then_shown(walls.paste)),
                (tr("table…"), tr("Read walls from .xlsx or .csv"), then_shown(walls.load_table)),
                (tr("delete"), tr("Delete this wall"), walls.delete),
            ]
        )
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

    def set_choice(self, setting: str, name: str) -> None:
        """Change the theme or the language, and build the window again where it is another."""
        self.settings.setValue(setting, name)
        shown = {theme.current.name} if setting == "theme" else {language.current_language(), self.language}
        if shown == {name}:
            return
        self.parts.flush_pending()
        page, stage, shown, row = self.navigator.page, self.stages.front, self.navigator.shown, self.walls.row
        chosen, refused = self.tree.current, RefusedTexts(self)
        stages.remove(self)  # before: what goes is not to be painted in another theme first
        if setting == "theme":
            theme.set_theme(name)
        else:
            language.set_language(name)
        self.build()
        self.walls.row = row
        self.navigator.take(self.session.result)
        if chosen is not None:
            self.tree.select(chosen.key)
        self.navigator.shown = shown
        if self.runner.finished_walls and self.runner.job is None:
            self.navigator.keep_finished()
        self.refresh()
        refused.type_into(self)
        if page is not None:
            self.navigator.show_page(page)
        else:
            self.navigator.show_stage(stage)

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

    # what runs

    def _follow_runner(self) -> None:
        """Show what it tells; the parts it is shown by are made again with each `build`."""
        runner = self.runner
        runner.case_starts.connect(self._case_starts)
        runner.started.connect(self._started)
        runner.told.connect(self.show_word)
        runner.progressed.connect(self._progressed)
        runner.found.connect(self._found)
        runner.judged.connect(lambda: self.navigator.show_judged())
        runner.result_ready.connect(self._arrived)
        runner.accuracy_stated.connect(lambda k, accuracy: self.navigator.show_accuracy(k, accuracy))
        runner.refused.connect(self._refused)
        runner.ended.connect(self._ended)

    def run(self) -> None:
        """Run the case, unless something is missing or another job runs."""
        self.parts.flush_pending()
        if self.run_action.isEnabled() and self.missing.can_run():
            self.runner.run()

    def show_word(self, text: str, kind: str = "message") -> None:
        """The word of the status line. kind : what it is about, for who may take it away again."""
        self.word.setText(text)
        self.word.setToolTip(escape_html(text))
        self.word_kind = kind

    def show_running(self, on: bool) -> None:
        """Progress over the stage, and Cancel in the place of Run, while there is something to cancel."""
        self.stages.bar.setVisible(on)
        self.cancel_button.setVisible(on)
        self.run_button.setVisible(not on)
        self.actions_of.cancel.setEnabled(on)

    def _case_starts(self) -> None:
        self.records.read_again()
        self.navigator.show_page("walls")

    def _started(self) -> None:
        self.stages.bar.setRange(0, 0)
        self.show_running(True)
        self.refresh()

    def _progressed(self, done: int, planned: int, words: str) -> None:
        bar = self.stages.bar
        bar.setRange(0, max(planned, 1))
        bar.setValue(done)
        bar.setFormat(words.replace("%", "%%"))

    def _found(self) -> None:
        """Another wall is finished: of many, those that come within a moment are shown together."""
        if len(self.runner.finished_walls) <= FINISHED_AT_ONCE:
            self._show_finished()
        elif not self.finished_timer.isActive():
            self.finished_timer.start(BETWEEN_FINISHED)

    def _show_finished(self) -> None:
        if self.runner.job is not None and self.runner.finished_walls:
            self.navigator.show_finished()
            self._show_tree()

    def _arrived(self, result: StudyResult) -> None:
        self.navigator.take(result)
        self.navigator.show_answer()

    def _refused(self, sentence: str) -> None:
        self.closing = False
        QMessageBox.warning(self, tr("Not done"), escape_html(sentence))

    def warn_of_self_test(self) -> None:
        """The numbers of this machine are not to be used."""
        words = guide.self_test_words(self)
        self.show_word(words)
        QMessageBox.warning(self, tr("Self-test"), escape_html(words))

    def _ended(self, partly: bool) -> None:
        self.stages.bar.setFormat("")
        if partly and self.runner.cancelled and self.runner.is_of_input:
            self.navigator.keep_finished()
        elif partly:
            self.runner.forget_finished()
            self.navigator.leave_finished()
        self.show_running(False)
        self.refresh()
        if self.closing:
            QTimer.singleShot(0, self.close)

    # what is shown

    def show_first_run(self) -> None:
        """Ask what there is, until a stage is chosen."""
        page = FirstRun(self.files.recent)
        page.chosen.connect(lambda name: open_first_choice(self, name))
        page.opened.connect(lambda name: self.files.open(Path(name)))
        self.stages.show_first(page)

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
        Table.stale = self.session.stale
        if self.navigator.parts and self.runner.job is None and not self.runner.is_of_input:
            self.runner.forget_finished()
            self.navigator.leave_finished()
        self.navigator.cover_pages()

    def _show_note(self) -> None:
        """The pages hold what is typed beside them."""
        page = self.pages["note"]
        if page.made is None:
            return
        from app.views.note_tab import NoteTab

        if isinstance(page.made, NoteTab) and page.made.result is not self.session.result:
            self.navigator.fresh.discard(page)
            self.navigator.show_result()

    def _judged(self) -> None:
        """A field takes or refuses what was typed into it."""
        with typed_edit():
            self.refresh()

    def _may_run(self) -> None:
        """At each key, for F5 may come right after it."""
        can_run = self.runner.job is None and self.missing.can_run()
        self.run_action.setEnabled(can_run)
        self.run_button.setEnabled(can_run)

    def _show_problem(self) -> None:
        self.missing.show_problems()
        count, words = len(self.missing.problems), ""
        if count and self.stages.front != "input":
            words = tr("Before F5: {n}", n=count)
        elif not count and self.session.stale and self.runner.job is None:
            words = tr("The input has changed: press F5.")
        self.header.show_notice(words, self.missing.text())
        self.navigator.say_empty()

    def _show_tree(self) -> None:
        runner = self.runner
        so_far = runner.job is not None and runner.finished_walls and runner.is_of_input
        finished = runner.zetas_so_far() if so_far else None
        state = tree.State(
            self.session.case,
            self.session.result,
            self.session.stale,
            self.session.problems(),
            len(self.records.motions),
            self.records.unreadable_row() is not None,
            self.navigator.results_of(),
            finished,
        )
        self.tree.show_rows(tree.rows_of(state))
        self.navigator.follow_tree()

    def _show_input(self) -> None:
        """What a page shows of the input as it stands."""
        given = self.stages.input
        if self.navigator.page == "spectra":
            self.navigator.show_spectra()
        elif (
            self.stages.front == "input"
            and given.kind == "records"
            and (self.records.motions or given.spectra.made is not None)
        ):
            self.navigator.show_spectra(given.spectra)

    def show_recent(self) -> None:
        """The files of late in the menu."""
        menus.show_recent(self, self.actions_of.recent)

    def changeEvent(self, event) -> None:
        """Back from another program: has it changed a record?"""
        super().changeEvent(event)
        back = event.type() == QEvent.Type.ActivationChange and self.isActiveWindow()
        if back and self.runner.job is None and not self.records.pending:
            self.records.read_again()

    def dragEnterEvent(self, event) -> None:
        """Records are taken wherever they are dropped."""
        self.records.dragEnterEvent(event)

    def dropEvent(self, event) -> None:
        self.navigator.show_input("records")
        self.records.dropEvent(event)

    def _autosave(self) -> None:
        """Keep the case for a crash, unless it is kept already: of 200 walls that takes a tenth of a second. Saving, or
        taking back all changes, drops the file of a case that may come back. Never between two keys."""
        if not self.timer.isActive():  # the window is closed
            return
        if self.parts.wait():
            QTimer.singleShot(TYPING_PAUSE_MS, self, self._autosave)
            return
        kept = self.session.case is self.autosaved and self.session.recovery_file.exists()
        if not kept and self.session.autosave():
            self.autosaved = self.session.case

    def start_afresh(self, open_case: Callable[[], None]) -> None:
        """Have `open_case` put another case in the place of this one, of which nothing stays; it may raise InputError
        before it changes anything. All is shown once, when it is there."""
        with self.parts.once():
            open_case()
            self.runner.cancel()
            self.walls.row = 0
            self.records.read_again()
            for field in self.stages.fields:
                field.forget()
            for form in (self.walls, self.demand, self.demand.building):
                form.forget()
            self.stages.show_stage("input")  # no page in front is made anew to show that there is nothing
            self.navigator.take(None)
        self.navigator.show_input("wall", 0)

    def closeEvent(self, event) -> None:
        self.parts.flush_pending()
        if not self.closing and not self.files.give_up():
            event.ignore()
            return
        if not self.runner.is_uncancellable:
            self.runner.cancel()
        if self.runner.job is not None:
            # it writes files: the window goes when they are there, and stays to say if they are not
            self.closing = True
            event.ignore()
            return
        self.timer.stop()
        self.stages.input.live.end()
        self.session.drop_recovery_file()
        self.session.close()
        self.settings.setValue("geometry", self.saveGeometry())
        event.accept()
