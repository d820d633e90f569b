"""The demand: hazard of a place, islands, return periods, spectra of the codes, what zeta means for an owner."""

import math
from functools import cache, partial

from core.codes import target_spectrum
from core.codes.demand import SeismicDemand
from core.codes.limits import return_period
from core.codes.national_hazard import HazardValues, SiteHazard, hazard_at
from core.codes.risk import Risk, risk_class, risk_of_mechanism
from core.codes.spectrum_codes import en1998
from core.known import require_value
from core.lab.solved.solved import Answer, Kind, Solved, printed, row, worded
from core.units import G

ANNEX = "D.M. 14/01/2008, A, B"

SITES = (
    # key, place, latitude and longitude, nodes, rows T_R: a_g [g], F_0, T_C* [s]
    (
        "aquila",
        "L'Aquila",
        (42.3498, 13.3995),
        "26305 26306 26528 26527",
        (
            (30, "0.078781 2.40001 0.27212"),
            (50, "0.103892 2.33224 0.28097"),
            (475, "0.260743 2.36355 0.34653"),
            (712, "0.299774 2.38391 0.35616"),
            (1950, "0.418547 2.44269 0.37903"),
        ),
    ),
    (
        "modena",
        "Modena",
        (44.6471, 10.9252),
        "16058 16059 16281 16280",
        (
            (30, "0.048641 2.47549 0.25363"),
            (50, "0.060226 2.50629 0.26903"),
            (475, "0.163049 2.42772 0.28869"),
            (712, "0.190015 2.42820 0.29133"),
            (1950, "0.271089 2.41275 0.30084"),
        ),
    ),
    (
        "messina",
        "Messina",
        (38.1938, 15.554),
        "44765 44766 44988 44987",
        (
            (30, "0.060853 2.36104 0.27710"),
            (50, "0.081762 2.31621 0.29376"),
            (475, "0.248679 2.41108 0.35917"),
            (712, "0.295230 2.43090 0.37306"),
            (1950, "0.441673 2.48006 0.41956"),
        ),
    ),
    (
        "border",
        "Bardonecchia",
        (45.13446, 6.544813),
        "13111 13112 13334 13333",
        (
            (30, "0.026297 2.49510 0.17895"),
            (50, "0.034013 2.50990 0.20544"),
            (475, "0.094255 2.43520 0.26660"),
            (712, "0.111311 2.42675 0.27096"),
            (1950, "0.162281 2.43061 0.28266"),
        ),
    ),
)


@cache
def site(point: tuple[float, float]) -> SiteHazard:
    return hazard_at(*point)


def site_values(point: tuple[float, float], years: int) -> HazardValues:
    return site(point).at(float(years))


def of_site(key: str, place: str, point: tuple[float, float], nodes: str, rows) -> Solved:
    corners = row([(worded("node {n}", n=k), "") for k in range(1, 5)], nodes, lambda: site(point).nodes)
    answers = [
        answer
        for years, values in rows
        for answer in row(
            ((f"a_g ({years})", "g"), (f"F_0 ({years})", ""), (f"T_C* ({years})", "s")),
            values,
            partial(site_values, point, years),
        )
    ]
    return Solved(
        f"hazard_{key}",
        Kind.HAND,
        worded("Hazard of {place}", place=place),
        ANNEX,
        (*corners, *answers),
        "p = (sum_i p_i\\/d_i)/(sum_i 1\\/d_i), quad log p = log p_1 + log(p_2\\/p_1) "
        "(log(T_R\\/T_1))/(log(T_2\\/T_1))",
        comment=worded(
            "Latitude {north}, longitude {east}; return periods in brackets. Worked from the table of "
            "the annex by another program.",
            north=point[0],
            east=point[1],
        ),
    )


