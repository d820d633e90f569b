"""run.py: what it does before anything is installed."""

import ast
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from app.terminal import command_line
from core.text.sentence import LANGUAGES
from tests.conftest import ROOT
from tests.core.jit.test_shipped import make_library
from tests.test_packaging import of_packaging
from tests.trees import nodes_of

EXAMPLE = str(ROOT / "resources" / "cases" / "example.toml")


def load():
    """run.py as a module, of the environment RIBALTA_ENV names now."""
    description = importlib.util.spec_from_file_location("run", ROOT / "run.py")
    module = importlib.util.module_from_spec(description)
    description.loader.exec_module(module)
    return module


@pytest.fixture
def run(tmp_path, monkeypatch):
    """run.py whose environment is a folder of the test; nothing is installed. `offline` : pip fails;
    `version` : of what pip installs."""
    monkeypatch.setenv("RIBALTA_ENV", str(tmp_path / "env"))
    module = load()
    module.calls, module.offline, module.version = [], False, "1.0"

    def logged(command, trouble, total=0):
        module.calls.append(command)
        if "venv" in command:
            folder = command[-1]
            os.makedirs(module.site_packages(folder))
            os.makedirs(os.path.dirname(module.interpreter(folder)), exist_ok=True)
            for name in (module.interpreter(folder), os.path.join(folder, "pyvenv.cfg")):
                open(name, "w").close()
            return
        if module.offline:
            raise module.Failure(f"{trouble} (ERROR: no network)")
        folder = os.path.dirname(os.path.dirname(command[0]))
        with open(command[-1]) as stream:
            names = re.findall(r"^([\w.-]+)==", stream.read(), re.MULTILINE)
        for name in names:
            place = f"{name.replace('-', '_')}-{module.version}.dist-info"
            os.makedirs(os.path.join(module.site_packages(folder), place), exist_ok=True)

    module.logged = logged
    return module


def contents(folder):
    """Every path below a folder."""
    return sorted(str(path.relative_to(folder)) for path in Path(folder).rglob("*"))


def of_another_lock(run, monkeypatch, *added):
    """As after an update: all groups are of other lines, the base names one more package where given."""
    sections = run.lock_sections()
    changed = {name: lines + "# another\n" for name, lines in sections.items()}
    changed["base"] += "".join(f"{name}==1.0\n" for name in added)
    monkeypatch.setattr(run, "lock_sections", lambda: changed)


@pytest.mark.shows("install.environment")
def test_that_an_environment_is_made_once(run):
    run.ensure(["base"])
    assert len(run.calls) == 2
    run.ensure(["base"])
    assert len(run.calls) == 2
    run.ensure(["base", "test"])
    assert len(run.calls) == 3
    assert set(run.installed_groups()) == {"base", "test"}


def test_that_a_broken_environment_is_rebuilt(run):
    run.ensure(["base"])
    os.rmdir(os.path.join(run.site_packages(), os.listdir(run.site_packages())[0]))
    assert run.installed_groups() == {}
    run.ensure(["base"])
    assert len(run.calls) == 4
    os.unlink(run.interpreter())
    run.ensure(["base"])
    assert len(run.calls) == 6
    with open(os.path.join(run.ENVIRONMENT, run.STAMP), "w") as stream:
        stream.write("{half")
    run.ensure(["base"])
    assert len(run.calls) == 8


def test_that_an_outdated_environment_is_replaced(run, monkeypatch):
    run.ensure(["base"])
    of_another_lock(run, monkeypatch)
    run.version = "2.0"
    run.ensure(["base"])
    assert len(run.calls) == 4
    assert all("-2.0" in name for name in os.listdir(run.site_packages()))
    assert not os.path.exists(run.NEXT) and not os.path.exists(run.PREVIOUS)


