"""Which quantities a wall has, with the values the program found: what the sheet Check and the note write.

The descriptions are those of body.py and checks.py; the numbers are those of core/codes and core/wall, an independent
way to the same values (tests/core/derivation).
"""

import math

from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.kinematic import PERIOD_FACTOR, STATE_DAMPING, Displacement
from core.codes.kinematic_chain import sum_chain_of_side
from core.codes.risk import EXPONENT, exponent_by_ag
from core.codes.target_spectrum import CodeSpectrum
from core.derivation import arch, bending, body, checks
from core.derivation.geometry import forces_at_limit, governing_side, shown_block
from core.derivation.line import FULL, INPUT, LIVE, NOT, RUN, SYMBOLS, VALUE, Columns, Line, Section, Word
from core.derivation.quantity import Given
from core.known import require_value
from core.study.results import StudyResult, WallResult
from core.units import G
from core.wall.masonry import inner_of
from core.wall.wall_loads import start_moments


def sides_agree(wall: WallResult) -> bool:
    """Whether the side that lifts first is the one whose d_0 is the smaller one, so that it is of the same formulas."""
    asked = wall.mechanics.wall
    return sum_chain_of_side(asked, governing_side(wall)).d0 == wall.mechanics.d0


def chain(wall: WallResult) -> Section:
    """Section of the start of the motion: alpha_0, e*, M*, a_0*."""
    kinematic, asked = wall.mechanics, wall.mechanics.wall
    sums, where = kinematic.chain, "about the outer hinge"
    lines: list[Line | Columns] = []
    if sums.bending is not None:
        lines = [*(arch.chain(wall) if asked.arch else bending.chain(wall))]
    elif asked.loads:
        where = where if governing_side(wall) > 0.0 else "about the inner hinge"
        moments = start_moments(asked, governing_side(wall))
        parts = (checks.wx, checks.nd, checks.fh, checks.th, checks.wy, checks.qh)
        tied = bool(asked.ties)
        pairs = zip(parts, moments, strict=True)
        lines = [Line(of, 1e-3 * moment) for of, moment in pairs if tied or of is not checks.th]
        if tied:
            lines.append(Line(checks.alpha0_bare, sums.alpha0_bare, LIVE, FULL, "without its ties"))
            lines.append(Line(checks.alpha0_with_ties, sums.alpha0, LIVE, FULL, where))
        else:
            lines.append(Line(checks.alpha0_with_loads, sums.alpha0, LIVE, FULL, where))
        lines.append(Line(checks.e_star_with_loads, sums.e_star, LIVE, SYMBOLS))
    else:
        alpha0 = checks.alpha0
        if asked.parts:
            pass
        elif asked.height and asked.setback:
            alpha0 = checks.alpha0_with_setback
        elif asked.height and wall.wall.slenderness_deg is None:
            alpha0 = checks.alpha0_of_sizes
        lines.append(Line(alpha0, sums.alpha0, note=FULL))
        lines.append(Line(checks.E_STAR, sums.e_star, RUN, VALUE, "one block, no other mass pushes it"))
    mass, m_star, a0_star, of_part = sums.mass, checks.m_star, checks.a0_star, ""
    if sums.alpha0_friction is not None:
        mass, m_star, a0_star, of_part = (
            sums.mass_friction, checks.m_star_with_friction, checks.a0_star_with_friction, "of that part")  # fmt: off
        label, words = "with the friction of the return walls, of the upper {h:.2f} m", {"h": sums.friction_height}
        lines.append(Line(checks.ALPHA0_FRICTION, sums.alpha0_friction, RUN, VALUE, label, words=words))
        lines.append(Line(checks.E_STAR_FRICTION, sums.e_star_friction, RUN, VALUE, of_part))
    if kinematic.m_star is not None:
        lines.append(Line(checks.MASS, mass, RUN))
        of_2009 = "participating mass, a quantity of the Circolare of 2009"
        lines.append(Line(m_star, kinematic.m_star, LIVE, FULL, of_part or of_2009))
    lines.append(Line(a0_star, kinematic.a0 / G, LIVE, FULL, of_part))
    return Section("Kinematic chain", lines)


