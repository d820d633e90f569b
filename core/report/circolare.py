"""Live formulas of the Circolare's checks on the Check sheet: C8.7.1.2.1.7, .8 and .9."""

from core.capacity.limit_states import LIMIT_FRACTION
from core.codes.kinematic import CANTILEVER, DAMPING, PERIOD_FACTOR
from core.codes.risk import EXPONENT, exponent_by_ag
from core.codes.target_spectrum import CodeSpectrum
from core.report.cells import BAD, EXACT, GOOD, QUIET, RATIO, Book, style, text
from core.report.load_rows import MOMENTS, chain_formulas, moments, sides_agree
from core.report.rows import found_row, heads, input_row, live_row
from core.report.spectrum_rows import spectrum_shape
from core.study.results import StudyResult, WallResult
from core.text.sentence import word
from core.units import G


def wall_rows(book: Book, sheet, result: StudyResult, wall: WallResult, name: str, row: int) -> int:
    """Kinematic checks of one wall, linear and nonlinear, beside the program's values."""
    say, kinematic = book.say, wall.assessment.kinematic
    demand = result.demand
    kind = say("element free to vibrate") if kinematic.free_element else say("not free to vibrate")
    if kinematic.floor:
        label = say("Circolare 7/2019, wall at {z:g} m, {kind}", z=wall.wall.base_z_m, kind=kind)
    else:
        label = say("Circolare 7/2019, wall on the ground, {kind}", kind=kind)
    row = heads(book, sheet, row, label)
    sums, start = kinematic.chain, f"{name}_alpha0"
    if wall.wall.load:
        formulas = chain_formulas(book, name)
        for key, value in moments(wall).items():
            row = live_row(
                book, sheet, row, MOMENTS[key], "C8.7.1.1", formulas[key], 1e-3 * value, "kN", f"{name}_{key}", "0.00"
            )
        row = live_row(
            book,
            sheet,
            row,
            "α0 = (W x + ΣN d + ΣF h)/(W y + ΣQ h)",
            "C8.7.1.1",
            formulas["alpha0"],
            sums.alpha0,
            "–",
            start,
        )
        row = live_row(
            book,
            sheet,
            row,
            "e* = (W y + ΣQ h)²/[(W + ΣQ)(W y² + ΣQ h²)]",
            "C8.7.1.5",
            formulas["e_star"],
            sums.e_star,
            "–",
            f"{name}_e_star",
        )
    else:
        row = live_row(
            book, sheet, row, "α0 = tan α", "C8.7.1.1", f"=TAN(RADIANS({name}_slenderness))", sums.alpha0, "–", start
        )
        row = found_row(book, sheet, row, "e* (C8.7.1.5)", sums.e_star, "–", f"{name}_e_star", RATIO)
    if sums.alpha0_friction is not None:
        start = f"{name}_alpha0_friction"
        label = say("α0 with friction, top {h:.2f} m", h=sums.friction_height)
        row = found_row(book, sheet, row, label, sums.alpha0_friction, "–", start)
        share = f"{name}_e_star_friction"
        row = found_row(book, sheet, row, say("e* of that part"), sums.e_star_friction, "–", share)
        mass = say("M* per metre of that part")
    else:
        share, mass = f"{name}_e_star", say("M* per metre")
    row = live_row(
        book,
        sheet,
        row,
        "a0* = α0 g / (e* FC)",
        "C8.7.1.3",
        f"={start}/({share}*demand_fc)",
        kinematic.a0 / G,
        "g",
        f"{name}_a0_star",
    )
    if kinematic.m_star is not None:
        row = found_row(book, sheet, row, mass, kinematic.m_star, "kg/m", f"{name}_m_star", "0")
    row = _sld(book, sheet, wall, name, demand, row)
    for check in found_checks(wall, "linear_q_slv", "linear_q_code"):
        if check.label == "linear_sld":
            row = _outcome(book, sheet, row, f"{name}_zeta_sld", check)
            continue
        q = f"{name}_{check.name}"
        label = word(check.label, book.language)
        if check.name == "linear_q_code":
            row = live_row(book, sheet, row, f"q: {label}", "", "=code_q", check.q, "–", q)
        else:
            row = found_row(book, sheet, row, "q SLV", wall.q_slv_set, "–")
            row = found_row(
                book, sheet, row, say("lower end of the spread of q SLV"), wall.q_slv_low_set, "–", f"{name}_q_slv_low"
            )
            counted = f"{name}_q_slv_low*{share}"
            if kinematic.chain.alpha0_friction is not None:
                counted += f"*MIN(1,{name}_alpha0/{start})"
            row = live_row(book, sheet, row, f"q: {label}", "C8.7.1.5", f"={counted}", check.q, "–", q)
        row = live_row(
            book, sheet, row, f"ζ: {label}", check.clause, f"={q}*{name}_zeta_sld", check.zeta, "–", f"{q}_zeta"
        )
        row = _outcome(book, sheet, row, f"{q}_zeta", check)
    for check in found_checks(wall, "nonlinear"):
        row = _displacement(book, sheet, wall, name, demand, check, row)
    for check in found_checks(wall, "dynamic"):
        if check.demand is not None:
            row = found_row(
                book, sheet, row, say("θmax/θc of the set (Dynamic check)"), check.demand, "–", f"{name}_peak", EXACT
            )
        row = found_row(
            book, sheet, row, f"ζ_E: {word('dynamic', book.language)}", check.zeta, "–", f"{name}_dynamic_zeta", EXACT
        )
        dynamic = wall.assessment.dynamic
        row = found_row(book, sheet, row, "ζ_16", dynamic.zeta_16, "–", None, EXACT)
        if dynamic.zeta_other:
            on = word(f"confidence_{dynamic.zeta_other.confidence_on}", book.language)
            row = found_row(book, sheet, row, f"ζ_E, {on}", dynamic.zeta_other.zeta, "–", None, EXACT)
    return _risk(book, sheet, wall, name, demand, row)


