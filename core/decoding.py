"""Bytes of a text file to its text, whatever program wrote it."""

import re

_CONTROL = re.compile(rb"[\x00-\x08\x7f]")

LOOKED_AT = 4096
"""Bytes of a file in which a control character tells that it is no text."""


class NoText(ValueError):
    """What was read is no text."""


def decode_text(content: bytes) -> str:
    """The text of a file, its lines ended by \\n: UTF-8 or UTF-16 by their marks, UTF-16 by its zeros, else UTF-8, else
    the alphabet of Windows. Raises NoText for a binary file."""
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = content.decode("utf-16", errors="replace")
    elif order := _order_of_utf16(content):
        text = content.decode(f"utf-16-{order}", errors="replace")
    else:
        body = content.removeprefix(b"\xef\xbb\xbf").rstrip(b"\x00\x1a")
        if _CONTROL.search(body[:LOOKED_AT]):
            raise NoText
        try:
            text = body.decode("utf-8")
        except UnicodeDecodeError:
            text = body.decode("cp1252", errors="replace")
    if "\r" in text:
        text = re.sub(r"\r+\n?", lambda run: "\n" * (1 if run[0][-1] == "\n" else len(run[0])), text)
    return text


def _order_of_utf16(content: bytes) -> str:
    """The order of the bytes, le or be, of a text in UTF-16 without its mark: of its first letters nearly each has a
    zero byte beside it, and none stands elsewhere; "" of another file."""
    start = content[:400]
    zeros = [start[first::2].count(0) for first in (0, 1)]
    if len(start) < 20 or min(zeros) > 0 or max(zeros) < 0.45 * len(start):
        return ""
    return "le" if zeros[1] else "be"
