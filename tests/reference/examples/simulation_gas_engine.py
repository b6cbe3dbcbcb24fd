"""A crank-slider under a given pressure: speed and time over the angle of the crank, from row to row of the table."""
from dynamics import *

rows = [(0, 3.2), (15, 4.6), (40, 2.4), (90, 0.8), (140, 0.35), (180, 0.12), (360, 0.1), (380, 0.09), (540, 0.09), (630, 0.25), (690, 1.1), (720, 3.2)]
at = [math.radians(x) for x, _ in rows]
p = [1e6 * y for _, y in rows]
n = len(rows) - 1
steps = [b - a for a, b in zip(at, at[1:])]
secants = [(b - a) / h for a, b, h in zip(p, p[1:], steps)]


def middle(k):
    """Slope at a row: the weighted harmonic mean of both secants where they have one sign (Fritsch and Butland)."""
    (d0, h0), (d1, h1) = (secants[k - 1], steps[k - 1]), (secants[k], steps[k])
    if d0 * d1 <= 0.0:
        return 0.0
    w = (1.0 + h1 / (h0 + h1)) / 3.0
    return d0 * d1 / (w * d1 + (1.0 - w) * d0)


slopes = [middle(k) for k in range(n)]
slopes.append(slopes[0])
area, r, l = math.pi / 4 * 0.01, 0.06, 0.22


def pressure(k, phi):
    h, x = steps[k], (phi - at[k]) / steps[k]
    return (p[k] * (1 + 2 * x) + h * slopes[k] * x) * (1 - x) ** 2 + (p[k + 1] * (3 - 2 * x) - h * slopes[k + 1] * (1 - x)) * x * x


def parts(phi):
    b = (cos(phi) * r, sin(phi) * r)
    psi = atan2(-b[1], sqrt(l * l - b[1] * b[1]))
    return psi, point(*b, psi, (0.07, 0.0)), b[0] + cos(psi) * l


def over_angle(k, turn):
    """Time, speed and work of the gas over the angle."""
    def of(phi, y):
        w = y[1]
        psi, (sx, sy), c = parts(Jet(phi, w))
        gas = -(pressure(k, phi - turn) - 1e5) * area
        terms = [(0.9, Jet(phi, w), -0.4 * w), (1.4, sx, 0.0), (1.4, sy, 0.0), (0.009, psi, 0.0), (1.1, c, gas)]
        unit = [1.0 if i == 0 else s.b / w for i, (_, s, _) in enumerate(terms)]
        alpha = sum((f - m * s.c) * u for (m, s, f), u in zip(terms, unit)) / sum(m * u * u for (m, _, _), u in zip(terms, unit))
        return [1.0 / w, alpha / w, gas * c.b / w, 0.0]
    return of


y, extremes = [0.0, 1400 * math.pi / 30, 0.0, 0.0], []
for cycle in (0, 1):
    turn = 4.0 * math.pi * cycle
    for k in range(n):
        f = over_angle(k, turn)
        rate = lambda phi, y: f(phi, y)[1]
        _, y, found = integrate(f, y, turn + at[k], turn + at[k + 1], 0.05, events=[("extreme", rate)])
        extremes += [s[1] for _, s in found["extreme"]]
    key("omega(crank)", y[1], "rad/s", "1e-11", [" at event cycle", " at event end"][cycle])
    key(["time(cycle)", "time(done)"][cycle], y[0], "s", "1e-11")
key("max(omega(crank))", max(extremes), "rad/s", "1e-11")
key("min(omega(crank))", min(extremes), "rad/s", "1e-11")
key("integral(power(Q))", y[2], "J", "1e-11")
