"""The claims of Coccia et al. (2016), as counts of what a finished study finds."""

import itertools
import math
from collections.abc import Callable, Iterable

import numpy as np

from core.capacity.closed_forms import closed_form_q_eff
from core.capacity.regression import BAND
from core.lab.research.figures import Claim
from core.lab.research.paper_sets import (
    EXPERIMENTAL,
    MECHANISM,
    THEORETICAL,
    closed_form_of,
    law_pairs,
    natural_values,
    restitution_pairs,
    theoretical,
    words,
)
from core.lab.research.paper_tables import exponent_error, points_of, power_laws, residual
from core.lab.research.set_means import MotionValue, SetMean, chosen, exact
from core.wall.kinematics import kinematics

Say = Callable[..., str]

C2_RANGE = {"two_sided": (-1.07, -0.919), "one_sided": (-0.95, -0.862)}
"""Ranges of the free exponent the paper states, section 5."""


def _growth(sets: list[SetMean], key: str, other: str) -> tuple[int, int]:
    """Count the neighbouring pairs in which q grows with the cell's `key`, `other` and the spectrum equal, and all such
    pairs."""
    lines: dict[tuple, list[SetMean]] = {}
    for entry in sets:
        lines.setdefault((entry.spectrum.name, getattr(entry.cell, other), entry.cell.restitution), []).append(entry)
    held = tried = 0
    for members in lines.values():
        members.sort(key=lambda entry: getattr(entry.cell, key))
        for low, high in itertools.pairwise(members):
            tried += 1
            held += high.q > low.q
    return held, tried


def _count(flags: Iterable[bool]) -> tuple[int, int]:
    flags = list(flags)
    return sum(flags), len(flags)


def claims(sets: list[SetMean], values: list[MotionValue], say: Say) -> list[Claim]:
    """Every claim of the paper the study can count."""
    made: list[Claim] = []
    for mechanism in THEORETICAL:
        name = say(MECHANISM[mechanism])
        made += _of_the_size(sets, mechanism, name, say)
        made += _of_restitution(sets, values, mechanism, name, say)
        made += _of_intensity(sets, mechanism, name, say)
        made += _of_the_laws(sets, mechanism, name, say)
        made += _of_the_equations(sets, values, mechanism, say)
    return [claim for claim in made if claim.tried]


def _of_the_size(sets: list[SetMean], mechanism: str, name: str, say: Say) -> list[Claim]:
    """q over height and slenderness of rigid walls."""
    figures = "Fig. 13, 14" if kinematics(mechanism).one_way else "Fig. 6, 7, 9"
    rigid = [
        entry
        for model in (THEORETICAL[mechanism], EXPERIMENTAL[mechanism])
        for entry in chosen(exact(sets), mechanism=mechanism, restitution=model, law="rigid")
    ]
    return [
        Claim(figures, say("q grows with H, {name}", name=name), *_growth(rigid, "height_m", "slenderness_deg")),
        Claim(figures, say("q grows with alpha, {name}", name=name), *_growth(rigid, "slenderness_deg", "height_m")),
    ]


def _of_restitution(sets: list[SetMean], values: list[MotionValue], mechanism: str, name: str, say: Say) -> list[Claim]:
    """Whether the theoretical restitution is on the safe side of that fitted to tests, in sets and motion by motion."""
    figure = "Fig. 15" if kinematics(mechanism).one_way else "Fig. 8"
    models = {"theory": words(say)[THEORETICAL[mechanism]], "tests": words(say)[EXPERIMENTAL[mechanism]]}
    ratios = [other.q / one.q for one, other in restitution_pairs(sets, mechanism)]
    return [
        Claim(
            figure,
            say("q by {theory} is not above q by {tests}, {name}, sets", name=name, **models),
            *_count(ratio >= 1.0 for ratio in ratios),
            say(
                "q by {tests} over q by {theory}: {low:.2f} to {high:.2f}",
                **models,
                low=min(ratios, default=1),
                high=max(ratios, default=1),
            ),
        ),
        Claim(
            figure,
            say("q by {theory} is not above q by {tests}, {name}, single motions", name=name, **models),
            *_count(other >= one for one, other in _records_of(values, mechanism)),
        ),
    ]


