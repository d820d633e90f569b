"""What kernels add to numba, and that nothing of what others in the process use is changed."""

import ast
import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT
from tests.trees import nodes_of

ROCK = """
import numpy as np
from core import api
wall = api.wall(height_m=4.0, thickness_m=0.4, mechanism="two_sided", base_z_m=0.0)
motion = api.motion(np.sin(6.0 * np.arange(300) * 0.01) * 3.0, 0.01)
print(repr(float(api.history(wall, motion, 1.0).rotation.sum())))
"""

FOREIGN = """
import numpy as np
from numba import njit

@njit(cache=True)
def shifted(x):
    return np.sin(x) + 1.0

@njit(cache=True)
def total(x):
    s = 0.0
    for i in range(x.size):
        s += shifted(x[i])
    return s
"""

STATE = """
import gc, locale, os, signal, sys, warnings
def state():
    import csv, decimal, json
    import numba
    from numba.core import caching, config, types
    import openpyxl
    classes = caching.Cache, caching.FunctionCache, caching._Cache, types.Function
    return {
        "classes": [{name: repr(value) for name, value in vars(kind).items()} for kind in classes],
        "settings of numba": {name: repr(getattr(config, name)) for name in dir(config) if name.isupper()},
        "environment": dict(os.environ),
        "warnings": repr(warnings.filters),
        "locale": locale.setlocale(locale.LC_ALL),
        "csv": csv.field_size_limit(),
        "decimal": repr(decimal.getcontext()),
        "hooks": (sys.excepthook, sys.getrecursionlimit(), sys.getswitchinterval(), signal.getsignal(signal.SIGINT)),
        "collector": (gc.isenabled(), gc.get_threshold(), gc.get_freeze_count()),
        "lxml": openpyxl.LXML,
    }
before = state()
"""


def output_of(program: str, folder, **variables: str) -> str:
    """What a program prints in a process of its own."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(("NUMBA", "OPENPYXL"))}
    path = os.pathsep.join([str(ROOT), str(folder)])
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        env=inherited | {"PYTHONPATH": path} | variables,
        capture_output=True,
        text=True,
        timeout=240,
    )
    assert done.returncode == 0, (done.returncode, done.stderr[-2000:])
    return done.stdout


@pytest.mark.shows("install.neighbours")
def test_that_a_cached_function_of_somebody_else_runs_after_a_kernel_of_ours(tmp_path):
    """It was loaded without what it needs, and ended the interpreter."""
    (tmp_path / "foreign.py").write_text(FOREIGN)
    call = "import numpy as np\nfrom foreign import total\nprint(repr(total(np.arange(5.0))))\n"
    cold = output_of(call, tmp_path)
    assert output_of(call, tmp_path) == cold
    assert output_of(ROCK + call, tmp_path).splitlines()[-1] == cold.strip()
    assert output_of(call + ROCK, tmp_path).splitlines()[0] == cold.strip()


@pytest.mark.shows("install.neighbours")
def test_that_the_library_changes_nothing_that_others_in_the_process_use(tmp_path):
    compared = "after = state()\nprint([name for name in before if before[name] != after[name]])\n"
    assert output_of(STATE + ROCK + compared, tmp_path).splitlines()[-1] == "[]"


def test_that_another_numba_gives_the_same_results(tmp_path):
    """Of a version whose internals are not known nothing is shortened."""
    assert output_of("import numba; numba.__version__ = '9.0.0'\n" + ROCK, tmp_path) == output_of(ROCK, tmp_path)


def foreign_names(source) -> set[str]:
    """Names that a module imports from packages of others."""
    names = set()
    for node in nodes_of(source):
        if isinstance(node, ast.Import):
            imported = [(alias.name, alias.asname or alias.name.split(".")[0]) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            imported = [(node.module or "", alias.asname or alias.name) for alias in node.names]
        else:
            continue
        names |= {name for module, name in imported if module.split(".")[0] not in ("app", "core")}
    return names


SETTERS = {"setattr", "seterr", "simplefilter", "filterwarnings", "setlocale", "field_size_limit", "setrecursionlimit"}
SETTERS |= {"freeze", "set_start_method", "setcontext", "putenv", "update_rcparams"}


def changes(source) -> list[str]:
    """Statements of a module that change an attribute or an item of what is imported from others."""
    names, found = foreign_names(source), []
    for node in nodes_of(source):
        targets = node.targets if isinstance(node, ast.Assign) else []
        targets = [node.target] if isinstance(node, (ast.AugAssign, ast.AnnAssign)) else targets
        for target in [part for whole in targets for part in (whole.elts if isinstance(whole, ast.Tuple) else [whole])]:
            root = target
            while isinstance(root, (ast.Attribute, ast.Subscript)):
                root = root.value
            if root is not target and isinstance(root, ast.Name) and root.id in names:
                found.append(f"{source.relative_to(ROOT).as_posix()}: {ast.unparse(target)}")
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            called, of = node.func, ast.unparse(node.func.value)
            sets = of in names and called.attr in SETTERS and (node.args or called.attr == "freeze")
            if sets or (of == "os.environ" and called.attr in ("setdefault", "update", "pop")):
                found.append(f"{source.relative_to(ROOT).as_posix()}: {ast.unparse(called)}")
    return found


OWN_PROCESS = {
    "core/jit/cache.py: os.environ.setdefault": "`own_process`, which the program calls",
    "core/jit/numba_extensions.py: gc.freeze": "in a process of the program's own",
    "app/__main__.py: os.environ.setdefault": "workbooks alike with and without lxml",
    "app/shell/start.py: gc.freeze": "once the window is shown",
    "app/__main__.py: sys.stdout": "a program without a terminal",
    "app/__main__.py: sys.stderr": "a program without a terminal",
    "app/__main__.py: warnings.simplefilter": "of libraries, to developers",
    "app/look/charting.py: sys.modules[name]": "the window's own start",
    "app/look/quick_imports.py: feature._mod_uses_pyside": "the window's own start",
    "app/shell/start.py: sys.excepthook": "errors of slots",
    "app/terminal/case_run.py: sys.stdout": "a pipe that was closed",
}
"""What the program changes of its own process -> why."""


def test_that_what_is_changed_of_others_is_listed_and_of_the_programs_own_process():
    sources = [*(ROOT / "core").rglob("*.py"), *(ROOT / "app").rglob("*.py")]
    assert {line for source in sources for line in changes(source)} == set(OWN_PROCESS)
