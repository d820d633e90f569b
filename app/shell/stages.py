"""The frame of the window: a bar, the tree, and beside it the stage: input, answer, why, report."""

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenuBar,
    QProgressBar,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QStackedWidget,
    QStatusBar,
    QStyle,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from app.input.demand_form import AnalysisForm, DemandForm
from app.input.fields import Field
from app.input.message_bar import MessageBar
from app.input.note_form import NoteForm
from app.input.records_panel import RecordsPanel
from app.input.wall_form import WallForm
from app.look.labels import PlainLabel
from app.look.language import FORM_NAMES, current_language, result_word, tr
from app.shell.header import STAGES
from app.shell.live_answer import LiveAnswer
from app.shell.pages import LazyPage, StaleOverlay, delete
from app.shell.problems_panel import ProblemsPanel
from app.work.session import Session
from core.codes.spectrum_codes import CODES
from core.errors import place
from core.known import require_value

if TYPE_CHECKING:
    from app.shell.window import MainWindow

MIN_WIDTH_FOR_MOTION = 1250
"""Width of the stage [px] from which the rocking wall stands beside the answer."""

ANSWER, WHY = ("walls", "check"), ("histories", "sure", "capacity", "intensity", "spectra", "validation")
"""Pages of these stages; the pages of the report are one."""

CHOICES_WIDTH = 300
"""Width of what stands beside the pages of the note [px]."""

WIDTH_SHARES = {"wall": (44, 56), "demand": (44, 56), "building": (44, 56), "records": (62, 38), "report": (56, 44)}
"""Shares of the width of the stage that forms and what stands beside them take."""


def stage_of(page: str) -> str:
    """The stage a page is of."""
    return "answer" if page in ANSWER else "why" if page in WHY else "report"


def name_sections() -> None:
    """What errors call the sections of a case in the window."""
    FORM_NAMES.captions.update(
        {
            "[demand]": tr("Demand"),
            "[demand.spectrum]": tr("Spectrum"),
            "[site]": tr("the place"),
            "spectrum": tr("Spectrum"),
            "spectrum_file": tr("spectrum of a file"),
            "[generate]": tr("Generate…"),
            "[select]": tr("Choose…"),
            "time_step_s": tr("Time step"),
            "skip_lines": tr("Lines to skip"),
            "[analysis]": tr("Analysis"),
            "[report]": tr("Report"),
            "[record]": tr("Records"),
            "[building]": tr("Building of the walls above the ground"),
            "[[wall]]": tr("wall"),
            "mechanism": result_word("key_mechanism"),
            "[wall.bar]": tr("Bars in place of the force"),
            "[wall.return_walls]": tr("Friction of return walls (in α0 only)"),
            "[wall.corner]": tr("Corner of two walls that turn together"),
            "[wall.plan]": tr("Place in the key plan"),
            "[wall.leaf]": tr("Outer leaf that comes off"),
            "[wall.evidence]": tr("Evidence"),
            "[[wall.hold]]": tr("What holds it"),
            "evidence": tr("Evidence"),
            "hold": tr("What holds it"),
            **{name: code.name for name, code in CODES.items()},
            **{
                f"[[{kind}]] {k}": place(kind, n=k).text(current_language())
                for kind in ("load", "hold")
                for k in range(1, 100)
            },
        }
    )


class InputStage(QSplitter):
    """The form of what is chosen in the tree; beside it the drawing or the spectrum, and all that is missing."""

    def __init__(self, window: "MainWindow", session: Session, spectra: Callable[[], QWidget]):
        """spectra() : makes the spectra of the records"""
        super().__init__(Qt.Orientation.Horizontal)
        self.setHandleWidth(5)
        self.walls, self.demand = WallForm(session), DemandForm(session)
        self.analysis, self.records = AnalysisForm(session), RecordsPanel(session)
        name_sections()
        self.forms, self.views, self.kind = QStackedWidget(), QStackedWidget(), ""
        self.areas: dict[str, QScrollArea] = {}
        forms = {
            "wall": self.walls,
            "demand": self.demand,
            "building": self.demand.building,
            "records": self.records,
            "report": self.analysis,
        }
        for kind, form in forms.items():
            area = QScrollArea()
            area.setWidgetResizable(True)
            area.setFrameShape(QFrame.Shape.NoFrame)
            area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
            area.setWidget(form)
            self.areas[kind] = area
            self.forms.addWidget(area)
        drawing = QWidget()
        column = QVBoxLayout(drawing)
        column.setContentsMargins(4, 4, 4, 4)
        column.addWidget(self.walls.summary)
        column.addWidget(self.walls.drawing, 1)
        hint = PlainLabel(
            tr("Click a load, a hold, a hinge or a size for its field, twice to change it here; drag loads and holds.")
        )
        hint.setWordWrap(True)
        column.addWidget(hint)
        self.nothing = PlainLabel()
        self.spectra = LazyPage(spectra)
        self.of_kind = {"wall": drawing, "demand": self.demand.view, "records": self.spectra}
        for view in (*self.of_kind.values(), self.nothing):
            self.views.addWidget(view)
        self.missing, self.live = ProblemsPanel(window), LiveAnswer(window)
        beside = QWidget()
        right = QVBoxLayout(beside)
        right.setContentsMargins(0, 0, 0, 0)
        right.addWidget(self.views, 1)
        right.addWidget(self.live)
        right.addWidget(self.missing)
        column_beside = QScrollArea()
        column_beside.setWidgetResizable(True)
        column_beside.setFrameShape(QFrame.Shape.NoFrame)
        column_beside.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        column_beside.setWidget(beside)
        self.said = MessageBar(self._fields_in_front)
        self.fields_of = {kind: area.findChildren(Field) for kind, area in self.areas.items()}
        for fields in self.fields_of.values():
            for field in fields:
                field.tell = self.said.follow
        column_of_forms = QWidget()
        left = QVBoxLayout(column_of_forms)
        left.setContentsMargins(0, 0, 0, 0)
        left.setSpacing(0)
        left.addWidget(self.forms, 1)
        left.addWidget(self.said)
        for part in (column_of_forms, column_beside):
            part.setMinimumWidth(240)
            self.addWidget(part)
        self.setChildrenCollapsible(False)

    def show_kind(self, kind: str) -> None:
        """Bring a form to the front: wall, demand, building, records, report."""
        self.forms.setCurrentWidget(self.areas[kind])
        self.views.setCurrentWidget(self.of_kind.get(kind, self.nothing))
        if kind != self.kind:
            self.kind = kind
            self._share()
            self.said.follow()
            self.live.follow()

    def _fields_in_front(self) -> list[Field]:
        fields = self.fields_of[self.kind] if self.kind else []
        return [field for field in fields if isValid(field)]  # the focus also leaves a window that is being deleted

    def _share(self) -> None:
        kind = self.kind or "wall"
        forms, views = (self.width() * share // 100 for share in WIDTH_SHARES[kind])
        bar = self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollBarExtent)
        needed = require_value(self.areas[kind].widget()).minimumSizeHint().width() + bar
        self.setSizes([max(forms, needed), min(views, self.width() - needed)])

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self._share()


