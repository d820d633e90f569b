"""`--verify`: a report that is what its case gives, one that was edited anywhere, and one that nobody can tell."""

import json
import re
import shutil
import zipfile

import openpyxl
import pytest

from app.__main__ import main
from core.case.note_file import files_within
from tests.conftest import FACADE, ROOT

CASE = f"""
title = "Verified"
[report]
language = "en"
date = "2026-11-27"
extent = "brief"
{FACADE}[[record]]
file = "motion.txt"
[analysis]
q_step = 0.05
map_span = 1.2
[demand]
ag_g = 0.12
spectrum = {{ code = "EN1998", type = 1, soil = "B" }}
"""


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """A folder with a case, its record and its reports."""
    folder = tmp_path_factory.mktemp("reports")
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_text().splitlines()
    (folder / "motion.txt").write_text("\n".join([*motion[:602], ""]))
    (folder / "case.toml").write_text(CASE)
    for end in (".docx", ".pdf"):
        assert main(["--batch", str(folder / "case.toml"), "--report", str(folder / f"case{end}"), "--quiet"]) == 0
    return folder


def verified(capsys, report, *more) -> tuple[int, str]:
    capsys.readouterr()
    code = main(["--verify", str(report), "--quiet", *map(str, more)])
    said = capsys.readouterr()
    return code, said.out + said.err


@pytest.fixture
def copied(reports, tmp_path):
    shutil.copytree(reports, tmp_path / "copied")
    return tmp_path / "copied"


@pytest.mark.shows("batch.verify")
@pytest.mark.parametrize("end", [".json", ".xlsx", ".pdf"])
def test_that_a_report_is_equal_to_its_case_run_again(reports, capsys, end):
    code, said = verified(capsys, reports / f"case{end}")
    assert code == 0 and "equal, run again by version" in said


@pytest.mark.shows("batch.verify")
@pytest.mark.parametrize("end", [".pdf", *(pytest.param(end, marks=pytest.mark.long) for end in (".json", ".xlsx"))])
def test_that_its_records_may_stand_elsewhere(copied, tmp_path, capsys, end):
    apart = tmp_path / "apart"
    apart.mkdir()
    shutil.copy(copied / f"case{end}", apart)
    code, said = verified(capsys, apart / f"case{end}")
    assert code == 6 and "cannot be verified" in said and "motion.txt" in said
    assert verified(capsys, apart / f"case{end}", "--records", copied)[0] == 0
    assert [path.name for path in apart.iterdir()] == [f"case{end}"]


@pytest.mark.shows("batch.verify")
def test_that_a_report_whose_case_names_its_record_absolutely_is_equal_wherever_it_stands(copied, tmp_path, capsys):
    motion, case, apart = tmp_path / "motion.txt", copied / "absolute.toml", tmp_path / "a" / "part"
    apart.mkdir(parents=True)
    shutil.copy(copied / "motion.txt", motion)
    case.write_text(CASE.replace("motion.txt", motion.as_posix()))
    assert main(["--batch", str(case), "--report", str(case.with_suffix(".pdf")), "--quiet"]) == 0
    for end in (".json", ".pdf", ".xlsx"):
        report = shutil.copy(case.with_suffix(end), apart / f"alone{end}")
        code, said = verified(capsys, report)
        assert code == 0, said


FILES_CASE = """
title = "Of files"
walls = "tables/walls.xlsx"
report.language = "it"
[analysis]
histories = false
[demand]
ag_g = 0.12
spectrum_file = "spectrum.csv"
hazard_file = "hazard.csv"
"""


