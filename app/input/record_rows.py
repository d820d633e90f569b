"""What the table of the records shows: the motions of a case read or generated, one row each."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from app.input.record_files import read_motions
from app.look.language import current_language, describe_message, number, tr
from core.case.schema import Case, Record
from core.errors import InputError
from core.ground.ground_motion import GroundMotion
from core.report.record_tables import RecordRow, records_as_read
from core.report.tables import WINDOW
from core.report.words import Words
from core.setting.demand_input import generate_motions, read_demand
from core.setting.plan import select_case_records
from core.setting.record_input import read_records

Row = tuple[int | None, GroundMotion | str]
"""(index of the entry of the case, None for generated ones; the motion, or the sentence why there is none)."""


def heads() -> list[str]:
    """Heads of the columns."""
    return [tr("Use"), *(column.head for column in records_as_read(Words(current_language())).shown(WINDOW))]


def state_of(name: str) -> tuple | None:
    """What tells whether a file is still the same; None where it is gone."""
    try:
        state = Path(name).stat()
    except OSError:
        return None
    return state.st_mtime_ns, state.st_size


def read_rows(
    case: Case, base: Path, cancelled: Callable[[], bool] = lambda: False
) -> tuple[list[Row], dict[str, tuple | None]]:
    """(rows of a case whose files are relative to `base`, state of each file that was read).

    cancelled : asked while records are chosen; raises Cancelled
    """
    rows: list[Row] = [(k, motion) for k, entry in enumerate(case.record) for motion in read_motions(entry, base)]
    if case.generate or case.select:
        try:
            asked = read_demand(case, base)
            made = generate_motions(case, asked) if asked and asked.target else []
            chosen, _ = select_case_records(case, base, cancelled=cancelled)
            made += read_records(chosen, base)[0] if case.select else []
            rows += [(None, motion) for motion in made]
        except InputError as error:
            rows.append((None, describe_message(error)))
        except (TypeError, KeyError):  # values of the site are still to be given
            rows.append((None, tr("The values of the site are still missing.")))
    motions = [motion for _, motion in rows if not isinstance(motion, str)]
    for motion in motions:
        motion.measure()
    files = {motion.file for motion in motions if motion.format != "generated"}
    return rows, {name: state_of(name) for name in files}


def cells(motion: GroundMotion | str, entry: Record | None) -> list[str]:
    """Texts of a row."""
    if isinstance(motion, str):
        return ["", motion, *[""] * (len(heads()) - 2)]
    kind = entry.kind if entry else "artificial" if motion.format == "generated" else "natural"
    row = RecordRow(replace(motion, scale=entry.scale) if entry else motion, kind)
    return ["", *records_as_read(Words(current_language())).words(WINDOW, [row], number)[0]]
