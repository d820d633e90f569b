"""Published worked examples, run again; where the program differs on purpose a case holds both numbers.

The textbook's number is computed in the textbook's way, in a few lines here; the program's by what a case runs.
"""

import math
from pathlib import Path

from core.case.rules import parse_case
from core.codes.kinematic import KinematicAnalysis, analyse_mechanism
from core.codes.vertical_bending import Bending, mechanism
from core.lab.solved import published_rocking
from core.lab.solved.experiments import section
from core.lab.solved.solved import Kind, Sketch, Solved, answer, told
from core.setting.demand_input import read_demand
from core.units import G
from core.wall.bending import Strip

WALL = {"height_m": 3.0, "thickness_m": 0.45, "unit_weight_kn_m3": 18.0}
"""The wall of which most examples here are: 24.3 kN/m."""

ROOF = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}

FACADE = {"height_m": 9.0, "thickness_m": 0.50, "unit_weight_kn_m3": 18.0}
FLOOR_LOADS = ((6.0, 0.30, 3.0), (6.0, 0.30, 6.0), (4.0, 0.30, 9.0), (15.0, 0.35, 3.0))
"""A facade of three storeys: N [kN/m], d, h [m] of two floors, the roof and a vault, whose masses push it."""
THRUST_HEIGHT = 3.0
THRUST = {"kind": "thrust", "kn_m": 3.0, "h_m": THRUST_HEIGHT}

STONE = {"height_m": 5.4, "thickness_m": 0.6}
PARAPET = {"height_m": 1.2, "thickness_m": 0.25, "unit_weight_kn_m3": 18.0}
THIN_WALL = {"height_m": 3.0, "thickness_m": 0.30, "unit_weight_kn_m3": 18.0}
ON_TOP = {"kind": "vertical", "kn_m": 5.0, "d_m": 0.15, "h_m": 3.0, "mass": "horizontal"}
TIE = {"kind": "tie", "out_kn_m": 1.9526786, "h_m": 2.8, "bar_length_m": 8.0, "elongation_m": 0.4}