@pytest.fixture(scope="module")
def of_files(tmp_path_factory):
    """A folder with a case that names a table of walls, a spectrum and a hazard, and its reports."""
    folder = tmp_path_factory.mktemp("files")
    (folder / "tables").mkdir()
    book = openpyxl.Workbook()
    rows = (
        ["name", "height_m", "thickness_m", "mechanism", "base_z_m"],
        ["-", "m", "cm", "-", "m"],
        ["facade = 1", 5.0, "45", "two_sided", 0],
        ["gable", "3,5", 30, "two_sided", 0],
        [None, None, None, None, None],
        ["hidden", 4.0, 40, "two_sided", 0],
    )
    for row in rows:
        book.active.append(row)
    book.active.row_dimensions[6].hidden = True
    book.save(folder / "tables" / "walls.xlsx")
    (folder / "spectrum.csv").write_text("0.0 0.12\n0.2 0.4\n0.4 0.4\n0.6 0.4\n1.0 0.24\n2.0 0.12\n4.0 0.05\n")
    (folder / "hazard.csv").write_text("30 0.04 2.5 0.2\n475 0.12 2.5 0.25\n2475 0.2 2.6 0.3\n")
    (folder / "case.toml").write_text(FILES_CASE)
    assert main(["--batch", str(folder / "case.toml"), "--report", str(folder / "case.pdf"), "--quiet"]) == 0
    return folder


@pytest.mark.shows("batch.verify_alone")
@pytest.mark.parametrize("end", [".json", ".xlsx", ".pdf"])
def test_that_a_report_holds_its_table_of_walls_and_names_what_it_does_not_hold(of_files, tmp_path, capsys, end):
    report = shutil.copy(of_files / f"case{end}", tmp_path)
    for name in ("hazard.csv", "spectrum.csv"):
        code, said = verified(capsys, report)
        assert code == 6 and f"{name}: the report does not hold this file" in said, said
        shutil.copy(of_files / name, tmp_path)
    code, said = verified(capsys, report)
    assert code == 0, said
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "walls.xlsx").write_text("another table of that name")
    assert verified(capsys, report)[0] == 0
    (tmp_path / "hazard.csv").write_text("30 0.04 2.5 0.2\n475 0.12 2.5 0.25\n2475 0.2 2.6 0.31\n")
    code, said = verified(capsys, report)
    assert code == 6 and "hazard.csv: this is not the file that the report was made from" in said
    assert verified(capsys, report, "--records", of_files)[0] == 0


@pytest.mark.shows("batch.verify_alone")
def test_that_rows_of_a_table_that_were_edited_in_a_report_are_told(of_files, tmp_path, capsys):
    results = json.loads((of_files / "case.json").read_text(encoding="utf-8"))
    report, rows = tmp_path / "case.json", results["files"][0]["rows"]
    assert results["files"][0]["role"] == "walls" and rows[2][0] == "facade = 1"
    rows[2][2] = "65"
    report.write_text(json.dumps(results))
    for name in ("spectrum.csv", "hazard.csv"):
        shutil.copy(of_files / name, tmp_path)
    code, said = verified(capsys, report)  # its numbers are of another wall
    assert code == 5 and "walls[0]." in said
    code, said = verified(capsys, report, "--records", of_files)  # the table itself is there
    assert code == 5 and "files[0].rows[2][2]: reported 65, found 45" in said
    for broken in ([{}], [{**results["files"][0], "rows": [[1]]}], {"role": 3}, 7, [[]]):
        report.write_text(json.dumps(results | {"files": broken}))
        assert verified(capsys, report)[0] == 1


@pytest.mark.shows("batch.verify")
def test_that_every_edited_number_of_the_results_is_named_with_how_much_it_is_off(copied, capsys):
    path = copied / "case.json"
    content = json.loads(path.read_text())
    content["walls"][0]["q_set"] *= 1.01
    content["verdicts"][0]["text_en"] = "verified"
    path.write_text(json.dumps(content))
    code, said = verified(capsys, path)
    assert code == 5 and "walls[0].q_set: reported" in said and "different by 9.9e-03" in said
    assert "verdicts[0].text_en: reported verified, found" in said and "2 differences" in said


EDITS = {
    "number": (rb'<c r="(\w+)"[^>]*><v>', rb"[^<]+", rb"12.5"),
    "text": (rb'<c r="(\w+)"[^>]*><is><t>', rb"[^<]+", rb"verified"),
    "formula": (rb'<c r="(\w+)"[^>]*><f>', rb"[^<]+", rb"1+1"),
    "kept value": (rb'<c r="(\w+)"[^>]*><f>[^<]+</f><v>', rb"0\.", rb"7."),  # beside a formula, which stays
}
"""What is edited in the cells of a sheet: what stands before it, it, and what takes its place."""


