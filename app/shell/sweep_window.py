"""The window of a sweep: one number of a wall or of the demand over a range, zeta of each check and q against it."""

import os
import time
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from app.input.editors import Choice
from app.look import theme
from app.look.labels import PlainLabel
from app.look.language import (
    FORM_NAMES,
    current_language,
    describe_message,
    key_text,
    number,
    result_word,
    tr,
    wall_title,
)
from app.views.chart import Chart
from app.views.study_tabs import figure_chart, table_view
from app.work.runner import progress_word
from app.work.worker import Job
from core.case.keys import unit_in_form
from core.case.loads import Load, ReturnWalls
from core.case.number import parse_quantity
from core.case.schema import Case
from core.case.site import Building
from core.case.values import check_value, field_of
from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.lab.research.figures import DASHED, LINE_POINTS, Figure, Series, Table
from core.study.sweep import MAX_VALUES, SweepKey, SweepPoint, sweep, sweep_keys, value_at
from core.text.sentence import Number, sentence

if TYPE_CHECKING:
    from app.shell.window import MainWindow

PROGRESS_PARTS = 100
"""Parts of a value that the progress bar tells apart."""

FIRST_RANGE = (0.7, 1.3)
"""Range that is proposed, over the value at hand."""


def key_words(case: Case, k: int, key: SweepKey) -> str:
    """What a key is called, with the load it is of and its unit."""
    unit, _ = unit_in_form(field_of(key.section, key.name))
    unit = tr("years") if unit == "years" else unit
    words = key_text(key.section, key.name, ".caption")
    if key.section in (Building, ReturnWalls):
        words = f"{tr('Building') if key.section is Building else result_word('key_return_walls')}: {words}"
    if key.index is not None:
        entries = case.wall[k].load if key.section is Load else case.wall[k].hold
        words = f"{result_word(f'choice_{entries[key.index].kind}')} {key.index + 1}: {words}"
    return f"{words} [{unit}]" if unit else words


def figures_of(points: list[SweepPoint], x: str, factor: float, case: Case) -> list[Figure]:
    """Zeta of each check and q against the key. x : label of its axis; factor : to the unit there"""
    demand = case.demand
    figures = []
    labels = list(dict.fromkeys(label for point in points for label in point.zeta))
    if demand and labels:
        curves = [
            _series(check_words(case, label), points, factor, lambda point, label=label: point.zeta.get(label), color)
            for color, label in enumerate(labels)
        ]
        ends = tuple(factor * one.value for one in (points[0], points[-1]))
        target = Series(tr("ζ required"), ends, (demand.zeta_target,) * 2, DASHED, len(labels))
        figures.append(Figure("sweep_zeta", tr("ζ of each check"), x, "ζ [-]", (*curves, target)))
    q = _series("q", points, factor, lambda point: point.q, 0)
    return [*figures, Figure("sweep_q", tr("q of the set"), x, "q [-]", (q,))]


def check_words(case: Case, label: str) -> str:
    """What a check is called in a list."""
    return sentence("short", label, q=Number(require_value(case.demand).q_code, "g")).text(current_language())


def _series(name: str, points: list[SweepPoint], factor: float, of, color: int) -> Series:
    known = [(factor * point.value, of(point)) for point in points if of(point) is not None]
    return Series(name, tuple(x for x, _ in known), tuple(y for _, y in known), LINE_POINTS, color)


def table_of_points(points: list[SweepPoint], x: str, factor: float, case: Case) -> Table:
    """Every number of a sweep; of a value that is refused the reason."""
    labels = list(dict.fromkeys(label for point in points for label in point.zeta))
    rows = []
    for point in points:
        outcome = describe_message(point.error) if point.error else result_word(point.verdict) if point.verdict else ""
        zetas = [point.zeta.get(label) for label in labels]
        rows.append((factor * point.value, *zetas, *([point.zeta_e] if case.demand else []), point.q, outcome))
    of_verdict = [tr("ζ of the verdict")] if case.demand else []
    head = (x, *(f"ζ {check_words(case, label)}" for label in labels), *of_verdict, "q", tr("Outcome"))
    return Table("sweep", tr("Sweep"), head, tuple(rows))


