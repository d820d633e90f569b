"""Every solved case agrees with its source: what the program finds, and the input files by which it is run again."""

import math
import re
import tomllib
from dataclasses import replace

import pytest

from core.case.loads import Load
from core.case.rules import parse_case
from core.case.values import field_of
from core.errors import InputError
from core.lab.solved import bodies, clauses, experiments, floors, hazard, histories, motion, paper, published, ties
from core.lab.solved.cases import SUBJECTS, cases_of, solve, subjects
from core.lab.solved.pack import KIND_TITLES, called, file_of, input_of
from core.lab.solved.solved import Kind, Sketch, printed

CASES = cases_of(SUBJECTS)


def each(cases):
    return pytest.mark.parametrize("case", cases, ids=lambda case: case.key)


def differing(case):
    """(answer, expected, found) of each that does not agree."""
    return [(called(answer, "en"), answer.expected, answer.found) for answer in case.answers if not answer.agrees]


@pytest.mark.shows("paper.eq_1", "paper.eq_8")
@each(motion.CASES)
def test_that_the_rocking_block_moves_as_in_closed_form(case):
    assert differing(case) == []


@pytest.mark.shows("paper.eq_1", "mechanics.exact")
@each(histories.CASES)
def test_that_histories_are_those_to_forty_digits(case):
    assert differing(case) == []


@pytest.mark.shows("paper.eq_12", "paper.eq_13", "paper.eq_15", "paper.eq_16")
@each(paper.CASES)
def test_that_the_equations_of_the_paper_give_the_numbers_by_hand(case):
    assert differing(case) == []


@pytest.mark.shows("mechanics.published")
@each(published.CASES)
def test_that_published_examples_are_run_again(case):
    assert differing(case) == []


@pytest.mark.shows("mechanics.experiments")
@each(experiments.CASES)
def test_that_experiments_are_as_near_as_stated(case):
    assert differing(case) == []


@pytest.mark.shows("kinematic.alpha0", "kinematic.loads", "kinematic.friction", "kinematic.sums", "kinematic.d0")
@pytest.mark.shows("kinematic.a0", "kinematic.e_star", "kinematic.t0", "kinematic.d_slv", "kinematic.q_2")
@pytest.mark.shows("kinematic.displacement")
@each(clauses.CASES)
def test_that_the_circolare_is_the_calculation_by_hand(case):
    assert differing(case) == []


@pytest.mark.shows("ties.histories", "ties.work", "ties.bar", "held.mechanism")
@each(ties.CASES)
def test_that_ties_and_walls_held_at_their_top_are_as_worked(case):
    assert differing(case) == []


@pytest.mark.shows("bodies.integrals")
@each(bodies.CASES)
def test_that_bodies_have_their_integrals(case):
    assert differing(case) == []


@pytest.mark.shows("kinematic.floor_spectrum", "kinematic.participation", "kinematic.at_height")
@pytest.mark.shows("kinematic.displacement_at_height", "mechanics.measures")
@each(floors.CASES)
def test_that_walls_above_the_ground_are_the_calculation_by_hand(case):
    assert differing(case) == []


@pytest.mark.shows("demand.place", "demand.ntc_spectrum", "demand.en_spectrum", "demand.return_period")
@pytest.mark.shows("risk.return_period", "risk.class")
@each(hazard.CASES)
def test_that_hazard_spectra_and_risk_are_those_of_the_tables(case):
    assert differing(case) == []


def test_that_no_subject_is_left_out():
    asked = [motion, histories, paper, published, experiments, clauses, ties, bodies, floors, hazard]
    assert [subject.cases for subject in SUBJECTS] == [module.CASES for module in asked]


@pytest.mark.shows("paper.eq_10")
def test_that_q_of_el_centro_is_that_of_three_independent_solvers(shelf):
    found = subjects(shelf)[-1].cases
    assert solve(found) == [] and sum(len(case.answers) for case in found) == 27


def test_that_a_folder_without_el_centro_is_refused(tmp_path):
    (tmp_path / "elCentro.txt").write_text("no record")
    with pytest.raises(InputError) as refused:
        paper.el_centro(tmp_path)
    assert refused.value.code == "no_el_centro"


def test_that_there_are_forty_cases_of_keys_of_their_own_in_both_languages():
    keys = [case.key for case in CASES]
    assert len(keys) >= 40 and len(set(keys)) == len(keys)
    assert all(re.fullmatch(r"[a-z0-9_]+", key) for key in keys)
    assert {case.kind for case in CASES} <= set(KIND_TITLES) == set(Kind)
    for case in CASES:
        texts = [case.title, *([case.comment] if case.comment else [])]
        assert all(text.text("en") and text.text("it") for text in texts)
        assert all(called(answer, language) for answer in case.answers for language in ("en", "it"))


@pytest.mark.parametrize("case", [case for case in CASES if case.table], ids=lambda case: case.key)
def test_that_the_input_file_of_a_case_is_the_case(case):
    assert parse_case(tomllib.loads(input_of(case))) == parse_case(dict(case.table))
    assert file_of(case).removesuffix(".toml") == case.key


def test_that_every_kind_of_load_is_worked_by_hand():
    walls = [wall for case in CASES if case.table for wall in case.table["wall"]]
    worked = {load["kind"] for wall in walls for load in wall.get("load", ())}
    assert worked == set(field_of(Load, "kind").metadata["names"])


def test_that_sketches_are_finite_and_closed_bodies():
    for case in CASES:
        sketch = case.drawing
        assert isinstance(sketch, Sketch) and all(map(math.isfinite, sketch.motion))
        assert len(sketch.outline) != 1 and all(len(outline) > 1 for outline in sketch.others)


def test_that_an_answer_is_held_to_the_digits_of_its_print():
    """0.50 leaves 0.495 to 0.505 open, 3 nothing, 0.00 a two-hundredth itself."""
    for value, found, agrees in (
        ("0.50", 0.5049, True),
        ("0.50", 0.5051, False),
        ("-0.50", -0.4951, True),
        ("3", 3.0, True),
        ("3", 3.0001, False),
        ("0.00", 0.0049, True),
        ("0.00", -0.0051, False),
        ("0.50", math.nan, False),
    ):
        assert printed(("x", ""), value, lambda found=found: found).agrees == agrees, (value, found)


def test_that_a_case_that_does_not_agree_is_named_with_its_furthest_answer():
    case = CASES[0]
    wrong = replace(case, answers=(*case.answers, printed(("x", ""), "1.0", lambda: 1.2)))
    assert solve([case, wrong]) == [wrong] and wrong.furthest.words == "x"
