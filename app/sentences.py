"""Sentences of the core in the language of the window: what an input check says is English there."""

import re
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "translations"
HOLE = "{}"
_spoken = ["en"]

captions: dict[str, str] = {}
"""What the forms call the keys, names and sections of a case file; each field adds its own."""
scales: dict[str, tuple[float, str]] = {}
"""Of keys whose field has another unit: its factor and unit."""
NAMED = re.compile(
    r'"[^"]*"|\[[a-z.]+\]|(?<![\w./\\-])([a-z]\w*_\w+)(?![\w/\\-]|\.\w)( = (-?\d+(?:\.\d+)?(?:e[+-]?\d+)?))?'
)
"""Names in quotes, sections, keys and what they are; never a part of a path."""


def speak(language: str) -> None:
    """From now on `said` speaks this language."""
    _spoken[:] = [language]


def spoken() -> str:
    """The language of the window."""
    return _spoken[0]


@cache
def catalogue(language: str) -> list[tuple[re.Pattern, str, str]]:
    """(pattern, English, translation) of each sentence, those with most words of their own first."""
    path = FOLDER / f"sentences_{language}.txt"
    if not path.exists():
        return []
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line[:1] != "#"]
    pairs = sorted(
        zip(lines[::2], lines[1::2], strict=True), key=lambda pair: -len(pair[0].replace(HOLE, ""))
    )
    return [
        (re.compile("(.+?)".join(map(re.escape, english.split(HOLE))), re.DOTALL), english, other)
        for english, other in pairs
    ]


def said(sentence: object) -> str:
    """A sentence in the language of the window, with the words of its forms for what a case file calls otherwise;
    names in quotes stay. (What is wrong in a file opened is said in the words of the file: `translated`.)"""
    return NAMED.sub(_as_in_the_form, translated(sentence))


def _as_in_the_form(found: re.Match) -> str:
    key, value = found[1], found[3]
    if value and key in scales:
        factor, unit = scales[key]
        return f"{captions[key]} = {float(value) * factor:g} {unit}"
    return captions.get(key or found[0], key or found[0]) + (found[2] or "")


def translated(sentence: object, language: str | None = None) -> str:
    """A sentence in a language, what it names within it too; as it is where the catalogue has none."""
    sentence, language = str(sentence), language or _spoken[0]
    for pattern, english, other in catalogue(language):
        found = pattern.fullmatch(sentence)
        if found:
            before = english.split(HOLE)
            parts = [
                part if start.endswith('"') else translated(part, language)
                for part, start in zip(found.groups(), before, strict=False)
            ]
            pieces = other.split(HOLE)
            return "".join(piece + part for piece, part in zip(pieces, [*parts, ""], strict=True))
    return sentence
