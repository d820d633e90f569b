"""The workbook: live formulas recalculated by LibreOffice, safe text, words, one-page Summary."""

import math
import os
import re
import shutil
import subprocess
import tempfile
import zipfile
from dataclasses import replace
from io import BytesIO

import numpy as np
import openpyxl
import pytest

from app.terminal import export
from core.case.loads import Load
from core.case.rules import parse_case
from core.case.values import field_of
from core.errors import Cancelled
from core.report.cells import Book
from core.report.input_sheet import inputs
from core.report.load_arrows import arrows, tie_bars
from core.study import run as study
from core.study.governing import collapse_histories
from tests.conftest import STANDING
from tests.core.report import whole_workbook
from tests.holds import between, sought

HOSTILE = '=HYPERLINK("http://x","y")'


@pytest.fixture(scope="module")
def folder(tmp_path_factory, reference):
    place = tmp_path_factory.mktemp("records")
    ground = reference("standard")[0][:900]
    for k in range(3):
        text = "\n".join(f"{value:.9e}" for value in np.roll(ground, 30 * k) * (0.9 + 0.1 * k))
        (place / f"r{k}.txt").write_text(text)
    return place


def made(folder, language="en", **more):
    table = {
        "title": HOSTILE,
        "report": {"language": language, "client": "=1+1", "author": "@cmd", "site": "-2+3"},
        "wall": [
            {"name": "=cmd|'/c calc'!A1", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "both"},
            {
                "name": "general",
                "radius_m": 2.6,
                "slenderness_deg": 8.0,
                "inertia_over_mass_m2": 9.5,
                "base_z_m": 0.0,
                "mechanism": "two_sided",
            },
            {
                "name": "eq 7",
                "height_m": 4.0,
                "slenderness_deg": 7.0,
                "base_z_m": 0.0,
                "mechanism": "one_sided",
                "restitution": "one_sided_experimental",
            },
            {
                "name": "eq 5",
                "height_m": 4.0,
                "height_over_thickness": 9.0,
                "base_z_m": 0.0,
                "mechanism": "two_sided",
                "restitution": "sorrentino_experimental",
            },
        ],
        "record": [{"file": "r*.txt", "unit": "m/s2", "time_step_s": 0.01}],
        "analysis": {"q_step": 0.02},
        "demand": {"ag_g": 0.2, "soil_factor": 1.2},
    }
    result = study.run(parse_case({**table, **more}), base_dir=folder)
    return result, written(result)


def written(result):
    """The workbook of a result."""
    drawn = [entry for wall in result.walls if (entry := collapse_histories(result, wall))]
    return whole_workbook.build(result, drawn)


@pytest.fixture(scope="module")
def plain(folder):
    """The result of four walls, and its workbook."""
    return made(folder)


@pytest.fixture(scope="module")
def book(plain):
    return plain[1]


def formulas(book):
    """(sheet, cell) -> formula of the workbook."""
    return {
        (sheet.title, cell.coordinate): cell.value
        for sheet in book.workbook
        for row in sheet.iter_rows()
        for cell in row
        if cell.data_type == "f"
    }


@pytest.mark.shows("files.formulas")
def test_that_every_formula_carries_its_value_and_nothing_else_is_a_formula(book):
    assert set(formulas(book)) == set(book.cached)
    assert len(book.cached) > 100
    shown = openpyxl.load_workbook(BytesIO(book.content()), data_only=True)
    for (sheet, cell), value in book.cached.items():
        found = shown[sheet][cell].value
        assert ("" if found is None else found) == value


@pytest.mark.shows("files.formulas")
def test_that_formulas_stand_on_the_check_sheet_with_named_cells(book):
    found = formulas(book)
    assert {sheet for sheet, _ in found} == {
        "Summary",
        "Overview",
        "Check",
        "Dynamic check",
        "Results",
        "Spectral compatibility",
        "q against SI",
        "Histories",
        "Survival map",
    }
    beside = {place for place in found if place[0] in ("Results", "Histories", "Survival map")}
    assert {cell for _, cell in beside} == {"A1"}  # titles, which say when an input is changed
    names = set(book.workbook.defined_names)
    assert {"wall1_height", "wall1_a_rm", "demand_pga", "wall3_q_set"} <= names
    for formula in found.values():
        for word in re.findall(r"\b(?:wall\d+_\w+|demand_\w+|code_q|gravity)\b", formula):
            assert word in names


