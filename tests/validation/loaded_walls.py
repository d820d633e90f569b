"""A wall with loads written from coordinates and forces, with no a, c or alpha of the program in it."""

import itertools
import math

import numpy as np
from scipy.integrate import solve_ivp

G = 9.80665


def moment(theta, side, wall, loads):
    """(restoring moment, moment of a unit ground acceleration, I0) per metre about the hinge of this side.

    wall : (H, t, unit weight [N/m3]); loads : (vertical N, horizontal F inward to the outer face, distance from the
    outer face, height, mass that moves) in N/m, m, kg/m; theta : outward from that hinge
    """
    height, thickness, weight = wall
    mass = weight * height * thickness / G
    parts = [(mass * G, 0.0, 0.5 * thickness, 0.5 * height, mass), *loads]
    c, s = math.cos(theta), math.sin(theta)
    restoring = pushed = 0.0
    inertia = mass * (height**2 + thickness**2) / 12.0
    for vertical, horizontal, distance, above, moves in parts:
        d = distance if side > 0 else thickness - distance
        restoring += vertical * (d * c - above * s) + side * horizontal * (above * c + d * s)
        pushed += moves * (above * c + d * s)
        inertia += moves * (d**2 + above**2)
    return restoring, pushed, inertia


def history(ground, dt, wall, loads, one_sided, ratio, rest, start=0.0, moment=moment):
    """theta at the samples [rad] under a ground of 1000 samples or less, by DOP853 from sample to sample; below
    the speed rest [rad/s] it rests after an impact. ratio : of an impact, or of each side by 1.0 and -1.0"""
    side, phi, speed, moving = 1.0, start, 0.0, start > 0.0
    theta = [start]
    for first, last in itertools.pairwise(ground):
        t = 0.0
        while t < dt:

            def net(y, s, way, first=first, last=last):
                holds, pushes, inertia = moment(y, way, wall, loads)
                u = first + (last - first) * s / dt
                return (way * u * pushes - holds) / inertia

            if not moving:
                for way in (1.0,) if one_sided else (1.0, -1.0):
                    side = way
                    at_start, at_end = net(0.0, t, side), net(0.0, dt, side)
                    if max(at_start, at_end) > 0.0:
                        break
                else:
                    break
                if at_start <= 0.0:
                    t += (dt - t) * at_start / (at_start - at_end)
                phi, speed, moving = 0.0, 0.0, True

            # a hop from the base must not end within its first step
            pull = -net(0.0, t, side) if phi == 0.0 else 0.0
            longest = min(dt, 0.1 * speed / pull) if pull > 0.0 < speed else dt

            def hits(s, y):
                return y[0]

            vars(hits).update(terminal=True, direction=-1)
            piece = solve_ivp(
                lambda s, y, way=side: [y[1], net(y[0], s, way)],
                (t, dt),
                [phi, speed],
                "DOP853",
                rtol=1e-13,
                atol=1e-16,
                max_step=longest,
                events=[hits],
            )
            t, (phi, speed) = piece.t[-1], piece.y[:, -1]
            if piece.status != 1:
                break
            phi, speed = 0.0, -(ratio[side] if isinstance(ratio, dict) else ratio) * speed
            side = side if one_sided else -side
            ways = (1.0,) if one_sided else (1.0, -1.0)
            moving = speed > rest or max(net(0.0, t, way) for way in ways) > 0.0
        theta.append(side * phi if moving else 0.0)
    return np.array(theta)
