"""The records: drag and drop, what each file is, include, sign, generated sets."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QMenu,
    QSizePolicy,
    QTableWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app import theme
from app.language import tr
from app.plots.chart import Chart
from app.plots.table import Table
from app.sentences import said
from app.session import Session
from app.worker import Job
from core import records
from core.case import Generate, Record
from core.demand import demand_of, generated
from core.errors import InputError
from core.number import parse_number
from core.records.grammar import Options
from core.units import CM, G


def read(record: Record, base_dir: Path) -> list:
    """Motions of one entry, or the sentence why there are none."""
    options = Options(record.unit, record.time_step_s, record.column, record.skip_lines)
    try:
        return [
            records.read(path, options, record.scale)
            for path in records.expand(record.file, base_dir)
        ]
    except InputError as error:
        return [said(error)]


def all_files(paths: list[Path]) -> list[Path]:
    """Files among these, folders opened."""
    found = []
    for path in paths:
        found += sorted(f for f in path.rglob("*") if f.is_file()) if path.is_dir() else [path]
    return [path for path in found if not path.name.startswith(".")][:500]


class ImportDialog(QDialog):
    """What was recognised in each file; unit and time step where the file does not say."""

    def __init__(self, paths: list[Path], parent: QWidget | None = None):
        super().__init__(parent)
        self.setWindowTitle(tr("Records found"))
        self.paths = paths
        self.entries = {path: Record(str(path)) for path in paths}
        self.list = QListWidget()
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.addItems([path.name for path in paths])
        self.list.currentRowChanged.connect(lambda _: self.show_file())
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.chart = Chart("t [s]", "u'' [g]", tr("Preview"))
        self.unit = QComboBox()
        self.unit.addItem(tr("as the file says"), None)
        for unit in ("g", "m/s2", "cm/s2", "mm/s2"):
            self.unit.addItem(unit, unit)
        self.unit.activated.connect(lambda k: self.change(unit=self.unit.itemData(k)))
        self.step = QLineEdit()
        self.step.setPlaceholderText(tr("as the file says"))
        self.step.editingFinished.connect(self._step_given)
        self.kind = QComboBox()
        for kind, label in (("natural", tr("natural")), ("artificial", tr("artificial")),
                            ("simulated", tr("simulated"))):  # fmt: skip
            self.kind.addItem(label, kind)
        self.kind.activated.connect(lambda k: self.change(kind=self.kind.itemData(k)))
        form = QFormLayout()
        form.addRow(tr("Unit"), self.unit)
        form.addRow(tr("Time step [s]"), self.step)
        form.addRow(tr("Kind"), self.kind)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        right = QVBoxLayout()
        right.addWidget(self.words)
        right.addWidget(self.chart, 1)
        right.addLayout(form)
        row = QHBoxLayout()
        row.addWidget(self.list, 1)
        row.addLayout(right, 2)
        layout = QVBoxLayout(self)
        layout.addWidget(
            QLabel(tr("Choices apply to the files selected; those not readable are left out."))
        )
        layout.addLayout(row, 1)
        layout.addWidget(self.buttons)
        self.resize(QSize(820, 520))
        self.list.setCurrentRow(0)

    def _step_given(self) -> None:
        text = self.step.text().strip()
        try:
            self.change(time_step_s=parse_number(text) if text else None)
        except InputError as error:
            self.words.setText(said(error))

    def change(self, **values) -> None:
        """Apply a choice to the selected files."""
        rows = {index.row() for index in self.list.selectedIndexes()} or {self.list.currentRow()}
        for row in rows:
            path = self.paths[row]
            self.entries[path] = replace(self.entries[path], **values)
        self.show_file()

    def show_file(self) -> None:
        path = self.paths[max(0, self.list.currentRow())]
        self.chart.clear()
        (found, *_) = read(self.entries[path], path.parent)
        if isinstance(found, str):
            self.words.setText(found)
            return
        self.words.setText(
            f"{found.format}: {found.acceleration.size} × {found.time_step:g} s, {found.unit}, "
            f"PGA {found.pga / G:.3f} g"
        )
        times = np.arange(found.acceleration.size) * found.time_step
        self.chart.curve(found.name, times, found.acceleration / G, 0, 1.0)
        self.chart.reset()

    def chosen(self) -> list[Record]:
        """Entries of the files that can be read."""
        return [
            entry for path, entry in self.entries.items()
            if not isinstance(read(entry, path.parent)[0], str)
        ]  # fmt: skip


class RecordsPanel(QWidget):
    """Table of the records. loaded() : the motions of the case are there; `motions` holds them."""

    loaded = Signal()

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.setAcceptDrops(True)
        self.motions: list = []
        self.rows: list[tuple[int | None, object]] = []
        self.key: object = None
        self.pending = False
        self.jobs: set[Job] = set()
        self.table = Table(tr("Records"), [
            tr("Use"), tr("Record"), "PGA [g]", "PGV [cm/s]", "SI [cm]", tr("D5-95 [s]"), "Δt [s]",
            tr("Sign"), tr("Format")])  # fmt: skip
        self.table.itemChanged.connect(self._ticked)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.table.customContextMenuRequested.connect(self._menu)
        self.words = QLabel(tr("Drop accelerograms or folders here."))
        self.words.setWordWrap(True)
        bar = QHBoxLayout()
        for label, tip, slot in (
            (tr("Add…"), tr("Add accelerograms"), self.add),
            (tr("Generate…"), tr("Seven motions compatible with the spectrum"), self.generate),
            (tr("Reverse"), tr("Change the sign of the selected records"), self.reverse),
            (tr("Remove"), tr("Remove the selected records"), self.remove),
        ):
            button = QToolButton()
            button.setText(label)
            button.setToolTip(tip)
            button.clicked.connect(slot)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            bar.addWidget(button)
        bar.setSpacing(3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addLayout(bar)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.words)

    # loading, off this thread

    def show_case(self) -> None:
        """Read what changed among the records; the table follows when they are there."""
        case = self.session.case
        demand = case.demand if case.generate else None
        key = (case.record, case.generate, demand, self.session.base_dir)
        if key == self.key:
            return
        self.key = key
        self.pending = True  # the rows are of the records before
        base = self.session.base_dir

        def work(job):
            found = [
                (k, motion) for k, entry in enumerate(case.record) for motion in read(entry, base)
            ]
            if case.generate:
                try:
                    asked = demand_of(case, base)
                    found += [
                        (None, m)
                        for m in (generated(case, asked) if asked and asked.target else [])
                    ]
                except (InputError, TypeError) as error:
                    found.append((None, said(error)))
            for _, motion in found:
                if not isinstance(motion, str):
                    motion.measure()
            return key, found

        job = Job(work, self)
        job.done.connect(self._arrived)
        job.failed.connect(lambda sentence, log: self.words.setText(sentence))
        job.finished.connect(lambda: self.jobs.discard(job))
        self.jobs.add(job)
        job.start()

    def wait(self) -> None:
        """Until the reading threads have ended: before the window goes."""
        for job in list(self.jobs):
            job.wait()

    def _arrived(self, answer) -> None:
        key, found = answer
        if key != self.key:
            return
        self.rows, self.pending = found, False
        case = self.session.case
        self.motions = [
            motion for k, motion in found
            if not isinstance(motion, str) and (k is None or case.record[k].include)
        ]  # fmt: skip
        self.table.blockSignals(True)
        rows, colors = [], []
        for k, motion in found:
            if isinstance(motion, str):
                rows.append(["", motion, *[""] * 7])
                colors.append([theme.current.bad] * 9)
                continue
            sign = "+" if k is None or case.record[k].scale > 0 else "−"
            rows.append(["", motion.name, f"{motion.pga / G:.3f}", f"{motion.pgv / CM:.1f}",
                         f"{motion.housner_intensity / CM:.1f}", f"{motion.duration_5_95:.1f}",
                         f"{motion.time_step:g}", sign, motion.format])  # fmt: skip
            colors.append([theme.current.amber if motion.warnings else None] * 9)
        self.table.show_rows(rows, colors)
        for row, (k, motion) in enumerate(found):
            if isinstance(motion, str) or k is None:
                continue
            tick = QTableWidgetItem()
            tick.setFlags(
                Qt.ItemFlag.ItemIsUserCheckable
                | Qt.ItemFlag.ItemIsEnabled
                | Qt.ItemFlag.ItemIsSelectable
            )
            on = case.record[k].include
            tick.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
            self.table.setItem(row, 0, tick)
            tips = "\n".join(w.text(case.report.language) for w in motion.warnings)
            self.table.item(row, 1).setToolTip(tips or motion.file)
        self.table.blockSignals(False)
        count = len(self.motions)
        self.words.setText(
            tr("{n} records in use. Drop accelerograms or folders here.").format(n=count)
        )
        self.loaded.emit()

    # changes

    def _selected(self) -> set[int]:
        if self.pending:
            return set()
        rows = {index.row() for index in self.table.selectedIndexes()}
        return {self.rows[row][0] for row in rows if self.rows[row][0] is not None}

    def _ticked(self, item) -> None:
        known = not self.pending and item.row() < len(self.rows)
        entry = self.rows[item.row()][0] if known else None
        if item.column() == 0 and entry is not None:
            self.session.edit_record(entry, include=item.checkState() == Qt.CheckState.Checked)

    def _menu(self, place) -> None:
        menu = QMenu(self)
        menu.addAction(tr("Reverse"), self.reverse)
        menu.addAction(tr("Remove"), self.remove)
        menu.exec(self.table.viewport().mapToGlobal(place))

    def reverse(self) -> None:
        for entry in self._selected():
            self.session.edit_record(entry, scale=-self.session.case.record[entry].scale)

    def remove(self) -> None:
        rows = {index.row() for index in self.table.selectedIndexes()}
        if not self.pending and any(self.rows[row][0] is None for row in rows):
            self.session.edit(replace(self.session.case, generate=None))
        if self._selected():
            self.session.remove_records(self._selected())

    def generate(self) -> None:
        """Seven compatible motions, or the same with the next seeds."""
        case = self.session.case
        if case.demand is None or not (case.demand.spectrum or case.demand.spectrum_file):
            self.words.setText(tr("Choose a spectrum on the sheet Demand first."))
            return
        seed = case.generate.seed + case.generate.count if case.generate else 1
        self.session.edit(replace(case, generate=Generate(7, seed)))

    def add(self) -> None:
        names, _ = QFileDialog.getOpenFileNames(
            self, tr("Add accelerograms"), str(self.session.base_dir)
        )
        if names:
            self.take([Path(name) for name in names])

    def take(self, paths: list[Path], ask: bool = True) -> None:
        """Add files and folders, after the dialog that shows what they are."""
        files = all_files(paths)
        if not files:
            return
        dialog = ImportDialog(files, self)
        if not ask or dialog.exec() == QDialog.DialogCode.Accepted:
            chosen = dialog.chosen()
            self.session.add_records(
                [replace(entry, file=self.session.relative(Path(entry.file))) for entry in chosen]
            )

    def dragEnterEvent(self, event) -> None:
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event) -> None:
        self.take([Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()])
