"""Pythons and systems are one table: run.py, documents, launchers, project and workflow say what it says."""

import ast
import os
import re
import subprocess
import sys
import tomllib
from collections import Counter

import pytest
from packaging.markers import Marker
from packaging.specifiers import SpecifierSet
from packaging.tags import compatible_tags, cpython_tags
from packaging.utils import parse_wheel_filename

from tests.conftest import ROOT
from tests.test_run import load

platforms = load().platforms
WINDOWED = [name for name in platforms.PYTHONS if not platforms.without(platforms.PYTHONS[name], "gui")]
FIRST, *_, LAST = platforms.PYTHONS
GROUPS = ("base", "gui", "accuracy", "study", "report", "parquet", "dxf", "scheduler", "bench")


@pytest.fixture
def here(monkeypatch):
    """Sets what this interpreter seems to be."""

    def seem(python=(3, 12), system=("Linux", "x86_64", "glibc 2.36"), kind="cpython", free=0):
        monkeypatch.setattr(platforms.sys, "version_info", (*python, 0, "final", 0))
        monkeypatch.setattr(platforms, "this_system", lambda: system)
        monkeypatch.setattr(platforms.sys.implementation, "name", kind)
        monkeypatch.setattr(platforms.sysconfig, "get_config_var", lambda name: free)

    return seem


def lacks(python: str, row: dict) -> dict:
    """Group -> the package that this Python or this system has no wheel of."""
    if python not in row.get("pythons", platforms.PYTHONS):
        everything = dict.fromkeys(GROUPS, "llvmlite")
    else:
        everything = row.get("without", {})
    return {**everything, **platforms.PYTHONS[python].get("without", {})}


@pytest.mark.parametrize("python", platforms.PYTHONS)
@pytest.mark.parametrize("row", platforms.SYSTEMS, ids=lambda row: row["name"])
def test_that_what_the_table_has_is_installed(here, python, row):
    version = tuple(platforms.numbers(python))
    least = row.get("least", {})
    lacking = lacks(python, row)
    for group in GROUPS:
        here(version, (row["system"], row["processor"], least.get(group, least.get("base", ""))))
        refused = platforms.refusal([group])
        assert bool(refused) == (group in lacking), (group, refused)
        if refused:
            assert lacking[group] in refused and refused.count("\n") == 0


@pytest.mark.shows("install.refused")
@pytest.mark.parametrize(
    "seems, groups, said",
    [
        ({"python": (3, 10)}, [], "does not run with Python 3.10: take Python 3.11 to 3.15"),
        ({"python": (3, 16)}, [], "does not run with Python 3.16"),
        ({"kind": "pypy"}, [], "Ribalta does not run with "),
        ({"free": 1}, [], "does not run with free-threaded Python 3.12"),
        ({"python": (3, 15)}, ["base", "gui"], "window cannot be installed here (Python 3.15): PySide6 has no wheel"),
        ({"python": (3, 15)}, ["gui"], "take Python 3.11 to 3.14; a case runs without a window: --batch"),
        ({"python": (3, 15)}, ["bench"], "of peers cannot be installed here (Python 3.15): heyoka has no"),
        ({"system": ("macOS", "x86_64", "macOS 15.1")}, ["base"], "(macOS x86_64, macOS 15.1): llvmlite has no wheel"),
        ({"system": ("Linux", "x86_64", "no glibc")}, ["base"], "(Linux x86_64, no glibc): llvmlite has no wheel"),
        ({"system": ("Linux", "x86_64", "glibc 2.27")}, ["base"], "glibc 2.27): llvmlite has no wheel for it; take"),
        ({"system": ("Linux", "x86_64", "glibc 2.31")}, ["base", "gui"], "the window cannot be installed here (Linux"),
        (
            {"python": (3, 11), "system": ("Windows", "arm64", "")},
            ["base"],
            "(Windows arm64, Python 3.11): llvmlite has no wheel for it; take Python 3.12 to 3.14",
        ),
        (
            {"python": (3, 12), "system": ("Windows", "arm64", "")},
            ["base", "parquet"],
            "what more than 10 000 walls need cannot be installed here (Windows arm64): pyarrow has no wheel for it;",
        ),
        ({"system": ("Windows", "x86", "")}, ["base"], "(Windows x86): llvmlite has no wheel"),
        ({"system": ("Linux", "riscv64", "glibc 2.39")}, ["base"], "(Linux riscv64, glibc 2.39): llvmlite"),
    ],
)
def test_that_what_has_no_wheel_is_refused_in_a_sentence_with_its_reason(here, seems, groups, said):
    here(**seems)
    assert said in platforms.refusal(groups)


