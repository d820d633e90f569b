"""The figures of Coccia et al. (2016), sections 3 to 5, from a finished study."""

import math
import re
from collections.abc import Callable

import numpy as np

from core.capacity.closed_forms import COEFFICIENTS, closed_form_q_eff, fit_power_law
from core.capacity.regression import BAND, agreement
from core.ground.response_spectrum import pseudo_acceleration_spectrum
from core.lab.research.figures import DASHED, LINE, LINE_POINTS, POINTS, Figure, Series
from core.lab.research.paper_sets import (
    EXPERIMENTAL,
    MECHANISM,
    PAPER_INTENSITIES,
    THEORETICAL,
    c1_points,
    closed_form_of,
    law_pairs,
    natural_values,
    restitution_pairs,
    theoretical,
    words,
)
from core.lab.research.parametric import ParametricResult
from core.lab.research.set_means import MotionValue, SetMean, chosen, exact
from core.rocking.history import integrate_history
from core.units import CM, G
from core.wall.block import Block
from core.wall.kinematics import kinematics
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

Say = Callable[..., str]

FIGURE_NUMBERS = {
    "two_sided": ("06", "07", "08", "09", ("10", "11", "12"), "21"),
    "one_sided": ("13", "14", "15", "", ("16", "17", "18"), "22"),
}
"""Numbers of the paper's figures: q against H of both restitutions, scatter, all spectra, q_eff, natural records."""

PAPER_SLENDERNESS = (3.1, 6.8, 11.3)
"""Slenderness of the paper's walls [deg]; figures 10 to 12 and 16 to 18 in this order."""

SHOWN_GROUP = "B"
"""The group figures 6, 7, 13 and 14 show."""

TUFF_HEIGHT, TUFF_THICKNESS = 0.800, 0.123
"""The block of figure 4 [m], Sorrentino et al. (2011)."""

TUFF_START = 0.95
"""First rotation of figure 4 over alpha: assumed, the figure is lost."""

COMPARED_PERIODS = np.geomspace(0.05, 4.0, 40)


def curve(name: str, points, look: str = LINE, color: int = 0) -> Series:
    """A series through (x, y), in order of x."""
    x, y = zip(*sorted(points), strict=True) if points else ((), ())
    return Series(name, tuple(map(float, x)), tuple(map(float, y)), look, color)


def free_rocking(say: Say) -> Figure:
    """Fig. 4: decay of the tuff block, Eq. 4 and Eq. 5."""
    block = Block.rectangle(TUFF_HEIGHT, math.atan2(TUFF_THICKNESS, TUFF_HEIGHT))
    dt, still = 0.005, np.zeros(1601)
    series = []
    for color, model in enumerate(("housner", "sorrentino_experimental")):
        rocking = rocking_model(block, False, restitution(block, model), LAWS["rigid"])
        moved = integrate_history(still, dt, 1.0, rocking, start=(TUFF_START * block.slenderness, 0.0))
        ratio = moved.rotation / block.slenderness
        series.append(curve(f"Eq. {4 + color}", list(zip(dt * np.arange(ratio.size), ratio, strict=True)), LINE, color))
    title = say("Fig. 4: free rocking of the tuff block, 0.800 x 0.123 m")
    note = say("First rotation {share:g} alpha: assumed, the figure is lost.", share=TUFF_START)
    return Figure("fig04_decay", title, "t [s]", "θ/α [-]", tuple(series), note=note)