def cell_prefix(result: StudyResult, wall: WallResult) -> str:
    """What the names of the cells of a wall begin with: wall1 for the first of the result."""
    return f"wall{result.numbers[id(wall)]}"


def zeta_cell(wall: WallResult, name: str, demand) -> str:
    """Name of the cell of the zeta that decides."""
    governing = wall.assessment.verdict.governing
    if demand.limit_state == "SLD" and governing == "linear_q_code":
        return f"{name}_zeta_sld"
    return f"{name}_{governing}_zeta"


def _risk(book: Book, sheet, wall, name: str, demand, row: int) -> int:
    """PGA_C, T_R,C by both exponents, IS-V of this mechanism, from the zeta of the check that decides."""
    say, found = book.say, wall.assessment.risk
    if found is None:
        return row
    zeta = zeta_cell(wall, name, demand)
    of_histories = wall.assessment.verdict.governing == "dynamic"
    pga = "demand_pga_run" if of_histories else "demand_pga"  # zeta of the histories is of the demand of the run
    row = live_row(book, sheet, row, "PGA_C = ζ S a_g", "", f"={zeta}*{pga}", found.pga / G, "g", f"{name}_pga_c")
    if found.by_hazard:
        text(sheet, row, 1, say("T_R,C by the hazard of the site"))
        text(sheet, row, 3, found.years, align="right")
        text(sheet, row, 5, say("years"), color=QUIET, align="center")
        row += 1
    elif found.return_period is not None:
        tr_row = found_row if of_histories else input_row
        row = tr_row(book, sheet, row, "T_R,D", demand.return_period, say("years"), f"{name}_tr_d", RATIO)
        both = [f"{name}_tr_d*{zeta}^(1/{1.0 / eta:.3g})" for eta in (EXPONENT, exponent_by_ag(demand.ag))]
        label = "T_R,C = T_R,D ζ^η, min"
        row = live_row(
            book,
            sheet,
            row,
            label,
            "",
            f"=MIN({','.join(both)})",
            found.return_period,
            say("years"),
            f"{name}_tr_c",
            RATIO,
        )
        row = live_row(
            book,
            sheet,
            row,
            "T_R,C, max",
            "",
            f"=MAX({','.join(both)})",
            found.other_return_period,
            say("years"),
            None,
            RATIO,
        )
    if found.index is not None:
        label = say("IS-V of this mechanism, class {letter}", letter=found.letter)
        row = live_row(book, sheet, row, label, "D.M. 65/2017", f"={name}_pga_c/{pga}", found.index, "–", None, RATIO)
    return row


