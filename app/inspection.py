"""`--inspect`: what the program makes of record files."""

import sys
from pathlib import Path

from app.language import current_language, described, terminal
from core.errors import RecordError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.units import CM, G


def inspect(paths: list[Path]) -> int:
    """One line a file, or a channel of it, on stdout, refusals on stderr; exit code 1 if any file was refused."""
    refused = 0
    for path in paths:
        try:
            motion = records.read(path)
        except RecordError as error:
            if error.code == "no_unit" and _without_unit(path):
                continue
            if error.code == "which_channel":
                refused += _channels(path, error)
                continue
            print(terminal("refused: {error}", error=described(error)), file=sys.stderr)
            refused += 1
            continue
        _say(str(path), motion)
    return 1 if refused else 0


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


def _channels(path: Path, error: RecordError) -> int:
    """Say what each channel of a file holds; returns how many were refused."""
    refused = 0
    for name in error.values["names"]:
        try:
            _say(f'{path}, channel = "{name}"', records.read(path, Options(channel=name)))
        except RecordError as why:
            if why.code == "which_channel":  # of a member of a zip
                refused += _channels(path, why)
                continue
            print(terminal("refused: {error}", error=described(why)), file=sys.stderr)
            refused += 1
    return refused


def _without_unit(path: Path) -> bool:
    """Say what a file holds that does not state its unit; False if it lacks more than that."""
    try:
        motion = records.read(path, Options(unit="mm/s2"))
    except RecordError:
        return False
    print(
        terminal(
            "{path}: {format}, {samples} samples every {step:g} s, peak {peak:.5g}; the unit is not stated: give it in "
            "the case",
            path=path,
            format=motion.format,
            samples=motion.acceleration.size,
            step=motion.time_step,
            peak=motion.pga / 0.001,
        )
    )
    return True