def linear(result: StudyResult, wall: WallResult) -> Section:
    """Linear check: zeta_SLD = a_g,SLD / a_g, and q zeta_SLD."""
    kinematic, demand = wall.mechanics, result.demand_required
    if kinematic.zeta_sld is None:
        return Section("Linear check", [])
    lines, zeta_sld = _demand_at(wall), checks.zeta_sld
    against = Line(Given("demand_pga", "S a_g", "g", 3, clause="C8.7.1.8"), demand.pga / G, RUN, VALUE)
    if kinematic.free_element:
        zeta_sld = checks.zeta_sld_of_free_element
        lines += _free(wall, demand.target if isinstance(demand.target, CodeSpectrum) else None)
    elif kinematic.floor:
        zeta_sld = checks.zeta_sld_on_floor
    else:
        lines.append(against)
    sld = next((check for check in wall.required_assessment.checks if check.label == "linear_sld"), None)
    lines.append(Line(zeta_sld, kinematic.zeta_sld, note=FULL, passed=sld.passed if sld else None))
    for check in wall.required_assessment.checks:
        if not check.name.startswith("linear") or check is sld or check.zeta is None:
            continue
        if check.name == "linear_q_slv":
            q = _q_slv(wall)
            words = {"check": Word(check.label)}
            lower = "of each record the lower of q_SLV,min and q_SLV,rob, times e*"
            lines += [Line(checks.Q_SLV, wall.q_slv_set, RUN), Line(checks.Q_SLV_LOW, wall.q_slv_low_set, RUN)]
            if wall.q_slv_robust_set is not None:
                lines.append(Line(checks.Q_SLV_ROBUST, wall.q_slv_robust_set, RUN))
            lines.append(Line(checks.Q_SLV_SAFE, wall.q_slv_safe_set, RUN))
            lines.append(Line(q, check.q, LIVE, FULL, lower, "q: {check}", words))
            zeta = checks.linear_q_slv_zeta
        else:
            words = {"check": Word(check.label)}
            lines.append(Line(getattr(checks, check.name), check.q, title="q: {check}", words=words))
            zeta = getattr(checks, f"{check.name}_zeta")
        lines.append(_zeta(zeta, check))
    return Section("Linear check", lines)


def _q_slv(wall: WallResult):
    """How q SLV is counted: from the uplift of the wall without its ties and without friction."""
    friction = wall.mechanics.chain.alpha0_friction is not None
    if wall.wall.ties:
        return checks.linear_q_slv_with_ties_and_friction if friction else checks.linear_q_slv_with_ties
    return checks.linear_q_slv_with_friction if friction else checks.linear_q_slv


def _zeta(of, check) -> Line:
    """Line of zeta of a check, with its outcome."""
    label = Word(check.label)
    return Line(of, check.zeta, LIVE, FULL, label, "ζ: {check}", {"check": label}, passed=check.passed)


def _demand_at(wall: WallResult) -> list[Line | Columns]:
    """Lines of the demand above the ground: the modes of the building and a_Z; none on the ground."""
    kinematic = wall.mechanics
    if not kinematic.floor:
        return []
    rows = []
    for k, mode in enumerate(kinematic.floor.modes, start=1):
        elastic = float(kinematic.floor.ground.acceleration([mode.period], mode.damping)[0]) / G
        rows.append((str(k), (mode.period, mode.damping, mode.participation, elastic)))
    modes = Columns("Mode", checks.MODES, ("s", "–", "–", "g"), rows, RUN)
    return [modes, Line(checks.a_z, kinematic.floor.a_z / G, note=NOT if kinematic.free_element else VALUE)]


