"""Walls with loads: worked values, closed forms, energy, and histories by the load's own moment."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from core.capacity.ida import Search, incremental_dynamic_analysis, multiplier_of
from core.case.rules import parse_case
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, STABLE
from core.setting.check_input import make_rocking_model
from core.study import run as study
from core.units import G
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.loads import Force, restoring_moment
from core.wall.moment_rotation import LAWS
from core.wall.rocking_model import rocking_model
from tests.core.rocking.lanes_and_histories import assert_lanes_are_histories
from tests.holds import carries
from tests.validation import loaded_walls

WALL = {
    "name": "w",
    "mechanism": "one_sided",
    "height_m": 3.0,
    "thickness_m": 0.45,
    "unit_weight_kn_m3": 18.0,
    "base_z_m": 0.0,
    "velocity_ratio": 0.6,
}
PARTS = (3.0, 0.45, 18000.0)
ROOF = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}
PUSHING = {**ROOF, "mass": "horizontal"}
CARRIED = {"kind": "carried_mass", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0}
TIE = {"kind": "tie", "out_kn_m": 5.0, "h_m": 2.8, "bar_length_m": 8.0, "elongation_m": 0.4}
INWARD = {"kind": "thrust", "kn_m": -5.0, "h_m": 2.8}
THRUST = {"kind": "thrust", "kn_m": 2.0, "h_m": 2.5}
DEMAND = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}


def case_of(*given, **changes):
    """The case of the wall with these loads and ties; without either nobody says that it bears nothing."""
    wall = WALL | (carries(*given, **changes) if given else changes)
    return parse_case({"wall": [wall], "demand": DEMAND})


def wall_model(*loads, **changes):
    wall = case_of(*loads, **changes).wall[0]
    return make_rocking_model(wall, wall.mechanisms()[0])


@pytest.mark.parametrize("loads", [(), (ROOF,)])
def test_that_the_free_fall_takes_the_time_of_the_energy_integral(loads):
    """From 0.06 rad at rest to the base; the integral of d(theta) / sqrt(2 p2 (V(0.06) - V)) by quadrature."""
    model = wall_model(*loads)
    a, c, alpha = model.restoring.sine, model.restoring.cosine, model.slenderness

    def slowness(x):
        half, middle = 0.5 * x * x, alpha - 0.06 + 0.5 * x * x
        drop = 2.0 * math.sin(half) * (a * math.sin(middle) + c * math.cos(middle))
        return 2.0 * x / math.sqrt(2.0 * model.p2 * drop)

    integral = quad(slowness, 1e-12, math.sqrt(0.06), epsabs=1e-13)[0]
    fall = integrate_history(np.zeros(2000), 0.005, 1.0, model, start=(0.06, 0.0))
    assert fall.impact_time[0] == pytest.approx(integral, rel=1e-10)


def test_that_a_load_on_the_ray_of_the_centroid_is_a_stronger_gravity(reference):
    """alpha_i = alpha: c = 0, so that a p2 and the record over a are the same motion."""
    ground = reference("standard")[0]
    block = Block.with_setback(3.0, 0.45, 0.0)
    free = Restitution("user", 0.6)
    force = Force(10e3, 0.0, 0.45, 3.0)
    held = restoring_moment(block, 24.3e3, [force])
    assert abs(held.cosine) < 1e-16 and held.sine > 1.5
    loaded = rocking_model(block, True, free, LAWS["rigid"], (held, held))
    bare = rocking_model(block, True, free, LAWS["rigid"])
    bare = bare._replace(p2=held.sine * bare.p2)
    one = integrate_history(ground, 0.01, 3.0, loaded)
    other = integrate_history(ground / held.sine, 0.01, 3.0, bare)
    assert one.outcome == other.outcome == STABLE and one.impact_time.size > 3
    assert np.abs(one.rotation - other.rotation).max() < 1e-10 * block.slenderness


@pytest.mark.shows("mechanics.energy")
@pytest.mark.parametrize("loads", [(ROOF, INWARD), (ROOF, THRUST), (PUSHING,)])
def test_that_free_motion_with_loads_keeps_its_energy(loads):
    """V = a (cos(alpha - theta) - cos(alpha)) + c (sin(alpha) - sin(alpha - theta)); an impact leaves e^2 of it."""
    model = wall_model(*loads)
    alpha, a, c = model.slenderness, model.restoring.sine, model.restoring.cosine

    def energy(theta, speed):
        stored = a * (math.cos(alpha - theta) - math.cos(alpha))
        stored += c * (math.sin(alpha) - math.sin(alpha - theta))
        return 0.5 * speed**2 + model.p2 * stored

    start = 0.9 * model.collapse_rotation
    found = integrate_history(np.zeros(1500), 0.005, 1.0, model, start=(start, 0.0))
    impacts = np.searchsorted(found.impact_time, 0.005 * np.arange(1500))
    assert found.impact_time.size > 4
    for k in np.nonzero(found.rotation)[0]:
        target = energy(start, 0.0) * 0.36 ** impacts[k]
        now = energy(found.rotation[k], found.velocity[k])
        assert abs(now - target) <= 1e-12 * target + 1e-15 * model.p2


SETS = [
    ((ROOF,), True, [(1e4, 0.0, 0.30, 3.0, 0.0)]),
    ((ROOF, INWARD), True, [(1e4, 0.0, 0.30, 3.0, 0.0), (0.0, 5e3, 0.0, 2.8, 0.0)]),
    ((ROOF, THRUST), True, [(1e4, 0.0, 0.30, 3.0, 0.0), (0.0, -2e3, 0.0, 2.5, 0.0)]),
    ((PUSHING,), True, [(1e4, 0.0, 0.30, 3.0, 1e4 / G)]),
    ((ROOF,), False, [(1e4, 0.0, 0.30, 3.0, 0.0)]),
    ((ROOF, {**THRUST, "kn_m": 0.5, "d_m": 0.4}), False, [(1e4, 0.0, 0.30, 3.0, 0.0), (0.0, -5e2, 0.4, 2.5, 0.0)]),
]


def two_or_one(one_sided: bool) -> dict:
    return {} if one_sided else {"mechanism": "two_sided"}


@pytest.mark.shows("mechanics.loaded")
@pytest.mark.parametrize(("loads", "one_sided", "forces"), SETS)
@pytest.mark.parametrize("times", [2.2, 2.6])
def test_that_histories_with_loads_are_those_of_the_loads_own_moment(reference, loads, one_sided, forces, times):
    model = wall_model(*loads, **two_or_one(one_sided))
    ground = reference("standard")[0][:700]
    scale = times * model.threshold / np.abs(ground).max()
    rest = 1e-6 * math.sqrt(model.p2) * model.slenderness
    truth = loaded_walls.history(scale * ground, 0.01, PARTS, forces, one_sided, 0.6, rest)
    found = integrate_history(ground, 0.01, scale, model)
    assert np.abs(truth).max() > 0.01 * model.collapse_rotation
    assert found.impact_time.size > 3
    assert np.abs(found.rotation[:700] - truth).max() < 1e-8 * model.collapse_rotation
    if not one_sided:
        assert truth.min() < 0.0 < truth.max()


@pytest.mark.shows("mechanics.loaded")
@pytest.mark.parametrize("law", ["rigid", "al_shawa"])
@pytest.mark.parametrize(("loads", "one_sided"), [entry[:2] for entry in SETS[:5]])
def test_that_lanes_with_loads_are_single_histories(reference, loads, one_sided, law):
    if law != "rigid" and not one_sided:
        loads = ({**ROOF, "d_m": 0.225},)
    model = wall_model(*loads, **two_or_one(one_sided), law=law)
    ground = reference("standard")[0]
    least = model.threshold / np.abs(ground).max()
    scales = least * np.linspace(0.5, 12.0, 90) * (-1.0) ** np.arange(90)
    for method in ("taylor", "taylor_6"):
        seen = assert_lanes_are_histories(ground, 0.01, scales, model, method)
    assert set(seen) == {STABLE, COLLAPSED}


@pytest.mark.shows("mechanics.loaded")
@pytest.mark.parametrize(("loads", "one_sided"), [entry[:2] for entry in SETS])
def test_that_q_with_loads_is_that_of_multipliers_one_after_another(reference, loads, one_sided):
    """The first collapse among single histories on the grid of the search, q to its bracket."""
    model = wall_model(*loads, **two_or_one(one_sided))
    ground = reference("standard")[0]
    pga = float(np.abs(ground).max())
    found = incremental_dynamic_analysis(ground, 0.01, pga, 1, model, METHODS["taylor"], Search(q_step=0.02))
    q = 1.0
    while True:
        q_next = q * 1.02
        one = integrate_history(ground, 0.01, multiplier_of(q_next, pga, model.threshold), model)
        if one.outcome == COLLAPSED:
            break
        q = q_next
    assert q * (1.0 - 1e-9) < found.q <= q_next * (1.0 + 1e-9)
    low, high = found.bracket
    for value, outcome in ((low, STABLE), (high, COLLAPSED)):
        scale = multiplier_of(value, pga, model.threshold)
        assert integrate_history(ground, 0.01, scale, model).outcome == outcome


def test_that_a_two_sided_wall_of_unlike_sides_takes_both_signs_and_does_not_care_from_where_it_is_drawn(tmp_path):
    """d measured from the other face mirrors the wall: the record reversed does the same to it."""
    walls = [
        {**WALL, "name": name, "mechanism": "two_sided", "load": [{**ROOF, "kn_m": 30.0, "d_m": d}]}
        for name, d in (("one", 0.42), ("other", 0.45 - 0.42))
    ]
    table = {"wall": walls, "demand": DEMAND, "generate": {"scatter": 0.0, "count": 2}, "analysis": {"q_step": 0.02}}
    one, other = study.run(parse_case(table), base_dir=tmp_path).walls
    assert [run.polarity for run in one.runs] == [1, -1, 1, -1]
    found = {(run.record, run.polarity): run.ida.q for run in one.runs}
    mirrored = {(run.record, -run.polarity): run.ida.q for run in other.runs}
    assert found == pytest.approx(mirrored, rel=1e-9)
    assert len(set(found.values())) == 4
    assert one.q_set == pytest.approx(other.q_set, rel=1e-9)
    assert one.assessment.dynamic.zeta == pytest.approx(other.assessment.dynamic.zeta, rel=1e-6)
    alike = {**WALL, "mechanism": "two_sided", "load": [{**ROOF, "d_m": 0.225}]}
    alike = study.run(parse_case({**table, "wall": [alike]}), base_dir=tmp_path).walls[0]
    assert {run.polarity for run in alike.runs} == {1}


@pytest.mark.shows("kinematic.q_slv")
def test_that_q_of_the_histories_is_not_raised_by_e_star_twice(tmp_path):
    """a_g,SLV = q a_g,SLD with q from uplift at alpha_0 g: q e* a0* FC = q alpha_0 g."""
    table = {
        "wall": [{**WALL, "load": [PUSHING]}],
        "demand": DEMAND,
        "generate": {"scatter": 0.0, "count": 3},
        "analysis": {"q_step": 0.02},
    }
    wall = study.run(parse_case(table), base_dir=tmp_path).walls[0]
    row = next(check for check in wall.assessment.checks if check.name == "linear_q_slv")
    assert wall.assessment.kinematic.e_star < 0.9
    expected = wall.q_slv_safe_set * wall.model.threshold / (1.35 * 0.312 * G)
    assert row.zeta == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(("loads", "one_sided"), [entry[:2] for entry in SETS])
@pytest.mark.parametrize(
    ("name", "error"), [("dormand_prince", 1e-9), ("rk4", 2e-3), ("newmark_events", 0.3), ("newmark_paper_reset", 1.0)]
)
def test_that_the_compared_methods_take_loads(reference, loads, one_sided, name, error):
    model = wall_model(*loads, **two_or_one(one_sided))
    ground = reference("standard")[0][:700]
    scale = 1.3 * model.threshold / np.abs(ground).max()
    exact = integrate_history(ground, 0.01, scale, model)
    other = integrate_history(ground, 0.01, scale, model, METHODS[name])
    difference = np.abs(exact.rotation[: other.rotation.size] - other.rotation).max()
    assert difference < error * model.collapse_rotation
