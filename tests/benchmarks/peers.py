"""Other solvers on the same scenes: scipy, naive and restarted at samples, heyoka and diffrax.

Each peer takes a Scene and returns theta / alpha at the samples; it handles rest, uplift and impact with
its own event location. numbalsoda has no wheel for Linux and is left out where it does not import.
"""

import math
import time
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from core.capacity import independent_solver
from tests.benchmarks.scenes import Scene

G = 9.80665

ABOVE = 1e-22
"""Rotation after an impact [rad]: where a step begins at zero, heyoka does not see it fall to zero again."""


def uplift_thresholds(scene: Scene) -> tuple[float, float]:
    """Ground accelerations over g that lift the wall to the positive and to the negative side; infinite where it is
    held."""
    model = scene.model
    threshold = math.tan(model.slenderness) if model.plateau_end == 0.0 else 0.0
    return threshold, math.inf if model.one_sided else threshold


def scipy_restarted(scene: Scene) -> np.ndarray:
    """DOP853 restarted at samples and events, rtol 3e-14."""
    model = scene.model
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    theta, _ = independent_solver.history(
        scene.ground,
        scene.dt,
        model.slenderness,
        model.p2,
        model.one_sided != 0.0,
        lambda v: model.ratio_at_rest,
        kinks,
    )
    return theta / model.slenderness


def scipy_naive(scene: Scene, rtol: float = 1e-8) -> np.ndarray:
    """What one writes first: interpolated ground, one call of LSODA-like freedom between impacts."""
    model = scene.model
    alpha = model.slenderness
    times = np.arange(scene.ground.size) * scene.dt
    kinks = None if model.plateau_end == 0.0 else (model.elastic_end, model.plateau_end)
    thresholds = uplift_thresholds(scene)
    theta = np.zeros(times.size)
    side, now, state, moving = 1.0, 0.0, [0.0, 0.0], False
    rest = 1e-6 * math.sqrt(model.p2) * alpha

    def motion(t, y, side):
        beta = side * np.interp(t, times, scene.ground) / G
        moment = independent_solver.law(y[0], alpha, kinks)
        return [y[1], -model.p2 * (moment - beta * math.cos(alpha - y[0]))]

    def impact(t, y, side):
        return y[0]

    vars(impact).update(terminal=True, direction=-1)
    while now < times[-1]:
        k = min(int(now / scene.dt + 1e-9), times.size - 2)
        if not moving:
            start = independent_solver.uplift(
                scene.ground[k] / G, scene.ground[k + 1] / G, now - times[k], scene.dt, thresholds
            )
            if start is None:
                now = times[k + 1]
                continue
            now, side, state, moving = times[k] + start[0], start[1], [0.0, 0.0], True
        found = solve_ivp(
            motion,
            (now, times[-1]),
            state,
            "DOP853",
            rtol=rtol,
            atol=1e-3 * rtol,
            events=impact,
            args=(side,),
            dense_output=True,
        )
        inside = (times >= now) & (times <= found.t[-1])
        if inside.any():
            theta[inside] = side * found.sol(times[inside])[0]
        now = found.t[-1]
        if found.status != 1:
            break
        speed = model.ratio_at_rest * -found.y[1, -1]
        side = side if model.one_sided else -side
        ground = np.interp(now, times, scene.ground) / G
        lifts = ground > thresholds[0] or ground < -thresholds[1]
        state, moving = [0.0, speed], not (speed < rest and not lifts)
    return theta / alpha


