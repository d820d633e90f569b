"""`--study` from outside and in its window: files that open, digits that come back, one sentence for wrong input."""

import csv
import hashlib
import io
import json
import os
import re
import shutil
import signal
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

import numpy as np
import pytest
from openpyxl import load_workbook

from app.terminal import study
from core.capacity import scale_free_law
from core.capacity.regression import agreement
from core.lab.research.law_fit import columns, set_columns
from core.lab.research.page import kept
from core.lab.research.set_means import motion_values
from core.lab.research.study_report import report_of
from core.version import commit
from tests.app.driving import settle
from tests.app.test_batch import call, start, waited
from tests.conftest import ROOT

STUDY = """
title = "=1+1"
count = 2
[quick]
count = 1
[[group]]
name = "A"
pga_g = 0.2
[[group.spectrum]]
name = "s1"
seed = 3
code = "EN1998"
type = 2
soil = "A"
[[group.spectrum]]
name = "s2"
seed = 13
code = "EN1998"
type = 1
soil = "B"
[[grid]]
slenderness_deg = [3.1, 6.8]
height_m = [2, 3]
mechanism = ["two_sided", "one_sided"]
q_step = [0.02]
"""
ENDS = (".xlsx", ".json", ".csv")


@pytest.fixture
def small(tmp_path):
    path = tmp_path / "small.toml"
    path.write_text(STUDY)
    return path


@pytest.fixture
def undrawn(monkeypatch):
    """Figures without their pictures: to draw them takes longer than the study."""
    monkeypatch.setattr("core.lab.research.study_files.figure_files", lambda _: {})


def content(folder, stem="small"):
    """Files of a study without the time it took."""
    whole = json.loads((folder / f"{stem}.json").read_text())
    del whole["started_utc"], whole["elapsed_s"], whole["notes"]
    return whole, (folder / f"{stem}.csv").read_bytes()


@pytest.mark.shows("batch.study")
def test_that_a_study_writes_files_that_open(small, tmp_path, capsys):
    pillow = pytest.importorskip("PIL.Image")
    assert call("--study", small, "--jobs", "2") == 0
    assert "48 runs" in capsys.readouterr().out
    whole, runs = content(tmp_path)
    rows = list(csv.DictReader(io.StringIO(runs.decode())))
    assert len(rows) == 4 * 4 + 4 * 4 * 2 == whole["runs"]["count"]
    assert whole["runs"]["sha256"] == hashlib.sha256(runs).hexdigest()
    for row in rows:
        assert row["status"] == "collapse_found" and float(row["q_low"]) < float(row["q"])
        assert float(row["q_eff"]) == pytest.approx(float(row["q"]) / float(row["pga_g"]), rel=1e-12)
    book = load_workbook(tmp_path / "small.xlsx")
    assert book["Study"]["A1"].value == "=1+1" and book["Study"]["A1"].data_type == "s"
    assert len(book["Figures"]._charts) == 4
    assert not any("journal" in path.name for path in tmp_path.iterdir())
    pictures = sorted((tmp_path / "small_figures").iterdir())
    assert len(pictures) == 8
    for path in pictures:
        if path.suffix == ".svg":
            assert "q [-]" in "".join(ElementTree.fromstring(path.read_bytes()).itertext())
        else:
            shades = np.asarray(pillow.open(path).convert("L"))
            assert shades.shape == (690, 1080) and 0.005 < (shades < 200).mean() < 0.3


@pytest.mark.shows("batch.study")
@pytest.mark.long
@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_that_a_killed_study_resumes_to_the_same_digits(small, tmp_path):
    small.write_text(STUDY.replace("q_step = [0.02]", "q_step = [0.0005]"))
    running = start("--study", small, "--jobs", "1", "--quiet")
    waited(tmp_path / "small.journal", 5)
    running.send_signal(signal.SIGKILL)
    running.communicate()
    assert not any((tmp_path / f"small{end}").exists() for end in ENDS)
    assert call("--study", small, "--resume", "--quiet") == 0
    resumed = content(tmp_path)
    assert call("--study", small, "--output", tmp_path / "fresh", "--quiet") == 0
    assert content(tmp_path / "fresh") == resumed


