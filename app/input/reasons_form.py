"""Why values that raise zeta hold, in the engineer's words."""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any, TypeGuard

from PySide6.QtWidgets import QGroupBox, QVBoxLayout

from app.input.fields import TextField, connect
from app.input.wall_text import add_building_loads
from app.look.labels import PlainLabel
from app.look.language import result_word, tr
from app.work.session import Session
from core.case.schema import Case, Generate
from core.case.site import FULL_FACTOR, Building, Demand, DemandJustification
from core.case.solids import Leaf
from core.case.wall import Wall, WallJustification
from core.codes.limits import ORDINARY_LIFE
from core.codes.national_hazard import national_range
from core.codes.spectrum_codes import NATIONAL
from core.codes.verdict import CODE_Q
from core.ground.scattered import SPREAD
from core.setting.floors import MAX_STOREY, MIN_STOREY
from core.text.sentence import capital
from core.wall.kinematics import kinematics
from core.wall.restitution import MODELS

DEFAULT_COUNT = Generate().count
"""Motions of a generated set."""

Reasons = WallJustification | DemandJustification


def _of_ties(wall: Wall, leaf: Leaf | None) -> dict[str, bool]:
    """Those keys of `favourable_wall_keys` that ties hold, and the connectors of a leaf."""
    ties = wall.ties
    return {
        "elongation_m": bool(ties),
        "slack_mm": any(tie.slack_mm for tie in ties),
        "anchorage_kn": any(tie.bar is None or tie.bar.anchorage_kn is None for tie in ties)
        or bool(leaf and leaf.connector_kn_m),
        "prestress": any(tie.prestress for tie in ties),
    }


def favourable_wall_keys(case: Case, wall: Wall) -> set[str]:
    """Keys of a wall that raise its zeta as they are, see `core.variation.assumptions`."""
    leaf, wall = wall.leaf, add_building_loads(case, wall) or wall
    at_height = wall.above_ground and case.building is not None and not case.building.modes
    lifting = {
        **_of_ties(wall, leaf),
        "velocity_ratio": wall.velocity_ratio is not None,
        "restitution": wall.restitution not in (None, "user") and not MODELS[wall.restitution].by_theory,
        "return_walls": wall.return_walls is not None,
        "corner": wall.corner is not None,
        "leaf": wall.leaf is not None,
        "return_wedges": wall.return_wedges is not None,
        "contact": bool(wall.solid),
        "law": wall.law != "auto",
        "free_element": wall.free_element is not None
        and any(wall.free_element != (kinematics(mechanism).both_ways) for mechanism in wall.mechanisms()),
        "load": (wall.kinematics.bends_up and bool(wall.load))
        or any(load.is_carried or load.q_kn_m for load in wall.load)
        or any(load.is_thrust and isinstance(load.kn_m, float) and load.kn_m < 0.0 for load in wall.load),
        "mass": any(load.rests for load in wall.load),
        "d_m": any(load.rests for load in wall.load),
        "h_m": any(load.is_weight and is_number(load.h_m) for load in wall.load),
        "compressive_strength_mpa": wall.compressive_strength_mpa is not None,
        "unit_weight_kn_m3": wall.unit_weight_kn_m3 is not None and wall.is_loaded,
        "base_z_m": case.demand is not None and at_height and not wall.bends,
    }
    return {key for key, lifts in lifting.items() if lifts}


def favourable_demand_keys(case: Case) -> set[str]:
    """Keys of the demand and of the building whose values lift zeta: each asks for a reason."""
    demand, building = case.demand, case.building
    if demand is None:
        return set()
    lifting = {
        "confidence_factor": demand.confidence_factor < FULL_FACTOR,
        "q_code": demand.q_code > CODE_Q,
        "histories": not case.analysis.histories,
        "scatter": any(record.kind == "artificial" for record in case.record)
        or (case.generate is not None and case.generate.scatter < SPREAD),
        "count": case.generate is not None and is_number(case.generate.count) and case.generate.count > DEFAULT_COUNT,
        "limit_state": demand.limit_state == "SLC" and demand.return_period is None,
        "zeta_target": is_number(demand.zeta_target) and demand.zeta_target < 1.0,
        "soil_factor": is_number(demand.soil_factor) and demand.soil_factor < 1.0,
        **_of_the_place(demand),
        "period_s": building is not None and (building.period_s is not None or bool(building.modes)),
        "storeys": building is not None and _odd_storeys(building),
        "building": building is not None
        and (bool(building.modes) or (building.period_factor, building.damping) != (None, None)),
        "participation": building is not None and bool(building.modes),
    }
    return {key for key, lifts in lifting.items() if lifts}


