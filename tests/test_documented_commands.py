"""Every command that the documents name runs here in a small form: one wall, one record, fifty samples, one peer."""

import contextlib
import importlib.util
import itertools
import os
import re
import shlex
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from app import __main__ as program
from app.terminal import batch
from tests.benchmarks import bench
from tests.benchmarks.short_case import short_case
from tests.conftest import ROOT
from tests.core.lab.research.test_shake_table import invented

DOCUMENTS = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "packaging" / "README.md",
    *sorted((ROOT / "resources" / "docs").rglob("*.md")),
]

FIRST_WORD = re.compile(
    r"((python3?|py|uvx?|pipx) \S|(run\.py|ribalta|\.venv/bin/\w+|packaging[/\\]Ribalta\.\w+)(\s|$))"
)
"""How a command of ours begins; those of the system (apt) are not ours to try."""

LONG = ("bench", "mutate", "robustness")
"""Commands that measure, start pytest or a second study, two minutes together: with `-m long` they are tried, in every
run their words are read."""

WINDOWED = ("window", "screenshots", "pictures", "records")
"""Benchmarks that open a window: each in a process of its own."""

STUDY = """title = "Small"
count = 1
[quick]
count = 1
[[group]]
name = "A"
pga_g = 0.2
[[group.spectrum]]
name = "s"
seed = 3
code = "EN1998"
type = 1
soil = "B"
[[grid]]
slenderness_deg = [6.8]
height_m = [3]
mechanism = ["two_sided"]
q_step = [0.05]
motions = "all"
"""

ENTRY = "import sys; from app.__main__ import main; sys.exit(main())"
"""What the command `ribalta` of the wheel runs (pyproject.toml, project.scripts)."""


