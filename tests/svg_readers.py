"""Readers of SVG that are not Qt, each a picture of so many pixels: that of typst; librsvg where the system has it."""

import ctypes
import ctypes.util
import tempfile
from pathlib import Path

import numpy as np
import pytest

READERS = ("typst", "librsvg")


def picture_by(reader: str, content: bytes, width: int, height: int) -> np.ndarray:
    """Red, green, blue on white, shape (height, width, 3). Skips the test where the reader is not there."""
    return {"typst": _by_typst, "librsvg": _by_librsvg}[reader](content, width, height)


def _by_typst(content: bytes, width: int, height: int) -> np.ndarray:
    typst = pytest.importorskip("typst", reason="typst has no wheel here")
    from PySide6.QtGui import QImage

    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "figure.svg").write_bytes(content)
        page = f"#set page(width: {width}pt, height: {height}pt, margin: 0pt)\n"
        source = Path(folder, "page.typ")
        source.write_text(f'{page}#image("figure.svg", width: {width}pt, height: {height}pt, fit: "stretch")')
        image = QImage.fromData(typst.compile(str(source), format="png", ppi=72), "PNG")
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(np.int16)


class Rectangle(ctypes.Structure):
    """RsvgRectangle."""

    _fields_ = [(name, ctypes.c_double) for name in ("x", "y", "width", "height")]


def _by_librsvg(content: bytes, width: int, height: int) -> np.ndarray:
    names = [ctypes.util.find_library(name) for name in ("rsvg-2", "cairo", "gobject-2.0")]
    if None in names:
        pytest.skip("no librsvg here")
    rsvg, cairo, gobject = map(ctypes.CDLL, names)
    pointer = ctypes.c_void_p
    rsvg.rsvg_handle_new_from_data.restype = pointer
    rsvg.rsvg_handle_new_from_data.argtypes = [ctypes.c_char_p, ctypes.c_size_t, pointer]
    rsvg.rsvg_handle_render_document.argtypes = [pointer, pointer, ctypes.POINTER(Rectangle), pointer]
    cairo.cairo_image_surface_create_for_data.restype = cairo.cairo_create.restype = pointer
    cairo.cairo_image_surface_create_for_data.argtypes = [pointer, *[ctypes.c_int] * 4]
    for function in (cairo.cairo_create, cairo.cairo_surface_destroy, cairo.cairo_destroy, cairo.cairo_surface_flush):
        function.argtypes = [pointer]
    gobject.g_object_unref.argtypes = [pointer]
    pixels = np.full((height, width, 4), 255, np.uint8)  # white, blue first
    surface = cairo.cairo_image_surface_create_for_data(pixels.ctypes.data, 0, width, height, 4 * width)
    context = cairo.cairo_create(surface)
    handle = rsvg.rsvg_handle_new_from_data(content, len(content), None)
    assert handle, "librsvg does not read it"
    try:
        assert rsvg.rsvg_handle_render_document(handle, context, Rectangle(0.0, 0.0, width, height), None)
        cairo.cairo_surface_flush(surface)
    finally:
        gobject.g_object_unref(handle)
        cairo.cairo_destroy(context)
        cairo.cairo_surface_destroy(surface)
    return pixels[:, :, 2::-1].astype(np.int16)
