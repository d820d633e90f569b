"""The error of a history beside what noise of 1e-15 on the samples does to it, over random hostile cases.

The error is against a Taylor solver of order 24 in double-double arithmetic that shares no code with the program
(tests/validation/double_double.py): a millisecond a case.

python3 run.py bench --noise [--explain | --tangent] [--cases N]

--explain names each case whose error is beyond EXPLAINED times that effect, and the worst of all, and what its error
is. --tangent builds of each case without ties the two motions, a last digit apart, of which one lands once more:
between them a landing is tangent, where an error of the last digit becomes its square root.
"""

import functools
import math
import tempfile
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from typing import NamedTuple

import numpy as np

from core.capacity.accuracy import NOISE, NOISES, PROMISED, TIMES_NOISE
from core.rocking.history import integrate_history
from core.rocking.methods import AUTO
from core.rocking.taylor_bounds import RELATIVE_TOLERANCE, SERIES_TOLERANCE
from core.wall.bars import TieBar
from core.wall.loads import RestoringMoment
from core.wall.rocking_model import RockingModel
from tests.benchmarks import tolerance_sweep
from tests.benchmarks.inputs import Command
from tests.conftest import ROOT
from tests.validation import double_double_walls
from tests.validation.test_random_histories import drawn

SAMPLES = 150
"""Of a case, around the first at which the wall moves."""

KINDS = (
    "rigid law",
    "rigid law with loads",
    "trilinear law",
    "trilinear law with loads",
    "stiff elastic branch",
    "motion that begins small",
    "ties",
    "stiff ties",
)
"""What is drawn, in turn."""

MANY = 200
"""Draws of noise where NOISES of them do not explain an error."""

EXPLAINED = 10.0

TIMES = (1.0, EXPLAINED, 100.0, TIMES_NOISE)

TIGHTER = SERIES_TOLERANCE / 100.0, RELATIVE_TOLERANCE / 100.0

RIGID, LOADED, TRILINEAR, LOADED_TRILINEAR, STIFF, SMALL, TIES, STIFF_TIES = range(8)


class Case(NamedTuple):
    """A wall and its ground. dt : [s]; ground : [m/s2]"""

    model: RockingModel
    dt: float
    ground: np.ndarray


class Found(NamedTuple):
    """Of a case, as fractions of theta_c while the wall stands: error, largest effect of NOISES draws of NOISE, peak;
    impacts : count."""

    error: float
    noise: float
    peak: float
    impacts: int


def loaded(model: RockingModel, rng: np.random.Generator, alike: bool) -> RockingModel:
    """A wall with loads of up to three times its moment, thrusts inward and outward. alike : on both sides"""
    sides = []
    for _ in range(2):
        sine = 1.0 + 2.0 * rng.uniform()
        cosine = sine * math.tan(model.slenderness) * rng.uniform(-0.6, 1.0)
        sides.append(RestoringMoment(sine, cosine, math.hypot(sine, cosine), math.atan2(cosine, sine)))
    if model.one_sided or alike:
        sides[1] = sides[0]
    weaker = min(sides, key=lambda side: side.lean)
    return model._replace(restoring=sides[0], mirrored=sides[1], lean=weaker.lean, amplitude=weaker.amplitude)


def trilinear(model: RockingModel, rng: np.random.Generator, stiff: bool) -> RockingModel:
    """The wall under a trilinear law: of the literature or any other; stiff : D1 from 0.002 to 0.03."""
    ends = [(0.06, 0.28), (0.02, 0.28), tuple(sorted(rng.uniform(0.005, 0.6, 2)))][rng.integers(3)]
    if stiff:
        ends = 10.0 ** rng.uniform(math.log10(0.002), math.log10(0.03)), rng.uniform(0.1, 0.6)
    end = model.collapse_rotation
    return model._replace(elastic_end=ends[0] * end, plateau_end=ends[1] * end)


