"""The robustness sheet: kills, faults, hostile inputs, mutants, events of the window, counted for one version.

    python3 run.py robustness [--share S] [--journal FILE] [--output FILE] [CAMPAIGN ...]

Each campaign is a command of its own, whose last numbers are counted: some minutes to some hours. What is done stands
in the journal, so that a run that was stopped goes on; a campaign of another version is made again. The sheet is
resources/docs/robustness.md.
"""

import argparse
import datetime
import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from core.version import VERSION
from tests.fuzz.fuzz import TARGETS

ROOT = Path(__file__).resolve().parents[2]
SHEET = ROOT / "resources" / "docs" / "robustness.md"
PYTEST = ["-m", "pytest", "-q", "-p", "no:cacheprovider"]


class Campaign(NamedTuple):
    """title : what is counted, as the sheet says it
    command : share -> arguments of Python, and what goes into the environment
    counted : output -> (tried, what did not hold)
    """

    title: str
    command: Callable[[float, Path], tuple[list[str], dict[str, str]]]
    counted: Callable[[str], tuple[int, int]]


def of_pytest(*arguments: str, **environment: str) -> Callable[[float, Path], tuple[list[str], dict[str, str]]]:
    """A campaign that is a choice of tests, whatever the share."""
    return lambda share, journal: ([*PYTEST, *arguments], environment)


def facts_counted(said: str) -> tuple[int, int]:
    """Of the last line of pytest."""
    line = said.strip().splitlines()[-1]
    passed, failed, errors = (re.search(rf"(\d+) {word}", line) for word in ("passed", "failed", "error"))
    bad = sum(int(one[1]) for one in (failed, errors) if one)
    return bad + (int(passed[1]) if passed else 0), bad


def inputs_counted(said: str) -> tuple[int, int]:
    """Of the lines of fuzz, one for each reader."""
    rows = re.findall(r"^\w[\w ]*? +(\d+) inputs, seed \d+: (.*)$", said, re.MULTILINE)
    return sum(int(count) for count, _ in rows), sum(found != "nothing found" for _, found in rows)


def mutants_counted(said: str) -> tuple[int, int]:
    """Of the last line of mutate."""
    killed, total = map(int, re.findall(r"^(\d+) of (\d+) faults found", said, re.MULTILINE)[-1])
    return total, total - killed


def lines_counted(said: str) -> tuple[int, int]:
    """Of a last line "N tried, M found"."""
    tried, found = map(int, re.findall(r"^(\d+) tried, (\d+) found", said, re.MULTILINE)[-1])
    return tried, found


def mutants(share: float, journal: Path) -> tuple[list[str], dict[str, str]]:
    kept = journal.with_suffix(f".mutants-{VERSION}")
    return ["tests/mutation/mutate.py", "--faults", str(max(1, round(600 * share))), "--journal", str(kept)], {}


def readers(share: float, journal: Path) -> tuple[list[str], dict[str, str]]:
    return ["tests/fuzz/fuzz.py", "--seconds", str(max(0.5, 120.0 * share)), "--seed", "1"], {}


def kills(share: float, journal: Path) -> tuple[list[str], dict[str, str]]:
    script = (
        "import sys, tempfile; from pathlib import Path; from tests.app.test_kills import killed_at_random_times\n"
        "with tempfile.TemporaryDirectory() as name:\n"
        "    count = int(sys.argv[1]); lost = killed_at_random_times(Path(name), count, 7)\n"
        "print(f'{count} tried, {lost} found')"
    )
    return ["-c", script, str(max(1, round(200 * share)))], {"QT_QPA_PLATFORM": "offscreen"}