def test_that_an_environment_is_made_beside_and_the_old_one_untouched_until_it_is_whole(run, monkeypatch):
    run.ensure(["base", "gui"])
    before = contents(run.ENVIRONMENT)
    of_another_lock(run, monkeypatch)
    real = run.logged

    def watched(command, trouble, total=0):
        assert contents(run.ENVIRONMENT) == before and run.ENVIRONMENT + os.sep not in command[0]
        real(command, trouble)

    monkeypatch.setattr(run, "logged", watched)
    run.ensure(["base", "gui"])
    assert set(run.installed_groups()) == {"base", "gui"}
    # a failure, a kill and a full disk on the way
    of_another_lock(run, monkeypatch)
    for trouble in (run.Failure("no network"), KeyboardInterrupt(), OSError(28, "No space left")):
        for step in ("venv", "pip"):

            def fails(command, sentence, total=0, trouble=trouble, step=step):
                if step in command:
                    raise trouble
                watched(command, sentence)

            monkeypatch.setattr(run, "logged", fails)
            with pytest.raises((run.Failure, KeyboardInterrupt)):
                run.ensure(["base", "gui"])
            assert contents(run.ENVIRONMENT) == before and not os.path.exists(run.NEXT)


def test_that_without_a_network_after_an_update_the_packages_there_are_start_the_program(run, monkeypatch, capsys):
    run.ensure(["base", "gui"])
    before = contents(run.ENVIRONMENT)
    of_another_lock(run, monkeypatch)
    run.offline = True
    run.ensure(["base", "gui"], older_serves=True)
    said = capsys.readouterr().err.splitlines()[-1]
    assert "no network" in said and "packages of an earlier version" in said
    for groups, older in ((["base", "gui"], False), (["base", "study"], True)):
        with pytest.raises(run.Failure, match="the installation failed: check the network"):
            run.ensure(groups, older_serves=older)
    of_another_lock(run, monkeypatch, "new-package")
    with pytest.raises(run.Failure, match="the installation failed: check the network"):
        run.ensure(["base", "gui"], older_serves=True)
    assert contents(run.ENVIRONMENT) == before
    run.offline = False
    run.ensure(["base", "gui"], older_serves=True)
    assert set(run.installed_groups()) == {"base", "gui"}


def test_that_a_case_that_may_be_large_runs_without_a_network(run, capsys):
    """The rows of its table are counted, its hinges are guessed: the program itself refuses one that is large."""
    run.ensure(["base"])
    run.offline = True
    run.prepare(["base", "parquet"], True)
    assert "the installation failed" in capsys.readouterr().err and set(run.installed_groups()) == {"base"}
    with pytest.raises(run.Failure, match="the installation failed"):
        run.prepare(["base", "study"], True)
    run.offline = False
    run.prepare(["base", "parquet"], True)
    assert set(run.installed_groups()) == {"base", "parquet"}


@pytest.fixture
def wheel(run, tmp_path, monkeypatch):
    """A wheel of machine code for these sources in dist, and an environment without it."""
    run.ensure(["base"])
    make_library(tmp_path / "library")
    monkeypatch.setattr(run, "DIST", str(tmp_path / "dist"))
    made = of_packaging("kernels", monkeypatch).wheel(tmp_path / "library", tmp_path / "dist")
    for path in (made, made.parent):
        path.chmod(path.stat().st_mode & ~0o022)
    return made


def of_kernels(run):
    """What the environment holds of machine code."""
    return sorted(name for name in os.listdir(run.site_packages()) if name.startswith(run.KERNELS))


@pytest.mark.shows("install.wheel")
def test_that_a_wheel_of_machine_code_that_stands_in_dist_is_taken_once(run, wheel, tmp_path, capsys):
    run.prepare(["base"], False)  # a word of a developer
    assert of_kernels(run) == []
    open_to_group = os.umask(0o002)
    run.prepare(["base"], True)
    os.umask(open_to_group)
    packages = Path(run.site_packages())
    assert of_kernels(run) == [run.KERNELS, wheel.name.rsplit("-", 3)[0] + ".dist-info"]
    assert contents(packages / run.KERNELS) == contents(tmp_path / "library")
    for path in (tmp_path / "library").rglob("*.*"):
        taken = packages / run.KERNELS / path.relative_to(tmp_path / "library")
        assert path.is_dir() or taken.read_bytes() == path.read_bytes()
        assert os.name == "nt" or not taken.stat().st_mode & 0o022
    before = (packages / run.KERNELS).stat()
    run.prepare(["base", "gui"], True)
    assert (packages / run.KERNELS).stat() == before and "not used" not in capsys.readouterr().err
    # it is no package of the lock: the environment is whole without it
    for name in of_kernels(run):
        os.rename(packages / name, tmp_path / name)
    calls = len(run.calls)
    run.prepare(["base", "gui"], True)
    assert len(run.calls) == calls and len(of_kernels(run)) == 2


