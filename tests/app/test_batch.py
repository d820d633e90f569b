"""The program from outside: exit codes, files whole or untouched, no Qt, Ctrl-C, kill and resume."""

import errno
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile

import numpy as np
import pytest

from app import __main__ as program
from app.terminal import batch
from tests.conftest import ROOT

CASE = """
[[wall]]
name = "w"
height_m = 5.0
thickness_m = 0.5
mechanism = "two_sided"
base_z_m = 0.0
[[record]]
file = "r*.txt"
unit = "m/s2"
time_step_s = 0.01
[analysis]
q_step = 0.02
[demand]
ag_g = 0.2
"""


def case_in(folder, reference):
    """The case in this folder, with its two records."""
    ground = reference("standard")[0][:600]
    for k in range(2):
        text = "\n".join(f"{value:.9e}" for value in np.roll(ground, 50 * k))
        (folder / f"r{k}.txt").write_text(text)
    path = folder / "case.toml"
    path.write_text(CASE)
    return path


@pytest.fixture
def case(tmp_path, reference):
    return case_in(tmp_path, reference)


def call(*arguments) -> int:
    return program.main([str(argument) for argument in arguments])


def start(*arguments, **keywords):
    variables = dict(os.environ, PYTHONPATH=str(ROOT))
    command = [sys.executable, "-P", "-m", "app", *map(str, arguments)]
    return subprocess.Popen(
        command, env=variables, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **keywords
    )


CALLS = """
import sys
from app.__main__ import main
for arguments in {calls!r}:
    try:
        code = main(arguments)
    except SystemExit as stop:
        code = stop.code
    for stream in (sys.stdout, sys.stderr):
        print(code, end="\\0", file=stream, flush=True)
print(*sys.modules)
"""
"""Several calls in one process: after what each says to a stream its exit code, and a zero byte; then what is
imported."""


@pytest.fixture(scope="module")
def child(tmp_path_factory, reference):
    """Calls of the program on an Italian terminal that takes ASCII: (the folder of its cases, the process)."""
    folder = tmp_path_factory.mktemp("child")
    words = dict(os.environ, PYTHONPATH=str(ROOT), LC_ALL="it_IT.UTF-8", PYTHONIOENCODING="ascii")
    case_in(folder, reference).with_name("high.toml").write_text(CASE.replace("5.0", "500.0"))
    cases = [["--batch", str(folder / f"{name}.toml")] for name in ("none", "high", "case")]
    script = CALLS.format(calls=[["--help"], *cases])
    return folder, subprocess.run([sys.executable, "-P", "-c", script], env=words, capture_output=True, text=True)


@pytest.mark.shows("batch.italian")
def test_that_an_italian_terminal_is_spoken_to_in_italian(child):
    folder, done = child
    _, *refused, shown = done.stdout.split("\0")[:4]
    explained, *errors, last = done.stderr.split("\0")[:4]
    assert refused == ["1", "1"] and explained == "0", done.stderr
    assert errors == [
        f"errore: {folder / 'none.toml'}: questo file di caso non esiste\n1",
        f'errore: {folder / "high.toml"}: parete "w": height_m = 500.0 non ? ammesso: da 0.1 a 60 m\n1',
    ]
    assert "parete" in shown and "analisi in" in shown and shown.endswith("\n0") and "Traceback" not in last


@pytest.mark.shows("batch.batch")
def test_that_a_batch_leaves_no_qt_behind(child):
    folder, done = child
    loaded = {name.split(".")[0] for name in done.stdout.split("\0")[-1].split()}
    assert (folder / "case.json").exists() and "numba" in loaded
    assert not loaded & {"PySide6", "pyqtgraph", "typst", "pypdf", "docx"}


