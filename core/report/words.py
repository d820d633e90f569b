"""The language of a note: sentences, words and numbers."""

from dataclasses import dataclass

from core.text.sentence import Number, format_number, localized, sentence, title_in, word


@dataclass(frozen=True)
class Words:
    """language : its code."""

    language: str

    def say(self, english: str, /, **values) -> str:
        """A text of the group "report"."""
        return localized("report", english, self.language, **values)

    def titled(self, name: str) -> str:
        """A name of a wall, heights as the language writes them."""
        return title_in(name, self.language)

    def word(self, code: str) -> str:
        """A word of a result."""
        return word(code, self.language)

    def number(self, value: float | None, form: str) -> str:
        """A number, "–" for None."""
        return format_number(value, form, self.language)

    def short(self, check) -> str:
        """A check in a table: "time histories", "q = 2"."""
        return sentence("short", check.label, q=Number(check.q, "g")).text(self.language)