@pytest.fixture(scope="module")
def ntc(folder):
    """A hinge setback, one-sided, NTC 2018 spectrum, Italian, and a wall above the ground."""
    walls = [
        {
            "name": "a",
            "height_m": 5.0,
            "thickness_m": 0.6,
            "base_z_m": 0.0,
            "mechanism": "one_sided",
            "hinge_setback_m": 0.03,
            "length_m": 4.0,
            "unit_weight_kn_m3": 18.0,
        },
        {"name": "b", "height_m": 4.0, "thickness_m": 0.4, "mechanism": "two_sided", "base_z_m": 3.0},
        {
            "name": "d",
            "height_m": 3.0,
            "slenderness_deg": 8.5,
            "base_z_m": 0.0,
            "mechanism": "two_sided",
            "unit_weight_kn_m3": 18.0,
            "elastic_modulus_mpa": 600.0,
            "unloaded_confirmed": True,
        },
        {
            "name": "c",
            "radius_m": 2.6,
            "slenderness_deg": 8.0,
            "inertia_over_mass_m2": 9.5,
            "base_z_m": 0.0,
            "mechanism": "two_sided",
        },
    ]
    spectrum = {"code": "NTC2018", "f0": 2.4, "tc_star_s": 0.33, "soil": "C", "topography": "T2"}
    demand = {"ag_g": 0.2, "confidence_factor": 1.35, "limit_state": "SLC", "spectrum": spectrum}
    return made(folder, "it", wall=walls, demand=demand)[1]


@pytest.fixture(scope="module")
def height(folder):
    """Walls above the ground, restrained and free to vibrate, of a building."""
    own = {"base_z_m": 6.0, "unit_weight_kn_m3": 18.0, "elastic_modulus_mpa": 600.0}
    walls = [
        {"name": "top", "height_m": 3.0, "thickness_m": 0.45, "mechanism": "both", **own},
        {"name": "a", "height_m": 5.0, "thickness_m": 0.6, "base_z_m": 0.0, "mechanism": "one_sided"},
    ]
    spectrum = {"code": "EN1998", "type": 1, "soil": "B"}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    return made(folder, wall=walls, demand={"ag_g": 0.2, "spectrum": spectrum}, building=building)[1]


@pytest.fixture(scope="module")
def bodies(folder):
    """A gabled wall with openings and wedges, a stepped one that differs by side, one of oblique solids."""
    own = {"unit_weight_kn_m3": 18.0, "base_z_m": 0.0, "hinge_heights": "base"}
    coping = {"kind": "carried_mass", "kn_m": 2.0, "d_m": 0.2, "h_m": 5.0}
    door, rose = {"s_m": 2.0, "z_m": 0.0, "width_m": 1.2, "height_m": 2.2}, {"s_m": 3.0, "z_m": 4.0, "diameter_m": 1.0}
    corner = [
        {"plane": "oblique", "angle_deg": angle, "polygon_m": corners, "from_m": first, "to_m": first + 0.5}
        for angle, corners, first in (
            (45.0, [[0, 0], [3, 4], [0, 4]], 0.0),
            (-45.0, [[0.5, 0.666], [3, 4], [0.5, 4]], -0.5),
        )
    ]
    walls = [
        {"name": "facade", "mechanism": "one_sided", "height_m": 7.0, "thickness_m": 0.6, "length_m": 6.0,
         "gable_m": 2.0,
         "openings": [door, rose],
         "return_wedges": {"number": 2, "thickness_m": 0.4, "length_at_top_m": 1.0},
         **own},
        {"name": "pillar", "mechanism": "two_sided", "height_m": 5.0, "thickness_m": 0.6, "length_m": 2.0,
         "hinge_setback_m": 0.02,
         "steps": [{"from_z_m": 2.5, "thickness_m": 0.4}], "load": [coping], "elastic_modulus_mpa": 800.0, **own},
        {"name": "corner", "mechanism": "one_sided", "height_m": 4.0, "thickness_m": 0.5, "length_m": 4.0,
         "solid": corner, **own},
    ]  # fmt: skip
    return made(folder, wall=walls, demand={"ag_g": 0.12, "spectrum": {"code": "EN1998", "type": 1, "soil": "B"}})[1]


def test_that_a_body_has_its_solids_on_a_sheet_and_in_the_check(bodies, book):
    assert "Bodies" in bodies.workbook.sheetnames and "Bodies" not in book.workbook.sheetnames
    check = [cell.value for row in bodies.workbook["Check"].iter_rows() for cell in row]
    assert "=wall1_solid4_m" in check and "=wall2_solid2_i" in check
    sheets = bodies.workbook.sheetnames
    assert sheets.index("Bodies") == sheets.index("Check") + 1


