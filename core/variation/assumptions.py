"""What lifts zeta, shown with zeta at the other end of its range."""

import contextlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial, reduce
from typing import NamedTuple

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.loads import Load
from core.case.schema import Wall, WallJustification
from core.case.site import FULL_FACTOR, Building, DemandJustification
from core.codes.assumption import DECLARED, DEFAULT, GIVEN, LEFT_OUT, TOGETHER, Assumption, Shown
from core.codes.elastic_branch import ELASTIC, Branch, can_have_branch
from core.codes.floor_spectrum import estimated_period, first_mode
from core.codes.kinematic import Check
from core.codes.kinematic_chain import chain
from core.codes.masonry_types import least_strength
from core.codes.outcomes import PASSES
from core.codes.verdict import outcome_of
from core.codes.verdict_sentence import CODE_Q
from core.codes.vertical_bending import bent_inward
from core.errors import InputError
from core.ground.scattered import SPREAD
from core.setting.demand_input import default_motions, generated_for, set_of
from core.setting.floors import GREATEST_STOREY, LEAST_STOREY, damaged, other_ends
from core.setting.scene import ESTIMATES, Scene
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.evaluate import Evaluation, evaluate
from core.wall import ties, wall_body
from core.wall.restitution import MODELS
from core.wall.wall_loads import COUNTED, check_loads

Ends = list[Evaluation | None]
"""The wall at the other ends of the range of an input; None where it does not stand there."""

Change = Callable[[Scene], Scene]

LOWER = 0.999
"""Height of the restraint, of the top of the body, below which what it lifts is shown."""

LEAST_SETBACK = 0.01
"""Hinge setback [m] of any masonry: its edge is not sharp."""

MORE_RATIO = 0.1
"""What is added to a given velocity ratio: its zeta is shown as well."""


GIVEN_WORD, NONE_WORD = sentence("accepted", "given"), sentence("accepted", "none")


class End(NamedTuple):
    """The other end of the range of an input: the change to it, and its value as the table shows it."""

    change: Change
    value: Shown


@dataclass(frozen=True)
class Raised:
    """An input that raises zeta.

    key : of the case and of the reasons; reasons : sections of them, or None
    value : of it, as the table shows it
    ends : the other ends of its range
    words : from zeta of each end, and its check, the Sentence
    source, permitted : as of an Assumption
    histories : the dynamic check knows of it; otherwise its words are of the linear check
    """

    key: str
    reasons: object
    value: Shown
    ends: tuple[End, ...]
    words: Callable[[list[float | None], Check], Sentence]
    source: str = GIVEN
    histories: bool = True
    permitted: bool = False

    @property
    def reason(self) -> str:
        """Of the engineer, "" without one."""
        return str(getattr(self.reasons, self.key, "") or "") if self.reasons else ""


