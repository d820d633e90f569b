"""What a study of the scale-free law shows: fits, rivals, natural records, what q = 2 is worth."""

import functools
import math
from collections.abc import Callable
from dataclasses import asdict
from itertools import product

import numpy as np

from core.capacity.closed_forms import closed_form_q
from core.capacity.regression import Agreement, agreement, least_squares_of
from core.capacity.scale_free_law import ScaleFreeLaw, law_value, loss_ratio
from core.lab.research.figures import DASHED, LINE, LINE_POINTS, Figure, Series, StudyReport, Table
from core.lab.research.law_fit import MIN_SHAPES, STANDARD_ERRORS, Columns, columns, fits_of, left_out, set_columns
from core.lab.research.paper_figures import curve, scatter
from core.lab.research.paper_sets import MECHANISM, THEORETICAL, words
from core.lab.research.parametric import ParametricResult
from core.lab.research.set_means import MotionValue
from core.units import CM, G
from core.wall.block import Block
from core.wall.kinematics import kinematics
from core.wall.restitution import restitution

Say = Callable[..., str]

CODE_Q = 2.0
PAPER_RANGE = ((3.0, 12.0), (3.0, 12.0))
"""Slenderness [deg] and H [m] of the cells nearest to those Eq. 15 and 16 were fitted on."""


def _law_table(fits: dict, say: Say) -> Table:
    rows = []
    for (mechanism, law, quantity), fit in fits.items():
        cells: list = [say(MECHANISM[mechanism]), words(say)[law], words(say)[quantity]]
        for value, error in zip(fit.law.coefficients, fit.errors, strict=True):
            cells.append(f"{value:.2f} ± {STANDARD_ERRORS * error:.2f}")
        natural = fit.natural
        rows.append(
            (
                *cells,
                fit.law.limit,
                fit.inside.scatter,
                fit.outside.scatter,
                fit.records.scatter,
                natural.bias if natural else None,
                natural.scatter if natural else None,
                natural.n if natural else None,
                *fit.law.scaled_range,
            )
        )
    head = (
        say("mechanism"),
        say("law"),
        say("quantity"),
        "a0",
        "a1",
        "b0",
        "b1",
        say("limit"),
        say("scatter of sets"),
        say("scatter, shape left out"),
        say("scatter of single motions"),
        say("natural records, mean - 1"),
        say("natural records, scatter"),
        say("natural records"),
        say("least Λ"),
        say("largest Λ"),
    )
    note = say(
        "q = limit + exp(a0 + a1 s) Λ^-(b0 + b1 s), s = sqrt(1 - e), Λ = p²/PGA times the integral of S_v over a band "
        "of periods over 1/p: 0.2 to 8 two-sided, 0.2 to 5 one-sided. Intervals of 90 % by leaving out "
        "one shape at a time. Natural records were never used in a fit."
    )
    return Table("law", say("Ribalta's law of q, a research output"), head, tuple(rows), note)


def _rival_table(values: list[MotionValue], fits: dict, say: Say) -> Table:
    """The law beside p PGV/PGA and Eq. 15/16, as printed and refitted, on the same sets."""
    rows = []

    def add(mechanism: str, quantity: str, name: str, distance: Agreement) -> None:
        rows.append(
            (
                say(MECHANISM[mechanism]),
                words(say)[quantity],
                name,
                distance.bias,
                distance.scatter,
                distance.within,
                distance.n,
            )
        )

    for (mechanism, law, quantity), fit in fits.items():
        if law != "rigid":
            continue
        add(mechanism, quantity, say("Λ, shape left out"), fit.outside)
        add(mechanism, quantity, say("Π, shape left out"), fit.outside_pi)
        add(mechanism, quantity, say("p PGV/PGA, shape left out"), fit.outside_velocity)
        if fit.natural and fit.natural_velocity and fit.natural_pi:
            add(mechanism, quantity, say("Λ, natural records"), fit.natural)
            add(mechanism, quantity, say("Π, natural records"), fit.natural_pi)
            add(mechanism, quantity, say("p PGV/PGA, natural records"), fit.natural_velocity)
        if quantity != "q":
            continue
        sets = set_columns(columns(values, mechanism, law, quantity, False))
        sets = sets[sets.default]
        form = _closed_forms(sets, mechanism)
        (low, high), (short, tall) = PAPER_RANGE
        near = (sets.alpha >= low) & (sets.alpha <= high) & (sets.height >= short) & (sets.height <= tall)
        number = 15 + (kinematics(mechanism).one_way)
        own = law_value(fit.law.coefficients, fit.law.limit, sets.scaled, sets.loss)
        for where, which in ((say("all walls"), np.ones(near.size, bool)), (say("walls near the paper's"), near)):
            if which.any():
                add(mechanism, quantity, f"Eq. {number}, {where}", agreement(form[which], sets.q[which]))
                add(mechanism, quantity, f"Λ, {where}", agreement(own[which], sets.q[which]))
        if np.unique(sets.spectrum).size >= MIN_SHAPES:
            refit = say("Eq. {number} refitted on these walls, shape left out", number=number)
            add(mechanism, quantity, refit, agreement(_refit(sets), sets.q))
            _, predicted = left_out(sets, sets.scaled, fit.law.limit)
            add(mechanism, quantity, say("Λ on these walls, shape left out"), agreement(predicted, sets.q))
    head = (say("mechanism"), say("quantity"), say("law of q"), say("mean - 1"), say("scatter"), "±20 %", "n")
    return Table("rivals", say("Laws of q side by side"), head, tuple(rows))


