"""Names of files as the system gives them: written in a case, and shown where people read them."""

import os
import unicodedata
from urllib.parse import quote_from_bytes, unquote_to_bytes

ESCAPED = "percent:"
"""How a name begins in a case file that holds bytes which are no text: `percent:` and the bytes, %FF for one."""

BIDIRECTIONAL = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Marks that turn the reading direction: a name with them is not what it looks like."""


def key_of(name: str) -> str:
    """Text by which a case file holds a name of the system: as it is, but for one with bytes that are no text, or with
    a tab or a line break, which there is a slip."""
    try:
        name.encode()
    except UnicodeEncodeError:
        return ESCAPED + quote_from_bytes(os.fsencode(name), safe="/\\: ")
    slips = any(unicodedata.category(letter) == "Cc" for letter in name)
    return ESCAPED + quote_from_bytes(os.fsencode(name), safe="/\\: ") if slips else name


def name_of(key: str) -> str:
    """The name of the system behind what a case file holds."""
    if key.startswith(ESCAPED):
        return os.fsdecode(unquote_to_bytes(key.removeprefix(ESCAPED)))
    return key


def is_text(content: str) -> bool:
    """Whether this can stand in a case: no control characters, halves of characters or line separators, and
    none that turn the reading direction."""
    kinds = {unicodedata.category(letter) for letter in content}
    return not kinds & {"Cc", "Cs", "Zl", "Zp"} and not BIDIRECTIONAL & set(content)


def shown(name: str) -> str:
    """A name for reading: what cannot be seen or written is escaped."""
    if name.isprintable():  # then every letter is text
        return name
    return "".join(
        letter if is_text(letter) else letter.encode("unicode_escape", "backslashreplace").decode() for letter in name
    )


MAX_NAME_BYTES = 120
"""Bytes of a name of a file that is made of a name of a wall."""


def file_name(name: str) -> str:
    """A name that every system takes for a file: letters and digits, _ for what lies between."""
    letters = "".join(letter if letter.isalnum() else " " for letter in unicodedata.normalize("NFC", name))
    return "_".join(letters.split()).encode()[:MAX_NAME_BYTES].decode(errors="ignore") or "_"
