"""run.py: what it does before anything is installed."""

import importlib.util
import json
import os
import subprocess
import sys

import pytest

from tests.conftest import ROOT


@pytest.fixture
def run(tmp_path, monkeypatch):
    """run.py as a module whose environment is a folder of the test; nothing is installed."""
    monkeypatch.setenv("RIBALTA_ENV", str(tmp_path / "env"))
    description = importlib.util.spec_from_file_location("run", ROOT / "run.py")
    module = importlib.util.module_from_spec(description)
    description.loader.exec_module(module)
    calls = []

    def logged(command, trouble):
        calls.append(command)
        if "venv" in command:
            os.makedirs(module.site_packages())
            os.makedirs(os.path.dirname(module.interpreter()), exist_ok=True)
            open(module.interpreter(), "w").close()
            open(os.path.join(module.ENVIRONMENT, "pyvenv.cfg"), "w").close()
        else:
            os.makedirs(os.path.join(module.site_packages(), f"package{len(calls)}"))

    module.logged = logged
    module.calls = calls
    return module


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
    os.rmdir(os.path.join(run.site_packages(), "package2"))
    assert run.installed_groups() == {}
    run.ensure(["base"])
    assert len(run.calls) == 4
    os.unlink(run.interpreter())
    run.ensure(["base"])
    assert len(run.calls) == 6
    with open(run.STAMP, "w") as stream:
        stream.write("{half")
    run.ensure(["base"])
    assert len(run.calls) == 8


def test_that_an_outdated_environment_is_rebuilt(run):
    run.ensure(["base"])
    with open(run.STAMP) as stream:
        stamp = json.load(stream)
    stamp["groups"]["base"] = "of another lock"
    with open(run.STAMP, "w") as stream:
        json.dump(stamp, stream)
    run.ensure(["base"])
    assert len(run.calls) == 4


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
    open(run.MARK, "w").close()
    open(os.path.join(run.ENVIRONMENT, "half"), "w").close()
    run.ensure(["base"])
    assert not os.path.exists(os.path.join(run.ENVIRONMENT, "half"))


def test_that_a_package_that_differs_from_the_lock_is_not_a_matter_of_the_network(run):
    description = importlib.util.spec_from_file_location("again", ROOT / "run.py")
    fresh = importlib.util.module_from_spec(description)
    description.loader.exec_module(fresh)
    os.makedirs(os.path.dirname(fresh.LOG), exist_ok=True)
    words = "ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE."
    command = [sys.executable, "-c", f"print({words!r}); raise SystemExit(1)"]
    with pytest.raises(fresh.Failure, match="not the one requirements.lock names"):
        fresh.logged(command, "the installation failed: check the network")


def test_that_a_place_that_cannot_be_written_is_one_sentence(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    found = subprocess.run(
        [sys.executable, ROOT / "run.py", "--version"], capture_output=True, text=True,
        env=dict(os.environ, RIBALTA_ENV=str(blocked / "env")),
    )  # fmt: skip
    assert found.returncode == 1
    assert found.stderr.count("\n") == 1
    assert "RIBALTA_ENV" in found.stderr


def test_that_a_failed_installation_is_one_sentence_with_its_log(run, monkeypatch, capsys):
    description = importlib.util.spec_from_file_location("again", ROOT / "run.py")
    fresh = importlib.util.module_from_spec(description)
    description.loader.exec_module(fresh)
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
            [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, env=dict(os.environ, RIBALTA_ENV=run.ENVIRONMENT),
        )  # fmt: skip
        assert "waiting" in other.stderr.readline()
        assert other.poll() is None
    out, _ = other.communicate(timeout=30)
    assert out == "mine\n"


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