def _closed_forms(sets: Columns, mechanism: str) -> np.ndarray:
    one_sided = kinematics(mechanism).one_way
    return np.array(
        [
            closed_form_q(np.radians(a), h, si, pga, one_sided)
            for a, h, si, pga in zip(sets.alpha, sets.height, sets.intensity, sets.pga, strict=True)
        ]
    )


def _refit(sets: Columns) -> np.ndarray:
    """q of Eq. 13 and 14 with A1, A2, A3 and C2 fitted to these sets without those of its own shape."""
    ratio = np.log(100.0 * sets.intensity / (sets.pga / G))

    def value(c, own):
        level = c[0] * sets.alpha[own] + c[1] * sets.height[own] + c[2]
        return np.log(np.maximum(level, 1e-3)) + c[3] * ratio[own]

    def distance(own, c):
        return value(c, own) - np.log(sets.q[own])

    predicted = np.empty(sets.q.size)
    for shape in dict.fromkeys(sets.spectrum):
        own = sets.spectrum == shape
        fit = least_squares_of(functools.partial(distance, ~own), (30.0, 78.0, 90.0, -1.0))
        predicted[own] = np.exp(value(fit, own))
    return predicted


def _below_code(values: list[MotionValue], mechanism: str) -> Columns:
    """Sets of the default restitution and rigid law, q of SLV."""
    runs = columns(values, mechanism, "rigid", "q_slv", False)
    return set_columns(runs[runs.default]) if runs.q.size else runs


def _code_figure(values: list[MotionValue], say: Say) -> tuple[Figure, Table, list[str]]:
    """Figure of what q = 2 is worth: share of sites where q_slv stays below it; the table, and three sentences."""
    series: list[Series] = []
    rows, shares = [], {}
    for mechanism in MECHANISM:
        sets = _below_code(values, mechanism)
        low = sets.q < CODE_Q
        shares[mechanism] = (sets, low)
        for color, alpha in enumerate(np.unique(sets.alpha)):
            own = sets.alpha == alpha
            points = [(h, 100.0 * low[own & (sets.height == h)].mean()) for h in np.unique(sets.height)]
            name = f"{say(MECHANISM[mechanism])}, {alpha:g}°"
            look = LINE_POINTS if kinematics(mechanism).both_ways else DASHED
            series.append(curve(name, points, look, color))
        ratio = sets.intensity / CM / (sets.pga / G)
        edges = np.array([0.0, 250.0, 350.0, 450.0, 550.0, np.inf])
        for k in range(edges.size - 1):
            inside = (ratio >= edges[k]) & (ratio < edges[k + 1])
            if inside.any():
                rows.append(
                    (
                        say(MECHANISM[mechanism]),
                        float(edges[k]),
                        float(edges[k + 1]) if k < edges.size - 2 else None,
                        float(100.0 * low[inside].mean()),
                        float(np.median(sets.q[inside])),
                        int(inside.sum()),
                    )
                )
    head = (
        say("mechanism"),
        say("SI/PGA from [cm/g]"),
        say("to [cm/g]"),
        say("q SLV below 2 [%]"),
        say("median q SLV"),
        "n",
    )
    title = say("What q = 2 is worth: share of the spectra for which q at SLV stays below 2")
    two, one = shares["two_sided"], shares["one_sided"]
    sentences = []
    if two[1].size and one[1].size:
        slender = (two[0].alpha <= 7.0) & (two[0].height <= 7.0)
        tall = two[0].height >= 12.0
        sentences = [
            say(
                "A wall free to rock to both sides has q at SLV below 2 in {share:.0%} of the cases.",
                share=two[1].mean(),
            ),
            say(
                "A wall restrained from behind has it below 2 in {share:.0%}; its median is {median:.1f}.",
                share=one[1].mean(),
                median=float(np.median(one[0].q)),
            ),
        ]
        if slender.any() and tall.any():
            sentences.append(
                say(
                    "Of walls up to 7 m and 7 degrees that rock to both sides q = 2 is too much in {short:.0%}, of "
                    "those of 12 m and more in {tall:.0%}.",
                    short=two[1][slender].mean(),
                    tall=two[1][tall].mean(),
                )
            )
        sentences.append(say("These shares are of the walls and spectra of this study, not of buildings."))
    figure = Figure("q_code", title, "H [m]", "%", tuple(series), log_x=True)
    return figure, Table("q_code", title, head, tuple(rows)), sentences


