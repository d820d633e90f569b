"""The branches of Windows, over the rules of its files: tests of what is written, kept and recovered run there too."""

import importlib
import os
import subprocess
import sys
from typing import IO, Any

import pytest

from tests import windows
from tests.conftest import ROOT
from tests.test_run import load

pytestmark = pytest.mark.skipif(not os.path.isdir("/proc/self/fd"), reason="the stand-in asks /proc")

FILES = (
    "tests/core/test_atomic_write.py",
    "tests/core/study/test_journal.py",
    "tests/core/jit/test_cache.py",
    "tests/core/jit/test_shipped.py",
    "tests/app/test_recovery.py",
)
OF_POSIX = "not others_can_write and not another_user and not unwritable_place"


@pytest.mark.shows("doors.windows")
def test_that_what_is_written_kept_and_recovered_is_so_on_windows_and_every_branch_of_it_runs(tmp_path):
    reached = tmp_path / "reached"
    found = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-k", OF_POSIX, *FILES],
        capture_output=True,
        text=True,
        cwd=ROOT,
        env=dict(os.environ, RIBALTA_AS_WINDOWS=str(reached), PYTHONPATH=str(ROOT)),
    )
    assert found.returncode == 0, found.stdout[-3000:]
    assert set(reached.read_text().split()) >= set(windows.asking(ROOT))


def test_that_the_stand_in_refuses_what_windows_refuses(tmp_path, monkeypatch):
    windows.stand_in(monkeypatch, ROOT)
    file, other = tmp_path / "a", tmp_path / "b"
    other.write_text("")
    with open(file, "w"), open(file) as second:
        for refused in (lambda: os.replace(other, file), lambda: os.rename(file, tmp_path / "c"), file.unlink):
            with pytest.raises(PermissionError):
                refused()
        msvcrt: Any = importlib.import_module("msvcrt")
        with open(other) as third, open(other) as fourth:
            msvcrt.locking(third.fileno(), msvcrt.LK_NBLCK, 1)
            with pytest.raises(OSError, match="deadlock"):
                msvcrt.locking(fourth.fileno(), msvcrt.LK_NBLCK, 1)
        msvcrt.locking(second.fileno(), msvcrt.LK_NBLCK, 1)
    with pytest.raises(FileExistsError):
        os.rename(other, file)
    os.replace(other, file)
    with pytest.raises(PermissionError):
        os.open(tmp_path, os.O_RDONLY)


def test_that_two_starts_of_run_py_take_turns_on_windows(tmp_path, monkeypatch):
    monkeypatch.setenv("RIBALTA_ENV", str(tmp_path / "env"))
    run = load()
    windows.stand_in(monkeypatch, ROOT)
    monkeypatch.setattr(run, "os", windows._Seen(os, "run.py", "name", "nt"))
    said = []
    monkeypatch.setattr(run, "say", said.append)
    opened: list[IO[str]] = []
    monkeypatch.setattr(run.time, "sleep", lambda seconds: opened[0].close() if said else None)
    with run.environment_lock():
        pass
    second = open(tmp_path / "env.lock", "a")  # noqa: SIM115
    opened.append(second)
    sys.modules["msvcrt"].locking(second.fileno(), 2, 1)
    with run.environment_lock():
        assert len(said) == 1 and second.closed
    assert run.interpreter().endswith(os.path.join("Scripts", "python.exe"))
    assert run.site_packages().endswith(os.path.join("Lib", "site-packages"))
    assert run.guarded(str(tmp_path)) and run.hand_over([sys.executable, "-c", "raise SystemExit(3)"]) == 3
