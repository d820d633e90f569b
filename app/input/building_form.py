"""The building that carries the walls above the ground."""

from dataclasses import replace

from PySide6.QtWidgets import QGroupBox, QVBoxLayout, QWidget

from app.input.fields import blank, connect
from app.input.made_fields import make_fields
from app.look.labels import Plain
from app.look.language import tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.site import Building
from core.codes.floor_spectrum import estimated_period
from core.setting.floors import modes_at


class BuildingForm(QWidget):
    """Edits [building]."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.forget()
        self.given = QGroupBox(tr("Building of the walls above the ground"))
        self.given.setCheckable(True)
        self.given.toggled.connect(self._toggled)
        self.fields = make_fields(Building)
        connect(self.fields, self._changed)
        self.summary = Plain()
        self.summary.setWordWrap(True)
        inside = QVBoxLayout(self.given)
        for field in self.fields:
            inside.addWidget(field)
        inside.addWidget(self.summary)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.given)
        layout.addStretch(1)

    def forget(self) -> None:
        """Another case: the building switched off in the last one does not come back in this."""
        self.last: Building | None = None

    def show_case(self) -> None:
        """Fill the form from the session."""
        case = self.session.case
        building = case.building
        self.given.blockSignals(True)
        self.given.setChecked(building is not None)
        self.given.blockSignals(False)
        if building is None:
            blank(self.fields)
            self.summary.setText(tr("Needed where a wall has its base above the ground."))
            return
        for field in self.fields:
            field.show_value(getattr(building, field.key))
            field.setVisible(not building.modes or field.key not in ("period_s", "damping"))
        self.summary.setText(self._said(building, case.demand.limit_state if case.demand else "SLV"))

    @staticmethod
    def _said(building: Building, limit_state: str) -> str:
        """The modes of the damaged building at its top."""
        try:
            modes = modes_at(building, building.height_m, limit_state)
        except (TypeError, ValueError, ZeroDivisionError):  # work in progress
            return ""
        words = [
            tr(
                "At the top: T {period:.3f} s, ξ {damping:.0f} %, γψ {part:.3f}",
                period=mode.period,
                damping=100.0 * mode.damping,
                part=mode.participation,
            )
            for mode in modes
        ]
        if building.period_s is None and not building.modes:
            estimate = estimated_period(building.height_m)
            words.append(tr("T_1 {period:.3f} s is an estimate.", period=estimate))
        return "\n".join(words)

    def _toggled(self, on: bool) -> None:
        case = self.session.case
        if on:
            building = self.last or Building(TO_BE_GIVEN, TO_BE_GIVEN)
            self.session.edit(replace(case, building=building))
        else:
            self.last = case.building
            self.session.edit(replace(case, building=None))

    def _changed(self, field, value) -> None:
        if self.session.case.building is not None:
            self.session.edit_section("building", ("building", field.key), **{field.key: value})
