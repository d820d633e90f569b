"""Spectra of the codes at every branch, against values worked out by hand."""

import itertools
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.case.schema import Case
from core.case.site import Demand
from core.codes import target_spectrum as ts
from core.codes.demand import complete_with_records
from core.codes.spectrum_codes import en1998
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.setting.demand_input import read_demand, read_target_spectrum
from core.units import G

A_G = 0.25 * G


def by_hand(t, ag_s, eta, f0, tb, tc, td):
    """NTC 2018 3.2.2, branch by branch."""
    if t < tb:
        return ag_s * eta * f0 * (t / tb + (1.0 - t / tb) / (eta * f0))
    if t < tc:
        return ag_s * eta * f0
    if t < td:
        return ag_s * eta * f0 * tc / t
    return ag_s * eta * f0 * tc * td / t**2


@pytest.mark.shows("demand.en_spectrum")
@pytest.mark.parametrize("damping", [0.02, 0.05, 0.08, 0.10, 0.30])
@pytest.mark.parametrize("kind", [1, 2])
@pytest.mark.parametrize("soil", ts.SOILS)
def test_that_every_branch_of_en1998_is_its_formula(kind, soil, damping):
    target = en1998(A_G, kind, soil)
    s, tb, tc, td = target.soil, target.t_b, target.t_c, target.t_d  # by the print: core/lab/solved/hazard.py
    eta = max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55)
    periods = [0.0, 0.5 * tb, tb, 0.5 * (tb + tc), tc, 0.5 * (tc + td), td, 3.0 * td]
    found = target.acceleration(periods, damping)
    for t, value in zip(periods, found, strict=True):
        assert value == pytest.approx(by_hand(t, A_G * s, eta, 2.5, tb, tc, td), rel=1e-13)


@pytest.mark.shows("demand.ntc_spectrum")
@pytest.mark.parametrize(
    ("soil", "weak", "strong"), [("A", 1.0, 1.0), ("B", 1.2, 1.0), ("C", 1.5, 1.0), ("D", 1.8, 0.9), ("E", 1.6, 1.0)]
)
def test_that_s_of_ntc2018_keeps_within_the_limits_of_its_table(soil, weak, strong):
    assert ts.ntc2018(0.01 * G, 2.5, 0.3, soil, "T1").soil == weak
    assert ts.ntc2018(1.0 * G, 2.5, 0.3, soil, "T1").soil == strong
    tops = {"T1": 1.0, "T2": 1.2, "T3": 1.2, "T4": 1.4}
    for place, factor in tops.items():
        found = ts.ntc2018(0.01 * G, 2.5, 0.3, soil, place).soil
        assert found == pytest.approx(weak * factor, rel=1e-15)


def test_that_a_displacement_is_the_acceleration_over_the_squared_frequency():
    target = en1998(A_G, 1, "B")
    found = ts.displacement(target, [0.5, 1.0], 0.08)
    expected = target.acceleration([0.5, 1.0], 0.08) / (2.0 * math.pi / np.array([0.5, 1.0])) ** 2
    assert found == pytest.approx(expected, rel=1e-14)


@pytest.mark.shows("demand.branches")
def test_that_the_branches_meet_at_tb_tc_and_td():
    for target in (en1998(A_G, 1, "C"), ts.ntc2018(A_G, 2.4, 0.33, "D", "T2")):
        for corner in (target.t_b, target.t_c, target.t_d):
            below, above = target.acceleration([corner * (1 - 1e-12), corner * (1 + 1e-12)])
            assert below == pytest.approx(above, rel=1e-10)


def test_that_the_wrong_variants_of_public_codes_are_not_ours():
    two_c = en1998(A_G, 2, "C")
    assert two_c.t_c == 0.25  # not 0.60
    target = en1998(A_G, 1, "B")
    assert target.t_d == 2.0  # not 2.5
    # the last branch is TC TD / T^2, not (TC T) / T^2: it falls with the square of T
    two, four = target.acceleration([2.0, 4.0])
    assert four == pytest.approx(two / 4.0, rel=1e-13)


def test_that_the_soil_factor_is_held_within_its_limits():
    assert ts.ntc2018(0.02 * G, 2.5, 0.3, "C", "T1").soil == 1.5
    assert ts.ntc2018(0.9 * G, 2.5, 0.3, "D", "T1").soil == 0.9


