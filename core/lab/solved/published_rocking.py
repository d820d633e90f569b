"""Published worked examples of rocking blocks; `published` holds them with the others."""

import math
from functools import partial

import numpy as np

from core.capacity.closed_forms import closed_form_q_eff
from core.lab.solved.experiments import first_overturning, overturned, section
from core.lab.solved.motion import least, overturns, rocking
from core.lab.solved.solved import Answer, Kind, Sketch, Solved, answer, printed, told
from core.rocking.history import integrate_history
from core.text.sentence import sentence
from core.units import CM, G
from core.wall.block import Block
from core.wall.rocking_model import RockingModel

HALF_SINES = ((2.0, 1.80072), (4.0, 2.79080), (8.0, 4.78707))
"""omega/p and the amplitude over g alpha at which a half sine overturns a linear block."""

SINE_EDGES = (("published_falls", 3.01), ("published_stands", 6.33), ("published_falls_again", 7.18))
"""Words and amplitudes over g alpha at which a full sine with omega = 5 p begins or ceases to overturn a block."""

LINEAR_ALPHA = 1e-3
"""alpha [rad] at which the exact equation is the linear one of the older papers, to six digits."""

PULSE_ALPHA, PULSE = 0.2, 0.5
"""alpha [rad] of the blocks of "Under this pulse", and the length of its full sine [s]."""

OVERTURNING_PEAKS = ((0.25, "1.26189"), (0.5, "1.45844"), (1.0, "2.16378"), (2.0, "5.15493"))
"""R [m], and the peak over g tan alpha from which that sine overturns."""

ENERGIES = (
    (1.0, 0.25, "2.67694"),
    (1.0, 0.5, "1.71109"),
    (1.0, 1.0, "0.92452"),
    (1.0, 2.0, "0.47692"),
    (1.0, 4.0, "0.24182"),
    (0.8, 0.25, "1.75478"),
    (0.8, 1.0, "0.64263"),
    (0.8, 4.0, "0.17001"),
)
"""Velocity ratio over Eq. 4, R [m], and the energy over that of the fall as the sine of twice g tan alpha ends."""

STOCKIER = 0.02
RECTANGLES = ((0.5, 2.54188), (1.0, 1.58219), (2.0, 1.15666))
"""p t_1, and the height over g alpha of the rectangle that overturns a block of R 1 m and alpha STOCKIER."""

TIPPED, PUSH = 0.35, 0.6311
"""alpha [rad] of the block that is pushed, and the push over m g by which it falls, for a time of 1 sqrt(R/g)."""

PULSE_SAMPLES = 4000
"""Samples that a pulse is given by: a straight line between two is 2e-7 off the sine."""


def _of_rocking() -> tuple[Solved, ...]:
    return (
        told(
            "published_paper_law",
            Kind.PRINTED,
            "Coccia, Di Carlo, Imperatore (2016), Eq. 15, 16 and Table 2",
            tuple(
                answer(code, q_eff, partial(closed_form_q_eff, math.radians(6.8), 7.0, 124.27 * CM, side))
                for code, q_eff, side in (
                    ("published_q_two_sided", 6.7595, False),
                    ("published_q_one_sided", 18.917, True),
                )
            ),
            formula="(30 alpha + 78 H + 90) / S_I",
        ),
        told(
            "published_housner_period",
            Kind.PRINTED,
            "Housner (1963), BSSA 53(2); test_p2_housner.py of an open fork of OpenSees",
            (answer("published_quarter_period", 0.60050, _quarter_period, 5e-3, "s"),),
            formula='T/4 = 1/p op("arcosh") 1/(1 - theta_0 / alpha)',
            sketch=Sketch(section(2.0, 0.4)),
        ),
        told(
            "published_housner_pulses",
            Kind.PRINTED,
            "Housner (1963), BSSA 53(2); Makris, Roussos (2000), Géotechnique 50(3)",
            (
                answer("published_rectangle", math.acosh(1.25), _rectangular_pulse, 2e-3),
                *(
                    Answer(sentence("solved", "published_half_sine", ratio=w), "", a, 1e-3, partial(_half_sine, w))
                    for w, a in HALF_SINES
                ),
            ),
            formula="cosh p t_1 = 1 + 1/(2 r (r - 1)), quad r = dot.double(u) / (g alpha)",
        ),
        told(
            "published_full_sine",
            Kind.PRINTED,
            "Zhang, Makris (2001), J. Eng. Mech. 127(5)",
            tuple(answer(code, edge, partial(_edge_of_sine, n), 5e-3) for n, (code, edge) in enumerate(SINE_EDGES)),
        ),
    )


