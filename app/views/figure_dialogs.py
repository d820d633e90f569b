"""What is asked before a figure is saved, and the ends of the axes."""

from PySide6.QtWidgets import QCheckBox, QComboBox, QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QVBoxLayout

from app.look.dialogs import delete_after_use
from app.look.language import current_language, tr
from app.views.figure_file import FigureSize
from core.text.sentence import format_number

FIGURE_WIDTHS = (80.0, 120.0, 160.0)
RESOLUTIONS = (300, 600)

_last = [FigureSize()]


def last_size() -> FigureSize:
    """The size chosen last."""
    return _last[0]


def ask_size(parent) -> FigureSize | None:
    """The size of a figure, None where the user gives up."""
    dialog = QDialog(parent)
    dialog.setWindowTitle(tr("Figure for a report"))
    width, dpi, caption = QComboBox(), QComboBox(), QCheckBox(tr("with a caption"))
    width.addItems([f"{value:g} mm" for value in FIGURE_WIDTHS])
    width.setCurrentIndex(FIGURE_WIDTHS.index(last_size().width))
    dpi.addItems([f"{value} dpi" for value in RESOLUTIONS])
    dpi.setCurrentIndex(RESOLUTIONS.index(last_size().dpi))
    caption.setChecked(last_size().caption)
    form = QFormLayout(dialog)
    form.addRow(tr("Width"), width)
    form.addRow(tr("Resolution of a PNG"), dpi)
    form.addRow("", caption)
    if not _accepted(dialog, form):
        return None
    _last[0] = FigureSize(FIGURE_WIDTHS[width.currentIndex()], RESOLUTIONS[dpi.currentIndex()], caption.isChecked())
    return _last[0]


def axis_limits(parent, labels, now) -> tuple[float, float, float, float] | None:
    """The ends of both axes (x, x, y, y), None where the user gives up or they are no ranges. labels : of the axes."""
    dialog = QDialog(parent)
    dialog.setWindowTitle(tr("Axis limits"))
    form = QFormLayout(dialog)
    fields = []
    for k, value in enumerate(now):
        field = QLineEdit(format_number(value, ".5g", current_language()))
        end = tr("from") if k % 2 == 0 else tr("to")
        form.addRow(f"{labels[k // 2]} {end}", field)
        fields.append(field)
    if not _accepted(dialog, form):
        return None
    try:
        left, right, low, high = (float(field.text().replace(",", ".")) for field in fields)
    except ValueError:
        return None
    return (left, right, low, high) if left < right and low < high else None


MAX_TABLE_ROWS = 20_000
"""Rows of a table of data that are shown: more nobody reads; the CSV has them all."""


def data_table(chart) -> QDialog:
    """The data of a chart as a table: curve, x, y."""
    from app.views.table import Table

    dialog = QDialog(chart)
    dialog.setWindowTitle(chart.name)
    table = Table(chart.name, chart.columns)
    rows = [
        [
            name,
            chart.names[int(x)] if chart.names else format_number(x, ".6g", current_language()),
            format_number(y, ".6g", current_language()),
        ]
        for name, xs, ys in chart.data
        for x, y in zip(xs.tolist(), ys.tolist(), strict=True)
    ]
    table.show_rows(rows[:MAX_TABLE_ROWS])
    table.live = chart.live
    layout = QVBoxLayout(dialog)
    layout.addWidget(table)
    dialog.resize(560, 480)
    return dialog


def _accepted(dialog: QDialog, form: QFormLayout) -> bool:
    buttons = QDialogButtonBox()
    buttons.addButton(tr("OK"), QDialogButtonBox.ButtonRole.AcceptRole)
    buttons.addButton(tr("Cancel"), QDialogButtonBox.ButtonRole.RejectRole)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    form.addRow(buttons)
    with delete_after_use(dialog):  # gone with the next event: what was typed is read before
        return dialog.exec() == QDialog.DialogCode.Accepted
