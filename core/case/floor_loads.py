"""What the rest of a building brings to a wall: the loads of its floors, the thrust of walls that span to a corner."""

from collections.abc import Iterator
from dataclasses import replace

from core.case.loads import Load
from core.case.schema import Case
from core.case.site import Building, FloorLoad
from core.case.solids import Corner
from core.case.spanning import make_spanning_part
from core.case.wall import Wall
from core.errors import InputError, place, section
from core.known import require_value
from core.text.sentence import Key
from core.wall.arch import MIN_THRUST


def add_floor_loads(wall: Wall, building: Building | None) -> Wall:
    """The wall with the floors that bear on it, each with half of its span, after its own loads."""
    floors = building.floors if building else ()
    loads = [_load(floor, d, require_value(wall.base_z_m)) for floor in floors for d in floor.bears_on(wall.name)]
    if not loads:
        return wall
    return replace(wall, load=(*wall.load, *loads), unloaded_confirmed=False)


def infer_floor_supports(building: Building | None, wall: Wall, brought_to: Wall) -> Building | None:
    """The building with the places at which its floors bear on a wall taken from the wall they were brought to.

    wall : of the case; brought_to : the same with its floors, whose places moved
    """
    if building is None:
        return None
    places, floors = iter(brought_to.load[len(wall.load) :]), []
    for floor in building.floors:
        ends = {"from_d_m": floor.from_wall, "to_d_m": floor.to_wall}
        moved = {key: next(places).d_m for key, name in ends.items() if name == wall.name}
        floors.append(replace(floor, **moved))  # type: ignore[arg-type]
    return replace(building, floors=tuple(floors))


def _load(floor: FloorLoad, d: float, base: float) -> Load:
    """The load of a floor on a wall. d : from its outer face [m]; base : of the wall above the ground [m]"""
    share, q = 0.5 * floor.span_m, floor.q_kn_m2
    return Load(
        "vertical",
        h_m=floor.level_m - base,
        d_m=d,
        mass=floor.mass,
        g_kn_m=share * floor.g_kn_m2,
        q_kn_m=None if q is None else share * q,
        psi_2=floor.psi_2,
    )


def isolate_wall(case: Case, k: int) -> Case:
    """A case with one of its walls alone: what the rest of the building brings to it is its own load."""
    building, wall = case.building, add_floor_loads(case.wall[k], case.building)
    if building is not None and building.floors:
        case = replace(case, building=replace(building, floors=()))
    wall = replace(wall, hold=tuple(replace(hold, corner_wall="", corner_side=None) for hold in wall.hold))
    return replace(case, wall=(wall,))


def add_corner_thrust(wall: Wall) -> Wall:
    """A corner, or a part of one above a hinge, with what pushes it along and across its walls as a load: over its
    height, in the direction in which it turns."""
    if (corner := wall.corner) is None or not corner.is_pushed:
        return wall
    height = require_value(wall.height_m)
    load = Load("thrust", corner.outward_push * height / require_value(wall.length_m), 0.5 * height)
    plain = replace(corner, thrust_1_kn_m=0.0, thrust_2_kn_m=0.0, across_1_kn_m=0.0, across_2_kn_m=0.0)
    return replace(wall, corner=plain, load=(*wall.load, load), unloaded_confirmed=False)


def check_floors(building: Building | None) -> None:
    """Raise InputError for a floor of which half of something is given."""
    for here, floor in _placed(building):
        if bool(floor.to_wall) != (floor.to_d_m is not None):
            raise InputError("floor_to", place=here, key="to_d_m" if floor.to_wall else "to_wall")
        if (floor.q_kn_m2 is None) != (floor.psi_2 is None):
            raise InputError("combined_share", place=here)
        if floor.to_wall == floor.from_wall:
            raise InputError("floor_on_itself", place=here, key="to_wall", wall=floor.to_wall)
    for n, (here, floor) in enumerate(floors := list(_placed(building))):
        if twin := next((other for _, other in floors[:n] if replace(other, name=floor.name) == floor), None):
            raise InputError("floor_twice", place=here, twin=twin.name)


def _placed(building: Building | None) -> Iterator[tuple[tuple, FloorLoad]]:
    """Floors of a building with the place of an error."""
    for n, floor in enumerate(building.floors if building else (), start=1):
        yield (section("[building]"), place("floor", n=n, name=floor.name)), floor


