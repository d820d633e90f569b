"""Texts of a result in files of XML: workbook, Word document, SVG."""

import re
from dataclasses import fields, is_dataclass, replace
from typing import Any

_NOT_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Letters that no XML file may hold (XML 1.0, 2.2): control characters, halves of characters, U+FFFE and U+FFFF."""

_LIKE_A_CODE = re.compile(r"_(?=x[0-9A-Fa-f]{4}_)")


def escape_for_xml(value: Any) -> Any:
    """A text that XML can hold, the rest of it escaped as \\uffff; bytes are one in UTF-8; of a sequence or a
    dataclass all the texts in it."""
    if isinstance(value, str):
        return _NOT_XML.sub(lambda letter: letter[0].encode("unicode_escape").decode(), value)
    if isinstance(value, bytes):
        return escape_for_xml(value.decode()).encode()
    if isinstance(value, (tuple, list)):
        return type(value)(map(escape_for_xml, value))
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{entry.name: escape_for_xml(getattr(value, entry.name)) for entry in fields(value)})
    return value


def escape_for_cell(text: str) -> str:
    """A text as a cell of a workbook holds it (ST_Xstring, ECMA-376-1 22.9.2.19): where it looks like the code of a
    letter, as _x0041_, its line is written as a code, for Excel would show the letter."""
    return _LIKE_A_CODE.sub("_x005F_", escape_for_xml(text))
