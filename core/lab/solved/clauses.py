"""The Circolare 7/2019, C8.7.1.2.1, by hand: walls on the ground, free elements, loads, friction, a church facade."""

import math
from functools import cache

import numpy as np

from core.case.reader import read_case
from core.codes.kinematic import elastic_period
from core.codes.kinematic_chain import return_wall_friction, sum_chain
from core.known import require_value
from core.lab.solved.shipped import SHIPPED
from core.lab.solved.solved import Answer, Head, Kind, Sketch, Solved, printed, row, worded
from core.lab.solved.walls import EN_B, NTC_C, Asked
from core.rocking.history import integrate_history
from core.setting.demand_input import read_demand
from core.units import G

ZETA_LINEAR: Head = (worded("ζ linear, q = 2"), "")
ZETA_DISPLACEMENT: Head = (worded("ζ of the displacement check"), "")
FREE = {"elastic_modulus_mpa": 600.0}
NOT_FREE = {"hold": [{"kind": "cross_walls", "evidence": {"kind": "drawing"}}]}

WALLS_ON_GROUND = (
    # key, H, t, kind, then a_0*/g, zeta linear, T_SLV, S_De, zeta displacement
    ("tall", 7.0, 0.83, NOT_FREE, "0.08783 0.5630 2.99126 0.16994 0.9768"),
    ("storey", 3.0, 0.45, NOT_FREE, "0.11111 0.7123 1.95824 0.16639 0.5409"),
    ("free", 3.0, 0.45, FREE, "0.11111 0.2849 1.95824 0.16639 0.5409"),
    ("low", 1.0, 0.20, NOT_FREE, "0.14815 0.9497 1.13059 0.09606 0.4164"),
)

KINEMATIC = (
    'a_0^* = (alpha_0 g)/(e^* "FC"), quad zeta = (q a_0^*)/(a_g S), quad T_"SLV" = 1.68 pi '
    'sqrt(d_"SLV"/a(d_"SLV")), quad zeta = d_"SLV"/(S_"De" (T_"SLV", 8 %))'
)


def on_the_ground(key: str, height: float, thickness: float, kind: dict, values: str) -> Solved:
    asked = Asked({"height_m": height, "thickness_m": thickness, "mechanism": "two_sided", **kind})

    def found() -> tuple[float, ...]:
        check = asked.checked
        return (
            check.a0 / G,
            asked.zeta_linear(),
            require_value(check.period),
            require_value(check.s_de),
            asked.zeta_displacement,
        )

    heads = (("a_0*/g", ""), ZETA_LINEAR, ("T_SLV", "s"), ("S_De", "m"), ZETA_DISPLACEMENT)
    free = kind is FREE
    return Solved(
        f"ground_{key}",
        Kind.HAND,
        worded(
            "Free element {h:g} × {t:g} m on the ground" if free else "Wall {h:g} × {t:g} m on the ground",
            h=height,
            t=thickness,
        ),
        "Circolare 7/2019, C8.7.1.1-C8.7.1.12",
        row(heads, values, found),
        KINEMATIC,
        asked.sketch,
        worded(
            "a_g 0.26 g, EN 1998-1 type 1, ground B, FC 1.35. One wall is one block: e* = 1 and d = d_C "
            "at its centroid. The displacement check is shown as it is, before a_g,SLD is counted for "
            "SLV (clause .8)."
        ),
        asked.table,
    )


SOIL_C = (
    ("12.5 × 0.90 m", {"height_m": 12.5, "thickness_m": 0.90, **NOT_FREE}, "- 0.3073 0.7371"),
    ("3.0 × 0.40 m", {"height_m": 3.0, "thickness_m": 0.40, "elastic_modulus_mpa": 1e3}, "0.19417 0.2408 0.4423"),
    ("2.8 × 0.70 m", {"height_m": 2.8, "thickness_m": 0.70, "elastic_modulus_mpa": 1e3}, "0.09666 0.6044 0.8013"),
)