def check_floors_on(wall: Wall, building: Building | None) -> None:
    """Raise InputError for a floor that cannot bear on a wall."""
    for here, floor in _placed(building):
        for d in floor.bears_on(wall.name):
            given = {"base_z_m": wall.base_z_m, "height_m": wall.height_m, "thickness_m": wall.thickness}
            given |= {"unit_weight_kn_m3": wall.unit_weight_kn_m3}
            if missing := next((key for key, value in given.items() if value is None), None):
                raise InputError("floor_needs", place=here, key=missing, wall=wall.title)
            assert wall.base_z_m is not None and wall.height_m is not None and wall.thickness is not None
            if wall.unloaded_confirmed:
                raise InputError("floor_on_unloaded", place=here, key="unloaded_confirmed", wall=wall.title)
            low, high = wall.base_z_m, wall.base_z_m + wall.height_m
            if not low < floor.level_m <= high + 1e-9:
                said = {"low": low, "high": high, "wall": wall.title}
                raise InputError("floor_off_wall", place=here, key="level_m", found=floor.level_m, **said)
            if d > wall.thickness:
                raise InputError(
                    "floor_off_face", place=here, key="from_d_m", found=d, most=wall.thickness, wall=wall.title
                )


def floor_at(wall: Wall, building: Building | None, number: int) -> FloorLoad | None:
    """The floor that a load of `brought` comes from, by its number from 1; None of a load of the wall."""
    floors = building.floors if building else ()
    bearing = [floor for floor in floors for _ in floor.bears_on(wall.name)]
    k = number - 1 - len(wall.load)
    return bearing[k] if 0 <= k < len(bearing) else None


class WallSetChecker:
    """What the walls of a case are to each other: floors name walls of it, and a wall that spans to a corner pushes it
    with no more than the corner is checked with, along the wall it goes on from and across it. `saw` of each wall, then
    `check`."""

    def __init__(self, building: Building | None):
        self.building = building
        floors = building.floors if building else ()
        self.unseen = {name for floor in floors for name in (floor.from_wall, floor.to_wall) if name}
        self.pushed: list[tuple[Wall, str]] = []
        self.corners: dict[str, list[Corner]] = {}

    def saw(self, wall: Wall) -> None:
        """One more wall of the case."""
        self.unseen.discard(wall.name)
        corner, arch = wall.corner, wall.arch
        if corner is not None:
            self.corners.setdefault(wall.name, []).append(corner)
        if arch is not None and arch.corner_wall:
            self.pushed.append((wall, arch.corner_wall))

    def check(self) -> None:
        """Raise InputError where a wall that is named is none, or a corner takes more than it is checked with."""
        for here, floor in _placed(self.building):
            for key, name in (("from_wall", floor.from_wall), ("to_wall", floor.to_wall)):
                if name in self.unseen:
                    raise InputError("wall_not_there", place=here, key=key, found=name)
        pushes: dict[tuple[str, int], dict[str, tuple[float, float]]] = {}
        for wall, name in self.pushed:
            here = (place("wall", name=wall.title), place("hold", n=1 + wall.hold.index(require_value(wall.arch))))
            if name not in self.corners:
                said = {"found": name, "corner": Key("[wall.corner]")}
                raise InputError("corner_not_there", place=here, key="corner_wall", **said)
            side = require_value(require_value(wall.arch).corner_side)
            of_corner = pushes.setdefault((name, side), {})
            before = of_corner.get(wall.name, (0.0, 0.0))  # its variants are one wall
            of_corner[wall.name] = tuple(map(max, before, _on_corner(wall)))  # type: ignore[assignment]
            thrust, across = map(sum, zip(*of_corner.values(), strict=True))
            given = [
                min(pushes) for pushes in zip(*(corner.pushes[side - 1] for corner in self.corners[name]), strict=True)
            ]
            if thrust > given[0] + 1e-9 or across > given[1] + 1e-9:
                said = {"corner": name, "thrust": thrust, "across": across, "given": given[0], "given_across": given[1]}
                keys = {"one": Key(f"thrust_{side}_kn_m"), "other": Key(f"across_{side}_kn_m")}
                raise InputError("corner_thrust", place=here, key="corner_wall", **said, **keys)


def _on_corner(wall: Wall) -> tuple[float, float]:
    """(H, V) that the ends of a wall push with along and across it [kN/m]. Ties along it pull only as the ends part:
    before, and after one breaks, the masonry beyond carries the arch, and the corner takes what that gives; nothing
    where there is none. V : all that holds an end across, of which the corner is asked"""
    arch = require_value((make_spanning_part(wall) if not wall.kinematics.arches else wall).in_si.arch)
    if arch.tied:
        if arch.shoulder <= MIN_THRUST:
            return 0.0, 0.0
        arch = arch.without_tie
    return 1e-3 * arch.thrust, 1e-3 * arch.held_across
