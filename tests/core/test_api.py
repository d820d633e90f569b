"""Every wrong argument of a public function is an InputError in one line, whatever it is."""

import random

import numpy as np
import pytest

import core.api as api

WALL = {"name": "w", "height_m": 5.0, "thickness_m": 0.5}
KEYS = "name", "height_m", "thickness_m", "mechanism", "hold", "load", "evidence"


@pytest.fixture(scope="module")
def hostile():
    """(calls by name, each taking a list of arguments; what they are given)."""
    wall, ground = api.wall(**WALL, mechanism="one_sided"), api.motion(np.sin(np.arange(400) / 20), 0.01)
    case = api.case({"wall": [WALL | {"mechanism": "two_sided", "base_z_m": 0.0}]})
    calls = {
        "wall": lambda a: api.wall(**dict(zip(KEYS, a, strict=False))),
        "read_case": lambda a: api.read_case(a[0]),
        "case": lambda a: api.case(a[0]),
        "case of parts": lambda a: api.case({"wall": [a[0]], "demand": a[1], "generate": a[2]}),
        "motion": lambda a: api.motion(a[0], a[1]),
        "motion, name": lambda a: api.motion(np.sin(np.arange(50)), a[0], a[1]),
        "read_record": lambda a: api.read_record(a[0], a[1]),
        "read_record, keys": lambda a: api.read_record("none", unit=a[0], column=a[1]),
        "spectrum": lambda a: api.spectrum(a[0], a[1], a[2]),
        "spectrum, periods": lambda a: api.spectrum(ground, a[0], a[1]),
        "history": lambda a: api.history(a[0], a[1], a[2]),
        "history, scale": lambda a: api.history(wall, ground, a[0], a[1]),
        "search": lambda a: api.search(wall, ground, a[0]),
        "eq15_16": lambda a: api.eq15_16(wall, ground, a[0]),
        "run": lambda a: api.run(a[0], a[1], a[2]),
        "run, folder": lambda a: api.run(case, a[0], a[1]),
        "verdicts": lambda a: api.verdicts(a[0]),
        "table": lambda a: api.table(a[0]),
        "save_parquet": lambda a: api.save_parquet(a[0], a[1]),
        "select": lambda a: api.select(a[0], a[1]),
        "study": lambda a: api.study(a[0]),
    }
    numbers = [None, True, 0, -1, float("inf"), float("nan"), 10**400, -(10**400), 1 + 2j, np.float32(4.1)]
    texts = ["", "x" * 5000, "\0", b"a", "a\nb"]
    arrays = [np.array(5.0), np.array([]), np.array(["a"]), np.ma.masked_array([1.0, 2.0], [0, 1]), [[1]], (), range(3)]
    others = [{}, {1: 2}, {"wall": None}, {"wall": [None]}, {"wall": [{}]}, object(), float, set(), iter([1])]
    return calls, [*numbers, *texts, *arrays, *others, wall, ground, case]


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("count", [400, pytest.param(4000, marks=pytest.mark.long)])
def test_that_every_wrong_argument_is_an_input_error_of_one_line(hostile, count, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)  # where nothing is
    calls, given = hostile
    draw, refused = random.Random(count), 0
    for _ in range(count):
        name, arguments = draw.choice(list(calls)), [draw.choice(given) for _ in KEYS]
        try:
            calls[name](arguments)
        except api.InputError as error:
            refused += 1
            assert "\n" not in str(error) and str(error), name
    assert refused > 0.9 * count


def test_that_an_array_of_one_number_is_that_number():
    assert api.wall(**(WALL | {"height_m": np.array(5.0)}), mechanism="one_sided").height_m == 5.0
