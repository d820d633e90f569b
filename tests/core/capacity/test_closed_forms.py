"""Eq. 9 and 12 to 16, the power law, restitution, block: values by hand and ranges."""

import math

import numpy as np
import pytest

from core.capacity import closed_forms
from core.codes.eq9 import inequality
from core.errors import InputError
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import overturning_velocity, restitution
from core.wall.rocking_model import rocking_model

WALL = Block.rectangle(7.0, math.radians(6.8))


def test_that_eq_15_gives_the_q_eff_of_el_centro():
    """(30 x 6.8 + 78 x 7 + 90) / 124.27 = 6.76: q_eff, not q, against the print."""
    q_eff = closed_forms.closed_form_q_eff(WALL.slenderness, WALL.height, 1.2427, False)
    assert q_eff == pytest.approx(840.0 / 124.27, rel=1e-12)
    assert round(q_eff, 2) == 6.76
    q = closed_forms.closed_form_q(WALL.slenderness, WALL.height, 1.2427, 0.319 * G, False)
    assert q == pytest.approx(6.7595 * 0.319, rel=1e-4)


def test_that_eq_16_is_the_one_sided_form():
    q_eff = closed_forms.closed_form_q_eff(WALL.slenderness, WALL.height, 1.0, True)
    assert q_eff == pytest.approx((23 * 6.8 + 65 * 7 + 840) * 100.0**-0.9, rel=1e-12)


def test_that_q_eff_is_eq_12():
    assert closed_forms.effective_q(2.336, 0.3188 * G) == pytest.approx(2.336 / 0.3188)


def test_that_a_power_law_is_found_back():
    si = np.array([0.2, 0.5, 0.9, 1.4])
    fit = closed_forms.fit_power_law(list(si), list(321.0 * (100 * si) ** -0.93))
    assert fit.c1 == pytest.approx(321.0, rel=1e-12)
    assert fit.c2 == pytest.approx(-0.93, rel=1e-12)
    assert fit.r_squared == pytest.approx(1.0)
    assert fit.si_range_cm == pytest.approx((20.0, 140.0))
    assert fit.q_eff(0.5) == pytest.approx(321.0 * 50.0**-0.93)


def test_that_a_power_law_is_scipys_regression():
    from scipy.stats import linregress

    rng = np.random.default_rng(4)
    si, q_eff = rng.uniform(0.1, 2.0, 9), rng.uniform(2.0, 30.0, 9)
    fit = closed_forms.fit_power_law(list(si), list(q_eff))
    line = linregress(np.log(100 * si), np.log(q_eff))
    assert fit.c2 == pytest.approx(line.slope, rel=1e-10)
    assert fit.c1 == pytest.approx(math.exp(line.intercept), rel=1e-10)
    assert fit.r_squared == pytest.approx(line.rvalue**2, rel=1e-9)


@pytest.mark.parametrize("si", [[], [1.0, 2.0], [1.0, 1.0, 1.0]])
def test_that_a_power_law_needs_three_points_and_a_spread(si):
    assert closed_forms.fit_power_law(si, [5.0] * len(si)) is None


def test_that_leaving_the_fitted_range_is_said():
    inside = closed_forms.range_notices(math.radians(6.8), 7.0, [("a", 0.2 * G)])
    assert inside == []
    for edge in ((3.1, 3.0, 0.106), (11.3, 11.0, 0.312)):
        alpha, height, pga = edge
        assert not closed_forms.range_notices(math.radians(alpha), height, [("a", pga * G)])
    codes = [
        entry.code
        for entry in closed_forms.range_notices(math.radians(15), 2.0, [("a", G), ("b", 0.2 * G)])
    ]
    assert codes == ["eq15_slenderness", "eq15_height", "eq15_pga"]


def test_that_eq_9_by_hand_fails_with_q_2_for_the_wall_of_the_example():
    """7.0 x 0.83 m, a_g 0.26 g, S 1.2, q 2: 0.1186 g against 0.156 g, ratio 0.76."""
    block = Block.rectangle(7.0, math.atan2(0.83, 7.0))
    check = inequality("code", 2.0, block.threshold_acceleration, 0.26 * 1.2 * G)
    assert check.capacity == pytest.approx(0.83 / 7.0 * G)
    assert check.demand == pytest.approx(0.156 * G)
    assert round(check.ratio, 2) == 0.76
    assert not check.passed
    assert inequality("code", 4.0, block.threshold_acceleration, 0.26 * 1.2 * G).passed


def test_that_exact_equality_passes_whatever_the_rounding():
    """t/H = 0.1, a_g 0.2, q 2: the ratio is 1 and rounds to 0.9999999999999999."""
    block = Block.rectangle(3.0, math.atan2(0.30, 3.0))
    check = inequality("code", 2.0, block.threshold_acceleration, 0.2 * G)
    assert check.ratio == pytest.approx(1.0, abs=1e-15)
    assert check.passed


def test_that_the_overturning_velocity_has_the_root_the_print_lacks():
    """6.8 deg, 7 m: 0.1713 rad/s; as printed it would be 0.0294 in 1/s2."""
    assert overturning_velocity(WALL) == pytest.approx(0.1713, abs=5e-5)
    assert overturning_velocity(WALL) ** 2 == pytest.approx(0.0294, abs=5e-5)
    # by energy: the speed at theta = 0 that just reaches the barrier
    kinetic = 0.5 * overturning_velocity(WALL) ** 2
    assert kinetic == pytest.approx(WALL.p2 * (1 - math.cos(WALL.slenderness)))


