#!/usr/bin/env python3
"""Start Ribalta on a machine that has only Python: make the environment, install, run.

    python3 run.py [CASE]          open the window
    python3 run.py --batch CASE    run a case without a window (see --help)
    python3 run.py --study paper   the parametric study of the paper; law, or a file of one's own
    python3 run.py test [...]      ruff, import contracts, mypy, pytest
    python3 run.py package         the frozen program in dist/ribalta, tried
    python3 run.py bench [...]     the benchmarks; --work-precision for error against time
    python3 run.py mutate [...]    small faults in the modules that decide: do the tests find them?
    python3 run.py fuzz [...]      hostile input for everything that reads, as long as asked

The environment is .venv beside this file, or the folder named by RIBALTA_ENV. Standard library only.
"""

import contextlib
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.abspath(__file__))
ENVIRONMENT = os.path.abspath(os.environ.get("RIBALTA_ENV") or os.path.join(ROOT, ".venv"))
STAMP = os.path.join(ENVIRONMENT, "ribalta.json")
MARK = os.path.join(ENVIRONMENT, "ribalta-environment")
LOG = ENVIRONMENT + ".log"
MIN_PYTHON = (3, 11)


class Failure(Exception):
    """The environment cannot be made: one sentence with the cause and the way out."""


def lock_sections():
    """Group -> its lines of requirements.lock."""
    with open(os.path.join(ROOT, "requirements.lock"), encoding="ascii") as stream:
        parts = re.split(r"^# \[(\w+)\]\n", stream.read(), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))  # noqa: B905  (an old Python must reach our sentence)


def interpreter():
    """The environment's Python."""
    if os.name == "nt":
        return os.path.join(ENVIRONMENT, "Scripts", "python.exe")
    return os.path.join(ENVIRONMENT, "bin", "python")


def site_packages():
    if os.name == "nt":
        return os.path.join(ENVIRONMENT, "Lib", "site-packages")
    version = "python{}.{}".format(*sys.version_info[:2])
    return os.path.join(ENVIRONMENT, "lib", version, "site-packages")


def identity(lines):
    """What a group must have been installed from."""
    return hashlib.sha256((sys.version + sys.platform + lines).encode()).hexdigest()


def installed_groups():
    """Groups installed from the lock as it is now; empty where the environment is not whole."""
    try:
        with open(STAMP, encoding="utf-8") as stream:
            stamp = json.load(stream)
        folder = site_packages()
        whole = os.path.exists(interpreter()) and all(
            os.path.exists(os.path.join(folder, name)) for name in stamp["contents"]
        )
        groups = stamp["groups"] if whole else {}
    except (OSError, ValueError, KeyError, TypeError):
        return {}
    sections = lock_sections()
    current = {name for name, key in groups.items() if identity(sections.get(name, "")) == key}
    return {name: groups[name] for name in current} if "base" in current else {}


@contextlib.contextmanager
def environment_lock():
    """Two starts at once take turns: the second waits for the first one's environment."""
    path = ENVIRONMENT + ".lock"
    try:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        stream = open(path, "a")  # noqa: SIM115  (held to the end of the block)
    except OSError as error:
        raise Failure(
            f"the environment cannot be made in {ENVIRONMENT}: {error.strerror}; "
            "name a folder you can write in the variable RIBALTA_ENV"
        ) from None
    announced = False
    with stream:
        while True:
            try:
                if os.name == "nt":
                    import msvcrt

                    msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
                else:
                    import fcntl

                    fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except OSError:
                if not announced:
                    say("another start is preparing the environment: waiting for it")
                    announced = True
                time.sleep(0.2)
        yield


def say(sentence):
    print("run.py: " + sentence, file=sys.stderr, flush=True)


def ensure(groups):
    """Make the environment hold these groups; does nothing where it does."""
    if all(group in installed_groups() for group in groups):
        return
    with environment_lock():
        have = installed_groups()
        missing = [group for group in groups if group not in have]
        if not missing:
            return
        try:
            if not have:
                create()
            install(missing)
            have.update({name: identity(lock_sections()[name]) for name in missing})
            contents = [name for name in os.listdir(site_packages()) if name != "__pycache__"]
            with open(STAMP, "w", encoding="utf-8") as stream:
                json.dump({"groups": have, "contents": contents}, stream)
        except OSError as error:
            raise Failure(
                f"the environment cannot be written in {ENVIRONMENT}: {error.strerror}; "
                "free some space or name another folder in the variable RIBALTA_ENV"
            ) from None


def made_here():
    """Whether run.py made the folder of the environment: by its mark, by the stamp of an earlier version beside
    a pyvenv.cfg, or since it is .venv of this project."""
    config = os.path.isfile(os.path.join(ENVIRONMENT, "pyvenv.cfg"))
    if os.path.isfile(MARK) or (config and "RIBALTA_ENV" not in os.environ):
        return True
    try:
        with open(STAMP, encoding="utf-8") as stream:
            stamp = json.load(stream)
        return config and set(stamp) == {"groups", "contents"}
    except (OSError, ValueError, TypeError):
        return False


