"""The hazard of the site: rows pasted or read from a file."""

from pathlib import Path

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog, QGroupBox, QHBoxLayout, QMessageBox, QPushButton, QVBoxLayout

from app.look.labels import PlainLabel, escape_html
from app.look.language import quoted_from_file, tr
from app.work.session import Session
from core.case.hazard_table import parse_hazard, read_hazard
from core.case.site import HazardRow
from core.errors import InputError
from core.setting.demand_input import read_hazard_rows


class HazardForm(QGroupBox):
    """Edits the hazard of [demand]."""

    def __init__(self, session: Session):
        super().__init__(tr("Hazard of the site"))
        self.session = session
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        column, buttons = QVBoxLayout(self), QHBoxLayout()
        column.addWidget(self.words)
        for label, tip, slot in (
            (tr("Paste"), tr("Paste rows of T_R, a_g, F0, T_C*"), self.paste),
            (tr("File…"), tr("Read from a file"), self.choose_file),
            (tr("Clear"), "", lambda: self._edit((), None)),
        ):
            button = QPushButton(label)
            button.setToolTip(escape_html(tip))
            button.clicked.connect(slot)
            buttons.addWidget(button)
        column.addLayout(buttons)

    def show_case(self) -> None:
        """Say what is there."""
        demand = self.session.case.demand
        if demand is None:
            self.words.setText("")
            return
        try:
            rows = read_hazard_rows(demand, self.session.base_dir)
        except InputError as error:
            self.words.setText(quoted_from_file(error))
            return
        if not rows:
            self.words.setText(tr("none: T_R,C by the exponent of the code"))
            return
        ends = {"low": rows[0].return_period_years, "high": rows[-1].return_period_years}
        words = [tr("{n} rows, T_R {low:g} to {high:g} years", n=len(rows), **ends)]
        if demand.hazard_file:
            words.append(tr("from the file {name}", name=Path(demand.hazard_file).name))
        self.words.setText(", ".join(words))

    def paste(self) -> None:
        """Take the rows of the clipboard, as a spreadsheet or a page copies them."""
        try:
            self._edit(parse_hazard(QGuiApplication.clipboard().text()), None)
        except InputError as error:
            QMessageBox.warning(self, tr("Hazard not read"), escape_html(quoted_from_file(error)))

    def choose_file(self) -> None:
        """Refer to a file, if it can be read."""
        name, _ = QFileDialog.getOpenFileName(
            self, tr("T_R [years], a_g [g], F0, T_C* [s]"), str(self.session.base_dir)
        )
        if not name:
            return
        try:
            read_hazard(Path(name))
        except (InputError, OSError) as error:
            said = quoted_from_file(error) if isinstance(error, InputError) else str(error)
            QMessageBox.warning(self, tr("Hazard not read"), escape_html(said))
            return
        self._edit((), self.session.relative(Path(name)))

    def _edit(self, rows: tuple[HazardRow, ...], file: str | None) -> None:
        if self.session.case.demand is not None:
            self.session.edit_section("demand", hazard=rows, hazard_file=file)
