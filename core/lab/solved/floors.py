"""Walls above the ground: floor spectra of C7.2.3, the checks there, the motion of a floor, spectra of motions."""

import math
from functools import cache

import numpy as np

from core.codes.floor_spectrum import FloorSpectrum, estimated_period, first_mode, first_participation
from core.codes.spectrum_codes import en1998
from core.ground.floor_motion import Mode, floor_acceleration, modal_acceleration
from core.ground.ground_motion import GroundMotion
from core.ground.response_spectrum import displacement_spectrum
from core.known import require_value
from core.lab.solved.clauses import ZETA_DISPLACEMENT, ZETA_LINEAR
from core.lab.solved.motion import SINE
from core.lab.solved.solved import Answer, Head, Kind, Sketch, Solved, printed, row, worded
from core.lab.solved.walls import Asked
from core.units import G

BUILDING = {"height_m": 9.0, "storeys": 3, "period_s": 0.05 * 9.0**0.75}

WALLS_ABOVE_GROUND = (
    # key, H, t, z, free; a_Z, zeta linear, T_SLV, S_DeZ, zeta displacement
    ("storey", 3.0, 0.45, 6.0, False, "0.5567 0.3992 1.95824 0.16639 0.5409"),
    ("slender", 3.0, 0.30, 6.0, False, "0.5567 0.2661 1.95824 0.16639 0.3606"),
    ("high", 3.0, 0.45, 7.5, False, "0.69587 0.3193 1.95824 0.19375 0.4645"),
    ("parapet", 1.2, 0.25, 9.0, True, "0.83505 0.2904 1.23850 0.17976 0.2781"),
)
ABOVE_HEADS: tuple[Head, ...] = (("a_Z", "g"), ZETA_LINEAR, ("T_SLV", "s"), ("S_DeZ", "m"), ZETA_DISPLACEMENT)


def above(key: str, height: float, thickness: float, z: float, free: bool, values: str) -> Solved:
    wall = {"height_m": height, "thickness_m": thickness, "base_z_m": z, "hinge_heights": "base"}
    if free:
        wall |= {"mechanism": "two_sided", "elastic_modulus_mpa": 600.0}
    asked = Asked(wall, building=BUILDING)

    def found() -> tuple[float, ...]:
        check = asked.checked
        largest = require_value(asked.floor).a_z / G
        return (
            largest,
            asked.zeta_linear(),
            require_value(check.period),
            require_value(check.s_de),
            asked.zeta_displacement,
        )

    return Solved(
        f"floor_{key}",
        Kind.HAND,
        worded("Wall {h:g} × {t:g} m at {z:g} m", h=height, t=thickness, z=z),
        "Circolare 7/2019, C7.2.5-C7.2.10, C8.7.1.8-C8.7.1.12",
        row(ABOVE_HEADS, values, found),
        "a_Z = S_e (T_1, xi_1) gamma psi sqrt(1 + 4 xi_1^2), quad gamma = (3 n)/(2 n + 1), quad psi = z/H_b, quad "
        "A = 1.1 xi_1^(-0.5) eta(xi)",
        asked.sketch,
        worded(
            "Building of 9 m and three storeys, T_1 = 1.5 × 0.2598 s, ξ_1 10 %; a_g 0.26 g, EN 1998-1 "
            "type 1, ground B, FC 1.35. ξ_k of A is a fraction, against the print of C7.2.6."
        ),
        asked.table,
    )


@cache
def floor(z: float) -> FloorSpectrum:
    return FloorSpectrum(en1998(0.26 * G, 1, "B"), first_mode(3, 9.0, z, 1.5 * estimated_period(9.0), 0.10))


def at_six_metres(period: str, value: str) -> Answer:
    return printed(
        (f"S_eZ({period} s, 8 %)", "g"), value, lambda: float(floor(6.0).acceleration([float(period)], 0.08)[0]) / G
    )


def harmonic(ratio: float, damping: float) -> Answer:
    """The steady motion of a floor under a sine, in the last of many periods. ratio : of the frequency to its own"""

    def found() -> float:
        step, period = 2e-4, 0.4
        omega = 2.0 * math.pi / period * ratio
        t = np.arange(100000) * step
        moved = modal_acceleration(np.sin(omega * t), step, period, damping)
        return float(np.abs(moved[-round(2.0 * math.pi / omega / step) :]).max())

    square = (2.0 * damping * ratio) ** 2
    expected = math.sqrt((1.0 + square) / ((1.0 - ratio**2) ** 2 + square))
    return Answer(f"|A|/a (ω/ω_k = {ratio:g}, ξ = {damping:g})", "", expected, 2e-5, found)


def step_response(damping: float) -> Answer:
    """Largest displacement that a constant acceleration gives an oscillator of 0.5 s."""
    expected = (0.5 / (2.0 * math.pi)) ** 2 * (1.0 + math.exp(-math.pi * damping / math.sqrt(1.0 - damping**2)))
    ground, period = np.ones(2000), np.array([0.5])
    words = f"S_D (ξ = {damping:g})"
    return Answer(words, "m", expected, 5e-6, lambda: displacement_spectrum(ground, 0.001, period, damping, 0)[0])


@cache
def sine_motion() -> GroundMotion:
    """Ten periods of 1 s of a sine of 1 m/s2."""
    return GroundMotion("sine", np.sin(2.0 * math.pi * np.arange(0, 10.0005, 0.001)), 0.001)


