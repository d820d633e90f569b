"""A case as TOML text."""

from core.case import Case


def table_of(case: Case) -> dict:
    """The case as a mapping with the keys of the file, only what differs from the defaults; `parse_case`
    reads it back equal, and `draft_case` one that is not complete."""
    found = {"title": case.title}
    given = case.differing()
    content = case.as_dict()
    if case.walls is not None:
        found["walls"] = case.walls
    for section in ("report", "wall", "record", "generate", "analysis", "demand"):
        items = content[section]
        items = items if isinstance(items, tuple) else [items] if items is not None else []
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
                found[section] = tables
        elif tables and (tables[0] or section in ("generate", "demand")):
            found[section] = tables[0]
    return found


def dumps(case: Case) -> str:
    """`table_of` as TOML text."""
    import tomlkit

    document = tomlkit.document()
    for key, value in table_of(case).items():
        document[key] = value
    return tomlkit.dumps(document)


def _bare(value):
    """A value of TOML: nested tables without the keys that are not given."""
    if isinstance(value, dict):
        return {key: part for key, part in value.items() if part is not None}
    return value
