"""The loops over lanes become vector instructions, on every processor that has them and their fused products, and cheap
ones: none that stores under a mask, no more of them and of accesses to the stack than they need."""

import inspect
import re

import pytest

from core.jit import cache
from core.jit.decorators import Kernel
from core.jit.shipped import PROCESSOR_LEVELS, features
from core.rocking import held_lanes, lanes
from core.rocking.taylor_series import WallConstants
from core.wall.rocking_model import OtherSide, RockingModel

LOOPS, HELD = (
    {
        name: value.py_func
        for name, value in vars(module).items()
        if isinstance(value, Kernel) and "widest_vectors" in value.py_func.__code__.co_names
    }
    for module in (lanes, held_lanes)
)
CASES = (
    [
        (name, order, slopes, "one body")
        for name, loop in LOOPS.items()
        for order in ((6, 8) if "order" in inspect.signature(loop).parameters else (8,))
        for slopes in ((True, False) if "slopes" in inspect.signature(loop).parameters else (True,))
    ]
    + [(name, 8, False, "two hinges") for name in LOOPS]
    + [(name, 8, True, "bars") for name, loop in LOOPS.items() if "bars" in inspect.signature(loop).parameters]
    + [(name, 8, True, "held") for name in HELD]
)
"""Loop, order of the series, whether the law has slopes, whether the wall has two hinges or bars or is held at its
top."""
FEW = [case for case in CASES if case[1] == 8 and (case[2] or case[3] != "one body")]
"""Of one body those of most terms."""
SCALAR = re.compile(r"\sv?(?:add|sub|mul|min|max|fn?m(?:add|sub)\d+|u?comi|cmp\w*)sd\s.*")
"""Sums, products and comparisons of one double."""
PACKED = re.compile(r"\sv?(?:add|sub|mul|fn?m(?:add|sub)\d+|and|blendv|cmp\w*)pd\s.*%[yz]mm")
MASKED = re.compile(r"\tvmaskmovpd\s%[xyz]mm\d+, %[xyz]mm\d+, \S*\(.*|\tvmov[au]pd\s%[xyz]mm\d+, [^%]*\(.*\{%k\d\}.*")
"""A store under a mask: seven cycles each on AMD's processors."""
STACK = re.compile(r"\(%r[sb]p\)")
BUDGET = {
    "lane_initial_terms": {"x86-64-v3": (66, 15), "x86-64-v4": (66, 0)},
    "lane_taylor_coefficients": {"x86-64-v3": (210, 78), "x86-64-v4": (153, 18)},
    "shorten_steps": {"x86-64-v3": (186, 49), "x86-64-v4": (143, 9)},
    "restore_partial_steps": {"x86-64-v3": (27, 0), "x86-64-v4": (24, 0)},
    "vector_step": {"x86-64-v3": (305, 97), "x86-64-v4": (214, 35)},
    "locate_impacts": {"x86-64-v3": (324, 97), "x86-64-v4": (273, 37)},
    "vector_step_held": {"x86-64-v3": (423, 115), "x86-64-v4": (339, 41)},
}
WITH_BARS = {
    "lane_initial_terms": {"x86-64-v3": (60, 14), "x86-64-v4": (60, 0)},
    "lane_taylor_coefficients": {"x86-64-v3": (293, 102), "x86-64-v4": (201, 19)},
    "shorten_steps": {"x86-64-v3": (187, 46), "x86-64-v4": (146, 12)},
    "vector_step": {"x86-64-v3": (342, 102), "x86-64-v4": (244, 39)},
    "locate_impacts": {"x86-64-v3": (336, 102), "x86-64-v4": (267, 38)},
}
"""The same of walls held by bars."""
"""Loop -> level -> instructions and accesses to the stack of its longest form, as numba 0.68 makes it."""
TWO_HINGES = 8
"""Instructions, and accesses to the stack, that the numbers of a second hinge may add."""
SLACK = 1.1
"""Over the budget that another version of LLVM may take."""

JUMP = re.compile(r"^\tj\w+\s(\.L\w+)$")


def loops_of(text):
    """The lines between each label and the last jump back to it: what all lanes share is computed before them."""
    lines = text.splitlines()
    labels = {line[:-1]: number for number, line in enumerate(lines) if line.startswith(".L") and line.endswith(":")}
    ends = {}
    for number, line in enumerate(lines):
        jump = JUMP.match(line)
        if jump and labels.get(jump[1], number) < number:
            ends[labels[jump[1]]] = number
    return ["\n".join(lines[start:end]) for start, end in ends.items()]


