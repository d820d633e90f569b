"""What the checks of a wall follow from."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from core.case.site import Demand
from core.ground.ground_motion import GroundMotion
from core.setting.check_input import rescale_records, select_polarities
from core.setting.demand_input import read_stated_demand

GROUND = np.sin(np.arange(10.0))


@pytest.mark.parametrize(("scaling", "factor"), [("as_given", 1.5), ("pga", 1.0)])
def test_that_records_used_as_given_follow_the_demand_and_those_scaled_to_it_need_not(scaling, factor):
    """0.3 g after 0.2 g: half as much again. What need not follow stays the same object, as `Scene` asks."""
    demand = read_stated_demand(Demand(ag_g=0.2, demand_scaling=scaling), Path())
    ground = [GroundMotion("m", GROUND, 0.01, "m.txt")]
    (found,) = rescale_records(ground, demand, replace(demand, pga=1.5 * demand.pga))
    assert found.acceleration.tolist() == pytest.approx((factor * GROUND).tolist(), rel=1e-15)
    assert (found is ground[0]) == (factor == 1.0)


@pytest.mark.parametrize("alike", [True, False])
@pytest.mark.parametrize(("asked", "signs"), [("as_recorded", (1,)), ("reversed", (-1,)), ("both", (1, -1))])
def test_that_a_record_runs_with_the_signs_asked_and_once_where_both_do_the_same(alike, asked, signs):
    assert select_polarities(SimpleNamespace(both_signs_alike=alike), asked) == ((1,) if alike else signs)
