"""Numbers of the codes' tables, typed from the printed page: a table of the program is held by none of its own."""

import math

import pytest

from core.case.rules import parse_wall
from core.case.site import FULL_FACTOR, KNOWLEDGE
from core.codes import kinematic, limits, national_hazard, record_compatibility, risk, target_spectrum
from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_participation
from core.codes.masonry_types import TYPES
from core.ground.floor_motion import Mode
from core.units import G

NTC_TABLE_3_2_IV = """
    A 1.00 0.00 1.00 1.00 1.00  0.00
    B 1.40 0.40 1.00 1.20 1.10 -0.20
    C 1.70 0.60 1.00 1.50 1.05 -0.33
    D 2.40 1.50 0.90 1.80 1.25 -0.50
    E 2.00 1.10 1.00 1.60 1.15 -0.40
"""
"""Ground; S_S = a - b F_0 a_g/g within two bounds; C_C = c T_C*^d."""


@pytest.mark.shows("demand.ntc_spectrum")
@pytest.mark.parametrize("row", NTC_TABLE_3_2_IV.strip().splitlines())
def test_that_the_grounds_of_ntc_are_those_of_table_3_2_iv(row):
    soil, *numbers = row.split()
    a, b, low, high, c, d = map(float, numbers)
    for ag, f0, tc_star in ((0.05, 2.4, 0.27), (0.25, 2.4, 0.35), (0.45, 2.55, 0.45)):
        s_s = min(max(a - b * f0 * ag, low), high)
        made = target_spectrum.ntc2018(ag * G, f0, tc_star, soil, "T3")
        assert made.soil == pytest.approx(1.2 * s_s, rel=1e-12)
        assert made.t_c == pytest.approx(c * tc_star ** (1.0 + d), rel=1e-12)
        assert (made.t_b, made.t_d) == pytest.approx((made.t_c / 3.0, 4.0 * ag + 1.6), rel=1e-12)


def test_that_topography_use_and_limit_states_are_those_of_ntc():
    assert target_spectrum.NTC_TOPOGRAPHY == {"T1": 1.0, "T2": 1.2, "T3": 1.2, "T4": 1.4}  # Table 3.2.V
    assert national_hazard.USE_CLASSES == {"I": 0.7, "II": 1.0, "III": 1.5, "IV": 2.0}  # Table 2.4.II
    assert limits.EXCEEDANCE == {"SLO": 0.81, "SLD": 0.63, "SLV": 0.10, "SLC": 0.05}  # Table 3.2.I
    assert national_hazard.LEAST_REFERENCE == 35.0


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


ANNEX_B_TABLE_2 = """
    Sardegna   0.186 0.235 0.274 0.314 0.351 0.393 0.500 0.603 0.747
               2.61 2.67 2.70 2.73 2.78 2.82 2.88 2.98 3.09
               0.273 0.296 0.303 0.307 0.313 0.322 0.340 0.372 0.401
    Ventotene  0.239 0.303 0.347 0.389 0.430 0.481 0.600 0.707 0.852
               2.61 2.61 2.61 2.66 2.69 2.71 2.92 3.07 3.27
               0.245 0.272 0.298 0.326 0.366 0.401 0.476 0.517 0.564
    Ustica     0.429 0.554 0.661 0.776 0.901 1.056 1.500 1.967 2.725
               2.50 2.50 2.50 2.50 2.50 2.50 2.50 2.50 2.50
               0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400
    Alicudi    0.350 0.558 0.807 1.020 1.214 1.460 2.471 3.212 4.077
               2.70 2.70 2.70 2.70 2.70 2.70 2.70 2.70 2.70
               0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400
    Stromboli  0.618 0.817 0.983 1.166 1.354 1.580 2.200 2.823 3.746
               2.45 2.48 2.51 2.52 2.56 2.56 2.58 2.65 2.76
               0.287 0.290 0.294 0.290 0.290 0.292 0.306 0.316 0.324
"""
"""One island of each group; a_g [g/10], F_0, T_C* [s] at 30, 50, 72, 101, 140, 201, 475, 975, 2475 years."""

PLACES = {
    "Sardegna": (39.22, 9.12),
    "Ventotene": (40.79, 13.43),
    "Ustica": (38.71, 13.18),
    "Alicudi": (38.54, 14.35),
    "Stromboli": (38.80, 15.22),
}


@pytest.mark.shows("demand.place")
@pytest.mark.parametrize("island", PLACES)
def test_that_islands_have_the_hazard_of_table_2_of_annex_b(island):
    names, *rest = ANNEX_B_TABLE_2.split(island)[1].split("\n")
    rows = [[float(number) for number in line.split()] for line in (names, *rest[:2])]
    for years, ag, f0, tc in zip((30, 50, 72, 101, 140, 201, 475, 975, 2475), *rows, strict=True):
        found = national_hazard.hazard_at(*PLACES[island]).at(float(years))
        assert (found.ag_g, found.f0, found.tc_star_s) == pytest.approx((ag / 10.0, f0, tc), rel=1e-12)


@pytest.mark.shows("kinematic.displacement")
def test_that_periods_and_dampings_are_those_of_c8_7_1_2_1_8():
    assert {state: factor / math.pi for state, factor in kinematic.PERIOD_FACTOR.items()} == pytest.approx(
        {"SLV": 1.68, "SLC": 1.56}, rel=1e-15
    )
    assert kinematic.STATE_DAMPING == {"SLV": 0.08, "SLC": 0.10}
    assert (kinematic.FREE_DAMPING, kinematic.CANTILEVER) == (0.05, 6.2)


@pytest.mark.shows("demand.artificial")
def test_that_records_are_compared_by_the_bounds_of_3_2_3_6():
    assert record_compatibility.LOWER == {"artificial": -0.10, "simulated": -0.20, "natural": -0.10}
    assert record_compatibility.UPPER == {"natural": 0.30}
    assert record_compatibility.RANGE == (0.15, 2.0)
    assert (record_compatibility.STRONG_PART, record_compatibility.WHOLE_LENGTH) == (10.0, 25.0)


@pytest.mark.shows("risk.class")
def test_that_classes_of_risk_are_those_of_the_guidelines_of_2017():
    letters = {1.01: "A+", 1.0: "A", 0.8: "A", 0.79: "B", 0.6: "B", 0.59: "C", 0.45: "C", 0.44: "D", 0.3: "D"}
    letters |= {0.29: "E", 0.15: "E", 0.14: "F"}
    assert {index: risk.letter_of(index) for index in letters} == letters
    assert pytest.approx(1.0 / 0.41, rel=1e-15) == risk.EXPONENT
    by_ag = [(ag / G, 1.0 / exponent) for ag, exponent in risk.EXPONENT_BY_AG]
    assert by_ag == [pytest.approx(row) for row in ((0.25, 0.49), (0.15, 0.43), (0.05, 0.356), (0.0, 0.34))]


@pytest.mark.shows("kinematic.floor_spectrum")
@pytest.mark.parametrize(("damping", "amplification"), [(0.05, 4.92), (0.10, 3.48), (0.15, 2.84), (0.20, 2.46)])
def test_that_a_floor_amplifies_as_c7_2_6_and_c7_2_7(damping, amplification):
    ground = target_spectrum.en1998(0.2 * G, 1, "A")  # S_e(0.3 s, 5 %) = 2.5 a_g, eta of 8 % is 0.877
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
    floor = FloorSpectrum(target_spectrum.en1998(0.2 * G, 1, "A"), (Mode(0.3, 0.01, 1.2),))
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