LEVEL = 2
"""Of optimisation, as `cache.own_process` sets it."""


def processors(own):
    """Name -> LLVM's machine, of the levels machine code is shipped for, as numba would make it there, and of this
    processor, numba's `own`."""
    import llvmlite.binding as llvm

    fused = [name for name, needs in PROCESSOR_LEVELS.items() if "fma" in needs]
    target = llvm.Target.from_triple(llvm.get_process_triple())
    options = {"opt": LEVEL, "reloc": "static", "codemodel": "jitdefault", "jit": True}
    made = {name: target.create_target_machine(cpu=name, features="", **options) for name in fused}
    return {**made, "this one": own}


@pytest.fixture
def assembly(monkeypatch):
    """A loop's assembly for several processors: it is compiled once, and optimised for each as numba would do there."""
    cache.own_process()
    from numba import njit, typeof, types
    from numba.core import codegen, config

    import core.jit.numba_extensions  # noqa: F401  (what numba has to know of kernels)

    found = {}
    optimise = codegen.CPUCodeLibrary._optimize_final_module

    def for_each_processor(library):
        if library.name in {**LOOPS, **HELD}:
            whole, own = library._final_module, library._codegen._tm
            for name, machine in processors(own).items():
                library._final_module, library._codegen._tm = whole.clone(), machine
                monkeypatch.setattr(config, "OPT", type(config.OPT)(LEVEL))
                optimise(library)
                found[name] = machine.emit_assembly(library._final_module)
            library._final_module, library._codegen._tm = whole, own
        optimise(library)

    monkeypatch.setattr(codegen.CPUCodeLibrary, "_optimize_final_module", for_each_processor)

    def make(function, order, slopes, wall):
        number, whole = types.float64, types.int64
        other = OtherSide.of(0.2, 3.0, 0.8) if wall == "two hinges" else None
        known = {
            "lanes": whole,
            "falling": whole,
            "dt": number,
            "rest_below": typeof((1.0, 1.0)),
            "order": types.literal(order),
            "slopes": number if slopes else types.none,
            "model": typeof(RockingModel(0.1, 2.0, 0.0, 0.9, 0.0, 0.0, 0.0, other=other)),
            "bars": number[:, ::1] if wall == "bars" else types.none,
            "state": number[::1],
            "p2": number,
            **dict.fromkeys(("outward", "inward"), typeof((1.0, 1.0, 1.0))),
            "constants": typeof(WallConstants((1.0, 1.0), *(1.0,) * 7, other)),
        }
        loop = njit(nogil=True, error_model="numpy", _nrt=False, no_cpython_wrapper=True, no_cfunc_wrapper=True)
        loop(function).compile(tuple(known[name] for name in inspect.signature(function).parameters))
        return found

    return make


@pytest.mark.skipif(
    "avx512vl" not in features(),
    reason="passes before the last are of this processor: with vectors of 256 bits they leave four sums of vector_step "
    "under a mask scalar (speed.md)",
)
@pytest.mark.parametrize(
    "name, order, slopes, wall",
    [*FEW, *(pytest.param(*case, marks=pytest.mark.long) for case in CASES if case not in FEW)],
)
def test_that_a_loop_over_lanes_is_packed_and_no_longer_than_it_needs_on_every_processor(
    assembly, name, order, slopes, wall
):
    found, budget = (
        assembly({**LOOPS, **HELD}[name], order, slopes, wall),
        (WITH_BARS if wall == "bars" else BUDGET)[name],
    )
    assert len(found) >= 2
    for processor, text in found.items():
        loops = loops_of(text)
        assert any(PACKED.search(loop) for loop in loops), processor
        for loop in loops:
            assert not SCALAR.findall(loop), processor
            assert not MASKED.findall(loop), processor
        if processor in budget:
            whole = [line for line in max(loops, key=len).splitlines() if re.match(r"\t[^.]", line)]
            taken = len(whole), sum(bool(STACK.search(line)) for line in whole)
            most = budget[processor]
            room = TWO_HINGES if wall == "two hinges" else 2
            assert all(one <= SLACK * limit + room for one, limit in zip(taken, most, strict=True)), (processor, taken)
