"""The building that carries the walls above the ground."""

from dataclasses import replace
from typing import Any

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.input.entries_form import EntriesForm
from app.input.optional_group import OptionalGroup
from app.look.labels import PlainLabel
from app.look.language import FORM_NAMES, number, tr, wall_title
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.site import Building, FloorLoad
from core.codes.floor_spectrum import estimated_period
from core.setting.floors import modes_at


class FloorsForm(EntriesForm):
    """Edits the floors of the building."""

    owner = Building

    def __init__(self, session: Session):
        empty = dict.fromkeys(("name", "level_m", "from_wall", "from_d_m", "span_m", "g_kn_m2"), TO_BE_GIVEN)
        new: dict[str, Any] = {**empty, "mass": "none"}
        super().__init__(session, lambda: 0, "floors", {tr("Add"): lambda _: FloorLoad(**new)}, floor_words)
        self.set_title(tr("Floors and roofs"))
        FORM_NAMES.add("floors", tr("Floors and roofs"))

    @property
    def wall(self) -> Any:
        return self.session.case.building

    def edit(self, *place, **values) -> None:
        """Change keys of the building. place : as of `WallEditor.edit`"""
        case = self.session.case
        if case.building is not None:
            there = ("building", *place) if place else None
            self.session.edit(replace(case, building=replace(case.building, **values)), there)


def floor_words(floor: FloorLoad) -> str:
    """A floor in the list."""
    level = "–" if floor.level_m in (None, "") else number(floor.level_m, "g")
    walls = " – ".join(wall_title(name) for name in (floor.from_wall, floor.to_wall) if name)
    return f"{floor.name or '–'}: {level} m, {walls or '–'}"


class BuildingForm(QWidget):
    """Edits [building]."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        title, empty = tr("Building of the walls above the ground"), Building(TO_BE_GIVEN, TO_BE_GIVEN)
        self.given = OptionalGroup(title, "building", empty, lambda: session.case, self._edit)
        self.fields = self.given.fields
        self.summary = PlainLabel()
        self.summary.setWordWrap(True)
        self.given.column.addWidget(self.summary)
        self.floors = FloorsForm(session)
        self.given.column.addWidget(self.floors)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.given)
        layout.addStretch(1)

    def forget(self) -> None:
        """Another case: the building switched off in the last one does not come back in this."""
        self.given.forget()

    def show_case(self) -> None:
        """Fill the form from the session."""
        case = self.session.case
        building = case.building
        self.given.show_case()
        self.floors.setVisible(building is not None)
        self.floors.show_case()
        if building is None:
            self.summary.setText(tr("Needed where a wall has its base above the ground."))
            return
        for field in self.fields:
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

    def _edit(self, *place, **values) -> None:
        self.session.edit(replace(self.session.case, **values), place or None)
