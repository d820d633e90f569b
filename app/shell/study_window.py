"""The window of a parametric study: what to run, its progress, the claims, tables and figures it results in."""

import os
import time
from pathlib import Path

from PySide6.QtCore import QStandardPaths, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QMessageBox,
    QProgressBar,
    QPushButton,
    QSplitter,
    QStackedWidget,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.look.dialogs import delete_after_use
from app.look.labels import PlainLabel, escape_html
from app.look.language import tr
from app.shell.study_form import StudyForm
from app.terminal import study
from app.terminal.command_line import SHIPPED_STUDIES
from app.views.study_tabs import claims_table, figure_chart, table_view
from app.work.runner import progress_word
from app.work.worker import Job
from core.known import require_value
from core.lab.research import parametric
from core.lab.research.study_report import report_of


class StudyWindow(QDialog):
    """One study at a time, off the window's thread; finished runs stay in the journal, so that a cancelled study
    goes on where it was."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.setWindowTitle(tr("Parametric study"))
        self.resize(1100, 720)
        self.job: Job | None = None
        self.began = 0.0
        self.study = QComboBox()
        self.study.addItems(sorted(SHIPPED_STUDIES))
        self.study.setCurrentText("paper")
        self.study.setEditable(True)
        self.study.setAccessibleName(tr("Study"))
        self.quick = QCheckBox(tr("Short form"))
        self.quick.setChecked(True)
        documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
        self.folder = QLineEdit(str(Path(documents) / "Ribalta"))
        self.folder.setAccessibleName(tr("Folder of the results"))
        self.records = QLineEdit()
        self.records.setPlaceholderText(tr("none"))
        self.records.setAccessibleName(tr("Natural records"))
        self.run_button = QPushButton(tr("Run or go on"))
        self.run_button.clicked.connect(self.run)
        self.cancel_button = QPushButton(tr("Cancel"))
        self.cancel_button.clicked.connect(self.cancel)
        self.cancel_button.setEnabled(False)
        self.bar = QProgressBar()
        self.word = PlainLabel()
        self.word.setWordWrap(True)
        self.tabs = QTabWidget()
        self.tabs.setTabBarAutoHide(True)  # without a tab it would take the focus, and keep it
        self.tabs.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.tabs.tabBar().setAccessibleName(tr("Parametric study"))
        layout = QVBoxLayout(self)
        layout.addLayout(self._form())
        layout.addWidget(self.word)
        layout.addWidget(self.tabs, 1)

    def _form(self) -> QHBoxLayout:
        left = QFormLayout()
        line = self._with_button(self.study, tr("File…"), self._choose_study)
        new = QPushButton(tr("New…"))
        new.setAutoDefault(False)
        new.clicked.connect(self._make_study)
        line.addWidget(new)
        left.addRow(tr("Study"), line)
        left.addRow(tr("Natural records"), self._with_button(self.records, tr("Folder…"), self._choose_records))
        left.addRow(tr("Folder of the results"), self._with_button(self.folder, tr("Folder…"), self._choose_folder))
        right = QVBoxLayout()
        right.addWidget(self.quick)
        buttons = QHBoxLayout()
        buttons.addWidget(self.run_button)
        buttons.addWidget(self.cancel_button)
        right.addLayout(buttons)
        right.addWidget(self.bar)
        line = QHBoxLayout()
        line.addLayout(left, 3)
        line.addLayout(right, 1)
        return line

    def _with_button(self, editor: QWidget, label: str, slot) -> QHBoxLayout:
        line = QHBoxLayout()
        line.addWidget(editor, 1)
        button = QPushButton(label)
        button.setAutoDefault(False)
        button.clicked.connect(slot)
        line.addWidget(button)
        return line

    def _choose_study(self) -> None:
        name, _ = QFileDialog.getOpenFileName(self, tr("Study"), "", "*.toml")
        if name:
            self.study.setCurrentText(name)

    def _make_study(self) -> None:
        """A study by its keys; its file is the one to run, whole."""
        with delete_after_use(StudyForm(self, Path(self.folder.text()))) as form:
            if form.exec():
                self.study.setCurrentText(str(form.path))
                self.quick.setChecked(False)

    def _choose_folder(self) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("Folder of the results"), self.folder.text())
        if name:
            self.folder.setText(name)

    def _choose_records(self) -> None:
        name = QFileDialog.getExistingDirectory(self, tr("Natural records"), self.records.text())
        if name:
            self.records.setText(name)

    # running

    def run(self) -> None:
        """Run the study, or go on with the one that was cancelled; the window stays alive."""
        if self.job is not None:
            return
        if not self.folder.text().strip():
            self.word.setText(tr("Name a folder for the results."))
            return
        quick, folder = self.quick.isChecked(), Path(self.folder.text())
        asked = self.study.currentText().strip()
        records = Path(self.records.text()) if self.records.text().strip() else None

        def work(job: Job):
            made = study.results(asked, folder, records, os.cpu_count() or 1, quick, True, job.progress, job.cancelled)
            try:
                report = report_of(made.result)
                study.write(made.result, report, folder, made.stem, job.check, job.commit, job.progress)
                made.book.remove()
            finally:
                made.book.close()
            return made.result, report, folder

        job = self.job = Job(work)
        job.done.connect(lambda outcome: self._arrived(*outcome))
        job.failed.connect(self._failed)
        job.progressed.connect(self._progressed)
        job.finished.connect(self._ended)
        self.began = time.monotonic()
        self.bar.setRange(0, 0)
        self.word.setText(tr("Running…"))
        self._show_running(True)
        job.start()

    def _show_running(self, on: bool) -> None:
        self.run_button.setEnabled(not on)
        self.cancel_button.setEnabled(on)

    def _progressed(self, done: int, planned: int, left: float | None) -> None:
        self.bar.setRange(0, max(planned, 1))
        self.bar.setValue(done)
        self.word.setText(progress_word(done, planned, time.monotonic() - self.began, left))

    def cancel(self) -> None:
        """Stop between two analyses; finished runs are kept."""
        if self.job is not None and self.job.cancel():
            self.word.setText(tr("Cancelled: finished runs are kept, Run goes on with them."))

    def _ended(self) -> None:
        self.job = None
        self.bar.setRange(0, 1)
        self.bar.setValue(0)
        self._show_running(False)

    def _failed(self, sentence: str, log: str) -> None:
        if log:
            sentence += "\n" + tr("Details are in {log}", log=log)
        self.word.setText(tr("Not done."))
        QMessageBox.warning(self, tr("Not done"), escape_html(sentence))

    def reject(self) -> None:
        """Esc closes, as a click on the cross does, which comes here too."""
        self.cancel()
        super().reject()

    # what is shown

    def _arrived(self, result: parametric.ParametricResult, report, folder: Path) -> None:
        self.word.setText("\n".join((report.title, *report.notes, tr("Written to {folder}", folder=folder))))
        while self.tabs.count():
            page = require_value(self.tabs.widget(0))
            self.tabs.removeTab(0)
            page.deleteLater()
        if report.claims:
            self.tabs.addTab(claims_table(report.claims), tr("Claims"))
        self.tabs.addTab(self._chooser([(t.title, lambda t=t: table_view(t)) for t in report.tables]), tr("Tables"))
        self.tabs.addTab(self._chooser([(f.title, lambda f=f: figure_chart(f)) for f in report.figures]), tr("Figures"))

    def _chooser(self, entries: list) -> QWidget:
        """A list of titles and the page of the chosen one, made when it is first looked at."""
        names, stack = QListWidget(), QStackedWidget()
        pages: dict[int, QWidget] = {}

        def show(row: int) -> None:
            if row < 0:
                return
            if row not in pages:
                pages[row] = entries[row][1]()
                stack.addWidget(pages[row])
            stack.setCurrentWidget(pages[row])

        for title, _ in entries:
            names.addItem(title)
        names.currentRowChanged.connect(show)
        split = QSplitter()
        split.addWidget(names)
        split.addWidget(stack)
        split.setSizes([300, 800])
        names.setCurrentRow(0)
        return split
