"""Forces and masses on a block, against the moments and inertias of their points."""

import math

import pytest

from core.wall.block import Block
from core.wall.loads import UNLOADED, Force, PointMass, composite, restoring_moment

BLOCK = Block.with_setback(3.0, 0.45, 0.05)
WEIGHT = 24.3e3
FORCES = [
    Force(10e3, 0.0, 0.30, 3.0),
    Force(0.0, 5e3, 0.0, 2.8),
    Force(0.0, -2e3, 0.0, 2.5),
    Force(7e3, -3e3, -0.04, 1.2),
    Force(-1e3, 4e3, 0.4, 0.6),
]


@pytest.mark.shows("mechanics.loaded")
@pytest.mark.parametrize("forces", [*([force] for force in FORCES), FORCES])
def test_that_a_and_c_hold_the_moment_of_every_force_at_every_rotation(forces):
    """The point of a force turns about the pivot: inward d cos(phi) - h sin(phi), up h cos(phi) + d sin(phi); a
    downward force holds by the first, an inward one by the second."""
    found = restoring_moment(BLOCK, WEIGHT, forces)
    x, y = BLOCK.centroid
    for phi in (0.0, 0.03, 0.11, 0.4):
        cosine, sine = math.cos(phi), math.sin(phi)
        moment = WEIGHT * (x * cosine - y * sine)
        for force in forces:
            moment += force.vertical * (force.distance * cosine - force.height * sine)
            moment += force.horizontal * (force.height * cosine + force.distance * sine)
        lean = BLOCK.slenderness - phi
        held = found.sine * math.sin(lean) + found.cosine * math.cos(lean)
        assert WEIGHT * BLOCK.radius * held == pytest.approx(moment, rel=1e-12, abs=1e-9)
        one_sine = found.amplitude * math.sin(BLOCK.slenderness + found.lean - phi)
        assert one_sine == pytest.approx(held, rel=1e-12, abs=1e-14)


def test_that_no_force_and_no_mass_leave_the_block_as_it_is():
    assert restoring_moment(BLOCK, WEIGHT, []) == UNLOADED == (1.0, 0.0, 1.0, 0.0)
    assert composite(BLOCK, 2478.0, []) is BLOCK


def test_that_a_block_with_masses_has_their_common_centroid_and_inertia():
    mass, parts = 2400.0, [PointMass(600.0, 0.1, 2.9), PointMass(300.0, -0.04, 1.5)]
    found = composite(BLOCK, mass, parts)
    x, y = BLOCK.centroid
    assert found.centroid[0] == pytest.approx((2400 * x + 60.0 - 12.0) / 3300, rel=1e-13)
    assert found.centroid[1] == pytest.approx((2400 * y + 1740.0 + 450.0) / 3300, rel=1e-13)
    inertia = 2400 * BLOCK.inertia_over_mass + 600 * (0.01 + 2.9**2) + 300 * (0.0016 + 1.5**2)
    assert found.inertia_over_mass == pytest.approx(inertia / 3300, rel=1e-13)
