"""The window: forms on the left, tabs in the middle, records and verdict on the right."""

import os
import sys
import time
from dataclasses import replace
from pathlib import Path

import pyqtgraph as pg
from PySide6.QtCore import QByteArray, QSettings, QStandardPaths, Qt, QTimer
from PySide6.QtGui import QAction, QActionGroup, QColor, QKeySequence, QPainter
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDockWidget,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QMessageBox,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app import batch, language, theme
from app.forms.demand_form import AnalysisForm, DemandForm
from app.forms.records_panel import RecordsPanel
from app.forms.wall_form import WallForm
from app.language import tr
from app.plots.history_tabs import HistoriesTab, ValidationTab
from app.plots.result_tabs import CapacityTab, CheckTab, IntensityTab, SpectraTab, verdict_color
from app.session import Session
from app.worker import Job, write_log
from core import study
from core.demand import target_of
from core.errors import InputError, OutputError
from core.version import NAME, VERSION
from core.words import word

EXAMPLE = Path(__file__).resolve().parents[1] / "resources" / "cases" / "example.toml"
RECENT = 8
AUTOSAVE_MS = 4000


class Veil(QWidget):
    """A grey veil over results that are of an earlier input; clicks go through it."""

    def __init__(self, over: QWidget):
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def paintEvent(self, event) -> None:
        shade = QColor(theme.current.window)
        shade.setAlpha(165)
        QPainter(self).fillRect(self.rect(), shade)

    def cover(self, on: bool) -> None:
        self.setGeometry(self.parentWidget().rect())
        self.setVisible(on)
        self.raise_()