@pytest.mark.shows("batch.batch")
def test_that_a_case_gives_workbook_and_json_beside_it(case, capsys):
    assert call("--batch", case) == 0
    assert sorted(path.name for path in case.parent.iterdir()) == [
        "case.json",
        "case.toml",
        "case.xlsx",
        "r0.txt",
        "r1.txt",
    ]
    shown = capsys.readouterr()
    assert "case.xlsx" in shown.out
    assert shown.err == ""
    content = json.loads((case.parent / "case.json").read_text())
    assert list(content) == [
        *("program", "started_utc", "case", "case_toml", "case_sha256", "files"),
        *("demand", "records", "verdicts", "walls"),
    ]
    run = content["walls"][0]["runs"][0]
    for key in (
        "record",
        "polarity",
        "status",
        "q",
        "bracket",
        "q_slv",
        "q_slc",
        "q_robust",
        "collapse_scale",
        "q_eff",
        "q_last_survival",
        "survived_fraction",
        "survival_windows",
        "q_step",
        "analyses",
        "impact_limited",
        "clamped",
        "method",
    ):
        assert key in run
    check = content["walls"][0]["code_check"]
    assert [entry["q_source"] for entry in check] == [
        "code",
        "closed_form",
        "time_histories",
        "time_histories_slv",
        "time_histories_robust",
    ]
    assert content["case"]["analysis"]["q_limit"] == 100.0


@pytest.mark.shows("batch.code_3")
def test_that_a_run_without_number_is_code_3_and_named(case, capsys):
    case.write_text(CASE.replace("q_step = 0.02", "q_step = 0.05\nq_limit = 1.5"))
    assert call("--batch", case) == 3
    assert "no number: w (two_sided), r0 (+): no_collapse_found" in capsys.readouterr().err
    assert (case.parent / "case.xlsx").exists()


@pytest.mark.shows("batch.code_1")
@pytest.mark.parametrize(
    "change, words",
    [
        (("r*.txt", "*.AT2"), ["no file matches"]),
        (("r*.txt", "nowhere.txt"), ["nowhere.txt", "no such file"]),
        (('unit = "m/s2"\n', ""), ["r0.txt", "give unit"]),
        (('mechanism = "two_sided"', 'mechanism = "leaning"'), ["mechanism", "leaning", "one_sided"]),
        (("height_m = 5.0", "height_m = nan"), ["height_m", "nan"]),
        (("ag_g", "agg"), ["did you mean ag_g?"]),
        (("[[wall]]", "[[wall"), ["not TOML"]),
    ],
)
def test_that_wrong_input_is_one_line_and_code_1_and_old_results_stay(case, capsys, change, words):
    book, results = case.parent / "case.xlsx", case.parent / "case.json"
    with zipfile.ZipFile(book, "w") as archive:
        archive.writestr("docProps/core.xml", "old")
    results.write_text('{ "program": "old", "case": {"title": "Ribalta", "wall": [{"name": "w"')
    old = {path: path.read_bytes() for path in (book, results)}
    case.write_text(CASE.replace(*change))
    assert call("--batch", case) == 1
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.count("\n") == 1 and shown.err.startswith("error: ")
    for word in words:
        assert word in shown.err
    assert old == {path: path.read_bytes() for path in old}
    assert not (case.parent / "case.journal").exists()


@pytest.mark.shows("files.inputs_stay")
def test_that_the_case_itself_is_never_overwritten(case, capsys):
    for name in ("case.json", "case.journal"):
        odd = case.with_name(name)
        odd.write_text(CASE)
        assert call("--batch", odd) == 1
        assert "overwrite" in capsys.readouterr().err
        assert odd.read_text() == CASE
        odd.unlink()


def test_that_an_error_leaves_no_folder_behind(case, capsys):
    case.write_text(CASE.replace('unit = "m/s2"', 'unit = "g"').replace("r*.txt", "nowhere.txt"))
    assert call("--batch", case, "--output", case.parent / "new" / "deep") == 1
    shown = capsys.readouterr().err
    assert shown.startswith(f"error: {case}: record 1: ")
    assert not (case.parent / "new").exists()


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full here")
def test_that_a_full_or_narrow_terminal_ends_no_run(case, monkeypatch):
    case.write_text(CASE.replace('name = "w"', 'name = "Façade α 墙"'))
    variables = dict(os.environ, PYTHONPATH=str(ROOT), PYTHONIOENCODING="ascii")
    command = [sys.executable, "-P", "-m", "app", "--batch", str(case)]
    with open("/dev/full", "w") as full:
        assert subprocess.run(command, stdout=full, env=variables).returncode == 0
    narrow = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr(sys, "stdout", narrow)
    assert call("--batch", case) == 0
    narrow.flush()
    assert b"Fa?ade ? ?" in narrow.buffer.getvalue()


