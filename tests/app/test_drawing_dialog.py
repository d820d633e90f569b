"""A wall from a drawing in the window: clicks, keys, hinge, preview, sentences, what OK writes."""

import random

import pytest

pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
pytest.importorskip("ezdxf", reason="without the group dxf")
pytest.importorskip("shapely", reason="no wheel of shapely")

import ezdxf
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QDialog, QDialogButtonBox, QFileDialog, QLineEdit, QMessageBox

from app.input.drawing_canvas import BODY, NO_PART, OPENING
from app.input.drawing_dialog import DrawingDialog
from app.input.wall_form import WallForm
from app.look.language import set_language
from core.case.reader import read_case
from core.case.wall import Wall
from tests.core.case import sheets
from tests.core.case.test_drawing_file import area_of, sheet, written
from tests.fuzz.fuzz import changed, drawing

EMPTY = Wall("w", "one_sided", unit_weight_kn_m3=20.0)


@pytest.fixture
def dialog(application, tmp_path):
    made = []

    def opened(path, wall=EMPTY):
        made.append(DrawingDialog(path, wall))
        made[-1].show()
        return made[-1]

    yield opened
    for one in made:
        one.close()
        one.deleteLater()
    set_language("en")


def wait():
    QTest.qWait(1)


def click(dialog, x, y):
    """A click at a point of the drawing."""
    at = dialog.canvas.at(x, y)
    QTest.mouseClick(dialog.canvas, Qt.MouseButton.LeftButton, pos=QPoint(round(at.x()), round(at.y())))
    wait()


def give(field, text):
    field.editor.setFocus()
    field.editor.selectAll()
    QTest.keyClicks(field.editor, text)
    wait()


def ok(dialog):
    return dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)


def test_that_the_church_is_a_wall_after_its_thickness_and_its_hinge(dialog, tmp_path):
    path, body, openings = sheets.church(tmp_path / "church.dxf")
    shown = dialog(path)
    roles = dict(zip([(s.layer, len(s.corners)) for s in shown.sheet.shapes], shown.roles, strict=True))
    assert [role for (layer, _), role in roles.items() if layer == "MURATURA"] == [BODY]
    assert sorted(shown.roles) == sorted([BODY, *4 * [OPENING], *2 * [NO_PART]])  # the hatch, the inner ring
    assert not ok(shown).isEnabled() and "How thick" in shown.words.text()
    give(shown.fields["to_m"], "0.6")
    assert ok(shown).isEnabled()
    give(shown.fields["hinge_y_m"], "12.5")
    read = body.difference(openings)
    assert area_of(shown.made.solid).area == pytest.approx(read.area, abs=0.03)
    assert f"M {0.6 * area_of(shown.made.solid).area * 20 / 9.80665:.2f} t (20 kN/m³)" in shown.words.text()
    assert f"z_G {area_of(shown.made.solid).centroid.y:.3f} m" in shown.words.text()
    assert (shown.made.height_m, shown.made.thickness_m, shown.made.length_m) == (11.0, 0.6, 9.0)


def test_that_a_click_cycles_what_a_shape_is_and_the_list_does_so_by_keys(dialog, tmp_path):
    shown = dialog(sheets.church(tmp_path / "church.dxf")[0])
    give(shown.fields["to_m"], "0.6")
    rose = next(k for k, s in enumerate(shown.sheet.shapes) if s.layer == "ROSONE" and shown.roles[k] == OPENING)
    full = area_of(shown.made.solid).area
    click(shown, 4500 + 800, 12500 + 6500)
    assert shown.roles[rose] == NO_PART and area_of(shown.made.solid).area > full + 4.0
    click(shown, 4500 + 800, 12500 + 6500)
    assert shown.roles[rose] == BODY and "overlap" in shown.words.text() and ok(shown).isEnabled()
    shown.list.setFocus()
    shown.list.setCurrentRow(rose)
    button = shown.buttons_of_roles[OPENING]
    assert button.isEnabled()
    button.setFocus()
    QTest.keyClick(button, Qt.Key.Key_Space)
    wait()
    assert shown.roles[rose] == OPENING and area_of(shown.made.solid).area == pytest.approx(full)
    assert shown.list.item(rose).text().endswith("Opening")
    body = shown.roles.index(BODY)
    shown._give(NO_PART)
    shown.roles[body] = NO_PART
    shown.show_wall()
    assert shown.made is None and not ok(shown).isEnabled() and "Click the shape" in shown.words.text()


