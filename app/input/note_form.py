"""What goes into the note, and the judgement."""

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.input.fields import connect
from app.input.made_fields import make_fields
from app.work.session import Session
from core.case.schema import Report


class NoteForm(QWidget):
    """Edits of [report] what is decided with the pages in front."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.fields = make_fields(Report, "note", ("extent",))
        connect(
            self.fields,
            lambda field, value: session.edit_section("report", ("report", field.key), **{field.key: value}),
        )
        column = QVBoxLayout(self)
        for field in self.fields:
            column.addWidget(field)
        column.addStretch(1)

    def show_case(self) -> None:
        """Fill the form from the session."""
        for field in self.fields:
            field.show_value(getattr(self.session.case.report, field.key))