def on_soil_c(name: str, wall: dict, values: str) -> tuple[Answer, ...]:
    asked = Asked({**wall, "unit_weight_kn_m3": 19.0, "mechanism": "two_sided"}, NTC_C)

    def found() -> tuple[float, ...]:
        # clause .8: where a_g,SLV is below a_g,SLD, that counts
        counted = max(asked.zeta_displacement, require_value(asked.checked.zeta_sld))
        return asked.checked.period_0 or 0.0, asked.zeta_linear(), counted

    heads = (
        (f"T_0 ({name})", "s"),
        (worded("ζ linear, q = 2 ({name})", name=name), ""),
        (worded("ζ of the displacement check ({name})", name=name), ""),
    )
    return row(heads, values, found, 1.0)


FREE_PERIODS = (
    # H, t [m], E [MPa], w [kN/m3], T_0 [s]
    (3.0, 0.45, 600.0, 18.0, "0.21688"),
    (1.2, 0.25, 600.0, 18.0, "0.06246"),
    (3.0, 0.40, 1000.0, 19.0, "0.19417"),
)


def free_period(height: float, thickness: float, modulus: float, weight: float, seconds: str) -> Answer:
    keys = {"height_m": height, "thickness_m": thickness, "elastic_modulus_mpa": modulus, "unit_weight_kn_m3": weight}
    name = f"T_0 ({height:g} × {thickness:g} m, E {modulus:g} MPa)"
    return printed((name, "s"), seconds, lambda: require_value(elastic_period(Asked(keys, None).wall.in_si)))


ROOF = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}
PUSHING = {**ROOF, "mass": "horizontal"}
INWARD = {"kind": "thrust", "kn_m": -5.0, "h_m": 2.8}
THRUST = {"kind": "thrust", "kn_m": 2.0, "h_m": 2.5}
STOREY_WALL = {"height_m": 3.0, "thickness_m": 0.45, "velocity_ratio": 0.6}

LOADED = (
    # a, c, uplift/g, theta_c, alpha_0, e*, d_0, zeta linear, zeta displacement
    ("none", worded("Wall without loads"), (), "1 0 0.15000 0.148890 0.15000 1 0.22500 0.7123 0.5409"),
    (
        "roof",
        worded("Wall with a roof held elsewhere"),
        (ROOF,),
        "1.817008 -0.040247 0.23230 0.126744 0.23230 1 0.19141 1.1031 0.6209",
    ),
    (
        "pushing",
        worded("Wall with a roof whose mass pushes"),
        (PUSHING,),
        "- - - 0.126744 0.12743 0.88982 0.27783 0.6800 0.6540",
    ),
    (
        "carried",
        worded("Wall that carries a mass with it"),
        ({"kind": "carried_mass", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0},),
        "- - - 0.126744 0.12743 0.88982 0.27783 0.6800 0.6540",
    ),
    (
        "inward",
        worded("Wall with a roof and a constant force inward"),
        (ROOF, INWARD),
        "1.873354 0.335389 0.61639 0.326045 0.61639 1 0.49230 2.9268 1.6219",
    ),
    (
        "thrust",
        worded("Wall with a roof and a thrust"),
        (ROOF, THRUST),
        "1.796885 -0.174402 0.09513 0.052135 0.09513 1 0.07847 0.4517 0.2544",
    ),
)
LOAD_HEADS: tuple[Head, ...] = (
    ("a", ""),
    ("c", ""),
    (worded("uplift"), "g"),
    ("θ_c", "rad"),
    ("α_0", ""),
    ("e*", ""),
    ("d_0", "m"),
    ZETA_LINEAR,
    ZETA_DISPLACEMENT,
)


def loaded(*loads: dict, **changes: object) -> Asked:
    """The wall of 3.0 x 0.45 m and 24.3 kN/m with loads."""
    return Asked({**STOREY_WALL, **changes} | ({"load": list(loads)} if loads else {}))


