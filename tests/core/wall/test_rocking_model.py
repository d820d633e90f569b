"""The flat tuple of a wall: which side it takes, and what is counted from it."""

import math

import pytest

from core.units import G
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.loads import UNLOADED, Force, restoring_moment
from core.wall.moment_rotation import LAWS
from core.wall.rocking_model import RockingModel, rocking_model, seen_from, sides_differ

BLOCK = Block.rectangle(3.0, 0.15)
FREE = Restitution("user", 0.6, 0.02)
HELD = restoring_moment(BLOCK, 24.3e3, [Force(10e3, 0.0, 0.30, 3.0)])
PUSHED = restoring_moment(BLOCK, 24.3e3, [Force(0.0, -2e3, 0.0, 2.5)])


def model(one_sided, loads=(UNLOADED, UNLOADED), law="doherty") -> RockingModel:
    return rocking_model(BLOCK, one_sided, FREE, LAWS[law], loads)


def test_that_a_bare_wall_is_its_block_its_restitution_and_its_law():
    found = model(False)
    assert (found.slenderness, found.p2, found.one_sided) == (0.15, BLOCK.p2, 0.0)
    assert (found.ratio_at_rest, found.ratio_drop) == (0.6, 0.02)
    assert (found.elastic_end, found.plateau_end) == (0.06 * 0.15, 0.28 * 0.15)
    assert (found.collapse_rotation, found.amplitude) == (0.15, 1.0)
    assert found.threshold == pytest.approx(G * math.tan(0.15), rel=1e-15)
    assert model(True).one_sided == 1.0
    assert (model(True, law="rigid").elastic_end, model(True, law="rigid").plateau_end) == (0, 0)


def test_that_a_wall_is_as_strong_as_its_weaker_side():
    for loads in ((HELD, PUSHED), (PUSHED, HELD)):
        found = model(False, loads, "rigid")
        assert (found.restoring, found.mirrored) == loads
        assert (found.lean, found.amplitude) == (PUSHED.lean, PUSHED.amplitude)
        assert found.collapse_rotation == 0.15 + PUSHED.lean
        weaker = G * (PUSHED.sine * math.tan(0.15) + PUSHED.cosine)
        assert found.threshold == pytest.approx(weaker, rel=1e-15)


def test_that_a_one_sided_wall_knows_its_outer_side_only():
    found = model(True, (HELD, PUSHED))
    assert found.restoring == found.mirrored == HELD
    assert (found.lean, found.amplitude) == (HELD.lean, HELD.amplitude)
    assert found.plateau_end == 0.28 * (0.15 + HELD.lean)
    assert found.threshold == pytest.approx(G * (HELD.sine * math.tan(0.15) + HELD.cosine), rel=1e-15)


def test_that_each_pivot_sees_its_own_side_first():
    found = model(False, (HELD, PUSHED), "rigid")
    assert seen_from(found, 1.0) == found
    other = seen_from(found, -1.0)
    assert (other.restoring, other.mirrored) == (PUSHED, HELD)
    assert other._replace(restoring=HELD, mirrored=PUSHED) == found


def test_that_only_a_two_sided_wall_of_equal_sides_takes_a_record_as_its_reverse():
    assert model(False).both_signs_alike and not sides_differ(model(False))
    assert not model(True).both_signs_alike
    unlike = model(False, (HELD, PUSHED), "rigid")
    assert not unlike.both_signs_alike and sides_differ(unlike)
    for change in ({"sine": 1.1}, {"cosine": 0.1}):
        assert sides_differ(model(False)._replace(mirrored=UNLOADED._replace(**change)))
