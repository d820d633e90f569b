"""Where compiled kernels live: private, checked, and never in the way of a start."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from core.jit import cache
from tests.conftest import ROOT
from tests.core.jit.digest import run


@pytest.mark.long
def test_that_damaged_cache_files_are_dropped_and_compiled_again(tmp_path):
    digest, folder = run(RIBALTA_CACHE=str(tmp_path))
    files = sorted(os.path.join(folder, name) for name in os.listdir(folder))
    code = [name for name in files if name.endswith(".nbc")]
    assert len(code) >= 3
    for name in code[:2]:
        with open(name, "r+b") as stream:
            stream.seek(200)
            stream.write(b"\x00" * 64)
    with open(files[1], "r+b") as stream:
        stream.truncate(10)
    assert run(RIBALTA_CACHE=str(tmp_path))[0] == digest
    # the manifest itself damaged: nothing is trusted, everything works
    with open(os.path.join(folder, cache.MANIFEST), "w") as stream:
        stream.write("[1, 2")
    assert run(RIBALTA_CACHE=str(tmp_path)) == (digest, folder)


def test_that_drop_damaged_keeps_what_is_sound(tmp_path):
    for name in ("a.nbi", "b.nbc"):
        (tmp_path / name).write_bytes(b"machine code " + name.encode())
    cache.record(tmp_path)
    (tmp_path / "c.nbc").write_bytes(b"never recorded")
    (tmp_path / "b.nbc").write_bytes(b"changed")
    cache.drop_damaged(tmp_path)
    assert sorted(path.name for path in tmp_path.glob("*.nb*")) == ["a.nbi"]
    assert set(json.loads((tmp_path / cache.MANIFEST).read_text())) == {"a.nbi", "b.nbc"}


@pytest.mark.skipif(os.name == "nt", reason="owners and modes of POSIX")
def test_that_a_folder_others_can_write_is_not_used(tmp_path):
    base = tmp_path / "cache"
    first = cache.prepare(base, "stamp")
    assert first == base / "kernels-stamp"
    assert first.stat().st_mode & 0o777 == 0o700
    first.chmod(0o777)
    other = cache.prepare(base, "stamp")
    assert other != first and cache.private(other)
    shutil.rmtree(other)


def test_that_an_unwritable_place_falls_back_to_a_temporary_folder(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    folder = cache.prepare(blocked / "below", "stamp")
    assert folder.is_dir() and tmp_path not in folder.parents
    shutil.rmtree(folder)


def test_that_no_flipped_bit_of_the_manifest_ends_a_run(tmp_path):
    """The cache heals itself: what is not as recorded is compiled again."""
    folder = tmp_path / "kernels-x"
    folder.mkdir(mode=0o700)
    (folder / "a.nbi").write_bytes(b"index")
    cache.record(folder)
    good = (folder / "manifest.json").read_bytes()
    for place in range(len(good)):
        for bit in (0, 3, 7):
            changed = bytearray(good)
            changed[place] ^= 1 << bit
            (folder / "manifest.json").write_bytes(changed)
            (folder / "a.nbi").write_bytes(b"index")
            cache.drop_damaged(folder)
            cache.record(folder)
            known = json.loads((folder / "manifest.json").read_bytes())
            assert set(known) == {path.name for path in folder.glob("*.nbi")}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes on this system")
def test_that_a_pipe_in_the_cache_holds_nobody_up(tmp_path):
    folder = tmp_path / "kernels-x"
    folder.mkdir(mode=0o700)
    for name in ("a.nbi", "manifest.json"):
        os.mkfifo(folder / name)
    assert cache.prepare(tmp_path, "x") == folder
    cache.record(folder)
    assert (folder / "manifest.json").read_bytes() == b"{}"


def test_that_threads_of_a_cold_start_share_one_folder(tmp_path):
    """Eight threads ask for the cache's folder at once, where the user's cannot be written."""
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    script = (
        "import threading; from core.jit import cache; gate = threading.Barrier(8); seen = set()\n"
        "def ask():\n    gate.wait()\n    seen.add(cache.folder())\n"
        "threads = [threading.Thread(target=ask) for _ in range(8)]\n"
        "[t.start() for t in threads]; [t.join() for t in threads]; print(len(seen))"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT), RIBALTA_CACHE=str(blocked / "below")),
    )
    assert done.stdout == "1\n"


def test_that_kernels_are_kept_in_the_cache_whoever_imported_numba_first(tmp_path):
    script = (
        "import numba, numpy as np; from core.ground.response_spectrum import housner_intensity;"
        "housner_intensity(np.ones(50), 0.01)"
    )
    subprocess.run(
        [sys.executable, "-P", "-c", script],
        check=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT), RIBALTA_CACHE=str(tmp_path)),
    )
    assert list(tmp_path.glob("kernels-*/*.nbc"))


def test_that_only_old_folders_of_this_program_are_deleted(tmp_path):
    """RIBALTA_CACHE may name a folder that holds other things."""
    files = {
        "kernels-0123456789abcdef/a.nbi": True,
        "kernels-0123456789abcdef-x86-64-v3-own/manifest.json": True,
        "kernels-0123456789abcde0/photos.zip": False,
        "kernels-of-linux/vmlinuz": False,
        "kernels-mine/manifest.json": False,
    }
    for name in files:
        (tmp_path / name).parent.mkdir(mode=0o700)
        (tmp_path / name).write_bytes(b"x")
        os.utime((tmp_path / name).parent, (1e9, 1e9))
    (tmp_path / "kernels-0123456789abcde1").write_bytes(b"a file of this name")
    os.utime(tmp_path / "kernels-0123456789abcde1", (1e9, 1e9))
    cache.prepare(tmp_path, "fedcba9876543210")
    assert {name: not (tmp_path / name).exists() for name in files} == files
    assert (tmp_path / "kernels-0123456789abcde1").exists()
    assert (tmp_path / "kernels-fedcba9876543210").is_dir()


def test_that_an_empty_variable_names_no_folder(monkeypatch):
    monkeypatch.setenv("RIBALTA_CACHE", "")
    assert cache.user_folder().is_absolute()