def measures() -> tuple[Answer, ...]:
    omega = 2.0 * math.pi
    return (
        Answer("PGA", "m/s²", 1.0, 1e-9, lambda: sine_motion().pga),
        Answer("PGV", "m/s", 2.0 / omega, 1e-5, lambda: sine_motion().pgv),
        Answer("PGD", "m", 10.0 / omega, 1e-3, lambda: sine_motion().pgd),
        Answer("I_A", "m/s", math.pi / (2.0 * 9.80665) * 5.0, 1e-6, lambda: sine_motion().arias),
        # from 5 % to 95 % of ten periods; the square of the sine moves each end by up to a tenth of one
        Answer("t_5-95", "s", 9.0, 0.017, lambda: sine_motion().duration_5_95),
    )


def unmoved() -> float:
    """Largest difference of the motion of the ground from that of a floor that takes no part in any mode."""
    ground = sine_motion().acceleration
    return float(np.abs(floor_acceleration(ground, 0.001, [Mode(0.4, 0.1, 0.0)])[0] - ground).max())


def stiff() -> float:
    """Largest difference for a building of a period of 10 µs."""
    ground = sine_motion().acceleration
    moved, step = floor_acceleration(ground, 0.001, [Mode(1e-5, 0.1, 1.2)])
    whole = moved[:: round(0.001 / step)][: ground.size]
    return float(np.abs(whole - ground[: whole.size]).max())


GROUND_SKETCH = Sketch(motion=SINE * 4)

CASES: tuple[Solved, ...] = (
    *(above(*one) for one in WALLS_ABOVE_GROUND),
    Solved(
        "floor_spectrum",
        Kind.HAND,
        worded("Spectrum of a floor at 6 m"),
        "Circolare 7/2019, C7.2.5-C7.2.7",
        tuple(
            at_six_metres(period, value)
            for period, value in (
                ("0", "0.55670"),
                ("0.1", "0.80702"),
                ("0.3118", "1.69840"),
                ("0.4286", "1.69840"),
                ("0.6", "1.00961"),
                ("1.0", "0.43606"),
            )
        ),
        'S_"eZ" = (A a_Z)/(1 + (A - 1)(1 - T\\/(0.8 T_1))^1.6), quad A a_Z, quad (A a_Z)/(1 + (A - '
        "1)(T\\/(1.1 T_1) - 1)^1.2)",
        comment=worded("The building of the cases before: below 0.8 T_1, up to 1.1 T_1, beyond."),
    ),
    Solved(
        "building_period",
        Kind.HAND,
        worded("Period and participation of a building"),
        "Circolare 7/2019, C7.2.10; EN 1998-1, 4.6",
        (
            printed(("T_1 (9 m)", "s"), "0.2598", lambda: estimated_period(9.0)),
            Answer("γ_1 (n = 3)", "", 9.0 / 7.0, 1e-12, lambda: first_participation(3)),
        ),
        "T_1 = 0.05 H_b^0.75, quad gamma_1 = (3 n)/(2 n + 1)",
    ),
    Solved(
        "parapet_spectrum",
        Kind.HAND,
        worded("Spectrum at the period of a parapet"),
        "Circolare 7/2019, C8.7.1.7, C7.2.6",
        (
            printed(
                ("S_eZ(0.06246 s, 5 %)", "g"),
                "1.06278",
                lambda: float(floor(9.0).acceleration([0.06246180], 0.05)[0]) / G,
            ),
        ),
        'S_"eZ" (T_0, 5 %)',
        comment=worded("1.2 × 0.25 m at 9 m, E 600 MPa: the parapet of the case before."),
    ),
    Solved(
        "floor_harmonic",
        Kind.CLOSED_FORM,
        worded("Motion of a floor under a sine"),
        "Chopra, Dynamics of Structures, 3.6",
        tuple(harmonic(*one) for one in ((0.5, 0.05), (1.0, 0.05), (1.0, 0.20), (2.0, 0.10))),
        "abs(A)/a = sqrt((1 + (2 xi r)^2)/((1 - r^2)^2 + (2 xi r)^2)), quad r = omega\\/omega_k",
        GROUND_SKETCH,
        worded("Absolute acceleration of a mode of 0.4 s after twenty seconds, over that of the ground."),
    ),
    Solved(
        "floor_limits",
        Kind.CLOSED_FORM,
        worded("Motion of a floor that moves as the ground"),
        "physics.md, 16",
        (
            Answer(worded("difference without participation"), "m/s²", 0.0, 0.0, unmoved),
            Answer(worded("difference of a building without period"), "m/s²", 0.0, 1e-5, stiff),
        ),
        "a_z = (1 - sum gamma_k psi_k) u'' + sum gamma_k psi_k A_k",
        GROUND_SKETCH,
        worded("With γψ = 0 the record itself, bit for bit; a building of 10 µs follows the ground whatever its γψ."),
    ),
    Solved(
        "step_response",
        Kind.CLOSED_FORM,
        worded("Oscillator under a constant acceleration"),
        "Chopra, Dynamics of Structures, 4.3",
        tuple(map(step_response, (0.0, 0.05, 0.20))),
        "S_D = a/omega^2 (1 + e^(-pi xi\\/sqrt(1 - xi^2)))",
        Sketch(motion=(0.0, *[1.0] * 60)),
        worded("0.5 s under 1 m/s²; the recursion is exact, samples each millisecond miss the peak by some 1e-6."),
    ),
    Solved(
        "sine_measures",
        Kind.CLOSED_FORM,
        worded("Measures of a sine"),
        "physics.md, 12",
        measures(),
        '"PGV" = 2/omega, quad "PGD" = t/omega, quad I_A = pi/(2 g) integral a^2 dif t = (pi t)/(4 g)',
        GROUND_SKETCH,
        worded(
            "Ten periods of 1 s of 1 m/s²: without correction of the base line the velocity has one sign "
            "and the ground drifts."
        ),
    ),
)
