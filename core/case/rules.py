"""The rules of the keys of a case: every one is applied here, once, for file, table and form."""

import datetime
import difflib
import hashlib
import itertools
import json
import math
from dataclasses import MISSING, fields, replace
from types import SimpleNamespace

from core.case.hinges import FLOORS, check_hinges, parts
from core.case.schema import (
    MIN_ELASTIC,
    OWN_FIELDS,
    Analysis,
    Building,
    Case,
    Demand,
    Generate,
    Record,
    Report,
    Spectrum,
    Wall,
)
from core.codes.limits import check_return_period
from core.errors import InputError, place, section
from core.file_names import is_text, name_of
from core.text.sentence import Quantity, Sentence, sentence
from core.wall.moment_rotation import LAWS

MAX_TEXT, MAX_PATH = 500, 12_000
"""Characters of a text and of a name of a file, each byte of which may take three (`names.key_of`)."""

SHOWN = 100
"""Characters of a value repeated in a sentence."""

FULL_FACTOR = 1.35
"""Confidence factor where the compressive strength is not in alpha (Circolare 7/2019 C8.7.1.2.1)."""

PERIOD_LIMITS = (0.02, 10.0)
"""Periods accepted for the check of compatibility [s]."""

LATER = {"record": ("channel",)}
"""Keys of the contract whose work is not built yet: refused, never ignored."""


def parse_case(table: dict) -> Case:
    """The case of a mapping with the keys of the file; every rule is checked here, once."""
    refuse_unknown(Case, table, "case", "case")
    title = _value(_field(Case, "title"), table.get("title", "Ribalta"))
    analysis = section_of(Analysis, table.get("analysis", {}), "analysis", section("[analysis]"))
    if round(analysis.robust_window / math.log1p(analysis.q_step)) < 1:
        raise InputError(
            "window_below_step",
            place=(section("[analysis]"),),
            window=Quantity("robust_window", analysis.robust_window),
            step=Quantity("q_step", analysis.q_step),
        )
    records = [
        section_of(Record, entry, "record", place("record", n=k + 1))
        for k, entry in enumerate(tables_of(table, "record"))
    ]
    for k, record in enumerate(records):
        if record.scale == 0.0:
            accepted = sentence("accepted", "not_zero")
            here = place("record", n=k + 1)
            raise InputError("not_accepted", place=(here,), key="scale", value=0, accepted=accepted)
    demand = table.get("demand")
    generate = table.get("generate")
    case = Case(
        title=title,
        report=section_of(Report, table.get("report", {}), "report", section("[report]")),
        record=tuple(records),
        walls=_value(_field(Case, "walls"), table["walls"]) if "walls" in table else None,
        generate=section_of(Generate, generate, "generate", section("[generate]"))
        if generate is not None
        else None,
        analysis=analysis,
        demand=_demand(demand) if demand is not None else None,
        building=_building(table["building"]) if "building" in table else None,
        given=frozenset(_written(table)),
    )
    if case.generate and not (case.demand and (case.demand.spectrum or case.demand.spectrum_file)):
        raise InputError("generate_needs_spectrum")
    walls = [
        section_of(Wall, entry, "wall", place("wall", name=_name(entry, k)))
        for k, entry in enumerate(tables_of(table, "wall"))
    ]
    if case.walls is None:
        return with_walls(case, walls)
    return replace(case, wall=tuple(walls))


