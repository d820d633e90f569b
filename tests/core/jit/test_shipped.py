"""Machine code that comes with the frozen program: the best level, whole or not used."""

import hashlib
import json

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


@pytest.mark.shows("install.machine_code")
@pytest.mark.parametrize("harm", ["changed", "missing", "{", "null", "5", "[]", '["a.nbi"]', "[" * 9999])
def test_that_damaged_machine_code_is_not_used(level, harm):
    folder = shipped.FOLDER / "x86-64"
    assert shipped.whole_files("x86-64") == FILES
    if harm == "changed":
        (folder / "a.1.nbc").write_bytes(b"machine code?")
    elif harm == "missing":
        (folder / "a.nbi").unlink()
    else:
        (folder / shipped.MANIFEST).write_text(harm)
    assert shipped.whole_files("x86-64") == {}
