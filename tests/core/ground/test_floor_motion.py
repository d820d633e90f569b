"""The motion of a floor against closed forms and against direct integration of a three-storey building."""

import math

import numpy as np
import pytest

from core.ground.floor_motion import Mode, floor_acceleration, floor_motion, modal_acceleration
from core.ground.ground_motion import GroundMotion

DT = 0.01


@pytest.fixture
def ground():
    rng = np.random.default_rng(5)
    walk = np.cumsum(rng.normal(size=1500)) * np.hanning(1500)
    return 3.0 * walk / np.abs(walk).max()


@pytest.mark.shows("mechanics.floor_samples")
def test_that_no_participation_gives_the_record_bit_for_bit(ground):
    for modes in ((), (Mode(0.4, 0.1, 0.0),), (Mode(0.4, 0.1, 0.0), Mode(0.1, 0.05, 0.0))):
        floor, dt = floor_acceleration(ground, DT, modes)
        assert floor is ground and dt == DT
    motion = GroundMotion("a", ground, DT)
    assert floor_motion(motion, (Mode(0.4, 0.1, 0.0),)) is motion


@pytest.mark.shows("mechanics.floor_samples")
@pytest.mark.parametrize("participation", [0.3, 1.2, -0.5, 4.0])
def test_that_a_stiff_building_moves_as_the_ground(ground, participation):
    floor, dt = floor_acceleration(ground, DT, [Mode(1e-5, 0.1, participation)])
    parts = round(DT / dt)
    whole = floor[::parts][: ground.size]
    assert np.abs(whole - ground[: whole.size]).max() < 1e-5 * np.abs(ground).max()


@pytest.mark.shows("mechanics.floor_motion")
@pytest.mark.parametrize("period", [0.08, 0.39, 1.1])
@pytest.mark.parametrize("damping", [0.02, 0.1, 0.25])
def test_that_the_recursion_is_exact_for_a_ground_linear_between_samples(ground, period, damping):
    """Against the matrix exponential of scipy, and a ground that does not begin at zero."""
    from scipy.signal import lsim

    omega, times = 2.0 * math.pi / period, DT * np.arange(ground.size)
    system = ([2.0 * damping * omega, omega**2], [1.0, 2.0 * damping * omega, omega**2])
    for moved in (ground, ground + 1.0):
        _, expected, _ = lsim(system, moved, times)
        found = modal_acceleration(moved, DT, period, damping)
        assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max()


