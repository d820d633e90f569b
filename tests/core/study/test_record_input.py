"""The records of a case."""

import numpy as np
import pytest

from core.case.rules import parse_case
from core.errors import InputError
from core.study import run as study
from core.study.record_input import read_records


@pytest.fixture(scope="module")
def folder(tmp_path_factory, reference):
    """Three short records made from the reference motion."""
    place = tmp_path_factory.mktemp("records")
    ground = reference("standard")[0][:900]
    for k, factor in enumerate((0.9, 1.0, 1.1)):
        lines = [f"{value * factor:.9e}" for value in np.roll(ground, 30 * k)]
        (place / f"r{k}.txt").write_text("\n".join(lines))
    return place


def case(**more):
    table = {
        "wall": [
            {"name": "w", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "both"},
            {"name": "v", "height_m": 4.0, "slenderness_deg": 8.0, "base_z_m": 0.0, "mechanism": "two_sided",
             "law": "doherty"},
        ],
        "record": [{"file": "r*.txt", "unit": "m/s2", "time_step_s": 0.01}],
        "analysis": {"q_step": 0.02},
        "demand": {"ag_g": 0.2, "soil_factor": 1.2},
    }  # fmt: skip
    return parse_case({**table, **more})


def test_that_names_that_collide_become_paths(tmp_path, reference):
    """a.txt, a.txt.txt and s/a.txt: stems and paths must not be taken for each other."""
    ground = reference("standard")[0][:400]
    (tmp_path / "s").mkdir()
    for k, name in enumerate(("a.txt", "a.txt.txt", "s/a.txt")):
        text = "\n".join(f"{value:.9e}" for value in np.roll(ground, 9 * k))
        (tmp_path / name).write_text(text)
    entries = [{"file": n, "unit": "m/s2", "time_step_s": 0.01} for n in ("a*.txt", "s/a.txt")]
    motions, _ = read_records(case(record=entries), tmp_path)
    assert [motion.name for motion in motions] == ["a.txt", "a.txt.txt", "s/a.txt"]


def test_that_the_same_samples_under_two_names_are_refused(tmp_path, reference):
    text = "\n".join(f"{value:.9e}" for value in reference("standard")[0][:400])
    for name in ("a.txt", "b.txt"):
        (tmp_path / name).write_text(text)
    entries = [{"file": "*.txt", "unit": "m/s2", "time_step_s": 0.01}]
    with pytest.raises(InputError, match=r"record 1: b\.txt is in the case twice.*a\.txt"):
        read_records(case(record=entries), tmp_path)


def test_that_a_record_twice_in_a_case_is_refused(folder):
    twice = [{"file": "r0.txt", "unit": "m/s2", "time_step_s": 0.01}] * 2
    with pytest.raises(InputError, match="twice"):
        study.run(case(record=twice), base_dir=folder)
