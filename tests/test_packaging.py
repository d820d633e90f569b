"""What is made beside the frozen program: licences of its parts, and one kind of file on three systems."""

import importlib.util
import json
import re
import sys
from pathlib import Path

import numpy
import pytest

from tests.conftest import ROOT

PACKAGING = ROOT / "packaging"


@pytest.fixture
def licences(monkeypatch):
    spec = importlib.util.spec_from_file_location("licences", PACKAGING / "licences.py")
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "licences", module)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module.importlib.metadata, "version", lambda name: "6.0")  # of Qt
    return module


def packed(work: Path, *binaries: tuple[str, str]) -> None:
    """The lists PyInstaller makes, with numpy and these libraries in them."""
    (work / "PYZ-00.toc").write_text(repr(("x.pyz", [("numpy", numpy.__file__, "PYMODULE")])))
    entries = [(Path(source).name, source, kind) for source, kind in binaries]
    (work / "COLLECT-00.toc").write_text(repr((entries, "ribalta")))


def without_starter(licences, monkeypatch) -> None:
    """PyInstaller, which a machine of tests has not."""
    real = licences._of_distribution
    own = licences.Part("pyinstaller", "0", "pkg:pypi/pyinstaller@0", "GPL-2.0")
    monkeypatch.setattr(
        licences, "_of_distribution", lambda name: own if name == "pyinstaller" else real(name)
    )


def test_that_every_part_has_its_licence_and_is_in_the_parts_list(licences, tmp_path, monkeypatch):
    without_starter(licences, monkeypatch)
    packed(tmp_path)
    licences.gather(tmp_path, tmp_path / "licences", "1.0", "lib")
    folder = tmp_path / "licences" / f"numpy-{numpy.__version__}"
    assert "Redistribution" in (folder / "LICENSE.txt").read_text(encoding="utf-8")
    listing = json.loads((tmp_path / "licences" / "sbom.cdx.json").read_text())
    assert {part["name"] for part in listing["components"]} == {"numpy", "Python", "pyinstaller"}
    assert all(part["purl"].startswith("pkg:") for part in listing["components"])


def test_that_a_part_without_a_licence_ends_the_build(licences, tmp_path, monkeypatch):
    without_starter(licences, monkeypatch)
    packed(tmp_path, ("/nowhere/libstranger.so.1", "BINARY"))
    with pytest.raises(ValueError, match=r"libstranger\.so\.1"):
        licences.gather(tmp_path, tmp_path / "licences", "1.0", "lib")
    assert not (tmp_path / "licences").exists()


def test_that_the_own_extension_is_the_same_everywhere():
    files = pytest.importorskip("app.files", reason="Qt cannot start here", exc_type=ImportError)
    own = files.CASE_ENDS[1]
    desktop = (PACKAGING / "linux" / "ribalta.desktop").read_text(encoding="utf-8")
    kind = re.search(r"^MimeType=(.+);$", desktop, re.MULTILINE)[1]
    mime = (PACKAGING / "linux" / "ribalta.xml").read_text(encoding="utf-8")
    assert f'type="{kind}"' in mime and f'pattern="*{own}"' in mime
    assert f"Classes\\{own}" in (PACKAGING / "windows" / "ribalta.iss").read_text(encoding="utf-8")
    spec = (PACKAGING / "ribalta.spec").read_text(encoding="utf-8")
    assert f'"CFBundleTypeExtensions": ["{own[1:]}"]' in spec
