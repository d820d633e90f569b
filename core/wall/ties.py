"""The ties of a wall: the bars of each, what they hold and what they stand.

Steel by NTC 2018: N_pl,Rd = A f_yk / gamma_M0 [4.2.6] of the bar, F_t,Rd = 0.9 f_tbk A_res / gamma_M2 [4.2.68] of its
thread, as of a bolt. "Qualora il progetto preveda la gerarchia delle resistenze, come avviene in presenza di azioni
sismiche, la resistenza di progetto plastica della sezione lorda, N_pl,Rd, deve risultare minore della resistenza di
progetto a rottura delle sezioni indebolite" [4.2.8]: only then is an elongation beyond yield counted on. For the
bearing and the punching of the masonry under a plate no clause with a formula was found in the NTC 2018 or the
Circolare 7/2019 (C8.7.4.1 has none): the engineer gives the resistance of the anchorage.
"""

import math
from dataclasses import dataclass

from core.wall.bars import Bar, TieBar
from core.wall.block import Block
from core.wall.wall_body import weight_per_metre

MODULUS = 205e9
"""Of steel bars [Pa]."""

DEFAULT_STRENGTH, DEFAULT_TENSILE = 235.0, 360.0
"""f_y and f_u of a bar of which none is given [MPa]."""

GAMMA_M0, GAMMA_M2 = 1.05, 1.25
"""Partial factors of the gross section (Tab. 4.2.VII) and of a thread (Tab. 4.2.XIV)."""

PITCHES = (
    *((6, 1.0), (8, 1.25), (10, 1.5), (12, 1.75), (14, 2.0), (18, 2.5), (24, 3.0), (30, 3.5)),
    *((36, 4.0), (42, 4.5), (48, 5.0), (56, 5.5), (64, 6.0)),
)
"""Diameter from which on a coarse metric thread has a pitch, and that pitch [mm] (ISO 261)."""

DIAMETERS = (12, 14, 16, 18, 20, 22, 24, 27, 30, 33, 36, 40)
"""Bars that are offered for a force [mm]."""


@dataclass(frozen=True)
class Tie:
    """A tie of a wall.

    bar : for a metre of wall
    per_bar : force a bar holds [N], None of a tie whose bars are not given
    parts : resistance of each part of a bar [N]: steel, thread, anchorage
    stands_more : whether it stands an elongation beyond yield
    """

    bar: TieBar
    per_bar: float | None = None
    parts: tuple[tuple[str, float], ...] = ()
    stands_more: bool = False

    @property
    def weakest(self) -> str:
        """Name of the part that governs, "" where the bars are not given."""
        return min(self.parts, key=lambda part: part[1])[0] if self.parts else ""


def stress_area(diameter: float) -> float:
    """A_res of a coarse metric thread [mm2], as Tab. 4.2.XVI: pi/4 (d - 0.9382 P)^2. diameter : [mm]"""
    pitch = next((pitch for least, pitch in reversed(PITCHES) if diameter >= least), 0.2 * diameter)
    return 0.25 * math.pi * (diameter - 0.9382 * pitch) ** 2


def parts_of(bars) -> tuple[tuple[str, float], ...]:
    """Resistance of each part of a bar [N]. bars : Bars of a case"""
    area = 0.25 * math.pi * bars.diameter_mm**2
    threaded = stress_area(bars.thread_mm or bars.diameter_mm)
    steel = area * bars.strength / (1.0 if bars.existing else GAMMA_M0)
    parts = [("steel", steel), ("thread", 0.9 * threaded * bars.tensile / GAMMA_M2)]
    if bars.anchorage_kn is not None:
        parts.append(("anchorage", 1e3 * bars.anchorage_kn))
    return tuple(parts)


def is_ductile(bars) -> bool:
    """Whether the steel yields before anything else goes: thread [4.2.8], and an anchorage that stands the bar at its
    tensile strength."""
    (_, steel), (_, thread), *anchorage = parts_of(bars)
    area = 0.25 * math.pi * bars.diameter_mm**2
    return steel <= thread and any(held >= area * bars.tensile for _, held in anchorage)


def elongation_at_yield(length: float, strength: float = DEFAULT_STRENGTH) -> float:
    """u_y = f_y L / E [m]. length : [m]; strength : f_y [MPa]"""
    return 1e6 * strength * length / MODULUS


def stated_elongation(load) -> float | None:
    """What the bar of a tie stands before it breaks, as stated [m]; None where nothing is."""
    if load.elongation_m is not None or load.elongation is None:
        return load.elongation_m
    return load.elongation * load.bar_length_m


def tie_of(load, wall) -> Tie:
    """The tie of a load of a wall. Both are of a case that has been checked."""
    length, slack = load.bar_length_m, 1e-3 * (load.slack_mm or 0.0)
    bars = load.bar
    if bars is None:
        strength = 1e3 * load.kn_m
        at_yield = elongation_at_yield(length, load.fy_mpa or DEFAULT_STRENGTH)
        per_bar, parts, more = None, (), True
    else:
        parts, more = parts_of(bars), is_ductile(bars)
        per_bar = min(held for _, held in parts)
        strength = bars.number * per_bar / wall.length_m
        at_yield = per_bar * length / (MODULUS * 0.25e-6 * math.pi * bars.diameter_mm**2)
    stands = stated_elongation(load) or 0.0
    more = more and stands > at_yield
    slack -= (load.prestress or 0.0) * at_yield
    bar = TieBar(load.h_m, strength, at_yield, slack, stands if more else at_yield)
    return Tie(bar, per_bar, parts, more)


def ties_of(wall) -> tuple[Tie, ...]:
    """The ties of a wall, in the order of its loads."""
    return tuple(tie_of(load, wall) for load in wall.load if load.is_tie)


def counted(wall) -> tuple[TieBar, ...]:
    """The bars that a check of the clauses counts: none with slack, which does nothing before the wall has moved."""
    return tuple(tie_of(load, wall).bar for load in wall.load if load.is_tie and not load.slack_mm)


def moment_of_weight(wall, block: Block) -> float:
    """m g R of what moves [N m/m]. block : the wall and what moves with it"""
    return (weight_per_metre(wall) + sum(1e3 * load.kn_m for load in wall.load if load.pushes)) * block.radius


def scaled(wall, block: Block) -> tuple[Bar, ...]:
    """The bars of a wall as the kernels take them. block : as `moment_of_weight`"""
    found = ties_of(wall)
    return tuple(tie.bar.scaled(moment_of_weight(wall, block)) for tie in found) if found else ()


def bars_for(force: float, spacing: float) -> tuple[int | None, int | None]:
    """(smallest of DIAMETERS of S 235 bars that hold a force by their steel, smallest thread that is stronger, [4.2.8])
    [mm]; None where none does.

    force : [N/m]; spacing : of the bars along the wall [m]
    """
    threads = {d: 0.9 * stress_area(d) * DEFAULT_TENSILE / GAMMA_M2 for d in (*DIAMETERS, 42, 45, 48)}
    for diameter in DIAMETERS:
        steel = 0.25 * math.pi * diameter**2 * DEFAULT_STRENGTH / GAMMA_M0
        if steel >= force * spacing:
            return diameter, next(thread for thread, held in threads.items() if held >= steel)
    return None, None
