"""The choice of records in words and as keys of the JSON."""

from collections.abc import Callable

from core.file_names import shown
from core.setting.record_selection import Selection

Say = Callable[..., str]
"""A text of the group "report" in the language of the report."""


def lines_of(selection: Selection, say: Say, language: str, most: int | None = None) -> list[str]:
    """How the records were chosen, how near they are, what was left out. most : reasons of it, all where None"""
    best = selection.chosen
    low, high = selection.period_range
    lines = [
        say(
            "Chosen from {folder}: {candidates} horizontal records of {files} files.",
            folder=shown(selection.folder),
            candidates=selection.candidates,
            files=selection.files,
        ),
        say("Every combination was compared.")
        if selection.every
        else say("The combinations are too many to compare all: the nearest set of a search, the same at each run."),
        say(
            "Mean over target from {low:.2f} to {high:.2f} s: {least:.2f} at {at_least:.2f} s to {most:.2f} at "
            "{at_most:.2f} s, deviation {deviation:.1f} %.",
            low=low,
            high=high,
            at_least=best.lowest[0],
            least=best.lowest[1],
            at_most=best.highest[0],
            most=best.highest[1],
            deviation=100.0 * best.deviation,
        ),
    ]
    if best.stations < best.least_stations:
        lines.append(say("The code asks for {n} stations at least.", n=best.least_stations))
    if best.miss:
        lines.append(
            say(
                "No set that was found keeps the rule of the code. This one is the nearest: its worst ordinate is "
                "{miss:.1f} % beyond the bound.",
                miss=100.0 * best.miss,
            )
        )
    if selection.reasons:
        left = "; ".join(f"{reason.text(language)} ({n})" for reason, n in selection.reasons[:most])
        left += "; …" if selection.reasons[most or len(selection.reasons) :] else ""
        lines.append(say("Left out: {left}.", left=left))
    return lines
