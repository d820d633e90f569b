"""Machine code that was made before: the best level, for this very program, whole, of nobody else, or not used."""

import hashlib
import json
import os
from pathlib import Path

import pytest

from core.jit import cache, shipped, trial
from tests.core.jit import digest
from tests.test_packaging import of_packaging

CODE = b"machine code"
HASHES = dict.fromkeys(shipped.PROCESSOR_LEVELS, hashlib.sha256(CODE).hexdigest())


def make_library(folder, **changed):
    """A library with a file for each level. changed : entries of its index"""
    folder.mkdir(parents=True, mode=0o755)
    for name in shipped.PROCESSOR_LEVELS:
        (folder / shipped.file_name(name)).write_bytes(CODE)
    content = {"made_for": shipped.made_for(), "levels": HASHES, "self_test": ["0x1p0"], "kernels": {}}
    (folder / shipped.INDEX).write_bytes(shipped.index_of(content | changed))


@pytest.fixture
def places(tmp_path, monkeypatch):
    """A program that tries machine code: (where the frozen one has it, where a package of it is)."""
    monkeypatch.setattr(shipped, "FOLDER", tmp_path / "kernels")
    monkeypatch.setattr(shipped.np, "__file__", str(tmp_path / "site" / "numpy" / "__init__.py"))
    monkeypatch.setattr(shipped.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(trial, "self_test", [lambda: True])
    monkeypatch.delenv(shipped.FORCED_LEVEL, raising=False)
    shipped.library.cache_clear()
    yield shipped.FOLDER, tmp_path / "site" / shipped.PACKAGE
    shipped.library.cache_clear()


def processor(monkeypatch, *features):
    monkeypatch.setattr(shipped, "features", lambda: set(features))


@pytest.mark.parametrize("place", [0, 1])
def test_that_the_best_level_a_processor_has_is_taken(places, monkeypatch, place):
    make_library(places[place])
    v3, zen = shipped.PROCESSOR_LEVELS["x86-64-v3"], shipped.PROCESSOR_LEVELS["znver3"]
    for features, level in (
        ({*shipped.PROCESSOR_LEVELS["x86-64-v4"], "sse2"}, "x86-64-v4"),
        ({*shipped.PROCESSOR_LEVELS["x86-64-v4"], *zen}, "x86-64-v4"),  # Zen 4 and later
        ({*v3, "avx512f"}, "x86-64-v3"),  # not all of level 4
        ({*zen, "sse2"}, "znver3"),
        (zen - {"vaes"}, "x86-64-v3"),  # Zen 2
        (zen - {"sse4a"}, "x86-64-v3"),  # Intel
        (v3 - {"fma"}, "x86-64"),
    ):
        processor(monkeypatch, *features)
        assert shipped.levels()[0] == level and shipped.levels()[-1] == "x86-64"
        assert shipped.whole_file(level).read_bytes() == CODE
    monkeypatch.setattr(shipped.platform, "machine", lambda: "arm64")
    processor(monkeypatch, *v3)
    assert shipped.levels() == [] and shipped.levels_of([shipped.OF_ARM]) == [shipped.OF_ARM]


def test_that_a_level_is_used_only_where_it_was_made(places, monkeypatch):
    make_library(places[0], levels={"x86-64-v3": HASHES["x86-64"]})
    processor(monkeypatch, *shipped.PROCESSOR_LEVELS["x86-64-v4"])
    assert shipped.levels() == ["x86-64-v3"]
    processor(monkeypatch)
    assert shipped.levels() == []


def test_that_nothing_is_shipped_with_the_source_tree(places):
    assert shipped.levels() == [] and shipped.whole_file("x86-64") is None


def test_that_machine_code_that_nothing_would_try_is_not_used(places, monkeypatch):
    """A process that calls kernels by itself, such as a benchmark, compiles for its very processor."""
    make_library(places[1])
    monkeypatch.setattr(trial, "self_test", [])
    assert shipped.levels() == [] and shipped.whole_file("x86-64") is None


@pytest.mark.shows("install.made_for")
@pytest.mark.parametrize("key", ["kernels", "system", "processor"])
def test_that_a_package_made_for_something_else_is_not_used(places, key):
    make_library(places[1])
    assert shipped.library().levels
    shipped.library.cache_clear()
    index = shipped.index_of(
        {"made_for": shipped.made_for() | {key: "another"}, "levels": HASHES, "self_test": [], "kernels": {}}
    )
    (places[1] / shipped.INDEX).write_bytes(index)
    assert shipped.levels() == [] and shipped.whole_file("x86-64") is None


@pytest.mark.shows("install.made_for")
@pytest.mark.skipif(os.name == "nt", reason="owners and modes of POSIX")
@pytest.mark.parametrize("what", [".", shipped.INDEX, shipped.file_name("x86-64")])
@pytest.mark.parametrize("harm", [0o020, 0o002, "owner"])
def test_that_a_package_another_user_can_write_is_not_used(places, what, harm):
    make_library(places[1])
    assert shipped.whole_file("x86-64")
    shipped.library.cache_clear()
    path = places[1] / what
    if harm != "owner":
        path.chmod(path.stat().st_mode | harm)
    elif os.getuid() == 0:
        os.chown(path, 12345, -1)
    else:
        pytest.skip("only root gives a file away")
    assert not (shipped.levels() and shipped.whole_file("x86-64"))


@pytest.mark.shows("install.machine_code")
@pytest.mark.parametrize("place", [0, 1])
@pytest.mark.parametrize("harm", ["changed", "missing", "a link", "a folder"])
def test_that_damaged_machine_code_is_not_used(places, harm, place):
    make_library(places[place])
    file = places[place] / shipped.file_name("x86-64")
    if harm == "changed":
        file.write_bytes(CODE + b"?")
    else:
        file.unlink()
    if harm == "a link":
        file.symlink_to(file.with_name("nothing"))
    elif harm == "a folder":
        file.mkdir()
    assert shipped.whole_file("x86-64") is None and shipped.whole_file("x86-64-v3")


@pytest.mark.shows("install.machine_code")
@pytest.mark.parametrize("place", [0, 1])
def test_that_a_damaged_index_is_not_used(places, place):
    make_library(places[place])
    index = places[place] / shipped.INDEX
    good = index.read_bytes()
    flipped = [good[:k] + bytes([good[k] ^ 4]) + good[k + 1 :] for k in range(0, len(good), 97)]
    odd = [json.dumps(content).encode() for content in (None, 5, [], {}, {"levels": 5, "made_for": 1, "self_test": []})]
    signed = [hashlib.sha256(text).hexdigest().encode() + b"\n" + text for text in [*odd, b"{", b"[" * 9999]]
    for content in (b"", b"\n", good[:-1], *flipped, *signed):
        index.write_bytes(content)
        shipped.library.cache_clear()
        assert shipped.library() == shipped.NO_LIBRARY and shipped.levels() == []


@pytest.mark.long
@pytest.mark.shows("install.same_bits")
@pytest.mark.parametrize("level", list(shipped.PROCESSOR_LEVELS))
def test_that_machine_code_made_without_running_it_gives_the_bits_of_own_code_of_its_level(
    tmp_path, monkeypatch, level
):
    """Listed on another level, compiled for this one, tried, and used: nothing more is compiled, nor numba imported."""
    if not shipped.levels_of([level]):
        pytest.skip("not this processor's")
    other = next(name for name in ("x86-64-v3", "x86-64") if name != level)
    own, _ = digest.run("taylor", RIBALTA_LEVEL=level, RIBALTA_CACHE=str(tmp_path / "own"))
    listed = digest.run("taylor", RIBALTA_LEVEL=other, RIBALTA_CACHE=str(tmp_path / "listed"))[1]
    library = tmp_path / "kernels"
    of_packaging("kernels", monkeypatch).write(library, listed, [], [level])
    before = (
        f"import pathlib, sys; from core.jit import shipped, trial; shipped.FOLDER = pathlib.Path({str(library)!r})\n"
        "sys.modules['numba'] = None; trial.self_test[:] = [lambda: True]\n"
    )
    found, used = digest.run("taylor", before=before, RIBALTA_CACHE=str(tmp_path / "user"))
    assert found == own
    made = sorted(file.name for file in Path(used).iterdir())
    assert made[0] == cache.MANIFEST and made[1].startswith(trial.PASSED) and len(made) == 2
    assert cache.private(Path(used))
