"""The demands of SLD, SLV and SLC of a site by its hazard, and zeta of a wall at each (NTC 2018, Annex A)."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from core.case.schema import Case, Wall
from core.case.site import Building
from core.codes.demand import DemandResult
from core.codes.dynamic_check import DemandCheck
from core.codes.kinematic import Check, checks_of, kinematic
from core.codes.limits import return_period
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import Method
from core.study.demand_input import demand_of, hazard_of, interpolated, within
from core.study.floors import floor_of
from core.text.sentence import Sentence, notice
from core.wall.rocking_model import RockingModel

STATES = ("SLD", "SLV", "SLC")


@dataclass(frozen=True)
class StateZeta:
    """A wall at one limit state, by its kinematic checks: linear at SLD, displacement and linear with q of the code at
    SLV, displacement at SLC; the most refined decides, or time histories where they are asked for.

    return_period : T_R [years]; ag : on rock [m/s2]
    checks : those that could be made, the most refined first
    check : label of the one that decides, or would; zeta : of it, None where none could be made
    zeta_target : required; within_spread : the rule of histories holds there, and their spread contains it
    """

    state: str
    return_period: float
    ag: float
    check: str
    zeta: float | None
    zeta_target: float = 1.0
    checks: tuple[Check, ...] = ()
    within_spread: bool = False

    @property
    def code(self) -> str:
        """Of the table of outcomes: what the check that decides says."""
        if self.zeta is None:
            return "undetermined"
        if self.within_spread:
            return "at_limit"
        return "verified" if self.checks[0].passed else "not_verified"


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
        if not within(hazard, years):
            continue
        row = interpolated(hazard, years)
        spectrum = asked.spectrum
        if spectrum is not None and spectrum.code == "NTC2018":
            if row.f0 is None or row.tc_star_s is None:
                return {}
            spectrum = replace(spectrum, f0=row.f0, tc_star_s=row.tc_star_s)
        demand = replace(asked, limit_state=state, ag_g=row.ag_g, spectrum=spectrum, return_period_years=years)
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


@dataclass(frozen=True)
class StateHistories:
    """The dynamic check of a wall at the demand of another limit state.

    model, motions, polarities, method : as at the demand of the case, whose motions are taken times the ratio of the
        peak accelerations where they are used as given
    check : `demand_check`, or one that keeps its results
    """

    model: RockingModel
    motions: list[GroundMotion]
    polarities: tuple[int, ...]
    demand: DemandResult
    method: Method
    check: Callable
    cancelled: Callable[[], bool] = lambda: False

    def __call__(self, demand: DemandResult) -> DemandCheck | None:
        """None where the demand is that of the case, at SLD, and without records. Raises Cancelled."""
        if demand.limit_state == self.demand.limit_state or not self.motions:
            return None
        factor = demand.pga / self.demand.pga if demand.record_scaling == "as_given" else 1.0
        scaled = [replace(motion, acceleration=factor * motion.acceleration) for motion in self.motions]
        return self.check(self.model, scaled, self.polarities, demand, self.method, 1, False, self.cancelled)


def zetas(
    wall: Wall,
    mechanism: str,
    demands: dict[str, DemandResult],
    building: Building | None,
    histories: Callable[[DemandResult], DemandCheck | None] = lambda demand: None,
    asked: tuple[str, ...] = (),
) -> tuple[StateZeta, ...]:
    """The wall at each limit state. histories : the dynamic check at a demand, made at the states asked. Raises
    InputError where a spectrum ends too early, and Cancelled."""
    found = []
    for state, demand in demands.items():
        floor = floor_of(wall, building, demand, []) if wall.above_ground else None
        checks: tuple[Check, ...] = ()
        dynamic = None
        if floor is not None or not wall.above_ground:
            moved = kinematic(wall, mechanism, demand, floor.spectrum if floor else None)
            dynamic = histories(demand) if state in asked else None
            checks = ((dynamic.as_check(),) if dynamic else ()) + checks_of(moved, demand)
        label = checks[0].label if checks else "linear_sld" if state == "SLD" else "nonlinear"
        zeta = checks[0].zeta if checks else None
        years = demand.return_period or 0.0
        limit = dynamic is not None and dynamic.within_spread(demand.zeta_target)
        found.append(StateZeta(state, years, demand.ag, label, zeta, demand.zeta_target, checks, limit))
    return tuple(found)
