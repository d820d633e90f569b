"""The natural records of resources/docs/paper.md, as the list that `--study paper` and `--study law` take.

    python3 run.py bench --natural LIST.toml
    python3 run.py --study paper --records LIST.toml

Every acceleration record of the shelf in these folders that the program reads, with the unit and the time step of its
INDEX.csv where the file does not state them; of equal files the first. What else of them is one motion twice, and what
is vertical, the study leaves out.
"""

import argparse
import contextlib
import csv
from pathlib import Path

from core.errors import InputError
from core.ground import records
from core.ground.records.grammar import Options
from tests.conftest import shelf_folder

FOLDERS = ("PEER_AT2", "ESM_ASCII", "SIGMA_ITACA_acc", "plain_txt")


def entry(path: Path, row: dict[str, str]) -> tuple[str, str] | None:
    """Hash of the samples and [[record]] table of a file, None of one the program does not read. row : of INDEX.csv"""
    unit, step = row["units_in_file"].split(" ")[0] or None, float(row["dt_s"] or 0.0) or None
    for options in (Options(), Options(unit), Options(unit, step)):
        with contextlib.suppress(InputError):
            motion = records.read(path, options)
            told = {"unit": options.unit, "time_step_s": options.time_step}
            keys = [f"{key} = {value!r}" for key, value in told.items() if value is not None]
            table = "\n".join(["[[record]]", f"file = {path.as_posix()!r}", *keys, ""])
            return motion.samples_sha256, table
    return None


def main(options: argparse.Namespace) -> None:
    """Write the list. small : of one folder of the shelf"""
    shelf = shelf_folder()
    assert shelf, "no shelf of real records (RIBALTA_RECORDS or ../shared/records)"
    folders = FOLDERS[1:2] if options.small else FOLDERS
    with open(shelf / "INDEX.csv", encoding="utf-8") as stream:
        rows = [row for row in csv.DictReader(stream) if row["file"].split("/")[0] in folders]
    found: dict[str, str] = {}
    for row in rows:
        if read := entry(shelf / row["file"], row):
            found.setdefault(*read)
    assert found, "no record is read"
    options.natural.write_text("\n".join(found.values()), encoding="utf-8")
    print(f"{len(found)} of {len(rows)} files: {options.natural}")
