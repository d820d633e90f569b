"""The rocking block in closed form: free motion, pulses, harmonic motion, impacts.

Closed forms of the literature are of the linear equation, theta'' = p2 (theta - alpha s + u''/g): the program, which
integrates the exact one, is asked for a block so slender that both are one.
"""

import math
from collections.abc import Callable, Sequence
from functools import cache

import numpy as np

from core.lab.solved.solved import Answer, Kind, Sketch, Solved, printed, row, worded
from core.rocking.history import History, integrate_history
from core.rocking.outcome import COLLAPSED
from core.units import G
from core.wall.block import Block
from core.wall.loads import PointMass, composite
from core.wall.moment_rotation import LAWS
from core.wall.restitution import overturning_velocity, restitution
from core.wall.rocking_model import RockingModel, rocking_model

LINEAR_ALPHA = 1e-4
"""Slenderness of the block that moves as the linear equation says, to its square [rad]."""

BLOCK_HEIGHT = 7.0
"""Height [m] that the blocks have; it sets the unit of time alone, 1/p."""

PULSE_SAMPLES = 1000
"""Samples that a pulse or half a period has: a straight line between them is 1e-6 off the sine."""

BLOCK = Sketch(((0.0, 0.0), (0.83, 0.0), (0.83, BLOCK_HEIGHT), (0.0, BLOCK_HEIGHT)))


def pulse(shape: Sequence[float]) -> Sketch:
    """A block and the ground beneath it."""
    return Sketch(BLOCK.outline, motion=tuple(shape))


SINE = tuple(math.sin(math.pi * k / 40.0) for k in range(81))


def rocking(alpha: float = LINEAR_ALPHA, ratio: float = 1.0, height: float = BLOCK_HEIGHT) -> RockingModel:
    """A two-sided block. ratio : of velocities at an impact"""
    block = Block.rectangle(height, alpha)
    return rocking_model(block, False, restitution(block, "user", ratio), LAWS["rigid"])


def frequency(alpha: float = LINEAR_ALPHA, height: float = BLOCK_HEIGHT) -> float:
    """p of a rectangular block [rad/s]."""
    return math.sqrt(1.5 * G * math.cos(alpha) / height)


def least(holds: Callable[[float], bool], low: float, high: float) -> float:
    """Where a condition that fails at `low` and holds at `high` begins to hold, between them."""
    while high - low > 1e-11 * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def overturns(shape: np.ndarray, step: float, scale: float, model: RockingModel) -> bool:
    return integrate_history(shape, step, scale, model).outcome == COLLAPSED


def released(share: float, alpha: float, height: float = BLOCK_HEIGHT, ratio: float = 1.0) -> History:
    """A block that is let go at a share of its slenderness."""
    return integrate_history(np.zeros(20001), 0.001, 1.0, rocking(alpha, ratio, height), start=(share * alpha, 0.0))


def of_quarter_period(share: str) -> Answer:
    def found() -> float:
        return float(released(float(share), LINEAR_ALPHA).impact_time[0]) * frequency()

    expected = math.acosh(1.0 / (1.0 - float(share)))
    return Answer(f"p T/4 (θ_0/α = {share})", "", expected, 1e-7, found)


def of_quarter_period_exact(share: float, seconds: str) -> Answer:
    alpha = math.radians(6.8)
    return printed((f"T/4 (θ_0/α = {share})", "s"), seconds, lambda: float(released(share, alpha).impact_time[0]))


def of_rectangular_pulse(length: float) -> Answer:
    """length : of the pulse, times p"""

    def found() -> float:
        step = length / frequency() / PULSE_SAMPLES
        shape = np.concatenate([np.ones(PULSE_SAMPLES), [0.5, 0.0]])  # falls over two samples, of the same area
        return least(lambda a: overturns(shape, step, a * G * math.tan(LINEAR_ALPHA), rocking()), 1.0, 20.0)

    return Answer(f"a/(α g) (p t = {length:g})", "", 1.0 / (1.0 - math.exp(-length)), 2e-6, found)


def of_west(height: float, thickness: float) -> Answer:
    model = rocking(math.atan2(thickness, height), 0.9, height)

    def found() -> float:
        return least(lambda a: integrate_history(np.full(50, a * G), 0.01, 1.0, model).peak > 0.0, 1e-3, 1.0)

    return Answer(f"a/g ({height:g} × {thickness:g} m)", "", thickness / height, 1e-9, found)


