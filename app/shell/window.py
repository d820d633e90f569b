"""The window: forms on the left, tabs in the middle, records and verdict on the right."""

from pathlib import Path

import pyqtgraph as pg
from PySide6.QtCore import QByteArray, QEvent, QSettings, QSize, QTimer
from PySide6.QtWidgets import QComboBox, QDockWidget, QHBoxLayout, QPushButton, QTabWidget, QVBoxLayout, QWidget

from app.input.fields import Field
from app.look import language, theme
from app.look.language import named, tr
from app.look.parts import Parts
from app.shell import docks, menus, tabs
from app.shell.banner import Banner
from app.shell.files import Files
from app.shell.pages import Veil, card
from app.views.chart import Chart
from app.views.chart_output import ChartOutput
from app.views.note_tab import NoteTab
from app.views.table import Table
from app.views.validation_tab import ValidationTab
from app.work.preparation import Preparation
from app.work.running import RunningWindow
from app.work.session import Session
from app.work.worker import Collector
from core.case.schema import Wall
from core.errors import InputError
from core.study.demand_input import target_of
from core.study.journal import Memory
from core.study.results import StudyResult, WallResult
from core.text.sentence import LANGUAGES
from core.text.start import system_language
from core.version import NAME

AUTOSAVE_MS = 4000

FIRST_SIZE, FRAME = QSize(1280, 800), QSize(8, 40)
"""Of the window at first, and of what the desktop puts around it [px]."""


def row_of(result: StudyResult, wall: WallResult, walls: tuple[Wall, ...]) -> int | None:
    """Row of the wall, among those of a case that may have changed since, that a wall of a result is of or is a part
    of: the one that was analysed, else the one in its place; None where that is another one."""
    asked, k = wall.part.asked, wall.part.origin
    if asked in walls:
        return walls.index(asked)
    return k if k < len(walls) and walls[k] not in result.case.wall else None


