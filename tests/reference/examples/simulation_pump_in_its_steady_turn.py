"""A pump in its steady turn: a secant on the crank's first speed; the flywheel formula beside it.

The formula: at a constant speed the loads, reduced to the crank, leave a torque whose work swings by W; with the crank's inertia J
the speed swings by W/(J w^2) of its mean w.
"""
from dynamics import *

r, l, s, m_crank, j, m_rod, j_rod, m_piston, c = 0.1, 0.35, 0.117, 1.0, 2.0, 2.5, 0.0425, 8.0, 800.0


def scene(_, q):
    phi = q[0]
    x, y = cos(phi) * r, sin(phi) * r
    rod = sqrt(l * l - y * y)
    a = atan2(-y, rod)
    sx, sy = point(x, y, a, (s, 0.0))
    slide = x + rod
    return [(j, phi, lambda u: 300.0 - 12.0 * u), (m_rod, sx, 0.0), (m_rod, sy, 0.0), (j_rod, a, 0.0), (m_piston, slide, lambda v: -c * v)]


def f(_, y):
    """The scene's loads depend on the rates of what they act on."""
    terms = scene(0.0, [Jet(y[0], y[1])])
    unit = scene(0.0, [Jet(y[0], 1.0)])
    mass = sum(m * u.b * u.b for m, u, _ in unit)
    power = sum(((load(x.b) if callable(load) else load) - m * x.c) * u.b for (m, x, load), (_, u, _) in zip(terms, unit))
    return [y[1], power / mass]


def turn(w):
    names = [("turned", lambda _, y: y[0] - 2.0 * math.pi), ("extreme", lambda t, y: f(t, y)[1])]
    t, y, found = integrate(f, [0.0, w], 0.0, 2.0, 1e-3, tolerance=1e-13, events=names, stop="turned")
    return y[1], t, [u[1] for _, u in found["extreme"]]


w, before = 15.0, None
for _ in range(12):
    end, period, speeds = turn(w)
    gap = end - w
    if before is None:
        step = gap
    elif gap == before[1] or abs(gap) < 1e-14:
        break
    else:
        step = -gap * (w - before[0]) / (gap - before[1])
    before = (w, gap)
    w += step
end, period, speeds = turn(w)
mean = 2.0 * math.pi / period
key("period()", period, "s", "1e-9")
key("max(omega(crank))", max(speeds), "rad/s", "1e-9")
key("min(omega(crank))", min(speeds), "rad/s", "1e-9")
key("fluctuation", (max(speeds) - min(speeds)) / mean, "", "1e-9")
key("omega(crank)", w, "rad/s", "1e-9", " at event begin")

# the flywheel formula at the mean speed
n = 20000
work, works = 0.0, []
for i in range(n):
    terms = scene(0.0, [Jet(2.0 * math.pi * (i + 0.5) / n, mean)])
    torque = sum((load(x.b) if callable(load) else load) * x.b / mean - m * x.c * x.b / mean for m, x, load in terms if x.b != mean)
    works.append(torque)
average = sum(works) / n
total, least, most = 0.0, 0.0, 0.0
for torque in works:
    total += (torque - average) * 2.0 * math.pi / n
    least, most = min(least, total), max(most, total)
print(f"# flywheel formula: fluctuation {(most - least) / (j * mean * mean):.4f}")
