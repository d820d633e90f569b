#!/usr/bin/env python3
"""Start Ribalta on a machine that has only Python: make the environment, install, run.

    python3 run.py [CASE]          open the window
    python3 run.py --batch CASE    run a case without a window (see --help)
    python3 run.py --study paper   the parametric study of the paper; law, or a file of one's own
    python3 run.py test [...]      ruff, import contracts, mypy, pytest; --newest: under packages the lock forbids
    python3 run.py package         the frozen program in dist/ribalta, tried; --kernels: machine code for the sources
    python3 run.py bench [...]     the benchmarks; --work-precision for error against time
    python3 run.py docs            the documents as a site in dist/pages, its links checked
    python3 run.py mutate [...]    small faults in the modules that decide: do the tests find them?
    python3 run.py fuzz [...]      hostile input for everything that reads, as long as asked
    python3 run.py validate [--output DIR]   the solved cases; with --data DIR tests on a shake table
    python3 run.py robustness      all of these and kills, counted: hours, to be gone on with after a stop

The environment is .venv beside this file, or the folder named by RIBALTA_ENV. Standard library only.
"""

import contextlib
import difflib
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
import zlib

ROOT = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [path for path in (ROOT, os.path.join(ROOT, "packaging")) if path not in sys.path]
import platforms  # noqa: E402

from core.text.start import phrase, system_language  # noqa: E402

ENVIRONMENT = os.path.realpath(os.environ.get("RIBALTA_ENV") or os.path.join(ROOT, ".venv"))
NEXT, PREVIOUS = ENVIRONMENT + ".next", ENVIRONMENT + ".previous"
"""A new environment while it is made, and the one it replaces while it is deleted."""
STAMP, MARK = "ribalta.json", "ribalta-environment"
LOG = ENVIRONMENT + ".log"
DIST, KERNELS = os.path.join(ROOT, "dist"), "ribalta_kernels"
"""Where a wheel of machine code may stand (packaging/kernels.py), and its package."""
BETWEEN_WORDS = 10.0
"""Seconds between two lines of progress where they do not go to a terminal."""
TOOLS = {
    "bench": "tests/benchmarks/bench.py",
    "docs": "packaging/pages.py",
    "fuzz": "tests/fuzz/fuzz.py",
    "mutate": "tests/mutation/mutate.py",
    "package": "packaging/build.py",
    "robustness": "tests/robustness/robustness.py",
}
"""Words of a developer -> their script."""


class Failure(Exception):
    """What is asked cannot be done: one sentence with the cause and the way out; code : of the exit."""

    def __init__(self, sentence, code=1):
        super().__init__(sentence)
        self.code = code


def say(sentence, end="\n"):
    print("run.py: " + sentence, file=sys.stderr, flush=True, end=end)


def refuse_without_wheels(groups):
    """Raise Failure where this Python or system has no wheel of a package of these groups: pip would build it from its
    sources, or fail halfway."""
    sentence = platforms.refusal(groups)
    if sentence:
        raise Failure(sentence)


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
        text = (
            "the environment cannot be made in {folder}: {reason}; name a folder you can write in the variable "
            "RIBALTA_ENV"
        )
        raise Failure(phrase(text, folder=ENVIRONMENT, reason=error.strerror)) from None
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
                    say(phrase("another start is preparing the environment: waiting for it"))
                    announced = True
                time.sleep(0.2)
        yield


def ensure(groups, older_serves=False):
    """Make the environment hold these groups; does nothing where it does. older_serves : one of an earlier lock does
    where no other can be had, as after an update without a network."""
    if set(groups) <= set(installed_groups()):
        return
    refuse_without_wheels(groups)
    try:
        with environment_lock():
            update(groups)
    except Failure as failure:
        if not (older_serves and serves(groups)):
            raise
        say(phrase("{failure}; started with the packages of an earlier version instead", failure=failure))


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
        text = (
            "the environment cannot be written in {folder}: {reason}; free some space, end the programs that run "
            "from it, or name another folder in the variable RIBALTA_ENV"
        )
        raise Failure(phrase(text, folder=ENVIRONMENT, reason=error.strerror)) from None