SHOWN_SLENDERNESS = (4.0, 7.0, 10.0)
"""Slenderness that the tables of design values and of restitution show [deg]."""

E_FACTORS = (0.95, 1.05)
"""Factors of the velocity ratio of Eq. 4 or 6: tests of blocks lose more energy than it says, and some lose less."""


def _default_ratio(alpha: float, mechanism: str) -> float:
    """Velocity ratio of Eq. 4 or 6. alpha : [deg]"""
    block = Block.rectangle(3.0, math.radians(alpha))
    return loss_ratio(block, restitution(block, THEORETICAL[mechanism]))


def _design_table(values: list[MotionValue], fits: dict, say: Say) -> tuple[Table, list[str]]:
    """Up to which Lambda q = 2 is worth it, a share of natural records having q at SLV below it; sentences."""
    rows, sentences = [], []
    for mechanism in MECHANISM:
        fit = fits.get((mechanism, "rigid", "q_slv"))
        runs = columns(values, mechanism, "rigid", "q_slv", True)
        if fit is None or fit.law.record is None:
            continue
        for alpha in SHOWN_SLENDERNESS:
            ratio = _default_ratio(alpha, mechanism)
            ends = [_largest_scaled(fit.law, ratio, end) for end in (0, 1, None)]
            rows.append((say(MECHANISM[mechanism]), alpha, ratio, *ends))
        below = runs[runs.default].q < CODE_Q
        sentences.append(
            say(
                "Natural records: q at SLV is below 2 in {share:.0%} of the pairs of wall and motion, {mechanism}.",
                share=below.mean(),
                mechanism=say(MECHANISM[mechanism]),
            )
        )
    head = (
        say("mechanism"),
        "α [°]",
        "e",
        say("Λ at which 5 % of records are below 2"),
        say("Λ at which 16 % are"),
        say("Λ at which the mean of a set is"),
    )
    note = say("q = 2 is worth it up to these Λ: the design values of q at SLV, 5 and 16 %, are 2 there. – : nowhere.")
    return Table(
        "design", say("Where q = 2 is worth it: design values of q at SLV"), head, tuple(rows), note
    ), sentences


def _largest_scaled(law: ScaleFreeLaw, ratio: float, end: int | None) -> float | str | None:
    """Largest Lambda within the range of the fit at which a design value (0 or 1), or the law, is CODE_Q: "> end" where
    it is more there, None where it is less from its least Lambda on."""
    scaled = np.geomspace(law.scaled_range[0], law.scaled_range[1], 2000)
    if end is None:
        above = law.q(scaled, ratio) >= CODE_Q
    else:
        above = np.array([(law.record_values(one, ratio) or (0.0, 0.0))[end] >= CODE_Q for one in scaled])
    if above.all():
        return f"> {scaled[-1]:.3g}"
    lost = int(np.argmin(above))  # from here on it is not worth it, though it may be once more
    return float(scaled[lost - 1]) if lost else None


