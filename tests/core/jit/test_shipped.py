"""Machine code that comes with the frozen program: whole or not used, on trial until its numbers are right."""

import hashlib
import json
import shutil

import pytest

from core.jit import cache, shipped

FILES = {"a.nbi": b"index", "a.1.nbc": b"machine code"}


@pytest.fixture
def level(tmp_path, monkeypatch):
    """A folder of machine code for each level."""
    for name in shipped.LEVELS:
        folder = tmp_path / "kernels" / name
        folder.mkdir(parents=True)
        for file, content in FILES.items():
            (folder / file).write_bytes(content)
        hashes = {file: hashlib.sha256(content).hexdigest() for file, content in FILES.items()}
        (folder / shipped.MANIFEST).write_text(json.dumps(hashes))
    monkeypatch.setattr(shipped, "FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(shipped.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(cache, "_trials", [])
    return tmp_path


def processor(monkeypatch, *features):
    known = dict.fromkeys(features, True)
    monkeypatch.setattr("llvmlite.binding.get_host_cpu_features", lambda: known)


def test_that_the_best_level_a_processor_has_is_taken(level, monkeypatch):
    v3 = shipped.LEVELS["x86-64-v3"]
    processor(monkeypatch, *shipped.LEVELS["x86-64-v4"], "sse2")
    assert shipped.level() == "x86-64-v4"
    processor(monkeypatch, *v3, "avx512f")  # not all of level 4
    assert shipped.level() == "x86-64-v3"
    processor(monkeypatch, *(v3 - {"fma"}))
    assert shipped.level() == "x86-64"
    (shipped.FOLDER / "x86-64" / shipped.MANIFEST).unlink()
    assert shipped.level() == ""
    monkeypatch.setattr(shipped.platform, "machine", lambda: "arm64")
    processor(monkeypatch, *v3)
    assert shipped.level() == ""


def test_that_nothing_is_shipped_with_the_source_tree():
    assert shipped.level() == "" and cache.name() == cache.stamp()


@pytest.mark.parametrize("harm", ["changed", "missing", "manifest"])
def test_that_damaged_machine_code_is_not_used(level, harm):
    folder = shipped.FOLDER / "x86-64"
    assert shipped.whole_files("x86-64") == FILES
    if harm == "changed":
        (folder / "a.1.nbc").write_bytes(b"machine code?")
    elif harm == "missing":
        (folder / "a.nbi").unlink()
    else:
        (folder / shipped.MANIFEST).write_text("{")
    assert shipped.whole_files("x86-64") == {}


def started(base, monkeypatch):
    """The folder a start of the program takes."""
    monkeypatch.setenv("RIBALTA_CACHE", str(base))
    monkeypatch.setattr(cache, "name", lambda: "stamp-x86-64")
    monkeypatch.setattr(shipped, "level", lambda: "x86-64")
    monkeypatch.setattr(cache.atexit, "register", lambda function: None)
    monkeypatch.setattr(cache, "_trials", [])
    folder = cache.folder.__wrapped__()
    monkeypatch.setattr(cache, "folder", lambda: folder)
    return folder


def test_that_shipped_machine_code_is_kept_once_its_numbers_are_right(level, monkeypatch):
    real = cache.folder
    folder = started(level / "user", monkeypatch)
    assert folder.name == "kernels-stamp-x86-64" and cache.on_trial()
    assert {name: (folder / name).read_bytes() for name in FILES} == FILES
    cache.end_trial(right=True)
    assert not cache.on_trial() and not (folder / cache.TRIAL).exists()
    monkeypatch.setattr(cache, "folder", real)
    assert started(level / "user", monkeypatch) == folder and not cache.on_trial()


def test_that_machine_code_that_failed_or_ended_its_trial_badly_is_not_used_again(
    level, monkeypatch
):
    real = cache.folder
    folder = started(level / "user", monkeypatch)
    cache.end_trial(right=False)
    monkeypatch.setattr(cache, "folder", real)
    other = started(level / "user", monkeypatch)
    assert (
        other.name == folder.name + "-own" and not any(other.glob("*.nb*")) and not cache.on_trial()
    )


def test_that_a_cache_without_room_leaves_a_folder_of_the_process(level, monkeypatch):
    write, failed = type(level).write_bytes, []

    def no_room_at_first(path, content):
        if path.name == "a.1.nbc" and not failed:
            failed.append(path.parent)
            raise OSError(28, "No space left on device")
        return write(path, content)

    monkeypatch.setattr(type(level), "write_bytes", no_room_at_first)
    folder = started(level / "user", monkeypatch)
    assert folder.name.startswith(cache.TEMPORARY) and not failed[0].exists()
    assert cache.on_trial() and {name: (folder / name).read_bytes() for name in FILES} == FILES
    shutil.rmtree(folder)
