"""One verdict for each wall: the worst of its hinges and mechanisms, at every limit state."""

import math

from core.case.hinges import usual_hinges
from core.case.schema import Case, Wall
from core.codes.kinematic import Check
from core.codes.verdict_sentence import at_hinge
from core.study.limit_states import STATES
from core.study.results import StateOutcome, StudyResult, WallResult, WallVerdict
from core.text.sentence import Key, Number, Sentence, sentence


def severity(wall: WallResult) -> tuple[int, float]:
    """Order of the hinges of a wall: a missing number first, then the lowest zeta over the one required, what is not
    activated last."""
    verdict = wall.assessment.verdict
    if verdict.zeta_e is None or verdict.code == "undetermined":
        return 0, -math.inf
    return (2 if verdict.code == "not_activated" else 1), verdict.zeta_e / verdict.zeta_target


def wall_verdicts(case: Case, walls: tuple[WallResult, ...]) -> tuple[WallVerdict, ...]:
    """A verdict for each wall of the case, in its order; empty without a demand."""
    if not walls or walls[0].assessment is None:
        return ()
    by_origin: dict[int, list[int]] = {}
    for k, wall in enumerate(walls):
        by_origin.setdefault(wall.part.origin, []).append(k)
    found = []
    for origin, indices in by_origin.items():
        ordered = sorted(indices, key=lambda k: severity(walls[k]))
        asked, states = case.wall[origin], _states(case, [walls[k] for k in ordered])
        extra = [*_left_out(asked, case, walls, indices), *_other_states(case, states)]
        found.append(WallVerdict(asked, ordered[0], tuple(ordered), states, tuple(extra)))
    return tuple(found)


def _states(case: Case, ordered: list[WallResult]) -> dict[str, StateOutcome]:
    """The outcome at each limit state; at that of the demand it is the verdict itself."""
    found = {}
    for state in STATES:
        if state == case.demand.limit_state:
            worst = ordered[0].assessment.verdict
            found[state] = StateOutcome(worst.code, worst.zeta_e, worst.governing)
            continue
        there = [one for wall in ordered for one in wall.assessment.states if one.state == state]
        if not there:
            found[state] = StateOutcome("no_hazard")
            continue
        worst = min(there, key=lambda one: -math.inf if one.zeta is None else one.zeta)
        found[state] = StateOutcome(worst.code, worst.zeta, worst.check)
    return found


def _other_states(case: Case, states: dict[str, StateOutcome]) -> list[Sentence]:
    """Other limit states at which the wall fails: they limit the verdict, and never change its code."""
    return [
        sentence(
            "reason",
            "other_state",
            state=state,
            outcome=sentence("word", one.code),
            zeta=Number(one.zeta),
            check=sentence("short", one.check, q=Number(case.demand.q_code, "g")),
        )
        for state, one in states.items()
        if state != case.demand.limit_state and one.code == "not_verified"
    ]


def by_severity(verdicts: tuple[WallVerdict, ...], walls) -> list[WallVerdict]:
    """The walls of a study, the worst first."""
    return sorted(verdicts, key=lambda verdict: severity(walls[verdict.governing]))


def _left_out(asked: Wall, case: Case, walls, indices) -> list[Sentence]:
    """Heights at which a mechanism may start and that were not checked."""
    checked = {round(walls[k].part.hinge, 3) for k in indices}
    usual = [h for h in usual_hinges(asked, case.building) if round(h, 3) not in checked]
    if not usual:
        return []
    heights = tuple(Number(height, ".4g") for height in usual)
    code = "heights_left_out" if asked.hinge_heights is None else "hinges_as_asked"
    return [sentence("reason", code, heights=heights, building=Key("[building]"), key=Key("hinge_heights"))]


def deciding(wall: WallResult) -> Check | None:
    """The check that decides about a hinge."""
    governing = wall.assessment.verdict.governing
    return next((check for check in wall.assessment.checks if check.name == governing), None)


def where(wall: WallResult) -> Sentence | str:
    """Where the hinge of a result is, in words."""
    return at_hinge(wall.part.hinge, (wall.part.asked.base_z_m or 0.0))


def zetas_of(result: StudyResult, wall: WallResult) -> list[tuple[float, float | None]]:
    """Every hinge of the wall a result is of, with the smallest zeta found there; none where it has one alone."""
    found: dict[float, list[float]] = {}
    for one in result.walls:
        if one.part.origin == wall.part.origin and one.assessment:
            found.setdefault(one.part.hinge, []).append(one.assessment.verdict.zeta_e)
    zetas = {hinge: [zeta for zeta in known if zeta is not None] for hinge, known in found.items()}
    return [(hinge, min(known, default=None)) for hinge, known in sorted(zetas.items())] if len(zetas) > 1 else []
