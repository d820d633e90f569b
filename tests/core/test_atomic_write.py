"""Files that are whole or not there, under every fault and kill."""

import errno
import json
import os
import subprocess
import sys

import pytest

from core import atomic_write
from core.errors import OutputError
from core.study.journal import Journal
from tests.conftest import ROOT

CALLS = ("replace", "fsync", "unlink", "open", "chmod", "write", "stat", "mkdir", "close")


class Faults:
    """The n-th of all calls of the system fails, once or from there on."""

    def __init__(self, monkeypatch, number, for_ever, code=errno.ENOSPC):
        self.count, self.number, self.for_ever = 0, number, for_ever
        for name in ("replace", "fsync", "unlink", "open", "chmod", "rename"):
            real = getattr(os, name)
            monkeypatch.setattr(os, name, self.wrapped(real, code))

    def wrapped(self, real, code):
        def call(*arguments, **more):
            self.count += 1
            if self.count == self.number or (self.for_ever and self.count > self.number):
                raise OSError(code, os.strerror(code))
            return real(*arguments, **more)

        return call


@pytest.mark.shows("files.whole")
@pytest.mark.parametrize("for_ever", [False, True])
@pytest.mark.parametrize("number", range(1, 32))
def test_that_a_fault_of_any_call_leaves_both_old_files_or_both_new(tmp_path, monkeypatch, number, for_ever):
    one, two = tmp_path / "a.xlsx", tmp_path / "a.json"
    one.write_bytes(b"old 1")
    two.write_bytes(b"old 2")
    with monkeypatch.context() as patch:
        faults = Faults(patch, number, for_ever)
        try:
            atomic_write.write({one: b"new 1", two: b"new 2"})
            written = True
        except OutputError as error:
            written = False
            assert "cannot be written (No space left on device)" in str(error)
            said = str(error)
    atomic_write.clean(tmp_path)
    left = {path.name: path.read_bytes() for path in tmp_path.iterdir() if atomic_write.PREFIX not in path.name}
    both = ({"a.xlsx": b"new 1", "a.json": b"new 2"}, {"a.xlsx": b"old 1", "a.json": b"old 2"})
    if for_ever and not written:
        # a disk on which nothing can be put back any more: whole files all the same
        assert all(content in (b"old 1", b"new 1", b"old 2", b"new 2") for content in left.values())
        new = [name for name, content in left.items() if content.startswith(b"new")]
        assert ("is unchanged" in said) == (not new)
        assert all(str(tmp_path / name) in said for name in new)
    else:
        assert left == both[0 if written else 1], (written, faults.count)
    if not for_ever:
        assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.xlsx"]


def test_that_files_that_were_not_there_are_not_there_after_a_fault(tmp_path, monkeypatch):
    for number in range(1, 20):
        with monkeypatch.context() as patch:
            Faults(patch, number, False)
            try:
                atomic_write.write({tmp_path / "a.xlsx": b"1", tmp_path / "a.json": b"2"})
            except OutputError:
                assert list(tmp_path.iterdir()) == []
                continue
        assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.xlsx"]
        for path in tmp_path.iterdir():
            path.unlink()


