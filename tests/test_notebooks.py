"""The notebooks run, and the names of the package are those its page lists."""

import inspect
import json
import re
import warnings

import numpy as np
import pytest

import core.api
from tests.conftest import ROOT

NOTEBOOKS = sorted((ROOT / "resources" / "notebooks").glob("*.ipynb"))


@pytest.mark.shows("batch.script")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_that_a_notebook_runs(path, capsys, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    book, names = json.loads(path.read_text(encoding="utf-8")), {}
    assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in book["cells"]}) == len(book["cells"])
    for cell in book["cells"]:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec(compile("".join(cell["source"]), path.name, "exec"), names)
    drawn = [line for axes in names["figure"].axes for line in axes.get_lines()]
    assert drawn and all(len(line.get_xdata()) for line in drawn)
    names["plt"].close("all")


def test_that_every_name_has_its_types_units_and_a_row_in_the_page():
    page = (ROOT / "resources" / "docs" / "python.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"`(\w+)(?:\(|`)", page[: page.index("## ")]))
    names = set(core.api.__all__) - {"GroundMotion", "History"}
    assert names <= listed
    for name in core.api.__all__:
        of = getattr(core.api, name)
        assert inspect.getdoc(of)
        if inspect.isfunction(of):
            signature = inspect.signature(of)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in signature.parameters.values():
                assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)


def sine(scale=2.0):
    time = np.arange(0.0, 4.0, 0.005)
    return core.api.motion(np.where(time < 0.8, scale * np.sin(2.0 * np.pi * time / 0.8), 0.0), 0.005)


THICK = {"thickness_m": np.float64(0.4), "base_z_m": np.int64(0)}
PLAIN = {"mechanism": "two_sided", "height_m": 3.0, "thickness_m": 0.3}
CORNER = {"length_1_m": 2.4, "length_2_m": 2.4, "thickness_2_m": 0.6}
PUSHED = {"mechanism": "one_sided", "height_m": 6.0, "thickness_m": 0.6, "length_m": 3.39, "unit_weight_kn_m3": 18.0}
LOAD = {"kind": "thrust", "kn_m": 200.0, "h_m": 2.0}
BEHIND = {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "contact"}]}


@pytest.mark.parametrize(
    "asked",
    [
        lambda api: api.history(api.wall(**PLAIN), sine(), scale=float("nan")),
        lambda api: api.history(api.wall(**PLAIN), sine(), scale=1e7),
        lambda api: api.wall(mechanism="one_sided"),
        lambda api: api.wall(**PLAIN, drawing=[{"file": "x.dxf", "layers": "a", "plane": "section", "to_m": 1.0}]),
        lambda api: api.wall(**PLAIN | {"mechanism": "one_sided", **BEHIND, "load": [LOAD]}),
        lambda api: api.case({"walls": "walls.xlsx"}),
        lambda api: api.eq15_16(api.wall(**PLAIN, base_z_m=6.0), sine()),
        lambda api: api.spectrum(sine(), [0.0, 0.5]),
        lambda api: api.spectrum(sine(), [0.5], damping=1.5),
        lambda api: api.search(api.wall(**PLAIN), sine(), q_step=0.0),
        lambda api: api.motion(np.ones((100, 2)), 0.005),
        lambda api: api.motion(["a"] * 20, 0.005),
        lambda api: api.motion(np.exp(1j * np.arange(50)), 0.005),
        lambda api: api.motion(np.ones(50), "0.005"),
        lambda api: api.motion(np.ones(50), None),
        lambda api: api.spectrum(sine(), "abc"),
        lambda api: api.spectrum(sine(), [0.5], damping="5"),
        lambda api: api.spectrum(sine(), [0.5], damping=None),
        lambda api: api.spectrum(np.ones(50), [0.5]),
        lambda api: api.history(api.wall(**PLAIN), sine(), "1"),
        lambda api: api.history(sine(), api.wall(**PLAIN)),
        lambda api: api.history(api.wall(**PLAIN, base_z_m=6.0), sine()),
        lambda api: api.search(api.wall(**PLAIN, base_z_m=6.0), sine()),
        lambda api: api.search(api.wall(**PLAIN), sine(), q_step="a"),
        lambda api: api.eq15_16(PLAIN, sine()),
        lambda api: api.read_record(None),
        lambda api: api.read_record("a.txt", "2"),
        lambda api: api.read_record("a.txt", unit="furlong"),
        lambda api: api.read_record("a.txt", no_key=1),
        lambda api: api.read_case(None),
        lambda api: api.case([]),
        lambda api: api.case(None),
        lambda api: api.run(None),
        lambda api: api.run({}),
        lambda api: api.run(api.case({"wall": [{"name": "w", **PLAIN}]}), jobs="2"),
        lambda api: api.select({}),
        lambda api: api.search(api.wall(**PLAIN), sine(), reverse="no"),
        lambda api: api.search(api.wall(**PLAIN), sine(), reverse=np.array([0, 1])),
        lambda api: api.read_case("a\0b"),
        lambda api: api.read_record("a.txt", include=False),
        lambda api: api.motion(np.ma.masked_array(np.ones(50), np.arange(50) < 3), 0.005),
        lambda api: api.motion(np.ones(50), 0.005, name=None),
        lambda api: api.history(api.wall(**PLAIN), sine(), scale=True),
        lambda api: api.run(api.case({"wall": [{"name": "w", **PLAIN}]}), jobs=True),
        lambda api: api.study(None),
    ],
)
def test_that_what_cannot_be_is_one_sentence_and_no_number(asked):
    with pytest.raises(core.api.InputError) as refused:
        asked(core.api)
    assert str(refused.value) and "\n" not in str(refused.value)


