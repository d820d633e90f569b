"""A parametric study by its keys: what a person fills in becomes the file of the study."""

from pathlib import Path

from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from app.input.editors import Choice
from app.look.file_dialogs import path_to_write
from app.look.labels import PlainLabel
from app.look.language import current_language, describe_message, number, result_word, tr
from core import atomic_write
from core.case.keys import format_unit
from core.case.number import parse_number
from core.case.study_file import DEFAULT_MODEL, Grid, Group, Shape, Study, parse_study
from core.case.values import field_of
from core.errors import InputError
from core.text.sentence import capital, choice

LISTS: dict[str, tuple[float, ...]] = {"slenderness_deg": (3.1, 6.8, 10.0), "height_m": (3.0, 5.0, 7.0, 9.0)}
"""Keys of [[grid]] that are lists of numbers, and what stands there at first."""

NUMBERS = {"pga_g": (Group, 0.2), "count": (Study, 7)}
SECTION_OF_CHOICE = {"mechanism": Grid, "restitution": Grid, "law": Grid, "soil": Shape, "type": Shape}
SEED = 1


def caption(section: type, key: str) -> str:
    """What a key of a study is called, with its unit."""
    entry = field_of(section, key)
    rule = entry.metadata["of"].metadata if entry.metadata["kind"] == "list" else entry.metadata
    unit = format_unit(rule.get("unit", ""))
    own = {
        "pga_g": tr("a_g S of the spectrum"),
        "count": tr("Motions for each spectrum"),
        "type": tr("EN 1998-1, type"),
    }
    words = own.get(key) or capital(result_word(f"key_{key}"))
    return f"{words} [{unit}]" if unit else words


def names_of(section: type, key: str) -> list:
    """What a choice of a study takes."""
    entry = field_of(section, key)
    rule = entry.metadata["of"].metadata if entry.metadata["kind"] == "list" else entry.metadata
    if rule["kind"] == "int":
        return list(range(rule["low"], rule["high"] + 1))
    return [name for name in rule["names"] if name != "user"]


class StudyForm(QDialog):
    """Asks for the grid of a study and writes its file. path : of the file, None while there is none"""

    def __init__(self, parent: QWidget, folder: Path):
        super().__init__(parent)
        self.setWindowTitle(tr("A study by its keys"))
        self.folder = folder
        self.path: Path | None = None
        self.title = QLineEdit(tr("Parametric study"))
        self.lines = {key: QLineEdit("; ".join(number(one, "g") for one in ones)) for key, ones in LISTS.items()}
        self.lines |= {key: QLineEdit(number(one, "g")) for key, (_, one) in NUMBERS.items()}
        self.choices = {key: self._choice(section, key) for key, section in SECTION_OF_CHOICE.items()}
        self.records = QCheckBox(tr("Natural records beside the generated ones"))
        self.word = PlainLabel()
        self.word.setWordWrap(True)
        form = QFormLayout(self)
        form.addRow(tr("Title"), self.title)
        sections = (
            dict.fromkeys(LISTS, Grid) | {key: section for key, (section, _) in NUMBERS.items()} | SECTION_OF_CHOICE
        )
        for key, editor in (self.lines | self.choices).items():
            words = caption(sections[key], key)
            editor.setAccessibleName(words)
            form.addRow(words, editor)
        form.addRow(self.records)
        form.addRow(self.word)
        standard = QDialogButtonBox.StandardButton
        buttons = QDialogButtonBox(standard.Save | standard.Cancel)
        buttons.accepted.connect(self.save)
        buttons.rejected.connect(self.reject)
        form.addRow(buttons)

    @staticmethod
    def _choice(section: type, key: str) -> Choice:
        editor = Choice()
        for name in names_of(section, key):
            words = tr("default of the mechanism") if name == DEFAULT_MODEL else choice(str(name), current_language())
            editor.addItem(words, name)
        if key == "mechanism":
            editor.addItem(result_word("both"), ["two_sided", "one_sided"])
        return editor

    def table(self) -> dict:
        """The study as the keys of its file. Raises InputError."""
        lists = {key: [parse_number(part) for part in self.lines[key].text().split(";")] for key in LISTS}
        chosen = {key: editor.currentData() for key, editor in self.choices.items()}
        shape = {"name": "A1", "seed": SEED, "code": "EN1998", "type": chosen.pop("type"), "soil": chosen.pop("soil")}
        several = {key: one if isinstance(one, list) else [one] for key, one in chosen.items()}
        count = parse_number(self.lines["count"].text())
        return {
            "title": self.title.text().strip() or tr("Parametric study"),
            "language": current_language(),
            "count": int(count) if count == int(count) else count,
            "group": [{"name": "A", "pga_g": parse_number(self.lines["pga_g"].text()), "spectrum": [shape]}],
            "grid": [{**lists, **several, "motions": "all" if self.records.isChecked() else "generated"}],
        }

    def save(self) -> None:
        """Write the file where the person says, and close; a key that is not accepted is said."""
        import tomlkit

        try:
            table = self.table()
            parse_study(table)
            path = path_to_write(self, tr("Save the study"), str(self.folder / "study.toml"), "*.toml", (".toml",))
            if path is None:
                return
            atomic_write.write({path: tomlkit.dumps(table).encode()})
        except InputError as error:
            self.word.setText(describe_message(error))
            return
        self.path = path
        self.accept()