KILLED = """
import json, os, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from core import atomic_write
def ended_at(number, one, two):
    count = 0
    def kill(real):
        def call(*a, **k):
            nonlocal count
            count += 1
            if count == number:
                os._exit(9)
            return real(*a, **k)
        return call
    for name in ("replace", "fsync", "unlink", "open", "chmod"):
        setattr(os, name, kill(getattr(os, name)))
    atomic_write.write({Path(one): b"new 1", Path(two): b"new 2"})
    os._exit(0)
for line in sys.stdin:
    child = os.fork() if hasattr(os, "fork") else 0
    if not child:
        ended_at(*json.loads(line))
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""
"""Writes two files and ends at a call of the system, in a process of its own for each line that comes; one interpreter
starts them all, where the system can fork."""


@pytest.fixture(scope="module")
def killed():
    """killed(number, one, two): the code of a process that writes these two files and is killed at this call."""
    command = [sys.executable, "-c", KILLED, str(ROOT)]
    if not hasattr(os, "fork"):
        yield lambda *asked: subprocess.run(command, input=json.dumps(asked, default=str), text=True).returncode
        return
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as starter:

        def one_more(number, one, two):
            starter.stdin.write(json.dumps([number, str(one), str(two)]) + "\n")
            starter.stdin.flush()
            return int(starter.stdout.readline())

        yield one_more
        starter.stdin.close()


@pytest.mark.shows("files.whole")
@pytest.mark.parametrize("number", range(1, 30))
def test_that_a_kill_between_any_two_calls_is_finished_or_undone_at_the_next_start(killed, tmp_path, number):
    one, two = tmp_path / "a.xlsx", tmp_path / "a.json"
    one.write_bytes(b"old 1")
    two.write_bytes(b"old 2")
    assert killed(number, one, two) in (0, 9)
    atomic_write.check_folder(tmp_path)
    pair = (one.read_bytes(), two.read_bytes())
    assert pair in ((b"old 1", b"old 2"), (b"new 1", b"new 2"))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.xlsx"]


@pytest.mark.parametrize("cleaned", ["out", "notes"])
@pytest.mark.parametrize("number", range(1, 34))
def test_that_a_kill_leaves_all_old_or_all_new_in_two_folders_whichever_is_looked_at_first(
    killed, tmp_path, number, cleaned
):
    for name in ("out", "notes"):
        (tmp_path / name).mkdir()
    one, two = tmp_path / "out" / "a.xlsx", tmp_path / "notes" / "a.docx"
    one.write_bytes(b"old 1")
    two.write_bytes(b"old 2")
    assert killed(number, one, two) in (0, 9)
    atomic_write.clean(tmp_path / cleaned)
    pair = (one.read_bytes(), two.read_bytes())
    assert pair in ((b"old 1", b"old 2"), (b"new 1", b"new 2"))
    for name in ("out", "notes"):
        atomic_write.clean(tmp_path / name)
    assert pair == (one.read_bytes(), two.read_bytes())
    assert sorted(path.name for path in tmp_path.rglob("*.*")) == ["a.docx", "a.xlsx"]


def test_that_a_folder_out_of_reach_is_waited_for(killed, tmp_path):
    """The list of the moves lies on a share that is away: nothing is taken back, and all is done when it is there."""
    for name in ("out", "notes"):
        (tmp_path / name).mkdir()
    one, two = tmp_path / "out" / "a.xlsx", tmp_path / "notes" / "a.docx"
    for number in range(1, 34):
        one.write_bytes(b"old 1")
        two.write_bytes(b"old 2")
        assert killed(number, one, two) in (0, 9)
        for away, here in (("out", "notes"), ("notes", "out")):
            (tmp_path / away).rename(tmp_path / "away")
            atomic_write.clean(tmp_path / here)
            (tmp_path / "away").rename(tmp_path / away)
        for name in ("out", "notes"):
            atomic_write.clean(tmp_path / name)
        pair = (one.read_bytes(), two.read_bytes())
        assert pair in ((b"old 1", b"old 2"), (b"new 1", b"new 2")), number


def test_that_what_another_machine_writes_on_a_share_is_left_alone(tmp_path, monkeypatch):
    """Its process has a number that runs nowhere here; after a day it writes no more."""
    number = 999999
    assert not atomic_write.alive(number)
    monkeypatch.setattr(atomic_write, "machine", lambda: "0123abcd")
    monkeypatch.setattr(os, "getpid", lambda: number)
    name = atomic_write._beside(str(tmp_path / "a.xlsx"), b"being written")
    monkeypatch.undo()
    atomic_write.clean(tmp_path)
    assert os.listdir(tmp_path) == [os.path.basename(name)]
    os.utime(name, (0.0, 0.0))
    atomic_write.clean(tmp_path)
    assert os.listdir(tmp_path) == []


def test_that_results_written_since_are_not_replaced_by_what_a_kill_left(killed, tmp_path):
    """A machine comes back whose batch was killed, and another has written the results meanwhile."""
    one, two = tmp_path / "a.xlsx", tmp_path / "a.json"
    for number in range(1, 30):
        one.write_bytes(b"old 1")
        two.write_bytes(b"old 2")
        assert killed(number, one, two) in (0, 9)
        one.write_bytes(b"since 1")
        two.write_bytes(b"since 2")
        atomic_write.clean(tmp_path)
        assert (one.read_bytes(), two.read_bytes()) == (b"since 1", b"since 2"), number
        assert len(os.listdir(tmp_path)) == 2


def test_that_a_rename_refused_for_ever_names_the_file_that_is_new(tmp_path, monkeypatch):
    one, two = tmp_path / "a.xlsx", tmp_path / "a.json"
    one.write_bytes(b"old 1")
    two.write_bytes(b"old 2")
    real, taken = os.replace, []

    def refused(source, target):
        if str(target).endswith(atomic_write.COMMIT):
            return real(source, target)
        if taken:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        taken.append(target)
        return real(source, target)

    monkeypatch.setattr(os, "replace", refused)
    with pytest.raises(OutputError) as caught:
        atomic_write.write({one: b"new 1", two: b"new 2"})
    assert "unchanged" not in str(caught.value)
    assert str(one) in str(caught.value) and str(two) in str(caught.value)
    assert (one.read_bytes(), two.read_bytes()) == (b"new 1", b"old 2")
    assert len(os.listdir(tmp_path)) == 2


def test_that_what_is_not_ours_or_in_use_is_left_alone(tmp_path):
    here = f".ribalta-{atomic_write.machine()}"
    names = (
        ".ribalta-notes",
        ".ribalta-notes-12-mine",
        ".ribalta-12x-a",
        f"{here}-{os.getpid()}-used",
        f"{here}-x.commit",
    )
    for name in names:
        (tmp_path / name).write_bytes(b"x")
        os.utime(tmp_path / name, (0.0, 0.0))
    os.mkfifo(tmp_path / f"{here}-999999-pipe")
    (tmp_path / f"{here}-999999-left").write_bytes(b"x")
    (tmp_path / f"{here}-999999-bad.commit").write_bytes(b"{no list")
    outside = tmp_path / "sub"
    outside.mkdir()
    (tmp_path / f"{here}-999999-far").write_bytes(b"x")
    (tmp_path / "mine").write_bytes(b"mine")
    far = f"{here}-999999-far"
    for number, moves in (
        (999999, [[str(tmp_path / far), str(outside / "planted"), None]]),
        (999999, [[far, str(outside / "planted"), None]]),
        (999999, [[far, "../planted", None]]),
        (999999, [["mine", "planted", None]]),
        (999997, [[far, "planted", None]]),
        (999996, [1]),
        (999995, [["sub/x", "sub/y", None]]),
        (999994, {"a": "b"}),
        (999993, 1),
        (999992, str(tmp_path / f"{here}-999999-a.commit")),
        (999991, "relative.commit"),
    ):
        place = tmp_path / f"{here}-{number}-{len(os.listdir(tmp_path))}.commit"
        place.write_text(json.dumps(moves))
    atomic_write.clean(tmp_path)
    assert list(outside.iterdir()) == []
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {*names, f"{here}-999999-pipe", "sub", "mine"}


@pytest.mark.parametrize("for_ever", [False, True])
@pytest.mark.parametrize("number", range(1, 8))
def test_that_a_full_disk_in_the_journal_is_one_sentence(tmp_path, monkeypatch, number, for_ever):
    path = tmp_path / "c.journal"
    with monkeypatch.context() as patch:
        Faults(patch, number, for_ever)
        try:
            book = Journal(path, "key", False)
            try:
                for k in range(5):
                    book.add(f"run{k}", {"q": float(k)})
            finally:
                book.close()
        except OutputError as error:
            assert "journal cannot be written" in str(error)
    again = Journal(path, "key", True)
    assert all(again.get(name) == {"q": float(name[3:])} for name in again.places)
    again.close()


def test_that_a_disk_that_takes_half_a_file_leaves_the_old_one(tmp_path):
    """A write that ends short, by the system's limit on the size of a file."""
    resource = pytest.importorskip("resource")
    script = f"""
import resource, signal, sys
from pathlib import Path
sys.path.insert(0, {str(ROOT)!r})
from core.errors import OutputError
from core import atomic_write
from core.study.journal import Journal
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))
folder = Path({str(tmp_path)!r})
def fill():
    book = Journal(folder / "d.journal", "key", False)
    for k in range(99):
        book.add(str(k), {{"x": "z" * 900}})
for write in (lambda: atomic_write.write({{folder / "a.xlsx": b"x" * 100_000, folder / "a.json": b"y"}}), fill):
    try:
        write()
    except OutputError as error:
        assert "File too large" in str(error), error
    else:
        raise SystemExit("written")
"""
    assert resource
    (tmp_path / "a.xlsx").write_bytes(b"old")
    found = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert found.returncode == 0, found.stderr
    assert (tmp_path / "a.xlsx").read_bytes() == b"old" and not (tmp_path / "a.json").exists()
    again = Journal(tmp_path / "d.journal", "key", True)
    assert len(again.places) >= 9 and all(again.get(name) == {"x": "z" * 900} for name in again.places)
    again.close()


