"""What stands beside a verdict is in note and workbook with the numbers of the result, in both languages."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import openpyxl
import pytest

from core.case.rules import parse_case
from core.codes.collapse_rate import Lognormal, StateRate
from core.report.note.brief import note
from core.report.note.content import full_note
from core.report.note.parts import Figures, Heading, Item, Table
from core.report.uncertainty_text import rate_lines, rate_row
from core.study.run import run
from tests.core.report import whole_workbook
from tests.core.study.test_verdict_uncertainty import ROWS
from tests.core.variation.test_sensitivity import LOADED, SPECTRUM


@pytest.fixture(scope="module")
def result():
    hazard = [{"return_period_years": t, "ag_g": ag, "f0": 2.4, "tc_star_s": 0.33} for t, ag in ROWS]
    demand = {"ag_g": 0.2, "spectrum": SPECTRUM, "nominal_life_years": 50.0, "use_class_factor": 1.0, "hazard": hazard}
    table = {"wall": [LOADED], "demand": demand, "generate": {"scatter": 0.0, "count": 7}, "analysis": {"q_step": 0.05}}
    return run(parse_case({**table, "sensitivity": {}}), base_dir=Path())


def section(result, language):
    parts = full_note(result, language)
    heads = {"en": "How sure", "it": "Quanto è sicuro"}
    (start,) = [k for k, part in enumerate(parts) if isinstance(part, Heading) and part.text == heads[language]]
    end = next(k for k in range(start + 1, len(parts)) if isinstance(parts[k], Heading) and parts[k].level == 2)
    return parts[start:end]


@pytest.mark.parametrize("language", ["en", "it"])
def test_the_section_of_the_note(result, language):
    (verdict,) = result.verdicts
    parts = section(result, language)
    moves, reach, rates = [part for part in parts if isinstance(part, Table)]
    assert len(moves.rows) == len(verdict.sensitivity.swings) and len(rates.rows) == 4
    comma = "," if language == "it" else "."
    lowest = f"{verdict.sensitivity.swings[0].ends[0].zeta:.2f}".replace(".", comma)
    assert moves.rows[0][2] == lowest
    assert [row[0] for row in rates.rows][:3] == ["SLD", "SLV", "SLC"]
    assert len(reach.rows) == len(verdict.sensitivity.reach) == 2
    (figures,) = [part for part in parts if isinstance(part, Figures)]
    assert len(figures.figures[0].names) == len(moves.rows)
    assert any("FC" in part.text for part in parts if isinstance(part, Item))


def test_that_the_interval_stands_with_the_wall_and_a_brief_note_has_no_section(result):
    parts = note(result, "en")
    interval = result.verdicts[0].interval
    (line,) = [part.text for part in parts if isinstance(part, Item) and "nine of ten" in part.text]
    assert f"{interval.low:.2f} and {interval.high:.2f}" in line and "7 other stations" in line
    assert not [part for part in parts if isinstance(part, Heading) and part.text == "How sure"]


def test_the_sheet_of_the_workbook(result, tmp_path):
    path = tmp_path / "r.xlsx"
    path.write_bytes(whole_workbook.content(result, []))
    sheet = openpyxl.load_workbook(path)["How sure"]
    cells = [cell.value for row in sheet.iter_rows() for cell in row]
    numbers = np.array([cell for cell in cells if isinstance(cell, float)])
    (verdict,) = result.verdicts
    for swing in verdict.sensitivity.swings:
        assert all(np.isclose(numbers, end.zeta, rtol=1e-12).any() for end in swing.ends if end.zeta is not None)
    assert f"{verdict.rates[-1].rate:.1e}" in cells and len(sheet._charts) == 1


def test_that_a_result_without_hazard_and_moves_has_neither_section_nor_sheet(result):
    plain = replace(result, verdicts=tuple(replace(v, rates=(), sensitivity=None) for v in result.verdicts))
    assert not [part for part in full_note(plain, "en") if isinstance(part, Heading) and part.text == "How sure"]
    assert "How sure" not in whole_workbook.build(plain, []).workbook.sheetnames


@pytest.mark.parametrize("share, is_said", [(0.051, True), (0.049, False)])
def test_that_what_the_hazard_does_not_hold_is_said_from_a_twentieth_on(result, share, is_said):
    """What is counted as failure beyond its rows; what is not counted below them, where the rate is too low."""
    rates = [replace(rate, beyond=0.0, weaker=0.0) for rate in result.verdicts[0].rates]

    def lines(*changed):
        return rate_lines(lambda text, **values: text.format(**values), result, changed)

    plain = lines(*rates)
    beyond = [line for line in lines(rates[0], *rates[1:3], replace(rates[3], beyond=share)) if line not in plain]
    weaker = [line for line in lines(replace(rates[0], weaker=share), *rates[1:]) if line not in plain]
    assert (len(beyond), len(weaker)) == ((1, 1) if is_said else (0, 0))
    if is_said:
        assert beyond[0].endswith("taken to fail: a part of collapse.")
        assert weaker[0].endswith("which are not counted: SLD.")


@pytest.mark.parametrize("share, written", [(0.9963, "100 %"), (0.9949, "99 %"), (0.123, "12 %"), (0.00123, "0.12 %")])
def test_that_a_probability_in_the_nominal_life_is_read_at_a_glance(share, written):
    rate = StateRate("SLD", Lognormal(1.0, 0.3, 7), 0.1, 0.05, 0.2, share, 0.1, 0.0, 0.0)
    assert rate_row(lambda words, **_: words, rate, "en")[6] == written
