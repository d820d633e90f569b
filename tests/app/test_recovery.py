"""The last three states of an unsaved case: what is bad never hides or replaces what is good."""

import json
import os
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from app.work import recovery
from app.work.session import Session
from core.errors import InputError
from tests.conftest import ROOT

EXAMPLE = ROOT / "resources" / "cases" / "example.toml"


@pytest.fixture
def session(tmp_path):
    made = Session(tmp_path / "recovery_folder")
    made.open(EXAMPLE)
    yield made
    made.close()


def autosave(session: Session, height: float) -> None:
    session.edit_wall(0, height_m=height)
    session.autosave()


def heights(file: Path) -> list[float]:
    """Of the states that are there, the newest first."""
    return [recovery.read(state).case.wall[0].height_m for state in recovery.states(file) if state.exists()]


def recovered(session: Session, tmp_path: Path) -> float:
    other = Session(tmp_path / "recovery_folder")
    other.recover(session.recovery_file)
    other.close()
    return other.case.wall[0].height_m


@pytest.mark.shows("window.autosave")
def test_that_the_last_three_states_are_kept_and_a_case_at_rest_adds_none(session):
    for height in (6.0, 6.0, 6.25, 6.5, 6.75):
        autosave(session, height)
        session.autosave()
    assert heights(session.recovery_file) == [6.75, 6.5, 6.25]
    session.drop_recovery_file()
    assert not any(state.exists() for state in recovery.states(session.recovery_file))


@pytest.mark.shows("window.autosave")
@pytest.mark.parametrize("damage", [b"", b"{", None], ids=["empty", "truncated", "unreadable"])
def test_that_a_bad_newest_state_neither_hides_nor_replaces_a_good_one(session, tmp_path, damage):
    for height in (6.0, 6.25, 6.5):
        autosave(session, height)
    file = session.recovery_file
    if damage is None:
        file.unlink()
        file.mkdir()
    else:
        file.write_bytes(damage or file.read_bytes()[:-40])
    assert recovery.describe(file).startswith(f"{EXAMPLE} 20")
    if damage is not None:
        autosave(session, 6.75)
        assert heights(file) == [6.75, 6.25, 6.0]
        file.write_bytes(damage)
    assert file in recovery.files(file.parent)
    assert recovered(session, tmp_path) == 6.25


def test_that_a_full_disk_leaves_every_state_as_it_was(session, tmp_path, monkeypatch):
    for height in (6.0, 6.25, 6.5):
        autosave(session, height)
    with monkeypatch.context() as full:
        full.setattr(os, "fsync", lambda *_: (_ for _ in ()).throw(OSError(28, "No space left on device")))
        autosave(session, 6.75)
        autosave(session, 7.25)
    assert heights(session.recovery_file) == [6.5, 6.25, 6.0]
    session.autosave()
    assert heights(session.recovery_file) == [7.25, 6.5, 6.25]


def test_that_a_kill_between_two_moves_leaves_the_newest_state(session, tmp_path, monkeypatch):
    """The new state is whole on disk before those before it move: at each move the next start finds it. The folder as a
    kill at that moment leaves it is a copy of it."""
    for height in (6.0, 6.25, 6.5):
        autosave(session, height)
    session.edit_wall(0, height_m=6.75)
    real, left = os.replace, []

    def killed() -> None:
        left.append(shutil.copytree(session.recovery_folder, tmp_path / f"killed_{len(left)}"))

    def moved(source, target):
        if str(source).endswith((".swap", ".1", ".new")):
            killed()
        real(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", moved)
        session.autosave()
    killed()
    assert len(left) == 4
    for folder in left:
        other = Session(folder)
        (file,) = other.recoverable()
        assert len(heights(file)) >= 3
        other.recover(file)
        assert other.case.wall[0].height_m == 6.75 and other.path == session.path
        assert other.recoverable() == [] and not any(state.exists() for state in recovery.states(file))
        other.close()


def test_that_states_of_which_none_reads_are_said_and_stay(session, tmp_path):
    folder = tmp_path / "recovery_folder"
    folder.mkdir(exist_ok=True)
    for end in ("", ".2"):
        (folder / f"x-aa.swap{end}").write_text("{")
    (file,) = session.recoverable()
    with pytest.raises(InputError) as caught:
        session.recover(file)
    assert caught.value.place == (file,) or str(file) in caught.value.text()
    assert len(list(folder.glob("x-aa.swap*"))) == 2


def test_that_a_state_of_an_earlier_version_is_recovered(session, tmp_path):
    """One file, without the states beside it."""
    folder = tmp_path / "recovery_folder"
    folder.mkdir(exist_ok=True)
    text = session._text(replace(session.case, title="earlier"))[0]
    file = folder / "x-aa.swap"
    file.write_text(json.dumps({"path": None, "base_dir": str(tmp_path), "case": text}))
    session.recover(file)
    assert session.case.title == "earlier" and not file.exists()
