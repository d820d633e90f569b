"""The tables of Coccia et al. (2016) from a finished study: spectra, power laws, Eq. 14, distances, natural records."""

import math
from collections.abc import Callable
from statistics import NormalDist

import numpy as np

from core.capacity.closed_forms import COEFFICIENTS, PowerLaw, closed_form_q_eff, fit_power_law
from core.capacity.regression import agreement, linear_c1, power_coefficient
from core.lab.research.figures import Table
from core.lab.research.paper_sets import (
    MECHANISM,
    THEORETICAL,
    c1_points,
    closed_form_of,
    natural_values,
    theoretical,
    words,
)
from core.lab.research.parametric import ParametricResult
from core.lab.research.set_means import MotionValue, SetMean, chosen
from core.units import CM, G
from core.wall.kinematics import kinematics

Say = Callable[..., str]

OUTLIER_MEASURES = ("PGV", "PGV/PGA", "5-95 %")


def power_laws(sets: list[SetMean], mechanism: str) -> list[tuple[float, float, PowerLaw]]:
    """(alpha [deg], H [m], Eq. 13 with free C2) of every wall of the paper's grid with three sets."""
    ours = theoretical(sets, mechanism)
    laws = []
    for alpha, height in sorted({(e.cell.slenderness_deg, e.cell.height_m) for e in ours}):
        members = chosen(ours, slenderness_deg=alpha, height_m=height)
        law = fit_power_law([e.intensity for e in members], [e.q_eff for e in members])
        if law:
            laws.append((alpha, height, law))
    return laws


def points_of(sets: list[SetMean], mechanism: str, alpha: float, height: float) -> tuple[np.ndarray, np.ndarray]:
    """Logarithms of SI [cm] and of q_eff of the sets of a wall of the paper's grid. alpha : [deg]; height : [m]"""
    members = chosen(theoretical(sets, mechanism), slenderness_deg=alpha, height_m=height)
    return np.log([e.intensity / CM for e in members]), np.log([e.q_eff for e in members])


STUDENT = (
    *(6.3138, 2.9200, 2.3534, 2.1318, 2.0150, 1.9432, 1.8946, 1.8595, 1.8331, 1.8125),
    *(1.7959, 1.7823, 1.7709, 1.7613, 1.7531, 1.7459, 1.7396, 1.7341, 1.7291, 1.7247),
)
"""Quantile of 95 % of Student's distribution with one degree of freedom, two and so on, as any table has it."""


def student(free: int) -> float:
    """Quantile of 95 % of Student's distribution; beyond the table by its expansion about the normal one (Fisher)."""
    if free <= len(STUDENT):
        return STUDENT[free - 1]
    z = NormalDist().inv_cdf(0.95)
    return z + (z**3 + z) / (4.0 * free) + (5.0 * z**5 + 16.0 * z**3 + 3.0 * z) / (96.0 * free**2)


def exponent_error(x: np.ndarray, y: np.ndarray) -> float:
    """Half of the interval of 90 % of the exponent of a power law through points, given by their logarithms."""
    free = x.size - 2
    dx, dy = x - x.mean(), y - y.mean()
    left = dy - (dx @ dy) / (dx @ dx) * dx
    return student(free) * math.sqrt((left @ left) / free / (dx @ dx))


def residual(x: np.ndarray, y: np.ndarray, law: PowerLaw) -> float:
    """Largest distance of points, given by their logarithms, from their power law [-]."""
    return float(np.abs(np.expm1(y - math.log(law.c1) - law.c2 * x)).max())


def spectra_table(result: ParametricResult, say: Say) -> Table:
    """Table 1: the target spectra and the mean of their motions."""
    rows = []
    for spectrum in result.spectra:
        own = [entry.motion for entry in result.motions if entry.spectrum == spectrum.name]
        mean = sum(motion.housner_intensity for motion in own) / len(own)
        pga = spectrum.target.pga
        rows.append(
            (
                spectrum.group,
                spectrum.name,
                spectrum.target.name,
                pga / G,
                spectrum.intensity / CM,
                spectrum.intensity / CM / (pga / G),
                mean / CM,
            )
        )
    head = (
        say("group"),
        say("spectrum"),
        say("shape"),
        "PGA [g]",
        "SI [cm]",
        "SI/PGA [cm/g]",
        say("SI of motions [cm]"),
    )
    return Table("table1", say("Table 1: the spectra, our reconstruction"), head, tuple(rows))


