"""Help: what F1 says of a field, the guide, the shortcuts, the template of walls."""

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QUrl
from PySide6.QtGui import QDesktopServices, QKeySequence
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QDialog,
    QFileDialog,
    QMessageBox,
    QTextBrowser,
    QVBoxLayout,
    QWhatsThis,
    QWidget,
)

from app.input.fields import Field
from app.look.file_dialogs import path_to_write
from app.look.labels import escape_html
from app.look.language import current_language, key_text, tr
from app.work.worker import Job

if TYPE_CHECKING:
    from app.shell.window import MainWindow

DOCS = Path(__file__).resolve().parents[2] / "resources" / "docs"
TEMPLATE = Path(__file__).resolve().parents[2] / "resources" / "templates" / "walls.xlsx"
FOLDERS = {"en": DOCS / "guide", "it": DOCS / "guida"}


def help_of(field: Field) -> str:
    """The paragraph on a field: its help, else its tip."""
    return key_text(field.section, field.key, ".help") or field.editor.toolTip()


def explain(window: "MainWindow") -> None:
    """F1: the field that has the focus, else the guide."""
    widget: QWidget | None = QApplication.focusWidget()
    while widget is not None and not isinstance(widget, Field):
        widget = widget.parentWidget()
    words = help_of(widget) if widget else ""
    if widget is not None and words:
        place = widget.mapToGlobal(QPoint(20, widget.height()))
        QWhatsThis.showText(place, f"<b>{widget.caption.text()}</b><p>{words}</p>", widget)
    else:
        show_guide(window)


def pages_of(language: str) -> list[Path]:
    """The pages of the guide in their order."""
    return sorted(FOLDERS.get(language, FOLDERS["en"]).glob("*.md"))


class Guide(QDialog):
    """The guide in a window of its own."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setWindowTitle(tr("Guide"))
        self.paths = pages_of(current_language())
        self.chosen, self.text = QComboBox(), QTextBrowser()
        self.chosen.setAccessibleName(tr("Page"))
        for path in self.paths:
            first = path.read_text(encoding="utf-8").splitlines()[0]
            self.chosen.addItem(first.lstrip("# "))
        self.chosen.currentIndexChanged.connect(self._show)
        self.text.setOpenLinks(False)
        self.text.setTabChangesFocus(True)
        self.text.setAccessibleName(tr("Guide"))
        layout = QVBoxLayout(self)
        layout.addWidget(self.chosen)
        layout.addWidget(self.text, 1)
        self.resize(760, 620)
        self._show(0)

    def _show(self, k: int) -> None:
        if 0 <= k < len(self.paths):
            self.text.setSearchPaths([str(self.paths[k].parent)])
            self.text.setMarkdown(self.paths[k].read_text(encoding="utf-8"))


def show_guide(window: "MainWindow") -> None:
    """Open the guide, or bring it to the front."""
    opened = window.findChild(Guide) or Guide(window)
    opened.show()
    opened.raise_()


def show_shortcuts(window: "MainWindow") -> None:
    """Every entry of the menus that has a key."""
    lines = []
    for action in window.actions_with_keys:
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        if keys:
            lines.append(f"{keys}\t{action.text().replace('&', '').replace('…', '')}")
    QMessageBox.information(window, tr("Shortcuts"), escape_html("\n".join(lines)))


def show_validation(window: "MainWindow") -> None:
    """What the model tells of tests on a shake table, of a folder that is chosen; off the thread of the window."""
    title = tr("Tests on a shake table")
    name = QFileDialog.getExistingDirectory(window, tr("Folder with tests.csv and records.npz"))
    if not name:
        return
    from core.lab.research.shake_table import compared, read_tests
    from core.lab.solved.shaken import lines

    language = current_language()

    def work(job: Job) -> list[str]:
        tests = read_tests(Path(name))
        bodies = compared(tests, told=lambda share: job.progress(round(100 * share), 100, None))
        return lines(bodies, len(tests.left_out), language)

    def arrived(said: list[str]) -> None:
        window.show_word("")
        QMessageBox.information(window, title, escape_html("\n".join(said)))

    window.runner.start(work, arrived)


def save_solved_cases(window: "MainWindow") -> None:
    """Save and open the solved cases, run now, as a PDF; off the thread of the window."""
    title = tr("Solved cases")
    path = path_to_write(window, title, "solved.pdf", "PDF (*.pdf)", (".pdf",))
    if path is None:
        return
    from core import atomic_write
    from core.lab.solved import cases, pack

    language = current_language()

    def work(job: Job) -> str:
        known = cases.cases_of(cases.SUBJECTS)

        def told(done: int, planned: int) -> None:
            job.check()
            job.progress(done, planned, None)

        cases.solve(known, told)
        content = pack.pdf(cases.SUBJECTS, language)
        job.commit()
        atomic_write.write({path: content})
        return pack.summary(known).text(language)

    def arrived(said: str) -> None:
        window.show_word(said)
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(path)))

    window.runner.start(work, arrived, to_end=True)


def show_verification(window: "MainWindow") -> None:
    """What of a report differs from its case run again beside the files it reads; off the thread of the window."""
    title = tr("Verify a report")
    kinds = tr("Reports") + " (*.pdf *.xlsx *.json)"
    name = QFileDialog.getOpenFileName(window, title, str(window.session.base_dir), kinds)[0]
    if not name:
        return
    from app.terminal.verification import compare_report

    def arrived(verified: tuple[int, list[str]]) -> None:
        window.show_word("")
        QMessageBox.information(window, title, escape_html("\n".join(verified[1])))

    window.runner.start(
        lambda job: compare_report(Path(name), on_progress=job.progress, cancelled=job.cancelled), arrived
    )


def self_test_words(window: "MainWindow") -> str:
    """What the self-test told."""
    outcome = window.preparation.outcome
    if outcome is None:
        return tr("Self-test: not run yet, for no motion is there.")
    if not outcome.wrong:
        exact = tr("Self-test: passed, to the last digit.")
        return exact if outcome.exact else tr("Self-test: passed; some last digits differ on this machine.")
    names = {
        "intensity": tr("the Housner intensity"),
        "kinematic": tr("the checks by the clauses"),
        "two_sided_q": tr("q of a two-sided wall"),
        "two_sided_history": tr("a history of a two-sided wall"),
        "one_sided_q": tr("q of a one-sided wall"),
        "one_sided_history": tr("a history of a one-sided wall"),
        "trilinear_q": tr("q by the trilinear law"),
        "trilinear_history": tr("a history by the trilinear law"),
    }
    return tr(
        "Self-test: FAILED. On this machine {names} come out wrong: do not use any result of this installation.",
        names=", ".join(names[name] for name in outcome.wrong),
    )


def show_self_test(window: "MainWindow") -> None:
    """Compare known searches and histories with their stored answers; off the thread of the window."""
    from core.study.self_test import Outcome, compare_answers

    def arrived(outcome: Outcome) -> None:
        window.show_word("")
        window.preparation.tested(outcome)
        if not outcome.wrong:
            QMessageBox.information(window, tr("Self-test"), escape_html(self_test_words(window)))

    window.runner.start(lambda job: compare_answers(), arrived)


def save_template(window: "MainWindow") -> None:
    """A copy of the empty table of walls, to be filled in."""
    title = tr("Save the table of walls")
    path = path_to_write(window, title, "walls.xlsx", "Excel (*.xlsx)", (".xlsx",))
    if path is None:
        return
    try:
        shutil.copyfile(TEMPLATE, path)
    except OSError as error:
        QMessageBox.warning(window, title, escape_html(f"{path}: {error.strerror}"))
