"""The wording of every text a person reads, by group and code. A group is a file of resources/translations, read when
it is first asked for. Read by any Python from 3.6 on."""

import json
from collections.abc import Mapping
from pathlib import Path
from string import Formatter

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "translations"

GROUPS = (
    "error",  # what the user can mend; a placeholder without a value is a key of the case
    "place",  # where an error is
    "accepted",  # what is accepted instead, and other parts of an error
    "notice",  # warnings of a result
    "word",  # results, kinds of loads, sections and choices of a case, ways to get a package
    "key",  # of a case: its word; .caption, .tip, =choice of its field, .help for F1, .column of a table of walls
    "assumption",  # what the engineer confirms by ticking
    "verdict",  # what stands after the name of the wall
    "added",  # parts of a verdict's sentence
    "reason",  # of a verdict
    "mechanism",  # rows of a register: names, directions, status, and why one is not possible
    "missing",  # what T_0 and the spectrum there take
    "short",  # what a list of checks calls a check
    "method_label",  # paragraphs of the sheet Method
    "method_body",
    "report",  # workbook, calculation note, parametric study; the code is the English wording
    "window",  # the code is the English wording
    "solved",  # titles, answers and comments of solved cases
    "terminal",  # with run.py; the code is the English wording
)


class Catalogue(Mapping):
    """Group -> code -> its texts, one in each language, in English where a language has none.

    languages : code -> {"name": its own name, "decimal_comma": whether numbers have it}: English, Italian, and each
        that has a folder of its code in that of the catalogue, with language.json and the groups it translates
    faults : code -> (file, what is wrong) of a language that cannot be used; the others can
    """

    def __init__(self, folder):
        self.folder, self.known, self.faults, self.own = folder, {}, {}, {}
        self.languages = {
            "en": {"name": "English", "decimal_comma": False},
            "it": {"name": "Italiano", "decimal_comma": True},
        }
        for about in sorted(folder.glob("*/language.json")):
            code = about.parent.name
            try:
                told = content_of(about)
                kinds = {key: type(value) for key, value in told.items()}
                if code in self.languages or kinds != {"name": str, "decimal_comma": bool}:
                    raise RuntimeError("not a name, and true or false for decimal_comma, of a language more")
                groups = [path for path in about.parent.glob("*.json") if path.stem in GROUPS]
                own = {path.stem: content_of(path) for path in groups}
            except RuntimeError as error:
                self.faults[code] = (str(about.parent), str(error))
                continue
            self.languages[code], self.own[code] = told, own

    def comma(self, language):
        """Whether numbers have the decimal comma in a language."""
        return self.languages[language]["decimal_comma"]

    def text(self, group, code, language):
        """The text of a group and code. Raises KeyError for an unknown one."""
        return self.of(self[group][code], language)

    def of(self, texts, language):
        """Choose among the texts of a code the one in a language."""
        return texts[list(self.languages).index(language)]

    def __getitem__(self, group):
        if group not in self.known:
            if group not in GROUPS:
                raise KeyError(group)
            self.known[group] = texts_of(self.folder / (group + ".json"))
            for language in list(self.languages)[2:]:
                translated = self.own[language].get(group, {})
                for code, texts in self.known[group].items():
                    self.known[group][code] = (*texts, in_its_place(translated.get(code), texts[0]))
        return self.known[group]

    def __iter__(self):
        return iter(GROUPS)

    def __len__(self):
        return len(GROUPS)


def content_of(path):
    """What a JSON object in a file holds; raises RuntimeError where it is damaged: no input is at fault."""
    try:
        content = json.loads(path.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError) as error:
        raise RuntimeError("the texts of " + str(path) + " cannot be read: " + repr(error)) from error
    if not isinstance(content, dict):
        raise RuntimeError("the texts of " + str(path) + " cannot be read: no object")
    return content


def in_its_place(text, english):
    """A translated text where it can stand for the English one: a text, with the same placeholders of the same formats
    (0.69 with none of its decimals is 1); else that."""
    try:
        named = [{part[1:] for part in Formatter().parse(one) if part[1] is not None} for one in (text, english)]
    except (TypeError, ValueError):
        return english
    return text if named[0] == named[1] else english


def texts_of(path):
    """Code -> (English, Italian) of a file; raises RuntimeError where it is missing or damaged: no input is at fault.

    The file has the Italian alone where the code is the English wording, else "en" and "it", a long one in parts.
    """
    try:
        texts = json.loads(path.read_text(encoding="utf-8"))
        return {
            code: (code, text) if isinstance(text, str) else ("".join(text["en"]), "".join(text["it"]))
            for code, text in texts.items()
        }
    except (OSError, ValueError, AttributeError, KeyError, TypeError) as error:
        raise RuntimeError("the texts of " + str(path) + " cannot be read: " + repr(error)) from error


CATALOGUE = Catalogue(FOLDER)