class AnswerStage(QWidget):
    """All walls, or the one that is chosen; in a wide window the rocking wall beside it. widened : it came or went"""

    widened = Signal()

    def __init__(self, pages: dict[str, LazyPage], beside: LazyPage):
        super().__init__()
        self.stack, self.beside = QStackedWidget(), beside
        for name in ANSWER:
            self.stack.addWidget(pages[name])
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.stack, 5)
        row.addWidget(beside, 3)
        beside.hide()

    def has_beside(self) -> bool:
        return not self.beside.isHidden()

    def show_beside(self, on: bool) -> None:
        """on : there is a wall to show"""
        wide = on and self.width() >= MIN_WIDTH_FOR_MOTION
        if wide != self.has_beside():
            self.beside.setVisible(wide)

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self.widened.emit()


class Stages(QWidget):
    """The four stages, one in front; progress above them."""

    def __init__(
        self, window: "MainWindow", session: Session, pages: dict[str, tuple[LazyPage, str]], beside: LazyPage
    ):
        super().__init__()
        made = self.pages = {name: page for name, (page, _) in pages.items()}
        self.input = InputStage(window, session, made["spectra"].maker)
        self.answer = AnswerStage(made, beside)
        self.why = QTabWidget()
        self.why.setDocumentMode(True)
        self.why.tabBar().setAccessibleName(tr("Why"))
        for name in WHY:
            self.why.addTab(made[name], pages[name][1])
        self.note_form, report = NoteForm(session), QSplitter(Qt.Orientation.Horizontal)
        for part in (made["note"], self.note_form):
            report.addWidget(part)
        report.setStretchFactor(0, 1)
        report.setSizes([1000, CHOICES_WIDTH])
        self.stack = QStackedWidget()
        self.first: QWidget | None = None
        for stage in (self.input, self.answer, self.why, report):
            self.stack.addWidget(stage)
        self.bar = QProgressBar()
        self.bar.setAccessibleName(tr("Progress"))
        self.bar.setTextVisible(True)
        self.bar.setFixedHeight(24)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.bar)
        layout.addWidget(self.stack, 1)
        self.veil = StaleOverlay(self.stack)
        self.bar.hide()

    @cached_property
    def fields(self) -> list[Field]:
        """The fields of the case, which are all made with their forms; those of a dialog are not among them."""
        given = self.input
        forms = (given.walls, given.demand, given.demand.building, given.analysis, self.note_form)
        return [field for form in forms for field in form.findChildren(Field)]

    @property
    def front(self) -> str:
        """The stage in front."""
        return STAGES[self.stack.currentIndex()] if self.first is None else "input"

    def show_first(self, page: QWidget) -> None:
        """A page before all stages, gone with the first stage that is chosen."""
        self.first = page
        self.stack.addWidget(page)
        self.stack.setCurrentWidget(page)

    def show_stage(self, name: str) -> None:
        if self.first is not None:
            self.stack.removeWidget(self.first)
            self.first.deleteLater()
            self.first = None
        self.stack.setCurrentIndex(STAGES.index(name))


def remove(window: "MainWindow") -> None:
    """Take away what an earlier build of a window made."""
    centre = window.takeCentralWidget()
    if centre is not None:
        window.stages.input.live.end()
        delete(centre)
    window.setMenuBar(QMenuBar())
    window.setStatusBar(QStatusBar())


def build_status(window: "MainWindow") -> QLabel:
    """Make the status line of a window: a word."""
    word = PlainLabel()
    word.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
    window.statusBar().addWidget(word, 1)
    window.statusBar().setSizeGripEnabled(False)
    return word
