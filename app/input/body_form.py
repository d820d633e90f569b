"""The shape of a wall that is no rectangle: gable, openings, steps, wedges of the return walls, solids."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QPushButton, QToolButton, QVBoxLayout, QWidget

from app.input.editors import Line
from app.input.entries_form import EntriesForm
from app.input.fields import Field, clear_fields, connect
from app.input.made_fields import make_fields
from app.input.optional_group import OptionalGroup
from app.input.wall_editor import WallEditor
from app.look.labels import PlainLabel
from app.look.language import FORM_NAMES, current_language, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.number import parse_number
from core.case.solids import Corner, Leaf, Opening, Solid, Step, Wedges
from core.case.wall import Wall
from core.errors import InputError
from core.text.sentence import choice
from core.units import CM

OPENING_SIZES = ("width_m", "height_m", "diameter_m")
"""What an opening is given by."""


def drawing_button(session: Session, index: Callable[[], int]) -> QToolButton:
    """The button that takes the solids of a wall from a drawing."""
    button = QToolButton()
    button.setText(tr("From a drawing…"))
    button.setAccessibleName(tr("From a drawing…"))
    button.setToolTip(tr("Closed shapes of a DXF file become the solids of this wall"))

    def ask() -> None:
        from app.input.drawing_dialog import take_from_drawing

        take_from_drawing(session, index, button)

    button.clicked.connect(ask)
    return button


def _m(value) -> str:
    """A length of the case [m], – where it is still to be given."""
    return "–" if value in (None, "") else number(value, "g")


def opening_words(opening: Opening) -> str:
    """An opening in the list."""
    if opening.diameter_m is None:
        size = f"{_m(opening.width_m)} × {_m(opening.height_m)}"
    else:
        size = f"⌀ {_m(opening.diameter_m)}"
    return f"{size} m, s {_m(opening.s_m)}, z {_m(opening.z_m)} m"


def step_words(step: Step) -> str:
    """A step in the list."""
    thick = "–" if step.thickness_m in (None, "") else number(step.thickness_m / CM, "g")
    return tr("{t} cm from z {z} m", t=thick, z=_m(step.from_z_m))


def solid_words(solid: Solid) -> str:
    """A solid in the list."""
    plane = choice(solid.plane, current_language()) if solid.plane else "–"
    what = tr("{plane}, {n} corners, {first} to {last} m", plane=plane, n=len(solid.polygon_m or ()),
              first=_m(solid.from_m), last=_m(solid.to_m))  # fmt: skip
    return f"− {what}" if solid.opening else what


def _opening_has(opening: Opening, key: str) -> bool:
    """Whether an opening of this shape has this key; one without a size may have any."""
    given = [size for size in OPENING_SIZES if getattr(opening, size) is not None]
    if key not in OPENING_SIZES or not given:
        return True
    return (key == "diameter_m") == ("diameter_m" in given) or key in given


def _first_solid(wall: Wall) -> Solid:
    """A solid to be drawn; the first of a wall is the wall."""
    rectangle: tuple = ()
    if not wall.solid and wall.height_m and wall.length_m:
        length, height = wall.length_m, wall.height_m
        rectangle = ((0.0, 0.0), (length, 0.0), (length, height), (0.0, height))
    return Solid("elevation", rectangle, wall.thickness or TO_BE_GIVEN)


class BodyForm(WallEditor):
    """Edits what makes the wall at `index()` another shape than a rectangle."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index)
        self.gable_fields = make_fields(Wall, "body")
        connect(self.gable_fields, lambda field, value: self.edit(field.key, **{field.key: value}))
        empty: dict[str, Any] = {"s_m": TO_BE_GIVEN, "z_m": TO_BE_GIVEN}
        self.openings = EntriesForm(
            session,
            index,
            "openings",
            {
                tr("Rectangle"): lambda wall: Opening(**empty, width_m=TO_BE_GIVEN, height_m=TO_BE_GIVEN),
                tr("Circle"): lambda wall: Opening(**empty, diameter_m=TO_BE_GIVEN),
            },
            opening_words,
            _opening_has,
            lead="width_m",
        )
        new_step = {tr("Add"): lambda wall: Step(TO_BE_GIVEN, TO_BE_GIVEN)}
        self.steps = EntriesForm(session, index, "steps", new_step, step_words)
        self.solids = EntriesForm(
            session,
            index,
            "solid",
            {tr("Add"): _first_solid},
            solid_words,
            lambda solid, key: key != "angle_deg" or solid.plane == "oblique" or solid.angle_deg is not None,
            first=("plane", "angle_deg", "polygon_m", "from_m", "to_m", "x0_m", "unit_weight_kn_m3", "opening"),
        )
        self.lists = (self.openings, self.steps, self.solids)
        for entries, title in zip(self.lists, (tr("Openings"), tr("Steps"), tr("Solids")), strict=True):
            entries.set_title(title)
            FORM_NAMES.add(entries.key, title)
        self.solids.buttons.addWidget(drawing_button(session, index))
        for key in ("return_wedges", "[wall.return_wedges]"):
            FORM_NAMES.add(key, tr("Wedges of return walls, dragged along"))
        self._make_wedges()
        title, given = tr("Corner of two walls that turn together"), [TO_BE_GIVEN] * 3
        self.corner = OptionalGroup(title, "corner", Corner(*given), lambda: self.wall, self.edit)
        title = tr("Outer leaf that comes off")
        self.leaf = OptionalGroup(title, "leaf", Leaf(TO_BE_GIVEN), lambda: self.wall, self.edit)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        groups = self.wedges, self.corner, self.leaf
        for widget in (*self.gable_fields, self.openings, self.steps, *groups, self.solids):
            column.addWidget(widget)
        self.forget()

    def forget(self) -> None:
        """Another wall: no brick of the last one comes back in this."""
        self.brick_length.clear()
        self.brick_height.clear()

    def _make_wedges(self) -> None:
        """The wedges, and a length of theirs from the bricks, which a button fills in."""
        title, empty = tr("Wedges of return walls, dragged along"), Wedges(TO_BE_GIVEN, TO_BE_GIVEN, TO_BE_GIVEN)
        self.wedges = OptionalGroup(title, "return_wedges", empty, lambda: self.wall, self.edit)
        for field in self.wedges.fields:
            field.inside = lambda problem, field=field: self._names(problem, field)
        self.bricks = QWidget()
        grid = QGridLayout(self.bricks)
        grid.setContentsMargins(0, 0, 0, 0)
        words = PlainLabel(tr("Crack from the bricks: tan = length/(2 height)"))
        words.setWordWrap(True)
        grid.addWidget(words, 0, 0, 1, 3)
        self.brick_length, self.brick_height = (Line(lambda: False, lambda: None) for _ in range(2))
        lines = ((self.brick_length, tr("Brick length")), (self.brick_height, tr("Brick height")))
        for row, (line, title) in enumerate(lines, start=1):
            label = PlainLabel(title)
            label.setBuddy(line)
            line.setAccessibleName(f"{title} [cm]")
            line.setAlignment(Qt.AlignmentFlag.AlignRight)
            line.textEdited.connect(lambda _: self._show_offer())
            for column, widget in enumerate((label, line, PlainLabel("cm"))):
                grid.addWidget(widget, row, column)
        self.fill = QPushButton()
        self.fill.clicked.connect(self._fill_length)
        grid.addWidget(self.fill, 3, 0, 1, 3)
        self.wedges.column.addWidget(self.bricks)

    # showing

    def show_case(self) -> None:
        """Fill the form from the wall."""
        wall = self.wall
        for entries in self.lists:
            entries.show_case()
        if wall is None:
            clear_fields(self.gable_fields)
        for field in self.gable_fields if wall else ():
            field.show_value(getattr(wall, field.key))
        self.wedges.show_case()
        self.corner.show_case()
        self.leaf.show_case()
        self.bricks.setVisible(self.wedges.isChecked())
        self._show_offer()

    @property
    def offered(self) -> float | None:
        """Length of the wedge at the top [m] by the bricks, as far as they and the height are known."""
        wedges = self.wall.return_wedges if self.wall else None
        if self.wall is None or wedges is None:
            return None
        try:
            length, height = (parse_number(line.text()) for line in (self.brick_length, self.brick_height))
            crack = self.wall.shoulder - wedges.from_z_m
            wedge_length = crack * length / (2.0 * height)
        except (InputError, TypeError, ZeroDivisionError):
            return None
        return round(wedge_length, 3) if 0.0 < wedge_length <= 30.0 else None

    def _show_offer(self) -> None:
        offered = self.offered
        self.fill.setEnabled(offered is not None)
        self.fill.setText(
            tr("Fill in the length") if offered is None else tr("Fill in {length} m", length=number(offered, "g"))
        )

    def _names(self, problem: InputError, field: Field) -> bool:
        of_wedges = problem.code == "wedge_above" or problem.section == "[wall.return_wedges]"
        return of_wedges and field.key in problem.keys

    def point_at(self, problem: InputError) -> None:
        """Choose the opening, step or solid an error is about."""
        for entries in self.lists:
            entries.point_at(problem)

    # changes

    def _fill_length(self) -> None:
        """What the bricks give, as asked for."""
        wedges = self.wall.return_wedges if self.wall else None
        if wedges is not None and self.offered is not None:
            self.edit(return_wedges=replace(wedges, length_at_top_m=self.offered))
