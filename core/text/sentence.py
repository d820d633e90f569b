"""The one mechanism for every text a person reads: a group, a code and values; core.text.catalogue has the wording
in each language."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from core.file_names import shown
from core.text.catalogue import CATALOGUE

LANGUAGES = {code: about["name"] for code, about in CATALOGUE.languages.items()}
"""Code of a language -> its own name."""


@dataclass
class FormNames:
    """Captions by which the forms of the window call the keys of a case.

    captions : key, name or section -> caption; "[demand].site" where two sections have a key of one name
    scales : key -> (factor, unit) of a field in another unit than its key
    """

    captions: dict[str, str] = field(default_factory=dict)
    scales: dict[str, tuple[float, str]] = field(default_factory=dict)

    def of(self, key: str, section: str = "") -> str:
        """The caption of a key of a section, else the key; of a choice of a key, "key=choice", else the choice."""
        return self.captions.get(f"{section}.{key}", self.captions.get(key, key.rpartition("=")[2]))

    def add(self, key: str, caption: str, section: str = "") -> None:
        """A field of this key and caption."""
        self.captions[f"{section}.{key}"] = self.captions[key] = caption


FILE_NAMES = FormNames()
"""The words of a case file itself."""


class CommaFloat(float):
    """A number that is written with the decimal comma, whatever the format asks."""

    def __format__(self, form: str) -> str:
        return super().__format__(form).replace(".", ",")


class Key(str):
    """A key, name or section of a case file as a value of a sentence."""

    __slots__ = ()


@dataclass(frozen=True)
class Quantity:
    """The value of a key as a value of a sentence; in the unit of its field where the window says it."""

    key: str
    value: float


@dataclass(frozen=True)
class Number:
    """A number as a value of a sentence that says nothing of its format; "–" for None. form : as of format()"""

    value: float | None
    form: str = ".2f"


@dataclass(frozen=True)
class Sentence:
    """A text as data: group and code of the catalogue, values of its placeholders. In an error a placeholder
    without a value is a key of the case; section_demand is [demand]."""

    group: str
    code: str
    values: tuple[tuple[str, object], ...] = ()

    def text(self, language: str = "en", form: FormNames = FILE_NAMES) -> str:
        """The words in a language; raises KeyError for an unknown code."""
        # an error of a file is in the numbers of the file, which have points
        comma = CATALOGUE.comma(language) and not (self.group == "error" and form is FILE_NAMES)
        return self.in_numbers(comma, language, form)

    def in_numbers(self, comma: bool, language: str, form: FormNames) -> str:
        """`text`, its numbers with the decimal comma or with the point."""
        template = CATALOGUE.text(self.group, self.code, language)
        keyed = self.group == "error"
        return template.format_map(_Values(self.values, language, form, keyed, comma))


class _Values(Mapping):
    """Values of a template's placeholders, each in words."""

    def __init__(self, values, language: str, form: FormNames, keyed: bool, comma: bool):
        self.values_of, self.keyed = dict(values), keyed
        self.language, self.form, self.comma = language, form, comma

    def __getitem__(self, name: str):
        if name in self.values_of:
            return format_count(self.values_of[name], self.language, self.form, self.comma)
        if not self.keyed:
            raise KeyError(name)
        if name.startswith("section_"):
            name = f"[{name.removeprefix('section_').replace('_', '.')}]"
        return self.form.of(name)

    def __iter__(self):
        return iter(self.values_of)

    def __len__(self) -> int:
        return len(self.values_of)


def format_count(value, language: str, form: FormNames = FILE_NAMES, comma: bool = False):
    """A value of a sentence: what is a sentence, a key, a quantity or several of these in words, else itself.
    comma : of a number, in the place of the decimal point"""
    if isinstance(value, Sentence):
        return value.in_numbers(comma, language, form)
    if isinstance(value, Key):
        return form.of(value)
    if isinstance(value, Quantity):
        factor, unit = form.scales.get(value.key, (1.0, ""))
        number = format_count(value.value * factor, language, form, comma)
        return f"{number:g} {unit}".strip()
    if isinstance(value, Number):
        return _written(value.value, value.form, comma)
    if isinstance(value, tuple):
        return ", ".join(str(format_count(part, language, form, comma)) for part in value)
    if isinstance(value, float) and comma:
        return CommaFloat(value)
    if isinstance(value, (str, Path)):  # no letter of a name moves the cursor or begins a line
        return shown(str(value))
    return value


def format_number(value: float | None, form: str, language: str) -> str:
    """A number as it is written in a language, "–" for None; form : as of format()."""
    return _written(value, form, CATALOGUE.comma(language))


def _written(value: float | None, form: str, comma: bool) -> str:
    if value is None:
        return "–"
    return format(CommaFloat(value) if comma else value, form)


def apart(value: float | None, limit: float, above: bool = False) -> Number:
    """A ratio of a check with the digits, two to four, that keep a value below its limit from reading as the limit;
    above : one above it as well."""
    if value is None:
        return Number(None)
    for digits in (2, 3, 4):
        shown = round(value, digits)
        if (shown < limit) == (value < limit) and not (above and shown == limit != value):
            return Number(value, f".{digits}f")
    return Number(limit - 1e-4 if value < limit else limit + 1e-4, ".4f")


def sentence(group: str, code: str, /, **values) -> Sentence:
    """A Sentence of this group and code; raises KeyError for an unknown one."""
    CATALOGUE[group][code]
    return Sentence(group, code, tuple(values.items()))


def localized(group: str, code: str, language: str, /, **values) -> str:
    """The words of a group and code in a language."""
    return sentence(group, code, **values).text(language)


def notice(code: str, /, **values) -> Sentence:
    """A warning of a result."""
    return sentence("notice", code, **values)


PART_OF_NAME = re.compile(r" [\[(][\d.+–−, ]+ m[\])]")
"""What stands behind the name of a wall for a part of it: a hinge, a stretch, the holds it is without."""


def title_in(name: str, language: str) -> str:
    """A name of a wall, or words with it, with the decimal mark of a language in the heights of its part."""
    if language == "en":
        return name
    return PART_OF_NAME.sub(lambda found: re.sub(r"(?<=\d)\.(?=\d)", ",", found[0].replace(", ", "; ")), name)


def word(code: str, language: str) -> str:
    """A word of a result; `key_height_m` is that of a key."""
    if code.startswith("key_"):
        return localized("key", code.removeprefix("key_"), language)
    return localized("word", code, language)


def text_of_key(section: str, key: str, part: str, language: str) -> str:
    """Text of the catalogue for a key of a section, "" if it has none. part : ".caption", ".tip", ".help", "=" and a
    choice. section : where keys of one name are called otherwise ("load.kind")"""
    known = CATALOGUE["key"]
    code = f"{section}.{key}{part}"
    texts = known.get(code if code in known else f"{key}{part}")
    return CATALOGUE.of(texts, language) if texts else ""


def choice(name: str, language: str) -> str:
    """Word for a name that a key accepts, of a key its own; the name itself where it has none."""
    if f"choice_{name}" in CATALOGUE["word"]:
        return word(f"choice_{name}", language)
    return word(f"key_{name}", language) if name in CATALOGUE["key"] else name


def capital(label: str) -> str:
    """A word as it begins a line; a symbol (a_g, ζ) stays."""
    plain = label[:1].islower() and label[:1].isascii() and "_" not in label.split()[0]
    return label[0].upper() + label[1:] if plain else label
