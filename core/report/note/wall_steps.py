"""Derivations of one wall in the form of an Italian note, as "α0 = t/H = 0.90/12.50 = 0.0720".

The values are those of the result; each step names the cell of the sheet Check that has the same as a live formula.
"""

import math
from functools import partial

from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.kinematic import CANTILEVER, DAMPING, PERIOD_FACTOR
from core.report.load_rows import governing_side, moments
from core.report.note.parts import Step
from core.report.note.words import Words
from core.study.results import StudyResult, WallResult
from core.units import G
from core.wall import wall_loads
from core.wall.restitution import MODELS


def geometry(wall: WallResult, name: str, words: Words) -> list[Step]:
    """The block: slenderness, radius, frequency parameter, velocity ratio, uplift."""
    block, asked = wall.block, wall.wall
    degrees, h, t, u = math.degrees(block.slenderness), wall.height, wall.thickness, asked.setback
    sizes = {"t": (t, f"{name}_thickness"), "h": (h, f"{name}_height"), "u": (u, f"{name}_setback")}
    alpha = partial(Step, "α", degrees, ".2f", "°", words.say("paper, Fig. 1"), cell=f"{name}_slenderness")
    steps = []
    if asked.load:
        weight = 1e-3 * wall_loads.weight_per_metre(asked)
        values = {**sizes, "w": (asked.unit_weight_kn_m3, f"{name}_weight")}
        steps.append(Step("W", weight, ".2f", "kN/m", "", "w t H", "{w:.1f} · {t:.3f} · {h:.2f}", values, f"{name}_w"))
        steps.append(alpha(label=words.say("of the wall with the masses that move with it")))
    elif asked.height_m and u:
        numbers = "arctan[({t:.3f} − 2 · {u:.4f})/{h:.2f}]"
        steps.append(alpha(formula="arctan[(t − 2u)/H]", numbers=numbers, values=sizes))
    elif asked.height_m and asked.slenderness_deg is None:
        numbers = "arctan({t:.3f}/{h:.2f})"
        steps.append(alpha(formula="arctan(t/H)", numbers=numbers, values=sizes))
    else:
        steps.append(alpha(label=words.say("as given")))
    steps.append(Step("R", block.radius, ".3f", "m", words.say("paper, Fig. 1"), cell=f"{name}_radius"))
    p = f"{name}_p"
    if block.is_rectangle:
        values = {"g": (G, "gravity"), "r": (block.radius, f"{name}_radius")}
        steps.append(
            Step(
                "p",
                block.frequency_parameter,
                ".3f",
                "rad/s",
                "Eq. 1",
                "√(3 g/(4 R))",
                "√(3 · {g:.2f}/(4 · {r:.3f}))",
                values,
                p,
            )
        )
    else:
        steps.append(Step("p", block.frequency_parameter, ".3f", "rad/s", "Eq. 1", "√(m g R/I_0)", cell=p))
    steps.append(
        Step(
            "e",
            wall.restitution.ratio_at_rest,
            ".3f",
            "–",
            "",
            cell=f"{name}_velocity_ratio",
            label=words.say("velocity ratio of an impact: {model}", model=_source(wall, words)),
        )
    )
    steps.append(
        Step(
            "a_RM",
            wall.model.threshold / G,
            ".3f",
            "g",
            "Eq. 2",
            cell=f"{name}_a_rm",
            label=words.say("acceleration that lifts the wall"),
        )
    )
    return steps


def _source(wall: WallResult, words: Words) -> str:
    """Where the velocity ratio comes from."""
    model = wall.restitution.model
    if model == "user":
        return words.say("given")
    if wall_loads.contact_of(wall.wall):
        return words.say("{equation}, impacts of the wall with what moves with it", equation=MODELS[model])
    return MODELS[model]


