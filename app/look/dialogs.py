"""A dialog that is asked once."""

import contextlib
from collections.abc import Iterator
from typing import TypeVar

from PySide6.QtWidgets import QDialog

Asked = TypeVar("Asked", bound=QDialog)


@contextlib.contextmanager
def delete_after_use(dialog: Asked) -> Iterator[Asked]:
    """Delete a dialog after what is asked of it: else it lives as long as its parent, among whose fields and lists its
    own are found."""
    try:
        yield dialog
    finally:
        dialog.deleteLater()
