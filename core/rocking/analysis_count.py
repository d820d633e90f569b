"""How many analyses this process has made: what a run prints, and what tests hold below a ceiling."""

import threading


class AnalysisCount:
    """A count that several threads add to."""

    def __init__(self) -> None:
        self._lock, self._total = threading.Lock(), 0

    def add(self, analyses: int) -> None:
        """Count analyses that were made."""
        with self._lock:
            self._total += analyses

    @property
    def total(self) -> int:
        """Analyses made since the process began."""
        return self._total


MADE = AnalysisCount()
"""Analyses of this process, and of the processes that worked for it."""
