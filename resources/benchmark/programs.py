"""Programs that answer the scenes: one on standard input, its answer on standard output.

    python3 programs.py ribalta|scipy|heyoka|opensees < problem.json

The rules of the motion that README.md states stand in `Wall`, in plain Python. scipy and heyoka integrate it piece by
piece; Ribalta and OpenSees are asked for whole histories.
"""

import json
import math
import sys
import time
from itertools import pairwise
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Wall:
    """A wall whose motion `step` integrates, piece by piece: step(phi, speed, beta, slope, span, law, low, high) gives
    (time, phi, speed) at the end of the span or where phi falls to `low` or rises to `high`, and -1, 1 or 0, which.

    law : (sine, slope, constant) of the moment sine sin(alpha - phi) + slope phi + constant, over m g R
    """

    def __init__(self, problem: dict, step):
        block = problem["block"]
        self.alpha, self.p2, self.ratio = block["slenderness"], block["p2"], block["velocity_ratio"]
        self.one_sided, self.kinks = block["one_sided"], block["kinks"] or []
        self.gravity, self.dt, self.start, self.step = problem["gravity"], problem["dt"], problem["start"], step
        self.rest = 1e-6 * math.sqrt(self.p2) * self.alpha
        self.right = 0.0 if self.kinks else math.tan(self.alpha)
        self.left = math.inf if self.one_sided else self.right
        self.levels, self.laws = [0.0, *self.kinks, math.inf], [(1.0, 0.0, 0.0)]
        if self.kinks:
            plateau = math.sin(self.alpha - self.kinks[1])
            self.laws = [(0.0, plateau / self.kinks[0], 0.0), (0.0, 0.0, plateau), *self.laws]

    def uplift(self, first: float, slope: float, t: float) -> tuple[float, float] | None:
        """(time, side) of the next uplift within a sample, from t on."""
        if self.lifts(first + slope * t):
            return t, math.copysign(1.0, first + slope * t)
        level = self.right if slope > 0.0 else -self.left
        when = (level - first) / slope if slope else math.inf
        return (max(when, t), math.copysign(1.0, slope)) if when < self.dt else None

    def lifts(self, now: float) -> bool:
        return now > self.right or now < -self.left

    def history(self, ground, scale: float = 1.0) -> tuple[list[float], list[float], bool]:
        """(rotations at the samples [rad], times of impacts [s], whether it overturns)."""
        side = math.copysign(1.0, self.start[0])
        phi, speed = abs(self.start[0]), side * self.start[1]
        moving, zone = phi > 0.0, sum(phi > kink for kink in self.kinks)
        rotations, impacts = [self.start[0]], []
        for k, (first, second) in enumerate(pairwise(ground)):
            first, second, t = scale * first / self.gravity, scale * second / self.gravity, 0.0
            slope = (second - first) / self.dt
            while t < self.dt:
                if not moving:
                    uplift = self.uplift(first, slope, t)
                    if uplift is None:
                        break
                    (t, side), phi, speed, moving, zone = uplift, 0.0, 0.0, True, 0
                beta, span, levels = side * (first + slope * t), self.dt - t, self.levels[zone : zone + 2]
                passed, phi, speed, end = self.step(phi, speed, beta, side * slope, span, self.laws[zone], *levels)
                t = t + passed if end else self.dt
                phi = levels[(end + 1) // 2] if end else phi
                if zone + end >= 0:
                    zone += end
                    continue
                impacts.append(k * self.dt + t)
                speed, side = -self.ratio * speed, side if self.one_sided else -side
                moving = speed > 0.0 and (speed >= self.rest or self.lifts(first + slope * t))
            phi = phi if moving else 0.0
            rotations.append(side * phi)
            if phi > 0.5 * math.pi:
                return rotations, impacts, True
        return rotations, impacts, moving and self.falls(phi, speed)

    def falls(self, phi: float, speed: float) -> bool:
        """Whether it overturns on still ground."""
        energy = 0.5 * speed**2 + self.potential(phi)
        if phi > self.alpha and (speed >= 0.0 or energy < 0.0):
            return True
        if speed < 0.0:
            at_rest = self.potential(0.0)
            energy = self.ratio**2 * (energy - at_rest) + at_rest
        return energy > 0.0

    def potential(self, phi: float) -> float:
        """Potential energy over I0, less that of the upright wall [1/s2]."""
        first, last = self.kinks or (0.0, 0.0)
        flat = max(last - max(phi, first), 0.0) + (max(first**2 - phi**2, 0.0) / (2 * first) if first else 0.0)
        return self.p2 * (math.cos(self.alpha - max(phi, last)) - 1.0 - flat * math.sin(self.alpha - last))


def scipy(problem: dict):
    """DOP853 at the least tolerance it takes, restarted at samples and events."""
    from scipy.integrate import solve_ivp

    alpha, p2 = problem["block"]["slenderness"], problem["block"]["p2"]

    def event(level, direction):
        def distance(t, y):
            return y[0] - level

        vars(distance).update(terminal=True, direction=direction)
        return distance

    def step(phi, speed, beta, slope, span, law, low, high):
        def motion(t, y):
            moment = law[0] * math.sin(alpha - y[0]) + law[1] * y[0] + law[2]
            return y[1], p2 * ((beta + slope * t) * math.cos(alpha - y[0]) - moment)

        events = [event(low, -1)] + ([event(high, 1)] if high < math.inf else [])
        found = solve_ivp(motion, (0.0, span), (phi, speed), "DOP853", rtol=3e-14, atol=1e-18, events=events)
        ends = [end for end, times in zip((-1, 1), found.t_events, strict=False) if len(times)]
        return found.t[-1], found.y[0, -1], found.y[1, -1], ends[0] if ends else 0

    return Wall(problem, step).history


def heyoka(problem: dict):
    """Its adaptive Taylor integrator in double precision, restarted at samples and events. A step that begins at an
    event is not seen to come back to it: it begins at the next number beyond, at zero at 1e-22."""
    import heyoka as hy

    phi, speed = hy.make_vars("phi", "speed")
    lean, beta, at_end = hy.par[0] - phi, hy.par[2] + hy.par[3] * hy.time, [0]
    moment = hy.par[4] * hy.sin(lean) + hy.par[5] * phi + hy.par[6]

    def note(end):
        def callback(_, sign):
            at_end[0] = end
            return False

        return callback

    events = [
        hy.t_event(phi - hy.par[7], callback=note(-1), direction=hy.event_direction.negative, cooldown=0.0),
        hy.t_event(phi - hy.par[8], callback=note(1), direction=hy.event_direction.positive, cooldown=0.0),
    ]
    system = [(phi, speed), (speed, hy.par[1] * (beta * hy.cos(lean) - moment))]
    block = problem["block"]
    if not block["kinks"]:
        events.pop()
    integrator = hy.taylor_adaptive(system, [0.0, 0.0], t_events=events)

    def step(phi, speed, beta, slope, span, law, low, high):
        if phi == low:
            phi = max(math.nextafter(low, math.inf), 1e-22)
        elif phi == high:
            phi = math.nextafter(high, 0.0)
        integrator.time, integrator.state[:], at_end[0] = 0.0, (phi, speed), 0
        known = block["slenderness"], block["p2"], beta, slope, *law, low, min(high, 100.0)
        integrator.pars[:] = known[: integrator.pars.size]
        integrator.propagate_until(span)
        return integrator.time, *integrator.state, at_end[0]

    return Wall(problem, step).history


def ribalta(problem: dict):
    """One call a history."""
    sys.path.insert(0, str(ROOT))
    import numpy as np

    from core.rocking.history import integrate_history
    from core.rocking.outcome import COLLAPSED
    from core.wall.rocking_model import RockingModel

    block = problem["block"]
    kinks = block["kinks"] or (0.0, 0.0)
    sided = float(block["one_sided"])
    model = RockingModel(block["slenderness"], block["p2"], sided, block["velocity_ratio"], 0.0, *kinks)

    def whole(ground, scale=1.0):
        found = integrate_history(np.asarray(ground, float), problem["dt"], scale, model, start=tuple(problem["start"]))
        return found.rotation, found.impact_time, found.outcome == COLLAPSED

    return whole


def opensees(problem: dict, parts: int = 10):
    """The oscillator of one degree of freedom on a nonlinear elastic spring, as Diamantopoulos and Fragiadakis (2019)
    use OpenSees: the rigid law rises within a thousandth of alpha, the ground pushes with cos(alpha), the velocity is
    reduced at the end of the step in which the rotation has changed sign; average acceleration, ten steps a sample."""
    import openseespy.opensees as ops

    block, dt = problem["block"], problem["dt"]
    alpha, p2, ratio, one_sided = (block[key] for key in ("slenderness", "p2", "velocity_ratio", "one_sided"))
    rise, last = block["kinks"] or (1e-3 * alpha, 1e-3 * alpha)
    turned = [rise, *(last + (1.6 - last) * k / 200 for k in range(201))][rise == last :]
    moments = [p2 * math.sin(alpha - max(phi, last)) for phi in turned]
    strains = [-phi for phi in reversed(turned)] + [0.0, *turned]
    stresses = [-moment for moment in reversed(moments)] + [0.0, *moments]
    wall = Wall(problem, None)

    def history(ground, scale=1.0):
        ops.wipe()
        ops.model("basic", "-ndm", 1, "-ndf", 1)
        ops.node(1, 0.0)
        ops.node(2, 0.0, "-mass", 1.0)
        ops.fix(1, 1)
        ops.uniaxialMaterial("ElasticMultiLinear", 1, "-strain", *strains, "-stress", *stresses)
        ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
        push = p2 * math.cos(alpha) * scale / problem["gravity"]
        ops.timeSeries("Path", 1, "-dt", dt, "-values", *ground, "-factor", push)
        ops.pattern("Plain", 1, 1)
        ops.load(2, 1.0)
        for command in (("constraints", "Plain"), ("numberer", "Plain"), ("system", "FullGeneral")):
            getattr(ops, command[0])(command[1])
        ops.test("NormDispIncr", 1e-14, 50)
        ops.algorithm("Newton")
        ops.integrator("Newmark", 0.5, 0.25)
        ops.analysis("Transient")
        ops.setNodeDisp(2, 1, problem["start"][0], "-commit")
        ops.setNodeVel(2, 1, problem["start"][1], "-commit")
        theta, speed, rotations, impacts, reach = *problem["start"], [problem["start"][0]], [], 0.0
        for k in range(len(ground) - 1):
            for part in range(parts):
                if ops.analyze(1, dt / parts) != 0:
                    raise ArithmeticError(f"no convergence at {ops.getTime()} s")
                before, theta, speed = theta, ops.nodeDisp(2, 1), ops.nodeVel(2, 1)
                reach = max(reach, abs(before))
                if (one_sided and theta < 0.0) or before * theta < 0.0:
                    if reach > rise:  # else it wobbles about its base
                        impacts.append(dt * (k + (part + 1) / parts))
                    reach = 0.0
                    theta, speed = (0.0, max(0.0, -ratio * speed)) if one_sided else (theta, ratio * speed)
                    ops.setNodeDisp(2, 1, theta, "-commit")
                    ops.setNodeVel(2, 1, speed, "-commit")
                    ops.domainChange()  # else the integrator goes on from its own copy
            rotations.append(theta)
            if abs(theta) > 0.5 * math.pi:
                return rotations, impacts, True
        return rotations, impacts, wall.falls(abs(theta), math.copysign(speed, theta * speed))

    return history


PROGRAMS = {one.__name__: one for one in (ribalta, scipy, heyoka, opensees)}


def critical(history, ground, low: float, high: float) -> float:
    """The multiplier at which the outcome changes, by bisection to the last digit."""
    falls = history(ground, low)[2]
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (middle, high) if history(ground, middle)[2] == falls else (low, middle)
    return high


def timed(history, ground, most: int = 20):
    """(the history, least seconds it took)."""
    best = math.inf
    history(ground[:5])  # compiles, imports
    begun = time.perf_counter()
    for _ in range(most):
        start = time.perf_counter()
        found = history(ground)
        best = min(best, time.perf_counter() - start)
        if time.perf_counter() - begun > 0.5:
            break
    return found, best


def answer(problem: dict, history) -> dict:
    """What is asked of a scene."""
    ask = problem["ask"]
    if "critical" in ask:
        return {"critical": [critical(history, problem["ground"], *ends) for ends in ask["critical"]]}
    if "seeds" in ask:
        history(problem["grounds"][0])
        start = time.perf_counter()
        found = [history(ground) for ground in problem["grounds"]]
        seconds = time.perf_counter() - start
        peaks = sorted(max(map(abs, rotations)) for rotations, _, overturns in found if not overturns)
        standing = [float(peaks[rank - 1]) if rank <= len(peaks) else None for rank in ask["peaks"]]
        return {"overturned": len(found) - len(peaks), "peaks": standing, "seconds": seconds}
    (rotations, impacts, overturns), seconds = timed(history, problem["ground"])
    at = [float(rotations[k]) if k < len(rotations) else None for k in ask.get("rotation", [])]
    given = {
        "rotation": at,
        "impact_times": [float(when) for when in impacts[: ask.get("impact_times", 0)]],
        "impacts": len(impacts),
        "peak": float(max(map(abs, rotations))),
        "overturns": bool(overturns),
    }
    # of a history that ended early, the samples it took
    return {key: given[key] for key in ask} | {"seconds": seconds * len(problem["ground"]) / len(rotations)}


if __name__ == "__main__":
    scene = json.load(sys.stdin)
    print(json.dumps(answer(scene, PROGRAMS[sys.argv[1]](scene))))