def test_that_the_hinge_line_is_dragged_and_a_movement_elsewhere_moves_the_sheet(dialog, tmp_path):
    shown = dialog(sheets.church(tmp_path / "church.dxf")[0])
    give(shown.fields["to_m"], "0.6")
    height = shown.made.height_m
    before, after = (shown.canvas.at(1000.0, y) for y in (12500.0 - 800.0, 12500.0 + 2000.0))
    points = [QPoint(round(at.x()), round(at.y())) for at in (before, after)]
    QTest.mousePress(shown.canvas, Qt.MouseButton.LeftButton, pos=points[0])
    QTest.mouseMove(shown.canvas, points[1])
    shown.canvas.hinge_moved.emit(shown.canvas._point(QPointF(points[1]))[1])
    QTest.mouseRelease(shown.canvas, Qt.MouseButton.LeftButton, pos=points[1])
    wait()
    assert height - shown.made.height_m == pytest.approx(2.8, abs=0.1)
    assert float(shown.fields["hinge_y_m"].editor.text()) == pytest.approx(14.5, abs=0.1)
    roles = list(shown.roles)
    QTest.mousePress(shown.canvas, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    QTest.mouseRelease(shown.canvas, Qt.MouseButton.LeftButton, pos=QPoint(45, 30))
    assert shown.roles == roles and shown.canvas.shift == QPointF(40, 25)


def test_that_the_unit_is_asked_for_where_the_drawing_says_none(dialog, tmp_path):
    shown = dialog(sheets.palace(tmp_path / "palace.dxf")[0])
    give(shown.fields["to_m"], "0.5")
    assert not ok(shown).isEnabled() and "does not say its unit" in shown.words.text() and "cm" in shown.words.text()
    for unit, words in (("m", "the likely unit is cm"), ("mm", "L 1.20 m"), ("cm", "L 12.00 m")):
        shown.fields["unit"].edited.emit(unit)
        wait()
        assert words in shown.words.text()
    assert ok(shown).isEnabled() and sum(solid.opening for solid in shown.made.solid) == 4


def test_that_a_section_lies_from_its_outer_face_and_open_outlines_are_said(dialog, tmp_path):
    shown = dialog(sheets.nave(tmp_path / "nave.dxf")[0])
    shown.fields["unit"].edited.emit("m")
    shown.fields["plane"].edited.emit("section")
    give(shown.fields["to_m"], "5")
    click(shown, 20.3, 4.0) if shown.roles[0] != BODY else click(shown, 20.2, 10.0)
    for k in range(2):
        shown.roles[k] = BODY
    shown.show_wall()
    assert (shown.made.height_m, shown.made.thickness_m, shown.made.length_m) == pytest.approx((8.6, 0.9, 5.0))
    assert "Open outlines, marked by crosses: 1" in shown.words.text() and "layer VOLTA" in shown.words.text()


def test_that_shapes_without_an_area_and_a_sheet_without_shapes_are_no_wall(dialog, tmp_path):
    def level(space):
        space.add_lwpolyline([(0, 0), (5, 0), (3, 0)], close=True)

    for draw in (level, lambda space: None):
        shown = dialog(sheet(tmp_path / "d.dxf", draw))
        give(shown.fields["to_m"], "0.5")
        assert shown.made is None and not ok(shown).isEnabled() and shown.words.text()


def test_that_sizes_a_wall_has_stay_where_the_box_is_not_ticked(dialog, tmp_path):
    path = sheets.church(tmp_path / "church.dxf")[0]
    wall = Wall("w", "one_sided", height_m=9.0, slenderness_deg=5.0, length_m=8.0, gable_m=2.0)
    shown = dialog(path, wall)
    assert not shown.sizes.isChecked() and "18 kN/m³" in shown.words.text()
    assert (shown.made.height_m, shown.made.slenderness_deg, shown.made.length_m) == (9.0, 5.0, 8.0)
    assert shown.made.gable_m is None and shown.made.thickness_m is None
    shown.sizes.click()
    wait()
    made = shown.made
    assert (made.height_m, made.slenderness_deg, made.length_m) == (11.8, None, 9.0)
    assert made.thickness_m == pytest.approx(wall.thickness, abs=1e-6)


@pytest.mark.parametrize(
    ("content", "words"), [(b"", "damaged"), (b"AC1032...", "save it as DXF"), (b"0\nSECTION\n", "damaged")]
)
def test_that_a_file_that_is_no_drawing_is_a_sentence_in_the_dialog(dialog, tmp_path, content, words):
    (tmp_path / "x.dxf").write_bytes(content)
    for language in ("it", "en"):
        set_language(language)
        shown = dialog(tmp_path / "x.dxf")
        assert not ok(shown).isEnabled() and shown.words.text()
    assert words in shown.words.text()


@pytest.mark.parametrize("seeds", [range(8), pytest.param(range(8, 300), marks=pytest.mark.long)], ids=str)
def test_that_a_damaged_drawing_is_a_sentence_or_a_sheet_one_can_click_through(dialog, tmp_path, seeds):
    good = [drawing()]
    for seed in seeds:
        (tmp_path / "x.dxf").write_bytes(changed(random.Random(seed), good))
        shown = dialog(tmp_path / "x.dxf")
        middle = QPoint(shown.canvas.width() // 2, shown.canvas.height() // 2)
        QTest.mouseClick(shown.canvas, Qt.MouseButton.LeftButton, pos=middle)
        assert shown.words.text() or shown.sheet.shapes, seed


def test_that_every_control_has_a_name_and_is_reached_by_tab(dialog, tmp_path):
    shown = dialog(sheets.church(tmp_path / "church.dxf")[0])
    kinds = (QAbstractButton, QLineEdit, QComboBox)
    controls = [shown.list, *(one for kind in kinds for one in shown.findChildren(kind) if one.isVisible())]
    assert len(controls) >= 12
    for control in controls:
        name = control.accessibleName() or getattr(control, "text", str)()
        assert name, control
        assert control.focusPolicy() & Qt.FocusPolicy.TabFocus or not control.isEnabled(), control
    assert shown.canvas.accessibleName()


@pytest.mark.shows("window.from_drawing")
def test_that_ok_writes_the_solids_into_the_wall_and_undo_takes_them_back(opened, tmp_path, monkeypatch):
    path = sheets.church(tmp_path / "church.dxf")[0]
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    seen = []

    def run(self):
        give(self.fields["to_m"], "0,6")
        give(self.fields["hinge_y_m"], "12,5")
        seen.append(self.made)
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(DrawingDialog, "exec", run)
    form = opened.findChild(WallForm)
    before = opened.session.case
    button = next(b for b in form.findChildren(QAbstractButton) if b.text() == "From a drawing…")
    button.click()
    (made,) = seen
    assert opened.session.case.wall[0] == made and made.solid and made.name == before.wall[0].name
    opened.session.undo()
    assert opened.session.case == before
    monkeypatch.setattr(DrawingDialog, "exec", lambda self: QDialog.DialogCode.Rejected)
    button.click()
    assert opened.session.case == before


@pytest.mark.shows("window.from_drawing")
def test_that_opening_a_case_takes_its_drawings_over_and_says_so(opened, tmp_path, monkeypatch):
    """As solids, which are what is saved; of a draft too; a drawing that cannot be read is said with its reason."""
    said = []
    monkeypatch.setattr(QMessageBox, "information", lambda *words: said.append(words[-1]))
    case, _ = written(tmp_path, "church")
    assert opened.files.open(case)
    assert opened.session.case.wall == read_case(case).wall and not opened.session.case.drawings
    assert "1 solids and 4 openings are from the drawing church.dxf" in said[0] and "--batch" in said[0]
    opened.session.save(tmp_path / "saved.toml")
    assert "drawing" not in (tmp_path / "saved.toml").read_text()
    assert read_case(tmp_path / "saved.toml").wall == read_case(case).wall
    draft = tmp_path / "draft.toml"
    draft.write_text(case.read_text().replace("height_m = 10.9\n", ""))
    assert opened.files.open(draft)
    assert len(opened.session.case.wall[0].solid) == 5 and len(said) == 2
    sheet(tmp_path / "church.dxf", lambda space: None)
    assert opened.files.open(case)
    assert "there is no layer MURATURA" in said[2] and opened.session.case.wall[0].drawing
    assert any("church.dxf has not been read" in str(problem) for problem in opened.session.problems())


def test_that_a_click_between_lines_finds_the_outline_and_names_the_gaps_it_closed(dialog, tmp_path):
    """A facade of lines, as they are drawn: ends 5 and 12 mm short, a window and a line that leads nowhere."""
    document = ezdxf.new("R2010", units=6)
    space = document.modelspace()
    for start, end in (
        ((0, 0), (9, 0)),
        ((9, 0.005), (9, 8)),
        ((9, 8), (4.5, 11)),
        ((4.5, 11), (0, 8)),
        ((0, 7.988), (0, 0)),
        ((6, 3), (7, 3)),
    ):
        space.add_line(start, end, dxfattribs={"layer": "LINEE"})
    space.add_lwpolyline([(3, 2), (4, 2), (4, 4), (3, 4)], close=True, dxfattribs={"layer": "LINEE"})
    document.saveas(tmp_path / "lines.dxf")
    shown = dialog(tmp_path / "lines.dxf")
    shown.roles = [NO_PART for _ in shown.roles]
    click(shown, 8.0, 5.0)
    assert shown.roles[-2:] == [BODY, OPENING]
    give(shown.fields["to_m"], "0.6")
    assert area_of(shown.made.solid).area == pytest.approx(72.0 + 13.5 - 2.0, abs=0.1)
    assert "Gaps closed between lines, up to 20 mm: 2, the largest 12.0 mm" in shown.words.text()
    click(shown, 20.0, 20.0)
    assert "no outline closes" in shown.words.text()