def start(result: StudyResult, wall: WallResult, name: str, words: Words) -> list[Step]:
    """The kinematic chain: alpha_0, e*, M*, a_0*."""
    kinematic, demand = wall.assessment.kinematic, result.demand
    sums, block = kinematic.chain, wall.block
    cell, share = f"{name}_alpha0", f"{name}_e_star"
    if wall.wall.load:
        values = {key: (1e-3 * value, f"{name}_{key}") for key, value in moments(wall).items()}
        where = words.say("about the outer hinge") if governing_side(wall) > 0.0 else words.say("about the inner hinge")
        steps = [
            Step(
                "α0",
                sums.alpha0,
                ".4f",
                "–",
                "C8.7.1.1",
                "(W x + ΣN d + ΣF h)/(W y + ΣQ h)",
                "({wx:.2f} + {nd:.2f} + {fh:.2f})/({wy:.2f} + {qh:.2f})",
                values,
                cell,
                where,
            )
        ]
        steps.append(
            Step("e*", sums.e_star, ".3f", "–", "C8.7.1.5", "(W y + ΣQ h)²/[(W + ΣQ)(W y² + ΣQ h²)]", cell=share)
        )
    else:
        values = {
            "t": (wall.thickness, f"{name}_thickness"),
            "h": (wall.height, f"{name}_height"),
            "u": (wall.wall.setback, f"{name}_setback"),
            "alpha": (math.degrees(block.slenderness), f"{name}_slenderness"),
        }
        formula, numbers = "tan α", "tan {alpha:.2f}°"
        if wall.wall.height_m and wall.wall.setback:
            formula, numbers = "(t − 2u)/H", "({t:.3f} − 2 · {u:.4f})/{h:.2f}"
        elif wall.wall.height_m and wall.wall.slenderness_deg is None:
            formula, numbers = "t/H", "{t:.3f}/{h:.2f}"
        steps = [
            Step("α0", sums.alpha0, ".4f", "–", "C8.7.1.1", formula, numbers, values, cell),
            Step(
                "e*",
                sums.e_star,
                ".3f",
                "–",
                "C8.7.1.5",
                cell=share,
                label=words.say("one block, no other mass pushes it"),
            ),
        ]
    alpha0, e_star, mass, of = (sums.alpha0, cell), (sums.e_star, share), sums.mass, ""
    if sums.alpha0_friction is not None:
        cell, share = f"{name}_alpha0_friction", f"{name}_e_star_friction"
        alpha0, e_star = (sums.alpha0_friction, cell), (sums.e_star_friction, share)
        mass, of = sums.mass_friction, words.say("of that part")
        where = words.say("with the friction of the return walls, of the upper {h:.2f} m", h=sums.friction_height)
        steps.append(Step("α0", sums.alpha0_friction, ".4f", "–", "C8.7.1.1", cell=cell, label=where))
        steps.append(Step("e*", sums.e_star_friction, ".3f", "–", "C8.7.1.5", cell=share, label=of))
    if kinematic.m_star is not None:
        values = {"e": e_star, "m": (mass, None)}
        steps.append(
            Step(
                "M*",
                kinematic.m_star,
                ".0f",
                "kg/m",
                "C8.7.1.4",
                "e* Σ(P + Q)/g",
                "{e:.3f} · {m:.0f}",
                values,
                f"{name}_m_star",
                of,
            )
        )
    values = {"a": alpha0, "e": e_star, "fc": (demand.confidence_factor, "demand_fc")}
    steps.append(
        Step(
            "a_0*",
            kinematic.a0 / G,
            ".4f",
            "g",
            "C8.7.1.3",
            "α0/(e* FC)",
            "{a:.4f}/({e:.3f} · {fc:.2f})",
            values,
            f"{name}_a0_star",
            of,
        )
    )
    if kinematic.period_0 is not None:
        asked = wall.wall
        values = {
            "h": (wall.height, f"{name}_height"),
            "t": (wall.thickness, f"{name}_thickness"),
            "w": (asked.unit_weight_kn_m3, f"{name}_weight"),
            "e": (asked.elastic_modulus_mpa, f"{name}_modulus"),
            "k": (CANTILEVER, None),
            "g": (G, "gravity"),
        }
        formula = "κ (H/t) H √(w/(E g))"
        numbers = "{k:.1f} · ({h:.2f}/{t:.3f}) · {h:.2f} · √({w:.1f}/({e:.0f} · 10³ · {g:.2f}))"
        if asked.load:
            formula, numbers = "√(κ² (H/t)² H² w/(E g) + Σ 4π² m h³/(3 E I))", ""
        steps.append(
            Step("T_0", kinematic.period_0, ".3f", "s", "C8.7.1.7", formula, numbers, values, f"{name}_period_0")
        )
    return steps