def with_loads(key: str, title, loads: tuple[dict, ...], values: str) -> Solved:
    asked = loaded(*loads)

    def found() -> tuple[float, ...]:
        model, check = asked.model, asked.checked
        of_histories = model.restoring.sine, model.restoring.cosine, model.threshold / G, model.collapse_rotation
        return *of_histories, check.alpha0, check.e_star, check.d0, asked.zeta_linear(), asked.zeta_displacement

    return Solved(
        f"loads_{key}",
        Kind.HAND,
        title,
        "Circolare 7/2019, C8.7.1.1-C8.7.1.12; physics.md, 17",
        row(LOAD_HEADS, values, found),
        "theta'' = -p^2 [a sin(alpha - theta) - ((u'')/g - c) cos(alpha - theta)], quad alpha_0 = (W "
        "t\\/2 + sum N d + sum F h)/(W H\\/2 + sum Q h), quad e^* = (W H\\/2 + sum Q h)^2/((W + sum "
        "Q)(W H^2\\/4 + sum Q h^2))",
        asked.sketch,
        worded(
            "3.0 × 0.45 m, 18 kN/m³; roof 10 kN/m at 0.30 m from the outer face, force 5 kN/m at 2.8 m, "
            "thrust 2 kN/m at 2.5 m; a_g 0.26 g, EN 1998-1 type 1, ground B, FC 1.35. Worked twice, by "
            "independent scripts."
        ),
        asked.table,
    )


def free_fall(loads: tuple[dict, ...], seconds: str) -> Answer:
    def found() -> float:
        return float(
            integrate_history(np.zeros(2000), 0.005, 1.0, loaded(*loads).model, start=(0.06, 0.0)).impact_time[0]
        )

    return printed((worded("time, with the roof") if loads else worded("time, without loads"), "s"), seconds, found)


ACROSS = {"number": 2, "thickness_m": 0.5, "brick_height_m": 0.25, "brick_length_m": 0.2}
"""Return walls of the worked value of the friction: 12 courses."""


def slc() -> tuple[Answer, ...]:
    asked = Asked(
        {"height_m": 7.0, "thickness_m": 0.83, "mechanism": "two_sided", **NOT_FREE}, {**EN_B, "limit_state": "SLC"}
    )
    a0 = 0.83 / 7.0 / 1.35 * 9.80665
    period = 1.56 * math.pi * math.sqrt(0.249 / (0.4 * a0))
    s_de = 0.312 * 9.80665 * math.sqrt(10.0 / 15.0) * 2.5 * 0.5 * 2.0 / (4.0 * math.pi**2)
    return (
        Answer("d_SLC", "m", 0.6 * 0.415, 1e-9, lambda: require_value(asked.checked.d_limit)),
        Answer("T_SLC", "s", period, 1e-9, lambda: require_value(asked.checked.period)),
        Answer("S_De(T_SLC, 10 %)", "m", s_de, 1e-9, lambda: require_value(asked.checked.s_de)),
    )


CHURCH_AG_S = 0.29977 * (1.4 - 0.4 * 2.38391 * 0.29977)
"""NTC 2018 Tab. 3.2.IV, ground B [g]."""

CHURCH = Asked(
    {
        "height_m": 11.0,
        "thickness_m": 0.90,
        "unit_weight_kn_m3": 19.0,
        "hinge_setback_m": 0.04,
        "load": [
            {"kind": "vertical", "kn_m": 9.0, "d_m": 0.60, "h_m": 10.6, "mass": "horizontal"},
            {"kind": "thrust", "kn_m": 1.2, "d_m": 0.04, "h_m": 10.6},
        ],
    },
    {
        "ag_g": 0.29977,
        "spectrum": {"code": "NTC2018", "f0": 2.38391, "tc_star_s": 0.35616, "soil": "B", "topography": "T1"},
    },
)


def church() -> tuple[Answer, ...]:
    """About a hinge 0.04 m inside the edge; the roof's mass pushes, its thrust of 1.2 kN/m acts outward."""
    weight = 19.0 * 11.0 * 0.9
    holding = weight * (0.45 - 0.04) + 9.0 * (0.60 - 0.04) - 1.2 * 10.6
    pushing, second = weight * 5.5 + 9.0 * 10.6, weight * 5.5**2 + 9.0 * 10.6**2
    e_star = pushing**2 / ((weight + 9.0) * second)
    a0 = holding / pushing / (e_star * 1.35)
    return (
        Answer("α_0", "", holding / pushing, 1e-9, lambda: CHURCH.checked.alpha0),
        Answer("e*", "", e_star, 1e-9, lambda: CHURCH.checked.e_star),
        Answer("a_0*/g", "", a0, 1e-9, lambda: CHURCH.checked.a0 / G),
        Answer("ζ, q = 2", "", 2.0 * a0 / CHURCH_AG_S, 1e-9, CHURCH.zeta_linear),
    )