def draft_case(table: dict) -> Case:
    """The case of a mapping that may not be complete: unknown keys are refused, values are taken as they
    are, a missing one is empty. For work in progress; `parse_case` decides what can run."""
    refuse_unknown(Case, table, "case", "case")

    def part(cls, content, name):
        if not isinstance(content, dict):
            raise InputError("not_a_table_of_keys", name=name, value=_repeated(content))
        refuse_unknown(cls, content, name, name)
        for entry in fields(cls):
            # what breaks a rule with others may be work in progress, what is of another kind is not
            value = content.get(entry.name)
            if entry.name in content and not (entry.metadata["kind"] == "law" and _ends(value)):
                _value(entry, value, name)
        missing = {entry.name: "" for entry in fields(cls) if entry.default is MISSING}
        return cls(**{**missing, **content})

    def one(cls, name):
        return part(cls, table[name], name) if name in table else None

    demand = one(Demand, "demand")
    if demand and demand.spectrum is not None:
        demand = replace(demand, spectrum=part(Spectrum, demand.spectrum, "spectrum"))
    return Case(
        title=_value(_field(Case, "title"), table.get("title", "Ribalta")),
        report=one(Report, "report") or Report(),
        wall=tuple(part(Wall, entry, "wall") for entry in tables_of(table, "wall")),
        record=tuple(part(Record, entry, "record") for entry in tables_of(table, "record")),
        generate=one(Generate, "generate"),
        analysis=one(Analysis, "analysis") or Analysis(),
        demand=demand,
        building=one(Building, "building"),
        given=frozenset(_written(table)),
    )


def check_value(cls, key: str, value):
    """One value of a key of a section, checked; raises InputError that names what is accepted."""
    return _value(_field(cls, key), value)


def with_walls(case: Case, walls: list[Wall]) -> Case:
    """The case with these walls, checked as a set. Raises InputError."""
    if not walls:
        raise InputError("no_wall")
    names = {}
    for wall in walls:
        if names.setdefault(wall.name, wall) is not wall:
            raise InputError("same_name", key="name", wall=wall.name)
        try:
            wall.block()
            for mechanism in wall.mechanisms():
                wall.restitution_of(mechanism)
            wall.moment_law()
        except InputError as error:
            raise error.at(place("wall", name=wall.name)) from None
        if case.analysis.method == "linearised" and not wall.moment_law().is_rigid:
            raise InputError(
                "linearised_is_rigid", place=(section("[analysis]"),), key="method", wall=wall.name
            )
        if case.building and (wall.base_z_m or 0.0) > case.building.height_m:
            raise InputError(
                "base_above_building",
                place=(place("wall", name=wall.name),),
                key="base_z_m",
                base=wall.base_z_m,
                height=case.building.height_m,
            )
        check_hinges(wall, case.building)
        if case.demand and wall.base_z_m is None:
            raise InputError("base_missing", place=(place("wall", name=wall.name),), key="base_z_m")
        if case.demand and case.demand.confidence_factor < FULL_FACTOR and not wall.setback > 0.0:
            raise InputError(
                "low_confidence_factor",
                place=(section("[demand]"),),
                stated=case.demand.confidence_factor,
                wall=wall.name,
            )
    case = replace(case, wall=tuple(walls), walls=None)
    for name, part in parts(case):
        if part.name != name and part.name in names:
            raise InputError("same_name", key="name", wall=part.name)
    heights = {part.base_z_m for _, part in parts(case) if part.above_ground}
    if case.building and case.building.modes and len(heights) > 1:
        raise InputError(
            "modes_at_one_height",
            place=(section("[building]"),),
            key="modes",
            low=min(heights),
            high=max(heights),
        )
    digest = hashlib.sha256(json.dumps(case.as_dict(), sort_keys=True).encode()).hexdigest()
    return replace(case, sha256=digest)


def parse_wall(table: dict) -> Wall:
    """One wall of a mapping with the keys of [[wall]]. Raises InputError."""
    return section_of(Wall, table, "wall", place("wall", name=_name(table, 0)))


def _building(table) -> Building:
    here = section("[building]")
    building = section_of(Building, table, "building", here)
    if building.modes and (building.period_s is not None or building.damping is not None):
        raise InputError("modes_or_period", place=(here,))
    return building


