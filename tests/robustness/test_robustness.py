"""The robustness sheet: what its campaigns print is counted, and what is done is not done again."""

import sys

import pytest

from core.version import VERSION
from tests.robustness import robustness
from tests.robustness.robustness import CAMPAIGNS, facts_counted, inputs_counted, mutants_counted, sheet


def test_that_the_last_numbers_of_each_kind_of_campaign_are_counted():
    assert facts_counted("....\n12 passed, 3 deselected in 4.00s\n") == (12, 0)
    assert facts_counted("FAILED a\n2 failed, 12 passed, 1 error in 4.00s\n") == (15, 3)
    assert facts_counted("1 failed in 0.20s") == (1, 1)
    said = "record         120 inputs, seed 1: nothing found\nusc two         30 inputs, seed 1: took 3.0 s; kept\n"
    assert inputs_counted(said) == (150, 1)
    assert mutants_counted("core/a.py: 1 -> 2 in x = 1\n560 of 600 faults found (93%); 3 change nothing") == (600, 40)


def test_that_a_run_that_was_stopped_goes_on_and_one_of_another_version_is_made_again(tmp_path, monkeypatch, capsys):
    asked = []

    def row(name, share, journal):
        asked.append(name)
        if len(asked) == 2:
            raise KeyboardInterrupt
        return {"campaign": name, "version": VERSION, "date": "2026-01-02", "tried": 7, "found": 0, "minutes": 0.1}

    monkeypatch.setattr(robustness, "made", row)
    journal, output = tmp_path / "r.journal", tmp_path / "r.md"
    words = ["robustness", "--journal", str(journal), "--output", str(output), "kills", "writing"]
    monkeypatch.setattr(sys, "argv", words)
    with pytest.raises(KeyboardInterrupt):
        robustness.main()
    assert asked == ["kills", "writing"] and not output.exists()
    assert robustness.main() == 0 and asked == ["kills", "writing", "writing"]
    assert output.read_text().count(f"| 7 | 0 | {VERSION} | 2026-01-02 | 0.1 |") == 2
    journal.write_text(journal.read_text().replace(VERSION, "0.0.1"))
    assert robustness.main() == 0 and asked[-2:] == ["kills", "writing"]
    assert capsys.readouterr().out.count("7 tried, 0 did not hold") == 6 - 1


def test_that_the_sheet_has_a_row_for_each_campaign_that_was_made():
    row = {"version": VERSION, "date": "2026-01-02", "tried": 7, "found": 1, "minutes": 0.1}
    page = sheet(dict.fromkeys(CAMPAIGNS, row))
    assert page.count("| 7 | 1 |") == len(CAMPAIGNS)
    assert sheet({}).count("| 7 |") == 0
