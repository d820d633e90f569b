"""Doors of a batch: what is no file where one is named, results over inputs, two batches in one folder."""

import json
import os
import random
import subprocess
import sys
import time
import zipfile

import pytest

from app import __main__ as program
from core.errors import OutputError
from core.study.journal import Journal
from tests.core.test_regular_file import ENDLESS, endless, within
from tests.test_boundaries import ROOT

CASE = """
title = "t"
[[wall]]
name = "w"
mechanism = "one_sided"
height_m = 3.0
thickness_m = 0.4
unit_weight_kn_m3 = 18.0
length_m = 4.0
base_z_m = 0.0
unloaded_confirmed = true
{wall}
{top}
"""
SPECTRUM = '[demand.spectrum]\ncode = "EN1998"\ntype = 1\nsoil = "B"\n[generate]\ncount = 2\nscatter = 0.0\n'
DEMAND = "[demand]\nag_g = 0.2\n" + SPECTRUM

KINDS = {
    "the case": ("case.toml", {}),
    "records": ("x", {"top": '[[record]]\nfile = "x"\nunit = "g"\n'}),
    "a spectrum": ("x", {"top": '[demand]\nag_g = 0.2\nsoil_factor = 1.0\nspectrum_file = "x"\n'}),
    "a hazard": ("x", {"top": '[demand]\nag_g = 0.2\nhazard_file = "x"\n'}),
    "a drawing": ("x.dxf", {"wall": '[[wall.drawing]]\nfile = "x.dxf"\nlayers = "M"\nplane = "section"\nto_m = 4.0\n'}),
    "a logo": ("x.png", {"top": DEMAND + '[report]\nlogo = "x.png"\n'}),
    "a journal": ("case.journal", {"top": DEMAND}),
}


@pytest.mark.shows("doors.endless")
@pytest.mark.skipif(os.name == "nt", reason="no pipes with names")
@pytest.mark.parametrize("kind", ENDLESS)
@pytest.mark.parametrize("name", KINDS)
def test_that_a_thing_without_an_end_is_refused_in_a_sentence(name, kind, tmp_path, capsys):
    file, parts = KINDS[name]
    if name != "the case":
        (tmp_path / "case.toml").write_text(CASE.format(**{"wall": "", "top": ""} | parts), encoding="utf-8")
    endless(kind, tmp_path, file)
    case = tmp_path / "case.toml"
    asked = ["--batch", str(case), "--quiet", *(["--report", str(tmp_path / "n.pdf")] if name == "a logo" else [])]
    assert within(60.0, lambda: program.main(asked)) == 1
    err = capsys.readouterr().err.strip()
    assert err and "Traceback" not in err and len(err.splitlines()) <= 2
    assert not (tmp_path / "case.xlsx").exists()


@pytest.mark.skipif(os.name == "nt", reason="no pipes with names")
@pytest.mark.parametrize("kind", ENDLESS)
def test_that_nothing_is_extracted_from_a_thing_without_an_end(kind, tmp_path, capsys):
    path = endless(kind, tmp_path, "note.pdf")
    assert within(20.0, lambda: program.main(["--extract", str(path)])) == 1
    assert capsys.readouterr().err.strip()


HAZARD = b"30 0.05 2.4 0.28\n475 0.19 2.5 0.33\n"
SVG = b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M0 0H9V9z"/></svg>'
OF_A_FILE = '[demand]\nag_g = 0.2\nhazard_file = "x"\n' + SPECTRUM
OF_A_DRAWING = '[[wall.drawing]]\nfile = "x"\nlayers = "0"\nplane = "elevation"\nto_m = 0.4\nunit = "m"\n'
OF_A_FOLDER = DEMAND.partition("[generate]")[0] + '[select]\nfolder = "x.zip"\ncount = 1\n'


def drawn(path):
    """A wall of 4 x 3 m in DXF."""
    ezdxf = pytest.importorskip("ezdxf", reason="without the group dxf")
    document = ezdxf.new()
    document.modelspace().add_lwpolyline([(0, 0), (4, 0), (4, 3), (0, 3)], close=True)
    document.saveas(path)


