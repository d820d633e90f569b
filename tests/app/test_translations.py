"""Every visible string of the window has its Italian."""

import ast
import xml.etree.ElementTree as ET

from tests.conftest import ROOT

APP = sorted((ROOT / "app").rglob("*.py"))


def visible_strings():
    """(file, string) of every tr("...") in the program."""
    for path in APP:
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "tr":
                (argument,) = node.args
                if isinstance(argument, ast.Constant):
                    yield path.name, argument.value


def test_that_no_visible_string_lacks_a_translation():
    tree = ET.parse(ROOT / "resources" / "translations" / "ribalta_it.ts")
    done = {
        m.find("source").text
        for m in tree.iter("message")
        if m.find("translation").text and m.find("translation").get("type") != "unfinished"
    }
    found = list(visible_strings())
    assert len(found) > 150
    assert [entry for entry in found if entry[1] not in done] == []
