"""Numbers of the codes' tables, typed from the printed page: a table of the program is held by none of its own."""

import math

import pytest

from core.case.rules import parse_wall
from core.case.site import FULL_FACTOR, KNOWLEDGE
from core.codes import kinematic, limits, national_hazard, record_compatibility, risk, target_spectrum
from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_participation
from core.codes.masonry_types import TYPES
from core.codes.spectrum_codes import en1998
from core.ground.floor_motion import Mode
from core.units import G


def test_that_topography_use_and_limit_states_are_those_of_ntc():
    assert target_spectrum.NTC_TOPOGRAPHY == {"T1": 1.0, "T2": 1.2, "T3": 1.2, "T4": 1.4}  # Table 3.2.V
    assert national_hazard.USE_CLASSES == {"I": 0.7, "II": 1.0, "III": 1.5, "IV": 2.0}  # Table 2.4.II
    assert limits.EXCEEDANCE == {"SLO": 0.81, "SLD": 0.63, "SLV": 0.10, "SLC": 0.05}  # Table 3.2.I
    assert national_hazard.MIN_REFERENCE_PERIOD == 35.0


@pytest.mark.shows("kinematic.knowledge")
def test_that_confidence_factors_are_those_of_table_c8_5_iv():
    assert FULL_FACTOR == 1.35
    assert KNOWLEDGE == {"LC2": 1.20, "LC3": 1.00}


TABLE_C8_5_I = """
    disordered_rubble      1.0 2.0  690 1050 19 19 3.5
    roughly_dressed_stone  2.0 2.0 1020 1440 20 20 3.0
    split_stone            2.6 3.8 1500 1980 21 21 2.4
    irregular_soft_stone   1.4 2.2  900 1260 13 16 2.0
    regular_soft_stone     2.0 3.2 1200 1620 13 16 1.8
    squared_stone          5.8 8.2 2400 3300 22 22 1.4
    solid_brick            2.6 4.3 1200 1800 18 18 1.8
    hollow_brick           5.0 8.0 3500 5600 15 15 1.3
"""
"""Type; f, E [MPa], w [kN/m3], each from and to; of Table C8.5.II the greatest product of the factors."""


@pytest.mark.shows("demand.masonry")
def test_that_types_of_masonry_are_those_of_table_c8_5_i():
    rows = [line.split() for line in TABLE_C8_5_I.strip().splitlines()]
    assert list(TYPES) == [name for name, *_ in rows]
    for name, *numbers in rows:
        kind = TYPES[name]
        assert [*kind.strength, *kind.modulus, *kind.weight, kind.most_factor] == [float(number) for number in numbers]


@pytest.mark.shows("kinematic.displacement")
def test_that_periods_and_dampings_are_those_of_c8_7_1_2_1_8():
    assert {state: factor / math.pi for state, factor in kinematic.PERIOD_FACTOR.items()} == pytest.approx(
        {"SLV": 1.68, "SLC": 1.56}, rel=1e-15
    )
    assert kinematic.STATE_DAMPING == {"SLV": 0.08, "SLC": 0.10}
    assert (kinematic.FREE_DAMPING, kinematic.CANTILEVER_KAPPA) == (0.05, 6.2)


@pytest.mark.shows("demand.artificial")
def test_that_records_are_compared_by_the_bounds_of_3_2_3_6():
    assert record_compatibility.LOWER_BOUND == {"artificial": -0.10, "simulated": -0.20, "natural": -0.10}
    assert record_compatibility.UPPER == {"natural": 0.30}
    assert record_compatibility.PERIOD_RANGE == (0.15, 2.0)
    assert (record_compatibility.STRONG_PART, record_compatibility.WHOLE_LENGTH) == (10.0, 25.0)


