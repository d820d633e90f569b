"""Fig. 3: rigid and trilinear law."""

import math

import numpy as np
import pytest

from core.errors import InputError
from core.wall.block import Block
from core.wall.loads import RestoringMoment
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

WALL = Block.rectangle(7.0, math.radians(6.8))


@pytest.mark.parametrize("ends", [(0.0, 0.5), (0.3, 0.2), (0.5, 1.0), (-0.1, 0.2), (math.nan, 0.2)])
def test_that_an_impossible_law_is_refused(ends):
    with pytest.raises(InputError):
        MomentLaw(*ends)


@pytest.mark.shows("mechanics.law")
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


LOADED = RestoringMoment(1.3, -0.02, math.hypot(1.3, -0.02), math.atan2(-0.02, 1.3))


@pytest.mark.shows("mechanics.law")
def test_that_the_energy_of_the_rigid_law_is_the_rise_of_its_weights():
    """a (cos(alpha - phi) - cos(alpha)) + c (sin(alpha) - sin(alpha - phi)): a and c one by one."""
    from core.wall.moment_rotation import potential

    for side in (RestoringMoment(), LOADED):
        model = rocking_model(WALL, True, restitution(WALL, "housner"), LAWS["rigid"], (side, side))
        for phi in (0.0, 1e-3, 0.05, 0.11, 0.3):
            left = WALL.slenderness - phi
            rise = side.sine * (math.cos(left) - math.cos(WALL.slenderness))
            rise += side.cosine * (math.sin(WALL.slenderness) - math.sin(left))
            assert potential(phi, model) == pytest.approx(rise, rel=1e-10, abs=1e-16)


@pytest.mark.parametrize("side", [RestoringMoment(), LOADED])
@pytest.mark.parametrize("name", list(LAWS))
def test_that_the_rotation_of_an_energy_is_the_one_that_stores_it(name, side):
    """On each branch, at their ends and at the barrier."""
    from core.wall.moment_rotation import potential, rotation_at_potential

    model = rocking_model(WALL, True, restitution(WALL, "housner"), LAWS[name], (side, side))
    top = WALL.slenderness + side.lean
    for share in (0.0, 0.005, 0.02, 0.04, 0.06, 0.15, 0.28, 0.4, 0.7, 0.95):
        found = rotation_at_potential(potential(share * top, model), model)
        assert found == pytest.approx(share * top, rel=1e-9, abs=1e-9)
    assert rotation_at_potential(potential(top, model), model) == pytest.approx(top, rel=1e-6)
