"""The records of a case."""

from dataclasses import replace

import numpy as np
import pytest

from core.errors import InputError
from core.setting.record_input import join_motions, read_records
from core.study import run as study
from tests.core.study.cases import case


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


@pytest.mark.parametrize("pattern", ["motion.txt", "mo*.txt"])
def test_that_a_record_is_named_as_the_case_gives_it_from_its_folder_or_absolutely(tmp_path, reference, pattern):
    """A report then says the same wherever its case is run again."""
    text = "\n".join(f"{value:.9e}" for value in reference("standard")[0][:400])
    (tmp_path / "motion.txt").write_text(text)
    for folder in (tmp_path, tmp_path / "elsewhere"):
        folder.mkdir(exist_ok=True)
        up = "" if folder == tmp_path else "../"
        for given, named in ((f"{up}{pattern}", f"{up}motion.txt"), (f"{tmp_path.as_posix()}/{pattern}", None)):
            entries = [{"file": given, "unit": "m/s2", "time_step_s": 0.01}]
            ((motion,), _) = read_records(case(record=entries), folder)
            assert motion.file == (named or f"{tmp_path.as_posix()}/motion.txt")


@pytest.mark.shows("records.twice")
def test_that_the_same_samples_under_two_names_are_refused(tmp_path, reference):
    text = "\n".join(f"{value:.9e}" for value in reference("standard")[0][:400])
    for name in ("a.txt", "b.txt"):
        (tmp_path / name).write_text(text)
    entries = [{"file": "*.txt", "unit": "m/s2", "time_step_s": 0.01}]
    with pytest.raises(InputError, match=r"record 1: b\.txt is in the case twice.*a\.txt"):
        read_records(case(record=entries), tmp_path)


def test_that_a_record_that_is_a_generated_motion_is_refused_and_others_stand_beside_it(tmp_path, reference):
    """Of one name both are called by their files."""
    text = "\n".join(f"{value:.9e}" for value in reference("standard")[0][:400])
    (tmp_path / "a.txt").write_text(text)
    ((record,), _) = read_records(case(record=[{"file": "a.txt", "unit": "m/s2", "time_step_s": 0.01}]), tmp_path)
    made = replace(record, file="generated, seed 1", acceleration=2.0 * record.acceleration)
    assert [motion.name for motion in join_motions([record], [made])] == ["a.txt", "generated, seed 1"]
    with pytest.raises(InputError) as refused:
        join_motions([record], [made, replace(record, file="generated, seed 2")])
    assert (refused.value.code, refused.value.values) == (
        "record_twice",
        {"file": "a.txt", "twin": "generated, seed 2"},
    )


@pytest.mark.shows("records.twice")
def test_that_a_record_twice_in_a_case_is_refused(folder):
    twice = [{"file": "r0.txt", "unit": "m/s2", "time_step_s": 0.01}] * 2
    with pytest.raises(InputError, match="twice"):
        study.run(case(record=twice), base_dir=folder)
