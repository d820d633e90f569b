"""A case as TOML text."""

import tomllib

from core.case.place import drop_site_values
from core.case.rules import parse_draft
from core.case.schema import Case
from core.case.variant_of import contract_variants
from core.errors import InputError

SECTION_ORDER = (
    "report",
    "wall",
    "record",
    "generate",
    "select",
    "analysis",
    "site",
    "demand",
    "building",
    "sensitivity",
)
"""Sections of a case file, in the order they are written."""

STATED = ("generate", "select", "site", "demand", "building", "sensitivity")
"""Sections that say something though no key of theirs differs from its default."""

IDENTITY = {"wall": "name", "record": "file"}
"""Keys of many tables, and what a table of them is known by."""


def table_of(case: Case) -> dict:
    """The case as a mapping with the keys of the file, only what differs from the defaults; `parse_case`
    reads it back equal, and `parse_draft` one that is not complete."""
    table: dict[str, object] = {"title": case.title}
    given = case.differing()
    content = case.as_dict()
    if case.walls is not None:
        table["walls"] = case.walls
    for section in SECTION_ORDER:
        items = content[section]
        items = items if isinstance(items, tuple) else [items] if items is not None else []
        tables = [
            {key: _bare(value) for key, value in item.items() if (section, k, key) in given and value not in (None, "")}
            for k, item in enumerate(items)
        ]
        if section in ("wall", "record"):
            if tables:
                table[section] = tables
        elif tables and (tables[0] or section in STATED):
            table[section] = drop_site_values(case.site, tables[0]) if section == "demand" else tables[0]
    return table


class _OtherTables(Exception):
    """Tables came or went: a comment above one is the end of the one before, and would change its place."""


def dumps(case: Case, before: str = "") -> str:
    """`table_of` as TOML text. before : the file as it was: its comments, its order and the defaults it states
    stay where no table came or went and what is read back is the same case."""
    import tomlkit
    from tomlkit.exceptions import TOMLKitError

    plain, wanted = tomlkit.document(), table_of(case)
    plain.update(wanted)
    try:
        document = tomlkit.parse(before)
        stated = (
            {**wanted, "wall": contract_variants(wanted["wall"], document.get("wall", []))}
            if "wall" in wanted
            else wanted
        )
        _merge(document, stated, case.as_dict())
        text = tomlkit.dumps(document)
        if parse_draft(tomllib.loads(text)) == parse_draft(wanted):
            return text
    except (_OtherTables, TOMLKitError, ValueError, InputError):
        pass
    return tomlkit.dumps(plain)


def _merge(target, wanted: dict, content: dict) -> None:
    """Make a table of the file hold what is wanted. content : the same with all defaults."""
    for key in list(target):
        if key not in wanted and not _states(target[key], content.get(key)):
            if isinstance(target[key], (dict, list)):
                raise _OtherTables
            del target[key]
    for key, value in wanted.items():
        old = target.get(key)
        if isinstance(value, dict) and isinstance(old, dict):
            _merge(old, value, content[key])
        elif isinstance(value, dict) or key in IDENTITY:
            _merge_tables(old or [], value, content[key], IDENTITY.get(key))
        elif old is None or not _states(old, value):
            target[key] = value


def _states(stated, content) -> bool:
    """Whether what the file states is so."""
    if isinstance(stated, dict) and isinstance(content, dict):
        return all(key in content and _states(part, content[key]) for key, part in stated.items())
    return stated == content and isinstance(stated, bool) == isinstance(content, bool)


def _merge_tables(target: list, wanted: list[dict], content, identity: str | None) -> None:
    """Merge [[wall]] or [[record]] tables into those of the file: each is recognised by its name or file, a renamed one
    by its place. Raises _OtherTables where tables came, went or moved."""
    if identity is None or len(target) != len(wanted):
        raise _OtherTables
    old, new = ([table.get(identity) for table in tables] for tables in (target, wanted))
    if any(a != b and (a in new or b in old) for a, b in zip(old, new, strict=True)):
        raise _OtherTables
    for table, value, full in zip(target, wanted, content, strict=True):
        _merge(table, value, full)


def _bare(value):
    """A value of TOML: nested tables without the keys that are not given, and without the flags that are not set."""
    if isinstance(value, dict):
        return {key: _bare(part) for key, part in value.items() if part not in (None, "") and part is not False}
    return [_bare(part) for part in value] if isinstance(value, tuple) else value
