"""The rules of a case: every one is applied here and in values.py, once, for file, table and form."""

import math
from collections.abc import Iterable
from dataclasses import fields, replace
from typing import NamedTuple

from core.case.detached import check_leaf
from core.case.document import check_evidence, document_of
from core.case.floor_loads import WallSetChecker, add_floor_loads, check_floors, check_floors_on, floor_at
from core.case.hazard_table import check_rising
from core.case.held_top import check_bends, check_held_top
from core.case.hinges import WallPart, check_hinges, make_wall_parts, turning_hinges, turns_above_ties
from core.case.hold_rules import check_holds, check_holds_of_building
from core.case.keys import is_required
from core.case.load_rules import check_given, check_loads, places_of_forces
from core.case.place import HERE, Site, apply_site, fill_from_site
from core.case.schema import Analysis, Case, Generate, Record, Report
from core.case.select import Select
from core.case.sensitivity import Ranges
from core.case.set_aside import check_set_aside
from core.case.shape_memory import check_known_shape
from core.case.site import FULL_FACTOR, KNOWLEDGE, Building, Demand, Spectrum
from core.case.spanning import check_arch
from core.case.spans_between_ties import find_bending_spans, has_load_below_tie
from core.case.values import (
    MAX_VALUE_SHOWN,
    are_ends,
    field_of,
    parse_corners,
    parse_section,
    parse_value,
    quote_value,
    refuse_unknown,
)
from core.case.variant_of import expand_variants
from core.case.wall import FOUND, Wall, leans_on_something
from core.codes.limits import check_return_period
from core.codes.spectrum_codes import refuse_faulty, requires_key
from core.errors import InputError, place, section
from core.text.catalogue import CATALOGUE
from core.text.sentence import Key, Quantity, sentence

TESTED_STRENGTH = (0.5, 10.0)
"""Compressive strengths of masonry [MPa] that tests give."""


TIE_METHODS = ("auto", "taylor", "taylor_6")
"""Methods that know a tie; all of them are then the one of order 8."""


def parse_case(table: dict) -> Case:
    """The case of a mapping with the keys of the file; every rule is checked here, once."""
    table = expand_variants(table)
    case = parse_sections(table)
    walls = [parse_wall_entry(entry, k) for k, entry in enumerate(_walls_of(table))]
    return replace_walls(case, walls) if case.walls is None else replace(case, wall=tuple(walls))


def _walls_of(table: dict) -> Iterable:
    """The tables of the walls of a case: beside a demand with the mechanism of those that leave it out, the same of
    both variants of a wall."""
    walls = tables_of(table, "wall")
    if "demand" not in table and "site" not in table:
        return walls
    keys = [wall for wall in walls if isinstance(wall, dict)]
    leaning = {repr(wall.get("name")) for wall in keys if leans_on_something(wall)}
    found = {"mechanism": FOUND[True]}
    return [
        {**found, **wall} if isinstance(wall, dict) and repr(wall.get("name")) in leaning else Wall.with_mechanism(wall)
        for wall in walls
    ]


