"""How zeta_E, zeta_16 and zeta_first of the dynamic check hang on the grid of their search, over 120 sets.

    python3 run.py bench --zeta

Where the rule fails is found on a grid 20 times finer; the search of the program then runs on every 20th point,
from seven starts, so that nothing but the step and its place differs. 60 sets of seven real records of the shelf
and 60 of seven generated motions; walls, mechanisms and laws drawn by chance.
"""

import math
import random
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from core.capacity.ida import ROBUST_SHARE, first_with_share
from core.case.rules import parse_case
from core.codes.dynamic_check import DemandRuns
from core.codes.multiplier_search import (
    FAILURE_WINDOW,
    HALF_FAIL,
    MAX_MULTIPLIER,
    MULTIPLIER_STEP,
    Precision,
    ZetaSearchResult,
    search_zeta,
)
from core.codes.spectrum_codes import en1998
from core.errors import InputError
from core.ground import records
from core.ground.artificial import compatible_motion
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.known import require_value
from core.rocking.methods import AUTO
from core.setting.check_input import make_rocking_model
from core.setting.demand_input import read_demand
from core.units import G
from tests.benchmarks.inputs import Command
from tests.conftest import shelf_folder

FINER = 20
STARTS = (0, 3, 6, 9, 12, 15, 18)
SETS = 60
LONGEST = 20000
"""Samples of a record above which it is left out here: some are minutes of ground at rest."""

STEPS = {1: "0.25 %", 2: "0.5 %", 4: "1 %"}
"""Multiples of the step of the program that are tried."""


def real_motions(options: Command) -> list[GroundMotion]:
    """Recorded accelerograms of the shelf that state their unit, but for scaled and matched ones."""
    shelf, found = shelf_folder(), {}
    if shelf is None:
        return []
    paths = [
        path
        for path in sorted(shelf.rglob("*"))
        if (path.parent.name in ("PEER_AT2", "SIGMA_ITACA_acc", "ESM_ASCII") or path.name.startswith("P695"))
        and "Matched" not in path.name
        and not path.name.startswith("Oak")
    ]
    for path in options.few(paths, 30):
        named = path.name.startswith("P695")
        try:
            motion = records.read(path, Options("g" if named else None, None, None, None))
        except InputError:
            continue
        if motion.acceleration.size <= LONGEST and motion.pga > 0.02 * G:
            found.setdefault(motion.samples_sha256, motion)
    return list(found.values())


def draw(k: int, shelf: list[GroundMotion]):
    """(model, motions, signs, demand) of set k."""
    chance = random.Random(k)
    height = chance.uniform(2.5, 12.0)
    mechanism = chance.choice(("two_sided", "one_sided"))
    wall: dict[str, object] = {
        "name": "w",
        "height_m": height,
        "thickness_m": height * chance.uniform(0.05, 0.2),
        "mechanism": mechanism,
        "base_z_m": 0.0,
        "law": chance.choice(("rigid", "rigid", "rigid", "doherty")),
    }
    real = shelf and k < SETS
    spectrum = {"code": "EN1998", "type": 1, "soil": chance.choice("ABCDE")}
    demand = {"ag_g": 0.25, "spectrum": spectrum, "demand_scaling": "pga" if real else "as_given"}
    case = parse_case({"wall": [wall], "demand": demand})
    if real:
        motions = chance.sample(shelf, 7)
    else:
        target = en1998(0.25 * G, 1, str(spectrum["soil"]))
        motions = [
            GroundMotion(f"{n}", compatible_motion(target, 7 * k + n), 0.01, format="generated") for n in range(7)
        ]
    signs = (1,) if mechanism == "two_sided" else (1, -1)
    return make_rocking_model(case.wall[0], mechanism), motions, signs, require_value(read_demand(case, Path()))


def spread(k: int, shelf) -> dict[int, list[tuple]]:
    """Of set k relative errors of zeta_E, zeta_16, zeta_first against the fine grid, whether the spread holds
    the zeta_E of that grid, and its width in ln; by multiple of the step."""
    model, motions, signs, demand = draw(k, shelf)
    work = DemandRuns(model, motions, signs, demand, "capacity", AUTO, lambda: False)
    fine = (1.0 + MULTIPLIER_STEP) ** (1.0 / FINER) - 1.0
    rough = search_zeta(work.failures, work.rest, 1.0)
    if rough.half is None or rough.half >= MAX_MULTIPLIER:
        return {}
    low = math.floor(math.log(0.85 * min(require_value(rough.first), require_value(rough.sixteen))) / math.log1p(fine))
    high = math.ceil(math.log(1.5 * rough.half) / math.log1p(fine))
    flags = np.concatenate(
        [work.failures((1.0 + fine) ** np.arange(start, min(start + 256, high)))[0] for start in range(low, high, 256)]
    )

    def looked_up(multipliers):
        place = np.rint(np.log(multipliers) / math.log1p(fine)).astype(int) - low
        fails = flags[np.clip(place, 0, flags.size - 1)] & (place >= 0)
        return fails | (place >= flags.size), np.zeros(fails.size, bool), np.ones(fails.size, bool)

    def searched(every: int, target: float) -> ZetaSearchResult:
        return search_zeta(looked_up, work.rest, target, Precision(every))

    half = round(FAILURE_WINDOW / math.log1p(fine))
    places = (
        first_with_share(flags, half, HALF_FAIL),
        first_with_share(flags, half, ROBUST_SHARE),
        int(np.argmax(flags)),
    )
    truth = np.array([(1.0 + fine) ** (low + require_value(place)) for place in places])
    found = {}
    for factor in STEPS:
        step = (1.0 + MULTIPLIER_STEP) ** factor - 1.0
        tries = [searched(factor, (1.0 + fine) ** (factor * start)) for start in STARTS]
        found[factor] = [
            (
                *(np.array([one.half, one.sixteen, one.first]) / truth - 1.0),
                require_value(one.spread)[0] * (1.0 - step) <= truth[0] <= require_value(one.spread)[1] * (1.0 + step),
                math.log(require_value(one.spread)[1] / require_value(one.spread)[0]),
            )
            for one in tries
        ]
    return found


def main(options: Command) -> None:
    """Print the table."""
    shelf = real_motions(options)
    print(f"{len(shelf)} real records" if shelf else "no shelf: generated sets only")
    with ThreadPoolExecutor(2) as pool:
        sets = pool.map(lambda k: spread(k, shelf), options.few(range(2 * SETS)))
        found = [part for part in sets if part]
    assert found, "no set with a zeta"
    print(f"{len(found)} sets, {len(STARTS)} starts each; |error| against a grid {FINER} times finer")
    print(f"{'step':8} {'':10} {'median':>8} {'90 %':>8} {'worst':>8} {'mean':>8}")
    for factor, label in STEPS.items():
        rows = np.array([row for part in found for row in part[factor]])
        for column, name in enumerate(("zeta_E", "zeta_16", "zeta_first")):
            size = np.abs(rows[:, column])
            numbers = (np.median(size), np.quantile(size, 0.9), size.max(), rows[:, column].mean())
            print(f"{label:8} {name:10} " + " ".join(f"{100 * x:7.2f}%" for x in numbers), flush=True)
        width = rows[:, 4]
        print(
            f"{label:8} spread     holds it {rows[:, 3].mean():.1%}, width {np.median(width):.1%} (median), "
            f"{np.quantile(width, 0.9):.1%} (90 %), {width.max():.1%}"
        )