def spectra(result: ParametricResult, say: Say) -> list[Figure]:
    """Fig. 5, a chart for each group: target spectra and their motions."""
    figures = []
    for group in dict.fromkeys(spectrum.group for spectrum in result.spectra):
        series = []
        for color, spectrum in enumerate(entry for entry in result.spectra if entry.group == group):
            for k, entry in enumerate(entry for entry in result.motions if entry.spectrum == spectrum.name):
                motion = entry.motion
                values = (
                    pseudo_acceleration_spectrum(motion.acceleration, motion.time_step, COMPARED_PERIODS, per_period=0)
                    / G
                )
                name = say("{name}, motions", name=spectrum.name) if k == 0 else ""
                series.append(curve(name, list(zip(COMPARED_PERIODS, values, strict=True)), POINTS, color))
            target = spectrum.target.acceleration(COMPARED_PERIODS) / G
            series.append(curve(spectrum.name, list(zip(COMPARED_PERIODS, target, strict=True)), LINE, color))
        title = say("Fig. 5: target spectra and motions, group {group}", group=group)
        figures.append(Figure(f"fig05_{slug(group)}", title, "T [s]", "S_e [g]", tuple(series), log_x=True))
    return figures


def q_against_height(sets: list[SetMean], mechanism: str, say: Say) -> list[Figure]:
    """Fig. 6, 7, 13, 14: q against H of group B; Fig. 9: all spectra at 6.8 degrees."""
    figures = []
    theory, experiment, _, everything, _, _ = FIGURE_NUMBERS[mechanism]
    for number, models in ((theory, THEORETICAL), (experiment, EXPERIMENTAL)):
        ours = [
            entry
            for entry in chosen(exact(sets), mechanism=mechanism, restitution=models[mechanism], law="rigid")
            if entry.spectrum.group == SHOWN_GROUP
        ]
        series = []
        for color, alpha in enumerate(sorted({entry.cell.slenderness_deg for entry in ours})):
            for name in sorted({entry.spectrum.name for entry in ours}):
                points = [
                    (entry.cell.height_m, entry.q)
                    for entry in chosen(ours, slenderness_deg=alpha)
                    if entry.spectrum.name == name
                ]
                series.append(curve(f"{alpha:g}°, {name}", points, LINE_POINTS, color))
        restitution = words(say)[models[mechanism]]
        title = say("Fig. {number}: q against H, {restitution}, group B", number=int(number), restitution=restitution)
        figures.append(Figure(f"fig{number}_q_height", title, "H [m]", "q [-]", tuple(series)))
    if everything:
        ours = chosen(
            exact(sets), mechanism=mechanism, restitution=THEORETICAL[mechanism], law="rigid", slenderness_deg=6.8
        )
        series = [
            curve(
                name,
                [(e.cell.height_m, e.q) for e in ours if e.spectrum.name == name],
                LINE_POINTS,
                "ABC".find(name[0]),
            )
            for name in sorted({entry.spectrum.name for entry in ours})
        ]
        title = say("Fig. 9: q against H at 6.8 degrees, all spectra")
        figures.append(Figure("fig09_q_height", title, "H [m]", "q [-]", tuple(series)))
    return figures


def slug(name: str) -> str:
    """A name as part of the name of a file."""
    return re.sub(r"[^A-Za-z0-9]+", "_", name)


def scatter(name: str, points: list[tuple[float, float]], color: int = 0) -> Series:
    return Series(name, tuple(x for x, _ in points), tuple(y for _, y in points), POINTS, color)


def diagonal(points: list[tuple[float, float]]) -> Series:
    """The line of equality over the range of these points."""
    values = [value for point in points for value in point]
    ends = (min(values), max(values)) if values else ()
    return Series("1:1", ends, ends, DASHED, 7)


def restitution_scatter(sets: list[SetMean], mechanism: str, say: Say) -> Figure:
    """Fig. 8 and 15."""
    number = FIGURE_NUMBERS[mechanism][2]
    points = [(one.q, other.q) for one, other in restitution_pairs(sets, mechanism)]
    title = say("Fig. {number}: q of both restitution models", number=int(number))
    return Figure(
        f"fig{number}_restitution",
        title,
        f"q [-], {words(say)[THEORETICAL[mechanism]]}",
        f"q [-], {words(say)[EXPERIMENTAL[mechanism]]}",
        (scatter("", points), diagonal(points)),
    )