def test_that_numbers_of_numpy_are_numbers_and_one_period_is_a_row():
    wall = core.api.wall(mechanism="two_sided", height_m=np.int64(3), thickness_m=np.float32(0.5))
    assert wall.height_m == 3.0 and wall.thickness_m == 0.5
    assert core.api.spectrum(sine(), 0.3).shape == (1,)


def test_that_a_one_sided_wall_has_the_lower_q_of_both_signs_as_in_the_program():
    """The notebook printed 6.59 for a motion of which the program says 5.16."""
    wall = core.api.wall(mechanism="one_sided", height_m=4.0, thickness_m=0.4, base_z_m=0.0)
    one, other = (core.api.search(wall, sine(), reverse=reverse).q for reverse in (False, True))
    assert one != other and core.api.search(wall, sine()).q == min(one, other)
    keys = {"wall": [{"name": "w", "mechanism": "one_sided", "height_m": 4.0, "thickness_m": 0.4, "base_z_m": 0.0}]}
    keys |= {"demand": {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}}}
    result = core.api.run(core.api.case(keys | {"generate": {"count": 3}}))
    names = ("q", "q_slv", "q_robust", "q_slv_low", "q_slv_robust")
    for ground, entry in zip(result.motions, result.walls[0].per_record, strict=True):
        found = core.api.search(wall, ground)
        assert [getattr(found, name) for name in names] == [getattr(entry, name) for name in names]


def test_that_the_equations_of_the_paper_warn_outside_their_ranges():
    inside = core.api.wall(mechanism="two_sided", height_m=7.0, slenderness_deg=6.8)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        core.api.eq15_16(inside, sine(2.0))
    for keys in ({"velocity_ratio": 0.95}, {"law": "doherty"}, {"height_m": 20.0}, {"slenderness_deg": 30.0}):
        wall = core.api.wall(**{"mechanism": "two_sided", "height_m": 7.0, "slenderness_deg": 6.8} | keys)
        with pytest.warns(UserWarning, match="Eq. 15|fitted|range"):
            core.api.eq15_16(wall, sine(2.0))


def test_that_what_a_file_does_not_say_may_be_said(tmp_path):
    file = tmp_path / "bare.txt"
    file.write_text("\n".join(f"{0.1 * np.sin(0.3 * k):.5f}" for k in range(400)))
    with pytest.raises(core.api.InputError):
        core.api.read_record(file)
    found = core.api.read_record(file, unit="g", time_step_s=0.01)
    assert found.time_step == 0.01 and found.pga == pytest.approx(0.1 * 9.80665, rel=1e-3)
    keys = {"name": "w", "mechanism": "two_sided", "height_m": np.float32(4.1)} | THICK
    assert core.api.case({"wall": [keys]}).wall[0].height_m == 4.1


def test_that_a_corner_is_pushed_in_histories_and_searches_too():
    quiet, pushed = (
        core.api.wall(**PUSHED, corner=CORNER | {"thrust_1_kn_m": thrust, "thrust_2_kn_m": thrust})
        for thrust in (0.0, 0.3)
    )
    found = [core.api.history(wall, sine(6.0)).peak for wall in (quiet, pushed)]
    assert found[0] != found[1]