def parse_sections(table: dict) -> Case:
    """The case of a mapping without its walls, of which only the places that are given are noted."""
    refuse_unknown(Case, table, "case")
    language = str(table["report"].get("language")) if isinstance(table.get("report"), dict) else ""
    if language in CATALOGUE.faults:
        folder, why = CATALOGUE.faults[language]
        raise InputError("language_damaged", place=(section("[report]"),), key="language", folder=folder, reason=why)
    title = parse_value(field_of(Case, "title"), table.get("title", "Ribalta"))
    analysis = parse_section(Analysis, table.get("analysis", {}), "analysis", section("[analysis]"))
    if round(analysis.robust_window / math.log1p(analysis.q_step)) < 1:
        raise InputError(
            "window_below_step",
            place=(section("[analysis]"),),
            window=Quantity("robust_window", analysis.robust_window),
            step=Quantity("q_step", analysis.q_step),
        )
    records = [
        parse_section(Record, entry, "record", place("record", n=k + 1))
        for k, entry in enumerate(tables_of(table, "record"))
    ]
    for k, record in enumerate(records):
        if record.scale == 0.0:
            accepted = sentence("accepted", "not_zero")
            here = place("record", n=k + 1)
            raise InputError("not_accepted", place=(here,), key="scale", value=0, accepted=accepted)
    site = parse_section(Site, table["site"], "site", HERE) if "site" in table else None
    demand = table.get("demand")
    if site is not None:
        site.hazard  # noqa: B018  (a place outside the grid is refused, with a demand or without)
        demand = fill_from_site(site, demand) if isinstance(demand, dict) else demand
    generate = table.get("generate")
    case = Case(
        title=title,
        report=parse_section(Report, table.get("report", {}), "report", section("[report]")),
        record=tuple(records),
        walls=parse_value(field_of(Case, "walls"), table["walls"]) if "walls" in table else None,
        generate=parse_section(Generate, generate, "generate", section("[generate]")) if generate is not None else None,
        select=parse_section(Select, table["select"], "select", section("[select]")) if "select" in table else None,
        analysis=analysis,
        demand=_demand(demand) if demand is not None else None,
        building=_building(table["building"]) if "building" in table else None,
        site=site,
        sensitivity=_sensitivity(table),
        given=frozenset(_written(table)),
    )
    if case.demand and case.demand.demand_scaling == "pga":
        for k, record in enumerate(records, start=1):
            if record.scale not in (1.0, -1.0):
                here = place("record", n=k)
                raise InputError("scale_and_pga_scaling", place=(here,), key="scale", found=record.scale)
    if case.generate and not (case.demand and (case.demand.spectrum or case.demand.spectrum_file)):
        raise InputError("generate_needs_spectrum")
    if case.select:
        _check_select(case)
    return case


def parse_wall_entry(entry, k: int) -> Wall:
    """The k-th wall of a case, its keys checked one by one. Raises InputError."""
    return parse_section(Wall, entry, "wall", place("wall", name=_name(entry, k)))


def parse_draft(table: dict) -> Case:
    """The case of a mapping that may not be complete: unknown keys are refused, values are taken as they
    are, a missing one is empty. For work in progress; `parse_case` decides what can run."""
    table = expand_variants(table)
    refuse_unknown(Case, table, "case")

    def part(cls, content, name):
        if not isinstance(content, dict):
            raise InputError("not_a_table_of_keys", name=name, value=quote_value(content))
        refuse_unknown(cls, content, name)
        values = {entry.name: "" for entry in fields(cls) if is_required(entry)}
        for entry in fields(cls):
            if entry.name in content:
                values[entry.name] = value(entry, content[entry.name], name)
        return cls(**values)

    def value(entry, given, name):
        # what breaks a rule with others may be work in progress, what is of another kind is not
        kind, of = entry.metadata["kind"], entry.metadata.get("of")
        if kind == "tables" and isinstance(given, (list, tuple)):
            return tuple(part(of, row, entry.name) for row in given)
        if kind in ("section", "spectrum"):
            return part(of, given, entry.name)
        if kind == "polygon" and (corners := parse_corners(given)) is not None:
            return corners
        return given if kind == "law" and are_ends(given) else parse_value(entry, given, name)

    def one(cls, name):
        return part(cls, table[name], name) if name in table else None

    return Case(
        title=parse_value(field_of(Case, "title"), table.get("title", "Ribalta")),
        report=one(Report, "report") or Report(),
        wall=tuple(part(Wall, entry, "wall") for entry in tables_of(table, "wall")),
        record=tuple(part(Record, entry, "record") for entry in tables_of(table, "record")),
        generate=one(Generate, "generate"),
        select=one(Select, "select"),
        analysis=one(Analysis, "analysis") or Analysis(),
        demand=apply_site(one(Site, "site"), one(Demand, "demand")),
        building=one(Building, "building"),
        site=one(Site, "site"),
        sensitivity=one(Ranges, "sensitivity"),
        given=frozenset(_written(table)),
    )


class AcceptedWall(NamedTuple):
    """A wall that breaks no rule of its own or with the rest of its case.

    whole : with the floors that bear on it; beside : `wall_dependencies` then; hinges : about which it turns
    above : names of its parts above them; heights : above the ground at which they are felt [m]
    """

    wall: Wall
    whole: Wall
    beside: tuple
    hinges: tuple[float, ...]
    above: tuple[str, ...]
    heights: frozenset[float]


