"""The hinge that loads open inside a wall, and where it starts, by hand."""

import pytest

from core.errors import InputError
from core.wall.masonry import load_to_force
from core.wall.wall_loads import hinge_inside, largest_tie_share, start_moments, start_multiplier
from tests.validation.test_loaded_walls import PUSHING, ROOF, THRUST, TIE, case_of


def wall_of(*loads, **changes):
    """The wall of 3.0 x 0.45 m and 18 kN/m3, 24.3 kN/m."""
    return case_of(*loads, **changes).wall[0]


@pytest.mark.shows("ties.too_strong")
def test_that_the_largest_tie_is_where_the_resultant_of_a_section_leaves_the_wall():
    """At the multiplier lambda that uplifts the wall the moment of the part above y about the middle of the wall is
    lambda w t (H - y)^2 / 2 - F (h - y) - N (d - t/2), its weight w t (H - y) + N: beyond N' t/2 it hinges there."""
    strong = case_of(ROOF, {**TIE, "out_kn_m": 8.69}).wall[0]
    assert hinge_inside(strong.in_si) is None
    force, weight = 8.7, 24.3
    push = (weight * 0.225 + 10.0 * 0.30 + force * 2.8) / (weight * 1.5)
    worst = 0.0
    for k in range(1, 3000):
        y = 0.001 * k
        part = weight * (1.0 - y / 3.0)
        moment = 0.5 * push * part * (3.0 - y) - 10.0 * (0.30 - 0.225)
        if y < 2.8:
            moment -= force * (2.8 - y)
        worst = max(worst, abs(moment) / ((part + 10.0) * 0.225))
    assert worst == pytest.approx(1.0, abs=0.002)
    with pytest.raises(InputError) as caught:
        case_of(ROOF, {**TIE, "out_kn_m": 9.0, "slack_mm": 1.0})
    assert caught.value.values["most"] == pytest.approx(8.696, abs=0.01)
    assert largest_tie_share(strong.in_si) > 0.999


def test_that_the_strength_of_the_masonry_moves_hinge_and_largest_tie():
    """u = 2 N / (3 f) with the loads in N."""
    wall = case_of(ROOF, hinge_setback_m=0.0, compressive_strength_mpa=1.0).wall[0]
    assert wall.setback == pytest.approx(2.0 * 34.3e3 / 3e6, rel=1e-12)
    with pytest.raises(InputError) as caught:
        case_of(ROOF, {**TIE, "out_kn_m": 9.0, "slack_mm": 1.0}, compressive_strength_mpa=1.0)
    most, weight = caught.value.values["most"], 24.3
    assert most < 8.69
    # about the hinge u inside the edge; of each section u = 2 N / (3 f) inside its own
    u = wall.setback
    push = (weight * (0.225 - u) + 10.0 * (0.30 - u) + most * 2.8) / (weight * 1.5)
    worst = 0.0
    for y in (3.0 / 400 * k for k in range(1, 400)):
        part = weight * (1.0 - y / 3.0)
        moment = 0.5 * push * part * (3.0 - y) - 10.0 * (0.30 - 0.225)
        moment -= most * max(2.8 - y, 0.0)
        worst = max(worst, abs(moment) / ((part + 10.0) * (0.225 - 2.0 * (part + 10.0) / 3e3)))
    assert worst == pytest.approx(1.0, abs=1e-6)


@pytest.mark.shows("kinematic.loads")
def test_that_the_start_multiplier_is_holding_over_pushing_moments():
    wall = wall_of(PUSHING, TIE, THRUST).in_si
    held = (24.3e3 * 0.225, 10e3 * 0.30, -2e3 * 2.5, 5e3 * 2.8, 24.3e3 * 1.5, 10e3 * 3.0)
    assert start_moments(wall, 1.0) == pytest.approx(held, rel=1e-13)
    inner = (24.3e3 * 0.225, 10e3 * 0.15, 2e3 * 2.5, 0.0, 24.3e3 * 1.5, 10e3 * 3.0)
    assert start_moments(wall, -1.0) == pytest.approx(inner, rel=1e-13)
    forces = [load_to_force(load, wall, 1.0) for load in wall.loads]
    found = start_multiplier(24.3e3, 0.225, 1.5, forces, wall.masses)
    assert found == pytest.approx(sum(held[:4]) / sum(held[4:]), rel=1e-13)