def tied(model: RockingModel, dt: float, rng: np.random.Generator, stiff: bool) -> RockingModel:
    """The wall of the rigid law with one to three bars: slack, prestressed, some brittle.

    stiff : a time step is 0.3 to 5 times the inverse of the frequency of the wall on its bar, else 0.003 to 0.3
    """
    bars = []
    for _ in range(rng.integers(1, 4)):
        moment = math.sin(model.slenderness) * 10.0 ** rng.uniform(-1.3, 0.5)
        growth = 10.0 ** (rng.uniform(math.log10(0.3), math.log10(5.0)) - (0.0 if stiff else 2.0 * rng.uniform()))
        at_yield = min(moment * model.p2 * (dt / growth) ** 2, 0.3 * math.sin(model.slenderness))
        kind = rng.uniform()
        slack = at_yield * (rng.uniform(0.0, 2.0) if kind < 0.3 else -rng.uniform(0.0, 0.95) if kind > 0.7 else 0.0)
        stands = at_yield * 10.0 ** rng.uniform(0.0, 3.0)
        bars.append(TieBar(1.0, moment, at_yield, slack, stands).scaled(1.0))
    return model._replace(bars=tuple(bars))


@functools.cache
def motions() -> list[np.ndarray]:
    paths = sorted((ROOT / "tests" / "motions").glob("*.txt"))
    return [np.loadtxt(path, skiprows=2)[:, 1] for path in paths]


def case_of(seed: int) -> Case:
    """The case of this number; its kind is that of `seed % len(KINDS)`."""
    rng, kind = np.random.default_rng(seed), seed % len(KINDS)
    model, dt, ground = drawn(rng, motions())
    model = model._replace(elastic_end=0.0, plateau_end=0.0)
    if kind in (LOADED, LOADED_TRILINEAR) or (kind in (TIES, STIFF_TIES) and rng.uniform() < 0.4):
        model = loaded(model, rng, kind == LOADED_TRILINEAR)
    if kind in (TRILINEAR, LOADED_TRILINEAR, STIFF) or (kind == SMALL and rng.uniform() < 0.7):
        model = trilinear(model, rng, kind == STIFF)
    if kind == STIFF:  # a time step is 0.3 to 5 times the inverse of the frequency of the elastic branch
        slope = math.sin(model.slenderness - model.plateau_end) / model.elastic_end
        dt = 10.0 ** rng.uniform(math.log10(0.3), math.log10(5.0)) / math.sqrt(model.p2 * slope)
    if kind in (TIES, STIFF_TIES):
        model = tied(model, dt, rng, kind == STIFF_TIES)
    ground = ground * (model.threshold / float(np.abs(ground).max())) * 10.0 ** rng.uniform(0.0, 1.2)
    first = int(np.argmax(np.abs(ground) >= model.threshold * (1.0 - 1e-9)))
    if kind == SMALL and model.plateau_end > 0.0:
        ground = ground * 10.0 ** np.minimum(0.0, (np.arange(ground.size) - first) / rng.uniform(5.0, 100.0))
        first = max(0, first - 100)
    elif kind == SMALL:  # it is lifted by a hair before the strong motion, over and over
        ground[:first] = 0.0
        head = model.threshold * (1.0 + 10.0 ** rng.uniform(-9.0, -2.0, 50)) * rng.choice([1.0, -1.0], 50)
        ground = np.concatenate([head, ground])
        first = 0 if first > 90 else max(0, first - 10)
    return Case(model, dt, np.ascontiguousarray(ground[max(0, first - 2) :][:SAMPLES]))


def distance(model: RockingModel, one: np.ndarray, other: np.ndarray) -> float:
    """Largest difference of two histories over theta_c while neither is beyond it."""
    both = min(one.size, other.size)
    first, second = one[:both], other[:both]
    inside = (np.abs(first) < model.collapse_rotation) & (np.abs(second) < model.collapse_rotation)
    return float(np.abs(first - second)[inside].max(initial=0.0)) / model.collapse_rotation


