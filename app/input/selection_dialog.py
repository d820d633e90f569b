"""Natural records chosen from a folder by the spectrum of the demand: the sets found, one of which becomes records."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSize
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.look.dialogs import delete_after_use
from app.look.labels import PlainLabel
from app.look.language import current_language, describe_message, tr
from app.views.chart import Chart
from app.views.table import Table
from app.work.session import Session
from app.work.worker import Job
from core.case.rules import parse_case
from core.case.schema import Case, Record
from core.case.select import Select
from core.case.writer import table_of
from core.errors import InputError
from core.file_names import key_of, name_of
from core.report.record_tables import numbered_sets, sets_of_selection
from core.report.selection_words import lines_of
from core.report.words import Words
from core.setting.plan import select_case_records
from core.setting.record_selection import Selection
from core.text.sentence import localized
from core.units import G


def choose_for(session: Session, parent: QWidget) -> str:
    """Ask for a folder and a set; its records take the place of those of the case. Returns why not, "" if it went."""
    try:
        case = replace(session.case, record=(), generate=None, select=session.case.select or Select("."))
        case = parse_case(table_of(case))
    except InputError as error:
        return describe_message(error)
    with delete_after_use(SelectionDialog(case, session.base_dir, parent)) as dialog:
        if dialog.exec() == QDialog.DialogCode.Accepted and dialog.taken:
            session.edit(replace(session.case, record=dialog.taken, generate=None, select=None))
    return ""


MAX_REASONS_SHOWN = 3
"""Reasons for which files were left out that are shown, the most frequent first; all are in the tool tip."""


class SelectionDialog(QDialog):
    """Searches a folder off this thread and lists the sets, the best first.

    case : complete but for its records; files are named from `base`
    taken : records of the set that was accepted
    """

    def __init__(self, case: Case, base: Path, parent: QWidget | None = None):
        super().__init__(parent)
        self.setWindowTitle(tr("Choose from a folder"))
        self.case, self.base = case, base
        self.job: Job | None = None
        self.found: Selection | None = None
        self.asked = case.select or Select(".")
        self.folder, self.count, self.scaling = QLineEdit(), QSpinBox(), QComboBox()
        self.count.setRange(1, 30)
        self.count.setValue(self.asked.count)
        for label, name in (
            (tr("One factor for all"), "common"),
            (tr("A factor for each"), "individual"),
            (tr("As recorded"), "none"),
        ):
            self.scaling.addItem(label, name)
        self.scaling.setCurrentIndex(self.scaling.findData(self.asked.scaling))
        if self.asked.folder != ".":
            self.folder.setText(name_of(self.asked.folder))
        self.form = QFormLayout()
        line = QHBoxLayout()
        line.addWidget(self.folder, 1)
        for label, slot in ((tr("Folder…"), self._ask_folder), (tr("Zip…"), self._ask_zip)):
            line.addWidget(self._button(label, slot))
        self.form.addRow(tr("Folder or zip"), line)
        self.form.addRow(tr("Records"), self.count)
        self.form.addRow(tr("Scale"), self.scaling)
        self.bar = QProgressBar()
        self.search_button = self._button(tr("Search"), self.search)
        self.stop_button = self._button(tr("Stop"), self.stop)
        running = QHBoxLayout()
        for widget in (self.search_button, self.stop_button, self.bar):
            running.addWidget(widget)
        self.words = PlainLabel(self._limits_in_words())
        self.words.setWordWrap(True)
        self.table = Table(tr("Sets of records"), [])
        self.table.itemSelectionChanged.connect(self._show_set)
        self.chart = Chart("T [s]", "S_a [g]", tr("Mean over the spectrum"), live=True)
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        self.ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setText(tr("Take this set"))
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(self.form)
        layout.addLayout(running)
        layout.addWidget(self.words)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.chart, 1)
        layout.addWidget(self.buttons)
        self.resize(QSize(860, 680))
        self._show_running(False)

    def _limits_in_words(self) -> str:
        low, high = self.asked.scale_limits
        station, event = self.asked.per_station, self.asked.per_event
        return tr(
            "Factors from {low:g} to {high:g}, at most {station} of a station and {event} of an event.",
            low=low,
            high=high,
            station=station,
            event=event,
        )

    @property
    def taken(self) -> tuple[Record, ...]:
        row = self.table.currentRow()
        return self.found.sets[row].records if self.found and row >= 0 else ()

    def search(self) -> None:
        """Read the folder and search the sets; what was found before goes."""
        if self.job is not None or not self.folder.text().strip():
            return
        folder = key_of(self.folder.text().strip())
        asked = replace(self.asked, folder=folder, count=self.count.value(), scaling=self.scaling.currentData())
        case = replace(self.case, record=(), generate=None, select=asked)
        job = self.job = Job(lambda job: select_case_records(case, self.base, job.progress, job.cancelled)[1])
        job.done.connect(self._arrived)
        job.failed.connect(lambda sentence, log: self.words.setText(f"{sentence} {log}".strip()))
        job.progressed.connect(lambda done, planned, left: self.bar.setValue(100 * done // max(planned, 1)))
        job.finished.connect(self._ended)
        self.show_found(None)
        self.chart.clear()
        self.words.setText(tr("Reading and searching…"))
        self._show_running(True)
        job.start()

    def stop(self) -> None:
        """End the search; nothing was taken."""
        if self.job is not None:
            self.job.cancel()
            self.words.setText(tr("Stopped."))

    def done(self, result: int) -> None:
        self.stop()
        super().done(result)

    def _ended(self) -> None:
        self.job = None
        self._show_running(False)

    def _show_running(self, on: bool) -> None:
        self.search_button.setEnabled(not on)
        self.stop_button.setEnabled(on)
        self.bar.setVisible(on)
        self.bar.setValue(0)
        self.ok.setEnabled(bool(self.taken))

    def _arrived(self, selection: Selection) -> None:
        language = current_language()
        for most, show in ((MAX_REASONS_SHOWN, self.words.setText), (None, self.words.setToolTip)):
            lines = lines_of(
                selection, lambda text, **values: localized("report", text, language, **values), language, most
            )
            show("\n".join(lines))
        self.show_found(selection)

    def show_found(self, found: Selection | None) -> None:
        """List the sets of a search, the first selected; None lists nothing."""
        self.found = found
        self.table.show_table(sets_of_selection(Words(current_language())), list(numbered_sets(found)))
        self.table.selectRow(0)

    def _show_set(self) -> None:
        """The mean of the set that is selected over the spectrum."""
        self.ok.setEnabled(bool(self.taken))
        self.chart.clear()
        if self.found is None or not self.taken:
            return
        times, target = np.array(self.found.periods), np.array(self.found.target) / G
        low, high, _ = self.found.bounds
        for bound in (low, high):
            if np.isfinite(bound):
                self.chart.curve("", times, bound * target, "quiet", 1.0, dash=True, legend=False)
        self.chart.curve(tr("spectrum"), times, target, "bad")
        mean = np.array(self.found.sets[self.table.currentRow()].mean) / G
        self.chart.curve(tr("mean of the records"), times, mean, 0, 2.0)
        self.chart.reset()

    def _button(self, label: str, slot) -> QPushButton:
        button = QPushButton(label)
        button.setAutoDefault(False)
        button.clicked.connect(slot)
        return button

    def _ask_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("Natural records"), self.folder.text() or str(self.base))
        if name:
            self.folder.setText(name)

    def _ask_zip(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self, tr("Natural records"), self.folder.text() or str(self.base), "*.zip"
        )
        if name:
            self.folder.setText(name)
