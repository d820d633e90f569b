"""National annexes of EN 1998-1: each file is a code, and Spain's numbers are those of its tables."""

import math
import re
import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes.spectrum_codes import CODES, FOLDER, NATIONAL, codes_of
from core.errors import InputError
from core.setting.demand_input import demand_of
from core.study.run import run
from core.units import G
from tests.clauses_alone import parse_case as clauses_alone
from tests.conftest import ROOT

WALL = {"name": "w", "mechanism": "two_sided", "height_m": 3.0, "thickness_m": 0.4, "base_z_m": 0.0}
SPAIN = {"code": "EN1998-ES", "soil": "C", "vs30_m_s": 300.0, "contribution_k": 1.1}


def demand_with(**changes):
    spectrum = {key: value for key, value in {**SPAIN, **changes}.items() if value is not None}
    case = parse_case({"wall": [WALL], "demand": {"ag_g": 0.23, "spectrum": spectrum}})
    return demand_of(case, Path())


def test_that_each_file_is_a_code_and_names_its_source():
    assert {path.stem for path in FOLDER.glob("*.toml")} == set(CODES) - {NATIONAL}
    for path in FOLDER.glob("*.toml"):
        given = tomllib.loads(path.read_text(encoding="utf-8"))
        assert given["source"] and "EN 1998-1" in given["name"]


@pytest.mark.shows("demand.annex")
def test_that_a_file_more_is_a_code_more(tmp_path):
    """An annex that keeps the form of EN 1998-1 with its own numbers."""
    shutil.copytree(FOLDER, tmp_path, dirs_exist_ok=True)
    (tmp_path / "EN1998-XX.toml").write_text(
        'name = "AN/XX EN 1998-1"\nseen_in_print = false\nsource = "made"\namplification = 2.5\n'
        "[type.1]\nA = { s = 1.0, t_b = 0.1, t_c = 0.6, t_d = 2.0 }\n"
    )
    made = codes_of(tmp_path)
    assert set(made) == {*CODES, "EN1998-XX"} and not made["EN1998-XX"].seen_in_print
    target = made["EN1998-XX"].make(2.0, "A", 1)
    assert target.name == "AN/XX EN 1998-1 type 1, A" and target.acceleration([1.2])[0] == pytest.approx(2.5)
    for soil, kind in (("B", 1), ("A", 2)):
        with pytest.raises(InputError) as refused:
            made["EN1998-XX"].make(2.0, soil, kind)
        assert refused.value.code == "annex_ground"


TABLE = """name = "AN"
source = "made"
seen_in_print = true
amplification = 2.5
[type.1]
A = { s = 1.0, t_b = 0.1, t_c = 0.4, t_d = 2.0 }
"""


@pytest.mark.parametrize(
    ("name", "written", "instead"),
    [
        ("EN1998-X", "true", '"false"'),  # would be true
        ("EN1998-X", 'name = "AN"\n', ""),
        ("EN1998-X", "t_b = 0.1", "t_b = 0.5"),
        ("EN1998-X", "s = 1.0", "s = 12.0"),
        ("EN1998-X", "[type.1]", "[typ.1]"),
        ("EN1998-X", "name", "name name"),
        (NATIONAL, "", ""),
    ],
)
def test_that_a_file_that_is_no_annex_stops_the_program(tmp_path, name, written, instead):
    """No wall is verified by what a file does not plainly say."""
    (tmp_path / "EN1998-Y.toml").write_text(TABLE)
    assert codes_of(tmp_path)["EN1998-Y"].seen_in_print is True
    (tmp_path / f"{name}.toml").write_text(TABLE.replace(written, instead, 1))
    with pytest.raises(RuntimeError, match=f"{name}.toml cannot be used"):
        codes_of(tmp_path)


def test_that_no_other_module_names_a_code():
    """A country comes in by the table; what asks for one by its name would pass another by."""
    apart = ("core/solved/", "core/codes/spectrum_codes.py", "app/shell/study_form.py")
    for path in sorted([*(ROOT / "core").rglob("*.py"), *(ROOT / "app").rglob("*.py")]):
        if not path.relative_to(ROOT).as_posix().startswith(apart):
            assert not re.search(r'"(NTC2018|EN1998[\w-]*)"', path.read_text(encoding="utf-8")), path


@pytest.mark.shows("demand.annex")
@pytest.mark.parametrize("k", [1.0, 1.3])
@pytest.mark.parametrize("ag", [0.05, 0.1, 0.25, 0.4, 0.5])
@pytest.mark.parametrize(("soil", "vs30"), [("A", 900.0), ("B", 575.0), ("C", 300.0), ("C", 180.0), ("D", 150.0)])
def test_that_spain_is_by_table_an_2(soil, vs30, ag, k):
    """S, T_B, T_C, T_D written out here a second time, as the table has them."""
    c = (800.0 / vs30) ** 0.465
    weak, t_c = {"A": (1.0, k / 4.0), "B": (c, k * c / 4.0), "C": (c, k * c / 4.0), "D": (2.0, k / 2.0)}[soil]
    if soil == "D":
        between = 2.33 - 3.33 * ag
    else:
        between = weak + 3.33 * (ag - 0.1) * (1.0 - weak)
    s = weak if ag <= 0.1 else between if ag <= 0.4 else 1.0
    made = CODES["EN1998-ES"].make(ag * G, soil, vs30, k)
    assert made.soil == pytest.approx(s, abs=0.0035)  # of D the print rounds 2.333 to 2.33
    assert soil == "D" or made.soil == pytest.approx(s, rel=1e-12)
    assert (made.t_b, made.t_c, made.t_d) == pytest.approx((t_c / 5.0, t_c, 2.0), rel=1e-12)
    plateau = made.acceleration([t_c])[0]
    assert plateau == pytest.approx(2.5 * ag * G * made.soil, rel=1e-12)
    assert made.acceleration([4.0])[0] == pytest.approx(plateau * t_c * 2.0 / 16.0, rel=1e-12)


@pytest.mark.shows("demand.annex")
def test_that_grounds_meet_where_their_velocities_do():
    for one, other, vs30 in (("A", "B", 800.0), ("B", "C", 360.0), ("C", "D", 180.0)):
        first, second = (CODES["EN1998-ES"].make(0.2 * G, soil, vs30, 1.0) for soil in (one, other))
        periods = np.linspace(0.02, 4.0, 200)
        assert np.allclose(first.acceleration(periods), second.acceleration(periods), rtol=2e-3)


def test_that_a_case_takes_it_from_file_to_verdict():
    demand = demand_with()
    c = (800.0 / 300.0) ** 0.465
    assert demand.target.t_c == pytest.approx(1.1 * c / 4.0) and demand.soil_factor == demand.target.soil
    result = run(clauses_alone({"wall": [WALL], "demand": {"ag_g": 0.23, "spectrum": SPAIN}}), base_dir=Path())
    assert math.isfinite(result.verdicts[0].zeta_least)
    assert demand.target.name == "AN/UNE-EN 1998-1, C, v_s,30 300 m/s, K 1.1"
    assert any(one.code == "annex_unseen" for one in result.walls[0].assessed.verdict.limits)


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"vs30_m_s": 500.0}, "annex_velocity"),
        ({"soil": "E"}, "annex_ground"),
        ({"vs30_m_s": None}, "code_needs"),
        ({"type": 1}, "code_does_not_take"),
        ({"code": "EN1998", "type": 1}, "code_does_not_take"),
    ],
)
def test_that_what_the_annex_has_not_is_refused(changes, code):
    with pytest.raises(InputError) as refused:
        demand_with(**changes)
    assert refused.value.code == code
