"""Where a sensor stood, as the head of a file says it: a record of a roof is no motion of the ground."""

import re

_NUMBERED = (
    r"(?:\d{1,3}\s*(?:st|nd|rd|th|°|º)|first|second|third|fourth|fifth|top|upper|last|ultimo|primo|secondo|terzo)"
)
IN_STRUCTURE = re.compile(
    rf"\b(roof(?:top)?|penthouse|attic|copertura|sottotetto|basement|seminterrato|sub-?basement|mezzanine"
    rf"|{_NUMBERED}\s+(?:floor|storey|story|piano|solaio|impalcato)"
    r"|ground\s+floor|piano\s+terra|floor\s*#?\s*\d{1,3}\b|bridge\s+deck|deck\s+level|pier\s+cap"
    r"|dam\s+crest|crest\s+of\s+(?:the\s+)?dam|coronamento|(?:left|right)\s+abutment|bent\s+\d+)",
    re.IGNORECASE,
)
"""Words of a place in a building, on a bridge or on a dam; names of places that contain them are no such words."""

LINES = 60
"""Lines of a file in which its head says where the sensor stood."""


def in_structure(lines: list[str], channel: str) -> str:
    """The words by which a head, or the name of a channel, places its sensor in a structure; "" where none does."""
    heads = [line for line in lines[:LINES] if any(char.isalpha() for char in line)]
    for text in (channel, *heads):
        if found := IN_STRUCTURE.search(text):
            return found[0]
    return ""
