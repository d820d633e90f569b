"""The calculation note: its derivations, its figures, the document; the workbook with another input."""

import io
import itertools
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import openpyxl
import pytest

from app import __main__ as program
from app.terminal import export
from core.case.rules import parse_case
from core.codes.capacity_curve import capacity_curve
from core.codes.kinematic import CHECKS
from core.codes.target_spectrum import displacement
from core.errors import InputError, OutputError
from core.report.assumption_table import tabled
from core.report.derived import cell_prefix
from core.report.note import document
from core.report.note.brief import note
from core.report.note.content import full_note
from core.report.note.equation import MAX_WHOLE_LINE, equations, width
from core.report.note.parts import Bars, Blanks, Box, Derivation, Figures, Heading, Item, Paragraph, Step, Table
from core.report.verdict_words import lines_of, sentence_of, sort_results
from core.study.demand_histories import deciding_runs, demand_histories
from core.study.run import run
from core.text.sentence import format_number, word
from core.units import G
from tests.clauses_alone import parse_case as clauses_alone
from tests.conftest import ROOT
from tests.core.report import whole_workbook
from tests.core.variation.random_walls import random_tables
from tests.holds import at_top, shown
from tests.validation.circolare import HELD, case


def steps_of(parts):
    return [step for part in parts if isinstance(part, Derivation) for step in part.steps]


def lines_within(parts):
    return [part.text for part in parts if isinstance(part, (Paragraph, Item))]


def test_a_derivation_in_the_form_of_an_italian_note(verdict):
    lines = [f"{s.written('it')} = {s.result_written('it')}" for s in steps_of(full_note(verdict, "it"))]
    assert "α0 = t/H = 0,830/7,000 = 0,1186" not in lines  # two figures of H
    assert "α0 = t/H = 0,830/7,00 = 0,1186" in lines
    assert "a_0* = α0/(e* FC) = 0,1186/(1,000 · 1,35) = 0,0878" in lines


@pytest.fixture(scope="module")
def held():
    """A wall held at its top, with a load, on the ground of a building."""
    load = {"kind": "vertical", "kn_m": 20.0, "h_m": 3.5, "d_m": 0.15, "mass": "none"}
    wall = {"name": "v", "height_m": 3.5, "thickness_m": 0.3, "mechanism": "vertical_bending", "base_z_m": 0.0}
    wall |= {"unit_weight_kn_m3": 18.0, "hold": at_top(3.5), "load": [load]}
    spectrum = {"code": "NTC2018", "f0": 2.45, "tc_star_s": 0.33, "soil": "B", "topography": "T1"}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    case = parse_case({"wall": [wall], "building": building, "demand": {"ag_g": 0.3, "spectrum": spectrum}})
    return run(case, base_dir=ROOT)


@pytest.mark.shows("note.lines")
def test_that_each_line_of_a_derivation_gives_its_result(building, verdict, held):
    """The numbers of a line, computed as they stand there, give the result to the digits they are written with."""
    counted = 0
    for result, write in itertools.product((building, verdict, held), (full_note, note)):
        for step in steps_of(write(result, "en")):
            written = step.in_numbers("en")
            if not written or "κ" in step.formula:
                continue
            text = written.replace("10³", "1000")
            for sign, meant in {"·": "*", "−": "-", "√": "sqrt", "π": "pi", "²": "**2", "³": "**3", "^": "**"}.items():
                text = text.replace(sign, meant)
            text = re.sub(r"(sin|cos|tan) ([\d.]+)°", r"\1(\2)", text).replace("°", "")
            text = re.sub(r"\|(.*)\|", r"abs(\1)", text)
            known = {
                "pi": np.pi,
                "sqrt": np.sqrt,
                "sin": lambda x: np.sin(np.radians(x)),
                "cos": lambda x: np.cos(np.radians(x)),
                "tan": lambda x: np.tan(np.radians(x)),
                "arctan": lambda x: np.degrees(np.arctan(x)),
            }
            assert eval(text, known) == pytest.approx(step.result, rel=0.02), written
            counted += 1
    assert counted > 40


