"""What is written well is read back as it was: records of every dialect, cases, tables, journals, autosaves."""

import tomllib

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.case.rules import parse_case, parse_draft
from core.case.wall_table import parse_wall_rows
from core.case.writer import dumps
from core.errors import InputError
from core.ground import records
from core.ground.records.grammar import Options
from core.study.journal import Journal

SLOWLY = settings(deadline=None, max_examples=25, suppress_health_check=list(HealthCheck))

samples = st.lists(st.integers(-99999, 99999), min_size=12, max_size=60).filter(lambda values: any(values))
steps = st.sampled_from([0.002, 0.005, 0.01, 0.02])
ends = st.sampled_from(["\n", "\r\n", "\r"])


def at2(values, dt, end, shape):
    rows = ["".join(shape(v) for v in values[k : k + 5]) for k in range(0, len(values), 5)]
    head = [
        "PEER STRONG MOTION DATABASE RECORD",
        "EVENT 01/01/80, STATION, 090",
        "ACCELERATION TIME HISTORY IN UNITS OF G",
        f"NPTS= {len(values)}, DT= {dt:.5f} SEC",
    ]
    return end.join([*head, *rows]) + end


def esm(values, dt, end, shape):
    head = [
        "EVENT_ID: X",
        "STATION_CODE: ABC",
        f"SAMPLING_INTERVAL_S: {dt}",
        f"NDATA: {len(values)}",
        "UNITS: cm/s^2",
        "DATA_TYPE: ACCELERATION",
    ]
    return end.join([*head, *(shape(v) for v in values)]) + end


def sigma(values, dt, end, shape):
    rows = ["".join(f"{v:14.7E}" for v in values[k : k + 5]) for k in range(0, len(values), 5)]
    head = [
        "Station Code / Name : 1 / X",
        f"Time Increment (s) : {dt}",
        f"Number of Data : {len(values)}",
        "Accelaration time series in m/s/s",
    ]
    return end.join([*head, *rows]) + end


def columns(values, dt, end, shape):
    return end.join(f"{k * dt:.4f} {shape(v).strip()}" for k, v in enumerate(values)) + end


DIALECTS = {"at2": (at2, 9.80665), "esm": (esm, 0.01), "sigma": (sigma, 1.0), "columns": (columns, 1.0)}
SHAPES = {"e": lambda v: f"{v:15.7E}", "f": lambda v: f"{v:12.5f}"}


@pytest.mark.parametrize("dialect", DIALECTS)
@SLOWLY
@given(numbers=samples, dt=steps, end=ends, shape=st.sampled_from(list(SHAPES)))
def test_that_a_record_of_each_dialect_is_the_motion_that_was_written(dialect, tmp_path, numbers, dt, end, shape):
    write, unit = DIALECTS[dialect]
    values = [number / 100_000 for number in numbers]
    path = tmp_path / "r.txt"
    path.write_bytes(write(values, dt, end, SHAPES[shape]).encode())
    options = Options("m/s2") if dialect == "columns" else Options()
    found = records.read(path, options)
    assert found.time_step == pytest.approx(dt, rel=1e-12)
    assert np.allclose(found.acceleration, np.array(values) * unit, rtol=1e-12, atol=1e-15)


TURNS = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"  # refused: they change the reading order
words = st.text(
    st.characters(exclude_categories=("Cc", "Cs", "Zl", "Zp"), exclude_characters=TURNS), min_size=1, max_size=40
)
wall = st.fixed_dictionaries(
    {
        "height_m": st.floats(1.0, 20.0),
        "thickness_m": st.floats(0.1, 0.9),
        "mechanism": st.sampled_from(["one_sided", "two_sided", "both"]),
        "base_z_m": st.floats(0.0, 30.0),
    },
    optional={
        "law": st.sampled_from(["rigid", "doherty", "al_shawa"]),
        "notes": words,
        "floor": words,
        "unloaded_confirmed": st.booleans(),
        "hold": words.map(lambda text: [{"kind": "contact", "name": text}]),
        "unit_weight_kn_m3": st.floats(5.0, 40.0),
        "elastic_modulus_mpa": st.floats(10.0, 1e5),
    },
)
demand = st.fixed_dictionaries(
    {"ag_g": st.floats(0.01, 1.0)},
    optional={
        "soil_factor": st.floats(0.9, 3.0),
        "confidence_on": st.sampled_from(["capacity", "demand"]),
        "site": words,
        "zeta_target": st.floats(0.1, 2.0),
        "period_range_s": st.just([0.15, 3.0]),
        "limit_state": st.sampled_from(["SLV", "SLC", "SLD"]),
    },
)


@SLOWLY
@given(walls=st.lists(wall, min_size=1, max_size=4), asked=demand, title=words)
def test_that_a_case_is_itself_after_it_was_saved(walls, asked, title):
    table = {"title": title, "demand": asked, "wall": [{"name": f"w{k}", **w} for k, w in enumerate(walls)]}
    first = parse_case(table)
    text = dumps(first)
    assert parse_case(tomllib.loads(text)) == first
    # a draft of it, as autosaved, and saved again over its own text, comments and all
    assert parse_draft(tomllib.loads(text)).wall == first.wall
    assert parse_case(tomllib.loads(dumps(first, f"# mine\n{text}"))) == first


@SLOWLY
@given(
    rows=st.lists(st.tuples(st.integers(100, 2000), st.integers(10, 99), st.booleans()), min_size=1, max_size=20),
    comma=st.booleans(),
    unit=st.sampled_from([("m", 0.01), ("cm", 1.0), ("mm", 10.0)]),
)
def test_that_a_table_of_walls_is_the_walls_that_were_written(rows, comma, unit):
    name, factor = unit
    cells = [["Parete", "z", "H", "t", "Meccanismo"], ["", "m", name, name, ""]]
    for k, (height, thickness, free) in enumerate(rows):
        numbers = [f"{height * factor:g}", f"{thickness * factor:g}"]
        numbers = [number.replace(".", ",") if comma else number for number in numbers]
        cells.append([f"w{k}", "0", *numbers, "su due lati" if free else "su un lato"])
    for (height, thickness, free), found in zip(rows, parse_wall_rows(cells, True), strict=True):
        assert found.height_m == pytest.approx(0.01 * height, rel=1e-12)
        assert found.thickness_m == pytest.approx(0.01 * thickness, rel=1e-12)
        assert found.mechanism == ("two_sided" if free else "one_sided")


results = st.dictionaries(st.text(max_size=8), st.one_of(st.none(), st.floats(allow_nan=False), words), max_size=5)


@SLOWLY
@given(runs=st.dictionaries(words, results, max_size=12), cut=st.integers(0, 400))
def test_that_a_journal_gives_back_what_was_whole_when_it_was_cut(tmp_path_factory, runs, cut):
    path = tmp_path_factory.mktemp("journal") / "c.journal"
    book = Journal(path, "key", False)
    for name, result in runs.items():
        book.add(name, result)
    book.close()
    content = path.read_bytes()
    path.write_bytes(content[: max(len(content) - cut, 0)])
    try:
        again = Journal(path, "key", True)
    except InputError:
        raise AssertionError("a cut journal is still ours") from None
    whole = content[: max(len(content) - cut, 0)].count(b"\n") - 1
    assert [(name, again.get(name)) for name in again.places] == list(runs.items())[: max(whole, 0)]
    again.close()
