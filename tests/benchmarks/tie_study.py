"""What q = 2 is worth for a tie: walls held by the bar of the linear check with q, under twice the motion that
overturns them without it.

    python3 run.py bench --ties [LIST.toml]

One-sided walls of tie_study.toml, each with one tie. The linear check (C8.7.1.2.1.7, FC 1) with q gives the force of
the tie; a second table has the least force that keeps the wall within 0.40 theta_c, the largest rotation at SLV.
Motions of both signs: the natural records of LIST.toml ([[record]] tables), without it seven generated ones of one
spectrum.
"""

import math
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.capacity.limit_states import LIMIT_FRACTION
from core.case.study_file import Study
from core.codes.spectrum_codes import en1998
from core.ground.artificial import compatible_motion
from core.ground.ground_motion import GroundMotion
from core.lab.research.parametric import natural_motions
from core.rocking.history import integrate_history
from core.rocking.methods import METHODS
from core.rocking.outcome import COLLAPSED, IMPACT_LIMIT
from core.units import G
from core.wall.bars import TieBar
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model
from core.wall.ties import STEEL_MODULUS
from tests.benchmarks.inputs import Command
from tests.benchmarks.zeta_spread import LONGEST

DATA = Path(__file__).with_name("tie_study.toml")

UNIT_WEIGHT = 18e3
"""[N/m3]"""

TIE_HEIGHT = 0.92
"""Of the tie, share of the height of the wall [-]."""

BEYOND = 2.0
"""Multiplier of the motion over the one at which the wall without its tie first overturns [-]."""

LEAST_PGA = 0.05 * G
"""Of the natural records taken [m/s2]."""

FORCES = np.geomspace(0.05, 1.2, 60)
"""Tried for the least force, over that of the linear check with q = 1 [-]."""

GENERATED = 7


@dataclass(frozen=True)
class TiedWall:
    """A one-sided wall of a metre of length, and its tie. height, thickness : [m]"""

    height: float
    thickness: float

    @property
    def block(self) -> Block:
        return Block.rectangle(self.height, math.atan2(self.thickness, self.height))

    @property
    def weight(self) -> float:
        """[N/m]"""
        return UNIT_WEIGHT * self.height * self.thickness

    @property
    def tie_height(self) -> float:
        """[m]"""
        return TIE_HEIGHT * self.height

    def model(self, bar: TieBar | None = None) -> RockingModel:
        block = self.block
        bars = () if bar is None else (bar.scaled(self.weight * block.radius),)
        return rocking_model(block, True, restitution(block, "one_sided_theoretical"), LAWS["rigid"], bars=bars)

    def force(self, alpha0: float) -> float:
        """Force of the tie that gives this multiplier [N/m]: (W t/2 + F h) / (W H/2) = alpha_0, C8.7.1.1; negative
        where the wall needs none."""
        return 0.5 * self.weight * (alpha0 * self.height - self.thickness) / self.tie_height


class Held(NamedTuple):
    """What a bar of this force does.

    force : over that of q = 1 [-]
    rotation : largest, over theta_c [-]; inf of a wall that overturns
    elongation : of the bar at the largest rotation [mm], h sin(theta); inf of a wall that overturns
    yielded, broken : whether the bar does
    known : False where the impacts of a sample exceeded their limit
    """

    force: float
    rotation: float
    elongation: float
    yielded: bool
    broken: bool
    known: bool


class Pair(NamedTuple):
    """A wall under a motion of one sign.

    q : at which the wall without its tie first overturns [-]
    bare_overturns : whether it also does at twice that motion
    held : by the bar of each length and each q
    least : least force for 0.40 theta_c over that of q = 1, for each length; inf where the largest tried is too small
    """

    q: float
    bare_overturns: bool
    held: list[list[Held]]
    least: list[float]


