"""Coccia, Di Carlo, Imperatore (2016): its equations by hand, and q of El Centro 1940 where its record is given."""

import math
from collections.abc import Sequence
from functools import cache, partial
from pathlib import Path

from core.capacity import closed_forms
from core.capacity.ida import Search, incremental_dynamic_analysis
from core.codes.eq9 import inequality
from core.errors import InputError
from core.ground import records
from core.ground.ground_motion import GroundMotion
from core.known import require_value
from core.lab.solved.motion import BLOCK
from core.lab.solved.solved import Answer, Kind, Sketch, Solved, printed, worded
from core.rocking.methods import METHODS
from core.units import G
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import restitution
from core.wall.rocking_model import rocking_model

SOURCE = "Coccia, Di Carlo, Imperatore (2016)"


@cache
def wall(height: float = 7.0, alpha_deg: float = 6.8) -> Block:
    return Block.rectangle(height, math.radians(alpha_deg))


def ratio(model: str) -> float:
    return restitution(wall(), model).ratio_at_rest


def q_eff(one_sided: bool, intensity: float) -> float:
    return closed_forms.closed_form_q_eff(wall().slenderness, wall().height, intensity, one_sided)


def example() -> Block:
    """7.0 x 0.83 m."""
    return Block.rectangle(7.0, math.atan2(0.83, 7.0))


def ratio_of_eq_9() -> float:
    return inequality("code", 2.0, example().threshold_acceleration, 0.26 * 1.2 * G).ratio


EQ_4 = 1.0 - 1.5 * math.sin(math.radians(6.8)) ** 2
EQ_6 = EQ_4**2 * abs(1.0 - 1.5 * math.cos(math.radians(6.8)) ** 2)
SPECTRUM_POINTS = (0.2, 0.5, 0.9, 1.4)


def power_law() -> closed_forms.PowerLaw:
    """Fit the law to points that lie on 321 SI^-0.93."""
    return require_value(
        closed_forms.fit_power_law(list(SPECTRUM_POINTS), [321.0 * (100.0 * si) ** -0.93 for si in SPECTRUM_POINTS])
    )


EL_CENTRO = "4b45c5b08fd51868"
"""Begins the SHA-256 of the samples of El Centro 1940, 0.319 g."""

WALL_HEIGHTS = (3.0, 5.0, 7.0, 9.0, 11.0)
TABLE = (
    # alpha [deg], one-sided, sign; q of each height
    (3.1, False, 1, "1.172 1.534 1.851 2.346 2.862"),
    (6.8, False, 1, "1.406 1.874 2.336 2.764 4.386"),
    (11.3, False, 1, "1.859 2.319 2.884 4.541 5.861"),
    (6.8, True, 1, "3.150 4.646 4.924 5.052 5.167"),
    (6.8, True, -1, "4.984 5.263 5.777 6.425 6.744"),
)


def q_of(record: GroundMotion, alpha: float, height: float, one_sided: bool, sign: int, q_step: float = 0.005) -> float:
    block = wall(height, alpha)
    model = restitution(block, "one_sided_theoretical" if one_sided else "housner")
    moving = rocking_model(block, one_sided, model, LAWS["rigid"])
    ground, step = record.acceleration, record.time_step
    ida = incremental_dynamic_analysis(ground, step, record.pga, sign, moving, METHODS["taylor"], Search(q_step=q_step))
    return require_value(ida.q)


def el_centro(folder: Path) -> GroundMotion:
    """The record of El Centro 1940 among the files of a folder, known by its samples. Raises InputError."""
    for path in sorted(folder.rglob("*[eE]l*[cC]entro*")):
        try:
            record = records.read(path)
        except InputError:
            continue
        if record.samples_sha256.startswith(EL_CENTRO):
            return record
    raise InputError("no_el_centro", place=(folder,))


def of_el_centro(record: GroundMotion) -> tuple[Solved, ...]:
    """q of 25 walls, each the first collapse on a grid of 0.5 %."""
    sketch = Sketch(BLOCK.outline, motion=tuple(record.acceleration[::4].tolist()))
    cases = []
    for alpha, one_sided, sign, values in TABLE:
        way = "reversed" if sign < 0 else "recorded"
        title = {
            (False, 1): worded("El Centro 1940: q of two-sided walls of {alpha:g}°", alpha=alpha),
            (True, 1): worded("El Centro 1940: q of one-sided walls of {alpha:g}°", alpha=alpha),
            (True, -1): worded("El Centro 1940 reversed: q of one-sided walls of {alpha:g}°", alpha=alpha),
        }[one_sided, sign]
        answers = tuple(
            printed((f"q ({height:g} m)", ""), value, partial(q_of, record, alpha, height, one_sided, sign), 1.0)
            for height, value in zip(WALL_HEIGHTS, values.split(), strict=True)
        )
        cases.append(
            Solved(
                f"el_centro_{'one' if one_sided else 'two'}_sided_{alpha:g}_{way}".replace(".", "_"),
                Kind.REFERENCE,
                title,
                "physics.md, 11",
                answers,
                'q = (C thin "PGA")/(g tan alpha)',
                sketch,
                worded("First collapse on a grid of 0.5 % by three independent solvers, to their third digit."),
            )
        )
    coarser = tuple(
        Answer(
            f"q ({alpha:g}°, {height:g} m, {100 * step:g} %)",
            "",
            expected,
            2e-3 / expected,
            partial(q_of, record, alpha, height, False, 1, step),
        )
        for alpha, height, step, expected in ((6.8, 11.0, 0.001, 3.754), (11.3, 7.0, 0.01, 4.00))
    )
    steps = Solved(
        "el_centro_steps",
        Kind.REFERENCE,
        worded("El Centro 1940: first collapse depends on the grid"),
        "physics.md, 11",
        coarser,
        "q_k = q_0 (1 + Delta q)^k",
        sketch,
        worded("Collapse is not monotone in the amplitude: q belongs to the grid of its search, q_robust does not."),
    )
    return (*cases, steps)


