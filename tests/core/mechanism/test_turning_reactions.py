"""What a wall that turns hands to its tie and to what stands behind it: worked values and an own integration."""

import math

import numpy as np
import pytest

from core.case.held_stretches import find_held_stretches
from core.case.rules import parse_case
from core.mechanism.sections import Sections
from core.mechanism.turning_reactions import force_behind, impulse_behind, largest_forces, speed_before, tie_forces
from core.rocking.history import integrate_history
from core.setting.check_input import make_rocking_model
from core.study.run import run
from core.units import G
from tests.conftest import ROOT

TURNING = {"name": "w", "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.45, "unit_weight_kn_m3": 18.0}
TURNING |= {"base_z_m": 0.0, "length_m": 5.0, "hinge_setback_m": 0.0, "unloaded_confirmed": True}
BEHIND = {"kind": "contact", "to_m": 3.0, "evidence": {"kind": "survey", "reference": "tav. 1"}}
TIE = {"kind": "tie", "h_m": 2.8, "out_kn_m": 6.0, "bar_length_m": 8.0, "elongation_m": 0.05}


def wall_of(*holds, **keys):
    return parse_case({"wall": [TURNING | keys | {"hold": [BEHIND, *holds]}]}).wall[0]


def test_that_a_tie_takes_the_worked_force_at_rest_and_along_a_pulse():
    """Worked value 17: 1.952679 kN/m static under 0.3 g, 3.504 along one cycle of 0.6 s (formula 3.50156)."""
    wall = wall_of(TIE, velocity_ratio=0.5)
    own = wall.in_si
    assert tie_forces(Sections(own), own.ties, 0.3) == pytest.approx([1952.679], rel=1e-6)
    assert own.ties[0].bar.elongation_at_yield == pytest.approx(9.171e-3, abs=1e-6)
    time = np.arange(0.0, 3.0, 1e-3)
    ground = 0.3 * G * np.sin(2.0 * math.pi * time / 0.6) * (time < 0.6)
    history = integrate_history(ground, 1e-3, 1.0, make_rocking_model(wall, "one_sided"))
    bars = tuple(tie.bar for tie in own.ties)
    assert largest_forces(bars, history) == pytest.approx([3504.0], abs=0.5)
    theta = float(history.rotation.max())
    assert largest_forces(bars, history) == pytest.approx([bars[0].force_at(theta)], rel=1e-3)


def test_that_a_brittle_tie_is_asked_for_twice_and_several_as_they_are_stretched():
    brittle = wall_of({key: value for key, value in TIE.items() if key != "elongation_m"}).in_si
    assert tie_forces(Sections(brittle), brittle.ties, 0.3) == pytest.approx([2.0 * 1952.679], rel=1e-6)
    assert tie_forces(Sections(brittle), brittle.ties, 9.0) == [6000.0]
    both = wall_of(TIE, TIE | {"h_m": 1.4}).in_si
    high, low = tie_forces(Sections(both), both.ties, 0.3)
    assert high == pytest.approx(2.0 * low) and 2.8 * high + 1.4 * low == pytest.approx(2.8 * 1952.679, rel=1e-6)


def test_that_a_wall_that_comes_back_hits_what_stands_behind_with_the_worked_impulse():
    """Worked value 16: at most 596.485 N s/m for e 0.436673 and omega 0.163867."""
    own = wall_of().in_si
    inertia = own.moment_of_weight / own.block.p2
    assert inertia == pytest.approx(18e3 * 1.35 / G * (3.0**2 + 0.45**2) / 3.0, rel=1e-12)
    assert impulse_behind(inertia, 0.163867, 0.436673, 3.0) == pytest.approx(596.485, rel=1e-5)
    assert force_behind(Sections(own), 3.0, 0.2) == pytest.approx(0.2 * 24.3e3 / 2.0)


@pytest.mark.parametrize("kept", [0.5, 1e-9])
def test_that_the_speed_before_an_impact_is_that_of_the_motion(kept):
    model = make_rocking_model(wall_of(velocity_ratio=max(kept, 0.01)), "one_sided")
    time = np.arange(0.0, 3.0, 1e-3)
    history = integrate_history(0.3 * G * np.sin(2.0 * math.pi * time / 0.6) * (time < 0.6), 1e-3, 1.0, model)
    first = int(history.impact_time[0] / 1e-3)
    assert speed_before(history, model.ratio_at_rest) >= 0.99 * abs(history.velocity[first])


@pytest.mark.shows("held.reaction")
def test_that_reactions_of_a_turning_wall_are_in_its_results():
    demand = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}
    table = {"demand": demand, "generate": {"count": 3, "scatter": 0.0}}
    wall = TURNING | {"hold": [BEHIND, TIE]}
    found = run(parse_case(table | {"wall": [wall]}), base_dir=ROOT).walls[0].assessment.reactions
    rows = {(row.hold, row.check): row for row in found}
    assert set(rows) == {(hold, check) for hold in ("tie", "behind") for check in ("kinematic", "dynamic")}
    assert rows["behind", "dynamic"].impulse > 0.0 and rows["behind", "dynamic"].stands is None
    assert 0.0 <= rows["tie", "dynamic"].at_demand <= rows["tie", "dynamic"].stands == 6000.0


def test_that_what_rocks_above_a_hold_hands_it_the_worked_force():
    """Worked value 19: a parapet of 1.0 x 0.3 m, alpha 0.4: T 1.788440 and M 0.81; no more than its inertia."""
    keys = {"height_m": 4.0, "thickness_m": 0.3}
    wall = wall_of({"kind": "floor", "h_m": 3.0, "out_kn_m": 20.0}, **keys)
    above = find_held_stretches(wall)[-1].wall.in_si.declared.above
    shear = above.weight * above.multiplier + above.growth * (0.4 - above.multiplier)
    moment = above.weight * above.multiplier * 0.5
    assert shear == pytest.approx(1788.440, rel=1e-6) and moment == pytest.approx(810.0, rel=1e-9)
    assert above.force(0.4) == pytest.approx(shear + moment / 3.0, rel=1e-9)
    assert above.force(0.2) == pytest.approx(0.2 * 5400.0 * (1.0 + 0.5 / 3.0))
    assert all(above.force(alpha) <= above.lever * above.weight * alpha * (1 + 1e-12) for alpha in (0.1, 0.3, 0.5, 3.0))
