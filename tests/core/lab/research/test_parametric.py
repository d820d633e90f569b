"""A parametric study: what q does not depend on, a cell by another solver and a plain loop, resume, counts."""

import math

import numpy as np
import pytest
from scipy.special import stdtrit

from core.capacity import independent_solver
from core.capacity.bisection import BRACKET
from core.capacity.ida import Search, incremental_dynamic_analysis
from core.case.study_file import parse_study, read_study
from core.codes.target_spectrum import ntc2018
from core.errors import Cancelled, InputError
from core.lab.research import parametric
from core.lab.research.paper_tables import exponent_error, student
from core.lab.research.parametric import model_of
from core.lab.research.set_means import motion_values, set_means
from core.rocking.methods import METHODS
from core.study.journal import Journal
from core.units import G
from tests.conftest import ROOT

SHAPE = {"name": "s", "seed": 11, "code": "EN1998", "type": 1, "soil": "A"}


def table(**grid):
    return {
        "count": 2,
        "group": [{"name": "g", "pga_g": 0.2, "spectrum": [SHAPE]}],
        "grid": [{"slenderness_deg": [6.8], "height_m": [3.0], "q_step": [0.02], **grid}],
    }


def run(content, **options):
    return parametric.run(parse_study(content), "", base_dir=ROOT, **options)


@pytest.mark.shows("mechanics.mirror")
@pytest.mark.parametrize("count", [2, pytest.param(10, marks=pytest.mark.long)])
@pytest.mark.parametrize("one_sided, law", [(False, "rigid"), (True, "rigid"), (False, "doherty")])
def test_that_q_does_not_depend_on_the_scale_of_the_record(one_sided, law, count, make_model):
    study, _ = read_study(ROOT / "resources" / "studies" / "paper.toml")
    spectrum, shape = parametric.spectra_of(study)[4]
    ground = parametric.compatible_motion(spectrum.target, shape.seed)
    model = make_model(one_sided=one_sided, law=law)
    search = Search(q_step=0.01)

    def numbers(motion):
        pga = float(np.abs(motion).max())
        found = incremental_dynamic_analysis(motion, 0.01, pga, 1, model, METHODS["taylor"], search)
        return [found.q, found.q_slv, found.q_slc, found.q_robust]

    once = numbers(ground)
    for factor in np.geomspace(0.03, 20.0, count):
        assert numbers(factor * ground) == pytest.approx(once, rel=1e-12)


@pytest.mark.long
def test_that_dop853_in_a_plain_loop_finds_the_q_of_a_cell(tmp_path):
    """The grid one point after the other, then bisection, each by a solver that shares no line with the kernels."""
    lines = (ROOT / "tests" / "motions" / "noise_1.txt").read_text().splitlines()
    (tmp_path / "short.txt").write_text("\n".join([*lines[:2], *lines[302:552]]) + "\n")
    grid = table(height_m=[1.0], slenderness_deg=[3.1], motions="records", q_step=[0.05])
    result = run(grid, records_from=tmp_path)
    (row,) = result.rows
    motion, model = result.motions[row.motion].motion, model_of(row.cell)
    ground = np.concatenate([motion.acceleration, np.zeros(400)])  # the free motion to its end
    threshold = G * math.tan(model.slenderness)

    def falls(q):
        scaled = ground * (q * threshold / motion.pga)
        theta, _ = independent_solver.history(
            scaled, 0.01, model.slenderness, model.p2, False, lambda v: model.ratio_at_rest
        )
        return np.abs(theta).max() > 0.5 * math.pi

    low, high = 1.0, 1.05
    while not falls(high):
        low, high = high, high * 1.05
    while high / low - 1.0 > BRACKET:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if falls(middle) else (middle, high)
    assert (row.low, row.q) == pytest.approx((low, high), rel=1e-12)


def test_that_threads_and_finished_runs_change_no_digit(tmp_path):
    content = table(mechanism=["two_sided", "one_sided"])
    once, books, count = run(content), [], []

    def journal(key):
        books.append(Journal(tmp_path / "s.journal", key, True, sync_seconds=1.0))
        return books[-1]

    def cancelled():
        return bool(books) and (tmp_path / "s.journal").read_bytes().count(b"\n") > 3

    with pytest.raises(Cancelled):
        run(content, journal=journal, cancelled=cancelled)
    books[0].close()
    again = run(content, jobs=2, journal=journal, on_progress=lambda done, of, left: count.append(done))
    books[1].close()
    assert count[0] >= 3
    assert again.rows == once.rows
    assert len(once.rows) == 2 * 1 + 2 * 2
    assert [row.polarity for row in once.rows] == [1, 1, 1, -1, 1, -1]


def test_that_a_motion_takes_the_lower_of_both_signs_and_a_set_the_mean():
    result = run(table(mechanism=["one_sided"]))
    values = motion_values(result)
    assert len(values) == 2
    for k, value in enumerate(values):
        rows = [row for row in result.rows if row.motion == k]
        assert value.q == min(row.q for row in rows)
        assert value.q_slv == min(row.q_slv for row in rows)
        assert value.q_recorded == rows[0].q
        motion = value.entry.motion
        wall = value.cell.wall.block()
        assert value.pi == pytest.approx(wall.p2 * motion.housner_intensity / motion.pga, rel=1e-14)
    (mean,) = set_means(result, values)
    assert mean.q == pytest.approx((values[0].q + values[1].q) / 2, rel=1e-14)
    assert mean.numbers == 2
    assert mean.q_eff == pytest.approx(mean.q / 0.2, rel=1e-12)