def of_ishiyama(height: float, thickness: float) -> Answer:
    alpha, step = math.atan2(thickness, height), 1e-5
    radius = math.hypot(0.5 * height, 0.5 * thickness)
    expected = math.sqrt(8.0 * G * radius / 3.0 * (1.0 - math.cos(alpha))) / math.cos(alpha)
    blow = np.array([0.0, 1.0, 0.0]) / step  # a velocity of 1 m/s

    def found() -> float:
        return least(lambda v: overturns(blow, step, v, rocking(alpha, 0.9, height)), 1e-3, 5.0)

    return Answer(f"v ({height:g} × {thickness:g} m)", "m/s", expected, 1e-4, found)


def of_half_sine(ratio: float, value: str, alpha: float, units: float) -> Answer:
    """ratio : of the circular frequency to p"""

    def found() -> float:
        step = math.pi / (ratio * frequency(alpha)) / PULSE_SAMPLES
        shape = np.sin(math.pi * np.arange(PULSE_SAMPLES + 1) / PULSE_SAMPLES)
        return least(lambda a: overturns(shape, step, a * G * math.tan(alpha), rocking(alpha)), 1.0, 6.0)

    return printed((f"a/(α g) (ω/p = {ratio:g})", ""), value, found, units)


def full_sine_overturns(amplitude: float) -> bool:
    """Whether one sine of omega = 5 p overturns a slender block of e = 0.9. amplitude : over alpha g"""
    step = 2.0 * math.pi / (5.0 * frequency()) / (2 * PULSE_SAMPLES)
    shape = np.sin(math.pi * np.arange(2 * PULSE_SAMPLES + 1) / PULSE_SAMPLES)
    return overturns(shape, step, amplitude * G * math.tan(LINEAR_ALPHA), rocking(ratio=0.9))


FULL_SINE = (
    printed(
        (worded("overturns after one impact from a/(α g)"), ""), "3.019", lambda: least(full_sine_overturns, 2.8, 3.3)
    ),
    printed(
        (worded("stands again from a/(α g)"), ""),
        "6.318",
        lambda: least(lambda a: not full_sine_overturns(a), 5.5, 6.8),
    ),
    printed(
        (worded("overturns without impact from a/(α g)"), ""), "7.168", lambda: least(full_sine_overturns, 6.8, 7.8)
    ),
)


def periodic(amplitude: float, omega: float, halves: int, ratio: float) -> tuple[float, float, float]:
    """(velocity after an impact, cosine and sine of the phase of the ground there) of the symmetric motion of one
    impact each `halves` half periods of u'' = a cos(omega t + phi); times over 1/p, rotations over alpha.

    Between impacts x = 1 + B cosh t + C sinh t - g cos(omega t + phi), g = a / (1 + omega2); x = 0 at both ends, and
    the velocity v at the first is that at the last times -e. Both lines are linear in v, c = g cos(phi) and
    s = g omega sin(phi).
    """
    length, g = halves * math.pi / omega, amplitude / (1.0 + omega**2)
    ch, sh = math.cosh(length), math.sinh(length)
    system = np.array([[1.0 + ch, -sh], [sh, -(1.0 + ch)]])
    start = np.linalg.solve(system, [ch - 1.0, sh])
    slope = np.linalg.solve(system, [-sh, -(ch + 1.0 / ratio)])
    scale = np.array([1.0 / g, 1.0 / (g * omega)])
    start, slope = start * scale, slope * scale  # (c, s) of length one
    square = float(slope @ slope), 2.0 * float(start @ slope), float(start @ start) - 1.0
    velocity = (-square[1] + math.sqrt(square[1] ** 2 - 4.0 * square[0] * square[2])) / (2.0 * square[0])
    return velocity, *(start + slope * velocity).tolist()


def of_periodic(amplitude: float, omega: float, halves: int, ratio: float) -> tuple[Answer, ...]:
    """Forty periods of the ground from an impact: the block has to keep the motion."""
    velocity, cosine, sine = periodic(amplitude, omega, halves, ratio)
    p = frequency()

    @cache
    def found() -> History:
        step = math.pi / (omega * p) / PULSE_SAMPLES
        phase = math.pi / PULSE_SAMPLES * np.arange(80 * PULSE_SAMPLES) + math.atan2(sine, cosine)
        ground = amplitude * G * math.tan(LINEAR_ALPHA) * np.cos(phase)
        return integrate_history(ground, step, 1.0, rocking(ratio=ratio), start=(0.0, velocity * p * LINEAR_ALPHA))

    case = f"(a = {amplitude:g} α g, ω = {omega:g} p, e = {ratio:g})"
    times = worded("periods between two impacts {case}", case=case)
    return (
        Answer(f"θ'/(p α) {case}", "", velocity, 5e-6, lambda: abs(found().impact_velocity[-1]) / (p * LINEAR_ALPHA)),
        Answer(
            times, "", 0.5 * halves, 5e-6, lambda: float(np.diff(found().impact_time)[-1]) * omega * p / (2 * math.pi)
        ),
    )