class MainWindow(QMainWindow):
    """One session in a window. settings : where its state is remembered; swaps : folder of autosaves."""

    def __init__(self, settings: QSettings, swaps: Path):
        super().__init__()
        self.settings = settings
        self.session = Session(swaps)
        self.session.listeners.append(self.refresh)
        self.job: Job | None = None
        self.started = 0.0
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
        pg.setConfigOptions(antialias=True)
        self.language = self.settings.value("language") or language.system_language()
        for dock in self.findChildren(QDockWidget):
            self.removeDockWidget(dock)
            dock.deleteLater()
        self.menuBar().clear()
        self._tabs()
        self._docks()
        self._menus()
        self._status()
        self.refresh()

    def _tabs(self) -> None:
        self.check, self.histories, self.capacity = (
            CheckTab(self.language),
            HistoriesTab(),
            CapacityTab(),
        )
        self.intensity, self.spectra = IntensityTab(), SpectraTab(self.language)
        self.validation = ValidationTab()
        self.validation.asked.connect(self.state_accuracy)
        self.tabs = QTabWidget()
        for tab, label in (
            (self.check, tr("Check")), (self.histories, tr("Histories")), (self.capacity, tr("Capacity")),
            (self.intensity, tr("q against SI")), (self.spectra, tr("Spectra")),
            (self.validation, tr("Validation")),
        ):  # fmt: skip
            self.tabs.addTab(tab, label)
        self.tabs.currentChanged.connect(lambda _: self.show_result())
        self.chosen = QComboBox()
        self.chosen.setAccessibleName(tr("Wall shown"))
        self.chosen.activated.connect(lambda _: self._wall_chosen())
        self.banner = QLabel()
        self.banner.setStyleSheet(f"color: {theme.current.amber}; font-weight: 600;")
        self.run_button = QPushButton(tr("Run (F5)"))
        self.run_button.clicked.connect(self.run)
        bar = QHBoxLayout()
        bar.addWidget(self.run_button)
        bar.addWidget(self.chosen, 1)
        bar.addWidget(self.banner, 2)
        centre = QWidget()
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(6, 6, 6, 0)
        layout.addLayout(bar)
        layout.addWidget(self.tabs, 1)
        self.veil = Veil(self.tabs)
        self.setCentralWidget(centre)
        self.fresh: set[QWidget] = set()

    def _docks(self) -> None:
        self.walls, self.demand = WallForm(self.session), DemandForm(self.session)
        self.analysis, self.records = AnalysisForm(self.session), RecordsPanel(self.session)
        self.records.loaded.connect(self._records_loaded)
        forms = QTabWidget()
        for form, label in ((self.walls, tr("Walls")), (self.demand, tr("Demand")),
                            (self.analysis, tr("Report and analysis"))):  # fmt: skip
            area = QScrollArea()
            area.setWidgetResizable(True)
            area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
            area.setWidget(form)
            forms.addTab(area, label)
        self.forms = forms
        left = QDockWidget(tr("Input"), objectName="input")
        left.setWidget(forms)
        self.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, left)
        right = QDockWidget(tr("Records"), objectName="records")
        right.setWidget(self.records)
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, right)
        self.card = QLabel(tr("No result yet: press F5."))
        self.card.setWordWrap(True)
        self.card.setTextFormat(Qt.TextFormat.RichText)
        self.card.setMargin(8)
        self.card.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.card.setAccessibleName(tr("Verdict"))
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setWidget(self.card)
        below = QDockWidget(tr("Verdict"), objectName="verdict")
        below.setWidget(area)
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, below)
        self.resizeDocks([left, right], [348, 318], Qt.Orientation.Horizontal)
        self.resizeDocks([right, below], [430, 260], Qt.Orientation.Vertical)
        state = self.settings.value("state")
        if isinstance(state, QByteArray):
            self.restoreState(state)

    def _action(self, menu, label: str, slot, keys=None) -> QAction:
        action = QAction(label, self)
        action.triggered.connect(lambda _=False: slot())
        if keys is not None:
            action.setShortcut(QKeySequence(keys))
        menu.addAction(action)
        return action

    def _menus(self) -> None:
        key = QKeySequence.StandardKey
        file = self.menuBar().addMenu(tr("&File"))
        self._action(file, tr("&New"), self.new, key.New)
        self._action(file, tr("&Open…"), self.ask_open, key.Open)
        self.recent = file.addMenu(tr("Open &recent"))
        self._action(file, tr("Open the &example"), lambda: self.open(EXAMPLE))
        self._action(file, tr("&Save"), self.save, key.Save)
        self._action(file, tr("Save &as…"), self.save_as, QKeySequence("Ctrl+Shift+S"))
        file.addSeparator()
        self._action(file, tr("&Export workbook…"), self.ask_export, QKeySequence("Ctrl+E"))
        file.addSeparator()
        self._action(file, tr("&Quit"), self.close, key.Quit)
        edit = self.menuBar().addMenu(tr("&Edit"))
        self.undo_action = self._action(edit, tr("&Undo"), self.session.undo, key.Undo)
        self.redo_action = self._action(
            edit, tr("&Redo"), self.session.redo, QKeySequence("Ctrl+Y")
        )
        self._action(
            edit, tr("&Paste walls"), lambda: self.walls.paste(), QKeySequence("Ctrl+Shift+V")
        )
        runs = self.menuBar().addMenu(tr("&Run"))
        self.run_action = self._action(runs, tr("&Run"), self.run, QKeySequence("F5"))
        self.cancel_action = self._action(runs, tr("&Cancel"), self.cancel, QKeySequence("Esc"))
        view = self.menuBar().addMenu(tr("&View"))
        for dock in self.findChildren(QDockWidget):
            view.addAction(dock.toggleViewAction())
        view.addSeparator()
        for k in range(self.tabs.count()):
            self._action(view, self.tabs.tabText(k), lambda k=k: self.tabs.setCurrentIndex(k),
                         QKeySequence(f"Ctrl+{k + 1}"))  # fmt: skip
        view.addSeparator()
        self._choices(view, tr("Theme"), "theme", {"light": tr("light"), "dark": tr("dark")},
                      theme.current.name)  # fmt: skip
        self._choices(view, tr("Language"), "language", language.LANGUAGES, self.language)
        about = self.menuBar().addMenu(tr("&Help"))
        self._action(about, tr("&About"), self.about)

    def _choices(self, menu, label: str, setting: str, names: dict, current: str) -> None:
        inside = menu.addMenu(label)
        group = QActionGroup(inside)
        for name, shown in names.items():
            action = self._action(inside, shown, lambda name=name: self.set_choice(setting, name))
            action.setCheckable(True)
            action.setChecked(name == current)
            group.addAction(action)

    def _status(self) -> None:
        bar = self.statusBar()
        for child in bar.findChildren(QWidget):
            bar.removeWidget(child)
        self.word = QLabel()
        self.bar = QProgressBar()
        self.bar.setMaximumWidth(220)
        self.bar.setAccessibleName(tr("Progress"))
        self.cancel_button = QPushButton(tr("Cancel"))
        self.cancel_button.clicked.connect(self.cancel)
        bar.addWidget(self.word, 1)
        bar.addPermanentWidget(self.bar)
        bar.addPermanentWidget(self.cancel_button)
        self._running(self.job is not None)

    def set_choice(self, setting: str, name: str) -> None:
        """Change the theme or the language, and build the window again."""
        self.settings.setValue(setting, name)
        self.settings.setValue("state", self.saveState())
        if setting == "theme":
            theme.set_theme(name)
        else:
            language.set_language(name)
        self.records.wait()
        tab, wall = self.tabs.currentIndex(), self.chosen.currentIndex()
        self.build()
        self.tabs.setCurrentIndex(tab)
        self.result_arrived(self.session.result)
        self.chosen.setCurrentIndex(wall)
        self.show_result()

    # what is shown

    def refresh(self) -> None:
        """After every change of the session."""
        for form in (self.walls, self.demand, self.analysis, self.records):
            form.show_case()
        mark = "*" if self.session.dirty else ""
        name = self.session.path.name if self.session.path else tr("untitled")
        self.setWindowTitle(f"{mark}{name} – {NAME}")
        self.setWindowModified(self.session.dirty)
        self.undo_action.setEnabled(bool(self.session.past))
        self.redo_action.setEnabled(bool(self.session.future))
        stale = self.session.stale
        self.veil.cover(stale)
        problem = self.session.problem()
        can_run = problem is None and self.job is None
        self.run_action.setEnabled(can_run)
        self.run_button.setEnabled(can_run)
        if problem:
            self.banner.setText(problem if len(problem) < 160 else problem[:157] + "…")
            self.banner.setToolTip(problem)
        else:
            self.banner.setText(tr("The input has changed: press F5.") if stale else "")
            self.banner.setToolTip("")
        self.banner.setWordWrap(True)
        if self.tabs.currentWidget() is self.spectra:
            self._show_spectra()
        self._recent()

    def _recent(self) -> None:
        self.recent.clear()
        for name in self.settings.value("recent") or []:
            self._action(self.recent, name, lambda name=name: self.open(Path(name)))

    def _records_loaded(self) -> None:
        if self.tabs.currentWidget() is self.spectra:
            self._show_spectra()

    def _show_spectra(self) -> None:
        target = None
        try:
            if self.session.case.demand:
                target = target_of(self.session.case.demand, self.session.base_dir)
        except (InputError, TypeError):
            target = None
        result = self.session.result
        rules = result.compliance if result and not self.session.stale else None
        self.spectra.show_records(self.records.motions, target, rules)

    @property
    def wall(self):
        result = self.session.result
        k = self.chosen.currentIndex()
        return result.walls[k] if result and 0 <= k < len(result.walls) else None

    def _wall_chosen(self) -> None:
        self.fresh.clear()
        self.show_result()

    def show_result(self) -> None:
        """Fill the tab in front, once per result and wall."""
        tab = self.tabs.currentWidget()
        if tab is self.spectra:
            self._show_spectra()
        elif self.wall is not None and tab not in self.fresh:
            tab.show_wall(self.session.result, self.wall)
            self.fresh.add(tab)
        self.veil.cover(self.session.stale)

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.veil.cover(self.session.stale)

    # running

    def _running(self, on: bool) -> None:
        self.bar.setVisible(on)
        self.cancel_button.setVisible(on)
        self.cancel_action.setEnabled(on)

    def run(self) -> None:
        """Run the case off this thread; the window stays alive."""
        case = self.session.checked()
        if case is None or self.job is not None:
            return
        base = self.session.base_dir
        self._start(
            lambda job: study.run(
                case, base_dir=base, jobs=os.cpu_count() or 1, on_progress=job.progress,
                cancelled=job.cancelled,
            ),
            self.result_arrived,
        )  # fmt: skip

    def _start(self, work, arrived) -> None:
        self.job = Job(work, self)
        self.job.done.connect(arrived)
        self.job.failed.connect(self._failed)
        self.job.stopped.connect(lambda: self.word.setText(tr("Cancelled.")))
        self.job.progressed.connect(self._progressed)
        self.job.finished.connect(self._ended)
        self.started = time.monotonic()
        self.bar.setRange(0, 0)
        self.word.setText(tr("Running…"))
        self._running(True)
        self.job.start()
        self.refresh()

    def _progressed(self, done: int, planned: int) -> None:
        self.bar.setRange(0, max(planned, 1))
        self.bar.setValue(done)
        elapsed = time.monotonic() - self.started
        left = elapsed / done * (planned - done) if done else 0.0
        self.word.setText(
            tr("{done} of {planned}, {elapsed:.0f} s, about {left:.0f} s left").format(
                done=done, planned=planned, elapsed=elapsed, left=left)
        )  # fmt: skip

    def _ended(self) -> None:
        self.job = None
        self._running(False)
        self.refresh()

    def _failed(self, sentence: str, log: str) -> None:
        if log:
            sentence += "\n" + tr("Details are in {log}").format(log=log)
        self.word.setText(tr("Not done."))
        QMessageBox.warning(self, tr("Not done"), sentence)

    def cancel(self) -> None:
        if self.job is not None:
            self.job.cancel()
            self.word.setText(tr("Cancelling…"))

    def result_arrived(self, result) -> None:
        """Show a result of study.run."""
        self.session.result = result
        self.fresh.clear()
        self.chosen.clear()
        if result is None:
            return
        mechanisms = {"one_sided": tr("one-sided"), "two_sided": tr("two-sided")}
        for wall in result.walls:
            self.chosen.addItem(f"{wall.name} – {mechanisms[wall.mechanism]}")
        analyses = sum(run.ida.analyses for wall in result.walls for run in wall.runs)
        self.word.setText(
            tr("{n} analyses in {seconds:.1f} s").format(n=analyses, seconds=result.elapsed)
        )
        self._show_card(result)
        self.refresh()
        self.show_result()

    def _show_card(self, result) -> None:
        lines = []
        for wall in result.walls[:40]:
            if wall.assessment is None:
                lines.append(f"<b>{_plain(wall.name)}</b>: q {wall.q_set or 0:.2f}")
                continue
            said = wall.assessment.verdict
            zeta = "–" if said.zeta_e is None else f"{said.zeta_e:.2f}"
            lines.append(
                f"<b>{_plain(wall.name)}</b> ({word_of(wall.mechanism)})<br>"
                f"<span style='color:{verdict_color(wall)}; font-weight:600'>ζ {zeta}, "
                f"{word(said.code, self.language)}</span><br>{said.text(self.language)}"
            )
        self.card.setText("<p>" + "</p><p>".join(lines) + "</p>")

    def state_accuracy(self) -> None:
        """The accuracy statement of the wall shown, off this thread."""
        result, k = self.session.result, self.chosen.currentIndex()
        if self.wall is None or self.job is not None:
            return

        def arrived(found) -> None:
            if self.session.result is result:
                walls = list(result.walls)
                walls[k] = replace(walls[k], accuracy=found)
                self.session.result = replace(result, walls=tuple(walls))
                self.validation.show_accuracy(found)
                self.word.setText("")

        wall = result.walls[k]
        self._start(
            lambda job: study.accuracy_of(
                wall, result.motions, result.method, result.search, job.cancelled
            ),
            arrived,
        )

    # files

    def open(self, path: Path) -> bool:
        """Open a case; the one at hand is saved or given up first."""
        if not self.give_up():
            return False
        try:
            self.session.open(path)
        except InputError as error:
            QMessageBox.warning(self, tr("Not opened"), str(error))
            return False
        if path != EXAMPLE:
            self.remember(path)
        self.card.setText(tr("No result yet: press F5."))
        self.result_arrived(None)
        return True

    def remember(self, path: Path) -> None:
        known = [name for name in self.settings.value("recent") or [] if name != str(path)]
        self.settings.setValue("recent", [str(path), *known][:RECENT])
        self._recent()

    def new(self) -> None:
        if self.give_up():
            self.session.new()
            self.result_arrived(None)

    def ask_open(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self, tr("Open a case"), str(self.session.base_dir), tr("Cases") + " (*.toml)"
        )
        if name:
            self.open(Path(name))

    def save(self) -> bool:
        if self.session.path is None or self.session.path == EXAMPLE:
            return self.save_as()
        return self._save(None)

    def save_as(self) -> bool:
        name, _ = QFileDialog.getSaveFileName(
            self, tr("Save the case"), str(self.session.path or self.session.base_dir / "case.toml"),
            tr("Cases") + " (*.toml)",
        )  # fmt: skip
        return self._save(Path(name).with_suffix(".toml")) if name else False

    def _save(self, path: Path | None) -> bool:
        try:
            self.session.save(path)
        except OutputError as error:
            QMessageBox.warning(self, tr("Not saved"), str(error))
            return False
        self.remember(self.session.path)
        return True

    def ask_export(self) -> None:
        if self.export_refused():
            return
        stem = self.session.path.stem if self.session.path else "ribalta"
        name, _ = QFileDialog.getSaveFileName(
            self,
            tr("Export the workbook"),
            str(self.session.base_dir / f"{stem}.xlsx"),
            "Excel (*.xlsx)",
        )
        if name:
            self.export(Path(name))

    def export_refused(self) -> bool:
        """Whether there is nothing to export, or only results of an earlier input; says so."""
        if self.session.result is None or self.session.stale:
            reason = tr("The results are not of this input: run it first (F5).")
            QMessageBox.information(self, tr("Nothing exported"), reason)
            return True
        return False

    def export(self, path: Path) -> None:
        """Workbook and JSON, as the batch writes them, off this thread."""
        result = self.session.result
        self._start(
            lambda job: batch.write(result, path.parent, path.stem),
            lambda _: self.word.setText(tr("Written: {path}").format(path=path)),
        )

    def give_up(self) -> bool:
        """Whether the case at hand may go: saved, unchanged, or given up by the user."""
        if not self.session.dirty:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self, tr("Unsaved changes"), tr("Save the changes of this case?"),
            button.Save | button.Discard | button.Cancel,
        )  # fmt: skip
        return self.save() if answer == button.Save else answer == button.Discard

    def about(self) -> None:
        QMessageBox.about(self, NAME, tr(
            "{name} {version}\nOut-of-plane overturning of masonry walls (Coccia, Di Carlo, Imperatore 2016; "
            "Circolare 7/2019 C8.7.1.2.1). The results are the engineer's responsibility.").format(
                name=NAME, version=VERSION))  # fmt: skip

    def closeEvent(self, event) -> None:
        if not self.give_up():
            event.ignore()
            return
        if self.job is not None:
            self.job.cancel()
            self.job.wait()
        self.records.wait()
        self.timer.stop()
        self.session.drop_swap()
        self.settings.setValue("geometry", self.saveGeometry())
        self.settings.setValue("state", self.saveState())
        event.accept()