def q_eff_against_si(sets: list[SetMean], mechanism: str, say: Say) -> list[Figure]:
    """Fig. 10 to 12 and 16 to 18: q_eff against SI with the power law of each H."""
    figures = []
    ours = theoretical(sets, mechanism)
    numbers = dict(zip(PAPER_SLENDERNESS, FIGURE_NUMBERS[mechanism][4], strict=True))
    for alpha in sorted({entry.cell.slenderness_deg for entry in ours}):
        number = numbers.get(alpha)
        series = []
        of_alpha = chosen(ours, slenderness_deg=alpha)
        for color, height in enumerate(sorted({entry.cell.height_m for entry in of_alpha})):
            points = [(entry.intensity / CM, entry.q_eff) for entry in chosen(of_alpha, height_m=height)]
            law = fit_power_law([x * CM for x, _ in points], [y for _, y in points])
            name = f"H {height:g} m"
            if law:
                x = np.geomspace(*law.si_range_cm, 15)
                line = [(float(v), law.q_eff(v * CM)) for v in x]
                series.append(curve("", line, DASHED, color))
                name += f", C2 {law.c2:.2f}, R² {law.r_squared:.2f}"
            series.append(scatter(name, points, color))
        title = say(
            "q_eff against SI, {mechanism}, {alpha:g} degrees", mechanism=say(MECHANISM[mechanism]), alpha=alpha
        )
        key = f"fig{number}_q_eff_si" if number else f"q_eff_si_{mechanism}_{alpha:g}"
        label = f"Fig. {number}: {title}" if number else title
        figures.append(Figure(key, label, "SI [cm]", "q_eff [-]", tuple(series), True, True))
    return figures


def q_against_ratio(sets: list[SetMean], mechanism: str, say: Say) -> Figure:
    """q against SI/PGA, beside figures 10 to 18: q_eff is proportional to 1/PGA, so that part of its correlation
    with SI is built in; this one is not."""
    ours = chosen(theoretical(sets, mechanism), slenderness_deg=6.8)
    series = []
    for color, height in enumerate(sorted({entry.cell.height_m for entry in ours})):
        points = [(entry.intensity / CM / (entry.pga / G), entry.q) for entry in chosen(ours, height_m=height)]
        series.append(curve(f"H {height:g} m", points, LINE_POINTS, color))
    title = say("q against SI/PGA, {mechanism}, 6.8 degrees", mechanism=say(MECHANISM[mechanism]))
    return Figure(f"q_si_pga_{mechanism}", title, "SI/PGA [cm/g]", "q [-]", tuple(series), True, True)


def rigid_against_trilinear(sets: list[SetMean], mechanism: str, say: Say) -> Figure:
    """Fig. 19, of one mechanism: the paper does not say which it is."""
    series, everything = [], []
    for color, law in enumerate(("doherty", "al_shawa")):
        points = [(one.q, other.q) for one, other in law_pairs(sets, mechanism, law)]
        everything += points
        series.append(scatter(words(say)[law], points, color))
    title = say("Fig. 19: rigid and trilinear law, {mechanism}, 6.8 degrees, 7 m", mechanism=say(MECHANISM[mechanism]))
    named = say("q [-], rigid"), say("q [-], trilinear")
    return Figure(f"fig19_trilinear_{mechanism}", title, *named, (*series, diagonal(everything)))


def c1_against_height(sets: list[SetMean], mechanism: str, say: Say) -> Figure:
    """C1 against H and alpha, beside Eq. 14 with the paper's coefficients."""
    a1, a2, a3, c2 = COEFFICIENTS[kinematics(mechanism).one_way]
    points = c1_points(sets, mechanism, c2)
    series = []
    for color, alpha in enumerate(sorted({alpha for alpha, _, _ in points})):
        ours = [(height, c1) for a, height, c1 in points if a == alpha]
        series.append(curve(f"{alpha:g}°", ours, LINE_POINTS, color))
        paper = [(height, a1 * alpha + a2 * height + a3) for height, _ in ours]
        series.append(curve(say("{alpha:g}°, paper", alpha=alpha), paper, DASHED, color))
    title = say("Eq. 14: C1 against H, {mechanism}", mechanism=say(MECHANISM[mechanism]))
    return Figure(f"eq14_c1_{mechanism}", title, "H [m]", "C1", tuple(series))


