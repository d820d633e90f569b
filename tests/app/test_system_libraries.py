"""Libraries of Linux that Qt needs: named with the command that gets them, before Qt ends the process."""

import shutil

import pytest

from app.terminal import system_libraries
from app.terminal.system_libraries import ALWAYS, COMMANDS, ON_X11, Package, missing, needed, refuse_without
from core.errors import InputError
from tests.conftest import ROOT

NONE = {
    "libnone-of-this.so.1": Package("libnone1", "none-libs", "none"),
    "libnone-2.so": Package("libnone2", "none-libs", "none"),
}


@pytest.mark.parametrize(
    ("variables", "on_x11"),
    [
        ({"DISPLAY": ":0"}, True),
        ({"DISPLAY": ":0", "WAYLAND_DISPLAY": "wayland-0"}, False),
        ({"WAYLAND_DISPLAY": "wayland-0", "QT_QPA_PLATFORM": "xcb"}, True),
        ({"QT_QPA_PLATFORM": "offscreen"}, False),
    ],
)
def test_that_those_of_x11_are_asked_for_where_qt_takes_it(variables, on_x11):
    assert needed(variables) == (ALWAYS | ON_X11 if on_x11 else ALWAYS)


def test_that_a_library_that_is_there_is_not_missing():
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    assert missing(ALWAYS) == {} and missing(ALWAYS | NONE) == NONE


@pytest.mark.shows("install.refused")
@pytest.mark.parametrize(
    ("manager", "command"),
    [
        ("apt", "sudo apt install libnone1 libnone2"),
        ("dnf", "sudo dnf install none-libs"),
        ("pacman", "sudo pacman -S none"),
        ("", "sudo apt install libnone1 libnone2 / sudo dnf install none-libs / sudo pacman -S none"),
    ],
)
def test_that_missing_ones_are_said_with_the_command_of_the_system(monkeypatch, manager, command):
    monkeypatch.setattr(shutil, "which", lambda name: name if name == manager else None)
    monkeypatch.setattr(system_libraries, "needed", lambda _: NONE)
    with pytest.raises(InputError) as refused:
        refuse_without()
    said = str(refused.value)
    assert "libnone-of-this.so.1, libnone-2.so" in said and f": {command};" in said and "--batch" in said


@pytest.mark.parametrize("page", ["troubleshooting.md", "guide/1_install.md", "guida/1_installare.md"])
def test_that_the_pages_name_every_package(page):
    text = (ROOT / "resources" / "docs" / page).read_text(encoding="utf-8")
    for manager, command in COMMANDS.items() if page == "troubleshooting.md" else [("apt", COMMANDS["apt"])]:
        packages = dict.fromkeys(getattr(one, manager) for one in (ALWAYS | ON_X11).values())
        assert f"`{command} {' '.join(packages)}`" in text
