"""The fields of a place: the name of its municipality, its coordinates in a line."""

from PySide6.QtCore import QStringListModel, Qt
from PySide6.QtWidgets import QCompleter

from app.input.editors import Line
from app.input.fields import LineField
from app.look.language import FORM_NAMES, describe_message, tr
from core.case.coordinates import parse_coordinates
from core.case.place import Site
from core.errors import InputError

OFFERED = 12
"""Municipalities the list of a search shows."""

COORDINATE_TOLERANCE = 1e-9
"""Degrees."""


def names_beginning_with(text: str, most: int) -> list[str]:
    """Municipalities as they are named here."""
    from core.codes.national_hazard import search_municipalities

    return [f"{one.name} ({one.province})" for one in search_municipalities(text, most)]


class MunicipalityField(LineField):
    """A name, with its province in brackets; value : (name, province). Each letter is taken: what runs is what stands
    here."""

    def __init__(self):
        super().__init__(Site, "municipality")

    def make_editor(self) -> Line:
        editor = super().make_editor()
        self.names = QStringListModel()
        completer = QCompleter(self.names, self)
        completer.setCompletionMode(QCompleter.CompletionMode.UnfilteredPopupCompletion)
        completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        completer.activated.connect(self.choose)
        editor.setCompleter(completer)
        return editor

    def text_of(self, part: str) -> str:
        return tr("Municipality") if part == ".caption" else ""

    def _typed(self, text: str) -> None:
        self.propose(text)
        self.choose(text)

    def propose(self, text: str) -> None:
        """The municipalities of the letters typed so far."""
        self.names.setStringList(names_beginning_with(text, OFFERED))

    def choose(self, text: str) -> None:
        """A municipality is named."""
        value = self.meant(text)
        if value != self.value:
            self.value = value
            self.edited.emit(value)

    @staticmethod
    def meant(text: str) -> tuple[str, str]:
        """Name and province of a text."""
        name, _, rest = text.strip().partition(" (")
        return name.strip(), rest.rstrip(") ")

    def show_value(self, value) -> None:
        self.value = value
        name, province = value or ("", "")
        if self.meant(self.editor.text()) != (name, province):
            self.editor.setText(f"{name} ({province})" if province else name)

    def named_in(self, problem: InputError, wall: str) -> bool:
        nowhere = problem.code == "site_nowhere" or {"municipality", "province"} & set(problem.keys)
        return problem.section == "[site]" and bool(nowhere)


class CoordinatesField(LineField):
    """Latitude and longitude in any usual form; value : both [degrees], None without them."""

    def __init__(self):
        super().__init__(Site, "latitude")
        FORM_NAMES.add("longitude", tr("Coordinates"), "[site]")
        self.editor.setPlaceholderText("42.3498 N 13.3995 E, 42°20'59\" 13°23'58\"")

    def text_of(self, part: str) -> str:
        return tr("Coordinates") if part == ".caption" else ""

    def _typed(self, text: str) -> None:
        try:
            value = parse_coordinates(text) if text.strip() else None
        except InputError as error:
            self.refuse(describe_message(error))
            return
        self.show_error("")
        self.value = value
        self.edited.emit(value)

    def write(self, value) -> None:
        if not self._means(value):
            self.editor.setText("" if value is None else ", ".join(f"{angle:.9g}" for angle in value))

    def _means(self, value) -> bool:
        text = self.editor.text()
        if value is None or not text.strip():
            return value is None and not text.strip()
        try:
            return all(abs(a - b) < COORDINATE_TOLERANCE for a, b in zip(parse_coordinates(text), value, strict=True))
        except InputError:
            return False

    def named_in(self, problem: InputError, wall: str) -> bool:
        of_point = problem.code in ("site_half_a_point", "outside_the_grid")
        return problem.section == "[site]" and (of_point or bool({"latitude", "longitude"} & set(problem.keys)))