def _free(wall: WallResult, target: CodeSpectrum | None) -> list[Line | Columns]:
    """Lines of T_0 and S_e(T_0) of an element free to vibrate."""
    kinematic, asked = wall.mechanics, wall.wall
    lines: list[Line | Columns] = [Line(checks.MODULUS, asked.elastic_modulus_mpa, INPUT)]
    if asked.parts:
        note = "of the section at the base, by Rayleigh's quotient over the mass of the body"
        lines.append(Line(checks.T0_GIVEN, kinematic.period_0, RUN, VALUE, note))
    elif asked.is_loaded:
        lines.append(Line(checks.period_0_with_loads, kinematic.period_0, note=SYMBOLS))
    else:
        lines.append(Line(body.UNIT_WEIGHT, asked.unit_weight_kn_m3, INPUT))
        sizes = asked.slenderness_deg is None or asked.setback
        lines.append(Line(checks.period_0 if sizes else checks.period_0_of_slenderness, kinematic.period_0, note=FULL))
    elastic = require_value(kinematic.acceleration_demand) / G
    if kinematic.floor:
        return [*lines, Line(checks.SEZ_T0_GIVEN, elastic, RUN, VALUE)]
    if target is not None:
        branch = checks.SE_BRANCHES[_branch(target, require_value(kinematic.period_0))]
        return [*lines, Line(checks.se_t0, elastic, note=FULL, shown_by=branch)]
    return [*lines, Line(checks.SE_T0_GIVEN, elastic, RUN, VALUE)]


def _branch(target: CodeSpectrum, period: float) -> int:
    """Which branch of the spectrum of a code holds a period [s], from 0."""
    return sum(period >= end for end in (target.t_b, target.t_c, target.t_d))


def displacement(result: StudyResult, wall: WallResult) -> Section:
    """Section of the displacement check: d_limit against S_De."""
    kinematic, state = wall.mechanics, result.demand_required.limit_state
    check = next((one for one in wall.required_assessment.checks if one.name == "nonlinear"), None)
    title = "Displacement check"
    if check is None:
        return Section(title, [])
    damping = 100.0 * STATE_DAMPING[state]
    constants = {"share": LIMIT_FRACTION[state], "factor": PERIOD_FACTOR[state] / math.pi, "damping": damping}
    if kinematic.chain.bending is not None:
        d0 = arch.collapse(wall) if wall.mechanics.wall.arch else bending.collapse(wall)
    elif not wall.wall.is_loaded:
        d0 = [Line(checks.d0, kinematic.d0, note=FULL)]
    elif sides_agree(wall):
        d0 = [_centroid_at_collapse(wall), Line(checks.d0_with_loads, kinematic.d0, note=SYMBOLS)]
    else:
        d0 = [Line(checks.D0_GIVEN, kinematic.d0, RUN, VALUE)]
    largest = "largest, T_0 to T_{state}"
    if kinematic.floor:
        s_de = Line(checks.S_DEZ_GIVEN, kinematic.s_de, RUN, VALUE, largest)
    elif isinstance(result.demand_required.target, CodeSpectrum):
        branch = checks.S_DE_BRANCHES[_branch(result.demand_required.target, require_value(kinematic.period))]
        s_de = Line(checks.s_de, kinematic.s_de, LIVE, FULL, largest, shown_by=branch)
    else:
        s_de = Line(checks.S_DE_GIVEN, kinematic.s_de, RUN, VALUE, largest)
    ties, of_ties = kinematic.chain.ties, list[Line]()
    d_limit, a_limit = Line(checks.d_limit, kinematic.d_limit, note=FULL), checks.a_limit
    if ties:
        d0 += [
            Line(checks.D0_WITH_TIES, kinematic.chain.d0_with_ties, RUN, VALUE, "not taken: a tie yields and breaks")
        ]
        a_limit = checks.a_limit_with_ties
        held = sum(f * tie.bar.height for f, tie in zip(forces_at_limit(wall), wall.wall.in_si.ties, strict=True))
        of_ties = [Line(checks.th_limit, held, LIVE, SYMBOLS)]
    if kinematic.chain.bending is not None:
        plain = require_value(kinematic.moved.bending).strip.is_plain
        of_ties, a_limit = bending.at_limit(wall), bending.a_limit if plain else bending.a_limit_of_blocks
    if require_value(kinematic.d_limit) < LIMIT_FRACTION[state] * kinematic.d0 * (1.0 - 1e-12):
        d_limit = Line(checks.D_BREAK, kinematic.d_limit, RUN, VALUE, "where a tie breaks")
    lines: list[Line | Columns] = [
        *d0,
        d_limit,
        *of_ties,
        Line(a_limit, kinematic.a_limit, note=FULL),
        Line(checks.period, kinematic.period, note=FULL),
        s_de,
    ]
    zeta, at_slv, bare = checks.nonlinear_zeta, checks.nonlinear_zeta_at_slv, kinematic.without_ties
    floored = state == "SLV" and kinematic.zeta_floor is not None
    if floored or bare is not None:
        lines.append(
            Line(checks.displacement_ratio, require_value(kinematic.d_limit) / require_value(kinematic.s_de), note=FULL)
        )
    if bare is not None:
        zeta, at_slv = checks.nonlinear_zeta_of_ties, checks.nonlinear_zeta_of_ties_at_slv
        lines += _without_ties(bare, s_de)
    if floored:
        lines += _floor(wall)
        zeta = at_slv
    return Section(title, [*lines, _zeta(zeta, check)], constants)