def _of_the_place(demand: Demand) -> dict[str, bool]:
    """What of the hazard and of the spectrum does, drafts of them among it."""
    life, spectrum = demand.nominal_life_years, demand.spectrum
    share, code = demand.use_class_factor, spectrum.code if spectrum else ""
    known = bool(demand.hazard) or bool(demand.hazard_file)
    least = dict(zip(("f0", "tc_star_s"), (ends[0] for ends in national_range()), strict=True))
    given = {key: getattr(spectrum, key) for key in least} if code == NATIONAL else {}
    below = {key: is_number(value) and value < least[key] for key, value in given.items()}
    return below | {
        "nominal_life_years": known and is_number(life) and is_number(share) and life * share < ORDINARY_LIFE,
        "spectrum": (known and (code not in ("", NATIONAL) or bool(demand.spectrum_file)))
        or (spectrum is not None and spectrum.type == 2),
    }


def is_number(value: object) -> TypeGuard[float]:
    """Whether a value of a draft is one already."""
    return isinstance(value, (int, float))


def _odd_storeys(building: Building) -> bool:
    """Whether the storeys of a building, as far as it is given, are of an odd height."""
    known = is_number(building.height_m) and is_number(building.storeys) and building.storeys > 0
    return known and not MIN_STOREY <= building.height_m / building.storeys <= MAX_STOREY


class ReasonField(TextField):
    """The reason for a key; the key itself is another field's."""

    def text_of(self, part: str) -> str:
        return capital(result_word(f"key_{self.key}")) if part == ".caption" else ""

    def key_in_errors(self) -> str:
        return f"reason_{self.key}"


class ReasonsForm(QGroupBox):
    """Edits the section of the reasons: a row for each that is given, or whose key raises zeta.

    section : its class
    raised : keys that raise zeta as the case is; given : the reasons of the case
    change(key, reasons) : what to do with another reason for this key, None without any reason left
    """

    def __init__(
        self,
        section: type[Reasons],
        raised: Callable[[], set[str]],
        given: Callable[[], Reasons | None],
        change: Callable[[str, Reasons | None], None],
    ):
        super().__init__(tr("Reasons of the engineer"))
        self.section, self.raised, self.given, self.change = section, raised, given, change
        column = QVBoxLayout(self)
        hint = PlainLabel(
            tr("State why each of these values holds; without a reason the verdict may be only indicative.")
        )
        hint.setWordWrap(True)
        column.addWidget(hint)
        self.fields = []
        for entry in fields(section):
            self.fields.append(ReasonField(section, entry.name))
            column.addWidget(self.fields[-1])
        connect(self.fields, self._changed)

    def show_case(self) -> None:
        """Fill the form from the session."""
        given, raised = self.given(), self.raised()
        for field in self.fields:
            reason = getattr(given, field.key, "")
            field.show_value(reason)
            field.setVisible(bool(reason) or field.key in raised)
        self.setVisible(any(not field.isHidden() for field in self.fields))

    def _changed(self, field: TextField, value: str) -> None:
        changes: dict[str, Any] = {field.key: value}
        changed = replace(self.given() or self.section(), **changes)
        self.change(field.key, changed if changed != self.section() else None)


def reasons_of_wall(session: Session, index: Callable[[], int]) -> ReasonsForm:
    """The reasons of the wall at `index()`."""

    def wall() -> Wall | None:
        walls = session.case.wall
        return walls[index()] if index() < len(walls) else None

    def raised() -> set[str]:
        shown = wall()
        return favourable_wall_keys(session.case, shown) if shown else set()

    def given() -> Reasons | None:
        shown = wall()
        return shown.justification if shown else None

    def change(key: str, reasons: Reasons | None) -> None:
        if wall() is not None:
            place = ("wall", index(), "justification", key)
            session.edit_wall(index(), place, justification=reasons)

    return ReasonsForm(WallJustification, raised, given, change)


def reasons_of_demand(session: Session) -> ReasonsForm:
    """The reasons of the demand and of the building."""

    def given() -> Reasons | None:
        demand = session.case.demand
        return demand.justification if demand else None

    def change(key: str, reasons: Reasons | None) -> None:
        if session.case.demand is not None:
            place = ("demand", "justification", key)
            session.edit_section("demand", place, justification=reasons)

    return ReasonsForm(DemandJustification, lambda: favourable_demand_keys(session.case), given, change)
