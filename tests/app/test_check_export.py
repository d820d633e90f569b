"""`--export-check`: scripts beside the case, run by their own, and what is refused."""

import subprocess
import sys

import pytest

from app.__main__ import main
from core.file_names import file_name
from tests.conftest import ROOT

CASE = """
title = "Checked"
[[wall]]
name = "parete à/1"
height_m = 5.0
thickness_m = 0.5
mechanism = "one_sided"
base_z_m = 0.0
[[wall]]
name = "Parete à 1"
height_m = 3.0
thickness_m = 0.4
mechanism = "one_sided"
base_z_m = 0.0
[[record]]
file = "motion.txt"
[demand]
ag_g = 0.2
spectrum = { code = "EN1998", type = 1, soil = "B" }
"""
HELD = """[[wall]]
name = "held"
mechanism = "vertical_bending"
hold = [{ kind = "contact" }]
height_m = 3.0
thickness_m = 0.3
unit_weight_kn_m3 = 18.0
base_z_m = 0.0
"""


@pytest.fixture
def case(tmp_path):
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_text().splitlines()
    (tmp_path / "motion.txt").write_text("\n".join([*motion[:402], ""]))
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    return tmp_path / "case.toml"


def ran(script):
    return subprocess.run([sys.executable, script], capture_output=True, text=True, encoding="utf-8")


@pytest.mark.shows("batch.export_check")
def test_that_each_wall_is_a_script_that_runs_by_itself_and_finds_an_altered_rotation(case, tmp_path, capsys):
    names = ["check_parete_à_1_one_sided.py", "check_Parete_à_1_one_sided_2.py"]
    for _ in range(2):  # its own scripts are replaced
        assert main(["--export-check", str(case), "--output", str(tmp_path / "out")]) == 0
        assert capsys.readouterr().out.split() == [str(tmp_path / "out" / name) for name in names]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == sorted(names)
    script = tmp_path / "out" / names[1]
    found = ran(script)
    assert found.returncode == 0 and "all numbers as Ribalta says" in found.stdout, found
    assert "Parete à 1" in found.stdout and "This is no verification" in found.stdout
    script.write_text(script.read_text(encoding="utf-8").replace("'rotation': (0", "'rotation': (1"), encoding="utf-8")
    found = ran(script)
    assert found.returncode == 1 and found.stdout.count("DIFFERS") == 1


@pytest.mark.shows("batch.export_check")
def test_that_a_wall_without_a_check_is_named_and_the_others_are_written(case, tmp_path, capsys):
    case.write_text(CASE.replace("[[record]]", HELD + "[[record]]"), encoding="utf-8")
    assert main(["--export-check", str(case)]) == 3
    said = capsys.readouterr()
    assert len(said.out.split()) == 2 and said.err.startswith("held: no check is written: it is held at its top")


def test_that_no_file_but_a_script_of_its_own_is_replaced(case, tmp_path, capsys):
    mine = tmp_path / "check_parete_à_1_one_sided.py"
    mine.write_text("print('mine')")
    assert main(["--export-check", str(case)]) == 1
    assert mine.name in capsys.readouterr().err and mine.read_text() == "print('mine')"
    assert not list(tmp_path.glob("check_Parete*"))
    assert main(["--export-check", str(tmp_path / "none.toml")]) == 1
    with pytest.raises(SystemExit) as ended:
        main(["--export-check", str(case), "--batch", str(case)])
    assert ended.value.code == 2


@pytest.mark.parametrize(
    "name, expected",
    [
        ("a/../b: c*", "a_b_c"),
        ("e\u0301", "é"),
        ("con\u202egpj.", "con_gpj"),
        ("\udcff?", "_"),
        ("x" * 300, "x" * 120),
        ("\U00020000" * 60, "\U00020000" * 30),
    ],
)
def test_that_a_name_of_a_wall_becomes_a_name_that_every_system_takes(name, expected):
    assert file_name(name) == expected
