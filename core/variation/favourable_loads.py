"""Inputs of the loads of a wall that raise zeta."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

from core.capacity.limit_states import LIMIT_FRACTION
from core.case.hold import Hold
from core.case.load_rules import check_loads
from core.case.loads import Load, OwnWeight
from core.case.wall import Wall
from core.codes.assumption import LEFT_OUT
from core.codes.kinematic_chain import sum_chain
from core.errors import InputError
from core.setting.check_input import CheckInput
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.evaluate import evaluate
from core.variation.favourable_input import (
    GIVEN_WORD,
    NONE_WORD,
    Alternative,
    FavourableInput,
    SceneChange,
    check_phrase,
    single_alternative,
)
from core.wall.masonry import COUNTED


def _with_loads(change: Callable[[Wall], tuple[Load, ...]]) -> SceneChange:
    return lambda scene: scene.replace_parts(wall=replace(scene.wall, load=change(scene.wall)))


def _of_ties(**values) -> SceneChange:
    """Change that gives all ties of the wall these values."""
    return _change_ties(lambda tie: replace(tie, **values))


def _drop_ties(goes: Callable[[Hold], bool]) -> SceneChange:
    """Change that takes away the ties that go."""
    return _change_ties(lambda tie: None if goes(tie) else tie)


def _change_ties(change: Callable[[Hold], Hold | None]) -> SceneChange:
    """Change of each tie of the wall; None of one that goes."""

    def changed(scene: CheckInput) -> CheckInput:
        holds = (change(hold) if hold in scene.wall.ties else hold for hold in scene.wall.hold)
        return scene.replace_parts(wall=replace(scene.wall, hold=tuple(filter(None, holds))))

    return changed


def _without(goes: Callable[[Wall, Load], bool]) -> SceneChange:
    """Change that takes away the loads that go."""
    return _with_loads(lambda wall: tuple(load for load in wall.load if not goes(wall, load)))


MASSES = "none", "horizontal", "moving"
"""Choices of what the mass of a vertical load may do."""


LOW_HEIGHT, LOW_HEIGHT_IN_WALL = 1.0, 2.0
"""Heights above the hinge [m] up to which no floor stands that the part above the hinge carries: any, and one in the
lower half of the wall."""


def favourable_weights(scene: CheckInput) -> Iterator[FavourableInput]:
    """What the mass of vertical loads does otherwise; the wall without what is carried low, is
    variable, or moves with it."""
    wall, t = scene.wall, scene.wall.thickness
    weights = [load for load in wall.load if load.rests and not isinstance(load, OwnWeight)]
    if t is None or not any(load.is_weight for load in wall.load):
        return
    yield from _of_weights_that_may_go(scene)
    choices = [(partial(_of_weights, mass=mass), sentence("word", f"choice_{mass}")) for mass in MASSES]
    ends = [(change, said) for change, said in choices if weights and _may_be(scene, change(wall))]
    if ends:
        others = tuple(Alternative(_with_loads(change), said) for change, said in ends)
        of_all = {load.mass for load in weights}
        value = sentence("word", f"choice_{weights[0].mass}") if len(of_all) == 1 else GIVEN_WORD
        yield FavourableInput("lift_mass", "mass", wall.evidence, value, others)


def _of_weights_that_may_go(scene: CheckInput) -> Iterator[FavourableInput]:
    """The wall without the weights that stand low above the hinge, without variable ones, and without masses it
    carries. A permanent load of a floor is there; what may not be, and lifts, is asked about."""
    wall = scene.wall
    lowest = [load.h_m for load in wall.load if _is_low(wall, load)]
    low, carried = _without(_is_low), _without(lambda _, load: _is_carried(load))
    if lowest and _may_be(scene, tuple(load for load in wall.load if not _is_low(wall, load))):
        end, height = Alternative(low, sentence("word", "below_hinge")), Number(min(lowest), ".2f")
        yield single_alternative("h_m", "lift_low_load", wall.evidence, GIVEN_WORD, end, height=height)
    permanent = tuple(
        replace(load, kn_m=load.g_kn_m, q_kn_m=None, psi_2=None) if load.g_kn_m else load for load in wall.load
    )
    permanent = tuple(load for load in permanent if not _is_variable(load))
    if any(map(_is_variable, wall.load)) and _may_be(scene, permanent):
        end = Alternative(
            lambda there: there.replace_parts(wall=replace(there.wall, load=permanent)), sentence("word", "permanent")
        )
        yield single_alternative("variable", "lift_variable", wall.evidence, GIVEN_WORD, end)
    if any(map(_is_carried, wall.load)) and _may_be(scene, tuple(load for load in wall.load if not _is_carried(load))):
        yield single_alternative("load", "lift_carried", wall.evidence, GIVEN_WORD, Alternative(carried, NONE_WORD))


def _is_low(wall: Wall, load: Load) -> bool:
    """Whether it stands where no floor does."""
    most = max(LOW_HEIGHT, min(LOW_HEIGHT_IN_WALL, 0.5 * (wall.height_m or 0.0)))
    return load.is_weight and load.h_m <= most


def _is_variable(load: Load) -> bool:
    """Whether part of it is, in the seismic combination."""
    return load.is_weight and bool(load.q_kn_m and load.psi_2)


def _is_carried(load: Load) -> bool:
    """Whether it is a mass that moves with the wall."""
    return load.is_carried


def _of_weights(wall: Wall, **values) -> tuple[Load, ...]:
    given = (load.rests and not isinstance(load, OwnWeight) for load in wall.load)
    return tuple(replace(load, **values) if own else load for load, own in zip(wall.load, given, strict=True))


UNSTABLE = ("unstable_under_loads", "bending_unstable", "arch_unstable", "body_falls")
"""Codes of the errors of a wall that does not stand: the worst that another end can say."""


def _may_be(scene: CheckInput, loads: tuple[Load, ...]) -> bool:
    """Whether these loads are other ones, that the rules of the wall allow or under which it does not stand."""
    if loads == scene.wall.load:
        return False
    try:
        wall = replace(scene.wall, load=loads)
        check_loads(wall)
        evaluate(scene.without_records().replace_parts(wall=wall))
    except InputError as error:
        return error.code in UNSTABLE
    return True


def favourable_ties_and_forces(scene: CheckInput, clauses: bool) -> Iterator[FavourableInput]:
    """Inputs of the ties, and of forces that always pull inward, that raise zeta. clauses : no histories are made"""
    wall, given = scene.wall, scene.wall.ties
    of_ties = given[0].evidence if given and all(tie.shows_strength for tie in given) else None
    if any(tie.stands_more for tie in (wall.in_si.ties if given else ())):
        end = Alternative(_of_ties(elongation_m=None), NONE_WORD)
        yield single_alternative("elongation_m", "lift_elongation", of_ties, GIVEN_WORD, end)
    if any(_breaks(tie, scene) for tie in given):  # no clause follows a bar that breaks
        end = Alternative(lambda tied: _drop_ties(lambda tie: _breaks(tie, tied))(tied), _no_ties())
        yield single_alternative("elongation_m", "lift_brittle", of_ties, GIVEN_WORD, end, histories=clauses)
    if any(tie.slack_mm for tie in given):
        ends = (
            Alternative(_of_ties(slack_mm=None), NONE_WORD),
            Alternative(_drop_ties(lambda tie: bool(tie.slack_mm)), _no_ties()),
        )
        words = lambda zetas, check: sentence(  # noqa: E731
            "reason", "lift_slack", zeta_taut=Number(zetas[0]), zeta=Number(zetas[1]), check=check_phrase(check)
        )
        yield FavourableInput("lift_slack", "slack_mm", of_ties, GIVEN_WORD, ends, words, each_written=True)
    if any(map(_anchorage_open, given)):
        end = Alternative(_drop_ties(_anchorage_open), _no_ties())
        unsaid = sentence("accepted", "missing")
        yield single_alternative(
            "anchorage_kn", "lift_anchorage", of_ties, unsaid, end, LEFT_OUT, anchorage_kn=Key("anchorage_kn")
        )
    if any(tie.prestress for tie in given):
        yield single_alternative(
            "prestress", "lift_prestress", of_ties, GIVEN_WORD, Alternative(_of_ties(prestress=None), NONE_WORD)
        )
    if any(map(_pulls_inward, wall.load)):
        end = Alternative(_without(lambda _, load: _pulls_inward(load)), NONE_WORD)
        yield single_alternative("inward", "lift_inward", wall.evidence, GIVEN_WORD, end)


def _no_ties() -> Sentence:
    return sentence("word", "without_ties")


def _anchorage_open(tie: Hold) -> bool:
    """Whether nothing is said of the anchorage of a tie."""
    return tie.bar is None or tie.bar.anchorage_kn is None


def _pulls_inward(load: Load) -> bool:
    """Whether it always does: no tie."""
    return load.is_thrust and load.kn_m is not None and load.kn_m < 0.0


def _breaks(tie: Hold, scene: CheckInput) -> bool:
    """Whether a tie breaks before the rotation up to which a check of the clauses counts on it."""
    wall = scene.wall
    sums, block = sum_chain(wall.in_si, scene.kinematics.both_ways), wall.block()
    share = LIMIT_FRACTION.get(scene.demand.limit_state, COUNTED)
    far = max(sums.rotation(share * sums.d0), COUNTED * (block.slenderness + wall.in_si.restoring[0].lean))
    bar = tie.tie(wall.length_m).bar
    return bar.breaks_at <= bar.height * math.sin(far) * (1.0 + 1e-9)
