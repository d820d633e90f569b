"""Errors the user can mend, as data, and the cancellation of a run."""

from string import Formatter
from typing import Any

from core.text.catalogue import CATALOGUE
from core.text.sentence import FILE_NAMES, FormNames, Key, Quantity, Sentence, format_count, sentence


class InputError(ValueError):
    """Something in the input is wrong.

    code : of the group "error" of core.text
    place : where, from the outside in: names of files as text, else Sentences of the group "place"
    key, value, accepted : of the case, what was found there and what is accepted (a Sentence or text)
    values : of the sentence's other placeholders
    """

    def __init__(self, code: str, /, *, place=(), key=None, value=None, accepted=None, **values):
        super().__init__(code)
        self.code, self.place = code, tuple(place)
        self.key, self.value, self.accepted, self.values = key, value, accepted, values

    def at(self, *place) -> "InputError":
        """Add a place to the error and return it; a place that is known is not said twice, nor a wall by two names."""
        new = [str(part) if not isinstance(part, Sentence) else part for part in place]
        inner = self.place
        if any(_is_wall(part) for part in new):
            inner = tuple(part for part in inner if not _is_wall(part))
        self.place = (*(part for part in new if part not in inner), *inner)
        return self

    def text(self, language: str = "en", form: FormNames = FILE_NAMES) -> str:
        """Text of the error in one sentence: place, what was found, what is accepted, what to do."""
        shown = {
            "key": form.of(self.key or "", self.section or ""),
            "value": self.value,
            "accepted": self.accepted,
            **self.values,
        }
        if self.key in form.scales:
            shown |= self._scaled(*form.scales[self.key])
        body = Sentence("error", self.code, tuple(shown.items())).text(language, form)
        return ": ".join([*(str(format_count(part, language, form)) for part in self.place), body])

    def _scaled(self, factor: float, unit: str) -> dict:
        """Value and accepted range in the unit of a field, as values of the sentence."""
        shown: dict[str, object] = {}
        value = self.values.get("found", self.value)
        if isinstance(value, (int, float)):
            shown["value"] = f"{value * factor:g} {unit}"
        if isinstance(self.accepted, Sentence) and self.accepted.code in RANGES:
            ends: dict[str, Any] = dict(self.accepted.values)
            ends |= {end: factor * ends[end] for end in ("low", "high")}
            shown["accepted"] = sentence("accepted", self.accepted.code, **(ends | {"unit": f" {unit}"}))
        return shown

    def accepted_text(self, language: str = "en", form: FormNames = FILE_NAMES) -> str:
        """Text of what the key accepts, for the field that holds it; the whole sentence where nothing is named."""
        if self.accepted is None:
            return self.text(language, form)
        scaled = self._scaled(*form.scales[self.key]) if self.key in form.scales else {}
        comma = CATALOGUE.comma(language) and form is not FILE_NAMES
        return str(format_count(scaled.get("accepted", self.accepted), language, form, comma))

    @property
    def without_place(self) -> Sentence:
        """Text of what is wrong, for where the place is said beside it."""
        shown = {"key": Key(self.key or ""), "value": self.value, "accepted": self.accepted, **self.values}
        return Sentence("error", self.code, tuple(shown.items()))

    @property
    def keys(self) -> set[str]:
        """Keys of the case this error speaks of."""
        names = {name for _, name, _, _ in Formatter().parse(CATALOGUE["error"][self.code][0]) if name}
        named = {part for value in self.values.values() for part in _keys(value)}
        return {*(names - set(self.values)), *named, *([self.key] if self.key else [])}

    @property
    def wall(self) -> str | None:
        """Name of the wall it is about."""
        if "wall" in self.values:
            return str(self.values["wall"])
        walls = (dict(part.values)["name"] for part in self.place if _is_wall(part))
        return next((str(name) for name in walls), None)

    @property
    def section(self) -> str | None:
        """Section of the case it is about, "[demand]"."""
        sections = (dict(p.values)["name"] for p in self.place if isinstance(p, Sentence) and p.code == "section")
        return next((str(name) for name in sections), None)

    def __str__(self) -> str:
        return self.text()


def _is_wall(part) -> bool:
    """Whether this part of a place is a wall."""
    return isinstance(part, Sentence) and part.code == "wall"


def _keys(value):
    """Keys among the values of a sentence."""
    if isinstance(value, Key):
        yield str(value)
    elif isinstance(value, Quantity):
        yield value.key
    elif isinstance(value, tuple):
        for part in value:
            yield from _keys(part)


RANGES = ("from", "above", "whole")
"""Codes of what is accepted that name a range."""


class RecordError(InputError):
    """A record cannot be read as an accelerogram."""


class OutputError(InputError):
    """A result cannot be written."""


class Cancelled(Exception):
    """The user asked to stop between two analyses; finished runs are in the journal."""


def place(code: str, /, **values) -> Sentence:
    """Sentence of the place of an error: wall, record, row, cell, line or section."""
    return sentence("place", code, **values)


def section(name: str) -> Sentence:
    """Sentence of the place of a section of a case, by "[demand]"."""
    return place("section", name=Key(name))


def require(condition: bool, key: str, value, accepted) -> None:
    """Raise InputError naming the key, its value and what is accepted, unless condition holds."""
    if not condition:
        raise InputError("not_accepted", key=key, value=repr(value)[:100], accepted=accepted)
