"""Whether a page can show a picture: it is set alone before the run, in a process of its own."""

import functools
import json
from typing import Any

from core.child import Refused, bounded

SECONDS, MEGABYTES = 20.0, 3000
"""That a picture may take: one of 40 million pixels of 16 bits takes a second."""

TOO_MUCH = "too much"

PICTURE_DOCUMENT = """
#set document(title: "picture")
#image(bytes(json(bytes(sys.inputs.data))), height: 1.5cm, alt: "picture")
"""
"""A page with the picture as the note shows it (resources/templates/note.typ)."""


@functools.lru_cache(8)
def fault_of(content: bytes, standards: tuple[str, ...]) -> str:
    """Why a picture cannot be set in a PDF of these standards; TOO_MUCH where that takes more than SECONDS or
    MEGABYTES; "" where it can be set."""
    try:
        bounded(set_alone, content, standards, seconds=SECONDS, megabytes=MEGABYTES)
    except Refused as error:
        return error.reason or TOO_MUCH
    return ""


def set_alone(content: bytes, standards: tuple[str, ...]) -> None:
    """Set a page with a picture alone, as a document and as a drawing. Raises typst.TypstError."""
    import typst

    asked: Any = list(standards)
    given = {"data": json.dumps(list(content))}
    typst.compile(PICTURE_DOCUMENT.encode(), format="pdf", pdf_standards=asked, sys_inputs=given)
    typst.compile(PICTURE_DOCUMENT.encode(), format="png", ppi=100.0, sys_inputs=given)