def power_law_table(sets: list[SetMean], say: Say) -> Table:
    """Eq. 13 with free and with given exponent, wall by wall."""
    rows = []
    for mechanism in THEORETICAL:
        c2 = COEFFICIENTS[kinematics(mechanism).one_way][3]
        for alpha, height, law in power_laws(sets, mechanism):
            members = chosen(theoretical(sets, mechanism), slenderness_deg=alpha, height_m=height)
            given = power_coefficient([e.intensity / CM for e in members], [e.q_eff for e in members], c2)
            by_shape = fit_power_law([e.intensity / e.pga for e in members], [e.q for e in members])
            rows.append(
                (
                    say(MECHANISM[mechanism]),
                    alpha,
                    height,
                    law.c1,
                    law.c2,
                    exponent_error(*points_of(sets, mechanism, alpha, height)),
                    law.r_squared,
                    residual(*points_of(sets, mechanism, alpha, height), law),
                    given.coefficients[0],
                    given.r_squared,
                    by_shape.c2 if by_shape else None,
                    by_shape.r_squared if by_shape else None,
                )
            )
    head = (
        say("mechanism"),
        "α [°]",
        "H [m]",
        "C1",
        "C2",
        "± 90 %",
        "R²",
        say("furthest set"),
        say("C1, C2 of the paper"),
        "R²",
        say("exponent of q in SI/PGA"),
        "R²",
    )
    note = say(
        "q_eff = q g/PGA holds 1/PGA, and so part of its correlation with SI: the last two columns are free of it."
    )
    return Table("eq13", say("Eq. 13: power laws of q_eff in SI"), head, tuple(rows), note)


def coefficients(sets: list[SetMean], mechanism: str, c2: float) -> tuple[float, ...] | None:
    """A1, A2, A3 and R2 of Eq. 14 with this C2; None with fewer than four walls or without two of alpha and of H."""
    walls = c1_points(sets, mechanism, c2)
    if len(walls) < 4:
        return None
    alphas, heights, c1 = zip(*walls, strict=True)
    if len(set(alphas)) < 2 or len(set(heights)) < 2:
        return None
    fit = linear_c1(alphas, heights, c1)
    return (*fit.coefficients, fit.r_squared)


def linear_table(sets: list[SetMean], say: Say) -> Table:
    """Eq. 14: A1 to A3 with the paper's exponent and with the mean of the free ones."""
    rows: list[tuple] = []
    for mechanism in THEORETICAL:
        a1, a2, a3, c2 = COEFFICIENTS[kinematics(mechanism).one_way]
        rows.append((say(MECHANISM[mechanism]), say("paper"), c2, a1, a2, a3, None))
        free = [law.c2 for _, _, law in power_laws(sets, mechanism)]
        exponents = [(say("fitted, C2 of the paper"), c2)]
        if free:
            exponents.append((say("fitted, mean of the free C2"), float(np.mean(free))))
        for name, exponent in exponents:
            fitted = coefficients(sets, mechanism, exponent)
            if fitted:
                rows.append((say(MECHANISM[mechanism]), name, exponent, *fitted))
    head = (say("mechanism"), say("source"), "C2", "A1 [1/°]", "A2 [1/m]", "A3", "R²")
    return Table("eq14", say("Eq. 14: C1 = A1 α + A2 H + A3"), head, tuple(rows))