@pytest.mark.shows("files.inputs_stay")
@pytest.mark.parametrize("place", ["small.csv", "small.json", "small.xlsx"])
def test_that_a_study_never_takes_the_place_of_a_file_it_reads(place, small, tmp_path, capsys):
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_bytes()
    (tmp_path / place).write_bytes(motion)
    small.write_text(STUDY + f'motions = "all"\n[[record]]\nfile = "{place}"\n')
    assert call("--study", small) == 1
    assert "would overwrite" in capsys.readouterr().err
    assert (tmp_path / place).read_bytes() == motion
    small.write_text(STUDY)
    assert call("--study", small, "--records", tmp_path) == 1
    assert (tmp_path / place).read_bytes() == motion
    own = tmp_path / "own.json"
    own.write_text(STUDY)
    assert call("--study", own) == 1 and own.read_text() == STUDY
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["small.toml", "own.json", place])


@pytest.mark.long
def test_that_a_title_may_change_and_figures_of_an_earlier_run_go(small, tmp_path):
    small.write_text(STUDY.replace("q_step = [0.02]", "q_step = [0.0005]"))
    running = start("--study", small, "--jobs", "1", "--quiet")
    waited(tmp_path / "small.journal", 5)
    running.kill()
    running.communicate()
    small.write_text(small.read_text().replace("=1+1", "another"))
    old = tmp_path / "small_figures"
    old.mkdir()
    for name in ("fig21_natural.png", "mine.png"):
        (old / name).write_bytes(b"x")
    assert call("--study", small, "--resume", "--quiet") == 0
    assert "finished by an earlier start" in " ".join(json.loads((tmp_path / "small.json").read_text())["notes"])
    assert (old / "mine.png").exists() and not (old / "fig21_natural.png").exists()


SHORT = ("paper", "velocity_ratio = [0.9]"), ("law", 'restitution = ["default"]')
"""Reports and grids of the short run."""


@pytest.mark.shows("batch.study")
@pytest.mark.parametrize(
    ("report", "grid"),
    [
        pytest.param(report, grid, marks=() if (report, grid) in SHORT else pytest.mark.long)
        for report in ("paper", "law")
        for grid in ('restitution = ["default"]', "velocity_ratio = [0.9]", 'motions = "records"', 'method = ["rk4"]')
    ],
)
def test_that_every_report_is_made_of_any_grid(report, grid, tmp_path):
    """Few walls, other restitutions, records alone: less is shown, nothing fails."""
    path = tmp_path / "any.toml"
    names = STUDY.replace('"s1"', '"s $^$ / x"').replace('name = "A"', 'name = "../A"')
    path.write_text(f'report = "{report}"\n' + names.replace('mechanism = ["two_sided", "one_sided"]', grid))
    shutil.copy(ROOT / "tests" / "motions" / "noise_1.txt", tmp_path)
    assert call("--study", path, "--records", tmp_path, "--output", tmp_path / "out", "--quiet") == 0
    whole = json.loads((tmp_path / "out" / "any.json").read_text())
    assert not re.search(r"\bnan\b", " ".join(whole["notes"]))
    assert not any(table["rows"] == [] for table in whole["tables"])


def test_that_a_run_without_a_number_is_named_and_gives_exit_code_3(tmp_path, capsys):
    path = tmp_path / "stands.toml"
    stands = STUDY.replace("[3.1, 6.8]", "[40.0]").replace("[2, 3]", "[50]").replace(', "one_sided"', "")
    path.write_text(stands)
    assert call("--study", path, "--quick", "--quiet") == 3
    assert "no_collapse_found" in capsys.readouterr().err