def test_that_the_floor_is_counted_again_from_the_printed_table_of_modes(building):
    """a_Z, S_eZ(T_0) and S_DeZ(T_SLV) by C7.2.5 to C7.2.8, typed here, from the figures of the note alone."""
    parts = full_note(building, "en")
    (table,) = [part for part in parts if isinstance(part, Table) and part.heads and part.heads[-1] == "S_e(T, ξ) [g]"]
    counted = 0
    for wall in building.walls:
        if wall.floor is None:
            continue
        modes = [[float(cell) for cell in row[2:]] for row in table.rows if float(row[0]) == round(wall.floor.z, 2)]
        mine = [(t, xi, se * abs(part) * np.sqrt(1.0 + 4.0 * xi**2)) for t, xi, part, se in modes]
        prefix = cell_prefix(building, wall)
        steps = {step.cell: step.result for step in steps_of(parts) if (step.cell or "").startswith(prefix)}

        def spectrum(t, damping, mine=mine):
            squares = 0.0
            for of_mode, xi, a_z in mine:
                largest = 1.1 * max(np.sqrt(10.0 / (5.0 + 100.0 * damping)), 0.55) / np.sqrt(xi)
                r = max(1.0 - t / (0.8 * of_mode), 0.0) ** 1.6 + max(t / (1.1 * of_mode) - 1.0, 0.0) ** 1.2
                squares += (largest * a_z / (1.0 + (largest - 1.0) * r)) ** 2
            return np.sqrt(squares)

        assert steps[f"{prefix}a_z"] == pytest.approx(np.sqrt(sum(one[2] ** 2 for one in mine)), rel=5e-3)
        if f"{prefix}se_t0" in steps:
            assert steps[f"{prefix}se_t0"] == pytest.approx(spectrum(steps[f"{prefix}period_0"], 0.05), rel=5e-3)
        counted += 1
    assert counted > 1


# zeta : of the check that decides, which stands above by its own name
IN_TABLES = {"loads", "modes", "solids"}
CONSTANTS = {"zeta", "share", "factor", "damping", "gravity", "topography", "area_run", "si_run", "pga_run"}


@pytest.mark.shows("note.lines")
def test_that_whatever_a_line_is_made_of_stands_above_it(building, verdict):
    """Each number of the note is counted from numbers of the note: of lines, of its tables, constants of a clause."""
    for result, write in itertools.product((building, verdict), (full_note, note)):
        steps = steps_of(write(result, "en"))
        known = {step.cell for step in steps if not (step.cell or "").startswith("wall")}
        for step in steps:
            needs = set(step.quantity.needs if step.quantity else ()) - IN_TABLES - CONSTANTS - known
            assert {name for name in needs if not name.startswith("soil_")} == set(), step.written("en")
            known |= {step.cell, re.sub(r"^wall\d+_", "", step.cell or "")}


@pytest.mark.shows("note.brief")
@pytest.mark.parametrize("walls", [25, pytest.param(200, marks=pytest.mark.long)])
def test_that_a_brief_note_of_any_wall_has_its_outcome_and_lines_that_follow_from_its_lines(walls):
    """Random walls by the clauses, whatever check decides about them."""
    decided = set()
    for table in random_tables(walls, first=2200):
        try:
            result = run(clauses_alone(table), base_dir=Path())
        except InputError:
            continue
        (verdict,) = result.verdicts
        found = result.walls[verdict.governing].required_assessment.verdict
        decided.add(found.governing)
        for language in ("en", "it"):
            parts = note(result, language)
            (row,) = next(part for part in parts if isinstance(part, Table) and part.walls).rows
            assert row[-1] == word(found.code, language) and format_number(found.zeta_e, ".2f", language) in row
            signed = next(k for k, part in enumerate(parts) if isinstance(part, Blanks))
            assert not any(isinstance(part, Derivation) for part in parts[:signed])
    assert len(decided) > 1


@pytest.mark.shows("note.walls")
def test_that_every_check_has_its_zeta_in_the_note_and_on_the_check_sheet(verdict):
    steps = {step.cell for step in steps_of(full_note(verdict, "en"))}
    names = set(whole_workbook.build(verdict, []).workbook.defined_names)
    for wall in verdict.walls:
        assert {check.name for check in wall.assessment.checks} == set(CHECKS) - {"hold"}
        for check in wall.assessment.checks:
            cell = f"{cell_prefix(verdict, wall)}{check.name}_zeta"
            assert cell in steps and cell in names, check.name