ISLANDS = (
    # place, a_g [g/10], F_0, T_C* [s] at the return periods of the table
    (
        "Sardegna",
        (39.22, 9.12),
        "0.186 0.235 0.274 0.314 0.351 0.393 0.500 0.603 0.747",
        "2.61 2.67 2.70 2.73 2.78 2.82 2.88 2.98 3.09",
        "0.273 0.296 0.303 0.307 0.313 0.322 0.340 0.372 0.401",
    ),
    (
        "Ventotene",
        (40.79, 13.43),
        "0.239 0.303 0.347 0.389 0.430 0.481 0.600 0.707 0.852",
        "2.61 2.61 2.61 2.66 2.69 2.71 2.92 3.07 3.27",
        "0.245 0.272 0.298 0.326 0.366 0.401 0.476 0.517 0.564",
    ),
    (
        "Ustica",
        (38.71, 13.18),
        "0.429 0.554 0.661 0.776 0.901 1.056 1.500 1.967 2.725",
        "2.50 2.50 2.50 2.50 2.50 2.50 2.50 2.50 2.50",
        "0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400",
    ),
    (
        "Alicudi",
        (38.54, 14.35),
        "0.350 0.558 0.807 1.020 1.214 1.460 2.471 3.212 4.077",
        "2.70 2.70 2.70 2.70 2.70 2.70 2.70 2.70 2.70",
        "0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400 0.400",
    ),
    (
        "Stromboli",
        (38.80, 15.22),
        "0.618 0.817 0.983 1.166 1.354 1.580 2.200 2.823 3.746",
        "2.45 2.48 2.51 2.52 2.56 2.56 2.58 2.65 2.76",
        "0.287 0.290 0.294 0.290 0.290 0.292 0.306 0.316 0.324",
    ),
)
YEARS = (30, 50, 72, 101, 140, 201, 475, 975, 2475)


def of_island(name: str, point: tuple[float, float], *rows: str) -> Solved:
    def found(k: int, years: int, scale: float) -> float:
        return scale * site_values(point, years)[k]

    answers = [
        printed((f"{symbol} ({years})", unit), value, partial(found, k, years, scale))
        for k, (symbol, unit, scale, values) in enumerate(
            zip(("a_g", "F_0", "T_C*"), ("g/10", "", "s"), (10.0, 1.0, 1.0), rows, strict=True)
        )
        for years, value in zip(YEARS, values.split(), strict=True)
    ]
    return Solved(
        f"island_{name.lower()}",
        Kind.PRINTED,
        worded("Hazard of an island: {name}", name=name),
        "D.M. 14/01/2008, B, Tab. 2",
        tuple(answers),
        comment=worded(
            "Latitude {north}, longitude {east}: one row of the table; return periods in brackets.",
            north=point[0],
            east=point[1],
        ),
    )


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


@cache
def of_zeta(zeta: float) -> Risk:
    return risk_of_mechanism(zeta, DEMAND)


RISK_CLASSES = ["F", "E", "D", "C", "B", "A", "A+"]
MIN_IS_V = {"A+": 1.01, "A": 0.80, "B": 0.60, "C": 0.45, "D": 0.30, "E": 0.15, "F": 0.0}
"""Lower bounds of IS-V of the guidelines; of A+ a value above 1.00."""


def least_of(letter: str) -> float:
    """The lowest hundredth of IS-V that has a letter; of A+ above 1.00."""
    return next(k / 100.0 for k in range(200) if risk_class(k / 100.0) == letter)


EN_TABLES = (
    # ground; S, T_B, T_C, T_D of type 1 and of type 2
    ("A", "1.0 0.15 0.4 2.0", "1.0 0.05 0.25 1.2"),
    ("B", "1.2 0.15 0.5 2.0", "1.35 0.05 0.25 1.2"),
    ("C", "1.15 0.2 0.6 2.0", "1.5 0.1 0.25 1.2"),
    ("D", "1.35 0.2 0.8 2.0", "1.8 0.1 0.3 1.2"),
    ("E", "1.4 0.15 0.5 2.0", "1.6 0.05 0.25 1.2"),
)


SPECTRUM_NAMES = {"S": "soil", "T_B": "t_b", "T_C": "t_c", "T_D": "t_d"}
"""Symbol of a quantity of a spectrum -> its name in the program."""


def of_grounds(kind: int) -> tuple[Answer, ...]:
    def found(soil: str, name: str) -> float:
        return getattr(en1998(0.25 * G, kind, soil), name)

    return tuple(
        Answer(f"{symbol} ({soil})", "s" if symbol != "S" else "", float(value), 1e-12, partial(found, soil, name))
        for soil, *rows in EN_TABLES
        for (symbol, name), value in zip(SPECTRUM_NAMES.items(), rows[kind - 1].split(), strict=True)
    )


