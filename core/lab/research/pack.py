"""A study as one archive that can be deposited: runs with units, results, seeds, hashes of the records, the state of
the program, and how to run it again."""

import csv
import hashlib
import importlib.metadata
import io
import platform
import zipfile
from pathlib import Path, PurePosixPath

from core.case.study_file import Study
from core.errors import InputError
from core.lab.research.parametric import ParametricResult
from core.lab.research.study_files import CSV_COLUMNS
from core.version import NAME, VERSION, commit

LOCK = Path(__file__).resolve().parents[3] / "requirements.lock"

MADE_WITH = ("numpy", "numba", "scipy")

README = """# {title}
{runs} runs, {analyses} integrations, by {name} {version} ({commit}), started {started} UTC.

| file | what it is |
|---|---|
| {csv} | every run, a line each, numbers in full; SHA-256 {digest} |
| columns.csv | the columns of that file with their units |
| {json} | tables, claims, motions with their seeds and, of natural records, event and measures |
| {study} | the study: grids, spectra, seeds |
{named}| figures/ | PNG and SVG |
| requirements.lock, versions.txt | packages: those of the program, and those this was made with |

Again, with {name} {version}, into `again`:

    ribalta --study {study}{quick}{given} --output again

{absent}`again/{csv}` is then the same file, byte for byte ({processor}; on another processor or system numbers may
differ in their last digits).

Licence: CC BY 4.0 (LICENCE.txt). Cite the program ({name} {version}) and Coccia, Di Carlo, Imperatore (2016).
"""

NAMED = "| {file} | natural records by event, station, component and SHA-256 |\n"
LISTED = "| {file} | the list of records that was given |\n"
FOLDER = "FOLDER holds the records that {file} names, under any names; they are of others and not in here.\n"
OF_A_FOLDER = "FOLDER held the records whose names are in {csv}; they are of others and not in here.\n"
OWN = "The records that {file} names are of others and not in here: they stand where it says.\n"
"""Sentences of the README."""

LICENCE = """Creative Commons Attribution 4.0 International (CC BY 4.0)
https://creativecommons.org/licenses/by/4.0/legalcode

The runs, results and figures of this archive may be shared and adapted by anyone, for any purpose, if the source is
named and changes are said.
"""


def columns_text() -> str:
    """Columns of the CSV of runs, each with its unit and what it is."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(("column", "unit", "what it is"))
    writer.writerows((name, unit, words) for name, (unit, words) in CSV_COLUMNS.items())
    return stream.getvalue()


def refuse_outside(study: Study) -> None:
    """Raise InputError for a study whose named set would stand outside of the archive."""
    kept = PurePosixPath((study.natural or "").replace("\\", "/"))
    if kept.is_absolute() or ".." in kept.parts or ":" in str(kept):
        raise InputError("pack_outside", key="natural", found=study.natural)


def content(
    result: ParametricResult, study: Path, records: Path | None, files: dict[str, bytes], figures: dict[str, bytes]
) -> bytes:
    """The archive.

    study : its file; records : a list of records given beside it; files : CSV and JSON by name; figures : by name
    """
    (table,) = (name for name in files if name.endswith(".csv"))
    (stated,) = (name for name in files if name.endswith(".json"))
    inside, named, absent, given = {study.name: study.read_bytes(), **files}, "", "", ""
    if result.study.record:
        absent = OWN.format(file=study.name)
    if records is not None and records.is_file():
        name = f"given/{records.name}"
        inside[name], given = records.read_bytes(), f" --records {name}"
        named, absent = LISTED.format(file=name), absent + OWN.format(file=name)
    elif records is not None:
        given, kept = " --records FOLDER", result.study.natural
        absent += FOLDER.format(file=kept) if kept else OF_A_FOLDER.format(csv=table)
    if kept := result.study.natural:
        inside[kept] = (study.parent / kept).read_bytes()
        named += NAMED.format(file=kept)
    words = README.format(
        title=result.study.title, runs=len(result.rows), analyses=sum(row.analyses for row in result.rows),
        name=NAME, version=VERSION, commit=commit() or "no commit", started=result.started, csv=table, json=stated,
        study=study.name, quick=" --quick" if result.quick else "", named=named, given=given,
        absent=f"{absent}\n" if absent else "", digest=hashlib.sha256(files[table]).hexdigest(),
        processor=platform.machine(),
    )  # fmt: skip
    inside |= {
        "README.md": words.encode(),
        "LICENCE.txt": LICENCE.encode(),
        "columns.csv": columns_text().encode(),
        "versions.txt": _versions().encode(),
        **({"requirements.lock": LOCK.read_bytes()} if LOCK.is_file() else {}),
        **{f"figures/{name}": one for name, one in figures.items()},
    }
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name in sorted(inside):
            archive.writestr(zipfile.ZipInfo(name), inside[name], zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def _versions() -> str:
    """Python and the packages the numbers were made with."""
    lines = [f"Python {platform.python_version()}"]
    for name in MADE_WITH:
        try:
            lines.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:  # the installed program has no numba
            continue
    return "\n".join(lines) + "\n"