def test_that_what_holds_a_wall_has_its_lines_in_the_note_and_on_the_check_sheet():
    bends = HELD | {"mechanism": "vertical_bending", "height_m": 3.0, "thickness_m": 0.4, "hold": at_top(3.0, 10.0)}
    bends |= {"unit_weight_kn_m3": 18.0}
    bends = {key: value for key, value in bends.items() if key not in ("restitution", "velocity_ratio")}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    held = case(bends, {}, analysis={"histories": False}, building=building)
    made = run(held, base_dir=ROOT)
    names = set(whole_workbook.build(made, []).workbook.defined_names)
    steps = {step.cell: step.result for step in steps_of(full_note(made, "en"))}
    (check,) = [check for check in made.walls[0].assessment.checks if check.name == "hold"]
    for cell, value in (("hold_asked", check.demand), ("hold_stands", check.capacity), ("hold_zeta", check.zeta)):
        (found,) = [name for name in steps if name and name.endswith(cell)]
        assert found in names and steps[found] == pytest.approx(value)


@pytest.mark.shows("kinematic.sld_shown")
@pytest.mark.parametrize("state", ["SLD", "SLV", "SLC"])
def test_that_a_g_sld_over_a_g_is_printed_at_every_limit_state(state):
    """t/H over FC and a_g S, of 7.0 x 0.83 m at 0.26 g with S = 1.2."""
    made = run(case(HELD, {"limit_state": state}, analysis={"histories": False}), base_dir=ROOT)
    (step,) = [step for step in steps_of(full_note(made, "en")) if (step.cell or "").endswith("zeta_sld")]
    assert step.result == pytest.approx(0.83 / 7.0 / 1.35 / 0.312, rel=1e-12)
    assert step.cell in whole_workbook.build(made, []).workbook.defined_names


@pytest.mark.shows("note.walls")
def test_that_every_wall_has_its_verdict_with_all_reasons_its_checks_and_its_figures(building):
    parts = full_note(building, "en")
    words = lines_within(parts)
    decide = [wall for wall, decides in sort_results(building) if decides]
    for wall in building.walls:
        # in its section, and that of the hinge that decides on the first page
        assert words.count(sentence_of(wall, "en")) == 1 + (wall in decide)
        said = [*lines_of(building, wall, "en"), *(warning.text("en") for warning in wall.warnings)]
        assert set(said) - tabled(wall, "en") <= set(words)  # those stand in the table of the first page
    figures = [figure for part in parts if isinstance(part, Figures) for figure in part.figures]
    assert len(figures) == 4 * len(building.walls) + 1  # the spectra of the records
    table = next(part for part in parts if isinstance(part, Table) and "ζ_E" in part.heads)
    assert table.rows[0][0] == "gable" and len(table.rows) == len(building.walls)
    assert [building.walls[k].name for k in table.walls] == [row[0].removeprefix("– ") for row in table.rows]
    bars = [part for part in parts if isinstance(part, Bars)]
    for one, k in zip(bars, table.walls, strict=True):
        checks = building.walls[k].assessment.checks
        assert [row[2] for row in one.rows] == [check.zeta for check in checks] and one.rows[0][4]


@pytest.mark.shows("note.first_page")
def test_that_the_first_page_is_the_answer(whole_building):
    """Works and demand in six lines at most, every wall, what decides and what is to be done, a place to sign."""
    parts = full_note(whole_building, "it")
    end = next(k for k, part in enumerate(parts) if isinstance(part, Heading) and part.new_page)
    first = parts[:end]
    assert len(next(part for part in first if isinstance(part, Table) and not part.heads).rows) <= 6
    assert {type(part).__name__ for part in first} == {"Heading", "Paragraph", "Table", "Item", "Blanks"}
    assert "Da fare" in " ".join(lines_within(first))
    walls = [part.wall for part in parts if isinstance(part, Heading) and part.wall is not None]
    assert sorted(walls) == list(range(len(whole_building.walls)))


