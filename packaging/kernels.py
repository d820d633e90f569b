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
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

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

Names = dict[str, dict[str, list[str]]]
"""Names of the kernels of a level, as `shipped.Library` has them."""


class Overload(NamedTuple):
    """A kernel for the types of its arguments.

    types : as `core.jit.native` spells them, whether an array may be written or not
    signature : types of numba, of arrays that may be written
    readonly : of each array, whether a caller hands one on that may not be written
    """

    kernel: Kernel
    types: str
    signature: tuple
    readonly: list[bool]


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


def wanted_of(folder: Path) -> list[Overload]:
    """The overloads of kernels that Python calls, in a cache, in the order of their names and types: the list is the
    same in every process. Ends the build, with one sentence, where a kernel of it is not found."""
    for file in stamp.kernel_sources(stamp.CORE):
        if file.parent.name != "jit":
            importlib.import_module(".".join(file.relative_to(ROOT).with_suffix("").parts))
    # the collector lists objects by age, and their age depends on when it ran
    kernels = sorted(
        (thing for thing in gc.get_objects() if isinstance(thing, Kernel) and thing.python_wrapper),
        key=lambda kernel: kernel.name,
    )
    left = {file.name: _overloads(file) for file in folder.glob("*.nbi")}
    signatures: list[tuple[Kernel, tuple]] = []
    for kernel in kernels:
        own = kernel.dispatcher._cache
        name = own._cache_file._index_name
        for key in sorted(left.get(name, ()), key=repr):
            signature, _, code = key
            if code == own._index_key(signature, kernel.dispatcher.targetctx.codegen())[2]:
                signatures.append((kernel, signature))
                left[name].remove(key)
    names = {kernel.dispatcher._cache._cache_file._index_name for kernel in kernels}
    if lost := sorted(name for name, keys in left.items() if name in names and keys):
        raise SystemExit(
            f"the cache in {folder} has machine code of no kernel of these sources ({', '.join(lost)}): build again, "
            f"with sources that nobody changes meanwhile"
        )
    if not signatures:
        raise SystemExit(f"the cache in {folder} has no kernel that Python calls: the examples compiled nothing")
    return merged(signatures)


def merged(signatures: Iterable[tuple[Kernel, tuple]]) -> list[Overload]:
    """Overloads in the order of names and types. An array that may be written and one that may not are spelled alike,
    and are one overload: that of arrays that may be written, which serves both where the kernel writes none."""
    found: dict[tuple[str, str], Overload] = {}
    for kernel, signature in signatures:
        types, readonly = "".join(map(spelled, signature)), [not may for may in may_write(signature)]
        former = found.get((kernel.name, types))
        if former is not None:
            readonly = [one or other for one, other in zip(former.readonly, readonly, strict=True)]
        found[kernel.name, types] = Overload(kernel, types, tuple(map(writable, signature)), readonly)
    return [found[key] for key in sorted(found)]


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


def writable(kind):
    """A type of numba with arrays that may be written in the place of those that may not."""
    from numba.core import types

    if isinstance(kind, types.Array):
        return kind.copy(readonly=False)
    if isinstance(kind, types.BaseTuple):
        return types.BaseTuple.from_types([*map(writable, parts_of(kind))], getattr(kind, "instance_class", None))
    return kind


def words_of(kind) -> list[str]:
    """The words of an argument of a type, of an array "a" for its address."""
    from numba.core import types

    if isinstance(kind, types.Array):
        return [*"....a", *"." * (2 * kind.ndim)]
    if isinstance(kind, types.BaseTuple):
        return [word for part in parts_of(kind) for word in words_of(part)]
    return ["."]


def written_of(overload: Overload, function) -> str:
    """Of each array "r" where LLVM knows that the function does not write it, else "w". Ends the build, with one
    sentence, where it does not know it of an array that a caller hands on and that may not be written.

    function : of LLVM
    """
    attributes = [" ".join(map(bytes.decode, argument.attributes)) for argument in function.arguments][2:]
    words = [word for kind in overload.signature for word in words_of(kind)]
    if len(words) != len(attributes):
        raise SystemExit(
            f"{overload.kernel.name}({overload.types}): numba lays its arguments out as {len(attributes)} words, "
            f"words_of in packaging/kernels.py as {len(words)}: make that, and spell in core/jit/native.py, as numba is"
        )
    marks = [
        "r" if "readonly" in a or "readnone" in a else "w"
        for word, a in zip(words, attributes, strict=True)
        if word == "a"
    ]
    for k, (kept, mark) in enumerate(zip(overload.readonly, marks, strict=True)):
        if kept and mark == "w":
            raise SystemExit(
                f"{overload.kernel.name}({overload.types}): its array {k} is called with one that may not be written, "
                f"and LLVM does not know that the kernel only reads it: without numba the call would be of the Python "
                f"function, slow; hand on an array that may be written, or let the kernel plainly only read it"
            )
    return "".join(marks)


