"""New, open, save, export: the files of a window, and the questions that go with them."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, QStandardPaths
from PySide6.QtWidgets import QFileDialog, QMessageBox

from app.look.file_dialogs import path_to_write
from app.look.labels import escape_html
from app.look.language import current_language, describe_message, quoted_from_file, tr
from app.work.session import Session
from core import atomic_write
from core.errors import InputError
from core.known import require_value

if TYPE_CHECKING:
    from app.shell.window import MainWindow

EXAMPLE = Path(__file__).resolve().parents[2] / "resources" / "cases" / "example.toml"
RECENT = 8

CASE_ENDS = (".toml", ".ribalta")
"""Endings of a case file; the second is the one that opens the installed program."""
CASE_FILTER = f" ({' '.join(f'*{end}' for end in CASE_ENDS)})"
OPENED = f" ({' '.join(f'*{end}' for end in (*CASE_ENDS, '.pdf'))})"
"""A calculation note has its case within it."""


class Files:
    """What the menu File does for a window and its session."""

    def __init__(self, window: "MainWindow", session: Session, settings: QSettings):
        self.window, self.session, self.settings = window, session, settings

    def open(self, path: Path) -> bool:
        """Open a case; the one at hand is saved or given up first."""
        if not self.give_up():
            return False
        try:
            self.window.start_afresh(lambda: self.session.open(path))
        except InputError as error:
            QMessageBox.warning(self.window, tr("Not opened"), escape_html(quoted_from_file(error)))
            return False
        if path != EXAMPLE:
            self.remember(path)
        if said := self.session.from_drawings:
            lines = [
                describe_message(one) if isinstance(one, InputError) else one.text(current_language()) for one in said
            ]
            text = tr("What is saved or run from here are these solids; the drawing is read again with --batch.")
            words = lines if isinstance(said[0], InputError) else [*lines, text]
            QMessageBox.information(self.window, tr("Shapes of a drawing"), escape_html("\n\n".join(words)))
        return True

    @property
    def recent(self) -> list[str]:
        """Names of the files of late; settings give a single one as text."""
        names = self.settings.value("recent") or []
        names = [names] if isinstance(names, str) else names
        return [name for name in names if isinstance(name, str)] if isinstance(names, list) else []

    def remember(self, path: Path) -> None:
        others = [name for name in self.recent if name != str(path)]
        self.settings.setValue("recent", [str(path), *others][:RECENT])
        self.window.show_recent()

    def new(self) -> bool:
        """An empty case; False where the one at hand is to stay."""
        if not self.give_up():
            return False
        self.window.start_afresh(lambda: self.session.new(self.window.language))
        return True

    def ask_open(self) -> None:
        name, _ = QFileDialog.getOpenFileName(
            self.window, tr("Open a case"), str(self.session.base_dir), tr("Cases and notes") + OPENED
        )
        if name:
            self.open(Path(name))

    @property
    def _is_example(self) -> bool:
        """Whether the case is one of the program's own, which nothing is written over or beside."""
        return self.session.path is not None and self.session.path.parent == EXAMPLE.parent

    def proposed(self, end: str, stem: str = "ribalta") -> Path:
        """A file of the case with this ending, beside it; of an example in the user's folder of documents."""
        stem = self.session.path.stem if self.session.path else stem
        documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
        return (Path(documents) if self._is_example else self.session.base_dir) / f"{stem}{end}"

    def save(self) -> bool:
        if self.session.path is None or self._is_example:
            return self.save_as()
        return self._save(None)

    def save_as(self) -> bool:
        proposal = str(
            self.session.path if self.session.path and not self._is_example else self.proposed(".toml", "case")
        )
        kinds = tr("Cases") + CASE_FILTER
        path = path_to_write(self.window, tr("Save the case"), proposal, kinds, CASE_ENDS)
        return self._save(path) if path else False

    def _save(self, path: Path | None) -> bool:
        here = path is None or path.resolve() == self.session.path
        if here and self.session.is_changed_on_disk:
            question = tr("Another program has changed {path}. Overwrite it?", path=self.session.path)
            if not self._agreed(tr("Save the case"), question):
                return False
        try:
            self.session.save(path)
        except InputError as error:
            QMessageBox.warning(self.window, tr("Not saved"), escape_html(describe_message(error)))
            return False
        self.remember(require_value(self.session.path))
        if self.session.left_out:
            lines = "\n".join(describe_message(error) for error in self.session.left_out)
            text = tr("Saved without these values, which no case file may hold:\n{lines}", lines=lines)
            QMessageBox.warning(self.window, tr("Save the case"), escape_html(text))
        if any(field.wrong for field in self.window.stages.fields):
            self.window.show_word(tr("Saved without the content of the red field."))
        return True

    def _agreed(self, title: str, question: str) -> bool:
        button = QMessageBox.StandardButton
        return QMessageBox.question(self.window, title, escape_html(question)) == button.Yes

    def ask_export(self) -> None:
        """Workbook and JSON to a place the user names; the JSON of another program is not taken unasked."""
        if self.export_refused():
            return
        title = tr("Export the workbook")
        path = path_to_write(self.window, title, str(self.proposed(".xlsx")), "Excel (*.xlsx)", (".xlsx",))
        if path is None:
            return
        beside = path.with_suffix(".json")
        question = tr("{path} already exists. Overwrite it?", path=beside)
        if not beside.exists() or path.exists() or self._agreed(title, question):
            self.export(path)

    def ask_script(self) -> None:
        """The case as a Python script, to a place the user names."""
        from core.case.rules import replace_walls
        from core.study.case_script import case_script

        title, case = tr("Save as Python"), self.session.case
        try:
            text = case_script(replace_walls(case, list(case.wall)), self.session.base_dir)
        except (InputError, TypeError) as error:
            reason = describe_message(error) if isinstance(error, InputError) else tr("Something is still to be given.")
            QMessageBox.warning(self.window, tr("Nothing saved"), escape_html(reason))
            return
        path = path_to_write(self.window, title, str(self.proposed(".py")), "Python (*.py)", (".py",))
        if path is None:
            return
        try:
            atomic_write.write({path: text.encode()})
        except InputError as error:
            QMessageBox.warning(self.window, tr("Nothing saved"), escape_html(describe_message(error)))

    def ask_note(self) -> None:
        """The calculation note, as a PDF or for Word, to a place the user names."""
        from app.terminal import export
        from core.report.steps import Steps

        if self.export_refused():
            return
        title = tr("Export the calculation note")
        proposal = str(self.proposed(".pdf"))
        path = path_to_write(self.window, title, proposal, "PDF (*.pdf);;Word (*.docx)", (".pdf", ".docx"))
        if path is None:
            return
        result, case_path = require_value(self.session.result), self.session.path or self.session.base_dir / "case.toml"
        try:
            export.check_note(path, self.session.base_dir / "case.toml", result.case)
        except InputError as error:
            QMessageBox.warning(self.window, tr("Nothing exported"), escape_html(describe_message(error)))
            return

        def write(job) -> None:
            steps = Steps(job.check, job.progress)
            steps.take(100)
            content = export.note_content(result, path, case_path, steps)
            job.commit()
            atomic_write.write({path: content})

        self.window.runner.start(write, lambda _: self.window.show_word(tr("Written: {path}", path=path)), to_end=True)

    def ask_figures(self) -> None:
        """Every figure of the wall shown, to a folder the user names."""
        from app.views.figure_dialogs import last_size

        if self.export_refused() or self.window.runner.job is not None:
            return
        title = tr("Export all figures")
        name = QFileDialog.getExistingDirectory(self.window, title, str(self.proposed("").parent))
        if name:
            self.export_figures(Path(name), last_size())

    def export_figures(self, folder: Path, size) -> None:
        """The charts of every page as PNG, all or none; nothing that is there is overwritten unasked."""
        from app.shell.figure_export import FigureExport, beginning

        start = beginning(self.window.navigator.wall)
        there = next((path for path in sorted(folder.glob("*.png")) if path.name.startswith(start)), None)
        question = tr("{path} already exists. Overwrite it?", path=there)
        if there is None or self._agreed(tr("Export all figures"), question):
            FigureExport(self.window, folder, size)

    def export_refused(self) -> bool:
        """Whether there is nothing to export, or only results of an earlier input; says so."""
        changed = self.window.records.changed_on_disk
        if changed:
            self.window.records.read_again()
        stale = self.session.result is None or self.session.stale
        if stale or changed or self.window.runner.job is not None:
            reason = tr("The results are not of this input: run it first (F5).")
            QMessageBox.information(self.window, tr("Nothing exported"), escape_html(reason))
            return True
        return False

    def export(self, path: Path) -> None:
        """Workbook and JSON, as the batch writes them, off this thread."""
        from app.terminal import export

        result, case = require_value(self.session.result), self.session.case
        try:
            here = self.session.path or self.session.base_dir / "case.toml"
            export.refuse_overwriting(case, here, path.parent, path.stem)
        except InputError as error:
            QMessageBox.warning(self.window, tr("Nothing exported"), escape_html(describe_message(error)))
            return
        self.window.runner.start(
            lambda job: export.write(result, path.parent, path.stem, job.check, job.commit, tell=job.progress),
            lambda _: self.window.show_word(tr("Written: {path}", path=path)),
            to_end=True,
        )

    def give_up(self) -> bool:
        """Whether the case at hand may go: saved, unchanged, or given up by the user."""
        if not self.session.dirty:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self.window,
            tr("Unsaved changes"),
            tr("Save the changes of this case?"),
            button.Save | button.Discard | button.Cancel,
        )
        return self.save() if answer == button.Save else answer == button.Discard
