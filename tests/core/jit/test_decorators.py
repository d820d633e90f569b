"""Kernels: the same numbers compiled, uncompiled and on any processor."""

import os
import re
import subprocess
import sys

import pytest

from core.jit import decorators
from tests.conftest import ROOT
from tests.core.jit.digest import run


@pytest.mark.shows("mechanics.any_processor")
@pytest.mark.long
def test_that_the_kernels_without_compiler_are_bit_identical():
    compiled = run()[0]
    assert run(NUMBA_DISABLE_JIT="1")[0] == compiled


@pytest.mark.shows("mechanics.any_processor")
@pytest.mark.long
def test_that_a_processor_without_wide_registers_or_fused_products_gives_the_same_bits(tmp_path):
    orders = ("taylor", "taylor_6")
    plain = run(*orders, RIBALTA_CACHE=str(tmp_path), NUMBA_CPU_NAME="generic", NUMBA_CPU_FEATURES="")
    assert plain[0] == run(*orders)[0]


@pytest.mark.shows("mechanics.fma")
def test_that_no_kernel_is_fast_math_or_parallel():
    for source in (ROOT / "core").rglob("*.py"):
        text = source.read_text()
        assert not re.search(r"fastmath\s*=|parallel\s*=|\bprange\b", text), source


def test_that_numba_waits_for_the_first_call_of_a_kernel():
    script = (
        "import sys; import core.study.run, app.terminal.batch; early = 'numba' in sys.modules;"
        "from core.ground.response_spectrum import housner_intensity; import numpy as np;"
        "housner_intensity(np.ones(50), 0.01); print(early, 'numba' in sys.modules)"
    )
    found = subprocess.run(
        [sys.executable, "-P", "-c", script],
        capture_output=True,
        text=True,
        check=True,
        env=dict(os.environ, PYTHONPATH=str(ROOT)),
    )
    assert found.stdout.split() == ["False", "True"]


def test_that_kernels_of_kernels_run_as_python_when_python_calls_them():
    @decorators.subkernel
    def half(x):
        return "python" if isinstance(x, str) else 0.5 * x

    @decorators.subkernel
    def quarter(x):
        return 0.25 * x

    @decorators.kernel
    def three_quarters(x):
        return 0.5 * x + quarter(x)

    assert half("a") == "python"
    assert quarter(8.0) == 2.0
    assert three_quarters(8.0) == 6.0


def test_that_a_kernel_runs_where_its_machine_code_cannot_be_saved(monkeypatch):
    from numba.core import caching

    def no_room(*arguments):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(caching.IndexDataCacheFile, "save", no_room)

    @decorators.kernel
    def doubled(x):
        return 2.0 * x

    assert doubled(21.0) == 42.0
