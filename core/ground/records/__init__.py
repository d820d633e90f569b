"""Accelerogram files: one reader per format, recognised by content, in this explicit table."""

import functools
import hashlib
import os
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.errors import InputError, RecordError
from core.file_names import name_of, shown
from core.ground.ground_motion import LARGE_PGA, SMALL_PGA, GroundMotion, check_step
from core.ground.records import plausible, samples
from core.ground.records.container import MEMBER_SEPARATOR, is_zip, member_of, sheet_of, tar_as_zip
from core.ground.records.cut import refuse_cut
from core.ground.records.grammar import UNITS, Options, Parsed, decode, quoted
from core.ground.records.placement import structure_words
from core.ground.records.signatures import refuse_signature
from core.ooxml.package import is_workbook
from core.regular_file import TooLarge, read_regular
from core.text.sentence import Sentence, notice
from core.units import G

SPECTRA = re.compile(r"RESPONSE AND FOURIER", re.IGNORECASE)
"""Beginning of a file of spectra (CSMIP volume 3)."""

MAX_BYTES = 20_000_000
MAX_NUMBERS, MAX_LINES, MAX_LINE_BYTES = 5_000_000, 2_500_000, 1_000_000
"""Larger files are refused before they take the memory; the longest records known have 2 MB."""

END_SHARE = 0.05
"""Share of its peak at which a record without a declared count ends that is not at rest: is it cut?"""

MAX_USUAL_SCALE = 3.0
"""Scales of a record beyond this one are warned of."""

OFFSET_SHARE, OFFSET_VELOCITY = 0.01, 0.5
"""Mean over the peak [-] and velocity left at the end [m/s] beyond both of which samples have an offset; the
corrected records tried have means below 1e-4 of the peak."""

MAX_PGA = 20.0 * G
"""Above this peak [m/s2] a file is not what it is said to be."""


PLAIN = "plain text"
"""Title of what is read by its columns alone."""


@functools.cache
def readers() -> tuple[tuple[str, Callable, Callable], ...]:
    """(format, recognises(lines), read(lines, options)); the first that recognises the content reads it. Imported when
    a record is first read: their patterns take a tenth of the start of the window."""
    from core.ground.records import california, film, geonet, italian, japan_taiwan, labview, networks, peer, plain, smc

    return (
        ("PEER AT2", peer.recognises, peer.read),
        ("tab matrix", peer.recognises_matrix, peer.read_matrix),
        ("ESM ASCII", italian.recognises_esm, italian.read_esm),
        ("SIGMA acc", italian.recognises_sigma, italian.read_sigma),
        ("K-NET / KiK-net", japan_taiwan.recognises_knet, japan_taiwan.read_knet),
        ("CWA", japan_taiwan.recognises_cwa, japan_taiwan.read_cwa),
        ("GeoNet", geonet.recognises, geonet.read),
        ("SMC", smc.recognises, smc.read),
        ("CSMIP / COSMOS", california.recognises, california.read),
        ("USC volume 1", california.recognises_pairs, california.read_pairs),
        ("CSMIP volume 1 / RENADIC", film.recognises, film.read),
        ("NSMN", networks.recognises_nsmn, networks.read_nsmn),
        ("UNAM", networks.recognises_unam, networks.read_unam),
        ("CSMNC", networks.recognises_csmnc, networks.read_csmnc),
        ("BHRC", networks.recognises_bhrc, networks.read_bhrc),
        ("LabVIEW .lvm", labview.recognises, labview.read),
        (PLAIN, plain.recognises, plain.read),
    )


def read(path: Path, options: Options = Options(), scale: float = 1.0, name: str = "") -> GroundMotion:
    """The accelerogram of one file, in SI units.

    scale : multiplier asked by the user [-]. Raises RecordError naming file, place and way out.
    """
    try:
        if path.exists() and not path.is_file():
            raise RecordError("record_not_a_file")
        content = read_regular(path, MAX_BYTES)
        return _motion(content, path, options, scale, name or shown(path.stem))
    except FileNotFoundError:
        raise RecordError("no_record", place=(path,)) from None
    except TooLarge as error:
        most = MAX_BYTES // 1_000_000
        raise RecordError("record_too_large", mb=error.size / 1e6, most=most, place=(path,)) from None
    except (OSError, ValueError) as error:
        if isinstance(error, RecordError):
            raise error.at(path) from None
        raise RecordError("unreadable", reason=error, place=(path,)) from None


def _motion(content: bytes, path: Path, options: Options, scale: float, name: str) -> GroundMotion:
    if not content.strip():
        raise RecordError("empty_file")
    if (packed := tar_as_zip(content)) is not None:
        motion = _unpacked(packed, path, options, scale, name)
        own = motion.format.removeprefix("zip, ")
        return replace(motion, file_sha256=hashlib.sha256(content).hexdigest(), format=f"tar, {own}")
    refuse_signature(content)
    if is_zip(content):
        return _unpacked(content, path, options, scale, name)
    if len(content) > MAX_NUMBERS and _separate(content) > MAX_NUMBERS:
        raise RecordError("too_many_numbers", n=MAX_NUMBERS)
    if content.count(b"\n") > MAX_LINES:
        raise RecordError("too_many_numbers", n=MAX_LINES)
    return _of_lines(content, decode(content), path, options, scale, name)


