"""A case as a Python script gives the numbers of the program."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from core.case.rules import parse_case
from core.case.solids import Drawing
from core.errors import InputError
from core.study.case_script import case_script
from core.study.run import run
from tests.conftest import ROOT

WALL = {"name": 'the "north" wall', "mechanism": "both", "height_m": 4.0, "thickness_m": 0.4, "base_z_m": 0.0}
TABLE = {
    "title": 'Palazzo "Rossi", C:\\walls',
    "wall": [WALL],
    "demand": {"ag_g": 0.15, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
    "record": [{"file": "motion.txt"}],
    "analysis": {"q_step": 0.05},
}


@pytest.mark.shows("batch.script")
@pytest.mark.parametrize("title", [TABLE["title"], 'three """ marks', "plain"])
def test_that_the_script_prints_the_numbers_of_the_program(title, tmp_path, fine):
    time = 0.01 * np.arange(800)
    ground = 0.2 * np.sin(2.0 * np.pi * time / 0.7) * np.exp(-0.3 * time)
    lines = "\n".join(f"{t:.2f} {a:.6f}" for t, a in zip(time, ground, strict=True))
    (tmp_path / "motion.txt").write_text(f"time [s]  acceleration [g]\n{lines}\n")
    case = parse_case(TABLE | {"title": title})
    result = run(case, base_dir=tmp_path)
    path = tmp_path / "case.py"
    path.write_text(case_script(case, tmp_path), encoding="utf-8")
    done = subprocess.run([sys.executable, path], capture_output=True, text=True, cwd=ROOT, env=of_sources())
    assert done.returncode == 0, done.stderr
    (verdict,) = result.verdicts
    lines = done.stdout.splitlines()
    deciding = result.walls[verdict.governing].required_assessment.verdict
    assert lines[0] == f"{WALL['name']} {deciding.code} zeta {deciding.zeta_e}"
    rows = [f"{w.name} {w.mechanism} q {w.q_set} zeta {w.required_assessment.verdict.zeta_e}" for w in result.walls]
    assert lines[1:] == rows and len(rows) == 2


def of_sources() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT)}


def test_that_a_wall_of_a_drawing_is_read_from_its_file():
    case = parse_case({"wall": [WALL]})
    drawn = replace(case, wall=(replace(case.wall[0], drawing=(Drawing("a.dxf", ("wall",), "elevation", 0.4),)),))
    with pytest.raises(InputError) as refused:
        case_script(drawn, Path())
    assert refused.value.code == "script_of_drawing" and "read_case" in str(refused.value)
