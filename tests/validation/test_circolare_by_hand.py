"""Checks of the Circolare 7/2019, C8.7.1.2.1.1 to .9, worked out by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.capacity import independent_solver
from core.capacity.ida import incremental_dynamic_analysis, multiplier_of
from core.case.rules import parse_case
from core.codes.dynamic_check import demand_check
from core.codes.kinematic import linear, nonlinear, sld
from core.rocking.history import history
from core.rocking.methods import AUTO, METHODS
from core.rocking.outcome import COLLAPSED
from core.study import run as study
from core.study.demand_input import demand_of
from core.units import G
from tests.validation.circolare import FREE, HELD, NTC_C, case, mechanism_of

BY_HAND = [
    # H, t, kind of wall, then a0*/g, zeta linear with q = 2, T_SLV, S_De, zeta displacement raw and counted;
    # EC8 type 1 B, a_g 0.26 g, S 1.2, FC 1.35, e* = 1
    (7.0, 0.83, HELD, 0.08783, 0.5630, 2.99126, 0.16994, 0.9768, 0.9768),
    (3.0, 0.45, HELD, 0.11111, 0.7123, 1.95824, 0.16639, 0.5409, 0.5409),
    (3.0, 0.45, FREE, 0.11111, 0.2849, 1.95824, 0.16639, 0.5409, 0.5409),
    (1.0, 0.20, HELD, 0.14815, 0.9497, 1.13059, 0.09606, 0.4164, 0.4748),
]


@pytest.mark.parametrize(
    ("height", "thickness", "kind", "a0", "zeta_linear", "period", "s_de", "raw", "counted"),
    BY_HAND,
)
def test_that_a_wall_on_the_ground_is_the_hand_calculation(
    height, thickness, kind, a0, zeta_linear, period, s_de, raw, counted
):
    found, demand = mechanism_of(case({"height_m": height, "thickness_m": thickness, **kind}))
    assert found.e_star == 1.0 and found.alpha0 == pytest.approx(thickness / height, rel=1e-14)
    assert found.a0 / G == pytest.approx(a0, abs=5e-6)
    assert found.period == pytest.approx(period, abs=5e-6)
    assert found.s_de == pytest.approx(s_de, abs=5e-6)
    assert found.d0 == pytest.approx(thickness / 2.0, rel=1e-12)
    check = linear("linear_q_code", found, demand, 2.0)
    assert check.zeta == pytest.approx(zeta_linear, abs=5e-5) and check.q == 2.0
    # a_g,SLV against a_g, both in g
    assert check.demand == pytest.approx(0.26, rel=1e-12)
    assert check.capacity == pytest.approx(0.26 * check.zeta, rel=1e-12)
    assert found.d_limit / found.s_de == pytest.approx(raw, abs=5e-5)
    # clause .8: where the a_g,SLV of the displacement check is below a_g,SLD, that counts
    assert nonlinear(found, demand).zeta == pytest.approx(counted, abs=5e-5)


@pytest.mark.parametrize(
    ("height", "thickness", "modulus", "weight", "period_0", "zeta_linear", "zeta_displacement"),
    [
        (12.5, 0.90, None, None, None, 0.3073, 0.7371),
        (3.0, 0.40, 1000.0, 19.0, 0.19417, 0.2408, 0.4423),
        (2.8, 0.70, 1000.0, 19.0, 0.09666, 0.6044, 0.8013),
    ],
)
def test_that_walls_of_a_site_on_soil_c_are_the_hand_calculation(
    height, thickness, modulus, weight, period_0, zeta_linear, zeta_displacement
):
    """NTC 2018, a_g 0.261 g, F0 2.364, T_C* 0.347 s, soil C: S = 1.70 - 0.60 2.364 0.261 = 1.32980."""
    wall = {"height_m": height, "thickness_m": thickness, "free_element": modulus is not None}
    if modulus:
        wall |= {"elastic_modulus_mpa": modulus, "unit_weight_kn_m3": weight}
    found, demand = mechanism_of(case(wall, {"ag_g": 0.261, "spectrum": NTC_C}))
    assert demand.soil_factor == pytest.approx(1.32980, abs=5e-6)
    if period_0:
        assert found.period_0 == pytest.approx(period_0, abs=5e-6)
    assert linear("linear_q_code", found, demand, 2.0).zeta == pytest.approx(zeta_linear, abs=1e-4)
    assert nonlinear(found, demand).zeta == pytest.approx(zeta_displacement, abs=5e-5)


def test_that_t_0_and_the_demand_of_a_free_element_are_the_hand_calculation():
    # 6.2 (3.0 / 0.45) 3.0 sqrt(18e3 / (600e6 9.80665)) = 0.216880 s, on the plateau: S_e = 0.312 2.5 g
    found, _ = mechanism_of(case({"height_m": 3.0, "thickness_m": 0.45, **FREE}))
    assert found.period_0 == pytest.approx(0.21688, abs=5e-6)
    assert found.acceleration_demand / G == pytest.approx(0.780, rel=1e-12)
    assert found.zeta_sld == pytest.approx(0.45 / 3.0 / 1.35 / 0.780, rel=1e-12)
    # M* of one block is its mass: 18e3 3.0 0.45 / g per metre
    assert found.m_star == pytest.approx(18e3 * 3.0 * 0.45 / G, rel=1e-14)


def test_that_a_wall_is_free_as_said_else_by_its_mechanism():
    both = case({"mechanism": "both"}).wall[0]
    assert both.is_free("two_sided") and not both.is_free("one_sided")
    assert not case(HELD).wall[0].is_free("two_sided")
    assert case({**FREE, "mechanism": "one_sided"}).wall[0].is_free("one_sided")


def test_that_a_free_element_without_its_period_has_no_linear_check():
    found, demand = mechanism_of(case({"unit_weight_kn_m3": 18.0}))
    assert found.missing == ("elastic_modulus_mpa",) and found.zeta_sld is None
    assert linear("linear_q_code", found, demand, 2.0) is None and sld(found, demand) is None
    assert nonlinear(found, demand).zeta == pytest.approx(0.9768, abs=5e-5)
    bare = {"wall": [{"name": "w", "height_m": 7.0, "thickness_m": 0.83, "base_z_m": 0.0,
                      "mechanism": "two_sided", **FREE}], "demand": {"ag_g": 0.26, "soil_factor": 1.2}}  # fmt: skip
    assert mechanism_of(parse_case(bare))[0].missing == ("spectrum",)


def test_that_the_check_at_sld_is_against_the_ground_or_the_spectrum_at_t_0():
    for kind, demanded in ((HELD, 0.312), (FREE, 0.780)):
        asked = case({"height_m": 3.0, "thickness_m": 0.45, **kind}, {"limit_state": "SLD"})
        check = sld(*mechanism_of(asked))
        assert check.clause == "C8.7.1.2.1.5" and check.unit == "g"
        assert check.demand == pytest.approx(demanded, rel=1e-12)
        assert check.capacity == pytest.approx(0.45 / 3.0 / 1.35, rel=1e-12)
        assert check.zeta == pytest.approx(0.45 / 3.0 / 1.35 / demanded, rel=1e-12)


def test_that_slc_has_its_own_fraction_period_and_damping():
    found, _ = mechanism_of(case(HELD, {"limit_state": "SLC"}))
    assert found.d_limit == pytest.approx(0.6 * 0.415, rel=1e-12)
    assert found.period == pytest.approx(
        1.56 * math.pi * math.sqrt(0.249 / (0.4 * found.a0)), rel=1e-12
    )
    eta = math.sqrt(10.0 / 15.0)
    by_hand = 0.312 * G * eta * 2.5 * 0.5 * 2.0 / (4.0 * math.pi**2)
    assert found.period > 2.0 and found.s_de == pytest.approx(by_hand, rel=1e-12)


@pytest.fixture(scope="module")
def designed(tmp_path_factory):
    """7.0 x 0.83 m, a_g 0.26 g, S 1.2, two-sided, seven compatible motions."""
    return study.run(case(HELD, generate={"count": 7}), base_dir=tmp_path_factory.mktemp("none"))


def checks(result):
    return {check.name: check for check in result.walls[0].assessment.checks}


def reduced(model, factor=1.35):
    """The model with the strength of its capacity curve over FC, to be shaken by the ground times FC."""
    return model._replace(p2=model.p2 / factor)


@pytest.mark.parametrize("one_sided", [False, True])
def test_that_fc_on_the_strength_is_the_restoring_moment_over_fc(designed, one_sided):
    """theta'' = -p^2 [sin(alpha - theta) / FC - u''/g cos(alpha - theta)] by scipy's DOP853, with its own
    uplift at g tan(alpha) / FC, against the kernel with p^2 / FC under FC u''."""
    factor, wall = 1.35, designed.walls[0]
    alpha, p2, ratio = wall.block.slenderness, wall.block.p2, 0.9
    model = wall.model._replace(one_sided=float(one_sided), ratio_at_rest=ratio)
    ground, dt = designed.motions[0].acceleration[:900], 0.01
    scale = 0.6 if not one_sided else 1.2
    theta = solved(scale * ground, dt, alpha, p2, one_sided, ratio, factor)
    found = history(ground, dt, factor * scale, reduced(model), METHODS["taylor"])
    assert np.abs(theta).max() > 0.02 * alpha and found.impact_time.size > 2
    assert np.abs(found.rotation - theta).max() < 1e-8 * alpha


def solved(ground, dt, alpha, p2, one_sided, ratio, strength):
    """theta at the samples [rad] of a rigid block whose restoring moment is divided by `strength`."""
    from scipy.integrate import solve_ivp

    threshold = math.tan(alpha) / strength
    side, phi, speed, moving, theta = 1.0, 0.0, 0.0, False, [0.0]

    def touches(t, y):
        return y[0]

    touches.terminal, touches.direction = True, -1
    for k in range(len(ground) - 1):
        b0, slope, t = ground[k] / G, (ground[k + 1] - ground[k]) / dt / G, 0.0
        while t < dt:
            if not moving:
                start = independent_solver.uplift(b0, b0 + slope * dt, t, dt, threshold, one_sided)
                if start is None:
                    break
                t, side = start
                phi, speed, moving = 0.0, 0.0, True

            def motion(s, y, b0=b0, slope=slope, side=side):
                push = side * (b0 + slope * s) * math.cos(alpha - y[0])
                return [y[1], -p2 * (math.sin(alpha - y[0]) / strength - push)]

            found = solve_ivp(motion, (t, dt), [phi, speed], "DOP853", rtol=1e-13, atol=1e-17,
                              max_step=dt / 4, events=[touches])  # fmt: skip
            t, (phi, speed) = found.t[-1], found.y[:, -1]
            if found.status == 1:
                speed, phi = -ratio * speed, 0.0
                side = side if one_sided else -side
                beta = b0 + slope * t
                lifts = beta > threshold or (beta < -threshold and not one_sided)
                moving = speed > 1e-6 * math.sqrt(p2 / strength) * alpha or lifts
        theta.append(side * phi if moving else 0.0)
    return np.array(theta)


def test_that_the_dynamic_check_is_what_single_histories_say(designed):
    wall = designed.walls[0]
    found = wall.assessment.dynamic
    assert found.confidence_on == "capacity" and found.zeta_other.confidence_on == "demand"
    peaks = []
    for run, motion in zip(found.runs, designed.motions, strict=True):
        assert run.factor == 1.0
        alone = history(motion.acceleration, motion.time_step, 1.35, reduced(wall.model), AUTO)
        assert run.exceeded == (alone.outcome == COLLAPSED or alone.peak > wall.block.slenderness)
        if run.peak_ratio is not None:
            assert run.peak_ratio == alone.peak / wall.block.slenderness
            peaks.append(run.peak_ratio)
    assert found.n_exceeded == sum(run.exceeded for run in found.runs)
    overturned = any(run.status == "overturned" for run in found.runs)
    assert found.mean_peak_ratio == (None if overturned else pytest.approx(np.mean(peaks)))


def test_that_records_scaled_to_the_pga_are_the_records_at_the_demand(designed, tmp_path):
    """Half of each record, scaled to a_g S, is the record: the same peaks and the same zeta."""
    wall, demand = designed.walls[0], designed.demand
    weak = [replace(m, acceleration=0.5 * m.acceleration) for m in designed.motions]
    for confidence_on in ("capacity", "demand"):
        asked = {"confidence_on": confidence_on}
        plain = demand_of(case(HELD, asked), tmp_path)
        scaled = demand_of(case(HELD, {**asked, "demand_scaling": "pga"}), tmp_path)
        first = demand_check(wall.model, list(designed.motions), (1,), plain, AUTO)
        second = demand_check(wall.model, weak, (1,), scaled, AUTO)
        factor = (
            2.0 * (1.35 if confidence_on == "demand" else 1.0) * demand.pga / (2.0 * weak[0].pga)
        )
        assert second.runs[0].factor == pytest.approx(factor, rel=1e-12)
        assert second.zeta == pytest.approx(first.zeta, rel=0.01)
        assert second.n_exceeded == first.n_exceeded
        for one, other in zip(first.runs, second.runs, strict=True):
            assert other.status == one.status
            assert one.peak_ratio is None or other.peak_ratio == pytest.approx(
                one.peak_ratio, rel=1e-6
            )
    assert demand_check(wall.model, [], (1,), plain, AUTO) is None


STEP = 0.0025


def rule_fails(designed, model, factor: float) -> np.ndarray:
    """Whether the rule fails at each point k = -700 .. 240 of the grid 1.0025^k, by single histories."""
    alpha, fails = designed.walls[0].block.slenderness, []
    for k in range(-700, 241):
        multiplier, peaks = 1.0025**k, []
        for motion in designed.motions:
            alone = history(motion.acceleration, 0.01, factor * multiplier, model, AUTO)
            peaks.append(math.inf if alone.outcome == COLLAPSED else alone.peak / alpha)
        fails.append(max(peaks) > 1.0 or np.mean(peaks) > 0.40)
    return np.array(fails)


def lowest_with(fails: np.ndarray, share: float) -> float:
    """Lowest multiplier around which this share of the 81 points within +-10 % fails."""
    places = (k for k in range(40, 901) if fails[k - 40 : k + 41].mean() >= share)
    return 1.0025 ** (next(places) - 700)


def test_that_zeta_is_where_half_of_the_multipliers_around_fail(designed):
    wall = designed.walls[0]
    found = wall.assessment.dynamic
    fails = rule_fails(designed, reduced(wall.model), 1.35)
    assert found.zeta == pytest.approx(lowest_with(fails, 0.5), rel=0.6 * STEP)
    assert found.zeta_16 == pytest.approx(lowest_with(fails, 0.16), rel=2.1 * STEP)
    assert found.share_failing_at_demand == pytest.approx(fails[660:741].mean(), abs=1e-12)
    assert found.holds == (not fails[700])
    # below the first failure found nothing fails on the coarse grid, which may step over a narrow one
    assert 1.0025 ** (int(np.argmax(fails)) - 700) <= found.zeta_first * 1.0001
    on_demand = rule_fails(designed, wall.model, 1.35)
    other = found.zeta_other.zeta  # by steps of 0.5 %
    assert lowest_with(on_demand, 0.42) < other < lowest_with(on_demand, 0.58)
    low, high = found.zeta_spread
    assert low == pytest.approx(lowest_with(fails, 0.45), rel=1.1 * STEP)
    assert high == pytest.approx(lowest_with(fails, 0.55), rel=1.1 * STEP)
    assert found.zeta_other.zeta < found.zeta


def test_that_the_wall_of_the_design_shows_its_disagreement(designed):
    wall = designed.walls[0]
    found = checks(designed)
    assert found["dynamic"].passed is False and found["dynamic"].zeta < 0.9
    assert found["nonlinear"].zeta == pytest.approx(0.98, abs=0.005)
    assert found["linear_q_code"].zeta == pytest.approx(0.5630, abs=5e-5)
    by_source = {check.q_source: check.ratio for check in wall.code_check if check}
    assert by_source["code"] == pytest.approx(0.76, abs=0.005)
    # Eq. 9 at collapse says more than the dynamic check at SLV
    assert by_source["time_histories"] > 1.1 * found["dynamic"].zeta
    assert wall.assessment.verdict.code == "not_verified"
    assert wall.assessment.verdict.governing == "dynamic"


def test_that_q_and_its_multiplier_are_one_formula(designed):
    """The multiplier of a q is that of its search, to the last bit: the wall falls at it, not below."""
    wall, motion = designed.walls[0], designed.motions[0]
    ida = incremental_dynamic_analysis(
        motion.acceleration, 0.01, motion.pga, 1, wall.model, AUTO, designed.search
    )
    threshold = wall.block.threshold_acceleration
    low, high = (multiplier_of(q, motion.pga, threshold) for q in ida.bracket)
    assert wall.runs[0].scale == high
    assert history(motion.acceleration, 0.01, high, wall.model, AUTO).outcome == COLLAPSED
    assert history(motion.acceleration, 0.01, low, wall.model, AUTO).outcome != COLLAPSED


def test_that_a_setback_turns_the_wall_about_its_hinge():
    # t = 0.83, u = 0.05: tan(alpha) = 0.73 / 7; R = sqrt(3.5^2 + 0.365^2); I0/m = (7^2 + 0.83^2)/12 + R^2
    block = case(wall={"hinge_setback_m": 0.05}).wall[0].block()
    assert math.tan(block.slenderness) == pytest.approx(0.73 / 7.0, rel=1e-14)
    assert block.radius == pytest.approx(math.hypot(3.5, 0.365), rel=1e-14)
    inertia = (49.0 + 0.83**2) / 12.0 + block.radius**2
    assert block.inertia_over_mass == pytest.approx(inertia, rel=1e-14)
    none = case(wall={"hinge_setback_m": 0.0}).wall[0].block()
    assert none.is_rectangle


def test_that_the_strength_of_the_masonry_gives_the_setback():
    # W per metre = 19 kN/m3 0.83 m 7 m = 110.39 kN/m; u = 2 110.39e3 / (3 2e6) = 0.036797 m
    wall = case(wall={"compressive_strength_mpa": 2.0, "unit_weight_kn_m3": 19.0}).wall[0]
    assert wall.setback == pytest.approx(0.036797, abs=1e-6)


def test_that_a_search_that_ends_early_does_not_raise_zeta(tmp_path):
    """q_limit below the first peak at 0.40 alpha: zeta is still searched, from where the search ended."""
    wall = {"base_z_m": 0.0, "mechanism": "one_sided", "height_m": 5.0, "thickness_m": 0.6}
    table = {"wall": wall, "demand": {"ag_g": 0.3}, "generate": {"count": 3}}
    full = study.run(case(**table), base_dir=tmp_path).walls[0].assessment.dynamic
    table["analysis"] = {"q_step": 0.01, "q_limit": 2.0}
    short = study.run(case(**table), base_dir=tmp_path).walls[0].assessment.dynamic
    assert short.zeta == pytest.approx(full.zeta, rel=0.05)


def test_that_a_free_element_is_not_called_at_rest_by_the_pga(tmp_path):
    """FC S a_g is below a_RM, but FC S_e(T_0) is not (C8.7.1.9)."""
    wall = {
        "height_m": 1.2,
        "thickness_m": 0.35,
        "elastic_modulus_mpa": 200.0,
        "unit_weight_kn_m3": 18.0,
    }
    for kind in (wall, {k: v for k, v in wall.items() if k[0] != "e"}):
        found = study.run(case(kind, {"ag_g": 0.16}), base_dir=tmp_path).walls[0].assessment
        assert found.verdict.code != "not_activated"
    held = study.run(case({**wall, "free_element": False}, {"ag_g": 0.16}), base_dir=tmp_path)
    assert held.walls[0].assessment.verdict.code == "not_activated"


def test_that_a_target_below_one_is_what_decides(tmp_path):
    found = (
        study.run(
            case(demand={"ag_g": 0.25, "zeta_target": 0.4}, generate={"count": 7}),
            base_dir=tmp_path,
        )
        .walls[0]
        .assessment
    )
    assert not found.dynamic.holds and found.dynamic.holds_at_target
    assert found.dynamic.zeta > 0.4 and found.dynamic.passed
    assert found.verdict.code.startswith("verified")
