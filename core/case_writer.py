"""A case as TOML text."""

import tomlkit

from core.case import Case


def dumps(case: Case) -> str:
    """The case as TOML, only what differs from the defaults; `parse_case` reads it back equal."""
    document = tomlkit.document()
    document["title"] = case.title
    given = case.differing()
    content = case.as_dict()
    for section in ("report", "wall", "record", "analysis", "demand"):
        items = content[section] if isinstance(content[section], tuple) else [content[section]]
        tables = [
            {key: value for key, value in (item or {}).items() if (section, k, key) in given}
            for k, item in enumerate(items)
        ]
        if section in ("wall", "record"):
            if tables:
                document[section] = tables
        elif tables[0]:
            document[section] = tables[0]
    return tomlkit.dumps(document)
