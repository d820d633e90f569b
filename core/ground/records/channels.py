"""Files of several channels: which are there, which one is asked for. Nothing is guessed."""

import re
from collections.abc import Callable
from dataclasses import dataclass

from core.errors import RecordError
from core.ground.records.grammar import MAX_QUOTED, Options, Parsed, quoted
from core.text.sentence import sentence

MAX_CHANNELS = 200
"""Channels of a file that are looked at; real files have up to some dozens."""

MAX_LISTED = 24
"""Names in a sentence; more are counted."""

_VERTICAL = re.compile(r"\b(up|down|dwn|dn|ver|vert\w*|u-d|ud|v|z|[a-z]{2}z)\b", re.IGNORECASE)
_NUMBERED = re.compile(r"(\d+): ?")


@dataclass(frozen=True)
class Channel:
    """One channel of a file.

    name : as the file has it
    vertical : its direction is up or down
    read : its samples; raises RecordError
    """

    name: str
    vertical: bool
    read: Callable[[], Parsed]


def is_vertical(direction: str) -> bool:
    """Whether a direction as written is up or down."""
    return bool(_VERTICAL.search(direction))


def refuse_unchosen(names: list[str], verticals: list[bool], asked: str | None) -> int:
    """Number from 0 of the channel asked for, by name or by its number: its own where the file numbers them ("2: Up"),
    else its place from 1; the only one where none is asked for.
    Raises RecordError naming the channels."""
    if len(names) > MAX_CHANNELS:
        raise RecordError("too_many_channels", n=len(names), most=MAX_CHANNELS)
    if asked is None and len(names) == 1:
        return 0
    wanted = (asked or "").strip().casefold()
    same = [k for k, name in enumerate(names) if name.casefold() == wanted]
    if not same and wanted.isascii() and wanted.isdigit():
        numbered = [_NUMBERED.match(name) for name in names]
        if all(numbered):  # a number is that of the channel, whatever its place in the file
            same = [k for k, match in enumerate(numbered) if match and match[1] == wanted]
        elif 0 < int(wanted[:4]) <= len(names):
            same = [int(wanted[:4]) - 1]
    if len(same) == 1:
        return same[0]
    listed = tuple(
        sentence("accepted", "vertical_channel" if vertical else "channel", name=name[:MAX_QUOTED])
        for name, vertical in list(zip(names, verticals, strict=True))[:MAX_LISTED]
    )
    if len(names) > MAX_LISTED:
        listed += (sentence("accepted", "more_channels", n=len(names) - MAX_LISTED),)
    if asked is None:
        raise RecordError("which_channel", key="channel", n=len(names), channels=listed, names=names)
    raise RecordError("no_such_channel", given=quoted(asked), channels=listed, names=names)


def chosen(channels: list[Channel], options: Options) -> Parsed:
    """The samples of the channel asked for. Raises RecordError."""
    k = refuse_unchosen([channel.name for channel in channels], [c.vertical for c in channels], options.channel)
    parsed = channels[k].read()
    parsed.channel, parsed.vertical = channels[k].name, channels[k].vertical
    parsed.several = len(channels) > 1
    return parsed
