"""The window: forms on the left, tabs in the middle, records and verdict on the right."""

import os
import time
from dataclasses import replace
from pathlib import Path

import pyqtgraph as pg
from PySide6.QtCore import QByteArray, QEvent, QSettings, QTimer
from PySide6.QtWidgets import (
    QComboBox,
    QDockWidget,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QMessageBox,
    QPushButton,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app import docks, language, menus, tabs, theme
from app.files import Files
from app.forms.fields import Field
from app.language import described, named, tr
from app.pages import Veil, card
from app.plots.history_tabs import ValidationTab
from app.preparation import Preparation
from app.session import Session
from app.worker import Job
from core.errors import InputError
from core.study.demand_input import target_of
from core.study.journal import Memory
from core.version import NAME

AUTOSAVE_MS = 4000


class MainWindow(QMainWindow):
    """One session in a window.

    settings : where its state is remembered
    recovery : folder of recovery files
    """

    def __init__(self, settings: QSettings, recovery: Path):
        super().__init__()
        self.settings = settings
        self.session = Session(recovery)
        self.session.listeners.append(self.refresh)
        self.files = Files(self, self.session, settings)
        self.job: Job | None = None
        self.preparation = Preparation(self)
        self.finished_runs = Memory()
        self.closing = self.to_end = False
        self.began = 0.0
        self.build()
        geometry = settings.value("geometry")
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        else:
            self.resize(1280, 800)
        self.timer = QTimer(self)
        self.timer.timeout.connect(self.session.autosave)
        self.timer.start(AUTOSAVE_MS)

    # building

    def build(self) -> None:
        """Everything that speaks or has a colour; again after a change of language or theme."""
        pg.setConfigOptions(antialias=True, exitCleanup=False)
        asked = menus.chosen(self.settings, "language", language.LANGUAGES)
        self.language = asked or language.system_language()
        for dock in self.findChildren(QDockWidget):
            self.removeDockWidget(dock)
            dock.setParent(None)
            dock.deleteLater()
        self.menuBar().clear()
        self._tabs()
        sides = docks.build(self, self.session, self.settings.value("state"))
        self.forms, self.walls, self.demand = sides.forms, sides.walls, sides.demand
        self.analysis, self.records = sides.analysis, sides.records
        self.card, self.card_veil = sides.card, sides.card_veil
        self.records.loaded.connect(self.records_loaded)
        self.actions_of = menus.build(self)
        self.run_action = self.actions_of.run
        line = docks.build_status(self)
        self.word, self.bar, self.cancel_button = line.word, line.bar, line.cancel_button
        self.cancel_button.clicked.connect(self.cancel)
        self.word_kind = ""
        self.show_running(self.job is not None)
        for field in self.fields:
            field.judged.connect(self.refresh)
        self.refresh()

    def _tabs(self) -> None:
        self.tabs = QTabWidget()
        made = tabs.pages(self.language, self._validation, self.pick)
        self.pages = {name: page for name, (page, _) in made.items()}
        self.tab_labels = tuple(label for _, label in made.values())
        for page, label in made.values():
            self.tabs.addTab(page, label)
        self.tabs.currentChanged.connect(lambda _: self.show_result())
        self.chosen = QComboBox()
        self.chosen.setMinimumWidth(80)
        self.chosen.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.chosen.setAccessibleName(tr("Wall shown"))
        self.chosen.activated.connect(lambda _: self._wall_chosen())
        self.banner = QLabel()
        self.banner.setStyleSheet(f"color: {theme.current.amber}; font-weight: 600;")
        self.run_button = QPushButton(tr("Run (F5)"))
        self.run_button.clicked.connect(self.run)
        bar = QHBoxLayout()
        bar.addWidget(self.run_button)
        bar.addWidget(self.chosen)
        bar.addWidget(self.banner, 1)
        centre = QWidget()
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(6, 6, 6, 0)
        layout.addLayout(bar)
        layout.addWidget(self.tabs, 1)
        self.pages["check"].content  # noqa: B018  (the first page is there at once)
        self.veil = Veil(self.tabs)
        self.setCentralWidget(centre)
        self.fresh: set[QWidget] = set()

    def _validation(self) -> ValidationTab:
        tab = ValidationTab()
        tab.asked.connect(self.state_accuracy)
        return tab

    def set_choice(self, setting: str, name: str) -> None:
        """Change the theme or the language, and build the window again."""
        self.settings.setValue(setting, name)
        self.settings.setValue("state", self.saveState())
        if setting == "theme":
            theme.set_theme(name)
        else:
            language.set_language(name)
        tab, wall = self.tabs.currentIndex(), self.chosen.currentIndex()
        widths = [dock.width() for dock in docks.sides(self)]
        self.build()
        QTimer.singleShot(0, self, lambda: docks.widen(self, widths))
        self.tabs.setCurrentIndex(tab)
        self.result_arrived(self.session.result)
        self.chosen.setCurrentIndex(wall)
        self.show_result()

    # what is shown

    @property
    def fields(self) -> list[Field]:
        """The fields of the case; those of a dialog are not among them."""
        forms = (self.walls, self.demand, self.analysis)
        return [field for form in forms for field in form.findChildren(Field)]

    def refresh(self) -> None:
        """After every change of the session."""
        for form in (self.walls, self.demand, self.analysis, self.records):
            form.show_case()
        mark = "*" if self.session.dirty else ""
        name = self.session.path.name if self.session.path else tr("untitled")
        self.setWindowTitle(f"{mark}{name} – {NAME}")
        self.actions_of.undo.setEnabled(bool(self.session.past))
        self.actions_of.redo.setEnabled(bool(self.session.future))
        stale = self.session.stale
        self.veil.cover(stale)
        self.card_veil.cover(stale)
        problem = self.session.problem()
        wall = self.walls.wall.name if self.walls.wall else ""
        for field in self.fields:
            field.show_rule(described(problem) if problem and field.named_in(problem, wall) else "")
        problem = described(problem) if problem else None
        if any(field.wrong for field in self.fields):
            problem = problem or tr("A field holds what is not accepted: see the words below it.")
        can_run = problem is None and self.job is None
        self.run_action.setEnabled(can_run)
        self.run_button.setEnabled(can_run)
        if problem:
            self.banner.setText(problem if len(problem) < 160 else problem[:157] + "…")
            self.banner.setToolTip(problem)
        else:
            ask = stale and self.job is None
            self.banner.setText(tr("The input has changed: press F5.") if ask else "")
            self.banner.setToolTip("")
        self.banner.setWordWrap(True)
        if self.tabs.currentWidget() is self.pages["spectra"]:
            self._show_spectra()
        menus.show_recent(self, self.actions_of.recent)
        self.preparation.prepare_next()

    def changeEvent(self, event) -> None:
        """Back from another program: has it changed a record?"""
        super().changeEvent(event)
        back = event.type() == QEvent.Type.ActivationChange and self.isActiveWindow()
        if back and self.job is None and not self.records.pending:
            self.records.read_again()

    def records_loaded(self) -> None:
        self.refresh()

    def _show_spectra(self) -> None:
        demand = self.session.case.demand
        try:
            target = target_of(demand, self.session.base_dir) if demand else None
        except (InputError, TypeError):
            target = None
        result = self.session.result
        rules = result.compliance if result and not self.session.stale else None
        floor = self.wall.floor if self.wall and not self.session.stale else None
        self.pages["spectra"].content.show_records(self.records.motions, target, rules, floor)

    @property
    def wall(self):
        result = self.session.result
        k = self.chosen.currentIndex()
        return result.walls[k] if result and 0 <= k < len(result.walls) else None

    def pick(self, k: int) -> None:
        """Show the k-th wall of the result on the tab Check."""
        self.chosen.setCurrentIndex(k)
        self._wall_chosen()
        self.tabs.setCurrentWidget(self.pages["check"])

    def _wall_chosen(self) -> None:
        self.fresh.clear()
        self.show_result()

    def show_result(self) -> None:
        """Fill the tab in front, once per result and wall."""
        tab = self.tabs.currentWidget()
        if tab is self.pages["spectra"]:
            self._show_spectra()
        elif tab not in self.fresh and (self.wall is not None or tab.made is None):
            content = tab.content
            if self.wall is None:
                return
            content.show_wall(self.session.result, self.wall)
            self.fresh.add(tab)
        self.veil.cover(self.session.stale)

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.veil.cover(self.session.stale)

    # running

    def show_word(self, text: str, kind: str = "message") -> None:
        """The word of the status line. kind : what it is about, for who may take it away again."""
        self.word.setText(text)
        self.word_kind = kind

    def show_running(self, on: bool) -> None:
        """Progress and Cancel, while there is something to cancel."""
        self.bar.setVisible(on)
        self.cancel_button.setVisible(on)
        self.actions_of.cancel.setEnabled(on)

    def run(self) -> None:
        """Run the case off this thread; the window stays alive."""
        case = self.session.checked()
        if case is None or self.job is not None or not self.run_action.isEnabled():
            return
        generation, made = self.session.generation, self.finished_runs.analyses
        base = self.session.base_dir

        def arrived(result) -> None:
            if generation == self.session.generation:
                if base != self.session.base_dir:  # saved elsewhere meanwhile
                    result = self.session.moved_result(result, base)
                self.result_arrived(result)
                self.show_word(
                    tr(
                        "{n} analyses in {seconds:.1f} s",
                        n=self.finished_runs.analyses - made,
                        seconds=result.elapsed,
                    )
                )

        from core.study.run import run

        self.records.read_again()
        self.start(
            lambda job: run(
                case, base_dir=base, jobs=os.cpu_count() or 1, journal=lambda _: self.finished_runs,
                on_progress=job.progress, cancelled=job.cancelled,
            ),
            arrived,
        )  # fmt: skip

    def start(self, work, arrived, to_end: bool = False) -> None:
        """Work off this thread, one at a time; `arrived(result)` unless it is cancelled before. to_end : the
        window does not close before its end."""
        if self.job is not None:
            return
        job = self.job = Job(work)
        self.to_end = to_end

        def unless_left(slot):
            return lambda *values: slot(*values) if self.job is job else None

        job.done.connect(unless_left(arrived))
        job.failed.connect(unless_left(self.failed))
        job.progressed.connect(unless_left(self._progressed))
        job.finished.connect(unless_left(self._ended))
        self.began = time.monotonic()
        self.bar.setRange(0, 0)
        self.show_word(tr("Running…"))
        self.show_running(True)
        job.start()
        self.refresh()

    def _progressed(self, done: int, planned: int) -> None:
        self.bar.setRange(0, max(planned, 1))
        self.bar.setValue(done)
        elapsed = time.monotonic() - self.began
        left = elapsed / done * (planned - done) if done else 0.0
        self.show_word(
            tr(
                "{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left",
                done=done,
                planned=planned,
                elapsed=elapsed,
                left=left,
            )
        )

    def _ended(self) -> None:
        self.job = None
        self.show_running(False)
        self.refresh()
        if self.closing:
            QTimer.singleShot(0, self.close)

    def failed(self, sentence: str, log: str) -> None:
        if log:
            sentence += "\n" + tr("Details are in {log}", log=log)
        self.closing = False
        self.show_word(tr("Not done."))
        QMessageBox.warning(self, tr("Not done"), sentence)

    def cancel(self) -> None:
        """Stop what runs: at once here, its thread ends when it can. What is being written is written."""
        if self.job is not None and self.job.cancel():
            self._ended()
            self.show_word(tr("Cancelled."))
        elif self.job is not None:
            self.show_word(tr("It is being written."))

    def start_afresh(self) -> None:
        """Another case is open: nothing of the last one stays."""
        self.cancel()
        self.walls.list.setCurrentRow(0)
        self.records.read_again()
        for field in self.fields:
            field.forget()
        self.result_arrived(None)

    def result_arrived(self, result) -> None:
        """Show a result of study.run, None while there is none."""
        self.session.result = result
        self.fresh.clear()
        self.chosen.clear()
        if result is None:
            self.card.setText(tr("No result yet: press F5."))
            for page in self.pages.values():
                page.empty()
            self.pages["check"].content  # noqa: B018  (it says what to do)
            self.show_result()
            self.refresh()
            return
        for wall in result.walls:
            self.chosen.addItem(f"{wall.name} – {named(wall.mechanism)}")
        self.card.setText(card(result, self.language))
        self.refresh()
        self.show_result()

    def state_accuracy(self) -> None:
        """The accuracy statement of the wall shown, off this thread."""
        result, k = self.session.result, self.chosen.currentIndex()
        if self.wall is None or self.job is not None or self.session.stale:
            return
        from core.study.run import accuracy_of

        def arrived(accuracy) -> None:
            self.show_word("", "")
            shown = self.session.result
            if shown is not None and shown.walls is result.walls:
                walls = list(shown.walls)
                walls[k] = replace(walls[k], accuracy=accuracy)
                self.session.result = replace(shown, walls=tuple(walls))
                if self.chosen.currentIndex() == k:
                    self.pages["validation"].content.show_accuracy(accuracy)

        wall = result.walls[k]
        self.start(
            lambda job: accuracy_of(
                wall, result.motions, result.method, result.search, job.cancelled
            ),
            arrived,
        )

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
        self.settings.setValue("state", self.saveState())
        event.accept()