@pytest.mark.shows("risk.class")
def test_that_exponents_of_risk_are_those_of_the_guidelines_of_2017():
    assert pytest.approx(1.0 / 0.41, rel=1e-15) == risk.EXPONENT
    by_ag = [(ag / G, 1.0 / exponent) for ag, exponent in risk.EXPONENT_BY_AG]
    assert by_ag == [pytest.approx(row) for row in ((0.25, 0.49), (0.15, 0.43), (0.05, 0.356), (0.0, 0.34))]


@pytest.mark.shows("kinematic.floor_spectrum")
@pytest.mark.parametrize(("damping", "amplification"), [(0.05, 4.92), (0.10, 3.48), (0.15, 2.84), (0.20, 2.46)])
def test_that_a_floor_amplifies_as_c7_2_6_and_c7_2_7(damping, amplification):
    ground = en1998(0.2 * G, 1, "A")  # S_e(0.3 s, 5 %) = 2.5 a_g, eta of 8 % is 0.877
    floor = FloorSpectrum(ground, (Mode(0.3, damping, 1.2),))
    a_z = 0.5 * G * max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55) * 1.2 * math.sqrt(1.0 + 4.0 * damping**2)
    assert floor.a_z == pytest.approx(a_z, rel=1e-12)
    eta = math.sqrt(10.0 / 13.0)
    at = floor.acceleration([0.12, 0.24, 0.3, 0.33, 0.66], 0.08)
    most = amplification * eta
    expected = [most / (1.0 + (most - 1.0) * 0.5**1.6), most, most, most, most / (1.0 + (most - 1.0) * 1.0**1.2)]
    assert at / a_z == pytest.approx([max(one, 0.0) for one in expected], rel=2e-3)
    assert first_participation(3) == pytest.approx(9.0 / 7.0, rel=1e-15)  # C7.2.10
    assert estimated_period(9.0) == pytest.approx(0.05 * 9.0**0.75, rel=1e-15)


@pytest.mark.shows("kinematic.displacement_at_height")
def test_that_beyond_the_first_period_a_floor_moves_no_less_than_at_it():
    """C8.7.1.12: S_DeZ is not below S_eZ(T_1) (1.1 T_1 / 2 pi)^2."""
    floor = FloorSpectrum(en1998(0.2 * G, 1, "A"), (Mode(0.3, 0.01, 1.2),))
    first = floor.acceleration([0.3], 0.08)[0] * (0.33 / (2.0 * math.pi)) ** 2
    for period in (0.2, 0.33, 0.36, 0.4, 1.5):
        own = floor.acceleration([period], 0.08)[0] * (period / (2.0 * math.pi)) ** 2
        expected = max(own, first) if period > 0.33 else own
        assert floor.displacement(period, 0.08) == pytest.approx(expected, rel=1e-12)
    assert floor.displacement(0.4, 0.08) > 1.3 * floor.acceleration([0.4], 0.08)[0] * (0.4 / (2 * math.pi)) ** 2


@pytest.mark.shows("kinematic.t0")
def test_that_the_period_of_a_wall_with_masses_is_that_of_both():
    """T_0^2 is the sum of that of the wall alone, C8.7.1.7, and of what moves with it."""
    wall = {"name": "w", "mechanism": "one_sided", "height_m": 3.0, "thickness_m": 0.4, "unit_weight_kn_m3": 18.0}
    wall |= {"elastic_modulus_mpa": 900.0}
    roof = {"kind": "vertical", "kn_m": 8.0, "h_m": 3.0, "d_m": 0.2, "mass": "moving"}
    bare, loaded = parse_wall(wall), parse_wall(wall | {"load": [roof]})
    alone = kinematic.elastic_period(bare.in_si)
    by_hand = 6.2 * (3.0 / 0.4) * 3.0 * math.sqrt(18e3 / (9e8 * 9.80665))
    assert alone == pytest.approx(by_hand, rel=1e-12)
    together = kinematic.elastic_period(loaded.in_si)
    assert together**2 == pytest.approx(alone**2 + kinematic.elastic_period_of_loads(loaded.in_si), rel=1e-12)
    assert together > 1.02 * alone
