"""One verdict for each wall: the worst of its hinges and mechanisms, at every limit state."""

from core.case.floor_loads import add_floor_loads
from core.case.hinges import best_way, default_hinges
from core.case.plausible import plausibility_questions
from core.case.schema import Case
from core.case.set_aside import OVERTURNING
from core.case.site import Demand
from core.case.wall import Wall
from core.codes.assumption import ALL_TOGETHER_KEY, ARCH, RESTRAINT, Assumption, sort_assumptions
from core.codes.kinematic import Check
from core.codes.outcomes import FAILS, NO_HAZARD, OUTCOMES, PASSES, min_if_all_known, way_key, worst_outcome
from core.codes.outcomes import severity_key as severity_of
from core.codes.risk import risk_of_wall
from core.codes.verdict_sentence import hinge_phrase
from core.study.results import LimitStateOutcome, StudyResult, WallResult, WallVerdict
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.limit_states import LIMIT_STATES


def wall_severity(wall: WallResult) -> tuple[int, bool, float]:
    """Order of the hinges of a wall, and of walls: by the table of outcomes, worst first."""
    verdict = wall.required_assessment.verdict
    return severity_of(verdict.code, verdict.zeta_e, verdict.zeta_target)


HIDDEN_CELL_NOTICES = "hidden_rows", "hidden_columns"
"""Notices on what of a table of walls nobody sees, and is not read."""


def wall_verdicts(case: Case, walls: tuple[WallResult, ...]) -> tuple[WallVerdict, ...]:
    """A verdict for each wall of the case, in its order; empty without a demand."""
    demand = case.demand
    if demand is None or not walls or walls[0].assessment is None:
        return ()
    by_origin: dict[int, list[int]] = {}
    for k, wall in enumerate(walls):
        by_origin.setdefault(wall.part.origin, []).append(k)
    verdicts = []
    for origin, indices in by_origin.items():
        ordered = sorted(_counted(walls, indices), key=lambda k: wall_severity(walls[k]))
        hinges = [walls[k] for k in ordered]
        asked, states = case.wall[origin], _states(demand, hinges)
        hidden = [note for note in case.table_notes if note.code in HIDDEN_CELL_NOTICES]
        extra = [*_lower_elsewhere(hinges), *_left_out(asked, case, walls, indices), *_other_states(demand, states)]
        extra += [*hidden, *plausibility_questions(asked, case.building, case.wall)]
        extra += _also_rests_on(asked, hinges)
        zeta_least = min_if_all_known(wall.required_assessment.verdict.zeta_e for wall in hinges)
        withstands = risk_of_wall([wall.required_assessment.risk for wall in hinges])
        verdicts.append(WallVerdict(asked, ordered[0], tuple(ordered), states, tuple(extra), zeta_least, withstands))
    return tuple(verdicts)


def _also_rests_on(wall: Wall, hinges: list[WallResult]) -> list[Sentence]:
    """The documents without which a wall that passes would not, beyond those of the hinge that decides, and what is set
    aside. hinges : worst first"""
    verdicts = [hinge.required_assessment.verdict for hinge in hinges]
    if OUTCOMES[verdicts[0].code].judgement != PASSES:
        return []
    own, *others = ({row.key: row for row in verdict.assumptions if row.turns and row.reason} for verdict in verdicts)
    rows = {key: row for found in others for key, row in found.items() if key not in own and not row.permitted}
    things = [
        sentence("added", "shown_key", key=Key(key), document=row.reason)
        for key, row in rows.items()
        if key not in (RESTRAINT, ARCH)
    ]
    things += [
        sentence("added", "set_aside", mechanism=sentence("mechanism", entry.mechanism), document=entry.evidence.words)
        for entry in wall.set_aside
        if entry.evidence is not None
    ]
    return [sentence("reason", "also_rests_on", things=tuple(dict.fromkeys(things)))] if things else []


def _counted(walls: tuple[WallResult, ...], indices: list[int]) -> list[int]:
    """The results of a wall by which it is judged, of those at these places."""

    def worst(numbers: list[int]) -> tuple:
        verdicts = (walls[indices[n]].required_assessment.verdict for n in numbers)
        return way_key((verdict.code, verdict.zeta_e, verdict.zeta_target) for verdict in verdicts)

    parts = [walls[k].part for k in indices]
    return [indices[n] for n in best_way(parts, worst, lambda n: walls[indices[n]].required_assessment.loses_hold)]


def _lower_elsewhere(hinges: list[WallResult]) -> list[Sentence]:
    """The hinge with the lowest zeta, where another one has the worse outcome and decides. hinges : worst first"""
    zetas = [zeta for hinge in hinges if (zeta := hinge.required_assessment.verdict.zeta_e) is not None]
    if len(zetas) < len(hinges):
        return []
    k = zetas.index(min(zetas))
    if round(zetas[k], 2) >= round(zetas[0], 2):
        return []
    lowest = hinges[k]
    height, mechanism = Number(lowest.part.hinge, ".4g"), sentence("word", lowest.mechanism)
    return [sentence("reason", "lower_elsewhere", zeta=Number(zetas[k]), hinge=height, mechanism=mechanism)]