def numerical_against_analytical(sets: list[SetMean], say: Say) -> Figure:
    """Fig. 20."""
    series, everything = [], []
    for color, mechanism in enumerate(THEORETICAL):
        points = [(closed_form_of(entry), entry.q) for entry in theoretical(sets, mechanism)]
        everything += points
        series.append(scatter(say(MECHANISM[mechanism]), points, color))
    title = say("Fig. 20: q of the time histories against Eq. 15 and 16")
    return Figure(
        "fig20_closed_form",
        title,
        say("q [-], Eq. 15 or 16"),
        say("q [-], time histories"),
        (*series, diagonal(everything)),
        True,
        True,
    )


def natural_records(values: list[MotionValue], mechanism: str, say: Say) -> Figure | None:
    """Fig. 21 and 22: q_eff of the natural records within the paper's range of SI with the band of Eq. 15 or 16; None
    without records."""
    every = natural_values(values, mechanism)
    low, high = PAPER_INTENSITIES
    ours = [value for value in every if low <= value.entry.motion.housner_intensity / CM <= high]
    if not ours:
        return None
    number = FIGURE_NUMBERS[mechanism][5]
    block, one_sided = ours[0].cell.wall.block(), kinematics(mechanism).one_way
    intensities = [value.entry.motion.housner_intensity for value in ours]
    points = [(si / CM, value.q_eff) for si, value in zip(intensities, ours, strict=True)]
    x = np.geomspace(min(intensities), max(intensities), 40)
    form = [closed_form_q_eff(block.slenderness, block.height, si, one_sided) for si in x]
    lines = [
        curve(name, [(si / CM, factor * y) for si, y in zip(x, form, strict=True)], look, 1)
        for factor, look, name in (
            (1.0, LINE, f"Eq. {15 + one_sided}"),
            (1 + BAND, DASHED, "±20 %"),
            (1 - BAND, DASHED, ""),
        )
    ]
    share = agreement(
        [closed_form_q_eff(block.slenderness, block.height, si, one_sided) for si in intensities],
        [value.q_eff for value in ours],
    ).within
    title = say(
        "Fig. {number}: q_eff of natural records, {mechanism}", number=int(number), mechanism=say(MECHANISM[mechanism])
    )
    note = say("{n} records, {share:.0%} of them within ±20 % of the equation.", n=len(ours), share=share)
    if beyond := len(every) - len(ours):
        note += " " + say(
            "{n} more have an SI beyond the paper's {low:g} to {high:g} cm.", n=beyond, low=low, high=high
        )
    return Figure(
        f"fig{number}_natural",
        title,
        "SI [cm]",
        "q_eff [-]",
        (scatter(say("records"), points), *lines),
        True,
        True,
        note,
    )


def figures(result: ParametricResult, values: list[MotionValue], sets: list[SetMean], say: Say) -> list[Figure]:
    """All of them, in the paper's order."""
    made: list[Figure | None] = [free_rocking(say), *spectra(result, say)]
    for mechanism in THEORETICAL:
        made += [
            *q_against_height(sets, mechanism, say),
            restitution_scatter(sets, mechanism, say),
            *q_eff_against_si(sets, mechanism, say),
            q_against_ratio(sets, mechanism, say),
            c1_against_height(sets, mechanism, say),
        ]
    made += [rigid_against_trilinear(sets, mechanism, say) for mechanism in THEORETICAL]
    made.append(numerical_against_analytical(sets, say))
    made += [natural_records(values, mechanism, say) for mechanism in THEORETICAL]
    return [figure for figure in made if figure is not None and any(series.x for series in figure.series)]