@pytest.mark.shows("batch.study")
def test_that_a_short_run_has_its_own_files(small, tmp_path, undrawn):
    assert call("--study", small, "--quick", "--quiet") == 0
    whole, _ = content(tmp_path, "small_quick")
    assert whole["quick"] and len(whole["motions"]) == 2
    assert not (tmp_path / "small.json").exists()


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["--study", "nowhere.toml"], "nowhere.toml: there is no such study: paper, law"),
        (["--study", "{small}", "--records", "{small}"], "unknown key"),
        (["--study", "{small}", "--records", "nowhere"], "no such folder or list of records"),
        (["--study", "{broken}"], "did you mean height_m"),
    ],
)
def test_that_wrong_input_is_one_sentence_and_nothing_is_written(arguments, words, small, tmp_path, capsys):
    broken = tmp_path / "broken.toml"
    broken.write_text(STUDY.replace("height_m", "heigth_m"))
    before = sorted(tmp_path.iterdir())
    filled = [word.format(small=small, broken=broken) for word in arguments]
    assert call(*filled, "--output", tmp_path / "out" / "deep") == 1
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and words in error
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.shows("paper.pack")
def test_that_the_archive_of_a_study_runs_again_to_the_same_bytes(small, tmp_path, capsys):
    """By the command its README names, in the folder it was unpacked in; every column has its unit."""
    assert call("--study", small, "--quick", "--quiet", "--pack") == 0
    words, code, unpacked = rerun(tmp_path, tmp_path / "small_quick_pack.zip")
    names = {path.relative_to(unpacked).as_posix() for path in unpacked.rglob("*")}
    assert code == 0 and "FOLDER" not in words
    runs = (unpacked / "small_quick.csv").read_bytes()
    assert (unpacked / "again" / "small_quick.csv").read_bytes() == runs
    assert hashlib.sha256(runs).hexdigest() in words and f"({commit()})" in words and "CC BY 4.0" in words
    columns = list(csv.reader(io.StringIO((unpacked / "columns.csv").read_text(encoding="utf-8"))))
    assert [row[0] for row in columns[1:]] == runs.decode().splitlines()[0].split(",")
    assert all(row[2] for row in columns)
    assert {"small.toml", "small_quick.json", "LICENCE.txt", "versions.txt", "requirements.lock"} <= names
    assert any(name.startswith("figures/") for name in names)
    assert "numba" in (unpacked / "versions.txt").read_text()


def rerun(place, archive_of):
    """Unpack an archive and run the command of its README there, FOLDER as `records` of the place."""
    unpacked = place / "unpacked"
    with zipfile.ZipFile(archive_of) as archive:
        archive.extractall(unpacked)
    words = (unpacked / "README.md").read_text(encoding="utf-8")
    command = re.search(r"^    ribalta (.+)$", words, re.MULTILINE)[1].split()
    for k, word in enumerate(command):
        if k and not word.startswith("-") and command[k - 1] in ("--study", "--records", "--output"):
            command[k] = place / "records" if word == "FOLDER" else unpacked / word
    return words, call(*command, "--quiet"), unpacked


def test_that_an_archive_names_what_it_has_and_has_not(small, tmp_path, capsys, undrawn):
    """A set in a folder below the study runs again; a list of its own name takes no place of it; a set elsewhere
    is refused before anything runs."""
    folder = tmp_path / "records"
    folder.mkdir()
    shutil.copy(ROOT / "tests" / "motions" / "noise_1.txt", folder / "one.txt")
    digest = hashlib.sha256((folder / "one.txt").read_bytes()).hexdigest()
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "set.toml").write_text(
        f'[[record]]\nevent = "E"\nstation = "S"\ncomponent = "N"\nfile = "one.txt"\nfile_sha256 = "{digest}"\n'
    )
    small.write_text(STUDY.replace("count = 2", 'count = 2\nnatural = "sub/set.toml"', 1) + 'motions = "all"\n')
    asked = ("--study", small, "--quick", "--quiet", "--pack")
    assert call(*asked, "--records", folder) == 0
    words, code, unpacked = rerun(tmp_path, tmp_path / "small_quick_pack.zip")
    assert code == 0 and "FOLDER holds the records that sub/set.toml names" in words
    assert (unpacked / "again" / "small_quick.csv").read_bytes() == (unpacked / "small_quick.csv").read_bytes()
    (tmp_path / "lists").mkdir()
    (tmp_path / "lists" / "small.toml").write_text(f'[[record]]\nfile = "{(folder / "one.txt").as_posix()}"\n')
    assert call(*asked, "--records", tmp_path / "lists" / "small.toml") == 0
    with zipfile.ZipFile(tmp_path / "small_quick_pack.zip") as archive:
        assert archive.read("small.toml") == small.read_bytes() and b"[[record]]" in archive.read("given/small.toml")
    small.write_text(small.read_text().replace("sub/set.toml", "../set.toml"))
    before = sorted(tmp_path.rglob("*"))
    assert call(*asked) == 1
    assert "outside of the folder of the study" in capsys.readouterr().err and sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize(
    "arguments", [["--quick"], ["--pack", "--batch", "x"], ["--records", "x"], ["--study", "paper", "--batch", "x"]]
)
def test_that_options_that_do_not_go_together_are_wrong_usage(arguments, capsys):
    with pytest.raises(SystemExit) as ended:
        call(*arguments)
    assert ended.value.code == 2
    capsys.readouterr()


