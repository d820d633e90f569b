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
ENVIRONMENT = os.path.realpath(os.environ.get("RIBALTA_ENV") or os.path.join(ROOT, ".venv"))
NEXT, PREVIOUS = ENVIRONMENT + ".next", ENVIRONMENT + ".previous"
"""A new environment while it is made, and the one it replaces while it is deleted."""
STAMP, MARK = "ribalta.json", "ribalta-environment"
LOG = ENVIRONMENT + ".log"
MIN_PYTHON = (3, 11)


class Failure(Exception):
    """The environment cannot be made: one sentence with the cause and the way out."""


def lock_sections():
    """Group -> its lines of requirements.lock."""
    with open(os.path.join(ROOT, "requirements.lock"), encoding="ascii") as stream:
        parts = re.split(r"^# \[(\w+)\]\n", stream.read(), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))  # noqa: B905  (an old Python must reach our sentence)


def interpreter(folder=ENVIRONMENT):
    """The Python of an environment."""
    if os.name == "nt":
        return os.path.join(folder, "Scripts", "python.exe")
    return os.path.join(folder, "bin", "python")


def site_packages(folder=ENVIRONMENT):
    if os.name == "nt":
        return os.path.join(folder, "Lib", "site-packages")
    version = "python{}.{}".format(*sys.version_info[:2])
    return os.path.join(folder, "lib", version, "site-packages")


def identity(lines):
    """What a group must have been installed from."""
    return hashlib.sha256((sys.version + sys.platform + lines).encode()).hexdigest()


def stamped_groups(folder):
    """Group -> `identity` of the lines it was installed from; empty where the environment is not whole."""
    try:
        with open(os.path.join(folder, STAMP), encoding="utf-8") as stream:
            stamp = json.load(stream)
        packages = site_packages(folder)
        whole = os.path.exists(interpreter(folder)) and all(
            os.path.exists(os.path.join(packages, name)) for name in stamp["contents"]
        )
        return dict(stamp["groups"]) if whole else {}
    except (OSError, ValueError, KeyError, TypeError):
        return {}


def installed_groups(folder=ENVIRONMENT):
    """Groups of an environment that are of the lock as it is now; none where the base is not."""
    sections = lock_sections()
    groups = stamped_groups(folder)
    current = {name for name, key in groups.items() if identity(sections.get(name, "")) == key}
    return {name: groups[name] for name in current} if "base" in current else {}


def serves(groups):
    """Whether the environment, though of another lock, is whole and holds all packages of these groups, in some
    version."""
    if not set(groups) <= set(stamped_groups(ENVIRONMENT)):
        return False
    sections = lock_sections()
    lines = [line for group in groups for line in sections[group].split("\n") if "==" in line]
    named = {line.split("==")[0] for line in lines if " ; " not in line}
    there = {name.split("-")[0] for name in os.listdir(site_packages())}
    return all(_canonical(name) in map(_canonical, there) for name in named)


def _canonical(name):
    return re.sub("[-_.]+", "-", name).lower()


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


def ensure(groups, older_serves=False):
    """Make the environment hold these groups; does nothing where it does. older_serves : one of an earlier lock does
    where no other can be had, as after an update without a network."""
    if set(groups) <= set(installed_groups()):
        return
    try:
        with environment_lock():
            update(groups)
    except Failure as failure:
        if not (older_serves and serves(groups)):
            raise
        say(f"{failure}; started with the packages of an earlier version instead")


def update(groups):
    """Add what the environment lacks of these groups; where some of them are of another lock, replace it."""
    try:
        take_back()
        have = installed_groups()
        missing = [group for group in groups if group not in have]
        if have and not set(missing) & set(stamped_groups(ENVIRONMENT)):
            if missing:
                install(missing, ENVIRONMENT, have)
        else:
            replace_environment(groups)
    except OSError as error:
        raise Failure(
            f"the environment cannot be written in {ENVIRONMENT}: {error.strerror}; free some space, end the "
            "programs that run from it, or name another folder in the variable RIBALTA_ENV"
        ) from None


def refuse_if_not_ours(folder):
    """What run.py did not make, by its mark, is neither emptied nor moved."""
    ours = os.path.isfile(os.path.join(folder, MARK))
    if os.path.lexists(folder) and not (os.path.isdir(folder) and (ours or not os.listdir(folder))):
        raise Failure(
            f"{folder} was not made by run.py and stays as it is: move it away, or name another folder, empty or "
            "new, in the variable RIBALTA_ENV"
        )