@pytest.mark.shows("paper.eq_11")
def test_that_the_intensity_of_a_spectrum_is_the_integral_of_its_velocity():
    target = en1998(A_G, 1, "B")
    t = np.linspace(0.1, 2.5, 240001)
    fine = np.trapezoid(target.acceleration(t) * t / (2.0 * math.pi), t)
    # 0.02 s against 1e-5 s: the kinks at T_C and T_D are grid points
    assert ts.housner_intensity(target) == pytest.approx(fine, rel=1e-4)
    exact = target.pga * ts.shape_integral(target) / (2.0 * math.pi)
    assert exact == pytest.approx(fine, rel=1e-9)


@pytest.mark.parametrize(
    "target",
    [
        en1998(A_G, 2, "A"),  # T_B below 0.1 s, T_D within
        en1998(A_G, 2, "D"),  # T_B at 0.1 s
        ts.ntc2018(0.3 * G, 2.4, 0.33, "C", "T1"),  # T_D beyond 2.5 s
    ],
    ids=["early", "at 0.1 s", "late"],
)
def test_that_the_integral_of_a_shape_is_that_of_its_branches_within_the_periods(target):
    corners = [0.1, target.t_b, target.t_c, target.t_d, 2.5]
    corners = sorted({min(max(corner, 0.1), 2.5) for corner in corners})
    total = 0.0
    for low, high in itertools.pairwise(corners):
        t = np.linspace(low, high, 100001)
        total += np.trapezoid(target.acceleration(t) * t, t)
    assert ts.shape_integral(target) == pytest.approx(total / target.pga, rel=1e-8)


FILE = [(0.0, 3.0), (0.1, 7.0), (0.5, 7.0), (1.0, 3.5), (2.5, 1.0)]


@pytest.mark.parametrize("span", [(0.0, 3.0), (0.2, 0.4), (0.6, 1.3), (1.0, 1.0), (1.2, 2.5), (2.6, 4.0)])
def test_that_the_largest_displacement_is_that_of_a_fine_grid(span):
    """Also within a branch of a file, where T^2 (level + slope T) turns."""
    low, high = span
    kinks = [period for period in np.linspace(0.0, 3.0, 61) if low <= period <= high]
    periods = np.concatenate([np.linspace(low, high, 100001), kinks])
    chance = np.random.default_rng(4)
    given = list(zip(np.linspace(0.05, 3.0, 60), chance.uniform(2.0, 9.0, 60), strict=True))
    for target in (en1998(A_G, 1, "C"), ts.given("f", 3.0, 1.0, FILE), ts.given("g", 3.0, 1.0, given)):
        for damping in (0.05, 0.1):
            found = ts.largest_displacement(target, low, high, damping)
            largest = float(ts.displacement(target, periods, damping).max())
            assert found == pytest.approx(largest, rel=1e-7) and found >= largest * (1 - 1e-12)


def test_that_below_the_first_period_of_a_file_the_line_goes_to_the_ground():
    target = ts.given("f", 3.0, 1.2, [(0.1, 8.0), (0.3, 8.0), (0.5, 6.0), (1.0, 3.5), (2.5, 1.0)])
    assert target.pga == pytest.approx(3.6, rel=1e-15)
    assert target.acceleration([0.0, 0.05, 0.1]) == pytest.approx([3.6, 5.8, 8.0], rel=1e-13)
    eta = math.sqrt(10.0 / 15.0)
    half = 5.8 * (1.0 + (eta - 1.0) * 0.5)
    assert target.acceleration([0.05, 0.1, 0.2], 0.10) == pytest.approx([half, 8.0 * eta, 8.0 * eta], rel=1e-13)
    assert target.acceleration([1.0], 0.30)[0] == pytest.approx(0.55 * 3.5, rel=1e-13)


