"""Files of records, as the table of the records and the dialog that imports them take them."""

from pathlib import Path

from app.look.language import describe_message
from core.case.schema import Record
from core.errors import InputError
from core.file_names import name_of
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.provenance import provenance
from core.ground.records.grammar import Options

Row = Path | tuple[Path, str]
"""A file, or a channel of a file that has several."""


def read_motions(record: Record, base_dir: Path) -> list:
    """Motions of one entry, or the sentence why there are none."""
    options = Options(record.unit, record.time_step_s, record.column, record.skip_lines, record.channel or None)
    try:
        return [records.read(path, options, record.scale) for path in records.expand(record.file, base_dir)]
    except InputError as error:
        return [describe_message(error)]


def channels_of(record: Record) -> tuple[str, ...]:
    """Channels of the file of an entry, none where it has one."""
    options = Options(record.unit, record.time_step_s, record.column, record.skip_lines)
    return records.channels(Path(name_of(record.file)), options)


def provenance_lines(motion: GroundMotion) -> list[str]:
    """What the file says of event, station, date, magnitude, filter and processing, and the warnings."""
    where = provenance(motion)
    parts = (where.event, where.station, where.date, where.magnitude, where.filter_and_processing)
    line = ", ".join(dict.fromkeys(part for part in parts if part))
    return [*([line] if line else []), *(describe_message(warning) for warning in motion.warnings)]


def file_of(row: Row) -> Path:
    return row if isinstance(row, Path) else row[0]


def named_row(row: Row) -> str:
    """What a row of the list says."""
    return row.name if isinstance(row, Path) else f"{row[0].name}: {row[1]}"


def all_files(paths: list[Path]) -> list[Path]:
    """Files among these, folders opened."""
    files = []
    for path in paths:
        files += sorted(f for f in path.rglob("*") if f.is_file()) if path.is_dir() else [path]
    return [path for path in files if not path.name.startswith(".")]