def word_of(mechanism: str) -> str:
    return tr("one-sided") if mechanism == "one_sided" else tr("two-sided")


def _plain(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")


def offer_recovery(window: MainWindow) -> None:
    """After a crash: the autosaved case, if the user wants it back."""
    for swap in window.session.recoverable():
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            window, tr("Autosaved case found"),
            tr("The program ended without saving. Bring back the unsaved case?"), button.Yes | button.No,
        )  # fmt: skip
        if answer == button.Yes:
            try:
                window.session.recover(swap)
                return
            except InputError as error:
                QMessageBox.warning(window, tr("Not opened"), str(error))
        swap.unlink(missing_ok=True)


def install_hook(window: MainWindow) -> None:
    """An exception in a slot: a log and a dialog, never a silent stop."""

    def hook(kind, value, trace) -> None:
        import traceback

        log = write_log("".join(traceback.format_exception(kind, value, trace)))
        sentence = f"{kind.__name__}: {value}"
        QTimer.singleShot(0, window, lambda: window._failed(sentence, log))

    sys.excepthook = hook


def make(arguments: list[str] | None = None) -> tuple[QApplication, MainWindow]:
    """The application and its window, not shown yet."""
    application = QApplication.instance() or QApplication(arguments or sys.argv[:1])
    application.setApplicationName(NAME)
    application.setOrganizationName(NAME)
    folder = Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppDataLocation))
    folder.mkdir(parents=True, exist_ok=True)
    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    theme.set_theme(settings.value("theme") or "light")
    language.set_language(settings.value("language") or language.system_language())
    return application, MainWindow(settings, folder / "autosave")


def warm_up(window: MainWindow) -> None:
    """Compile or load the kernels in the background, with a word in the status line."""
    from core.ground_motion import GroundMotion
    from core.kernel_cache import FOLDER, record

    def work(job):
        case = window.session.checked()
        motions = [m for m in window.records.motions if isinstance(m, GroundMotion)]
        if case and motions:
            study.warm(case, motions[0])
            record(FOLDER)

    if window.job is None:
        job = Job(work, window)
        window.word.setText(tr("Preparing the solver…"))
        job.finished.connect(lambda: window.job is None and window.word.setText(tr("Ready.")))
        window.warming = job
        job.start()


def main(path: Path | None) -> int:
    """Show the window, on this case or the example; returns its exit code."""
    application, window = make()
    install_hook(window)
    window.show()
    if path is not None:
        window.open(path)
    else:
        window.session.open(EXAMPLE)
    QTimer.singleShot(0, lambda: offer_recovery(window))
    window.records.loaded.connect(lambda: warm_up(window), Qt.ConnectionType.SingleShotConnection)
    code = application.exec()
    for job in (getattr(window, "warming", None),):
        if job is not None:
            job.wait()
    return code
