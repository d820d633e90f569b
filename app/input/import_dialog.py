"""The dialog that shows what accelerogram files are, and asks for what they do not say."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.input.fields import LineField, connect
from app.input.made_fields import make_field, make_fields
from app.input.record_files import Row, channels_of, file_of, named_row, provenance_lines, read_motions
from app.look import theme
from app.look.labels import PlainLabel, escape_html
from app.look.language import number, tr
from app.views.chart import Chart
from core.case.schema import Record
from core.units import G

MAX_FILES = 500


class ImportDialog(QDialog):
    """What was recognised in each file; the choices apply to the files selected. A file of several channels becomes a
    row for each, to be ticked: none is taken by itself. entries : of records that are there already, by their row."""

    def __init__(self, paths: Sequence[Row], parent: QWidget | None = None, entries: dict[Row, Record] | None = None):
        super().__init__(parent)
        self.setWindowTitle(tr("Records found"))
        self.paths: list[Row] = list(dict.fromkeys(paths))[:MAX_FILES]
        known = entries or {}
        self.entries = {path: known.get(path, Record(str(path))) for path in self.paths}
        self.looked: set[Row] = set(known)
        self.found: dict[Record, list] = {}
        self.list = QListWidget()
        self.list.setAccessibleName(tr("Files"))
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.addItems([named_row(path) for path in self.paths])
        self.list.itemChanged.connect(lambda _: self._judge())
        self.list.currentRowChanged.connect(lambda _: self._other_file())
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        self.chart = Chart("t [s]", "u'' [g]", tr("Preview"), live=True)
        self.fields = [*make_fields(Record, "file"), make_field(Record, "scale")]
        connect(self.fields, lambda field, value: self.change(**{field.key: value}))
        for field in self.fields[1:4]:
            if isinstance(field, LineField):
                field.editor.setPlaceholderText(tr("as the file says"))
            field.judged.connect(self._judge)
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        right = QVBoxLayout()
        right.addWidget(self.words)
        right.addWidget(self.chart, 1)
        for field in self.fields:
            right.addWidget(field)
        row = QHBoxLayout()
        row.addWidget(self.list, 2)
        row.addLayout(right, 3)
        hint = tr("Choices apply to the selected files; unreadable files are left out. Tick the channels to use.")
        if len(paths) > MAX_FILES:
            left = tr("{n} more files are not shown: add them in parts.", n=len(paths) - MAX_FILES)
            hint += " " + left
        self.hint = PlainLabel(hint)
        layout = QVBoxLayout(self)
        layout.addWidget(self.hint)
        layout.addLayout(row, 1)
        layout.addWidget(self.buttons)
        self.resize(QSize(920, 560))
        self.list.setCurrentRow(0)
        self.unmarked = list(range(len(self.paths)))
        self.marking = QTimer(self)
        self.marking.timeout.connect(self._mark_next)
        self.marking.start(0)

    def _mark_next(self) -> None:
        """Read one file after another, between other events, and mark in the list what cannot be read."""
        if self.unmarked:
            self._mark(self.unmarked.pop(0))
        else:
            self.marking.stop()

    def _mark(self, row: int) -> None:
        if self._split(row):
            return
        (motion, *_) = self._read(self.paths[row])
        bad, name = isinstance(motion, str), named_row(self.paths[row])
        if not bad and any(warning.code == "vertical" for warning in motion.warnings):
            name = tr("{name} (vertical)", name=name)
        item = self.list.item(row)
        item.setText(f"{name}  ✕" if bad else name)
        item.setForeground(QColor(theme.current.bad if bad else theme.current.ink))
        item.setToolTip(escape_html(motion if bad else "" if isinstance(self.paths[row], Path) else name))

    def _split(self, row: int) -> bool:
        """Put the channels of a file of several in its place, each with a box to tick."""
        path = self.paths[row]
        if path in self.looked or not isinstance(path, Path):
            return False
        self.looked.add(path)
        entry = self.entries[path]
        names = channels_of(entry) if isinstance(self._read(path)[0], str) else ()
        if not names:
            return False
        shown = self.list.currentRow()
        rows: list[Row] = [(path, name) for name in names]
        self.paths[row : row + 1] = rows
        del self.entries[path]
        self.list.blockSignals(True)
        self.list.takeItem(row)
        for k, one in enumerate(rows):
            self.entries[one] = replace(entry, channel=names[k])
            item = QListWidgetItem(named_row(one))
            item.setCheckState(Qt.CheckState.Unchecked)
            self.list.insertItem(row + k, item)
        self.list.setCurrentRow(shown if shown <= row else shown + len(rows) - 1)
        self.list.blockSignals(False)
        added = range(row, row + len(rows))
        self.unmarked = [*added, *(k + len(rows) - 1 if k > row else k for k in self.unmarked)]
        self.show_file()
        return True

    def _ticked(self, row: int) -> bool:
        item = self.list.item(row)
        return isinstance(self.paths[row], Path) or item.checkState() == Qt.CheckState.Checked

    def _judge(self) -> None:
        """No OK while a field holds what is not in the entries."""
        ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setEnabled(not any(field.wrong for field in self.fields))

    def _other_file(self) -> None:
        for field in self.fields:
            field.forget()
        self.show_file()

    @property
    def path(self) -> Row:
        return self.paths[max(0, self.list.currentRow())]

    def _read(self, path: Row) -> list:
        """`read` of the entry of a file, once."""
        entry = self.entries[path]
        if entry not in self.found:
            self.found[entry] = read_motions(entry, file_of(path).parent)
        return self.found[entry]

    def change(self, **values) -> None:
        """Apply a choice to the selected files."""
        rows = {index.row() for index in self.list.selectedIndexes()} or {self.list.currentRow()}
        for row in rows:
            path = self.paths[row]
            self.found.pop(self.entries[path], None)
            self.entries[path] = replace(self.entries[path], **values)
        self.unmarked = sorted(rows.union(self.unmarked))
        self.marking.start(0)
        self.show_file()

    def show_file(self) -> None:
        """What the current file is with its choices."""
        for field in self.fields:
            field.show_value(getattr(self.entries[self.path], field.key))
        self.chart.clear()
        (motion, *_) = self._read(self.path)
        if isinstance(motion, str):
            self.words.setText(motion)
            return
        summary = (
            f"{motion.format}: {motion.acceleration.size} × {number(motion.time_step, 'g')} s, {motion.unit}, "
            f"PGA {number(motion.pga / G, '.3f')} g"
        )
        self.words.setText("\n".join([summary, *provenance_lines(motion)]))
        times = np.arange(motion.acceleration.size) * motion.time_step
        self.chart.curve(motion.name, times, motion.acceleration / G, 0, 1.0)
        self.chart.reset()

    def chosen(self) -> list[Record]:
        """Entries of the files that can be read, of several channels those ticked."""
        for row in range(len(self.paths) - 1, -1, -1):
            self._split(row)
        return [
            self.entries[path]
            for row, path in enumerate(self.paths)
            if self._ticked(row) and not isinstance(self._read(path)[0], str)
        ]