def mechanism_of(wall: dict, *loads: dict, **more) -> KinematicAnalysis:
    """The mechanism of a wall as the keys of a case give it."""
    table = {"name": "wall", "base_z_m": 0.0, "mechanism": "one_sided", **wall, **more}
    table |= {"load": list(loads)} if loads else {}
    demand = {"ag_g": 0.26, "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}
    case = parse_case({"wall": [table], "demand": demand, "analysis": {"histories": False}})
    (made,), asked = case.wall, read_demand(case, Path())
    assert asked is not None
    return analyse_mechanism(made.in_si, made.mechanism, asked)


def _of_one_body() -> tuple[Solved, ...]:
    facade = (
        *({"kind": "vertical", "kn_m": n, "d_m": d, "h_m": z, "mass": "horizontal"} for n, d, z in FLOOR_LOADS),
        THRUST,
    )
    return (
        told(
            "published_stone_facade",
            Kind.PRINTED,
            "Frahan, example 36 (libishm1/Frahan, 2026)",
            (answer("published_alpha0", 0.112, lambda: mechanism_of(STONE).alpha0, 0.01),),
            formula="alpha_0 = t / H",
            sketch=Sketch(section(5.4, 0.6)),
        ),
        told(
            "published_courses",
            Kind.PRINTED,
            "RD2229, test_cinematica.py (dancarloni/RD2229)",
            (
                answer("published_alpha0", 0.1, lambda: mechanism_of(THIN_WALL).alpha0),
                answer("published_alpha0_loaded", 0.080916, lambda: mechanism_of(THIN_WALL, ON_TOP).alpha0),
                answer("published_e_star", 1.0, lambda: mechanism_of(THIN_WALL).e_star),
                answer("published_d0", 0.15, lambda: mechanism_of(THIN_WALL).d0, unit="m"),
                answer("published_a0", 0.074074, lambda: mechanism_of(THIN_WALL).a0 / G, unit="g"),
            ),
            formula="e^* = (sum P delta)^2 / (sum P sum P delta^2)",
            sketch=Sketch(section(3.0, 0.30)),
        ),
        told(
            "published_storeys",
            Kind.HAND,
            "Circolare 7/2019, C8.7.1.1 and C8.7.1.5",
            (
                answer("published_alpha0", 0.0426426, lambda: mechanism_of(FACADE, *facade).alpha0),
                answer("published_e_star", 0.940247, lambda: mechanism_of(FACADE, *facade).e_star),
                answer(
                    "published_m_star", 10738.4, lambda: mechanism_of(FACADE, *facade).m_star or math.nan, unit="kg/m"
                ),
            ),
            sketch=Sketch(
                section(9.0, 0.50), (*((d, z, 0.0, -1.0) for _, d, z in FLOOR_LOADS), (0.0, THRUST_HEIGHT, -1.0, 0.0))
            ),
        ),
    )


def _of_forces() -> tuple[Solved, ...]:
    return (
        told(
            "published_vault_thrust",
            Kind.PRINTED,
            "Petrella et al. (2026), Procedia Structural Integrity 78, Eq. 4 and 5",
            (
                answer("published_alpha0", 0.0951303, lambda: _pushed().alpha0),
                answer("published_rotation", 0.0521821, lambda: _pushed().chain.rotation(_pushed().d0), 1e-3, "rad"),
            ),
            formula="theta_u = (W t \\/ 2 + N d - F h) / (W H \\/ 2 + N h)",
            sketch=Sketch(section(3.0, 0.45), ((0.30, 3.0, 0.0, -1.0), (0.0, 2.5, -1.0, 0.0))),
        ),
        told(
            "published_tie_force",
            Kind.HAND,
            "Circolare 7/2019, C8.7.1.1",
            (answer("published_alpha0", 0.30, lambda: mechanism_of(WALL, hold=[TIE]).alpha0),),
            formula="F = (alpha W H \\/ 2 - W t \\/ 2) / h",
            sketch=Sketch(section(3.0, 0.45), ((0.0, 2.8, 1.0, 0.0),)),
        ),
        told(
            "published_elastic_period",
            Kind.PRINTED,
            "Circolare 7/2019, C8.7.1.7",
            (answer("published_t0", 0.216546, lambda: _vibrating().period_0 or math.nan, 2e-3, "s"),),
            formula="T_0 = (2 pi) / 1.8751^2 sqrt(m L^4 / (E I))",
            sketch=Sketch(section(3.0, 0.45)),
        ),
    )


def _pushed() -> KinematicAnalysis:
    """A wall with a roof and the thrust of a vault."""
    return mechanism_of(WALL, ROOF, {"kind": "thrust", "kn_m": 2.0, "h_m": 2.5})


def _vibrating() -> KinematicAnalysis:
    """A wall free to vibrate."""
    return mechanism_of(WALL, mechanism="two_sided", elastic_modulus_mpa=600.0)


def _bent(load: float, h1: float | None = None) -> Bending:
    """3.0 x 0.30 m held at its top, with a load in the middle of it [kN/m], its hinge in the middle or the lowest."""
    return mechanism(Strip(3.0, 0.30, 0.0, 16.2, ((load, 0.15),) if load else ()), h1)


READING = 0.012
"""Share to which a line of a printed figure is read."""

SOLID = {"height_m": 3.0, "thickness_m": 0.30, "unit_weight_kn_m3": 2200.0 * 9.81 / 1e3}
"""The wall of the examples of the macro-element: 2200 kg/m3."""

HEAVY_LOAD = 1e4
"""Load [kN/m] beside which a wall of LIGHT_WALL weighs next to nothing."""

LIGHT_WALL = {**SOLID, "unit_weight_kn_m3": 5.0}

ASPECT = 0.1
"""t/H of all of them."""


def _start(wall: dict, *loads: dict) -> float:
    """alpha_0 over t/H."""
    return mechanism_of(wall, *loads).alpha0 / ASPECT


def _end(wall: dict, *loads: dict) -> float:
    """Way of the top over the thickness at which nothing holds the wall."""
    closed_form = mechanism_of(wall, *loads)
    return wall["height_m"] * math.sin(closed_form.chain.rotation(closed_form.d0)) / wall["thickness_m"]


def _spanning(depth: float, h1: float | None = None) -> Bending:
    """The wall held at its top without a weight of its own, under HEAVY_LOAD at a depth [m]."""
    return mechanism(Strip(3.0, 0.30, 0.0, 1.0, ((HEAVY_LOAD, depth),)), h1)


def _pushed_over_load(depth: float, h1: float | None = None) -> float:
    """Horizontal force over the load on the top, over t/H."""
    return _spanning(depth, h1).alpha0 / HEAVY_LOAD / ASPECT


def _of_macroelement() -> tuple[Solved, ...]:
    source = "Vanin, Penna, Beyer (2019), examples 2a to 2d and figure of Macroelement3d (eesd-epfl/OpenSees)"
    on_top = {"kind": "vertical", "kn_m": HEAVY_LOAD, "d_m": 0.15, "h_m": 3.0, "mass": "horizontal"}
    gable = {**SOLID, "gable_m": 3.0, "length_m": 6.0}
    return (
        told(
            "published_cantilevers",
            Kind.PRINTED,
            source,
            (
                answer("published_start_weight", 1.0, lambda: _start(SOLID), READING),
                answer("published_end_weight", 1.0, lambda: _end(SOLID), READING),
                answer("published_start_load", 0.5, lambda: _start(LIGHT_WALL, on_top), READING),
                answer("published_end_load", 0.5, lambda: _end(LIGHT_WALL, on_top), READING),
                answer("published_start_gable", 1.5, lambda: _start(gable), READING),
                answer("published_end_gable", 1.5, lambda: _end(gable), READING),
            ),
            formula="lambda_0 = alpha_0 / (t \\/ H)",
            sketch=Sketch(section(3.0, 0.30), ((0.15, 3.0, 0.0, -1.0),)),
        ),
        told(
            "published_spanning",
            Kind.PRINTED,
            source,
            (
                answer("published_start_edge", 8.0, lambda: _pushed_over_load(0.0), READING),
                answer("published_end_edge", 1.0, lambda: _spanning(0.0).d_c0 / 0.30, READING),
                answer("published_start_lowest", 5.8, lambda: _pushed_over_load(0.15), READING),
                answer("published_start_middle", 6.0, lambda: _pushed_over_load(0.15, 1.5), READING),
                answer("published_end_middle", 0.75, lambda: _spanning(0.15, 1.5).d_c0 / 0.30, READING),
            ),
            formula="lambda_0 = 2 (1 \\/ xi + 1 \\/ 2 (1 - xi)), quad xi = h_1 / H",
            sketch=Sketch(section(3.0, 0.30), ((0.15, 3.0, 0.0, -1.0),)),
        ),
    )


def _new_zealand() -> tuple[Solved, ...]:
    return (
        told(
            "published_parapet",
            Kind.PRINTED,
            "NZSEE (2017), Section C8",
            (
                answer("published_alpha0", 0.25 / 1.2, lambda: mechanism_of(PARAPET).alpha0),
                answer("published_d0", 0.125, lambda: mechanism_of(PARAPET).d0, unit="m"),
            ),
            formula="T_p = sqrt(0.65 h (1 + (t\\/h)^2))",
            sketch=Sketch(section(1.2, 0.25)),
        ),
        told(
            "published_held_at_top",
            Kind.PRINTED,
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
        ),
    )


CASES: tuple[Solved, ...] = (
    *published_rocking.CASES,
    *_of_one_body(),
    *_of_forces(),
    *_of_macroelement(),
    *_new_zealand(),
)
"""Worked examples of papers, codes and open programs."""