CAMPAIGNS = {
    "mutants": Campaign(
        "Faults put into the modules that decide; not found by the module's own tests", mutants, mutants_counted
    ),
    "readers": Campaign(
        f"Hostile inputs for {len(TARGETS)} readers; not read or refused in a sentence", readers, inputs_counted
    ),
    "kills": Campaign("Kills of the window at random times; something acknowledged lost", kills, lines_counted),
    "writing": Campaign(
        "Faults and kills at each call of writing results and journals; a file lost or half-written",
        of_pytest("-m", "long or not long", "tests/core/test_atomic_write.py", "tests/core/study/test_journal.py"),
        facts_counted,
    ),
    "folders": Campaign(
        "Batches side by side in one folder, things without an end; results not whole, or a hang",
        of_pytest("-m", "long or not long", "tests/app/test_doors.py", "tests/core/test_regular_file.py"),
        facts_counted,
    ),
    "schedulers": Campaign(
        "Parts of a case by schedulers, a worker lost; another result than the undivided run",
        of_pytest(
            "-m", "long or not long", "tests/core/study/test_case_parts.py", "tests/core/study/test_large_case.py"
        ),
        facts_counted,
    ),
    "window": Campaign(
        "Random walks of the window, damaged drawings in its dialog; an exception, a complaint of Qt, a value lost",
        of_pytest(
            *("-m", "long or not long", "tests/app/test_random_events.py", "tests/app/test_walk.py"),
            *("tests/app/test_drafts.py", "tests/app/test_drawing_dialog.py", "tests/app/test_recovery.py"),
            QT_QPA_PLATFORM="offscreen",
        ),
        facts_counted,
    ),
}


def known(journal: Path) -> dict[str, dict[str, Any]]:
    """Campaign -> what the journal says of it, of this version."""
    if not journal.exists():
        return {}
    rows = [json.loads(line) for line in journal.read_text(encoding="utf-8").splitlines()]
    return {row["campaign"]: row for row in rows if row["version"] == VERSION}


def made(name: str, share: float, journal: Path) -> dict[str, Any]:
    """Run a campaign; what its row of the sheet says."""
    campaign, begun = CAMPAIGNS[name], time.monotonic()
    arguments, environment = campaign.command(share, journal)
    variables = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    done = subprocess.run([sys.executable, *arguments], cwd=ROOT, env=variables, capture_output=True, text=True)
    try:
        tried, found = campaign.counted(done.stdout)
        if tried == 0 or (done.returncode != 0 and found == 0):
            raise ValueError(f"exit code {done.returncode}")
    except (IndexError, ValueError):
        sys.exit(f"{name}: says no numbers\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    minutes = round((time.monotonic() - begun) / 60.0, 1)
    day = datetime.date.today().isoformat()
    return {"campaign": name, "version": VERSION, "date": day, "tried": tried, "found": found, "minutes": minutes}


def sheet(rows: dict[str, dict[str, Any]]) -> str:
    """The page: a row for each campaign that was made."""
    lines = [
        "# Robustness",
        "",
        "What was tried against the program, how often, and how often it did not hold. Written by",
        "`python3 run.py robustness`, which takes hours and goes on where it was stopped; no number is typed.",
        "",
        "| tried; did not hold | tried | did not hold | version | date | minutes |",
        "|---|---|---|---|---|---|",
    ]
    for name, campaign in CAMPAIGNS.items():
        if name in rows:
            row = rows[name]
            cells = (row["tried"], row["found"], row["version"], row["date"], row["minutes"])
            lines.append(f"| {campaign.title} | {' | '.join(map(str, cells))} |")
    lines += [
        "",
        "Faults that no test finds are in tests/mutation/survivors.txt with their reasons, those that nobody has",
        "judged yet in tests/mutation/open.txt.",
    ]
    return "\n".join([*lines, ""])


def main() -> int:
    words = argparse.ArgumentParser()
    words.add_argument("campaigns", nargs="*", default=list(CAMPAIGNS))
    words.add_argument("--share", type=float, default=1.0, help="of the mutants, seconds and kills of a whole run")
    words.add_argument("--journal", type=Path, default=Path("robustness.journal"))
    words.add_argument("--output", type=Path, default=SHEET)
    options = words.parse_args()
    rows = known(options.journal)
    for name in options.campaigns:
        if name not in rows:
            rows[name] = made(name, options.share, options.journal)
            with options.journal.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(rows[name]) + "\n")
        print("{campaign}: {tried} tried, {found} did not hold, {minutes} minutes".format(**rows[name]), flush=True)
    options.output.write_text(sheet(rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
