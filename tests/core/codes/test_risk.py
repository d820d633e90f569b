"""PGA_C, T_R,C and IS-V against worked values."""

from dataclasses import replace

import pytest

from core.case.rules import parse_case
from core.codes.demand import SeismicDemand
from core.codes.risk import exponent_by_ag, return_period_of, risk_class, risk_of_mechanism
from core.errors import InputError
from core.units import G

DEMAND = SeismicDemand(
    limit_state="SLV",
    ag=0.26 * G,
    soil_factor=1.2,
    pga=0.312 * G,
    intensity=None,
    intensity_source=None,
    q_code=2.0,
    confidence_factor=1.35,
    zeta_target=1.0,
    target=None,
    return_period=475.0,
)


@pytest.mark.shows("risk.return_period")
def test_that_the_shorter_return_period_is_taken_on_either_side_of_one():
    weak = replace(DEMAND, ag=0.04 * G)
    for demand in (DEMAND, weak):
        for zeta in (0.3, 0.9, 1.0, 1.4):
            found = risk_of_mechanism(zeta, demand)
            assert found.return_period <= found.other_return_period
    assert risk_of_mechanism(0.5, weak).return_period == pytest.approx(475.0 * 0.5 ** (1.0 / 0.34))


@pytest.mark.shows("risk.return_period")
@pytest.mark.parametrize(
    ("ag_g", "inverse"),
    [
        (0.26, 0.49),
        (0.25, 0.49),
        (0.249, 0.43),
        (0.15, 0.43),
        (0.149, 0.356),
        (0.05, 0.356),
        (0.049, 0.34),
        (0.0, 0.34),
    ],
)
def test_that_the_exponent_goes_by_a_g(ag_g, inverse):
    assert exponent_by_ag(ag_g * G) == pytest.approx(1.0 / inverse, rel=1e-14)


def test_that_the_letter_is_of_the_lower_end_of_what_zeta_is_known_to_be():
    assert (risk_of_mechanism(0.9, DEMAND).letter, risk_of_mechanism(0.9, DEMAND, 0.7).letter) == ("A", "B")
    assert risk_of_mechanism(0.9, DEMAND, 0.95).letter == "A" and risk_of_mechanism(0.9, DEMAND, 0.7).index == 0.9
    assert not risk_of_mechanism(0.9, DEMAND).by_hazard and risk_of_mechanism(0.9, DEMAND).known_years == (30.0, 2475.0)


@pytest.mark.shows("risk.class")
@pytest.mark.parametrize(
    "index, letter",
    [
        (1.2, "A+"),
        (1.0001, "A+"),
        (1.0, "A"),
        (0.8, "A"),
        (0.7999, "B"),
        (0.6, "B"),
        (0.5999, "C"),
        (0.45, "C"),
        (0.3, "D"),
        (0.15, "E"),
        (0.1499, "F"),
        (0.0, "F"),
    ],
)
def test_the_letters(index, letter):
    assert risk_class(index) == letter


@pytest.mark.shows("risk.class")
def test_that_the_index_is_of_slv_and_the_return_period_needs_that_of_the_demand():
    found = risk_of_mechanism(0.7, replace(DEMAND, limit_state="SLD", return_period=None))
    assert found.index is None and found.letter is None and found.return_period is None


@pytest.mark.shows("risk.hazard")
def test_that_beyond_the_hazard_of_ntc_it_is_said():
    found = risk_of_mechanism(1.0, DEMAND)
    shown = [replace(found, return_period=years).years for years in (29.9, 30.0, 475.4, 2476.0)]
    assert shown == ["< 30", "30", "475", "> 2475"]


@pytest.mark.shows("risk.hazard")
def test_that_beyond_the_rows_of_the_hazard_it_is_said():
    short = replace(DEMAND, hazard=((50.0, 0.10 * G), (475.0, 0.26 * G), (975.0, 0.33 * G)))
    assert risk_of_mechanism(1.0, short).years == "475"
    assert risk_of_mechanism(2.0, short).years == "> 975" and risk_of_mechanism(0.2, short).years == "< 50"


HAZARD = ((30.0, 0.06 * G), (72.0, 0.09 * G), (475.0, 0.22 * G), (2475.0, 0.40 * G))


@pytest.mark.shows("risk.hazard")
def test_the_return_period_by_the_hazard_of_the_site():
    """At the rows their own, halfway between two in the logarithms the geometric mean of both."""
    for period, ag in HAZARD:
        assert return_period_of(ag, HAZARD) == pytest.approx(period, rel=1e-12)
    middle = (0.09 * G * 0.22 * G) ** 0.5
    assert return_period_of(middle, HAZARD) == pytest.approx((72.0 * 475.0) ** 0.5, rel=1e-12)
    assert return_period_of(0.05 * G, HAZARD) < 30.0 < 2475.0 < return_period_of(0.5 * G, HAZARD)
    found = risk_of_mechanism(0.22 / 0.26, replace(DEMAND, hazard=HAZARD))
    assert found.by_hazard and found.return_period == pytest.approx(475.0)
    assert found.other_return_period == risk_of_mechanism(0.22 / 0.26, DEMAND).return_period


@pytest.mark.parametrize("periods", [(475.0,), (475.0, 100.0), (475.0, 475.0)])
def test_that_a_hazard_that_does_not_rise_is_refused(periods):
    rows = [{"return_period_years": t, "ag_g": 0.05 * (k + 1)} for k, t in enumerate(periods)]
    with pytest.raises(InputError) as caught:
        parse_case({"demand": {"ag_g": 0.2, "hazard": rows}, "wall": []})
    assert caught.value.code == "hazard_not_rising"