def create():
    """A new, empty environment; an old or broken one goes first."""
    for module in ("venv", "ensurepip"):
        try:
            __import__(module)
        except ImportError:
            raise Failure(
                f"this Python lacks the module {module}: install it (Debian and Ubuntu: apt install "
                "python3-venv) or start with a Python from python.org"
            ) from None
    if os.path.exists(ENVIRONMENT):
        if not os.path.isdir(ENVIRONMENT) or (os.listdir(ENVIRONMENT) and not made_here()):
            raise Failure(
                f"{ENVIRONMENT} was not made by run.py and stays as it is: name another folder, empty or new, "
                "in the variable RIBALTA_ENV"
            )
        for name in os.listdir(
            ENVIRONMENT
        ):  # the mark last, so that a kill leaves it known as ours
            path = os.path.join(ENVIRONMENT, name)
            if os.path.isdir(path) and not os.path.islink(path):
                shutil.rmtree(path)
            elif path != MARK:
                os.unlink(path)
    os.makedirs(ENVIRONMENT, exist_ok=True)
    with open(
        MARK, "w", encoding="utf-8"
    ) as stream:  # first of all, so that what a kill leaves is known
        stream.write("made by run.py, which may delete it\n")
    say(f"making the environment in {ENVIRONMENT} (once)")
    logged([sys.executable, "-m", "venv", ENVIRONMENT], "the environment could not be made")


def install(groups):
    """Install groups of the lock, every file checked against its hash."""
    sections = lock_sections()
    with tempfile.TemporaryDirectory() as folder:
        wanted = os.path.join(folder, "requirements.txt")
        with open(wanted, "w", encoding="ascii") as stream:
            stream.write("".join(sections[group] for group in groups))
        say("installing {} (once)".format(", ".join(groups)))
        logged(
            [interpreter(), "-m", "pip", "install", "--disable-pip-version-check", "--no-input",
             "--require-hashes", "--no-deps", "-r", wanted],
            "the installation failed: check the network or the proxy settings of pip",
        )  # fmt: skip


def logged(command, trouble):
    """Run a command with its output in the log; raises Failure naming the log and its last line."""
    try:
        with open(LOG, "w", encoding="utf-8", errors="replace") as log:
            code = subprocess.call(command, stdout=log, stderr=subprocess.STDOUT)
    except OSError as error:
        raise Failure(f"{trouble}: {error}") from None
    if code:
        with open(LOG, encoding="utf-8", errors="replace") as log:
            lines = [line.strip() for line in log if line.strip()]
        cause = next(
            (line for line in reversed(lines) if "ERROR" in line), (lines or ["no word"])[-1]
        )
        if any("DO NOT MATCH THE HASHES" in line for line in lines):
            trouble = "the installation was refused: a package served is not the one requirements.lock names"
        raise Failure(f"{trouble} ({cause[:200]}); the whole output is in {LOG}")


def environment():
    """Variables of the program: the tree on its path, nothing from the user's packages."""
    variables = dict(os.environ, PYTHONPATH=ROOT, PYTHONNOUSERSITE="1")
    variables.pop("PYTHONHOME", None)
    return variables


def hand_over(command):
    """Become the program where the system can, else wait for it."""
    if os.name == "nt":
        return subprocess.call(command, env=environment())
    if sys.stdout:
        sys.stdout.flush()
    return os.execve(command[0], command, environment())


def test(arguments):
    """Style, import contracts, types, tests; the first failure's exit code."""
    python = interpreter()
    scripts = os.path.dirname(python)
    steps = [
        [python, "-m", "ruff", "check", "--no-cache", "."],
        [python, "-m", "ruff", "format", "--no-cache", "--check", "."],
        [os.path.join(scripts, "lint-imports"), "--no-cache"],
        [python, "-m", "mypy", "--cache-dir", os.devnull],
    ]
    if arguments:
        steps = []
    steps.append([python, "-m", "pytest", *arguments])
    for step in steps:
        code = subprocess.call(step, cwd=ROOT, env=environment())
        if code:
            return code
    return 0


def main():
    if sys.version_info[:2] < MIN_PYTHON:
        raise Failure(
            "Python {}.{} is too old: Ribalta needs 3.11 or newer (python.org)".format(
                *sys.version_info[:2]
            )
        )
    arguments = sys.argv[1:]
    word = arguments[0] if arguments else ""
    if word == "test":
        ensure(["base", "test", "gui", "study", "report"])
        return test(arguments[1:])
    if word == "bench":
        ensure(["base", "test", "gui", "study", "report", "bench"])
        script = os.path.join(ROOT, "tests", "benchmarks", "bench.py")
        return hand_over([interpreter(), "-P", script, *arguments[1:]])
    if word in ("mutate", "fuzz"):
        ensure(["base", "test"])
        folder = {"mutate": "mutation", "fuzz": "fuzz"}[word]
        script = os.path.join(ROOT, "tests", folder, word + ".py")
        return hand_over([interpreter(), "-P", script, *arguments[1:]])
    if word == "package":
        ensure(["base", "gui", "study", "report", "package"])
        script = os.path.join(ROOT, "packaging", "build.py")
        return hand_over([interpreter(), "-P", script, *arguments[1:]])
    headless = {"--batch", "--study", "--inspect", "--version", "--help", "-h"}
    windowed = not any(argument.split("=")[0] in headless for argument in arguments)
    asked = {argument.split("=")[0] for argument in arguments}
    more = [name for name in ("study", "report") if "--" + name in asked]
    ensure(["base", "gui", "study", "report"] if windowed else ["base", *more])
    return hand_over([interpreter(), "-P", "-m", "app", *arguments])


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failure as failure:
        say(str(failure))
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
