"""What surrounds the tabs of the window: forms, records, verdict, status line."""

from typing import NamedTuple

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtWidgets import (
    QDockWidget,
    QLabel,
    QMenuBar,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QStatusBar,
    QTabWidget,
)

from app.input.demand_form import AnalysisForm, DemandForm
from app.input.records_panel import RecordsPanel
from app.input.wall_form import WallForm
from app.look.language import FORM_NAMES, tr
from app.shell.pages import Veil, delete
from app.work.session import Session


class Sides(NamedTuple):
    """Forms on the left, records and the verdict on the right."""

    forms: QTabWidget
    walls: WallForm
    demand: DemandForm
    analysis: AnalysisForm
    records: RecordsPanel
    card: QLabel
    card_veil: Veil


class StatusLine(NamedTuple):
    """The line at the bottom: a word, progress, Cancel."""

    word: QLabel
    bar: QProgressBar
    cancel_button: QPushButton


def build(window, session: Session, state, narrow: bool) -> Sides:
    """Make the docks of a window for its session. state : where they were last, a QByteArray or anything else;
    narrow : as of `arrange`."""
    walls, demand = WallForm(session), DemandForm(session)
    analysis, records = AnalysisForm(session), RecordsPanel(session)
    forms = QTabWidget()
    for form, label in ((walls, tr("Walls")), (demand, tr("Demand")), (analysis, tr("Report"))):
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setMinimumWidth(366)
        area.setWidget(form)
        forms.addTab(area, label)
    FORM_NAMES.captions.update(
        {
            "[demand]": tr("Demand"),
            "[demand.spectrum]": tr("Spectrum"),
            "spectrum": tr("Spectrum"),
            "spectrum_file": tr("spectrum of a file"),
            "[generate]": tr("Generate…"),
            "time_step_s": tr("Time step"),
            "skip_lines": tr("Lines to skip"),
            "[analysis]": tr("Analysis"),
            "[report]": tr("Report"),
            "[record]": tr("Records"),
            "[building]": tr("Building of the walls above the ground"),
        }
    )
    left = QDockWidget(tr("Input"), objectName="input")
    left.setWidget(forms)
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, left)
    right = QDockWidget(tr("Records"), objectName="records")
    records.setMinimumWidth(318)
    right.setWidget(records)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, right)
    card = QLabel(tr("No result yet: press F5."))
    card.setWordWrap(True)
    card.setTextFormat(Qt.TextFormat.RichText)
    card.setMargin(8)
    card.setAlignment(Qt.AlignmentFlag.AlignTop)
    card.setAccessibleName(tr("Verdict"))
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setWidget(card)
    card_veil = Veil(area)
    below = QDockWidget(tr("Verdict"), objectName="verdict")
    below.setWidget(area)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, below)
    known = isinstance(state, QByteArray) and not narrow
    if not known or not window.restoreState(state, LAYOUT):
        arrange(window, narrow)
    return Sides(forms, walls, demand, analysis, records, card, card_veil)


LAYOUT = 1
"""Raised where the docks are no longer those of an older version, whose arrangement is left aside then."""

NARROW = 1200
"""Width of the window [px] below which its docks share the left side: both sides would leave the tabs too little."""


WIDTHS, HEIGHTS = [348, 318], [430, 260]
"""Of input and records where both sides are taken, of records and verdict below them [px]."""


def show_walls(window) -> None:
    """Bring the form of the walls to the front."""
    window.forms.setCurrentIndex(0)
    dock = window.findChild(QDockWidget, "input")
    dock.show()
    dock.raise_()


def arrange(window, narrow: bool) -> None:
    """Records and verdict right of the tabs, or behind the input where the window is narrow, as wide as at first."""
    _place(window, narrow)
    widen(window, WIDTHS[:1] if narrow else WIDTHS)


def _place(window, narrow: bool) -> None:
    left, right, below = (window.findChild(QDockWidget, name) for name in ("input", "records", "verdict"))
    if narrow:
        window.tabifyDockWidget(left, right)
        window.tabifyDockWidget(right, below)
        QTimer.singleShot(0, left, left.raise_)  # of tabs that are there by then
        return
    for dock in (right, below):
        window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
    window.splitDockWidget(right, below, Qt.Orientation.Vertical)


def sides(window) -> list[QDockWidget]:
    """What stands left and right of the tabs."""
    return [window.findChild(QDockWidget, name) for name in ("input", "records")]


def widen(window, widths: list[int]) -> None:
    """Give the sides these widths when the docks have their places: before they have none to share out."""

    def share_out() -> None:
        window.resizeDocks(sides(window)[: len(widths)], widths, Qt.Orientation.Horizontal)
        right = [window.findChild(QDockWidget, name) for name in ("records", "verdict")]
        window.resizeDocks(right, HEIGHTS, Qt.Orientation.Vertical)

    QTimer.singleShot(0, window, share_out)


def remove(window) -> None:
    """Take away what an earlier build of a window made."""
    for dock in window.findChildren(QDockWidget):
        window.removeDockWidget(dock)
        delete(dock)
    centre = window.takeCentralWidget()
    if centre is not None:
        delete(centre)
    window.setMenuBar(QMenuBar())
    window.setStatusBar(QStatusBar())


def build_status(window) -> StatusLine:
    """Make the status line of a window."""
    line = window.statusBar()
    word, bar, cancel_button = QLabel(), QProgressBar(), QPushButton(tr("Cancel"))
    bar.setMaximumWidth(220)
    bar.setAccessibleName(tr("Progress"))
    line.addWidget(word, 1)
    line.addPermanentWidget(bar)
    line.addPermanentWidget(cancel_button)
    return StatusLine(word, bar, cancel_button)