def refuse_if_not_ours(folder):
    """What run.py did not make, by its mark, is neither emptied nor moved."""
    ours = os.path.isfile(os.path.join(folder, MARK))
    if os.path.lexists(folder) and not (os.path.isdir(folder) and (ours or not os.listdir(folder))):
        text = (
            "{folder} was not made by run.py and stays as it is: move it away, or name another folder, empty or "
            "new, in the variable RIBALTA_ENV"
        )
        raise Failure(phrase(text, folder=folder))


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
            text = (
                "this Python lacks the module {module}: install it (Debian and Ubuntu: apt install python3-venv) or "
                "start with a Python from python.org"
            )
            raise Failure(phrase(text, module=module)) from None
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
    say(phrase("making the environment in {folder} (once)", folder=ENVIRONMENT))
    prompt = os.path.basename(ENVIRONMENT)
    logged([sys.executable, "-m", "venv", "--prompt", prompt, folder], phrase("the environment could not be made"))
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
        names = packages_of(groups)
        fetch, disk = platforms.megabytes(names)
        text = (
            "installing {groups}: {fetch:.0f} MB to fetch, {disk:.0f} MB on the disk, about {minutes:.0f} minutes at "
            "10 Mbit/s (once)"
        )
        minutes = max(1, fetch * 8 / 10 / 60 + disk / 600)
        say(phrase(text, groups=", ".join(groups), fetch=fetch, disk=disk, minutes=minutes))
        logged(
            [
                interpreter(folder),
                "-m",
                "pip",
                "install",
                "--disable-pip-version-check",
                "--no-input",
                "--progress-bar",
                "off",
                "--only-binary",
                ":all:",
                "--require-hashes",
                "--no-deps",
                "-r",
                wanted,
            ],
            phrase("the installation failed: check the network or the proxy settings of pip"),
            len(names),
        )
    now = dict(have, **{name: identity(sections[name]) for name in groups})
    names = os.listdir(site_packages(folder))
    contents = [name for name in names if name != "__pycache__" and not name.startswith(KERNELS)]
    with open(os.path.join(folder, STAMP), "w", encoding="utf-8") as stream:
        json.dump({"groups": now, "contents": contents}, stream)


def take_kernels():
    """Put machine code made for these sources and this system, where its wheel stands in dist, into the
    environment; what hinders that is one sentence, and the program compiles its own."""
    name = wheel_of_kernels()
    wheel, about = os.path.join(DIST, name), name.rsplit("-", 3)[0] + ".dist-info"
    if not name or os.path.isdir(os.path.join(site_packages(), about)):
        return
    try:
        for path in (DIST, wheel):
            if not guarded(path):
                raise ValueError(phrase("others can write there"))
        with environment_lock(), zipfile.ZipFile(wheel) as archive:
            unpack_kernels(archive, about)
    except (OSError, ValueError, RuntimeError, EOFError, zipfile.BadZipFile, zlib.error, Failure) as error:
        text = "{file} is not used ({reason}): the solver is compiled at its first run"
        say(phrase(text, file=wheel, reason=str(error) or phrase("damaged")))


def wheel_of_kernels():
    """Name of the wheel in dist that was made for these sources and this system, "" where there is none."""
    end = f"-{platforms.tag()}.whl"
    if not os.path.isdir(DIST) or not any(name.endswith(end) for name in os.listdir(DIST)):
        return ""
    from core.jit.stamp import stamp
    from core.version import VERSION

    name = f"{KERNELS}-{VERSION}+{stamp()}{end}"
    return name if os.path.isfile(os.path.join(DIST, name)) else ""


def guarded(path):
    """Whether nobody can write a file or folder who cannot write run.py beside it: machine code is code."""
    if os.name == "nt":
        return True
    own, sources = os.lstat(path), os.stat(ROOT)
    same_group = own.st_gid == sources.st_gid or not own.st_mode & 0o020
    return own.st_uid in (0, os.getuid(), sources.st_uid) and same_group and not own.st_mode & 0o022 & ~sources.st_mode


def unpack_kernels(archive, about):
    """Unpack a wheel of machine code beside the packages, in place of an older one. about : its folder of metadata.
    Raises ValueError for what belongs to none, and what zipfile raises."""
    packages = site_packages()
    allowed = re.compile(f"({KERNELS}|{re.escape(about)})(/[\\w-][\\w.-]*)+")
    with tempfile.TemporaryDirectory(prefix=KERNELS + ".", dir=packages) as place:
        for member in archive.infolist():
            if not allowed.fullmatch(member.filename):
                raise ValueError(member.filename)
            path = os.path.join(place, *member.filename.split("/"))
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as stream:
                stream.write(archive.read(member))
        if set(os.listdir(place)) != {KERNELS, about}:
            raise ValueError
        for folder, _, files in os.walk(place):
            for path in [folder, *(os.path.join(folder, name) for name in files)]:
                os.chmod(path, os.stat(path).st_mode & ~0o022)
        for name in os.listdir(packages):
            if name.startswith(KERNELS) and name != os.path.basename(place):
                shutil.rmtree(os.path.join(packages, name))
        for name in (KERNELS, about):  # the one that says it is there last
            os.rename(os.path.join(place, name), os.path.join(packages, name))


