"""One number of a case over a range: what each check of a wall gives, and q. The case stays as it is."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from core.case.floor_loads import isolate_wall
from core.case.held_top import move_top_loads
from core.case.hold import Bars, Hold
from core.case.loads import Load, ReturnWalls
from core.case.rules import parse_case
from core.case.schema import Case
from core.case.site import Building, Demand, Spectrum
from core.case.variant_of import ALTERNATIVES
from core.case.wall import Wall
from core.case.writer import table_of
from core.errors import InputError
from core.known import require_value
from core.setting.plan import select_case_records
from core.study.journal import MemoryJournal
from core.study.results import StudyResult
from core.study.run import run
from core.study.wall_verdict import counted_walls

NOT_SWEPT = ("zeta_target", "q_code")
"""Keys of the demand that name what is shown, the line required and a check."""

OF_GENERAL_BLOCK, OF_RECTANGLE = (
    ("radius_m", "inertia_over_mass_m2"),
    ("height_m", "thickness_m", "height_over_thickness"),
)
"""Sizes of a general block and of a rectangle, of which the other has none."""

MAX_VALUES = 200


@dataclass(frozen=True)
class SweepKey:
    """A key that is swept. section : its class; index : of the load or hold it is of, None where of none"""

    section: type
    name: str
    index: int | None = None


@dataclass(frozen=True)
class SweepPoint:
    """Checks and q at one value.

    value : of the key, as in the case file
    zeta : label of a check -> the lowest of all hinges and mechanisms, None where one of them has none
    q : the lowest of the same, None without a collapse
    verdict, zeta_e : of the wall; None without a demand
    error : why there are no numbers, None where there are
    """

    value: float
    zeta: dict[str, float | None]
    q: float | None = None
    verdict: str | None = None
    zeta_e: float | None = None
    error: InputError | None = None


def sweep_keys(case: Case, k: int) -> list[SweepKey]:
    """The numbers of the k-th wall, and of the case as far as it is given, that can be swept."""
    wall = case.wall[k]
    other = OF_GENERAL_BLOCK if wall.radius_m is None else OF_RECTANGLE
    keys = [key for key in _keys(Wall) if key.name not in other]
    for n, load in enumerate(wall.load):
        keys += _given(load, n)
    for n, hold in enumerate(wall.hold):
        keys += [] if hold.design else _given(hold, n)
        keys += _given(hold.bar, n) if hold.bar else []
    spectrum = case.demand.spectrum if case.demand else None
    for section in (wall.return_walls, case.demand, spectrum, case.building):
        keys += _given(section) if section else []
    return [key for key in keys if key.name not in NOT_SWEPT]


def _keys(section: type, index: int | None = None) -> list[SweepKey]:
    return [SweepKey(section, entry.name, index) for entry in fields(section) if entry.metadata["kind"] == "float"]


def _given(section: Any, index: int | None = None) -> list[SweepKey]:
    return [key for key in _keys(type(section), index) if getattr(section, key.name) is not None]


def value_at(case: Case, k: int, key: SweepKey) -> float | None:
    """The value of a key now; of a thickness the one that follows, where another size gives it."""
    wall = case.wall[k]
    if key.name == "thickness_m" and key.section is Wall:
        return wall.thickness
    return getattr(_holder(case, wall, key), key.name)


def _holder(case: Case, wall: Wall, key: SweepKey) -> Any:
    """The section a key is in."""
    if key.section is Load:
        return wall.load[require_value(key.index)]
    if key.section in (Hold, Bars):
        hold = wall.hold[require_value(key.index)]
        return hold if key.section is Hold else hold.bar
    spectrum = case.demand.spectrum if case.demand else None
    of_case = {ReturnWalls: wall.return_walls, Demand: case.demand, Spectrum: spectrum, Building: case.building}
    return ({Wall: wall} | of_case)[key.section]


def set_swept_value(case: Case, k: int, key: SweepKey, value: float) -> Case:
    """The case with the k-th wall alone and another value of a key; another way to give the same size goes, and no tie
    is sought. Raises InputError where a rule is broken."""
    case = isolate_wall(case, k)
    wall = case.wall[0]
    changed = replace(_holder(case, wall, key), **{key.name: value})
    if key.section is Wall:
        others = next((keys for keys in ALTERNATIVES if key.name in keys), ())
        empty: dict[str, Any] = {one: 0.0 if one == "hinge_setback_m" else None for one in others if one != key.name}
        wall = move_top_loads(wall, replace(changed, **empty))
    elif key.section is Load:
        wall = replace(wall, load=tuple(changed if n == key.index else load for n, load in enumerate(wall.load)))
    elif key.section in (Hold, Bars):
        hold = changed if key.section is Hold else replace(wall.hold[require_value(key.index)], bar=changed)
        wall = replace(wall, hold=tuple(hold if n == key.index else other for n, other in enumerate(wall.hold)))
    elif key.section is ReturnWalls:
        wall = replace(wall, return_walls=changed)
    elif key.section is Building:
        case = replace(case, building=changed)
    elif case.demand:
        case = replace(case, demand=replace(case.demand, spectrum=changed) if key.section is Spectrum else changed)
    case = replace(case, wall=(wall.without_sought(),), analysis=replace(case.analysis, accuracy=False))
    return parse_case(table_of(case))


def sweep(
    case: Case,
    k: int,
    key: SweepKey,
    values: Iterable[float],
    *,
    base_dir: Path,
    jobs: int = 1,
    finished: MemoryJournal | None = None,
    on_progress: Callable[[int, float], None] = lambda n, share: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[SweepPoint]:
    """A point for each value, in their order; a value that is refused has no numbers, and the others go on.

    k : of the wall
    base_dir, jobs : as of `core.study.run.run`
    finished : finished searches and checks, used and added to
    on_progress : index of the value and the share of it that is done
    Raises Cancelled.
    """
    memory = finished or MemoryJournal()
    case, _ = select_case_records(case, base_dir, cancelled=cancelled)  # the same records at every value
    for n, value in enumerate(values):

        def tell(done: int, of: int, left: float | None, n: int = n) -> None:
            on_progress(n, done / max(of, 1))

        options: dict[str, Any] = {"base_dir": base_dir, "jobs": jobs, "on_progress": tell, "cancelled": cancelled}
        try:
            result = run(set_swept_value(case, k, key, value), journal=lambda _: memory, **options)
        except InputError as error:
            yield SweepPoint(value, {}, error=error)
            continue
        yield make_sweep_point(value, result)


def make_sweep_point(value: float, result: StudyResult) -> SweepPoint:
    """Point of a sweep from the result of one wall."""
    zeta: dict[str, float | None] = {}
    for wall in counted_walls(result):
        for check in wall.assessment.checks if wall.assessment else ():
            known = zeta.get(check.label, check.zeta)
            zeta[check.label] = None if check.zeta is None or known is None else min(known, check.zeta)
    unknown = any(wall.set_rule == "incomplete" for wall in result.walls)
    q_values = [] if unknown else [wall.q_set for wall in result.walls if wall.q_set is not None]
    verdict = result.walls[result.verdicts[0].governing].required_assessment.verdict if result.verdicts else None
    return SweepPoint(
        value,
        zeta,
        min(q_values) if q_values else None,
        verdict.code if verdict else None,
        verdict.zeta_e if verdict else None,
    )
