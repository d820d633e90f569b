"""A case file read and checked."""

import hashlib
import re
import tomllib
from dataclasses import replace
from pathlib import Path

from core.case.drawn_solids import with_drawings
from core.case.hazard_table import read_hazard
from core.case.many_walls import ManyWalls, with_many
from core.case.note_file import CASE, MAX_NOTE_BYTES, files_within, is_note
from core.case.rules import parse_case, with_walls
from core.case.schema import Case
from core.case.wall_table import MANY_BYTES, read_table
from core.errors import InputError
from core.file_names import name_of
from core.regular_file import TooLarge, first_bytes, read_regular

MAX_DOTS = 50
_DOTTED = re.compile(rf"^[ \t]*+\[*+(?:[ \t]*+[A-Za-z0-9_\"'-]++[ \t]*+\.){{{MAX_DOTS}}}", re.MULTILINE)
"""Keys of many parts, which take tomllib the square of their number."""

MAX_BYTES = 2_000_000
"""A case file is a page or two; a larger file is something else."""


_COMMA = re.compile(r"^[^#\n\"']*=\s*([+-]?\d+,\d+)\s*(?:#.*)?$", re.MULTILINE)
"""A number with a decimal comma, which TOML has not."""


def read_toml(path: Path) -> tuple[dict, bytes]:
    """Content of a TOML file as a mapping, and its bytes. Raises InputError."""
    try:
        if path.exists() and not path.is_file():
            raise InputError("case_not_a_file", place=(path,))
        of_note = is_note(first_bytes(path, 5))  # it holds its case, and is larger than one
        content = read_regular(path, MAX_NOTE_BYTES if of_note else MAX_BYTES)
        if of_note:
            content = files_within(path, (CASE,))[CASE]
        if len(content) > MAX_BYTES:
            raise TooLarge(len(content))
    except FileNotFoundError:
        raise InputError("no_case_file", place=(path,)) from None
    except TooLarge as error:
        raise InputError("case_too_large", mb=error.size / 1e6, most=MAX_BYTES / 1e6, place=(path,)) from None
    except OSError as error:
        raise InputError("unreadable", reason=error.strerror, place=(path,)) from None
    return _table_of(content, path), content


def _table_of(content: bytes, path: Path) -> dict:
    """The mapping of the text of a TOML file. path : named where it is none"""
    try:
        text = content.decode("utf-8-sig")
        if _DOTTED.search(text):
            raise InputError("toml_dotted", parts=MAX_DOTS, place=(path,))
        table = tomllib.loads(text)
    except UnicodeDecodeError:
        raise InputError("case_not_utf8", place=(path,)) from None
    except (ValueError, RecursionError) as error:
        reason = str(error).split("; use sys")[0][:200]
        number = _COMMA.search(text)
        if number:
            line = text.count("\n", 0, number.start(1)) + 1
            raise InputError("toml_comma", line=line, found=number[1], place=(path,)) from None
        raise InputError("not_toml", reason=reason, place=(path,)) from None
    return table


def read_case(path: Path, many: bool = False) -> Case:
    """The case of a TOML file. many : its table may have more rows than are held at once, see ManyWalls. Raises
    InputError naming file, place, value and what is accepted."""
    table, content = read_toml(path)
    return _case_of(table, content, path, many)


def case_of_text(text: str, path: Path) -> Case:
    """The case of the text of a file as it would be read at a path, which need not be there. Raises InputError."""
    content = text.encode()
    return _case_of(_table_of(content, path), content, path, False)


def _case_of(table: dict, content: bytes, path: Path, many: bool) -> Case:
    try:
        table, drawings = with_drawings(table, path.parent)
        case = parse_case(table)
        digest = hashlib.sha256(content)
        digest.update("".join(drawing.sha256 for drawing in drawings).encode())
        if case.walls is not None:
            source = path.parent / name_of(case.walls)
            walls, notes = read_table(source, case.demand is not None, many)
            digest.update(read_regular(source, MANY_BYTES))
            table = case.walls
            case = with_many(case, walls) if isinstance(walls, ManyWalls) else with_walls(case, [*case.wall, *walls])
            case = replace(case, table=table, table_notes=tuple(notes))
        if case.demand and case.demand.hazard_file:
            source = path.parent / name_of(case.demand.hazard_file)
            read_hazard(source)
            digest.update(read_regular(source, MAX_BYTES))
        case = replace(case, sha256=digest.hexdigest(), source=content.decode("utf-8-sig"))
        notices, files = (tuple(getattr(one, name) for one in drawings) for name in ("notice", "file"))
        return replace(case, drawings=notices, drawn_from=files)
    except InputError as error:
        raise error.at(path) from None
