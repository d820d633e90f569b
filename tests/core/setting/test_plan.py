"""What a study knows before its first analysis."""

from pathlib import Path

import pytest

from core.setting.plan import make_plan, read_inputs
from tests.clauses_alone import parse_case

WALLS = [
    {"name": name, "height_m": height, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "one_sided"}
    for name, height in (("low", 3.0), ("high", 6.0))
]
SPECTRUM = {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}


def longest(**keys) -> float:
    case = parse_case({"wall": WALLS, **keys})
    return make_plan(case, read_inputs(case, Path())).longest_period


def test_that_no_period_is_that_of_no_mechanism():
    """Without a demand there is no mechanism, and without a spectrum none of them has T_SLV."""
    assert longest() == longest(demand={"ag_g": 0.2}) == 0.0


def test_that_the_longest_period_of_walls_alike_but_in_height_is_that_of_the_highest():
    """d_0 over a_0 grows with H: twice as high a wall has sqrt(2) times the T_SLV, but for theta_0 and tan(theta_0)."""
    case = parse_case({"wall": WALLS[:1], "demand": SPECTRUM})
    low = make_plan(case, read_inputs(case, Path())).longest_period
    assert longest(demand=SPECTRUM) / low == pytest.approx(2.0**0.5, rel=0.01)