@dataclass(frozen=True)
class TieStudy:
    """What is tried.

    walls
    lengths : of the bars [m]
    strength : yield strength of their steel [Pa]
    elongation : that they stand, a share of their length [-]
    factors : q of the linear check [-]
    forces : tried for the least one, over that of q = 1, rising [-]
    """

    walls: tuple[TiedWall, ...]
    lengths: tuple[float, ...]
    strength: float
    elongation: float
    factors: tuple[float, ...]
    forces: np.ndarray

    @classmethod
    def read(cls, options: Command) -> "TieStudy":
        """Of tie_study.toml."""
        table = tomllib.loads(DATA.read_text(encoding="utf-8"))
        walls = tuple(TiedWall(wall["height_m"], wall["thickness_m"]) for wall in table["wall"])
        lengths, factors = options.few(tuple(table["lengths_m"])), options.few(tuple(table["q"]), 2)
        steel = 1e6 * table["fy_mpa"], table["elongation"]
        return cls(options.few(walls), lengths, *steel, factors, options.few(FORCES, 6, FORCES.size - 6))

    def bar(self, wall: TiedWall, force: float, length: float) -> TieBar | None:
        """The bar of this force [N/m] and length [m]; None where no force is needed."""
        if force <= 0.0:
            return None
        at_yield = self.strength * length / STEEL_MODULUS
        return TieBar(wall.tie_height, force, at_yield, 0.0, self.elongation * length)


def generated_motions(count: int) -> list[GroundMotion]:
    """Compatible with EN 1998-1 type 1, soil B."""
    target = en1998(0.25 * G, 1, "B")
    return [
        GroundMotion(f"{seed}", compatible_motion(target, seed), 0.01, format="generated")
        for seed in range(1, count + 1)
    ]


def listed_motions(path: Path) -> list[GroundMotion]:
    """The horizontal records of a list, each motion once, but for weak and very long ones."""
    motions = [entry.motion for entry in natural_motions(Study(), path.parent, path).motions]
    return [m for m in motions if m.pga > LEAST_PGA and m.acceleration.size <= LONGEST]


def pair_of(study: TieStudy, wall: TiedWall, motion: GroundMotion, sign: int) -> Pair | None:
    """What the bars do; None where the wall without its tie does not overturn."""
    ground, dt, taylor = motion.acceleration, motion.time_step, METHODS["taylor"]
    bare = wall.model()
    q = incremental_dynamic_analysis(ground, dt, motion.pga, sign, bare, taylor, Search()).q
    if q is None:
        return None
    scale = BEYOND * sign * multiplier_of(q, motion.pga, threshold_of(bare))
    alpha0 = abs(scale) * motion.pga / G
    force_1 = wall.force(alpha0)

    def held_by(force: float, length: float) -> Held:
        bar = study.bar(wall, force, length)
        found = integrate_history(ground, dt, scale, wall.model(bar), taylor)
        overturns = found.outcome == COLLAPSED
        rotation = math.inf if overturns else found.peak / bare.collapse_rotation
        elongation = math.inf if overturns else 1e3 * wall.tie_height * math.sin(found.peak)
        return Held(
            force / force_1,
            rotation,
            elongation,
            bool((found.residual > 0.0).any()),
            bar is not None and elongation > 1e3 * bar.breaks_at,
            found.outcome != IMPACT_LIMIT,
        )

    def least_force(length: float) -> float:
        """From the largest force down to the first that does not hold the wall."""
        least = math.inf
        for share in study.forces[::-1]:
            held = held_by(share * force_1, length)
            if not held.known or held.rotation > LIMIT_FRACTION["SLV"]:
                break
            least = float(share)
        return least

    return Pair(
        q,
        held_by(0.0, study.lengths[0]).rotation > 1.0,
        [[held_by(wall.force(alpha0 / factor), length) for factor in study.factors] for length in study.lengths],
        [least_force(length) for length in study.lengths],
    )


def row(*cells: str) -> str:
    """A row of a Markdown table."""
    return "| " + " | ".join(cells) + " |"


