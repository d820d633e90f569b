"""The displacement demand of C8.7.1.2.1.8: the largest S_De on [T_0, T_SLV], by hand and by brute force."""

import math

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.kinematic import analyse_mechanism, check_displacement, check_linear
from core.codes.target_spectrum import given, largest_displacement
from core.errors import InputError
from core.setting.demand_input import read_demand
from core.units import G
from tests.holds import BOUND
from tests.validation.circolare import FREE, case, mechanism_of


def site_spectrum(tmp_path, end=5.0):
    """A site's spectrum with a hump at 1.2 s, beyond which S_De falls: (file, S_e [g] at a period)."""
    rows = [
        (0.0, 0.312),
        (0.15, 0.78),
        (0.5, 0.78),
        (1.0, 0.39),
        (1.2, 0.70),
        (1.5, 0.25),
        (2.0, 0.10),
        (3.0, 0.04),
        (5.0, 0.01),
    ]
    rows = [row for row in rows if row[0] < end] + [(end, float(np.interp(end, *np.transpose(rows))))]
    (tmp_path / "site.txt").write_text("\n".join(f"{t} {s}" for t, s in rows))
    return {"spectrum": None, "spectrum_file": "site.txt", "soil_factor": 1.2}


def without(demand):
    return {key: value for key, value in demand.items() if value is not None}


@pytest.mark.shows("kinematic.displacement")
def test_that_the_displacement_demand_of_a_site_is_its_largest_up_to_t_slv(tmp_path):
    wall = {"height_m": 5.0, "thickness_m": 0.5} | BOUND
    table = {
        "wall": [{"name": "w", "base_z_m": 0.0, "mechanism": "two_sided", **wall}],
        "demand": {"ag_g": 0.26, **without(site_spectrum(tmp_path))},
    }
    demand = read_demand(parse_case(table), tmp_path)
    found = analyse_mechanism(parse_case(table).wall[0].in_si, "two_sided", demand)
    # by brute force over [0, T_SLV]: the hump decides, not S_De(T_SLV)
    periods = np.linspace(1e-3, found.period, 200001)
    values = demand.target.acceleration(periods, 0.08) * (periods / (2.0 * math.pi)) ** 2
    assert found.s_de == pytest.approx(values.max(), rel=1e-5)  # of the grid
    assert found.s_de > 2.0 * values[-1]
    # free, T_0 beyond the hump: only what lies between T_0 and T_SLV counts
    free = {key: value for key, value in table["wall"][0].items() if key != "hold"}
    slow = analyse_mechanism(
        parse_case({**table, "wall": [{**free, **FREE, "elastic_modulus_mpa": 40.0}]}).wall[0].in_si,
        "two_sided",
        demand,
    )
    inside = periods >= slow.period_0
    assert 1.5 < slow.period_0 < slow.period
    assert slow.s_de == pytest.approx(values[inside].max(), rel=1e-5)


@pytest.mark.shows("kinematic.displacement")
def test_that_the_largest_s_de_is_found_inside_a_branch():
    # S_e falls from 1 g at 1 s to 0.1 g at 2 s: S_e T^2 with S_e = 1.9 - 0.9 T is largest at T = 1.9/1.35 s
    rows = [(0.0, 0.4 * G), (0.1, 1.0 * G), (1.0, 1.0 * G), (2.0, 0.1 * G), (3.0, 0.01 * G)]
    target = given("site", 0.4 * G, 1.0, rows)
    top = 1.9 / 1.35
    by_hand = (1.9 - 0.9 * top) * G * (top / (2.0 * math.pi)) ** 2
    assert largest_displacement(target, 0.0, 3.0, 0.05) == pytest.approx(by_hand, rel=1e-12)


@pytest.mark.shows("kinematic.displacement")
def test_that_a_spectrum_that_ends_before_t_slv_is_refused(tmp_path):
    demand = read_demand(
        parse_case(
            {
                "wall": [{"name": "w", "height_m": 9.0, "thickness_m": 0.9, "base_z_m": 0.0, "mechanism": "two_sided"}],
                "demand": {"ag_g": 0.26, **without(site_spectrum(tmp_path, 3.0))},
            }
        ),
        tmp_path,
    )
    wall = case({"height_m": 9.0, "thickness_m": 0.9}).wall[0]
    with pytest.raises(InputError, match=r'wall "w".*ends at 3.00 s, before T_SLV = 3.39 s'):
        analyse_mechanism(wall.in_si, "two_sided", demand)


@pytest.mark.shows("kinematic.elastic_to_d_slv")
def test_that_a_wall_elastic_up_to_d_slv_has_no_linear_check():
    """12 x 0.40 m, E 200 MPa: T_0 = 6.9 s beyond T_SLV, where S_e(T_0) is next to nothing and would let a wall of
    d_SLV / S_De = 0.47 pass."""
    wall = {"height_m": 12.0, "thickness_m": 0.40, "elastic_modulus_mpa": 200.0, "unit_weight_kn_m3": 19.0}
    found, demand = mechanism_of(case(wall))
    assert found.period_0 > found.period and found.missing == ("period_0",)
    assert check_linear("linear_q_code", found, demand, 2.0) is None
    check = check_displacement(found, demand)
    assert check.zeta == pytest.approx(0.080 / 0.170, abs=2e-3) and check.passed is False


@pytest.mark.parametrize(("share", "missing"), [(1.01, ()), (0.99, ("period_0",))])
def test_that_a_wall_is_elastic_up_to_d_slv_where_its_modulus_is_below_that_of_the_closed_form(share, missing):
    """a_0* (T_0 / 2 pi)^2 = 0.4 d_0 with a_0* = (t / h) g / FC, d_0 = t / 2 and T_0 = 6.2 (h / t) h sqrt(w / (E g)):
    E = 6.2^2 h^3 w / (4 pi^2 0.2 FC t^2)."""
    height, thickness, weight = 12.0, 0.40, 19e3
    modulus = 6.2**2 * height**3 * weight / (4.0 * math.pi**2 * 0.2 * 1.35 * thickness**2)
    wall = {"height_m": height, "thickness_m": thickness, "unit_weight_kn_m3": 1e-3 * weight}
    found, _ = mechanism_of(case({**wall, "elastic_modulus_mpa": 1e-6 * share * modulus}))
    assert found.missing == missing