def _restitution_table(fits: dict, say: Say) -> Table:
    """What another velocity ratio than that of Eq. 4 or 6 does to q, by the law."""
    rows = []
    for (mechanism, law, quantity), fit in fits.items():
        if law != "rigid" or quantity not in ("q", "q_slv"):
            continue
        scaled = np.geomspace(fit.law.scaled_range[0], fit.law.scaled_range[1], 200)
        for alpha in SHOWN_SLENDERNESS:
            ratio = _default_ratio(alpha, mechanism)
            for factor in E_FACTORS:
                other = min(factor * ratio, 1.0 - fit.law.loss_range[0] ** 2)
                changed = fit.law.q(scaled, other) / fit.law.q(scaled, ratio)
                shares = float(np.median(changed)), float(changed.min()), float(changed.max())
                rows.append((say(MECHANISM[mechanism]), words(say)[quantity], alpha, ratio, other, *shares))
    head = (
        say("mechanism"), say("quantity"), "α [°]", "e", say("another e"),
        say("q over q of e, median"), say("least"), say("largest"),
    )  # fmt: skip
    note = say(
        "By the law, over its range of Λ; another e is 5 % less and 5 % more than that of Eq. 4 or 6, at most the "
        "largest of the fit."
    )
    return Table("restitution", say("What another velocity ratio does to q"), head, tuple(rows), note)


def _law_figures(values: list[MotionValue], fits: dict, say: Say) -> list[Figure]:
    """q and q_slv against Lambda for both mechanisms, sets of every restitution coloured by their velocity ratio."""
    figures = []
    for mechanism, quantity in product(MECHANISM, ("q", "q_slv")):
        fit = fits.get((mechanism, "rigid", quantity))
        if fit is None:
            continue
        sets = set_columns(columns(values, mechanism, "rigid", quantity, False))
        natural = columns(values, mechanism, "rigid", quantity, True)
        natural = natural[natural.default] if natural.q.size else natural
        edges = np.quantile(sets.loss, (0.0, 0.25, 0.5, 0.75, 1.0))
        series: list[Series] = []
        if natural.q.size:
            series.append(scatter(say("natural records"), list(zip(natural.scaled, natural.q, strict=True)), 7))
        x = np.geomspace(fit.law.scaled_range[0], fit.law.scaled_range[1], 30)
        for k in range(4):
            own = (sets.loss >= edges[k]) & ((sets.loss < edges[k + 1]) | (k == 3))
            if not own.any():
                continue
            ratio = 1.0 - float(np.median(sets.loss[own])) ** 2
            series.append(scatter(f"e ≈ {ratio:.2f}", list(zip(sets.scaled[own], sets.q[own], strict=True)), k))
            series.append(curve("", list(zip(x, fit.law.q(x, ratio), strict=True)), LINE, k))
        named = words(say)[quantity]
        title = say("{quantity} against Λ, {mechanism}", quantity=named, mechanism=say(MECHANISM[mechanism]))
        note = (
            say("One-sided, a motion has the lower of the numbers of both its signs.")
            if kinematics(mechanism).one_way
            else ""
        )
        figures.append(
            Figure(f"law_{mechanism}_{quantity}", title, "Λ [-]", f"{named} [-]", tuple(series), True, True, note)
        )
    return figures


def report(result: ParametricResult, values: list[MotionValue], notes: list[str], say: Say) -> StudyReport:
    """Everything the study of the law shows; `fits` of the report hold what the program takes over."""
    fits = fits_of(values)
    if not fits:
        notes = [*notes, say("No fit: it takes four shapes and the restitution that follows the mechanism.")]
    figure, table, sentences = _code_figure(values, say)
    stored = {
        " ".join(key): {
            "coefficients": fit.law.coefficients,
            "limit": fit.law.limit,
            "scatter_set": fit.outside.scatter,
            "scatter_record": fit.records.scatter,
            "scaled_range": fit.law.scaled_range,
            "loss_range": fit.law.loss_range,
            "sets": asdict(fit.law.sets),
            "record": fit.law.record and asdict(fit.law.record),
            "record_loss": fit.law.record_loss,
            "record_held": fit.covered,
            "set_held": fit.held,
            "set_of_records": fit.of_records,
        }
        for key, fit in fits.items()
    }
    design, more = _design_table(values, fits, say)
    made = (_law_table(fits, say), _rival_table(values, fits, say), table, design, _restitution_table(fits, say))
    tables = [entry for entry in made if entry.rows]
    return StudyReport(
        result.study.title,
        (*notes, *sentences, *more),
        (*_law_figures(values, fits, say), *([figure] if figure.series else [])),
        tuple(tables),
        fits=stored,
    )