@pytest.fixture(scope="module")
def held(folder):
    """Walls held at their top, with loads, a setback and neither, beside one that rocks."""
    top = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.1, "h_m": 3.0, "mass": "none"}
    own = {"height_m": 3.0, "thickness_m": 0.3, "unit_weight_kn_m3": 18.0, "mechanism": "vertical_bending"}
    walls = [
        {"name": "top", "base_z_m": 3.0, "load": [top, top | {"d_m": 0.2}], "hinge_setback_m": 0.01, **own},
        {"name": "bare", "base_z_m": 0.0, **own},
        {"name": "rocks", "height_m": 5.0, "thickness_m": 0.6, "base_z_m": 0.0, "mechanism": "one_sided"},
    ]
    spectrum = {"code": "EN1998", "type": 1, "soil": "B"}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    return made(folder, "it", wall=walls, demand={"ag_g": 0.2, "spectrum": spectrum}, building=building)[1]


@pytest.fixture(scope="module")
def arches(folder):
    """Walls between transverse walls, by masonry beyond and by a tie, with what pushes them and without."""
    own = {"height_m": 3.0, "thickness_m": 0.3, "unit_weight_kn_m3": 18.0, "mechanism": "horizontal_bending"}
    own |= {"compressive_strength_mpa": 2.0, "base_z_m": 0.0}
    beyond = {"spacing": 4.0, "shoulder_length_m": 3.0, "shoulder_thickness_m": 0.6}
    along, push = (
        {"tie_kn_m": 60.0, "tie_bar_length_m": 6.0, "tie_elongation_m": 0.02},
        {"kind": "thrust", "kn_m": 0.4, "h_m": 2.5},
    )
    pushing = {"kind": "vertical", "kn_m": 12.0, "d_m": 0.1, "h_m": 3.0, "mass": "horizontal"}
    walls = [
        {"name": "spans", "hold": between(**beyond), **own},
        {"name": "tied", "hold": between(**beyond, **along), "load": [push, pushing], **own},
    ]
    spectrum = {"code": "EN1998", "type": 1, "soil": "B"}
    building = {"height_m": 9.0, "storeys": 3, "period_s": 0.26}
    return made(folder, wall=walls, demand={"ag_g": 0.2, "spectrum": spectrum}, building=building)[1]


@pytest.fixture(scope="module")
def loads(folder):
    """Walls with every kind of load, hinge setback, return walls, tie, variants, hazard."""
    roof = {"kind": "vertical", "kn_m": 10.0, "d_m": 0.30, "h_m": 3.0, "mass": "none"}
    base = {
        "height_m": 3.0,
        "thickness_m": 0.45,
        "unit_weight_kn_m3": 18.0,
        "base_z_m": 0.0,
        "mechanism": "one_sided",
        "hold": [{"kind": "cross_walls"}],
    }
    across = {"number": 2, "thickness_m": 0.4, "brick_height_m": 0.2, "brick_length_m": 0.3}
    walls = [
        {
            **base,
            "name": "a",
            "variant": "stato di fatto",
            "hold": [*base["hold"], sought(2.8)],
            "load": [roof, {"kind": "thrust", "kn_m": 2.0, "h_m": 2.5, "d_m": 0.3}],
        },
        {
            **base,
            "name": "a",
            "variant": "progetto",
            "hinge_setback_m": 0.03,
            "return_walls": across,
            "length_m": 4.0,
            "load": [{**roof, "mass": "horizontal"}],
            "hold": [*base["hold"], {"kind": "tie", "out_kn_m": 3.0, "h_m": 2.8, "bar_length_m": 8.0}],
        },
        {
            **base,
            "name": "both sides",
            "mechanism": "two_sided",
            "elastic_modulus_mpa": 600.0,
            "load": [roof, {"kind": "carried_mass", "kn_m": 2.0, "d_m": 0.225, "h_m": 3.1}],
        },
    ]
    hazard = [{"return_period_years": y, "ag_g": a} for y, a in ((30, 0.08), (475, 0.2), (2475, 0.4))]
    demand = {
        "ag_g": 0.2,
        "spectrum": {"code": "EN1998", "soil": "B", "type": 1},
        "nominal_life_years": 50,
        "use_class_factor": 1.0,
        "hazard": hazard,
    }
    return made(folder, wall=walls, demand=demand)