@pytest.mark.shows("batch.output", "batch.code_1")
def test_that_an_output_folder_is_made_or_refused(case, capsys):
    assert call("--batch", case, "--output", case.parent / "new" / "deep", "--quiet") == 0
    assert (case.parent / "new" / "deep" / "case.json").exists()
    blocked = case.parent / "file"
    blocked.write_text("")
    assert call("--batch", case, "--output", blocked) == 1
    assert "cannot be written" in capsys.readouterr().err


@pytest.mark.shows("files.whole")
def test_that_a_full_disk_leaves_the_old_report_and_nothing_half_written(case, capsys, monkeypatch):
    assert call("--batch", case, "--quiet") == 0
    before = {path.name: path.read_bytes() for path in case.parent.iterdir()}
    real, calls = os.fsync, []

    def full(handle):
        journal = case.with_suffix(".journal")
        if journal.exists() and os.path.samestat(os.fstat(handle), journal.stat()):
            return real(handle)
        calls.append(1)
        if len(calls) > 2:  # after the proof of the folder: the second file of the results
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(handle)

    monkeypatch.setattr(os, "fsync", full)
    assert call("--batch", case, "--quiet") == 1
    assert "No space left" in capsys.readouterr().err
    after = {path.name: path.read_bytes() for path in case.parent.iterdir()}
    after.pop("case.journal", None)  # kept: the finished runs are not lost
    assert after == before


@pytest.mark.shows("batch.code_2")
@pytest.mark.parametrize("arguments", [["--nonsense"], ["--batch"], ["--batch", "x", "--jobs", "0"], ["--output", "x"]])
def test_that_wrong_usage_is_code_2(arguments, capsys):
    with pytest.raises(SystemExit) as caught:
        call(*arguments)
    assert caught.value.code == 2


@pytest.mark.shows("batch.code_4")
def test_that_an_internal_error_is_code_4_with_a_log(case, capsys, monkeypatch):
    def broken(*arguments, **keywords):
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(batch, "run_study", broken)
    assert call("--batch", case) == 4
    line = capsys.readouterr().err
    log = line.strip().split()[-1]
    with open(log) as stream:
        assert "a bug" in stream.read()
    os.unlink(log)


@pytest.mark.shows("batch.inspect")
def test_that_inspect_tells_what_a_record_holds(case, capsys):
    assert call("--inspect", ROOT / "tests" / "motions" / "noise_1.txt") == 0
    assert "2501 samples every 0.01 s" in capsys.readouterr().out
    assert call("--inspect", case.parent / "r0.txt") == 1
    assert "refused" in capsys.readouterr().err
    (case.parent / "two.txt").write_text("\n".join(f"{k * 0.01:.2f} {k % 7 - 3}" for k in range(99)) + "\n")
    assert call("--inspect", case.parent / "two.txt") == 0
    assert "99 samples every 0.01 s, peak 3; the unit is not stated" in capsys.readouterr().out
    assert call("--inspect", ROOT / "tests" / "motions") == 0
    assert capsys.readouterr().out.count("samples every") == len(list((ROOT / "tests" / "motions").iterdir()))


def test_that_inspect_names_the_channel_that_is_refused(tmp_path, capsys):
    from openpyxl import Workbook

    book = Workbook()
    book.active.title = "Words"
    book.active.append(["of", "no", "record"])
    book.create_sheet("Empty")
    book.save(tmp_path / "two sheets.xlsx")
    assert call("--inspect", tmp_path / "two sheets.xlsx") == 1
    lines = capsys.readouterr().err.splitlines()
    for line, sheet in zip(lines, ("Words", "Empty"), strict=True):
        assert f'two sheets.xlsx, channel = "{sheet}": ' in line


@pytest.mark.shows("batch.version")
def test_that_version_names_program_and_version(capsys):
    assert call("--version") == 0
    assert capsys.readouterr().out.startswith("Ribalta 0.")


@pytest.mark.shows("batch.code_0")
def test_that_a_wall_that_fails_is_code_0(case):
    case.write_text(CASE.replace("0.2", "0.9"))
    assert call("--batch", case, "--quiet") == 0
    verdicts = json.loads(case.with_suffix(".json").read_text())["verdicts"]
    assert [verdict["code"] for verdict in verdicts] == ["not_verified"]


