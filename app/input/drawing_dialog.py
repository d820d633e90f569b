"""A wall from a drawing: its shapes, what each is, where the hinge is; solids for the wall."""

from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSignalBlocker, QSize, QTimer
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QListWidget,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.input.drawing_canvas import BODY, NO_PART, OPENING, ROLES, DrawingCanvas
from app.input.fields import LineField, connect
from app.input.made_fields import make_field
from app.look import theme
from app.look.dialogs import delete_after_use
from app.look.labels import PlainLabel
from app.look.language import describe_message, number, tr
from app.work.session import Session
from core.case.drawing_file import DRAWING_TOLERANCE, DRAWING_UNITS, DxfFile, Shape, Sheet
from core.case.drawn_solids import made_solids, origin_of, replace_solids, sum_of_solids
from core.case.outline_inside import find_enclosing_outline
from core.case.shape_rules import check_shape
from core.case.solids import Drawing
from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.wall.body import contains_point, point_within, polygon_sums

MAX_GAP = 0.02
"""How far the end of a line may be from the line it should meet, in an outline around a click [m]."""

MAX_UNREAD_SHOWN = 8
"""Kinds of entities that are not read, named in the dialog."""

DEFAULT_UNIT_WEIGHT = 18.0
"""What a wall without a unit weight is taken to weigh, for the mass that is shown [kN/m3]."""

MAX_SHAPES = 2000
"""Shapes of a drawing that are looked at for what they may be: of more none is."""


def likely_roles(shapes: tuple[Shape, ...]) -> list[str]:
    """The largest shape is the body, what lies in it an opening unless it lies in another one, the rest nothing."""
    areas = [polygon_sums(shape.corners).area for shape in shapes]
    if not shapes or len(shapes) > MAX_SHAPES:
        return [NO_PART] * len(shapes)
    roles, largest = [NO_PART] * len(shapes), max(range(len(shapes)), key=lambda k: areas[k])
    roles[largest], openings = BODY, []
    for k in sorted(range(len(shapes)), key=lambda k: -areas[k]):
        if k == largest or areas[k] > 0.9 * areas[largest]:  # a hatch of the wall
            continue
        inside = point_within(shapes[k].corners)
        if contains_point(shapes[largest].corners, inside) and not any(
            contains_point(shapes[n].corners, inside) for n in openings
        ):
            openings.append(k)
            roles[k] = OPENING
    return roles