def _unpacked(content: bytes, path: Path, options: Options, scale: float, name: str) -> GroundMotion:
    """The accelerogram of one member of a zip, or of one sheet of a workbook."""
    if is_workbook(content):
        sheet, lines, several, notes = sheet_of(content, options.channel)
        inside = replace(options, channel=None)
        motion = _of_lines(content, lines, path, inside, scale, name)
        motion = replace(motion, warnings=(*motion.warnings, *notes))
        if several:
            motion = replace(motion, name=f"{name} {sheet}", channel=sheet)
        return replace(motion, format=f"xlsx, {motion.format}")
    member, body, within, several = member_of(content, options.channel)
    try:
        inner = replace(options, channel=within)
        motion = _motion(body, path, inner, scale, shown(Path(member).stem))
    except RecordError as error:
        if error.code == "which_channel" and several:  # say them as they are asked for
            names = [f"{member}{MEMBER_SEPARATOR}{one}" for one in error.values["names"]]
            raise RecordError(
                "which_channel", **{**error.values, "names": names}, key="channel", place=(member,)
            ) from None
        raise error.at(member) from None
    channel = MEMBER_SEPARATOR.join(part for part in (member, motion.channel) if part) if several else motion.channel
    return replace(
        motion, file_sha256=hashlib.sha256(content).hexdigest(), channel=channel, format=f"zip, {motion.format}"
    )


def _of_lines(content: bytes, lines: list[str], path: Path, options: Options, scale: float, name: str) -> GroundMotion:
    cells = is_zip(content)  # a workbook is whole or cannot be opened
    ended = cells or content.rstrip(b"\x00\x1a")[-1:] in (b"\n", b"\r")
    ended = ended or content[-2:] in (b"\n\0", b"\0\n")
    title, parsed = _parsed(lines, options, ended)
    if parsed.factor is not None and not abs(scale / parsed.factor[0] - 1.0) <= 1e-6:
        raise parsed.factor[1]
    unit = _agreed("unit", parsed.unit, options.unit, parsed.lines)
    if unit not in UNITS:
        raise RecordError("unit_not_accepted", given=unit, known=", ".join(UNITS))
    if parsed.unit is None:
        parsed.warnings.append(notice("unit_as_given", unit=unit))
    time_step = _agreed("time_step_s", parsed.time_step, options.time_step, parsed.lines)
    check_step(time_step)
    motion = parsed.values * UNITS[unit] * scale
    warnings = [
        *parsed.warnings,
        *_doubts_as_read(parsed, time_step, title == PLAIN),
        *_doubts_of_motion(motion, time_step, scale),
    ]
    _refuse_unused(options, title, parsed)
    if parsed.vertical:
        warnings.append(notice("vertical"))
    words = structure_words(lines, parsed.channel) if parsed.standing is None else parsed.standing
    if words:
        warnings.append(notice("in_structure", words=quoted(words)))
    if not cells:
        refuse_cut(lines, ended)
    channel = parsed.channel if parsed.several else ""
    return GroundMotion(
        name=f"{name} {channel}".strip(),
        channel=channel,
        acceleration=motion,
        time_step=time_step,
        file=str(path),
        file_sha256=hashlib.sha256(content).hexdigest(),
        format=title,
        unit=unit,
        details=parsed.details,
        lines=(*parsed.told, len(lines) - sum(parsed.told)) if parsed.told else None,
        warnings=tuple(warnings),
        scale=scale,
    )


def _parsed(lines: list[str], options: Options, ended: bool) -> tuple[str, Parsed]:
    """(format, what its reader read) of a file, whose samples have no mark of a gap. ended : it has its line end."""
    longest = max(map(len, lines), default=0)
    if longest > MAX_LINE_BYTES:
        raise RecordError("line_too_long", n=longest)
    if SPECTRA.match("\n".join(lines[:30])):
        raise RecordError("spectra_file")
    title, reader = next((title, read) for title, knows, read in readers() if knows(lines))
    parsed = reader(lines, options)
    if not ended and any(warning.code == "partial_last_line" for warning in parsed.warnings):
        raise RecordError("last_line_cut")
    samples.refuse_marks(parsed.values)
    plausible.refuse_sorted(parsed.values)
    samples.refuse_repeated_line(lines)
    return title, parsed


def _doubts_as_read(parsed: Parsed, time_step: float, plain: bool) -> list[Sentence]:
    """Warnings of the samples in the file's unit. time_step [s]; plain : of no format that names the quantity"""
    warnings = [
        *samples.jumps(parsed.values),
        *plausible.doubts(*_as_written(parsed, time_step), plain),
        *plausible.misplaced(parsed.values, time_step, parsed.peak_time),
        *plausible.beyond_nyquist(time_step, parsed.corner),
    ]
    peak = float(np.abs(parsed.values).max()) if parsed.values.size else 0.0
    if parsed.stated_peak and abs(peak - parsed.stated_peak) > 0.02 * parsed.stated_peak:
        warnings.append(notice("peak_differs", read=peak, stated=parsed.stated_peak))
    if not parsed.counted and peak and abs(parsed.values[-1]) > END_SHARE * peak:
        warnings.append(notice("ends_moving", share=abs(parsed.values[-1]) / peak))
    return warnings


