"""Machine code of the kernels for other processors than this one: a library for the frozen program, which has no
compiler, and the wheel `ribalta_kernels` of it in dist.

python3 run.py package --kernels

The batches of the examples, the window and `exercise` say which kernels a user needs, with which types. Those are
compiled for each level, linked and never called, so that this processor need not have what the code is for.
"""

import base64
import gc
import hashlib
import importlib
import json
import os
import pickle
import platform
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Any

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
Requires-Dist: numpy
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: ribalta\nRoot-Is-Purelib: false\nTag: {tag}\n"

NAMES = "names.json"
"""File of the names of the kernels beside the machine code of a level."""


def listed(folder: Path) -> Path:
    """The cache of a user, in a folder, who ran the examples by batch and in the window, and every kernel beside."""
    path = os.pathsep.join(map(str, (ROOT, ROOT / "packaging")))
    own = {shipped.FORCED_LEVEL: levels()[0], "PYTHONPATH": path}
    variables = smoke.variables(folder, **own)
    for case in smoke.CASES:
        smoke.batch([sys.executable, "-P", "-m", "app"], case, folder / "results", variables)
    smoke.window(ROOT / "packaging" / "entry.py", folder, variables, (sys.executable, "-P"))
    subprocess.run([sys.executable, "-P", ROOT / "packaging" / "exercise.py"], check=True, env=variables)
    return next(Path(variables["RIBALTA_CACHE"]).glob("kernels-*"))


def levels() -> list[str]:
    """The levels of this kind of processor, the one this processor has first."""
    if platform.machine().lower() not in ("x86_64", "amd64"):
        return [shipped.OF_ARM]
    own = shipped.levels_of(shipped.PROCESSOR_LEVELS)[0]
    return sorted(shipped.PROCESSOR_LEVELS, key=lambda level: level != own)


def _overloads(index: Path) -> set[tuple]:
    """Keys of numba's cache: signature, target, hashes of the kernel's code."""
    with open(index, "rb") as stream:
        pickle.load(stream)  # numba's version
        return set(pickle.loads(stream.read())[1])


def wanted_of(folder: Path) -> dict[Kernel, list]:
    """Kernel that Python calls -> the signatures it has in a cache. Raises LookupError where a kernel of it is not
    found."""
    for file in stamp.kernel_sources(stamp.CORE):
        if file.parent.name != "jit":
            importlib.import_module(".".join(file.relative_to(ROOT).with_suffix("").parts))
    known = [thing for thing in gc.get_objects() if isinstance(thing, Kernel) and thing.python_wrapper]
    left = {file.name: _overloads(file) for file in folder.glob("*.nbi")}
    wanted: dict[Kernel, list] = {}
    for kernel in known:
        own = kernel.dispatcher._cache
        name = own._cache_file._index_name
        for key in sorted(left.get(name, ()), key=repr):
            signature, _, code = key
            if code == own._index_key(signature, kernel.dispatcher.targetctx.codegen())[2]:
                wanted.setdefault(kernel, []).append(signature)
                left[name].remove(key)
    names = {kernel.dispatcher._cache._cache_file._index_name for kernel in known}
    if lost := {name: keys for name, keys in left.items() if name in names and keys}:
        raise LookupError(lost)
    return wanted