def test_that_every_file_of_a_folder_is_read_or_named(tmp_path):
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_bytes()
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "one.txt").write_bytes(motion)
    (tmp_path / "twin.txt").write_bytes(motion)
    (tmp_path / "notes.md").write_text("no record")
    result = run(table(motions="records"), records_from=tmp_path)
    assert [entry.motion.name for entry in result.motions if entry.seed is None] == ["a/one.txt"]
    assert [file for file, _ in result.refused] == ["notes.md"]
    assert len(result.rows) == 1
    (tmp_path / "list.toml").write_text('[[record]]\nfile = "a/*.txt"\n')
    assert run(table(motions="records"), records_from=tmp_path / "list.toml").rows[0].q == result.rows[0].q
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError, match="no acceleration record"):
        run(table(motions="records"), records_from=tmp_path / "empty")


def test_that_the_smallest_a_g_gives_the_pga_asked_for():
    """S of soil D jumps down at 0.375 g for this shape: two values of a_g give that PGA."""
    soft = {"name": "s", "seed": 5, "code": "NTC2018", "f0": 2.5, "tc_star_s": 0.5, "soil": "D", "topography": "T1"}
    for pga in (0.05, 0.2, 0.3, 0.36, 0.375):
        content = {**table(), "group": [{"name": "g", "pga_g": pga, "spectrum": [soft]}]}
        ((spectrum, _),) = parametric.spectra_of(parse_study(content))
        assert spectrum.target.pga == pytest.approx(pga * G, rel=1e-11)
        for ag in np.linspace(0.02, 0.999, 60) * spectrum.target.ag:
            assert ntc2018(ag, 2.5, 0.5, "D", "T1").pga < pga * G


def test_that_equal_records_count_once_whatever_their_scale(tmp_path):
    lines = (ROOT / "tests" / "motions" / "noise_2.txt").read_text().splitlines()
    rows = [line.split() for line in lines[2:]]
    for name, factor in (("a", 1.0), ("b", 2.0)):
        values = [f"{time} {factor * float(value):.7f}" for time, value in rows]
        (tmp_path / f"{name}.txt").write_text("\n".join(lines[:2] + values) + "\n")
    content = {**table(motions="records"), "record": [{"file": str(tmp_path / "a.txt")}]}
    result = run(content, records_from=tmp_path)
    assert [entry.motion.name for entry in result.motions if entry.seed is None] == ["a"]


def test_that_a_record_and_its_copy_that_differ_by_rounding_count_once(tmp_path):
    """One sample half way between two steps of 1e-4 of the peak: no rounding of the samples makes both equal."""
    samples = np.sin(np.arange(400) * 0.1) * np.hanning(400)
    samples[100] = 0.50005 * np.abs(samples).max()
    for name, factor in (("a", 1.0 - 1e-8), ("b", 1.0 + 1e-8), ("c", 1.001)):
        other = samples.copy()
        other[100] *= factor
        lines = [f"{value:.10f}" for value in other]
        (tmp_path / f"{name}.txt").write_text("\n".join(lines))
    entries = [{"file": str(tmp_path / f"{name}.txt"), "unit": "g", "time_step_s": 0.01} for name in "abc"]
    result = run({**table(motions="records"), "record": entries})
    found = [entry.motion.name for entry in result.motions if entry.seed is None]
    assert found == ["a", "c"]


def test_that_a_vertical_component_is_left_out_and_named(tmp_path):
    values = "\n".join(f"{math.sin(0.1 * k):.6f}" for k in range(400))
    for direction in ("NS", "UP"):
        (tmp_path / f"{direction}.AT2").write_text(
            f"PEER NGA STRONG MOTION DATABASE RECORD\nNowhere, 1/1/2000, Station, {direction}\n"
            f"ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 400, DT= .0100 SEC\n{values}\n"
        )
    (tmp_path / "UP.AT2").write_text((tmp_path / "UP.AT2").read_text().replace("0.8", "0.7"))
    result = run({**table(motions="records"), "record": [{"file": str(tmp_path / "*.AT2")}]})
    assert [entry.motion.name for entry in result.motions if entry.seed is None] == ["NS"]
    ((name, error),) = result.refused
    assert (name, error.code) == ("UP", "vertical_component")


def test_that_a_study_without_a_motion_is_refused():
    with pytest.raises(InputError, match="no wall has a motion"):
        run({"grid": table(motions="records")["grid"]})


def test_that_grids_that_share_a_wall_run_it_once():
    content = table()
    content["grid"] += [{**content["grid"][0], "motions": "all"}, {**content["grid"][0], "restitution": ["housner"]}]
    assert len(run(content).rows) == 2


def test_that_the_interval_of_an_exponent_is_that_of_student():
    """Against scipy's distribution, and of points about a line with a known slope: nine of ten intervals hold it."""
    for free in (*range(1, 41), 200):
        assert student(free) == pytest.approx(stdtrit(free, 0.95), abs=6e-5 if free <= 20 else 2e-4)
    rng, x = np.random.default_rng(3), np.log(np.linspace(20.0, 200.0, 9))
    held = []
    for _ in range(2000):
        y = 2.0 - 0.9 * x + rng.normal(0.0, 0.1, 9)
        slope = np.polyfit(x, y, 1)[0]
        held.append(abs(slope + 0.9) <= exponent_error(x, y))
    assert np.mean(held) == pytest.approx(0.9, abs=0.02)