def _floor(wall: WallResult) -> list[Line]:
    """Lines of a_g,SLD, below which a_g,SLV of the displacement check is not: without what has to stretch or slip."""
    kinematic, lines = wall.mechanics, list[Line]()
    friction = kinematic.chain.alpha0_friction is not None
    tied = bool(wall.wall.ties)
    if kinematic.wall.arch is not None and kinematic.wall.arch.tied:
        tied, alone = True, kinematic.chain.alpha0_bare
        lines.append(Line(arch.ALPHA0_BARE, alone, RUN, VALUE, "before its ties are stretched"))
    floor = checks.zeta_floor_with_friction if friction else checks.zeta_floor
    if tied:
        floor = checks.zeta_floor_with_ties_and_friction if friction else checks.zeta_floor_with_ties
    note = VALUE if friction or tied else NOT
    return [*lines, Line(floor, kinematic.zeta_floor, LIVE, note, "not below a_g,SLD")]


def _without_ties(bare: Displacement, s_de: Line) -> list[Line]:
    """Lines of the displacement check of the wall without its ties. s_de : the line of the demand with them"""
    note, live = "without its ties", s_de.of is checks.s_de
    demand = checks.s_de_bare if live else checks.S_DE_BARE_GIVEN
    return [
        Line(checks.d_limit_bare, bare.limit),
        Line(checks.a_limit_bare, bare.capacity),
        Line(checks.period_bare, bare.period),
        Line(demand, bare.demand, LIVE if live else RUN),
        Line(checks.displacement_ratio_bare, bare.ratio, LIVE, VALUE, note),
    ]


def dynamic(wall: WallResult) -> Section:
    """Section of the dynamic check by time histories."""
    check, title = wall.required_assessment.dynamic, "Time histories"
    if check is None:
        return Section(title, [])
    rule = "mean of the peaks" if check.set_rule == "mean" else "largest peak"
    peak = check.peak_ratio
    on = Word(f"confidence_{check.confidence_on}")
    lines: list[Line | Columns] = [
        Line(checks.PEAK, Word("overturned") if peak is None else peak, RUN, VALUE, rule),
        Line(checks.LIMIT, check.limit_ratio, RUN, VALUE, "limit"),
        Line(checks.EXCEEDED, f"{check.n_exceeded} / {len(check.runs)}", RUN, VALUE, "runs beyond θc"),
        Line(checks.DYNAMIC_ZETA, check.zeta, RUN, VALUE, on),
        Line(checks.ZETA_16, check.zeta_16, RUN),
    ]
    if check.zeta_other is not None:
        other = Word(f"confidence_{check.zeta_other.confidence_on}")
        words = {"on": other}
        lines.append(Line(checks.ZETA_OTHER, check.zeta_other.zeta, RUN, VALUE, other, "ζ_E, {on}", words))
    return Section(title, lines)