def replace_walls(case: Case, walls: list[Wall], accepted: dict[int, AcceptedWall] | None = None) -> Case:
    """The case with these walls, checked as a set. Raises InputError. accepted : by `id`, those checked before, of
    which only what is beside them is looked at again, where it is another; the others are added"""
    accepted, beside = {} if accepted is None else accepted, wall_dependencies(case)
    # the same object where it is equal: of 200 walls each would be compared twice
    beside = next((one.beside for one in accepted.values() if one.beside == beside), beside)
    if not walls:
        raise InputError("no_wall", section=Key("[[wall]]"))
    check_floors(case.building)
    names = set[str]()
    for wall in walls:
        if not wall.name.strip():
            raise InputError("blank_name", key="name")
        if wall.title in names:
            raise InputError("same_name", key="name", wall=wall.title)
        names.add(wall.title)
        known = accepted.get(id(wall))
        if known is None or known.beside is not beside:
            check_wall(case, wall, alone=known is None)
    case = replace(case, wall=tuple(walls), walls=None)
    heights: set[float] = set()
    together = WallSetChecker(case.building)
    for k, wall in enumerate(walls):
        together.saw(wall)
        known = accepted.get(id(wall))
        if known is not None and known.beside is not beside:
            same = known.whole == add_floor_loads(wall, case.building)
            same = same and known.hinges == tuple(turning_hinges(wall, case.building))
            known = known._replace(beside=beside) if same else None
        if known is None:
            known = _accepted(k, wall, case.building, names, beside)
        elif taken := next((name for name in known.above if name in names), None):
            raise InputError("same_name", key="name", wall=taken)
        accepted[id(wall)] = known
        heights |= accepted[id(wall)].heights
    if len(heights) > 1:
        refuse_modes(case, min(heights), max(heights))
    together.check()
    return replace(case, sha256=case.digest())


def _accepted(k: int, wall: Wall, building: Building | None, names: set[str], beside: tuple) -> AcceptedWall:
    """Check the parts of a wall above its hinges. Raises InputError. names : of the walls of the case"""
    parts = make_wall_parts(k, wall, building)
    for part in parts:
        if not part.is_whole and part.wall.name in names:
            raise InputError("same_name", key="name", wall=part.wall.name)
        check_part(part)
    heights = (part.wall.demand_height_m for part in parts if part.wall.above_ground)
    above = tuple(part.wall.name for part in parts if not part.is_whole)
    hinges = tuple(part.hinge for part in parts[1:] if part.turns)
    felt = frozenset(z for z in heights if z is not None)
    return AcceptedWall(wall, add_floor_loads(wall, building), beside, hinges, above, felt)


def check_part(part: WallPart) -> None:
    """Raise InputError for a part of a wall that does not stand, or cannot be as the wall is asked to be."""
    wall, whole = part.wall, part.body
    try:
        bends = bool(find_bending_spans(whole, (part.hinge,))) or turns_above_ties(whole, part.hinge)
        bends = bends or (bool(part.aspect) and not has_load_below_tie(whole))
        check_loads(wall, places_of_forces(whole, part.hinge), bends=bends)
    except InputError as error:
        corner, leaf = whole.corner, part.asked.leaf
        if error.code == "tie_too_strong" and part.aspect and leaf is not None:
            raise InputError("leaf_held", place=(place("wall", name=part.asked.title), place("leaf"))) from None
        if error.code != "unstable_under_loads" or corner is None or not corner.is_pushed:
            raise
        raise InputError("corner_pushed_over", place=error.place, key="corner_wall") from None
    if wall.kinematics.bends_up and part.top is not None:
        check_bends(wall)
    elif part.hinge and part.top is None:
        check_given(wall)
        for mechanism in wall.mechanisms():
            wall.restitution_of(mechanism)


def wall_dependencies(case: Case) -> tuple:
    """What `check_wall` and the hinges of a wall read of the rest of a case."""
    demand, analysis = case.demand, case.analysis
    confidence = demand and (demand.confidence_factor, demand.knowledge_level, demand.evidence)
    return analysis.method, analysis.accuracy, confidence, case.building


def check_wall(case: Case, wall: Wall, alone: bool = True) -> None:
    """Raise InputError for a wall that breaks a rule of its own or one with the rest of the case. alone : whether those
    of its own are to be checked too"""
    if alone:
        _check_alone(wall)
    _check_beside(case, wall)
    if alone:
        _check_reasons(wall)