def _quarter_period() -> float:
    """Time until a block falls back from half of alpha: its mass is in its corners, half-width 0.2, half-height 1 m."""
    radius = math.hypot(0.2, 1.0)
    block = Block(math.atan2(0.2, 1.0), radius, 2.0 * radius**2)
    model = RockingModel(block.slenderness, block.p2, 0.0, 0.9, 0.0, 0.0, 0.0)
    return integrate_history(np.zeros(2001), 1e-3, 1.0, model, start=(0.5 * block.slenderness, 0.0)).impact_time[0]


def _rectangular_pulse() -> float:
    """Least p t_1 of a rectangle of twice g alpha that overturns."""
    model = RockingModel(LINEAR_ALPHA, 1.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    for duration in np.arange(0.68, 0.71, 5e-4):
        step = duration / 1000.0
        ground = np.where(np.arange(1002) <= 1000, 2.0 * LINEAR_ALPHA * G, 0.0)
        if first_overturning(ground, step, np.ones(1), model) == 1.0:
            return float(duration)
    return math.inf


def _half_sine(ratio: float) -> float:
    """Least amplitude over g alpha of a half sine with omega = ratio p."""
    model = RockingModel(LINEAR_ALPHA, 1.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    ground = LINEAR_ALPHA * G * np.sin(np.linspace(0.0, math.pi, 1001))
    return float(first_overturning(ground, math.pi / ratio / 1000.0, np.arange(1.5, 5.0, 5e-4), model))


def edges_of_sine(slenderness: float) -> list[float]:
    """Amplitudes over g alpha, in steps of 0.01, at which a full sine with omega = 5 p begins and ceases to overturn a
    block of velocity ratio 0.9."""
    model, scales = RockingModel(slenderness, 2.14**2, 0.0, 0.9, 0.0, 0.0, 0.0), np.arange(1.0, 9.0, 0.01)
    ground = slenderness * G * np.sin(np.linspace(0.0, 2.0 * math.pi, 2001))
    falls = overturned(ground, 2.0 * math.pi / (5.0 * 2.14) / 2000.0, scales, model)
    return [float(scales[n + 1]) for n in np.flatnonzero(np.diff(falls))]


def _edge_of_sine(n: int) -> float:
    return edges_of_sine(LINEAR_ALPHA)[n]


def _of_size(radius: float, share: float = 1.0) -> RockingModel:
    """A block of PULSE_ALPHA. radius : R [m]; share : its velocity ratio over that of Eq. 4"""
    return rocking(PULSE_ALPHA, share * (1.0 - 1.5 * math.sin(PULSE_ALPHA) ** 2), 2.0 * radius * math.cos(PULSE_ALPHA))


def _sine() -> np.ndarray:
    """A full sine whose peak is g tan alpha [m/s2]."""
    return G * math.tan(PULSE_ALPHA) * np.sin(np.linspace(0.0, 2.0 * math.pi, PULSE_SAMPLES + 1))


def _least_sine(radius: float) -> float:
    """Least peak over g tan alpha by which the sine overturns; above it, it always does up to 6."""
    shape, model = _sine(), _of_size(radius)
    return least(lambda scale: overturns(shape, PULSE / PULSE_SAMPLES, scale, model), 1.0, 6.0)


def _energy_left(share: float, radius: float) -> float:
    """Energy over that of the fall as the sine of twice g tan alpha ends."""
    model = _of_size(radius, share)
    motion = integrate_history(_sine(), PULSE / PULSE_SAMPLES, 2.0, model)
    rotation, velocity = abs(float(motion.rotation[-1])), float(motion.velocity[-1])
    risen = math.cos(PULSE_ALPHA - rotation) - math.cos(PULSE_ALPHA)
    return (0.5 * velocity**2 / model.p2 + risen) / (1.0 - math.cos(PULSE_ALPHA))


def _plateau(length: float) -> tuple[np.ndarray, float]:
    """A rectangle of g [m/s2] and its step [s]; its end, a straight line a step long, has its middle at the length."""
    return np.append(np.full(PULSE_SAMPLES + 1, G), 0.0), length / (PULSE_SAMPLES + 0.5)


def _least_rectangle(length: float) -> float:
    """Least height over g alpha of a rectangle that overturns a block of R 1 m. length : p t_1"""
    model = rocking(STOCKIER, 1.0, 2.0 * math.cos(STOCKIER))
    shape, step = _plateau(length / math.sqrt(model.p2))
    return least(lambda scale: overturns(shape, step, scale * STOCKIER, model), 1.0, 5.0)


def _tipped() -> RockingModel:
    """The block that is pushed, with R = g in metres, so that sqrt(R/g) is a second."""
    return rocking(TIPPED, 1.0 - 1.5 * math.sin(TIPPED) ** 2, 2.0 * G * math.cos(TIPPED))


def _least_push() -> float:
    shape, step = _plateau(1.0)
    return least(lambda scale: overturns(shape, step, scale, _tipped()), 0.4, 1.0)


def _peak_of_push(share: float) -> float:
    """Largest rotation [rad] under a share of the push printed."""
    shape, step = _plateau(1.0)
    return integrate_history(shape, step, share * PUSH, _tipped()).peak


def _of_open_programs() -> tuple[Solved, ...]:
    blocks = "Numerics in Motion (2026), Under this pulse (Numerics-in-Motion/blocks)"
    shape = section(2.0 * math.cos(PULSE_ALPHA), 2.0 * math.sin(PULSE_ALPHA))
    return (
        told(
            "published_sizes",
            Kind.PRINTED,
            blocks,
            tuple(
                printed((sentence("solved", "published_least_sine", radius=r), ""), a, partial(_least_sine, r), 1.0)
                for r, a in OVERTURNING_PEAKS
            ),
            formula="p = sqrt(3 g / (4 R)), quad e = 1 - 3 / 2 sin^2 alpha",
            sketch=Sketch(shape, motion=_drawn(_sine())),
        ),
        told(
            "published_energies",
            Kind.PRINTED,
            blocks,
            tuple(
                printed(
                    (sentence("solved", "published_energy", radius=r, share=share), ""),
                    value,
                    partial(_energy_left, share, r),
                )
                for share, r, value in ENERGIES
            ),
            formula="E / E_b = (dot(theta)^2 \\/ (2 p^2) + cos(alpha - abs(theta)) - cos alpha) / (1 - cos alpha)",
            sketch=Sketch(shape, motion=_drawn(_sine())),
        ),
        told(
            "published_rectangles",
            Kind.PRINTED,
            blocks,
            tuple(
                Answer(
                    sentence("solved", "published_least_rectangle", length=length),
                    "",
                    height,
                    5e-6,
                    partial(_least_rectangle, length),
                )
                for length, height in RECTANGLES
            ),
            formula="dot.double(u) / (g alpha) = 1 / (1 - e^(-p t_1))",
            sketch=Sketch(section(2.0 * math.cos(STOCKIER), 2.0 * math.sin(STOCKIER))),
        ),
        told(
            "published_push",
            Kind.PRINTED,
            "sanger640 (2026), tipping_block.py and its notes (sanger640/stable_lyap_filters)",
            (
                answer("published_lift", 0.365, lambda: math.tan(_tipped().slenderness), 1e-3),
                answer("published_least_push", PUSH, _least_push, 1e-3),
                *(
                    Answer(
                        sentence("solved", "published_push_peak", share=share),
                        "rad",
                        peak,
                        5e-3,
                        partial(_peak_of_push, share),
                    )
                    for share, peak in ((0.80, 0.0832), (0.99, 0.2863))
                ),
            ),
            sketch=Sketch(section(2.0 * math.cos(TIPPED), 2.0 * math.sin(TIPPED))),
        ),
    )


def _drawn(shape: np.ndarray) -> tuple[float, ...]:
    """Every hundredth sample, for a sketch."""
    return tuple(float(value) for value in shape[::100])


CASES: tuple[Solved, ...] = (*_of_rocking(), *_of_open_programs())
"""Worked examples of rocking blocks."""
