"""Answers of resources/benchmark to 40 digits, by the multi-precision solver, which shares no code with the program.

    .venv/bin/python -m tests.validation.benchmark_answers [SCENE ...]

Each number is computed twice, by series of other orders in arithmetic of other precision. Its interval is ten times the
difference, and at least what printing leaves. A critical multiplier is the root of the energy at the end of the ground
over the energy to overturn. The order in a set is that of the double-double solver; the histories its answers are taken
from are computed anew. Writes scenes.json; takes about ten minutes.
"""

import hashlib
import importlib.util
import json
import sys
from pathlib import Path

import mpmath as mp
import numpy as np

from core.wall.rocking_model import RockingModel
from tests.validation import double_double_walls, high_precision

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "benchmark"
PRINTED = 42
"""Digits of an answer in the file."""

PRECISIONS = ((60, 36), (75, 45))
"""(digits, order of the series) of both computations."""

SETTLED = 0.9
"""Of alpha, the largest rotation at the end of a motion of a set whose wall counts as standing."""


def benchmark(name: str):
    """A module of the folder of the benchmark, which is no package."""
    spec = importlib.util.spec_from_file_location(name, FOLDER / f"{name}.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def motion(scene: dict, ground, order: int, scale=1) -> high_precision.Motion:
    """The history of a scene in the digits mpmath works with, its doubles exact; up to beyond 90 degrees."""
    block = scene["block"]
    return high_precision.motion(
        [scale * mp.mpf(sample) for sample in ground],
        scene["ground"]["dt"],
        block["slenderness"],
        block["p2"],
        block["one_sided"],
        lambda speed: mp.mpf(block["velocity_ratio"]),
        block["kinks"],
        gravity=9.80665,
        start=scene["start"],
        order=order,
        last=mp.pi / 2,
    )


def to_overturn(block: dict, phi):
    """Energy over I0 that a wall at this rotation, seen from its pivot, needs to reach the upright position [1/s2]."""
    alpha, p2 = mp.mpf(block["slenderness"]), mp.mpf(block["p2"])
    if not block["kinks"]:
        return p2 * (1 - mp.cos(alpha - phi))
    first, last = (mp.mpf(kink) for kink in block["kinks"])
    flat = max(last - max(phi, first), 0) + max(first**2 - phi**2, 0) / (2 * first)
    return p2 * (1 - mp.cos(alpha - max(phi, last)) + flat * mp.sin(alpha - last))


def margin(block: dict, end: high_precision.Motion):
    """Positive where the wall overturns on still ground, from the state at the end of a history [1/s2]."""
    needed = to_overturn(block, end.phi)
    over = end.speed**2 / 2 - needed
    beyond = end.phi > block["slenderness"]
    if end.speed >= 0:
        return abs(over) if beyond else over
    whole = to_overturn(block, mp.mpf(0))
    after_impact = mp.mpf(block["velocity_ratio"]) ** 2 * (over + whole) - whole
    return max(-over, after_impact) if beyond else after_impact


def critical(scene: dict, ground, order: int, low, high):
    """The multiplier between two at which the outcome changes: by bisection in few digits, then by secants."""

    def at(scale, order=order):
        return margin(scene["block"], motion(scene, ground, order, scale))

    with mp.workdps(20):
        falls = at(low, 14) > 0
        assert (at(high, 14) > 0) != falls
        while high - low > 1e-8 * low:
            middle = (low + high) / 2
            low, high = (middle, high) if (at(middle, 14) > 0) == falls else (low, middle)
    last, new = mp.mpf(low), mp.mpf(high)
    before, value = at(last), at(new)
    while abs(new - last) > mp.mpf(10) ** -(PRINTED + 3):
        last, before, new = new, value, new - value * (new - last) / (value - before)
        value = at(new)
    assert low <= new <= high
    return new


def single(scene: dict, ground, order: int) -> dict:
    """The answers of a scene of one history, numbers of mpmath."""
    ask = scene["ask"]
    if "critical" in ask:
        return {"critical": [critical(scene, ground, order, *ends) for ends in ask["critical"]]}
    found = motion(scene, ground, order)
    answer = {}
    if "rotation" in ask:
        answer["rotation"] = [found.rotations[k] for k in ask["rotation"]]
    if "impact_times" in ask:
        answer["impact_times"] = [time for time, _, _ in found.impacts[: ask["impact_times"]]]
    if "impacts" in ask:
        answer["impacts"] = len(found.impacts)
    if "peak" in ask:
        answer["peak"] = max(abs(phi) for phi in found.rotations)
    if "overturns" in ask:
        answer["overturns"] = bool(found.phi > mp.pi / 2 or margin(scene["block"], found) > 0)
    return answer


def ranked(scene: dict, grounds) -> tuple[int, list[int]]:
    """(count of motions of a set that overturn the wall, motions of the peaks asked for), by the double-double
    solver."""
    block, dt = scene["block"], scene["ground"]["dt"]
    kinks = block["kinks"] or (0.0, 0.0)
    alpha = block["slenderness"]
    model = RockingModel(alpha, block["p2"], float(block["one_sided"]), block["velocity_ratio"], 0.0, *kinks)
    peaks = []
    for ground in grounds:
        rotation = double_double_walls.history(np.array(ground), dt, model).rotation
        overturns = abs(rotation[-1]) > 0.5 * np.pi
        assert overturns or abs(rotation[-1]) < SETTLED * alpha
        peaks.append(np.inf if overturns else float(np.abs(rotation).max()))
    order = sorted(range(len(peaks)), key=peaks.__getitem__)
    for rank in scene["ask"]["peaks"]:
        assert all(abs(peaks[order[rank - 1]] - peaks[order[k]]) > 1e-12 for k in (rank - 2, rank))
    return sum(np.isinf(peaks)).item(), [order[rank - 1] for rank in scene["ask"]["peaks"]]


def computed(scene: dict, digits: int, order: int, samples) -> dict:
    """The answers of a scene by one precision."""
    with mp.workdps(digits):
        if "seeds" not in scene["ask"]:
            return single(scene, samples(scene["ground"]), order)
        grounds = [samples(scene["ground"], seed) for seed in range(1, scene["ask"]["seeds"] + 1)]
        overturned, chosen = ranked(scene, grounds)
        rotations = [motion(scene, grounds[k], order).rotations for k in chosen]
        return {"overturned": overturned, "peaks": [max(abs(phi) for phi in rotation) for rotation in rotations]}


def numbers(answer: dict) -> list:
    """All that is no count, and no yes or no."""
    values = [value for value in answer.values() if not isinstance(value, int)]
    return [number for value in values for number in (value if isinstance(value, list) else [value])]


def digest(ground: list[float]) -> str:
    """SHA-256 of samples as whole micrometres per second squared, one a line."""
    return hashlib.sha256("".join(f"{round(1e6 * sample)}\n" for sample in ground).encode()).hexdigest()


def answered(scene: dict, samples) -> dict:
    """The scene with its answer and interval."""
    rough, fine = (computed(scene, *precision, samples) for precision in PRECISIONS)
    assert [value for value in rough.values() if isinstance(value, int)] == [
        value for value in fine.values() if isinstance(value, int)
    ]
    with mp.workdps(PRECISIONS[1][0]):
        pairs = zip(numbers(rough), numbers(fine), strict=True)
        error = max(10 * abs(one - other) + abs(other) * mp.mpf(10) ** -PRINTED for one, other in pairs)
        interval = f"1e{int(mp.ceil(mp.log10(error)))}" if error else "0"

        def printed(value):
            if isinstance(value, list):
                return [printed(one) for one in value]
            return value if isinstance(value, int) else mp.nstr(value, PRINTED)

        written = {"sha256": digest(samples(scene["ground"]))}
        return scene | written | {"answer": {key: printed(value) for key, value in fine.items()}, "interval": interval}


def text_of(scenes: list[dict]) -> str:
    """The file: a key of a scene a line."""
    blocks = (",\n".join(f"  {json.dumps(key)}: {json.dumps(scene[key])}" for key in scene) for scene in scenes)
    return "[\n" + ",\n".join(f" {{\n{block}\n }}" for block in blocks) + "\n]\n"


def main(names: list[str]) -> None:
    runner = benchmark("run_benchmark")
    scenes = json.loads(runner.SCENES.read_text())
    for k, scene in enumerate(scenes):
        if not names or scene["name"] in names:
            scenes[k] = answered(scene, runner.samples)
            print(f"{scene['name']:24} {scenes[k]['interval']}", flush=True)
            runner.SCENES.write_text(text_of(scenes))


if __name__ == "__main__":
    main(sys.argv[1:])