def zipped(path):
    """Records in an archive."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("a.txt", (ROOT / "tests" / "motions" / "noise_1.txt").read_bytes())


INPUTS = {
    "case.toml": ({"top": DEMAND}, lambda path: None),
    "x": ({"top": DEMAND + '[report]\nlogo = "x"\n'}, lambda path: path.write_bytes(SVG)),
    "./x": ({"top": OF_A_FILE}, lambda path: path.write_bytes(HAZARD)),
    "././x": ({"top": DEMAND, "wall": OF_A_DRAWING}, drawn),
    "x.zip": ({"top": OF_A_FOLDER}, zipped),
}
"""Name of an input -> (what names it: the case, a logo, a hazard, a drawing, a folder of records; what makes it)."""


@pytest.mark.shows("files.inputs_stay")
@pytest.mark.parametrize("name", INPUTS)
def test_that_a_note_never_takes_the_place_of_an_input(name, tmp_path, capsys):
    """The note is asked for under another name of the input, a link that ends as a note does."""
    parts, make = INPUTS[name]
    case, note, target = tmp_path / "case.toml", tmp_path / "n.pdf", tmp_path / name
    case.write_text(CASE.format(**{"wall": ""} | parts), encoding="utf-8")
    make(target)
    note.symlink_to(target)
    before = target.read_bytes()
    assert program.main(["--batch", str(case), "--quiet", "--report", str(note)]) == 1
    assert target.read_bytes() == before
    assert f"the results would overwrite {target}" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["case.xlsx", "case.json", "n.pdf"])
def test_that_a_folder_under_the_name_of_a_result_is_said_before_the_run(name, tmp_path, capsys, monkeypatch):
    from app.terminal import batch

    monkeypatch.setattr(batch, "run_study", lambda *_, **__: pytest.fail("run"))
    case = tmp_path / "case.toml"
    case.write_text(CASE.format(wall="", top=DEMAND), encoding="utf-8")
    (tmp_path / name).mkdir()
    assert program.main(["--batch", str(case), "--quiet", "--report", str(tmp_path / "n.pdf")]) == 1
    assert name in capsys.readouterr().err


@pytest.mark.shows("files.two_batches")
def test_that_no_other_batch_begins_while_the_results_are_written(tmp_path, monkeypatch):
    from app.terminal import export

    case = tmp_path / "case.toml"
    case.write_text(CASE.format(wall="", top=DEMAND), encoding="utf-8")
    written, refused = export.Report.write, []

    def writes(self, *given, **named):
        with pytest.raises(OutputError) as second:
            Journal(tmp_path / "case.journal", "another", resume=False)
        refused.append(second.value.code)
        written(self, *given, **named)

    monkeypatch.setattr(export.Report, "write", writes)
    assert program.main(["--batch", str(case), "--quiet"]) == 0
    assert refused == ["batch_running"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["case.json", "case.toml", "case.xlsx"]


def test_that_a_journal_is_removed_only_while_it_is_the_one_that_was_opened(tmp_path):
    path = tmp_path / "case.journal"
    first = Journal(path, "key", resume=False)
    path.unlink()
    other = Journal(path, "key", resume=False)
    other.add("run", {"q": 1.0})
    first.remove()
    assert path.exists()
    other.remove()
    assert not path.exists()


MACHINES = {
    "one": "import sys; from app.__main__ import main; sys.exit(main(sys.argv[1:]))",
    "many": "import sys; from core.study import journal; journal.lock = lambda stream: None; "
    "from app.__main__ import main; sys.exit(main(sys.argv[1:]))",
}
"""Machines that write to a folder -> program: on many, none sees the locks of the others."""


@pytest.mark.long
@pytest.mark.parametrize(("count", "machines"), [(2, "one"), (3, "one"), (10, "one"), (2, "many"), (5, "many")])
def test_that_batches_in_one_folder_at_random_times_leave_whole_results(count, machines, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(CASE.format(wall="", top=DEMAND), encoding="utf-8")
    chance, started = random.Random(count), []
    for _ in range(count):
        command = [sys.executable, "-c", MACHINES[machines], "--batch", str(case), "--quiet"]
        started.append(subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL))
        time.sleep(chance.uniform(0.0, 4.0))
    ended = [(process.communicate()[1].decode(), process.returncode) for process in started]
    assert any(code == 0 for _, code in ended)
    for said, code in ended:
        assert code in (0, 1) and "Traceback" not in said and (code == 0 or len(said.strip().splitlines()) == 1), said
    assert json.loads((tmp_path / "case.json").read_bytes())["walls"]
    aside = {path.name for path in tmp_path.glob("case.journal.old*")}  # what another machine had found is kept
    assert machines == "many" or not aside
    assert {path.name for path in tmp_path.iterdir()} - aside == {"case.json", "case.toml", "case.xlsx"}


@pytest.mark.shows("note.holds_case")
def test_that_a_case_edited_during_its_run_leaves_the_note_that_of_the_run(tmp_path, monkeypatch):
    """Its comments are those of what was run, beside the hash of that."""
    pytest.importorskip("pypdf", reason="without the group report")
    from app.terminal import batch
    from core.case.note_file import CASE as NAME
    from core.case.note_file import files_within

    case = tmp_path / "case.toml"
    case.write_text("# before\n" + CASE.format(wall="", top=DEMAND), encoding="utf-8")
    ran = batch.run_study

    def edited(*given, **named):
        result = ran(*given, **named)
        case.write_text("# after\n" + CASE.format(wall="", top=DEMAND), encoding="utf-8")
        return result

    monkeypatch.setattr(batch, "run_study", edited)
    assert program.main(["--batch", str(case), "--quiet", "--report", str(tmp_path / "n.pdf")]) == 0
    within_note = files_within(tmp_path / "n.pdf")[NAME]
    assert b"# before" in within_note and b"# after" not in within_note
    # the note holds its case, and is run again however large it is
    grown = tmp_path / "again.pdf"
    note = (tmp_path / "n.pdf").read_bytes()
    grown.write_bytes(note + b"\n%" + b"x" * 3_000_000 + b"\n" + note[note.rindex(b"startxref") :])
    assert program.main(["--batch", str(grown), "--quiet", "--output", str(tmp_path / "out")]) == 0


@pytest.mark.parametrize("end", [";" * 3_000_000 + "\n", '"ab\n";' * 600_000], ids=["marks", "lines in quotes"])
def test_that_a_row_without_an_end_of_a_large_table_is_refused_before_its_cells_are_made(end, tmp_path):
    from core.case.wall_table import read_table
    from core.errors import InputError

    path = tmp_path / "t.csv"
    path.write_text("nome;H (m)\n" + "a;5\n" * 2100 + end, encoding="utf-8")
    with pytest.raises(InputError) as refused:
        read_table(path, many=True)
    assert refused.value.code in ("row_too_long", "table_too_large")
