"""Part of a note on the site beside its demand: the hazard, the building, the loads of a wall, before and after."""

import math

from core.case.above_holds import SAME_HEIGHT
from core.case.hold import Hold
from core.case.loads import Load
from core.case.wall import Wall
from core.codes.floor_spectrum import PLATEAU_END, PLATEAU_START, estimated_period
from core.known import require_value
from core.report.note.parts import Derivation, Heading, Paragraph, Part, Step, Table, table_of_rows
from core.report.place_lines import place_of, states_of
from core.report.wall_tables import limit_states_of_site, modes_of_floor, numbered_modes, variants_of_walls
from core.report.words import Words
from core.setting.floors import damaged_period_and_damping
from core.study.results import StudyResult, WallResult
from core.study.variants import compare_walls
from core.units import G


def hazard(result: StudyResult, words: Words) -> list[Part]:
    """The rows of the hazard of the site; of a file those that decide, T_R and a_g."""
    demand = result.demand
    if demand is None or not demand.hazard:
        return []
    shapes = {row.return_period_years: row for row in require_value(result.case.demand).hazard}
    rows = []
    for years, ag in demand.hazard:
        row = shapes.get(years)
        rows.append(
            [
                words.number(years, ".0f"),
                words.number(ag / G, ".3f"),
                words.number(row.f0 if row else None, ".3f"),
                words.number(row.tc_star_s if row else None, ".3f"),
            ]
        )
    heads = [f"T_R [{words.say('years')}]", "a_g [g]", "F0", "T_C* [s]"]
    return [Heading(words.say("Hazard of the site"), 3), Table(heads, rows, (1, 1, 1, 1))]


def place(result: StudyResult, words: Words) -> list[Part]:
    """Lines of where the building stands, and of the values of the four limit states there."""
    site = result.case.site
    if site is None:
        return []
    states = table_of_rows(limit_states_of_site(words), states_of(site), words.number)
    return [Table((), place_of(site, words.language), (1, 4)), states]


def building(result: StudyResult, words: Words) -> list[Part]:
    """The building, and its modes at the walls above the ground; nothing where no wall is above it."""
    say, asked = words.say, result.case.building
    floors = {wall.floor.z: wall.floor for wall in result.walls if wall.floor is not None}
    if asked is None or not floors:
        return []
    factor, damping = damaged_period_and_damping(asked, result.demand_required.limit_state if result.demand else "SLV")
    period = asked.period_s or estimated_period(asked.height_m)
    steps = [Step("H_b", asked.height_m, ".2f", "m"), Step("n", asked.storeys, ".0f", "–", label=say("storeys"))]
    if not asked.modes:
        source = words.word("choice_user") if asked.period_s else say("estimate")
        steps += [
            Step("T_1", period, ".3f", "s", label=source),
            Step("T/T_1", factor, ".2f", "–", "C8.7.1.2.1.4", label=say("of the damaged building")),
            Step("ξ", damping, ".2f", "–", "C8.7.1.2.1.4", label=say("of the damaged building")),
        ]
    rows = [row for _, floor in sorted(floors.items()) for row in numbered_modes(floor)]
    table = table_of_rows(modes_of_floor(words), rows, words.number)
    counted = say(
        "C7.2.5 to C7.2.8, with sums over the modes k: a_Z,k = S_e(T_k, ξ_k) γψ √(1 + 4 ξ_k²), a_Z = √Σ a_Z,k². "
        "S_eZ(T, ξ) = √Σ S_eZ,k², S_eZ,k = A a_Z,k/(1 + (A − 1) r), A = 1.1 η(ξ)/√ξ_k, η = √(10/(5 + 100 ξ)) ≥ 0.55; "
        "r = (1 − T/({short:g} T_k))^1.6 below {short:g} T_k, (T/({long:g} T_k) − 1)^1.2 above {long:g} T_k, else 0. "
        "Beyond T_1 not below S_e(T, ξ). S_DeZ(T, ξ) = S_eZ (T/2π)², beyond {long:g} T_1 not below its value there "
        "with S_eZ(T_1).",
        short=PLATEAU_START,
        long=PLATEAU_END,
    )
    return [Heading(words.word("section_building"), 3), Derivation(steps), table, Paragraph(counted, "quiet")]


