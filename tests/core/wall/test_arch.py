"""The wall that spans as a flat arch between transverse walls, against geometry and virtual work of its own."""

import math

import numpy as np
import pytest

from core.codes.vertical_bending import mechanism
from core.wall.arch import CRUSHING, SHOULDER, TIE, Along, arch_of, parted_at, parted_flat, thrust_of_shoulder
from core.wall.bending import Strip


def strip(thrust, thickness, spacing, weight, setback=0.0, **more):
    """thrust [kN/m], sizes [m], weight [kN/m3]"""
    of_wall = 1e3 * weight * thickness * spacing
    return Strip(spacing, thickness, setback, of_wall, ((1e3 * thrust, setback),), lies=True, **more)


def places(first, second, width, turn):
    """Hinge between (x outward, z) and parting of the ends, the first half turned by this angle: distances alone."""
    radius, start = math.hypot(first, width), math.atan2(first, -width)
    x, z = radius * math.cos(start - turn), radius * math.sin(start - turn)
    return x, z, z + math.sqrt(second**2 + width**2 - x**2) - (first + second)


def by_virtual_work(thrust, weight, thickness, setback, first, second, turn, step=1e-6):
    """alpha by differences of the parting of the ends and of the ways of both centroids, each found from three points
    of its half: nothing of the program is used."""
    width, total = thickness - 2.0 * setback, weight * thickness * (first + second)

    def state(angle):
        x, z, parted = places(first, second, width, angle)
        far = first + second + parted

        def moved(one, other, at_one, at_other, local):  # x outward of a point fixed to two others
            along = np.subtract(at_other, at_one) / np.linalg.norm(np.subtract(other, one))
            across = np.array([-along[1], along[0]])
            unit = np.subtract(other, one) / np.linalg.norm(np.subtract(other, one))
            normal = np.array([-unit[1], unit[0]])
            from_one = np.subtract(local, one)
            return float(at_one[0] + (from_one @ unit) * along[0] + (from_one @ normal) * across[0])

        start, between, end = (0.0, 0.0), (-width, first), (0.0, first + second)
        middle = setback - 0.5 * thickness  # of the wall, outward of the hinges at the outer face
        now = (x, z)
        one = moved(start, between, start, now, (middle, 0.5 * first))
        two = moved(between, end, now, (0.0, far), (middle, first + 0.5 * second))
        return parted, (first * one + second * two) / (first + second)

    (parted1, way1), (parted2, way2) = state(turn - step), state(turn + step)
    return thrust * (parted2 - parted1) / (total * (way2 - way1))


@pytest.mark.shows("arch.mechanism")
@pytest.mark.parametrize("walls", [100, pytest.param(1000, marks=pytest.mark.long)])
def test_that_alpha_is_that_of_virtual_work_from_coordinates_at_every_displacement(walls):
    draw = np.random.default_rng(29)
    for _ in range(walls):
        t, spacing = draw.uniform(0.2, 0.9), draw.uniform(3.0, 9.0)
        thrust, weight, setback = draw.uniform(5.0, 80.0), draw.uniform(13.0, 22.0), draw.uniform(0.0, 0.15) * t
        h1 = spacing * draw.uniform(0.25, 0.75)
        own = mechanism(strip(thrust, t, spacing, weight, setback), h1)
        width = t - 2.0 * setback
        closed = 2.0 * thrust * width * (1.0 / h1 + 1.0 / (spacing - h1)) / (weight * t * spacing)
        assert own.alpha0 == pytest.approx(closed, rel=1e-12) and own.e_star == pytest.approx(1.0, rel=1e-12)
        for share in (0.2, 0.4, 0.7):
            d = share * own.d0
            there = by_virtual_work(thrust, weight, t, setback, h1, spacing - h1, own.rotation(d))
            assert own.alpha(d) == pytest.approx(there, rel=2e-7)
        parted = places(h1, spacing - h1, width, own.rotation(0.4 * own.d0))[2]
        assert own.parted(own.rotation(0.4 * own.d0)) == pytest.approx(parted, abs=1e-12)


