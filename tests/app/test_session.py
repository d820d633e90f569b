"""What the window works on: history, files, autosave, recovery. No Qt."""

import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import tomllib
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.work import recovery
from app.work.session import Session
from core.case.hold import Hold
from core.case.loads import Load, ReturnWalls
from core.case.reader import read_case
from core.case.rules import parse_case, parse_draft
from core.case.schema import Record
from core.case.site import Building, BuildingMode, Demand, HazardRow, Spectrum
from core.case.wall import Wall
from core.case.writer import table_of
from core.errors import InputError
from tests.conftest import ROOT

EXAMPLE = ROOT / "tests" / "cases" / "records.toml"


@pytest.mark.shows("note.holds_case")
def test_that_a_note_opens_as_the_case_it_is_of_and_is_never_written_into(session, tmp_path):
    pytest.importorskip("typst")
    from core.report.note.archive import note_as_pdf
    from core.study.run import run

    whole = read_case(EXAMPLE)
    case = replace(whole, wall=whole.wall[:1], record=whole.record[:2])
    path = tmp_path / "archive" / "note.pdf"
    path.parent.mkdir()
    path.write_bytes(note_as_pdf(run(case, base_dir=EXAMPLE.parent), EXAMPLE.parent))
    before = path.read_bytes()
    session.open(path)
    assert session.case == case and session.path is None
    assert session.base_dir == path.parent
    session.save(tmp_path / "archive" / "again.toml")
    assert path.read_bytes() == before and read_case(tmp_path / "archive" / "again.toml") == session.case
    path.write_bytes(b"%PDF-1.7 damaged")
    with pytest.raises(InputError):
        session.open(path)
    assert session.path.name == "again.toml"


@pytest.fixture
def session(tmp_path):
    made = Session(tmp_path / "recovery_folder")
    made.open(EXAMPLE)
    return made


@pytest.mark.shows("window.undo")
def test_that_undo_and_redo_walk_over_every_edit(session):
    first = session.case
    session.edit_wall(0, "a", height_m=6.0)
    session.edit_wall(0, "a", height_m=6.5)
    session.edit_wall(0, "b", name="x")
    second = session.case
    session.undo()
    assert session.case.wall[0].height_m == 6.5
    session.undo()  # typing in one field is one step
    assert session.case == first and not session.dirty
    session.redo()
    session.redo()
    assert session.case == second
    session.redo()
    assert session.case == second


@pytest.mark.shows("window.undo")
@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.sampled_from(["height_m", "thickness_m"]), st.floats(0.2, 9.0)), max_size=12))
def test_that_undoing_everything_gives_the_first_case(edits):
    import tempfile
    from pathlib import Path

    with tempfile.TemporaryDirectory() as folder:
        session = Session(Path(folder))
        session.open(EXAMPLE)
        first = session.case
        for key, value in edits:
            session.edit_wall(0, None, **{key: value})
        for _ in edits:
            session.undo()
        assert session.case == first


@pytest.mark.shows("window.same_files")
def test_that_what_is_saved_is_what_the_batch_reads(session, tmp_path):
    session.edit_wall(0, height_m=6.25)
    session.edit(replace(session.case, demand=Demand(0.3, spectrum=None, soil_factor=1.4)))
    target = tmp_path / "other" / "case.toml"
    target.parent.mkdir()
    session.save(target)
    assert not session.dirty
    read = read_case(target)
    assert read == session.case
    # the record still names the same files from the new folder
    assert (target.parent / read.record[0].file).parent.resolve() == ROOT / "tests" / "motions"


def test_that_a_case_in_the_making_can_be_saved_and_opened_again(session, tmp_path):
    session.add_walls([Wall("new", "", height_m=3.0)])
    assert (
        session.problem().code == "one_geometry" and session.checked() is None
    )  # beside a demand how it turns is found
    session.save(tmp_path / "draft.toml")
    again = Session(tmp_path / "recovery_folder")
    again.open(tmp_path / "draft.toml")
    assert again.case.wall[-1].name == "new"
    assert again.problem() is not None


