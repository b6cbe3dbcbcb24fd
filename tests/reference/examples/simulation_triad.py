"""A plate on three legs: its place from the lengths of the legs by Newton's method, rates from the same equations."""
from dynamics import *

g = 9.81
Q, R, T = (0.42, 0.03), (0.16, 0.5), (0.4, 0.4)
legs = ((0.19, (0.0, 0.0)), (0.22, (0.24, 0.0)), (0.17, (0.1, 0.16)))
near = [0.08, 0.2, 0.0]


def gaps(crank, u):
    """Squares of the distances between the ends of each leg, less those of their lengths."""
    feet = ((cos(crank) * 0.05, sin(crank) * 0.05), Q, R)
    tops = [point(*u, at) for _, at in legs]
    return [(p[0] - f[0]) * (p[0] - f[0]) + (p[1] - f[1]) * (p[1] - f[1]) + -l * l for (l, _), f, p in zip(legs, feet, tops)], feet, tops


def plate(crank):
    """Place and angle with their rates, from a crank with its rates."""
    still = lambda x: Jet(x)
    for _ in range(30):
        units = [[Jet(x, float(i == j)) for j, x in enumerate(near)] for i in range(3)]
        columns = [[e.b for e in gaps(Jet(crank.a), u)[0]] for u in units]
        rows = [list(row) for row in zip(*columns)]
        step = solve(rows, [-e.a for e in gaps(Jet(crank.a), [still(x) for x in near])[0]])
        near[:] = [x + s for x, s in zip(near, step)]
        if max(map(abs, step)) < 1e-14:
            break
    first = solve(rows, [-e.b for e in gaps(crank, [still(x) for x in near])[0]])
    second = solve(rows, [-e.c for e in gaps(crank, [Jet(x, v) for x, v in zip(near, first)])[0]])
    return [Jet(*of) for of in zip(near, first, second)]


def scene(_, q):
    crank = q[0]
    u = plate(crank)
    _, feet, tops = gaps(crank, u)
    terms = [(0.006, crank, 2.0 - 0.05 * crank.b), *weight(2.2, *point(*u, (0.11, 0.05)), g), (0.016, u[2], 0.0)]
    for foot, top, m, j in zip(feet, tops, (0.6, 0.7, 0.5), (0.002, 0.003, 0.0015)):
        terms += weight(m, (top[0] + foot[0]) * 0.5, (top[1] + foot[1]) * 0.5, g)
        terms.append((j, atan2(top[1] - foot[1], top[0] - foot[0]), 0.0))
    ex, ey = point(*u, (0.2, 0.12))
    length = sqrt((ex - T[0]) * (ex - T[0]) + (ey - T[1]) * (ey - T[1]))
    return [*terms, (0.0, length, -300.0 * (length.a - 0.15) - 4.0 * length.b)]


f = rates(scene)
# of the two assemblies the one near these places
t, y = 0.0, [math.radians(20), 0.0]
for end in (0.1, 0.2):
    t, y, _ = integrate(f, y, t, end, 0.005, tolerance=1e-13)
    u = plate(Jet(y[0], y[1], f(t, y)[1]))
    tail = f" at time = {end} s"
    key("angle(crank)", y[0], "rad", "1e-10", tail, places=11)
    key("omega(crank)", y[1], "rad/s", "1e-10", tail, places=11)
    key("angle(plate)", u[2].a, "rad", "1e-10", tail, places=11)
    key("omega(plate)", u[2].b, "rad/s", "1e-10", tail, places=11)
    key("alpha(plate)", u[2].c, "rad/s^2", "1e-9", tail, places=10)