def _check_alone(wall: Wall) -> None:
    """Refuse a wall without a shape, or one that no motion can be made of."""
    if wall.drawing:
        here = (place("wall", name=wall.name),)
        raise InputError("drawing_not_read", place=here, key="drawing", file=wall.drawing[0].file)
    try:
        check_known_shape(wall)
        wall.bare_block()
        check_given(wall)
        check_held_top(wall)
        check_holds(wall)
        for n, entry in enumerate(wall.set_aside, start=1):
            check_set_aside(entry, wall.height_m, (place("wall", name=wall.title), place("set_aside", n=n)))
        check_arch(wall)
        check_leaf(wall)
        for mechanism in wall.mechanisms():
            wall.restitution_of(mechanism)
        wall.moment_law()
    except InputError as error:
        raise error.at(place("wall", name=wall.title)) from None


def _check_beside(case: Case, wall: Wall) -> None:
    """Refuse a wall beside a method, a demand or a building that is not for it; all that is read of these is in
    `wall_dependencies`."""
    _check_exact(case, wall)
    if case.analysis.method == "linearised" and not wall.moment_law().is_rigid:
        raise InputError("linearised_is_rigid", place=(section("[analysis]"),), key="method", wall=wall.title)
    if case.building and (wall.base_z_m or 0.0) > case.building.height_m:
        raise InputError(
            "base_above_building",
            place=(place("wall", name=wall.title),),
            key="base_z_m",
            base=wall.base_z_m,
            height=case.building.height_m,
        )
    check_holds_of_building(wall, case.building)
    check_hinges(wall, case.building)
    check_floors_on(wall, case.building)
    if (whole := add_floor_loads(wall, case.building)) is not wall:
        _check_with_floors(wall, whole, case.building)
    if case.demand and wall.base_z_m is None:
        raise InputError("base_missing", place=(place("wall", name=wall.title),), key="base_z_m")
    if case.demand:
        check_confidence(case.demand, wall)


def _check_with_floors(wall: Wall, whole: Wall, building: Building | None) -> None:
    """Refuse a wall that breaks a rule of its own with the floors that bear on it. whole : with them"""
    try:
        _check_alone(whole)
    except InputError as error:
        for k, there in enumerate(error.place):
            number = dict(getattr(there, "values", ())).get("n") if getattr(there, "code", "") == "load" else None
            floor = floor_at(wall, building, number) if isinstance(number, int) else None
            if floor is not None and building is not None:
                named = place("floor", n=building.floors.index(floor) + 1, name=floor.name)
                error.place = (*error.place[:k], named, *error.place[k + 1 :])
        raise


def _check_reasons(wall: Wall) -> None:
    """Refuse reasons of a wall that say nothing."""
    check_evidence(wall.evidence, (place("wall", name=wall.title),))


def _check_exact(case: Case, wall: Wall) -> None:
    """Refuse a method that has no bars and no unlike sides, and a statement of accuracy by such methods."""
    method, here = case.analysis.method, (section("[analysis]"),)
    if any(hold.is_tie for hold in wall.hold) or (wall.leaf is not None and wall.leaf.connector_kn_m):
        if method not in TIE_METHODS:
            raise InputError("tie_method", place=here, key="method", found=method)
        if case.analysis.accuracy:
            raise InputError("tie_accuracy", place=here, key="accuracy")
    if wall.is_asymmetric and wall.kinematics.rocks_both_ways:
        if method not in TIE_METHODS:
            raise InputError("unlike_method", place=here, key="method", found=method)
        if case.analysis.accuracy:
            raise InputError("unlike_accuracy", place=here, key="accuracy")


def refuse_modes(case: Case, low: float, high: float) -> None:
    """Raise InputError where walls at two heights [m] are in a case whose building has modes, which are of one."""
    if case.building and case.building.modes:
        raise InputError("modes_at_one_height", place=(section("[building]"),), key="modes", low=low, high=high)


def check_confidence(demand: Demand, wall: Wall) -> None:
    """Refuse an FC below 1.35 for a wall whose compressive strength is not in alpha, or without the level of knowledge
    and the investigations that it follows from (Circolare 7/2019 C8.7.1.2.1, Tab. C8.5.IV)."""
    stated = demand.confidence_factor
    if stated >= FULL_FACTOR:
        return
    here, level = (section("[demand]"),), demand.knowledge_level
    least = KNOWLEDGE.get(level or "")
    if least is None or document_of(demand.evidence, "confidence_factor") is None:
        raise InputError("low_confidence_factor", place=here, stated=stated)
    if stated < least:
        raise InputError("confidence_below_level", place=here, stated=stated, level=level, least=least)
    (low, high), strength = TESTED_STRENGTH, wall.compressive_strength_mpa
    here, said = (place("wall", name=wall.title),), {"stated": stated, "low": low, "high": high}
    if strength is None:
        raise InputError("confidence_needs_strength", place=here, key="compressive_strength_mpa", **said)
    if not low <= strength <= high:
        raise InputError("strength_of_no_test", place=here, key="compressive_strength_mpa", found=strength, **said)


