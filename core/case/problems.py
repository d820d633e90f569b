"""Everything that keeps a case from running, not only the first: for a form, which is filled in any order."""

import re
from dataclasses import fields, is_dataclass, replace
from typing import Any

from core.case.judge import IncrementalParser
from core.case.keys import NESTED
from core.case.schema import Analysis, Case, Report
from core.case.wall import Wall
from core.errors import InputError

MAX_JUDGEMENTS = 60
"""Times a case is judged: of more problems nobody reads."""


def find_problems(case: Case, judge: IncrementalParser | None = None) -> list[InputError]:
    """What is missing or breaks a rule. After each problem the value that is missing is taken as given, or else the
    wall or section in question is left out, and the rest is judged again: a rule that needs a missing value waits, for
    what it would say of the value that is assumed is no problem of the case. judge : of cases much like it"""
    judge = judge or IncrementalParser()
    errors: list[InputError] = []
    assumed: set[tuple[str, str]] = set()
    part_given: set[str | None] = set()
    for _ in range(MAX_JUDGEMENTS):
        try:
            judge(case)
            break
        except InputError as error:
            keys = [error.key] if error.key else sorted(error.keys)
            free = [key for key in keys if (repr(error.place), key) not in assumed]
            filled = next(((key, one) for key in free if (one := _filled(case, error, key))), None)
            row = wall_of(case, error)
            owner = error.section if row is None else case.wall[row].title
            if filled is not None or (free == keys and owner not in part_given):
                errors.append(error)
            if filled is not None:
                of_shape = keys if error.code == "one_geometry" else ()
                assumed.update((repr(error.place), key) for key in (filled[0], *of_shape))
                part_given.add(owner)
                case = filled[1]
                continue
            changed = _without(case, error)
            if changed is None:
                break
            case = changed
    return errors


def _filled(case: Case, error: InputError, key: str) -> Case | None:
    """The case with a value of this key where the error finds none; None where that is not what it says."""
    if error.wall is not None:
        walls = list(case.wall)
        for k, wall in enumerate(walls):
            if k != wall_of(case, error):
                continue
            name, n = find_table(error)
            tables = getattr(wall, name) if name in WALL_TABLES else ()
            if error.code == "one_geometry":
                whole = _with_sizes(wall)
            elif n < len(tables):
                table = _given(tables[n], key)
                changed: dict[str, Any] = {name: (*tables[:n], table, *tables[n + 1 :])}
                whole = table and replace(wall, **changed)
            else:
                whole = _given(wall, key)
            if whole is not None:
                walls[k] = whole
                return replace(case, wall=tuple(walls))
    for name in ("demand", "building"):
        section = getattr(case, name)
        here = error.section in (f"[{name}]", f"[{name}.spectrum]")
        if section is not None and here and (whole := _given(section, key)) is not None:
            if name == "building" and key == "height_m":  # one that no wall is above
                tops = [one for wall in case.wall for one in (wall.base_z_m,) if isinstance(one, (int, float))]
                whole = replace(whole, height_m=max([whole.height_m, *tops]))
            return replace(case, **{name: whole})
    return None


ASSUMED_HEIGHT, ASSUMED_SLENDERNESS = 60.0, 10.0
"""H [m] and H/t of sizes that are assumed: nothing that is within a wall is above its top."""


def _with_sizes(wall: Wall) -> Wall | None:
    """Complete a wall with plausible sizes where some are missing; None where it has too many."""
    given = [one for one in (wall.thickness_m, wall.slenderness_deg, wall.height_over_thickness) if one is not None]
    if len(given) > 1 or (given and wall.height_m is not None):
        return None
    height = wall.height_m or (
        ASSUMED_HEIGHT if wall.thickness_m is None else min(ASSUMED_HEIGHT, ASSUMED_SLENDERNESS * wall.thickness_m)
    )
    return (
        replace(wall, height_m=height)
        if given
        else replace(wall, height_m=height, thickness_m=height / ASSUMED_SLENDERNESS)
    )


def wall_of(case: Case, error: InputError) -> int | None:
    """Index of the wall an error is about, of it all or of its part above a hinge."""
    said = error.wall
    if said is None:
        return None
    return next(
        (k for k, wall in enumerate(case.wall) if said == wall.title or said.startswith(f"{wall.title} (+")), None
    )


WALL_TABLES = "load", "hold"
"""Keys of a wall whose tables an error names by their number."""


def find_table(error: InputError) -> tuple[str, int]:
    """(key, index) of the table of a wall an error is about; ("", 0) of another one."""
    for part in error.place:
        values, code = dict(getattr(part, "values", ())), getattr(part, "code", "")
        if code in WALL_TABLES:
            return code, values["n"] - 1
        if match := re.match(r"\[\[(load|hold)\]\] (\d+)", str(values.get("name", ""))):
            return match[1], int(match[2]) - 1
    return "", 0


def load_of(error: InputError) -> int | None:
    """Index of the load an error is about."""
    name, n = find_table(error)
    return n if name == "load" else None


def _given(section: Any, key: str) -> Any:
    """A section, or one inside it, whose empty key has a value that is accepted; None where none is empty."""
    for entry in fields(section):
        value = getattr(section, entry.name)
        if entry.name == key and value in (None, ""):
            return replace(section, **{key: _plausible(entry.metadata)})
        if entry.metadata.get("kind") not in NESTED:
            continue
        parts = list(value) if isinstance(value, tuple) else [value]
        for k, part in enumerate(parts):
            if is_dataclass(part) and (whole := _given(part, key)) is not None:
                parts[k] = whole
                return replace(section, **{entry.name: tuple(parts) if isinstance(value, tuple) else whole})
    return None


def _plausible(rule) -> Any:
    """A plausible value of a key of this kind, in place of a missing one."""
    match rule["kind"]:
        case "choice":
            return next(iter(rule["names"]))
        case "int":
            return rule["low"]
        case "float":
            return rule["low"] if rule["low"] > 0.0 or (rule["low"] == 0.0 and not rule["exclusive"]) else 0.01
        case _:
            return "-"


def _without(case: Case, error: InputError) -> Case | None:
    """The case without the wall, record or section an error is about; None where it is about none of them."""
    if error.wall is not None:
        rest = tuple(wall for k, wall in enumerate(case.wall) if k != wall_of(case, error))
        return replace(case, wall=rest) if rest and len(rest) < len(case.wall) else None
    said = [dict(part.values) for part in error.place if getattr(part, "code", "") == "record"]
    if said:
        k = said[0]["n"] - 1
        return replace(case, record=tuple(one for n, one in enumerate(case.record) if n != k))
    match error.section:
        case str(name) if name.startswith("[demand"):
            return replace(case, demand=None, generate=None, select=None) if case.demand else None
        case "[generate]":
            return replace(case, generate=None) if case.generate else None
        case "[select]":
            return replace(case, select=None) if case.select else None
        case str(name) if name.startswith("[building"):
            return replace(case, building=None) if case.building else None
        case "[analysis]":
            return replace(case, analysis=Analysis()) if case.analysis != Analysis() else None
        case "[report]":
            return replace(case, report=Report()) if case.report != Report() else None
    return replace(case, generate=None) if error.code == "generate_needs_spectrum" else None
