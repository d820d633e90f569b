"""The ties of a wall: the bars of each, what they hold and what they stand.

Steel by NTC 2018: N_pl,Rd = A f_yk / gamma_M0 [4.2.6] of the bar, F_t,Rd = 0.9 f_tbk A_res / gamma_M2 [4.2.68] of its
thread, as of a bolt. "Qualora il progetto preveda la gerarchia delle resistenze, come avviene in presenza di azioni
sismiche, la resistenza di progetto plastica della sezione lorda, N_pl,Rd, deve risultare minore della resistenza di
progetto a rottura delle sezioni indebolite" [4.2.8]: only then is an elongation beyond yield counted on. For the
bearing and the punching of the masonry under a plate no clause with a formula was found in the NTC 2018 or the
Circolare 7/2019 (C8.7.4.1 has none): the engineer gives the resistance of the anchorage.
"""

import math
from dataclasses import dataclass, replace

from core.wall.bars import TieBar

STEEL_MODULUS = 205e9
"""Modulus of steel bars [Pa]."""

DEFAULT_STRENGTH, DEFAULT_TENSILE = 235e6, 360e6
"""f_y and f_u of a bar of which none is given [Pa]."""

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
    def is_slack(self) -> bool:
        """Whether it does nothing before the wall has moved."""
        return self.bar.slack > 0.0

    @property
    def weakest(self) -> str:
        """Name of the part that governs, "" where the bars are not given."""
        return min(self.parts, key=lambda part: part[1])[0] if self.parts else ""


@dataclass(frozen=True)
class Steel:
    """The bars of a tie, over the length of the wall.

    diameter, thread : of a bar and of the thread at its ends [m]
    strength, tensile : f_y and f_u [Pa]; existing : these are mean values of an existing building, without gamma
    anchorage : least resistance of the anchorage of a bar [N]; None : not known, the elongation is not counted on
    """

    number: int
    diameter: float
    strength: float = DEFAULT_STRENGTH
    tensile: float = DEFAULT_TENSILE
    thread: float | None = None
    existing: bool = False
    anchorage: float | None = None

    @property
    def area(self) -> float:
        """[m2]."""
        return 0.25 * math.pi * self.diameter**2

    @property
    def parts(self) -> tuple[tuple[str, float], ...]:
        """Resistance of each part of a bar [N]."""
        steel = self.area * self.strength / (1.0 if self.existing else GAMMA_M0)
        threaded = stress_area(self.thread or self.diameter)
        parts = [("steel", steel), ("thread", 0.9 * threaded * self.tensile / GAMMA_M2)]
        return (*parts, *([] if self.anchorage is None else [("anchorage", self.anchorage)]))

    @property
    def is_ductile(self) -> bool:
        """Whether the steel yields before anything else goes: thread [4.2.8], and an anchorage that stands the bar at
        its tensile strength."""
        (_, steel), (_, thread), *anchorage = self.parts
        return steel <= thread and any(held >= self.area * self.tensile for _, held in anchorage)


def stress_area(diameter: float) -> float:
    """A_res of a coarse metric thread [m2], as Tab. 4.2.XVI: pi/4 (d - 0.9382 P)^2. diameter : [m]"""
    millimetres = 1e3 * diameter
    pitch = next((pitch for least, pitch in reversed(PITCHES) if millimetres >= least), 0.2 * millimetres)
    return 0.25e-6 * math.pi * (millimetres - 0.9382 * pitch) ** 2


def elongation_at_yield(length: float, strength: float = DEFAULT_STRENGTH) -> float:
    """u_y = f_y L / E [m]. length : [m]; strength : f_y [Pa]"""
    return strength * length / STEEL_MODULUS


def tie_of_force(
    height: float, force: float, at_yield: float, stands: float, slack: float = 0.0, prestress: float = 0.0
) -> Tie:
    """A tie of which the force at yield is known, and not its bars.

    height : above the hinge [m]; force : [N/m]; at_yield : its elongation there [m]
    stands : elongation beyond which it is gone [m], at yield where it is less; slack : [m]; prestress : share of force
    """
    more = stands > at_yield
    return Tie(
        TieBar(height, force, at_yield, slack - prestress * at_yield, stands if more else at_yield), None, (), more
    )


def tie_of_bars(
    height: float, bars: Steel, bar_length: float, wall_length: float, stands: float, slack: float, prestress: float
) -> Tie:
    """A tie whose bars are given.

    height : above the hinge [m]
    bars : its Steel, over the length of the wall
    bar_length, wall_length : [m]
    stands : elongation beyond which a bar is gone [m], at yield where it is less, or its steel does not yield first
    slack : [m]
    prestress : share of the force at yield
    """
    per_bar = min(held for _, held in bars.parts)
    at_yield = per_bar * bar_length / (STEEL_MODULUS * bars.area)
    force = bars.number * per_bar / wall_length
    tie = tie_of_force(height, force, at_yield, stands if bars.is_ductile else 0.0, slack, prestress)
    return replace(tie, per_bar=per_bar, parts=bars.parts)


def bars_for(force: float, spacing: float) -> tuple[int | None, int | None]:
    """(smallest of DIAMETERS of S 235 bars that hold a force by their steel, smallest thread that is stronger, [4.2.8])
    [mm]; None where none does.

    force : [N/m]; spacing : of the bars along the wall [m]
    """
    threads = {d: 0.9 * stress_area(1e-3 * d) * DEFAULT_TENSILE / GAMMA_M2 for d in (*DIAMETERS, 42, 45, 48)}
    for diameter in DIAMETERS:
        steel = 0.25e-6 * math.pi * diameter**2 * DEFAULT_STRENGTH / GAMMA_M0
        if steel >= force * spacing:
            return diameter, next(thread for thread, held in threads.items() if held >= steel)
    return None, None
