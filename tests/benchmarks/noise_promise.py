"""The error of a history beside what noise of 1e-15 on the samples does to it, over random hostile cases.

The error is against a Taylor solver of order 24 in 30 digits that shares no code with the program
(tests/validation/high_precision.py): a second a case.

python3 run.py bench --noise [--cases N]
"""

import argparse
import math
from concurrent.futures import ProcessPoolExecutor

import numpy as np

from core.capacity.accuracy import NOISE, NOISES, PROMISED, TIMES_NOISE
from core.rocking.history import history
from core.rocking.methods import AUTO
from core.wall.loads import RestoringMoment
from core.wall.rocking_model import RockingModel
from tests.conftest import ROOT
from tests.validation import high_precision
from tests.validation.test_random_histories import drawn

SAMPLES = 150
"""Of a case, around the first at which the wall moves."""


LOADED = 0.5
"""Share of the walls of the rigid law that carry loads."""


def loaded(model: RockingModel, rng: np.random.Generator) -> RockingModel:
    """A wall with loads that differ from side to side: up to three times the moment, thrusts inward and outward."""
    sides = []
    for _ in range(2):
        sine = 1.0 + 2.0 * rng.uniform()
        cosine = sine * math.tan(model.slenderness) * rng.uniform(-0.6, 1.0)
        sides.append(RestoringMoment(sine, cosine, math.hypot(sine, cosine), math.atan2(cosine, sine)))
    if model.one_sided:
        sides[1] = sides[0]
    weaker = min(sides, key=lambda side: side.lean)
    return model._replace(restoring=sides[0], mirrored=sides[1], lean=weaker.lean, amplitude=weaker.amplitude)


def errors(seed: int) -> tuple[float, float]:
    """(error, effect of noise) of a random case, of alpha, while the wall stands."""
    rng = np.random.default_rng(seed)
    paths = sorted((ROOT / "resources" / "motions").glob("*.txt"))
    grounds = [np.loadtxt(paths[rng.integers(len(paths))], skiprows=2)[:, 1]]
    model, dt, ground = drawn(rng, grounds)
    if model.plateau_end == 0.0 and rng.uniform() < LOADED:
        model = loaded(model, rng)
    first = int(np.argmax(np.abs(ground) >= min(model.threshold, np.abs(ground).max())))
    ground = np.ascontiguousarray(ground[max(0, first - 2) :][:SAMPLES])

    def distance(other: np.ndarray) -> float:
        both = min(once.size, other.size)
        first, second = once[:both], other[:both]
        inside = (np.abs(first) < model.collapse_rotation) & (np.abs(second) < model.collapse_rotation)
        return float(np.abs(first - second)[inside].max(initial=0.0)) / model.slenderness

    once = history(ground, dt, 1.0, model, AUTO).rotation
    noise = 0.0
    for _ in range(NOISES):
        moved = ground * (1.0 + NOISE * rng.uniform(-1.0, 1.0, ground.size))
        noise = max(noise, distance(history(moved, dt, 1.0, model, AUTO).rotation))
    kinks = (model.elastic_end, model.plateau_end) if model.plateau_end else None

    (a, c, *_), (b, d, *_) = model.restoring, model.mirrored

    def ratio(speed):
        return max(0, model.ratio_at_rest - model.ratio_drop * speed * speed)

    exact, _ = high_precision.history(
        ground.tolist(), dt, model.slenderness, model.p2, model.one_sided != 0.0, ratio, kinks, loads=((a, c), (b, d))
    )
    return distance(np.array([float(phi) for phi in exact])), noise


def main(options: argparse.Namespace) -> None:
    """Print the table."""
    cases = 4 if options.small else options.cases
    with ProcessPoolExecutor(2) as pool:
        found = np.array(list(pool.map(errors, range(cases), chunksize=4)))
    error, noise = found.T
    print(f"{cases} cases; error above {PROMISED:g} alpha: {int((error > PROMISED).sum())}")
    for times in sorted({1.0, 10.0, TIMES_NOISE}):
        beyond = int((error > np.maximum(PROMISED, times * noise)).sum())
        print(f"above the larger of {PROMISED:g} and {times:g} times the effect of noise of {NOISE:g}: {beyond}")
    over = error / np.maximum(noise, 1e-17)
    print(f"error over noise: median {np.median(over):.2g}, 99 % {np.quantile(over, 0.99):.2g}")
    quiet = noise < 1e-11
    print(f"noise below 1e-11: {int(quiet.sum())} cases, worst error {error[quiet].max(initial=0.0):.1e} alpha")