def test_that_limits_of_a_file_are_taken_and_a_row_that_does_not_rise_is_named():
    at_the_ends = [(0.1, 6.54), (0.2, 6.54), (0.4, 6.54), (1.0, 1.0), (2.5, 0.1)]  # 2.2 times a_g S as printed
    assert ts.given("f", 3.0, 1.0, at_the_ends).periods == (0.1, 0.2, 0.4, 1.0, 2.5)
    for start in (3.14, 2.86):  # within 5 % of a_g S
        assert ts.given("f", 3.0, 1.0, [(0.01, start), *FILE[1:]]).values[0] == start
    for start in (3.156, 2.844):
        with pytest.raises(InputError, match="starts at"):
            ts.given("f", 3.0, 1.0, [(0.01, start), *FILE[1:]])
    assert ts.given("f", 3.0, 1.0, [(0.02, 3.2), *FILE[1:]]).values[0] == 3.2
    high = [(period, min(value, 18.0)) for period, value in [(0.1, 18.0), *FILE[2:], (3.0, 0.5)]]
    assert max(ts.given("f", 3.0, 1.0, high).values) == 18.0  # 6 times a_g S
    for far in (6.5, 18.5):
        flat = [(0.05, far), (0.1, far), (0.5, far), (1.0, 2.0), (2.5, 1.0)]
        with pytest.raises(InputError, match="is the file in g"):
            ts.given("f", 3.0, 1.0, flat)
    with pytest.raises(InputError, match="row 3"):
        ts.given("f", 3.0, 1.0, [FILE[0], FILE[1], FILE[1], FILE[3], FILE[4]])
    steep = [(0.0, 19.9 * G / 6), (0.1, 19.9 * G), (0.5, 19.9 * G), (1.0, G), (2.5, 1.0)]
    assert ts.given("f", 19.9 * G / 6, 1.0, steep)
    beyond = [(period, value * 20.0 / 19.9) for period, value in steep]
    with pytest.raises(InputError, match="20 g"):
        ts.given("f", 20.0 * G / 6, 1.0, beyond)


def test_that_a_t_c_beyond_t_d_is_refused():
    with pytest.raises(InputError) as caught:
        ts.ntc2018(0.05 * G, 2.5, 2.5, "D", "T1")
    assert caught.value.code == "t_c_above_t_d"
    assert caught.value.values["t_d"] == pytest.approx(1.8)
    assert caught.value.values["t_c"] == pytest.approx(1.25 * 2.5**0.5)


def test_that_a_spectrum_of_a_file_gives_its_points_and_its_ends():
    rows = [(0.0, 3.0), (0.1, 7.0), (0.5, 7.0), (1.0, 3.5), (2.5, 1.0)]
    target = ts.given("f", 3.0, 1.0, rows)
    assert target.acceleration([0.1, 0.3, 1.0]).tolist() == [7.0, 7.0, 3.5]
    assert target.acceleration([5.0])[0] == pytest.approx(0.25, rel=1e-13)
    eight = target.acceleration([0.0, 1.0], 0.08)
    assert eight[0] == 3.0
    assert eight[1] == pytest.approx(3.5 * math.sqrt(10 / 13), rel=1e-13)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([(0.1, 1.0)] * 3, "too few"),
        ([(0.1, 1.0), (0.1, 1.0), (0.2, 1.0), (1.0, 1.0), (3.0, 1.0)], "must increase"),
        ([(0.2, 1.0), (0.3, 1.0), (0.4, 1.0), (1.0, 1.0), (3.0, 1.0)], "0.1 to 2.5"),
        ([(0.0, 2.0), (0.1, 7.0), (0.4, 7.0), (1.0, 3.0), (3.0, 1.0)], "starts at"),
        ([(0.05, 49.0), (0.1, 49.0), (0.4, 49.0), (1.0, 49.0), (3.0, 49.0)], "is the file in g"),
        ([(0.0, -1.0), (0.1, 1.0), (0.4, 1.0), (1.0, 1.0), (3.0, 1.0)], "above 0 g"),
    ],
)
def test_that_a_wrong_file_of_a_spectrum_is_refused(rows, words):
    with pytest.raises(InputError, match=words):
        ts.given("f", 3.0, 1.0, rows)


def rows_of_file(target, first, scale=1.0, floor=0.0):
    """Points of a spectrum as a file has them, times `scale`, no less than `floor`."""
    periods = np.concatenate([[first], np.arange(max(0.05, first + 0.02), 4.0, 0.05)])
    return [(t, max(scale * s, floor)) for t, s in zip(periods, target.acceleration(periods), strict=True)]


