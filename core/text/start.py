"""Texts that run.py prints before anything is installed. Read by any Python from 3.6 on."""

import locale
import os

from core.text.catalogue import CATALOGUE


def system_language():
    """The system's language where it is one of ours, else English."""
    named = next(filter(None, map(os.environ.get, ("LC_ALL", "LC_MESSAGES", "LANG"))), None)
    code = (named or locale.getlocale()[0] or "")[:2].lower()
    return code if code in CATALOGUE.languages else "en"


def phrase(text, **values):
    """A text of the terminal in the language of the system."""
    return CATALOGUE.text("terminal", text, system_language()).format(**values)
