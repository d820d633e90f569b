"""The one package of the wheel: the sources with their imports moved, and nothing else of theirs changed."""

import ast
import math
import os
import subprocess
import sys
import tomllib
import types
from pathlib import Path

import pytest

from core.jit.stamp import kernel_sources
from core.version import VERSION
from tests.conftest import ROOT
from tests.test_packaging import of_packaging


@pytest.fixture(scope="module")
def builder():
    interface = types.ModuleType("hatchling.builders.hooks.plugin.interface")
    interface.BuildHookInterface = object
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, interface.__name__, interface)
        yield of_packaging("one_package", patch)


@pytest.fixture(scope="module")
def package(builder, tmp_path_factory) -> Path:
    return builder.make(ROOT, tmp_path_factory.mktemp("site"))


def by_itself(package: Path, *words: str) -> str:
    """What a process prints that finds the package, and a `core` and an `app` of somebody else before it."""
    others = package.parent / "others"
    for name in ("core", "app", "resources"):
        (others / name).mkdir(parents=True, exist_ok=True)
        (others / name / "__init__.py").write_text("raise ImportError('of somebody else')\n")
    path = os.pathsep.join(map(str, (others, package.parent)))
    there = {**os.environ, "PYTHONPATH": path}
    done = subprocess.run(
        [sys.executable, "-P", *words], check=True, capture_output=True, text=True, env=there, cwd=package.parent
    )
    return done.stdout.strip()


@pytest.mark.shows("install.one_package")
def test_that_only_imports_differ_from_the_sources(builder, package):
    moved = 0
    for part in ("app", "core"):
        for source in sorted((ROOT / part).rglob("*.py")):
            own, there = source.read_text(), (package / source.relative_to(ROOT)).read_text()
            pairs = list(zip(own.splitlines(), there.splitlines(), strict=True))
            assert all(one == other or one == other.replace("ribalta_rocking.", "", 1) for one, other in pairs)
            assert not builder.outside(there)
            moved += sum(one != other for one, other in pairs)
            names = {node.module for node in ast.walk(ast.parse(own)) if isinstance(node, ast.ImportFrom)}
            assert bool(builder.outside(own)) == any((name or "").split(".")[0] in ("app", "core") for name in names)
    assert moved > 3000
    for path in (ROOT / "resources").rglob("*"):
        if path.is_file() and "__pycache__" not in path.parts:
            assert (package / path.relative_to(ROOT)).read_bytes() == path.read_bytes()


@pytest.mark.shows("install.one_package")
def test_that_it_runs_beside_packages_of_the_same_names(package):
    assert VERSION in by_itself(package, "-m", "ribalta_rocking", "--version")
    words = "import sys, ribalta_rocking as r; w = r.wall(mechanism='two_sided', height_m=3.0, thickness_m=0.3)"
    said = f"{words}; print(r.__version__, f'{{w.in_si.block.p2:.6f}}', {{'core', 'app'}} & set(sys.modules))"
    p2 = 0.75 * 9.80665 / (0.5 * math.hypot(3.0, 0.3))
    assert by_itself(package, "-c", said) == f"{VERSION} {p2:.6f} set()"
    inside = "from ribalta_rocking.core import child; print(child.bounded(len, 'abc', seconds=60, megabytes=3000))"
    assert by_itself(package, "-c", inside) == "3"


def test_that_its_machine_code_comes_from_the_same_sources(package):
    here = {path.relative_to(ROOT / "core") for path in kernel_sources(ROOT / "core")}
    assert {path.relative_to(package / "core") for path in kernel_sources(package / "core")} == here and len(here) > 30


@pytest.mark.shows("install.one_package")
def test_that_the_project_names_the_package_and_its_command(package):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert project["project"]["name"].replace("-", "_") == package.name
    assert project["project"]["scripts"] == {"ribalta": f"{package.name}.app.__main__:main"}
    assert (package / "py.typed").exists() and (package / "__main__.py").exists()
    asked = project["tool"]["hatch"]["build"]["targets"]["wheel"]["hooks"]["custom"]["path"]
    assert asked == "packaging/one_package.py"
