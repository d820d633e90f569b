"""q of El Centro 1940, three independent solvers agreeing (issue A): real record, paper's walls."""

import math

import pytest

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.rocking.methods import METHODS
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

HEIGHTS = (3.0, 5.0, 7.0, 9.0, 11.0)


def q_of(record, alpha, height, one_sided=False, sign=1, q_step=0.005):
    block = Block.rectangle(height, math.radians(alpha))
    model = "one_sided_theoretical" if one_sided else "housner"
    found = incremental_dynamic_analysis(
        record.acceleration,
        record.time_step,
        record.pga,
        sign,
        rocking_model(block, one_sided, restitution(block, model), LAWS["rigid"]),
        METHODS["taylor"],
        Search(q_step=q_step),
    )
    assert found.status == "collapse_found"
    return found.q


@pytest.mark.shows("paper.eq_10")
@pytest.mark.parametrize(
    "alpha, known",
    [
        (3.1, (1.172, 1.534, 1.851, 2.346, 2.862)),
        (6.8, (1.406, 1.874, 2.336, 2.764, 4.386)),
        (11.3, (1.859, 2.319, 2.884, 4.541, 5.861)),
    ],
)
def test_that_two_sided_walls_collapse_at_the_known_q(el_centro, alpha, known):
    for height, q in zip(HEIGHTS, known, strict=True):
        assert q_of(el_centro, alpha, height) == pytest.approx(q, abs=1e-3)


@pytest.mark.shows("paper.eq_10")
@pytest.mark.parametrize(
    "sign, known", [(1, (3.150, 4.646, 4.924, 5.052, 5.167)), (-1, (4.984, 5.263, 5.777, 6.425, 6.744))]
)
def test_that_one_sided_walls_collapse_at_the_known_q(el_centro, sign, known):
    for height, q in zip(HEIGHTS, known, strict=True):
        assert q_of(el_centro, 6.8, height, True, sign) == pytest.approx(q, abs=1e-3)


@pytest.mark.parametrize("alpha, height, q_step, q", [(6.8, 11.0, 0.001, 3.754), (11.3, 7.0, 0.01, 4.00)])
def test_that_first_collapse_depends_on_the_step_as_known(el_centro, alpha, height, q_step, q):
    assert q_of(el_centro, alpha, height, q_step=q_step) == pytest.approx(q, abs=2e-3)