def hold(wall: WallResult) -> Section:
    """Section of what holds a wall that bends."""
    title = "What holds the wall"
    check = next((check for check in wall.required_assessment.checks if check.name == "hold"), None)
    if check is None:
        return Section(title, [])
    lines: list[Line | Columns] = [
        Line(checks.HOLD_ASKED, check.demand, RUN, VALUE),
        Line(checks.HOLD_STANDS, check.capacity, RUN, VALUE),
        Line(checks.HOLD_ZETA, check.zeta, RUN, VALUE, passed=check.passed),
    ]
    return Section(title, lines)


def _centroid_at_collapse(wall: WallResult) -> Line:
    """Displacement of the centroid where nothing holds the wall any more."""
    bare, model = wall.wall.in_si.bare, wall.model
    restoring = model.restoring
    if governing_side(wall) < 0.0:
        bare, restoring = inner_of(wall.wall.in_si, bare) or bare, model.mirrored
    turned = bare.slenderness - (shown_block(wall).slenderness + restoring.lean)
    return Line(checks.d_c, bare.radius * (math.sin(bare.slenderness) - math.sin(turned)), note=SYMBOLS)


def risk(result: StudyResult, wall: WallResult) -> Section:
    """PGA_C, T_R,C by both exponents, IS-V of this mechanism, from the zeta of the check that decides: of histories it
    is that of the run, and so are the demand and T_R."""
    capacity, demand, title = wall.required_assessment.risk, result.demand_required, "What the mechanism withstands"
    if capacity is None:
        return Section(title, [])
    of_histories = wall.required_assessment.verdict.governing == "dynamic"
    other = {"zeta": deciding(wall, demand), "demand_pga": "demand_pga_run" if of_histories else "demand_pga"}
    note = "of the run" if of_histories else ""
    lines: list[Line | Columns] = [Line(checks.pga_c, capacity.pga / G, LIVE, FULL, note, other=other)]
    constants = {}
    if capacity.years is not None:
        title_of_row = "T_R,C by the hazard of the site" if capacity.by_hazard else ""
        lines.append(Line(Given("tr_c_years", "T_R,C", "{years}"), capacity.years, RUN, VALUE, title=title_of_row))
    if capacity.return_period is not None and not capacity.by_hazard:
        tr_d = Given("tr_d", "T_R,D", "{years}", 0, "0.00")
        lines.append(Line(tr_d, demand.return_period, RUN if of_histories else INPUT))
        constants = {"eta_italy": EXPONENT, "eta_site": exponent_by_ag(demand.ag)}
        lines.append(Line(checks.tr_c, capacity.return_period, other=other))
        lines.append(Line(checks.tr_c_longer, capacity.other_return_period, other=other))
    if capacity.index is not None:
        label, words = "of this mechanism, class {letter}", {"letter": capacity.letter}
        lines.append(Line(checks.is_v, capacity.index, LIVE, VALUE, label, words=words, other=other))
    return Section(title, lines, constants)


def deciding(wall: WallResult, demand) -> str:
    """Name of the zeta of the check that decides."""
    governing = wall.required_assessment.verdict.governing
    return "zeta_sld" if demand.limit_state == "SLD" and governing == "linear_q_code" else f"{governing}_zeta"


def checks_of(result: StudyResult, wall: WallResult) -> list[Section]:
    """The sections of a wall after its block."""
    return [chain(wall), *sections_by_check(result, wall).values(), risk(result, wall)]


def sections_by_check(result: StudyResult, wall: WallResult) -> dict[str, Section]:
    """How the name of a check begins -> its section."""
    return {
        "linear": linear(result, wall),
        "nonlinear": displacement(result, wall),
        "dynamic": dynamic(wall),
        "hold": hold(wall),
    }
