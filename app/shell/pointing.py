"""The cursor into a field, wherever its form is; what links, errors and the finder lead to."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QGroupBox, QLineEdit, QScrollArea, QWidget

from app.input.fields import Field
from app.look.section import FoldingSection, unfold_to
from core.case.hold import Bars, Hold
from core.case.tie_rules import OF_A_TIE

if TYPE_CHECKING:
    from app.shell.navigator import Navigator


def point_at(navigator: "Navigator", widget: QWidget) -> None:
    """Put the cursor into a field, or where it begins to be: one that is hidden takes nothing into the case."""
    navigator.show_form_of(widget)
    unfold_to(widget)
    if isinstance(widget, Field):
        there = widget.isVisibleTo(widget.window()) and widget.isEnabled()
        widget = widget.editor if there else _way_to(navigator, widget)
    area = navigator.stages.input.forms.currentWidget()
    if isinstance(area, QScrollArea) and area.isAncestorOf(widget):
        area.ensureWidgetVisible(widget)
    widget.setFocus()


def _way_to(navigator: "Navigator", field: Field) -> QWidget:
    """What makes a field there is none of appear: a load to be added, the tick of its group, its section."""
    for form in (navigator.walls.loads, navigator.walls.holds, navigator.walls.set_aside, navigator.walls.evidence):
        if form.isAncestorOf(field) and not form.list.isVisibleTo(form.window()):
            return form.add_button
    above = field.parentWidget()
    while above is not None:
        if isinstance(above, FoldingSection):
            return above.head
        if isinstance(above, QGroupBox) and above.isCheckable():
            return above
        above = above.parentWidget()
    return field.editor


def point_at_key(navigator: "Navigator", key: str) -> None:
    """The cursor into the field of a key of the wall that is shown, of the demand or of the building; of a tie that of
    its first tie."""
    fields = [field for field in navigator.stages.fields if field.key == key]
    if not fields:
        return
    field = fields[0]
    if field.section is Bars or (field.section is Hold and key in OF_A_TIE):
        navigator.walls.holds.show_tie()
    point_at(navigator, field)


def point_at_evidence(navigator: "Navigator", key: str) -> None:
    """The cursor into the document that shows the value of a key, which is made where there is none."""
    form = navigator.walls.evidence if key in navigator.walls.evidence.keys else navigator.demand.evidence
    point_at(navigator, form.show_key(key))


def first_empty(fields: list[Field]) -> Field | None:
    """The first empty one of the fields that an error names, else the first."""
    empty = (field for field in fields if isinstance(field.editor, QLineEdit) and not field.editor.text().strip())
    return next(empty, fields[0] if fields else None)