@pytest.mark.shows("mechanics.floor_motion")
def test_that_a_three_storey_shear_building_is_that_of_direct_integration(ground):
    """Uniform storeys: frequencies 1 : 2.80194 : 4.04892, gamma psi at the roof 1.22041, -0.28011, 0.05970."""
    from scipy.linalg import eigh
    from scipy.signal import lsim

    stiffness = np.array([[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]])
    squares, shapes = eigh(stiffness)
    scale = (2.0 * math.pi / 0.4) ** 2 / squares[0]
    omegas = np.sqrt(scale * squares)
    assert omegas / omegas[0] == pytest.approx([1.0, 2.80194, 4.04892], abs=5e-6)
    participations = shapes * shapes.sum(axis=0)
    assert participations[2] == pytest.approx([1.22041, -0.28011, 0.05970], abs=5e-6)
    assert participations.sum(axis=1) == pytest.approx(np.ones(3), abs=1e-12)
    # damping 8 % in every mode, so that the building has classical modes
    damping = shapes @ np.diag(2.0 * 0.08 * omegas) @ shapes.T
    system = np.block([[np.zeros((3, 3)), np.eye(3)], [-scale * stiffness, -damping]])
    push = np.concatenate([np.zeros(3), -np.ones(3)])[:, None]
    for storey in range(3):
        output = np.concatenate([-scale * stiffness[storey], -damping[storey]])[None, :]
        modes = [
            Mode(2.0 * math.pi / omega, 0.08, part) for omega, part in zip(omegas, participations[storey], strict=True)
        ]
        floor, dt = floor_acceleration(ground, DT, modes)
        times = dt * np.arange(floor.size)
        # after the record the ground falls to zero within a sample
        still = np.append(ground, np.zeros(floor.size))
        fine = np.interp(times, DT * np.arange(still.size), still)
        _, expected, _ = lsim((system, push, output, np.zeros((1, 1))), fine, times)
        assert np.abs(floor - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.shows("mechanics.floor_samples")
@pytest.mark.parametrize("dt", [0.005, 0.01, 0.02])
@pytest.mark.parametrize(
    "modes",
    [
        [(0.39, 1.0)],
        [(0.2, 1.2)],
        [(0.1, 0.8)],
        [(0.05, 1.0)],
        [(0.02, 1.0)],
        [(0.3, 1.22), (0.1, -0.28), (0.06, 0.06)],
    ],
)
def test_that_a_floor_motion_is_linear_between_its_samples_within_a_thousandth(dt, modes):
    """Against samples 16 times as close, exact for a ground linear between samples: sharp noise of five seconds."""
    rng = np.random.default_rng(7)
    ground = rng.normal(size=round(5.0 / dt)) * np.hanning(round(5.0 / dt))
    modes = [Mode(period, 0.05, part) for period, part in modes]
    floor, step = floor_acceleration(ground, dt, modes)
    parts = round(dt / step)
    finer = 16 * parts
    moving = np.interp(np.arange((ground.size - 1) * finer + 1) / finer, np.arange(ground.size), ground)
    exact = (1.0 - sum(mode.participation for mode in modes)) * moving
    for mode in modes:
        exact += mode.participation * modal_acceleration(moving, dt / finer, mode.period, mode.damping)
    known = np.arange(min(floor.size, (ground.size - 1) * parts + 1))
    drawn = np.interp(np.arange(exact.size) / 16.0, known, floor[: known.size])
    assert np.abs(drawn - exact).max() <= 1e-3 * np.abs(exact).max()


def test_that_the_free_motion_after_the_record_is_kept_to_a_thousandth(ground):
    mode = Mode(0.5, 0.05, 1.0)
    floor, dt = floor_acceleration(ground, DT, [mode])
    assert floor.size * dt > ground.size * DT + 2.0
    assert np.abs(floor[-1]) < 2e-3 * np.abs(floor).max()


def test_that_a_floor_motion_keeps_its_record_and_that_record_s_pga(ground):
    record = GroundMotion("a", ground, DT, file="a.txt", details=(("station", "X"),))
    floor = floor_motion(record, [Mode(0.3, 0.1, 1.0)])
    assert (floor.name, floor.file, floor.details) == (record.name, record.file, record.details)
    assert floor.ground_pga == record.pga and floor.pga > record.pga
    assert floor.samples_sha256 != record.samples_sha256


@pytest.mark.parametrize(("period", "parts"), [(1.0, 1), (0.05, 2), (0.02, 4), (0.0125, 7), (1e-5, 64)])
def test_that_a_smooth_ground_is_sampled_eight_times_in_the_shortest_period(period, parts):
    """A ground and a floor so slow that they are linear between any of these samples; 64 parts of a step at most."""
    slow = np.sin(np.pi * np.linspace(0.0, 1.0, 2000)) ** 4
    _, dt = floor_acceleration(slow, DT, [Mode(1.0, 0.05, 0.5), Mode(period, 0.05, 0.5)])
    assert dt == pytest.approx(DT / parts)


@pytest.mark.shows("mechanics.floor_samples")
@pytest.mark.parametrize("damping", [0.05, 0.1, 0.3, 0.5])
@pytest.mark.parametrize("period", [0.3, 1.0])
def test_that_no_free_motion_above_a_thousandth_of_the_peak_is_left_out(ground, period, damping):
    """Of a record that ends at rest, and of others that break off: the envelope may then begin above the peak. Nothing
    smaller is kept at the end, but for the record itself."""
    for moved in (ground, np.ones(3), np.ones(51), 0.1 * np.arange(159)):
        floor, dt = floor_acceleration(moved, DT, [Mode(period, damping, 1.0)])
        parts = round(DT / dt)
        still = np.append(moved, np.zeros(4000))
        fine = np.interp(np.arange((still.size - 1) * parts + 1) / parts, np.arange(still.size), still)
        whole = modal_acceleration(fine, dt, period, damping)
        limit = 1e-3 * np.abs(whole).max()
        assert np.abs(whole[: floor.size] - floor).max() < 1e-12 * np.abs(whole).max()
        assert np.abs(whole[floor.size :]).max() <= limit
        assert np.abs(floor[-1]) > limit or floor.size == (moved.size - 1) * parts + 1