class DrawingDialog(QDialog):
    """Shows the shapes of a file; `made` is the wall of those chosen, None while there is none."""

    def __init__(self, path: Path, wall: Wall, parent: QWidget | None = None):
        super().__init__(parent)
        self.setWindowTitle(tr("Wall from the drawing {name}", name=path.name))
        self.wall = wall
        self.made: Wall | None = None
        self.file: DxfFile | None = None
        self.failure = ""
        self.closed: list[float] = []
        self.sheet = Sheet((), (), (), (), None, "m")
        self.roles: list[str] = []
        self.areas: list[float] = []
        self.asked: dict[str, Any] = {"unit": None, "plane": "elevation", "from_m": 0.0, "to_m": wall.thickness}
        self.asked["hinge_y_m"] = None
        self.canvas = DrawingCanvas()
        self.canvas.clicked.connect(self._next_role)
        self.canvas.asked_around.connect(self._around)
        self.canvas.hinge_moved.connect(self._drag_hinge)
        self.list = QListWidget()
        self.list.setAccessibleName(tr("Shapes"))
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.itemSelectionChanged.connect(self._show_roles)
        self.names = {BODY: tr("Body"), OPENING: tr("Opening"), NO_PART: tr("Nothing")}
        self.buttons_of_roles = {role: QPushButton(name) for role, name in self.names.items()}
        choices = QHBoxLayout()
        for role, button in self.buttons_of_roles.items():
            button.setAutoDefault(False)
            button.clicked.connect(lambda _=False, role=role: self._give(role))
            choices.addWidget(button)
        self.fields = {key: make_field(Drawing, key) for key in self.asked}
        connect(list(self.fields.values()), self._changed)
        hinge = self.fields["hinge_y_m"]
        assert isinstance(hinge, LineField)
        hinge.editor.setPlaceholderText(tr("lowest point"))
        for field in self.fields.values():
            field.judged.connect(self._judge)
        self.sizes = QCheckBox(tr("Height, base and length of the wall from here too"))
        self.sizes.setChecked(not wall.has_shape)
        self.sizes.toggled.connect(self._later)
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        self.words.setMinimumHeight(4 * self.fontMetrics().height())
        ok, cancel = QDialogButtonBox.StandardButton.Ok, QDialogButtonBox.StandardButton.Cancel
        self.buttons = QDialogButtonBox(ok | cancel)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        right = QVBoxLayout()
        right.addWidget(self.list, 1)
        right.addLayout(choices)
        for widget in (*self.fields.values(), self.sizes):
            right.addWidget(widget)
        row = QHBoxLayout()
        row.addWidget(self.canvas, 3)
        row.addLayout(right, 2)
        layout = QVBoxLayout(self)
        layout.addLayout(row, 1)
        layout.addWidget(self.words)
        layout.addWidget(self.buttons)
        self.resize(QSize(980, 640))
        self.timer = QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self.show_wall)
        try:
            self.file = DxfFile(path)
        except InputError as error:
            self.failure = describe_message(error)
        self._read()

    def _read(self) -> None:
        """The shapes in the unit asked for; they keep what they are where they are the same."""
        if self.file is not None:
            try:
                self.sheet = self.file.sheet(self.asked["unit"])
            except InputError as error:
                self.failure = describe_message(error)
        if len(self.roles) != len(self.sheet.shapes):
            self.roles = likely_roles(self.sheet.shapes)
        self.areas = [self.scale**2 * polygon_sums(shape.corners).area for shape in self.sheet.shapes]
        with QSignalBlocker(self.list):
            self.list.clear()
            self.list.addItems([""] * len(self.roles))
        self.canvas.show_sheet(self.sheet)
        self._show_roles()
        self.show_wall()

    @property
    def scale(self) -> float:
        """How long the unit of the drawing is [m]."""
        return DRAWING_UNITS[self.sheet.unit]

    @property
    def hinge(self) -> float | None:
        """y of the hinge in the drawing, as given or the lowest point of the body."""
        if self.asked["hinge_y_m"] is not None:
            return self.asked["hinge_y_m"] / self.scale
        return min((shape.extent[1] for shape in self._of(BODY)), default=None)

    def _of(self, role: str) -> list[Shape]:
        return [shape for shape, own in zip(self.sheet.shapes, self.roles, strict=True) if own == role]

    def _show_roles(self) -> None:
        chosen = {index.row() for index in self.list.selectedIndexes()}
        for k, (shape, role) in enumerate(zip(self.sheet.shapes, self.roles, strict=True)):
            self.list.item(k).setText(f"{shape.layer}, {number(self.areas[k], '.3g')} m²: {self.names[role]}")
        for button in self.buttons_of_roles.values():
            button.setEnabled(bool(chosen))
        self.canvas.show_roles(self.roles, chosen, self.hinge)

    # changes

    def _next_role(self, k: int) -> None:
        """What was clicked becomes the next thing."""
        self.roles[k] = ROLES[(ROLES.index(self.roles[k]) + 1) % len(ROLES)]
        self.list.setCurrentRow(k)
        self._later()

    def _around(self, x: float, y: float) -> None:
        """The outline around a place between lines becomes a shape of the wall, what stands apart in it openings."""
        close, same = MAX_GAP / self.scale, DRAWING_TOLERANCE / self.scale
        try:
            region = find_enclosing_outline(self.sheet.lines, (x, y), close, same)
        except InputError as error:
            self.words.setText(describe_message(error))
            return
        made = [Shape(region.layer, corners) for corners in (region.outline, *region.holes)]
        left = [gap for gap in self.sheet.gaps if gap.at not in {one.at for one in region.closed}]
        self.sheet = self.sheet._replace(shapes=(*self.sheet.shapes, *made), gaps=tuple(left))
        self.roles += [BODY, *(OPENING for _ in region.holes)]
        self.areas += [self.scale**2 * polygon_sums(shape.corners).area for shape in made]
        self.closed += [self.scale * gap.size for gap in region.closed]
        with QSignalBlocker(self.list):
            self.list.addItems([""] * len(made))
        self.canvas.show_shapes(self.sheet)
        self._later()

    def _give(self, role: str) -> None:
        """The shapes marked in the list become this."""
        for index in self.list.selectedIndexes():
            self.roles[index.row()] = role
        self._later()

    def _changed(self, field, value) -> None:
        self.asked[field.key] = value
        if field.key == "unit":
            self._read()
        self._later()

    def _drag_hinge(self, y: float) -> None:
        self.asked["hinge_y_m"] = round(y * self.scale, 3)
        self._later()

    def _later(self) -> None:
        """The wall anew, once after all that moves at a time."""
        self.timer.start(0)

    # the wall

    def show_wall(self) -> None:
        """The wall of what is chosen, its mass and centroid; else the sentence why there is none."""
        for key, field in self.fields.items():
            field.show_value(self.asked[key])
        self._show_roles()
        self.made, words, wrong = None, "", self._lacking()
        if not wrong:
            try:
                self.made = self._wall()
                words = self._preview(self.made)
                check_shape(replace(self.made, unit_weight_kn_m3=self.weight))
            except InputError as error:  # a rule with the rest of the wall may be met in its form
                wrong = describe_message(error)
        self.words.setText(
            "\n".join(part for part in (words, wrong, self._gaps_closed(), self._open_outlines()) if part)
        )
        self.words.setStyleSheet(f"color: {theme.current.bad};" if wrong else "")
        self._judge()

    def _judge(self) -> None:
        """No OK without a wall, or while a field holds what is not in it."""
        ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setEnabled(self.made is not None and not any(field.wrong for field in self.fields.values()))

    def _lacking(self) -> str:
        """What is still to be said, or why the file cannot be read."""
        if self.failure:
            return self.failure
        if self.sheet.stated is None and self.asked["unit"] is None:
            return describe_message(InputError("drawing_unit", key="unit", likely=self.sheet.unit))
        if not self._of(BODY):
            return tr("Click the shape that is the wall.")
        if self.asked["to_m"] is None:
            return tr("How thick is it? From and to, from the outer face inward.")
        return ""

    @property
    def weight(self) -> float:
        """[kN/m3]"""
        return self.wall.unit_weight_kn_m3 or DEFAULT_UNIT_WEIGHT

    def _wall(self) -> Wall:
        """The wall of the shapes chosen. Raises InputError."""
        asked = self.asked
        ends = (asked["from_m"] or 0.0, asked["to_m"])
        shapes = self._of(BODY), self._of(OPENING)
        origin = origin_of(shapes[0], self.sheet.unit, asked["plane"], asked["hinge_y_m"])
        made = made_solids(*shapes, self.sheet.unit, asked["plane"], ends, origin)
        return replace_solids(self.wall, made, self.sizes.isChecked())

    def _preview(self, wall: Wall) -> str:
        area, body = sum_of_solids(wall.solid, self.weight)
        x, z = body.centroid
        properties = [
            tr("area {area} m²", area=number(area, ".2f")),
            f"M {number(body.mass / 1000.0, '.2f')} t ({number(self.weight, 'g')} kN/m³)",
            f"x_G {number(x, '.3f')} m, z_G {number(z, '.3f')} m",
            f"H {number(wall.height_m, '.2f')} m, t {number(100.0 * require_value(wall.thickness), '.1f')} cm, "
            f"L {number(wall.length_m, '.2f')} m",
        ]
        return "   ".join(properties)

    def _gaps_closed(self) -> str:
        """The gaps that outlines between lines have closed."""
        if not self.closed:
            return ""
        return tr(
            "Gaps closed between lines, up to {most} mm: {n}, the largest {mm} mm.",
            most=number(1e3 * MAX_GAP, "g"),
            n=len(self.closed),
            mm=number(1e3 * max(self.closed), ".1f"),
        )

    def _not_read(self) -> str:
        """What the drawing holds besides and is not read: areas and references first."""
        unread = sorted(self.sheet.unread, key=lambda one: not one.is_ground)
        return tr("Not read: {left}.", left=", ".join(map(str, unread[:MAX_UNREAD_SHOWN]))) if unread else ""

    def _open_outlines(self) -> str:
        if not self.sheet.gaps:
            return self._not_read()
        gap = min(self.sheet.gaps, key=lambda one: one.size)
        x, y = (number(self.scale * value, ".3f") for value in gap.at)
        return tr(
            "Open outlines, marked by crosses: {n}; one by {mm} mm at x = {x} m, y = {y} m, layer {layer}.",
            n=len(self.sheet.gaps),
            mm=number(1e3 * self.scale * gap.size, ".0f"),
            x=x,
            y=y,
            layer=gap.layer,
        )


def take_from_drawing(session: Session, index: Callable[[], int], parent: QWidget) -> None:
    """Ask for a drawing, and for what of it are the solids of a wall of the form."""
    walls = session.case.wall
    name, _ = QFileDialog.getOpenFileName(
        parent, tr("Take a wall from a drawing"), str(session.base_dir), "DXF (*.dxf)"
    )
    if not name or not walls:
        return
    row, wall = index(), walls[index()]
    with delete_after_use(DrawingDialog(Path(name), wall, parent)) as dialog:
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        made = dialog.made if accepted else None
    if made is not None:
        values = {entry.name: getattr(made, entry.name) for entry in fields(Wall)}
        session.edit_wall(row, **{key: value for key, value in values.items() if value != getattr(wall, key)})