@pytest.mark.shows("batch.verify")
def test_that_an_edited_cell_of_the_workbook_is_named(copied, capsys):
    path = copied / "case.xlsx"
    place = openpyxl.load_workbook(path, read_only=True).sheetnames.index("Check") + 1
    with zipfile.ZipFile(path) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    sheet, edited = f"xl/worksheets/sheet{place}.xml", {}
    for kind, (before, old, new) in EDITS.items():
        cells = (one for one in re.finditer(b"(" + before + b")" + old, parts[sheet]) if one[2] not in edited.values())
        cell = next(cells)
        edited[kind] = cell[2]
        parts[sheet] = parts[sheet][: cell.start()] + cell[1] + new + parts[sheet][cell.end() :]
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    code, said = verified(capsys, path)
    named = [f"Check!{cell.decode()}: reported" for cell in edited.values()]
    assert code == 5 and [name for name in named if name not in said] == [] and "4 differences" in said


def test_that_a_note_of_other_numbers_and_one_written_by_another_program_are_told(copied, capsys):
    """Its own pages; then those of another note, with its files."""
    import pypdf
    from pypdf.generic import NumberObject

    path, case = copied / "case.pdf", copied / "other.toml"
    files = files_within(path)
    case.write_text(CASE.replace("thickness_m = 0.5", "thickness_m = 0.55"))
    assert main(["--batch", str(case), "--report", str(case.with_suffix(".pdf")), "--quiet"]) == 0
    for pages, told in ((path, "written again by another program"), (case.with_suffix(".pdf"), "0.55")):
        writer = pypdf.PdfWriter(clone_from=pages)
        for file in writer.attachment_list:
            if file.name in files:
                file.content, file.size = files[file.name], NumberObject(len(files[file.name]))
        writer.write(path)
        code, said = verified(capsys, path)
        assert code == 5 and told in said and ("other bytes" in said) == (pages == path), said


@pytest.mark.shows("batch.verify")
def test_that_another_version_or_another_record_cannot_be_told(copied, capsys):
    path = copied / "case.json"
    whole = json.loads(path.read_text())
    path.write_text(json.dumps(whole | {"program": whole["program"] | {"version": "0.1.0"}}))
    code, said = verified(capsys, path)
    assert code == 6 and "made by version 0.1.0" in said
    path.write_text(json.dumps(whole))
    *lines, last = (copied / "motion.txt").read_text().splitlines()
    (copied / "motion.txt").write_text("\n".join([*lines, last[:-1] + ("1" if last[-1] != "1" else "2"), ""]))
    code, said = verified(capsys, path)
    assert code == 6 and "not those of the report" in said
    path.write_text(json.dumps(whole | {"case_toml": None}))
    code, said = verified(capsys, path)
    assert code == 6 and "text of its case" in said


@pytest.mark.parametrize(
    "content", [b"", b"{}", b"[1]", b"PK\x03\x04", b"%PDF-1.7\n%%EOF", b'{"program": 1, "case_toml": 3}']
)
def test_that_what_is_no_report_is_refused_in_a_sentence(tmp_path, capsys, content):
    path = tmp_path / "report.json"
    assert verified(capsys, path)[0] == 1
    path.write_bytes(content)
    code, said = verified(capsys, path)
    assert code == 1 and said.count("\n") == 1 and "report.json" in said


