"""Hostile input for everything that reads: records, cases, tables of walls, journals, autosaved cases, spectra.

    python3 run.py fuzz [--seconds N | --inputs N] [--seed N] [TARGET ...]

Good files are changed at random: bits flipped, pieces cut out, doubled, exchanged with those of other files, ends cut
off, numbers made absurd. Whatever comes is read or refused by an InputError of one line within a second: every other
exception, a result that is no finite number, or a message that repeats more than a piece of the input, is a find,
whose bytes are kept in a file that is named.
"""

import argparse
import contextlib
import io
import json
import math
import random
import sys
import tempfile
import time
import tomllib
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.case.drawing_file import DxfFile
from core.case.hazard_table import parse_hazard
from core.case.reader import read_case
from core.case.rules import parse_case, parse_draft
from core.case.site import Demand
from core.case.wall_table import read_table
from core.case.writer import dumps
from core.codes.kinematic_chain import sum_chain
from core.errors import InputError
from core.ground import records
from core.ground.records.grammar import Options
from core.setting.demand_input import read_target_spectrum
from core.study.journal import Journal
from tests.conftest import shelf_folder
from tests.core.ground.dialects import DIALECTS, usc
from tests.core.ground.networks_made import EXACT, TENTH
from tests.core.ooxml.writers import WRITERS, workbook

ROOT = Path(__file__).resolve().parents[2]
SLOWEST = 2.0
"""Seconds one input may take, of a machine that others use too."""

LONGEST = 2000
"""Characters of a message, two paths of the system among them."""

WORDS = [
    b"1e400",
    b"-",
    b"nan",
    b"inf",
    b"0x1F",
    b"9" * 400,
    b"\xff\xfe",
    b"\x00",
    b"\r",
    b"\n\n",
    b"=cmd()",
    b"NPTS= 1000000000",
    b"[g] (cm/s2)",
    b"wall",
    b"[[wall]]\n",
    b"*" * 300,
    b"1.5.2",
    b";",
    b",",
    b"\t",
    b"{",
    b"]",
    b'"',
    b"true",
    b"1_000",
    b"\xe2\x80\x8b",
]


def changed(chance: random.Random, seeds: list[bytes]) -> bytes:
    """A good file with some faults."""
    data = bytearray(chance.choice(seeds))
    for _ in range(chance.choice((1, 1, 1, 2, 4, 16))):
        if not data:
            break
        at = chance.randrange(len(data))
        size = chance.choice((1, 2, 5, 20, 200))
        kind = chance.randrange(8)
        if kind == 0:
            data[at] ^= 1 << chance.randrange(8)
        elif kind == 1:
            del data[at : at + size]
        elif kind == 2:
            data[at:at] = data[at : at + size] * chance.choice((1, 2, 50))
        elif kind == 3:
            del data[at:]
        elif kind == 4:
            data[at:at] = chance.choice(WORDS)
        elif kind == 5:
            other = chance.choice(seeds)
            start = chance.randrange(len(other) or 1)
            data[at : at + size] = other[start : start + size]
        elif kind == 6:
            data[at : at + size] = chance.randbytes(size)
        else:
            data[at : at + 1] = str(chance.choice((0, -1, 10**9, 10**18, 1e-300))).encode()
    return bytes(data[:400_000])


DIALECT_TARGETS = {
    "knet": ("K-NET",),
    "cwa": ("CWA",),
    "geonet": ("GeoNet V1A", "GeoNet V2A"),
    "smc": ("SMC, 8 fields", "SMC, 5 fields"),
    "california": ("CSMIP V2", "CSMIP V1", "COSMOS"),
    "peer": ("PEER", "PEER, values first", "tab matrix"),
    "sigma": ("SIGMA",),
    "itaca": ("ESM", "AFAD", "ITACA before 2014", "DYNA 1.0"),
    "zip": ("zip of ESM",),
    "sheet": ("xlsx",),
}
NETWORKS = {name: made[0] for name, made in EXACT.items()} | {name: made[0] for name, made in TENTH.items()}
NETWORK_TARGETS = {
    "networks": ("NSMN", "UNAM", "CSMNC", "BHRC"),
    "film": ("RENADIC", "CSMIP volume 1"),
    "usc two": ("USC volume 2", "CSMIP raw in g"),
    "labview": ("LabVIEW, one time column", "LabVIEW, no time column", "LabVIEW, times of each channel"),
}
"""target -> the files of tests/core/ground/networks_made.py."""

