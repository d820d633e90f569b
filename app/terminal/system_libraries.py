"""Libraries of Linux that Qt needs and its wheels do not bring; without one Qt ends the process with a message of its
own."""

import ctypes
import os
import shutil
from typing import NamedTuple

from core.errors import InputError


class Package(NamedTuple):
    """What holds a library in Debian and Ubuntu, in Fedora, in Arch Linux."""

    apt: str
    dnf: str
    pacman: str


ALWAYS = {
    "libglib-2.0.so.0": Package("libglib2.0-0", "glib2", "glib2"),
    "libGL.so.1": Package("libgl1", "libglvnd-glx", "libglvnd"),
    "libEGL.so.1": Package("libegl1", "libglvnd-egl", "libglvnd"),
    "libfontconfig.so.1": Package("libfontconfig1", "fontconfig", "fontconfig"),
    "libdbus-1.so.3": Package("libdbus-1-3", "dbus-libs", "dbus"),
    "libxkbcommon.so.0": Package("libxkbcommon0", "libxkbcommon", "libxkbcommon"),
}
"""Library -> its packages, whatever shows the window."""

ON_X11 = {
    "libxkbcommon-x11.so.0": Package("libxkbcommon-x11-0", "libxkbcommon-x11", "libxkbcommon-x11"),
    "libX11-xcb.so.1": Package("libx11-xcb1", "libX11-xcb", "libx11"),
    "libxcb-cursor.so.0": Package("libxcb-cursor0", "xcb-util-cursor", "xcb-util-cursor"),
    "libxcb-icccm.so.4": Package("libxcb-icccm4", "xcb-util-wm", "xcb-util-wm"),
    "libxcb-image.so.0": Package("libxcb-image0", "xcb-util-image", "xcb-util-image"),
    "libxcb-keysyms.so.1": Package("libxcb-keysyms1", "xcb-util-keysyms", "xcb-util-keysyms"),
    "libxcb-randr.so.0": Package("libxcb-randr0", "libxcb", "libxcb"),
    "libxcb-render-util.so.0": Package("libxcb-render-util0", "xcb-util-renderutil", "xcb-util-renderutil"),
    "libxcb-shape.so.0": Package("libxcb-shape0", "libxcb", "libxcb"),
    "libxcb-xkb.so.1": Package("libxcb-xkb1", "libxcb", "libxcb"),
}
"""Libraries that X11 needs beside them, which Qt takes where there is no Wayland."""

COMMANDS = {"apt": "sudo apt install", "dnf": "sudo dnf install", "pacman": "sudo pacman -S"}


def needed(variables: dict[str, str]) -> dict[str, Package]:
    """The libraries that the window needs. variables : of the environment"""
    platform = variables.get("QT_QPA_PLATFORM", "")
    on_x11 = platform == "xcb" or (not platform and not variables.get("WAYLAND_DISPLAY"))
    return ALWAYS | ON_X11 if on_x11 else ALWAYS


def missing(libraries: dict[str, Package]) -> dict[str, Package]:
    """Those that cannot be loaded."""
    unloadable = {}
    for name, package in libraries.items():
        try:
            ctypes.CDLL(name)
        except OSError:
            unloadable[name] = package
    return unloadable


def refuse_without() -> None:
    """Raise InputError where the window lacks libraries, with the command that gets them."""
    if not (lacking := missing(needed(dict(os.environ)))):
        return
    ways = []
    for manager, command in COMMANDS.items():
        packages = dict.fromkeys(getattr(package, manager) for package in lacking.values())
        if shutil.which(manager):
            ways = [f"{command} {' '.join(packages)}"]
            break
        ways.append(f"{command} {' '.join(packages)}")
    raise InputError("libraries_missing", libraries=", ".join(lacking), way=" / ".join(ways))
