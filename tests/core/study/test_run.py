"""study.run: set rules, polarity, threads, journal, demand."""

import json
from dataclasses import asdict

import numpy as np
import pytest

from core.capacity.ida import Ida
from core.errors import Cancelled
from core.report import json_report
from core.study import run as study
from core.study.governing import collapse_histories
from core.study.journal import Journal
from core.units import CM, G
from tests.core.study.cases import case


def numbers(result) -> str:
    """The JSON without what names the moment of the run."""
    content = json_report.results(result)
    del content["started_utc"]
    return json.dumps(content)


def test_that_threads_and_their_number_change_no_digit(folder, result):
    for jobs in (2, 5):
        assert numbers(study.run(case(), base_dir=folder, jobs=jobs)) == numbers(result)


def test_that_a_wall_with_both_mechanisms_gives_two_entries(result):
    assert [(wall.name, wall.mechanism) for wall in result.walls] == [
        ("w", "two_sided"), ("w", "one_sided"), ("v", "two_sided"),
    ]  # fmt: skip
    assert [run.polarity for run in result.walls[1].runs] == [1, -1] * 3
    assert [run.polarity for run in result.walls[0].runs] == [1] * 3


def test_that_q_is_c_pga_over_a_rm(result):
    for wall in result.walls:
        for run in wall.runs:
            motion = next(m for m in result.motions if m.name == run.record)
            q = run.scale * motion.pga / wall.block.threshold_acceleration
            assert run.ida.q == pytest.approx(q, rel=1e-14)
            assert run.q_eff == pytest.approx(run.ida.q * G / motion.pga, rel=1e-14)


def test_that_an_impact_limit_makes_the_set_incomplete(folder, monkeypatch):
    real = study.incremental_dynamic_analysis
    calls = []

    def limited(*arguments, **keywords):
        found = real(*arguments, **keywords)
        calls.append(1)
        if len(calls) == 2:
            return Ida(**{**asdict(found), "status": "impact_limit", "q": None, "bracket": None})
        return found

    monkeypatch.setattr(study, "incremental_dynamic_analysis", limited)
    wall = study.run(case(), base_dir=folder).walls[0]
    assert wall.set_rule == "incomplete"
    assert wall.q_set is None and wall.q_robust_set is None
    assert wall.code_check[2] is None
    assert wall.code_check[0] is not None


def test_that_the_intensity_of_the_demand_is_given_or_from_the_records(folder, result):
    demand = result.demand
    assert demand.intensity_source == "records_scaled"
    scaled = [m.housner_intensity * demand.pga / m.pga for m in result.motions]
    assert demand.intensity == pytest.approx(np.mean(scaled), rel=1e-14)
    assert any(notice.code == "si_from_records" for notice in result.walls[0].warnings)
    given = study.run(case(demand={"ag_g": 0.2, "housner_intensity_cm": 80.0}), base_dir=folder)
    assert given.demand.intensity == 80.0 * CM
    assert given.demand.intensity_source == "given"


def test_that_a_case_without_records_gives_closed_forms_and_code_only(folder):
    found = study.run(
        case(record=[], demand={"ag_g": 0.2, "housner_intensity_cm": 80.0}), base_dir=folder
    )
    wall = found.walls[0]
    assert wall.runs == () and wall.set_rule is None and wall.q_set is None
    assert wall.closed_form_q == pytest.approx(wall.closed_form_q_eff * 0.2)
    assert [check is not None for check in wall.code_check] == [True, True, False, False, False]


def test_that_a_new_title_or_demand_keeps_the_finished_runs(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, False))
    first = []
    study.run(
        case(title="other", demand={"ag_g": 0.1}), base_dir=folder,
        journal=lambda key: Journal(path, key, True), on_progress=lambda d, p, stage: first.append((d, p, stage)),
    )  # fmt: skip
    stages = [(12, 12, "stage_runs"), *((n, 3, "stage_checks") for n in range(4))]
    assert first == stages  # three walls are assessed again


def test_that_each_stage_of_a_study_is_counted_by_itself_to_its_end(folder):
    said = []
    study.run(
        case(analysis={"q_step": 0.02, "accuracy": True}), base_dir=folder,
        on_progress=lambda *counted: said.append(counted),
    )  # fmt: skip
    for stage, planned in (("stage_runs", 12), ("stage_checks", 3), ("stage_accuracy", 3)):
        assert [count for *count, of in said if of == stage] == [
            [done, planned] for done in range(planned + 1)
        ]


def test_that_a_damaged_line_of_a_journal_is_run_again(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, False))
    lines = path.read_bytes().split(b"\n")
    lines[2] = lines[2].replace(b'"status"', b'"stat"')
    lines.insert(4, b"5")
    path.write_bytes(b"\n".join(lines))
    again = study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, True))
    assert numbers(again) == numbers(result)


def test_that_collapse_histories_stand_on_both_sides_of_collapse(result):
    for wall in result.walls:
        pair = collapse_histories(result, wall)
        assert [history.outcome for history in pair.histories] == [0, 1]
        assert pair.scales[0] != pair.scales[1]


def test_that_a_cancelled_run_keeps_its_journal_and_resumes_bit_identical(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    state = {"done": 0}

    def progress(done, planned, stage):
        state["done"] = done

    with pytest.raises(Cancelled):
        study.run(
            case(), base_dir=folder, journal=lambda key: Journal(path, key, False),
            on_progress=progress, cancelled=lambda: state["done"] >= 4,
        )  # fmt: skip
    lines = path.read_bytes().count(b"\n")
    assert lines >= 5
    # a line cut by a kill
    path.write_bytes(path.read_bytes() + b'{"run": "0/0/1", "resu')
    first = []

    def resumed(done, planned, stage):
        first.append(done)

    again = study.run(
        case(), base_dir=folder, journal=lambda key: Journal(path, key, True), on_progress=resumed
    )
    assert first[0] >= 4
    assert numbers(again) == numbers(result)


def test_that_a_start_without_resume_sets_finished_runs_aside(folder, tmp_path):
    path = tmp_path / "case.journal"
    study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, False))
    kept = path.read_bytes()
    study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, False))
    assert (tmp_path / "case.journal.old").read_bytes() == kept


def test_that_a_journal_of_another_case_is_not_used(folder, tmp_path):
    path = tmp_path / "case.journal"
    study.run(case(), base_dir=folder, journal=lambda key: Journal(path, key, False))
    first = []
    study.run(
        case(analysis={"q_step": 0.03}), base_dir=folder,
        journal=lambda key: Journal(path, key, True), on_progress=lambda d, p, stage: first.append(d),
    )  # fmt: skip
    assert first[0] == 0


def test_that_a_large_a_g_is_questioned(tmp_path):
    asked = case(record=[], demand={"ag_g": 0.61, "soil_factor": 1.2})
    assert study.run(asked, base_dir=tmp_path).demand.warnings[0].code == "large_ag"
