"""Formats that are not read are named, with the way out."""

import io
import struct
import zipfile

import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records.signatures import BEGINNINGS


def made() -> dict[str, tuple[bytes, str]]:
    """Name of a format -> (a file of it, the code of its refusal)."""
    found = {name: (start + b"\x00 \x01" * 300, code) for start, name, code in BEGINNINGS}
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as folder:
        folder.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet")
        folder.writestr("content.xml", "<office/>")
    found["OpenDocument .ods"] = packed.getvalue(), "format_sheet"
    found["miniSEED"] = b"000001D IU ANMO  00BHZ" + b"\x07\xe9\x00\x01" + b"\x00" * 500, "format_seismic"
    for order in "<>":
        reals = struct.pack(f"{order}70f", *([0.01] + [-12345.0] * 69))
        whole = struct.pack(f"{order}40i", *([-12345] * 6 + [6] + [-12345] * 33))
        found["SAC" + order] = reals + whole + b" " * 192 + b"\x00" * 400, "format_seismic"
    return found


MADE = made()


@pytest.mark.shows("records.not_read")
@pytest.mark.parametrize("name", MADE)
def test_that_a_format_that_is_not_read_is_named_with_the_way_out(name, tmp_path):
    content, code = MADE[name]
    path = tmp_path / "record.bin"
    path.write_bytes(content)
    with pytest.raises(RecordError) as caught:
        records.read(path)
    assert caught.value.code == code
    assert name.rstrip("<>") in str(caught.value)
