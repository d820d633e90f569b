"""Floor spectra and the checks above the ground, against worked values of two independent scripts: EN 1998-1 type 1,
soil B, a_g 0.26 g, building 9 m, three storeys, T_1 = 1.5 x 0.2598 s, xi_1 10 %, e* = 1, FC 1.35, q = 2."""

import numpy as np
import pytest

from core.case.rules import parse_wall
from core.codes.demand import DemandResult
from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_mode, first_participation
from core.codes.kinematic import kinematic, linear, nonlinear
from core.codes.target_spectrum import en1998
from core.ground.floor_motion import Mode
from core.units import G

TARGET = en1998(0.26 * G, 1, "B")
PERIOD = 1.5 * estimated_period(9.0)


def floor(z: float) -> FloorSpectrum:
    return FloorSpectrum(TARGET, first_mode(3, 9.0, z, PERIOD, 0.10))


@pytest.mark.shows("kinematic.participation")
def test_the_period_and_the_participation():
    assert pytest.approx(0.3897, abs=5e-5) == PERIOD
    assert first_participation(3) == pytest.approx(9.0 / 7.0)


@pytest.mark.shows("kinematic.floor_spectrum")
@pytest.mark.parametrize("z, a_z", [(6.0, 0.5567), (7.5, 0.69587), (9.0, 0.83505)])
def test_the_largest_acceleration_of_the_floor(z, a_z):
    assert floor(z).a_z / G == pytest.approx(a_z, abs=5e-6)


@pytest.mark.shows("kinematic.floor_spectrum")
def test_the_spectrum_at_six_metres():
    periods = [0.0, 0.1, 0.3118, 0.4286, 0.6, 1.0]
    expected = [0.55670, 0.80702, 1.69840, 1.69840, 1.00961, 0.43606]
    assert floor(6.0).acceleration(periods, 0.08) / G == pytest.approx(expected, abs=6e-6)
    # beyond T_1 not below the spectrum of the ground; 0.19911 before it
    at = floor(6.0)
    alone = float(at._of_mode(at.modes[0], np.array([1.6959]), 0.08)[0])
    assert alone / G == pytest.approx(0.19911, abs=6e-6)
    assert at.acceleration([1.6959], 0.08) == pytest.approx(TARGET.acceleration([1.6959], 0.08))


def test_that_the_spectrum_starts_at_the_acceleration_of_the_floor():
    modes = (Mode(0.4, 0.1, 1.2), Mode(0.13, 0.05, -0.3))
    at = FloorSpectrum(TARGET, modes)
    assert at.acceleration([0.0], 0.05)[0] == pytest.approx(at.a_z, rel=1e-12)


WALLS = {
    # H, t, z, free -> zeta linear, T_SLV, S_De or S_DeZ, zeta of the displacement alone
    "3.0x0.45 at 6": (3.0, 0.45, 6.0, False, 0.3992, 1.95824, 0.16639, 0.5409),
    "3.0x0.30 at 6": (3.0, 0.30, 6.0, False, 0.2661, 1.95824, 0.16639, 0.3606),
    "3.0x0.45 at 7.5": (3.0, 0.45, 7.5, False, 0.3193, 1.95824, 0.19375, 0.4645),
    "parapet": (1.2, 0.25, 9.0, True, 0.2904, 1.23850, 0.17976, 0.2781),
    "7.0x0.83": (7.0, 0.83, 0.0, False, 0.5630, 2.99126, 0.16994, 0.9768),
    "3.0x0.45": (3.0, 0.45, 0.0, False, 0.7123, 1.95824, 0.16639, 0.5409),
    "3.0x0.45 free": (3.0, 0.45, 0.0, True, 0.2849, 1.95824, 0.16639, 0.5409),
    "1.0x0.20": (1.0, 0.20, 0.0, False, 0.9497, 1.13059, 0.09606, 0.4164),
}


@pytest.mark.shows("kinematic.at_height", "kinematic.displacement_at_height")
@pytest.mark.parametrize("name", WALLS)
def test_the_checks_of_the_worked_walls(name):
    height, thickness, z, free, zeta, period, s_de, displacement = WALLS[name]
    wall = parse_wall(
        {
            "name": name,
            "height_m": height,
            "thickness_m": thickness,
            "mechanism": "one_sided",
            "base_z_m": z,
            "free_element": free,
            "unit_weight_kn_m3": 18.0,
            "elastic_modulus_mpa": 600.0,
        }
    )
    demand = DemandResult(
        limit_state="SLV",
        ag=0.26 * G,
        soil_factor=1.2,
        pga=0.312 * G,
        intensity=None,
        intensity_source=None,
        q_code=2.0,
        confidence_factor=1.35,
        zeta_target=1.0,
        target=TARGET,
    )
    found = kinematic(wall.in_si, "one_sided", demand, floor(z) if z else None)
    assert linear("linear_q_code", found, demand, 2.0).zeta == pytest.approx(zeta, abs=6e-5)
    assert found.period == pytest.approx(period, abs=6e-6)
    assert found.s_de == pytest.approx(s_de, abs=6e-6)
    assert found.d_limit / found.s_de == pytest.approx(displacement, abs=6e-5)
    checked = nonlinear(found, demand)
    assert checked.zeta == max(found.d_limit / found.s_de, found.zeta_sld)


def test_the_free_parapet():
    """T_0 0.06246 s, S_eZ(T_0, 5 %) 1.06278 g."""
    at = floor(9.0)
    assert at.acceleration([0.06246180], 0.05)[0] / G == pytest.approx(1.06278, abs=6e-6)


@pytest.mark.shows("kinematic.floor_spectrum")
def test_that_the_spectrum_has_a_plateau_at_the_mode_not_a_dip():
    """xi_k in A is a fraction: in per cent A would be below 1."""
    at = floor(6.0)
    assert at.acceleration([PERIOD], 0.05)[0] > 2.0 * at.acceleration([0.0], 0.05)[0]
