"""What stands in the frozen program in the place of PySide6's modules of OpenGL, which are 10 MB with their libraries.
pyqtgraph imports them, and asks them for something only where a chart is drawn by OpenGL: none here is."""

import sys
from types import ModuleType

MODULES = {"PySide6.QtOpenGL": (), "PySide6.QtOpenGLWidgets": ("QOpenGLWidget",)}
"""Module -> the classes that pyqtgraph derives others from when it is imported."""


def stand_in() -> None:
    """Before pyqtgraph is imported: modules without anything in them but those classes, of which no object is made."""
    for name, classes in MODULES.items():
        module = ModuleType(name)
        for own in classes:
            setattr(module, own, type(own, (), {}))
        sys.modules[name] = module
