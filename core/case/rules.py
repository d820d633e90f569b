"""The rules of the keys of a case: every one is applied here, once, for file, table and form."""

import datetime
import difflib
import hashlib
import json
import math
from dataclasses import MISSING, fields, replace

from core.case.schema import (
    LEAST_ELASTIC,
    OWN_FIELDS,
    Analysis,
    Case,
    Demand,
    Generate,
    Record,
    Report,
    Spectrum,
    Wall,
)
from core.codes.limits import check_return_period
from core.errors import InputError
from core.file_names import is_text, name_of
from core.wall.moment_rotation import LAWS

MAX_TEXT, MAX_PATH = 500, 12_000
"""Characters of a text and of a name of a file, each byte of which may take three (`names.key_of`)."""

SHOWN = 100
"""Characters of a value repeated in a sentence."""

FULL_FACTOR = 1.35
"""Confidence factor where the compressive strength is not in alpha (Circolare 7/2019 C8.7.1.2.1)."""

BASE_MISSING = (
    "base_z_m is missing: with a demand the height of the hinge above the ground is required, 0 m for a wall "
    "on the ground"
)

PERIOD_LIMITS = (0.02, 10.0)
"""Periods accepted for the check of compatibility [s]."""

LATER = {"record": ("channel",)}
"""Keys of the contract whose work is not built yet: refused, never ignored."""


def parse_case(table: dict) -> Case:
    """The case of a mapping with the keys of the file; every rule is checked here, once."""
    _known(Case, table, "case", "case")
    title = _value(_field(Case, "title"), table.get("title", "Ribalta"), "title")
    analysis = _section(Analysis, table.get("analysis", {}), "analysis", "[analysis]")
    if round(analysis.robust_window / math.log1p(analysis.q_step)) < 1:
        raise InputError(
            f"[analysis]: robust_window = {analysis.robust_window:g} is narrower than one step of q_step = "
            f"{analysis.q_step:g}: widen the window or take a finer step"
        )
    records = [
        _section(Record, entry, "record", f"record {k + 1}")
        for k, entry in enumerate(_tables(table, "record"))
    ]
    for k, record in enumerate(records):
        if record.scale == 0.0:
            raise InputError(f"record {k + 1}: scale = 0 is not accepted: other than 0")
    demand = table.get("demand")
    generate = table.get("generate")
    case = Case(
        title=title,
        report=_section(Report, table.get("report", {}), "report", "[report]"),
        record=tuple(records),
        walls=_value(_field(Case, "walls"), table["walls"], "walls") if "walls" in table else None,
        generate=_section(Generate, generate, "generate", "[generate]")
        if generate is not None
        else None,
        analysis=analysis,
        demand=_demand(demand) if demand is not None else None,
        given=frozenset(_written(table)),
    )
    if case.generate and not (case.demand and (case.demand.spectrum or case.demand.spectrum_file)):
        raise InputError(
            "[generate] makes motions compatible with the spectrum of the demand: give "
            "[demand.spectrum] or spectrum_file"
        )
    walls = [
        _section(Wall, entry, "wall", f'wall "{_name(entry, k)}"')
        for k, entry in enumerate(_tables(table, "wall"))
    ]
    if case.walls is None:
        return with_walls(case, walls)
    return replace(case, wall=tuple(walls))


def draft_case(table: dict) -> Case:
    """The case of a mapping that may not be complete: unknown keys are refused, values are taken as they
    are, a missing one is empty. For work in progress; `parse_case` decides what can run."""
    _known(Case, table, "case", "case")

    def section(cls, content, name):
        if not isinstance(content, dict):
            raise InputError(f"{name} must be a table of keys, not {_repeated(content)}")
        _known(cls, content, name, name)
        for entry in fields(cls):
            # what breaks a rule with others may be work in progress, what is of another kind is not
            value = content.get(entry.name)
            if entry.name in content and not (entry.metadata["kind"] == "law" and _ends(value)):
                _value(entry, value, f"{name}: {entry.name}")
        missing = {entry.name: "" for entry in fields(cls) if entry.default is MISSING}
        return cls(**{**missing, **content})

    def one(cls, name):
        return section(cls, table[name], name) if name in table else None

    demand = one(Demand, "demand")
    if demand and demand.spectrum is not None:
        demand = replace(demand, spectrum=section(Spectrum, demand.spectrum, "spectrum"))
    return Case(
        title=_value(_field(Case, "title"), table.get("title", "Ribalta"), "title"),
        report=one(Report, "report") or Report(),
        wall=tuple(section(Wall, entry, "wall") for entry in _tables(table, "wall")),
        record=tuple(section(Record, entry, "record") for entry in _tables(table, "record")),
        generate=one(Generate, "generate"),
        analysis=one(Analysis, "analysis") or Analysis(),
        demand=demand,
        given=frozenset(_written(table)),
    )