@pytest.mark.shows("arch.mechanism")
def test_that_the_hinge_in_the_middle_is_the_weakest_and_alpha_lies_below_the_straight_line():
    for thrust, t, spacing, weight in ((30.0, 0.45, 5.0, 18.0), (20.0, 0.30, 4.0, 18.0), (60.0, 0.60, 8.0, 20.0)):
        one = strip(thrust, t, spacing, weight)
        own = mechanism(one)
        others = [mechanism(one, spacing * share).alpha0 for share in (0.3, 0.45, 0.55, 0.7)]
        assert own.alpha0 < min(others) and own.h1 == 0.5 * spacing
        assert own.alpha0 == pytest.approx(8.0 * thrust / (weight * spacing**2), rel=1e-12)
        assert own.d_c0 == pytest.approx(t, rel=1e-9) and own.d0 == pytest.approx(0.5 * t, rel=1e-9)
        below = 100.0 * (1.0 - own.alpha(0.4 * own.d0) / (0.6 * own.alpha0))
        assert 0.7 <= round(below, 1) <= 1.0  # [%]: the straight line is not on the safe side
        assert own.parted(own.theta0) == pytest.approx(parted_flat(spacing, t), rel=1e-9)


def test_that_what_presses_the_wall_outward_lowers_alpha_by_its_share_of_the_weight():
    bare = mechanism(strip(30.0, 0.45, 5.0, 18.0))
    pressed = mechanism(strip(30.0, 0.45, 5.0, 18.0, pressed=0.1))
    assert pressed.alpha0 == pytest.approx(bare.alpha0 - 0.1, rel=1e-12) and pressed.d0 < bare.d0
    for d in (0.02, 0.1):
        assert pressed.alpha(d) == pytest.approx(bare.alpha(d) - 0.1, rel=1e-9)
    assert pressed.alpha(pressed.d0) == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(ValueError, match="-0"):
        mechanism(strip(30.0, 0.45, 5.0, 18.0, pressed=0.54))


@pytest.mark.shows("arch.mechanism")
def test_that_a_tie_ends_the_displacement_where_the_ends_have_parted_by_what_it_stands():
    free = mechanism(strip(30.0, 0.45, 5.0, 18.0))
    assert math.isinf(free.breaks_at)
    for stands in (0.005, 0.03, 0.06):
        tied = mechanism(strip(30.0, 0.45, 5.0, 18.0, stands=stands))
        assert tied.parted(tied.rotation(tied.breaks_at)) == pytest.approx(stands, rel=1e-9)
    assert math.isinf(mechanism(strip(30.0, 0.45, 5.0, 18.0, stands=0.0811)).breaks_at)  # flat it has parted by less


def test_that_masonry_beyond_takes_what_overturns_it_leaning_or_makes_it_slide():
    """1.2 x 0.45 m, 3.5 m high: 3.333 kN/m upright; 4 m long it slides first."""
    assert thrust_of_shoulder(1.2, 0.45, 3.5, 18e3, 0.0) == pytest.approx(18e3 * 0.45 * 1.44 / 3.5, rel=1e-12)
    leaning = thrust_of_shoulder(1.2, 0.45, 3.5, 18e3, 0.12)
    assert leaning == pytest.approx(0.8 * 18e3 * 0.45 * 1.44 / 3.5, rel=1e-12)
    assert thrust_of_shoulder(4.0, 0.45, 3.5, 18e3, 0.0) == pytest.approx(0.4 * 18e3 * 0.45 * 4.0, rel=1e-12)
    assert thrust_of_shoulder(0.1, 0.45, 3.5, 18e3, 0.06) == 0.0


