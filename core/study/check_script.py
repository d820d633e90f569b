"""A wall as a script that checks it without this program: by a second engine, numpy and scipy, and by hand."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from core.capacity.ida import multiplier_of, threshold_of
from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.demand import SeismicDemand, complete_with_records
from core.codes.dynamic_check import model_and_scale_at_demand
from core.codes.kinematic import PERIOD_FACTOR, STATE_DAMPING
from core.codes.kinematic_chain import sum_chain
from core.codes.target_spectrum import CodeSpectrum
from core.ground.ground_motion import GroundMotion
from core.rocking.history import integrate_history
from core.rocking.methods import AUTO
from core.rocking.outcome import COLLAPSED, STABLE
from core.setting.plan import Plan, PlannedWall
from core.units import G
from core.version import line
from core.wall.masonry import load_to_force
from core.wall.rocking_model import RockingModel, seen_from

TEMPLATE = Path(__file__).resolve().parents[2] / "resources" / "templates" / "check_wall.py"

SAMPLE_NOISE, NOISE_DRAWS = 1e-12, 8
"""Noise on the samples, of each, and how often it is drawn, for the tolerance of a rotation."""

MIN_TOLERANCE, TIMES_NOISE, MAX_TOLERANCE = 1e-9, 30.0, 1e-4
"""The tolerance over theta_c is the larger of the first and so many times the effect of the noise: of 110 random walls
of every kind none differed by more (resources/docs/validation.md). Beyond the last the next history is taken."""

BY_HAND = 1e-9
"""Tolerance of what is worked by hand, of each number."""

Q_THAT_MOVES = 1.5
"""q at which a motion is taken that does not move the wall at the demand."""


class ScriptUnavailable(Exception):
    """Why a wall has no script: held_at_top, between_walls, no_records or too_sensitive."""


class Answer(NamedTuple):
    """rotation : the largest one [rad], of a wall that overturns that at the sample `last`."""

    overturns: bool
    last: int
    rotation: float


@dataclass(frozen=True)
class ScriptHistory:
    """One history.

    scale : multiplier of the motion, its sign that of the record
    chosen : why this one, in words of the script
    tolerance : of the rotation [rad]
    """

    motion: GroundMotion
    scale: float
    model: RockingModel
    chosen: str
    answer: Answer
    tolerance: float


def check_script(plan: Plan, k: int) -> str:
    """The script that checks the k-th entry of a plan. Raises NoCheck."""
    entry = plan.entries[k]
    if entry.part.wall.bends:
        raise ScriptUnavailable("held_at_top" if entry.part.wall.arch is None else "between_walls")
    demand = complete_with_records(plan.demand, plan.motions) if plan.demand else None
    one = _chosen(plan, k, demand)
    lines = {**_of(entry, one), **_model_lines(one), **_wall_lines(entry)}
    expected = {"rotation": (one.answer.rotation, one.tolerance)}
    if demand is not None:
        lines |= _demand_lines(entry, demand)
        if demand.confidence_on == "capacity":
            lines["FC_OF_MODEL"] = demand.confidence_factor
    for name, value in _by_hand(entry, demand, one.model).items():
        expected[name] = value, BY_HAND * abs(value)
    return _filled({**lines, "EXPECTED": expected}, one.motion.acceleration)


def _runs(plan: Plan, k: int, demand: SeismicDemand | None) -> Iterator[tuple[GroundMotion, float, RockingModel]]:
    """(motion, multiplier, model) of every history at the demand, or of the records as they are without one; of an
    element free to vibrate with each of its elastic branches."""
    entry = plan.entries[k]
    models = [entry.model]
    if demand is not None:
        scene = plan.scene(k, demand)
        models = [branch.of(entry.model) for branch in scene.branches] or models
    for motion in entry.felt:
        for model in models:
            there, factor = (
                model_and_scale_at_demand(model, demand, demand.confidence_on, motion) if demand else (model, 1.0)
            )
            for sign in entry.signs:
                yield motion, sign * factor, there


def _chosen(plan: Plan, k: int, demand: SeismicDemand | None) -> ScriptHistory:
    """The history that governs at the demand, or the next one if noise in the last digits of the samples decides it.
    Raises NoCheck."""
    runs = [(*run, answered) for run in _runs(plan, k, demand) if (answered := _answer(*run))]
    if not runs:
        raise ScriptUnavailable("no_records")
    runs.sort(key=lambda run: (run[3].overturns, run[3].rotation), reverse=True)
    chosen = "of all records and signs the largest rotation" + (" at the demand, with FC" if demand else "")
    if demand and demand.weak_share is not None:
        chosen += f"; the records as given are {demand.weak_share:.0%} of a_g S, NOT at the demand"
    motion, scale, model, most = runs[0]
    if most.rotation == 0.0:
        scale = float(np.sign(scale) * multiplier_of(Q_THAT_MOVES, motion.pga, threshold_of(model)))
        moved = _answer(motion, scale, model)
        runs = [] if moved is None else [(motion, scale, model, moved)]
        chosen = f"no record moves the wall: PGA {Q_THAT_MOVES} a_RM"
    for n, (motion, scale, model, answer) in enumerate(runs):
        tolerance = _tolerance(motion, scale, model, answer)
        if tolerance <= MAX_TOLERANCE * model.collapse_rotation:
            words = chosen if n == 0 else f"{chosen}, after {n} that the last digits of the samples decide"
            return ScriptHistory(motion, scale, model, words, answer, tolerance)
    raise ScriptUnavailable("too_sensitive")


def _answer(
    motion: GroundMotion, scale: float, model: RockingModel, ground: np.ndarray | None = None, last: int | None = None
) -> Answer | None:
    """The largest rotation, with the free motion after the record; of a wall that overturns that at the last sample
    within theta_c, or at a given one. None where its outcome is not known."""
    one = integrate_history(motion.acceleration if ground is None else ground, motion.time_step, scale, model, AUTO)
    if one.outcome != COLLAPSED:
        return Answer(False, 0, one.peak) if one.outcome == STABLE else None
    within = np.nonzero(np.abs(one.rotation) <= model.collapse_rotation)[0]
    last = int(within[-1]) if last is None else min(last, one.rotation.size - 1)
    return Answer(True, last, float(abs(one.rotation[last])))


def _tolerance(motion: GroundMotion, scale: float, model: RockingModel, answer: Answer) -> float:
    """Tolerance of a rotation [rad]: what noise in the last digits of the samples does to it, infinite where it
    decides whether the wall stands."""
    draw, effect = np.random.default_rng(1), 0.0
    for _ in range(NOISE_DRAWS):
        noise = 1.0 + SAMPLE_NOISE * draw.uniform(-1.0, 1.0, motion.acceleration.size)
        moved = _answer(motion, scale, model, motion.acceleration * noise, answer.last)
        if moved is None or moved.overturns != answer.overturns:
            return np.inf
        effect = max(effect, abs(moved.rotation - answer.rotation))
    return max(MIN_TOLERANCE * model.collapse_rotation, TIMES_NOISE * effect)


def _of(entry: PlannedWall, one: ScriptHistory) -> dict[str, Any]:
    """Lines of what is checked."""
    return {
        "WALL": f"{entry.part.wall.name} ({entry.mechanism})",
        "MADE_BY": line(),
        "RECORD": one.motion.name,
        "CHOSEN": one.chosen,
    }


def _model_lines(one: ScriptHistory) -> dict[str, Any]:
    """Lines of the equation of motion."""
    model = one.model
    sides = {}
    for side in (1,) if model.one_sided else (1, -1):
        seen = seen_from.py_func(model, float(side))
        held = seen.restoring
        sides[side] = (seen.slenderness, seen.p2, held.sine, held.cosine, seen.ratio_at_rest, seen.ratio_drop)
    return {
        "SIDES": sides,
        "PHI1, PHI2, OSCILLATOR": (model.elastic_end, model.plateau_end, model.driven is not None),
        "BARS": [tuple(bar[1:]) for bar in model.bars],
        "SCALE, DT": (one.scale, one.motion.time_step),
        "OVERTURNS, LAST": (one.answer.overturns, one.answer.last),
    }


def _wall_lines(entry: PlannedWall) -> dict[str, Any]:
    """Lines of the geometry and the loads, as they are worked by hand; what is no number is an expression."""
    wall = entry.kinematic.wall if entry.kinematic else entry.part.wall.in_si
    bare, t, u = wall.bare, wall.thickness, wall.setback
    x, z = bare.centroid
    weighs = wall.unit_weight is not None and wall.height is not None and t is not None
    geometry = [repr(wall.weight) if weighs else "1.0", repr(x), repr(z), repr(bare.inertia_over_mass - bare.radius**2)]
    if weighs and not wall.parts:
        h = wall.height
        geometry = [
            f"{wall.unit_weight!r} * {t!r} * {h!r}",
            f"{t!r} / 2 - {u!r}",
            f"{h!r} / 2",
            f"({h!r}**2 + {t!r}**2) / 12",
        ]
    width = f"{2.0 * x!r}" if t is None else f"{t!r} - 2 * {u!r}"
    forces = [load_to_force(load, wall, 1.0) for load in wall.loads if load.tie is None]
    held = [load_to_force(load, wall, 1.0) for load in wall.loads if load.tie is not None]
    return {
        "WEIGHT": Expression(geometry[0]),
        "X, Z, INERTIA, WIDTH": Expression(", ".join([*geometry[1:], width])),
        "LOADS": [(force.vertical, force.horizontal, force.distance, force.height) for force in forces],
        "TIES": [(one.horizontal, one.height) for one in held],
        "MASSES": [(mass.mass * G, mass.distance, mass.height) for mass in wall.masses],
        "TWO_SIDED": entry.kinematics.both_ways,
    }


def _demand_lines(entry: PlannedWall, demand: SeismicDemand) -> dict[str, Any]:
    """Lines of the checks by hand."""
    lines: dict[str, Any] = {"FC": demand.confidence_factor}
    if (state := demand.limit_state) in LIMIT_FRACTION:
        lines["PERIOD, DAMPING, SHARE"] = PERIOD_FACTOR[state], STATE_DAMPING[state], LIMIT_FRACTION[state]
        if isinstance(target := demand.target, CodeSpectrum) and entry.floor is None:
            lines["SPECTRUM"] = target.pga, target.amplification, target.t_b, target.t_c, target.t_d
    return lines


def _by_hand(entry: PlannedWall, demand: SeismicDemand | None, model: RockingModel) -> dict[str, float]:
    """Name in the script -> number of the program."""
    numbers, own = {}, entry.kinematic
    for side, name in ((1.0, "outer"), (-1.0, "inner")) if entry.kinematics.both_ways else ((1.0, "outer"),):
        seen = seen_from.py_func(model, side)
        held, alpha = seen.restoring, seen.slenderness
        numbers[f"alpha, {name} hinge [rad]"] = alpha
        numbers[f"p^2, {name} hinge [1/s2]"] = seen.p2
        numbers[f"collapse rotation, {name} hinge [rad]"] = alpha + held.lean
        numbers[f"uplift a_RM / g, {name} hinge"] = held.sine * np.tan(alpha) + held.cosine
    sums = own.chain if own else sum_chain(entry.part.wall.in_si, entry.kinematics.both_ways)
    numbers |= {"alpha_0 (C8.7.1.1)": sums.alpha0, "e* (C8.7.1.5)": sums.e_star, "d_0 [m]": sums.d0}
    if own is None or demand is None:
        return numbers
    if sums.alpha0_friction is None:
        numbers["a_0* / g (C8.7.1.3)"] = own.a0 / G
    if displacement := own.without_ties or (None if sums.ties else own.displacement):
        numbers["d of the limit state [m] (C8.7.1.2.1.6)"] = displacement.limit
        numbers["a(d) / g"] = displacement.capacity / G
        numbers["T(d) [s] (C8.7.1.10)"] = displacement.period
        if isinstance(demand.target, CodeSpectrum) and entry.floor is None:
            numbers["S_De(T) [m]"] = displacement.demand
            numbers["d / S_De (C8.7.1.12)"] = displacement.ratio
    return numbers


class Expression(str):
    """A value written as arithmetic."""


def _filled(lines: dict[str, Any], samples: np.ndarray) -> str:
    """The template with these values. lines : what stands left of the sign -> value"""
    text = TEMPLATE.read_text(encoding="utf-8")
    for name, value in lines.items():
        if isinstance(value, Expression):
            written = str(value)
        elif isinstance(value, tuple):
            written = ", ".join(map(repr, value))
        else:
            written = repr(value)
        pattern = rf"^{re.escape(name)} = .*?(?=  #|$)"
        (place,) = re.finditer(pattern, text, re.MULTILINE)
        text = f"{text[: place.start()]}{name} = {written}{text[place.end() :]}"
    head, _, tail = text.partition('SAMPLES = """\n')
    numbers = re.sub(r"(.{90,}?) ", r"\1\n", " ".join(map(repr, samples.tolist())))
    return f'{head}SAMPLES = """\n{numbers}{tail[tail.index(chr(10)) :]}'