def check_value(cls, key: str, value):
    """One value of a key of a section, checked; raises InputError that names what is accepted."""
    return _value(_field(cls, key), value, key)


def with_walls(case: Case, walls: list[Wall]) -> Case:
    """The case with these walls, checked as a set. Raises InputError."""
    if not walls:
        raise InputError("no [[wall]]: a case needs at least one wall")
    names = {}
    for wall in walls:
        if names.setdefault(wall.name, wall) is not wall:
            raise InputError(f'two walls have the same name "{wall.name}": names must differ')
        try:
            wall.block()
            for mechanism in wall.mechanisms():
                wall.restitution_of(mechanism)
            wall.moment_law()
        except InputError as error:
            place = f'wall "{wall.name}": '
            raise InputError(place + str(error).removeprefix(place)) from None
        if case.analysis.method == "linearised" and not wall.moment_law().is_rigid:
            raise InputError(
                f'[analysis]: method linearised is for the rigid law; wall "{wall.name}" is '
                "trilinear: take method auto"
            )
        if case.demand and wall.base_z_m is None:
            raise InputError(f'wall "{wall.name}": {BASE_MISSING}')
        if case.demand and case.demand.confidence_factor < FULL_FACTOR and not wall.setback > 0.0:
            raise InputError(
                f"[demand]: confidence_factor = {case.demand.confidence_factor:g} is for walls whose "
                "compressive strength is in alpha (Circolare C8.7.1.2.1): give "
                f'hinge_setback_m above 0 for wall "{wall.name}", or 1.35'
            )
    case = replace(case, wall=tuple(walls), walls=None)
    digest = hashlib.sha256(json.dumps(case.as_dict(), sort_keys=True).encode()).hexdigest()
    return replace(case, sha256=digest)


def parse_wall(table: dict) -> Wall:
    """One wall of a mapping with the keys of [[wall]]. Raises InputError."""
    return _section(Wall, table, "wall", f'wall "{_name(table, 0)}"')


def _demand(table) -> Demand:
    demand = _section(Demand, table, "demand", "[demand]")
    asked = demand.spectrum
    if asked and demand.spectrum_file:
        raise InputError("[demand]: give spectrum or spectrum_file, not both")
    if asked and demand.soil_factor is not None:
        raise InputError("[demand]: soil_factor follows from [demand.spectrum]: leave it out")
    if asked:
        needed = {"NTC2018": ("f0", "tc_star_s", "topography"), "EN1998": ("type",)}
        for code, keys in needed.items():
            for key in keys:
                if (getattr(asked, key) is not None) != (code == asked.code):
                    raise InputError(
                        f"[demand.spectrum]: code {asked.code} needs {key}"
                        if code == asked.code
                        else f"[demand.spectrum]: code {asked.code} does not take {key}"
                    )
    if demand.return_period_years is not None:
        own = replace(demand, return_period_years=None).return_period
        check_return_period(demand.limit_state, demand.return_period_years, own)
    if (asked or demand.spectrum_file) and demand.housner_intensity_cm is not None:
        raise InputError(
            "[demand]: housner_intensity_cm follows from the spectrum: leave one of them out"
        )
    return demand


def _written(table: dict):
    """Places (section, index, key) the user wrote."""
    for section in ("wall", "record", "report", "analysis", "demand", "generate"):
        items = table.get(section) or []
        for index, item in enumerate(items if isinstance(items, (list, tuple)) else [items]):
            for key in item if isinstance(item, dict) else ():
                yield section, index, key