@pytest.mark.shows("batch.jobs")
def test_that_jobs_change_no_digit_and_quiet_says_nothing(case, capsys):
    written = []
    case.write_text(BOTH)
    for jobs in ("1", "2"):
        assert call("--batch", case, "--jobs", jobs, "--quiet") == 0
        said = capsys.readouterr()
        assert said.out == said.err == ""
        written.append(json.loads(case.with_suffix(".json").read_text()) | {"started_utc": None})
    assert written[0] == written[1]
    assert call("--batch", case) == 0 and "case.xlsx" in capsys.readouterr().out


BOTH = CASE.replace('"two_sided"', '"both"')
LONG = BOTH.replace("q_step = 0.02", "q_step = 0.0004").replace("thickness_m = 0.5", "thickness_m = 0.9")


def waited(path, lines, limit=60.0):
    """Wait until the journal holds this many lines."""
    end = time.monotonic() + limit
    while not path.exists() or path.read_bytes().count(b"\n") < lines:
        assert time.monotonic() < end, "the journal does not grow"
        time.sleep(0.01)  # without it the wait takes the processor of a core


@pytest.mark.shows("batch.code_130")
@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_that_ctrl_c_stops_with_130_and_keeps_the_journal_and_no_workbook(case):
    case.write_text(LONG)
    running = start("--batch", case, "--jobs", "1")
    waited(case.with_suffix(".journal"), 2)
    running.send_signal(signal.SIGINT)
    _, error = running.communicate(timeout=60)
    assert running.returncode == 130
    assert "--resume" in error
    assert case.with_suffix(".journal").exists()
    assert not case.with_suffix(".xlsx").exists()


@pytest.mark.shows("batch.resume")
@pytest.mark.parametrize("module", ["check_sheet", "demand_sheets"])
def test_that_ctrl_c_while_the_files_are_made_stops_and_resumes(case, monkeypatch, capsys, module):
    from core.report import check_sheet, demand_sheets

    sheet = {"check_sheet": check_sheet, "demand_sheets": demand_sheets}[module]
    real = sheet._wall

    def pressed(*arguments):
        signal.raise_signal(signal.SIGINT)
        return real(*arguments)

    with monkeypatch.context() as patch:
        patch.setattr(sheet, "_wall", pressed)
        assert call("--batch", case) == 130
    assert "--resume" in capsys.readouterr().err
    assert sorted(path.name for path in case.parent.iterdir()) == ["case.journal", "case.toml", "r0.txt", "r1.txt"]
    assert call("--batch", case, "--resume", "--quiet") == 0
    assert case.with_suffix(".xlsx").exists() and not case.with_suffix(".journal").exists()


def test_that_a_line_of_progress_counts_runs_and_checks_and_says_no_time_it_does_not_know(monkeypatch, capsys):
    from app.terminal import terminal_progress

    monkeypatch.setattr(terminal_progress, "BETWEEN_LINES", 0.0)
    with terminal_progress.progress(False) as show:
        show.runs(0, 23, None)
        show.runs(2, 23, None)
        show.runs(3, 23, 41.0)
        show.writing(50, 100)
    lines = capsys.readouterr().err.splitlines()
    assert lines[-3:] == ["2/23 runs and checks", "3/23 runs and checks, about 41 s left", "writing the results: 50 %"]


@pytest.mark.shows("batch.resume")
@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_that_a_killed_batch_resumes_to_the_same_digits(case, tmp_path):
    case.write_text(LONG)
    running = start("--batch", case, "--jobs", "1", "--quiet")
    waited(case.with_suffix(".journal"), 3)
    running.kill()
    running.communicate()
    assert call("--batch", case, "--resume", "--quiet") == 0
    resumed = json.loads(case.with_suffix(".json").read_text())
    assert not case.with_suffix(".journal").exists()
    fresh = tmp_path / "fresh"
    assert call("--batch", case, "--output", fresh, "--quiet") == 0
    anew = json.loads((fresh / "case.json").read_text())
    for content in (resumed, anew):
        del content["started_utc"]
    assert resumed == anew


CASES = sorted(path.stem for path in (ROOT / "resources" / "cases").glob("*.toml"))


