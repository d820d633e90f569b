"""The language of what a person reads on screen, and what the forms of the window call the keys of a case."""

from core.case.variant_names import AS_IS, DESIGNED
from core.errors import InputError
from core.text.sentence import FormNames, Sentence, capital, format_number, localized, text_of_key, title_in, word

FORM_NAMES = FormNames()
"""Captions and units of the forms; each field adds its own."""

_current = ["en"]

followers: list = []
"""Called with the code of a language that is set: the window has Qt's own words follow."""


def set_language(code: str) -> None:
    """From now on texts are in this language; widgets made before keep theirs."""
    _current[:] = [code]
    for follow in followers:
        follow(code)


def current_language() -> str:
    """The language of the window, or of the terminal."""
    return _current[0]


def tr(text: str, /, **values) -> str:
    """A text of the window."""
    return localized("window", text, current_language(), **values)


def result_word(code: str) -> str:
    """A word of a result or of a case: a mechanism, an outcome."""
    return word(code, current_language())


def key_text(section: type, key: str, part: str) -> str:
    """What a form says of a key: part as of `text_of_key`; the caption is its word where it has no other."""
    words = text_of_key(section.__name__.lower(), key, part, _current[0])
    return words or (capital(result_word(f"key_{key}")) if part == ".caption" else "")


def variant_word(variant: str | None) -> str:
    """What a variant is called here: a case has it by an Italian name."""
    return text_of_key("wall", "variant", f"={variant}", _current[0]) if variant else ""


def wall_title(name: str) -> str:
    """Words with the name of a wall, its variant by `variant_word`, heights as the language writes them."""
    for variant in (AS_IS, DESIGNED):
        name = name.replace(f"({variant})", f"({variant_word(variant)})")
    return title_in(name, _current[0])


def number(value: float | None, form: str) -> str:
    """A number with the decimal mark of the language, "–" for None; form : as of format()."""
    return format_number(value, form, current_language())


def terminal(text: str, /, **values) -> str:
    """A text of the terminal."""
    return localized("terminal", text, current_language(), **values)


def describe_message(what: InputError | Sentence) -> str:
    """An error or a sentence, in the words of the forms."""
    return wall_title(what.text(current_language(), FORM_NAMES))


def quoted_from_file(error: InputError) -> str:
    """An error of a file that was opened, in the words of the file."""
    return error.text(current_language())