def _sld(book: Book, sheet, wall, name: str, demand, row: int) -> int:
    """a_g,SLD over a_g: against a_g S, of an element free to vibrate against S_e(T_0)."""
    kinematic, say = wall.assessment.kinematic, book.say
    if kinematic.zeta_sld is None:
        text(sheet, row, 1, say("No linear check: T_0 is not known (see the verdict)."), color=QUIET, italic=True)
        return row + 1
    against, clause = "demand_pga", "C8.7.1.8"
    if kinematic.floor:
        row = _floor(book, sheet, kinematic, name, row)
        against = f"MAX({name}_a_z,demand_pga)"
    if kinematic.free_element:
        asked, against, clause = wall.wall, f"{name}_se_t0", "C8.7.1.9"
        drawn = asked.slenderness_deg is None or asked.setback
        t = f"{name}_thickness" if drawn else f"({name}_height*TAN(RADIANS({name}_slenderness)))"
        row = input_row(book, sheet, row, "E", asked.elastic_modulus_mpa, "MPa", f"{name}_modulus")
        alone = f"{CANTILEVER}*{name}_height/{t}*{name}_height*SQRT({name}_weight/(1000*{name}_modulus*gravity))"
        if asked.load:
            label = "T_0 = √(κ² (H/t)² H² w/(E g) + Σ 4π² m h³/(3 E I))"
            formula = f"=SQRT(({alone})^2+{chain_formulas(book, name)['period']})"
        else:
            row = input_row(book, sheet, row, say("unit weight"), asked.unit_weight_kn_m3, "kN/m³", f"{name}_weight")
            label, formula = "T_0 = κ (H/t) H √(w/(E g))", f"={alone}"
        row = live_row(book, sheet, row, label, "C8.7.1.7", formula, kinematic.period_0, "s", f"{name}_period_0")
        if kinematic.floor:
            row = found_row(book, sheet, row, "S_eZ(T_0, 5 %)", kinematic.acceleration_demand / G, "g", against)
        elif isinstance(demand.target, CodeSpectrum):
            formula = f"=demand_pga*{spectrum_shape(f'{name}_period_0', 5.0)}"
            row = live_row(
                book, sheet, row, "S_e(T_0, 5 %)", clause, formula, kinematic.acceleration_demand / G, "g", against
            )
        else:
            row = found_row(book, sheet, row, "S_e(T_0, 5 %)", kinematic.acceleration_demand / G, "g", against)
    return live_row(
        book,
        sheet,
        row,
        "a_g,SLD / a_g",
        clause,
        f"={name}_a0_star/{against}",
        kinematic.zeta_sld,
        "–",
        f"{name}_zeta_sld",
    )


def _floor(book: Book, sheet, kinematic, name: str, row: int) -> int:
    """The modes of the building and a_Z, C7.2.7 and C7.2.8."""
    squares = []
    for k, mode in enumerate(kinematic.floor.modes, start=1):
        row = found_row(book, sheet, row, f"T_{k}", mode.period, "s", f"{name}_t_{k}")
        row = found_row(book, sheet, row, f"ξ_{k}", mode.damping, "–", f"{name}_xi_{k}")
        row = found_row(book, sheet, row, f"γψ_{k}", mode.participation, "–", f"{name}_part_{k}")
        elastic = kinematic.floor.ground.acceleration([mode.period], mode.damping)[0] / G
        row = found_row(book, sheet, row, f"S_e(T_{k}, ξ_{k})", float(elastic), "g", f"{name}_se_{k}")
        squares.append(f"({name}_se_{k}*{name}_part_{k})^2*(1+4*{name}_xi_{k}^2)")
    return live_row(
        book, sheet, row, "a_Z", "C7.2.8", f"=SQRT({'+'.join(squares)})", kinematic.floor.a_z / G, "g", f"{name}_a_z"
    )


def found_checks(wall: WallResult, *names: str):
    return [check for check in wall.assessment.checks if check.name in names]