def linear(result: StudyResult, wall: WallResult, name: str, words: Words) -> list[Step]:
    """The linear check: a_g,SLD over a_g, times q."""
    kinematic = wall.assessment.kinematic
    if kinematic.zeta_sld is None:
        return []
    a0 = (kinematic.a0 / G, f"{name}_a0_star")
    asked = kinematic.acceleration_demand / G
    if kinematic.free_element:
        symbol, cell, clause = "S_e(T_0, 5 %)", f"{name}_se_t0", "C8.7.1.9"
    elif kinematic.floor:
        symbol, cell, clause = "a_Z", f"{name}_a_z", "C7.2.8"
    else:
        symbol, cell, clause = "S a_g", "demand_pga", "C8.7.1.8"
    steps = [Step(symbol, asked, ".3f", "g", clause, cell=cell)]
    if kinematic.floor and not kinematic.free_element:
        steps[0] = Step("max(a_Z, S a_g)", asked, ".3f", "g", clause)
        symbol, cell = "max(a_Z, S a_g)", None
    # no cell, no live text: a number that stands still beside one that moves would contradict it
    numbers = "{a:.4f}/{s:.3f}" if cell else ""
    steps.append(
        Step(
            "a_g,SLD/a_g",
            kinematic.zeta_sld,
            ".3f",
            "–",
            "C8.7.1.2.1.5",
            "a_0*/" + symbol,
            numbers,
            {"a": a0, "s": (asked, cell)},
            f"{name}_zeta_sld",
        )
    )
    for check in wall.assessment.checks:
        if not check.name.startswith("linear") or check.label == "linear_sld" or check.zeta is None:
            continue
        values = {"q": (check.q, f"{name}_{check.name}"), "z": (kinematic.zeta_sld, f"{name}_zeta_sld")}
        label = words.word(check.label)
        if check.name == "linear_q_slv":
            low, sums = wall.q_slv_low_set, kinematic.chain
            bare = sums.alpha0_friction is None
            cell = f"{name}_e_star" if bare else f"{name}_e_star_friction"
            factors = {"l": (low, f"{name}_q_slv_low"), "e": (kinematic.e_star, cell)}
            symbols, numbers = "q_SLV,min e*", "{l:.3f} · {e:.3f}"
            if not bare and sums.alpha0_friction > sums.alpha0:  # no friction in the histories
                factors |= {
                    "a": (sums.alpha0, f"{name}_alpha0"),
                    "f": (sums.alpha0_friction, f"{name}_alpha0_friction"),
                }
                symbols, numbers = symbols + " α0/α0,f", numbers + " · {a:.4f}/{f:.4f}"
            lower = words.say("lower end of the spread of q SLV, {q:.2f}, times e*", q=wall.q_slv_set)
            steps.append(
                Step("q", check.q, ".3f", "–", "C8.7.1.5", symbols, numbers, factors, f"{name}_linear_q_slv", lower)
            )
        steps.append(
            Step(
                "ζ",
                check.zeta,
                ".3f",
                "–",
                check.clause,
                "q a_g,SLD/a_g",
                "{q:.2f} · {z:.3f}",
                values,
                f"{name}_{check.name}_zeta",
                label,
            )
        )
    return steps


