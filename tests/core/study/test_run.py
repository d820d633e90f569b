"""study.run: set rules, polarity, threads, journal, demand."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from core.case.rules import parse_case
from core.codes import dynamic_check
from core.errors import Cancelled, InputError
from core.packages import PACKAGES
from core.report import json_report
from core.study import run as study
from core.study import wall_tasks
from core.study.governing import collapse_histories
from core.study.journal import Journal
from core.units import CM, G
from tests.conftest import ROOT
from tests.core.report import whole_workbook
from tests.core.study.cases import case
from tests.holds import sought


def run(asked, journal=None, **named):
    """`study.run`; journal : (file, whether an earlier start is gone on with), closed at the end as a batch does."""
    if journal is None:
        return study.run(asked, **named)
    books = []

    def made(key):
        books.append(Journal(journal[0], key, journal[1]))
        return books[0]

    try:
        return study.run(asked, journal=made, **named)
    finally:
        for book in books:
            book.close()


def numbers(result) -> str:
    """The JSON without what names the moment of the run."""
    content = json_report.results(result)
    del content["started_utc"]
    return json.dumps(content)


@pytest.mark.shows("batch.jobs")
def test_that_threads_and_their_number_change_no_digit(folder, result):
    for jobs in (2, 5):
        assert numbers(run(case(), base_dir=folder, jobs=jobs)) == numbers(result)


@pytest.mark.shows("dynamic.signs")
def test_that_a_wall_with_both_mechanisms_gives_two_entries(result):
    assert [(wall.name, wall.mechanism) for wall in result.walls] == [
        ("w", "two_sided"),
        ("w", "one_sided"),
        ("v", "two_sided"),
    ]
    assert [run.polarity for run in result.walls[1].runs] == [1, -1] * 3
    assert [run.polarity for run in result.walls[0].runs] == [1] * 3


@pytest.mark.shows("paper.eq_10")
def test_that_q_is_c_pga_over_a_rm(result):
    for wall in result.walls:
        for run in wall.runs:
            motion = result.motions[run.motion]
            q = run.scale * motion.pga / wall.block.threshold_acceleration
            assert run.ida.q == pytest.approx(q, rel=1e-14)
            assert run.q_eff == pytest.approx(run.ida.q * G / motion.pga, rel=1e-14)


@pytest.mark.shows("mechanics.impact_limit")
def test_that_an_impact_limit_makes_the_set_incomplete(folder, monkeypatch):
    real = wall_tasks.incremental_dynamic_analyses
    calls = []

    def limited(*arguments, **keywords):
        found = real(*arguments, **keywords)
        calls.append(1)
        if len(calls) == 2:
            return [replace(found[0], status="impact_limit", q=None, bracket=None), *found[1:]]
        return found

    monkeypatch.setattr(wall_tasks, "incremental_dynamic_analyses", limited)
    wall = run(case(), base_dir=folder).walls[0]
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
    given = run(case(demand={"ag_g": 0.2, "housner_intensity_cm": 80.0}), base_dir=folder)
    assert given.demand.intensity == 80.0 * CM
    assert given.demand.intensity_source == "given"


def test_that_a_case_without_records_gives_closed_forms_and_code_only(folder):
    found = run(case(record=[], demand={"ag_g": 0.2, "housner_intensity_cm": 80.0}), base_dir=folder)
    wall = found.walls[0]
    assert wall.runs == () and wall.set_rule is None and wall.q_set is None
    assert wall.closed_form_q == pytest.approx(wall.closed_form_q_eff * 0.2)
    assert [check is not None for check in wall.code_check] == [True, True, False, False, False]


def test_that_a_new_title_or_demand_keeps_the_finished_runs(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    run(case(), base_dir=folder, journal=(path, False))
    first = []
    run(
        case(title="other", demand={"ag_g": 0.1}),
        base_dir=folder,
        journal=(path, True),
        on_progress=lambda d, p, left: first.append((d, p)),
    )
    assert first[0] == (12, 15)  # three walls are assessed again


def test_that_a_resume_with_every_run_done_makes_no_analysis(folder, tmp_path, result, monkeypatch):
    """Neither a run nor a check: of a wall that could rock freely, above the ground, with a tie asked for, too."""
    wall = {"height_m": 3.0, "thickness_m": 0.3, "unit_weight_kn_m3": 18.0, "mechanism": "one_sided"}
    spectrum = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
    asked = case(
        wall=[{**wall, "name": "t", "base_z_m": 0.0, "hold": [sought(2.8)]}, {**wall, "name": "high", "base_z_m": 3.0}],
        building={"height_m": 9.0, "storeys": 3, "period_s": 0.3},
        demand={"ag_g": 0.2, "spectrum": spectrum},
    )
    path = tmp_path / "case.journal"
    first = run(asked, base_dir=folder, journal=(path, False))
    assert first.verdicts[0].wall.sought and first.walls[1].floor
    monkeypatch.setattr(dynamic_check, "scan_records", lambda *_: pytest.fail("checked again"))
    monkeypatch.setattr(wall_tasks, "incremental_dynamic_analyses", lambda *_: pytest.fail("run again"))
    told = []
    again = run(asked, base_dir=folder, journal=(path, True), on_progress=lambda *state: told.append(state))
    assert numbers(again) == numbers(first)
    assert told[-1] == (told[0][1], told[0][1], 0.0)


def test_that_runs_checks_and_statements_are_all_counted_from_the_beginning(folder):
    told = []
    run(
        case(analysis={"q_step": 0.02, "accuracy": True}),
        base_dir=folder,
        on_progress=lambda *state: told.append(state),
    )
    assert [state[:2] for state in told] == [(k, 12 + 3 + 3) for k in range(12 + 3 + 3 + 1)]


def test_that_a_damaged_line_of_a_journal_is_run_again(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    run(case(), base_dir=folder, journal=(path, False))
    lines = path.read_bytes().split(b"\n")
    lines[2] = lines[2].replace(b'"status"', b'"stat"')
    lines.insert(4, b"5")
    path.write_bytes(b"\n".join(lines))
    again = run(case(), base_dir=folder, journal=(path, True))
    assert numbers(again) == numbers(result)


def test_that_collapse_histories_stand_on_both_sides_of_collapse(result):
    for wall in result.walls:
        pair = collapse_histories(result, wall)
        assert [history.outcome for history in pair.histories] == [0, 1]
        assert pair.scales[0] != pair.scales[1]


@pytest.mark.shows("batch.resume")
def test_that_a_cancelled_run_keeps_its_journal_and_resumes_bit_identical(folder, tmp_path, result):
    path = tmp_path / "case.journal"
    state = {"done": 0}

    def progress(done, planned, left):
        state["done"] = done

    with pytest.raises(Cancelled):
        run(case(), base_dir=folder, journal=(path, False), on_progress=progress, cancelled=lambda: state["done"] >= 4)
    lines = path.read_bytes().count(b"\n")
    assert lines >= 5
    # a line cut by a kill
    path.write_bytes(path.read_bytes() + b'{"run": "0/0/1", "resu')
    first = []

    def resumed(done, planned, left):
        first.append(done)

    again = run(case(), base_dir=folder, journal=(path, True), on_progress=resumed)
    assert first[0] >= 4
    assert numbers(again) == numbers(result)


@pytest.mark.shows("files.other_case")
def test_that_a_start_without_resume_sets_finished_runs_aside(folder, tmp_path):
    path = tmp_path / "case.journal"
    run(case(), base_dir=folder, journal=(path, False))
    kept = path.read_bytes()
    run(case(), base_dir=folder, journal=(path, False))
    assert (tmp_path / "case.journal.old").read_bytes() == kept


@pytest.mark.shows("files.other_case")
def test_that_a_journal_of_another_case_is_not_used(folder, tmp_path):
    path = tmp_path / "case.journal"
    run(case(), base_dir=folder, journal=(path, False))
    first = []
    run(
        case(analysis={"q_step": 0.03}),
        base_dir=folder,
        journal=(path, True),
        on_progress=lambda d, p, left: first.append(d),
    )
    assert first[0] == 0


def test_that_a_large_a_g_is_questioned(tmp_path):
    asked = case(record=[], demand={"ag_g": 0.61, "soil_factor": 1.2})
    assert run(asked, base_dir=tmp_path).demand.warnings[0].code == "large_ag"


NAMES = [
    (("r0.txt", "r1.txt", "r2.txt"), ("w", "v")),
    (("compatible 1.txt", "compatible 2.txt", "a.txt"), ("w", "w (+1 m) beside")),
    # stems alike, and files alike by file and channel; a name that ends as a variant does
    (("s/x.txt", "x.txt", "x.txt.txt"), ("w (progetto)", "w (stato di fatto)")),
    (("generated, seed 2.txt", "generated, seed 1.txt", "compatible 2.txt"), ("v", "w")),
]
"""Files of three records and names of two walls."""


def only_numbers(content):
    """A results file without its words."""
    if isinstance(content, dict):
        return {key: only_numbers(value) for key, value in content.items() if "sha256" not in key}
    if isinstance(content, list):
        return [only_numbers(value) for value in content]
    return "" if isinstance(content, str) else content


@pytest.fixture(scope="module")
def renamed(folder, tmp_path_factory):
    """Results of one case under every set of NAMES, with motions generated beside the records."""
    found = []
    for files, names in NAMES:
        place = tmp_path_factory.mktemp("renamed")
        for k, file in enumerate(files):
            (place / file).parent.mkdir(exist_ok=True)
            (place / file).write_bytes((folder / f"r{k}.txt").read_bytes())
        records = [{"file": file, "unit": "m/s2", "time_step_s": 0.01} for file in files]
        wall = {
            "height_m": 4.0,
            "thickness_m": 0.4,
            "base_z_m": 0.0,
            "mechanism": "one_sided",
            "hold": [{"kind": "cross_walls"}],
        }
        first, second = ({**wall, "name": name} for name in names)
        walls = [
            {**first, "variant": "stato di fatto", "hinge_heights": [1.0]},
            {**first, "variant": "progetto", "thickness_m": 0.45},
            {**second, "mechanism": "two_sided"},
        ]
        table = {
            "wall": walls,
            "record": records,
            "generate": {"scatter": 0.0, "count": 2},
            "building": {"height_m": 6.0, "storeys": 2, "period_s": 0.2},
            "analysis": {"q_step": 0.05, "map_span": 1.0, "polarity": "as_recorded"},
            "demand": {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        }
        found.append(run(parse_case(table), base_dir=place))
    return found


@pytest.mark.shows("files.names")
def test_that_names_of_files_and_walls_change_no_number(renamed):
    expected, *others = [json.loads(json_report.dumps(result)) for result in renamed]
    for content in (expected, *others):
        del content["started_utc"]
    for content in others:
        assert only_numbers(content) == only_numbers(expected)


@pytest.mark.shows("files.names")
def test_that_names_of_files_and_walls_change_no_number_of_the_workbook(renamed):
    """Numbers and formulas of every sheet, the note among them, one after the other."""
    found = []
    for result in renamed[:2]:
        book = whole_workbook.build(result, [collapse_histories(result, result.walls[0])])
        cells = [cell.value for sheet in book.workbook for row in sheet for cell in row]
        found.append([cell for cell in cells if not isinstance(cell, str) or cell.startswith("=")])
    assert len(found[0]) > 1000 and found.count(found[0]) == len(found)


def test_that_every_motion_of_a_study_has_a_name_of_its_own(renamed):
    for result in renamed:
        names = [motion.name for motion in result.motions]
        assert len(set(names)) == len(names) == 5
        for wall in result.walls:
            assert [run.record for run in wall.runs] == names


def test_that_a_file_of_a_generated_motion_is_refused_beside_it(folder, tmp_path):
    asked = {
        "demand": {"ag_g": 0.2, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}},
        "generate": {"scatter": 0.0, "count": 1},
    }
    made = run(case(record=[], **asked), base_dir=folder).motions[0]
    lines = [f"{value:.17e}\n" for value in made.acceleration]
    (tmp_path / "copy.txt").write_text("".join(lines))
    entry = {"file": "copy.txt", "unit": "m/s2", "time_step_s": 0.01}
    with pytest.raises(InputError, match="copy.txt is in the case twice"):
        run(case(record=[entry], **asked), base_dir=tmp_path)


@pytest.mark.shows("install.batch_alone")
@pytest.mark.long
def test_that_a_batch_needs_no_package_that_is_not_installed_with_the_program(tmp_path):
    """scipy, there in the tests, is not on a fresh machine: generated sets that scatter ended there in an error."""
    case = tmp_path / "c.toml"
    case.write_text(
        '[[wall]]\nname = "w"\nheight_m = 3.0\nthickness_m = 0.3\nmechanism = "two_sided"\nbase_z_m = 0.0\n'
        "elastic_modulus_mpa = 1000.0\nunit_weight_kn_m3 = 18.0\nunloaded_confirmed = true\n"
        "[generate]\ncount = 2\n[demand]\nag_g = 0.2\n"
        '[demand.spectrum]\ncode = "NTC2018"\nf0 = 2.4\ntc_star_s = 0.3\nsoil = "B"\ntopography = "T1"\n'
    )
    names = sorted({name for group in PACKAGES.values() for name in group})
    start = f"import sys; sys.modules |= dict.fromkeys({names!r}); from app.__main__ import main; sys.exit(main())"
    words = [sys.executable, "-P", "-c", start, "--batch", str(case), "--output", str(tmp_path / "out"), "--quiet"]
    done = subprocess.run(words, capture_output=True, text=True, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)})
    assert (done.returncode, (tmp_path / "out" / "c.xlsx").exists()) == (0, True), done.stderr
