"""A press in its steady turn: three parts of a turn, with and without the work piece; a secant on the speed at its begin."""
from dynamics import *

r, l, s, j, m_rod, j_rod, m_ram = 0.1, 0.35, 0.117, 6.0, 2.5, 0.0425, 12.0


def ram(q):
    y = sin(q) * r
    return cos(q) * r + sqrt(l * l - y * y)


def rates_under(force):
    def f(_, y):
        def terms(phi):
            x, up = cos(phi) * r, sin(phi) * r
            rod = atan2(-up, sqrt(l * l - up * up))
            sx, sy = point(x, up, rod, (s, 0.0))
            return [(j, phi, 450.0 - 20.0 * y[1]), (m_rod, sx, 0.0), (m_rod, sy, 0.0), (j_rod, rod, 0.0), (m_ram, ram(phi), -force)]
        all_terms, unit = terms(Jet(y[0], y[1])), terms(Jet(y[0], 1.0))
        mass = sum(m * u.b * u.b for m, u, _ in unit)
        return [y[1], sum((p - m * x.c) * u.b for (m, x, p), (_, u, _) in zip(all_terms, unit)) / mass]
    return f


free, pressed = rates_under(0.0), rates_under(30e3)
# where the ram comes to 430 mm on its way out, and where it turns
low, high = 1.5 * math.pi, 2.0 * math.pi
for _ in range(100):
    middle = 0.5 * (low + high)
    low, high = (middle, high) if ram(Jet(middle)).a < 0.43 else (low, middle)
touch, dead, end = low, 2.0 * math.pi, 2.5 * math.pi


def turn(w):
    t, y, speeds = 0.0, [0.5 * math.pi, w], []
    for f, until in ((free, touch), (pressed, dead), (free, end)):
        events = [("there", lambda _, y, until=until: y[0] - until), ("extreme", lambda t, y, f=f: f(t, y)[1])]
        t, y, found = integrate(f, y, t, t + 1.0, 1e-3, events=events, stop="there")
        speeds += [y[1], *(u[1] for _, u in found["extreme"])]
        y[0] = until
    return y[1], t, speeds


w, before = 17.0, None
for _ in range(12):
    gap = turn(w)[0] - w
    if before is None:
        step = gap
    elif gap == before[1] or abs(gap) < 1e-14:
        break
    else:
        step = -gap * (w - before[0]) / (gap - before[1])
    before, w = (w, gap), w + step
_, period, speeds = turn(w)
key("period()", period, "s", "1e-11")
key("max(omega(crank))", max(speeds), "rad/s", "1e-11")
key("min(omega(crank))", min(speeds), "rad/s", "1e-11")
key("omega(crank)", w, "rad/s", "1e-11", " at event begin")
key("work(P)", -30e3 * 0.02, "J", "1e-11", " at event end")