def held_table(study: TieStudy, pairs: list[Pair]) -> list[str]:
    """What the bars of the linear check do, a row for each length and q."""
    slv = LIMIT_FRACTION["SLV"]
    head = ("bar [m]", "q", "F/F1", "overturned", f"above {slv:.2f} θc", "bar broken", "peak/θc", "elongation [mm]")
    rows = [row(*head), row(*["---"] * len(head))]
    for i, length in enumerate(study.lengths):
        for j, factor in enumerate(study.factors):
            of_pairs = [pair.held[i][j] for pair in pairs if pair.held[i][j].known]
            force, rotation, elongation, _, broken, _ = np.array(of_pairs).T
            shares = (rotation > 1.0).mean(), (rotation > slv).mean(), broken.mean()
            peak, longest = np.median(rotation), np.median(elongation)
            rows.append(
                row(
                    f"{length:g}",
                    f"{factor:g}",
                    f"{np.median(force):.2f}",
                    *(f"{100.0 * share:.0f} %" for share in shares),
                    f"{peak:.2f}" if math.isfinite(peak) else "overturns",
                    f"{longest:.0f}" if math.isfinite(longest) else "–",
                )
            )
    return rows


def least_table(study: TieStudy, pairs: list[Pair]) -> list[str]:
    """The least force for 0.40 theta_c over that of q = 1, and the q with which the linear check gives that force."""
    most = study.forces[-1]
    head = ("bar [m]", "F/F1: median", "90 %", "largest", f"above {most:g}", "q: median", "10 %", "smallest")
    rows = [row(*head), row(*["---"] * len(head))]
    ratio = BEYOND * np.array([pair.q for pair in pairs])  # PGA over g tan(alpha)
    for i, length in enumerate(study.lengths):
        least = np.array([pair.least[i] for pair in pairs])
        missing = np.isinf(least)
        # of a pair without such a force its q is less than that of the largest force tried
        factor = ratio / (1.0 + (ratio - 1.0) * np.where(missing, most, least))
        bound = factor[missing].max(initial=0.0)
        shares = np.quantile(least, (0.5, 0.9, 1.0), method="higher")
        factors = np.quantile(factor, (0.5, 0.1, 0.0), method="lower")
        rows.append(
            row(
                f"{length:g}",
                *(f"{share:.2f}" if math.isfinite(share) else f"> {most:g}" for share in shares),
                f"{100.0 * missing.mean():.1f} %",
                *(f"{value:.2f}" if value > bound else f"< {value:.2f}" for value in factors),
            )
        )
    return rows


def print_pairs(study: TieStudy, pairs: list[Pair], planned: int) -> None:
    """How many pairs there are, what the walls do without their ties, and where the check asks for none."""
    q = np.array([pair.q for pair in pairs])
    bare = np.mean([pair.bare_overturns for pair in pairs])
    all_held = [held for pair in pairs for of_length in pair.held for held in of_length]
    needless = {factor: sum(pair.held[0][j].force <= 0.0 for pair in pairs) for j, factor in enumerate(study.factors)}
    print(
        f"{len(pairs)} pairs of wall, motion and sign; {planned - len(pairs)} left out, where the wall without its tie "
        f"does not overturn up to q = {Search().q_limit:g}."
    )
    print(
        f"It first does at q = {np.median(q):.2f} (median; {q.min():.2f} to {q.max():.2f}); under {BEYOND:g} times "
        f"that motion {100.0 * bare:.0f} % overturn."
    )
    print("Pairs in which the check asks for no force:", ", ".join(f"{n} (q = {f:g})" for f, n in needless.items()))
    print(f"Histories with too many impacts, left out: {sum(not held.known for held in all_held)} of {len(all_held)}")


def main(options: Command) -> None:
    """Print the tables. ties : the list of natural records, True without one"""
    study, listed = TieStudy.read(options), options.ties is not True
    motions = listed_motions(options.ties) if listed else generated_motions(options.number(GENERATED, 1))
    assert motions, "no motion"
    planned = [(wall, motion, sign) for wall in study.walls for motion in motions for sign in (1, -1)]
    print(f"{len(study.walls)} walls, {len(motions)} {'natural' if listed else 'generated'} motions")
    with ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda entry: pair_of(study, *entry), planned)
        pairs = [pair for pair in found if pair is not None]
    assert any(pair.bare_overturns for pair in pairs), "no wall overturns without its tie"
    assert any(held.yielded for pair in pairs for of_length in pair.held for held in of_length), "no bar yields"
    print_pairs(study, pairs, len(planned))
    print("\n".join(["", *held_table(study, pairs), "", *least_table(study, pairs)]))
