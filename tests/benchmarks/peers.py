"""Other solvers on the same scenes: scipy, naive and restarted at samples, and heyoka.

Each peer takes a Scene and returns theta / alpha at the samples; it handles rest, uplift and impact with
its own event location. numbalsoda has no wheel for Linux and is left out where it does not import.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

from core.capacity import independent_solver
from tests.benchmarks.scenes import Scene

G = 9.80665


def scipy_restarted(scene: Scene) -> np.ndarray:
    """DOP853 restarted at samples and events, rtol 3e-14."""
    model = scene.model
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    theta, _ = independent_solver.history(
        scene.ground, scene.dt, model.slenderness, model.p2, model.one_sided != 0.0,
        lambda v: model.ratio_at_rest, kinks,
    )  # fmt: skip
    return theta / model.slenderness


def scipy_naive(scene: Scene, rtol: float = 1e-8) -> np.ndarray:
    """What one writes first: interpolated ground, one call of LSODA-like freedom between impacts."""
    model = scene.model
    alpha = model.slenderness
    times = np.arange(scene.ground.size) * scene.dt
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    threshold = math.tan(alpha) if kinks is None else 0.0
    theta = np.zeros(times.size)
    side, now, state, moving = 1.0, 0.0, [0.0, 0.0], False
    rest = 1e-6 * math.sqrt(model.p2) * alpha

    def motion(t, y, side):
        beta = side * np.interp(t, times, scene.ground) / G
        moment = independent_solver.law(y[0], alpha, kinks)
        return [y[1], -model.p2 * (moment - beta * math.cos(alpha - y[0]))]

    def impact(t, y, side):
        return y[0]

    impact.terminal, impact.direction = True, -1
    while now < times[-1]:
        k = min(int(now / scene.dt + 1e-9), times.size - 2)
        if not moving:
            start = independent_solver.uplift(
                scene.ground[k] / G, scene.ground[k + 1] / G, now - times[k], scene.dt, threshold,
                model.one_sided != 0.0,
            )  # fmt: skip
            if start is None:
                now = times[k + 1]
                continue
            now, side, state, moving = times[k] + start[0], start[1], [0.0, 0.0], True
        found = solve_ivp(
            motion, (now, times[-1]), state, "DOP853", rtol=rtol, atol=1e-3 * rtol, events=impact,
            args=(side,), dense_output=True,
        )  # fmt: skip
        inside = (times >= now) & (times <= found.t[-1])
        if inside.any():
            theta[inside] = side * found.sol(times[inside])[0]
        now = found.t[-1]
        if found.status != 1:
            break
        speed = model.ratio_at_rest * -found.y[1, -1]
        side = side if model.one_sided else -side
        ground = np.interp(now, times, scene.ground) / G
        lifts = ground > threshold or (ground < -threshold and not model.one_sided)
        state, moving = [0.0, speed], not (speed < rest and not lifts)
    return theta / alpha


class Heyoka:
    """heyoka's adaptive Taylor integrator at double precision, restarted at samples; rigid law."""

    def __init__(self, tolerance: float = 0.0):
        import heyoka as hy

        phi, speed = hy.make_vars("phi", "speed")
        lean = hy.par[0] - phi
        beta = hy.par[2] + hy.par[3] * hy.time
        push = hy.par[1] * (beta * hy.cos(lean) - hy.sin(lean))
        event = hy.t_event(phi, direction=hy.event_direction.negative)
        options = {"tol": tolerance} if tolerance else {}
        self.stop = hy.taylor_outcome.time_limit
        self.integrator = hy.taylor_adaptive(
            [(phi, speed), (speed, push)], [0.0, 0.0], pars=[0.1, 1.0, 0.0, 0.0], t_events=[event],
            **options,
        )  # fmt: skip

    def __call__(self, scene: Scene) -> np.ndarray:
        model, ta = scene.model, self.integrator
        alpha, one_sided = model.slenderness, model.one_sided != 0.0
        threshold = math.tan(alpha)
        rest = 1e-6 * math.sqrt(model.p2) * alpha
        ta.pars[0], ta.pars[1] = alpha, model.p2
        theta = np.zeros(scene.ground.size)
        side, moving, dt = 1.0, False, scene.dt
        for i in range(scene.ground.size - 1):
            b0, b1 = scene.ground[i] / G, scene.ground[i + 1] / G
            t = 0.0
            while t < dt:
                if not moving:
                    start = independent_solver.uplift(b0, b1, t, dt, threshold, one_sided)
                    if start is None:
                        break
                    t, side = start
                    ta.state[:] = (0.0, 0.0)
                    ta.reset_cooldowns()
                    moving = True
                ta.pars[2], ta.pars[3] = side * b0, side * (b1 - b0) / dt
                ta.time = t
                outcome = ta.propagate_until(dt)[0]
                if outcome == self.stop:
                    break
                t = ta.time
                speed = -model.ratio_at_rest * ta.state[1]
                ta.state[:] = (0.0, speed)
                side = side if one_sided else -side
                now = b0 + (b1 - b0) * t / dt
                lifts = now > threshold or (now < -threshold and not one_sided)
                moving = not (speed < rest and not lifts)
            theta[i + 1] = side * ta.state[0] if moving else 0.0
        return theta / alpha
