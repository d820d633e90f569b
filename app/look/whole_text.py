"""Words that a control may have no room for, whole in its tool tip."""

from PySide6.QtWidgets import QComboBox

from app.look.labels import escape_html


def tell_whole(box: QComboBox) -> None:
    """Have the tool tip of a list say what is chosen, below what it said before."""
    tip = box.toolTip()

    def tell(words: str) -> None:
        box.setToolTip(escape_html(f"{tip}\n{words}".strip()))

    box.currentTextChanged.connect(tell)
    tell(box.currentText())
