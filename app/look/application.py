"""The application, as the widgets find it."""

from PySide6.QtWidgets import QApplication


def application() -> QApplication:
    """There is one as soon as there is a widget."""
    instance = QApplication.instance()
    assert isinstance(instance, QApplication)
    return instance
