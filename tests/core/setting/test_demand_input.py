"""The demand of a case beside the hazard of its site, and which set of motions was generated."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.schema import Generate
from core.case.site import Demand, HazardRow, Spectrum
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.setting.demand_input import check_hazard, find_generation_settings, hazard_covers, read_target_spectrum
from core.units import G

ROWS = HazardRow(30.0, 0.05, 2.4, 0.28), HazardRow(475.0, 0.2, 2.5, 0.33), HazardRow(2475.0, 0.35, 2.6, 0.36)
NTC = Spectrum("NTC2018", "B", f0=2.5, tc_star_s=0.33, topography="T1")


@pytest.mark.parametrize(
    ("years", "held"),
    [(29.6, False), (29.8, True), (30.0, True), (2475.0, True), (2499.0, True), (2501.0, False), (2600.0, False)],
)
def test_that_a_hazard_holds_the_return_periods_of_its_rows_and_one_percent_beyond(years, held):
    assert hazard_covers(ROWS, years) == held


@pytest.mark.shows("risk.hazard_agrees")
@pytest.mark.parametrize(
    ("key", "given", "agrees"),
    [
        # half a unit of the last decimal of both and half a percent: 0.005 + 0.005 + 0.001 of a_g
        ("ag_g", 0.21, True),
        ("ag_g", 0.22, False),
        ("ag_g", 0.18, False),
        # of F_0 0.005 + 0.005 + 0.0125
        ("f0", 2.52, True),
        ("f0", 2.53, False),
        ("f0", 2.47, False),
    ],
)
def test_that_a_demand_is_that_of_its_hazard_by_the_digits_of_both_and_half_a_percent(key, given, agrees):
    asked = Demand(ag_g=0.2, return_period_years=475.0, spectrum=NTC)
    asked = replace(asked, ag_g=given) if key == "ag_g" else replace(asked, spectrum=replace(NTC, f0=given))
    if agrees:
        check_hazard(asked, ROWS)
        return
    with pytest.raises(InputError) as refused:
        check_hazard(asked, ROWS)
    assert refused.value.code == "hazard_disagrees"
    told = {name: refused.value.values[name] for name in ("given", "years")}
    assert (refused.value.key, told) == (key, {"given": given, "years": 475.0})


@pytest.mark.parametrize("missing", ["f0", "tc_star_s", "topography"])
def test_that_a_spectrum_in_the_making_is_none_yet(missing):
    target = read_target_spectrum(Demand(ag_g=0.2, spectrum=NTC), Path())
    assert target is not None and target.ag == pytest.approx(0.2 * G)
    with pytest.raises(KeyError):
        read_target_spectrum(Demand(ag_g=0.2, spectrum=replace(NTC, **{missing: None})), Path())


def motion(**details: str) -> GroundMotion:
    known = tuple(details.items())
    return GroundMotion(
        "m", np.sin(np.arange(10.0)), 0.01, "m.txt", format="generated" if details else "plain text", details=known
    )


def test_that_a_set_of_motions_tells_what_was_asked_for_to_make_it():
    made = [motion(seed=str(seed), scatter="0.4") for seed in (8, 7, 9)]
    assert find_generation_settings(made) == Generate(3, 7, 0.4)
    assert find_generation_settings(made[:1]) == Generate(1, 8, 0.4)
    assert find_generation_settings([motion(), *made]) == Generate(
        3, 7, 0.4
    )  # a record beside them does not hide how they were made


@pytest.mark.parametrize(
    "motions", [[], [motion()], [motion(seed="1", scatter="0.4"), motion(seed="1", scatter="0")], [motion(seed="1")]]
)
def test_that_records_and_two_sets_are_no_generated_set(motions):
    assert find_generation_settings(motions) is None
