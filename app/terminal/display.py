"""Whether a display is there for the window: Qt ends the process where it finds none."""

import ctypes
import os
import socket
from collections.abc import Mapping

from core.errors import InputError

VARIABLES = {"": ("WAYLAND_DISPLAY", "DISPLAY"), "xcb": ("DISPLAY",), "wayland": ("WAYLAND_DISPLAY",)}
"""QT_QPA_PLATFORM -> variables that name a display it takes; other platforms need none."""


def refuse_without_display(variables: Mapping[str, str]) -> None:
    """Raise InputError where Qt on Linux would find no display. variables : of the environment"""
    names = VARIABLES.get(variables.get("QT_QPA_PLATFORM", ""))
    if names is None:
        return
    named = [name for name in names if variables.get(name)]
    if not named:
        raise InputError("no_display")
    answers = {"WAYLAND_DISPLAY": wayland_answers, "DISPLAY": x11_answers}
    if not any(answers[name](variables) for name in named):
        displays = ", ".join(f"{name}={variables[name]}" for name in named)
        raise InputError("display_silent", displays=displays)


def x11_answers(variables: Mapping[str, str]) -> bool:
    """Whether the X server of DISPLAY takes a connection, asked as Qt asks it; True where its library is missing."""
    try:
        xcb = ctypes.CDLL("libxcb.so.1")
    except OSError:
        return True
    xcb.xcb_connect.argtypes, xcb.xcb_connect.restype = (ctypes.c_char_p, ctypes.c_void_p), ctypes.c_void_p
    xcb.xcb_connection_has_error.argtypes = xcb.xcb_disconnect.argtypes = (ctypes.c_void_p,)
    connection = xcb.xcb_connect(os.fsencode(variables["DISPLAY"]), None)
    error = xcb.xcb_connection_has_error(connection)
    xcb.xcb_disconnect(connection)
    return not error


def wayland_answers(variables: Mapping[str, str]) -> bool:
    """Whether the compositor of WAYLAND_DISPLAY takes a connection."""
    path = os.path.join(variables.get("XDG_RUNTIME_DIR", ""), variables["WAYLAND_DISPLAY"])
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as stream:
        try:
            stream.connect(path)
        except OSError:
            return False
    return True