@pytest.mark.shows("install.wheel")
def test_that_machine_code_of_other_sources_is_replaced_and_not_taken(run, wheel, capsys):
    packages = Path(run.site_packages())
    for name in (run.KERNELS, run.KERNELS + "-0.1+0123.dist-info", run.KERNELS + ".left"):
        (packages / name).mkdir()
        (packages / name / "old").write_text("")
    run.prepare(["base"], True)
    assert len(of_kernels(run)) == 2 and not (packages / run.KERNELS / "old").exists()
    for old, new in (("+", "+0"), ("-cp3", "-cp2"), ("_x86_64", "_s390x"), ("0.", "1.")):
        for name in of_kernels(run):
            shutil.rmtree(packages / name)
        other = wheel.with_name(wheel.name.replace(old, new, 1))
        if other != wheel:
            wheel.rename(other)
            run.prepare(["base"], True)
            assert of_kernels(run) == [] and "not used" not in capsys.readouterr().err
            other.rename(wheel)


@pytest.mark.shows("install.wheel")
@pytest.mark.parametrize(
    "member",
    ["numba/__init__.py", "run.pth", "ribalta_kernels/../a.py", "/a", "ribalta_kernels//a", "ribalta_kernels/.a",
     "ribalta_kernels-0.1.dist-info/METADATA", "ribalta_kernels.py"],
)  # fmt: skip
def test_that_a_wheel_with_anything_else_in_it_is_refused(run, wheel, capsys, member):
    with zipfile.ZipFile(wheel, "a") as archive:
        archive.writestr(member, b"print('mine')")
    before = contents(run.ENVIRONMENT)
    run.prepare(["base"], True)
    assert contents(run.ENVIRONMENT) == before
    assert f"{wheel} is not used ({member}): the solver is compiled" in capsys.readouterr().err


