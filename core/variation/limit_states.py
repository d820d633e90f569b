"""The demands of SLD, SLV and SLC of a site by its hazard, and a wall at each (NTC 2018, Annex A)."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.schema import Case
from core.codes.demand import SeismicDemand, complete_with_records
from core.codes.limits import return_period
from core.codes.record_compatibility import Compliance, check_compatibility
from core.codes.spectrum_codes import NATIONAL
from core.setting.check_input import CheckInput, rescale_records
from core.setting.demand_input import hazard_covers, interpolate_hazard, read_hazard_rows, read_stated_demand
from core.setting.plan import Plan
from core.text.sentence import Sentence, notice
from core.variation.assessment import Assessment, LimitStateCheck, assess

LIMIT_STATES = ("SLD", "SLV", "SLC")


def limit_state_demands(case: Case, base_dir: Path) -> dict[str, SeismicDemand]:
    """The demand of each limit state; empty without the hazard, or V_N and C_U, or where a spectrum of NTC 2018 is
    asked and the hazard has no F_0 and T_C*; without the states whose return period lies outside its rows. Raises
    InputError."""
    asked = case.demand
    if asked is None or asked.spectrum_file or not (hazard := read_hazard_rows(asked, base_dir)):
        return {}
    if asked.reference_period is None:
        return {}
    demands = {}
    for state in LIMIT_STATES:
        years = return_period(asked.reference_period, state)
        if not hazard_covers(hazard, years):
            continue
        row = interpolate_hazard(hazard, years)
        spectrum = asked.spectrum
        if spectrum is not None and spectrum.code == NATIONAL:
            if row.f0 is None or row.tc_star_s is None:
                return {}
            spectrum = replace(spectrum, f0=row.f0, tc_star_s=row.tc_star_s)
        there = replace(asked, limit_state=state, ag_g=row.ag_g, spectrum=spectrum, return_period_years=years)
        demands[state] = read_stated_demand(there, base_dir)
    return demands


def unused_hazard_notices(demand: SeismicDemand | None, demands: dict[str, SeismicDemand]) -> list[Sentence]:
    """Notices on limit states a hazard was given for, and that are not among those found."""
    if demand is None or not demand.hazard:
        return []
    if not demands:
        return [notice("hazard_incomplete")]
    missing = [state for state in LIMIT_STATES if state not in demands]
    return [notice("hazard_too_short", states=", ".join(missing))] if missing else []


def check_limit_states(
    scene: CheckInput,
    known: Assessment,
    demands: dict[str, SeismicDemand],
    rules: dict[str, Compliance | None],
    cancelled: Callable[[], bool] = lambda: False,
) -> tuple[LimitStateCheck, ...]:
    """The wall at each limit state; at that of the demand it is what is known of it there.

    demands : of `limit_state_demands`
    rules : whether the records comply with the spectrum of a state; of the states by histories alone
    Raises InputError where a spectrum ends too early, and Cancelled.
    """
    state_zetas = []
    for state, demand in demands.items():
        there = known
        if state != scene.demand.limit_state:
            there = assess(_at(scene, demand, rules), cancelled)
        verdict = there.verdict
        decides = next((check.label for check in there.checks if check.name == verdict.governing), None)
        label = decides or ("linear_sld" if state == "SLD" else "nonlinear")
        years, target = demand.return_period, demand.zeta_target
        assert years is not None
        state_zetas.append(
            LimitStateCheck(state, years, demand.ag, verdict.code, label, verdict.zeta_e, target, there.checks)
        )
    return tuple(state_zetas)


def _at(scene: CheckInput, demand: SeismicDemand, rules: dict[str, Compliance | None]) -> CheckInput:
    """The scene at the demand of another limit state; its records, where they are used as given, times the ratio of the
    peak accelerations, and none of a state that is not asked for by histories."""
    if demand.limit_state not in rules:
        return scene.replace_parts(demand=demand, ground=(), compliance=None, histories_off=False)
    ground = tuple(rescale_records(scene.ground, scene.demand, demand))
    return scene.replace_parts(
        demand=complete_with_records(demand, list(ground)), ground=ground, compliance=rules[demand.limit_state]
    )


def limit_state_compliance(
    plan: Plan, demand: SeismicDemand, demands: dict[str, SeismicDemand]
) -> dict[str, Compliance | None]:
    """Whether the records comply with the spectrum of each limit state that is asked for by histories."""
    asked = plan.case.demand.limit_states if plan.case.demand and plan.motions else ()
    rules = {}
    for state in asked:
        if state in demands and state != demand.limit_state and state in LIMIT_FRACTION:
            motions = list(rescale_records(plan.motions, demand, demands[state]))
            rules[state] = check_compatibility(motions, plan.kinds, demands[state], plan.longest_period)
    return rules