class Heyoka:
    """heyoka's adaptive Taylor integrator at double precision as its authors drive it: compiled steps to the end of
    each sample, impacts in the callback of a terminal event; `lanes` histories in one of its batches. Rigid law.

    (An event's cooldown is zero: that of its own choice, which grows with the tolerance, hides the next impact.)
    """

    def __init__(self, tolerance: float = 0.0, lanes: int = 1):
        import heyoka as hy

        phi, speed = hy.make_vars("phi", "speed")
        lean = hy.par[0] - phi
        beta = hy.par[2] + hy.par[3] * hy.time
        system = [(phi, speed), (speed, hy.par[1] * (beta * hy.cos(lean) - hy.sin(lean)))]
        options: dict[str, Any] = {"tol": tolerance} if tolerance else {}
        self.lanes = lanes
        self.scene: Scene
        falling: dict[str, Any] = {"direction": hy.event_direction.negative, "cooldown": 0.0}
        if lanes == 1:
            event = hy.t_event(phi, callback=lambda _, sign: self.impact(0), **falling)
            self.integrator = hy.taylor_adaptive(system, [0.0, 0.0], pars=[0.0] * 4, t_events=[event], **options)
        else:
            event = hy.t_event_batch(phi, callback=lambda _, sign, k: self.impact(k), **falling)
            self.integrator = hy.taylor_adaptive_batch(
                system, np.zeros((2, lanes)), pars=np.zeros((4, lanes)), t_events=[event], **options
            )
        # views of the integrator's own memory, a column for each history
        self.state = self.integrator.state.reshape(2, lanes)
        self.pars = self.integrator.pars.reshape(4, lanes)
        self.order = self.integrator.order

    def impact(self, k: int) -> bool:
        """Eq. 3, and the rest of `core.rocking.events`; the integrator goes on."""
        model = self.scene.model
        speed = -model.ratio_at_rest * self.state[1, k]
        self.state[:, k] = ABOVE, speed
        if not model.one_sided:
            self.side[k] = -self.side[k]
            self.pars[2:, k] *= -1.0
        time = self.integrator.time if self.lanes == 1 else self.integrator.time[k]
        ground = self.side[k] * (self.pars[2, k] + self.pars[3, k] * time)
        lifts = ground > self.thresholds[0] or ground < -self.thresholds[1]
        if speed < self.rest and not lifts:
            self.stop(k)
            self.times[k] = time
        return True

    def stop(self, k: int) -> None:
        """At rest: a history of its batch that stays where it is, away from the event."""
        self.moving[k] = False
        self.state[:, k] = 1.0, 0.0
        self.pars[1, k] = 0.0

    def lift(self, k: int, first: float, second: float) -> None:
        """Set a resting history moving where the ground lifts it first, else to the end of the sample."""
        scene = self.scene
        start = independent_solver.uplift(first, second, self.times[k], scene.dt, self.thresholds)
        self.times[k] = scene.dt
        if start is not None:
            self.times[k], self.side[k] = start
            self.moving[k], self.state[:, k] = True, (ABOVE, 0.0)
            pull = self.side[k] * np.array([first, (second - first) / scene.dt])
            self.pars[1:, k] = scene.model.p2, *pull

    def __call__(self, scene: Scene) -> np.ndarray:
        """theta / alpha of the scene; the other histories of a batch are of smaller multipliers."""
        model, dt, lanes = scene.model, scene.dt, self.lanes
        scales = np.linspace(1.0, 0.9, lanes)
        self.scene, self.thresholds = scene, uplift_thresholds(scene)
        self.rest = 1e-6 * math.sqrt(model.p2) * model.slenderness
        self.side, self.moving = np.ones(lanes), np.zeros(lanes, bool)
        self.pars[0] = model.slenderness
        for k in range(lanes):
            self.stop(k)
        theta = np.zeros(scene.ground.size)
        ground = scene.ground[:, None] * scales / G
        for i in range(scene.ground.size - 1):
            first, jump = ground[i], ground[i + 1] - ground[i]
            self.pars[2], self.pars[3] = self.side * first, self.side * jump / dt
            self.times = np.zeros(lanes)
            todo = True
            while todo:
                for k in np.nonzero(~self.moving)[0].tolist():
                    self.lift(k, ground[i, k], ground[i + 1, k])
                if lanes == 1:
                    self.integrator.time = self.times[0]
                else:
                    self.integrator.set_time(self.times)
                self.times[:] = dt
                self.integrator.propagate_until(dt)
                todo = (self.times < dt).any()
            theta[i + 1] = self.side[0] * self.state[0, 0] if self.moving[0] else 0.0
        return theta / model.slenderness

    def compiled(self, dt: float, steps: int = 400, repeats: int = 20) -> float:
        """Time of a step of its compiled loop alone, a history [s]: no impact, the event watched."""
        best = math.inf
        for _ in range(repeats):
            self.pars[:] = np.array([[0.119], [2.0866], [0.1], [0.0]])
            self.state[0], self.state[1] = 0.119 - math.atan(0.1), 1e-6
            if self.lanes == 1:
                self.integrator.time = 0.0
            else:
                self.integrator.set_time(0.0)
            start = time.perf_counter()
            self.integrator.propagate_until(steps * dt, max_delta_t=dt)
            best = min(best, time.perf_counter() - start)
        return best / (steps * self.lanes)

    def in_ensemble(self, dt: float, steps: int = 2500, members: int = 64) -> float:
        """Time of such a step in heyoka's ensemble, whose members run on all threads of the machine, a history [s];
        each is a copy of the integrator, which takes a millisecond."""
        import heyoka as hy

        run = hy.ensemble_propagate_until if self.lanes == 1 else hy.ensemble_propagate_until_batch

        def member(integrator, k: int):
            state, pars = integrator.state.reshape(2, self.lanes), integrator.pars.reshape(4, self.lanes)
            pars[:] = np.array([[0.119], [2.0866], [0.1], [0.0]])
            state[0], state[1] = 0.119 - math.atan(0.1), 1e-6 * (1.0 + 0.001 * k)
            if self.lanes == 1:
                integrator.time = 0.0
            else:
                integrator.set_time(0.0)
            return integrator

        best = math.inf
        for _ in range(3):
            start = time.perf_counter()
            run(self.integrator, steps * dt, members, member, max_delta_t=dt)
            best = min(best, time.perf_counter() - start)
        return best / (steps * self.lanes * members)


