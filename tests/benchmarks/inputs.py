"""Words of a benchmark, and how many inputs it takes: the one place where its small form differs from its real one.

A benchmark asks `Command` for its inputs and never whether it is small (tests/test_small_forms.py), so that both forms
are the same code on the same inputs, fewer of them.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar, cast

import numpy as np

MOVING = 50, 150
"""Count and first of the samples of resources/reference/standard_record.csv in which walls of either kind and either
law lift off and fall back several times."""

Inputs = TypeVar("Inputs", bound=Sequence | np.ndarray)


class Command(argparse.Namespace):
    """Words of the command.

    paired, ties, against : path where it is given
    pairs, walls, cases : count where it is given
    output : folder, None where none is given
    """

    def few(self, inputs: Inputs, count: int = 1, first: int = 0) -> Inputs:
        """All inputs; in the small form `count` of them from `first` on. Raises ValueError where they are not fewer."""
        if not 0 < count <= len(inputs) - first or first < 0 or count == len(inputs) > 1:
            raise ValueError(f"{count} inputs from {first} on are not fewer than {len(inputs)}")
        return cast(Inputs, inputs[first : first + count]) if self._small else inputs

    def number(self, count: int, fewer: int) -> int:
        """Number of inputs of one kind (walls, cases, samples) or of repeats; in the small form `fewer`, where that is
        fewer. Raises ValueError where it is none."""
        if fewer < 1:
            raise ValueError("no input at all")
        return min(count, fewer) if self._small else count

    def kernels(self, folder: str) -> str | None:
        """Folder in which processes compile their kernels anew; in the small form None, for the kernels of the tests,
        which are compiled."""
        return None if self._small else folder

    def folder(self, default: Path | str = "work_precision") -> Path:
        """Folder of what is written, made where it is missing."""
        folder = self.output or Path(default)
        folder.mkdir(parents=True, exist_ok=True)
        return folder