@cache
def shipped_facade():
    """(mechanism, demand) of the facade of resources/cases/facade.toml as it is."""
    from core.codes.kinematic import analyse_mechanism, check_linear

    case = read_case(SHIPPED / "facade.toml")
    demand = require_value(read_demand(case, SHIPPED))
    mechanism = analyse_mechanism(case.wall[0].in_si, "one_sided", demand)
    return mechanism, require_value(check_linear("linear_q_code", mechanism, demand, 2.0))


def facade() -> tuple[Answer, ...]:
    """Rectangle of 10 x 8 m, gable of 3 m, portal of 2 x 3.5 m, rose window of 2.4 m at +6.5 m."""
    rose = math.pi * 1.2**2
    area = 80.0 + 15.0 - 7.0 - rose
    z = (80.0 * 4.0 + 15.0 * 9.0 - 7.0 * 1.75 - rose * 6.5) / area
    zeta = 2.0 * 0.45 / z / 1.35 / (0.18 * 1.2)
    return (
        Answer(
            "M*", "kg/m", 19e3 / 9.80665 * area * 0.9 / 10.0, 1e-9, lambda: require_value(shipped_facade()[0].m_star)
        ),
        Answer("α_0", "", 0.45 / z, 1e-9, lambda: shipped_facade()[0].alpha0),
        Answer("ζ, q = 2", "", zeta, 1e-9, lambda: require_value(shipped_facade()[1].zeta)),
    )


