"""`--export-check CASE`: each wall of a case as a script that checks it without this program."""

from pathlib import Path

from app.look.language import terminal
from app.terminal.case_run import DONE, WITHOUT_NUMBER, make_folders, results_of, say
from app.terminal.export import refuse_taking, sources_of
from app.terminal.terminal_progress import tell
from core import atomic_write
from core.case.reader import read_case
from core.errors import InputError
from core.file_names import file_name, shown
from core.regular_file import first_bytes
from core.setting.plan import make_plan, read_inputs
from core.study.check_script import TEMPLATE, ScriptUnavailable, check_script

REASON_WORDS = {
    "between_walls": "it spans between transverse walls: no histories are made of it",
    "held_at_top": "it is held at its top: the script has the equation of one block, it moves as two",
    "no_records": "no record moves it: give [[record]], [select] or [generate]",
    "too_sensitive": "the last digits of the samples decide each of its histories: another solver finds another one",
}
"""Why a wall has no script -> the text of the terminal."""

COMPARED_BYTES = 60
"""Bytes by which a script of ours is known."""


def run(case_path: Path, output: Path | None) -> int:
    """Write `check_<wall>_<mechanism>.py` for each hinge and mechanism of each wall of a case; returns the exit code.
    Raises InputError for what the user can mend; nothing is written then."""
    case = read_case(case_path)
    folder, _ = results_of(case_path, output)
    with make_folders(case_path, folder):
        plan = make_plan(case, read_inputs(case, case_path.parent))
        files: dict[Path, bytes] = {}
        taken: dict[str, int] = {}
        refused = []
        for k, entry in enumerate(plan.entries):
            stem = f"check_{file_name(entry.part.wall.name)}_{entry.mechanism}"
            try:
                script = check_script(plan, k)
            except ScriptUnavailable as reason:
                refused.append((entry.part.wall.name, str(reason)))
                continue
            taken[stem.casefold()] = number = taken.get(stem.casefold(), 0) + 1
            files[folder / f"{stem}{f'_{number}' if number > 1 else ''}.py"] = script.encode()
        _refuse_overwriting(set(files), sources_of(case, case_path))
        atomic_write.write(files)
    for path in files:
        say(shown(str(path)))
    for wall, code in refused:
        tell("{wall}: no check is written: {reason}", wall=wall, reason=terminal(REASON_WORDS[code]))
    return WITHOUT_NUMBER if refused else DONE


def _refuse_overwriting(files: set[Path], sources: set[Path]) -> None:
    """Raise InputError where a script would take the place of a source, or of a file that is no such script."""
    refuse_taking({path.resolve() for path in files}, sources)
    for path in files:
        if path.exists() and first_bytes(path, COMPARED_BYTES) != TEMPLATE.read_bytes()[:COMPARED_BYTES]:
            raise InputError("would_overwrite", path=path)