@pytest.fixture(scope="module")
def paper(tmp_path_factory):
    """The paper's study in its short form, and its files."""
    folder = tmp_path_factory.mktemp("paper")
    made = study.results("paper", folder, None, 2, True, False, lambda done, of, left: None, lambda: False)
    report = report_of(made.result)
    study.write(made.result, report, folder, made.stem)
    made.book.remove()
    return folder, made.result, report


@pytest.mark.shows("paper.claims")
@pytest.mark.long
def test_that_the_claims_of_the_paper_are_counted(paper):
    _, _, report = paper
    counts = {(claim.source, claim.claim): (claim.held, claim.tried) for claim in report.claims}

    def share(words):
        found = [held / tried for (_, claim), (held, tried) in counts.items() if words in claim]
        assert found, words
        return found

    assert min(share("q grows with H")) == 1.0
    assert min(share("q grows with alpha")) >= 0.9
    assert min(share("not above q by Eq. 5, two-sided, sets") + share("not above q by Eq. 7, one-sided, sets")) == 1.0
    assert min(share("PGA alone does not decide")) == 1.0
    assert min(share("more conservative, one-sided")) == 1.0
    assert max(share("more conservative, two-sided")) < 0.5  # not so for walls that rock to both sides
    assert share("within 20 % of Eq. 16")[0] > 0.7 > 0.4 > share("within 20 % of Eq. 15")[0]


@pytest.mark.long
def test_that_every_figure_of_the_paper_is_there_but_those_of_records(paper):
    folder, result, report = paper
    numbers = {figure.key[3:5] for figure in report.figures if figure.key.startswith("fig")}
    assert numbers == {f"{k:02}" for k in range(4, 21)}
    assert {path.stem for path in (folder / "paper_quick_figures").glob("*.png")} == {f.key for f in report.figures}
    assert all(row.q is not None for row in result.rows)
    assert [table.key for table in report.tables] == ["table1", "eq13", "eq14", "distance"]


@pytest.mark.shows("paper.law")
@pytest.mark.long
@pytest.mark.parametrize("mechanism, quantity", [(m, q) for m in ("two_sided", "one_sided") for q in ("q", "q_slv")])
def test_that_the_stored_law_holds_for_shapes_and_seeds_it_has_never_seen(paper, mechanism, quantity):
    """Nine shapes of the paper's study, two motions each; the law was fitted on others."""
    _, result, _ = paper
    fitted = scale_free_law.fitted()[mechanism, "rigid", quantity]
    of_study = json.loads(kept("law").read_text(encoding="utf-8"))["fits"][f"{mechanism} rigid {quantity}"]
    sets = set_columns(columns(motion_values(result), mechanism, "rigid", quantity, False))
    found = agreement(fitted.q(sets.scaled, 1.0 - sets.loss**2), sets.q)
    assert found.n == 9 * 6 * 2
    assert abs(found.bias) < 0.08 and found.scatter < 1.5 * of_study["scatter_record"]


@pytest.mark.long
def test_that_the_italian_study_has_the_same_numbers(small, tmp_path):
    assert call("--study", small, "--quiet") == 0
    _, runs = content(tmp_path)
    small.write_text('language = "it"\n' + STUDY)
    assert call("--study", small, "--quiet") == 0
    assert content(tmp_path)[1] == runs
    assert load_workbook(tmp_path / "small.xlsx").sheetnames[0] == "Studio"