def _of_paper(key: str, title, equation: str, formula: str, answers: Sequence[Answer], comment=None) -> Solved:
    return Solved(key, Kind.PRINTED, title, f"{SOURCE}, {equation}", tuple(answers), formula, BLOCK, comment)


CASES: tuple[Solved, ...] = (
    _of_paper(
        "paper_restitution",
        worded("Velocity ratios of an impact"),
        "Eq. 4-6",
        "e = 1 - 3/2 sin^2 alpha, quad e_1 = (1 - 3/2 sin^2 alpha)^2 |1 - 3/2 cos^2 alpha|",
        (
            printed((worded("Eq. 4"), ""), "0.9789708", lambda: ratio("housner")),
            Answer(worded("Eq. 5, 0.95 of it"), "", 0.95 * EQ_4, 1e-12, lambda: ratio("sorrentino_experimental")),
            Answer(worded("Eq. 6"), "", EQ_6, 1e-12, lambda: ratio("one_sided_theoretical")),
            Answer(worded("Eq. 7 at rest"), "", 1.18 * EQ_6, 1e-12, lambda: ratio("one_sided_experimental")),
        ),
        worded("6.8°. The bracket of Eq. 6 is negative below 35.3°: its sign is the reversal."),
    ),
    _of_paper(
        "paper_example",
        worded("A wall of 7.0 × 0.83 m by the equations of the paper"),
        "Eq. 2, 4, 9, 15",
        'a_"RM" = g tan alpha >= (S a_g)/q, quad q_"eff" = (30 alpha + 78 H + 90) "SI"^(-1)',
        (
            printed(("α", "°"), "6.7621", lambda: math.degrees(example().slenderness)),
            printed(("a_RM", "g"), "0.1186", lambda: example().threshold_acceleration / G),
            printed(("R", "m"), "3.5245", lambda: example().radius),
            printed(("p", "rad/s"), "1.4446", lambda: example().frequency_parameter),
            printed(
                (worded("velocity ratio, Eq. 4"), ""), "0.9792", lambda: restitution(example(), "housner").ratio_at_rest
            ),
            Answer(worded("a_RM over S a_g / 2, Eq. 9"), "", 0.83 / 7.0 / (0.26 * 1.2 / 2.0), 1e-12, ratio_of_eq_9),
            printed(
                (worded("q_eff, Eq. 15"), ""),
                "6.93",
                lambda: closed_forms.closed_form_q_eff(example().slenderness, 7.0, 1.2097, False),
            ),
            printed(
                (worded("q, Eq. 15"), ""),
                "2.16",
                lambda: closed_forms.closed_form_q(example().slenderness, 7.0, 1.2097, 0.312 * G, False),
            ),
        ),
        worded(
            "a_g 0.26 g, S 1.2, SI 120.97 cm: the example of validation.md, each step by hand. The paper "
            "omits the factor a_g S / g of q."
        ),
    ),
    _of_paper(
        "paper_closed_forms",
        worded("q_eff of El Centro by Eq. 15 and 16"),
        "Eq. 12, 15, 16",
        'q_"eff" = (30 alpha + 78 H + 90) "SI"^(-1.0), quad q_"eff" = (23 alpha + 65 H + 840) "SI"^(-0.9)',
        (
            printed((worded("q_eff, Eq. 15"), ""), "6.76", lambda: q_eff(False, 1.2427)),
            Answer(
                worded("q_eff, Eq. 16 at SI 100 cm"),
                "",
                (23.0 * 6.8 + 65.0 * 7.0 + 840.0) * 100.0**-0.9,
                1e-12,
                lambda: q_eff(True, 1.0),
            ),
            Answer(
                worded("q_eff, Eq. 12"), "", 2.336 / 0.3188, 1e-12, lambda: closed_forms.effective_q(2.336, 0.3188 * G)
            ),
        ),
        worded("7 m, 6.8°, SI 124.27 cm of Table 2. Eq. 15 and 16 give q_eff, against the print."),
    ),
    _of_paper(
        "paper_power_law",
        worded("A power law is found back"),
        "Eq. 13",
        'q_"eff" = C_1 "SI"^(C_2)',
        (
            Answer("C_1", "", 321.0, 1e-9, lambda: power_law().c1),
            Answer("C_2", "", -0.93, 1e-9, lambda: power_law().c2),
            Answer("R²", "", 1.0, 1e-9, lambda: require_value(power_law().r_squared)),
        ),
        worded("Least squares of the logarithms of four points of 321 SI^-0.93."),
    ),
)
