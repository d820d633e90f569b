"""Values of a wall changed where they are drawn, by the fields of its form."""

from collections.abc import Callable

from PySide6.QtCore import QRectF
from shiboken6 import isValid

from app.input.fields import Field, LineField
from app.look.drawing import WallDrawing
from app.look.in_place import InPlaceEditor
from core.known import require_value

DRAWN = {"height": "height_m", "thickness": "thickness_m", "load": "kn_m", "hold": "h_m", "hinge": "hinge_heights"}
"""What is drawn -> the key whose value stands there."""


class DrawnValues:
    """Opens a line over a drawing for what was clicked twice.

    field_of(kind, k) : brings the field of what is drawn to the front
    """

    def __init__(self, drawing: WallDrawing, field_of: Callable[[str, int], Field]):
        self.drawing, self.field_of = drawing, field_of
        self.line: InPlaceEditor | None = None
        self.field: LineField | None = None
        drawing.asked.connect(self._ask)

    def _ask(self, kind: str, k: int, area: QRectF) -> None:
        """Change a value there as if it were typed into its field; what no field has is not changed."""
        field = self.field_of(kind, k)
        if field.key != DRAWN[kind] or not isinstance(field, LineField) or field.isHidden():
            return
        field.editor.entered.emit()
        before = field.text
        line = InPlaceEditor(self.drawing, area, before, field.caption.text(), field.unit)
        self.line, self.field = line, field

        def typed(text: str) -> bool:
            field.type_again(text)
            return not field.wrong

        def given_up() -> None:
            if field.text != before:
                field.type_again(before)
            if field.wrong:
                field.revert()

        line.typed, line.given_up = typed, given_up

    def follow(self) -> None:
        """Close the line where its field holds something else now, as after an undo."""
        if self.line is not None and isValid(self.line) and self.line.text() != require_value(self.field).text:
            self.line.close_it()

    def close(self) -> None:
        """Another wall is shown."""
        if self.line is not None and isValid(self.line):
            self.line.close_it()