def _states(demand: Demand, ordered: list[WallResult]) -> dict[str, LimitStateOutcome]:
    """The outcome at each limit state; at that of the demand it is the verdict itself."""
    outcomes = {}
    for state in LIMIT_STATES:
        if state == demand.limit_state:
            verdict = ordered[0].required_assessment.verdict
            outcomes[state] = LimitStateOutcome(verdict.code, verdict.zeta_e, verdict.governing)
            continue
        there = [one for wall in ordered for one in wall.required_assessment.states if one.state == state]
        if not there:
            outcomes[state] = LimitStateOutcome(NO_HAZARD)
            continue
        least_of = worst_outcome(there, lambda one: (one.code, one.zeta, one.zeta_target))
        outcomes[state] = LimitStateOutcome(least_of.code, least_of.zeta, least_of.check)
    return outcomes


def _other_states(demand: Demand, states: dict[str, LimitStateOutcome]) -> list[Sentence]:
    """Other limit states at which the wall fails: they limit the verdict, and never change its code."""
    return [
        sentence(
            "reason",
            "other_state",
            state=state,
            outcome=sentence("word", one.code),
            zeta=_zeta_of(one, demand.zeta_target),
            check=sentence("short", one.check, q=Number(demand.q_code, "g")),
        )
        for state, one in states.items()
        if state != demand.limit_state and one.code != NO_HAZARD and OUTCOMES[one.code].judgement != PASSES
        if one.check is not None
    ]


def _zeta_of(state: LimitStateOutcome, target: float) -> Number | Sentence:
    """zeta of a state that fails; where it reaches what is required, with the words that the rule fails there."""
    if state.zeta is None or OUTCOMES[state.code].judgement != FAILS or state.zeta < target:
        return Number(state.zeta)
    return sentence("added", "fails_at_demand", zeta=Number(state.zeta))


def sort_by_severity(verdicts: tuple[WallVerdict, ...], walls) -> list[WallVerdict]:
    """The walls of a study, the worst first."""
    return sorted(verdicts, key=lambda verdict: wall_severity(walls[verdict.governing]))


def _left_out(asked: Wall, case: Case, walls, indices) -> list[Sentence]:
    """Heights at which a mechanism may start and that the engineer sets aside; the others are a limit of the hinge at
    the base."""
    checked = {round(walls[k].part.hinge, 3) for k in indices if walls[k].part.turns}
    usual = [
        height
        for height in default_hinges(add_floor_loads(asked, case.building), case.building)
        if round(height, 3) not in checked
        and any(entry.covers(OVERTURNING, height, height) for entry in asked.set_aside)
    ]
    if not usual:
        return []
    heights = tuple(Number(height, ".4g") for height in usual)
    return [sentence("reason", "hinges_set_aside", heights=heights, key=Key("set_aside"))]


def collect_assumptions(result: StudyResult, verdict: WallVerdict) -> tuple[Assumption, ...]:
    """The table of assumptions of a wall: of all its hinges and mechanisms, of each input the row that matters most.
    The last row is that of the hinge that decides: each hinge has its own."""
    rows: list[Assumption] = []
    for k in verdict.results:
        assessment = result.walls[k].assessment
        of_hinge = assessment.verdict.assumptions if assessment else ()
        rows += [row for row in of_hinge if row.key != ALL_TOGETHER_KEY or k == verdict.governing]
    return sort_assumptions(rows)


def governing_check_of_wall(wall: WallResult) -> Check | None:
    """The check that decides about a hinge."""
    governing = wall.required_assessment.verdict.governing
    return next((check for check in wall.required_assessment.checks if check.name == governing), None)


def hinge_location(wall: WallResult) -> Sentence | str:
    """Words that say where the hinge of a result is."""
    if (arch := wall.wall.in_si.arch) is not None:
        return sentence("added", "between_walls", spacing=arch.spacing)
    there = _at_height(wall)
    if not wall.part.aspect:
        return there
    return sentence(
        "added", "of_direction" if wall.kinematics.both_ways else "of_leaf", aspect=wall.part.aspect, there=there
    )


def _at_height(wall: WallResult) -> Sentence | str:
    """Words that say at what height the hinge of a result is."""
    height, kinematic = wall.part.hinge, wall.assessment.kinematic if wall.assessment else None
    if kinematic is not None:
        of_check = kinematic.moved if wall.required_assessment.verdict.governing == "nonlinear" else kinematic.chain
        height = height + of_check.bending.h1 if of_check.bending is not None else height
    return hinge_phrase(height, (wall.part.asked.base_z_m or 0.0))


def counted_walls(result: StudyResult) -> list[WallResult]:
    """The results by which the walls of a study are judged, in their order: all but those of a way of holding a wall
    that is passed over."""
    counted = {k for verdict in result.verdicts for k in verdict.results}
    return [wall for k, wall in enumerate(result.walls) if k in counted or not result.verdicts]


def zeta_by_hinge(result: StudyResult, wall: WallResult) -> list[tuple[float, float | None]]:
    """Every hinge of the wall a result is of, with the smallest zeta there, None where one is not known; none where it
    has one alone."""
    by_hinge: dict[float, list[float | None]] = {}
    for one in counted_walls(result):
        if one.part.origin == wall.part.origin and one.part.turns and one.assessment:
            by_hinge.setdefault(one.part.hinge, []).append(one.assessment.verdict.zeta_e)
    return [(hinge, min_if_all_known(zetas)) for hinge, zetas in sorted(by_hinge.items())] if len(by_hinge) > 1 else []
