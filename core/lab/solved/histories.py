"""Histories to 30 and 40 digits: references computed once, by other programs, with steps and impacts of their own."""

import csv
import math
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from core.lab.solved.solved import Answer, Kind, Sketch, Solved, worded
from core.rocking.history import History, integrate_history
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

FOLDER = Path(__file__).resolve().parents[3] / "resources" / "reference"
SAMPLE_STEP = 0.01
ALPHA = math.radians(6.8)

SECTION = ((0.0, 0.0), (0.834674, 0.0), (0.834674, 7.0), (0.0, 7.0))


@cache
def columns(name: str) -> np.ndarray:
    """Columns of a file of the references."""
    with open(FOLDER / f"{name}.csv", encoding="utf-8") as stream:
        return np.array([[float(cell) for cell in line] for line in list(csv.reader(stream))[1:]]).T.copy()


def ground_of(name: str) -> np.ndarray:
    """Acceleration of the ground of a reference [m/s2]."""
    return columns(f"{name}_record")[1]


@cache
def found(name: str, one_sided: bool = False, law: str = "rigid", samples: int = 2001) -> History:
    """The history of the program: 7 m, 6.8°, the restitution of theory."""
    block = Block.rectangle(7.0, ALPHA)
    model = restitution(block, "one_sided_theoretical" if one_sided else "housner")
    return integrate_history(
        ground_of(name)[:samples], SAMPLE_STEP, 1.0, rocking_model(block, one_sided, model, LAWS[law])
    )


def largest(motion: History) -> float:
    """Over alpha, at the samples."""
    return float(np.abs(motion.rotation).max()) / ALPHA


def whole(name: str, impacts: int, peak: float, end: float, room: float) -> tuple[Answer, ...]:
    """A history against every sample of its reference. room : of the rotation over alpha"""

    def error() -> float:
        return float(np.abs(found(name).rotation / ALPHA - columns(f"{name}_record")[2]).max())

    def late() -> float:
        return float(np.abs(found(name).impact_time - columns(f"{name}_impacts")[0]).max())

    return (
        Answer(worded("impacts"), "", impacts, 0.0, lambda: found(name).impact_time.size),
        Answer(worded("largest rotation over α"), "", peak, room, lambda: largest(found(name)), 12),
        Answer(worded("last rotation over α"), "", end, room, lambda: found(name).rotation[-1] / ALPHA, 12),
        Answer(worded("largest difference of the rotation over α"), "", 0.0, room, error),
        Answer(worded("largest difference of the times of the impacts"), "s", 0.0, room, late),
    )


def part(one_sided: bool, law: str, impacts: int, peak: float, end: float, last: float) -> tuple[Answer, ...]:
    """The first 4.5 s of `standard`. last : time of the last impact [s]"""

    def motion() -> History:
        return found("standard", one_sided, law, 450)

    return (
        Answer(worded("impacts"), "", impacts, 0.0, lambda: motion().impact_time.size),
        Answer(worded("largest rotation over α"), "", peak, 1e-11, lambda: largest(motion()), 12),
        Answer(worded("last rotation over α"), "", end, 1e-10 / end**0.5, lambda: motion().rotation[-1] / ALPHA, 12),
        Answer(worded("time of the last impact"), "s", last, 1e-11, lambda: motion().impact_time[-1], 12),
    )


def drawn(name: str, samples: int = 2001) -> Callable[[], Sketch]:
    return lambda: Sketch(SECTION, motion=tuple(ground_of(name)[:samples:4].tolist()))


FORTY = "resources/reference"

CASES: tuple[Solved, ...] = (
    Solved(
        "history_standard",
        Kind.REFERENCE,
        worded("A history of 20 s to forty digits"),
        FORTY,
        whole("standard", 20, 0.604144410309676, 0.327914632438699, 1e-12),
        sketch=drawn("standard"),
        comment=worded(
            "Wall of 7 m and 6.8°, two-sided, Eq. 4: Taylor series of order 20 to 26 in 40 digits, two "
            "orders alike to the last digit of a double."
        ),
    ),
    Solved(
        "history_hard",
        Kind.REFERENCE,
        worded("A history that magnifies every error, to forty digits"),
        FORTY,
        whole("hard", 24, 0.494826442714933, 0.153924345673713, 1e-11),
        sketch=drawn("hard"),
        comment=worded("The same wall; two tiny hops at 1.82 s multiply an error by 100 000."),
    ),
    Solved(
        "history_one_sided",
        Kind.REFERENCE,
        worded("A one-sided history to forty digits"),
        FORTY,
        part(True, "rigid", 56, 0.006357287140156756, 9.240317119098551e-7, 4.4899605341861835),
        sketch=drawn("standard", 450),
        comment=worded("The same wall against its restraint, Eq. 6, the first 4.5 s, by a program in 40 digits."),
    ),
    Solved(
        "history_trilinear",
        Kind.REFERENCE,
        worded("A history of the trilinear law to forty digits"),
        FORTY,
        part(False, "al_shawa", 14, 0.055613757247832973, 0.046239687289912207, 4.3485425784928019),
        sketch=drawn("standard", 450),
        comment=worded("The same wall, two-sided, D1 0.02 and D2 0.28, the first 4.5 s, by a program in 40 digits."),
    ),
    Solved(
        "history_trilinear_one_sided",
        Kind.REFERENCE,
        worded("A one-sided history of the trilinear law to forty digits"),
        FORTY,
        part(True, "doherty", 19, 0.1186536284530826, 0.029904182135162813, 4.3809384355365286),
        sketch=drawn("standard", 450),
        comment=worded(
            "The same wall against its restraint, D1 0.06 and D2 0.28, the first 4.5 s, by a program in 40 digits."
        ),
    ),
)