"""target -> the dialects of tests/core/ground/dialects.py whose files are changed; usc beside them."""


GIVEN = (Options(), Options(), Options(channel="1"), Options("g", 0.01))
"""What is given beside a record; which of these, its content decides, so that a find is found again."""


def _record(content: bytes, folder: Path) -> None:
    options = GIVEN[zlib.crc32(content) % len(GIVEN)]
    motion = records._motion(content, folder / "x.txt", options, 1.0, "x")
    assert np.isfinite(motion.acceleration).all() and 0.0 < motion.pga < 21.0 * 9.80665
    assert 1e-5 <= motion.time_step <= 0.5


def _case(content: bytes, folder: Path) -> None:
    path = folder / "x.toml"
    path.write_bytes(content)
    case = read_case(path)
    for wall in case.wall:
        assert math.isfinite(wall.block().p2)
        if wall.load:
            found = sum_chain(wall.in_si, "two_sided" in wall.mechanisms())
            assert found.alpha0 > 0.0 and 0.0 < found.e_star <= 1.0 + 1e-12 and found.d0 > 0.0
            assert all(side.sine > 0.0 for side in wall.in_si.restoring[: len(wall.mechanisms())])
    again = parse_case(tomllib.loads(dumps(case))) if not case.table else case
    assert again == case


def _table(content: bytes, folder: Path) -> None:
    path = folder / "x.csv"
    path.write_bytes(content)
    for wall in read_table(path, True)[0]:
        assert wall.base_z_m is not None and (wall.height_m or wall.block().height) >= 0.1


def _workbook(content: bytes, folder: Path) -> None:
    path = folder / "x.xlsx"
    path.write_bytes(content)
    read_table(path, False)


def _journal(content: bytes, folder: Path) -> None:
    path = folder / "x.journal"
    path.write_bytes(content)
    try:
        book = Journal(path, "key", True)
    except InputError:
        assert path.read_bytes() == content
        raise
    try:
        assert all(book.get(name) == {"q": float(name[3:])} for name in book.places)
    finally:
        book.close()


def _swap(content: bytes, folder: Path) -> None:
    from app.work import recovery
    from app.work.session import Session

    path = folder / "x-aa.swap"
    path.write_bytes(content)
    session = Session(folder / "recovery_folder")
    recovery.describe(path)
    session.recover(path)
    session.problem()
    session.drop_recovery_file()
    session.close()


def _spectrum(content: bytes, folder: Path) -> None:
    (folder / "s.txt").write_bytes(content)
    target = read_target_spectrum(Demand(0.26, soil_factor=1.2, spectrum_file="s.txt"), folder)
    assert target is not None and np.isfinite(target.acceleration(np.linspace(0.0, 9.0, 50))).all()


def _hazard(content: bytes, folder: Path) -> None:
    rows = parse_hazard(content.decode(errors="replace"))
    assert len(rows) >= 2 and all(0.0 < row.ag_g <= 5.0 for row in rows)


def _drawing(content: bytes, folder: Path) -> None:
    path = folder / "x.dxf"
    path.write_bytes(content)
    for shape in DxfFile(path).sheet().shapes:
        assert len(shape.corners) > 2 and all(math.isfinite(number) for corner in shape.corners for number in corner)


def _note(content: bytes, folder: Path) -> None:
    path = folder / "x.pdf"
    path.write_bytes(content)
    read_case(path)


def _draft(content: bytes, folder: Path) -> None:
    try:
        table = tomllib.loads(content.decode())
    except (ValueError, RecursionError):
        return
    parse_draft(table)


