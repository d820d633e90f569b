"""Place of a sensor, as the head of a file says it: a record of a roof is no motion of the ground."""

import re

_NUMBERED = (
    r"(?:\d{1,3}\s*(?:st|nd|rd|th|°|º)|first|second|third|fourth|fifth|top|upper|last|ultimo|primo|secondo|terzo)"
)
_WORDS = (
    r"roof(?:top)?|penthouse|attic|copertura|tetto|lastrico|sottotetto|basement|seminterrato|sub-?basement|mezzanine"
    rf"|{_NUMBERED}[\s_]+(?:floor|fl\.?|storey|story|level|piano|solaio|impalcato)"
    r"|ground\s+floor|piano\s+terra|(?:floor|piano|solaio)\s*[#:]?\s*\d{1,3}(?!\d)"
    r"|location\s*[:=]?\s*level\s*\d{1,2}"
    r"|bridge\s+deck|deck(?:\s+level)?|impalcato|pier\s+cap|foundation|fondazione"
    r"|dam\s*\(?crest|\(crest\)|location\s*[:=]?\s*crest|crest\s+of\s+(?:the\s+)?dam|coronamento|abut(?:ment)?|bent\s+\d+"
    r"|(?:acc\w*?[_ -]?)?top(?=\s*[\[(;,\t]|\s*$)|acctop|a_?top|(?:storey|story)[_ ]?\d+|level_?\d+"
    r"|[lf]\d{1,2}[_-][xyzhv]"
    r"|bore-?hole|down-?hole|in-?hole|pozzo|foro\s+di\s+sondaggio|SENSOR_DEPTH_M:\s*(?:[3-9]|[1-9]\d+)(?:\.\d+)?"
)
IN_STRUCTURE = re.compile(rf"(?<![^\W_])(?:{_WORDS})(?![^\W\d_])", re.IGNORECASE)
"""Words of a place in a building, on a bridge, on a dam or in a borehole; names of places that contain them are no such
words."""

HEAD_LINES = 60
"""Lines of a file in which its head says where the sensor stood."""


def structure_words(lines: list[str], channel: str) -> str:
    """The words by which a head, or the name of a channel, places its sensor in a structure; "" where none does."""
    heads = [line for line in lines[:HEAD_LINES] if any(char.isalpha() for char in line)]
    for text in (channel, *heads):
        if match := IN_STRUCTURE.search(text):
            return match[0]
    return ""