def _demand(table) -> Demand:
    here = section("[demand]")
    demand = section_of(Demand, table, "demand", here)
    asked = demand.spectrum
    if asked and demand.spectrum_file:
        raise InputError("two_spectra", place=(here,))
    if asked and demand.soil_factor is not None:
        raise InputError("soil_factor_follows", place=(here,))
    if asked:
        check_code_keys(asked, section("[demand.spectrum]"))
    if demand.return_period_years is not None:
        own = replace(demand, return_period_years=None).return_period
        check_return_period(demand.limit_state, demand.return_period_years, own)
    rows = demand.hazard
    rising = all(
        low.return_period_years < high.return_period_years and low.ag_g < high.ag_g
        for low, high in itertools.pairwise(rows)
    )
    if len(rows) == 1 or not rising:
        raise InputError("hazard_not_rising", place=(here,), key="hazard")
    if (asked or demand.spectrum_file) and demand.housner_intensity_cm is not None:
        raise InputError("intensity_follows", place=(here,))
    return demand


def check_code_keys(asked, here) -> None:
    """Refuse a spectrum of a code without the keys of that code, or with those of another."""
    needed = {"NTC2018": ("f0", "tc_star_s", "topography"), "EN1998": ("type",)}
    for code, keys in needed.items():
        for key in keys:
            if (getattr(asked, key) is not None) != (code == asked.code):
                raise InputError(
                    "code_needs" if code == asked.code else "code_does_not_take",
                    place=(here,),
                    key=key,
                    code=asked.code,
                )


def _written(table: dict):
    """Places (section, index, key) the user wrote."""
    for name in ("wall", "record", "report", "analysis", "demand", "generate", "building"):
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
    name = entry.get("name") if isinstance(entry, dict) else None
    return name[:SHOWN] if isinstance(name, str) else index + 1


def _field(cls, key: str):
    return next(entry for entry in fields(cls) if entry.name == key)


def refuse_unknown(cls, table: dict, name: str, here) -> None:
    """Refuse keys that are not of this section.

    name : of the section
    here : its place
    """
    keys = [entry.name for entry in fields(cls) if entry.name not in OWN_FIELDS]
    for key in table:
        if key in LATER.get(name, ()):
            raise InputError("not_built", place=(here,), key=key)
        if key not in keys:
            near = difflib.get_close_matches(key, keys + list(LATER.get(name, ())), 1)
            if near:
                raise InputError(
                    "unknown_key_near", place=(here,), value=_repeated(key), near=near[0]
                )
            raise InputError("unknown_key", place=(here,), value=_repeated(key), known=tuple(keys))


def section_of(cls, table, name: str, here):
    """A section of a mapping as an object of its class, every value checked. Raises InputError.

    name : of the section
    here : its place
    """
    if not isinstance(table, dict):
        raise InputError("not_a_table_of_keys", name=here, value=_repeated(table))
    refuse_unknown(cls, table, name, here)
    values = {}
    for entry in fields(cls):
        if entry.name in table:
            values[entry.name] = _value(entry, table[entry.name], here)
        elif entry.default is MISSING:
            raise InputError("missing", place=(here,), key=entry.name, accepted=_accepted(entry))
    return cls(**values)


def _ends(value) -> bool:
    """Whether this is a law by two numbers."""
    ends = list(value.values()) if isinstance(value, dict) else []
    named = ends and sorted(value) == ["elastic_limit", "plateau_end"]
    return bool(named) and all(type(end) in (int, float) for end in ends)


def _accepted(entry) -> Sentence:
    """What a key accepts."""
    rule = entry.metadata
    kind = rule["kind"]
    if kind == "choice":
        return sentence("accepted", "one_of", names=tuple(rule["names"]))
    if kind in ("float", "int"):
        code = "whole" if kind == "int" else "above" if rule["exclusive"] else "from"
        unit = f" {rule['unit']}" if rule["unit"] else ""
        return sentence("accepted", code, low=rule["low"], high=rule["high"], unit=unit)
    if kind == "range":
        return sentence("accepted", "periods", low=PERIOD_LIMITS[0], high=PERIOD_LIMITS[1])
    if kind == "law":
        return sentence("accepted", "law", names=tuple(LAWS))
    if kind == "hinges":
        return sentence("accepted", "hinges", floors=FLOORS)
    if kind == "list":
        return sentence("accepted", "list", items=_accepted(rule["of"]))
    if kind == "tables":
        return sentence("accepted", "tables", name=entry.name)
    if kind == "text":
        return sentence("accepted", "text", most=MAX_TEXT)
    return sentence("accepted", {"flag": "flag", "spectrum": "table", "path": "path"}[kind])


