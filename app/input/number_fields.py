"""Fields of numbers: in the unit of the office, with a unit of their own, as a sum or product, by the wheel."""

import math
import re

from PySide6.QtCore import Qt

from app.input.editors import Line
from app.input.fields import LineField
from app.look.language import FORM_NAMES, current_language, number, tr
from core.case.number import parse_formula, parse_number, parse_quantity
from core.errors import InputError

SIGNIFICANT_DIGITS = 12

OF_THOUSANDS = ("m", "cm", "mm", "m2", "MPa", "kN", "kN/m", "kN/m3")
"""Units of keys of which a thousand may be meant, of the key or of a smaller unit."""


class NumberField(LineField):
    """A number, comma or point."""

    def __init__(self, section: type, key: str):
        super().__init__(section, key)
        self.whole = self.entry.metadata["kind"] == "int"
        if self.factor != 1.0:
            FORM_NAMES.scales[key] = (self.factor, self.unit)

    def make_editor(self) -> Line:
        editor = super().make_editor()
        editor.setAlignment(Qt.AlignmentFlag.AlignRight)
        editor.setMinimumWidth(64)
        editor.stepped.connect(self._step)
        return editor

    def _step(self, by: int) -> None:
        """Change the number by one in its second figure: 0.50 by 0.01, 18 by 1."""
        if self.value and not self.error:
            shown = self.value * self.factor
            step = 1.0 if self.whole else 10.0 ** (math.floor(math.log10(abs(shown)) + 1e-9) - 1)
            self.type_again(number(round(shown + by * step, 12), f".{SIGNIFICANT_DIGITS}g"))

    def _typed(self, text: str) -> None:
        self.reading = ""
        if not text.strip() and self.optional:
            self.show_error("")
            self.value = None
            self.edited.emit(None)
            return
        if not text.strip():
            self.refuse(tr("a number is needed here"))
            return
        try:
            typed = self._value_of(text)
        except InputError as error:
            said = error.text(current_language()) if error.code == "unit_of_number" else ""
            self.refuse(said or tr("{text}: not a number", text=text.strip()))
            return
        self.reading = self._read_as(text.strip(), typed * self.factor)
        self.offer(int(typed) if self.whole and typed == int(typed) else typed)

    def _value_of(self, text: str) -> float:
        """A text in the unit of the key: a number alone, and a sum or product of such, is in the unit of the field.
        Raises InputError."""
        unit = self.entry.metadata.get("unit", "")
        try:
            return parse_number(text) / self.factor
        except InputError:
            pass
        try:
            return parse_quantity(text, unit)
        except InputError as error:
            try:
                return float(f"{parse_formula(text, unit, 1.0 / self.factor):.15g}")
            except InputError:
                raise error from None

    def _read_as(self, text: str, value: float) -> str:
        """How a sum or product was read, or a number that may be one with a separator of thousands, "" for others: both
        marks are decimal ones. Angles, seconds and ratios are never thousands."""
        if re.search(r"[0-9.,)]\s*[-+*/×·÷−]\s*[0-9.,(]", re.sub("[eE][-+]", "", text)):
            return f"{text} = {number(value, f'.{SIGNIFICANT_DIGITS}g')} {self.unit}".rstrip()
        mark = "," if current_language() == "en" else "[.,]"  # in English the point alone is the usual one
        grouped = re.fullmatch(rf"[1-9]\d{{0,2}}{mark}\d{{3}}", text)
        if self.entry.metadata.get("unit") not in OF_THOUSANDS or not grouped:
            return ""
        shown, meant = f"{number(value, 'g')} {self.unit}", re.sub("[.,]", "", text)
        return tr("{text} is read as {shown}: was {meant} meant?", text=text, shown=shown, meant=meant)

    def write(self, value: float | None) -> None:
        if self.editor.hasFocus() and self._means(value):
            return
        shown = "" if value is None or value == "" else number(value * self.factor, f".{SIGNIFICANT_DIGITS}g")
        if self.editor.text() != shown:
            self.editor.setText(shown)

    def _means(self, value) -> bool:
        text = self.editor.text()
        if not text.strip() or value in (None, ""):  # a value still to be given is ""
            return not text.strip() and value in (None, "")
        try:
            typed = self._value_of(text)
        except InputError:
            return False
        return abs(typed - value) <= 1e-12 * abs(value)


class RangeField(LineField):
    """Two rising numbers with a space, a dash or a semicolon between them; empty for none."""

    def make_editor(self) -> Line:
        editor = super().make_editor()
        editor.setAlignment(Qt.AlignmentFlag.AlignRight)
        return editor

    def _typed(self, text: str) -> None:
        if not text.strip():
            self.show_error("")
            self.value = None
            self.edited.emit(None)
            return
        try:
            self.offer([parse_number(part) for part in re.split(r"[\s;–-]+", text.strip())])
        except InputError:
            self.refuse(tr("{text}: not two numbers", text=text.strip()))

    def write(self, value) -> None:
        if not (self.editor.hasFocus() and value is not None):
            self.editor.setText("" if value is None else " – ".join(f"{number(end, 'g')}" for end in value))