def nonlinear(result: StudyResult, wall: WallResult, name: str, words: Words) -> list[Step]:
    """The displacement check."""
    kinematic, state = wall.assessment.kinematic, result.demand.limit_state
    check = next((one for one in wall.assessment.checks if one.name == "nonlinear"), None)
    if check is None:
        return []
    share = LIMIT_FRACTION[state]
    d0, d = (kinematic.d0, f"{name}_d0"), (kinematic.d_limit, f"{name}_d_limit")
    a, s = (kinematic.a_limit, f"{name}_a_limit"), (kinematic.s_de, f"{name}_s_de")
    factor = PERIOD_FACTOR[state] / math.pi
    part, times = words.number(share, ".2f"), words.number(factor, ".2f")
    damping = f"{100.0 * DAMPING[state]:g}"
    own = "" if wall.wall.load else "R sin α"
    values = {
        "r": (wall.block.radius, f"{name}_radius"),
        "a": (math.degrees(wall.block.slenderness), f"{name}_slenderness"),
    }
    numbers = "{r:.3f} · sin {a:.2f}°" if own else ""
    steps = [
        Step("d_0", kinematic.d0, ".4f", "m", "C8.7.1.4", own, numbers, values, d0[1]),
        Step(
            f"d_{state}",
            kinematic.d_limit,
            ".4f",
            "m",
            "C8.7.1.2.1.6",
            f"{part} d_0",
            part + " · {d:.4f}",
            {"d": d0},
            d[1],
        ),
        Step(f"a(d_{state})", kinematic.a_limit, ".3f", "m/s²", "C8.7.1.3", cell=a[1]),
        Step(
            f"T_{state}",
            kinematic.period,
            ".3f",
            "s",
            "C8.7.1.10" if state == "SLV" else "C8.7.1.11",
            f"{times} π √(d_{state}/a)",
            times + " π √({d:.4f}/{a:.3f})",
            {"d": d, "a": a},
            f"{name}_period",
        ),
        Step(
            f"S_De({damping} %)",
            kinematic.s_de,
            ".4f",
            "m",
            "C8.7.1.12",
            cell=s[1],
            label=words.say("largest between T_0 and T_{state}", state=state),
        ),
    ]
    by_floor = kinematic.zeta_floor is not None and check.zeta > kinematic.d_limit / kinematic.s_de
    if state == "SLV" and by_floor:
        steps.append(
            Step(
                "ζ",
                check.zeta,
                ".3f",
                "–",
                "C8.7.1.2.1.8",
                "a_g,SLD/a_g",
                cell=f"{name}_nonlinear_zeta",
                label=words.say("not below a_g,SLD"),
            )
        )
    else:
        steps.append(
            Step(
                "ζ",
                check.zeta,
                ".3f",
                "–",
                "C8.7.1.2.1.8",
                f"d_{state}/S_De",
                "{d:.4f}/{s:.4f}",
                {"d": d, "s": s},
                f"{name}_nonlinear_zeta",
            )
        )
    return steps


def dynamic(wall: WallResult, name: str, words: Words) -> list[Step]:
    """The time histories."""
    check = wall.assessment.dynamic
    if check is None:
        return []
    rule = words.say("mean of the peaks") if check.set_rule == "mean" else words.say("largest peak")
    peak = words.word("overturned") if check.peak_ratio is None else check.peak_ratio
    steps = [
        Step("θmax/θc", peak, ".3f", "–", "C8.7.1.2.1.9", cell=f"{name}_peak", label=rule),
        Step(words.say("limit"), check.limit_ratio, ".2f", "–", "C8.7.1.2.1.9"),
        Step(words.say("runs beyond θc"), f"{check.n_exceeded} / {len(check.runs)}", "", "–"),
        Step(
            "ζ_E",
            check.zeta,
            ".3f",
            "–",
            "C8.7.1.2.1.9",
            cell=f"{name}_dynamic_zeta",
            label=words.word(f"confidence_{check.confidence_on}"),
        ),
    ]
    if check.zeta_other is not None:
        other = check.zeta_other
        steps.append(Step("ζ_E", other.zeta, ".3f", "–", label=words.word(f"confidence_{other.confidence_on}")))
    return steps


def risk(result: StudyResult, wall: WallResult, words: Words) -> list[Step]:
    """What the mechanism withstands: of the run, for the zeta of histories moves with no cell."""
    found, demand = wall.assessment.risk, result.demand
    if found is None:
        return []
    values = {"z": (wall.assessment.verdict.zeta_e, None), "s": (demand.pga / G, None)}
    steps = [
        Step(
            "PGA_C",
            found.pga / G,
            ".3f",
            "g",
            "",
            "ζ S a_g",
            "{z:.3f} · {s:.3f}",
            values,
            label=words.say("of the run"),
        )
    ]
    if found.years is not None:
        steps.append(Step("T_R,C", found.years, "", words.say("years")))
    if found.index is not None:
        steps.append(
            Step(
                "IS-V",
                found.index,
                ".2f",
                "–",
                "D.M. 65/2017",
                label=words.say("of this mechanism, class {letter}", letter=found.letter),
            )
        )
    return steps