@pytest.mark.shows("window.of_a_study")
def test_that_the_window_of_a_study_runs_cancels_goes_on_and_shows_it(
    application, small, tmp_path, monkeypatch, undrawn
):
    from PySide6.QtWidgets import QMessageBox

    from app.shell.study_window import StudyWindow

    monkeypatch.setattr(QMessageBox, "warning", lambda *a: pytest.fail(f"unexpected: {a[-1]}"))
    small.write_text(STUDY.replace("q_step = [0.02]", "q_step = [0.008]"))
    made = StudyWindow(None)
    made.quick.setChecked(False)
    made.study.setCurrentText(str(small))
    made.folder.setText(str(tmp_path / "results"))
    made.show()
    made.run()
    settle(application, lambda: made.bar.value() > 0)
    made.cancel()
    settle(application, lambda: made.job is None)
    journal = tmp_path / "results" / "small.journal"
    kept = journal.read_bytes().count(b"\n") - 1
    assert kept > 0 and made.tabs.count() == 0
    progress = []
    made.run()
    made.job.progressed.connect(lambda done, of, left: progress.append(done))
    settle(application, lambda: made.job is None)
    assert progress[0] >= kept
    assert made.tabs.count() == 2  # no claims of the paper
    charts = made.tabs.widget(1).widget(0)
    assert charts.count() == 4
    for row in range(charts.count()):
        charts.setCurrentRow(row)
    application.processEvents()
    assert not journal.exists() and (tmp_path / "results" / "small.xlsx").exists()
    assert made.close() and not made.isVisible()
    made.deleteLater()


def test_that_a_study_without_its_packages_is_refused_before_it_computes(small, tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    before = sorted(tmp_path.iterdir())
    assert call("--study", small, "--output", tmp_path / "out") == 1
    said = capsys.readouterr().err
    assert "a parametric study needs matplotlib" in said and said.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.long
def test_that_a_figure_that_fails_takes_no_number_along(small, tmp_path, monkeypatch, capsys):
    assert call("--study", small, "--output", tmp_path / "right", "--quiet") == 0

    def fails(figure):
        raise RuntimeError("no font")

    monkeypatch.setattr("core.lab.research.study_files.figure_files", fails)
    assert call("--study", small, "--output", tmp_path / "out", "--quiet") == 4
    said = capsys.readouterr().err
    assert f"workbook, JSON and CSV are written: {tmp_path / 'out' / 'small'}" in said
    assert content(tmp_path / "out") == content(tmp_path / "right")
    load_workbook(tmp_path / "out" / "small.xlsx")
    monkeypatch.undo()  # finished runs are used again, so that the figures cost no second run
    monkeypatch.setattr(
        "core.lab.research.parametric.incremental_dynamic_analysis", lambda *_: pytest.fail("run again")
    )
    assert call("--study", small, "--output", tmp_path / "out", "--resume", "--quiet") == 0
    assert len(list((tmp_path / "out" / "small_figures").iterdir())) == 8


def test_that_a_study_by_its_keys_is_written_read_back_and_is_the_one_to_run(application, tmp_path, monkeypatch):
    from PySide6.QtWidgets import QFileDialog

    from app.shell import study_form
    from app.shell.study_window import StudyWindow
    from core.case.study_file import cells_of, read_study

    made = StudyWindow(None)
    made.folder.setText(str(tmp_path))
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "mine.toml"), ""))

    def fill(form):
        for heights, said in (("3; x", "x"), ("3; 900", "900"), ("", "number")):
            form.lines["height_m"].setText(heights)
            form.save()
            assert form.path is None and said in form.word.text()
        form.lines["height_m"].setText("3; 5,5")
        form.lines["slenderness_deg"].setText("5")
        form.choices["mechanism"].setCurrentIndex(form.choices["mechanism"].count() - 1)
        form.save()
        return form.path is not None

    monkeypatch.setattr(study_form.StudyForm, "exec", fill)
    made._make_study()
    assert made.study.currentText() == str(tmp_path / "mine.toml") and not made.quick.isChecked()
    study, _ = read_study(tmp_path / "mine.toml")
    cells = {(cell.height_m, cell.mechanism, cell.slenderness_deg) for cell in cells_of(study)}
    assert cells == {(h, m, 5.0) for h in (3.0, 5.5) for m in ("two_sided", "one_sided")}
    made.close()
    made.deleteLater()