def test_that_loads_are_on_every_sheet_that_a_reader_needs(loads):
    result, book = loads
    names = book.workbook.sheetnames
    assert names[:4] == ["Summary", "Risk", "How sure", "Input"]

    def words(name):
        return [str(cell.value) for row in book.workbook[name].iter_rows() for cell in row if cell.value]

    summary, risk = words("Summary"), words("Risk")
    assert any("a_g 0." in text for text in summary)
    assert any("vertical load, intensity 10" in text for text in words("Input"))
    assert sum(text in ("vertical load", "thrust", "tie", "carried mass") for text in words("Check")) == 6
    assert "Before and after" in risk and "Variants" not in risk
    assert any("loads" in text and "return walls" in text for text in risk)
    assert any("θc" in text for text in words("Method"))
    zetas = [w.assessment.verdict.zeta_e for w in result.walls]
    sheet = book.workbook["Risk"]
    assert min(zetas) in [cell.value for row in sheet.iter_rows() for cell in row]
    beside = [cell.value for cell in next(zip(*sheet["D4:D9"], strict=True))]
    found = [w.assessment for w in result.walls]
    sixteen = {a.dynamic.zeta_16 for a in found if a.verdict.governing == "dynamic"}
    assert beside[0] == "ζ_16" and sixteen and sixteen <= set(beside)


@pytest.mark.shows("paper.eq_16")
def test_that_no_closed_form_is_drawn_for_a_wall_with_loads(loads):
    """Eq. 15, 16 and Ribalta's law were fitted without loads."""
    sheet = loads[1].workbook["q against SI"]
    assert len(sheet._charts) == 0
    assert any("with loads" in str(cell.value) for row in sheet.iter_rows() for cell in row)


def test_that_every_load_is_an_arrow_at_its_place(loads):
    kinds = {load.kind for found in loads[0].walls for load in found.wall.load}
    assert kinds == set(field_of(Load, "kind").metadata["names"])
    wall = loads[0].walls[0].wall
    down, outward = arrows(wall, 3.0, 0.45)
    assert down[1] == (0.45 - 0.30, 3.0) and down[0][1] > 3.0
    assert outward[1] == (0.45 - 0.30, 2.5) and outward[0][0] < outward[1][0]
    (bar,) = tie_bars(loads[0].walls[1].wall, 3.0, 0.45)  # from behind the wall to its plate on the outer face
    assert bar[0][0] < 0.0 and bar[0][1] == bar[1][1] == 2.8 and {x for x, _ in bar[1:]} == {0.45}
    lengths = [abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in (down[:2], outward[:2])]
    assert lengths[0] > lengths[1]


def test_that_no_cell_shows_an_escaped_line_break(book, height, loads):
    for made in (book, height, loads[1]):
        for sheet in made.workbook:
            for row in sheet.iter_rows():
                for cell in row:
                    assert not (isinstance(cell.value, str) and "\\n" in cell.value), cell


def test_that_walls_above_the_ground_have_a_sheet_of_their_floors(height, book):
    assert "Floors" in height.workbook.sheetnames and "Floors" not in book.workbook.sheetnames
    sheet = height.workbook["Floors"]
    floors = [cell.value for cell in sheet["A"] if str(cell.value).startswith("z = ")]
    assert len(sheet._charts) == 2 and floors == ["z = 3 m", "z = 6 m"]  # "a" turns at the first storey's end as well
    shown = [cell.value for row in height.workbook["Check"].iter_rows() for cell in row]
    assert "PFA [g]" in shown and any("wall at 6 m" in str(value) for value in shown)


BOOKS = ("book", "ntc", "height", "held", "arches", "loads", "bodies")


@pytest.fixture(scope="module")
def books(request):
    """The workbooks above by their names."""
    found = {name: request.getfixturevalue(name) for name in BOOKS}
    return found | {"loads": found["loads"][1]}


