"""The hash of what machine code comes from: every source of it, and no other."""

import shutil
import sys

import pytest

from core.jit import stamp
from tests.conftest import ROOT


@pytest.mark.parametrize("step", [8, pytest.param(1, marks=pytest.mark.long)])
def test_that_the_stamp_follows_the_sources_of_kernels_and_no_others(tmp_path, step):
    """step : one source of so many of either kind"""
    core = tmp_path / "core"
    shutil.copytree(ROOT / "core", core, ignore=shutil.ignore_patterns("__pycache__"))
    of_kernels = stamp.kernel_sources(core)
    assert stamp.hash_of(of_kernels) == stamp.stamp()
    everything = sorted(core.rglob("*.py"))
    assert stamp.hash_of(everything) == stamp.source_stamp()
    seen, whole = {stamp.stamp()}, {stamp.source_stamp()}
    others = [source for source in everything if source not in of_kernels]
    changed = [*of_kernels[::step], *others[::step]]
    for source in changed:
        source.write_text(source.read_text() + "# another byte\n")
        whole.add(stamp.hash_of(everything))
        before = len(seen)
        seen.add(stamp.hash_of(stamp.kernel_sources(core)))
        assert (len(seen) > before) == (source in of_kernels), source
    assert len(whole) == len(changed) + 1
    folders = {source.relative_to(core).parts[0] for source in of_kernels}
    assert not folders & {"text", "report", "study", "codes", "case", "errors.py"}


def test_that_every_function_machine_code_comes_from_is_in_the_stamp():
    """By import: the module of every kernel, and whatever module one of its globals is from."""
    import importlib
    import types

    from core.jit.kernel import Kernel

    sources = {str(file) for file in stamp.kernel_sources(stamp.CORE)}
    kernels = 0
    for file in sorted(stamp.CORE.rglob("*.py")):
        if file.stem in ("__init__", "numba_extensions"):
            continue
        module = importlib.import_module(".".join(file.relative_to(ROOT).with_suffix("").parts))
        for value in list(vars(module).values()):
            if not isinstance(value, Kernel):
                continue
            kernels += 1
            function = value.__wrapped__
            assert function.__code__.co_filename in sources
            for name in function.__code__.co_names:
                used = function.__globals__.get(name)
                home = used.__wrapped__ if isinstance(used, Kernel) else used
                if isinstance(home, (types.FunctionType, type)) and home.__module__.startswith("core"):
                    assert sys.modules[home.__module__].__file__ in sources, name
    assert kernels > 100