def _tables(table: dict, key: str) -> list:
    entries = table.get(key, [])
    if not isinstance(entries, (list, tuple)):
        raise InputError(f"{key} must be written [[{key}]], once for each")
    return list(entries)


def _name(entry, index: int):
    name = entry.get("name") if isinstance(entry, dict) else None
    return name[:SHOWN] if isinstance(name, str) else index + 1


def _field(cls, key: str):
    return next(entry for entry in fields(cls) if entry.name == key)


def _known(cls, table: dict, section: str, place: str) -> None:
    keys = [entry.name for entry in fields(cls) if entry.name not in OWN_FIELDS]
    for key in table:
        if key in LATER.get(section, ()):
            raise InputError(f"{place}: {key} is not built yet in this version: leave it out")
        if key not in keys:
            near = difflib.get_close_matches(key, keys + list(LATER.get(section, ())), 1)
            hint = f"; did you mean {near[0]}?" if near else f"; known: {', '.join(keys)}"
            raise InputError(f"{place}: unknown key {_repeated(key)}{hint}")


def _section(cls, table, section: str, place: str):
    if not isinstance(table, dict):
        raise InputError(f"{place} must be a table of keys, not {_repeated(table)}")
    _known(cls, table, section, place)
    values = {}
    for entry in fields(cls):
        if entry.name in table:
            values[entry.name] = _value(entry, table[entry.name], f"{place}: {entry.name}")
        elif entry.default is MISSING:
            rule = _accepted(entry)
            raise InputError(f"{place}: {entry.name} is missing: it is required ({rule})")
    return cls(**values)


def _ends(value) -> bool:
    """Whether this is a law by two numbers."""
    ends = list(value.values()) if isinstance(value, dict) else []
    named = ends and sorted(value) == ["elastic_limit", "plateau_end"]
    return bool(named) and all(type(end) in (int, float) for end in ends)


def _accepted(entry) -> str:
    rule = entry.metadata
    if rule["kind"] == "choice":
        return "one of " + ", ".join(rule["names"])
    if rule["kind"] in ("float", "int"):
        bracket = "above" if rule["exclusive"] else "from"
        unit = f" {rule['unit']}" if rule["unit"] else ""
        whole = "a whole number " if rule["kind"] == "int" else ""
        return f"{whole}{bracket} {rule['low']:g} to {rule['high']:g}{unit}"
    if rule["kind"] == "flag":
        return "true or false"
    if rule["kind"] == "spectrum":
        return "a table [demand.spectrum]"
    if rule["kind"] == "range":
        return f"two periods [low, high] in s, rising, from {PERIOD_LIMITS[0]:g} to {PERIOD_LIMITS[1]:g}"
    if rule["kind"] == "law":
        return f"one of {', '.join(LAWS)}, or {{ elastic_limit = ..., plateau_end = ... }}"
    if rule["kind"] == "path":
        return "the name of a file in quotes"
    return f"text in quotes, up to {MAX_TEXT} characters, without control characters"


def _value(entry, value, place: str):
    """One value checked against its field; raises InputError with place, value, accepted."""
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
    elif kind == "spectrum":
        return _section(Spectrum, value, "spectrum", "[demand.spectrum]")
    elif kind == "law":
        if isinstance(value, str) and value in LAWS:
            return value
        if _ends(value):
            first, last = value["elastic_limit"], value["plateau_end"]
            if LEAST_ELASTIC <= first <= last < 1.0:
                return {"elastic_limit": float(first), "plateau_end": float(last)}
            raise InputError(
                f"{place}: elastic_limit = {_repeated(first)}, plateau_end = {_repeated(last)} are not accepted: "
                f"{LEAST_ELASTIC:g} <= elastic_limit <= plateau_end < 1"
            )
    raise InputError(f"{place} = {_repeated(value)} is not accepted: {_accepted(entry)}")


def _repeated(value) -> str:
    """A value in a sentence, not longer than needed to know it."""
    try:
        words = repr(value)
    except (ValueError, RecursionError):  # an integer of thousands of digits
        words = f"a {type(value).__name__} too long to show"
    return words if len(words) <= SHOWN else words[:SHOWN] + "…"
