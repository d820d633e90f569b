"""The keys of a case as tables for resources/docs/case.md: `.venv/bin/python -m tests.reference_of_keys` writes them
there, or into the page it is given."""

import sys
from dataclasses import fields
from pathlib import Path

from core.case.keys import NESTED, is_required
from core.case.schema import sections
from core.case.values import MAX_TEXT, accepted_by
from core.text.sentence import word
from tests.conftest import ROOT

PAGE = ROOT / "resources" / "docs" / "case.md"
TITLE = "\n## Every key\n"


def reference() -> str:
    """The last part of the page: of every section its keys, what each is, what it accepts, its default."""
    lines = [TITLE, f"A text has up to {MAX_TEXT} characters."]
    for name, section in sections().items():
        lines += ["", f"`{name}`", "", "| key | what it is | accepted | default |", "|---|---|---|---|"]
        for entry in fields(section):
            what = word_of(name, entry.name)
            lines.append(f"| {entry.name} | {what} | {accepted_in(name, entry)} | {default_of(entry)} |")
    return "\n".join(lines) + "\n"


def word_of(section: str, key: str) -> str:
    """The word of a key in the sheet Input. Raises SystemExit for one that has none."""
    try:
        return word(f"key_{key}", "en")
    except KeyError:
        sys.exit(f"the key {key} of {section} has no word: add it to resources/translations/key.json (CONTRIBUTING.md)")


def accepted_in(section: str, entry) -> str:
    """What a key of a section accepts, with its unit; of one that is a section where its keys are."""
    kind = entry.metadata["kind"]
    if kind in NESTED:
        return f"keys of {section.strip('[]')}.{entry.name}, below"
    return "text" if kind == "text" else accepted_by(entry).text("en")


def default_of(entry) -> str:
    """A default as a case file would have it."""
    if is_required(entry):
        return "required"
    if entry.default in (None, "", ()):
        return "–"
    return str(entry.default).lower() if isinstance(entry.default, bool) else str(entry.default)


def with_reference(page: str) -> str:
    """The page with the table as it is to be."""
    return page.partition(TITLE)[0] + reference()


if __name__ == "__main__":
    page = Path(sys.argv[1]) if sys.argv[1:] else PAGE
    page.write_text(with_reference(page.read_text(encoding="utf-8")), encoding="utf-8")