def packages_of(groups):
    """Names of the packages of groups, each once: those of this Python and system, as far as a name tells."""
    sections = lock_sections()
    lines = [line for group in groups for line in sections[group].split("\n") if "==" in line]
    return {line.split("==")[0] for line in lines}


def logged(command, trouble, total=0):
    """Run a command with its output in the log, and say how many of a total of packages were fetched; raises Failure
    naming the log and its last line."""
    try:
        with open(LOG, "w", encoding="utf-8", errors="replace") as log:
            running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            with running:
                show = shown_progress(total)
                for line in iter(running.stdout.readline, b""):
                    log.write(line.decode("utf-8", "replace"))
                    show(line.decode("utf-8", "replace"))
            code = running.returncode
    except OSError as error:
        raise Failure(f"{trouble}: {error}") from None
    if code:
        with open(LOG, encoding="utf-8", errors="replace") as log:
            lines = [line.strip() for line in log if line.strip()]
        cause = next((line for line in reversed(lines) if "ERROR" in line), lines[-1] if lines else phrase("no word"))
        if any("DO NOT MATCH THE HASHES" in line for line in lines):
            trouble = phrase(
                "the installation was refused: a downloaded package is not the one named in requirements.lock"
            )
        text = "{trouble} ({cause}); the whole output is in {log}"
        raise Failure(phrase(text, trouble=trouble, cause=cause[:200], log=LOG))


def shown_progress(total):
    """A function of pip's lines that says what is fetched: over one line of a terminal, else now and then."""
    state = {"count": 0, "said": time.time()}
    terminal = sys.stderr is not None and sys.stderr.isatty()

    def show(line):
        if line.startswith("Collecting ") and total:
            state["count"] += 1
            name = re.split("[=<>~! ]", line[len("Collecting ") :], maxsplit=1)[0].strip()
            text = "{n} of {total} packages: {package}"
            sentence = phrase(text, n=min(state["count"], total), total=total, package=name)
        elif line.startswith("Installing collected") and total:
            sentence = phrase("unpacking")
            state["said"] = 0.0
        else:
            return
        if terminal:
            say("\r" + sentence.ljust(60), end="\n" if state["said"] == 0.0 else "")
        elif time.time() - state["said"] >= BETWEEN_WORDS:
            state["said"] = time.time()
            say(sentence)

    return show


def environment():
    """Variables of the program: the tree on its path, nothing from the user's packages."""
    variables = dict(os.environ, PYTHONPATH=ROOT, PYTHONNOUSERSITE="1")
    variables.pop("PYTHONHOME", None)
    return variables


def environment_of_tests():
    """The same, with byte code kept whatever the shell asks for: the tests start the program a hundred times."""
    variables = environment()
    variables.pop("PYTHONDONTWRITEBYTECODE", None)
    return variables


def hand_over(command):
    """Become the program where the system can, else wait for it."""
    if os.name == "nt":
        return subprocess.call(command, env=environment())
    if sys.stdout:
        sys.stdout.flush()
    return os.execve(command[0], command, environment())


def test_steps(arguments):
    """Style, import contracts, types, tests; with arguments other than --durations the tests alone."""
    python = interpreter()
    scripts = os.path.dirname(python)
    steps = [
        [python, "-m", "ruff", "check", "--no-cache", "."],
        [python, "-m", "ruff", "format", "--no-cache", "--check", "."],
        [os.path.join(scripts, "lint-imports"), "--no-cache"],
        [python, "-m", "mypy", "--cache-dir", os.path.join(ENVIRONMENT, "mypy")],  # 40 s the first time, then 1 s
    ]
    every_core = ["-n", "auto", "--dist", "worksteal"]
    asked = with_budgets(arguments)
    if asked in ([], ["--budgets"]):
        asked = [*every_core, *asked]
    return [*([] if set(arguments) - {"--durations"} else steps), [python, "-m", "pytest", *asked]]


def with_budgets(arguments):
    """Arguments of the tests, --durations without a number as the option of tests/conftest.py that prints seconds
    and budget of each folder; with one it is pytest's own."""
    following = [*arguments[1:], ""]
    return [
        "--budgets" if word == "--durations" and not follows.isdigit() else word
        for word, follows in zip(arguments, following)  # noqa: B905  (an old Python must reach our sentence)
    ]


