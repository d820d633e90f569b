"""The solved cases as a PDF and as JSON, and what --validate says of them."""

import io
import json
import tomllib
from dataclasses import replace

import pytest

from app.__main__ import main
from core.lab.solved import cases
from core.lab.solved.pack import _figure, _parts, _Say, as_json, input_of, pdf, summary
from core.lab.solved.solved import Sketch, printed
from core.report.note.pdf import Note
from core.text.sentence import LANGUAGES

pypdf = pytest.importorskip("pypdf")
pytest.importorskip("typst")

FEW = tuple(subject._replace(cases=subject.cases[:2]) for subject in cases.SUBJECTS)


@pytest.mark.parametrize("language", LANGUAGES)
def test_that_the_pdf_has_every_case_and_the_input_files(language):
    reader = pypdf.PdfReader(io.BytesIO(pdf(FEW, language)))
    text = " ".join(page.extract_text() for page in reader.pages)
    few = cases.cases_of(FEW)
    assert all(f"{number}. " in text for number in range(1, len(few) + 1))
    assert ("NTC 2018, 10.2" in text) and summary(few).text(language) in " ".join(text.split())
    files = {f"{case.key}.toml" for case in few if case.table}
    assert files and {"solved.json", *files} == set(reader.attachments)
    assert tomllib.loads(reader.attachments["ground_tall.toml"][0].decode())["wall"][0]["height_m"] == 7.0


@pytest.mark.parametrize("language", LANGUAGES)
def test_that_every_case_is_set(language):
    """The mathematics of each, too: Typst refuses a formula that is none."""
    pages = Note(_parts(cases.SUBJECTS, _Say(language)), language).pages(20.0)
    assert len(pages) > 25


def test_that_the_json_says_what_the_pdf_says():
    few = cases.cases_of(FEW)
    found = json.loads(as_json(few))["cases"]
    assert [one["key"] for one in found] == [case.key for case in few]
    for one, case in zip(found, few, strict=True):
        assert one["agrees"] and one["case_toml"] == (input_of(case) or None)
        assert [answer["expected"] for answer in one["answers"]] == [answer.expected for answer in case.answers]


def test_that_a_case_is_drawn_as_its_sketch_has_it():
    box = ((0.0, 0.0), (0.5, 0.0), (0.5, 3.0), (0.0, 3.0))
    bare, whole = Sketch(box), Sketch(box, ((0.3, 3.0, 0.0, -1.0),), (0.0, 1.0, -1.0), (box,))
    assert _figure(Sketch(), "t") is None
    assert len(_figure(bare, "t").curves) == 3 and len(_figure(whole, "t").curves) == 6
    assert len(_figure(Sketch(motion=(0.0, 1.0)), "t").curves) == 1


@pytest.fixture
def few(monkeypatch):
    monkeypatch.setattr(cases, "SUBJECTS", FEW[:1])
    return FEW[0].cases


@pytest.mark.shows("batch.solved")
def test_that_validate_without_data_runs_the_solved_cases(few, tmp_path, capsys):
    assert main(["--validate", "--output", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    assert all(case.key in said for case in few) and "All 2 cases, 8 answers, agree" in said
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["solved.json", "solved.pdf"]
    assert main(["--validate"]) == 0


def test_that_a_file_that_is_no_pack_is_not_overwritten(few, tmp_path, capsys):
    assert main(["--validate", "--output", str(tmp_path)]) == main(["--validate", "--output", str(tmp_path)]) == 0
    (tmp_path / "solved.json").write_text("thesis")
    assert main(["--validate", "--output", str(tmp_path)]) == 1
    assert "would overwrite" in capsys.readouterr().err and (tmp_path / "solved.json").read_text() == "thesis"


@pytest.mark.shows("batch.solved")
def test_that_a_case_that_does_not_agree_ends_in_5(few, monkeypatch, capsys):
    wrong = replace(few[0], answers=(*few[0].answers, printed(("x", ""), "1.0", lambda: 1.2)))
    monkeypatch.setattr(cases, "SUBJECTS", (FEW[0]._replace(cases=(wrong, few[1])),))
    assert main(["--validate"]) == 5
    said = capsys.readouterr().out
    assert "1 of 2 cases do not agree with their sources: quarter_period." in said and "NO" in said


def test_that_validate_takes_records_or_data_and_refuses_what_it_does_not_take(few, tmp_path, capsys):
    assert main(["--validate", "--records", str(tmp_path)]) == 1
    assert "El Centro 1940" in capsys.readouterr().err
    for words in (["--data", "x"], ["--validate", "--quick"]):
        with pytest.raises(SystemExit) as refused:
            main(words)
        assert refused.value.code == 2