def effect_of_noise(case: Case, once: np.ndarray, draws: int, key: list[int]) -> float:
    """Largest effect over theta_c of so many draws of NOISE on the samples on a history, `once` without it.

    key : of the generator
    """
    rng, largest = np.random.default_rng(key), 0.0
    for _ in range(draws):
        moved = case.ground * (1.0 + NOISE * rng.uniform(-1.0, 1.0, case.ground.size))
        largest = max(
            largest, distance(case.model, once, integrate_history(moved, case.dt, 1.0, case.model, AUTO).rotation)
        )
    return largest


def errors(seed: int) -> Found:
    """Error and effect of noise of a random case."""
    return errors_of(case_of(seed), seed)


def errors_of(case: Case, seed: int) -> Found:
    """Error and effect of noise of a case. seed : of the noise"""
    once = integrate_history(case.ground, case.dt, 1.0, case.model, AUTO).rotation
    exact = double_double_walls.history(case.ground, case.dt, case.model)
    peak = float(np.minimum(np.abs(exact.rotation), case.model.collapse_rotation).max()) / case.model.collapse_rotation
    noise = effect_of_noise(case, once, NOISES, [seed, 1])
    return Found(distance(case.model, once, exact.rotation), noise, peak, exact.impacts)


def landings(case: Case, scale: float) -> int:
    return integrate_history(case.ground, case.dt, scale, case.model, AUTO).impact_time.size


def tangent_cases(seed: int) -> list[Case]:
    """The case with its ground as strong as two neighbouring doubles of which one has another count of impacts; empty
    where no ground up to a tenth stronger has, and of walls with ties."""
    case, rng = case_of(seed), np.random.default_rng([seed, 3])
    low, high = 1.0, 1.0 + 10.0 ** rng.uniform(-3.0, -1.0)
    few = landings(case, low)
    if case.model.bars or landings(case, high) == few:
        return []
    while low < (middle := 0.5 * (low + high)) < high:
        if landings(case, middle) == few:
            low = middle
        else:
            high = middle
    return [case._replace(ground=case.ground * scale) for scale in (low, high)]


def errors_of_tangent(seed: int) -> list[Found]:
    """`errors` of these cases."""
    return [errors_of(case, seed) for case in tangent_cases(seed)]


def print_tangent(cases: int) -> None:
    """Print how many landings that were built tangent are beyond the promise, and by how much."""
    with ProcessPoolExecutor(2) as pool:
        made = list(pool.map(errors_of_tangent, range(cases), chunksize=16))
    seeds = [seed for seed, rows in enumerate(made) for _ in rows]
    found = np.array([row for rows in made for row in rows]).reshape(-1, len(Found._fields))
    assert found.size, "no landing changes: more cases"
    counts = ", ".join(f"{times:g} times {int(beyond(found, times).sum())}" for times in (0.0, *TIMES))
    print(f"{len(found)} cases a last digit from a tangent landing; above {PROMISED:g} theta_c and noise of {NOISE:g}:")
    print(counts)
    for k in np.nonzero(beyond(found, TIMES_NOISE))[0]:
        error, noise = found[k, :2]
        print(f"case {seeds[k]}, {KINDS[seeds[k] % len(KINDS)]}: error {error:.1e}, noise {noise:.1e} theta_c")


def of_many_draws(seed: int) -> float:
    """Effect of noise on a case, over theta_c, by MANY draws."""
    case = case_of(seed)
    once = integrate_history(case.ground, case.dt, 1.0, case.model, AUTO).rotation
    return effect_of_noise(case, once, MANY, [seed, 2])


def found_of(cases: int) -> np.ndarray:
    """A row of Found for each of the first so many cases."""
    with ProcessPoolExecutor(2) as pool:
        return np.array(list(pool.map(errors, range(cases), chunksize=32)))


