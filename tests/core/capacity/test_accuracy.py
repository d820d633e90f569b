"""The statement of accuracy: solver and definition, for a wall and its record."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.capacity.accuracy import NOISES, PROMISED, TIMES_NOISE, effect_of_noise, make_accuracy, reference_history
from core.capacity.ida import Search, incremental_dynamic_analysis
from core.errors import Cancelled
from core.ground.ground_motion import GroundMotion
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, STABLE
from core.units import G
from core.wall.bars import TieBar


@pytest.fixture(scope="module")
def said(make_model, reference):
    """A short record, a small grid: seconds, not minutes; the order that a wall with ties is not given."""
    ground = np.ascontiguousarray(reference("standard")[0][:700])
    motion = GroundMotion("short", ground, 0.01)
    model = make_model(height=4.0)
    search = Search(q_step=0.02)
    ida = incremental_dynamic_analysis(ground, 0.01, motion.pga, 1, model, METHODS["taylor"], search)
    return ida, make_accuracy(motion, 1, ida, None, model, METHODS["taylor_6"], search)


@pytest.mark.shows("search.accuracy")
def test_that_the_default_agrees_with_independent_solvers(said):
    ida, found = said
    assert found.q == ida.q and found.q_reference == ida.q
    assert found.solver_q_difference == 0.0
    # at the last survived scale the motion amplifies what DOP853 itself leaves (3e-14 a step)
    assert found.history_difference < 1e-6
    # what the governing history does with the last digit of its samples bounds its error
    assert found.noise_effect < 1e-6 and found.history_bound >= PROMISED
    for effect, bound in ((0.0, 1e-9), (5.39e-9 / TIMES_NOISE, 6e-9), (0.0301 / TIMES_NOISE, 0.04), (np.inf, None)):
        assert replace(found, noise_effect=effect).history_bound == bound


def test_that_the_governing_history_is_the_last_that_the_search_survives(said, make_model, reference):
    """q = C PGA / a_RM, at the lower end of the bracket of q, by the method asked for."""
    ida, found = said
    model, ground = make_model(height=4.0), np.ascontiguousarray(reference("standard")[0][:700])
    by_hand = ida.bracket[0] * G * math.tan(model.slenderness) / np.abs(ground).max()
    assert found.scale == pytest.approx(by_hand, rel=1e-12) and found.method == "taylor_6"
    stands, falls = (
        integrate_history(ground, 0.01, by_hand * q / ida.bracket[0], model, METHODS["taylor"]).outcome
        for q in ida.bracket
    )
    assert stands == STABLE and falls == COLLAPSED


def test_that_a_spread_is_that_of_two_numbers_or_more(said):
    rows = ((0.01, 2.0, None), (0.02, None, None), (0.04, 3.0, 1.5))
    assert said[1].spread(1, rows) == 0.5 and said[1].spread(2, rows) is None


def test_that_the_chart_orders_the_methods(said):
    errors = {point.name: point.error for point in said[1].points}
    assert errors["taylor"] < 1e-6
    for crude in ("newmark_paper", "linearised"):
        assert errors[crude] is None or errors[crude] > 1e-3
    assert all(point.seconds > 0.0 for point in said[1].points)


def test_that_a_wall_with_ties_has_the_bound_and_no_other_solver(make_model, reference):
    """DOP853 and dormand_prince know no ties: what they say of the bare wall is not said of this one."""
    ground = np.ascontiguousarray(reference("standard")[0][:400])
    motion, search = GroundMotion("short", ground, 0.01), Search(q_step=0.05)
    bar = TieBar(3.5, 0.02, 5e-3, 0.0, 0.1).scaled(1.0)
    model = make_model(height=4.0, one_sided=True)._replace(bars=(bar,))
    ida = incremental_dynamic_analysis(ground, 0.01, motion.pga, 1, model, METHODS["taylor"], search)
    found = make_accuracy(motion, 1, ida, None, model, METHODS["rk4"], search)
    assert found.method == "taylor" and found.points == ()
    assert found.q_reference is found.solver_q_difference is found.history_difference is None
    assert found.history_bound >= PROMISED and found.noise_effect > 0.0
    assert found.spread(1, found.rounded) is not None


def test_that_the_spread_by_definition_stands_apart(said):
    ida, found = said
    own = ida.q, ida.q_robust, ida.q_slv_robust
    assert (0.02, *own) in found.steps and found.rounded[0] == own and None not in own
    assert len(found.steps) >= 3 and len(found.rounded) == NOISES + 1
    for column in (1, 2, 3):
        known = [row[column] for row in found.steps]
        assert found.spread(column, found.steps) == max(known) / min(known) - 1.0 >= 0.0
    assert found.polarities is None


def test_that_the_independent_solver_ends_soon_after_a_cancel(make_model, reference):
    """It takes seconds a history: a cancel is seen between its samples."""
    asked = []

    def cancelled():
        asked.append(True)
        return len(asked) > 3

    model, ground = make_model(), reference("standard")[0]
    with pytest.raises(Cancelled):
        reference_history(GroundMotion("long", ground, 0.01), 1.0, model, cancelled)
    assert len(asked) == 4


@pytest.mark.parametrize(("scale", "bounded"), [(0.5, True), (3.0, True)])
def test_that_noise_in_the_last_digit_has_a_small_effect_far_from_collapse(make_model, reference, scale, bounded):
    model, ground = make_model(), reference("standard")[0]
    found = effect_of_noise(GroundMotion("r", ground, 0.01), scale, model, METHODS["taylor"])
    assert (found < 1e-9) is bounded


@pytest.mark.shows("search.accuracy")
def test_that_a_history_next_to_collapse_has_no_bound(make_model, reference):
    """The multiplier at which the wall falls, to the last digits: noise decides whether it does."""
    model, ground = make_model(), reference("standard")[0]
    motion = GroundMotion("r", ground, 0.01)
    stands, falls = 1.0, None
    for scale in np.arange(1.0, 60.0, 0.25):
        if integrate_history(ground, 0.01, scale, model, METHODS["taylor"]).rotation.size < ground.size:
            falls = float(scale)
            break
        stands = float(scale)
    assert falls is not None
    while stands < 0.5 * (stands + falls) < falls:
        middle = 0.5 * (stands + falls)
        if integrate_history(ground, 0.01, middle, model, METHODS["taylor"]).rotation.size < ground.size:
            falls = middle
        else:
            stands = middle
    assert effect_of_noise(motion, stands, model, METHODS["taylor"]) == np.inf
