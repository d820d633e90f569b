"""What is replaced of numba, and that a version whose internals are not known is left as it is."""

import subprocess
import sys

import pytest

from tests.conftest import ROOT

ROCK = (
    "from core.rocking.history import history; from core.rocking.methods import METHODS\n"
    "from core.wall.block import Block; from core.wall.restitution import restitution\n"
    "from core.wall.moment_rotation import LAWS; from core.wall.rocking_model import rocking_model\n"
    "import numpy as np\n"
    "block = Block.rectangle(5.0, 0.1)\n"
    "model = rocking_model(block, False, restitution(block, 'housner', None), LAWS['rigid'])\n"
    "ground = 2.0 * np.sin(np.arange(200) * 0.1)\n"
    "print(repr(float(history(ground, 0.01, 1.0, model).rotation.sum())))\n"
    "from numba.core import types; print(types.Function.get_call_type.__module__)\n"
)


MADE = "import core.jit.numba_extensions; from numba.core import types; print(types.Function.get_call_type.__module__)"


def of_a_history(before: str) -> list[str]:
    """Sum of the rotations, and the module that finds the types of a call."""
    done = subprocess.run(
        [sys.executable, "-c", before + ROCK], cwd=ROOT, capture_output=True, text=True, check=True, timeout=240
    )
    return done.stdout.split()


@pytest.mark.parametrize(
    "before, module",
    [("", "core.jit.numba_extensions"), ("import numba; numba.__version__ = '9.0.0'\n", "numba.core.types.functions")],
)
def test_that_an_unknown_numba_is_left_as_it_is(before, module):
    command = [sys.executable, "-c", before + MADE]
    assert subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split() == [module]


@pytest.mark.long  # every kernel of a history is compiled anew
def test_that_an_unknown_numba_gives_the_same_results():
    value, module = of_a_history("")
    assert module == "core.jit.numba_extensions"
    assert of_a_history("import numba; numba.__version__ = '9.0.0'\n") == [value, "numba.core.types.functions"]
