"""Does the program compute on this machine what it computed where it was made?

The stored answers are told at every start of the window, from source too. Those of the machine that a library of
machine code was made on decide whether it is used at all (core/jit/trial.py).
"""

import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.capacity.ida import Search, incremental_dynamic_analysis, multiplier_of, threshold_of
from core.codes.demand import SeismicDemand
from core.codes.kinematic import analyse_mechanism
from core.codes.spectrum_codes import en1998
from core.ground.ground_motion import GroundMotion
from core.jit import shipped
from core.jit.native import has_numba
from core.rocking.history import integrate_history, requires_order_8, uses_lanes
from core.rocking.methods import METHODS, Method, resolve_auto
from core.units import G
from core.wall.block import Block
from core.wall.masonry import Masonry
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import RockingModel, rocking_model

STORED = Path(__file__).resolve().parents[2] / "resources" / "self_test.json"

ORDERS = ("taylor", "taylor_6")
"""Methods whose searches and histories have stored answers."""

LAST_DIGITS = 1e-9
"""Difference, over the largest number of an answer, up to which it is not wrong: functions such as the tangent may end
in another digit on another system, which no result shows."""


class Outcome(NamedTuple):
    """wrong : names of the questions that have another answer; exact : every answer is the same to the last bit."""

    wrong: tuple[str, ...]
    exact: bool


def compute_answers(method: str) -> dict[str, list[str]]:
    """Question -> doubles, as hexadecimal text: the Housner intensity of a motion; q, SLV and a history of a wall 3 m
    high, rigid and free to rock to both sides, then one-sided, rigid and trilinear, beside a transverse wall; its
    checks by the clauses. The motion is made of whole numbers, so that it is the same everywhere. method : of ORDERS"""
    count = np.arange(400)
    samples = ((count * count * 7 + count * 13) % 101 - 50.0) * (count % 40 < 23) / 16.0
    motion = GroundMotion("whole numbers", samples, 0.01)
    block = Block.rectangle(3.0, 0.13)
    doubles: dict[str, list[float]] = {"intensity": [motion.housner_intensity], "kinematic": _by_clauses(block)}
    walls = (("two_sided", False, "rigid"), ("trilinear", True, "doherty"), ("one_sided", True, "rigid"))
    for name, one_sided, law in walls:
        model = rocking_model(block, one_sided, restitution(block, "housner"), LAWS[law])
        ground, pga, by = motion.acceleration, motion.pga, METHODS[method]
        run = incremental_dynamic_analysis(ground, 0.01, pga, 1, model, by, Search(q_step=0.02, q_limit=10.0))
        doubles[f"{name}_q"] = [math.nan if value is None else value for value in (run.q, run.q_slv)]
        scale = float(multiplier_of(3.0, pga, threshold_of(model)))
        doubles[f"{name}_history"] = list(integrate_history(ground, 0.01, scale, model, by).rotation[::40])
    return {name: [float(value).hex() for value in values] for name, values in doubles.items()}


def _by_clauses(block: Block) -> list[float]:
    """alpha_0, d_0 [m], T_SLV [s] and S_De [m] of a wall under a spectrum of EN 1998-1."""
    spectrum = en1998(0.25 * G, 1, "B")
    demand = SeismicDemand("SLV", 0.25 * G, 1.2, spectrum.pga, None, None, 2.0, 1.35, 1.0, spectrum)
    mechanism = analyse_mechanism(Masonry("", "one_sided", block), "one_sided", demand)
    assert mechanism.period is not None and mechanism.s_de is not None
    return [mechanism.alpha0, mechanism.d0, mechanism.period, mechanism.s_de]


def compute_order_8_answers() -> list[str]:
    """All answers of the series of order 8, as a library of machine code keeps them."""
    return [number for values in compute_answers(ORDERS[0]).values() for number in values]


def numbers_are_right() -> bool:
    """Whether they are those of the machine on which the machine code was made: to the last bit where numba can compile
    in its place, else within LAST_DIGITS, for functions such as the sine are of the system."""
    found, known = compute_order_8_answers(), shipped.library().self_test
    if has_numba() or len(found) != len(known):
        return found == known
    pairs = [(float.fromhex(one), float.fromhex(other)) for one, other in zip(found, known, strict=True)]
    return all(abs(one - other) <= LAST_DIGITS * max(1.0, abs(other)) for one, other in pairs)


def find_kernel_order(method: Method, model: RockingModel, dt: float) -> tuple[str, ...]:
    """Find which of ORDERS names the kernels that analyses of a wall compile; none where they are others. dt : [s]"""
    resolved = resolve_auto(method, model, dt)
    own = requires_order_8(model) or model.bending is not None
    return (resolved.name,) if uses_lanes(resolved, model) and not own else ()


def compare_answers(methods: Iterable[str] = ORDERS) -> Outcome:
    """What is not as it is stored, some 0.1 s once the kernels are there; the name of the file where that is damaged.
    methods : of ORDERS"""
    computed = {method: compute_answers(method) for method in methods}
    try:
        stored = json.loads(STORED.read_bytes())
        wrong = [
            name
            for method, own in computed.items()
            for name, values in own.items()
            if _differs(values, stored[method][name])
        ]
        return Outcome(tuple(dict.fromkeys(wrong)), all(stored[method] == own for method, own in computed.items()))
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return Outcome((STORED.name,), False)


def _differs(values: list[str], stored: list[str]) -> bool:
    computed, known = ([float.fromhex(number) for number in each] for each in (values, stored))
    most = LAST_DIGITS * max(map(abs, known))
    return not math.isfinite(most) or not all(
        abs(one - other) <= most for one, other in zip(computed, known, strict=True)
    )


if __name__ == "__main__":  # python -m core.study.self_test, after a change of a result that the changelog names
    STORED.write_text(
        json.dumps({method: compute_answers(method) for method in ORDERS}, indent=1) + "\n", encoding="ascii"
    )