def loads(wall: WallResult, words: Words) -> list[Part]:
    """The loads above the hinge of a wall, as its arrows show them, and what holds it and stands something."""
    asked = wall.wall
    rows = [
        [
            words.word(f"choice_{load.kind}"),
            _size(load, asked, words),
            words.number(load.h_m, ".2f"),
            words.number(load.d_m, ".3f"),
            words.word(f"choice_{load.mass}") if load.mass else "–",
        ]
        for load in asked.load
    ]
    holds = [(_as_given(hold, wall), hold.h_m) for hold in asked.hold if hold.is_tie or hold.out_kn_m is not None]
    # the joint at a foot that is taken to hold is none of the case
    rows += [_row_of_hold(hold, height, asked, words) for hold, height in holds if height or hold.out_kn_m != math.inf]
    heads = [words.say("Loads and holds"), "[kN/m]", "h [m]", "d [m]", words.say("mass, or shown")]
    return [Table(heads, rows, (2, 1, 1, 1, 2))] if rows else []


def _as_given(hold: Hold, wall: WallResult) -> Hold:
    """A hold of a stretch; the tie of the wall where its strength is compared elsewhere."""
    if hold.out_kn_m is None or not math.isinf(hold.out_kn_m):
        return hold
    height = wall.part.hinge + (hold.h_m or 0.0)
    return next((tie for tie in wall.part.body.ties if abs((tie.h_m or 0.0) - height) < SAME_HEIGHT), hold)


def _row_of_hold(hold: Hold, height: float | None, asked: Wall, words: Words) -> list[str]:
    """What holds a wall, what it stands outward, and the document that shows it. height : above its base [m]"""
    stands = 1e-3 * hold.tie(asked.length_m).bar.strength if hold.is_tie else hold.out_kn_m
    shown = hold.evidence
    document = (words.word(f"evidence_{shown.kind}"), shown.reference, shown.date, shown.note) if shown else ()
    return [
        hold.name or words.word(f"choice_{hold.kind}"),
        "–" if stands is None or math.isinf(stands) else words.number(stands, ".2f"),
        words.number(height, ".2f"),
        "–",
        ", ".join(filter(None, document)) or "–",
    ]


def _size(load: Load, asked: Wall, words: Words) -> str:
    """Size of a load [kN/m], with the sum it is of (NTC 2018 2.5.3)."""
    size = words.number(1e-3 * load.in_si.force, ".2f")
    if load.combined is None:
        return size
    g, q, share = (words.number(value or 0.0, ".2f") for value in (load.g_kn_m, load.q_kn_m, load.psi_2))
    return f"{g} + {share} · {q} = {size}"


def solids(wall: WallResult, words: Words, grouped: bool = False) -> list[Part]:
    """The solids of a wall that is no rectangle, from the outer face of its base. grouped : alike ones in one row"""
    parts = wall.wall.parts
    if not parts:
        return []
    say, number = words.say, words.number
    heads = [say("Solids, from the outer face of the base"), "M [kg]", "x [m]", "z [m]", "I [kg m²]"]
    rows = []
    for k, part in enumerate(parts, start=1):
        kind = say("opening") if part.weight < 0.0 else say("wedge") if part.wedge else say("solid")
        (x, z), mass = part.body.centroid, part.body.mass
        plane = words.word(f"choice_{part.plane}")
        cells = [number(mass, ".1f"), number(x, ".4f"), number(z, ".4f"), number(part.body.inertia, ".1f")]
        rows.append([f"{k} {kind}, {plane}", *cells])
    if grouped:
        alike: dict[tuple[str, ...], list[str]] = {}
        for name, *cells in rows:
            alike.setdefault((name.partition(" ")[2], *cells), []).append(name.partition(" ")[0])
        rows = [[f"{', '.join(numbers)} {kind}", *cells] for (kind, *cells), numbers in alike.items()]
    return [Table(heads, rows, (2.4, 1, 1, 1, 1.2))]


def compare_variants_table(result: StudyResult, words: Words) -> list[Part]:
    """The walls as they are beside the walls as they are designed."""
    pairs = compare_walls(result.verdicts)
    table = table_of_rows(variants_of_walls(words, result), pairs, words.number)
    return [Heading(words.say("Before and after"), 3), table] if pairs else []
