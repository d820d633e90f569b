"""Published worked examples, run again; where the program differs on purpose a case holds both numbers.

The textbook's number is computed in the textbook's way, in a few lines here; the program's by what a case runs.
"""

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from core.capacity.closed_forms import closed_form_q_eff
from core.case.rules import parse_case
from core.codes.kinematic import Kinematic, kinematic
from core.codes.vertical_bending import Bending, Strip, mechanism
from core.rocking.history import history
from core.setting.demand_input import demand_of
from core.solved.experiments import first_overturning, overturned, section
from core.solved.solved import Answer, Kind, Sketch, Solved
from core.text.sentence import sentence
from core.units import CM, G
from core.wall.block import Block
from core.wall.rocking_model import RockingModel

WALL = {"height_m": 3.0, "thickness_m": 0.45, "unit_weight_kn_m3": 18.0}
"""The wall of which most examples here are: 24.3 kN/m."""

ROOF = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}

FACADE = {"height_m": 9.0, "thickness_m": 0.50, "unit_weight_kn_m3": 18.0}
FLOORS = ((6.0, 0.30, 3.0), (6.0, 0.30, 6.0), (4.0, 0.30, 9.0), (15.0, 0.35, 3.0))
"""A facade of three storeys: N [kN/m], d, h [m] of two floors, the roof and a vault, whose masses push it."""
THRUST_HEIGHT = 3.0
THRUST = {"kind": "thrust", "kn_m": 3.0, "h_m": THRUST_HEIGHT}

STONE = {"height_m": 5.4, "thickness_m": 0.6}
PARAPET = {"height_m": 1.2, "thickness_m": 0.25, "unit_weight_kn_m3": 18.0}
THIN = {"height_m": 3.0, "thickness_m": 0.30, "unit_weight_kn_m3": 18.0}
ON_TOP = {"kind": "vertical", "kn_m": 5.0, "d_m": 0.15, "h_m": 3.0, "mass": "horizontal"}
TIE = {"kind": "tie", "kn_m": 1.9526786, "h_m": 2.8, "bar_length_m": 8.0, "elongation_m": 0.4}

HALF_SINES = ((2.0, 1.80072), (4.0, 2.79080), (8.0, 4.78707))
"""omega/p and the amplitude over g alpha at which a half sine overturns a linear block."""

SINE_EDGES = (("published_falls", 3.01), ("published_stands", 6.33), ("published_falls_again", 7.18))
"""Words and amplitudes over g alpha at which a full sine with omega = 5 p begins or ceases to overturn a block."""

SLENDER = 1e-3
"""alpha [rad] at which the exact equation is the linear one of the older papers, to six digits."""


def mechanism_of(wall: dict, *loads: dict, **more) -> Kinematic:
    """The mechanism of a wall as the keys of a case give it."""
    table = {"name": "wall", "base_z_m": 0.0, "mechanism": "one_sided", **wall, **more}
    table |= {"load": list(loads)} if loads else {}
    reasons = {"histories": "the checks of the clauses alone"}
    demand = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}, "justification": reasons}
    case = parse_case({"wall": [table], "demand": demand, "analysis": {"histories": False}})
    (made,), asked = case.wall, demand_of(case, Path())
    assert asked is not None
    return kinematic(made.in_si, made.mechanism, asked)


def answer(code: str, expected: float, find: Callable[[], float], tolerance: float = 1e-4, unit: str = "") -> Answer:
    """An answer. code : of its words; tolerance : the digits it is printed with, where none is said"""
    return Answer(sentence("solved", code), unit, expected, tolerance, find)


def _of_rocking() -> tuple[Solved, ...]:
    return (
        Solved(
            "published_paper_law",
            Kind.PRINTED,
            sentence("solved", "published_paper_law"),
            "Coccia, Di Carlo, Imperatore (2016), Eq. 15, 16 and Table 2",
            tuple(
                answer(code, q_eff, partial(closed_form_q_eff, math.radians(6.8), 7.0, 124.27 * CM, side))
                for code, q_eff, side in (
                    ("published_q_two_sided", 6.7595, False),
                    ("published_q_one_sided", 18.917, True),
                )
            ),
            formula="(30 alpha + 78 H + 90) / S_I",
            comment=sentence("solved", "published_paper_law_why"),
        ),
        Solved(
            "published_housner_period",
            Kind.PRINTED,
            sentence("solved", "published_housner_period"),
            "Housner (1963), BSSA 53(2); test_p2_housner.py of an open fork of OpenSees",
            (answer("published_quarter_period", 0.60050, _quarter_period, 5e-3, "s"),),
            formula='T/4 = 1/p op("arcosh") 1/(1 - theta_0 / alpha)',
            sketch=Sketch(section(2.0, 0.4)),
            comment=sentence("solved", "published_housner_period_why"),
        ),
        Solved(
            "published_housner_pulses",
            Kind.PRINTED,
            sentence("solved", "published_housner_pulses"),
            "Housner (1963), BSSA 53(2); Makris, Roussos (2000), Géotechnique 50(3)",
            (
                answer("published_rectangle", math.acosh(1.25), _rectangular_pulse, 2e-3),
                *(
                    Answer(sentence("solved", "published_half_sine", ratio=w), "", a, 1e-3, partial(_half_sine, w))
                    for w, a in HALF_SINES
                ),
            ),
            formula="cosh p t_1 = 1 + 1/(2 r (r - 1)), quad r = dot.double(u) / (g alpha)",
            comment=sentence("solved", "published_housner_pulses_why"),
        ),
        Solved(
            "published_full_sine",
            Kind.PRINTED,
            sentence("solved", "published_full_sine"),
            "Zhang, Makris (2001), J. Eng. Mech. 127(5)",
            tuple(
                answer(code, printed, partial(_edge_of_sine, n), 5e-3) for n, (code, printed) in enumerate(SINE_EDGES)
            ),
            comment=sentence("solved", "published_full_sine_why"),
        ),
    )