def _value(entry, value, *here):
    """One value checked against its field; raises InputError with place, value, accepted. here : the place."""
    rule = entry.metadata
    kind = rule["kind"]
    if kind in ("float", "int"):
        fits = isinstance(value, (int, float) if kind == "float" else int)
        if fits and not isinstance(value, bool):
            above = value > rule["low"] if rule["exclusive"] else value >= rule["low"]
            if above and value <= rule["high"]:  # NaN is neither
                return float(value) if kind == "float" else value
    elif kind == "choice":
        if isinstance(value, str) and value in rule["names"]:
            return value
    elif kind == "text":
        if isinstance(value, datetime.date):
            value = value.isoformat()
        printable = isinstance(value, str) and len(value) <= MAX_TEXT and is_text(value)
        if printable and (value or entry.default is not MISSING):
            return value
    elif kind == "path":
        named = isinstance(value, str) and 0 < len(value) <= MAX_PATH and "\0" not in value
        if named and name_of(value):
            return value
    elif kind == "flag":
        if isinstance(value, bool):
            return value
    elif kind == "range":
        pair = list(value) if isinstance(value, (list, tuple)) else []
        if len(pair) == 2 and all(type(end) in (int, float) for end in pair):
            low, high = float(pair[0]), float(pair[1])
            if PERIOD_LIMITS[0] <= low < high <= PERIOD_LIMITS[1]:
                return (low, high)
    elif kind == "list":
        if isinstance(value, (list, tuple)) and value:
            item = SimpleNamespace(name=entry.name, metadata=rule["of"].metadata, default=MISSING)
            return tuple(_value(item, part, *here) for part in value)
    elif kind == "tables":
        if isinstance(value, (list, tuple)) and value:
            above = [part for part in here if isinstance(part, Sentence)]
            parts = []
            for k, part in enumerate(value, start=1):
                try:
                    parts.append(
                        section_of(rule["of"], part, entry.name, section(f"[[{entry.name}]] {k}"))
                    )
                except InputError as error:
                    raise (error.at(above[0]) if above else error) from None
            return tuple(parts)
    elif kind == "spectrum":
        return section_of(Spectrum, value, "spectrum", section("[demand.spectrum]"))
    elif kind == "hinges":
        if value == FLOORS:
            return value
        heights = value if isinstance(value, (list, tuple)) else ()
        if heights and all(type(h) in (int, float) and 0.0 < h < 300.0 for h in heights):
            return tuple(sorted({float(h) for h in heights}))
    elif kind == "law":
        if isinstance(value, str) and value in LAWS:
            return value
        if _ends(value):
            first, last = value["elastic_limit"], value["plateau_end"]
            if MIN_ELASTIC <= first <= last < 1.0:
                return {"elastic_limit": float(first), "plateau_end": float(last)}
            raise InputError(
                "ends_not_accepted",
                place=here,
                key="law",
                first=_repeated(first),
                last=_repeated(last),
                least=MIN_ELASTIC,
            )
    shown, accepted = _repeated(value), _accepted(entry)
    raise InputError(
        "not_accepted", place=here, key=entry.name, value=shown, accepted=accepted, found=value
    )


def _repeated(value) -> str:
    """A value in a sentence, not longer than needed to know it."""
    try:
        words = repr(value)
    except (ValueError, RecursionError):  # an integer of thousands of digits
        words = f"{type(value).__name__} …"
    return words if len(words) <= SHOWN else words[:SHOWN] + "…"