@pytest.mark.shows("install.wheel")
@pytest.mark.parametrize("step", [211, pytest.param(13, marks=pytest.mark.long)])
def test_that_a_damaged_wheel_is_one_sentence_and_leaves_nothing(run, wheel, capsys, step):
    good, before = wheel.read_bytes(), contents(run.ENVIRONMENT)
    flipped = [good[:k] + bytes([good[k] ^ 0x41]) + good[k + 1 :] for k in range(0, len(good), step)]
    refused = 0
    for content in (b"", good[: len(good) // 2], good[:-9], *flipped):
        wheel.write_bytes(content)
        run.prepare(["base"], True)
        if of_kernels(run):  # a time, or the like
            assert contents(Path(run.site_packages()) / run.KERNELS) and not capsys.readouterr().err
            for name in of_kernels(run):
                shutil.rmtree(os.path.join(run.site_packages(), name))
        else:
            said = capsys.readouterr().err
            assert said.count("\n") == 1 and "is not used (" in said and "used ()" not in said
            refused += 1
        assert contents(run.ENVIRONMENT) == before
    assert refused > len(flipped) / 2


@pytest.mark.shows("install.wheel")
@pytest.mark.skipif(os.name == "nt", reason="owners and modes of POSIX")
@pytest.mark.parametrize("harm", [0o002, "owner", "group", "a link"])
def test_that_a_wheel_others_can_write_is_not_taken(run, wheel, capsys, harm):
    for path in (wheel, wheel.parent):
        mode = path.stat().st_mode
        if harm == "a link":
            path.rename(path.with_name("moved"))
            path.symlink_to(path.with_name("moved"))
        elif harm == 0o002:
            path.chmod(mode | harm)
        elif os.getuid() == 0:
            path.chmod(mode | 0o020 * (harm == "group"))
            os.chown(path, *((12345, -1) if harm == "owner" else (-1, 12345)))
        else:
            pytest.skip("only root gives a file away")
        run.prepare(["base"], True)
        assert of_kernels(run) == [] and "others can write there" in capsys.readouterr().err
        if harm == "a link":
            path.unlink()
            path.with_name("moved").rename(path)
        else:
            os.chown(path, os.getuid(), os.getgid())
            path.chmod(mode)
    run.prepare(["base"], True)
    assert of_kernels(run)


@pytest.mark.skipif(os.name == "nt" or os.getuid() != 0, reason="only root gives a file away")
def test_that_a_wheel_may_be_written_by_the_group_that_can_write_the_sources(run, wheel, tmp_path, monkeypatch):
    """As a user's own group on some systems of Linux: they could change run.py as well."""
    sources = tmp_path / "sources"
    sources.mkdir()
    sources.chmod(0o775)
    wheel.chmod(0o664)
    assert not run.guarded(wheel)
    monkeypatch.setattr(run, "ROOT", str(sources))
    assert run.guarded(wheel)
    os.chown(sources, -1, 12345)
    assert not run.guarded(wheel)


def test_that_only_the_program_starts_with_packages_of_another_lock(run):
    for words in ([], ["--batch", EXAMPLE], ["--study", "paper"]):
        assert run.plan(words)[2]
    for words in (["test"], ["bench"], ["mutate"], ["fuzz"], ["package"]):
        assert not run.plan(words)[2]


@pytest.mark.shows("install.environment")
def test_that_each_word_installs_what_it_needs_and_no_more(run, tmp_path):
    stated = tmp_path / "stated.toml"
    stated.write_text("[analysis]\naccuracy = true\n")
    drawn = tmp_path / "drawn.toml"
    drawn.write_text('[[wall]]\nname = "w"\n[[wall.drawing]]\nfile = "w.dxf"\n')
    (tmp_path / "w.dxf").write_text("")
    long, high = tmp_path / "long.toml", tmp_path / "high.toml"
    long.write_text('walls = "long.csv"\n')
    high.write_text('walls = "high.csv"\n[building]\nstoreys = 30\n')
    (tmp_path / "long.csv").write_text("name\n" + "w\n" * 10_001)
    (tmp_path / "high.csv").write_text("name\n" + "w\n" * 200)
    from openpyxl import Workbook

    for rows in (150, 900):
        book = Workbook()
        for k in range(rows):
            book.active.append([f"wall {k}", 3.0 + 0.01 * k, 0.4, "two_sided", "restrained by the transverse walls"])
        book.save(tmp_path / f"of_{rows}.xlsx")
        (tmp_path / f"of_{rows}.toml").write_text(f'walls = "of_{rows}.xlsx"\n')
    assert (tmp_path / "of_150.xlsx").stat().st_size > 8000  # more bytes than 10 000 results were once taken for
    for words, extras in (
        (["--batch", EXAMPLE], []),
        (["--inspect", "a.txt"], []),
        (["--inspect", "a.txt", "b.DXF"], ["dxf"]),
        (["--inspect", str(tmp_path)], ["dxf"]),
        (["--batch", str(drawn)], ["dxf"]),
        (["--batch", EXAMPLE, "--report", "a.docx"], ["report"]),
        (["--batch", str(stated)], ["accuracy"]),
        (["--study=law"], ["study"]),
        ([EXAMPLE], ["gui", "accuracy", "study", "report", "dxf"]),
        (["fuzz", "case", "--seconds", "3"], ["test"]),
        (["bench", "--zeta"], ["test", "gui", "accuracy", "study", "report", "dxf"]),
        (["bench", "--work-precision"], ["test", "gui", "accuracy", "study", "report", "dxf", "bench"]),
        (["bench", "--memory", "--walls", "9"], ["test", "gui", "accuracy", "study", "report", "dxf", "parquet"]),
        (["bench", "--scale"], ["test", "gui", "accuracy", "study", "report", "dxf", "parquet"]),
        (["--batch", EXAMPLE, "--scheduler", "local:2"], ["scheduler"]),
        (["--batch", str(long), "--scheduler", "tcp://h:8786"], ["scheduler", "parquet"]),
        (["--batch", str(long)], ["parquet"]),
        (["--batch", str(long), "--merge"], ["parquet"]),
        (["--batch", str(long), "--part", "1/2"], []),
        (["--batch", str(high)], ["parquet"]),
        (["--batch", str(tmp_path / "of_150.toml")], []),
        (["--batch", str(tmp_path / "of_900.toml")], ["parquet"]),
    ):
        assert run.plan(words)[0] == ["base", *extras], words


@pytest.mark.shows("batch.code_2")
@pytest.mark.parametrize(
    "words, code, said",
    [
        (["--bacth", EXAMPLE], 2, "not known here: --bacth; did you mean --batch?"),
        (["tset"], 2, "unknown word tset: did you mean test?"),
        (["bench", "--work-precison"], 2, "did you mean --work-precision?"),
        (["fuzz", "--second=3"], 2, "did you mean --seconds?"),
        (["--batch", "nowhere.toml"], 1, "nowhere.toml: there is no such case file"),
        (["nowhere.toml"], 1, "nowhere.toml: there is no such case file"),
        (["--study", "papr"], 1, "papr: there is no such study: paper, law"),
        (["--batch", EXAMPLE, "--report", "a.odt"], 1, "a.odt is neither a PDF nor a Word document"),
        (["--batch", EXAMPLE, "--quick"], 2, "--quick and --pack go with --study"),
        (["--batch"], 2, "--batch takes a value"),
        (["--version"], 0, "Ribalta 0."),
        (["--help"], 0, "python3 run.py fuzz"),
    ],
)
def test_that_a_typo_costs_nothing(tmp_path, words, code, said):
    """Words, options and files are looked at before anything is made or fetched."""
    environment = tmp_path / "env"
    found = subprocess.run(
        [sys.executable, ROOT / "run.py", *words],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=dict(os.environ, RIBALTA_ENV=str(environment)),
    )
    assert (found.returncode, list(tmp_path.iterdir())) == (code, [])
    assert said in found.stdout + found.stderr and "Traceback" not in found.stderr


CASE = "resources/cases/verdict.toml"
SENTENCES = {0: "", 1: "the environment cannot be made in", 2: "did you mean"}
"""Exit code of a start that can install nothing -> what it prints to stderr."""

STARTS = (
    ([], 1),
    ([CASE], 1),
    (["--batch", CASE], 1),
    (["--batch", CASE, "--report", "note.pdf", "--resume", "--jobs", "2", "--quiet"], 1),
    (["--batch", CASE, "--part", "1/2"], 1),
    (["--batch", CASE, "--merge"], 1),
    (["--batch", CASE, "--scheduler", "local:2"], 1),
    (["--study", "paper", "--quick", "--pack"], 1),
    (["--inspect", CASE], 1),
    (["--extract", CASE], 1),
    (["--verify", CASE], 1),
    (["--validate"], 1),
    (["validate"], 1),
    (["--export-check", CASE], 1),
    (["test"], 1),
    (["test", "--newest"], 1),
    *(([word], 1) for word in load().TOOLS),
    (["--version"], 0),
    (["--help"], 0),
    (["--bacth", CASE], 2),
    (["tset"], 2),
)


def copy_sources(folder):
    """Copy what a checkout holds of the program, without an environment and without byte code."""
    for name in ("app", "core", "packaging", "resources", "tests"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("run.py", "requirements.lock"):
        shutil.copy(ROOT / name, folder / name)


@pytest.mark.shows("install.front_door")
def test_that_every_word_starts_with_a_python_that_has_nothing_installed(tmp_path):
    """With `-I -S` no package can be imported, and in a bare virtual environment none is there: a start ends in its own
    sentence, never in a traceback. Where nothing can be written, no word gets further than that sentence."""
    tree, bare = tmp_path / "tree", tmp_path / "bare"
    tree.mkdir()
    copy_sources(tree)
    subprocess.run([sys._base_executable, "-m", "venv", "--without-pip", bare], check=True)
    (tmp_path / "file").touch()
    variables = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    variables |= {"RIBALTA_ENV": str(tmp_path / "file" / "env"), "LC_ALL": "C.UTF-8"}
    pythons = [sys._base_executable, "-I", "-S"], [load().interpreter(str(bare))]

    def start(python, words):
        return subprocess.run([*python, "run.py", *words], cwd=tree, env=variables, capture_output=True, text=True)

    starts = [(python, words, code) for words, code in STARTS for python in pythons]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        ends = list(pool.map(lambda entry: start(*entry[:2]), starts))
    for (python, words, code), end in zip(starts, ends, strict=True):
        assert end.returncode == code, (python, words, end.stderr)
        assert SENTENCES[code] in end.stderr and "Traceback" not in end.stderr, (python, words, end.stderr)
        assert code != 1 or len(end.stderr.splitlines()) == 1, (python, words, end.stderr)
    spoken = {option for words, _ in STARTS for option in words if option.startswith("--")}
    options = {option for action in command_line.parser()._actions for option in action.option_strings}
    assert spoken >= options - {"-h", "--output", "--records", "--data", "--force"}


def test_that_the_contract_of_the_start_names_all_that_run_py_imports():
    """The contract forbids packages to the modules it names: run.py imports no other of ours."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = project["tool"]["importlinter"]["contracts"]
    contract = next(rule for rule in contracts if rule["name"].startswith("what run.py imports"))
    imported = set()
    for source in (ROOT / "run.py", ROOT / "packaging" / "platforms.py"):
        for node in nodes_of(source):
            if isinstance(node, ast.ImportFrom) and node.module.startswith(("app", "core")):
                named = {f"{node.module}.{alias.name}" for alias in node.names}
                imported |= named if node.module == "app.terminal" else {node.module}
    sources = tuple(contract["source_modules"])
    assert imported and all(f"{name}.".startswith(tuple(f"{source}." for source in sources)) for name in imported)
    base = {re.match(r"[\w-]+", package)[0] for package in project["project"]["dependencies"]}
    assert base <= set(contract["forbidden_modules"])


def test_that_run_py_speaks_the_language_of_the_system(tmp_path):
    found = subprocess.run(
        [sys.executable, ROOT / "run.py", "tset"],
        capture_output=True,
        text=True,
        env=dict(os.environ, RIBALTA_ENV=str(tmp_path / "env"), LC_ALL="it_IT.UTF-8"),
    )
    assert found.stderr == "run.py: parola sconosciuta tset: si intendeva test?\n"
    assert set(LANGUAGES) == {"en", "it"}


@pytest.mark.shows("install.environment")
def test_that_only_wheels_are_installed_and_the_size_is_said_before(run, capsys):
    run.ensure(["base", "gui"])
    pip = run.calls[-1]
    assert pip[pip.index("--only-binary") + 1] == ":all:" and "--require-hashes" in pip
    said = capsys.readouterr().err
    assert re.search(r"installing base, gui: 1\d\d MB to fetch, 5\d\d MB on the disk, about 3 min", said)


@pytest.mark.parametrize("terminal", [True, False])
def test_that_packages_are_counted_while_pip_fetches_them(run, monkeypatch, capsys, terminal):
    fresh = load()
    os.makedirs(os.path.dirname(fresh.LOG), exist_ok=True)
    lines = "Collecting numpy==2.4.6 (from -r x)\nDownloading\nCollecting numba==0.68.1\nInstalling collected packages"
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal, raising=False)
    monkeypatch.setattr(fresh, "BETWEEN_WORDS", 0.0)
    fresh.logged([sys.executable, "-c", f"print({lines!r})"], "no", total=2)
    said = [line.strip() for line in re.split(r"run\.py: ", capsys.readouterr().err) if line.strip()]
    assert said == ["1 of 2 packages: numpy", "2 of 2 packages: numba", "unpacking"]
    with open(fresh.LOG) as stream:
        assert stream.read() == lines + "\n"


def test_that_a_kill_between_the_two_moves_loses_no_environment(run, monkeypatch):
    run.ensure(["base"])
    before = contents(run.ENVIRONMENT)
    of_another_lock(run, monkeypatch)
    move = os.rename

    def killed(source, target):
        if source == run.NEXT:
            raise KeyboardInterrupt
        move(source, target)

    monkeypatch.setattr(run.os, "rename", killed)
    with pytest.raises(KeyboardInterrupt):
        run.ensure(["base"])
    assert not os.path.exists(run.ENVIRONMENT)
    monkeypatch.setattr(run.os, "rename", move)
    run.offline = True
    calls = len(run.calls)
    run.take_back()
    assert contents(run.ENVIRONMENT) == before
    run.ensure(["base"])  # the new one was whole
    assert len(run.calls) == calls and set(run.installed_groups()) == {"base"}


def test_that_an_environment_in_use_is_not_lost_and_the_new_one_waits(run, monkeypatch):
    """On Windows a folder is not moved while a program runs from it."""
    run.ensure(["base"])
    before = contents(run.ENVIRONMENT)
    of_another_lock(run, monkeypatch)
    move = os.rename
    for held in (run.ENVIRONMENT, run.NEXT):

        def refused(source, target, held=held):
            if source == held:
                raise PermissionError(13, "Access is denied")
            move(source, target)

        monkeypatch.setattr(run.os, "rename", refused)
        with pytest.raises(run.Failure, match=r"Access is denied; .* end the programs that run"):
            run.ensure(["base"])
        assert contents(run.ENVIRONMENT) == before
    monkeypatch.setattr(run.os, "rename", move)
    run.ensure(["base"])
    assert len(run.calls) == 4 and set(run.installed_groups()) == {"base"}


@pytest.mark.shows("install.foreign")
@pytest.mark.parametrize("place", ["ENVIRONMENT", "NEXT", "PREVIOUS"])
def test_that_no_environment_of_another_tool_is_emptied(run, monkeypatch, place):
    """As `uv run` makes one: `.venv` of the project is none of ours without the mark."""
    monkeypatch.delenv("RIBALTA_ENV")
    folder = getattr(run, place)
    os.makedirs(os.path.join(folder, "lib"))
    for name in ("pyvenv.cfg", "lib/module.py"):
        with open(os.path.join(folder, name), "w") as stream:
            stream.write("mine")
    before = contents(folder)
    with pytest.raises(run.Failure, match="was not made by run.py and stays as it is: move it away"):
        run.ensure(["base"], older_serves=True)
    assert contents(folder) == before and not run.calls


def test_that_the_scripts_of_an_environment_name_the_place_it_was_moved_to(run, tmp_path):
    """A real one: pip is a script, and runs where it lies."""
    fresh = load()
    fresh.install = lambda groups, folder, have: None
    fresh.replace_environment(["base"])
    scripts = os.path.dirname(fresh.interpreter())
    pip = os.path.join(scripts, "pip.exe" if os.name == "nt" else "pip")
    found = subprocess.run([pip, "--version"], capture_output=True, text=True, check=True)
    assert os.path.join(fresh.ENVIRONMENT, "") in found.stdout
    for file in Path(scripts).iterdir():
        assert file.is_symlink() or os.fsencode(fresh.NEXT) not in file.read_bytes()


@pytest.mark.shows("install.foreign")
def test_that_a_folder_of_the_user_is_never_deleted(run):
    os.makedirs(run.ENVIRONMENT)
    precious = os.path.join(run.ENVIRONMENT, "thesis.tex")
    open(precious, "w").close()
    with pytest.raises(run.Failure, match="was not made by run.py"):
        run.ensure(["base"])
    assert os.path.exists(precious)


def test_that_an_environment_of_another_program_is_refused_not_deleted(run):
    os.makedirs(os.path.join(run.ENVIRONMENT, "lib"))
    for name in ("pyvenv.cfg", "lib/precious.py"):
        with open(os.path.join(run.ENVIRONMENT, name), "w") as stream:
            stream.write("mine")
    with pytest.raises(run.Failure, match="stays as it is"):
        run.ensure(["base"])
    assert os.path.exists(os.path.join(run.ENVIRONMENT, "lib", "precious.py")) and not run.calls


def test_that_results_of_the_program_are_no_environment(run):
    """The window exports `ribalta.json` by default: a name is no proof."""
    os.makedirs(run.ENVIRONMENT)
    for name, content in (("ribalta.json", '{"program": {}}'), ("thesis.txt", "mine")):
        with open(os.path.join(run.ENVIRONMENT, name), "w") as stream:
            stream.write(content)
    with pytest.raises(run.Failure, match="stays as it is"):
        run.ensure(["base"])
    assert sorted(os.listdir(run.ENVIRONMENT)) == ["ribalta.json", "thesis.txt"]


def test_that_what_a_kill_left_of_an_environment_of_ours_is_made_anew(run):
    os.makedirs(run.ENVIRONMENT)
    open(os.path.join(run.ENVIRONMENT, run.MARK), "w").close()
    open(os.path.join(run.ENVIRONMENT, "half"), "w").close()
    run.ensure(["base"])
    assert not os.path.exists(os.path.join(run.ENVIRONMENT, "half"))


@pytest.mark.shows("install.failure")
def test_that_a_package_that_differs_from_the_lock_is_not_a_matter_of_the_network(run):
    fresh = load()
    os.makedirs(os.path.dirname(fresh.LOG), exist_ok=True)
    words = "ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE."
    command = [sys.executable, "-c", f"print({words!r}); raise SystemExit(1)"]
    with pytest.raises(fresh.Failure, match="not the one named in requirements.lock"):
        fresh.logged(command, "the installation failed: check the network")


def test_that_a_place_that_cannot_be_written_is_one_sentence(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    found = subprocess.run(
        [sys.executable, ROOT / "run.py", "--batch", EXAMPLE],
        capture_output=True,
        text=True,
        env=dict(os.environ, RIBALTA_ENV=str(blocked / "env")),
    )
    assert found.returncode == 1
    assert found.stderr.count("\n") == 1
    assert "RIBALTA_ENV" in found.stderr


@pytest.mark.shows("install.failure")
def test_that_a_failed_installation_is_one_sentence_with_its_log(run, monkeypatch, capsys):
    fresh = load()
    os.makedirs(os.path.dirname(fresh.LOG), exist_ok=True)
    command = [sys.executable, "-c", "print('ERROR: no network'); raise SystemExit(1)"]
    with pytest.raises(fresh.Failure, match="the installation failed .*ERROR: no network"):
        fresh.logged(command, "the installation failed")


@pytest.mark.parametrize("module", ["venv", "ensurepip"])
def test_that_a_python_without_venv_is_one_sentence(run, monkeypatch, module):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(run.Failure, match=f"lacks the module {module}"):
        run.ensure(["base"])


def test_that_two_starts_take_turns(run, tmp_path):
    """A second process waits while this one holds the lock, and then goes on."""
    script = (
        "import importlib.util, sys\n"
        f"d = importlib.util.spec_from_file_location('run', {str(ROOT / 'run.py')!r})\n"
        "m = importlib.util.module_from_spec(d); d.loader.exec_module(m)\n"
        "with m.environment_lock(): print('mine', flush=True)\n"
    )
    with run.environment_lock():
        other = subprocess.Popen(
            [sys.executable, "-c", script],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=dict(os.environ, RIBALTA_ENV=run.ENVIRONMENT),
        )
        assert "waiting" in other.stderr.readline()
        assert other.poll() is None
    out, _ = other.communicate(timeout=30)
    assert out == "mine\n"


@pytest.mark.shows("install.environment")
def test_that_the_lock_is_hashed_and_names_no_address():
    text = (ROOT / "requirements.lock").read_text()
    assert "://" not in text and "file:" not in text
    pins = [line for line in text.splitlines() if "==" in line]
    assert len(pins) > 20
    for block in text.split("\n# [")[0].split("\n")[1:]:
        assert "==" in block or "--hash=sha256:" in block


def test_that_the_lock_holds_every_dependency_of_the_project(run):
    import re
    import tomllib

    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    sections = run.lock_sections()
    base = sections["base"].lower()
    for wanted in project["dependencies"]:
        assert re.match(r"[\w-]+", wanted)[0].lower() + "==" in base
    for group, wanted in project["optional-dependencies"].items():
        for entry in wanted:
            assert re.match(r"[\w-]+", entry)[0].lower() + "==" in sections[group].lower() + base


def python(*lines):
    """A command that runs these lines."""
    return [sys.executable, "-c", "\n".join(lines)]


WAITS = "import os, time\nend = time.monotonic() + 60\nwhile not os.path.exists({!r}): assert time.monotonic() < end"


def test_that_types_are_checked_beside_the_tests_and_told_after_them(run, tmp_path, capfd):
    """Each of the two waits for a file of the other."""
    one, two = str(tmp_path / "one"), str(tmp_path / "two")
    types = python(f"open({one!r}, 'w')", WAITS.format(two), "print('types')")
    tests = python(WAITS.format(one), f"open({two!r}, 'w')", "print('tests')")
    assert run.in_turn([python("print('style')"), types, tests]) == 0
    assert capfd.readouterr().out.split() == ["style", "tests", "types"]


@pytest.mark.parametrize(
    ("fails", "said"),
    [("style", ["style"]), ("types", ["style", "tests", "types"]), ("tests", ["style", "tests", "types"])],
)
def test_that_one_step_that_fails_fails_the_whole(run, capfd, fails, said):
    steps = [
        python(f"print({name!r})", f"raise SystemExit({3 * (name == fails)})") for name in ("style", "types", "tests")
    ]
    assert run.in_turn(steps) == 3
    assert capfd.readouterr().out.split() == said


def test_that_types_are_the_step_beside_the_tests(run):
    *_, beside, last = run.test_steps([])
    assert (beside[2], last[2]) == ("mypy", "pytest") and len(run.test_steps(["tests"])) == 1