def _quarter_period() -> float:
    """Of a block with its mass in its corners, half-width 0.2 and half-height 1 m, from half of alpha."""
    radius = math.hypot(0.2, 1.0)
    block = Block(math.atan2(0.2, 1.0), radius, 2.0 * radius**2)
    model = RockingModel(block.slenderness, block.p2, 0.0, 0.9, 0.0, 0.0, 0.0)
    return history(np.zeros(2001), 1e-3, 1.0, model, start=(0.5 * block.slenderness, 0.0)).impact_time[0]


def _rectangular_pulse() -> float:
    """Least p t_1 of a rectangle of twice g alpha that overturns."""
    model = RockingModel(SLENDER, 1.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    for duration in np.arange(0.68, 0.71, 5e-4):
        step = duration / 1000.0
        ground = np.where(np.arange(1002) <= 1000, 2.0 * SLENDER * G, 0.0)
        if first_overturning(ground, step, np.ones(1), model) == 1.0:
            return float(duration)
    return math.inf


def _half_sine(ratio: float) -> float:
    """Least amplitude over g alpha of a half sine with omega = ratio p."""
    model = RockingModel(SLENDER, 1.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    ground = SLENDER * G * np.sin(np.linspace(0.0, math.pi, 1001))
    return float(first_overturning(ground, math.pi / ratio / 1000.0, np.arange(1.5, 5.0, 5e-4), model))


def edges_of_sine(slenderness: float) -> list[float]:
    """Amplitudes over g alpha, in steps of 0.01, at which a full sine with omega = 5 p begins and ceases to overturn a
    block of velocity ratio 0.9."""
    model, scales = RockingModel(slenderness, 2.14**2, 0.0, 0.9, 0.0, 0.0, 0.0), np.arange(1.0, 9.0, 0.01)
    ground = slenderness * G * np.sin(np.linspace(0.0, 2.0 * math.pi, 2001))
    falls = overturned(ground, 2.0 * math.pi / (5.0 * 2.14) / 2000.0, scales, model)
    return [float(scales[n + 1]) for n in np.flatnonzero(np.diff(falls))]


def _edge_of_sine(n: int) -> float:
    return edges_of_sine(SLENDER)[n]


def _of_one_body() -> tuple[Solved, ...]:
    facade = (
        *({"kind": "vertical", "kn_m": n, "d_m": d, "h_m": z, "mass": "horizontal"} for n, d, z in FLOORS),
        THRUST,
    )
    return (
        Solved(
            "published_stone_facade",
            Kind.PRINTED,
            sentence("solved", "published_stone_facade"),
            "Frahan, example 36 (libishm1/Frahan, 2026)",
            (answer("published_alpha0", 0.112, lambda: mechanism_of(STONE).alpha0, 0.01),),
            formula="alpha_0 = t / H",
            sketch=Sketch(section(5.4, 0.6)),
            comment=sentence("solved", "published_stone_facade_why"),
        ),
        Solved(
            "published_courses",
            Kind.PRINTED,
            sentence("solved", "published_courses"),
            "RD2229, test_cinematica.py (dancarloni/RD2229)",
            (
                answer("published_alpha0", 0.1, lambda: mechanism_of(THIN).alpha0),
                answer("published_alpha0_loaded", 0.080916, lambda: mechanism_of(THIN, ON_TOP).alpha0),
                answer("published_e_star", 1.0, lambda: mechanism_of(THIN).e_star),
                answer("published_d0", 0.15, lambda: mechanism_of(THIN).d0, unit="m"),
                answer("published_a0", 0.074074, lambda: mechanism_of(THIN).a0 / G, unit="g"),
            ),
            formula="e^* = (sum P delta)^2 / (sum P sum P delta^2)",
            sketch=Sketch(section(3.0, 0.30)),
            comment=sentence("solved", "published_courses_why"),
        ),
        Solved(
            "published_storeys",
            Kind.HAND,
            sentence("solved", "published_storeys"),
            "Circolare 7/2019, C8.7.1.1 and C8.7.1.5",
            (
                answer("published_alpha0", 0.0426426, lambda: mechanism_of(FACADE, *facade).alpha0),
                answer("published_e_star", 0.940247, lambda: mechanism_of(FACADE, *facade).e_star),
                answer(
                    "published_m_star", 10738.4, lambda: mechanism_of(FACADE, *facade).m_star or math.nan, unit="kg/m"
                ),
            ),
            sketch=Sketch(
                section(9.0, 0.50), (*((d, z, 0.0, -1.0) for _, d, z in FLOORS), (0.0, THRUST_HEIGHT, -1.0, 0.0))
            ),
            comment=sentence("solved", "published_storeys_why"),
        ),
    )


def _of_forces() -> tuple[Solved, ...]:
    return (
        Solved(
            "published_vault_thrust",
            Kind.PRINTED,
            sentence("solved", "published_vault_thrust"),
            "Petrella et al. (2026), Procedia Structural Integrity 78, Eq. 4 and 5",
            (
                answer("published_alpha0", 0.0951303, lambda: _pushed().alpha0),
                answer("published_rotation", 0.0521821, lambda: _pushed().chain.rotation(_pushed().d0), 1e-3, "rad"),
            ),
            formula="theta_u = (W t \\/ 2 + N d - F h) / (W H \\/ 2 + N h)",
            sketch=Sketch(section(3.0, 0.45), ((0.30, 3.0, 0.0, -1.0), (0.0, 2.5, -1.0, 0.0))),
            comment=sentence("solved", "published_vault_thrust_why"),
        ),
        Solved(
            "published_tie_force",
            Kind.HAND,
            sentence("solved", "published_tie_force"),
            "Circolare 7/2019, C8.7.1.1",
            (answer("published_alpha0", 0.30, lambda: mechanism_of(WALL, TIE).alpha0),),
            formula="F = (alpha W H \\/ 2 - W t \\/ 2) / h",
            sketch=Sketch(section(3.0, 0.45), ((0.0, 2.8, 1.0, 0.0),)),
            comment=sentence("solved", "published_tie_force_why"),
        ),
        Solved(
            "published_elastic_period",
            Kind.PRINTED,
            sentence("solved", "published_elastic_period"),
            "Circolare 7/2019, C8.7.1.7",
            (answer("published_t0", 0.216546, lambda: _vibrating().period_0 or math.nan, 2e-3, "s"),),
            formula="T_0 = (2 pi) / 1.8751^2 sqrt(m L^4 / (E I))",
            sketch=Sketch(section(3.0, 0.45)),
            comment=sentence("solved", "published_elastic_period_why"),
        ),
    )


def _pushed() -> Kinematic:
    """A wall with a roof and the thrust of a vault."""
    return mechanism_of(WALL, ROOF, {"kind": "thrust", "kn_m": 2.0, "h_m": 2.5})


def _vibrating() -> Kinematic:
    """A wall free to vibrate."""
    return mechanism_of(WALL, free_element=True, elastic_modulus_mpa=600.0)


def _bent(load: float, h1: float | None = None) -> Bending:
    """3.0 x 0.30 m held at its top, with a load in the middle of it [kN/m], its hinge in the middle or the lowest."""
    return mechanism(Strip(3.0, 0.30, 0.0, 16.2, ((load, 0.15),) if load else ()), h1)


def _new_zealand() -> tuple[Solved, ...]:
    return (
        Solved(
            "published_parapet",
            Kind.PRINTED,
            sentence("solved", "published_parapet"),
            "NZSEE (2017), Section C8",
            (
                answer("published_alpha0", 0.25 / 1.2, lambda: mechanism_of(PARAPET).alpha0),
                answer("published_d0", 0.125, lambda: mechanism_of(PARAPET).d0, unit="m"),
            ),
            formula="T_p = sqrt(0.65 h (1 + (t\\/h)^2))",
            sketch=Sketch(section(1.2, 0.25)),
            comment=sentence("solved", "published_parapet_why"),
        ),
        Solved(
            "published_held_at_top",
            Kind.PRINTED,
            sentence("solved", "published_held_at_top"),
            "NZSEE (2017), Section C8; Doherty, Griffith, Lam, Wilson (2002), EESD 31(4)",
            (
                answer("published_c_m", 0.40, lambda: _bent(0.0, 1.5).alpha0),
                answer("published_c_m_loaded", 0.77037, lambda: _bent(10.0, 1.5).alpha0),
                answer("published_delta_i", 0.30, lambda: _bent(0.0, 1.5).d_c0, unit="m"),
                answer("published_delta_i_loaded", 0.25856, lambda: _bent(10.0, 1.5).d_c0, 5e-3, "m"),
                answer("published_lowest", 2.0 * 0.30 / 2.7, lambda: _bent(0.0).alpha0),
                answer("published_lowest_loaded", 0.66779, lambda: _bent(10.0).alpha0),
            ),
            formula="alpha_0 = 2 / W ((W + N) t / h_1 + N t \\/ 2 / (H - h_1))",
            sketch=Sketch(section(3.0, 0.30), ((0.15, 3.0, 0.0, -1.0),)),
            comment=sentence("solved", "published_held_at_top_why"),
        ),
    )


CASES: tuple[Solved, ...] = (*_of_rocking(), *_of_one_body(), *_of_forces(), *_new_zealand())
"""Worked examples of papers, codes and open programs."""
