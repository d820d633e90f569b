"""How natural records scatter about the mean of their set, and what zeta generated sets give beside theirs:
`.venv/bin/python -m tests.validation.scatter_of_records FOLDER [--walls N] [--counts]`.

The events of a folder of records are parted in two halves, by lot. The spread of `core.ground.scattered` is that of
sets of a half, the mean over PARTINGS, for one parting alone hangs on where two or three events fall; zeta of walls
under sets of the other halves is compared with that of generated sets.
"""

import argparse
import random
import shutil
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.case.rules import parse_case
from core.case.select import Select
from core.errors import InputError
from core.ground.record_folder import Candidate, Limits, drop_duplicate_records, files_in, read_file
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.setting.demand_input import read_demand
from core.setting.plan import make_plan, read_inputs
from core.setting.record_input import read_records
from core.setting.record_selection import select_records
from core.variation.evaluate import evaluate

BAND = 0.15, 2.0
PERIODS = np.geomspace(*BAND, 80)
SITES = [(ag, soil) for soil in "ABC" for ag in (0.15, 0.20, 0.25, 0.30)]
"""a_g [g] and soil of the targets, with F_0 2.45 and T_C* 0.33 s."""

SEEDS = 1, 101, 201
FOUR = (6.0, 0.60, 0.20, "B"), (9.0, 0.70, 0.25, "B"), (4.0, 0.40, 0.20, "C"), (8.0, 0.90, 0.30, "B")
"""Height and thickness [m], a_g [g] and soil of four walls."""

COUNTS, COUNT_SEEDS = (7, 14, 28), range(1, 801, 100)

PARTINGS = range(12)
"""Seeds of the lots."""


def demand_table(ag: float, soil: str) -> dict:
    """[demand] of a target."""
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": soil, "topography": "T1"}
    return {"ag_g": ag, "limit_state": "SLV", "spectrum": spectrum}


def usable(folder: Path) -> list[Candidate]:
    """The records of a folder that a selection takes, each motion once."""
    read = (one for path in files_in(folder) for one in read_file(path, PERIODS, Limits()))
    return drop_duplicate_records([one for one in read if isinstance(one, Candidate)])[0]


def halves(found: list[Candidate], seed: int, into: Path) -> tuple[Path, Path]:
    """Records in two folders, each event in one of them by the lot of a seed."""
    events = sorted({one.event for one in found})
    random.Random(seed).shuffle(events)
    parts = into / f"first_{seed}", into / f"second_{seed}"
    for part in parts:
        part.mkdir()
    for one in found:
        part = parts[events.index(one.event) % 2]
        if not (part / one.file.name).exists():
            shutil.copy(one.file, part / one.file.name)
    return parts


def natural_sets(folder: Path, ag: float, soil: str, most: int) -> list[list]:
    """The records of the sets of seven nearest to a target, each read with its factor."""
    case = parse_case({"wall": [wall_table(3.0, 0.3, "two_sided")], "demand": demand_table(ag, soil)})
    asked = Select(folder=str(folder), count=7, scale_limits=(0.25, 4.0), per_event=3)
    try:
        found = select_records(asked, Path("/"), read_demand(case, Path()), 2.0)
    except InputError:
        return []
    return [read_records(replace(case, record=one.records), Path("/"))[0] for one in found.sets[:most] if one.fits]


def wall_table(height: float, thickness: float, mechanism: str) -> dict:
    """[[wall]] of a wall on the ground."""
    table = {"name": "w", "height_m": height, "thickness_m": thickness, "mechanism": mechanism, "base_z_m": 0.0}
    return table | {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "cross_walls"}], "unloaded_confirmed": True}


def spread_of(folder: Path) -> list[float]:
    """Standard deviation over the band of ln S_a over the mean of the set, of each set of each target."""
    found = []
    for ag, soil in SITES:
        for motions in natural_sets(folder, ag, soil, 3):
            spectra = [
                pseudo_acceleration_spectrum(motion.acceleration, motion.time_step, PERIODS) for motion in motions
            ]
            ratio = np.log(np.array(spectra) / np.mean(spectra, axis=0))
            found.append(float(np.sqrt(ratio.var(axis=0, ddof=1).mean())))
    return found