@pytest.mark.shows("demand.elastic_file")
@pytest.mark.parametrize("seeds", [range(60), pytest.param(range(2000), marks=pytest.mark.long)], ids=len)
def test_that_a_file_is_the_elastic_spectrum_of_its_demand_or_refused(seeds):
    """Random sites: the elastic spectrum is taken; that of design with q from 1.25 on, a share of the elastic one, that
    with 10 % damping and one with the floor of design are refused."""
    for seed in seeds:
        chance = np.random.default_rng(seed)
        ag, f0, tc_star = chance.uniform(0.05, 0.35) * G, chance.uniform(2.2, 2.7), chance.uniform(0.2, 0.5)
        soil, first = str(chance.choice(list("ABCDE"))), chance.choice([0.0, 0.03, 0.05])
        elastic = ts.ntc2018(ag, f0, tc_star, soil, "T1")
        assert ts.given("f", ag, elastic.soil, rows_of_file(elastic, first)).pga == pytest.approx(elastic.pga)
        q = chance.uniform(1.25, 4.0)
        design = replace(elastic, amplification=f0 / q)
        damped = replace(elastic, amplification=f0 * math.sqrt(10.0 / 15.0))
        wrong = [
            rows_of_file(design, first, floor=0.2 * ag),
            rows_of_file(elastic, first, scale=chance.uniform(0.3, 0.8)),
        ]
        if elastic.acceleration([3.0])[0] < 0.2 * ag:  # else it has come to no floor
            wrong += [rows_of_file(elastic, first, floor=0.2 * ag)]
        if f0 < 2.6:  # above that its plateau could be one of 5 %
            wrong += [rows_of_file(damped, first)]
        for rows in wrong:
            with pytest.raises(InputError) as refused:
                ts.given("f", ag, elastic.soil, rows)
            assert refused.value.code in ("spectrum_start", "spectrum_begins", "spectrum_largest", "spectrum_floor")


@pytest.mark.parametrize("between", [" ", "\t", ";", "; ", ",", ", "])
def test_that_columns_of_a_spectrum_are_parted_as_people_part_them(tmp_path, between):
    rows = [(0.0, 0.2), (0.1, 0.5), (0.5, 0.5), (2.0, 0.1), (4.0, 0.03)]
    asked = Demand(0.2, spectrum_file="s.txt")
    for comma in (False, True) if "," not in between else (False,):
        text = "\n".join(f"{t:.2f}{between}{s:.3f}" for t, s in rows)
        (tmp_path / "s.txt").write_text(text.replace(".", ",") if comma else text)
        assert read_target_spectrum(asked, tmp_path).values == pytest.approx([s * G for _, s in rows])


HEADS = [
    ("Spettro di progetto SLV, fattore q = 2.0", True),
    ("T [s] Sd [g]", True),
    ("T;Se(T) q=1,5", True),
    ("Design spectrum EN 1998-1", True),
    ("Behaviour factor 1.5", True),
    ("Spettri di risposta elastici SLV", False),
    ("Spettro di progetto, q = 1.0", False),  # that is the elastic one
    ("SPETTRO DI PROGETTO SLV", True),
    ("Spettro Di Progetto", True),
    ("Q = 2", True),
    ("Design spectrum, Q1 2024", True),  # a quarter of a year is no factor
    ("T [s] Se [g]", False),
    ("design ground acceleration 0.25 g", False),
]


@pytest.mark.shows("demand.elastic_file")
@pytest.mark.parametrize(("head", "refused"), HEADS)
def test_that_a_head_that_says_design_is_believed(tmp_path, head, refused):
    (tmp_path / "s.txt").write_text(f"{head}\n0 0.2\n0.1 0.5\n0.5 0.5\n2 0.1\n4 0.03\n")
    asked = Demand(0.2, spectrum_file="s.txt")
    if not refused:
        assert read_target_spectrum(asked, tmp_path).pga == pytest.approx(0.2 * G)
        return
    with pytest.raises(InputError) as found:
        read_target_spectrum(asked, tmp_path)
    assert found.value.code == "spectrum_of_design" and head[:20] in str(found.value)


@pytest.mark.shows("demand.coordinates")
def test_that_a_demand_below_that_of_its_coordinates_is_refused():
    """L'Aquila has a_g 0.261 g, F_0 2.36, T_C* 0.347 s at 475 years by the national grid."""
    spectrum = {"code": "NTC2018", "f0": 2.36, "tc_star_s": 0.347, "soil": "C", "topography": "T1"}
    here = {"ag_g": 0.26, "coordinates": "42.354, 13.392", "return_period_years": 475.0, "spectrum": spectrum}
    for key, value in (("ag_g", 0.05), ("ag_g", 0.24), ("f0", 2.2), ("tc_star_s", 0.3)):
        with pytest.raises(InputError) as refused:
            read_demand(*demand_case(here, key, value))
        assert refused.value.code == "elsewhere" and refused.value.key == key
    for key, value in (("ag_g", 0.26), ("ag_g", 0.30), ("coordinates", "52.5, 13.4")):
        assert read_demand(*demand_case(here, key, value)) is not None
    undated = here | {"return_period_years": None}  # at the shortest, F_0 and T_C* the least from it on
    for key, value in (("ag_g", 0.2), ("tc_star_s", 0.1), ("f0", 2.2)):
        with pytest.raises(InputError, match="332 years") as refused:
            read_demand(*demand_case(undated, key, value))
        assert refused.value.code == "elsewhere" and refused.value.key == key
    assert read_demand(*demand_case(undated, "tc_star_s", 0.34)) is not None


