"""The field of the hinges of a wall."""

import re

from app.input.fields import LineField
from app.look.language import number, tr
from core.case.hinges import BASE, FLOORS, default_hinges
from core.case.number import parse_number
from core.errors import InputError

HINGE_WORDS = {FLOORS: FLOORS, BASE: BASE}
"""Words of a case file that stand for hinges."""


def hinge_words() -> dict[str, str]:
    """Words that stand for hinges, as the window shows them in its language."""
    return {FLOORS: tr("floors"), BASE: tr("base")}


class HingesField(LineField):
    """Heights above the base [m] with spaces or semicolons between them, or the word for the floors or for the base
    alone; empty for the usual ones."""

    def show_usual(self, wall, building) -> None:
        """What applies while it is empty, in its place. wall : it may still be incomplete"""
        try:
            heights = ("0", *(number(height, ".3g") for height in default_hinges(wall, building)))
        except (InputError, TypeError):
            heights = ()
        self.editor.setPlaceholderText(tr("the usual ones: {heights} m", heights="; ".join(heights)) if heights else "")

    def _typed(self, text: str) -> None:
        text = text.strip()
        if not text:
            self.show_error("")
            self.value = None
            self.edited.emit(None)
        elif text.lower() in (codes := {word: code for code, word in hinge_words().items()} | HINGE_WORDS):
            self.offer(codes[text.lower()])
        else:
            try:
                self.offer([parse_number(part) for part in re.split(r"[\s;]+", text)])
            except InputError:
                self.refuse(tr("{text}: not heights in m", text=text))

    def write(self, value) -> None:
        if not self.editor.hasFocus():
            heights = () if isinstance(value, str) else value or ()
            words = hinge_words()[value] if isinstance(value, str) else "; ".join(number(h, "g") for h in heights)
            self.editor.setText(words)
