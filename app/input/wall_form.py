"""A wall: geometry, mechanism, what it carries, what holds it, hinges, impact and law; its drawing to scale."""

import math
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QGuiApplication
from PySide6.QtWidgets import QFileDialog, QGridLayout, QMessageBox, QToolButton, QVBoxLayout, QWidget

from app.input.body_form import BodyForm
from app.input.drawn_values import DrawnValues
from app.input.editors import Choice
from app.input.evidence_form import EvidenceForm
from app.input.fields import Field, clear_fields, connect
from app.input.hinges_field import HingesField
from app.input.holds_form import HoldsForm
from app.input.impact_form import ImpactForm
from app.input.loads_form import LoadsForm
from app.input.made_fields import make_field, make_fields
from app.input.optional_group import OptionalGroup
from app.input.set_aside_form import SetAsideForm
from app.input.wall_editor import WallEditor
from app.input.wall_text import (
    add_building_loads,
    contents_of,
    convert_shape_keys,
    deciding_hinge,
    differences,
    estimate_lines,
    hinge_zetas,
    input_questions,
    shape_of,
    unused_history_sections,
)
from app.look import theme
from app.look.case_views import CaseViews
from app.look.drawing import DRAGGED, WallDrawing, mechanism_icon
from app.look.labels import PlainLabel, escape_html
from app.look.language import FORM_NAMES, current_language, describe_message, number, quoted_from_file, result_word, tr
from app.look.section import FoldingSection, unfold_to
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.loads import ReturnWalls
from core.case.solids import InPlan
from core.case.values import check_value
from core.case.variant_names import AS_IS, DESIGNED
from core.case.wall import Wall, find_mechanism
from core.case.wall_table import parse_wall_rows, read_table, text_rows
from core.codes.masonry_types import TYPES
from core.codes.vertical_bending import bending, uplift_multiplier
from core.errors import InputError
from core.known import require_value
from core.units import G
from core.wall.kinematics import ARCHES, BENDS, MECHANISMS, kinematics
from core.wall.restitution import MODELS

IN_A_ROW = 400
"""Width that buttons of a row may take together [px]: larger letters have two rows."""

BASE_KEYS = "base_z_m", "base_friction"
"""Keys beside the mechanism."""


