"""What lifts zeta, shown with zeta at the other end of its range."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import reduce

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.loads import Load
from core.case.schema import Wall
from core.case.site import FULL_FACTOR, Building
from core.codes.floor_spectrum import first_mode
from core.codes.kinematic import Check
from core.codes.kinematic_chain import chain
from core.codes.outcomes import PASSES
from core.codes.verdict import Lift
from core.codes.verdict_sentence import CODE_Q
from core.codes.vertical_bending import bent_inward
from core.errors import InputError
from core.setting.floors import damaged, other_ends
from core.setting.scene import Scene
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.evaluate import Evaluation, evaluate
from core.wall import ties, wall_body
from core.wall.restitution import MODELS
from core.wall.wall_loads import COUNTED

Ends = list[Evaluation | None]
"""The wall at the other ends of the range of an input; None where it does not stand there."""

Change = Callable[[Scene], Scene]

LOWER = 0.999
"""Height of the restraint, of the top of the body, below which what it lifts is shown."""

MORE_RATIO = 0.1
"""What is added to a given velocity ratio: its zeta is shown as well."""


@dataclass(frozen=True)
class Raised:
    """An input that raises zeta.

    key : of the case and of the reasons; reasons : sections of them, or None
    ends : changes to the other ends of its range
    words : from zeta of each end, and its check, the Sentence
    given : the other ends count against the verdict
    histories : the dynamic check knows of it; otherwise its words are of the linear check
    """

    key: str
    reasons: object
    ends: tuple[Change, ...]
    words: Callable[[list[float | None], Check], Sentence]
    given: bool = True
    histories: bool = True

    @property
    def justified(self) -> bool:
        return bool(self.reasons and getattr(self.reasons, self.key))


def _worth(zeta: float | None) -> float:
    """To compare: a number that is missing is the least."""
    return -math.inf if zeta is None else zeta


def _zeta(end: Evaluation | None, check: Check) -> float | None:
    """zeta of a check at another end."""
    found = end.made(check.name) if end else None
    return found.zeta if found else None


def _turns(end: Evaluation | None, check: Check) -> bool:
    """Whether a check fails, is at its limit or has no number at another end."""
    return end is None or end.judgement(end.made(check.name)) != PASSES


def lifts(found: Evaluation, cancelled: Callable[[], bool] = lambda: False) -> tuple[Lift, ...]:
    """The inputs of a wall that raise zeta, each with zeta at the other end of its range; where no one of them turns
    the outcome, all together without a reason may. found : the wall as it is, some check of which has a zeta. Raises
    Cancelled."""
    decides, q_check = found.decides, found.made("linear_q_code")
    assert decides is not None

    def at(change: Change, by_histories: bool) -> Evaluation | None:
        there = found.scene if by_histories else found.scene.without_records()
        try:
            return evaluate(change(there), other=False, cancelled=cancelled)
        except InputError:  # without what lifts it the wall does not stand
            return None

    raised: list[Lift] = []
    worst: list[tuple[str, Change]] = []
    for one in _raised(found):
        touched = decides.name != "dynamic" or one.histories
        judged = [check for check in (decides if touched else None, q_check) if check is not None]
        if not judged:
            continue
        ends = [at(end, touched) for end in one.ends]
        told = _told(one, judged, ends, found)
        if told is None:
            continue
        zetas = [_zeta(end, told) for end in ends]
        lowest = min(range(len(zetas)), key=lambda k: _worth(zetas[k]))
        turns = {check.name for check in judged if one.given and any(_turns(end, check) for end in ends)}
        raised.append(
            Lift(
                one.key,
                one.words(zetas, told),
                turns=bool(decides.passed) and touched and decides.name in turns,
                justified=one.justified,
                zeta=zetas[lowest],
                turns_q=bool(q_check and q_check.passed) and "linear_q_code" in turns,
            )
        )
        if one.given and not one.justified:
            worst.append((one.key, one.ends[lowest]))
    return _together(raised, worst, decides, q_check, at)


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
    found: list[Lift], worst: list[tuple[str, Change]], decides: Check, q_check: Check | None, at
) -> tuple[Lift, ...]:
    """The lifts; where none turns a check alone, and all without a reason do together, each of them does.

    worst : (key, change to the end with the lowest zeta) of these; at(change, by_histories) : the wall there
    """
    open_keys = tuple(dict.fromkeys(key for key, _ in worst))
    open_ones = [lift for lift in found if lift.key in open_keys]
    asked = bool(decides.passed) and not any(lift.turns for lift in open_ones)
    asked_q = bool(q_check and q_check.passed) and not any(lift.turns_q for lift in open_ones)
    if len(worst) < 2 or not (asked or asked_q):
        return tuple(found)
    there = at(lambda scene: reduce(lambda changed, one: one[1](changed), worst, scene), asked)
    joint = asked and _turns(there, decides)
    joint_q = asked_q and q_check is not None and _turns(there, q_check)
    if joint or joint_q:
        found = [
            replace(lift, turns=lift.turns or joint, turns_q=lift.turns_q or joint_q) if lift.key in open_keys else lift
            for lift in found
        ]
    if joint:
        zeta, keys = _zeta(there, decides), tuple(map(Key, open_keys))
        found.append(Lift("", sentence("reason", "lifts_together", keys=keys, zeta=Number(zeta)), zeta=zeta))
    return tuple(found)


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
                (_of_wall(restitution=None, velocity_ratio=more), _of_wall(restitution=None, velocity_ratio=None)),
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
            end = _of_wall(restitution=None, velocity_ratio=1.0)
            yield _one(key, "lift_ratio_no_theory", wall.justification, end, e=given)
    if dynamic and not wall.moment_law().is_rigid:
        yield _one("law", "lift_law", wall.justification, _of_wall(law="rigid"))
    if demand.confidence_factor < FULL_FACTOR:
        yield _one(
            "confidence_factor",
            "lift_confidence_factor",
            asked.justification,
            _of_demand(confidence_factor=FULL_FACTOR),
            fc=demand.confidence_factor,
            level=asked.knowledge_level or "",
            investigations=asked.investigations,
        )
    if q_check is not None and q_check.q is not None and q_check.q > CODE_Q:
        end = _of_demand(q_code=CODE_Q)
        yield _one("q_code", "lift_q_code", asked.justification, end, histories=False, q=demand.q_code)
    if wall.return_walls is not None and q_check is not None:
        end = _of_wall(return_walls=None)
        yield _one("return_walls", "lift_return_walls", wall.justification, end, histories=False)
    yield from _of_the_loads(scene, not dynamic)
    if wall.free_element is not None and wall.free_element != replace(wall, free_element=None).is_free(scene.mechanism):
        code = "lift_one_sided_free" if wall.free_element else "lift_free_element"
        end = _of_wall(free_element=None)
        yield Raised(
            "free_element",
            wall.justification,
            (end,),
            lambda zetas, check: sentence("reason", code, zeta=Number(zetas[0]), check=_named(check)),
            histories=False,
        )
    yield from _of_the_shape(wall, scene.mechanism)
    if wall.above_ground and scene.building is not None:
        yield from _of_the_building(scene, scene.building)


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
        change = _of_wall(return_wedges=None, solid=solids)
        yield _one("return_wedges", "lift_return_wedges", wall.justification, change)
    top = wall_body.top_of(wall)
    if mechanism == "one_sided" and MODELS[wall.restitution_model(mechanism)].one_sided and wall.height_m < LOWER * top:
        change = _of_wall(height_m=top)
        yield _one("contact", "lift_contact", wall.justification, change, h=wall.height_m, top=top)


def _named(check: Check) -> Sentence:
    """A check within a sentence."""
    return sentence("short", check.label, q=Number(check.q, "g"))


def _one(key: str, code: str, reasons, end: Change, histories: bool = True, **values) -> Raised:
    """One with one other end, whose words take its zeta."""

    def words(zetas, check):
        told = {"check": _named(check)} if key in OF_LOADS else {}
        return sentence("reason", code, zeta=Number(zetas[0]), **told, **values)

    return Raised(key, reasons, (end,), words, histories=histories)


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
        yield _one("elongation_m", "lift_elongation", reasons, _of_ties(elongation_m=None, elongation=None))
    if any(_breaks(wall, load, scene) for load in given):  # no clause follows a bar that breaks
        end = _without(lambda there, load: _breaks(there, load, scene))
        yield _one("elongation_m", "lift_brittle", reasons, end, histories=clauses)
    if any(load.slack_mm for load in given):
        ends = _of_ties(slack_mm=None), _without(lambda _, load: bool(load.slack_mm))
        words = lambda zetas, check: sentence(  # noqa: E731
            "reason", "lift_slack", zeta_taut=Number(zetas[0]), zeta=Number(zetas[1]), check=_named(check)
        )
        yield Raised("slack_mm", reasons, ends, words)
    if any(_anchorage_open(load) for load in given):
        end = _without(lambda _, load: _anchorage_open(load))
        yield _one("anchorage_kn", "lift_anchorage", reasons, end, anchorage_kn=Key("anchorage_kn"))
    if any(load.prestress for load in given):
        yield _one("prestress", "lift_prestress", reasons, _of_ties(prestress=None))
    if wall.bends:
        end = _with_loads(lambda there: bent_inward(there).load)
        yield _one("load", "lift_bends_inward", reasons, end)
    if any(map(_pulls_inward, wall.load)):
        yield _one("load", "lift_inward", reasons, _without(lambda _, load: _pulls_inward(load)))


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
    if ends := other_ends(building, limit_state):

        def words(zetas, _):
            k = min(range(len(ends)), key=lambda k: _worth(zetas[k]))
            factor, damping = ends[k]
            return sentence("reason", "other_building", factor=factor, damping=damping, zeta=Number(zetas[k]))

        given = bool(building.modes) or (building.period_factor, building.damping) != (None, None)
        changes = tuple(_building_at(*end) for end in ends)
        yield Raised("building", asked.justification, changes, words, given)
    half = 0.5 * (wall.height_m or wall.block().height)
    if wall_body.has_shape(wall):
        half = wall.bare_block().centroid[1]
    centroid = min(base + half, building.height_m)
    if not building.modes and centroid > felt:
        yield _one("base_z_m", "at_centroid", wall.justification, _of_wall(base_z_m=centroid), z=centroid)
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
                _participating(share),
                given=given_share,
                expected=share,
            )
