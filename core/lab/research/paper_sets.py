"""The sets of a study that the figures, tables and claims of the paper speak of."""

from collections.abc import Callable

from core.capacity.closed_forms import closed_form_q
from core.capacity.regression import power_coefficient
from core.lab.research.set_means import MotionValue, SetMean, chosen, exact
from core.units import CM

MECHANISM = {"two_sided": "two-sided", "one_sided": "one-sided"}
THEORETICAL = {"two_sided": "housner", "one_sided": "one_sided_theoretical"}
EXPERIMENTAL = {"two_sided": "sorrentino_experimental", "one_sided": "one_sided_experimental"}


def words(say: Callable[..., str]) -> dict[str, str]:
    """Name in a study -> its words in the language of the report."""
    return {
        "rigid": say("rigid law"),
        "doherty": say("trilinear law of Doherty"),
        "al_shawa": say("trilinear law of Al Shawa"),
        "housner": "Eq. 4",
        "sorrentino_experimental": "Eq. 5",
        "one_sided_theoretical": "Eq. 6",
        "one_sided_experimental": "Eq. 7",
        "newmark_paper": say("Newmark of the paper"),
        "newmark_paper_reset": say("Newmark of the paper, rotation set to 0 at an impact"),
        "q": "q",
        "q_slv": say("q at SLV"),
        "q_slc": say("q at SLC"),
        "q_robust": say("q robust"),
    }


PAPER_INTENSITIES = (9.04, 137.5)
"""Range of SI of the paper's natural records, Table 2 [cm]."""

INTERMEDIATE: dict = {"slenderness_deg": 6.8, "height_m": 7.0}
"""The wall of figures 19, 21 and 22."""


def theoretical(sets: list, mechanism: str) -> list:
    """The paper's grid: Eq. 4 or Eq. 6, rigid law, exact method."""
    return chosen(exact(sets), mechanism=mechanism, restitution=THEORETICAL[mechanism], law="rigid")


def pairs(sets: list, first: dict, second: dict, same: tuple[str, ...]) -> list[tuple]:
    """(entry, entry) of equal spectrum, alpha, H and `same`, the cells of which have these values."""

    def key(entry):
        return (entry.spectrum.name, *(getattr(entry.cell, name) for name in ("slenderness_deg", "height_m", *same)))

    others = {key(entry): entry for entry in chosen(sets, **second)}
    return [(one, others[key(one)]) for one in chosen(sets, **first) if key(one) in others]


def restitution_pairs(sets: list[SetMean], mechanism: str) -> list[tuple[SetMean, SetMean]]:
    """Theoretical and experimental restitution of the same wall and spectrum."""
    first = {"mechanism": mechanism, "restitution": THEORETICAL[mechanism], "law": "rigid"}
    return pairs(exact(sets), first, {**first, "restitution": EXPERIMENTAL[mechanism]}, ())


def law_pairs(sets: list[SetMean], mechanism: str, law: str) -> list[tuple[SetMean, SetMean]]:
    """Rigid and trilinear law of the intermediate wall."""
    rigid = theoretical(sets, mechanism)
    other = chosen(exact(sets), mechanism=mechanism, law=law, **INTERMEDIATE)
    by_spectrum = {entry.spectrum.name: entry for entry in other}
    return [
        (one, by_spectrum[one.spectrum.name])
        for one in chosen(rigid, **INTERMEDIATE)
        if one.spectrum.name in by_spectrum
    ]


def c1_points(sets: list[SetMean], mechanism: str, c2: float) -> list[tuple[float, float, float]]:
    """(alpha [deg], H [m], C1) of Eq. 13 with this C2, SI in cm, of every wall of the grid."""
    ours = theoretical(sets, mechanism)
    points = []
    for alpha, height in sorted({(e.cell.slenderness_deg, e.cell.height_m) for e in ours}):
        members = chosen(ours, slenderness_deg=alpha, height_m=height)
        fit = power_coefficient([e.intensity / CM for e in members], [e.q_eff for e in members], c2)
        points.append((alpha, height, fit.coefficients[0]))
    return points


def closed_form_of(entry: SetMean) -> float:
    """q of Eq. 15 or 16 for the set."""
    block = entry.cell.wall.block()
    one_sided = entry.cell.kinematics.one_way
    return closed_form_q(block.slenderness, block.height, entry.intensity, entry.pga, one_sided)


def natural_values(values: list[MotionValue], mechanism: str) -> list[MotionValue]:
    """Natural records of the intermediate wall that have a q."""
    ours = chosen(theoretical(values, mechanism), **INTERMEDIATE)
    return [value for value in ours if value.entry.seed is None and value.q is not None]
