"""What would make a wall that fails pass: measures on the wall, each passing about all its hinges and mechanisms.

The size of a measure is searched by the checks of the clauses, which take milliseconds, and by a few histories around
the demand, and confirmed by the wall with all of them, as a run makes them; where these ask for more it grows, and one
that no size makes pass is no measure.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from core.boundary import narrowed, written_up
from core.case.document import Document
from core.case.hinges import make_wall_parts, storey_ends
from core.case.hold import TIE, Hold
from core.case.register import find_mechanisms_left_out
from core.case.schema import Case
from core.case.wall import Wall
from core.codes.dynamic_check import check_around_demand
from core.codes.multiplier_search import Precision
from core.errors import InputError
from core.known import require_value
from core.setting.plan import FloorCache
from core.text.sentence import Key, Number, Sentence, sentence
from core.variation.assessment import assess_evaluation
from core.variation.changes import rescale_thickness
from core.variation.evaluate import FULL_PRECISION
from core.variation.wall_evaluation import NO_EVALUATION, WallContext, WallEvaluation, evaluate_wall, replace_wall
from core.wall.ties import bars_for

MOST = 3
"""Measures that are named, at the most."""

BAR_LENGTH, STRAIN, SPACING = 8.0, 0.03, 2.0
"""Length of a bar of a tie that is proposed [m], the elongation it stands over that, and the spacing along the wall
[m]."""

GROWTH, MIN_SIZES = 1.5, 8
"""Factor between two sizes that are tried, and least number of them."""

BETWEEN = 8
"""Steps between two sizes of which one lets the wall move in another way."""

MORE, TRIES = 1.15, 8
"""Factor by which a size grows where histories ask for more, and how many sizes are looked at with them."""

CLOSE = 0.05
"""Width of the bracket of a size, of the size [-]."""

NEARLY = Precision(enough=1.25)
"""zeta of a hinge is searched up to here: that of a wall that just passes, which the worst of its hinges has, lies
below."""

LEAST_FORCE, MOST_FORCE = 0.2, 100.0
"""Forces that are tried [kN/m]."""

OF_FORCE = "measure_tie", "measure_hold", "measure_ties"
"""Measures whose size is a force."""

INSTEAD = "measure_ties", "measure_thickness"
"""Measures that are sought where no other makes a wall pass: ties at all floors hold as floors that are connected do,
and a wall that stands is seldom made thicker."""

NEAR_TOP, LOWEST_TIE = 0.95, 0.6
"""Height of a tie in a wall of which no floor is known, and lowest height of one alone, of the wall [-]."""

NEAR = 0.05
"""Holds nearer than this are at one height [m]."""

SHOWN = Document("calculation", "1")
"""What a floor that is proposed is held by: its connection is to be designed."""

PROPOSED = Hold(TIE, bar_length_m=BAR_LENGTH, elongation_m=STRAIN * BAR_LENGTH, evidence=SHOWN)
"""A tie that is proposed, without its force and its height."""


class MeasureKind(NamedTuple):
    """A kind of measure.

    code : of its sentence
    change : the wall with a measure of a size
    least, most : size that changes the wall the least, and the one that changes it most, of those that are tried
    step : last digit of the size
    heights : at which it acts [m]; spacing : of its bars [m]
    """

    code: str
    change: Callable[[float], Wall]
    least: float
    most: float
    step: float
    heights: tuple[float, ...] = ()
    spacing: float = SPACING

    @property
    def rises(self) -> bool:
        """Whether a larger size is more."""
        return self.most > self.least

    @property
    def sizes(self) -> list[float]:
        """Sizes that are tried, the least first: a strong tie may let a wall bend that a weaker one held as one
        block."""
        steps = max(MIN_SIZES, math.ceil(abs(math.log(self.most / self.least)) / math.log(GROWTH)))
        return spread(self.least, self.most, steps)

    def rounded(self, size: float) -> float:
        """A size with its last digit, to the side that is more."""
        return written_up(size, self.step) if self.rises else self.step * math.floor(size / self.step + 1e-9)


@dataclass(frozen=True)
class Measure:
    """A measure that makes a wall pass. size : force [kN/m], thickness or height [m], share of a thrust [-]; zeta : of
    the wall with it; heights : at which it acts [m]; spacing : of its bars along the wall [m]; to_show : keys of what
    documents must show then, by the checks of the clauses; to_look_at : names of mechanisms that are not looked at"""

    code: str
    size: float
    zeta: float | None
    heights: tuple[float, ...] = ()
    spacing: float = SPACING
    to_show: tuple[str, ...] = ()
    to_look_at: tuple[str, ...] = ()

    @property
    def bar(self) -> tuple[int | None, int | None]:
        """(diameter, thread) of the bars of a tie [mm]; None where none holds it."""
        return bars_for(1e3 * self.size, self.spacing) if self.code in OF_FORCE else (None, None)

    @property
    def is_single_tie(self) -> bool:
        """Whether it is a tie at one height."""
        return self.code == "measure_tie"

    @property
    def short(self) -> Sentence:
        """It in a table."""
        heights = tuple(Number(height, ".4g") for height in self.heights)
        return sentence("short", self.code, size=Number(self.size, ".4g"), zeta=Number(self.zeta), heights=heights)

    @property
    def words(self) -> Sentence:
        """What it is, with its size and zeta."""
        diameter, thread = self.bar
        bars = sentence("added", "nothing")
        if diameter is not None:
            bars = sentence("added", "bars", diameter=diameter, thread=thread, spacing=self.spacing)
        heights = tuple(Number(height, ".4g") for height in self.heights)
        values = {"size": Number(self.size, ".4g"), "zeta": Number(self.zeta), "heights": heights, "bars": bars}
        values["shown"] = values["looked_at"] = sentence("added", "nothing")
        if self.to_show:
            values["shown"] = sentence("added", "once_shown", keys=tuple(map(Key, self.to_show)))
        if self.to_look_at:
            names = tuple(sentence("mechanism", name) for name in self.to_look_at)
            values["looked_at"] = sentence("added", "once_looked_at", names=names)
        return sentence("reason", self.code, **values)


def find_measures(
    setting: WallContext, cancelled: Callable[[], bool] = lambda: False, sought: Hold | None = None
) -> tuple[Measure, ...]:
    """Measures that make the wall of a setting pass, MOST of them at the most. sought : the tie that is to be designed,
    which says where one goes and with what bar. Raises Cancelled."""
    found: list[Measure] = []
    for kind in measure_kinds(setting, sought):
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

    def there(size: float, precision: Precision = FULL_PRECISION, **changes) -> WallEvaluation | None:
        try:
            changed = replace(replace_wall(setting, kind.change(size)), **changes)
            return evaluate_wall(changed, precision, None if changed.inputs[1] else floors, cancelled)
        except InputError:
            return None

    def at_demand(size: float) -> WallEvaluation:
        """By the clauses, and where these are satisfied by a few histories around the demand."""
        by_clauses = there(size, inputs=(setting.demand, [], [])) or NO_EVALUATION
        if not by_clauses.sure or not setting.has_histories:
            return by_clauses
        return there(size, histories=check_around_demand) or NO_EVALUATION

    size, before = find_first(at_demand, kind.sizes)
    if size is None:
        return None
    if before is not None:
        size = narrowed(lambda size: at_demand(size).sure, size, before, CLOSE).good
    for _ in range(TRIES):
        size = kind.rounded(size)
        evaluated = there(size, NEARLY) if at_demand(size).sure else None
        if evaluated is not None and evaluated.sure:
            evaluated = there(size) if evaluated.beyond else evaluated
        if evaluated is not None and evaluated.sure:
            to_show = _find_unshown(there(size, inputs=(setting.demand, [], [])) or NO_EVALUATION, cancelled)
            left_out = _find_left_out(setting.case, kind.change(size))
            return Measure(kind.code, size, evaluated.zeta, kind.heights, kind.spacing, to_show, left_out)
        size = size * MORE if kind.rises else size / MORE
    return None


KEY_OF_ACTION = {
    **dict.fromkeys(("to_evidence", "to_evidence_strength", "to_no_restraint", "to_no_top_restraint"), "hold"),
    "to_no_soil_factor": "soil_factor",
    "to_building": "[building]",
}
"""Code of what is to be done for a wall that passes its checks, but for a document -> what that is about."""


def _find_unshown(by_clauses: WallEvaluation, cancelled: Callable[[], bool]) -> tuple[str, ...]:
    """Keys that are still to be given or shown of a wall that passes by the clauses."""
    keys: list[str] = []
    for hinge in by_clauses.hinges:
        if hinge.satisfied:
            verdict = assess_evaluation(hinge, cancelled).verdict
            keys += [row.key for row in verdict.assumptions if row.turns and row.open]
            keys += [KEY_OF_ACTION[action.code] for action in verdict.to_do if action.code in KEY_OF_ACTION]
    return tuple(dict.fromkeys(keys))


def _find_left_out(case: Case, wall: Wall) -> tuple[str, ...]:
    """Names of the mechanisms of a wall with a measure that nobody looks at."""
    return find_mechanisms_left_out(make_wall_parts(0, wall, case.building), case.building)


def spread(least: float, most: float, steps: int) -> list[float]:
    """Sizes from one to another, of equal ratios."""
    return [least * (most / least) ** (k / steps) for k in range(steps + 1)]


def find_first(evaluate: Callable[[float], WallEvaluation], sizes: list[float]) -> tuple[float | None, float | None]:
    """(the least of some sizes with which a wall passes, the one tried before it); None where there is none. Between
    two of them of which one lets the wall move in another way some more are tried: what passes may be narrow."""
    before, number = None, None
    for size in sizes:
        evaluated = evaluate(size)
        if before is not None and number != len(evaluated.hinges):
            for inside in spread(before, size, BETWEEN)[1:-1]:
                if evaluate(inside).sure:
                    return inside, before
                before = inside
        if evaluated.sure:
            return size, before
        before, number = size, len(evaluated.hinges)
    return None, None


def measure_kinds(setting: WallContext, sought: Hold | None = None) -> Iterator[MeasureKind]:
    """Kinds of measures that a wall may have, those that leave it most as it is first. sought : as `find_measures`
    takes it"""
    wall = setting.case.wall[0]
    height, thickness = wall.height_m, wall.thickness
    forces = LEAST_FORCE, MOST_FORCE, 0.1
    if height is not None and wall.leans and wall.corner is None and not wall.bends:
        floors = find_floors(setting)
        top = max((floor for floor in floors if floor >= LOWEST_TIE * height), default=NEAR_TOP * height)
        tie, spacing = (PROPOSED, SPACING) if sought is None else describe_tie(sought)
        top = top if sought is None else require_value(sought.h_m)
        yield MeasureKind("measure_tie", lambda force: add_ties(wall, force, (top,), tie), *forces, (top,), spacing)
        if floors:
            yield MeasureKind("measure_hold", lambda force: hold_floors(wall, force, floors), *forces, floors)
        if len(floors) > 1:
            yield MeasureKind("measure_ties", lambda force: add_ties(wall, force, floors), *forces, floors)
    if height is not None and wall.kinematics.bends_up:
        yield MeasureKind("measure_hold", lambda force: hold_floors(wall, force, (height,)), *forces, (height,))
    if any(hold.spans for hold in wall.hold):
        yield MeasureKind("measure_ends", lambda force: hold_ends(wall, force), *forces)
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


def describe_tie(sought: Hold) -> tuple[Hold, float]:
    """(the tie that is sought as one that is there, of a bar that is proposed where it has none; spacing of its bars
    [m])."""
    length, elongation = sought.bar_length_m or BAR_LENGTH, sought.elongation_m
    if sought.bar_length_m is None:
        elongation = STRAIN * BAR_LENGTH
    tie = replace(PROPOSED, bar_length_m=length, elongation_m=elongation, evidence=sought.evidence or SHOWN)
    return tie, sought.spacing_m or SPACING


def add_ties(wall: Wall, force: float, heights: tuple[float, ...], tie: Hold = PROPOSED) -> Wall:
    """The wall with one more tie at each of these heights [m]. force : of each at yield [kN/m]; tie : its bar"""
    return replace(wall, hold=(*wall.hold, *(replace(tie, out_kn_m=force, h_m=height) for height in heights)))


def hold_floors(wall: Wall, force: float, heights: tuple[float, ...]) -> Wall:
    """The wall with its floors at these heights connected to it, each to stand a force outward [kN/m]."""

    def is_there(hold: Hold) -> bool:
        return hold.h_m is not None and not hold.is_bar and any(abs(hold.h_m - height) <= NEAR for height in heights)

    def connected(height: float) -> Hold:
        """A floor at a height [m], as stiff, or as ductile, as what is connected there now."""
        now = [hold for hold in wall.hold if is_there(hold) and abs((hold.h_m or 0.0) - height) <= NEAR]
        stiffness = max((hold.stiffness_kn_m2 for hold in now if hold.stiffness_kn_m2 is not None), default=None)
        yields = [hold.elongation_m for hold in now if hold.elongation_m is not None]
        stretched = min(yields) if yields and len(yields) == len(now) else None
        return Hold(
            "floor", h_m=height, out_kn_m=force, stiffness_kn_m2=stiffness, elongation_m=stretched, evidence=SHOWN
        )

    others = tuple(hold for hold in wall.hold if not is_there(hold))
    return replace(wall, hold=(*others, *map(connected, heights)))


def hold_ends(wall: Wall, force: float) -> Wall:
    """The wall with its ends between transverse walls held across, each to stand a force more than it does by friction
    [kN/m]."""
    held = (
        replace(hold, out_kn_m=(hold.out_kn_m or 0.0) + force, evidence=SHOWN) if hold.spans else hold
        for hold in wall.hold
    )
    return replace(wall, hold=tuple(held))


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
