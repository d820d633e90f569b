"""A case file read and checked."""

import contextlib
import hashlib
import re
import tomllib
from collections.abc import Collection, Iterator
from dataclasses import replace
from pathlib import Path

from core.case.case_files import CaseFile, hash_file, hold_rows
from core.case.drawn_solids import expand_drawings
from core.case.hazard_table import read_hazard
from core.case.many_walls import LazyWalls, attach_walls
from core.case.note_file import CASE, MAX_NOTE_BYTES, files_within, is_note
from core.case.rules import parse_case, replace_walls
from core.case.schema import Case
from core.case.wall import Wall
from core.case.wall_table import parse_wall_rows, read_table
from core.errors import InputError
from core.file_names import name_of
from core.known import require_value
from core.regular_file import TooLarge, first_bytes, read_regular

MAX_DOTS = 50
_DOTTED = re.compile(rf"^[ \t]*+\[*+(?:[ \t]*+[A-Za-z0-9_\"'-]++[ \t]*+\.){{{MAX_DOTS}}}", re.MULTILINE)
"""Keys of many parts, which take tomllib the square of their number."""

MAX_BYTES = 2_000_000
"""A case file is a page or two; a larger file is something else."""


_BACKSLASH = re.compile(r"""[^"'#]*"[^"]*\\[^"\\]""")
"""A line with a backslash between double quotes."""

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
        for n, row in enumerate(text.splitlines(), start=1):
            if _BACKSLASH.match(row) and f"line {n}," in reason:
                raise InputError("toml_backslash", line=n, place=(path,)) from None
        raise InputError("not_toml", reason=reason, place=(path,)) from None
    return table


def read_case(path: Path, many: bool = False) -> Case:
    """The case of a TOML file. many : its table may have more rows than are held at once, see ManyWalls. Raises
    InputError naming file, place, value and what is accepted."""
    table, content = read_toml(path)
    return _case_of(table, content, path, many)


def case_of_text(text: str, path: Path, held: Collection[CaseFile] = ()) -> Case:
    """The case of the text of a file as it would be read at a path, which need not be there. held : files whose rows
    are known. Raises InputError."""
    content = text.encode()
    return _case_of(_table_of(content, path), content, path, False, held)


def _case_of(table: dict, content: bytes, path: Path, many: bool, held: Collection[CaseFile] = ()) -> Case:
    try:
        table, drawings = expand_drawings(table, path.parent)
        case = parse_case(table)
        files = [CaseFile("drawing", drawing.file, drawing.sha256) for drawing in drawings]
        if case.walls is not None:
            walls, file = _walls_of_table(case, path.parent, many, held)
            files.append(file)
            case = (
                attach_walls(case, walls) if isinstance(walls, LazyWalls) else replace_walls(case, [*case.wall, *walls])
            )
            case = replace(case, table=file.file, table_notes=file.notices)
        if case.demand and case.demand.hazard_file:
            read_hazard(path.parent / name_of(case.demand.hazard_file))
        files += _files_of_demand(case, path.parent)
        digest = hashlib.sha256(content)
        digest.update("".join(file.sha256 for file in files).encode())
        case = replace(case, sha256=digest.hexdigest(), source=content.decode("utf-8-sig"), files=tuple(files))
        notices, drawn_from = (tuple(getattr(drawing, name) for drawing in drawings) for name in ("notice", "file"))
        return replace(case, drawings=notices, drawn_from=drawn_from)
    except InputError as error:
        raise error.at(path) from None


def _walls_of_table(
    case: Case, folder: Path, many: bool, held: Collection[CaseFile]
) -> tuple[list[Wall] | LazyWalls, CaseFile]:
    """Read the walls of the table that a case names: of the file, or of its rows where they are held."""
    name, with_demand = require_value(case.walls), case.demand is not None
    for file in held:
        if (file.role, file.file) == ("walls", name) and file.rows is not None:
            return parse_wall_rows([list(row) for row in file.rows], with_demand), file
    read = read_table(folder / name_of(name), with_demand, many)
    return read.walls, CaseFile("walls", name, read.sha256, tuple(read.notices), hold_rows(read.rows))


def _files_of_demand(case: Case, folder: Path) -> Iterator[CaseFile]:
    """Yield the files that a demand names and that are there: who reads one that is not says so."""
    for key in ("hazard_file", "spectrum_file"):
        name = getattr(case.demand, key, None)
        if name:
            with contextlib.suppress(OSError):
                yield CaseFile(key, name, hash_file(folder / name_of(name)))
