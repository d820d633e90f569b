"""Fig. 3: rigid and trilinear law."""

import math

import numpy as np
import pytest

from core.errors import InputError
from core.wall.block import Block
from core.wall.moment_rotation import LAWS, MomentLaw
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

WALL = Block.rectangle(7.0, math.radians(6.8))


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