def remove(folder):
    """Delete an environment; the mark last, so that what a kill leaves is known as ours."""
    if not os.path.isdir(folder):
        return
    for name in os.listdir(folder):
        path = os.path.join(folder, name)
        if os.path.isdir(path) and not os.path.islink(path):
            shutil.rmtree(path)
        elif name != MARK:
            os.unlink(path)
    shutil.rmtree(folder)


def take_back():
    """Put the environment back that a kill left moved away, before the new one was in its place."""
    if not os.path.lexists(ENVIRONMENT) and os.path.isfile(os.path.join(PREVIOUS, MARK)):
        os.rename(PREVIOUS, ENVIRONMENT)


def replace_environment(groups):
    """Make a new environment with these groups beside the one there is, then put it in its place."""
    for module in ("venv", "ensurepip"):
        try:
            __import__(module)
        except ImportError:
            raise Failure(
                f"this Python lacks the module {module}: install it (Debian and Ubuntu: apt install "
                "python3-venv) or start with a Python from python.org"
            ) from None
    for folder in (ENVIRONMENT, NEXT, PREVIOUS):
        refuse_if_not_ours(folder)
    remove(PREVIOUS)
    if not set(groups) <= set(installed_groups(NEXT)):  # else made before, and not put in its place
        remove(NEXT)
        try:
            make(NEXT, groups)
        except BaseException:
            shutil.rmtree(NEXT, ignore_errors=True)
            raise
    name_its_place(NEXT)
    if os.path.isdir(ENVIRONMENT):
        os.rename(ENVIRONMENT, PREVIOUS)
    try:
        os.rename(NEXT, ENVIRONMENT)
    except OSError:
        take_back()
        raise
    with contextlib.suppress(OSError):  # next time
        remove(PREVIOUS)


def make(folder, groups):
    """A new environment in a folder, with these groups."""
    os.makedirs(folder)
    with open(os.path.join(folder, MARK), "w", encoding="utf-8") as stream:  # first of all
        stream.write("made by run.py, which may delete it\n")
    say(f"making the environment in {ENVIRONMENT} (once)")
    prompt = os.path.basename(ENVIRONMENT)
    logged(
        [sys.executable, "-m", "venv", "--prompt", prompt, folder],
        "the environment could not be made",
    )
    install(groups, folder, {})


def name_its_place(folder):
    """Let the scripts of an environment name the place it is moved to."""
    scripts = os.path.dirname(interpreter(folder))
    for path in [os.path.join(scripts, name) for name in os.listdir(scripts)]:
        if os.path.isfile(path) and not os.path.islink(path):
            with open(path, "rb") as stream:
                content = stream.read()
            moved = content.replace(os.fsencode(folder), os.fsencode(ENVIRONMENT))
            if moved != content:
                with open(path, "wb") as stream:
                    stream.write(moved)


def install(groups, folder, have):
    """Install groups of the lock beside those an environment has, every file checked against its hash."""
    sections = lock_sections()
    with tempfile.TemporaryDirectory() as place:
        wanted = os.path.join(place, "requirements.txt")
        with open(wanted, "w", encoding="ascii") as stream:
            stream.write("".join(sections[group] for group in groups))
        say("installing {} (once)".format(", ".join(groups)))
        logged(
            [interpreter(folder), "-m", "pip", "install", "--disable-pip-version-check", "--no-input",
             "--require-hashes", "--no-deps", "-r", wanted],
            "the installation failed: check the network or the proxy settings of pip",
        )  # fmt: skip
    now = dict(have, **{name: identity(sections[name]) for name in groups})
    contents = [name for name in os.listdir(site_packages(folder)) if name != "__pycache__"]
    with open(os.path.join(folder, STAMP), "w", encoding="utf-8") as stream:
        json.dump({"groups": now, "contents": contents}, stream)


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
    every_core = ["-n", "auto", "--dist", "worksteal"]
    steps.append([python, "-m", "pytest", *(arguments or every_core)])
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
    groups = ["base", "gui", "study", "report"] if windowed else ["base", *more]
    ensure(groups, older_serves=True)
    return hand_over([interpreter(), "-P", "-m", "app", *arguments])


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failure as failure:
        say(str(failure))
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