def of_capped(share: float) -> Answer:
    bare = Block.with_setback(3.0, 0.45, 0.0)

    def found() -> float:
        capped = composite(bare, 100.0, [PointMass(100.0 * share, 0.45, 3.0)])
        return capped.frequency_parameter / bare.frequency_parameter

    expected = math.sqrt((1.0 + 2.0 * share) / (1.0 + 3.0 * share))
    return Answer(f"p^/p (γ = {share:g})", "", expected, 1e-12, found)


def peaks_of(motion: History, alpha: float, count: int) -> list[float]:
    """Largest rotations after each of the first impacts, over alpha."""
    samples = (motion.impact_time / 0.001).astype(int)
    share = np.abs(motion.rotation) / alpha
    return [float(share[samples[k] : samples[k + 1] + 2].max()) for k in range(count)]


def of_decay(alpha_deg: float, peaks: str) -> tuple[Answer, ...]:
    alpha, count = math.radians(alpha_deg), len(peaks.split())
    ratio = 1.0 - 1.5 * math.sin(alpha) ** 2
    heads = [(worded("peak {n} over α ({alpha:g}°)", n=k, alpha=alpha_deg), "") for k in range(1, count + 1)]
    # the sample nearest to a peak is less than a millionth of alpha below it
    return row(heads, peaks, lambda: peaks_of(released(0.5, alpha, ratio=ratio), alpha, count), 1.5)


TUFF = math.atan2(0.123, 0.800)


@cache
def tuff() -> Block:
    """The wall of the paper's Fig. 4."""
    return Block.rectangle(0.800, TUFF)


def of_tuff_decay(share: float, peaks: str) -> tuple[Answer, ...]:
    """share : of the velocity ratio of Eq. 4"""

    def found() -> list[float]:
        return peaks_of(released(0.5, TUFF, 0.800, share * restitution(tuff(), "housner").ratio_at_rest), TUFF, 5)

    heads = [(worded("peak {n} over α (e {share:g} × Eq. 4)", n=k, share=share), "") for k in range(1, 6)]
    return row(heads, peaks, found, 20.0)