@pytest.mark.shows("batch.commands")
@pytest.mark.parametrize(
    ("name", "motions"),
    [
        *((name, 2) for name in CASES if name not in ("building", "facade", "palazzo")),
        pytest.param("facade", 3, marks=pytest.mark.long),
        *(pytest.param(name, None, marks=pytest.mark.long) for name in CASES),
    ],
)
def test_that_every_shipped_case_runs(name, motions, tmp_path, capsys):
    """motions : generated in place of all; `shipped` runs the cases with all of them"""
    shutil.copytree(ROOT / "resources", tmp_path / "resources")
    path = tmp_path / "resources" / "cases" / f"{name}.toml"
    if motions:
        every = path.read_text(encoding="utf-8")
        assert every.count("seed = 1\n") == 1
        path.write_text(
            re.sub(r"seed = 1\n(count = \d+\n)?", f"seed = 1\ncount = {motions}\n", every), encoding="utf-8"
        )
    assert call("--batch", path, "--output", tmp_path / "out", "--quiet") == 0
    assert (tmp_path / "out" / f"{name}.xlsx").stat().st_size > 10_000


@pytest.mark.shows("files.inputs_stay")
def test_that_the_table_of_walls_and_the_spectrum_are_not_overwritten(tmp_path, capsys):
    shutil.copy(ROOT / "resources" / "templates" / "walls.xlsx", tmp_path / "c.xlsx")
    before = (tmp_path / "c.xlsx").read_bytes()
    (tmp_path / "c.toml").write_text('walls = "c.xlsx"\n')
    assert call("--batch", str(tmp_path / "c.toml")) == 1
    assert "overwrite" in capsys.readouterr().err
    assert (tmp_path / "c.xlsx").read_bytes() == before