class SweepWindow(QDialog):
    """One sweep at a time, off the thread of the window; nothing of the case changes."""

    def __init__(self, window: "MainWindow"):
        super().__init__(window)
        self.setWindowTitle(tr("Sweep of one value"))
        self.resize(1040, 700)
        self.owner, self.began = window, 0.0
        self.job: Job | None = None
        self.look = (current_language(), theme.current.name)
        self.case: Case | None = None
        self.keys: list[SweepKey] = []
        self.points: list[SweepPoint] = []
        self.shown: tuple = ()
        self.wall, self.key = Choice(), Choice()
        self.low, self.high, self.count = QLineEdit(), QLineEdit(), QSpinBox()
        self.count.setRange(2, MAX_VALUES)
        self.count.setValue(9)
        self.run_button, self.cancel_button = QPushButton(tr("&Run")), QPushButton(tr("Cancel"))
        self.run_button.setDefault(True)
        self.cancel_button.setAutoDefault(False)
        self.bar, self.word, self.tabs = QProgressBar(), PlainLabel(), QTabWidget()
        self.word.setWordWrap(True)
        self.word.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout = QVBoxLayout(self)
        layout.addLayout(self._form())
        layout.addWidget(self.word)
        layout.addWidget(self.tabs, 1)
        self.wall.currentIndexChanged.connect(self._wall_chosen)
        self.key.currentIndexChanged.connect(self._key_chosen)
        self.run_button.clicked.connect(self.run)
        self.cancel_button.clicked.connect(self.cancel)
        self._show_running(False)
        self.show_case()

    def _form(self) -> QHBoxLayout:
        left, right = QFormLayout(), QFormLayout()
        left.addRow(tr("Wall"), self.wall)
        left.addRow(tr("Value"), self.key)
        limits, buttons = QHBoxLayout(), QHBoxLayout()
        for words, editor in ((tr("from"), self.low), (tr("to"), self.high), (tr("values"), self.count)):
            label = PlainLabel(words)
            label.setBuddy(editor)
            editor.setAccessibleName(words)
            limits.addWidget(label)
            limits.addWidget(editor)
        buttons.addWidget(self.run_button)
        buttons.addWidget(self.cancel_button)
        buttons.addWidget(self.bar, 1)
        buttons.addStretch(0)
        right.addRow(limits)
        right.addRow(buttons)
        for editor, words in ((self.wall, tr("Wall")), (self.key, tr("Value")), (self.bar, tr("Progress"))):
            editor.setAccessibleName(words)
        line = QHBoxLayout()
        line.addLayout(left, 1)
        line.addLayout(right, 1)
        return line

    # what is asked

    def show_case(self) -> None:
        """Offer the walls and the values of the case as it is now."""
        if self.job is not None:
            return
        self.case = self.owner.session.checked()
        row = self.owner.walls.current
        self.wall.clear()
        for wall in self.case.wall if self.case else ():
            self.wall.addItem(wall_title(wall.title))
        self.wall.setCurrentIndex(min(row, self.wall.count() - 1))
        problem = self.owner.session.problem()
        self.word.setText(describe_message(problem) if problem else "")
        self.run_button.setEnabled(self.case is not None)

    def _wall_chosen(self, k: int) -> None:
        chosen = self.key.currentText()
        self.key.clear()
        case = self.case
        self.keys = sweep_keys(case, k) if case and k >= 0 else []
        self.key.addItems([key_words(require_value(case), k, key) for key in self.keys])
        first = next((n for n, key in enumerate(self.keys) if key == SweepKey(Wall, "thickness_m")), 0)
        self.key.setCurrentIndex(max(self.key.findText(chosen), 0) if chosen else first)

    def _key_chosen(self, n: int) -> None:
        """A range about the value at hand; the same key keeps the one that stands there."""
        if not 0 <= n < len(self.keys):
            return
        key = self.keys[n]
        value = value_at(require_value(self.case), self.wall.currentIndex(), key)
        entry = field_of(key.section, key.name)
        _, factor = unit_in_form(entry)
        low, high = entry.metadata["low"], entry.metadata["high"]
        ends = sorted(min(max(share * value, low), high) for share in FIRST_RANGE) if value else ()
        for editor, end in zip((self.low, self.high), ends or (None, None), strict=True):
            editor.setText("" if end is None else number(end * factor, ".3g"))

    def values(self) -> list[float]:
        """The values asked for, in the unit of the case file. Raises InputError."""
        key = self.keys[self.key.currentIndex()]
        entry = field_of(key.section, key.name)
        unit, bare = entry.metadata.get("unit", ""), 1.0 / unit_in_form(entry)[1]
        ends = [parse_quantity(editor.text(), unit, bare) for editor in (self.low, self.high)]
        low, high = (check_value(key.section, key.name, end) for end in ends)
        n = self.count.value()
        return [low + (high - low) * k / (n - 1) for k in range(n)]

    # running

    def run(self) -> None:
        """Run the sweep of the case as it is; the window stays alive."""
        if self.job is not None or not self.keys or not self._take_case():
            return
        try:
            values = self.values()
        except InputError as error:
            words = error.accepted_text(current_language(), FORM_NAMES)
            self.word.setText(f"{self.key.currentText()}: {words}")
            return
        case, k, key = require_value(self.case), self.wall.currentIndex(), self.keys[self.key.currentIndex()]
        base, book = self.owner.session.base_dir, self.owner.runner.finished_runs
        self.points, self.shown = [], (case, k, key)

        def work(job: Job) -> None:
            def tell(n: int, share: float) -> None:
                job.progress(round(PROGRESS_PARTS * (n + share)), PROGRESS_PARTS * len(values))

            jobs = os.cpu_count() or 1
            for point in sweep(
                case, k, key, values, base_dir=base, jobs=jobs, finished=book, on_progress=tell, cancelled=job.cancelled
            ):
                job.found.emit(point)

        job = self.job = Job(work)
        job.found.connect(self.points.append)
        job.failed.connect(self._failed)
        job.progressed.connect(self._progressed)
        job.finished.connect(self._ended)
        self.began = time.monotonic()
        self.bar.setRange(0, 0)
        self.word.setText(tr("Running…"))
        self._show_running(True)
        job.start()

    def _take_case(self) -> bool:
        """Take the case as it is now; False where it has no longer what was chosen."""
        now, k = self.owner.session.checked(), self.wall.currentIndex()
        same = now and k < len(now.wall) and wall_title(now.wall[k].title) == self.wall.currentText()
        if now and same and self.keys[self.key.currentIndex()] in sweep_keys(now, k):
            self.case = now
            return True
        self.show_case()
        if now is not None:
            self.word.setText(tr("The case has changed: choose again."))
        return False

    def _show_running(self, on: bool) -> None:
        self.run_button.setEnabled(not on and self.case is not None)
        self.cancel_button.setEnabled(on)
        self.bar.setVisible(on)
        for editor in (self.wall, self.key, self.low, self.high, self.count):
            editor.setEnabled(not on)

    def _progressed(self, done: int, planned: int, left: float | None) -> None:
        self.bar.setRange(0, planned)
        self.bar.setValue(done)
        self.word.setText(
            progress_word(done // PROGRESS_PARTS, planned // PROGRESS_PARTS, time.monotonic() - self.began, left)
        )

    def cancel(self) -> None:
        """Stop between two analyses; what is finished is shown."""
        if self.job is not None:
            self.job.cancel()

    def _failed(self, words: str, log: str) -> None:
        self.word.setText(f"{words}\n{tr('Details are in {log}', log=log)}" if log else words)

    def _ended(self) -> None:
        self.job = None
        self._show_running(False)
        if self.points:
            self.show_points()

    def reject(self) -> None:
        """Esc closes, as a click on the cross does, which comes here too."""
        self.cancel()
        super().reject()

    # what is found

    def show_points(self) -> None:
        """Charts and table of the values that are finished."""
        case, k, key = self.shown
        _, factor = unit_in_form(field_of(key.section, key.name))
        x, now = key_words(case, k, key), value_at(case, k, key)
        while self.tabs.count():
            page = require_value(self.tabs.widget(0))
            self.tabs.removeTab(0)
            page.deleteLater()
        charts = QSplitter(Qt.Orientation.Vertical)
        for figure in figures_of(self.points, x, factor, case):
            charts.addWidget(self._chart(figure, case.wall[k], now and factor * now))
        charts.setSizes([400, 240])
        self.tabs.addTab(charts, tr("Charts"))
        self.tabs.addTab(table_view(table_of_points(self.points, x, factor, case)), tr("Table"))
        refused = [point for point in self.points if point.error]
        words = [tr("{n} of {planned} values", n=len(self.points) - len(refused), planned=self.count.value())]
        if refused:
            value = number(factor * refused[0].value, ".3g")
            words.append(
                tr(
                    "refused at {value}: {reason}",
                    value=value,
                    reason=describe_message(require_value(refused[0].error)),
                )
            )
        self.word.setText("; ".join(words))

    @staticmethod
    def _chart(figure: Figure, wall: Wall, now: float | None) -> QWidget:
        """A figure with the value at hand. now : in the unit of the axis"""
        page = figure_chart(figure)
        chart = require_value(page.findChild(Chart))
        chart.caption = f"{wall_title(wall.title)}: {figure.title}"
        if now is not None:
            chart.level(now, tr("now"), vertical=True, place=0.04)
        return page
