"""The second process of a cold start."""

import os
import subprocess
import sys

import pytest

from core.study import precompile
from tests.conftest import ROOT

COLD = """
import sys, numpy as np
from core.study import precompile
from core.rocking.history import history
from core.rocking.methods import METHODS
from core.wall.rocking_model import RockingModel
from core.rocking.taylor import through_sample
precompile.sys.executable = sys.argv[1]
precompile.start({"taylor_6", "rk4"})
model = RockingModel(0.1, 2.0, 0.0, 0.97, 0.0, 0.0, 0.0)
found = history(np.sin(np.arange(400.0)), 0.01, 3.0, model, METHODS["taylor_6"])
taken = sum(through_sample.dispatcher.stats.cache_hits.values())
print(taken, len(precompile._second), found.rotation.sum(), found.peak)
precompile.end()
precompile._second.clear()
precompile.start({"taylor_6"})
print(len(precompile._second))
precompile.end()
"""


@pytest.mark.long
@pytest.mark.skipif(precompile.available_cores() < 2, reason="one processor: there is no second process")
def test_that_a_second_process_compiles_the_step_where_nothing_is_compiled(tmp_path):
    def cold(executable, folder):
        found = subprocess.run(
            [sys.executable, "-P", "-c", COLD, executable],
            capture_output=True,
            text=True,
            check=True,
            env=dict(os.environ, PYTHONPATH=str(ROOT), RIBALTA_CACHE=str(folder)),
        )
        return found.stdout.split()

    taken, begun, *results, again = cold(sys.executable, tmp_path / "two")
    assert (taken, begun, again) == ("1", "1", "0")  # and no other where it is compiled
    missing = cold(str(tmp_path / "nothing"), tmp_path / "one")
    assert missing == ["0", "0", *results, "0"]
    # a second process that ends without having compiled anything
    assert cold("/bin/false", tmp_path / "none")[2:4] == results