def test_that_the_note_gives_hazard_building_loads_and_what_is_changed(whole_building):
    parts = full_note(whole_building, "en")
    tables = {tuple(part.heads): part.rows for part in parts if isinstance(part, Table)}
    hazard = next(rows for heads, rows in tables.items() if "T_R [years]" in heads)
    assert [row[:2] for row in hazard][-1] == ["975", "0.340"]
    assert {row[0] for heads, rows in tables.items() if "γψ [-]" in heads for row in rows} >= {"9.00"}
    symbols = {step.symbol for step in steps_of(parts)}
    assert {"H_b", "n", "T_1", "T/T_1", "ξ"} <= symbols
    changed = next(rows for heads, rows in tables.items() if "before" in heads)
    assert changed and all(row[2] != row[5] and row[-1] != "nothing" for row in changed)
    figures = [figure for part in parts if isinstance(part, Figures) for figure in part.figures]
    drawn = {label.text for figure in figures for label in figure.labels}
    listed = [row for part in parts if isinstance(part, Table) and "[kN/m]" in part.heads for row in part.rows]
    for wall in whole_building.walls:
        for load in wall.wall.load:
            assert f"{load.kn_m:.2f} kN/m" in drawn
            assert f"{load.kn_m:.2f}" in {row[1] for row in listed}


def _unloaded(wall):
    return replace(wall, part=replace(wall.part, wall=replace(wall.wall, unloaded_confirmed=True)))


@pytest.mark.shows("note.engineer")
def test_that_what_the_engineer_confirms_judges_and_signs_is_left_blank(whole_building, verdict):
    """Ticked is only what every wall says; with loads and ties these are what is confirmed."""
    parts = full_note(whole_building, "en")
    ticks = {part.text: part.sign for part in parts if isinstance(part, Item) and part.sign in "☑☐"}
    assert set(ticks.values()) == {"☐"} and any("yield" in text for text in ticks)
    assert not any("no load or thrust" in text for text in ticks)
    assert sum(isinstance(part, Box) for part in parts) == 1 and sum(isinstance(part, Blanks) for part in parts) == 2
    sure = replace(verdict, walls=[_unloaded(wall) for wall in verdict.walls])
    ticked = [part.text for part in full_note(sure, "en") if isinstance(part, Item) and part.sign == "☑"]
    assert len(ticked) == 1 and "no load" in ticked[0]


def test_that_what_no_file_states_of_the_records_takes_no_column(verdict):
    """One magnitude stated: its column stands, and the others are named. Generated motions state nothing."""
    first, *others = verdict.motions
    told = replace(first, details=(("station_code", "AQV"), ("magnitude_w", "6.3")))
    natural = replace(verdict, motions=(told, *others), kinds=("natural",) * len(verdict.kinds))
    for result, columns in ((natural, ["Event and station", "M"]), (verdict, [])):
        parts = full_note(result, "en")
        (table,) = (part for part in parts if isinstance(part, Table) and "Scale used" in part.heads)
        assert table.heads == ["Record", *columns, "PGA used [g]", "Scale used", "Kind"]
        assert all(len(row) == len(table.heads) == len(table.widths) for row in table.rows)
        said = [part.text for part in parts if isinstance(part, Paragraph) and part.text.startswith("No file states")]
        assert said == (["No file states: Date, Distance [km], Filter [Hz], processing."] if columns else [])


@pytest.mark.shows("note.walls")
def test_that_the_histories_at_the_demand_are_those_of_the_check(building):
    for wall in building.walls:
        runs = deciding_runs(wall)
        worst = [run for run in wall.assessment.dynamic.runs if run.peak_ratio is None]
        assert runs[0] in worst or runs[0].peak_ratio == max(r.peak_ratio for r in wall.assessment.dynamic.runs)
        for one in demand_histories(building, wall):
            if one.run.peak_ratio is not None:
                found = one.history.peak / wall.model.collapse_rotation
                assert found == one.run.peak_ratio
                assert np.abs(one.displacement).max() < wall.assessment.kinematic.d0


