"""The loops over lanes become vector instructions, on every processor that has them and their fused products."""

import inspect
import platform
import re

import pytest

from core.jit import cache
from core.jit.decorators import Kernel
from core.jit.shipped import LEVELS
from core.rocking import lanes
from core.rocking.taylor_series import WallConstants
from core.wall.rocking_model import RockingModel

LOOPS = {
    name: value.py_func
    for name, value in vars(lanes).items()
    if isinstance(value, Kernel) and "widest_vectors" in value.py_func.__code__.co_names
}
CASES = [
    (name, order)
    for name, loop in LOOPS.items()
    for order in ((6, 8) if "order" in inspect.signature(loop).parameters else (8,))
]
SCALAR = re.compile(r"\sv?(?:add|sub|mul|min|max|fn?m(?:add|sub)\d+|u?comi|cmp\w*)sd\s.*")
"""Sums, products and comparisons of one double. (A scalar that all lanes share is made before the loop by a division
or loaded.)"""
PACKED = re.compile(r"\sv?(?:add|sub|mul|fn?m(?:add|sub)\d+|and|blendv|cmp\w*)pd\s.*%[yz]mm")


def processors(own):
    """Name -> LLVM's machine: of the levels machine code is shipped for, as numba would make it there, and of this
    processor, numba's `own`."""
    import llvmlite.binding as llvm

    fused = [name for name in LEVELS if "fma" in LEVELS[name]]
    target = llvm.Target.from_triple(llvm.get_process_triple())
    made = {
        name: target.create_target_machine(
            cpu=name, features="", opt=1, reloc="static", codemodel="jitdefault", jit=True
        )
        for name in fused
    }
    return {**made, "this one": own} if llvm.get_host_cpu_features().get("fma") else made


@pytest.fixture
def assembly(monkeypatch):
    """A loop's assembly for several processors: it is compiled once, and optimised for each as numba would do there."""
    cache.configure_numba()
    from numba import njit, typeof, types
    from numba.core import codegen

    import core.jit.numba_extensions  # noqa: F401  (what numba has to know of kernels)

    found = {}
    optimise = codegen.CPUCodeLibrary._optimize_final_module

    def for_each_processor(library):
        if library.name in LOOPS:
            whole, own = library._final_module, library._codegen._tm
            for name, machine in processors(own).items():
                library._final_module, library._codegen._tm = whole.clone(), machine
                optimise(library)
                found[name] = machine.emit_assembly(library._final_module)
            library._final_module, library._codegen._tm = whole, own
        optimise(library)

    monkeypatch.setattr(codegen.CPUCodeLibrary, "_optimize_final_module", for_each_processor)

    def make(function, order):
        number, whole = types.float64, types.int64
        known = {
            "lanes": whole,
            "falling": whole,
            "dt": number,
            "rest_below": number,
            "order": types.literal(order),
            "model": typeof(RockingModel(0.1, 2.0, 0.0, 0.9, 0.0, 0.0, 0.0)),
            "state": number[::1],
            "constants": typeof(WallConstants((1.0, 1.0), *(1.0,) * (len(WallConstants._fields) - 1))),
        }
        loop = njit(nogil=True, error_model="numpy", _nrt=False, no_cpython_wrapper=True, no_cfunc_wrapper=True)
        loop(function).compile(tuple(known[name] for name in inspect.signature(function).parameters))
        return found

    return make


@pytest.mark.skipif(platform.machine().lower() not in ("x86_64", "amd64"), reason="reads assembly of x86-64")
@pytest.mark.parametrize("name, order", CASES)
def test_that_a_loop_over_lanes_is_vector_instructions_on_every_processor(assembly, name, order):
    found = assembly(LOOPS[name], order)
    assert len(found) >= 2
    for processor, text in found.items():
        assert not SCALAR.findall(text), processor
        assert PACKED.search(text), processor
