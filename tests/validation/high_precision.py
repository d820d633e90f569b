"""Independent truth: the rocking block in multi-precision arithmetic, Taylor order 24, events bisected.

Shares no code with the product. Slow (about a second per hundred samples): for tests and the chart.
"""

import mpmath as mp

ORDER = 24

BARE = ((1, 0), (1, 0))
"""A wall without loads."""


def _coefficients(phi, speed, beta, slope, p2, alpha, branch):
    """Taylor coefficients of phi; branch (sine, slope, constant) of the moment law over I0 p2."""
    s_factor, m, constant = branch
    c = [phi, speed]
    sine, cosine = [mp.sin(alpha - phi)], [mp.cos(alpha - phi)]
    for k in range(ORDER - 1):
        moment = s_factor * sine[k] + m * c[k] + (constant if k == 0 else 0)
        forcing = beta * cosine[k] + (slope * cosine[k - 1] if k else 0)
        c.append(-p2 * (moment - forcing) / ((k + 1) * (k + 2)))
        sine.append(-sum((j + 1) * c[j + 1] * cosine[k - j] for j in range(k + 1)) / (k + 1))
        cosine.append(sum((j + 1) * c[j + 1] * sine[k - j] for j in range(k + 1)) / (k + 1))
    return c


def _value(c, t):
    total = mp.mpf(0)
    for coefficient in reversed(c):
        total = total * t + coefficient
    return total


def _rate(c, t):
    return _value([k * c[k] for k in range(1, len(c))], t)


def _first_root(c, level, h, pieces=64):
    """First t in (0, h] where phi falls to (or passes) the level it started away from or on."""
    start = _value(c, h * mp.mpf(10) ** -12) - level
    previous = mp.mpf(0)
    for k in range(1, pieces + 1):
        t = h * k / pieces
        if (_value(c, t) - level) * start <= 0:
            low, high = previous, t
            if k == 1:
                low = h * mp.mpf(10) ** -12
            for _ in range(int(mp.mp.prec)):
                middle = (low + high) / 2
                if (_value(c, middle) - level) * start > 0:
                    low = middle
                else:
                    high = middle
            return (low + high) / 2
        previous = t
    return None


def history(ground, dt, alpha, p2, one_sided, ratio_of, kinks=None, gravity="9.80665", digits=30, loads=BARE):
    """Rotations at the samples [rad] and impacts [(time s, velocity before, velocity after rad/s)].

    ground, dt, alpha, p2 : exact numbers (float or mpf) [m/s2], [s], [rad], [1/s2];
    ratio_of : velocity ratio as a function of the impact speed; kinks : (phi1, phi2) or None;
    loads : (a, c) of positive and of negative rotations: the moment is a sin(alpha - phi) + c cos(alpha - phi), under a
    trilinear law beyond the plateau, whose moment it is at phi2.
    """
    with mp.workdps(digits):
        alpha, p2, dt, g = mp.mpf(alpha), mp.mpf(p2), mp.mpf(dt), mp.mpf(gravity)
        phi, speed, side, moving = mp.mpf(0), mp.mpf(0), 1, False
        levels = [mp.mpf(0)] if kinks is None else [mp.mpf(0), mp.mpf(kinks[0]), mp.mpf(kinks[1])]
        sine, cosine = ({1: mp.mpf(a), -1: mp.mpf(b)} for a, b in zip(*loads, strict=True))
        threshold = {s: mp.mpf(0) if kinks else sine[s] * mp.tan(alpha) + cosine[s] for s in (1, -1)}
        zone = 0
        rest_speed = mp.mpf("1e-6") * mp.sqrt(p2) * alpha
        rotations, impacts = [mp.mpf(0)], []
        for i in range(len(ground) - 1):
            b0, b1 = mp.mpf(ground[i]) / g, mp.mpf(ground[i + 1]) / g
            rate = (b1 - b0) / dt
            t = mp.mpf(0)
            while t < dt:
                now = b0 + rate * t
                if not moving:
                    if now > threshold[1]:
                        side = 1
                    elif now < -threshold[-1] and not one_sided:
                        side = -1
                    else:
                        t, side = _uplift(b0, rate, t, dt, threshold, one_sided)
                        if t is None:
                            break
                        now = b0 + rate * t
                    phi, speed, zone, moving = mp.mpf(0), mp.mpf(0), 0, True
                branch = _branch(zone, levels, alpha, sine[side], cosine[side])
                held = cosine[side] if branch[0] else 0
                c = _coefficients(phi, speed, side * now - held, side * rate, p2, alpha, branch)
                h = dt - t
                events = []
                lower = _first_root(c, levels[zone], h)
                if lower is not None:
                    events.append((lower, -1))
                if zone + 1 < len(levels):
                    upper = _first_root(c, levels[zone + 1], h)
                    if upper is not None:
                        events.append((upper, 1))
                if not events:
                    phi, speed, t = _value(c, h), _rate(c, h), dt
                    continue
                h, step = min(events)
                t += h
                speed = _rate(c, h)
                phi = levels[zone] if step < 0 else levels[zone + 1]
                if zone + step >= 0:
                    zone += step
                    continue
                before = side * speed
                speed = ratio_of(-speed) * -speed
                side = side if one_sided else -side
                impacts.append((i * dt + t, before, side * speed))
                now = b0 + rate * t
                lifts = now > threshold[1] or (now < -threshold[-1] and not one_sided)
                # of one that is stopped dead, the ground chooses the side again
                moving = speed > 0 and not (speed < rest_speed and not lifts)
            if not moving:
                phi, speed = mp.mpf(0), mp.mpf(0)
            rotations.append(side * phi)
        return rotations, impacts


def _branch(zone, levels, alpha, sine, cosine):
    if len(levels) == 1 or zone == 2:
        return sine, 0, 0
    plateau = sine * mp.sin(alpha - levels[2]) + cosine * mp.cos(alpha - levels[2])
    return (0, plateau / levels[1], 0) if zone == 0 else (0, 0, plateau)


def _uplift(b0, rate, t, dt, threshold, one_sided):
    if rate > 0:
        root, side = (threshold[1] - b0) / rate, 1
    elif rate < 0 and not one_sided:
        root, side = (-threshold[-1] - b0) / rate, -1
    else:
        return None, 1
    return (root, side) if t <= root < dt else (None, side)
