"""Kernels of a shipped library: the numbers of numba's own, for every kind of argument."""

import ctypes
import hashlib
from typing import NamedTuple

import numpy as np
import pytest

from core.errors import InputError
from core.jit import native, shipped, trial
from core.jit.decorators import kernel, subkernel
from core.jit.fma import fma
from tests.test_packaging import of_packaging


class Inner(NamedTuple):
    cube: np.ndarray
    count: int


class Outer(NamedTuple):
    factor: float
    inner: Inner
    nothing: None
    empty: tuple
    pair: tuple[float, float]
    flag: bool


@subkernel
def summed(values):
    total = 0.0
    for value in values.flat:
        total = fma(value, 3.0, total)
    return total


@kernel
def every_kind(values, whole, scale, number, flag, outer, nothing, result):
    """Returns (int, float, int)."""
    for i in range(result.size):
        result[i] = scale * values[i] + number * whole[i, 0] + outer.factor
    if flag and outer.flag:
        result[0] += summed(outer.inner.cube)
    if nothing is None:
        result[-1] -= outer.pair[1]
    return outer.inner.count, result.sum(), number


@kernel
def one_number(values):
    return summed(values)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """(library, kernel -> types -> [symbol, letters]) of the two kernels, made as the build makes it."""
    from numba import typeof

    place = tmp_path_factory.mktemp("library")
    patch = pytest.MonkeyPatch()
    kernels = of_packaging("kernels", patch)
    wanted = kernels.merged(
        [
            (every_kind, tuple(map(typeof, arguments()))),
            (every_kind, tuple(map(typeof, arguments(nothing=1.5)))),
            (one_number, (typeof(arguments()[0]),)),
        ]
    )
    names = kernels.compiled(wanted, "x86-64" if shipped.levels_of(["x86-64"]) else shipped.OF_ARM, place)
    patch.undo()
    return ctypes.CDLL(str(next(place.glob(shipped.file_name("*"))))), names


def arguments(seed=0, nothing=None):
    rng = np.random.default_rng(seed)
    cube = rng.normal(size=(2, 3, 2))
    outer = Outer(rng.normal(), Inner(cube, int(rng.integers(9))), None, (), (1.0, rng.normal()), True)
    whole = rng.integers(-9, 9, (6, 2))
    return rng.normal(size=6), whole, rng.normal(), int(rng.integers(-5, 5)), True, outer, nothing, np.zeros(6)


def of_library(library, one):
    found, names = library
    return native.NativeKernel(found, names[one.name], lambda *_: pytest.fail("not in the library"))


@pytest.mark.shows("install.same_bits")
@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("nothing", [None, 1.5])
def test_that_a_kernel_of_the_library_gives_the_bits_of_numba(library, seed, nothing):
    called = of_library(library, every_kind)
    own, shipped_ones = arguments(seed, nothing), arguments(seed, nothing)
    assert called(*shipped_ones) == every_kind(*own)
    assert own[-1].tobytes() == shipped_ones[-1].tobytes()
    readonly = own[0].copy()
    readonly.flags.writeable = False  # as that of a record
    assert of_library(library, one_number)(readonly) == one_number(readonly)


def test_that_other_types_go_to_numba(library):
    found, names = library
    asked = []
    called = native.NativeKernel(found, names[every_kind.name], lambda *given: asked.append(given))
    values, whole, *rest = arguments()
    for other in (values[::2], values.astype(np.float32), values.tolist(), np.zeros((6, 1)), 3.0):
        called(other, whole, *rest)
    called(values, whole, 1, *rest[1:])  # a whole number for another
    called(values, whole, rest[0], 2**64, *rest[2:])
    unaligned = np.frombuffer(bytes(49), np.uint8)[1:].view(np.float64)
    called(unaligned, whole, *rest)
    assert len(asked) == 8


def test_that_an_array_that_is_written_must_allow_it(library):
    """The machine code would write through to what may be a mapped file."""
    found, names = library
    called = native.NativeKernel(found, names[every_kind.name], lambda *given: "numba refuses it")
    *rest, result = arguments()
    result.flags.writeable = False
    assert called(*rest, result) == "numba refuses it" and not result.any()
    for values in rest[:2]:
        values.flags.writeable = False  # these are only read
    rest[5].inner.cube.flags.writeable = False
    assert called(*rest, np.zeros(6)) == every_kind.py_func(*rest, np.zeros(6))


def test_that_a_library_with_wrong_numbers_is_used_no_more(library, monkeypatch):
    found, names = library
    called = native.NativeKernel(found, names[one_number.name], lambda *given: "numba")
    assert called(arguments()[0]) == one_number(arguments()[0])
    monkeypatch.setattr(trial, "failed", [True])
    assert called(arguments()[0]) == "numba"


@pytest.mark.parametrize("numba", [True, False])
@pytest.mark.parametrize("wrong", [True, False])
def test_that_without_numba_wrong_machine_code_is_refused_and_else_python_runs(library, monkeypatch, numba, wrong):
    monkeypatch.setattr(native, "library", lambda: library[0])
    monkeypatch.setattr(native, "has_numba", lambda: numba)
    monkeypatch.setattr(trial, "failed", [True] if wrong else [])
    monkeypatch.setattr(shipped, "library", lambda: shipped.NO_LIBRARY._replace(kernels=library[1]))
    monkeypatch.setattr(shipped, "levels", list)
    if wrong and not numba:
        with pytest.raises(InputError, match="machine code supplied with the program does not give"):
            native.kernel(one_number.name, one_number.py_func, lambda: None)
        return
    made = native.kernel(one_number.name, lambda *_: "python", lambda: lambda *_: "numba")
    assert isinstance(made, native.NativeKernel) is not wrong
    if numba:
        assert made(1.0) == "numba"
    else:
        with pytest.warns(UserWarning, match=r"one_number.* not in the machine code .*: slow"):
            assert made(1.0) == "python"


@pytest.mark.parametrize("harm", ["no library", "damaged", "cannot be loaded"])
def test_that_a_program_without_its_machine_code_says_so_and_nothing_is_given_up(harm, monkeypatch, tmp_path):
    (tmp_path / shipped.file_name("x86-64")).write_bytes(b"no library")
    known = shipped.Library(tmp_path, {"x86-64": hashlib.sha256(b"no library").hexdigest()}, [], {})
    levels = [] if harm == "no library" else ["x86-64"]
    monkeypatch.setattr(shipped, "levels", lambda: levels)
    monkeypatch.setattr(shipped, "library", lambda: known)
    monkeypatch.setattr(native, "has_numba", lambda: False)
    monkeypatch.setattr(native, "library", native.library.__wrapped__)
    monkeypatch.setattr(trial, "failed", [])
    monkeypatch.setattr(native.cache, "folder", lambda: tmp_path)
    if harm == "damaged":
        (tmp_path / shipped.file_name("x86-64")).write_bytes(b"another")
    with pytest.raises(InputError, match="missing, damaged or cannot be loaded"):
        native.ready()
    assert not trial._begun and not list(tmp_path.glob("*-*[0-9a-f]-*"))
