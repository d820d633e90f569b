"""The records: drag and drop, what each file is, include, sign, generated sets."""

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractButton,
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QMenu,
    QMessageBox,
    QSizePolicy,
    QTableWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.input.record_files import Row as FileRow
from app.input.record_files import all_files, file_of, provenance_lines
from app.input.record_rows import Row, cells, heads, read_rows, state_of
from app.look import theme
from app.look.dialogs import delete_after_use
from app.look.labels import PlainLabel, escape_html
from app.look.language import describe_message, tr
from app.views.table import Table
from app.work.session import Session
from app.work.worker import Job
from core.case.schema import Generate, Record
from core.codes.record_compatibility import common_factor
from core.errors import InputError
from core.file_names import name_of
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.setting.demand_input import read_demand


class RecordsPanel(QWidget):
    """Table of the records. loaded() : the motions of the case are there; `motions` holds them."""

    loaded = Signal()

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.setAcceptDrops(True)
        self.motions: list = []
        self.states: dict[str, tuple | None] = {}
        self.left_out = ""
        self.rows: list[Row] = []
        self.key: object = None
        self.pending = False
        self.table = Table(tr("Records"), heads(), wraps=False)
        self.table.setToolTip(tr("Double-click a record to change its scale, unit, time step or kind."))
        self.table.cellDoubleClicked.connect(lambda row, column: self.edit() if column else None)
        self.table.live = True
        self.table.itemChanged.connect(self._ticked)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.table.customContextMenuRequested.connect(self._menu)
        self.one_set = tr("Generated motions are one set: Remove takes them all, Generate… makes others.")
        self.words = PlainLabel(tr("Drop accelerograms or folders here."))
        self.words.setWordWrap(True)
        bar = QHBoxLayout()
        for label, tip, slot in (
            (tr("Add…"), tr("Add accelerograms"), self.add),
            (
                tr("Generate…"),
                tr("Motions whose mean is compatible with the spectrum, and that scatter as natural ones do"),
                self.generate,
            ),
            (tr("Choose…"), tr("Natural records of a folder by the spectrum"), self.choose),
            (tr("To the spectrum"), tr("Scale all to the spectrum"), self.scale_to_target),
            (tr("Reverse"), tr("Change the sign of the selected records"), self.reverse),
            (tr("Remove"), tr("Remove the selected records"), self.remove),
        ):
            button = QToolButton()
            button.setText(label)
            button.setToolTip(escape_html(tip))
            button.clicked.connect(slot)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            bar.addWidget(button)
            if slot == self.scale_to_target:
                self.scale_button = button
            if slot == self.add:
                menu = QMenu(button)
                menu.addAction(tr("A folder…"), self.add_folder)
                button.setMenu(menu)
                button.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        bar.setSpacing(3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addLayout(bar)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.words)

    # loading, off this thread

    @property
    def changed_on_disk(self) -> bool:
        """Whether another program has changed a file since it was read."""
        return any(state_of(name) != state for name, state in self.states.items())

    def read_again(self) -> None:
        """Read the files again if another program has changed one since."""
        if self.changed_on_disk:
            self.key = None
            self.show_case()

    def show_case(self) -> None:
        """Read what changed among the records; the table follows when they are there."""
        case = self.session.case
        why = self._why_no_scaling()
        self.scale_button.setEnabled(not why)
        self.scale_button.setToolTip(escape_html(why or tr("Scale all to the spectrum")))
        demand = case.demand if case.generate or case.select else None
        walls = case.wall if case.select else ()  # the periods of their mechanisms decide with it
        key = (case.record, case.generate, case.select, walls, demand, self.session.base_dir)
        if key == self.key:
            return
        nothing = not (case.record or case.generate or case.select) and self.key is None and not self.rows
        self.key = key
        if nothing:  # of a window that begins: there is nothing to read
            self.session.samples = set()
            return
        self.pending = True  # the rows are of the records before
        self.session.samples = None
        base = self.session.base_dir

        job = Job(lambda _: (key, *read_rows(case, base, lambda: self.key != key)))
        job.done.connect(self._arrived)
        job.failed.connect(self._failed)
        job.start()

    def _failed(self, sentence: str, log: str) -> None:
        self.pending, self.key = False, None  # tried again at the next change
        self.words.setText(f"{sentence} {log}")

    def _arrived(self, answer) -> None:
        key, motions_read, states = answer
        if key != self.key:
            return
        self.states = states
        self.rows, self.pending = motions_read, False
        case = self.session.case
        self.motions = [
            motion
            for k, motion in motions_read
            if not isinstance(motion, str) and (k is None or case.record[k].include)
        ]
        self.session.samples = {motion.samples_sha256 for motion in self.motions}
        self.table.blockSignals(True)
        rows, colors, twins = [], [], self._twins()
        for row, (k, motion) in enumerate(motions_read):
            rows.append(cells(motion, None if k is None else case.record[k]))
            bad = isinstance(motion, str) or row in twins
            color = theme.current.amber if not bad and motion.warnings else None
            colors.append([theme.current.bad if bad else color] * len(rows[-1]))
        self.table.show_rows(rows, colors)
        for row, (k, motion) in enumerate(motions_read):
            if isinstance(motion, str):
                continue
            tick = QTableWidgetItem()
            tick.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
            on = k is None or case.record[k].include
            tick.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
            if k is None:
                tick.setToolTip(escape_html(self.one_set))
            else:
                tick.setFlags(tick.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            self.table.setItem(row, 0, tick)
            tips = [*provenance_lines(motion), *([twins[row]] if row in twins else []), motion.file]
            require_value(self.table.item(row, 1)).setToolTip(escape_html("\n".join(tips)))
        self.table.blockSignals(False)
        count = len(self.motions)
        words = tr("{n} records in use. Drop accelerograms or folders here.", n=count)
        self.words.setText("\n".join([*twins.values(), f"{words} {self.left_out}".strip()]))
        self.left_out = ""
        self.loaded.emit()

    def unreadable_row(self) -> int | None:
        """The first row in use that cannot be read; None while they are being read."""
        records = self.session.case.record
        bad = [
            row
            for row, (k, motion) in enumerate(self.rows)
            if isinstance(motion, str) and (k is None or (k < len(records) and records[k].include))
        ]
        return bad[0] if bad and not self.pending else None

    def _motion(self, row: int) -> GroundMotion:
        """The motion of a row whose record could be read."""
        motion = self.rows[row][1]
        assert not isinstance(motion, str)
        return motion

    def point_at(self, row: int) -> None:
        """Select a row and say what is wrong with it."""
        self.table.selectRow(row)
        self.table.scrollToItem(require_value(self.table.item(row, 1)))
        self.table.setFocus()
        self.words.setText(str(self.rows[row][1]))

    def _twins(self) -> dict[int, str]:
        """What to say of the rows in use whose samples an earlier one has: no study takes both."""
        seen: dict[object, int] = {}
        sentences = {}
        for row, (k, motion) in enumerate(self.rows):
            if not isinstance(motion, str) and (k is None or self.session.case.record[k].include):
                here = (motion.file, motion.channel)
                first = seen.get(motion.samples_sha256, seen.get(here, row))
                seen |= {motion.samples_sha256: first, here: first}
                if first != row:
                    sentences[row] = describe_message(
                        InputError("record_twice", file=motion.name, twin=self._motion(first).name)
                    )
        return sentences

    # changes

    def _selected(self) -> set[int]:
        """Rows of the table that are selected, none while they are of the records before."""
        return set() if self.pending else {index.row() for index in self.table.selectedIndexes()}

    def _change(self, rows: set[int], change: Callable[[Record], Record | None]) -> None:
        """Change the records of these rows, None to drop them."""
        self._change_each(rows, lambda record, row: change(record), False)

    def _change_each(self, rows: set[int], change: Callable[[Record, int], Record | None], apart: bool = True) -> None:
        """`change(record, row)` of these rows. An entry of many files is written file by file where only some of them
        are meant; apart : always."""
        case = self.session.case
        records: list[Record | None] = []
        for k, record in enumerate(case.record):
            mine = [row for row, (entry, _) in enumerate(self.rows) if entry == k]
            alike = rows.isdisjoint(mine) or (rows.issuperset(mine) and not (apart and len(mine) > 1))
            if alike:
                records.append(change(record, mine[0]) if mine and mine[0] in rows else record)
                continue
            for row in mine:
                name = self.session.relative(Path(name_of(self._motion(row).file)))
                one = replace(record, file=name)
                records.append(change(one, row) if row in rows else one)
        self.session.edit(replace(case, record=tuple(one for one in records if one is not None)))

    def _ticked(self, item) -> None:
        listed = not self.pending and item.row() < len(self.rows)
        if item.column() == 0 and listed and self.rows[item.row()][0] is not None:
            on = item.checkState() == Qt.CheckState.Checked
            self._change({item.row()}, lambda record: replace(record, include=on))

    def _menu(self, place) -> None:
        menu = QMenu(self)
        menu.addAction(tr("Change…"), self.edit)
        menu.addAction(tr("Scale all to the spectrum"), self.scale_to_target).setEnabled(self.scale_button.isEnabled())
        menu.addAction(tr("Reverse"), self.reverse)
        menu.addAction(tr("Remove"), self.remove)
        menu.exec(self.table.viewport().mapToGlobal(place))

    def reverse(self) -> None:
        rows = self._selected()
        if any(self.rows[row][0] is None for row in rows):
            self.words.setText(self.one_set)
        self._change(rows, lambda record: replace(record, scale=-record.scale))

    def remove(self) -> None:
        rows = self._selected()
        if any(self.rows[row][0] is None for row in rows):
            self.session.edit(replace(self.session.case, generate=None, select=None))
        self._change(rows, lambda record: None)

    def generate(self) -> None:
        """A set compatible with the spectrum in its mean, or the same with the next seeds."""
        case = self.session.case
        if case.demand is None or not (case.demand.spectrum or case.demand.spectrum_file):
            self.words.setText(tr("Choose a spectrum under Demand first."))
            return
        seed = case.generate.seed + case.generate.count if case.generate else 1
        records = case.record
        if records:
            answer = self.ask_replace()
            if answer is None:
                return
            records = () if answer else records
        self.session.edit(replace(case, record=records, generate=Generate(seed=seed)))

    def choose(self) -> None:
        """Natural records of a folder, in place of those there."""
        from app.input.selection_dialog import choose_for

        if why := choose_for(self.session, self):
            self.words.setText(why)

    def ask_replace(self) -> bool | None:
        """Whether generated records take the place of those there, or come beside them; None for neither."""
        with delete_after_use(QMessageBox(self)) as box:
            box.setWindowTitle(tr("Generate…"))
            box.setText(tr("There are records already. Replace them with seven generated ones, or add these?"))
            instead = box.addButton(tr("Replace"), QMessageBox.ButtonRole.AcceptRole)
            beside = box.addButton(tr("Add to them"), QMessageBox.ButtonRole.AcceptRole)
            box.addButton(tr("Cancel"), QMessageBox.ButtonRole.RejectRole)
            answers: dict[QAbstractButton, bool] = {instead: True, beside: False}
            box.exec()
            return answers.get(box.clickedButton())

    def edit(self) -> None:
        """Scale, unit, time step and kind of the selected records."""
        rows = sorted(row for row in self._selected() if self.rows[row][0] is not None)
        entries: dict[FileRow, Record] = {}
        path_of: dict[int, FileRow] = {}
        for row in rows:
            k, motion = self.rows[row]
            entry = self.session.case.record[require_value(k)]
            path = Path(entry.file if isinstance(motion, str) else name_of(motion.file))
            if not path.is_absolute():
                path = self.session.base_dir / path
            place = (path, entry.channel) if entry.channel else path
            entries[place], path_of[row] = replace(entry, file=str(path)), place
        if not entries:
            self.words.setText(self.one_set)
            return
        from app.input.import_dialog import ImportDialog

        with delete_after_use(ImportDialog(list(entries), self, entries)) as dialog:
            if dialog.exec() != QDialog.DialogCode.Accepted:
                return
            edited = dialog.entries  # two rows may be of one file, and the dialog shows not all of very many
            changed = {row: edited[path] for row, path in path_of.items() if path in edited}
        keys = ("unit", "time_step_s", "column", "skip_lines", "kind", "scale")

        def change(record: Record, row: int) -> Record:
            return replace(record, **{key: getattr(changed[row], key) for key in keys})

        self._change_each(set(changed), change)

    def _why_no_scaling(self) -> str:
        """Why no factor would bring the records to the spectrum of the demand; "" where one may."""
        case = self.session.case
        demand, files = case.demand, any(record.include for record in case.record)
        if demand is None or not (demand.spectrum or demand.spectrum_file) or not files:
            return tr("This needs records from files and a spectrum under Demand.")
        if demand.demand_scaling == "pga":  # which cancels any factor of a file
            return tr("The records are scaled to PGA = a_g S already (Demand).")
        return ""

    def scale_to_target(self) -> None:
        """One factor for all records in use: the mean spectrum nearest to that of the demand."""
        case = self.session.case
        if why := self._why_no_scaling():
            self.words.setText(why)
            return
        try:
            asked = read_demand(case, self.session.base_dir) if case.demand else None
        except (InputError, TypeError, KeyError):
            asked = None
        rows = {
            row
            for row, (k, motion) in enumerate(self.rows)
            if not self.pending and k is not None and not isinstance(motion, str) and case.record[k].include
        }
        if asked is None or asked.target is None or not rows:
            self.words.setText(tr("This needs records from files and a spectrum under Demand."))
            return
        try:
            factor = common_factor([self._motion(row) for row in rows], asked)
        except InputError as error:
            self.words.setText(describe_message(error))
            return
        if not 0.0 < factor < math.inf:
            self.words.setText(tr("This needs records from files and a spectrum under Demand."))
            return
        self._change(rows, lambda record: replace(record, scale=float(f"{record.scale * factor:.4g}")))
        self.left_out = tr("Scaled by {factor:.3f}, the factor nearest to the spectrum.", factor=factor)

    def add(self) -> None:
        names, _ = QFileDialog.getOpenFileNames(self, tr("Add accelerograms"), str(self.session.base_dir))
        if names:
            self.take([Path(name) for name in names])

    def add_folder(self) -> None:
        """All that a folder holds."""
        name = QFileDialog.getExistingDirectory(self, tr("Add accelerograms"), str(self.session.base_dir))
        if name:
            self.take([Path(name)])

    def take(self, paths: list[Path], ask: bool = True) -> None:
        """Add files and folders, after the dialog that shows what they are."""
        files = all_files(paths)
        if not files:
            self.words.setText(tr("No files there."))
            return
        from app.input.import_dialog import ImportDialog

        with delete_after_use(ImportDialog(files, self)) as dialog:
            taken = not ask or dialog.exec() == QDialog.DialogCode.Accepted
            chosen = dialog.chosen() if taken else []
        self.session.add_records(
            [replace(entry, file=self.session.relative(Path(name_of(entry.file)))) for entry in chosen]
        )
        left = len({file_of(row) for row in dialog.paths} - {Path(entry.file) for entry in chosen})
        if taken and left:
            self.left_out = tr("Files left out, which cannot be read as they are: {n}.", n=left)
            self.words.setText(self.left_out)

    def dragEnterEvent(self, event) -> None:
        if event.mimeData().hasUrls():
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()

    def dropEvent(self, event) -> None:
        """Files are read where they are: a move would have the file manager delete them there."""
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self.take([Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()])
