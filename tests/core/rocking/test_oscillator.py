import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from core.rocking import oscillator
from core.rocking.events import BlockState
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import AUTO
from core.rocking.oscillator import SWING_ENDS, SWING_FALLS, SWING_RISES, Oscillation
from core.units import G
from core.wall.rocking_model import RockingModel, with_branch

DT = 0.01


def wall(rng, one_sided: float) -> RockingModel:
    """A wall with a branch, small as of a parapet."""
    rigid = RockingModel(
        rng.uniform(0.08, 0.25), rng.uniform(1.0, 12.0), one_sided, rng.uniform(0.7, 0.95), 0.0, 0.0, 0.0
    )
    return with_branch(rigid, 10.0 ** rng.uniform(-3.5, -1.5))


def ground(rng, samples: int, strength: float) -> np.ndarray:
    """Noise that begins and ends at rest [m/s2]."""
    noise = np.convolve(rng.normal(size=samples), np.ones(4) / 4.0, "same")
    return strength * noise * np.hanning(samples)


def forcing(model: RockingModel) -> float:
    """p2 cos(alpha - phi1) / g, from the definition."""
    return model.p2 * math.cos(model.slenderness - model.elastic_end) / G


@pytest.mark.shows("mechanics.branch")
def test_an_event_of_a_swing_is_where_50_digits_find_it():
    rng = np.random.default_rng(4)
    seen = {SWING_ENDS: 0, SWING_FALLS: 0, SWING_RISES: 0}
    with mpmath.workdps(50):
        for _ in range(300):
            end, span = 1.0, rng.uniform(0.2, 1.6)
            phi, speed = float(rng.choice([0.0, rng.uniform(0.0, 1.0), 1.0])), rng.normal() * rng.choice([0.1, 1.0])
            if phi in (0.0, 1.0):
                speed = abs(speed) if phi == 0.0 else -abs(speed)
            first, jump = rng.normal(size=2)
            sine, versine = math.sin(span), 1.0 - math.cos(span)
            parts = Oscillation(2.0, 0.7, end, span, sine, versine)
            state = BlockState(1.0, phi, speed, True, 0, phi, 0, 0)
            found, t, event = oscillator.advance_oscillation.py_func(parts, state, first, jump, 0.0)
            f0, f1 = mpmath.mpf(0.7) * first, mpmath.mpf(0.7) * jump / span

            def rotation(x, f0=f0, f1=f1, phi=phi, speed=speed):
                u0 = mpmath.mpf(speed) / 2
                return phi * mpmath.cos(x) + f0 * (1 - mpmath.cos(x)) + f1 * (x - mpmath.sin(x)) + u0 * mpmath.sin(x)

            x = np.linspace(1e-6, t * span, 400, endpoint=False)
            swung = phi * np.cos(x) + float(f0) * (1.0 - np.cos(x)) + float(f1) * (x - np.sin(x))
            before = swung + 0.5 * speed * np.sin(x)
            assert before.min() > -1e-9 and before.max() < 1.0 + 1e-9  # nothing happens before it
            assert found.peak >= max(before.max(), phi) - 1e-9
            at = {SWING_ENDS: found.phi, SWING_FALLS: 0.0, SWING_RISES: 1.0}[event]
            assert float(rotation(mpmath.mpf(t) * span)) == pytest.approx(at, abs=4e-15)
            assert found.speed == pytest.approx(2.0 * float(mpmath.diff(rotation, mpmath.mpf(t) * span)), abs=2e-14)
            seen[event] += 1
    assert min(seen.values()) > 10


