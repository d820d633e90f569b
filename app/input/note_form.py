"""What goes into the note, and the judgement."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QPushButton, QVBoxLayout, QWidget

from app.input.fields import Field, connect
from app.input.made_fields import make_field, make_fields
from app.look.language import tr
from app.work.session import Session
from core.case.schema import Case, Report


def title_field(session: Session) -> Field:
    """The title of the case."""
    field = make_field(Case, "title")
    field.edited.connect(lambda value: session.edit(replace(session.case, title=value), "title"))
    return field


def with_button(logo: Field, session: Session) -> Field:
    """The field of the logo with a button that chooses its file."""

    def choose() -> None:
        pictures = "PNG, JPEG, SVG (*.png *.jpg *.jpeg *.svg)"
        name, _ = QFileDialog.getOpenFileName(logo, tr("Choose file…"), str(session.base_dir), pictures)
        if name:
            session.edit_section("report", logo=session.relative(Path(name)))

    button = QPushButton(tr("Choose file…"))
    button.clicked.connect(lambda _=False: choose())
    logo.grid.addWidget(button, 0, 2)
    return logo


class NoteForm(QWidget):
    """Edits of [report] what is decided with the pages in front; its head and language here as in the form Report."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.title_field = title_field(session)
        head = [make_field(Report, key) for key in ("client", "author", "language", "logo")]
        with_button(head[-1], session)
        self.fields = [*head, *make_fields(Report, "note", ("extent",))]
        connect(
            self.fields,
            lambda field, value: session.edit_section("report", ("report", field.key), **{field.key: value}),
        )
        column = QVBoxLayout(self)
        for field in (self.title_field, *self.fields):
            column.addWidget(field)
        column.addStretch(1)

    def show_case(self) -> None:
        """Fill the form from the session."""
        self.title_field.show_value(self.session.case.title)
        for field in self.fields:
            field.show_value(getattr(self.session.case.report, field.key))