NTC_TABLE = {
    # ground: S_S = a - b F_0 a_g/g within two bounds; C_C = c T_C*^d
    "A": (1.00, 0.00, 1.00, 1.00, 1.00, 0.00),
    "B": (1.40, 0.40, 1.00, 1.20, 1.10, -0.20),
    "C": (1.70, 0.60, 1.00, 1.50, 1.05, -0.33),
    "D": (2.40, 1.50, 0.90, 1.80, 1.25, -0.50),
    "E": (2.00, 1.10, 1.00, 1.60, 1.15, -0.40),
}


def of_ntc(soil: str) -> tuple[Answer, ...]:
    """S and the periods for a weak, a usual and a strong motion; topography T3."""
    a, b, low, high, c, d = NTC_TABLE[soil]

    def found(ag: float, f0: float, tc: float, name: str) -> float:
        return getattr(target_spectrum.ntc2018(ag * G, f0, tc, soil, "T3"), name)

    answers = []
    for ag, f0, tc in ((0.05, 2.4, 0.27), (0.25, 2.4, 0.35), (0.45, 2.55, 0.45)):
        t_c = c * tc ** (1.0 + d)
        by_hand = {"S": 1.2 * min(max(a - b * f0 * ag, low), high), "T_B": t_c / 3.0, "T_C": t_c, "T_D": 4.0 * ag + 1.6}
        for symbol, value in by_hand.items():
            ask = partial(found, ag, f0, tc, SPECTRUM_NAMES[symbol])
            answers.append(Answer(f"{symbol} ({soil}, {ag:g} g)", "s" if symbol != "S" else "", value, 1e-12, ask))
    return tuple(answers)


def of_branches(damping: float) -> tuple[Answer, ...]:
    """EN 1998-1 type 1, ground B, 0.25 g at and between T_B 0.15, T_C 0.5 and T_D 2.0 s."""
    eta, plateau = max(math.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55), 0.25 * 1.2 * 2.5

    def by_hand(t: float) -> float:
        if t < 0.15:
            return 0.3 * (1.0 + t / 0.15 * (2.5 * eta - 1.0))
        return plateau * eta * (1.0 if t <= 0.5 else 0.5 / t if t <= 2.0 else 1.0 / t**2)

    def found(t: float) -> float:
        return float(en1998(0.25 * G, 1, "B").acceleration([t], damping)[0]) / G

    return tuple(
        Answer(f"S_e({t:g} s, {100 * damping:g} %)", "g", by_hand(t), 1e-12, partial(found, t))
        for t in (0.0, 0.075, 0.15, 0.3, 0.5, 1.0, 2.0, 4.0)
    )


def spectrum() -> target_spectrum.CodeSpectrum:
    """EN 1998-1 type 1, ground B, 0.26 g."""
    return en1998(0.26 * G, 1, "B")


RISING = (0.15**2 - 0.1**2) / 2.0 + 10.0 * (0.15**3 - 0.1**3) / 3.0
"""Integral of (1 + 1.5 T / T_B) T up to T_B."""

INTENSITY = (
    100.0
    * 0.312
    * 9.80665
    / (2.0 * math.pi)
    * (RISING + 2.5 * ((0.5**2 - 0.15**2) / 2.0 + 0.5 * (2.0 - 0.5) + 0.5 * 2.0 * math.log(2.5 / 2.0)))
)
"""Housner intensity that its branches integrate to, one by one [cm]."""