def independent(model: RockingModel, record: np.ndarray, impacts: int):
    """(times, rotations) from rest to the given impact by another solver, events by its own search."""
    omega2 = model.p2 * model.driven.stiffness
    end, alpha, push = model.elastic_end, model.slenderness, forcing(model)

    def at(time):
        return np.interp(time, DT * np.arange(record.size), record)

    def rhs(time, y, side):
        phi = y[0]
        if phi <= end:
            return [y[1], -omega2 * phi + push * side * at(time)]
        return [y[1], -model.p2 * math.sin(alpha - phi) + model.p2 * side * at(time) * math.cos(alpha - phi) / G]

    def lands(time, y, side):
        return y[0] if time > start + 1e-9 else 1.0

    def kink(time, y, side):
        return y[0] - end

    lands.terminal, lands.direction = True, -1
    kink.terminal = True
    times, values, start, side, y, done = [], [], DT, 0.0, [0.0, 0.0], 0
    side = 1.0 if at(start * 1.001) > 0.0 else -1.0
    last = DT * (record.size - 1)
    while done < impacts and start < last:
        stop = DT * (math.floor(start / DT + 1e-9) + 1)  # the ground has a corner at each sample
        events = {"events": (lands, kink), "args": (side,)}
        found = solve_ivp(rhs, (start, stop), y, "DOP853", rtol=1e-12, atol=1e-16, **events)
        start, y = float(found.t[-1]), [float(v) for v in found.y[:, -1]]
        if found.t_events[0].size:
            done += 1
            y = [0.0, -model.ratio_at_rest * y[1]]
            side = side if model.one_sided else -side
        elif found.t_events[1].size:
            y[0] = end * (1.0 + (1e-13 if y[1] > 0.0 else -1e-13))
        else:
            times.append(start)
            values.append(side * y[0])
    return np.array(times), np.array(values)


@pytest.mark.shows("mechanics.branch")
@pytest.mark.parametrize("seed", range(6))
def test_a_history_with_the_branch_is_that_of_an_independent_solver(seed):
    rng = np.random.default_rng(20 + seed)
    model = wall(rng, 0.0)
    record = np.append([0.0, 0.0], ground(rng, 300, rng.uniform(1.0, 4.0))[1:])
    found = integrate_history(record, DT, 1.0, model)
    times, rotations = independent(model, record, 12)
    there = np.round(times / DT).astype(int)
    assert times.size > 5
    assert found.rotation[there] == pytest.approx(rotations, rel=1e-6, abs=1e-7 * np.abs(rotations).max())


@pytest.mark.parametrize("one_sided", [0.0, 1.0])
def test_many_multipliers_are_as_their_histories(one_sided):
    rng = np.random.default_rng(7)
    for _ in range(6):
        model = wall(rng, one_sided)
        record = ground(rng, 400, 2.0)
        scales = np.concatenate([np.geomspace(0.01, 3.0, 20), -np.geomspace(0.01, 3.0, 20)])
        outcomes, peaks = np.zeros(40, np.int64), np.zeros(40)
        scan_multipliers(AUTO, record, DT, scales, model, outcomes, peaks)
        alone = [integrate_history(record, DT, float(scale), model) for scale in scales]
        assert outcomes.tolist() == [one.outcome for one in alone]
        stable = outcomes == 0
        single = [one.peak for one in alone if one.outcome == 0]
        assert peaks[stable] == pytest.approx(single, rel=1e-5)  # the first part is shared
        assert not one_sided or peaks[stable].tolist() == single


@pytest.mark.shows("mechanics.branch")
def test_on_the_branch_a_motion_is_proportional_to_its_ground():
    rng = np.random.default_rng(9)
    model, record = wall(rng, 0.0), ground(rng, 800, 1.0)
    scales = np.array([1e-4, 1e-3, 2e-3])
    peaks = np.zeros(3)
    scan_multipliers(AUTO, record, DT, scales, model, np.zeros(3, np.int64), peaks)
    assert (peaks < model.elastic_end).all()
    assert peaks / scales == pytest.approx(peaks[0] / scales[0], rel=1e-12)


def test_a_branch_that_is_over_at_once_leaves_the_rigid_wall():
    rigid = RockingModel(0.1, 2.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    model = with_branch(rigid, 1e-7)
    record = 0.12 * G * np.sin(2.0 * math.pi * 1.2 * DT * np.arange(300))
    stiff, free = integrate_history(record, DT, 1.0, model), integrate_history(record, DT, 1.0, rigid)
    assert stiff.outcome == free.outcome
    assert np.abs(stiff.rotation - free.rotation).max() < 0.02 * np.abs(free.rotation).max()