def test_that_the_histories_of_an_element_free_to_vibrate_have_its_elastic_branch():
    wall = {"name": "parapet", "mechanism": "two_sided", "height_m": 1.2, "thickness_m": 0.25, "base_z_m": 0.0}
    wall |= {"unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 600.0}
    demand = {"ag_g": 0.13, "demand_scaling": "pga", "spectrum": {"code": "EN1998", "soil": "B", "type": 1}}
    record = {"file": "motions/noise_2.txt", "kind": "artificial"}
    case = parse_case({"wall": [wall], "record": [record], "demand": demand, "analysis": {"q_limit": 3.0}})
    result = run(case, base_dir=Path(__file__).parents[2])
    (one,) = demand_histories(result, result.walls[0])
    assert result.walls[0].assessment.dynamic.branch and one.run.peak_ratio > 0.2
    assert one.history.peak / result.walls[0].model.collapse_rotation == pytest.approx(one.run.peak_ratio, rel=1e-6)


def test_the_capacity_curve_over_the_demand(verdict):
    wall = verdict.walls[0]
    mechanism = wall.assessment.kinematic
    curve = capacity_curve(mechanism, verdict.demand)
    (first, a0), (d0, last) = curve.capacity
    assert (first, d0, last) == (0.0, mechanism.d0, 0.0) and a0 == pytest.approx(mechanism.a0)
    on_curve = a0 * (1.0 - mechanism.d_limit / d0)
    assert on_curve == pytest.approx(mechanism.a_limit)
    target = verdict.demand.target
    assert displacement(target, mechanism.period, 0.08) == pytest.approx(mechanism.s_de)
    at = float(target.acceleration(mechanism.period, 0.08))
    away = np.hypot(curve.demand_d / mechanism.s_de - 1.0, curve.demand_a / at - 1.0)
    assert away.min() < 0.01
    assert capacity_curve(replace(mechanism, d_limit=None), verdict.demand) is None


@pytest.mark.shows("note.word")
def test_the_document_opens_and_says_what_the_note_says(verdict):
    docx = pytest.importorskip("docx")
    from PIL import Image

    whole = replace(verdict, case=replace(verdict.case, report=replace(verdict.case.report, extent="full")))
    made = docx.Document(io.BytesIO(export.note_content(whole, Path("n.docx"), None)))
    text = [p.text for p in made.paragraphs]
    text += [cell.text for table in made.tables for row in table.rows for cell in row.cells]
    for part in full_note(verdict, "it"):
        if isinstance(part, Paragraph):
            assert part.text in text
        if isinstance(part, Item):
            assert f"{part.sign}  {part.text}" in text
    equations = made.element.body.iter("{http://schemas.openxmlformats.org/officeDocument/2006/math}oMath")
    lines = ["".join(equation.itertext()) for equation in equations]
    assert "α0 = tH = 0,8307,00 = 0,1186" in lines  # fractions
    assert any(line.endswith("0,0878 g") for line in lines)
    pictures = [p.image for p in made.part.package.image_parts] if hasattr(made.part.package, "image_parts") else []
    assert len(pictures) == 4 * len(verdict.walls) + 1
    for picture in pictures:
        image = Image.open(io.BytesIO(picture.blob)).convert("L")
        assert image.width > 900  # 8 cm at 300 dpi
        assert np.asarray(image).min() < 100  # something is drawn
    decimals = [line for line in text if re.search(r"(?<![\dC.])\d\.\d(?![\d.]*\.)", line)]
    allowed = re.compile(r"C8\.7|C7\.2|NTC 2018 10\.2|^3\.2\.|Ribalta|^0\.\d+\.\d")
    assert [line for line in decimals if not allowed.search(line)] == []


@pytest.mark.parametrize("which", ["building", "verdict"])
def test_that_no_equation_is_wider_than_its_column(which, request):
    for step in steps_of(full_note(request.getfixturevalue(which), "it")):
        for line in equations(step, "it"):
            assert width(ElementTree.fromstring(line)) <= MAX_WHOLE_LINE, step.symbol


@pytest.mark.shows("batch.report")
def test_that_the_batch_writes_the_document_or_refuses_before_the_run(tmp_path, monkeypatch, capsys):
    pytest.importorskip("docx")
    case, out = tmp_path / "one.toml", tmp_path / "new"
    case.write_text(
        '[[wall]]\nname = "w"\nheight_m = 5.0\nthickness_m = 0.5\nbase_z_m = 0\nmechanism = "two_sided"\n'
        "[demand]\nag_g = 0.2\nsoil_factor = 1.2\n"
    )
    for name in ("n.docx", "n.pdf"):
        assert program.main(["--batch", str(case), "--output", str(out), "--quiet", "--report", str(out / name)]) == 0
    assert {path.name for path in out.iterdir()} == {"one.xlsx", "one.json", "n.docx", "n.pdf"}
    assert program.main(["--batch", str(case), "--output", str(tmp_path / "b"), "--report", "x.odt"]) == 1
    assert ".docx" in capsys.readouterr().err and not (tmp_path / "b").exists()
    with pytest.raises(SystemExit) as usage:
        program.main(["--report", "x.docx"])
    assert usage.value.code == 2


def test_that_without_its_packages_the_note_is_refused_in_one_sentence(monkeypatch, tmp_path):
    with pytest.raises(InputError, match=r"ends in .pdf or .docx"):
        export.check_note(tmp_path / "a.doc", tmp_path / "a.toml")
    for module in ("docx", "typst", "pypdf"):
        with monkeypatch.context() as context:
            context.setitem(sys.modules, module, None)
            with pytest.raises(OutputError, match="python-docx, typst, pypdf"):
                export.check_note(tmp_path / "a.pdf", tmp_path / "a.toml")


def recalculated(book, folder):
    """The workbook as LibreOffice computes it."""
    office = shutil.which("soffice") or shutil.which("libreoffice")
    if not office:
        pytest.skip("LibreOffice is not installed: formulas were not recalculated")
    path = folder / "bare.xlsx"
    book.save(path)
    subprocess.run(
        [
            office,
            "--headless",
            f"-env:UserInstallation=file://{folder}/profile",
            "--convert-to",
            "xlsx:Calc MS Excel 2007 XML",
            "--outdir",
            folder / "out",
            path,
        ],
        check=True,
        capture_output=True,
        timeout=180,
    )
    return openpyxl.load_workbook(folder / "out" / "bare.xlsx", data_only=True)


def cell_of(book, name):
    sheet, place = book.defined_names[name].attr_text.replace("'", "").replace("$", "").split("!")
    return sheet, place


@pytest.mark.shows("files.live")
def test_that_a_changed_input_is_stated_and_moves_what_follows_from_it(building, tmp_path):
    made = whole_workbook.build(building, []).workbook
    sheet, place = cell_of(made, "demand_ag")
    made[sheet][place].value *= 1.1
    shown = recalculated(made, tmp_path)
    unmoved = {"Input", "Records", "Method"}
    assert {"Summary", "Overview", "Check", "Risk", "Floors"} < set(shown.sheetnames)
    for name in set(shown.sheetnames) - unmoved:
        words = [str(c.value) for line in shown[name].iter_rows(max_row=12) for c in line]
        assert any("Input changed since the run" in word for word in words), name
        rules = [rule for one in made[name].conditional_formatting for rule in one.rules]
        assert any("inputs_changed>0" in str(rule.formula) for rule in rules), name
    old = {
        place
        for one in made["Summary"].conditional_formatting
        for rule in one.rules
        if rule.formula == ["AND(inputs_changed>0,TRUE)"]
        for place in str(one.sqref).split()
    }
    histories = {c.coordinate for c in made["Summary"]["L"] if "_dynamic_zeta" in str(c.value)}
    assert histories and histories <= old  # a link to what the histories found is no less old
    sheet, place = cell_of(made, "demand_pga")
    assert shown[sheet][place].value == pytest.approx(1.1 * building.demand.pga / G)


@pytest.mark.shows("files.live")
@pytest.mark.long
def test_that_a_changed_sheet_agrees_with_a_new_run_or_stays_that_of_the_run(verdict, tmp_path):
    """The thickness of the first wall and a_g changed in the workbook, against the case run with both."""
    made = whole_workbook.build(verdict, []).workbook
    for name, value in (("demand_ag", 0.3), ("wall1_thickness", 0.6)):
        sheet, place = cell_of(made, name)
        made[sheet][place].value = value
    shown = recalculated(made, tmp_path)
    walls = (replace(verdict.case.wall[0], thickness_m=0.6),)
    demand = replace(verdict.case.demand, ag_g=0.3)
    again = run(replace(verdict.case, wall=walls, walls=None, demand=demand), base_dir=ROOT)
    wall, old = again.walls[0], verdict.walls[0]

    def value(name):
        sheet, place = cell_of(made, name)
        return shown[sheet][place].value

    assert value("wall1_a_rm") == pytest.approx(wall.model.threshold / G, rel=1e-9)
    assert value("demand_si") == pytest.approx(100.0 * again.demand.intensity, rel=1e-4)
    assert value("wall1_q_closed") == pytest.approx(wall.closed_form_q, rel=1e-4)
    a0 = wall.assessment.kinematic.a0 / G
    assert value("wall1_a0_star") == pytest.approx(a0, rel=1e-9)
    assert value("wall1_q_set") == pytest.approx(old.q_set, rel=1e-9)  # of the run, as it says
    assert value("wall1_pga_c") == pytest.approx(old.assessment.risk.pga / G, rel=1e-9)
    cells = [c.value for line in shown["Verifica"].iter_rows() for c in line]
    assert cells.count("rifare l'analisi") == 3 * len(verdict.walls)
    summary = [c.value for line in shown["Sintesi"].iter_rows() for c in line]
    assert 0.6 in summary and pytest.approx(7.0 / 0.6) in summary


def test_that_a_step_without_numbers_is_written_alone():
    step = Step("a_g", 0.25, ".3f", "g")
    assert (step.written("it"), step.result_written("it")) == ("a_g", "0,250")
    assert Step("ζ", None).result_written("en") == "–"


def test_that_many_walls_keep_their_reasons_and_the_lowest_their_figures(building, monkeypatch):
    from core.report.note import content

    monkeypatch.setattr(content, "FULL_WALLS", 2)
    parts = full_note(building, "en")
    assert sum(isinstance(part, Figures) for part in parts) == 5  # one of them that of the records
    words = lines_within(parts)
    for wall in building.walls:
        assert sentence_of(wall, "en") in words


@pytest.mark.shows("note.engineer")
def test_that_the_reasons_of_the_engineer_are_printed():
    wall = {
        "name": "w",
        "height_m": 6.0,
        "thickness_m": 0.6,
        "mechanism": "one_sided",
        "base_z_m": 0.0,
        "evidence": shown(law="held by two floors"),
    }
    demand = {"ag_g": 0.2, "soil_factor": 1.2, "evidence": shown(q_code="tests on this masonry")}
    result = run(parse_case({"wall": [wall], "demand": demand}), base_dir=ROOT)
    for language in ("en", "it"):
        said = "\n".join(lines_of(result, result.walls[0], language))
        assert "held by two floors" in said and "tests on this masonry" in said


def test_that_no_word_of_a_table_for_word_is_parted_where_there_is_room():
    """Each column has its longest word, whatever was asked, and all of them the width of the page."""
    rng = np.random.default_rng(4)
    for _ in range(300):
        columns = int(rng.integers(1, 9))
        rows = [["x" * int(n) for n in rng.integers(0, 12, columns)] for _ in range(3)]
        part = Table(rows[0], rows[1:], rng.uniform(0.3, 5.0, columns).tolist())
        sizes = document.widths_of(part)
        least = [
            document.MARGINS + document.CELL_LETTER_WIDTH * max(len(row[k]) for row in rows) for k in range(columns)
        ]
        assert sum(sizes) == pytest.approx(document.TEXT_WIDTH_CM)
        if sum(least) <= document.TEXT_WIDTH_CM:
            assert all(size >= need - 1e-9 for size, need in zip(sizes, least, strict=True))
    wide = Table(["a", "b"], [["one two", "three"]], [1.0, 2.0])
    assert document.widths_of(wide) == pytest.approx([document.TEXT_WIDTH_CM / 3.0, 2.0 * document.TEXT_WIDTH_CM / 3.0])
