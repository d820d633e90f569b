"""The demands of SLD, SLV and SLC of a site by its hazard, and zeta of a wall at each (NTC 2018, Annex A)."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from core.case.schema import Case, Wall
from core.case.site import Building
from core.codes.demand import DemandResult
from core.codes.kinematic import ROUNDING, Check, kinematic, linear, nonlinear, sld
from core.codes.limits import SAME_PERIOD, return_period
from core.study.demand_input import demand_of, hazard_of, interpolated
from core.study.floors import floor_of
from core.text.sentence import Sentence, notice

STATES = ("SLD", "SLV", "SLC")


@dataclass(frozen=True)
class StateZeta:
    """A wall at one limit state, by its kinematic checks: linear at SLD, displacement and linear with q of the code at
    SLV, displacement at SLC; the most refined decides, or time histories where they are asked for.

    return_period : T_R [years]; ag : on rock [m/s2]
    checks : those that could be made, the most refined first
    check : label of the one that decides, or would; zeta : of it, None where none could be made
    zeta_target : required
    """

    state: str
    return_period: float
    ag: float
    check: str
    zeta: float | None
    zeta_target: float = 1.0
    checks: tuple[Check, ...] = ()

    @property
    def code(self) -> str:
        """verified, not_verified, or undetermined."""
        if self.zeta is None:
            return "undetermined"
        return "verified" if self.zeta >= self.zeta_target - ROUNDING else "not_verified"


def demands_of(case: Case, base_dir: Path) -> dict[str, DemandResult]:
    """The demand of each limit state; empty without the hazard, or V_N and C_U, or where a spectrum of NTC 2018 is
    asked and the hazard has no F_0 and T_C*; without the states whose return period lies outside its rows. Raises
    InputError."""
    asked = case.demand
    if asked is None or asked.spectrum_file or not (hazard := hazard_of(asked, base_dir)):
        return {}
    if None in (asked.nominal_life_years, asked.use_class_factor):
        return {}
    found = {}
    for state in STATES:
        years = return_period(asked.nominal_life_years * asked.use_class_factor, state)
        low, high = hazard[0].return_period_years, hazard[-1].return_period_years
        if not (1.0 - SAME_PERIOD) * low <= years <= (1.0 + SAME_PERIOD) * high:
            continue
        row = interpolated(hazard, years)
        spectrum = asked.spectrum
        if spectrum is not None and spectrum.code == "NTC2018":
            if row.f0 is None or row.tc_star_s is None:
                return {}
            spectrum = replace(spectrum, f0=row.f0, tc_star_s=row.tc_star_s)
        demand = replace(
            asked, limit_state=state, ag_g=row.ag_g, spectrum=spectrum, return_period_years=years
        )
        found[state] = demand_of(replace(case, demand=demand), base_dir)
    return found


def unsaid(demand: DemandResult | None, found: dict[str, DemandResult]) -> list[Sentence]:
    """Notices on limit states a hazard was given for, and that are not among those found."""
    if demand is None or not demand.hazard:
        return []
    if not found:
        return [notice("hazard_incomplete")]
    missing = [state for state in STATES if state not in found]
    return [notice("hazard_too_short", states=", ".join(missing))] if missing else []


def zetas(
    wall: Wall,
    mechanism: str,
    demands: dict[str, DemandResult],
    building: Building | None,
    histories: Callable[[str, DemandResult], Check | None] = lambda state, demand: None,
) -> tuple[StateZeta, ...]:
    """The wall at each limit state. histories : the dynamic check at a state, where it is asked for. Raises InputError
    where a spectrum ends too early."""
    found = []
    for state, demand in demands.items():
        floor = floor_of(wall, building, demand, []) if wall.above_ground else None
        made: list[Check | None] = []
        if floor is not None or not wall.above_ground:
            moved = kinematic(wall, mechanism, demand, floor.spectrum if floor else None)
            made = [histories(state, demand), nonlinear(moved, demand)]
            if state == "SLD":
                made.append(sld(moved, demand))
            elif state == "SLV":
                made.append(linear("linear_q_code", moved, demand, demand.q_code))
        checks = tuple(check for check in made if check is not None)
        label = checks[0].label if checks else "linear_sld" if state == "SLD" else "nonlinear"
        zeta = checks[0].zeta if checks else None
        years = demand.return_period or 0.0
        found.append(StateZeta(state, years, demand.ag, label, zeta, demand.zeta_target, checks))
    return tuple(found)
