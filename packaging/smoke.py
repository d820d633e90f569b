"""Try the frozen program as its users have it.

python3 packaging/smoke.py [FOLDER]     (python3 run.py package does it after the build)

Results equal to the source tree's bit for bit; from any directory, a read-only folder with spaces and accents in its
path, as a user without rights and without a home, and with the network denied; the window opens, runs, exports and
closes; a fault leaves a log; an older version's settings stay. What this machine cannot try is said.
"""

import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.xvfb import display  # noqa: E402

CASES = sorted((ROOT / "resources" / "cases").glob("*.toml"))
NOBODY = 65534


def refuse(wrong: bool, said: str) -> None:
    """End the trial with a sentence, where something is wrong: what, and where to look."""
    if wrong:
        raise SystemExit(f"the trial failed: {said}")


def program_of(folder: Path) -> Path:
    return folder / ("ribalta.exe" if os.name == "nt" else "ribalta")


def variables(folder: Path, **more: str) -> dict[str, str]:
    """The environment of a user of his own below a folder."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "RIBALTA", "XDG"))}
    homes = {
        "HOME": folder / "home",
        "USERPROFILE": folder / "home",
        "LOCALAPPDATA": folder / "home",
        "APPDATA": folder / "home",
        "RIBALTA_CACHE": folder / "cache",
    }
    (folder / "home").mkdir(exist_ok=True)
    return kept | {key: str(place) for key, place in homes.items()} | {"LC_ALL": "C.UTF-8"} | more


def batch(program, case: Path, output: Path, environment: dict, before: tuple = ()) -> tuple[dict, float]:
    """Results without what names the moment and the build, and the seconds it took."""
    words = program if isinstance(program, list) else [program]
    output.mkdir(parents=True, exist_ok=True)
    start = time.perf_counter()
    subprocess.run(
        [*before, *words, "--batch", case, "--output", output, "--quiet"],
        check=True,
        cwd=output,
        env=environment,
        stdin=subprocess.DEVNULL,
    )
    seconds = time.perf_counter() - start
    content = json.loads((output / f"{case.stem}.json").read_text(encoding="utf-8"))
    for key in ("started_utc", "program"):
        del content[key]
    return content, seconds


def screen(shown: dict | str) -> dict[str, str]:
    """Variables of a display that tests.xvfb.display gives, or of none."""
    if isinstance(shown, str):
        return {"QT_QPA_PLATFORM": "offscreen"}
    return {key: shown[key] for key in ("DISPLAY", "QT_QPA_PLATFORM")}


def window(program: Path, folder: Path, environment: dict, before: tuple = (), code: int = 0, **more: str) -> dict:
    """Drive the window by packaging/window_smoke.py; the seconds it noted."""
    left = folder / "left"
    shutil.rmtree(left, ignore_errors=True)
    left.mkdir(parents=True)
    left.chmod(0o777)
    case = left / "case of the trial.ribalta"
    shutil.copy(ROOT / "resources" / "cases" / "verdict.toml", case)
    text = case.read_text(encoding="utf-8").replace('"../', f'"{(ROOT / "resources").as_posix()}/')
    case.write_text(text, encoding="utf-8")
    with display() as shown:
        asked = {"RIBALTA_SMOKE": str(left), "RIBALTA_SMOKE_CASE": str(case), "RIBALTA_SMOKE_START": str(time.time())}
        done = subprocess.run([*before, program], cwd=left, env=environment | screen(shown) | asked | more, timeout=300)
    refuse(done.returncode != code, f"the window ended with code {done.returncode}, not {code}: its output is above")
    workbook = left / "window.xlsx"
    whole = workbook.exists() and workbook.stat().st_size > 10_000 and (left / "window.json").exists()
    refuse(not whole, "the window exported no workbook of more than 10 kB with its JSON: see drive in window_smoke.py")
    refuse(not any(left.glob("*.png")), "the window left no picture: see drive in window_smoke.py")
    return json.loads((left / "times.json").read_text(encoding="ascii"))


def first_difference(own: object, right: object, place: str = "") -> str:
    """Where the results of the frozen program first differ from those of the source tree, "" where they do not."""
    if isinstance(own, dict) and isinstance(right, dict) and own.keys() == right.keys():
        return next(filter(None, (first_difference(own[key], right[key], f"{place}/{key}") for key in own)), "")
    if isinstance(own, list) and isinstance(right, list) and len(own) == len(right):
        pairs = enumerate(zip(own, right, strict=True))
        return next(filter(None, (first_difference(*pair, f"{place}/{k}") for k, pair in pairs)), "")
    return "" if own == right else f"{str(own)[:100]} at {place or '/'}, the source tree {str(right)[:100]}"


def same_as_the_source(program: Path, folder: Path) -> None:
    """Every example: the results of the frozen program are those of the source tree."""
    source = [sys.executable, "-P", "-m", "app"]
    mine = variables(folder)
    theirs = variables(folder, PYTHONPATH=str(ROOT), RIBALTA_CACHE=str(folder / "source"))
    for case in CASES:
        frozen, first = batch(program, case, folder / "frozen", mine)
        again = batch(program, case, folder / "frozen", mine)[1]
        right = batch(source, case, folder / "of_source", theirs)[0]
        refuse(frozen != right, f"{case.name} has {first_difference(frozen, right)}")
        print(f"{case.name}: equal to the source tree's; {first:.2f} s the first time, then {again:.2f} s")


def main(folder: Path) -> int:
    program = program_of(folder)
    with tempfile.TemporaryDirectory(prefix="ribalta-smoke-") as name:
        place = Path(name)
        place.chmod(0o755)
        words = subprocess.run([program, "--version"], check=True, capture_output=True, text=True, cwd=place)
        print(words.stdout.strip())
        for trial in TRIALS:
            below = place / trial.__name__
            below.mkdir()
            trial(program, below)
    print("the frozen program passed its trial")
    return 0


def first_start(program: Path, folder: Path) -> None:
    """Of a user who never started it: the first result, with nothing compiled before."""
    case = next(case for case in CASES if case.stem == "verdict")
    seconds = batch(program, case, folder / "first", variables(folder))[1]
    print(f"first result of a new user: {seconds:.2f} s")
    made = {file.name.partition("-")[0] for file in (folder / "cache").glob("kernels-*/*")}
    refuse(
        made != {"passed", "manifest.json"},
        f"the machine code did not pass its self-test (core/jit/trial.py): the cache of a new user has {sorted(made)}",
    )


def statement_of_accuracy(program: Path, folder: Path) -> None:
    """The second solver, of scipy, which no example asks for."""
    case = folder / "case.toml"
    case.write_text(
        f'[analysis]\naccuracy = true\n[[record]]\nfile = "{(ROOT / "tests/motions/noise_1.txt").as_posix()}"\n'
        '[[wall]]\nname = "w"\nmechanism = "two_sided"\nheight_m = 3.0\nthickness_m = 0.4\nbase_z_m = 0.0\n',
        encoding="utf-8",
    )
    batch(program, case, folder / "results", variables(folder))
    with zipfile.ZipFile(folder / "results" / "case.xlsx") as book:
        sheets = [book.read(name) for name in book.namelist() if name.startswith("xl/worksheets/sheet")]
    lacks = not any(b"DOP853" in sheet for sheet in sheets)
    refuse(lacks, "the workbook has no statement of accuracy: scipy as packed (second_solver.py) fails")
    print("the statement of accuracy: there")


def inspection(program: Path, folder: Path) -> None:
    record = ROOT / "tests" / "motions" / "noise_1.txt"
    words = subprocess.run(
        [program, "--inspect", record],
        capture_output=True,
        text=True,
        encoding="utf-8",
        env=variables(folder),
        check=True,
    )
    refuse("noise_1" not in words.stdout, f"--inspect does not name the record noise_1: {words.stdout}")
    drawing = folder / "circle.dxf"
    tags = ["0", "SECTION", "2", "ENTITIES", "0", "CIRCLE", "8", "A", "10", "0", "20", "0", "40", "3", "0", "ENDSEC"]
    drawing.write_text("\n".join([*tags, "0", "EOF", ""]))
    words = subprocess.run([program, "--inspect", drawing], capture_output=True, text=True, env=variables(folder))
    read = words.returncode == 0 and "28.2" in words.stdout.replace(",", ".")
    refuse(not read, f"--inspect does not find the area 28.2 of a circle in a drawing: {words.stdout}{words.stderr}")
    print("--inspect reads a record and a drawing")


def other_products(program: Path, folder: Path) -> None:
    """The calculation note says what the source tree's says; a short study leaves its files; a terminal's bar."""
    case = next(case for case in CASES if case.stem == "verdict")
    source = [sys.executable, "-P", "-m", "app"]
    theirs = variables(folder, PYTHONPATH=str(ROOT), RIBALTA_CACHE=str(folder / "source"))
    said = []
    for words, mine in (([program], variables(folder)), (source, theirs)):
        note = folder / f"{len(said)}.docx"
        subprocess.run(
            [*words, "--batch", case, "--output", folder / str(len(said)), "--quiet", "--report", note],
            check=True,
            env=mine,
            cwd=folder,
        )
        with zipfile.ZipFile(note) as parts:
            text = parts.read("word/document.xml").decode("utf-8")
            pictures = [parts.read(name) for name in parts.namelist() if "media/" in name]
        version = subprocess.run([*words, "--version"], check=True, capture_output=True, text=True, env=mine)
        built = version.stdout.split()[-1]  # the commit, or the version where there is none
        said.append((re.sub(rf"<[^>]*>|20\d\d-\d\d-\d\d[T ][\d:]+|{built}\w*", "", text), pictures))
    refuse(said[0][0] != said[1][0], "the text of the calculation note is not that of the source tree's")
    refuse(said[0][1] != said[1][1], "the pictures of the calculation note are not those of the source tree's")
    signed, mine = folder / "note.pdf", variables(folder)
    asked: list[str | Path] = [program, "--batch", case, "--output", folder / "signed", "--quiet", "--report", signed]
    subprocess.run(asked, check=True, env=mine, cwd=folder)
    subprocess.run([program, "--extract", signed, "--output", folder / "within"], check=True, env=mine)
    within = {file.name for file in (folder / "within").iterdir()}
    refuse(within != {"case.toml", "results.json", "records.csv"}, f"--extract of a note gives {sorted(within)}")
    subprocess.run(
        [program, "--study", "paper", "--quick", "--output", folder / "study", "--quiet"],
        check=True,
        env=variables(folder),
    )
    kinds = {file.suffix for file in (folder / "study").rglob("*")}
    lacking = {".xlsx", ".json", ".csv", ".png", ".svg"} - kinds
    refuse(bool(lacking), f"--study paper left no {', '.join(sorted(lacking))}")
    if shutil.which("script"):
        command = shlex.join(map(str, [program, "--batch", case, "--output", folder / "terminal"]))
        subprocess.run(
            ["script", "-qec", command, folder / "typescript"],
            check=True,
            env=variables(folder),
            stdout=subprocess.DEVNULL,
        )
    print("calculation note as the source tree's, a short study, the bar of a terminal")


def the_window(program: Path, folder: Path) -> None:
    for kind in ("a new user", "the next time"):
        times = window(program, folder, variables(folder))
        print(f"window of {kind}: shown after {times['window']:.2f} s, first result after {times['result']:.2f} s")


def crash_log(program: Path, folder: Path) -> None:
    """A fault of a library: a file says where, and the next start names it."""
    mine = variables(folder)
    fault = 0xC0000005 if os.name == "nt" else -11
    window(program, folder, mine, code=fault, RIBALTA_SMOKE_FAULT="1")
    log = next((folder / "home").rglob("crash-*.log"))
    text = log.read_text(encoding="utf-8")
    refuse("window_smoke.py" not in text or "drive" not in text, f"the log does not say where the fault was: {text}")
    window(program, folder, mine)
    named = log.with_suffix(".txt").exists() and not log.exists()
    refuse(not named, f"the next start did not put {log.name} away as .txt, as it does after naming it")
    print(f"a fault leaves a log: {text.splitlines()[0]}")


def upgrade(program: Path, folder: Path) -> None:
    """Settings of an older version are kept; its machine code neither used nor deleted."""
    mine = variables(folder)
    window(program, folder, mine)
    settings = next((folder / "home").rglob("window.ini"))
    text = settings.read_text(encoding="utf-8")
    settings.write_text(text.replace("[General]", "[General]\ntheme=dark"), encoding="utf-8")
    old = folder / "cache" / "kernels-0123456789abcdef"
    old.mkdir(mode=0o700)
    (old / "kernel.nbi").write_bytes(b"of another version")
    window(program, folder, mine)
    refuse("theme=dark" not in settings.read_text(encoding="utf-8"), "a setting of an older version was not kept")
    refuse(not (old / "kernel.nbi").exists(), "the machine code of another version was deleted")
    print("settings of an older version are kept, its machine code stays apart")


def elsewhere(program: Path, folder: Path) -> None:
    """Moved to a read-only folder with spaces and accents in its path; as nobody, without a home."""
    if os.name == "nt" or not shutil.which("setpriv") or os.getuid() != 0:
        print("not tried here: another user, a read-only folder (they need Linux, root and setpriv)")
        return
    place = folder / "Strumenti dell'ingegnère Müller — 1"
    shutil.copytree(program.parent, place / "ribalta", symlinks=True)
    subprocess.run(["chmod", "-R", "a-w,a+rX", place], check=True)
    moved = place / "ribalta" / program.name
    nobody = ("setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups")
    open_to_all = folder / "of nobody"
    open_to_all.mkdir()
    open_to_all.chmod(0o777)
    case = next(case for case in CASES if case.stem == "verdict")
    right = batch(moved, case, folder / "root", variables(folder))[0]
    personal = ("HOME", "USERPROFILE", "APPDATA", "LOCALAPPDATA", "RIBALTA_CACHE", "USER", "LOGNAME")
    homeless = {key: value for key, value in variables(folder).items() if key not in personal}
    subprocess.run(["chmod", "a+rwX", folder], check=True)
    with tempfile.TemporaryDirectory(dir=open_to_all) as temporary:
        os.chmod(temporary, 0o777)
        homeless |= {"TMPDIR": temporary}
        found, seconds = batch(moved, case, open_to_all, homeless, nobody)
        refuse(found != right, f"as nobody, in a read-only folder, {case.name} has {first_difference(found, right)}")
        times = window(moved, open_to_all, homeless, nobody)
    print(
        "read-only folder, spaces and accents, nobody without a home: "
        f"batch {seconds:.2f} s, window {times['window']:.2f} s"
    )


def no_network(program: Path, folder: Path) -> None:
    """In a network of its own without an interface."""
    before = ("unshare", "--net")
    if not shutil.which("unshare") or subprocess.run([*before, "true"], capture_output=True).returncode:
        print("not tried here: without a network (needs Linux, unshare and the right to use it)")
        return
    case = next(case for case in CASES if case.stem == "verdict")
    batch(program, case, folder / "batch", variables(folder), before)
    window(program, folder, variables(folder, QT_QPA_PLATFORM="offscreen"), before)
    print("with the network denied: batch and window")


def closed_streams(program: Path, folder: Path) -> None:
    """As a service or a launcher starts it: none of the three streams is open."""
    if os.name == "nt":
        print("not tried here: closed streams (they need a shell of Linux or macOS)")
        return
    case = next(case for case in CASES if case.stem == "verdict")
    right = batch(program, case, folder / "open", variables(folder))[0]
    before = ("sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh")
    found = batch(program, case, folder / "closed", variables(folder), before)[0]
    refuse(found != right, f"with its streams closed {case.name} has {first_difference(found, right)}")
    print("with its streams closed: the same results")


def full_cache(program: Path, folder: Path) -> None:
    """A cache on a disk that is full after a few files."""
    full = folder / "full"
    full.mkdir()
    mount = ("mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", full)
    if not shutil.which("mount") or subprocess.run(mount, capture_output=True).returncode:
        print("not tried here: a full disk (needs Linux and the right to mount one)")
        return
    case = next(case for case in CASES if case.stem == "verdict")
    try:
        mine = variables(folder, RIBALTA_CACHE=str(full))
        found = batch(program, case, folder / "of_full", mine)[0]
    finally:
        subprocess.run(["umount", full], check=True)
    right = batch(program, case, folder / "of_whole", variables(folder))[0]
    refuse(found != right, f"with a full cache {case.name} has {first_difference(found, right)}")
    print("with a full cache: the same results")


TRIALS = (
    first_start,
    same_as_the_source,
    statement_of_accuracy,
    inspection,
    other_products,
    the_window,
    crash_log,
    upgrade,
    elsewhere,
    no_network,
    closed_streams,
    full_cache,
)


if __name__ == "__main__":
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    words.add_argument("folder", nargs="?", type=Path, default=ROOT / "dist" / "ribalta")
    sys.exit(main(words.parse_args().folder))
