"""`--inspect`: what the program makes of record files and drawings."""

import sys
from pathlib import Path

from app.look.language import current_language, describe_message, terminal
from app.terminal.command_line import files_of, is_drawing
from core.case.drawing_file import DRAWING_UNITS, DxfFile
from core.errors import InputError, RecordError
from core.file_names import shown
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.ground.records.grammar import Options
from core.units import CM, G
from core.wall.body import polygon_sums

MAX_GAPS_SHOWN = 5
"""Open outlines of a layer that are listed."""


def inspect(paths: list[Path]) -> int:
    """One line a file, also of a folder, or a channel of it, on stdout, refusals on stderr; exit code 1 if any was."""
    files = [file for path in paths for file in files_of(path)]
    return 1 if sum(_drawing_refused(file) if is_drawing(file) else _refused(file) for file in files) else 0


def _drawing_refused(path: Path) -> int:
    """Say what a drawing holds, layer by layer; returns 1 where it was refused."""
    try:
        file = DxfFile(path)
        sheet = file.sheet()
    except InputError as error:
        print(terminal("refused: {error}", error=describe_message(error)), file=sys.stderr)
        return 1
    scale = DRAWING_UNITS[sheet.unit]
    unit = sheet.unit if sheet.stated else terminal("not stated, {unit} by the size", unit=sheet.unit)
    print(terminal("{path}: DXF {version}, unit {unit}", path=path, version=file.document.acad_release, unit=unit))
    for layer in sheet.layers:
        shapes = [shape for shape in sheet.shapes if shape.layer == layer]
        gaps = [gap for gap in sheet.gaps if gap.layer == layer]
        if shapes:
            xs, ys, ends_x, ends_y = zip(*(shape.extent for shape in shapes), strict=True)
            words = terminal(
                "  {layer}: closed shapes {n}, area {area:.4g} m², x {x:.5g} to {to_x:.5g} m, "
                "y {y:.5g} to {to_y:.5g} m",
                layer=layer,
                n=len(shapes),
                area=scale**2 * sum(polygon_sums(shape.corners).area for shape in shapes),
                x=scale * min(xs),
                to_x=scale * max(ends_x),
                y=scale * min(ys),
                to_y=scale * max(ends_y),
            )
            print(words)
        for gap in sorted(gaps, key=lambda one: one.size)[:MAX_GAPS_SHOWN]:
            x, y = (scale * number for number in gap.at)
            text = "  {layer}: an outline open by {mm:.0f} mm at x = {x:.5g} m, y = {y:.5g} m"
            print(terminal(text, layer=layer, mm=1e3 * scale * gap.size, x=x, y=y))
        if len(gaps) > MAX_GAPS_SHOWN:
            print(terminal("  {layer}: open outlines {n}", layer=layer, n=len(gaps)))
    for one in sheet.unread:
        print(terminal("  {layer}: not read {n} {kind}", layer=one.layer, n=one.n, kind=one.kind))
    return 0


def _refused(path: Path, channel: str | None = None) -> int:
    """Say what a file or each of its channels holds; returns how many were refused."""
    name = shown(str(path) if channel is None else f'{path}, channel = "{channel}"')
    try:
        _say(name, records.read(path, Options(channel=channel)))
    except RecordError as error:
        if error.code == "which_channel":
            return sum(_refused(path, one) for one in error.values["names"])
        if error.code == "no_unit" and _without_unit(name, path, channel):
            return 0
        words = describe_message(error).replace(str(path), name, 1)
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
    if motion.lines is not None:
        head, samples, others = motion.lines
        print(
            terminal(
                "  lines: {head} above the samples, {samples} of samples, {others} others",
                head=head,
                samples=samples,
                others=others,
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
