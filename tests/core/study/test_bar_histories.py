"""The ties of a wall over a history: force, elongation and energy."""

import numpy as np
import pytest

from core.case.hold import Hold
from core.case.wall import Wall
from core.rocking.bar_state import BROKEN, SLACK, TAUT, YIELDING
from core.rocking.history import integrate_history
from core.setting.check_input import make_rocking_model
from core.study.bar_histories import bar_histories, work_of_impacts
from core.units import G


def wall_of(*ties):
    return Wall(
        "w", "one_sided", height_m=7.0, thickness_m=0.83, unit_weight_kn_m3=18.0, velocity_ratio=0.5, hold=tuple(ties)
    )


def found_of(wall, amplitude, period=1.0, rest=6000):
    t = np.arange(round(3000 * period)) * 1e-3
    ground = np.append(amplitude * G * np.sin(2.0 * np.pi * t / period), np.zeros(rest))
    model = make_rocking_model(wall, "one_sided")
    return ground, model, integrate_history(ground, 1e-3, 1.0, model)


def test_that_a_bar_is_taut_yields_turns_back_and_is_slack():
    wall = wall_of(Hold("tie", h_m=6.5, out_kn_m=4.0, bar_length_m=8.0, elongation_m=0.6))
    _, _, found = found_of(wall, 0.25)
    (one,) = bar_histories(wall, found)
    assert set(one.phase) == {SLACK, TAUT, YIELDING}
    assert one.force.max() == pytest.approx(4e3) and one.elongation.max() == pytest.approx(0.18403, abs=2e-4)
    assert one.residual[-1] == pytest.approx(0.17486, abs=2e-4)
    taut = one.phase == TAUT
    assert np.allclose(one.force[taut], 4e3 / 9.171e-3 * (one.elongation - one.residual)[taut], rtol=1e-4, atol=0.1)
    assert (one.force[one.elongation < one.residual] == 0.0).all()
    # the work is the force over the elongation, by trapezoids
    by_sum = np.trapezoid(one.force, one.elongation)
    assert one.work == pytest.approx(4e3 * one.residual[-1], rel=1e-9) and by_sum == pytest.approx(one.work, rel=2e-3)


def test_that_what_the_ground_gives_is_what_bars_and_impacts_take():
    wall = wall_of(Hold("tie", h_m=6.5, out_kn_m=4.0, bar_length_m=8.0, elongation_m=0.6))
    ground, model, found = found_of(wall, 0.25)
    assert found.rotation[-1] < 1e-4
    inertia = 18e3 * 7.0 * 0.83 * wall.block().radius / model.p2
    pushed = inertia * model.p2 / G * ground[: found.rotation.size] * np.cos(model.slenderness - found.rotation)
    given = np.trapezoid(pushed * found.velocity, dx=1e-3)
    (one,) = bar_histories(wall, found)
    lost = work_of_impacts(wall, model, found)
    assert one.work + lost == pytest.approx(given, rel=2e-3) and lost > one.work > 0.0


def test_that_a_broken_bar_has_taken_what_it_could():
    wall = wall_of(Hold("tie", h_m=6.5, out_kn_m=8.0, bar_length_m=8.0, elongation_m=0.30))
    _, _, found = found_of(wall, 0.30, 1.5)
    (one,) = bar_histories(wall, found)
    assert one.phase[-1] == BROKEN and one.force[-1] == 0.0 and np.isnan(one.residual[-1])
    at_yield = one.bar.elongation_at_yield
    assert one.work == pytest.approx(8e3 * (0.30 - at_yield) + 4e3 * at_yield, rel=1e-12)


def test_that_a_wall_without_ties_has_none_and_no_energy_is_named_that_is_not_known():
    wall = wall_of()
    _, model, found = found_of(wall, 0.25)
    assert bar_histories(wall, found) == []
    assert work_of_impacts(wall, model._replace(ratio_drop=0.1), found) is None
