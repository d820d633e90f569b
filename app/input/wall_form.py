"""The walls: list, geometry with a drawing to scale, mechanism, restitution, law."""

import math
from dataclasses import replace

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QFileDialog,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QMessageBox,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.input.fields import Choice, Field, connect
from app.input.impact_form import ImpactForm
from app.input.loads_form import LoadsForm
from app.input.made_fields import make_field, make_fields
from app.input.reasons_form import reasons_of_wall
from app.input.wall_words import estimate_lines, hinge_zetas, shape_of, written_as
from app.look.drawing import WallDrawing, mechanism_icon
from app.look.language import FORM_NAMES, current_language, described, named, number, quoted_from_file, tr
from app.look.parts import Parts
from app.work.session import Session
from core.case.schema import AS_IS, DESIGNED, Wall
from core.case.wall_table import read_table, text_rows, walls_of
from core.errors import InputError
from core.units import G
from core.wall.restitution import MODELS


class WallForm(QWidget):
    """Edits one wall of the session at a time; `current` is its index."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.showing = False
        self.listed: list[str] = []
        self.former: tuple[Wall | None, Wall | None] = (None, None)
        self.list = QListWidget()
        self.list.setMaximumHeight(84)
        self.list.setAccessibleName(tr("Walls"))
        self.list.currentRowChanged.connect(self._selected)
        self.drawing = WallDrawing()
        self.summary = QLabel()
        self.summary.setWordWrap(True)
        self.problem = QLabel()
        self.impact = ImpactForm(session, lambda: self.current)
        self.loads = LoadsForm(session, lambda: self.current)
        self.reasons = reasons_of_wall(session, lambda: self.current)
        self.shape_fields = make_fields(Wall, "shape")
        checks = ("base_z_m", "free_element", "elastic_modulus_mpa", "unit_weight_kn_m3", "length_m")
        self.check_fields = make_fields(Wall, "checks", first=checks)
        self.fields = {field.key: field for field in (make_field(Wall, "name"), *self.shape_fields, *self.check_fields)}
        connect(list(self.fields.values()), self._changed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addLayout(self._buttons())
        layout.addWidget(self.list)
        layout.addWidget(self._geometry())
        layout.addWidget(self._mechanism())
        layout.addWidget(self.impact)
        layout.addWidget(self.loads)
        layout.addWidget(self._more())
        layout.addWidget(self.reasons)
        layout.addStretch(1)
        self.parts = Parts(
            self,
            self._show_list,
            self._show_sizes,
            self._show_fields,
            self.impact.show_case,
            self.loads.show_case,
            self.reasons.show_case,
        )

    # building

    def _buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        for label, tip, slot in (
            (tr("Add"), tr("Add a wall"), self.add),
            (tr("Duplicate"), tr("Copy this wall"), self.duplicate),
            (tr("Delete"), tr("Delete this wall"), self.delete),
            (tr("Paste"), tr("Paste rows copied from Excel"), self.paste),
            (tr("Table…"), tr("Read walls from .xlsx or .csv"), self.load_table),
        ):
            button = QToolButton()
            button.setText(label)
            button.setToolTip(tip)
            button.clicked.connect(slot)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            row.addWidget(button)
        row.setSpacing(3)
        return row

    def _geometry(self) -> QGroupBox:
        group = QGroupBox(tr("Geometry"))
        row = QHBoxLayout(group)
        column = QVBoxLayout()
        self.shape = Choice()
        self.shape.setAccessibleName(tr("Geometry given by"))
        for name, shown in (
            ("thickness_m", tr("height and thickness")),
            ("slenderness_deg", tr("height and slenderness")),
            ("height_over_thickness", tr("height and H/t")),
            ("general", tr("general block")),
        ):
            self.shape.addItem(shown, name)
        self.shape.activated.connect(self._shape_chosen)
        for widget in (self.fields["name"], self.shape, *self.shape_fields, self.summary):
            column.addWidget(widget)
        column.addStretch(1)
        row.addLayout(column, 3)
        row.addWidget(self.drawing, 2)
        return group

    def _mechanism(self) -> QGroupBox:
        group = QGroupBox(tr("Mechanism"))
        row = QHBoxLayout(group)
        self.mechanisms = {}
        for name, label, tip in (
            ("two_sided", named("two_sided"), tr("Free on both faces: rocks to both sides")),
            ("one_sided", named("one_sided"), tr("A restraint behind: rocks outwards only")),
            ("both", named("both"), tr("Two results: with the restraint behind and without")),
        ):
            button = QToolButton()
            button.setIcon(mechanism_icon(name))
            button.setIconSize(QSize(52, 52))
            button.setText(label)
            button.setToolTip(tip)
            button.setAccessibleName(label)
            FORM_NAMES.captions[name] = label
            button.setCheckable(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
            button.clicked.connect(lambda _, name=name: self._mechanism_chosen(name))
            self.mechanisms[name] = button
            row.addWidget(button)
        row.addStretch(1)
        return group

    def _more(self) -> QGroupBox:
        group = QGroupBox(tr("For checks and report"))
        column = QVBoxLayout(group)
        for field in self.check_fields:
            column.addWidget(field)
        return group

    # showing

    @property
    def current(self) -> int:
        return max(0, self.list.currentRow())

    @property
    def wall(self) -> Wall | None:
        walls = self.session.case.wall
        return walls[self.current] if self.current < len(walls) else None

    def _selected(self, row: int) -> None:
        if not self.showing:
            for field in self.findChildren(Field):
                field.forget()
            self.show_case()

    def show_case(self) -> None:
        """Fill the form from the session."""
        self.parts.show()

    def _show_list(self) -> None:
        self.showing = True
        walls = self.session.case.wall
        row = min(self.current, max(0, len(walls) - 1))
        names = [wall.title for wall in walls]
        if names != self.listed:
            self.listed = names
            self.list.clear()
            self.list.addItems(names)
        self.list.setCurrentRow(row if walls else -1)
        self.showing = False
        self.setProperty("empty", self.wall is None)
        for group in self.findChildren(QGroupBox):
            group.setEnabled(self.wall is not None)

    def _show_sizes(self) -> None:
        wall = self.wall
        self.drawing.show_wall(wall, hinge_zetas(self.session, self.current) if wall else [])
        if wall is not None:
            self._show_geometry(wall)
            return
        self._show_shape("thickness_m", False)
        self.summary.setText(tr("No wall yet: press Add."))

    def _show_fields(self) -> None:
        wall = self.wall
        if wall is None:
            return
        for name, button in self.mechanisms.items():
            button.setChecked(wall.mechanism == name)
        for field in self.fields.values():
            field.show_value(getattr(wall, field.key))

    def _show_geometry(self, wall: Wall) -> None:
        shape = shape_of(wall)
        self.shape.setCurrentIndex(self.shape.findData(shape))
        self._show_shape(shape, wall.compressive_strength_mpa is not None)
        try:
            block = wall.block()
            a = G * wall.uplift_multiplier(wall.mechanisms()[0])
        except InputError as error:
            self.summary.setText(described(error))
            return
        except TypeError:  # a size is still to be given
            self.summary.setText("")
            return
        lines = [f"α {number(math.degrees(block.slenderness), '.2f')}°"]
        if wall.thickness:
            lines.append(f"H/t {number(wall.height_m / wall.thickness, '.2f')}")
        if wall.height_m and wall.setback:
            lines.append(f"u {number(100 * wall.setback, '.1f')} cm")
        lines.append(f"a_RM {number(a / G, '.3f')} g = {number(a, '.2f')} m/s²")
        lines.append(f"R {number(block.radius, '.3f')} m, p {number(block.frequency_parameter, '.3f')} rad/s")
        lines += estimate_lines(self.session, wall)
        self.summary.setText("\n".join(lines))

    def _show_shape(self, shape: str, setback_follows: bool) -> None:
        """The fields that give this shape."""
        shown = ("slenderness_deg", "radius_m", "inertia_over_mass_m2") if shape == "general" else ("height_m", shape)
        for field in self.shape_fields:
            field.setVisible(field.key in shown)
        self.fields["hinge_setback_m"].setVisible(shape != "general" and not setback_follows)

    # changes

    def _changed(self, field, value) -> None:
        if self.wall is not None:
            values = {field.key: value}
            if field.key == "compressive_strength_mpa" and value is not None:
                values["hinge_setback_m"] = 0.0  # it follows from the strength: its field is hidden
            self.session.edit_wall(self.current, ("wall", self.current, field.key), **values)

    def _shape_chosen(self, index: int) -> None:
        """Write the same block in another way."""
        wall, shape = self.wall, self.shape.itemData(index)
        if wall is None or shape == shape_of(wall):
            return
        before, after = self.former
        if wall == after:
            wall = before  # the way back from a general block rounds nothing and holds_invalid_text the setback
        try:
            block = wall.block()
        except (InputError, TypeError):
            self.show_case()
            return
        self.session.edit_wall(self.current, **written_as(shape, wall, block))
        self.former = (wall, self.wall) if shape == "general" else (None, None)

    def _mechanism_chosen(self, name: str) -> None:
        wall = self.wall
        values = {"mechanism": name}
        if name != "one_sided" and wall.restitution and MODELS[wall.restitution].one_sided:
            values["restitution"] = None
        self.session.edit_wall(self.current, **values)
        self.show_case()

    def add(self) -> None:
        self.session.add_walls([Wall(tr("wall"), "", height_m=4.0, thickness_m=0.4)])
        self.list.setCurrentRow(len(self.session.case.wall) - 1)

    def duplicate(self) -> None:
        if self.wall is not None:
            variant = DESIGNED if self.wall.variant == AS_IS else self.wall.variant
            self.session.add_walls([replace(self.wall, variant=variant)])
            self.list.setCurrentRow(len(self.session.case.wall) - 1)

    def delete(self) -> None:
        if self.wall is not None:
            self.session.remove_wall(self.current)

    def paste(self) -> None:
        text = QGuiApplication.clipboard().text()
        self._take(lambda: walls_of(text_rows(text), self.session.case.demand is not None))

    def load_table(self) -> None:
        from pathlib import Path

        name, _ = QFileDialog.getOpenFileName(
            self, tr("Read walls"), str(self.session.base_dir), tr("Tables") + " (*.xlsx *.csv)"
        )
        if name:
            notes = []

            def read():
                walls, notices = read_table(Path(name), self.session.case.demand is not None)
                notes.extend(notices)
                return walls

            self._take(read)
            if len(notes) > 1:
                lines = "\n".join(note.text(current_language()) for note in notes)
                QMessageBox.information(self, tr("Read walls"), lines)

    def _take(self, read) -> None:
        try:
            walls = read()
        except InputError as error:
            QMessageBox.warning(self, tr("Walls not read"), quoted_from_file(error))
            return
        self.session.add_walls(walls)