def refuse_unknown_options(script, arguments):
    """Raise Failure for an option the script does not read, before anything is installed for it."""
    with open(script, encoding="utf-8") as stream:
        known = [*re.findall("--[a-z][a-z-]*", stream.read()), "--help"]
    for argument in arguments:
        option = argument.split("=")[0]
        if option.startswith("--") and option not in known:
            refuse_word(option, known)


def refuse_word(word, known):
    """Raise Failure for a word that is not known, with the nearest that is."""
    near = difflib.get_close_matches(word, known, 1)
    text = "unknown word {word}: did you mean {nearest}?" if near else "unknown word {word}"
    raise Failure(phrase(text, word=word, nearest="".join(near)), 2)


def available(group):
    """A group of packages, where this Python and system have it: its tests are skipped elsewhere."""
    return [] if platforms.refusal([group]) else [group]


def plan(arguments):
    """(groups, commands, whether older packages serve) for what is asked. Raises Failure, and SystemExit where the
    program's own command line ends: wrong usage, --help, --version."""
    word = arguments[0] if arguments else ""
    if word == "test" and "--newest" in arguments:
        others = [argument for argument in arguments[1:] if argument != "--newest"]
        return ["base", "test"], [[interpreter(), "-P", os.path.join(ROOT, "tests", "newest.py"), *others]], False
    if word == "test":
        groups = ["base", "test", "gui", "accuracy", "study", "report", "dxf", "docs", *available("parquet")]
        return groups, test_steps(arguments[1:]), False
    if word in TOOLS:
        script = os.path.join(ROOT, *TOOLS[word].split("/"))
        refuse_unknown_options(script, arguments[1:])
        everything = ["gui", "accuracy", "study", "report", "dxf"]
        peers = ["bench"] if "--work-precision" in arguments else []
        peers += ["parquet"] if {"--walls", "--scale"} & set(arguments) else []
        groups = {"bench": ["test", *everything, *peers], "package": [*everything, "package"], "docs": ["docs"]}
        groups = ["base", *groups.get(word, ["test"])]
        return groups, [[interpreter(), "-P", script, *arguments[1:]]], False
    if word == "validate":
        arguments = ["--validate", *arguments[1:]]
    from app.terminal import command_line
    from core.errors import InputError
    from core.version import line

    if word in ("-h", "--help"):
        print(__doc__)
    try:
        options = command_line.parse(arguments)
        if options.version:
            print(line())
            raise SystemExit(0)
        command_line.refuse_missing(options)
    except InputError as error:
        words = ["test", "validate", *TOOLS]
        if word not in words and not word.startswith("-") and difflib.get_close_matches(word, words, 1):
            refuse_word(word, words)
        raise Failure(error.text(system_language())) from None
    groups = ["base", *command_line.extras(options)]
    return groups, [[interpreter(), "-P", "-m", "app", *arguments]], True


def prepare(groups, older_serves):
    """Make the environment ready. A case that may be large is run without the packages of a large one where they cannot
    be had: the program refuses one that is. Raises Failure."""
    try:
        ensure(groups, older_serves=older_serves)
    except Failure as failure:
        if "parquet" not in groups:
            raise
        ensure([group for group in groups if group != "parquet"], older_serves=older_serves)
        say(str(failure))
    if older_serves:
        take_kernels()


def in_turn(commands):
    """Run commands one after the other up to the first that fails, the last but one beside the last: a check of types
    keeps one core busy for long. What it said comes after the output of the last. Returns the first code that is not
    0."""
    *first, beside, last = commands
    for command in first:
        code = subprocess.call(command, cwd=ROOT, env=environment_of_tests())
        if code:
            return code
    with tempfile.TemporaryFile() as said:
        running = subprocess.Popen(beside, cwd=ROOT, env=environment_of_tests(), stdout=said, stderr=subprocess.STDOUT)
        try:
            code = subprocess.call(last, cwd=ROOT, env=environment_of_tests())
            code = running.wait() or code
        finally:
            running.kill()
            running.wait()
        said.seek(0)
        print(said.read().decode("utf-8", "replace"), end="", flush=True)
    return code


def main():
    refuse_without_wheels([])
    groups, commands, older_serves = plan(sys.argv[1:])
    prepare(groups, older_serves)
    if len(commands) > 1:
        return in_turn(commands)
    if commands[0][2] == "pytest":
        return subprocess.call(commands[0], cwd=ROOT, env=environment_of_tests())
    return hand_over(commands[0])


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failure as failure:
        say(str(failure))
        sys.exit(failure.code)
    except KeyboardInterrupt:
        sys.exit(130)
