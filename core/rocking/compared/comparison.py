"""One history, or many multipliers of one record, by any method kept for comparison."""

from core.jit.decorators import kernel
from core.rocking.compared import newmark_paper, stepped

NEWMARK_PAPER = 1
"""Code of the paper's integrator; those of the others are in stepped.py."""


@kernel
def integrate_comparison(
    code, ground, dt, scale, model, option, start, rotation, velocity, impact_time,
    impact_velocity, table,
):  # fmt: skip
    """`taylor.integrate` of any other method, by its integer code; option, table : of its `Method`."""
    if code == NEWMARK_PAPER:
        return newmark_paper.integrate(
            ground, dt, scale, model, option, start, rotation, velocity, impact_time, impact_velocity
        )  # fmt: skip
    return stepped.integrate(
        code, ground, dt, scale, model, option, start, rotation, velocity, impact_time,
        impact_velocity, table,
    )  # fmt: skip


@kernel
def scan_comparison(code, option, ground, dt, scales, model, outcomes, peaks, clamped, none, table):
    """`history.scan` by the other methods. none : of no element."""
    for j in range(scales.size):
        outcomes[j], peaks[j], _, clamped[j], _ = integrate_comparison(
            code, ground, dt, scales[j], model, option, (0.0, 0.0), none, none, none, none, table
        )
