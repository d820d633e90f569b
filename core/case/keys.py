"""Kinds of keys: what each accepts stands beside it as metadata of its field."""

from dataclasses import MISSING, field


def number_key(low, high, default=None, unit="", exclusive=False, whole=False):
    """A number in [low, high] (low excluded if exclusive), NaN and infinity refused."""
    kind = "int" if whole else "float"
    rule = {"kind": kind, "low": low, "high": high, "unit": unit, "exclusive": exclusive}
    return field(default=default, metadata=rule)


def channel_key():
    """The channel of a file of several: its name, or its number from 1 as a number or as text."""
    return field(default="", metadata={"kind": "channel"})


def text_key(default=""):
    return field(default=default, metadata={"kind": "text"})


def path_key(default):
    """A name of a file: longer than other text, and with any letter the system allows."""
    return field(default=default, metadata={"kind": "path"})


def flag_key(default=False):
    return field(default=default, metadata={"kind": "flag"})


def choice_key(*names, default=MISSING):
    return field(default=default, metadata={"kind": "choice", "names": names})
