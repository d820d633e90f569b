"""Texts that are in no case yet, through a change of language or theme, which makes the forms anew."""

from typing import TYPE_CHECKING

from app.input.entries_form import EntriesForm

if TYPE_CHECKING:
    from app.shell.window import MainWindow


class RefusedTexts:
    """What stands in the fields of a window and is refused, with the row that is chosen in each list of a wall, whose
    fields show one entry."""

    def __init__(self, window: "MainWindow"):
        self.rows = [form.list.currentRow() for form in window.walls.findChildren(EntriesForm)]
        self.texts = [field.text if field.wrong else None for field in window.stages.fields]

    def type_into(self, window: "MainWindow") -> None:
        """Choose the same rows and type the same texts: the forms of a window are made in one order."""
        for form, row in zip(window.walls.findChildren(EntriesForm), self.rows, strict=True):
            if 0 <= row < form.list.count():
                form.list.setCurrentRow(row)
        for field, text in zip(window.stages.fields, self.texts, strict=True):
            if text is not None:
                field.type_again(text)
