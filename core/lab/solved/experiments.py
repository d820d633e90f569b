"""Experiments of others, in numbers, and what the program finds; how sure each is stands in its comment."""

import math
from functools import partial

import numpy as np

from core.lab.solved.solved import Answer, Kind, Sketch, Solved, told
from core.rocking.history import scan_multipliers
from core.rocking.methods import METHODS
from core.rocking.outcome import STABLE
from core.text.sentence import sentence
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import RIGID
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model

TRAIN = Block.rectangle(3.76, math.atan2(0.914, 3.76))
"""The train of 1906 as a block of 3.76 x 0.914 m."""

TUFF = Block.rectangle(0.800, math.atan2(0.123, 0.800))
"""The wall of tuff of Sorrentino et al. (2011), in the paper's Fig. 4."""

GRANITE = {"1": (1.0, 0.25, 0.936), "2": (1.0, 0.17, 0.973), "3": (1.0, 0.12, 0.978)}
"""Granite blocks of Pena et al. (2007): height, thickness [m], velocity ratio measured in free rocking [-]."""


RATIO_BY = {"housner": "experiment_ratio_housner", "sorrentino_experimental": "experiment_ratio_eq5"}
"""Model -> words."""


def section(height: float, thickness: float) -> tuple[tuple[float, float], ...]:
    """Corners of a rectangular wall [m], from its outer hinge."""
    return (0.0, 0.0), (thickness, 0.0), (thickness, height), (0.0, height)


def overturned(ground: np.ndarray, step: float, scales: np.ndarray, model: RockingModel) -> np.ndarray:
    """Whether a motion overturns a block, of each multiplier.

    ground : [m/s2], shape (n,); step : [s]; scales : [-], shape (m,)
    """
    outcomes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
    scan_multipliers(METHODS["taylor"], ground, step, scales, model, outcomes, peaks)
    return outcomes != STABLE


def first_overturning(ground: np.ndarray, step: float, scales: np.ndarray, model: RockingModel) -> float:
    """Smallest of some multipliers at which a motion overturns a block; infinite where none does."""
    return float(min(scales[overturned(ground, step, scales, model)], default=math.inf))


def sine_that_overturns_the_train(frequency: float, ratio: float) -> float:
    """Least amplitude [g] of one full sine, in steps of 0.005. frequency [Hz]; ratio : of velocities at an impact"""
    step = 0.002
    time = np.arange(0.0, 15.0, step)
    sine = np.where(time < 1.0 / frequency, G * np.sin(2.0 * np.pi * frequency * time), 0.0)
    model = rocking_model(TRAIN, False, restitution(TRAIN, "user", ratio), RIGID)
    return first_overturning(sine, step, np.arange(0.25, 1.8, 0.005), model)


def measured(block: Block, model: str, ratio: float, tolerance: float) -> Answer:
    """A measured velocity ratio beside that of a model at rest."""
    return Answer(
        sentence("solved", RATIO_BY[model]), "", ratio, tolerance, lambda: restitution(block, model).ratio_at_rest
    )


def slender(aspect: float) -> Block:
    """A block of a metre and this height over thickness."""
    return Block.rectangle(1.0, math.atan2(1.0, aspect))


def _train() -> Solved:
    needed = [
        Answer(
            sentence("solved", "experiment_sine", frequency=frequency),
            "g",
            printed,
            0.10,
            partial(sine_that_overturns_the_train, frequency, 1.0),
        )
        for frequency, printed in ((1.0, 0.35), (1.5, 0.50), (2.0, 1.05))
    ]
    time = np.linspace(0.0, 1.0, 41)
    return told(
        "experiment_train_of_1906",
        Kind.EXPERIMENT,
        "Anooshehpoor, Heaton, Shi, Brune (1999), BSSA 89(4), abstract",
        tuple(needed),
        sketch=Sketch(section(3.76, 0.914), motion=tuple(np.sin(2.0 * np.pi * time))),
    )


def _restitutions() -> tuple[Solved, ...]:
    theory = {aspect: 1.0 - 1.5 / (1.0 + aspect**2) for aspect in (3.0, 5.0)}  # Eq. 4: sin^2 = 1/(1 + (H/t)^2)
    granite = [
        measured(Block.rectangle(height, math.atan2(thickness, height)), "housner", ratio, 0.03)
        for height, thickness, ratio in GRANITE.values()
    ]
    tuff = 1.0 - 1.5 / (1.0 + (0.800 / 0.123) ** 2)
    return (
        told(
            "experiment_interface",
            Kind.EXPERIMENT,
            "ElGawady et al., Effects of interface material on the dynamic behaviour of rigid blocks, abstract",
            (
                measured(slender(5.0), "housner", 0.95 * theory[5.0], 0.06),
                measured(slender(3.0), "housner", 0.97 * theory[3.0], 0.06),
                measured(slender(5.0), "sorrentino_experimental", 0.95 * theory[5.0], 0.005),
                measured(slender(3.0), "sorrentino_experimental", 0.97 * theory[3.0], 0.025),
            ),
            sketch=Sketch(section(1.0, 0.2)),
        ),
        told(
            "experiment_tuff",
            Kind.EXPERIMENT,
            "Sorrentino, AlShawa, Decanini (2011), in Coccia et al. (2016), Eq. 5 and Fig. 4",
            (
                measured(TUFF, "housner", 0.95 * tuff, 0.06),
                measured(TUFF, "sorrentino_experimental", 0.95 * tuff, 0.005),
            ),
            sketch=Sketch(section(0.800, 0.123)),
        ),
        told(
            "experiment_sack_stone",
            Kind.EXPERIMENT,
            "Costa et al. (2013), in Coccia et al. (2016), sect. 2",
            (measured(Block.rectangle(3.0, math.radians(6.63)), "housner", 0.98, 0.001),),
        ),
        told(
            "experiment_granite",
            Kind.EXPERIMENT,
            "Peña, Prieto, Lourenço, Campos Costa, Lemos (2007), EESD 36(15)",
            tuple(granite),
            sketch=Sketch(section(1.0, 0.25)),
        ),
    )


CASES: tuple[Solved, ...] = (_train(), *_restitutions())
"""Bodies that were tilted, shaken or overturned."""