DRAFTS = {
    "a load without size": {"load": (Load("vertical", "", 5.0),)},
    "a load of a wall without height": {"height_m": None, "load": (Load("thrust", "", ""),)},
    "a tie of a wall without height": {"height_m": None, "hold": (Hold("tie", h_m="", out_kn_m=""),)},
    "one load of two without size": {"load": (Load("thrust", 2.0, 3.0), Load("carried_mass", "", 4.0, 0.2))},
    "return walls ticked": {"return_walls": ReturnWalls("", "", "", "")},
    "some of the return walls": {"return_walls": ReturnWalls(2, "", 0.2, "")},
    "a law whose ends are the wrong way round": {"law": {"elastic_limit": 0.5, "plateau_end": 0.2}},
}
"""What the forms leave in a wall while a person enters it."""

SPECTRA = [
    Spectrum("NTC2018", "", f0="", tc_star_s="", topography=""),
    Spectrum("NTC2018", "", f0=2.5),
    Spectrum("EN1998", "", type=""),
    Spectrum("EN1998", "C", type=""),
]


def drafts(case):
    """(what is missing, a case in the making)."""
    for name, values in DRAFTS.items():
        yield name, replace(case, wall=(replace(case.wall[0], **values),))
    for spectrum in SPECTRA:
        yield str(spectrum), replace(case, demand=Demand("", spectrum=spectrum))
    yield "a building", replace(case, building=Building("", ""))
    yield "a mode", replace(case, building=Building(9.0, 3, modes=(BuildingMode("", 0.05, ""),)))
    yield "a row of hazard", replace(case, demand=Demand(0.2, hazard=(HazardRow(30.0, ""),)))


@pytest.mark.shows("window.drafts")
def test_that_every_case_in_the_making_is_autosaved_saved_and_opened_again(session, tmp_path):
    for name, draft in drafts(session.case):
        session.edit(draft)
        session.autosave()
        other = Session(tmp_path / "recovery_folder")
        other.recover(session.recovery_file)
        assert table_of(other.case) == table_of(draft), name
        target = tmp_path / "draft.toml"
        session.save(target)
        assert not session.dirty
        again = Session(tmp_path / "recovery_folder")
        again.open(target)
        assert table_of(again.case) == table_of(session.case), name
        again.save()  # Ctrl+S
        assert target.read_bytes() == session.content, name
        assert str(again.problem()) == str(session.problem())
        session.edit(session.past[0])


@pytest.mark.parametrize(
    ("wrong", "left_out"), [({"notes": "two\nlines"}, 1), ({"height_m": 1e9}, 1), ({"hinge_heights": (3.0, 1.0)}, 0)]
)
def test_that_a_value_no_file_may_hold_is_left_out_alone_and_the_state_before_it_stays(
    session, tmp_path, wrong, left_out
):
    """A fault of the program: all later edits are kept, what is left out is said and stays unsaved."""
    session.save(tmp_path / "case.toml")
    session.edit_wall(0, height_m=6.5)
    session.autosave()
    good = session.recovery_file.read_bytes()
    session.edit_wall(0, **wrong)
    session.edit_wall(0, length_m=7.25)
    session.autosave()
    _, newest, before, _ = recovery.states(session.recovery_file)
    draft = recovery.read(newest).case
    assert draft.wall[0].length_m == 7.25 and draft.wall[1:] == session.case.wall[1:]
    assert before.read_bytes() == good
    session.save()
    assert len(session.left_out) == left_out and session.dirty == bool(left_out)
    assert parse_draft(tomllib.loads(session.path.read_text())).wall[0].length_m == 7.25


def test_that_what_could_not_be_opened_again_takes_the_place_of_nothing(session, tmp_path, monkeypatch):
    """A fault of the program that writes another case than it has: the last good files stay, and it is said."""
    session.edit_wall(0, notes="of mine")
    session.save(tmp_path / "case.toml")
    session.edit_wall(0, height_m=6.5)
    session.autosave()
    good = session.recovery_file.read_bytes(), session.path.read_bytes()
    session.edit_wall(0, height_m=6.75)
    for text in ("title = 'another'", "not = 'a case'"):
        monkeypatch.setattr("app.work.session.dumps", lambda *_, text=text: text)
        session.autosave()
        with pytest.raises(InputError):
            session.save()
        assert session.dirty
        assert (session.recovery_file.read_bytes(), session.path.read_bytes()) == good


def test_that_a_file_that_is_no_case_changes_nothing(session, tmp_path):
    before = session.case
    for content in ("not toml [", '[[wall]]\ncolour = "red"\n'):
        path = tmp_path / "bad.toml"
        path.write_text(content)
        with pytest.raises(InputError):
            session.open(path)
        assert session.case is before


