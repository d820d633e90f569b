"""One history, or many multipliers of one record, by any method kept for comparison."""

import numpy as np

from core.jit.decorators import kernel
from core.rocking.compared import dormand_prince, newmark_paper, stepped
from core.rocking.compared.branch import acceleration
from core.rocking.events import BlockState, end_of_record, uplift_thresholds
from core.rocking.outcome import STABLE
from core.units import G
from core.wall.moment_rotation import zone_of
from core.wall.rocking_model import seen_from

NEWMARK_PAPER = 1
"""Code of the paper's integrator; those of the others are in stepped.py."""


def make_comparison(paper):
    """The kernels (integrate, scan), specialised at compile time for the paper's integrator or for the others.

    Length: it holds both, which call one another.
    """

    @kernel
    def integrate(
        code, ground, dt, scale, model, option, start, rotation, velocity, impact_time, impact_velocity, table
    ):
        """Integrate one history as `taylor.integrate` does, by any other method.

        code : of its `Method`
        ground : ground acceleration [m/s2], shape (n,)
        dt : its time step [s]
        scale : multiplier [-], negative for the reversed record
        model : RockingModel
        option : of its `Method`
        start : initial rotation [rad] and velocity [rad/s]
        rotation : results at the samples [rad], shape (n,), or (0,) where nobody wants them
        velocity : results at the samples [rad/s], of the same shape
        impact_time : results [s], up to its size
        impact_velocity : results just after each impact [rad/s], of the same shape
        table : of `Method.table`, shape (0,) but for dormand_prince
        Returns (outcome, peak rotation [rad], impacts, clamped ratios, samples done).
        """
        thresholds = uplift_thresholds(model)
        keep = rotation.size > 0
        zero = np.int64(0)
        side = -1.0 if start[0] < 0.0 or (start[0] == 0.0 and start[1] < 0.0) else 1.0
        phi, speed = side * start[0], side * start[1]
        moving = phi != 0.0 or speed != 0.0
        state = BlockState(side, phi, speed, moving, zone_of(phi, model), phi, zero, zero)
        beta = side * scale * ground[0] / G
        push = acceleration(phi, beta, seen_from(model, side), state.zone)
        rates = table[16 * dormand_prince.STAGES : 17 * dormand_prince.STAGES]
        pushes = table[17 * dormand_prince.STAGES :]
        if keep:
            rotation[0] = start[0]
            velocity[0] = start[1]
        for i in range(ground.size - 1):
            ground0, ground1 = scale * ground[i], scale * ground[i + 1]
            if paper:
                outcome, push, state = newmark_paper.through_sample(
                    ground0,
                    ground1,
                    (i + 1) * dt,
                    dt,
                    model,
                    thresholds,
                    option,
                    push,
                    state,
                    impact_time,
                    impact_velocity,
                )
            else:
                outcome, state = stepped.through_sample(
                    code,
                    ground0,
                    ground1,
                    i * dt,
                    dt,
                    model,
                    thresholds,
                    option,
                    state,
                    impact_time,
                    impact_velocity,
                    table,
                    rates,
                    pushes,
                )
            if outcome != STABLE:
                return outcome, state.peak, state.impacts, state.clamped, i + 1
            if keep:
                rotation[i + 1] = state.side * state.phi if state.moving else 0.0
                velocity[i + 1] = state.side * state.speed if state.moving else 0.0
        outcome, peak = STABLE, state.peak
        if state.moving:
            outcome, peak = end_of_record(state.phi, state.speed, state.peak, seen_from(model, state.side))
        return outcome, peak, state.impacts, state.clamped, ground.size

    @kernel
    def scan(code, option, ground, dt, scales, model, outcomes, peaks, clamped, none, table):
        """`history.scan_multipliers` by the other methods.

        code : of its `Method`
        option : of its `Method`
        ground : ground acceleration [m/s2], shape (n,)
        dt : its time step [s]
        scales : multipliers [-], shape (m,), negative reverses the record
        model : RockingModel
        outcomes : results, codes of outcome.py, int64, shape (m,)
        peaks : results [rad], shape (m,)
        clamped : results, counts of clamped velocity ratios, int64, shape (m,)
        none : in place of the histories, which nobody wants, shape (0,)
        table : of `Method.table`, shape (0,) but for dormand_prince
        """
        for j in range(scales.size):
            outcomes[j], peaks[j], _, clamped[j], _ = integrate(
                code, ground, dt, scales[j], model, option, (0.0, 0.0), none, none, none, none, table
            )

    return integrate, scan


COMPARISON = {paper: make_comparison(paper) for paper in (True, False)}


def integrate_comparison(code, *arguments):
    """`integrate` of the method of this code; see `make_comparison`."""
    return COMPARISON[code == NEWMARK_PAPER][0](code, *arguments)


def scan_comparison(code, *arguments):
    """`scan` of the method of this code; see `make_comparison`."""
    COMPARISON[code == NEWMARK_PAPER][1](code, *arguments)
