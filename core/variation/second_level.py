"""What no clause asks about and moves zeta all the same: its range, by the clauses' checks alone.

It never holds an outcome back; time histories of it are made on request ([sensitivity]).
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

from core.case.asked import NOT_ASKED
from core.case.loads import Load
from core.case.site import Building
from core.case.wall import Wall
from core.codes.floor_spectrum import estimated_period
from core.codes.masonry_types import moduli, weights
from core.errors import InputError
from core.known import require_value
from core.setting.check_input import CheckInput
from core.setting.floors import MAX_STOREY, MIN_STOREY
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.evaluate import Evaluation, evaluate
from core.variation.favourable_input import SceneChange, at_period, check_phrase, wall_change, with_building
from core.variation.favourable_wall_inputs import setback_at, turning_inside

LEVER = 0.05
"""Distance, over the thickness, by which the point where a load stands may be another [-]."""

PERIODS = 0.5, 2.0
"""Periods of a building over the one of the formula between which its own lies."""


class UnaskedInput(NamedTuple):
    """An input that no clause asks about. code : of NOT_ASKED; key : of the case; ends : changes to its other ends"""

    code: str
    key: str
    ends: tuple[SceneChange, ...]

    @property
    def why(self) -> str:
        """Why no clause asks about it."""
        return NOT_ASKED[self.code]


@dataclass(frozen=True)
class UnaskedRange:
    """zeta over all that no clause asks about, one at a time, by the clauses' checks alone.

    keys : of what was moved; zeta : as the wall is; low, high : the lowest and the highest, zeta as it is among them
    most : key of what moves it most; by : the check that decides there, in words
    """

    keys: tuple[str, ...]
    zeta: float
    low: float
    high: float
    most: str
    by: Sentence

    @property
    def words(self) -> Sentence:
        """The line that says it."""
        values = {"low": Number(self.low), "high": Number(self.high), "zeta": Number(self.zeta)}
        named = {"keys": tuple(map(Key, self.keys)), "most": Key(self.most), "by": self.by}
        return sentence("reason", "unasked_range", **named, **values)


def find_unasked_range(evaluation: Evaluation) -> UnaskedRange | None:
    """The range of zeta of a wall; None of one of which the clauses make no check, or where nothing moves it."""
    scene = evaluation.scene.without_records()
    decides = evaluate(scene, other=False).decides
    if decides is None or decides.zeta is None:
        return None
    zeta = decides.zeta
    zetas: dict[str, list[float]] = {}
    for unasked in unasked_inputs(scene):
        zetas.setdefault(unasked.key, []).extend(_zeta_at(scene, end) for end in unasked.ends)
    moved = {key: found for key, found in zetas.items() if any(round(there, 2) != round(zeta, 2) for there in found)}
    if not moved:
        return None
    every = [zeta, *(there for found in moved.values() for there in found)]
    most = max(moved, key=lambda key: max(*moved[key], zeta) - min(*moved[key], zeta))
    return UnaskedRange(tuple(moved), zeta, min(every), max(every), most, check_phrase(decides))


def _zeta_at(scene: CheckInput, end: SceneChange) -> float:
    """zeta at an end; 0 where the wall does not stand there."""
    try:
        zeta = evaluate(end(scene), other=False).zeta
    except InputError:
        return 0.0
    return 0.0 if zeta is None else zeta


def unasked_inputs(scene: CheckInput) -> Iterator[UnaskedInput]:
    """What no clause asks about of a wall, of its loads, its masonry and its building."""
    wall = scene.wall
    yield from _of_the_masonry(scene, wall)
    if wall.thickness is not None and any(load.is_weight and load.d_m is not None for load in wall.load):
        shifts = (-LEVER * wall.thickness, LEVER * wall.thickness)
        yield UnaskedInput("lift_lever", "d_m", tuple(partial(_shift_weights, by=by) for by in shifts))
    if wall.above_ground and scene.building is not None:
        yield from _of_the_building(wall, scene.building)


def _of_the_masonry(scene: CheckInput, wall: Wall) -> Iterator[UnaskedInput]:
    """Unit weight and modulus within Table C8.5.I, the hinge of the weakest masonry of the whole table."""
    given, (low, high) = wall.unit_weight_kn_m3, weights(wall.masonry)
    if given is not None and low <= given <= high and (wall.is_loaded or wall.kinematics.arches):
        ends = tuple(wall_change(unit_weight_kn_m3=weight) for weight in (low, high) if weight != given)
        yield UnaskedInput("weight_within_table", "unit_weight_kn_m3", ends)
    modulus, (least, most) = wall.elastic_modulus_mpa, moduli(wall.masonry)
    if modulus is not None and wall.in_si.is_free(scene.mechanism) and least < modulus <= most:
        yield UnaskedInput("modulus_within_table", "elastic_modulus_mpa", (wall_change(elastic_modulus_mpa=least),))
    if wall.masonry and wall.compressive_strength_mpa is None and not wall.kinematics.arches:
        end = turning_inside(wall, setback_at(wall, None), masonry=None)
        yield UnaskedInput("lift_masonry", "masonry", (end,))


def _shift_weights(scene: CheckInput, by: float) -> CheckInput:
    """The wall with its weights further inward [m], within its thickness."""
    thickness = require_value(scene.wall.thickness)

    def shifted(load: Load) -> Load:
        if not load.is_weight or load.d_m is None:
            return load
        return replace(load, d_m=min(max(load.d_m + by, 0.0), thickness))

    return scene.replace_parts(wall=replace(scene.wall, load=tuple(map(shifted, scene.wall.load))))


def _of_the_building(wall: Wall, building: Building) -> Iterator[UnaskedInput]:
    """Period and storeys of a building, and the height at which its motion is taken."""
    expected = estimated_period(building.height_m)
    ends = tuple(partial(at_period, period=share * expected) for share in (*PERIODS, 1.0))
    yield UnaskedInput("period_range", "period_s", ends)
    storey = building.height_m / building.storeys
    if not MIN_STOREY <= storey <= MAX_STOREY and not building.modes:
        many = int(-(-building.height_m // MIN_STOREY))
        yield UnaskedInput("lift_storeys", "storeys", (partial(with_building, storeys=many),))
    half = wall.in_si.bare.centroid[1] if wall.has_shape else 0.5 * (wall.height_m or wall.block().height)
    centroid = min(require_value(wall.base_z_m) + half, building.height_m)
    if not building.modes and centroid > require_value(wall.demand_height_m):
        yield UnaskedInput("at_centroid", "base_z_m", (wall_change(base_z_m=centroid),))