@pytest.mark.parametrize(
    "name",
    [
        "run.py",
        "packaging/platforms.py",
        "core/__init__.py",
        "core/text/__init__.py",
        "core/text/start.py",
        "core/text/catalogue.py",
    ],
)
def test_that_a_python_of_2016_reads_what_refuses_it(name):
    tree = ast.parse(text_of(name), feature_version=(3, 6))
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign):  # evaluated there
            assert isinstance(node.annotation, ast.Constant)


@pytest.mark.shows("install.refused")
def test_that_a_batch_runs_where_the_window_cannot(here):
    here(python=(3, 15))
    assert platforms.refusal(["base", "report", "study", "accuracy"]) is None
    here(system=("Linux", "x86_64", "glibc 2.31"))
    assert platforms.refusal(["base", "report"]) is None


def test_that_this_system_is_read_from_the_interpreter(monkeypatch):
    assert platforms.refusal(["base"]) is None
    monkeypatch.setattr(platforms.os, "name", "nt")
    for kind, processor in (("win-amd64", "amd64"), ("win32", "x86"), ("win-arm64", "arm64")):
        monkeypatch.setattr(platforms.sysconfig, "get_platform", lambda kind=kind: kind)
        assert platforms.this_system() == ("Windows", processor, "")
    monkeypatch.setattr(platforms.os, "name", "posix")

    def unknown(name):
        raise ValueError("unrecognized configuration name")

    monkeypatch.setattr(platforms.sys, "platform", "linux")
    monkeypatch.setattr(platforms.os, "confstr", unknown)
    assert platforms.this_system()[2] == "no glibc"


@pytest.mark.shows("install.refused")
def test_that_nothing_is_fetched_before_the_refusal(monkeypatch, tmp_path, here):
    monkeypatch.setenv("RIBALTA_ENV", str(tmp_path / "env"))
    run = load()
    monkeypatch.setattr(run.platforms, "refusal", lambda groups: "no wheel" if "gui" in groups else None)
    with pytest.raises(run.Failure, match="no wheel"):
        run.ensure(["base", "gui"])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="a shell script")
@pytest.mark.parametrize("there", [["3.15", "3.12", "3.11"], ["3.15"], []])
def test_that_a_double_click_takes_a_python_with_a_window(tmp_path, there):
    for name in ["", *platforms.PYTHONS]:
        missing = name in platforms.PYTHONS and name not in there
        script = tmp_path / f"python{name or 3}"
        script.write_text(f'#!/bin/sh\n[ "$1" = -c ] && exit {int(missing)}\necho {name or 3} "$@"\n')
        script.chmod(0o755)
    found = subprocess.run(
        [ROOT / "packaging" / "Ribalta.command", "a.toml"],
        capture_output=True,
        text=True,
        env={"PATH": f"{tmp_path}:{os.environ['PATH']}"},
    )
    taken = next((name for name in there if name in WINDOWED), 3)
    assert found.stdout == f"{taken} run.py a.toml\n", found


# what others say of it