def test_that_restitution_models_are_their_equations():
    sine2 = math.sin(WALL.slenderness) ** 2
    cosine2 = math.cos(WALL.slenderness) ** 2
    eq4 = 1 - 1.5 * sine2
    eq6 = eq4**2 * abs(1 - 1.5 * cosine2)
    assert restitution(WALL, "housner").ratio_at_rest == pytest.approx(eq4, rel=1e-15)
    assert restitution(WALL, "housner").ratio_at_rest == pytest.approx(0.9789708, abs=5e-8)
    assert restitution(WALL, "costa_upper").ratio_at_rest == 0.98
    one = restitution(WALL, "one_sided_theoretical")
    assert one.ratio_at_rest == pytest.approx(eq6, rel=1e-14)
    assert 1 - 1.5 * cosine2 < 0.0, "the bracket of Eq. 6 is the reversal"
    experimental = restitution(WALL, "one_sided_experimental")
    speed = 0.7 * overturning_velocity(WALL)
    ratio = experimental.ratio_at_rest - experimental.ratio_drop * speed**2
    assert ratio == pytest.approx(eq6 * (1.18 - 0.473 * 0.7**2), rel=1e-12)


def test_that_eq_7_is_held_at_zero_and_counted():
    from core.wall.restitution import velocity_ratio

    one = restitution(WALL, "one_sided_experimental")
    model = rocking_model(WALL, True, one, LAWS["rigid"])
    limit = 1.579 * overturning_velocity(WALL)
    assert velocity_ratio(0.999 * limit, model)[0] > 0.0
    assert velocity_ratio(1.001 * limit, model) == (0.0, 1)


@pytest.mark.parametrize(
    "model, ratio", [("user", None), ("user", 1.5), ("user", -0.1), ("user", math.nan), ("x", None)]
)
def test_that_a_restitution_outside_its_range_is_refused(model, ratio):
    with pytest.raises(InputError, match="velocity_ratio"):
        restitution(WALL, model, ratio)


def test_that_a_block_too_stocky_for_eq_4_is_refused():
    with pytest.raises(InputError, match="too stocky"):
        restitution(Block.rectangle(1.0, math.radians(56.0)), "housner")


def test_that_a_general_block_follows_the_general_equations():
    block = Block(math.radians(8.0), 2.0, 6.0)
    assert block.p2 == pytest.approx(G * 2.0 / 6.0)
    assert not block.is_rectangle
    eq4 = 1 - 2 * 4.0 / 6.0 * math.sin(block.slenderness) ** 2
    assert restitution(block, "housner").ratio_at_rest == pytest.approx(eq4)
    assert block.height == pytest.approx(2 * 0.75 * G / block.p2 * math.cos(block.slenderness))
    same = Block(WALL.slenderness, WALL.radius, 4.0 / 3.0 * WALL.radius**2)
    assert same.p2 == pytest.approx(3 * G / (4 * WALL.radius))
    assert same.height == pytest.approx(7.0)


def test_that_eq_7_cannot_create_energy():
    with pytest.raises(InputError, match="above 1"):
        restitution(Block(math.radians(5.0), 1.0, 50.0), "one_sided_experimental")


@pytest.mark.parametrize(
    "alpha, radius, inertia",
    [(0.0, 1, 2), (2.0, 1, 2), (0.1, 0, 2), (0.1, 1, 1), (0.1, math.nan, 2), (math.nan, 1, 2)],
)
def test_that_an_impossible_block_is_refused(alpha, radius, inertia):
    with pytest.raises(InputError):
        Block(alpha, radius, inertia)


@pytest.mark.parametrize("ends", [(0.0, 0.5), (0.3, 0.2), (0.5, 1.0), (-0.1, 0.2), (math.nan, 0.2)])
def test_that_an_impossible_law_is_refused(ends):
    with pytest.raises(InputError):
        MomentLaw(*ends)


@pytest.mark.parametrize("name", ["doherty", "al_shawa"])
def test_that_a_trilinear_law_is_continuous_and_meets_the_rigid_one(name):
    from core.wall.moment_rotation import moment, potential

    model = rocking_model(WALL, False, restitution(WALL, "housner"), LAWS[name])
    for kink in (model.elastic_end, model.plateau_end):
        below, above = moment(kink * (1 - 1e-12), model), moment(kink * (1 + 1e-12), model)
        assert below == pytest.approx(above, rel=1e-9)
        below, above = potential(kink * (1 - 1e-12), model), potential(kink * (1 + 1e-12), model)
        assert below == pytest.approx(above, rel=1e-9)
    phi = np.linspace(0, 1.4 * WALL.slenderness, 40001)
    values = [moment(angle, model) for angle in phi]
    work = np.trapezoid(values, phi)
    assert potential(phi[-1], model) == pytest.approx(work, rel=1e-7)
    assert values[-1] == pytest.approx(math.sin(WALL.slenderness - phi[-1]))
    assert max(values) / math.sin(WALL.slenderness) == pytest.approx(0.72, abs=0.005)
