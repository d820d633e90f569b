"""Formats that are not read, by how their files begin: named, with the way to one that is."""

import re
import struct

from core.errors import RecordError

BEGINNINGS = (
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "Excel .xls", "format_sheet"),
    (b"MATLAB 5.0 MAT-file", "MATLAB .mat", "format_data"),
    (b"\x89HDF\r\n\x1a\n", "HDF5 (MATLAB 7.3 .mat, ASDF)", "format_data"),
    (b"\x93NUMPY", "NumPy .npy", "format_data"),
    (b"PAR1", "Parquet", "format_data"),
    (b"TDSm", "LabVIEW TDMS", "format_data"),
    (b"MS\x03", "miniSEED 3", "format_seismic"),
    (b"\x1f\x8b", "gzip", "format_archive"),
    (b"BZh", "bzip2", "format_archive"),
    (b"\xfd7zXZ\x00", "xz", "format_archive"),
    (b"7z\xbc\xaf\x27\x1c", "7z", "format_archive"),
    (b"Rar!\x1a\x07", "RAR", "format_archive"),
    (b"%PDF-", "PDF", "format_document"),
    (b"{\\rtf", "RTF", "format_document"),
    (b"\x89PNG\r\n\x1a\n", "PNG", "format_document"),
    (b"\xff\xd8\xff", "JPEG", "format_document"),
    (b"SQLite format 3\x00", "SQLite", "format_data"),
)
"""Beginning of a file, its format, and the code of the refusal, which says what to do."""

_OPEN_DOCUMENT = b"mimetypeapplication/vnd.oasis.opendocument"
_SEED = re.compile(rb"\d{6}[DRQM][ \x00]")
_SAC_UNDEFINED, _SAC_VERSIONS = -12345, (6, 7)


def refuse_signature(content: bytes) -> None:
    """Raise RecordError for a file of a format that is known and not read. content : of the file, its beginning"""
    for beginning, name, code in BEGINNINGS:
        if content.startswith(beginning):
            raise RecordError(code, format=name)
    if content[:4] == b"PK\x03\x04" and _OPEN_DOCUMENT in content[30:120]:
        raise RecordError("format_sheet", format="OpenDocument .ods")
    if _SEED.match(content) and b"\x00" in content[:64]:
        raise RecordError("format_seismic", format="miniSEED")
    if _is_sac(content):
        raise RecordError("format_seismic", format="SAC")


def _is_sac(content: bytes) -> bool:
    """Whether a file has the binary head of SAC, in either order of bytes: its version, and values left undefined."""
    if len(content) < 632:
        return False
    for order in "<>":
        (version,) = struct.unpack(f"{order}i", content[304:308])
        (undefined,) = struct.unpack(f"{order}f", content[16:20])
        if version in _SAC_VERSIONS and (undefined == _SAC_UNDEFINED or content[0:4] != b"\x00" * 4):
            return True
    return False