class WallForm(WallEditor):
    """Edits one wall of the session at a time; `current` is its row. selected(row) : another is shown; told(words) :
    what was done"""

    selected = Signal(int)
    told = Signal(str)

    def __init__(self, session: Session):
        super().__init__(session, lambda: self.current)
        self.row = 0
        self.shown: tuple[Wall | None, int] = (None, 0)
        self.former: tuple[Wall | None, Wall | None] = (None, None)
        self.drawing = WallDrawing()
        self.drawing.picked.connect(self._picked_in_drawing)
        self.drawing.moved.connect(self._moved_in_drawing)
        self.drawn = DrawnValues(self.drawing, self._field_in_drawing)
        self.summary = PlainLabel()
        self.summary.setWordWrap(True)
        self.differs = PlainLabel()
        self.differs.setWordWrap(True)
        self.impact = ImpactForm(session, lambda: self.current)
        self.holds = HoldsForm(session, lambda: self.current)
        self.loads = LoadsForm(session, lambda: self.current)
        self.set_aside = SetAsideForm(session, lambda: self.current)
        self.body = BodyForm(session, lambda: self.current)
        self.evidence = EvidenceForm(session, lambda: self.current)
        self.shape_fields = make_fields(Wall, "shape")
        check_fields = make_fields(Wall, "checks", first=BASE_KEYS)
        held = make_fields(Wall, "held")
        every = (make_field(Wall, "name"), *self.shape_fields, *check_fields, *held)
        self.fields = {field.key: field for field in every}
        connect(list(self.fields.values()), self._changed)
        self._make_shape()
        self.mechanisms = {}
        empty = ReturnWalls(TO_BE_GIVEN, TO_BE_GIVEN, TO_BE_GIVEN, TO_BE_GIVEN)
        title = tr("Friction of return walls (in α0 only)")
        self.across = OptionalGroup(title, "return_walls", empty, lambda: self.wall, self.edit)
        title, given = tr("Place in the key plan"), [TO_BE_GIVEN] * 4
        self.plan = OptionalGroup(title, "plan", InPlan(*given), lambda: self.wall, self.edit)
        base = [self.fields[key] for key in BASE_KEYS]
        notes = [field for field in check_fields if field.key not in (*BASE_KEYS, "unloaded_confirmed")]
        self.sections = {
            "geometry": FoldingSection(
                tr("Geometry"), [self.fields["name"], self.shape, *self.shape_fields], open=True
            ),
            "body": FoldingSection(tr("Shape"), [self.body]),
            "mechanism": FoldingSection(tr("Mechanism and base"), [self._mechanism(), *base], open=True),
            "holds": FoldingSection(tr("What holds it"), [self.holds], open=True),
            "loads": FoldingSection(tr("Loads"), [self.fields["unloaded_confirmed"], self.loads]),
            "held": FoldingSection(tr("Return walls"), [self.across]),
            "hinges": FoldingSection(tr("Hinges"), [self.fields["hinge_heights"], self.set_aside]),
            "impact": FoldingSection(tr("Restitution and law"), [self.impact]),
            "evidence": FoldingSection(tr("Evidence"), [self.evidence]),
            "notes": FoldingSection(
                tr("Material, variant, notes"), [*notes, self.fields["variant"], self.differs, self.plan]
            ),
        }
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        for section in self.sections.values():
            layout.addWidget(section)
        layout.addStretch(1)
        self.parts = CaseViews(
            self,
            self._show_row,
            self._show_sizes,
            self._show_fields,
            self.impact.show_case,
            self.holds.show_case,
            self.loads.show_case,
            self.set_aside.show_case,
            self.across.show_case,
            self.plan.show_case,
            self.body.show_case,
            self.evidence.show_case,
            self._show_contents,
            self.drawn.follow,
        )

    # building

    def _make_shape(self) -> None:
        """By which sizes the block is given."""
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

    def _mechanism(self) -> QWidget:
        group = QWidget()
        grid = QGridLayout(group)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(4)
        tips = {
            "two_sided": tr("Free on both faces: rocks to both sides"),
            "one_sided": tr("A restraint behind: rocks outwards only"),
            "both": tr("Two results: with the restraint behind and without"),
            BENDS: tr("Held at its top, free to rise there: bends outward and inward as two blocks"),
            ARCHES: tr("Held at both ends by transverse walls: spans between them as a flat arch"),
        }
        for name, kind in MECHANISMS.items():
            label, tip, button = result_word(name), tips.get(name, ""), QToolButton()
            button.setIcon(mechanism_icon(name))
            button.setIconSize(QSize(44, 44))
            lines = label.split(" ") if kind.bends else [label]
            button.setText("\n".join(lines))
            button.setToolTip(escape_html(tip))
            button.setAccessibleName(label)
            FORM_NAMES.captions[name] = FORM_NAMES.captions[f"mechanism={name}"] = label
            button.setCheckable(True)
            chosen = theme.current.curves[0]
            button.setStyleSheet(f"QToolButton:checked {{ border: 3px solid {chosen}; font-weight: 700; }}")
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
            bold = QFont(button.font())
            bold.setBold(True)
            widest = max(QFontMetrics(bold).horizontalAdvance(line) for line in lines)
            button.setMinimumWidth(widest + 10)  # chosen it is bold
            button.clicked.connect(lambda _, name=name: self._mechanism_chosen(name))
            self.mechanisms[name] = button
        in_a_row = 5 if sum(mechanism.sizeHint().width() for mechanism in self.mechanisms.values()) < IN_A_ROW else 3
        for k, button in enumerate(self.mechanisms.values()):
            grid.addWidget(button, *divmod(k, in_a_row))
        grid.setColumnStretch(in_a_row, 1)
        return group

    # showing

    @property
    def current(self) -> int:
        return max(0, min(self.row, len(self.session.case.wall) - 1))

    def select(self, row: int) -> None:
        """Show the wall of this row."""
        if row == self.row:
            return
        self.row = row
        self.forget()
        self.show_case()
        self.selected.emit(self.current)

    def forget(self) -> None:
        """Another wall: nothing that was typed or switched off in the last one stays."""
        for field in self.findChildren(Field):
            field.forget()
        for group in self.findChildren(OptionalGroup):
            group.forget()
        self.body.forget()
        self.drawn.close()
        self.former, self.shown = (None, None), (None, 0)

    def show_case(self) -> None:
        """Fill the form from the session."""
        self.parts.show()

    def _show_row(self) -> None:
        walls, known, count = self.session.case.wall, *self.shown
        if known is not None and len(walls) != count:  # the same wall, in another place
            ways = (lambda one: one == known, lambda one: one.title == known.title, lambda one: one.name == known.name)
            alike = ((k for k, one in enumerate(walls) if way(one)) for way in ways)
            self.row = next((k for matches in alike for k in matches), self.row)
        self.row = self.current
        self.shown = (self.wall, len(walls))
        for section in self.sections.values():
            section.setEnabled(self.wall is not None)

    def _show_sizes(self) -> None:
        wall = self.wall
        k = self.current
        marks = (hinge_zetas(self.session, k), deciding_hinge(self.session, k)) if wall else ([], None)
        self.drawing.show_wall(add_building_loads(self.session.case, wall), *marks)
        if wall is not None:
            self._show_geometry(wall)
            return
        self._show_shape("thickness_m", False)
        self.shape.setCurrentIndex(-1)
        self.summary.setText(tr("No wall yet: + wall below the tree."))

    def _show_fields(self) -> None:
        wall, case = self.wall, self.session.case
        shown = wall.mechanism if wall is not None else ""
        if wall is not None and not shown and (case.demand or case.site):
            shown = find_mechanism(wall, case.wall)
        for name, button in self.mechanisms.items():
            button.setChecked(shown == name)
        if wall is None:
            clear_fields(list(self.fields.values()))
            return
        for field in self.fields.values():
            field.show_value(getattr(wall, field.key))
            if isinstance(field, HingesField):
                field.show_usual(wall, self.session.case.building)
        # only what the mechanism needs, and what stands there all the same
        self.fields["unloaded_confirmed"].setVisible(not wall.load or wall.unloaded_confirmed)
        self.fields["base_friction"].setVisible(wall.bends or wall.base_friction is not None or bool(wall.restraints))
        self.fields["elastic_modulus_mpa"].setVisible(not wall.bends or wall.elastic_modulus_mpa is not None)
        for name, said in unused_history_sections(wall).items():
            self.sections[name].setVisible(not wall.bends or said)
        doubts = input_questions(wall)
        for field in (*self.fields.values(), *self.holds.fields, *self.loads.fields, *self.set_aside.fields):
            field.show_doubt(doubts.get(field.key, ""))

    def _show_contents(self) -> None:
        """What each section holds, in its head."""
        whole = add_building_loads(self.session.case, self.wall)
        words = contents_of(whole) if whole else {}
        lines = differences(self.session.case, self.wall) if self.wall else []
        self.differs.setText("\n".join([tr("Beside the wall as it is:"), *lines]) if lines else "")
        for name, section in self.sections.items():
            section.say(words.get(name, ""))

    def _show_geometry(self, wall: Wall) -> None:
        shape = shape_of(wall)
        self.shape.setCurrentIndex(self.shape.findData(shape))
        self._show_shape(shape, wall.compressive_strength_mpa is not None)
        try:
            block = wall.block()
            a = G * uplift_multiplier(wall.in_si, wall.mechanisms()[0])
        except InputError as error:
            self.summary.setText(describe_message(error))
            return
        except TypeError:  # a size is still to be given
            self.summary.setText("")
            return
        lines = [f"α {number(math.degrees(block.slenderness), '.2f')}°"]
        if wall.thickness and wall.height_m:
            lines.append(f"H/t {number(wall.height_m / wall.thickness, '.2f')}")
        if wall.height_m and wall.setback:
            lines.append(f"u {number(100 * wall.setback, '.1f')} cm")
        lines.append(f"{'α0 g' if wall.bends else 'a_RM'} {number(a / G, '.3f')} g = {number(a, '.2f')} m/s²")
        if wall.bends:
            lines += [] if wall.arch else [f"h₁ {number(bending(wall.in_si).h1, '.2f')} m"]
            self.summary.setText("   ".join(lines))
            return
        lines.append(f"R {number(block.radius, '.3f')} m, p {number(block.frequency_parameter, '.3f')} rad/s")
        lines += estimate_lines(self.session, wall)
        self.summary.setText("   ".join(lines))

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
            if field.key == "masonry" and value and self.wall.unit_weight_kn_m3 is None:
                least, greatest = TYPES[value].weight
                values["unit_weight_kn_m3"] = least if least == greatest else None
            self.edit(field.key, **values)

    def _shape_chosen(self, index: int) -> None:
        """Write the same block in another way."""
        wall, shape = self.wall, self.shape.itemData(index)
        if wall is None or shape == shape_of(wall):
            return
        before, after = self.former
        if before is not None and wall == after:
            wall = before  # the way back from a general block rounds nothing and holds_invalid_text the setback
        try:
            block = wall.block()
        except (InputError, TypeError):
            self.show_case()
            return
        values = convert_shape_keys(shape, wall, block)
        for key, value in values.items():
            if reason := self._refused(key, value):
                self.show_case()
                self.told.emit(tr("The shape stays as it is given. {reason}", reason=reason))
                return
        self.edit(**values)
        self.former = (wall, self.wall) if shape == "general" else (None, None)

    def _refused(self, key: str, value: float | None) -> str:
        """Why no case can have a size, "" where it can."""
        field = self.fields[key]
        try:
            if value is not None:
                check_value(Wall, key, value)
        except InputError as error:
            size = (
                f"{field.caption.text()} = {number(require_value(value) * field.factor, '.5g')} {field.unit}".rstrip()
            )
            accepted = error.accepted_text(current_language(), FORM_NAMES)
            return tr("{size} is not accepted: {accepted}", size=size, accepted=accepted)
        return ""

    def _mechanism_chosen(self, name: str) -> None:
        wall = require_value(self.wall)
        values: dict[str, Any] = {"mechanism": name}
        if not kinematics(name).one_way and wall.restitution and MODELS[wall.restitution].one_sided:
            values["restitution"] = None
        self.edit(**values)
        self.show_case()

    def _picked_in_drawing(self, kind: str, k: int) -> None:
        """What was clicked in the drawing: its field."""
        self._field_in_drawing(kind, k).editor.setFocus()

    def _field_in_drawing(self, kind: str, k: int) -> Field:
        """The field of what is drawn, in front."""
        if kind == "load" and self.wall is not None and k >= len(self.wall.load):  # of a floor
            kind = "height"
        if kind in DRAGGED:
            {"load": self.loads, "hold": self.holds}[kind].list.setCurrentRow(k)
        heights = [field for field in self.holds.fields if field.key in ("h_m", "to_m")]
        field = {
            "load": self.loads.fields[1],
            "hold": next((field for field in heights if not field.isHidden()), self.fields["name"]),
            "hinge": self.fields["hinge_heights"],
            "height": next((field for field in self.shape_fields if not field.isHidden()), self.fields["name"]),
            "thickness": next((field for field in self.shape_fields[1:] if not field.isHidden()), self.fields["name"]),
        }[kind]
        unfold_to(field)
        return field

    def _moved_in_drawing(self, kind: str, k: int, height: float) -> None:
        """A load or a hold was dragged to another height."""
        if self.wall is None or k >= len(entries := getattr(self.wall, kind)) or height <= 0.0:
            return
        key = "to_m" if kind == "hold" and not entries[k].has_height else "h_m"
        moved = tuple(replace(entry, **{key: height}) if n == k else entry for n, entry in enumerate(entries))
        self.edit(kind, k, key, **{kind: moved})

    def add(self) -> None:
        self.session.add_walls([Wall(tr("wall"), "")])  # mechanism and sizes are to be given
        self.select(len(self.session.case.wall) - 1)

    def duplicate(self) -> None:
        """A copy of the wall: of one as it is, the variant of the design."""
        if self.wall is not None:
            variant = DESIGNED if self.wall.variant == AS_IS else self.wall.variant
            self.session.add_walls([replace(self.wall, variant=variant)])
            self.select(len(self.session.case.wall) - 1)

    def add_variant(self) -> None:
        """The wall as it is and, beside it, the same wall to be changed: before and after."""
        wall, k = self.wall, self.current
        if wall is None:
            return
        walls = list(self.session.case.wall)
        there = {one.variant: row for row, one in enumerate(walls) if one.name == wall.name}
        made = [replace(wall, variant=one) for one in (AS_IS, DESIGNED) if there.get(one, k) == k]
        if made:
            walls[k : k + 1] = made
            self.session.edit(replace(self.session.case, wall=tuple(walls)))
        self.select(next(row for row, one in enumerate(walls) if (one.name, one.variant) == (wall.name, DESIGNED)))

    def delete(self) -> None:
        if self.wall is not None:
            self.forget()
            self.session.remove_wall(self.current)

    def paste(self) -> None:
        text = QGuiApplication.clipboard().text()
        self._take(lambda: parse_wall_rows(text_rows(text), self.session.case.demand is not None))

    def load_table(self) -> None:
        from pathlib import Path

        name, _ = QFileDialog.getOpenFileName(
            self, tr("Read walls"), str(self.session.base_dir), tr("Tables") + " (*.xlsx *.csv)"
        )
        if name:
            notes = []

            def read():
                walls, notices, *_ = read_table(Path(name), self.session.case.demand is not None)
                notes.extend(notices)
                return walls

            self._take(read)
            if len(notes) > 1:
                lines = "\n".join(note.text(current_language()) for note in notes)
                QMessageBox.information(self, tr("Read walls"), escape_html(lines))

    def _take(self, read) -> None:
        try:
            walls = read()
        except InputError as error:
            QMessageBox.warning(self, tr("Walls not read"), escape_html(quoted_from_file(error)))
            return
        first = len(self.session.case.wall)
        self.session.add_walls(walls)
        self.select(first)
        self.told.emit(tr("Walls added: {n}", n=len(walls)))
