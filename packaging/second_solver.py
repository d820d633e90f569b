"""What the frozen program holds of scipy: DOP853, which independent_solver.py asks for, in the files of scipy as they
are, without the 62 MB of other things that the package imports with it."""

import importlib.metadata
import shutil
from pathlib import Path

FILES = tuple(f"scipy/integrate/_ivp/{name}.py" for name in ("base", "common", "dop853_coefficients", "rk"))
"""Of scipy; they ask for numpy and for two names of scipy.sparse, for the Jacobian of implicit solvers."""

PACKAGES = {
    "scipy": "",
    "scipy.integrate": "from scipy.integrate._ivp.rk import DOP853 as DOP853\n",
    "scipy.integrate._ivp": "",
    "scipy.sparse": "coo_matrix = find = None\n",
}
"""The packages they stand in -> what these hold here."""


def write(folder: Path) -> None:
    """A package `scipy` in a folder, for the search path of PyInstaller before the installed one."""
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in PACKAGES.items():
        place = folder.joinpath(*name.split("."))
        place.mkdir(parents=True)
        said = '"""Of scipy, no more than its solver DOP853: packaging/second_solver.py."""\n'
        (place / "__init__.py").write_text(said + text, encoding="ascii")
    installed = importlib.metadata.distribution("scipy")
    for name in FILES:
        shutil.copyfile(str(installed.locate_file(name)), folder / name)