def letters_of(overload: Overload, kind) -> str:
    """The letters of the result of a kernel, of this type of numba. Ends the build, with one sentence, where
    core.jit.native does not unpack it."""
    letters = re.sub(r"^\((.*)\)$", r"\1", spelled(kind)).replace("n", "")
    if not re.fullmatch(r"[dq?]*", letters):
        raise SystemExit(
            f"{overload.kernel.name}({overload.types}) returns {kind}, and core/jit/native.py unpacks numbers and "
            f"tuples of numbers alone: let a kernel that Python calls return those"
        )
    return letters


def compiled(wanted: list[Overload], level: str, target: Path) -> Names:
    """Compile kernels for a level, which is that of this process, as a shared library in a folder; returns their names
    in it."""
    cache.own_process()
    import llvmlite.binding as llvm
    from numba import config, njit

    importlib.import_module("core.jit.numba_extensions")
    whole, names = llvm.parse_assembly(""), Names()
    for number, overload in enumerate(wanted):
        made = njit(nogil=True, error_model="numpy", **BARE)(overload.kernel.py_func)
        made.compile(overload.signature)
        result: Any = made.overloads[overload.signature]
        module = llvm.parse_assembly(str(result.library._final_module))
        symbol = f"kernel_{number}"
        module.get_function(result.fndesc.llvm_func_name).name = symbol
        marks = written_of(overload, module.get_function(symbol))
        letters = letters_of(overload, result.fndesc.restype)
        names.setdefault(overload.kernel.name, {})[overload.types] = [symbol, letters, marks]
        whole.link_in(module)
    machine = llvm.Target.from_default_triple().create_target_machine(
        cpu=level, features="", opt=int(vars(config)["OPT"]), reloc="pic", codemodel="default"
    )
    (target / f"{level}.o").write_bytes(machine.emit_object(whole))
    symbols = [symbol for types in names.values() for symbol, *_ in types.values()]
    link(target / f"{level}.o", target / shipped.file_name(level), symbols)
    return names


def agreed(lists: dict[str, Names]) -> Names:
    """The one list of a library. Levels are optimised differently, and LLVM may know at one that an array is only read
    where it does not at another: it is "r" where every level says so. Ends the build, with one sentence, where levels
    differ in anything else.

    lists : level -> names of its kernels
    """
    keys = {(name, types) for names in lists.values() for name, of_types in names.items() for types in of_types}
    whole = Names()
    for name, types in sorted(keys):
        rows = {level: names.get(name, {}).get(types, ["none", "", ""]) for level, names in lists.items()}
        if len({(symbol, letters, len(marks)) for symbol, letters, marks in rows.values()}) > 1:
            each = "; ".join(f"{level}: {' '.join(row).strip()}" for level, row in rows.items())
            raise SystemExit(
                f"{name}({types}) is not the same kernel at every level (its name in the library, letters of its "
                f"result, marks of its arrays; {each}): every level is to compile the same list in the same order, see "
                f"wanted_of and compiled in packaging/kernels.py"
            )
        symbol, letters, _ = next(iter(rows.values()))
        of_arrays = zip(*(marks for *_, marks in rows.values()), strict=True)
        whole.setdefault(name, {})[types] = [symbol, letters, "".join(map(max, of_arrays))]  # "w" comes after "r"
    return whole


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
    hashes, names = {}, dict[str, Names]()
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        for level in of:
            own = smoke.variables(place, **{shipped.FORCED_LEVEL: level})
            if subprocess.run([sys.executable, "-P", __file__, user, place], env=own).returncode:
                raise SystemExit(f"no machine code was made for {level}: what was said before this says why")
            content = (place / shipped.file_name(level)).read_bytes()
            (target / shipped.file_name(level)).write_bytes(content)
            hashes[level] = hashlib.sha256(content).hexdigest()
            names[level] = json.loads((place / NAMES).read_text(encoding="ascii"))
            print(f"{level}: {sum(map(len, names[level].values()))} kernels, {len(content) / 1e6:.1f} MB", flush=True)
    content = {"made_for": shipped.made_for(), "levels": hashes, "self_test": numbers, "kernels": agreed(names)}
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