def test_that_a_folder_that_cannot_be_synced_can_be_written(tmp_path, monkeypatch):
    """Some network drives know no fsync of a folder."""
    real = os.fsync

    def fsync(handle):
        if os.path.isdir(f"/proc/self/fd/{handle}"):
            raise OSError(errno.EINVAL, "Invalid argument")
        return real(handle)

    monkeypatch.setattr(os, "fsync", fsync)
    atomic_write.write({tmp_path / "a.xlsx": b"1", tmp_path / "a.json": b"2"})
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.xlsx"]


def test_that_a_kill_is_finished_also_where_the_folder_was_renamed(killed, tmp_path):
    folder = tmp_path / "out"
    folder.mkdir()
    one, two = folder / "a.xlsx", folder / "a.json"
    one.write_bytes(b"old 1")
    two.write_bytes(b"old 2")
    # after the list is on disk and the first file in its place
    for number in range(8, 20):
        assert killed(number, one, two) in (0, 9)
        moved = folder.rename(tmp_path / f"out{number}")
        atomic_write.clean(moved)
        pair = ((moved / "a.xlsx").read_bytes(), (moved / "a.json").read_bytes())
        assert pair in ((b"old 1", b"old 2"), (b"new 1", b"new 2"))
        folder = moved.rename(tmp_path / "out")
        one.write_bytes(b"old 1")
        two.write_bytes(b"old 2")