def _displacement(book: Book, sheet, wall, name: str, demand, check, row: int) -> int:
    kinematic, state = wall.assessment.kinematic, demand.limit_state
    share = LIMIT_FRACTION[state]
    if wall.wall.load and not sides_agree(wall):
        row = found_row(book, sheet, row, "d0 (C8.7.1.4)", kinematic.d0, "m", f"{name}_d0")
    elif wall.wall.load:
        row = live_row(
            book,
            sheet,
            row,
            "d0 = d_C(θ_c) (W y² + ΣQ h²)/[y (W y + ΣQ h)]",
            "C8.7.1.4",
            chain_formulas(book, name)["d0"],
            kinematic.d0,
            "m",
            f"{name}_d0",
        )
    else:
        row = live_row(
            book,
            sheet,
            row,
            "d0 = R sin α",
            "C8.7.1.2.1.6",
            f"={name}_radius*SIN(RADIANS({name}_slenderness))",
            kinematic.d0,
            "m",
            f"{name}_d0",
        )
    row = live_row(
        book,
        sheet,
        row,
        f"d_{state} = {book.digits(share, '.2f')} d0",
        "C8.7.1.2.1.6",
        f"={share}*{name}_d0",
        kinematic.d_limit,
        "m",
        f"{name}_d_limit",
    )
    row = live_row(
        book,
        sheet,
        row,
        f"a(d_{state})",
        "C8.7.1.3",
        f"=(1-{share})*{name}_alpha0/({name}_e_star*demand_fc)*gravity",
        kinematic.a_limit,
        "m/s²",
        f"{name}_a_limit",
    )
    equation = "C8.7.1.10" if state == "SLV" else "C8.7.1.11"
    factor = PERIOD_FACTOR[state] / 3.141592653589793
    row = live_row(
        book,
        sheet,
        row,
        f"T_{state}",
        equation,
        f"={factor:.2f}*PI()*SQRT({name}_d_limit/{name}_a_limit)",
        kinematic.period,
        "s",
        f"{name}_period",
    )
    damping = 100.0 * DAMPING[state]
    if kinematic.floor:
        row = found_row(
            book, sheet, row, f"S_DeZ(T_{state}, {damping:g} %), C8.7.1.12", kinematic.s_de, "m", f"{name}_s_de"
        )
    elif isinstance(demand.target, CodeSpectrum):
        t = f"{name}_period"
        formula = f"=demand_pga*gravity*{spectrum_shape(t, damping)}*({t}/(2*PI()))^2"
        row = live_row(
            book,
            sheet,
            row,
            f"S_De(T_{state}, {damping:g} %)",
            "C8.7.1.12",
            formula,
            kinematic.s_de,
            "m",
            f"{name}_s_de",
        )
    else:
        row = found_row(
            book, sheet, row, f"S_De max, [T_0, T_{state}], {damping:g} %", kinematic.s_de, "m", f"{name}_s_de"
        )
    ratio, formula = f"{name}_d_limit/{name}_s_de", f"={name}_d_limit/{name}_s_de"
    if state == "SLV" and kinematic.zeta_floor is not None:
        row = live_row(
            book, sheet, row, f"d_{state} / S_De", "C8.7.1.12", formula, kinematic.d_limit / kinematic.s_de, "–"
        )
        label, floor = book.say("not below a_g,SLD / a_g"), f"{name}_zeta_sld"
        if kinematic.chain.alpha0_friction is not None:  # without the friction
            share = f"({name}_alpha0/{name}_e_star)/({name}_alpha0_friction/{name}_e_star_friction)"
            floor = f"MIN({name}_zeta_sld,{name}_zeta_sld*{share})"
        row = live_row(book, sheet, row, label, "C8.7.1.2.1.8", f"={floor}", kinematic.zeta_floor, "–")
        formula = f"=MAX({ratio},{floor})"
    row = live_row(
        book,
        sheet,
        row,
        f"ζ: {word('nonlinear', book.language)}",
        "C8.7.1.2.1.8",
        formula,
        check.zeta,
        "–",
        f"{name}_nonlinear_zeta",
    )
    return _outcome(book, sheet, row, f"{name}_nonlinear_zeta", check)


def _outcome(book: Book, sheet, row: int, zeta: str, check) -> int:
    """A live word in the row of zeta: passed from the zeta required."""
    yes, no = word("passed", book.language), word("not_passed", book.language)
    cell = book.formula(
        sheet.cell(row - 1, 6), f'=IF({zeta}>=zeta_target-1E-12,"{yes}","{no}")', yes if check.passed else no
    )
    style(cell, bold=True, color=GOOD if check.passed else BAD)
    return row