@pytest.mark.shows("arch.thrust")
def test_that_more_of_anything_that_holds_gives_no_smaller_moment_of_the_thrust():
    draw = np.random.default_rng(3)
    for _ in range(300):
        t, f = draw.uniform(0.2, 0.8), draw.uniform(0.3, 4.0) * 1e6
        tie = Along(draw.uniform(1.0, 900.0) * 1e3, draw.uniform(0.002, 0.08), 0.1, 1.0)
        beyond, presses = draw.uniform(0.0, 300.0) * 1e3, draw.uniform(0.0, 5.0) * 1e3

        def moment(strength=f, tie=tie, beyond=beyond, t=t, presses=presses):
            one = arch_of(5.0, t, strength, tie, beyond, presses)
            assert 0.0 <= one.setback <= 0.25 * t * (1.0 + 1e-12)
            return one.thrust * (t - 2.0 * one.setback)

        base = moment()
        slack = base * (1.0 - 1e-12)
        assert moment(strength=1.1 * f) >= slack
        assert moment(tie=tie._replace(force=1.1 * tie.force)) >= slack
        assert moment(tie=tie._replace(at_yield=0.9 * tie.at_yield)) >= slack
        assert moment(beyond=1.1 * beyond) >= slack
        assert moment(tie=None) <= base * (1.0 + 1e-12) and moment(beyond=None) <= base * (1.0 + 1e-12)
    short = Along(1e4, 0.005, 0.1, 1.0)
    assert arch_of(5.0, 0.4, 1e6, short, None).by == TIE and arch_of(5.0, 0.4, 1e6, short, None).tied
    assert arch_of(5.0, 0.4, 1e6, short, 2e4).by == SHOULDER and not arch_of(5.0, 0.4, 1e6, short, 2e4).tied
    assert arch_of(5.0, 0.4, 1e6, short._replace(force=1e6), 2e4).by == CRUSHING


@pytest.mark.shows("arch.thrust")
def test_that_a_tie_pulls_as_far_as_the_ends_have_parted_and_each_bay_takes_its_share_of_the_bar():
    """5 m, hinges 0.225 m apart: at 0.40 of the way the ends part by 13 mm; a bar that yields at 26 mm pulls half."""
    assert parted_at(5.0, 0.45, 0.4 * 0.45) == pytest.approx(2.0 * (math.sqrt(6.25 + 0.45**2 - 0.27**2) - 2.5))
    at_limit = parted_at(5.0, 0.225, 0.4 * 0.225)
    assert at_limit == pytest.approx(0.0129, abs=1e-4)
    strong = 1e12  # no setback
    whole, half = (arch_of(5.0, 0.45, strong, Along(3e4, at_limit * k, 1.0, 1.0), None) for k in (1.0, 2.0))
    assert whole.thrust == pytest.approx(3e4, rel=1e-6) and half.thrust == pytest.approx(1.5e4, rel=1e-6)
    assert arch_of(5.0, 0.45, strong, Along(3e4, 0.01, 0.09, 3.0), None).stands == pytest.approx(0.03)
    assert whole.without_tie.thrust == 1.0  # nothing holds the wall before its ends part
    both = arch_of(5.0, 0.45, strong, Along(3e4, 0.01, 0.09, 1.0), 2e4)
    assert both.tied and both.without_tie.thrust == 2e4
    pressed = arch_of(5.0, 0.45, strong, Along(3e4, at_limit, 1.0, 1.0), None, presses=1e4)
    assert pressed.thrust < whole.thrust  # its hinges lie in line earlier, so that d_SLV is less


def test_that_masonry_beyond_pushed_along_the_wall_holds_less_until_a_tie_or_nothing_is_left():
    """H_s - 0.3 alpha W_s, no more than crushes the hinges; under no push it is the arch as it is."""
    rng = np.random.default_rng(12)
    for _ in range(200):
        beyond, at_rest, pull = (float(value) for value in rng.uniform((5e3, 2e3, 0.0), (4e4, 2e4, 1.5e4)))
        tie = Along(pull, 1e-9, 0.05, 1.0) if rng.random() < 0.5 else None
        arch = arch_of(4.0, 0.45, float(rng.uniform(2e5, 4e6)), tie, at_rest, beyond=beyond)
        assert arch.under(0.0) == arch
        thrusts = []
        for alpha in (0.05, 0.1, 0.2, 0.4, 0.8, 3.0):
            left = arch.under(alpha)
            shoulder = max(0.0, at_rest - 0.3 * alpha * beyond)
            assert left.shoulder == pytest.approx(min(shoulder, arch.most)) and left.pushed == alpha
            assert left.thrust == pytest.approx(min(max(shoulder, pull if tie else 0.0, 1.0), arch.most), rel=1e-6)
            assert left.tied == (left.pull > left.shoulder) and left.without_tie.thrust <= left.thrust + 1e-9
            thrusts.append(left.thrust)
        assert thrusts == sorted(thrusts, reverse=True)