def drawing() -> bytes:
    """A wall with a window, an arch, a bay from a block, a spline and a hatch, in DXF."""
    import ezdxf

    document = ezdxf.new("R2000")
    for name in ("MATERIAL", "ACAD_MLEADERSTYLE", "ACAD_SCALELIST", "ACAD_VISUALSTYLE"):
        document.rootdict.discard(name)
    space, block = document.modelspace(), document.blocks.new("bay")
    space.add_lwpolyline([(0, 0), (6, 0), (6, 5), (3, 7), (0, 5)], close=True, dxfattribs={"layer": "wall"})
    space.add_lwpolyline([(2, 1), (3, 1), (3, 2, 0, 0, 1.0), (2, 2)], format="xyseb", close=True)
    block.add_circle((0, 0), 0.4)
    space.add_blockref("bay", (4, 3), {"xscale": 1.5, "rotation": 30})
    space.add_spline([(1, 3, 0), (2, 4, 0), (3, 3, 0), (1, 3, 0)])
    space.add_hatch().paths.add_polyline_path([(4, 0), (5, 0), (5, 2), (4, 2)])
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue().encode()


def note(case: bytes) -> bytes:
    """A PDF with a case within, as a calculation note has it."""
    import pypdf

    writer, stream = pypdf.PdfWriter(), io.BytesIO()
    writer.add_blank_page(100, 100)
    writer.add_attachment("case.toml", case)
    writer.write(stream)
    return stream.getvalue()


def seeds(folder: Path) -> dict[str, list[bytes]]:
    """Good files of each target."""
    cases = [path.read_bytes() for path in sorted((ROOT / "resources" / "cases").glob("*.toml"))]
    cases.append(
        b'walls = "w.csv"\n[[wall]]\nname = "a"\nradius_m = 2.0\nslenderness_deg = 7.0\n'
        b'inertia_over_mass_m2 = 6.0\nbase_z_m = 0\nmechanism = "two_sided"\n'
        b"law = { elastic_limit = 0.05, plateau_end = 0.3 }\n[demand]\nag_g = 0.2\nperiod_range_s = [0.2, 3.0]\n"
    )
    cases.append(
        b'[[wall]]\nname = "a"\nheight_m = 4.0\nthickness_m = 0.4\nmechanism = "both"\nvelocity_ratio = 0.9\n'
        b'[[wall]]\nvariant_of = "a"\nslenderness_deg = 5.0\nvelocity_ratio = ""\n'
    )
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_bytes()[:6000]
    motions = [
        motion,
        motion.replace(b"\n", b"\r\n"),
        b"# Acceleration (g), dt=0.01s\n" + b"0.1\n-0.2\n0.05\n" * 20,
        "\n".join(
            [
                "Passo temporale (ms): 10, Δt = 0,01 s, fs = 100 Hz, 100 campioni al secondo",
                "NPTS, DT: 60, 0.01",
                "unità di misura: 10⁻³ g; fattore di scala = 2.5 x 10^-3",
                "Component UP, number of data points: 60",
            ]
        ).encode()
        + b"\n0.1\n-0.2\n0.05" * 20,
    ]
    shelf = shelf_folder()
    if shelf:
        for name in (
            "PEER_AT2/ARL360.at2",
            "PEER_AT2/AND270.AT2",
            "ESM_ASCII/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
            "SIGMA_ITACA_acc/16839_H1.cor.acc",
            "plain_txt/Hollister.dat",
            "plain_txt/eqsig_test_motion_dt0p01.txt",
            "plain_txt/OpenSees_Northridge.dat",
        ):
            motions.append((shelf / name).read_bytes()[:12000])
    table = (
        "Parete;z;H;t;Meccanismo;E;peso specifico\n;m;m;cm;;MPa;kN/m3\n"
        "a;0;4,5;45;su un lato;900;18\nb;6;3;30;entrambi;;\n"
    )
    loaded = (
        "name;z;h;t;mechanism;unit weight;velocity_ratio;load 1;load 1 p;load 1 d;load 1 h;load 1 mass;load 2;load 2 p;"
        "load 2 h\n;m;m;cm;;kN/m3;;;kN/m;m;m;;;kN/m;m\na;0;4.5;45;one_sided;18;0.5;vertical;8;0.3;4;moving;tie;2;4\n"
    )
    book = Journal(folder / "seed.journal", "key", False)
    for k in range(5):
        book.add(f"run{k}", {"q": float(k)})
    book.close()
    spectrum = "\n".join(
        f"{t:.2f} {0.312 * min(1 + 10 * t, 2.5, 1.25 / max(t, 0.1)):.4f}" for t in np.linspace(0, 4, 80)
    )
    return {
        "record": motions,
        "case": cases,
        "draft": cases,
        "table": [table.encode(), loaded.encode(), table.replace(";", "\t").encode("utf-16")],
        "workbook": [
            (ROOT / "resources" / "templates" / "walls.xlsx").read_bytes(),
            *(
                workbook(
                    writer, [line.split(";") for line in table.splitlines()], hidden_rows=(4,), hidden_columns=(6,)
                )
                for writer in WRITERS.values()
            ),
        ],
        "journal": [(folder / "seed.journal").read_bytes()],
        "swap": [json.dumps({"path": None, "base_dir": ".", "case": case.decode()}).encode() for case in cases],
        "spectrum": [spectrum.encode()],
        "drawing": [drawing()],
        "note": [note(case) for case in cases],
        "usc": [usc()],
        **{name: [DIALECTS[one][0] for one in names] for name, names in DIALECT_TARGETS.items()},
        **{name: [NETWORKS[one] for one in names] for name, names in NETWORK_TARGETS.items()},
        "hazard": [b"T_R\ta_g\tF0\tTC*\n30\t0,08\t2,4\t0,28\n475\t0,26\t2,4\t0,35\n", b"30 0.08\n2475 0.4\n"],
    }


