"""`--inspect`: what the program makes of record files."""

import contextlib
import sys
from pathlib import Path

from app.look.language import current_language, described, terminal
from core.errors import RecordError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.units import CM, G


def inspect(paths: list[Path]) -> int:
    """One line a file, also of a folder, or a channel of it, on stdout, refusals on stderr; exit code 1 if any was."""
    return 1 if sum(_refused(file) for path in paths for file in _files(path)) else 0


def _files(path: Path) -> list[Path]:
    """The files of a folder by name; a file, what is not there, and an empty folder as it is."""
    with contextlib.suppress(OSError):
        return sorted(file for file in path.iterdir() if file.is_file()) or [path]
    return [path]


def _refused(path: Path, channel: str | None = None) -> int:
    """Say what a file or each of its channels holds; returns how many were refused."""
    name = str(path) if channel is None else f'{path}, channel = "{channel}"'
    try:
        _say(name, records.read(path, Options(channel=channel)))
    except RecordError as error:
        if error.code == "which_channel":
            return sum(_refused(path, one) for one in error.values["names"])
        if error.code == "no_unit" and _without_unit(name, path, channel):
            return 0
        words = described(error).replace(str(path), name, 1)
        print(terminal("refused: {error}", error=words), file=sys.stderr)
        return 1
    return 0


def _say(name: str, motion: GroundMotion) -> None:
    print(
        terminal(
            "{path}: {format}, {samples} samples every {step:g} s, unit {unit}, PGA {pga:.4f} g, PGV {pgv:.2f} "
            "cm/s, SI {si:.2f} cm, 5-95 % {duration:.2f} s",
            path=name,
            format=motion.format,
            samples=motion.acceleration.size,
            step=motion.time_step,
            unit=motion.unit,
            pga=motion.pga / G,
            pgv=motion.pgv / CM,
            si=motion.housner_intensity / CM,
            duration=motion.duration_5_95,
        )
    )
    for warning in motion.warnings:
        print(f"  {warning.text(current_language())}")


def _without_unit(name: str, path: Path, channel: str | None) -> bool:
    """Say what a file holds that does not state its unit; False if it lacks more than that."""
    try:
        motion = records.read(path, Options(unit="mm/s2", channel=channel))
    except RecordError:
        return False
    print(
        terminal(
            "{path}: {format}, {samples} samples every {step:g} s, peak {peak:.5g}; the unit is not stated: give it in "
            "the case",
            path=name,
            format=motion.format,
            samples=motion.acceleration.size,
            step=motion.time_step,
            peak=motion.pga / 0.001,
        )
    )
    return True