def beyond(found: np.ndarray, times: float) -> np.ndarray:
    """Whether the error of each case is above the larger of PROMISED and so many times the effect of noise."""
    return found[:, 0] > np.maximum(PROMISED, times * found[:, 1])


def explain(seeds: list[int], found: np.ndarray) -> None:
    """Print what the error of each of these cases is, and how many are of each class.

    few draws : MANY draws of noise explain it; tolerance : kernels of TIGHTER make no such error, with as many impacts
    as the exact motion; unexplained : a branch of the motion taken the other way, or a fault
    """
    with tempfile.TemporaryDirectory() as cache:
        tighter = tolerance_sweep.errors_with(TIGHTER, seeds, cache)
    classes, left, others = Counter(), 0.0, 0
    for seed, (error, few, _, impacts), (exacter, *_) in zip(seeds, found[seeds], tighter, strict=True):
        case, noise, name = case_of(seed), of_many_draws(seed), KINDS[seed % len(KINDS)]
        alike = integrate_history(case.ground, case.dt, 1.0, case.model, AUTO).impact_time.size == impacts
        bound = max(PROMISED, EXPLAINED * noise)
        reason = "few draws" if error <= bound else "tolerance" if exacter <= bound and alike else "unexplained"
        classes[reason, name] += 1
        left, others = max(left, exacter / max(noise, 1e-17)), others + (not alike)
        print(
            f"case {seed}, {name}: error {error:.1e}, noise {few:.1e}, of {MANY} draws {noise:.1e}, "
            f"error by the tolerances {TIGHTER[0]:g}/{TIGHTER[1]:g} {exacter:.1e} theta_c: {reason}"
        )
    print(f"by these tolerances at most {left:.2g} times the noise of {MANY} draws; other impacts: {others} cases")
    for (reason, name), count in sorted(classes.items()):
        print(f"{reason:12} {name:26} {count}")


def main(options: Command) -> None:
    """Print the table."""
    cases = options.number(options.cases, 2 * len(KINDS))
    if options.tangent:
        print_tangent(cases)
        return
    found = found_of(cases)
    error, noise, peak, impacts = found.T
    kinds = np.arange(cases) % len(KINDS)
    assert (peak > 0.0).mean() > 0.5 and impacts.max() > 10.0, "walls that do not move"
    print(f"error above {PROMISED:g} theta_c, and above so many times the effect of noise of {NOISE:g} as well")
    print(f"{'':26} {'cases':>6} {'> 1e-9':>7}" + "".join(f" {f'{times:g} x':>6}" for times in TIMES) + "    worst")
    for kind, name in [*enumerate(KINDS), (None, "all")]:
        here = found if kind is None else found[kinds == kind]
        counts = "".join(f" {int(beyond(here, times).sum()):6}" for times in TIMES)
        print(f"{name:26} {len(here):6} {int(beyond(here, 0.0).sum()):7}{counts}  {here[:, 0].max(initial=0.0):7.1e}")
    over = error / np.maximum(noise, 1e-17)
    print(f"error over noise: median {np.median(over):.2g}, 99 % {np.quantile(over, 0.99):.2g}")
    quiet = noise < 1e-11
    print(f"noise below 1e-11: {int(quiet.sum())} cases, worst error {error[quiet].max(initial=0.0):.1e} theta_c")
    if options.explain:
        worst = int(np.argmax(error / np.maximum(noise, PROMISED / EXPLAINED)))
        explain(sorted({worst, *np.nonzero(beyond(found, EXPLAINED))[0].tolist()}), found)
        return
    for seed in np.nonzero(beyond(found, 100.0))[0]:
        print(
            f"case {seed}, {KINDS[kinds[seed]]}: error {error[seed]:.1e}, noise {noise[seed]:.1e}, "
            f"of {MANY} draws {of_many_draws(int(seed)):.1e} theta_c"
        )
