"""PGA_C, T_R,C and IS-V against worked values."""

from dataclasses import replace

import pytest

from core.codes.demand import DemandResult
from core.codes.risk import letter_of, risk, years
from core.units import G

DEMAND = DemandResult(
    limit_state="SLV", ag=0.26 * G, soil_factor=1.2, pga=0.312 * G, intensity=None,
    intensity_source=None, q_code=2.0, confidence_factor=1.35, zeta_target=1.0, target=None,
    return_period=475.0,
)  # fmt: skip


def test_the_worked_return_periods():
    """0.52 -> 96.4 years, by a_g 0.26 g (1/0.49) 125.1; 0.75 -> 235.5."""
    found = risk(0.52, DEMAND)
    assert found.return_period == pytest.approx(96.4, abs=0.05)
    assert found.other_return_period == pytest.approx(125.1, abs=0.05)
    assert risk(0.75, DEMAND).return_period == pytest.approx(235.5, abs=0.05)
    assert found.pga == pytest.approx(0.52 * 0.312 * G)


def test_that_the_shorter_return_period_is_taken_on_either_side_of_one():
    weak = replace(DEMAND, ag=0.04 * G)
    for demand in (DEMAND, weak):
        for zeta in (0.3, 0.9, 1.0, 1.4):
            found = risk(zeta, demand)
            assert found.return_period <= found.other_return_period
    assert risk(0.5, weak).return_period == pytest.approx(475.0 * 0.5 ** (1.0 / 0.34))


@pytest.mark.parametrize(
    "index, letter",
    [
        (1.2, "A+"), (1.0001, "A+"), (1.0, "A"), (0.8, "A"), (0.7999, "B"), (0.6, "B"),
        (0.5999, "C"), (0.45, "C"), (0.3, "D"), (0.15, "E"), (0.1499, "F"), (0.0, "F"),
    ],
)  # fmt: skip
def test_the_letters(index, letter):
    assert letter_of(index) == letter


def test_that_the_index_is_of_slv_and_the_return_period_needs_that_of_the_demand():
    found = risk(0.7, replace(DEMAND, limit_state="SLD", return_period=None))
    assert found.index is None and found.letter is None and found.return_period is None


def test_that_beyond_the_hazard_of_ntc_it_is_said():
    assert (years(29.9), years(30.0), years(475.4), years(2476.0)) == (
        "< 30",
        "30",
        "475",
        "> 2475",
    )
