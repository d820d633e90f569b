"""A case as TOML text."""

import tomlkit

from core.case import Case


def dumps(case: Case) -> str:
    """The case as TOML, only what differs from the defaults; `parse_case` reads it back equal, and
    `draft_case` one that is not complete."""
    document = tomlkit.document()
    document["title"] = case.title
    given = case.differing()
    content = case.as_dict()
    if case.walls is not None:
        document["walls"] = case.walls
    for section in ("report", "wall", "record", "generate", "analysis", "demand"):
        found = content[section]
        items = found if isinstance(found, tuple) else [found] if found is not None else []
        tables = [
            {
                key: _bare(value)
                for key, value in item.items()
                if (section, k, key) in given and value not in (None, "")
            }
            for k, item in enumerate(items)
        ]
        if section in ("wall", "record"):
            if tables:
                document[section] = tables
        elif tables and (tables[0] or section in ("generate", "demand")):
            document[section] = tables[0]
    return tomlkit.dumps(document)


def _bare(value):
    """A value of TOML: nested tables without the keys that are not given."""
    if isinstance(value, dict):
        return {key: part for key, part in value.items() if part is not None}
    return value
