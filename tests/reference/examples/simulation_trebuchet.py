"""A beam, a hanging counterweight and a sling in their angles; the sling's pull from the stone's own equation."""
from dynamics import *

g = 9.81


def places(q):
    beam, hanger, sling = q
    c = (cos(beam) * -1.5, sin(beam) * -1.5)
    tip = (cos(beam) * 5.5, sin(beam) * 5.5)
    return (cos(beam) * 1.7, sin(beam) * 1.7), (c[0] + cos(hanger) * 1.2, c[1] + sin(hanger) * 1.2), \
        (tip[0] + cos(sling) * 4.5, tip[1] + sin(sling) * 4.5)


def scene(_, q):
    s, w, p = places(q)
    return [*weight(120.0, *s, g), (500.0, q[0], 0.0), *weight(2000.0, *w, g), (150.0, q[1], 0.0), *weight(15.0, *p, g)]


f = rates(scene)


def pull(t, y):
    _, _, (px, py) = places([Jet(y[i], y[3 + i], f(t, y)[3 + i]) for i in range(3)])
    return 15.0 * math.hypot(px.c, py.c + g)


def pull_rate(t, y):
    h = 1e-4
    return pull(t + h, extrapolated(f, t, y, h)[0]) - pull(t - h, extrapolated(f, t, y, -h)[0])


start = [math.radians(-130), math.radians(-90), 0.0, 0.0, 0.0, 0.0]
events = [("out", lambda _, y: y[2] + math.radians(230)), ("extreme", pull_rate)]
t, y, found = integrate(f, start, 0.0, 5.0, 0.01, tolerance=1e-13, events=events, stop="out")
_, _, (px, py) = places([Jet(y[i], y[3 + i]) for i in range(3)])
key("v", (px.b, py.b), "m/s", "1e-10", " at event end", places=11)
key("omega(beam)", y[3], "rad/s", "1e-10", " at event end", places=11)
key("angle(beam)", y[0], "rad", "1e-10", " at event end", places=11)
key("max(mag(reaction(T, sling)))", max(pull(*e) for e in [*found["extreme"], (0.0, start), (t, y)]), "N", "1e-10", places=11)
key("range", 2.0 * px.b * py.b / g, "m", "1e-10", " at event end", places=11)