def test_that_a_link_stays_a_link_and_the_file_behind_is_replaced(tmp_path):
    behind, link = tmp_path / "real.json", tmp_path / "link.json"
    behind.write_text("old")
    behind.chmod(0o640)
    link.symlink_to(behind)
    atomic_write.write({link: b"new"})
    assert link.is_symlink() and behind.read_bytes() == b"new"
    assert behind.stat().st_mode & 0o777 == 0o640


def test_that_a_second_file_that_cannot_take_its_place_puts_the_first_back(tmp_path):
    first, second = tmp_path / "a.xlsx", tmp_path / "b.json"
    first.write_text("old")
    second.mkdir()
    with pytest.raises(Exception, match="what was there is unchanged"):
        atomic_write.write({first: b"new", second: b"new"})
    assert first.read_text() == "old"
    first.unlink()
    with pytest.raises(Exception, match="cannot be written"):
        atomic_write.write({first: b"new", second: b"new"})
    assert list(tmp_path.iterdir()) == [second]


def test_that_all_files_are_written_or_none(tmp_path):
    good, bad = tmp_path / "a", tmp_path / "missing" / "b"
    good.write_text("old")
    with pytest.raises(Exception, match="cannot be written"):
        atomic_write.write({good: b"new", bad: b"new"})
    assert good.read_text() == "old"
    assert list(tmp_path.iterdir()) == [good]
