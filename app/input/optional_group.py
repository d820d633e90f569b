"""A section that may be missing, as a form has it: its fields below a tick."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QGroupBox, QVBoxLayout

from app.input.fields import Field, clear_fields, connect
from app.input.made_fields import make_fields


class OptionalGroup(QGroupBox):
    """Edits a section that may be missing.

    key, empty : of the section, and the section with what is still to be given
    owner() : what has that key, None where there is none
    edit(*place, **values) : changes keys of the owner, see `WallEditor.edit`
    """

    def __init__(self, title: str, key: str, empty: Any, owner: Callable[[], Any], edit: Callable[..., None]):
        super().__init__(title)
        self.key, self.empty, self.owner, self.edit = key, empty, owner, edit
        self.former: Any = None
        self.absent = False  # as it is shown
        self.fields = make_fields(type(empty))
        connect(self.fields, self._changed)
        self.setCheckable(True)
        self.toggled.connect(self._toggled)
        self.column = QVBoxLayout(self)
        for field in self.fields:
            self.column.addWidget(field)

    @property
    def section(self):
        """The section as the case has it, None without one."""
        return getattr(self.owner(), self.key, None)

    def forget(self) -> None:
        """Another case, wall or load: what was typed or switched off in the last one does not come back in this."""
        self.former, self.absent = None, False
        for field in self.fields:
            field.forget()

    def show_case(self) -> None:
        """Fill the fields; without a section they are hidden."""
        section = self.section
        if section is None and self.absent:  # at every key of a form
            return
        self.absent = section is None
        with QSignalBlocker(self):
            self.setChecked(section is not None)
        if section is None:
            clear_fields(self.fields)
        for field in self.fields:
            field.setVisible(section is not None)
            if section is not None:
                field.show_value(getattr(section, field.key))

    def _toggled(self, on: bool) -> None:
        if not on:
            self.former = self.section
        self.edit(**{self.key: (self.former or self.empty) if on else None})

    def _changed(self, field: Field, value) -> None:
        if self.section is not None:
            self.edit(self.key, field.key, **{self.key: replace(self.section, **{field.key: value})})
