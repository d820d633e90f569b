"""`--inspect`: what the program makes of record files."""

import sys
from pathlib import Path

from core.errors import RecordError
from core.ground import records
from core.ground.records.grammar import Options
from core.units import CM, G


def inspect(paths: list[Path]) -> int:
    """One line a file on stdout, refusals on stderr; exit code 1 if any file was refused."""
    refused = 0
    for path in paths:
        try:
            motion = records.read(path)
        except RecordError as error:
            if "give unit" in str(error) and _without_unit(path):
                continue
            print(f"refused: {error}", file=sys.stderr)
            refused += 1
            continue
        print(
            f"{path}: {motion.format}, {motion.acceleration.size} samples every "
            f"{motion.time_step:g} s, unit {motion.unit}, PGA {motion.pga / G:.4f} g, "
            f"PGV {motion.pgv / CM:.2f} cm/s, SI {motion.housner_intensity / CM:.2f} cm, "
            f"5-95 % {motion.duration_5_95:.2f} s"
        )
        for warning in motion.warnings:
            print(f"  {warning.text()}")
    return 1 if refused else 0


def _without_unit(path: Path) -> bool:
    """Say what a file holds that does not state its unit; False if it lacks more than that."""
    try:
        motion = records.read(path, Options(unit="mm/s2"))
    except RecordError:
        return False
    print(
        f"{path}: {motion.format}, {motion.acceleration.size} samples every {motion.time_step:g} s, "
        f"peak {motion.pga / 0.001:.5g}; the unit is not stated: give it in the case"
    )
    return True
