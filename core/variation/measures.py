"""What would make a wall that fails pass: measures on the wall, each passing about all its hinges and mechanisms.

The size of a measure is searched by the checks of the clauses, which take milliseconds, and confirmed by the wall with
its histories, as a run makes them; where these ask for more it grows, and one that no size makes pass is no measure.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.boundary import narrowed, written_up
from core.case.document import Document
from core.case.hinges import storey_ends
from core.case.hold import TIE, Hold
from core.case.wall import Wall
from core.codes.dynamic_check import check_around_demand
from core.errors import InputError
from core.known import require_value
from core.setting.plan import FloorCache
from core.text.sentence import Number, Sentence, sentence
from core.variation.changes import rescale_thickness
from core.variation.wall_evaluation import WallContext, WallEvaluation, evaluate_wall, replace_wall
from core.wall.ties import bars_for

MOST = 3
"""Measures that are named, at the most."""

BAR_LENGTH, STRAIN, SPACING = 8.0, 0.03, 2.0
"""Length of a bar of a tie that is proposed [m], the elongation it stands over that, and the spacing along the wall
[m]."""

GROWTH, MIN_SIZES = 1.5, 8
"""Factor between two sizes that are tried by the clauses, and least number of them."""

MORE, TRIES = 1.15, 8
"""Factor by which a size grows where histories ask for more, and how many sizes are looked at with them."""

CLOSE = 0.05
"""Width of the bracket of a size, of the size [-]."""

LEAST_FORCE, MOST_FORCE = 0.2, 100.0
"""Forces that are tried [kN/m]."""

OF_FORCE = "measure_tie", "measure_hold", "measure_ties"
"""Measures whose size is a force."""

INSTEAD = "measure_ties", "measure_thickness"
"""Measures that are sought where no other makes a wall pass: ties at all floors hold as floors that are connected do,
and a wall that stands is seldom made thicker."""

NEAR_TOP, LOWEST_TIE = 0.95, 0.6
"""Height of a tie in a wall of which no floor is known, and lowest height of one alone, of the wall [-]."""

SHOWN = Document("calculation", "-")
"""What a floor that is proposed is held by: its connection is to be designed."""


class MeasureKind(NamedTuple):
    """A kind of measure.

    code : of its sentence
    change : the wall with a measure of a size
    least, most : size that changes the wall the least, and the one that changes it most, of those that are tried
    step : last digit of the size
    heights : at which it acts [m]
    """

    code: str
    change: Callable[[float], Wall]
    least: float
    most: float
    step: float
    heights: tuple[float, ...] = ()

    @property
    def rises(self) -> bool:
        """Whether a larger size is more."""
        return self.most > self.least

    @property
    def sizes(self) -> list[float]:
        """Sizes that are tried, the least first: a strong tie may let a wall bend that a weaker one held as one
        block."""
        steps = max(MIN_SIZES, math.ceil(abs(math.log(self.most / self.least)) / math.log(GROWTH)))
        return [self.least * (self.most / self.least) ** (k / steps) for k in range(steps + 1)]

    def rounded(self, size: float) -> float:
        """A size with its last digit, to the side that is more."""
        return written_up(size, self.step) if self.rises else self.step * math.floor(size / self.step + 1e-9)


@dataclass(frozen=True)
class Measure:
    """A measure that makes a wall pass. size : force [kN/m], thickness or height [m], share of a thrust [-]; zeta : of
    the wall with it; heights : at which it acts [m]"""

    code: str
    size: float
    zeta: float | None
    heights: tuple[float, ...] = ()

    @property
    def bar(self) -> tuple[int | None, int | None]:
        """(diameter, thread) of the bars of a tie [mm], SPACING apart; None where none holds it."""
        return bars_for(1e3 * self.size, SPACING) if self.code in OF_FORCE else (None, None)

    @property
    def words(self) -> Sentence:
        """What it is, with its size and zeta."""
        diameter, thread = self.bar
        bars = sentence("added", "nothing")
        if diameter is not None:
            bars = sentence("added", "bars", diameter=diameter, thread=thread, spacing=SPACING)
        heights = tuple(Number(height, ".4g") for height in self.heights)
        values = {"size": Number(self.size, ".4g"), "zeta": Number(self.zeta), "heights": heights, "bars": bars}
        return sentence("reason", self.code, **values)


def find_measures(setting: WallContext, cancelled: Callable[[], bool] = lambda: False) -> tuple[Measure, ...]:
    """Measures that make the wall of a setting pass, MOST of them at the most. Raises Cancelled."""
    found: list[Measure] = []
    for kind in measure_kinds(setting):
        if len(found) == MOST:
            break
        if found and kind.code in INSTEAD:
            continue
        measure = find_measure(setting, kind, cancelled)
        found += [] if measure is None else [measure]
    return tuple(found)


def find_measure(setting: WallContext, kind: MeasureKind, cancelled: Callable[[], bool]) -> Measure | None:
    """The measure of a kind, None where no size of it makes the wall pass."""

    floors = FloorCache()

    def there(size: float, **changes) -> WallEvaluation | None:
        try:
            changed = replace(replace_wall(setting, kind.change(size)), **changes)
            return evaluate_wall(changed, floors=None if changed.inputs[1] else floors, cancelled=cancelled)
        except InputError:
            return None

    def holds(size: float) -> bool:
        evaluated = there(size, inputs=(setting.demand, [], []))
        return evaluated is not None and evaluated.sure

    passing = next((size for size in kind.sizes if holds(size)), None)
    if passing is None:
        return None
    before = kind.sizes[kind.sizes.index(passing) - 1] if passing != kind.least else None
    size = passing if before is None else narrowed(holds, passing, before, CLOSE).good
    for _ in range(TRIES):
        size = kind.rounded(size)
        near = there(size, histories=check_around_demand) if holds(size) else None
        evaluated = there(size) if near is not None and near.sure else None
        if evaluated is not None and evaluated.sure:
            return Measure(kind.code, size, evaluated.zeta, kind.heights)
        size = size * MORE if kind.rises else size / MORE
    return None


def measure_kinds(setting: WallContext) -> Iterator[MeasureKind]:
    """Kinds of measures that a wall may have, those that leave it most as it is first."""
    wall = setting.case.wall[0]
    height, thickness = wall.height_m, wall.thickness
    forces = LEAST_FORCE, MOST_FORCE, 0.1
    if height is not None and wall.leans and wall.corner is None and not wall.bends:
        floors = find_floors(setting)
        top = max((floor for floor in floors if floor >= LOWEST_TIE * height), default=NEAR_TOP * height)
        yield MeasureKind("measure_tie", lambda force: add_ties(wall, force, (top,)), *forces, (top,))
        if floors:
            yield MeasureKind("measure_hold", lambda force: hold_floors(wall, force, floors), *forces, floors)
        if len(floors) > 1:
            yield MeasureKind("measure_ties", lambda force: add_ties(wall, force, floors), *forces, floors)
    if any(load.is_thrust and (load.kn_m or 0.0) > 0.0 for load in wall.load):
        yield MeasureKind("measure_thrust", lambda share: scale_thrusts(wall, share), 0.95, 0.05, 0.05)
    if height is not None and wall.kinematics.both_ways and not wall.has_shape:
        yield MeasureKind("measure_height", lambda lower: lower_top(wall, lower), 0.98 * height, 0.3 * height, 0.05)
    if thickness is not None and not wall.solid and wall.out_of_plumb_m is None:
        sizes = 1.02 * thickness, 2.0 * thickness, 0.01
        yield MeasureKind("measure_thickness", lambda more: rescale_thickness(wall, more), *sizes)


def find_floors(setting: WallContext) -> tuple[float, ...]:
    """Heights of floors and roofs above the base of a wall, by its holds, its loads or the storeys of its building
    [m]."""
    wall, building = setting.case.wall[0], setting.case.building
    by_hold = {require_value(hold.h_m) for hold in wall.restraints if hold.has_height}
    by_load = {load.h_m for load in wall.load if load.rests}
    by_storey = set(storey_ends(wall, building)) if building else set()
    return tuple(sorted(by_hold or by_load or by_storey))


def add_ties(wall: Wall, force: float, heights: tuple[float, ...]) -> Wall:
    """The wall with one more tie at each of these heights [m]. force : of each at yield [kN/m]"""
    tie = Hold(TIE, out_kn_m=force, bar_length_m=BAR_LENGTH, elongation_m=STRAIN * BAR_LENGTH, evidence=SHOWN)
    return replace(wall, hold=(*wall.hold, *(replace(tie, h_m=height) for height in heights)))


def hold_floors(wall: Wall, force: float, heights: tuple[float, ...]) -> Wall:
    """The wall with its floors at these heights connected to it, each to stand a force outward [kN/m]."""
    others = tuple(hold for hold in wall.hold if hold.h_m not in heights or hold.is_bar)
    held = tuple(Hold("floor", h_m=height, out_kn_m=force, evidence=SHOWN) for height in heights)
    return replace(wall, hold=(*others, *held))


def scale_thrusts(wall: Wall, share: float) -> Wall:
    """The wall with its outward thrusts reduced to a share of them."""
    loads = (
        replace(load, kn_m=share * require_value(load.kn_m)) if load.is_thrust and (load.kn_m or 0.0) > 0.0 else load
        for load in wall.load
    )
    return replace(wall, load=tuple(loads))


def lower_top(wall: Wall, height: float) -> Wall:
    """The wall with another height [m], what stands on its top on that."""
    loads = (replace(load, h_m=height) if load.h_m == wall.height_m else load for load in wall.load)
    return replace(wall, height_m=height, load=tuple(loads))
