"""Shared fixtures: the shelf of real records, the reference histories, a wall of the paper."""

import contextlib
import csv
import gc
import math
import os
import pickle
import random
from pathlib import Path

import numpy as np
import pytest

from core.jit import cache

cache.own_process()  # the tests are a program
os.environ["OPENPYXL_LXML"] = "False"
for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
    os.environ[name] = "C.UTF-8"  # the tests read the program's words in English

ROOT = Path(__file__).resolve().parents[1]

FACADE = """[[wall]]
name = "facade"
height_m = 5.0
thickness_m = 0.5
mechanism = "two_sided"
base_z_m = 0.0
"""
"""A wall as a case file has it."""

STANDING = {"name": "w", "height_m": 30.0, "slenderness_deg": 11.0, "base_z_m": 0.0, "mechanism": "two_sided"}
"""A wall that motions of the example do not overturn."""


def pytest_addoption(parser):
    parser.addoption("--shuffle", type=int, help="seed of a random order of the tests")
    parser.addoption("--budgets", action="store_true", help="seconds of each folder against its budget")


gc.disable()  # all that is collected stays: to look through it again and again is a third of the collection


def pytest_collection_finish():
    gc.freeze()  # nor does a look for what a window left go through all tests and modules
    gc.enable()


def pytest_collection_modifyitems(config, items):
    """With --shuffle the files in random order, and the tests of each: none may need another before it."""
    if (seed := config.getoption("--shuffle")) is None:
        return
    order = random.Random(seed)
    place = {path: order.random() for path in sorted({item.path for item in items})}
    items.sort(key=lambda item: (place[item.path], order.random()))


def pytest_terminal_summary(terminalreporter, config):
    """With --budgets (`run.py test --durations`) what each folder took; with xdist in the process that gathers."""
    if config.getoption("--budgets"):
        from tests.budgets import printed

        terminalreporter.section("seconds of each folder")
        for line in printed(terminalreporter.stats):
            terminalreporter.write_line(line)


def shelf_folder() -> Path | None:
    """Folder of real records: RIBALTA_RECORDS, else shared/records beside the project."""
    named = os.environ.get("RIBALTA_RECORDS")
    folder = Path(named) if named else ROOT.parent / "shared" / "records"
    return folder if (folder / "INDEX.csv").exists() else None


COARSE = 8
"""Every how many points of its grid zeta of histories is searched in the tests."""


@pytest.fixture(scope="session", autouse=True)
def light_histories():
    """Where no records are given two motions are generated, not fourteen, zeta of histories is searched at every
    COARSE-th point of its grid, and no measures are sought for a wall that fails: what that does to a verdict is the
    same. Searches asked for directly are as they are."""
    from core.case.schema import Generate
    from core.setting import demand_input
    from core.variation import evaluate, measures

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(demand_input, "DEFAULT_SET", Generate(count=2))
        patch.setattr(evaluate, "FINEST", COARSE)
        patch.setattr(measures, "MOST", 0)
        yield


@pytest.fixture
def fine():
    """For tests of numbers that are printed: zeta of histories on all points of its grid."""
    with whole_grid():
        yield


@contextlib.contextmanager
def whole_grid():
    from core.variation import evaluate

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(evaluate, "FINEST", 1)
        yield


@pytest.fixture(scope="session")
def kept(tmp_path_factory):
    """kept(name, make): what `make()` gives, made once for all tests that ask for this name, whichever process of
    pytest-xdist they run in: it is kept in their common folder. None may change it."""
    place, known = tmp_path_factory.getbasetemp(), {}
    folder = place.parent if "PYTEST_XDIST_WORKER" in os.environ else place

    def result(name: str, make):
        file = folder / f"{name}.kept"
        if name not in known and file.exists():
            known[name] = pickle.loads(file.read_bytes())
        elif name not in known:
            known[name] = make()
            whole = folder / f"{name}.{os.getpid()}"
            whole.write_bytes(pickle.dumps(known[name]))
            whole.replace(file)
        return known[name]

    return result


@pytest.fixture(scope="session")
def shipped(kept):
    """shipped(name): the result of a shipped case, as it is."""
    from core.case.reader import read_case
    from core.study.run import run

    path = ROOT / "resources" / "cases"

    def made(name: str):
        with whole_grid():
            return run(read_case(path / f"{name}.toml"), base_dir=path, jobs=2)

    return lambda name: kept(name, lambda: made(name))


SEVEN = ROOT / "tests" / "cases" / "verdict.toml"
"""The shipped case with half of its motions."""


@pytest.fixture(scope="session")
def of_seven(kept):
    """The result of SEVEN."""
    from core.case.reader import read_case
    from core.study.run import run

    return kept("verdict_of_seven", lambda: run(read_case(SEVEN), base_dir=SEVEN.parent, jobs=2))


@pytest.fixture(scope="session")
def shelf() -> Path:
    folder = shelf_folder()
    if folder is None:
        pytest.skip("no shelf of real records (RIBALTA_RECORDS or ../shared/records)")
    return folder


@pytest.fixture(scope="session")
def index(shelf) -> dict[str, dict[str, str]]:
    with open(shelf / "INDEX.csv", encoding="utf-8") as stream:
        return {row["file"]: row for row in csv.DictReader(stream)}


@pytest.fixture(scope="session")
def reference():
    """name -> (ground [m/s2], rotation / alpha, impact times [s], velocities before impact)."""

    def load(name: str):
        folder = ROOT / "resources" / "reference"
        record = np.loadtxt(folder / f"{name}_record.csv", delimiter=",", skiprows=1)
        impacts = np.loadtxt(folder / f"{name}_impacts.csv", delimiter=",", skiprows=1)
        return np.ascontiguousarray(record[:, 1]), record[:, 2], impacts[:, 0], impacts[:, 1]

    return load


@pytest.fixture(scope="session")
def make_model():
    """A RockingModel from degrees, metres and names."""
    from core.wall.block import Block
    from core.wall.moment_rotation import LAWS
    from core.wall.restitution import restitution
    from core.wall.rocking_model import rocking_model

    def make(alpha_deg=6.8, height=7.0, one_sided=False, model=None, ratio=None, law="rigid"):
        block = Block.rectangle(height, math.radians(alpha_deg))
        if ratio is not None:
            model = "user"
        model = model or ("one_sided_theoretical" if one_sided else "housner")
        return rocking_model(block, one_sided, restitution(block, model, ratio), LAWS[law])

    return make


@pytest.fixture(autouse=bool(os.environ.get("RIBALTA_AS_WINDOWS")))
def as_windows():
    """tests/windows.py, where the run asks for it; what of the program asked which system it is comes to a file."""
    from tests import windows

    with pytest.MonkeyPatch.context() as patch:
        windows.stand_in(patch, ROOT)
        yield
    with open(os.environ["RIBALTA_AS_WINDOWS"], "a", encoding="utf-8") as stream:
        stream.writelines(f"{file}\n" for file in windows.REACHED)