def zeta_of(table: dict, generate: dict | None, motions: list | None) -> float | None:
    """zeta of a wall by histories, under a generated set or under records."""
    case = parse_case(table | ({"generate": generate} if generate else {}))
    demand, made, kinds = read_inputs(case, Path())
    inputs = (demand, made, kinds) if motions is None else (demand, motions, ["natural"] * len(motions))
    found = evaluate(make_plan(case, inputs).scene(0, demand), other=False)
    return found.dynamic.zeta if found.dynamic else None


def compared(folders: list[Path], count: int) -> list[tuple[dict, float, list[float], float]]:
    """(wall, zeta under natural records, under scattered sets, under one matched to the target) of random walls."""
    draw, known, found = random.Random(5), {}, []
    while len(found) < count:
        folder, site = draw.choice(folders), draw.choice(SITES)
        if (folder, site) not in known:
            known[folder, site] = natural_sets(folder, *site, 1)
        if not known[folder, site]:
            continue
        height, mechanism = round(draw.uniform(2.5, 10.0), 1), ("one_sided", "two_sided")[len(found) % 2]
        slender = draw.uniform(8.0, 14.0) if mechanism == "one_sided" else draw.uniform(3.0, 8.0)
        table = {"wall": [wall_table(height, round(height / slender, 2), mechanism)], "demand": demand_table(*site)}
        natural = zeta_of(table, None, known[folder, site][0])
        scattered = [zeta_of(table, {"seed": seed}, None) for seed in SEEDS]
        matched = zeta_of(table, {"scatter": 0.0, "count": 7}, None)
        if natural is None or matched is None or None in scattered:
            continue
        found.append((table["wall"][0], natural, scattered, matched))
        print(site, mechanism, height, table["wall"][0]["thickness_m"], natural, scattered, matched, flush=True)
    return found


def of_counts() -> None:
    """Print zeta of four one-sided walls under scattered sets of each count, one a seed."""
    for height, thickness, ag, soil in FOUR:
        table = {"wall": [wall_table(height, thickness, "one_sided")], "demand": demand_table(ag, soil)}
        for count in COUNTS:
            zetas = [zeta_of(table, {"seed": seed, "count": count}, None) or np.nan for seed in COUNT_SEEDS]
            said = f"mean {np.mean(zetas):.2f}, {np.min(zetas):.2f} to {np.max(zetas):.2f}"
            print(f"{height} x {thickness} m, {ag} g, {soil}: {count} motions: {said}", flush=True)


def main() -> None:
    """Print the spread of the first half, and of walls the quantiles of zeta over that under the second."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--walls", type=int, default=0)
    parser.add_argument("--counts", action="store_true")
    asked = parser.parse_args()
    if asked.counts:
        of_counts()
        return
    with tempfile.TemporaryDirectory() as place:
        parted = [halves(usable(asked.folder), seed, Path(place)) for seed in PARTINGS]
        means = []
        for seed, (first, _) in zip(PARTINGS, parted, strict=True):
            if spreads := spread_of(first):
                means.append(np.mean(spreads))
                print(f"parting {seed}: {len(spreads)} sets, spread {means[-1]:.3f}", flush=True)
        print(f"spread of a half {np.mean(means):.3f}, {np.min(means):.3f} to {np.max(means):.3f}")
        if asked.walls:
            rows = compared([second for _, second in parted], asked.walls)
            levels = (0.05, 0.25, 0.5, 0.75, 0.95)
            print("quantiles", levels)
            for name, values in (
                ("natural over scattered", [natural / zeta for _, natural, made, _ in rows for zeta in made]),
                ("natural over matched", [natural / matched for _, natural, _, matched in rows]),
            ):
                print(name, np.round(np.quantile(values, levels), 3))


if __name__ == "__main__":
    main()
