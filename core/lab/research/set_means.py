"""Reduce the runs of a parametric study to one value a motion, the lower of both signs, and one a set, the mean."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from statistics import fmean, stdev

from core.capacity.closed_forms import effective_q
from core.capacity.scale_free_law import dimensionless_intensity
from core.case.study_file import Cell
from core.known import require_value
from core.lab.research.parametric import ParametricResult, Row, StudyMotion, StudySpectrum

QUANTITIES = ("q", "q_slv", "q_slc", "q_robust")


@dataclass(frozen=True)
class MotionValue:
    """One cell under one motion: of each quantity the lower of both signs, None without a number.

    q_recorded : q of the sign as recorded
    complete : no run stopped by the limit of impacts
    """

    cell: Cell
    entry: StudyMotion
    q: float | None
    q_slv: float | None
    q_slc: float | None
    q_robust: float | None
    q_recorded: float | None
    complete: bool = True

    @property
    def pi(self) -> float:
        """Pi = p^2 SI / PGA [-]."""
        motion = self.entry.motion
        return dimensionless_intensity(self.cell.wall.block().p2, motion.housner_intensity, motion.pga)

    @property
    def q_eff(self) -> float:
        """Eq. 12."""
        return effective_q(require_value(self.q), self.entry.motion.pga)


@dataclass(frozen=True)
class SetMean:
    """One cell under the motions of one spectrum: means over those with a number, of `numbers` of them.

    scatter : standard deviation of q over its mean [-]
    intensity, pga : of the target spectrum, SI [m], a_g S [m/s2]
    """

    cell: Cell
    spectrum: StudySpectrum
    q: float
    q_slv: float
    q_slc: float
    q_robust: float
    q_recorded: float
    scatter: float
    numbers: int

    @property
    def intensity(self) -> float:
        return self.spectrum.intensity

    @property
    def pga(self) -> float:
        return self.spectrum.target.pga

    @property
    def q_eff(self) -> float:
        """Eq. 12."""
        return effective_q(require_value(self.q), self.pga)

    @property
    def pi(self) -> float:
        """Pi = p^2 SI / PGA [-] of the target spectrum."""
        return dimensionless_intensity(self.cell.wall.block().p2, self.intensity, self.pga)


def motion_values(result: ParametricResult) -> list[MotionValue]:
    """Governing values of every cell and motion, in the order of the runs."""
    runs: dict[tuple[Cell, int], list[Row]] = {}
    for row in result.rows:
        runs.setdefault((row.cell, row.motion), []).append(row)

    def lower(rows: list[Row], name: str) -> float | None:
        return min((value for row in rows if (value := getattr(row, name)) is not None), default=None)

    return [
        MotionValue(
            cell,
            result.motions[motion],
            q_recorded=lower([row for row in rows if row.polarity == 1], "q"),
            complete=all(row.status != "impact_limit" for row in rows),
            **{name: lower(rows, name) for name in QUANTITIES},
        )
        for (cell, motion), rows in runs.items()
    ]


def set_means(result: ParametricResult, values: Iterable[MotionValue]) -> list[SetMean]:
    """Means over the motions of each spectrum; sets without a number, or with a run stopped by the limit of impacts,
    are left out."""
    spectra = {spectrum.name: spectrum for spectrum in result.spectra}
    sets: dict[tuple[Cell, str], list[MotionValue]] = {}
    for value in values:
        if value.entry.spectrum:
            sets.setdefault((value.cell, value.entry.spectrum), []).append(value)

    def mean(members: list[MotionValue], name: str) -> float:
        known = [value for entry in members if (value := getattr(entry, name)) is not None]
        return fmean(known) if known else float("nan")

    means = []
    for (cell, spectrum), members in sets.items():
        known = [entry.q for entry in members if entry.q is not None]
        if known and all(entry.complete for entry in members):
            quantities = {name: mean(members, name) for name in (*QUANTITIES, "q_recorded")}
            scatter = stdev(known) / fmean(known) if len(known) > 1 else 0.0
            means.append(SetMean(cell, spectra[spectrum], scatter=scatter, numbers=len(known), **quantities))
    return means


def exact(entries: Iterable, step: float = 0.005) -> list:
    """Sets by the exact method and the default step of the search."""
    return chosen(entries, method="taylor", q_step=step)


def chosen(entries: Iterable, keep: Callable[[Cell], bool] = lambda cell: True, **wanted) -> list:
    """The entries whose cell has these values, e.g. mechanism="two_sided"."""
    return [
        entry
        for entry in entries
        if keep(entry.cell) and all(getattr(entry.cell, key) == value for key, value in wanted.items())
    ]
