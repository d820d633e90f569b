"""Energy between impacts, at impacts, and the decision at the end of the record."""

import math

import numpy as np
import pytest

from core.rocking.history import integrate_history
from core.rocking.outcome import COLLAPSED
from core.units import G
from core.wall.rocking_model import RockingModel


def energy(rotation, velocity, model):
    """E / I0 [1/s2] from the laws themselves, not from the program's potential."""
    phi = abs(rotation)
    alpha, phi1, phi2 = model.slenderness, model.elastic_end, model.plateau_end
    if phi2 == 0.0:
        stored = math.cos(alpha - phi) - math.cos(alpha)
    else:
        k = math.sin(alpha - phi2)
        stored = k * min(phi, phi1) ** 2 / (2 * phi1) + k * max(0.0, min(phi, phi2) - phi1)
        if phi > phi2:
            stored += math.cos(alpha - phi) - math.cos(alpha - phi2)
    return 0.5 * velocity**2 + model.p2 * stored


@pytest.mark.shows("paper.eq_3", "mechanics.energy")
@pytest.mark.parametrize("law", ["rigid", "doherty", "al_shawa"])
@pytest.mark.parametrize("one_sided", [False, True])
def test_that_free_motion_keeps_its_energy_and_an_impact_takes_its_share(make_model, law, one_sided):
    model = make_model(one_sided=one_sided, law=law, ratio=0.93)
    start = (0.9 * model.slenderness, 0.0)
    found = integrate_history(np.zeros(3001), 0.01, 1.0, model, start=start)
    expected = energy(*start, model)
    impacts = 0
    ratios = 0.93 ** (2 * np.arange(found.impact_time.size + 1))
    for sample in range(found.rotation.size):
        while impacts < found.impact_time.size and sample * 0.01 > found.impact_time[impacts]:
            impacts += 1
        now = energy(found.rotation[sample], found.velocity[sample], model)
        if found.rotation[sample] != 0.0:
            # 1e-12 of the energy of the piece, or the rounding of cos - cos
            target = expected * ratios[impacts]
            assert abs(now - target) <= 1e-12 * target + 4e-16 * model.p2
    assert impacts > 5
    # just after an impact all energy is kinetic: velocities fall by exactly e
    speeds = np.abs(found.impact_velocity)
    assert np.allclose(speeds[1:] / speeds[:-1], 0.93, rtol=1e-11, atol=0)


@pytest.mark.shows("mechanics.end_of_record")
@pytest.mark.parametrize("law", ["rigid", "doherty", "al_shawa"])
@pytest.mark.parametrize(
    "one_sided, restitution", [(False, "housner"), (True, "housner"), (True, "one_sided_experimental")]
)
def test_that_the_energy_decision_is_what_integrating_on_gives(make_model, law, one_sided, restitution):
    model = make_model(one_sided=one_sided, model=restitution, law=law)
    p = math.sqrt(model.p2)
    seen = set()
    for phi in np.linspace(0.02, 1.9, 14) * model.slenderness:
        for speed in np.linspace(-1.6, 1.6, 15) * p * model.slenderness:
            decided = integrate_history(np.zeros(2), 1e-9, 1.0, model, start=(phi, speed))
            integrated = integrate_history(np.zeros(6001), 0.01, 1.0, model, start=(phi, speed))
            seen.add(decided.outcome)
            assert decided.outcome == integrated.outcome
            if decided.outcome == COLLAPSED:
                assert integrated.rotation.size < 6001
            else:
                assert decided.peak == pytest.approx(integrated.peak, rel=1e-6)
    assert len(seen) == 2


@pytest.mark.shows("mechanics.end_of_record")
def test_that_an_outcome_is_decided_just_below_and_above_the_separatrix(make_model):
    """The free block with the energy of the barrier is the separatrix: 1e-9 decides."""
    for law in ("rigid", "al_shawa"):
        model = make_model(law=law)
        barrier = energy(model.slenderness, 0.0, model)
        phi = 0.5 * model.slenderness
        edge = math.sqrt(2.0 * (barrier - energy(phi, 0.0, model)))
        outcomes = [
            integrate_history(np.zeros(2), 1e-9, 1.0, model, start=(phi, edge * factor)).outcome
            for factor in (1 - 1e-9, 1 + 1e-9)
        ]
        assert outcomes == [0, 1]


@pytest.mark.shows("mechanics.end_of_record")
@pytest.mark.parametrize("law", ["rigid", "al_shawa"])
def test_that_a_wall_that_falls_ends_at_a_right_angle(make_model, law):
    """The ground goes on; the history ends at the sample after theta = pi/2."""
    model = make_model(law=law)
    pushed = np.full(4000, 3.0 * G * math.tan(model.slenderness))
    found = integrate_history(pushed, 0.01, 1.0, model)
    assert found.outcome == COLLAPSED and found.rotation.size < 4000
    assert (np.abs(found.rotation[:-1]) <= 0.5 * math.pi).all() and found.peak >= 0.5 * math.pi


@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.9, 0.999, 1.0])
@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("kinks", [(0.0, 0.0), (0.02, 0.28)])
def test_that_every_velocity_ratio_ends_with_an_outcome(reference, ratio, one_sided, kinks):
    ground = reference("standard")[0]
    alpha = math.radians(6.8)
    model = RockingModel(alpha, 2.0866, float(one_sided), ratio, 0.0, kinks[0] * alpha, kinks[1] * alpha)
    for scale in (0.5, 1.0, 3.0):
        found = integrate_history(ground, 0.01, scale, model)
        assert found.outcome in (0, 1)
        assert math.isfinite(found.peak)
        assert np.isfinite(found.rotation).all()
        if one_sided:
            assert found.rotation.min() >= 0.0
