"""The error of a history beside what noise of 1e-15 on the samples does to it, over random hostile cases.

The error is against a Taylor solver of order 24 in 30 digits that shares no code with the program
(tests/validation/high_precision.py): a second a case.

python3 run.py bench --noise [--cases N]
"""

import argparse
from concurrent.futures import ProcessPoolExecutor

import numpy as np

from core.capacity.accuracy import NOISE, NOISES, PROMISED, TIMES_NOISE
from core.rocking.history import history
from core.rocking.methods import AUTO
from tests.conftest import ROOT
from tests.validation import high_precision
from tests.validation.test_random_histories import drawn

SAMPLES = 150
"""Of a case, around the first at which the wall moves."""


def errors(seed: int) -> tuple[float, float]:
    """(error, effect of noise) of a random case, of alpha, while the wall stands."""
    rng = np.random.default_rng(seed)
    paths = sorted((ROOT / "resources" / "motions").glob("*.txt"))
    grounds = [np.loadtxt(paths[rng.integers(len(paths))], skiprows=2)[:, 1]]
    model, dt, ground = drawn(rng, grounds)
    first = int(np.argmax(np.abs(ground) >= min(model.threshold, np.abs(ground).max())))
    ground = np.ascontiguousarray(ground[max(0, first - 2) :][:SAMPLES])

    def distance(other: np.ndarray) -> float:
        both = min(once.size, other.size)
        first, second = once[:both], other[:both]
        inside = (np.abs(first) < model.slenderness) & (np.abs(second) < model.slenderness)
        return float(np.abs(first - second)[inside].max(initial=0.0)) / model.slenderness

    once = history(ground, dt, 1.0, model, AUTO).rotation
    noise = 0.0
    for _ in range(NOISES):
        moved = ground * (1.0 + NOISE * rng.uniform(-1.0, 1.0, ground.size))
        noise = max(noise, distance(history(moved, dt, 1.0, model, AUTO).rotation))
    kinks = (model.elastic_end, model.plateau_end) if model.plateau_end else None

    def ratio(speed):
        return max(0, model.ratio_at_rest - model.ratio_drop * speed * speed)

    exact, _ = high_precision.history(
        ground.tolist(), dt, model.slenderness, model.p2, model.one_sided != 0.0, ratio, kinks
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
