"""Machine code of the kernels for other processors than this one: a library for the frozen program, and the wheel
`ribalta_kernels` of it in dist.

python3 run.py package --kernels

The batches of the examples and the window say which kernels a user needs, with which types. Those are compiled anew for
each level and never called, so that this processor need not have what the code is for.
"""

import base64
import gc
import hashlib
import importlib
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "packaging")]
import platforms  # noqa: E402
import smoke  # noqa: E402

from core.jit import cache, shipped, stamp  # noqa: E402
from core.jit.kernel import Kernel  # noqa: E402
from core.version import VERSION  # noqa: E402

METADATA = """Metadata-Version: 2.1
Name: ribalta-kernels
Version: {version}
Summary: Machine code of the kernels of Ribalta {program}, for its sources {kernels} alone
License: BSD-3-Clause
Requires-Python: =={python}.*
Requires-Dist: numba=={numba}
Requires-Dist: llvmlite=={llvmlite}
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: ribalta\nRoot-Is-Purelib: false\nTag: {tag}\n"


def listed(folder: Path) -> Path:
    """The cache of a user, in a folder, who ran the examples by batch and in the window."""
    path = os.pathsep.join(map(str, (ROOT, ROOT / "packaging")))
    own = {shipped.FORCED_LEVEL: shipped.best_of(shipped.PROCESSOR_LEVELS), "PYTHONPATH": path}
    variables = smoke.variables(folder, **own)
    for case in smoke.CASES:
        smoke.batch([sys.executable, "-P", "-m", "app"], case, folder / "results", variables)
    entry = ROOT / "packaging" / "entry.py"
    smoke.window(entry, folder, variables, (sys.executable, "-P"))
    return next(Path(variables["RIBALTA_CACHE"]).glob("kernels-*"))


def compile_again(folder: Path) -> None:
    """Compile what a cache holds, for the level of this process. Raises LookupError where a kernel is not found."""
    for file in stamp.kernel_sources(stamp.CORE):
        if file.parent.name != "jit":
            importlib.import_module(".".join(file.relative_to(ROOT).with_suffix("").parts))
    wanted = {file.name: _overloads(file) for file in folder.glob("*.nbi")}
    for kernel in [thing for thing in gc.get_objects() if isinstance(thing, Kernel)]:
        dispatcher = kernel.dispatcher
        own = dispatcher._cache
        for key in wanted.get(own._cache_file._index_name, set()).copy():
            signature, _, code = key
            if code == own._index_key(signature, dispatcher.targetctx.codegen())[2]:
                dispatcher.compile(signature)
                wanted[own._cache_file._index_name].remove(key)
    cache.close()
    if any(wanted.values()):
        raise LookupError(wanted)


def _overloads(index: Path) -> set[tuple]:
    """Keys of numba's cache: signature, target, hashes of the kernel's code."""
    with open(index, "rb") as stream:
        pickle.load(stream)  # numba's version
        return set(pickle.loads(stream.read())[1])


def compiled_again(listed: Path, level: str, user: Path) -> Path:
    """The cache of a new user, in a folder, with what another one holds, for a level."""
    user.mkdir()
    variables = smoke.variables(user, **{shipped.FORCED_LEVEL: level})
    subprocess.run([sys.executable, "-P", __file__, listed], check=True, env=variables)
    return next((user / "cache").glob("kernels-*"))


def write(target: Path, caches: dict[str, Path], numbers: list[str]) -> None:
    """A library in a folder. caches : of each level; numbers : of the self-test"""
    made = {}
    for level, folder in caches.items():
        shutil.copytree(folder, target / level, ignore=shutil.ignore_patterns("*.json"), copy_function=shutil.copyfile)
        files = sorted((target / level).iterdir())
        made[level] = {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files}
        print(f"{level}: {len(files)} files, {sum(file.stat().st_size for file in files) / 1e6:.1f} MB", flush=True)
    content = {"made_for": shipped.made_for(), "levels": made, "self_test": numbers}
    (target / shipped.INDEX).write_bytes(shipped.index_of(content))


def make(target: Path) -> bool:
    """A library of all levels in a folder; False where there are none for processors of this kind."""
    if not shipped.best_of(shipped.PROCESSOR_LEVELS):
        return False
    from core.study import self_test

    with tempfile.TemporaryDirectory() as name:
        user = listed(Path(name))
        caches = {level: compiled_again(user, level, Path(name) / level) for level in shipped.PROCESSOR_LEVELS}
        write(target, caches, self_test.numbers())
    return True


def wheel(library: Path, dist: Path) -> Path:
    """The wheel of a library, in a folder."""
    about, tag = shipped.made_for(), platforms.tag()
    version = f"{VERSION}+{about['kernels']}"
    own = f"{shipped.PACKAGE}-{version}"
    python = "{}.{}".format(*sys.version_info[:2])
    words = about | {"version": version, "program": VERSION, "python": python, "tag": tag}
    inside = {
        f"{shipped.PACKAGE}/{file.relative_to(library).as_posix()}": file.read_bytes()
        for file in library.rglob("*")
        if file.is_file()
    }
    for name in ("LICENSE", "THIRD_PARTY.md"):
        inside[f"{own}.dist-info/licenses/{name}"] = (ROOT / name).read_bytes()
    for name, text in (("METADATA", METADATA), ("WHEEL", WHEEL)):
        inside[f"{own}.dist-info/{name}"] = text.format(**words).encode()
    lines = []
    for name, content in inside.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        lines.append(f"{name},sha256={digest},{len(content)}\n")
    record = f"{own}.dist-info/RECORD"
    inside[record] = "".join([*lines, f"{record},,\n"]).encode()
    dist.mkdir(exist_ok=True)
    target = dist / f"{own}-{tag}.whl"
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in inside.items():
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return target


if __name__ == "__main__":
    compile_again(Path(sys.argv[1]))