def _of_intensity(sets: list[SetMean], mechanism: str, name: str, say: Say) -> list[Claim]:
    """PGA alone does not decide, SI by a power law does."""
    spread = _group_spread(theoretical(sets, mechanism))
    laws = power_laws(sets, mechanism)
    exponents, squares = [law.c2 for _, _, law in laws], [law.r_squared for _, _, law in laws]
    errors = [exponent_error(*points_of(sets, mechanism, alpha, height)) for alpha, height, _ in laws]
    furthest = [residual(*points_of(sets, mechanism, alpha, height), law) for alpha, height, law in laws]
    low, high = C2_RANGE[mechanism]
    return [
        Claim(
            "4.1",
            say("PGA alone does not decide (ours: q differs by more than 10 % inside a group), {name}", name=name),
            *_count(ratio > 1.1 for ratio in spread),
            say("largest over smallest q of a group: up to {most:.1f}", most=max(spread, default=1)),
        ),
        Claim(
            "5",
            say("C2 in [{low:g}, {high:g}], {name}", low=low, high=high, name=name),
            *_count(low <= c2 <= high for c2 in exponents),
            say(
                "C2 {low:.2f} to {high:.2f}; q_eff holds 1/PGA",
                low=min(exponents, default=0),
                high=max(exponents, default=0),
            ),
        ),
        Claim(
            "5",
            say("the interval of C2 meets [{low:g}, {high:g}], {name}", low=low, high=high, name=name),
            *_count(c2 - error <= high and c2 + error >= low for c2, error in zip(exponents, errors, strict=True)),
            say(
                "intervals of 90 %: C2 ± {low:.2f} to {high:.2f}",
                low=min(errors, default=0),
                high=max(errors, default=0),
            ),
        ),
        Claim(
            "4.1, 4.2",
            say("a clear power law (ours: R² of at least 0.9), {name}", name=name),
            *_count(square >= 0.9 for square in squares),
            say(
                "R² {low:.2f} to {high:.2f}; a set is up to {most:.0%} from its power law",
                low=min(squares, default=0),
                high=max(squares, default=0),
                most=max(furthest, default=0),
            ),
        ),
    ]


def _of_the_laws(sets: list[SetMean], mechanism: str, name: str, say: Say) -> list[Claim]:
    """Whether a trilinear law gives less than the rigid one."""
    return [
        Claim(
            "Fig. 19",
            say("the {law} is more conservative, {name}", law=words(say)[law], name=name),
            *_count(other.q <= one.q for one, other in law_pairs(sets, mechanism, law)),
        )
        for law in ("doherty", "al_shawa")
    ]


def _of_the_equations(sets: list[SetMean], values: list[MotionValue], mechanism: str, say: Say) -> list[Claim]:
    """Sets and natural records beside Eq. 15 or 16."""
    one_sided = kinematics(mechanism).one_way
    ours = theoretical(sets, mechanism)
    forms = [closed_form_of(e) for e in ours]
    ratios, of_event = [], dict[str, list[float]]()
    for v in natural_values(values, mechanism):
        block, intensity = v.cell.wall.block(), v.entry.motion.housner_intensity
        ratios.append(v.q_eff / closed_form_q_eff(block.slenderness, block.height, intensity, one_sided))
        of_event.setdefault(v.entry.event, []).append(math.log(ratios[-1]))
    means = [math.exp(float(np.mean(logs))) for logs in of_event.values()]
    return [
        Claim(
            "Fig. 20",
            say("q of the sets within 20 % of Eq. {number} (ours)", number=15 + one_sided),
            *_count(abs(e.q / form - 1.0) <= BAND for form, e in zip(forms, ours, strict=True)),
            say("the paper claims 20 % for Fig. 21 only"),
        ),
        Claim(
            "Fig. 22" if one_sided else "Fig. 21",
            say("natural records within 20 % of Eq. {number}", number=15 + one_sided),
            *_count(abs(ratio - 1.0) <= BAND for ratio in ratios),
            say(
                "q_eff over the equation: {low:.2f} to {high:.2f}, median {middle:.2f}",
                low=min(ratios, default=1),
                high=max(ratios, default=1),
                middle=float(np.median(ratios)) if ratios else 1.0,
            ),
        ),
        Claim(
            "Fig. 22" if one_sided else "Fig. 21",
            say("earthquakes whose records are within 20 % of Eq. {number} in the mean", number=15 + one_sided),
            *_count(abs(mean - 1.0) <= BAND for mean in means),
            say("median of the earthquakes {middle:.2f}", middle=float(np.median(means)) if means else 1.0),
        ),
    ]


def _records_of(values: list[MotionValue], mechanism: str) -> list[tuple[float, float]]:
    """q of both restitution models, motion by motion."""
    rigid = chosen(exact(values), mechanism=mechanism, law="rigid")
    first = chosen(rigid, restitution=THEORETICAL[mechanism])
    second = chosen(rigid, restitution=EXPERIMENTAL[mechanism])

    def key(value: MotionValue):
        return value.cell.slenderness_deg, value.cell.height_m, value.entry.motion.name

    others = {key(value): value.q for value in second}
    return [
        (value.q, other) for value in first if value.q is not None and (other := others.get(key(value))) is not None
    ]


def _group_spread(sets: list[SetMean]) -> list[float]:
    """Largest over smallest q of the spectra of a group, wall by wall."""
    groups: dict[tuple, list[float]] = {}
    for entry in sets:
        groups.setdefault((entry.cell, entry.spectrum.group), []).append(entry.q)
    return [max(members) / min(members) for members in groups.values() if len(members) > 1]