BARE: dict[str, Any] = {"_nrt": False, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Options of numba for code without anything of Python's."""


def parts_of(kind) -> list[Any]:
    """Types of the parts of a tuple of numba."""
    return [kind[k] for k in range(len(kind))]


def spelled(kind) -> str:
    """A type of numba as core.jit.native spells the type of an argument."""
    from numba.core import types

    if isinstance(kind, types.Array):
        return f"{spelled(kind.dtype)}{kind.ndim}{kind.layout}"
    if isinstance(kind, types.BaseTuple):
        own = getattr(kind, "instance_class", None)
        return f"{own.__name__ if own else ''}({''.join(map(spelled, parts_of(kind)))})"
    return {types.float64: "d", types.int64: "q", types.boolean: "?", types.none: "n"}[kind]


def may_write(signature) -> list[bool]:
    """Of each array of a signature of numba, in the order in which `core.jit.native.spell` finds them, whether it may
    be written."""
    from numba.core import types

    found = []
    for kind in signature:
        if isinstance(kind, types.Array):
            found.append(kind.mutable)
        elif isinstance(kind, types.BaseTuple):
            found += may_write(kind)
    return found


def words_of(kind) -> list[str]:
    """The words of an argument of a type, of an array "a" for its address."""
    from numba.core import types

    if isinstance(kind, types.Array):
        return [*"....a", *"." * (2 * kind.ndim)]
    if isinstance(kind, types.BaseTuple):
        return [word for part in parts_of(kind) for word in words_of(part)]
    return ["."]


def written_of(signature, function) -> str:
    """Of each array "r" where LLVM knows that the function does not write it, else "w". function : of LLVM"""
    attributes = [" ".join(map(bytes.decode, argument.attributes)) for argument in function.arguments][2:]
    words = [word for kind in signature for word in words_of(kind)]
    assert len(words) == len(attributes)
    marks = [
        "r" if "readonly" in a or "readnone" in a else "w"
        for word, a in zip(words, attributes, strict=True)
        if word == "a"
    ]
    assert all(may or mark == "r" for may, mark in zip(may_write(signature), marks, strict=True)), function.name
    return "".join(marks)


def compiled(wanted: dict[Kernel, list], level: str, target: Path) -> dict[str, dict[str, list[str]]]:
    """Compile kernels with these signatures for a level, which is that of this process, as a shared library in a
    folder; returns the names of the kernels in it, as `shipped.Library` has them."""
    cache.own_process()
    import llvmlite.binding as llvm
    from numba import config, njit

    importlib.import_module("core.jit.numba_extensions")
    whole, names = None, dict[str, dict[str, list[str]]]()
    for kernel, signatures in wanted.items():
        for signature in signatures:
            made = njit(nogil=True, error_model="numpy", **BARE)(kernel.py_func)
            made.compile(signature)
            result: Any = made.overloads[tuple(signature)]
            module = llvm.parse_assembly(str(result.library._final_module))
            types = "".join(map(spelled, signature))
            if types in names.setdefault(kernel.name, {}):  # of an array that may be written and one that may not
                assert all(
                    may or mark == "r"
                    for may, mark in zip(may_write(signature), names[kernel.name][types][2], strict=True)
                )
                continue
            symbol = f"kernel_{sum(map(len, names.values()))}"
            module.get_function(result.fndesc.llvm_func_name).name = symbol
            letters = re.sub(r"^\((.*)\)$", r"\1", spelled(result.fndesc.restype)).replace("n", "")
            assert re.fullmatch(r"[dq?]*", letters), letters  # core.jit.native unpacks nothing else
            names[kernel.name][types] = [symbol, letters, written_of(signature, module.get_function(symbol))]
            if whole is None:
                whole = module
            else:
                whole.link_in(module)
    assert whole is not None
    machine = llvm.Target.from_default_triple().create_target_machine(
        cpu=level, features="", opt=int(vars(config)["OPT"]), reloc="pic", codemodel="default"
    )
    (target / f"{level}.o").write_bytes(machine.emit_object(whole))
    symbols = [symbol for types in names.values() for symbol, *_ in types.values()]
    link(target / f"{level}.o", target / shipped.file_name(level), symbols)
    return names


def link(made: Path, target: Path, symbols: list[str]) -> None:
    """A shared library of machine code: by the linker of binutils on Linux, by that of the system elsewhere."""
    if sys.platform.startswith("linux"):
        subprocess.run(["ld", "-shared", "-s", "--hash-style=gnu", "-o", target, made], check=True)
        return
    from setuptools._distutils.ccompiler import new_compiler
    from setuptools._distutils.sysconfig import customize_compiler

    linker = new_compiler()
    customize_compiler(linker)
    linker.link_shared_object([str(made)], str(target), export_symbols=symbols)


def write(target: Path, user: Path, numbers: list[str], of: list[str]) -> None:
    """A library in a folder. user : cache whose kernels it has; numbers : of the self-test; of : levels"""
    target.mkdir(parents=True, exist_ok=True)
    hashes, names = {}, []
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        for level in of:
            own = smoke.variables(place, **{shipped.FORCED_LEVEL: level})
            subprocess.run([sys.executable, "-P", __file__, user, place], check=True, env=own)
            content = (place / shipped.file_name(level)).read_bytes()
            (target / shipped.file_name(level)).write_bytes(content)
            hashes[level] = hashlib.sha256(content).hexdigest()
            names.append(json.loads((place / NAMES).read_text(encoding="ascii")))
            print(f"{level}: {sum(map(len, names[-1].values()))} kernels, {len(content) / 1e6:.1f} MB", flush=True)
    assert all(one == names[0] for one in names)
    content = {"made_for": shipped.made_for(), "levels": hashes, "self_test": numbers, "kernels": names[0]}
    (target / shipped.INDEX).write_bytes(shipped.index_of(content))


def make(target: Path) -> None:
    """A library of all levels in a folder."""
    from core.study import self_test

    with tempfile.TemporaryDirectory() as name:
        write(target, listed(Path(name)), self_test.compute_order_8_answers(), levels())


def wheel(library: Path, dist: Path) -> Path:
    """The wheel of a library, in a folder."""
    about, tag = shipped.made_for(), platforms.tag()
    version = f"{VERSION}+{about['kernels']}"
    own = f"{shipped.PACKAGE}-{version}"
    words = about | {"version": version, "program": VERSION, "tag": tag}
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
    found = compiled(wanted_of(Path(sys.argv[1])), os.environ[shipped.FORCED_LEVEL], Path(sys.argv[2]))
    Path(sys.argv[2], NAMES).write_text(json.dumps(found), encoding="ascii")