@pytest.fixture(scope="module")
def recalculated(books, tmp_path_factory):
    """Folder of these workbooks as one start of LibreOffice computes them."""
    office = shutil.which("soffice") or shutil.which("libreoffice")
    if not office:
        pytest.skip("LibreOffice is not installed: formulas were not recalculated")
    place, bare = tmp_path_factory.mktemp("office"), []
    for name, book in books.items():
        bare.append(place / f"{name}.xlsx")
        book.workbook.save(bare[-1])  # without the values: LibreOffice would trust them
        assert b"<v>" not in _formula_cells(bare[-1])
    subprocess.run(
        [
            office,
            "--headless",
            f"-env:UserInstallation=file://{place}/profile",
            "--convert-to",
            "xlsx:Calc MS Excel 2007 XML",
            "--outdir",
            place / "out",
            *bare,
        ],
        check=True,
        capture_output=True,
        timeout=180,
    )
    return place / "out"


@pytest.mark.shows("files.formulas")
@pytest.mark.parametrize("which", BOOKS)
def test_that_libreoffice_recalculates_every_formula_to_the_programs_value(which, books, recalculated):
    book, shown = books[which], openpyxl.load_workbook(recalculated / f"{which}.xlsx", data_only=True)
    assert book.cached
    for (sheet, cell), value in book.cached.items():
        found = shown[sheet][cell].value
        if isinstance(value, str):
            assert (found or "") == value, (sheet, cell)
        else:
            # C1, C2 and R2 are sums over logarithms: their conditioning costs a digit
            assert found == pytest.approx(value, rel=1e-12, abs=1e-13), (sheet, cell)


def _formula_cells(path) -> bytes:
    with zipfile.ZipFile(path) as archive:
        sheets = [name for name in archive.namelist() if "worksheets/sheet" in name]
        text = b"".join(archive.read(name) for name in sheets)
    return b"".join(re.findall(rb"<c [^>]*><f>.*?</c>", text))


@pytest.mark.shows("files.no_formula_of_a_user")
def test_that_user_text_never_becomes_a_formula(book):
    wanted = {HOSTILE, "=1+1", "@cmd", "-2+3", "=cmd|'/c calc'!A1"}
    seen = set()
    for sheet in openpyxl.load_workbook(BytesIO(book.content())):
        for row in sheet.iter_rows():
            for cell in row:
                if cell.value in wanted:
                    assert cell.data_type == "s"
                    seen.add(cell.value)
    assert seen == wanted


@pytest.mark.shows("files.sheets")
def test_that_the_sheets_are_those_of_the_contract(plain, book):
    assert book.workbook.sheetnames == [
        "Summary",
        "Overview",
        "Input",
        "Records",
        "Results",
        "Check",
        "Dynamic check",
        "Spectral compatibility",
        "q against SI",
        "Histories",
        "Survival map",
        "Method",
    ]
    case = plain[0].case
    italian = written(replace(plain[0], case=replace(case, report=replace(case.report, language="it"))))
    assert italian.workbook.sheetnames[:5] == ["Sintesi", "Riepilogo", "Dati", "Accelerogrammi", "Risultati"]
    text = " ".join(
        str(cell.value)
        for sheet in italian.workbook
        for row in sheet.iter_rows()
        for cell in row
        if isinstance(cell.value, str)
    )
    for english in ("Warnings", "two-sided", "passed", "collapse found", "Ground"):
        assert english not in text


@pytest.mark.shows("files.sheets")
def test_that_a_sheet_in_italian_says_nothing_in_english(ntc):
    text = " ".join(
        str(cell.value)
        for sheet in ntc.workbook
        for row in sheet.iter_rows()
        for cell in row
        if isinstance(cell.value, str)
    )
    for english in ("Verified", "passed", "stable", "Capacity", "mean spectrum", "overturns"):
        assert english not in text


def test_that_displayed_numbers_are_the_results(plain):
    result, book = plain
    sheet = book.workbook["Results"]
    rows = list(sheet.iter_rows(min_row=4, max_row=3 + sum(len(w.runs) for w in result.walls)))
    runs = [run for wall in result.walls for run in wall.runs]
    for row, run in zip(rows, runs, strict=True):
        assert row[5].value == run.ida.q
        assert (row[9].value, row[11].value) == (run.ida.q_slv_robust, run.ida.q_robust)
        assert row[12].value == run.scale
    heads, values, *_ = book.workbook["Records"].iter_rows(min_row=3, values_only=True)
    assert dict(zip(heads, values, strict=True))["PGA [g]"] == result.motions[0].pga / 9.80665


@pytest.mark.shows("files.words_for_nan")
def test_that_a_wall_without_number_shows_words_not_nan(folder):
    result, book = made(folder, wall=[STANDING], analysis={"q_step": 0.05, "q_limit": 1.5})
    assert result.walls[0].q_set is None
    content = openpyxl.load_workbook(BytesIO(book.content()))
    values = [c.value for s in content for row in s.iter_rows() for c in row]
    assert "no number" in values and "no collapse found" in values
    for value in values:
        assert not isinstance(value, float) or math.isfinite(value)