CASES: tuple[Solved, ...] = (
    *(on_the_ground(*one) for one in WALLS_ON_GROUND),
    Solved(
        "ground_slc",
        Kind.HAND,
        worded("Wall 7 × 0.83 m at SLC"),
        "Circolare 7/2019, C8.7.1.2.1.6, C8.7.1.11, C8.7.1.12",
        slc(),
        'd_"SLC" = 0.60 d_0, quad T_"SLC" = 1.56 pi sqrt(d_"SLC"/a(d_"SLC")), quad S_"De" = S_e T^2/(4 pi^2)',
        Asked({"height_m": 7.0, "thickness_m": 0.83}, None).sketch,
        worded("The wall of the first case: 60 % of d_0 and 10 % of damping."),
        Asked(
            {"height_m": 7.0, "thickness_m": 0.83, "mechanism": "two_sided", **NOT_FREE}, {**EN_B, "limit_state": "SLC"}
        ).table,
    ),
    Solved(
        "soil_c",
        Kind.HAND,
        worded("Three walls of a site on ground C"),
        "NTC 2018, 3.2.3.2.1, Tab. 3.2.IV; Circolare 7/2019, C8.7.1.2.1",
        (
            printed(
                ("S", ""), "1.32980", lambda: Asked({"height_m": 3.0, "thickness_m": 0.4}, NTC_C).demand.soil_factor
            ),
            *(answer for one in SOIL_C for answer in on_soil_c(*one)),
        ),
        "S = 1.70 - 0.60 F_0 a_g/g",
        Asked({"height_m": 12.5, "thickness_m": 0.90}, None).sketch,
        worded("a_g 0.261 g, F_0 2.364, T_C* 0.347 s; the displacement check with a_g,SLD where that is larger."),
    ),
    Solved(
        "free_period",
        Kind.CLOSED_FORM,
        worded("Period of an element free to vibrate"),
        "Circolare 7/2019, C8.7.1.7",
        tuple(free_period(*period) for period in FREE_PERIODS),
        "T_0 = 6.2 L/t L sqrt(w/(E g))",
        Asked({"height_m": 1.2, "thickness_m": 0.25}, None).sketch,
        worded("κ 6.2 of a cantilever; w is the unit weight. Beam theory has 6.190."),
    ),
    *(with_loads(*one) for one in LOADED),
    Solved(
        "free_fall",
        Kind.CLOSED_FORM,
        worded("Free fall of a wall with and without its roof"),
        "physics.md, 17",
        (free_fall((), "0.502143"), free_fall((ROOF,), "0.423486")),
        "T = integral_0^(theta_0) (dif theta)/sqrt(2 p^2 (V(theta_0) - V(theta))), quad V = a "
        "[cos(alpha - theta) - cos alpha] + c [sin alpha - sin(alpha - theta)]",
        loaded(ROOF).sketch,
        worded("The wall of the cases before from 0.06 rad at rest to its base; the integral by quadrature."),
    ),
    Solved(
        "two_sided_loads",
        Kind.HAND,
        worded("The weaker side of a wall that turns both ways"),
        "Circolare 7/2019, C8.7.1.1",
        (
            Answer(
                worded("α_0 outward"),
                "",
                (24.3 * 0.225 + 10.0 * 0.30) / 36.45,
                1e-9,
                lambda: sum_chain(loaded(ROOF, mechanism="two_sided").wall.in_si, False).alpha0,
            ),
            Answer(
                worded("α_0 of the weaker side"),
                "",
                (24.3 * 0.225 + 10.0 * 0.15) / 36.45,
                1e-9,
                lambda: sum_chain(loaded(ROOF, mechanism="two_sided").wall.in_si, True).alpha0,
            ),
        ),
        "alpha_0 = (W t\\/2 + N d)/(W H\\/2)",
        loaded(ROOF).sketch,
        worded("A load at 0.30 m of 0.45 m holds the outer hinge more than the inner one."),
        loaded(ROOF, mechanism="two_sided").table,
    ),
    Solved(
        "friction",
        Kind.HAND,
        worded("Friction of a return wall"),
        "Circolare 7/2019, C8.7.1.2",
        (
            printed(
                ("F", "kN"),
                "16.202",
                lambda: 1e-3 * float(return_wall_friction(loaded(return_walls=ACROSS, length_m=5.0).wall.in_si, 3.0)),
            ),
        ),
        "F = 0.4 n (n + 1) phi mu l^2 t_s w, quad phi = h_b\\/l",
        Asked({"height_m": 3.0, "thickness_m": 0.45}, None).sketch,
        worded("12 courses of 0.25 m, bricks of 0.20 m, 0.5 m thick, μ 0.577, 18 kN/m³."),
    ),
    Solved(
        "church_facade",
        Kind.HAND,
        worded("A church facade of L'Aquila"),
        "Circolare 7/2019, C8.7.1.1-C8.7.1.8",
        church(),
        "alpha_0 = (W (t\\/2 - u) + N (d - u) - F h)/(W H\\/2 + N h), quad zeta = (2 a_0^*)/(a_g S)",
        CHURCH.sketch,
        worded(
            "11.0 × 0.90 m, hinge u = 0.04 m inside the edge, roof 9 kN/m whose mass pushes, thrust 1.2 "
            "kN/m at 10.6 m; a_g 0.29977 g, ground B."
        ),
        CHURCH.table,
    ),
    Solved(
        "shipped_facade",
        Kind.HAND,
        worded("A facade with gable, portal and rose window"),
        "Circolare 7/2019, C8.7.1.1-C8.7.1.8",
        facade(),
        'alpha_0 = x_G/z_G, quad M^* = w/g A t/L, quad zeta = (2 alpha_0)/("FC" thin a_g S)',
        Sketch(
            ((0.0, 0.0), (10.0, 0.0), (10.0, 8.0), (5.0, 11.0), (0.0, 8.0)),
            others=(
                ((4.0, 0.0), (6.0, 0.0), (6.0, 3.5), (4.0, 3.5)),
                tuple(
                    (5.0 + 1.2 * math.cos(k * math.pi / 8.0), 6.5 + 1.2 * math.sin(k * math.pi / 8.0))
                    for k in range(16)
                ),
            ),
        ),
        worded("Elevation of 10 × 8 m and a gable of 3 m, 0.90 m thick, areas and moments of the figures by hand."),
        shipped="facade",
    ),
)