def text_of(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def test_that_project_launchers_and_workflow_name_the_pythons_of_the_table():
    allowed = SpecifierSet(tomllib.loads(text_of("pyproject.toml"))["project"]["requires-python"])
    beyond = [f"3.{int(LAST[2:]) + 1}", f"3.{int(FIRST[2:]) - 1}"]
    assert [name for name in [*platforms.PYTHONS, *beyond] if name in allowed] == [*platforms.PYTHONS]
    newest_first = " ".join(reversed(WINDOWED))
    assert f"({newest_first})" in text_of("packaging/Ribalta.bat")
    assert f"Python {FIRST} to {WINDOWED[-1]} is missing" in text_of("packaging/Ribalta.bat")
    assert f"in {newest_first};" in text_of("packaging/Ribalta.command")
    for version in re.findall(r'python-version: "([\d.]+)"', text_of(".github/workflows/package.yml")):
        assert version in WINDOWED and platforms.PYTHONS[version]["run"]
    matrix = re.search(r"python: \[(.*)\]", text_of(".github/workflows/tests.yml"))
    assert re.findall(r'"([\d.]+)"', matrix[1]) == [*WINDOWED]


DOCUMENTS = [
    "resources/docs/run.md",
    "CONTRIBUTING.md",
    "resources/docs/guide/1_install.md",
    "resources/docs/guida/1_installare.md",
]


@pytest.mark.parametrize("name", DOCUMENTS)
def test_that_the_documents_name_the_pythons_of_the_table(name):
    text = text_of(name)
    ranges = set(re.findall(r"(3\.\d+) (?:to|a) (3\.\d+)", text))
    known = {(FIRST, WINDOWED[-1]), (FIRST, LAST)}
    known |= {(row["pythons"][0], row["pythons"][-1]) for row in platforms.SYSTEMS if "pythons" in row}
    assert (FIRST, WINDOWED[-1]) in ranges <= known
    assert set(re.findall(r"Python (3\.\d+)", text)) <= set(platforms.PYTHONS)
    assert LAST in text  # that it has no window is said


def test_that_the_readme_says_what_was_run_what_was_resolved_and_what_cannot_be():
    text = " ".join(text_of("resources/docs/run.md").split())
    run = [name for name, row in platforms.PYTHONS.items() if row["run"]]
    said = re.search(
        r"Run with ([\d., and]+) on (.+?); for ([\d., ]+), (.+?) the packages were resolved, not run", text
    )
    assert re.findall(r"3\.\d+", said[1]) == run
    assert re.findall(r"3\.\d+", said[3]) == [name for name in platforms.PYTHONS if name not in run]
    assert said[2] == " and ".join(row["name"] for row in platforms.SYSTEMS if row["run"])
    for row in platforms.SYSTEMS:
        assert row["run"] or row["name"] in said[4]
        for least in row.get("least", {}).values():
            assert not least.startswith("glibc") or least.removeprefix("glibc ") in text
    refused = text[text.index("the packages were resolved") :]
    for row in platforms.WITHOUT_WHEELS:
        assert row["name"] in refused


@pytest.mark.parametrize("name", ["resources/docs/run.md", *DOCUMENTS[2:]])
def test_that_the_documents_name_the_megabytes_that_run_py_says(run_groups, name):
    text = text_of(name)
    for groups in (["base"], ["base", "gui", "accuracy", "study", "report"]):
        fetch, disk = platforms.megabytes(run_groups(groups))
        near = [int(number) for number in re.findall(r"\b\d{2,3}\b", text)]
        assert any(abs(number - fetch) <= 0.05 * fetch for number in near)
        assert any(abs(number - disk) <= 0.07 * disk for number in near)


@pytest.fixture
def run_groups():
    return load().packages_of


# the lock against the index


def wheels_of_the_lock() -> dict[str, list[dict]]:
    """Package and version -> its wheels, as the index has them now: name of the file, sha256, size."""
    command = [
        "uv",
        "pip",
        "compile",
        "--quiet",
        "--universal",
        "--format",
        "pylock.toml",
        "pyproject.toml",
        "--constraint",
        "packaging/constraints.txt",
        "--all-extras",
    ]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    found = tomllib.loads(text)["packages"]
    return {
        f"{package['name']}=={package['version']}": [
            {"name": wheel["url"].rsplit("/", 1)[1], "sha256": wheel["hashes"]["sha256"], "size": wheel["size"]}
            for wheel in package["wheels"]
        ]
        for package in found
    }


def tags_of(python: str, row: dict, group: str) -> list:
    """The tags pip takes for a Python on a system, of the least version that has this group."""
    version = tuple(platforms.numbers(python))
    least = row.get("least", {})
    level = platforms.numbers(least.get(group, least.get("base", "")))
    places = [row["tag"]]
    if row["system"] == "Linux" and level != [0]:
        places = [row["tag"].format(2, minor) for minor in range(level[1], 16, -1)]
        places.append(f"manylinux2014_{row['processor']}")
    elif row["system"] == "macOS" and level != [0]:
        kinds = ("arm64", "universal2")
        places = [f"macosx_{major}_0_{kind}" for major in range(level[0], 10, -1) for kind in kinds]
        places += [f"macosx_10_{minor}_universal2" for minor in range(16, 8, -1)]
    return [*cpython_tags(version, platforms=places), *compatible_tags(version, f"cp{version[0]}{version[1]}", places)]


def pins(group: str, python: str, row: dict) -> list[str]:
    """Pins of a group that apply there."""
    names = {"Linux": "linux", "Windows": "win32", "macOS": "darwin"}
    asked = {"python_version": python, "python_full_version": f"{python}.0", "sys_platform": names[row["system"]]}
    kept = []
    for line in load().lock_sections()[group].split("\n"):
        pin, _, marker = line.rstrip(" \\").partition(" ; ")
        if "==" in pin and (not marker or Marker(marker).evaluate(asked)):
            kept.append(pin)
    return kept


@pytest.mark.network
@pytest.mark.long
def test_that_the_lock_has_a_wheel_for_every_row_of_the_table():
    wheels = wheels_of_the_lock()
    lock = text_of("requirements.lock")
    for python in platforms.PYTHONS:
        for row in (*platforms.SYSTEMS, *platforms.WITHOUT_WHEELS):
            for group in GROUPS:
                tags = set(tags_of(python, row, group))
                lacking = []
                for pin in pins(group, python, row):
                    fit = [w for w in wheels[pin] if parse_wheel_filename(w["name"])[3] & tags]
                    assert all(f"sha256:{w['sha256']}" in lock for w in fit), pin
                    lacking += [] if fit else [pin.split("==")[0]]
                if row in platforms.WITHOUT_WHEELS:
                    assert group != "base" or "llvmlite" in lacking, (python, row["name"], lacking)
                elif group not in ("gui", "accuracy", "study", "report") or not lacks(python, row):
                    # of Qt the tag (abi3) fits any Python, its metadata do not: below
                    known = group in lacks(python, row)
                    assert bool(lacking) == known, (python, row["name"], group, lacking)


@pytest.mark.network
@pytest.mark.long
@pytest.mark.parametrize("python", platforms.PYTHONS)
def test_that_qt_of_the_lock_serves_the_pythons_with_a_window_alone(python, tmp_path):
    pin = next(pin for pin in pins("gui", python, platforms.SYSTEMS[0]) if pin.startswith("shiboken6"))
    command = [
        sys.executable,
        "-m",
        "pip",
        "download",
        "--quiet",
        "--only-binary=:all:",
        "--no-deps",
        "--dest",
        tmp_path,
        "--python-version",
        python,
        "--platform",
        "manylinux_2_34_x86_64",
        pin,
    ]
    assert (subprocess.run(command, capture_output=True).returncode == 0) == (python in WINDOWED)


@pytest.mark.network
@pytest.mark.long
def test_that_the_megabytes_said_are_those_of_the_index():
    wheels, row = wheels_of_the_lock(), platforms.SYSTEMS[0]
    tags = set(tags_of(FIRST, row, "gui"))
    sizes = Counter()
    for group in GROUPS:
        for pin in pins(group, FIRST, row):
            fit = [w["size"] for w in wheels[pin] if parse_wheel_filename(w["name"])[3] & tags]
            sizes[pin.split("==")[0]] = max(fit) / 1e6
    for name, size in sizes.items():
        said = platforms.MEGABYTES.get(name, platforms.MEGABYTES["another"])[0]
        assert abs(said - size) <= max(1.5, 0.1 * size), (name, size)


def test_that_the_constraints_of_the_wheel_are_the_pins_of_the_lock():
    lock = {line.rstrip(" \\") for line in text_of("requirements.lock").split("\n") if "==" in line}
    assert text_of("packaging/constraints.txt").splitlines() == sorted(lock)