@pytest.mark.shows("demand.coordinates")
@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("L'Aquila 42.35, 13.40", "coordinates_unread"),
        ("33T 368000 4690000", "coordinates_unread"),
        ("a corner", "coordinates_unread"),
        ("13.40, 42.35", "coordinates_swapped"),
    ],
)
def test_that_coordinates_with_which_nothing_could_be_compared_are_refused(text, code):
    with pytest.raises(InputError) as refused:
        read_demand(
            *demand_case(
                {
                    "ag_g": 0.05,
                    "spectrum": {"code": "NTC2018", "f0": 2.36, "tc_star_s": 0.35, "soil": "C", "topography": "T1"},
                },
                "coordinates",
                text,
            )
        )
    assert refused.value.code == code


def demand_case(demand, key, value):
    """A case with one value of its demand changed, and the folder of its files."""
    table = {name: given for name, given in demand.items() if given is not None} | {
        "spectrum": dict(demand["spectrum"])
    }
    (table["spectrum"] if key in table["spectrum"] else table)[key] = value
    wall = {"name": "w", "mechanism": "two_sided", "height_m": 3.0, "thickness_m": 0.4, "base_z_m": 0.0}
    return parse_case({"wall": [wall], "demand": table}), Path()


@pytest.mark.parametrize("head", ["T[ms] Se[g]", "T (s); Se (m/s2)", "period [s] Se [cm/s2]", "f [Hz] Se"])
def test_that_a_spectrum_file_headed_by_other_units_is_refused(tmp_path, head):
    (tmp_path / "s.txt").write_text(f"{head}\n0 0.2\n0.5 0.5\n2 0.1\n4 0.05\n")
    with pytest.raises(InputError, match="the header names"):
        read_target_spectrum(Demand(0.2, spectrum_file="s.txt"), tmp_path)


def test_that_records_far_below_the_demand_are_warned_of():
    one = GroundMotion("a", np.sin(np.arange(500) * 0.3), 0.01, "a")
    for ag, codes in ((0.1, []), (0.6, ["weaker_records"])):
        case = Case(demand=Demand(ag, soil_factor=1.0))
        asked = complete_with_records(read_demand(case, Path()), [one])
        assert [warning.code for warning in asked.warnings] == codes


def test_that_a_spectrum_of_a_file_whose_displacement_falls_is_doubted_and_no_code_is():
    periods = np.linspace(0.02, 4.0, 200)
    for kind, soil in ((1, "A"), (1, "D"), (2, "A"), (2, "C")):
        code = en1998(2.0, kind, soil)
        copy = ts.given("copy", 2.0, code.soil, list(zip(periods, code.acceleration(periods), strict=True)))
        assert ts.displacement_fall(code) is None and ts.displacement_fall(copy) is None
    rows = [(t, a if t < 0.3 else 0.05 * a) for t, a in zip(periods, code.acceleration(periods), strict=True)]
    earlier, later, share = ts.displacement_fall(ts.given("cut", 2.0, code.soil, rows))
    assert earlier < 0.3 < later < 0.4 and 0.04 < share < 0.08


def test_that_a_spectrum_is_doubted_whose_displacement_falls_below_half():
    """S_De goes with T^2 S_e: 1.75 at 0.5 s; at 1.0 s 0.5 of it is no fall yet, 0.2857 is."""
    rows = [(0.0, 3.0), (0.1, 7.0), (0.5, 7.0), (1.0, 0.875), (2.5, 0.5)]
    assert ts.displacement_fall(ts.given("f", 3.0, 1.0, rows)) is None
    rows[3] = (1.0, 0.5)
    assert ts.displacement_fall(ts.given("f", 3.0, 1.0, rows)) == pytest.approx((0.5, 1.0, 2.0 / 7.0), rel=1e-12)
