"""The recovery files of a session: its last states, the newest that reads in front."""

import contextlib
import json
import os
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

from core import atomic_write
from core.case.rules import parse_draft
from core.case.schema import Case
from core.errors import InputError

STATE_ENDS = (".new", "", ".1", ".2")
"""Ends of the names of the last states, the newest first; .new while it takes its place."""

FAULTS = (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError, OverflowError)


@dataclass(frozen=True)
class Draft:
    """What a state holds. path : of the case's file, None before it has one; base_dir : where its records start"""

    case: Case
    path: Path | None
    base_dir: Path


def states(file: Path) -> list[Path]:
    """The states a recovery file stands for, the newest first, whether there or not."""
    return [file.with_name(file.name + end) for end in STATE_ENDS]


def read(state: Path) -> Draft:
    """One state. Raises InputError."""
    try:
        content = json.loads(state.read_text(encoding="utf-8"))
        path = Path(content["path"]) if content["path"] else None
        base = Path(content["base_dir"])
        if "\0" in f"{path}{base}":
            raise ValueError(repr(path))
        return Draft(parse_draft(tomllib.loads(content["case"])), path, base)
    except FAULTS as error:
        raise InputError("autosave_unreadable", reason=str(error)[:200], place=(state,)) from None


def newest(file: Path) -> Draft:
    """The newest state that reads. Raises InputError where none does, of the newest that is there."""
    errors = []
    for state in states(file):
        try:
            return read(state)
        except InputError as error:
            errors.append((not state.exists(), error))
    raise min(errors, key=lambda one: one[0])[1]


def write_state(file: Path, case: str, path: Path | None, base_dir: Path) -> None:
    """A state in front of those before it, whole on disk before any of them moves; a state that does not read takes
    the place of none. case : as TOML text. Raises OutputError or OSError: then those before it are there."""
    content = {"path": str(path) if path else None, "base_dir": str(base_dir), "case": case}
    text = json.dumps(content).encode()
    new, front, *older = states(file)
    is_good = False
    with contextlib.suppress(InputError, OSError):
        read(front)
        is_good = True
        if front.read_bytes() == text:
            return
    atomic_write.write({new: text})
    if is_good:
        for state, place in reversed(list(zip([front, *older], older, strict=False))):
            with contextlib.suppress(FileNotFoundError):
                os.replace(state, place)
    os.replace(new, front)


def delete_states(file: Path) -> None:
    """Delete all its states, the oldest first."""
    for state in reversed(states(file)):
        with contextlib.suppress(OSError):
            state.unlink(missing_ok=True)


def describe(file: Path) -> str:
    """Say of which file a recovery file is, and from when."""
    there = [state for state in states(file) if state.exists()] or [file]
    for state in there:
        with contextlib.suppress(InputError):
            return f"{read(state).path or ''} {_when(state)}".strip()
    return _when(there[0])


def _when(state: Path) -> str:
    try:
        return time.strftime("%Y-%m-%d %H:%M", time.localtime(state.stat().st_mtime))
    except OSError:
        return ""


def files(folder: Path) -> list[Path]:
    """The recovery files of a folder, the newest first."""
    modified: dict[Path, float] = {}
    with contextlib.suppress(OSError):
        for end in STATE_ENDS:
            for state in folder.glob(f"*.swap{end}"):
                if state.is_file():
                    file = state.with_name(state.name.removesuffix(end))
                    modified[file] = max(modified.get(file, 0.0), state.stat().st_mtime)
    return sorted(modified, key=lambda file: -modified[file])
