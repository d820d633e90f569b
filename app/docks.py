"""What surrounds the tabs of the window: forms, records, verdict, status line."""

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtWidgets import (
    QDockWidget,
    QLabel,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QTabWidget,
    QWidget,
)

from app.forms.demand_form import AnalysisForm, DemandForm
from app.forms.records_panel import RecordsPanel
from app.forms.wall_form import WallForm
from app.language import FORM_NAMES, tr
from app.pages import Veil


def build(window) -> None:
    """Forms on the left, records and the verdict on the right."""
    window.walls, window.demand = WallForm(window.session), DemandForm(window.session)
    window.analysis, window.records = AnalysisForm(window.session), RecordsPanel(window.session)
    window.records.loaded.connect(window.records_loaded)
    forms = QTabWidget()
    for form, label in ((window.walls, tr("Walls")), (window.demand, tr("Demand")),
                        (window.analysis, tr("Report"))):  # fmt: skip
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setMinimumWidth(366)
        area.setWidget(form)
        forms.addTab(area, label)
    window.forms = forms
    FORM_NAMES.captions.update({
        "[demand]": tr("Demand"), "[demand.spectrum]": tr("Spectrum"),
        "spectrum_file": tr("spectrum of a file"), "[generate]": tr("Generate…"),
        "time_step_s": tr("Time step"), "skip_lines": tr("Lines to skip"),
        "[analysis]": tr("Analysis"), "[report]": tr("Report"), "[record]": tr("Records"),
    })  # fmt: skip
    left = QDockWidget(tr("Input"), objectName="input")
    left.setWidget(forms)
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, left)
    right = QDockWidget(tr("Records"), objectName="records")
    window.records.setMinimumWidth(318)
    right.setWidget(window.records)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, right)
    window.card = QLabel(tr("No result yet: press F5."))
    window.card.setWordWrap(True)
    window.card.setTextFormat(Qt.TextFormat.RichText)
    window.card.setMargin(8)
    window.card.setAlignment(Qt.AlignmentFlag.AlignTop)
    window.card.setAccessibleName(tr("Verdict"))
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setWidget(window.card)
    window.card_veil = Veil(area)
    below = QDockWidget(tr("Verdict"), objectName="verdict")
    below.setWidget(area)
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, below)
    window.resizeDocks([left, right], [348, 318], Qt.Orientation.Horizontal)
    window.resizeDocks([right, below], [430, 260], Qt.Orientation.Vertical)
    state = window.settings.value("state")
    if isinstance(state, QByteArray):
        window.restoreState(state)


def sides(window) -> list[QDockWidget]:
    """What stands left and right of the tabs."""
    return [window.findChild(QDockWidget, name) for name in ("input", "records")]


def widen(window, widths: list[int]) -> None:
    """Give the sides their widths again: another language asks for others."""
    window.resizeDocks(sides(window), widths, Qt.Orientation.Horizontal)


def build_status(window) -> None:
    """The line at the bottom: a word, progress, Cancel."""
    bar = window.statusBar()
    for child in bar.findChildren(QWidget):
        bar.removeWidget(child)
    window.word = QLabel()
    window.bar = QProgressBar()
    window.bar.setMaximumWidth(220)
    window.bar.setAccessibleName(tr("Progress"))
    window.cancel_button = QPushButton(tr("Cancel"))
    window.cancel_button.clicked.connect(window.cancel)
    bar.addWidget(window.word, 1)
    bar.addPermanentWidget(window.bar)
    bar.addPermanentWidget(window.cancel_button)
    window.show_running(window.job is not None)