class MainWindow(RunningWindow):
    """One session in a window.

    settings : where its state is remembered
    recovery : folder of recovery files
    """

    def __init__(self, settings: QSettings, recovery: Path):
        super().__init__()
        self.settings = settings
        self.collector = Collector(self)
        self.session = Session(recovery)
        self.session.listeners.append(self.refresh)
        self.files = Files(self, self.session, settings)
        self.preparation = Preparation(self)
        self.parts = Parts(self)
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
        docks.remove(self)
        self._tabs()
        self.narrow = self.isVisible() and self.width() < docks.NARROW
        sides = docks.build(self, self.session, self.settings.value("state"), self.narrow)
        self.forms, self.walls, self.demand = sides.forms, sides.walls, sides.demand
        self.analysis, self.records = sides.analysis, sides.records
        self.card, self.card_veil = sides.card, sides.card_veil
        self.records.loaded.connect(self.records_loaded)
        self.walls.list.currentRowChanged.connect(self._wall_listed)
        self.actions_of = menus.build(self)
        self.run_action = self.actions_of.run
        line = docks.build_status(self)
        self.word, self.bar, self.cancel_button = line.word, line.bar, line.cancel_button
        self.cancel_button.clicked.connect(self.cancel)
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
            self.analysis.show_case,
            self.records.show_case,
            self._show_stale,
            self._show_problem,
            self._show_input,
            self._show_recent,
            self.preparation.prepare_next,
        )
        self.refresh()

    def _tabs(self) -> None:
        self.tabs = QTabWidget()
        made = tabs.pages(self.language, self._validation, self.pick, self._note)
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
        self.banner = Banner(self)
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
        self.pages["walls"].content  # noqa: B018  (the first page is there at once)
        self.veil = Veil(self.tabs)
        self.setCentralWidget(centre)
        self.fresh: set[QWidget] = set()

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

    def set_choice(self, setting: str, name: str, keep: bool = True) -> None:
        """Change the theme or the language, and build the window again. keep : the docks where they are"""
        self.settings.setValue(setting, name)
        if keep:
            self.settings.setValue("state", self.saveState(docks.LAYOUT))
        if setting == "theme":
            theme.set_theme(name)
        else:
            language.set_language(name)
        tab, wall = self.tabs.currentIndex(), self.chosen.currentIndex()
        widths = [dock.width() for dock in docks.sides(self)]
        keep = keep and not self.narrow  # those of a narrow window share a side
        self.build()
        if keep:
            docks.widen(self, widths)
        self.tabs.setCurrentIndex(tab)
        self.result_arrived(self.session.result)
        self.chosen.setCurrentIndex(wall)
        self.show_result()

    def reset_layout(self) -> None:
        """Docks and sizes as at the first start."""
        self.settings.remove("state")
        self.settings.remove("geometry")
        self.showNormal()
        self._first_size()
        self.set_choice("language", self.language, keep=False)
        for dock in self.findChildren(QDockWidget):
            dock.show()

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
        forms = (self.walls, self.demand, self.analysis)
        return [field for form in forms for field in form.findChildren(Field)]

    def refresh(self) -> None:
        """After every change of the session."""
        self.parts.show()

    def _show_state(self) -> None:
        mark = "*" if self.session.dirty else ""
        name = self.session.path.name if self.session.path else tr("untitled")
        self.setWindowTitle(f"{mark}{name} – {NAME}")
        self.actions_of.undo.setEnabled(bool(self.session.past))
        self.actions_of.redo.setEnabled(bool(self.session.future))

    def _show_stale(self) -> None:
        stale = ChartOutput.stale = Table.stale = self.session.stale
        self._cover_tabs()
        self.card_veil.cover(stale)

    def _show_problem(self) -> None:
        can_run = self.banner.show_problem() and self.job is None
        self.run_action.setEnabled(can_run)
        self.run_button.setEnabled(can_run)

    def _show_input(self) -> None:
        """What a tab shows of the input as it stands."""
        if self.tabs.currentWidget() is self.pages["spectra"]:
            self._show_spectra()

    def _show_recent(self) -> None:
        menus.show_recent(self, self.actions_of.recent)

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
        except (InputError, TypeError, KeyError):  # still to be given
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

    def pick_input(self, k: int) -> None:
        """Show the input of the k-th wall of the result."""
        self.chosen.setCurrentIndex(k)
        self._wall_chosen()
        docks.show_walls(self)

    def charts(self) -> list[Chart]:
        """Every chart that shows something of the wall shown. Its tab is once in front: Qt lays nothing out before."""
        found, front = [], self.tabs.currentIndex()
        self.tabs.setUpdatesEnabled(False)
        for page in self.pages.values():
            self.tabs.setCurrentWidget(page)
            found += [chart for chart in page.content.findChildren(Chart) if chart.data]
        self.tabs.setCurrentIndex(front)
        self.tabs.setUpdatesEnabled(True)
        return found

    def _wall_chosen(self) -> None:
        """List, selector and tabs show one wall."""
        self.fresh.clear()
        if self.wall is not None:
            row = row_of(self.session.result, self.wall, self.session.case.wall)
            if row is not None and self.walls.list.currentRow() != row:
                self.walls.list.setCurrentRow(row)
        self.show_result()

    def _wall_listed(self, row: int) -> None:
        """The selector follows the list."""
        result, walls = self.session.result, self.session.case.wall
        if result is None or not 0 <= row < len(walls) or self.walls.showing:
            return
        if self.wall is None or row_of(result, self.wall, walls) == row:
            return
        found = [k for k, wall in enumerate(result.walls) if row_of(result, wall, walls) == row]
        if found:
            self.chosen.setCurrentIndex(found[0])
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
        self._cover_tabs()

    def _cover_tabs(self) -> None:
        """Grey the tab in front where its result is of an earlier input; Spectra shows the input as it is."""
        front = self.tabs.currentWidget()
        live = front is self.pages["spectra"] or (front is self.pages["walls"] and self.finished_walls)
        self.veil.cover(self.session.stale and not live)

    def show_finished(self, walls: list) -> None:
        """Walls that have their verdict while others run."""
        self.pages["walls"].content.show_running(walls)
        self.fresh.discard(self.pages["walls"])
        self._cover_tabs()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        narrow = self.width() < docks.NARROW
        if narrow != self.narrow:
            self.narrow = narrow
            docks.arrange(self, narrow)
        self._cover_tabs()

    # results

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
            self.pages["walls"].content  # noqa: B018  (it says what to do)
            self.show_result()
            self.refresh()
            return
        for wall in result.walls:
            self.chosen.addItem(f"{wall.name} – {named(wall.mechanism)}")
        self.card.setText(card(result, self.language))
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
        self.settings.setValue("state", self.saveState(docks.LAYOUT))
        event.accept()
