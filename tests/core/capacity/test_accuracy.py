"""The statement of accuracy: solver and definition, for a wall and its record."""

import numpy as np
import pytest

from core.capacity.accuracy import NOISES, accuracy, truth
from core.capacity.ida import Search, incremental_dynamic_analysis
from core.errors import Cancelled
from core.ground.ground_motion import GroundMotion
from core.rocking.methods import METHODS


@pytest.fixture(scope="module")
def said(make_model, reference):
    """A short record, a small grid: seconds, not minutes."""
    ground = np.ascontiguousarray(reference("standard")[0][:700])
    motion = GroundMotion("short", ground, 0.01)
    model = make_model(height=4.0)
    search = Search(q_step=0.02)
    ida = incremental_dynamic_analysis(ground, 0.01, motion.pga, 1, model, METHODS["taylor"], search)
    return ida, accuracy(motion, 1, ida, None, model, METHODS["taylor"], search)


def test_that_the_default_agrees_with_independent_solvers(said):
    ida, found = said
    assert found.q == ida.q and found.q_reference == ida.q
    assert found.solver_q_error == 0.0
    # at the last survived scale the motion amplifies what DOP853 itself leaves (3e-14 a step)
    assert found.history_error < 1e-6


def test_that_the_chart_orders_the_methods(said):
    errors = {point.name: point.error for point in said[1].points}
    assert errors["taylor"] < 1e-6
    for crude in ("newmark_paper", "linearised"):
        assert errors[crude] is None or errors[crude] > 1e-3
    assert all(point.seconds > 0.0 for point in said[1].points)


def test_that_the_spread_by_definition_stands_apart(said):
    ida, found = said
    assert (0.02, ida.q, ida.q_robust) in found.steps
    assert len(found.steps) >= 3 and len(found.rounded) == NOISES + 1
    assert found.spread(1, found.steps) >= 0.0
    assert found.polarities is None


def test_that_the_independent_solver_ends_soon_after_a_cancel(make_model, reference):
    """It takes seconds a history: a cancel is seen between its samples."""
    asked = []

    def cancelled():
        asked.append(True)
        return len(asked) > 3

    model, ground = make_model(), reference("standard")[0]
    with pytest.raises(Cancelled):
        truth(GroundMotion("long", ground, 0.01), 1.0, model, cancelled)
    assert len(asked) == 4