CASES: tuple[Solved, ...] = (
    Solved(
        "quarter_period",
        Kind.CLOSED_FORM,
        worded("Quarter period of free rocking, linear"),
        "Housner (1963), Bull. Seism. Soc. Am. 53(2), 403-417",
        tuple(map(of_quarter_period, ("0.1", "0.5", "0.9", "0.99"))),
        'T/4 = 1/p op("arcosh") 1/(1 - theta_0\\/alpha)',
        BLOCK,
        worded("A block of α = 0.0001 rad let go at θ_0: so slender that the exact equation is Housner's."),
    ),
    Solved(
        "quarter_period_exact",
        Kind.CLOSED_FORM,
        worded("Quarter period of free rocking, exact"),
        "physics.md, 2",
        tuple(
            of_quarter_period_exact(share, seconds)
            for share, seconds in ((0.1, "0.323710"), (0.5, "0.912068"), (0.9, "2.072341"), (0.99, "3.668056"))
        ),
        "T/4 = integral_0^(theta_0) (dif theta)/sqrt(2 p^2 (cos(alpha - theta_0) - cos(alpha - theta)))",
        BLOCK,
        worded(
            "Wall of 7 m and 6.8°: the integral of the energy by quadrature. Housner's linear form is "
            "0.0002 to 0.0004 s shorter."
        ),
    ),
    Solved(
        "rectangular_pulse",
        Kind.CLOSED_FORM,
        worded("Rectangular pulse that overturns"),
        "Housner (1963), Bull. Seism. Soc. Am. 53(2), 403-417",
        tuple(map(of_rectangular_pulse, (0.5, 1.0, 2.0))),
        "cosh(p t) = 1 + 1/(2 a/(alpha g) (a/(alpha g) - 1)) quad arrow.r.double quad a/(alpha g) = 1/(1 - e^(-p t))",
        pulse((0.0, *[1.0] * 40, 0.0, 0.0)),
        worded("Constant acceleration a for a time t, then none; least a that overturns, without impact."),
    ),
    Solved(
        "west",
        Kind.CLOSED_FORM,
        worded("Acceleration that uplifts (West)"),
        "Milne (1885), Trans. Seism. Soc. Japan 8; Ishiyama (1982), Earthq. Eng. Struct. Dyn. 10, 635-650",
        tuple(of_west(h, t) for h, t in ((7.0, 0.83), (3.0, 0.45), (1.2, 0.25))),
        "a/g = t/H",
        BLOCK,
        worded("Least constant acceleration under which the block leaves the ground."),
    ),
    Solved(
        "ishiyama",
        Kind.CLOSED_FORM,
        worded("Velocity that overturns (Ishiyama)"),
        "Ishiyama (1982), Earthq. Eng. Struct. Dyn. 10, 635-650",
        tuple(of_ishiyama(h, t) for h, t in ((7.0, 0.83), (3.0, 0.45), (1.2, 0.25))),
        "v = sqrt((8 g R)/3 (1 - cos alpha)/(cos^2 alpha))",
        pulse((*[0.0] * 20, 1.0, *[0.0] * 20)),
        worded(
            "The ground takes the velocity v at once (in 0.01 ms): the block turns with v H/2 m/I_0, its energy just "
            "reaches the barrier."
        ),
    ),
    Solved(
        "half_sine",
        Kind.CLOSED_FORM,
        worded("Half sine that overturns, linear"),
        "Makris, Roussos (2000), Geotechnique 50(3), 243-262",
        tuple(
            of_half_sine(ratio, value, LINEAR_ALPHA, 500.0)
            for ratio, value in ((2.0, "1.80072393"), (4.0, "2.79079801"), (8.0, "4.78707127"))
        ),
        "p integral_(t_0)^infinity e^(-p (t - t_0)) (u''(t))/g dif t = alpha, quad u''(t_0) = alpha g",
        pulse((*SINE[:41], *[0.0] * 20)),
        worded(
            "Without impact; t_0 is the uplift. 1000 straight lines a pulse are off by some 1e-6, which "
            "is the tolerance."
        ),
    ),
    Solved(
        "half_sine_exact",
        Kind.CLOSED_FORM,
        worded("Half sine that overturns, exact"),
        "physics.md, 2",
        tuple(
            of_half_sine(ratio, value, math.radians(6.8), 4.0)
            for ratio, value in ((2.0, "1.800909"), (4.0, "2.792334"), (8.0, "4.791815"))
        ),
        "theta'' = -p^2 [sin(alpha - theta) - (u'')/g cos(alpha - theta)]",
        pulse((*SINE[:41], *[0.0] * 20)),
        worded("Wall of 7 m and 6.8°, amplitudes over g tan α: the exact equation solved by another program."),
    ),
    Solved(
        "full_sine",
        Kind.CLOSED_FORM,
        worded("One full sine: overturning with and without impact"),
        "Zhang, Makris (2001), J. Eng. Mech. 127(5), 473-483",
        FULL_SINE,
        "p integral_(t_0)^(2 pi\\/omega) e^(-p (t - t_0)) (u''(t))/g dif t = alpha quad (\"7.168\")",
        pulse(SINE),
        worded(
            "ω = 5 p, e = 0.9, linear. Between the two ways to overturn a stronger sine is safe again: collapse is not "
            "monotone in the amplitude, and a bisection over it is unsafe. The first two by hyperbolic functions "
            "from event to event."
        ),
    ),
    Solved(
        "steady_motion",
        Kind.CLOSED_FORM,
        worded("Steady motion under a sine, an impact each half period"),
        "Hogan (1989), Proc. R. Soc. Lond. A 425, 441-476",
        of_periodic(2.0, 3.0, 1, 0.9) + of_periodic(4.0, 8.0, 1, 0.9) + of_periodic(2.5, 5.0, 1, 0.925),
        "x = 1 + B cosh tau + C sinh tau - a/(1 + omega^2) cos(omega tau + phi), quad x(0) = x(T) = 0, quad "
        "x'(0) = -e x'(T), quad T = pi/omega",
        pulse(SINE * 2),
        worded(
            "x is θ/α, τ is p t, a over α g. Started on the orbit, the block has to be on it after forty "
            "periods, rounding and straight lines of the ground notwithstanding."
        ),
    ),
    Solved(
        "subharmonic_motion",
        Kind.CLOSED_FORM,
        worded("Steady motion of three times the period"),
        "Spanos, Koh (1984), J. Eng. Mech. 110(11), 1627-1642; Hogan (1989)",
        of_periodic(3.0, 5.0, 3, 0.925) + of_periodic(6.0, 8.0, 3, 0.925),
        "T = 3 pi\\/omega",
        pulse(SINE * 3),
        worded("As the case before, with an impact each three half periods of the ground: the mode (1, 3)."),
    ),
    Solved(
        "capped_column",
        Kind.CLOSED_FORM,
        worded("Block with a mass at its top"),
        "Makris, Vassiliou (2013), Earthq. Eng. Struct. Dyn. 42(3), 431-449",
        tuple(map(of_capped, (0.01, 0.2, 1.0))),
        "hat(p)/p = sqrt((1 + 2 gamma)/(1 + 3 gamma))",
        Sketch(((0.0, 0.0), (0.45, 0.0), (0.45, 3.0), (0.0, 3.0)), ((0.45, 3.0, 0.0, -1.0),)),
        worded(
            "γ is the mass over that of the block. Columns with a beam turn as a block with the mass at its top corner."
        ),
    ),
    Solved(
        "decay",
        Kind.CLOSED_FORM,
        worded("Decay by impacts"),
        "Coccia, Di Carlo, Imperatore (2016), Eq. 4; physics.md, 3",
        of_decay(3.1, "0.493478 0.487095 0.480845")
        + of_decay(6.8, "0.469730 0.442258 0.417141 0.394044 0.372705")
        + of_decay(11.3, "0.422315 0.361164 0.311369"),
        "cos(alpha - theta_(n+1)) = cos alpha + e^2 (cos(alpha - theta_n) - cos alpha), quad e = 1 - 3/2 sin^2 alpha",
        BLOCK,
        worded("From θ = 0.5 α at rest: an impact leaves e² of the energy."),
    ),
    Solved(
        "tuff_wall",
        Kind.PRINTED,
        worded("The paper's example: tuff wall of Fig. 4"),
        "Coccia, Di Carlo, Imperatore (2016), Fig. 4; Sorrentino, Al Shawa, Decanini (2011)",
        row(
            (("α", "rad"), ("R", "m"), ("p", "rad/s"), (worded("velocity ratio, Eq. 4"), "")),
            "0.1526 0.4047 4.2631 0.9654",
            lambda: (
                tuff().slenderness,
                tuff().radius,
                tuff().frequency_parameter,
                restitution(tuff(), "housner").ratio_at_rest,
            ),
        )
        + (printed(("T/4", "s"), "0.3089", lambda: float(released(0.5, TUFF, 0.8).impact_time[0]), 4.0),)
        + of_tuff_decay(1.0, "0.4513 0.4095 0.3731 0.3410 0.3124")
        + of_tuff_decay(0.95, "0.3924 0.3148 0.2558 0.2096 0.1727"),
        "theta_n\\/alpha = 1 - sqrt(1 - e^(2 n) (1 - (1 - theta_0\\/alpha)^2))",
        Sketch(((0.0, 0.0), (0.123, 0.0), (0.123, 0.8), (0.0, 0.8))),
        worded(
            "0.800 × 0.123 m, let go at half of its slenderness. Period and peaks are of the linear "
            "form; at 8.7° the exact ones differ in the fourth digit, up to 0.002, which is the "
            "tolerance."
        ),
    ),
    Solved(
        "overturning_velocity",
        Kind.CLOSED_FORM,
        worded("Velocity at θ = 0 that overturns (Eq. 8)"),
        "Coccia, Di Carlo, Imperatore (2016), Eq. 8",
        (
            printed(
                ("θ_r'", "rad/s"),
                "0.1713",
                lambda: overturning_velocity(Block.rectangle(BLOCK_HEIGHT, math.radians(6.8))),
            ),
            Answer(
                worded("least velocity whose history overturns"),
                "rad/s",
                math.sqrt(2.0 * (1.0 - math.cos(math.radians(6.8)))) * frequency(math.radians(6.8)),
                1e-9,
                lambda: least(
                    lambda v: (
                        integrate_history(np.zeros(2), 0.01, 1.0, rocking(math.radians(6.8)), start=(0.0, v)).outcome
                        == COLLAPSED
                    ),
                    0.1,
                    0.3,
                ),
            ),
        ),
        "theta'_r = p sqrt(2 (1 - cos alpha))",
        BLOCK,
        worded("Wall of 7 m and 6.8°. The print lacks the root: 0.0294 in 1/s² in the place of 0.1713 rad/s."),
    ),
)