def parse_wall(table: dict) -> Wall:
    """One wall of a mapping with the keys of [[wall]], with its loads. Raises InputError."""
    wall = parse_section(Wall, table, "wall", place("wall", name=_name(table, 0)))
    check_given(wall)
    check_held_top(wall)
    check_arch(wall)
    return wall


def _sensitivity(table: dict) -> Ranges | None:
    """[sensitivity]: of zeta, which only a demand gives."""
    if "sensitivity" not in table:
        return None
    here = section("[sensitivity]")
    if "demand" not in table:
        raise InputError("sensitivity_needs_demand", place=(here,))
    return parse_section(Ranges, table["sensitivity"], "sensitivity", here)


def _building(table) -> Building:
    here = section("[building]")
    building = parse_section(Building, table, "building", here)
    if building.modes and (building.period_s is not None or building.damping is not None):
        raise InputError("modes_or_period", place=(here,))
    return building


def _demand(table) -> Demand:
    here = section("[demand]")
    demand = parse_section(Demand, table, "demand", here)
    asked = demand.spectrum
    if asked and demand.spectrum_file:
        raise InputError("two_spectra", place=(here,))
    if asked and demand.soil_factor is not None:
        raise InputError("soil_factor_follows", place=(here,))
    if asked:
        check_code_keys(asked, section("[demand.spectrum]"))
    check_evidence(demand.evidence, (here,))
    if demand.return_period_years is not None:
        own = replace(demand, return_period_years=None).return_period
        check_return_period(demand.limit_state, demand.return_period_years, own)
    if demand.hazard and demand.hazard_file:
        raise InputError("two_hazards", place=(here,))
    if demand.hazard:
        try:
            check_rising(demand.hazard)
        except InputError as error:
            raise error.at(here) from None
    if (asked or demand.spectrum_file) and demand.housner_intensity_cm is not None:
        raise InputError("intensity_follows", place=(here,))
    return demand


def _check_select(case: Case) -> None:
    """Refuse records that are to be chosen where there is nothing to choose them by, or others beside them: the set is
    judged as a whole."""
    here, demand = (section("[select]"),), case.demand
    if not (demand and (demand.spectrum or demand.spectrum_file)):
        raise InputError("select_needs_spectrum", place=here)
    if case.record or case.generate:
        raise InputError("select_alone", place=here)
    if demand.demand_scaling == "pga":
        raise InputError("select_and_pga_scaling", place=here)


def check_code_keys(asked, here) -> None:
    """Refuse a spectrum of a code without the keys of that code, or with those of another, or whose file is at
    fault."""
    try:
        refuse_faulty(asked.code)
    except InputError as error:
        raise error.at(here) from None
    for entry in fields(Spectrum):
        needed, given = requires_key(asked.code, entry.name), getattr(asked, entry.name, None) is not None
        if needed is not None and given != needed:
            problem = "code_needs" if needed else "code_does_not_take"
            raise InputError(problem, place=(here,), key=entry.name, code=Key(asked.code))


def _written(table: dict):
    """Places (section, index, key) the user wrote."""
    for name in (
        "wall",
        "record",
        "report",
        "analysis",
        "site",
        "demand",
        "generate",
        "select",
        "building",
        "sensitivity",
    ):
        items = table.get(name) or []
        for index, item in enumerate(items if isinstance(items, (list, tuple)) else [items]):
            for key in item if isinstance(item, dict) else ():
                yield name, index, key


def tables_of(table: dict, key: str) -> list:
    entries = table.get(key, [])
    if not isinstance(entries, (list, tuple)):
        raise InputError("written_once_for_each", key=key)
    return list(entries)


def _name(entry, index: int):
    name, variant = (entry.get("name"), entry.get("variant")) if isinstance(entry, dict) else (None, None)
    if not isinstance(name, str):
        return index + 1
    return (
        f"{name[:MAX_VALUE_SHOWN]} ({variant})"
        if isinstance(variant, str) and len(variant) <= MAX_VALUE_SHOWN
        else name[:MAX_VALUE_SHOWN]
    )
