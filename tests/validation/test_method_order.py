"""The measured order of every method, against 30 digits on one smooth step."""

import math

import mpmath as mp
import numpy as np
import pytest

from core.rocking import taylor, taylor_series
from core.rocking.compared import dormand_prince, stepped
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS, Method
from core.wall.rocking_model import RockingModel
from tests.validation import high_precision

ALPHA, P2, BETA, SLOPE, PHI, SPEED = 0.2, 4.0, 0.05, 0.11, 0.09, 0.13
MODEL = RockingModel(ALPHA, P2, 0.0, 0.9, 0.0, 0.0, 0.0)


def truth(h: float) -> tuple[float, float]:
    with mp.workdps(30):
        c = high_precision._coefficients(
            mp.mpf(PHI), mp.mpf(SPEED), mp.mpf(BETA), mp.mpf(SLOPE), mp.mpf(P2), mp.mpf(ALPHA), (1, 0, 0)
        )
        return high_precision._value(c, mp.mpf(h)), high_precision._rate(c, mp.mpf(h))


def local_error(step, h: float) -> float:
    phi, speed = step(h)
    exact_phi, exact_speed = truth(h)
    return float(max(abs(phi - exact_phi), abs(speed - exact_speed)))


def taylor_step(order):
    def step(h):
        lean = ALPHA - PHI
        net = math.sin(lean) - BETA * math.cos(lean)
        v = taylor_series.series(
            SPEED * h, net, math.sin(lean), math.cos(lean), BETA, SLOPE * h, P2 * h * h, 1.0, 0.0, order
        )
        return PHI + taylor.increment(v, 1.0), SPEED + taylor.speed_increment(v, 1.0) / h

    return step


def stepped_step(code):
    def step(h):
        table, one, two = dormand_prince.tableau(), np.zeros(12), np.zeros(12)
        if code == stepped.DORMAND_PRINCE:
            return dormand_prince.single_step(PHI, SPEED, BETA, SLOPE, h, MODEL, 2, table, one, two)[:2]
        return stepped.advance(code, PHI, SPEED, BETA, SLOPE, h, MODEL, 2, 0.0, table, one, two)

    return step


@pytest.mark.shows("mechanics.orders")
@pytest.mark.parametrize(
    "name, step, order, h",
    [
        ("taylor", taylor_step(6), 6, 0.2),
        ("taylor", taylor_step(8), 8, 0.3),
        ("newmark_events", stepped_step(stepped.NEWMARK_EVENTS), 2, 0.05),
        ("rk4", stepped_step(stepped.RK4), 4, 0.05),
        ("dormand_prince", stepped_step(stepped.DORMAND_PRINCE), 8, 0.5),
    ],
)
def test_that_the_local_error_falls_with_the_stated_order(name, step, order, h):
    found = math.log2(local_error(step, h) / local_error(step, 0.5 * h)) - 1.0
    assert found == pytest.approx(order, abs=0.35)
    if name != "taylor" or order == 8:
        assert METHODS[name].order == order


@pytest.mark.shows("mechanics.orders")
def test_that_the_linearised_form_converges_to_its_own_equation_only():
    """Halving the step leaves its error: the equation is another one."""
    step = stepped_step(stepped.LINEARISED)
    half = step(0.05)
    whole = step(0.1)
    again = stepped.advance(
        stepped.LINEARISED,
        *half,
        BETA + 0.05 * SLOPE,
        SLOPE,
        0.05,
        MODEL,
        2,
        0.0,
        dormand_prince.tableau(),
        np.zeros(12),
        np.zeros(12),
    )
    assert again == pytest.approx(whole, rel=1e-13)
    assert local_error(step, 0.1) > 1e-5
    assert METHODS["linearised"].order == 0


@pytest.mark.shows("mechanics.orders")
def test_that_the_papers_integrator_is_of_order_one_through_its_impacts(make_model):
    """Free decay through six impacts: the error falls with the step, not with its square."""
    model = make_model()
    start = (0.6 * model.slenderness, 0.0)
    steps = [0.01 / 2**k for k in range(6)]
    errors = []
    for dt in steps:
        still = np.zeros(round(6.0 / dt) + 1)
        exact = integrate_history(still, dt, 1.0, model, start=start).rotation
        found = integrate_history(still, dt, 1.0, model, METHODS["newmark_paper"], start=start).rotation
        errors.append(np.abs(found - exact).max())
    slope = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert slope == pytest.approx(1.0, abs=0.3)


def test_that_a_method_of_the_program_needs_no_more_steps_to_be_exact(reference, make_model):
    """The default at the record's step against itself at an eighth of it."""
    ground = reference("standard")[0]
    fine = np.interp(np.arange(8 * (ground.size - 1) + 1) / 8, np.arange(ground.size), ground)
    for law in ("rigid", "doherty"):
        model = make_model(law=law)
        coarse = integrate_history(ground[:1200], 0.01, 1.0, model, Method("taylor", 0, 8, 8)).rotation
        finer = integrate_history(fine[: 8 * 1199 + 1], 0.00125, 1.0, model).rotation[::8]
        assert np.abs(coarse - finer).max() / model.slenderness < 1e-11