def commands_of(text: str) -> list[str]:
    """The commands of a document: lines of its blocks of code, and code within its sentences."""
    blocks = re.findall(r"^```\w*\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    prose = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    lines = [line for block in blocks for line in block.splitlines()]
    lines += [line for line in prose.splitlines() if line.startswith("    ")]
    found = [re.split(r"\s+#", line)[0] for line in lines]
    found += [" ".join(code.split()) for code in re.findall(r"`([^`]+)`", prose)]
    return [command.strip() for command in found if FIRST_WORD.match(command.strip())]


COMMANDS = sorted(
    {command for path in DOCUMENTS for command in commands_of(path.read_text(encoding="utf-8"))}
    | set(commands_of(bench.__doc__ or ""))
)


@pytest.fixture(scope="module")
def place(tmp_path_factory) -> Path:
    """A folder with a small case, a small study and a record, to which every result goes."""
    folder = tmp_path_factory.mktemp("commands")
    short_case(folder)
    (folder / "study.toml").write_text(STUDY)
    (folder / "records").mkdir()
    (folder / "tests").mkdir()
    motion = (ROOT / "tests" / "motions" / "noise_1.txt").read_text().splitlines()
    (folder / "records" / "one.txt").write_text("\n".join([*motion[:602], ""]))
    (folder / "ties.toml").write_text('[[record]]\nfile = "records/one.txt"\n')
    return folder


def small_words(words: tuple[str, ...], folder: Path) -> list[str]:
    """The words behind run.py of a documented command, made small; what they write goes to this folder."""
    match words:
        case ():
            return []
        case ("test", *rest):
            assert selected(rest), f"run.py test {' '.join(rest)} selects no test"
            return ["test", "--version"]
        case ("fuzz", *_):
            return ["fuzz", "--inputs", "20", "--seed", "1", "case"]
        case ("mutate", *_):
            return ["mutate", "--faults", "1", "core/codes/eq9.py"]
        case ("robustness", *_):
            kept, page = str(folder / "robustness.journal"), str(folder / "robustness.md")
            return ["robustness", "--share", "0.001", "--journal", kept, "--output", page, "kills"]
        case ("--verify", *_):
            batch.run(folder / "small.toml", folder / "verified", 1, True, False)
            return ["--verify", str(folder / "verified" / "small.json"), "--records", str(folder)]
        case ("validate", "--output", *_):
            return ["validate"]
        case ("--export-check", *_):
            return ["--export-check", str(folder / "small.toml"), "--output", str(folder / "checks")]
        case ("validate", *rest):
            invented(folder / "tests")
            return ["validate", "--data", str(folder / "tests"), "--output", str(folder / "validated")]
        case ("package" | "docs" as word, *_):  # tests/test_pages.py builds the site
            return [word, "--help"]
        case ("bench", *rest):
            named = {"--paired": [str(ROOT)], "--against": [str(ROOT)]}
            named["--ties"] = [str(folder / "ties.toml")] if "LIST.toml" in rest else []
            named["--walls"] = ["12"]
            flags = [word for word in rest if word[:2] == "--" and word not in ("--pairs", "--cases", "--output")]
            asked = [part for flag in flags for part in (flag, *named.get(flag, []))]
            return ["bench", *asked, "--small", "--output", str(folder / "bench")]
        case ("--batch", _, "--part", *_):
            return ["--batch", str(folder / "small.toml"), "--part", "1/1", "--output", str(folder / "part")]
        case ("--batch", _, "--merge", *_):
            batch.run_part(folder / "small.toml", folder / "merged", 1, True, 1, 1)
            return ["--batch", str(folder / "small.toml"), "--merge", "--output", str(folder / "merged")]
        case ("--batch", _, "--scheduler", *_):
            return ["--batch", str(folder / "small.toml"), "--scheduler", "local:1", "--output", str(folder / "spread")]
        case ("--batch", _, *rest):
            note = ["--report", str(folder / "note.docx")] if "--report" in rest else []
            return ["--batch", str(folder / "small.toml"), *note, "--output", str(folder / "out")]
        case ("--study", _, *rest):
            given = ["--records", str(folder / "records")] if "--records" in rest else []
            return ["--study", str(folder / "study.toml"), "--quick", *given, "--output", str(folder / "study")]
        case ("--inspect", *_):
            return ["--inspect", str(folder / "records" / "one.txt")]
    raise AssertionError(f"no small form of run.py {' '.join(words)}: give it one here")


def selected(words: list[str]) -> list[str]:
    """Names of the tests that these arguments of pytest select: paths, -k WORD, -m MARKER."""
    options = dict(itertools.pairwise(words))
    name, marker = options.get("-k", ""), options.get("-m")
    paths = [ROOT / word for word in words if word.startswith("tests")] or [ROOT / "tests"]
    files = [file for path in paths for file in ([path] if path.is_file() else path.rglob("test_*.py"))]
    texts = [file.read_text(encoding="utf-8") for file in files]
    texts = [text for text in texts if not marker or f"pytest.mark.{marker}" in text]
    return [test for text in texts for test in re.findall(r"^def (test_\w+)", text, re.M) if name in test]


def handed_over(words: list[str]) -> list[str]:
    """What run.py starts for these words, with everything installed."""
    description = importlib.util.spec_from_file_location("run", ROOT / "run.py")
    run = importlib.util.module_from_spec(description)
    description.loader.exec_module(run)
    started: list[list[str]] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(run, "ensure", lambda groups, **_: None)
        patch.setattr(run, "interpreter", lambda: sys.executable)
        patch.setattr(run, "hand_over", started.append)
        patch.setattr(run.subprocess, "call", lambda command, **_: started.append(command))
        patch.setattr(sys, "argv", ["run.py", *words])
        run.main()
    (command,) = started
    return command


@cache
def tried(command: tuple[str, ...], folder: Path) -> None:
    """Run a command once, however many documents name it."""
    script, *words = command[command.index("-P") + 1 :] if "-P" in command else ("", *command[1:])
    if Path(script).name == "bench.py" and not any(f"--{name}" in words for name in WINDOWED):
        with contextlib.redirect_stdout(None):
            bench.main(list(words))
        return
    if command[1:4] == ("-P", "-m", "app"):
        with contextlib.chdir(folder):
            assert program.main(list(command[4:])) == 0, shlex.join(command)
        return
    variables = dict(os.environ, PYTHONPATH=str(ROOT), QT_QPA_PLATFORM="offscreen")
    found = subprocess.run(command, cwd=folder, env=variables, capture_output=True, text=True)
    assert found.returncode == 0, f"{shlex.join(command)}\n{found.stdout}\n{found.stderr}"


def is_long(command: str) -> bool:
    return any(f"run.py {words}" in command for words in LONG)


@pytest.mark.parametrize("command", [command for command in COMMANDS if is_long(command)])
def test_that_the_words_of_a_long_command_are_read(command):
    """As run.py takes them, with the small form that is tried: the script is there and knows each option."""
    words = shlex.split(re.sub(r"[\[\]…]", "", command).partition("run.py ")[2])
    script = Path(handed_over(words)[2])
    assert script.is_file() and words[0] in script.stem
    small = small_words(tuple(words), ROOT)
    if words[0] == "bench":
        assert bench.options_of(small[1:]).few("ab") == "a"
        chosen = words[1].removeprefix("--").replace("-", "_") if words[1:] else "speed"
        assert callable(importlib.import_module(f"tests.benchmarks.{bench.BENCHMARKS.get(chosen, chosen)}").main)
    assert small[0] == words[0]


def test_that_every_long_command_is_documented():
    assert all(any(f"run.py {words}" in command for command in COMMANDS) for words in LONG)


@pytest.mark.shows("batch.commands")
@pytest.mark.parametrize(
    "command", [pytest.param(command, marks=[pytest.mark.long] if is_long(command) else []) for command in COMMANDS]
)
def test_that_a_documented_command_runs(command, place):
    words = shlex.split(re.sub(r"[\[\]…]", "", command).replace("\\", "/"))
    match words:
        case ["python3" | "python" | "py", "run.py", *rest] | ["run.py", *rest]:
            if {f"--{word}" for word in WINDOWED} & {*rest}:
                pytest.importorskip("PySide6.QtWidgets", reason="no Qt", exc_type=ImportError)
            if rest and rest[-1] == "--batch":  # "py run.py --batch …": the line above it again
                rest += ["CASE"]
            started = handed_over(small_words(tuple(rest), place))
            if rest:
                tried(tuple(started), place)
            else:  # the window: tests/app/test_smoke.py opens it
                assert started[1:] == ["-P", "-m", "app"]
        case ["uv", "run", "ribalta", *rest] | ["ribalta", *rest]:
            assert 'ribalta = "ribalta_rocking.app.__main__:main"' in (ROOT / "pyproject.toml").read_text()
            assert small_words(tuple(rest), place)  # and as a command of run.py it is tried
            tried((sys.executable, "-P", "-c", ENTRY, "--version"), place)
        case ["uv" | "pipx" as tool, verb, *_]:  # packaging/wheel.py runs it
            assert f'"{tool}", "{verb}"' in (ROOT / "packaging" / "wheel.py").read_text() or (
                f'{tool} {verb}"' in (ROOT / "packaging" / "wheel.py").read_text()
            )
        case ["python", "-m", "ribalta_rocking"]:  # tests/test_one_package.py and packaging/wheel.py run it
            assert '"ribalta_rocking", "--version"' in (ROOT / "tests" / "test_one_package.py").read_text()
        case ["python3" | ".venv/bin/python", script, *_] if script.startswith("packaging/"):
            tried((sys.executable, "-P", str(ROOT / script), "--help"), place)
        case [".venv/bin/python", "-m", "tests.reference_of_keys"]:
            page = place / "case.md"
            page.write_text("# The case file\n", encoding="utf-8")
            tried((sys.executable, "-P", "-m", "tests.reference_of_keys", str(page)), place)
            assert page.read_text(encoding="utf-8").startswith("# The case file\n\n## Every key\n")
        case [".venv/bin/python", "-m", "core.lab.research.page"]:  # elsewhere than in the documents
            into = (
                "from pathlib import Path; from core.lab.research import page; page.PAGE = Path('p.md'); page.main([])"
            )
            tried((sys.executable, "-P", "-c", into), place)
            assert (place / "p.md").read_bytes() == (ROOT / "resources" / "docs" / "paper.md").read_bytes()
        case [".venv/bin/python", "-m", "tests.reference_of_results"]:
            tried((sys.executable, "-P", "-m", "tests.reference_of_results", str(place)), place)
            assert (place / "results.md").exists() and (place / "results.schema.json").exists()
        case [".venv/bin/python", "-m", "tests.requirements"]:
            tried((sys.executable, "-P", "-m", "tests.requirements", str(place)), place)
            assert (place / "requirements.md").exists() and (place / "codes.md").exists()
        case [".venv/bin/python", "-m", "tests.requirements", "--run", *_]:
            small = ("--run", str(place / "verification.md"), "--only", "paper.eq_12")
            tried((sys.executable, "-P", "-m", "tests.requirements", *small), place)
            assert "| passed | `paper.eq_12` |" in (place / "verification.md").read_text(encoding="utf-8")
            assert (place / "verification.json").exists()
        case [".venv/bin/python", "-m", "tests.validation.scatter_of_records", *_]:  # of a folder of records, minutes
            tried((sys.executable, "-P", "-m", "tests.validation.scatter_of_records", "--help"), place)
        case [".venv/bin/python", "-m", "tests.core.ground.damage", *_]:  # of a folder of records, minutes
            tried((sys.executable, "-P", "-m", "tests.core.ground.damage", "--help"), place)
        case [".venv/bin/ruff", "format", *_]:
            check = ("format", "--no-cache", "--check", str(ROOT / "tests" / "test_run.py"))
            tried((sys.executable, "-m", "ruff", *check), place)
        case [double_click] if double_click.startswith("packaging/"):
            assert "run.py" in (ROOT / double_click).read_text()
        case _:
            raise AssertionError(f"no small form of {command!r}: give it one here")


def test_that_every_benchmark_is_documented():
    """So that each of them runs above."""
    for word in bench.BENCHMARKS:
        option = f"--{word.replace('_', '-')}"
        assert any(f"bench {option}" in command for command in COMMANDS), option


def test_that_a_command_without_a_small_form_is_found():
    assert commands_of("As `python3 run.py shine` does.\n```\npython3 x.py   # so\n```\n") == [
        "python3 x.py",
        "python3 run.py shine",
    ]
    with pytest.raises(AssertionError, match="no small form"):
        small_words(("shine",), ROOT)