def _worth(zeta: float | None) -> float:
    """To compare: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def _there(end: Evaluation, check: Check) -> Check | None:
    """A check at another end; where records are there by default, in the place of histories and displacement check the
    one of them that decides there."""
    if end.scene.by_default and check.name in ("dynamic", "nonlinear"):
        return end.decides
    return end.made(check.name)


def _zeta(end: Evaluation | None, check: Check) -> float | None:
    """zeta of a check at another end."""
    found = _there(end, check) if end else None
    return found.zeta if found else None


def _turns(end: Evaluation | None, check: Check) -> bool:
    """Whether a check fails, is at its limit or has no number at another end."""
    return end is None or end.judgement(_there(end, check)) != PASSES


def assumptions(found: Evaluation, cancelled: Callable[[], bool] = lambda: False) -> tuple[Assumption, ...]:
    """The inputs of a wall that raise zeta, each with zeta and the outcome at the other end of its range, and all of
    them together; where no one of them turns the outcome, all together without a reason may. found : the wall as it is,
    some check of which has a zeta. Raises Cancelled."""
    decides, q_check = found.decides, found.made("linear_q_code")
    assert decides is not None

    def at(change: Change, by_histories: bool) -> Evaluation | None:
        there = found.scene if by_histories else found.scene.without_records()
        try:
            return evaluate(change(there), other=False, cancelled=cancelled)
        except InputError:  # without what lifts it the wall does not stand
            return None

    rows: list[Assumption] = []
    worst: list[tuple[Assumption, Change]] = []
    for one in _raised(found):
        touched = decides.name != "dynamic" or one.histories
        judged = [check for check in (decides if touched else None, q_check) if check is not None]
        if not judged:
            continue
        ends = [at(end.change, touched) for end in one.ends]
        told = _told(one, judged, ends, found)
        if told is None:
            continue
        zetas = [_zeta(end, told) for end in ends]
        lowest = min(range(len(zetas)), key=lambda k: _worth(zetas[k]))
        turns = {check.name for check in judged if any(_turns(end, check) for end in ends)}
        row = Assumption(
            one.key,
            one.words(zetas, told),
            one.value,
            one.ends[lowest].value,
            one.source,
            zetas[lowest],
            _outcome(ends[lowest], found, touched),
            turns=bool(decides.passed) and touched and decides.name in turns,
            reason=one.reason,
            turns_q=bool(q_check and q_check.passed) and "linear_q_code" in turns,
            permitted=one.permitted,
            raises=_worth(zetas[lowest]) < _worth(told.zeta),
        )
        rows.append(row)
        if row.raises:
            worst.append((row, one.ends[lowest].change))
    return _together(rows, worst, found, at)


def _outcome(end: Evaluation | None, found: Evaluation, touched: bool) -> str:
    """Code of the outcome at another end; of an input that moves the check with q alone, with this check as it is
    there. A wall that does not stand there fails."""
    if end is None:
        return "not_verified"
    if touched:
        return end.outcome
    checks = tuple((end.made(one.name) or one) if one.name == "linear_q_code" else one for one in found.checks)
    return outcome_of(found.evidence._replace(checks=checks))


def _told(one: Raised, judged: list[Check], ends: Ends, found: Evaluation) -> Check | None:
    """The check whose zeta the words of a raised input give, None where it raises none: of what concerns the linear
    check alone that one, of a wall declared free or not the one that fares worst, of loads the first that they raise.
    judged : the checks the input moves; ends : at its other ends"""
    if one.key in OF_LOADS:
        lowest = ((check, min(_worth(_zeta(end, check)) for end in ends)) for check in judged)
        return next((check for check, zeta in lowest if zeta < _worth(check.zeta)), None)
    if one.key != "free_element":
        return found.decides if one.histories else found.made("linear_q_code")
    told = min(judged, key=lambda check: _worth(_zeta(ends[0], check)))
    raises_none = found.scene.wall.free_element and _worth(_zeta(ends[0], told)) >= _worth(told.zeta)
    return None if raises_none else told


def _together(
    rows: list[Assumption], worst: list[tuple[Assumption, Change]], found: Evaluation, at
) -> tuple[Assumption, ...]:
    """The rows, and the last one, all of them; where none turns a check alone, and all without a reason do together,
    each of these does.

    worst : (row, change to the end with the lowest zeta) of each; at(change, by_histories) : the wall there
    """
    decides, q_check = found.decides, found.made("linear_q_code")
    assert decides is not None
    unsaid = [pair for pair in worst if pair[0].open]
    open_keys = tuple(dict.fromkeys(row.key for row, _ in unsaid))
    asked = bool(decides.passed) and not any(row.turns for row, _ in unsaid)
    asked_q = bool(q_check and q_check.passed) and not any(row.turns_q for row, _ in unsaid)

    def there(pairs, by_histories: bool) -> Evaluation | None:
        return at(lambda scene: reduce(lambda changed, pair: pair[1](changed), pairs, scene), by_histories)

    if len(unsaid) > 1 and (asked or asked_q):
        end = there(unsaid, asked)
        joint = asked and _turns(end, decides)
        joint_q = asked_q and q_check is not None and _turns(end, q_check)
        rows = [
            replace(row, turns=row.turns or joint, turns_q=row.turns_q or joint_q) if row.key in open_keys else row
            for row in rows
        ]
        if joint:
            rows.append(_last(open_keys, end, decides, found, turns=True))
            return tuple(rows)
    if len(worst) > 1 and not any(row.zeta is None for row, _ in worst):
        rows.append(_last(tuple(row.key for row, _ in worst), there(worst, True), decides, found))
    return tuple(rows)


def _last(keys: tuple[str, ...], end: Evaluation | None, check: Check, found: Evaluation, turns=False) -> Assumption:
    """The row of several inputs at their other ends together."""
    zeta = _zeta(end, check)
    words = sentence("reason", "lifts_together", keys=tuple(map(Key, dict.fromkeys(keys))), zeta=Number(zeta))
    return Assumption(TOGETHER, words, "", "", DEFAULT, zeta, _outcome(end, found, True), turns)


def _of_wall(**values) -> Change:
    return lambda scene: scene.but(wall=replace(scene.wall, **values))


def _with_loads(change: Callable[[Wall], tuple[Load, ...]]) -> Change:
    return lambda scene: scene.but(wall=replace(scene.wall, load=change(scene.wall)))


def _of_ties(**values) -> Change:
    """Of all ties of the wall."""
    return _with_loads(lambda wall: tuple(replace(load, **values) if load.is_tie else load for load in wall.load))


def _without(goes: Callable[[Wall, Load], bool]) -> Change:
    """Without the loads that go."""
    return _with_loads(lambda wall: tuple(load for load in wall.load if not goes(wall, load)))


def _of_demand(**values) -> Change:
    return lambda scene: scene.but(demand=replace(scene.demand, **values))


def _raised(found: Evaluation) -> Iterator[Raised]:
    """What the case gives that raises zeta."""
    scene, q_check = found.scene, found.made("linear_q_code")
    wall, demand, asked = scene.wall, scene.demand, scene.asked
    model, dynamic = wall.restitution_model(scene.mechanism), found.dynamic is not None
    if dynamic and not MODELS[model].by_theory:
        given = wall.restitution_of(scene.mechanism).ratio_at_rest
        more = min(given + MORE_RATIO, 1.0)
        key, ratio = "velocity_ratio" if model == "user" else "restitution", _by_theory(wall, scene.mechanism)
        if ratio is not None:
            yield Raised(
                key,
                wall.justification,
                given,
                (
                    End(_of_wall(restitution=None, velocity_ratio=more), more),
                    End(_of_wall(restitution=None, velocity_ratio=None), ratio),
                ),
                lambda zetas, _: sentence(
                    "reason",
                    "lift_velocity_ratio",
                    e=given,
                    more=more,
                    zeta_more=Number(zetas[0]),
                    theory=ratio,
                    zeta_theory=Number(zetas[1]),
                ),
            )
        elif given < 1.0:
            end = End(_of_wall(restitution=None, velocity_ratio=1.0), 1.0)
            yield _one(key, "lift_ratio_no_theory", wall.justification, given, end, e=given)
    if dynamic:
        yield from _of_the_law(found)
    if demand.confidence_factor < FULL_FACTOR:
        yield _one(
            "confidence_factor",
            "lift_confidence_factor",
            asked.justification,
            demand.confidence_factor,
            End(_of_demand(confidence_factor=FULL_FACTOR), FULL_FACTOR),
            fc=demand.confidence_factor,
            level=asked.knowledge_level or "",
            investigations=asked.investigations,
        )
    if q_check is not None and q_check.q is not None and q_check.q > CODE_Q:
        end = End(_of_demand(q_code=CODE_Q), CODE_Q)
        reasons = asked.justification
        yield _one("q_code", "lift_q_code", reasons, demand.q_code, end, histories=False, q=demand.q_code)
    if wall.return_walls is not None and q_check is not None:
        end = End(_of_wall(return_walls=None), NONE_WORD)
        yield _one("return_walls", "lift_return_walls", wall.justification, GIVEN_WORD, end, histories=False)
    yield from _of_what_is_required(scene)
    asked_set = None if scene.by_default or not found.satisfied else set_of(scene.ground)
    if asked_set is not None and asked_set.scatter < SPREAD:
        natural = tuple(generated_for(replace(asked_set, scatter=SPREAD), demand))
        end = End(lambda scene: scene.but(ground=natural), SPREAD)
        yield _one("scatter", "lift_scatter", asked.justification, asked_set.scatter, end, given=asked_set.scatter)
    yield from _of_the_loads(scene, not dynamic)
    yield from _of_the_weights(scene)
    if wall.free_element is not None and wall.free_element != replace(wall, free_element=None).is_free(scene.mechanism):
        code = "lift_one_sided_free" if wall.free_element else "lift_free_element"
        end = End(_of_wall(free_element=None), _free(not wall.free_element))
        yield Raised(
            "free_element",
            wall.justification,
            _free(wall.free_element),
            (end,),
            lambda zetas, check: sentence("reason", code, zeta=Number(zetas[0]), check=_named(check)),
            DECLARED,
            histories=False,
        )
    yield from _of_the_shape(wall, scene.mechanism)
    yield from _of_the_edge(scene)
    if not dynamic and _histories_left_out(found):
        there = tuple(default_motions(demand))
        end = End(lambda scene: scene.but(ground=there, by_default=True), sentence("word", "made"))
        yield _one("histories", "lift_histories", asked.justification, sentence("word", "not_made"), end)
    if wall.above_ground and scene.building is not None:
        yield from _of_the_building(scene, scene.building)


def _of_the_law(found: Evaluation) -> Iterator[Raised]:
    """A trilinear law, the branch of an element free to vibrate, and a rigid law in its place."""
    scene, wall = found.scene, found.scene.wall
    if not wall.moment_law().is_rigid:
        end = End(_of_wall(law="rigid"), "rigid")
        yield _one("law", "lift_law", wall.justification, _law_named(wall.law), end)
    if found.dynamic is not None and found.dynamic.branch is not None:
        yield _of_the_branch(found.dynamic.branch)
    given = wall.law == "rigid" and wall.is_free(scene.mechanism) and found.satisfied
    if given and can_have_branch(wall, scene.mechanism):  # of a wall that fails without it the branch is not asked for
        end = End(_of_wall(law=ELASTIC), sentence("word", "with_branch"))
        yield _one("law", "lift_rigid", wall.justification, sentence("word", "choice_rigid"), end)


def _of_the_branch(branch: Branch) -> Raised:
    """The elastic branch of an element free to vibrate, with the rigid law beside it: the clause asks for the branch,
    also where the rigid wall fares worse."""
    said = {
        "period": Number(branch.period, ".3f"),
        "modulus": branch.modulus,
        "assumed": sentence("added", "assumed_modulus" if branch.assumed else "nothing"),
        "limit": Number(branch.limit, ".2g"),
        "own": Number(branch.own_period, ".3f"),
    }
    value, end = sentence("word", "with_branch"), End(_of_wall(law="rigid"), sentence("word", "choice_rigid"))
    return _one("law", "elastic_branch", None, value, end, DEFAULT, permitted=True, **said)


def _histories_left_out(found: Evaluation) -> bool:
    """Whether histories could be made of the wall, and are not; of one that fails without them they are not asked
    for."""
    scene, demand = found.scene, found.scene.demand
    can = demand.target is not None and demand.limit_state in LIMIT_FRACTION and not scene.wall.bends
    return can and scene.histories_off and not scene.ground and found.satisfied


def _of_the_edge(scene: Scene) -> Iterator[Raised]:
    """A hinge nearer to the edge than the weakest masonry of its type lets it be, or than LEAST_SETBACK: FC 1.35 lets
    one leave the strength out (C8.7.1.2.1.3), and alpha_0 then counts on more than there is."""
    wall = scene.wall
    if wall.bends or wall.thickness is None:
        return
    weakest, least = least_strength(wall.masonry), LEAST_SETBACK
    if wall.unit_weight_kn_m3 is not None:
        with contextlib.suppress(InputError):  # nothing stands just above the base of oblique solids
            least = max(least, replace(wall, hinge_setback_m=0.0, compressive_strength_mpa=weakest).setback)
    if wall.setback >= least * (1.0 - 1e-9):
        return
    there = _of_wall(compressive_strength_mpa=None, hinge_setback_m=least)
    f, cm = wall.compressive_strength_mpa, 100.0 * least
    if f is None:
        source = GIVEN if wall.hinge_setback_m else DEFAULT
        given, end = wall.hinge_setback_m, End(there, least)
        said = {"given": 100.0 * given, "cm": cm, "f": weakest}
        yield _one("hinge_setback_m", "lift_edge", None, given, end, source, permitted=True, **said)
    elif f > weakest:
        tested = scene.demand.confidence_factor < FULL_FACTOR  # then the strength is that of tests, as it must be
        reasons = wall.justification
        if tested and not (reasons and reasons.compressive_strength_mpa):
            reasons = replace(reasons or WallJustification(), compressive_strength_mpa=scene.asked.investigations)
        end = End(there, weakest)
        yield _one("compressive_strength_mpa", "lift_strength", reasons, f, end, given=f, f=weakest, cm=cm)


def _of_what_is_required(scene: Scene) -> Iterator[Raised]:
    """What of the demand makes it milder than the code's: a limit state whose a_g nothing shows to be its own, a zeta
    required below 1, a soil factor below 1."""
    demand, asked = scene.demand, scene.asked
    reasons = asked.justification
    if demand.limit_state == "SLC":
        if demand.return_period is not None and not (reasons and reasons.limit_state):
            years = f"T_R {demand.return_period:.0f}"
            reasons = replace(reasons or DemandJustification(), limit_state=years)
        end = End(_of_demand(limit_state="SLV"), "SLV")
        yield _one("limit_state", "lift_limit_state", reasons, "SLC", end)
    if demand.zeta_target < 1.0:
        end, target = End(_of_demand(zeta_target=1.0), 1.0), demand.zeta_target
        yield _one("zeta_target", "lift_zeta_target", reasons, target, end, target=target)
    if demand.target is None and demand.soil_factor < 1.0:
        end = End(_of_demand(soil_factor=1.0, pga=demand.ag), 1.0)
        yield _one("soil_factor", "lift_soil_factor", reasons, demand.soil_factor, end, given=demand.soil_factor)


MASSES = "none", "horizontal", "moving"
"""What the mass of a vertical load may do."""

LEVER = 0.05
"""Of the thickness: by how much the point where a load stands may be another."""


def _of_the_weights(scene: Scene) -> Iterator[Raised]:
    """What the mass of vertical loads does, and where they stand, otherwise."""
    wall, t = scene.wall, scene.wall.thickness
    weights = [load for load in wall.load if load.kind == "vertical"]
    if not weights or t is None:
        return
    changes: dict[str, list[tuple[Callable[[Wall], tuple[Load, ...]], Sentence]]] = {
        "mass": [(partial(_of_weights, mass=mass), sentence("word", f"choice_{mass}")) for mass in MASSES],
        "d_m": [
            (partial(_moved_weights, by=by), sentence("word", "moved_by", cm=Number(100.0 * by, "+.1f")))
            for by in (-LEVER * t, LEVER * t)
        ],
    }
    for key, ends in changes.items():
        others = tuple(End(_with_loads(change), said) for change, said in ends if _stands(scene, change(wall)))
        if others:
            given = weights[0].mass if key == "mass" else None
            value = sentence("word", f"choice_{given}") if given else GIVEN_WORD
            words = _worst_words("lift_mass" if key == "mass" else "lift_lever", others)
            yield Raised(key, wall.justification, value, others, words)


def _worst_words(code: str, ends: tuple[End, ...]) -> Callable[[list[float | None], Check], Sentence]:
    """The words of an input by the other end with the lowest zeta."""

    def words(zetas: list[float | None], check: Check) -> Sentence:
        k = min(range(len(zetas)), key=lambda k: _worth(zetas[k]))
        value = ends[k].value
        end = Number(value, ".2g") if isinstance(value, float) else value
        return sentence("reason", code, zeta=Number(zetas[k]), end=end, check=_named(check))

    return words


def _of_weights(wall: Wall, **values) -> tuple[Load, ...]:
    return tuple(replace(load, **values) if load.kind == "vertical" else load for load in wall.load)


def _moved_weights(wall: Wall, by: float) -> tuple[Load, ...]:
    """The loads of a wall, its weights standing further inward [m], within it."""
    assert wall.thickness is not None

    def there(load: Load) -> Load:
        if load.kind != "vertical" or load.d_m is None or wall.thickness is None:
            return load
        return replace(load, d_m=min(max(load.d_m + by, 0.0), wall.thickness))

    return tuple(there(load) for load in wall.load)


def _stands(scene: Scene, loads: tuple[Load, ...]) -> bool:
    """Whether these loads are other ones that the rules of the wall allow."""
    if loads == scene.wall.load:
        return False
    try:
        wall = replace(scene.wall, load=loads)
        check_loads(wall)
        evaluate(scene.without_records().but(wall=wall), other=False)
    except InputError:
        return False
    return True


def _by_theory(wall: Wall, mechanism: str) -> float | None:
    """Velocity ratio by theory; None where it is above 1, of a body that weighs behind its restraint."""
    try:
        return replace(wall, restitution=None, velocity_ratio=None).restitution_of(mechanism).ratio_at_rest
    except InputError as error:
        if error.code != "eq6_above_one":
            raise
        return None


def _of_the_shape(wall: Wall, mechanism: str) -> Iterator[Raised]:
    """What a body drags along behind its base, and a restraint that it meets below its top."""
    if not wall_body.has_shape(wall):
        return
    assert wall.thickness is not None and wall.height_m is not None
    parts = wall_body.parts_of(wall)
    kept = [wall_body.clipped(part, wall.thickness) for part in parts]
    if any(kept) and any(one is not part for one, part in zip(kept, parts, strict=True)):
        left = zip(wall.solid, kept, strict=False)  # the wedges come last
        solids = tuple(
            replace(solid, polygon_m=one.polygon, from_m=one.ends[0], to_m=one.ends[1]) for solid, one in left if one
        )
        end = End(_of_wall(return_wedges=None, solid=solids), NONE_WORD)
        yield _one("return_wedges", "lift_return_wedges", wall.justification, GIVEN_WORD, end)
    top = wall_body.top_of(wall)
    if mechanism == "one_sided" and MODELS[wall.restitution_model(mechanism)].one_sided and wall.height_m < LOWER * top:
        end = End(_of_wall(height_m=top), top)
        yield _one("contact", "lift_contact", wall.justification, wall.height_m, end, h=wall.height_m, top=top)


def _named(check: Check) -> Sentence:
    """A check within a sentence."""
    return sentence("short", check.label, q=Number(check.q, "g"))


def _one(
    key: str, code: str, reasons, value: Shown, end: End, source=GIVEN, histories=True, permitted=False, **values
) -> Raised:
    """One with one other end, whose words take its zeta."""

    def words(zetas, check):
        told = {"check": _named(check)} if key in OF_LOADS else {}
        return sentence("reason", code, zeta=Number(zetas[0]), **told, **values)

    return Raised(key, reasons, value, (end,), words, source, histories, permitted)


def _law_named(law: str | dict) -> str:
    """A trilinear law as the table of assumptions shows it."""
    return law if isinstance(law, str) else f"D1 {law['elastic_limit']:g}, D2 {law['plateau_end']:g}"


def _free(free: bool | None) -> Sentence:
    """Whether a wall is free to vibrate, in words."""
    return sentence("word", "free_to_vibrate" if free else "held")


def _of_building(**values) -> Change:
    def change(scene: Scene) -> Scene:
        assert scene.building is not None
        return scene.but(building=replace(scene.building, **values))

    return change


def _building_words(factor: float, damping: float) -> Sentence:
    """The ratio of the period to the elastic one, and the damping of a building, as the table shows them."""
    return sentence("added", "period_and_damping", factor=factor, damping=damping)


def _building_at(factor: float, damping: float) -> Change:
    """The building at this ratio to its elastic period, and with this damping."""

    def change(scene: Scene) -> Scene:
        building = scene.building
        assert building is not None
        modes = tuple(replace(mode, damping=damping) for mode in building.modes)
        damped = {"modes": modes} if modes else {"damping": damping}
        return scene.but(building=replace(building, period_factor=factor, **damped))

    return change


OF_LOADS = ("elongation_m", "slack_mm", "prestress", "anchorage_kn", "load")
"""Keys of what loads raise, told only where the other end is the lower one."""


def _of_the_loads(scene: Scene, clauses: bool) -> Iterator[Raised]:
    """What of the ties, and of forces that always pull inward, raises zeta. clauses : no histories are made"""
    wall, reasons = scene.wall, scene.wall.justification
    given = [load for load in wall.load if load.is_tie]
    if any(tie.stands_more for tie in (ties.ties_of(wall) if given else ())):
        end = End(_of_ties(elongation_m=None, elongation=None), NONE_WORD)
        yield _one("elongation_m", "lift_elongation", reasons, GIVEN_WORD, end)
    if any(_breaks(wall, load, scene) for load in given):  # no clause follows a bar that breaks
        end = End(_without(lambda there, load: _breaks(there, load, scene)), _no_ties())
        yield _one("elongation_m", "lift_brittle", reasons, GIVEN_WORD, end, histories=clauses)
    if any(load.slack_mm for load in given):
        ends = (End(_of_ties(slack_mm=None), NONE_WORD), End(_without(lambda _, load: bool(load.slack_mm)), _no_ties()))
        words = lambda zetas, check: sentence(  # noqa: E731
            "reason", "lift_slack", zeta_taut=Number(zetas[0]), zeta=Number(zetas[1]), check=_named(check)
        )
        yield Raised("slack_mm", reasons, GIVEN_WORD, ends, words)
    if any(_anchorage_open(load) for load in given):
        end = End(_without(lambda _, load: _anchorage_open(load)), _no_ties())
        unsaid = sentence("accepted", "missing")
        yield _one("anchorage_kn", "lift_anchorage", reasons, unsaid, end, LEFT_OUT, anchorage_kn=Key("anchorage_kn"))
    if any(load.prestress for load in given):
        yield _one("prestress", "lift_prestress", reasons, GIVEN_WORD, End(_of_ties(prestress=None), NONE_WORD))
    if wall.bends:
        end = End(_with_loads(lambda there: bent_inward(there).load), sentence("word", "inward"))
        yield _one("load", "lift_bends_inward", reasons, sentence("word", "outward"), end)
    if any(map(_pulls_inward, wall.load)):
        end = End(_without(lambda _, load: _pulls_inward(load)), NONE_WORD)
        yield _one("load", "lift_inward", reasons, GIVEN_WORD, end)


def _no_ties() -> Sentence:
    return sentence("word", "without_ties")


def _anchorage_open(load: Load) -> bool:
    """Whether nothing is said of the anchorage of a tie."""
    return load.is_tie and (load.bar is None or load.bar.anchorage_kn is None)


def _pulls_inward(load: Load) -> bool:
    """Whether it always does: no tie."""
    return load.kind == "thrust" and load.kn_m is not None and load.kn_m < 0.0


def _breaks(wall: Wall, load: Load, scene: Scene) -> bool:
    """Whether a tie breaks before the rotation up to which a check of the clauses counts on it."""
    if not load.is_tie:
        return False
    sums, block = chain(wall, scene.mechanism == "two_sided"), wall.block()
    share = LIMIT_FRACTION.get(scene.demand.limit_state, COUNTED)
    far = max(sums.rotation(share * sums.d0), COUNTED * (block.slenderness + wall.restoring()[0].lean))
    return ties.tie_of(load, wall).bar.breaks_at <= load.h_m * math.sin(far) * (1.0 + 1e-9)


def _participating(share: float) -> Change:
    """The first mode of the building with this participation."""

    def change(scene: Scene) -> Scene:
        building = scene.building
        assert building is not None
        first, *others = building.modes
        return scene.but(building=replace(building, modes=(replace(first, participation=share), *others)))

    return change


def _of_the_building(scene: Scene, building: Building) -> Iterator[Raised]:
    """What of the building, and of the height at which its motion is taken, raises zeta."""
    wall, asked, limit_state = scene.wall, scene.asked, scene.demand.limit_state
    base, felt = wall.base_z_m, wall.felt_z_m
    assert base is not None and felt is not None
    storey = building.height_m / building.storeys
    if not LEAST_STOREY <= storey <= GREATEST_STOREY and not building.modes:
        many = math.ceil(building.height_m / LEAST_STOREY)
        end, reasons = End(_of_building(storeys=many), float(many)), asked.justification
        yield _one("storeys", "lift_storeys", reasons, float(building.storeys), end, storey=storey, many=many)
    if building.period_s is not None and not scene.period_taken and not building.modes:
        estimated = estimated_period(building.height_m)
        periods = [factor * estimated for factor in ESTIMATES]
        there = tuple(End(_of_building(period_s=t), t) for t in periods if abs(t / building.period_s - 1.0) > 0.01)
        yield Raised("period_s", asked.justification, building.period_s, there, _worst_words("lift_period", there))
    if ends := other_ends(building, limit_state):

        def words(zetas, _):
            k = min(range(len(ends)), key=lambda k: _worth(zetas[k]))
            factor, damping = ends[k]
            return sentence("reason", "other_building", factor=factor, damping=damping, zeta=Number(zetas[k]))

        given = bool(building.modes) or (building.period_factor, building.damping) != (None, None)
        there = tuple(End(_building_at(*end), _building_words(*end)) for end in ends)
        value = _building_words(*damaged(building, limit_state))
        source = GIVEN if given else DEFAULT
        yield Raised("building", asked.justification, value, there, words, source, permitted=not given)
    half = 0.5 * (wall.height_m or wall.block().height)
    if wall_body.has_shape(wall):
        half = wall.bare_block().centroid[1]
    centroid = min(base + half, building.height_m)
    if not building.modes and centroid > felt:
        end = End(_of_wall(base_z_m=centroid), centroid)
        yield _one("base_z_m", "at_centroid", wall.justification, base, end, z=centroid)
    if building.modes:
        _, damping = damaged(building, limit_state)
        z = min(felt, building.height_m)
        (expected,) = first_mode(building.storeys, building.height_m, z, 1.0, damping)
        share, given_share = expected.participation, building.modes[0].participation
        if abs(given_share) < abs(share):
            yield _one(
                "participation",
                "lift_participation",
                asked.justification,
                given_share,
                End(_participating(share), share),
                given=given_share,
                expected=share,
            )