def distance_table(sets: list[SetMean], say: Say) -> Table:
    """The distance of Eq. 15 and 16 from q, by integrator, step of the search, spectra and sign."""
    rows = []

    def add(name: str, mechanism: str, members: list[SetMean], truth=lambda entry: entry.q) -> None:
        if members:
            statistics = agreement([closed_form_of(e) for e in members], [truth(e) for e in members])
            rows.append(
                (say(MECHANISM[mechanism]), name, statistics.bias, statistics.scatter, statistics.within, statistics.n)
            )

    for mechanism, model in THEORETICAL.items():
        base = chosen(sets, mechanism=mechanism, restitution=model, law="rigid")
        add(say("exact, step 0.5 %"), mechanism, theoretical(sets, mechanism))
        for step in sorted({e.cell.q_step for e in base} - {0.005}):
            add(say("exact, step {step:g} %", step=100 * step), mechanism, chosen(base, method="taylor", q_step=step))
        for method in sorted({e.cell.method for e in base} - {"taylor"}):
            add(words(say).get(method, method), mechanism, chosen(base, method=method))
        if kinematics(mechanism).one_way:
            add(say("exact, as recorded"), mechanism, theoretical(sets, mechanism), lambda entry: entry.q_recorded)
        ours = theoretical(sets, mechanism)
        for name in dict.fromkeys(e.spectrum.name for e in ours):
            add(say("exact, spectrum {name}", name=name), mechanism, [e for e in ours if e.spectrum.name == name])
    head = (say("mechanism"), say("q of the time histories"), say("Eq. over q, mean - 1"), say("scatter"), "±20 %", "n")
    note = say(
        "What goes with the integrator, the step of the search and the shape of the spectra; no cause is claimed."
    )
    return Table("distance", say("Eq. 15 and 16 against q"), head, tuple(rows), note)


def spearman(x, y) -> float:
    """Rank correlation [-]."""
    ranks = [np.argsort(np.argsort(np.asarray(values, float))).astype(float) for values in (x, y)]
    return float(np.corrcoef(ranks[0], ranks[1])[0, 1])


def natural_table(values: list[MotionValue], say: Say) -> Table | None:
    """Table 2: the natural records and what the intermediate wall makes of them; None without records."""
    by_record: dict[str, dict[str, MotionValue]] = {}
    event: dict[str, str] = {}
    for mechanism in THEORETICAL:
        for value in natural_values(values, mechanism):
            by_record.setdefault(value.entry.motion.name, {})[mechanism] = value
            event[value.entry.motion.name] = value.entry.event
    if not by_record:
        return None
    rows, logs, measures = [], [], []
    for name, by_mechanism in sorted(by_record.items()):
        motion = next(iter(by_mechanism.values())).entry.motion
        cells: list[object] = []
        for mechanism in THEORETICAL:
            value = by_mechanism.get(mechanism)
            if value is None:
                cells += [None, None]
                continue
            block = value.cell.wall.block()
            form = closed_form_q_eff(
                block.slenderness, block.height, motion.housner_intensity, kinematics(mechanism).one_way
            )
            cells += [value.q, value.q_eff / form]
            if kinematics(mechanism).both_ways:
                logs.append(math.log(value.q_eff / form))
                measures.append((motion.pgv, motion.pgv / motion.pga, motion.duration_5_95))
        rows.append(
            (
                event[name],
                name,
                motion.pga / G,
                motion.pgv / CM,
                motion.housner_intensity / CM,
                motion.duration_5_95,
                *cells,
            )
        )
    note = say(
        "The print gives PGA to 0.01 g: its rows of 0.02 and 0.03 g are uncertain by 17 to 25 % and cannot test ±20 %."
    )
    if len(logs) > 3:
        goes = [spearman(column, logs) for column in zip(*measures, strict=True)]
        named = ", ".join(f"{name} {value:+.2f}" for name, value in zip(OUTLIER_MEASURES, goes, strict=True))
        note += " " + say("Rank correlation of q_eff over Eq. 15 with {words}.", words=named)
    head = (
        say("earthquake"),
        say("record"),
        "PGA [g]",
        "PGV [cm/s]",
        "SI [cm]",
        "5-95 % [s]",
        say("q two-sided"),
        say("q_eff over Eq. 15"),
        say("q one-sided"),
        say("q_eff over Eq. 16"),
    )
    return Table("table2", say("Table 2: natural records, 6.8 degrees, 7 m"), head, tuple(rows), note)


def tables(result: ParametricResult, values: list[MotionValue], sets: list[SetMean], say: Say) -> list[Table]:
    """All of them."""
    made = [
        spectra_table(result, say),
        power_law_table(sets, say),
        linear_table(sets, say),
        distance_table(sets, say),
        natural_table(values, say),
    ]
    return [table for table in made if table is not None and table.rows]
