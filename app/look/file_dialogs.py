"""Names of files that a user chooses, and parts of them."""

import re
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QMessageBox

from app.look.labels import escape_html
from app.look.language import tr


def plain_name(text: str) -> str:
    """Text as part of a name of a file on every system."""
    return re.sub(r"[^\w.+ -]+", "_", text).strip(" .") or "_"


def path_to_write(parent, title: str, proposal: str, kinds: str, ends: tuple[str, ...]) -> Path | None:
    """The file to write that the user names, None if none. The ending of the kind chosen is added where it lacks, and
    where that makes it another file that is there, asked again."""
    name, kind = QFileDialog.getSaveFileName(parent, title, proposal, kinds)
    path = Path(name)
    if not name or path.suffix.lower() in ends:
        return path if name else None
    path = path.with_name(path.name + next((end for end in ends if f"*{end}" in kind), ends[0]))
    if path.exists():
        question = tr("{path} already exists. Overwrite it?", path=path)
        if QMessageBox.question(parent, title, escape_html(question)) != QMessageBox.StandardButton.Yes:
            return None
    return path
