"""Scenes of the work-precision chart, and their truth in 30 digits by an independent program."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import mpmath as mp
import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis
from core.ground import records
from core.known import require_value
from core.rocking.methods import METHODS
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model
from tests.benchmarks.inputs import MOVING, Command
from tests.conftest import shelf_folder
from tests.validation import high_precision

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Scene:
    """A wall under a record. ground [m/s2], scale included; dt [s]; truth : theta / alpha."""

    name: str
    ground: np.ndarray
    dt: float
    model: RockingModel
    truth: np.ndarray
    impacts: int


def wall(one_sided=False, model=None, law="rigid", height=7.0) -> RockingModel:
    block = Block.rectangle(height, math.radians(6.8))
    name = model or ("one_sided_theoretical" if one_sided else "housner")
    return rocking_model(block, one_sided, restitution(block, name), LAWS[law])


def _scene(name: str, ground, dt: float, model: RockingModel) -> Scene:
    """A scene with its truth; the model's own doubles are the exact input."""
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    ratio = mp.mpf(model.ratio_at_rest)
    theta, impacts = high_precision.history(
        ground, dt, model.slenderness, model.p2, model.one_sided != 0.0, lambda v: ratio, kinks
    )
    assert impacts, f"{name}: nothing to integrate"
    truth = np.array([float(value) for value in theta]) / model.slenderness
    return Scene(name, np.ascontiguousarray(ground), dt, model, truth, len(impacts))


def reference(name: str) -> np.ndarray:
    path = ROOT / "resources" / "reference" / f"{name}_record.csv"
    return np.loadtxt(path, delimiter=",", skiprows=1)[:, 1].copy()


def survived(ground: np.ndarray, dt: float, model: RockingModel) -> np.ndarray:
    """The record scaled to the last survival below first collapse."""
    pga = float(np.abs(ground).max())
    found = incremental_dynamic_analysis(ground, dt, pga, 1, model, METHODS["taylor"], Search())
    threshold = 9.80665 * math.tan(model.slenderness)
    return ground * (require_value(found.bracket)[0] * threshold / pga)


def scenes(options: Command) -> Iterator[Scene]:
    """All scenes; the real record only where the shelf is."""
    standard, hard, two = reference("standard"), reference("hard"), wall()
    made: list[tuple[str, Callable[[], np.ndarray], RockingModel]] = [
        ("standard", lambda: standard, two),
        ("one-sided, Eq. 6", lambda: 2.0 * standard, wall(True)),
        ("trilinear, D1 0.02", lambda: 0.6 * standard, wall(law="al_shawa")),
        ("hard", lambda: hard, two),
        ("one-sided, Hogan", lambda: 0.7 * standard, wall(True, "housner")),
        ("near collapse", lambda: survived(standard, 0.01, two), two),
        ("small wall, 0.5 m", lambda: 0.6 * standard, wall(height=0.5)),
    ]
    for name, ground, model in options.few(made, 3):
        yield _scene(name, options.few(ground(), *MOVING), 0.01, model)
    shelf = shelf_folder()
    if shelf:
        record = records.read(shelf / "PEER_AT2" / "elCentro_variant_noheader4.AT2")
        yield _scene("El Centro 1940", options.few(0.8 * record.acceleration, 100, 100), record.time_step, two)
