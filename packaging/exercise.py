"""Call every kernel with every kind of wall, so that the library of machine code has it (packaging/kernels.py)."""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from core.codes.floor_spectrum import Mode
from core.codes.vertical_bending import model_of_bending
from core.ground.floor_motion import floor_motion
from core.ground.ground_motion import GroundMotion
from core.ground.selection import MAX_SETS, Bounds, nearest_sets
from core.jit import cache
from core.rocking.energy import energy_ratios
from core.rocking.history import integrate_history, scan_multipliers
from core.rocking.methods import METHODS
from core.wall.bars import Bar
from core.wall.bending import Strip
from core.wall.rocking_model import OtherSide, RockingModel, with_branch

GROUND = np.sin(np.arange(60) / 3.0) * 2.0
RIGID = RockingModel(0.13, 2.4, 0.0, 0.95, 0.0, 0.0, 0.0)
STRIP = Strip(3.0, 0.3, 0.0, 16e3)
WALLS = (
    RIGID,
    RIGID._replace(one_sided=1.0),
    RIGID._replace(elastic_end=0.01, plateau_end=0.04),
    RIGID._replace(other=OtherSide.of(0.15, 2.2, 0.93)),
    with_branch(RIGID, 0.1),
    RIGID._replace(bars=(Bar(2.0, 30.0, 0.002, 0.0, 0.05),)),
    model_of_bending(STRIP, STRIP),
)


def main() -> None:
    cache.own_process()
    motion = GroundMotion("sine", GROUND, 0.01)
    floor_motion(motion, [Mode(0.3, 0.05, 1.3)])
    for model in WALLS:
        for method in METHODS.values():
            scan_multipliers(method, GROUND, 0.01, np.array([0.5, -0.7]), model, np.zeros(2, np.int64), np.zeros(2))
            energy_ratios(integrate_history(GROUND, 0.01, 1.0, model, method), model)
    for count, size in ((6, 3), (40, 7)):
        ratios = np.exp(np.random.default_rng(1).normal(0.0, 0.2, (count, 12)))
        if (math.comb(count, size) <= MAX_SETS) != (count == 6):
            raise SystemExit(
                f"{size} of {count} motions no longer take the way they stand for (of 6 each set, of 40 a search): "
                f"choose other counts in packaging/exercise.py, for MAX_SETS = {MAX_SETS}"
            )
        nearest_sets(ratios, size, np.arange(count), np.arange(count), (1, 2), Bounds(0.9, 1.3, 0.0, (0.5, 2.0)))


if __name__ == "__main__":
    main()
