"""What a history of a parapet with its elastic branch costs, in closed form and by the series:
`python3 run.py bench --branch`."""

import time

import numpy as np

from core.codes.target_spectrum import ntc2018
from core.ground.scattered import SPREAD, scattered_set
from core.rocking.grounds import Grounds
from core.rocking.history import scan_records
from core.rocking.methods import AUTO
from core.units import G
from core.wall.rocking_model import RockingModel, with_branch
from tests.benchmarks.inputs import Command

RIGID = RockingModel(0.2054, 12.0, 0.0, 0.9376, 0.0, 0.0, 0.0)
LIMIT = 0.001
"""D of a parapet of 1.2 x 0.25 m with E 1000 MPa."""

ROUNDS = 5


def main(options: Command) -> None:
    """Print microseconds of the processor a history, of both by turns, the least of ROUNDS."""
    motions = scattered_set(ntc2018(0.13 * G, 2.4, 0.33, "B", "T1"), 7, 3, SPREAD, (0.15, 2.0))
    grounds = Grounds.of(motions, 0.01)
    closed = with_branch(RIGID, LIMIT)
    models = {"rigid": RIGID, "closed form": closed, "series": closed._replace(driven=None)}
    for low, high in options.few(((0.2, 0.5), (0.5, 0.8), (0.8, 1.2))):
        scales = np.tile(np.linspace(low, high, 64), len(motions))
        which = np.repeat(np.arange(len(motions)), 64)
        taken = dict.fromkeys(models, np.inf)
        for _ in range(1 + options.number(ROUNDS, 1)):  # the first compiles
            for name, model in models.items():
                codes, peaks = np.zeros(scales.size, np.int64), np.zeros(scales.size)
                start = time.thread_time()
                scan_records(AUTO, grounds, which, scales, model, codes, peaks)
                taken[name] = min(taken[name], (time.thread_time() - start) / scales.size)
        said = ", ".join(f"{name} {1e6 * seconds:.0f} us" for name, seconds in taken.items())
        print(f"multipliers {low} to {high}: {said}", flush=True)