def _as_written(parsed: Parsed, time_step: float) -> tuple[np.ndarray, float]:
    """The samples as the file has them with their step, the mean one [s] of samples at uneven times."""
    if parsed.written is None:
        return parsed.values, time_step
    return parsed.written, time_step * parsed.values.size / parsed.written.size


def _doubts_of_motion(motion, time_step: float, scale: float) -> list[Sentence]:
    """Warnings of the acceleration of the ground [m/s2], scaled. Raises RecordError where no ground moves so."""
    warnings = []
    if scale != 1.0:
        code = "scaled_far" if abs(scale) > MAX_USUAL_SCALE else "scaled"
        warnings.append(notice(code, scale=scale))
    pga = float(np.abs(motion).max()) if motion.size else 0.0
    if not pga <= MAX_PGA * abs(scale):
        raise RecordError("peak_too_large", pga=pga / G / abs(scale))
    if pga > LARGE_PGA:
        warnings.append(notice("large_pga", pga=pga / G))
    elif 0.0 < pga < SMALL_PGA:
        warnings.append(notice("small_pga", pga=pga / G))
    mean = float(motion.mean()) if motion.size else 0.0
    left = abs(mean) * motion.size * time_step
    if abs(mean) > OFFSET_SHARE * pga and left > OFFSET_VELOCITY:
        warnings.append(notice("offset", mean=mean / G, velocity=left))
    return warnings


def _refuse_unused(options: Options, title: str, parsed: Parsed) -> None:
    """Raise RecordError for an option this format has no use for. title : of the format."""
    if options.channel and not parsed.several and options.channel.casefold() not in (parsed.channel.casefold(), "1"):
        raise RecordError("one_channel", given=quoted(options.channel), format=title)
    if options.skip_lines and title != "plain text":
        raise RecordError("skip_lines_of_plain_text", format=title)
    if options.column and title != "plain text":
        raise RecordError("column_of_plain_text", format=title)


def _separate(content: bytes) -> int:
    """Number of words of a text, counted without making them."""
    return content.translate(_WORDS).count(b" x") + 1


_WORDS = bytes(32 if letter in b" \t\r\n,;" else 120 for letter in range(256))
"""Every letter as x, every mark between words as a blank."""


def _agreed(key: str, stated, given, lines: dict[str, str]):
    """Value the file states or the user gives; an error if neither does or if they contradict each other."""
    if stated is None and given is None:
        raise RecordError(f"no_{key}", key=key)
    if stated is None or given is None:
        return given if stated is None else stated
    same = stated == given if isinstance(stated, str) else abs(stated - given) <= 1e-6 * stated
    if not same:
        line = lines.get(key)
        if line:
            raise RecordError("contradicts_line", named=key, stated=stated, given=given, line=line)
        raise RecordError("contradicts_file", named=key, stated=stated, given=given)
    return stated


def channels(path: Path, options: Options = Options()) -> tuple[str, ...]:
    """Names of the channels of a file that has several, else none; RecordErrors of another kind say nothing here."""
    try:
        read(path, replace(options, channel=None))
    except RecordError as error:
        if error.code != "which_channel":
            return ()
        names = tuple(error.values["names"])
    else:
        return ()
    content = read_regular(path, MAX_BYTES)
    if not is_zip(content) and tar_as_zip(content) is None:
        return names
    all_names: list[str] = []
    for name in names:  # a member may have channels of its own
        try:
            read(path, replace(options, channel=name))
        except RecordError as error:
            if error.code == "which_channel":
                all_names += error.values["names"]
                continue
        all_names.append(name)
    return tuple(all_names)


def expand(pattern: str, base_dir: Path) -> list[Path]:
    """Files of one `file` entry, relative to the case; a glob that matches nothing is an error."""
    pattern = name_of(pattern)
    path = base_dir / pattern
    try:
        os.fsencode(path)  # a name that this system cannot write is an error of the case
        if not any(letter in pattern for letter in "*?[") or path.exists():
            return [path]
        anchor = Path(path.anchor) if Path(pattern).is_absolute() else base_dir
        relative = Path(pattern).relative_to(anchor) if Path(pattern).is_absolute() else pattern
        files = sorted(entry for entry in anchor.glob(str(relative)) if entry.is_file())
    except (ValueError, OSError) as error:
        raise InputError("bad_pattern", pattern=pattern[:200], reason=str(error)[:200]) from None
    if not files:
        if Path(pattern).is_absolute():
            raise InputError("no_match", pattern=pattern[:200])
        raise InputError("no_match_in", pattern=pattern[:200], folder=base_dir.resolve())
    return files