def test_that_a_failed_save_leaves_the_old_file(session, tmp_path, monkeypatch):
    target = tmp_path / "case.toml"
    session.save(target)
    old = target.read_bytes()
    session.edit_wall(0, height_m=6.0)

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    from core.errors import OutputError

    with pytest.raises(OutputError):
        session.save()
    assert target.read_bytes() == old and session.dirty


def test_that_stale_results_are_known(session):
    class Result:
        case = session.checked()
        motions = ()

    session.result = Result()
    assert not session.stale
    session.edit_wall(0, height_m=6.0)
    assert session.stale
    session.undo()
    assert not session.stale


def test_that_excluded_records_are_kept_in_the_file_and_not_run(session, tmp_path):
    session.add_records([Record("nowhere.txt", include=False)])
    assert session.problem() is None
    session.save(tmp_path / "c.toml")
    assert read_case(tmp_path / "c.toml").record[-1].include is False
    from core.setting.record_input import read_records

    motions, _ = read_records(session.checked(), session.base_dir)
    assert len(motions) == 7


@pytest.mark.shows("window.autosave")
def test_that_a_killed_program_leaves_its_unsaved_case(tmp_path):
    """kill -9 while editing: the next start finds the case as it was last autosaved."""
    case = tmp_path / "case.toml"
    shutil.copy(EXAMPLE, case)
    script = textwrap.dedent(f"""
        import sys
        from pathlib import Path
        sys.path.insert(0, {str(ROOT)!r})
        from app.work.session import Session
        session = Session(Path({str(tmp_path / "recovery_folder")!r}))
        session.open(Path({str(case)!r}))
        session.edit_wall(0, height_m=6.125)
        session.autosave()
        print("ready", flush=True)
        sys.stdin.read()
    """)
    before = case.read_bytes()
    with subprocess.Popen(
        [sys.executable, "-c", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as program:
        assert program.stdout.readline().strip() == "ready"
        other = Session(tmp_path / "recovery_folder")
        assert other.recoverable() == []  # still alive: its own
        program.send_signal(signal.SIGKILL)
        program.wait()
    (swap,) = other.recoverable()
    other.recover(swap)
    assert other.case.wall[0].height_m == 6.125
    assert other.dirty and other.path == case
    assert case.read_bytes() == before
    assert not other.recoverable()


def test_that_a_damaged_swap_is_refused(tmp_path):
    session = Session(tmp_path)
    for content in ("{", json.dumps({"case": "x ="}), json.dumps({"path": None, "base_dir": ".", "case": "bad = 1"})):
        path = tmp_path / "0123-999999999.swap"
        path.write_text(content)
        with pytest.raises(InputError):
            session.recover(path)


@pytest.mark.shows("window.same_files")
def test_that_saving_keeps_comments_and_what_the_batch_says_of_the_file(session, tmp_path):
    path = tmp_path / "c.toml"
    text = EXAMPLE.read_text(encoding="utf-8").replace("[[wall]]", "# of mine\n[[wall]]", 1)
    path.write_text(text, encoding="utf-8")
    session.open(path)
    session.edit_wall(0, height_m=6.0)
    session.save()
    assert "# of mine\n[[wall]]" in path.read_text(encoding="utf-8")
    batch = read_case(path)
    seen = session.checked()
    assert seen == batch
    assert (seen.sha256, seen.given, seen.table) == (batch.sha256, batch.given, batch.table)


def test_that_a_draft_that_breaks_a_rule_is_saved_whole(session, tmp_path):
    session.edit_wall(0, slenderness_deg=7.0, mechanism="")
    session.save(tmp_path / "c.toml")
    assert not session.dirty and session.path == (tmp_path / "c.toml").resolve()


def test_that_saving_drops_the_swap(session, tmp_path):
    session.edit_wall(0, height_m=6.0)
    session.autosave()
    assert session.recovery_file.exists()
    session.save(tmp_path / "c.toml")
    assert list((tmp_path / "recovery_folder").glob("*.swap")) == []


def test_that_every_case_of_the_resources_goes_through_the_writer():
    from core.case.writer import table_of

    for path in sorted((ROOT / "resources" / "cases").glob("*.toml")):
        case = read_case(path)
        assert parse_case(table_of(case)) == case