CASES: tuple[Solved, ...] = (
    *(of_site(*one) for one in SITES),
    *(of_island(*island) for island in ISLANDS),
    Solved(
        "return_periods",
        Kind.HAND,
        worded("Return periods of the limit states"),
        "NTC 2018, 2.4, 3.2.0, Tab. 3.2.I",
        tuple(
            printed((f"T_R ({state}, {life:g})", ""), years, partial(return_period, life, state))
            for life, state, years in (
                (50.0, "SLO", "30.11"),
                (50.0, "SLD", "50.29"),
                (50.0, "SLV", "474.56"),
                (50.0, "SLC", "974.79"),
                (75.0, "SLV", "711.84"),
            )
        ),
        'T_R = -V_R/(ln(1 - P_"VR"))',
        comment=worded("V_R and T_R in years; P_VR 81, 63, 10 and 5 %."),
    ),
    Solved(
        "capacity_period",
        Kind.HAND,
        worded("Return period of the capacity"),
        "D.M. 65/2017, A",
        (
            printed(("PGA_C (ζ = 0.52)", "g"), "0.16224", lambda: of_zeta(0.52).pga / G),
            printed(("T_R,C (ζ = 0.52, η = 1/0.41)", ""), "96.4", lambda: require_value(of_zeta(0.52).return_period)),
            printed(
                ("T_R,C (ζ = 0.52, η = 1/0.49)", ""), "125.1", lambda: require_value(of_zeta(0.52).other_return_period)
            ),
            printed(("T_R,C (ζ = 0.75, η = 1/0.41)", ""), "235.5", lambda: require_value(of_zeta(0.75).return_period)),
        ),
        'T_(R,C) = T_(R,D) ("PGA"_C\\/"PGA"_D)^eta',
        comment=worded("a_g 0.26 g, S 1.2, T_R,D 475 years; both exponents, the shorter period is taken."),
    ),
    Solved(
        "risk_letters",
        Kind.PRINTED,
        worded("Letters of IS-V"),
        "D.M. 65/2017, A",
        tuple(
            Answer(f"IS-V ({letter})", "", MIN_IS_V[letter], 1e-12, partial(least_of, letter))
            for letter in RISK_CLASSES
        ),
        comment=worded("The lowest hundredth of IS-V that has the letter."),
    ),
    Solved("grounds_en_1", Kind.PRINTED, worded("Grounds of EN 1998-1, type 1"), "EN 1998-1, Tab. 3.2", of_grounds(1)),
    Solved("grounds_en_2", Kind.PRINTED, worded("Grounds of EN 1998-1, type 2"), "EN 1998-1, Tab. 3.3", of_grounds(2)),
    Solved(
        "grounds_ntc",
        Kind.PRINTED,
        worded("Grounds of NTC 2018"),
        "NTC 2018, Tab. 3.2.IV, 3.2.V",
        tuple(answer for soil in NTC_TABLE for answer in of_ntc(soil)),
        "S = S_T (a - b F_0 a_g\\/g), quad T_C = c (T_C^*)^(1 + d)",
        comment=worded(
            "a, b, c, d and the bounds of S_S typed from the table; a weak, a usual and a strong motion, topography T3."
        ),
    ),
    Solved(
        "spectrum_branches",
        Kind.HAND,
        worded("Branches of an elastic spectrum"),
        "EN 1998-1, 3.2.2.2; NTC 2018, 3.2.2",
        of_branches(0.05) + of_branches(0.08) + of_branches(0.30),
        "S_e = a_g S [1 + T/T_B (2.5 eta - 1)], quad 2.5 eta a_g S, quad 2.5 eta a_g S T_C/T, quad "
        "2.5 eta a_g S (T_C T_D)/T^2",
        comment=worded("Type 1, ground B, 0.25 g, at each corner and between; η not below 0.55."),
    ),
    Solved(
        "spectrum_intensity",
        Kind.CLOSED_FORM,
        worded("Housner intensity of a spectrum"),
        "EN 1998-1, 3.2.2.2; physics.md, 12",
        (
            # each 0.02 s the trapezoids miss the integral by some 1e-5
            Answer("SI", "cm", INTENSITY, 1e-4, lambda: 100.0 * target_spectrum.housner_intensity(spectrum())),
            Answer(
                "SI",
                "cm",
                INTENSITY,
                1e-9,
                lambda: 100.0 * spectrum().pga * target_spectrum.shape_integral(spectrum()) / (2.0 * math.pi),
            ),
        ),
        '"SI" = integral_0.1^2.5 (S_e T)/(2 pi) dif T',
        comment=worded(
            "Type 1, ground B, 0.26 g, 5 %: branch by branch; by the trapezoids of each 0.02 s, and exactly."
        ),
    ),
)
