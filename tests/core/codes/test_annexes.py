"""National annexes of EN 1998-1: each file is a code, and Spain's numbers are those of its tables."""

import math
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.annexes import ANNEXES, FOLDER, annex, annex_spectrum
from core.errors import InputError
from core.setting.demand_input import demand_of
from core.study.run import run
from core.units import G
from tests.clauses_alone import parse_case as clauses_alone

WALL = {"name": "w", "mechanism": "two_sided", "height_m": 3.0, "thickness_m": 0.4, "base_z_m": 0.0}
SPAIN = {"code": "EN1998-ES", "soil": "C", "vs30_m_s": 300.0, "contribution_k": 1.1}


def demand_with(**changes):
    spectrum = {key: value for key, value in {**SPAIN, **changes}.items() if value is not None}
    case = parse_case({"wall": [WALL], "demand": {"ag_g": 0.23, "spectrum": spectrum}})
    return demand_of(case, Path())


def test_that_each_file_is_a_code_and_names_its_source():
    assert {path.stem for path in FOLDER.glob("*.toml")} == set(ANNEXES)
    for code in ANNEXES:
        assert annex(code)["source"] and "EN 1998-1" in annex(code)["name"]


@pytest.mark.shows("demand.annex")
@pytest.mark.parametrize("k", [1.0, 1.3])
@pytest.mark.parametrize("ag", [0.05, 0.1, 0.25, 0.4, 0.5])
@pytest.mark.parametrize(("soil", "vs30"), [("A", 900.0), ("B", 575.0), ("C", 300.0), ("C", 180.0), ("D", 150.0)])
def test_that_spain_is_by_table_an_2(soil, vs30, ag, k):
    """S, T_B, T_C, T_D written out here a second time, as the table has them."""
    c = (800.0 / vs30) ** 0.465
    weak, t_c = {"A": (1.0, k / 4.0), "B": (c, k * c / 4.0), "C": (c, k * c / 4.0), "D": (2.0, k / 2.0)}[soil]
    if soil == "D":
        between = 2.33 - 3.33 * ag
    else:
        between = weak + 3.33 * (ag - 0.1) * (1.0 - weak)
    s = weak if ag <= 0.1 else between if ag <= 0.4 else 1.0
    made = annex_spectrum("EN1998-ES", ag * G, soil, vs30, k)
    assert made.soil == pytest.approx(s, abs=0.0035)  # of D the print rounds 2.333 to 2.33
    assert soil == "D" or made.soil == pytest.approx(s, rel=1e-12)
    assert (made.t_b, made.t_c, made.t_d) == pytest.approx((t_c / 5.0, t_c, 2.0), rel=1e-12)
    plateau = made.acceleration([t_c])[0]
    assert plateau == pytest.approx(2.5 * ag * G * made.soil, rel=1e-12)
    assert made.acceleration([4.0])[0] == pytest.approx(plateau * t_c * 2.0 / 16.0, rel=1e-12)


@pytest.mark.shows("demand.annex")
def test_that_grounds_meet_where_their_velocities_do():
    for one, other, vs30 in (("A", "B", 800.0), ("B", "C", 360.0), ("C", "D", 180.0)):
        first, second = (annex_spectrum("EN1998-ES", 0.2 * G, soil, vs30, 1.0) for soil in (one, other))
        periods = np.linspace(0.02, 4.0, 200)
        assert np.allclose(first.acceleration(periods), second.acceleration(periods), rtol=2e-3)


def test_that_a_case_takes_it_from_file_to_verdict():
    demand = demand_with()
    c = (800.0 / 300.0) ** 0.465
    assert demand.target.t_c == pytest.approx(1.1 * c / 4.0) and demand.soil_factor == demand.target.soil
    result = run(clauses_alone({"wall": [WALL], "demand": {"ag_g": 0.23, "spectrum": SPAIN}}), base_dir=Path())
    assert math.isfinite(result.verdicts[0].zeta_least)
    assert demand.target.name == "AN/UNE-EN 1998-1, C, v_s,30 300 m/s, K 1.1"
    assert any(one.code == "annex_unseen" for one in result.walls[0].assessed.verdict.limits)


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"vs30_m_s": 500.0}, "annex_velocity"),
        ({"soil": "E"}, "annex_ground"),
        ({"vs30_m_s": None}, "code_needs"),
        ({"type": 1}, "code_does_not_take"),
        ({"code": "EN1998", "type": 1}, "code_does_not_take"),
    ],
)
def test_that_what_the_annex_has_not_is_refused(changes, code):
    with pytest.raises(InputError) as refused:
        demand_with(**changes)
    assert refused.value.code == code