class Diffrax:
    """diffrax, the solvers of JAX, at double precision as its authors drive it: a history compiled whole, a loop over
    the samples (the ground is linear between them) and in it one over the impacts, each the event that ends a solution
    by Dopri8; `lanes` histories by its vmap. Rigid law. The first call for a count of samples compiles.

    (Steps of at most a sample over `parts`: an impact is as exact as the interpolation within a step, whatever the
    tolerance. Its root is bisected: Newton's, from the end of the step, now and then finds another one.)
    """

    def __init__(self, parts: int = 4, lanes: int = 1):
        import diffrax
        import jax
        import optimistix
        from jax import lax
        from jax import numpy as jnp

        jax.config.update("jax_enable_x64", True)
        self.lanes = lanes
        root = optimistix.Bisection(1e-14, 1e-16, flip=True)  # type: ignore[call-arg]
        event = diffrax.Event(lambda t, y, args, **_: y[0], root, direction=False)

        def motion(t, y, args):
            alpha, p2, first, slope = args
            lean = alpha - y[0]
            return jnp.array([y[1], p2 * ((first + slope * t) * jnp.cos(lean) - jnp.sin(lean))])

        def uplift(first, slope, t, dt, right, left):
            """(time, side) as `independent_solver.uplift` has them, the time dt where there is none."""
            now = first + slope * t
            lifts = (now > right) | (now < -left)
            crossing = (jnp.where(slope > 0.0, right, -left) - first) / slope
            later = jnp.where(slope == 0.0, dt, jnp.clip(crossing, t, dt))
            return jnp.where(lifts, t, later), jnp.sign(jnp.where(lifts, now, slope))

        def history(ground, dt, alpha, p2, ratio, rest, right, left):
            def solve(t, y, side, first, slope):
                """To the impact or the end of the sample: Eq. 3, and the rest of `core.rocking.events`."""
                found = diffrax.diffeqsolve(
                    *(diffrax.ODETerm(motion), diffrax.Dopri8(), t, dt, dt - t, y),
                    args=(alpha, p2, side * first, side * slope),
                    stepsize_controller=diffrax.PIDController(rtol=1e-12, atol=1e-14, dtmax=dt / parts),
                    event=event,
                    throw=False,
                )
                struck, passed = diffrax.is_event(found.result), found.result == diffrax.RESULTS.successful
                y = jnp.where(struck | passed, found.ys[-1], jnp.nan)
                t = jnp.where(struck, found.ts[-1], dt)
                speed, now = -ratio * y[1], first + slope * t
                moving = ~struck | (speed >= rest) | (now > right) | (now < -left)
                side = jnp.where(struck & jnp.isfinite(left), -side, side)
                return t, jnp.where(struck, jnp.array([ABOVE, speed]), y), side, moving

            def sample(state, ends):
                first, slope = ends[0], (ends[1] - ends[0]) / dt

                def advance(state):
                    t, y, side, moving = state
                    start, up = uplift(first, slope, t, dt, right, left)
                    t, side = jnp.where(moving, t, start), jnp.where(moving, side, up)
                    y = jnp.where(moving, y, jnp.array([ABOVE, 0.0]))
                    state = t, y, side, moving
                    return lax.cond(t < dt, lambda: solve(t, y, side, first, slope), lambda: state)

                _, y, side, moving = lax.while_loop(lambda state: state[0] < dt, advance, (jnp.zeros(()), *state))
                return (y, side, moving), jnp.where(moving, side * y[0], 0.0)

            still = jnp.zeros(2), jnp.ones(()), jnp.array(False)
            return lax.scan(sample, still, (ground[:-1], ground[1:]))[1]

        self.histories = jax.jit(jax.vmap(history, (0, *[None] * 7)) if lanes > 1 else history)

    def __call__(self, scene: Scene) -> np.ndarray:
        """theta / alpha of the scene; the other histories of vmap are of smaller multipliers."""
        model, ground = scene.model, scene.ground / G
        rest = 1e-6 * math.sqrt(model.p2) * model.slenderness
        if self.lanes > 1:
            ground = np.linspace(1.0, 0.9, self.lanes)[:, None] * ground
        known = (scene.dt, model.slenderness, model.p2, model.ratio_at_rest, rest, *uplift_thresholds(scene))
        theta = np.atleast_2d(self.histories(ground, *known))[0]
        return np.append(0.0, theta) / model.slenderness