def test_that_a_case_without_records_or_demand_still_makes_every_sheet(folder):
    for more in ({"record": []}, {"record": [], "demand": {"ag_g": 0.2}}):
        table = {"record": [], **more}
        if "demand" not in more:
            table["demand"] = {"ag_g": 0.1, "housner_intensity_cm": 60.0}
        _, book = made(folder, **table)
        assert len(book.workbook.sheetnames) == 12
        openpyxl.load_workbook(BytesIO(book.content()))


def test_that_two_hundred_walls_fit_the_one_page_summary(folder, reference):
    walls = [
        {"name": f"wall {k}", "height_m": 5.0, "thickness_m": 0.5, "base_z_m": 0.0, "mechanism": "two_sided"}
        for k in range(200)
    ]
    _, book = made(folder, wall=walls, record=[])
    summary = book.workbook["Summary"]
    assert summary.page_setup.fitToHeight == 1 == summary.page_setup.fitToWidth
    assert summary.max_row < 60
    assert len(list(book.workbook["Overview"].iter_rows(min_row=4))) == 200
    assert "wall199_height" in book.workbook.defined_names


def test_that_no_merged_range_is_compared_with_the_others_and_none_overlap(plain, monkeypatch):
    """A comparison with all ranges before makes a large report quadratic."""
    from openpyxl.worksheet.cell_range import MultiCellRange

    monkeypatch.setattr(MultiCellRange, "__contains__", lambda *_: pytest.fail("compared"))
    for sheet in written(plain[0]).workbook:
        cells = [cell for area in sheet.merged_cells.ranges for cell in area.cells]
        assert len(cells) == len(set(cells)), sheet.title


@pytest.mark.long
def test_that_the_writing_tells_how_far_it_is_and_may_be_cancelled_between_its_parts(plain, tmp_path):
    result = plain[0]
    told, asked = [], []
    export.write(result, tmp_path, "c", lambda: asked.append(1), tell=lambda *state: told.append(state))
    done = [at for at, planned in told]
    assert done == sorted(set(done)) and done[0] == 0 and done[-1] >= 95
    assert {planned for _, planned in told} == {100}
    sheets = openpyxl.load_workbook(tmp_path / "c.xlsx", read_only=True).sheetnames
    assert len(asked) > 2 * (len(result.walls) + len(sheets))  # each wall and sheet, made and then saved
    # wherever it is cancelled, nothing is written and no temporary file stays
    target, temporary = tmp_path / "none", set(os.listdir(tempfile.gettempdir()))
    target.mkdir()
    for last in range(0, len(asked), len(asked) // 25):
        left = iter(range(last))

        def check(left=left):
            if next(left, None) is None:
                raise Cancelled

        with pytest.raises(Cancelled):
            export.write(result, target, "c", check)
        assert list(target.iterdir()) == []
    new = set(os.listdir(tempfile.gettempdir())) - temporary
    assert [name for name in new if name.startswith("openpyxl.")] == []


def test_that_thinning_keeps_the_peaks():
    from core.report.plots import thinned

    values = np.zeros(100_000)
    values[[7, 50_123, 99_999]] = (3.0, -5.0, 1.0)
    chosen = thinned(values, 1500)
    assert len(chosen) <= 1501
    assert {7, 50_123, 99_999} <= set(chosen)
    assert chosen == sorted(set(chosen))


def test_that_the_input_is_in_words_and_says_what_the_user_did_not_write(verdict):
    """A value of a table of walls is no default."""
    sheet = Book("it")
    sheet.workbook.remove(sheet.workbook.active)
    inputs(sheet, verdict)
    rows = [[cell.value or None for cell in row] for row in sheet.workbook["Dati"].iter_rows(min_row=3)]
    assert ["Altezza", 7.0, "m", "tabella delle pareti"] in rows
    assert ["Fattore di confidenza FC", 1.35, None, "predefinito"] in rows
    assert ["a_g su suolo rigido", 0.2, "g", None] in rows
    heading = [row[0] for row in rows].index("Il caso come è stato analizzato")  # below it stands the file itself
    words = " ".join(str(cell) for row in rows[:heading] for cell in row if cell)
    assert "_m" not in words and "demand" not in words