def test_that_a_full_folder_of_temporary_files_is_one_sentence(case, tmp_path, monkeypatch, capsys):
    import errno
    import os

    from openpyxl.worksheet import _writer

    def full(*_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(_writer, "create_temporary_file", full)
    assert call("--batch", case, "--output", tmp_path / "out", "--quiet") == 1
    error = capsys.readouterr().err
    assert "the workbook cannot be created (No space left on device)" in error and "TMPDIR" in error
    assert [path.suffix for path in (tmp_path / "out").iterdir()] == [".journal"]


def test_that_parents_that_cannot_be_read_are_one_sentence(case, tmp_path, monkeypatch, capsys):
    from pathlib import Path

    real = Path.exists

    def exists(self, *more):
        if "closed" in self.name:
            raise PermissionError(13, "Permission denied")
        return real(self, *more)

    monkeypatch.setattr(Path, "exists", exists)
    assert call("--batch", case, "--output", tmp_path / "closed" / "out", "--quiet") == 1
    assert "the output folder cannot be written (Permission denied)" in capsys.readouterr().err


def test_that_a_number_of_thousands_of_digits_is_one_sentence(case, capsys):
    text = case.read_text()
    for value in ("0x" + "f" * 20000, "1" * 4000, "[" * 50 + "]" * 50):
        case.write_text(text.replace("height_m = 5.0", f"height_m = {value}"))
        assert call("--batch", case) == 1
        error = capsys.readouterr().err
        assert error.count("\n") == 1 and len(error) < 600


def test_that_the_terminal_names_verdict_zeta_and_deciding_check_of_each_wall(case, capsys):
    assert call("--batch", case) == 0
    out = capsys.readouterr().out
    assert "verdict" in out.splitlines()[0] and "Eq. 9" not in out
    assert out.splitlines()[1].split()[0] == "w" and out.splitlines()[1].split()[-1] == "dynamic"


def test_that_an_a_g_beyond_any_of_italy_is_asked_about_by_terminal_workbook_and_note(case, tmp_path, capsys):
    import docx
    import openpyxl

    walls = "".join(  # more warnings than the Summary has room for
        f'[[wall]]\nname = "w{k}"\nheight_m = {4 + 0.1 * k}\nthickness_m = 0.0{5 + k // 2}\n'
        f'mechanism = "two_sided"\nbase_z_m = 0.0\n'
        for k in range(7)
    )
    coarse = CASE.replace("q_step = 0.02", "q_step = 0.1").replace("r*.txt", "r0.txt")
    case.write_text(coarse.replace("ag_g = 0.2", "ag_g = 2.55") + '[report]\nextent = "brief"\n' + walls)
    note = tmp_path / "note.docx"
    assert call("--batch", case, "--quiet", "--report", note) == 0
    asked = "a_g = 2.55 g is above 0.6 g, beyond the hazard of Italy at 2475 years: was 2.55 m/s2 meant"
    assert f"[demand]: {asked}" in capsys.readouterr().err
    summary = openpyxl.load_workbook(tmp_path / "case.xlsx", read_only=True)["Summary"]
    assert any(asked in str(cell.value) for row in summary.iter_rows() for cell in row)
    assert any(asked in paragraph.text for paragraph in docx.Document(note).paragraphs)
    assert asked in json.loads((tmp_path / "case.json").read_text())["demand"]["warnings"][0]


@pytest.mark.shows("files.two_batches")
def test_that_a_second_batch_on_the_same_output_is_refused(case, tmp_path, capsys):
    from core.study.journal import Journal

    (tmp_path / "out").mkdir()
    held = Journal(tmp_path / "out" / "case.journal", "other", False)
    assert call("--batch", case, "--output", tmp_path / "out", "--quiet") == 1
    assert "another batch is writing" in capsys.readouterr().err
    held.close()


def test_that_a_batch_without_any_stream_says_nothing_and_opens_no_dialog(case, tmp_path, monkeypatch):
    for name in ("stdin", "stdout", "stderr"):
        monkeypatch.setattr(sys, name, None)
    monkeypatch.setitem(sys.modules, "app.shell.start", None)  # an import of it raises
    assert call("--batch", case) == 0
    assert call("--batch", tmp_path / "missing.toml") == 1
    sys.stderr.close()
    assert (tmp_path / "case.xlsx").exists()


@pytest.mark.shows("batch.output")
def test_that_the_results_of_an_example_land_where_one_stands(tmp_path, monkeypatch, capsys, of_seven):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(batch, "run_study", lambda *_, **__: of_seven)
    before = sorted((ROOT / "resources" / "cases").iterdir())
    assert call("--batch", ROOT / "resources" / "cases" / "verdict.toml") == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["verdict.json", "verdict.xlsx"]
    assert sorted((ROOT / "resources" / "cases").iterdir()) == before
    assert "\nverdict.xlsx\nverdict.json\n" in capsys.readouterr().out


def test_that_the_first_batch_says_what_its_words_mean_and_the_next_does_not(case, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("core.jit.cache.user_folder", lambda: tmp_path / "user")
    assert call("--batch", case, "--quiet") == 0 and capsys.readouterr().out == ""
    assert call("--batch", case) == 0
    said = capsys.readouterr().out
    table, words = said.split("\n\n")
    assert words.splitlines()[-1] == f"open {case.with_suffix('.xlsx')}: its first sheet sums up the walls"
    explained = [line.split(":")[0] for line in words.splitlines()[:-1]]
    assert explained == ["q", "robust", "zeta", "verdict"]
    assert set(explained) <= set(table.splitlines()[0].split())
    assert call("--batch", case) == 0
    assert capsys.readouterr().out.splitlines()[:2] == table.splitlines()[:2]
    case.write_text(CASE.replace("[demand]\nag_g = 0.2\n", ""))
    (tmp_path / "user" / "explained").unlink()
    assert call("--batch", case) == 0
    assert "zeta" not in capsys.readouterr().out


def test_that_a_statement_of_accuracy_without_scipy_is_refused_before_the_run(case, monkeypatch, capsys):
    case.write_text(CASE.replace("q_step = 0.02", "q_step = 0.02\naccuracy = true"))
    monkeypatch.setitem(sys.modules, "scipy", None)
    monkeypatch.setattr(batch, "run_study", lambda *_, **__: pytest.fail("computed"))
    assert call("--batch", case) == 1
    assert "the statement of accuracy needs scipy" in capsys.readouterr().err


def test_that_a_bar_of_a_terminal_is_one_line_and_leaves_nothing_there(capsys, monkeypatch):
    from app.terminal import terminal_progress

    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr(terminal_progress.native, "lacks_lanes", lambda: False)
    with terminal_progress.progress(False) as show:
        show.runs(3, 4, 7.0)
        show.writing(1, 2)
    said = capsys.readouterr().err
    assert "\n" not in said and said.endswith("\r\x1b[K")
    first, second = (line for line in said.split("\r")[1:3])
    assert first.count("█") == 18 and "3/4 runs and checks, about 7 s left" in first
    assert second.count("█") == 12 and "50 %" in second