@pytest.mark.shows("batch.force")
@pytest.mark.parametrize("end", [".pdf", ".docx"])
def test_that_a_note_is_written_again_over_its_own_and_over_no_other_without_force(copied, capsys, end):
    case, note = copied / "case.toml", copied / f"case{end}"
    ran = ["--batch", str(case), "--report", str(note), "--quiet"]
    assert main(ran) == 0
    own = note.read_bytes()
    other = copied / "other.toml"
    other.write_text(CASE.replace("facade", "gable"))
    for content in (own, b"my thesis", b"PK" + own[2:]):
        note.write_bytes(content)
        capsys.readouterr()
        assert main(["--batch", str(other), "--report", str(note), "--quiet"]) == 1
        said = capsys.readouterr().err
        assert said.count("\n") == 1 and note.name in said and "--force" in said and note.read_bytes() == content
        assert not (copied / "other.json").exists()
    assert main(["--batch", str(other), "--report", str(note), "--quiet", "--force"]) == 0
    assert note.read_bytes() != b"PK" + own[2:]


@pytest.mark.shows("batch.force")
def test_that_a_docx_that_an_office_saved_again_is_not_overwritten(copied, capsys):
    docx = pytest.importorskip("docx")
    note = copied / "case.docx"
    ran = ["--batch", str(copied / "case.toml"), "--report", str(note), "--quiet"]
    edited = docx.Document(note)
    edited.add_paragraph("Seen on site.")
    edited.core_properties.last_modified_by = "Ing. Rossi"
    edited.save(note)
    assert main(ran) == 1 and "--force" in capsys.readouterr().err
    assert docx.Document(note).paragraphs[-1].text == "Seen on site."


@pytest.mark.shows("batch.force")
@pytest.mark.parametrize("end", [".xlsx", ".json"])
def test_that_a_workbook_or_results_of_somebody_are_not_overwritten_without_force(copied, capsys, end):
    for other in (".xlsx", ".json"):
        (copied / f"case{other}").unlink()
    mine = copied / f"case{end}"
    mine.write_bytes(b"my estimate of costs")
    assert main(["--batch", str(copied / "case.toml"), "--quiet"]) == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and mine.name in said and mine.read_bytes() == b"my estimate of costs"
    assert main(["--batch", str(copied / "case.toml"), "--quiet", "--force"]) == 0
    assert main(["--batch", str(copied / "case.toml"), "--quiet"]) == 0


@pytest.mark.shows("batch.force")
def test_that_results_of_another_case_of_the_same_name_are_not_overwritten(copied, tmp_path, capsys):
    """Two folders with a case.toml each, and one folder of results."""
    other = tmp_path / "case.toml"
    shutil.copy(copied / "motion.txt", tmp_path)
    for old, new in (('name = "facade"', 'name = "gable"'), ('"Verified"', '"Another"')):
        other.write_text(CASE.replace(old, new))
        before = {path: path.read_bytes() for path in copied.glob("case.*")}
        assert main(["--batch", str(other), "--output", str(copied), "--quiet"]) == 1
        assert "case.xlsx" in capsys.readouterr().err
        assert before == {path: path.read_bytes() for path in copied.glob("case.*")}
    assert main(["--batch", str(other), "--output", str(copied), "--quiet", "--force"]) == 0
    assert json.loads((copied / "case.json").read_text())["case"]["title"] == "Another"


@pytest.mark.shows("batch.force")
@pytest.mark.parametrize(
    "written", [b"<cp:lastModifiedBy>Ing. Rossi</cp:lastModifiedBy>", b"<cp:lastModifiedBy></cp:lastModifiedBy>"]
)
def test_that_a_workbook_that_an_office_saved_is_not_overwritten(copied, capsys, written):
    """Its yellow cells are there to be changed. Excel and LibreOffice note who saved it, if by no name."""
    book, case = copied / "case.xlsx", copied / "case.toml"
    assert main(["--batch", str(case), "--quiet"]) == 0
    with zipfile.ZipFile(book) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    parts["docProps/core.xml"] = parts["docProps/core.xml"].replace(
        b"</cp:coreProperties>", written + b"</cp:coreProperties>"
    )
    with zipfile.ZipFile(book, "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    saved = book.read_bytes()
    for content in (saved, saved[:-30], b"PK"):  # and one that was cut
        book.write_bytes(content)
        assert main(["--batch", str(case), "--quiet"]) == 1
        assert "case.xlsx" in capsys.readouterr().err and book.read_bytes() == content