TARGETS: dict[str, Callable[[bytes, Path], None]] = {
    "record": _record,
    "case": _case,
    "draft": _draft,
    "table": _table,
    "workbook": _workbook,
    "journal": _journal,
    "swap": _swap,
    "spectrum": _spectrum,
    "hazard": _hazard,
    "drawing": _drawing,
    "note": _note,
    "usc": _record,
    **dict.fromkeys((*DIALECT_TARGETS, *NETWORK_TARGETS), _record),
}


def inside(content: bytes, chance: random.Random) -> bytes:
    """A workbook whose parts are changed, in a whole zip."""
    room = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(room, "w") as new:
        parts = [entry.filename for entry in old.infolist()]
        struck = chance.choice(parts)
        for name in parts:
            data = old.read(name)
            new.writestr(name, changed(chance, [data]) if name == struck and data else data)
    return room.getvalue()


def _refused_in_a_sentence(target, content: bytes, folder: Path) -> None:
    try:
        target(content, folder)
    except InputError as error:
        text = str(error)
        assert "\n" not in text and len(text) < LONGEST, f"a message of {len(text)} characters"


def attack(name: str, seconds: float, seed: int, inputs: float = math.inf) -> tuple[int, str | None]:
    """(inputs tried, what was found or None), for so long or of so many."""
    chance, count = random.Random(f"{name} {seed}"), 0
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        good = seeds(folder)[name]
        for one in good:  # what its first call imports and compiles is not the time of an input
            with contextlib.suppress(Exception):
                TARGETS[name](one, folder)
        end = time.monotonic() + seconds
        while count < inputs and time.monotonic() < end:
            whole_zip = name in ("workbook", "zip", "sheet") and chance.random() < 0.8
            content = inside(chance.choice(good), chance) if whole_zip else changed(chance, good)
            count += 1
            start = time.process_time()
            try:
                _refused_in_a_sentence(TARGETS[name], content, folder)
            except BaseException as error:
                kept = Path(tempfile.mkstemp(prefix=f"ribalta-{name}-")[1])
                kept.write_bytes(content)
                return count, f"{type(error).__name__}: {str(error)[:200]}; input kept in {kept}"
            if (took := time.process_time() - start) > SLOWEST:
                kept = Path(tempfile.mkstemp(prefix=f"ribalta-{name}-slow-")[1])
                kept.write_bytes(content)
                return count, f"took {took:.1f} s of processor; input kept in {kept}"
    return count, None


def main() -> int:
    words = argparse.ArgumentParser()
    words.add_argument("targets", nargs="*", default=list(TARGETS))
    words.add_argument("--seconds", type=float, default=60.0, help="for each target")
    words.add_argument("--inputs", type=float, default=math.inf, help="for each target, however long it takes")
    words.add_argument("--seed", type=int, default=random.randrange(10**6))
    options = words.parse_args()
    found, seconds = 0, options.seconds if options.inputs == math.inf else math.inf
    for name in options.targets:
        count, trouble = attack(name, seconds, options.seed, options.inputs)
        found += trouble is not None
        print(f"{name:10} {count:9} inputs, seed {options.seed}: {trouble or 'nothing found'}", flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
