"""A bar on a slide that is pushed with a given acceleration: one equation, and Newton's second law for both."""
from dynamics import *

g, m, m_slide, s, j, a = 9.81, 1.0, 3.0, 0.3, 0.03, 3.0


def f(_, y):
    return [y[1], -m * s * (g * math.cos(y[0]) - a * math.sin(y[0])) / (j + m * s * s)]


def force(t, y):
    return (m_slide + m) * a + m * s * (-math.sin(y[0]) * f(t, y)[1] - math.cos(y[0]) * y[1] ** 2)


def force_rate(t, y):
    h = 1e-4
    return force(t + h, extrapolated(f, t, y, h)[0]) - force(t - h, extrapolated(f, t, y, -h)[0])


events = [("turns", lambda _, y: y[1]), ("extreme", force_rate)]
t, y, found = integrate(f, [-math.pi / 2, 0.5], 0.0, 2.0, 0.01, events=events)
key("time(turns)", found["turns"][0][0], "s", "1e-10")
key("time(turns, 2)", found["turns"][1][0], "s", "1e-10")
key("max(angle(bar))", found["turns"][0][1][0], "rad", "1e-10")
key("min(angle(bar))", found["turns"][1][1][0], "rad", "1e-10")
key("max(F)", max(force(*e) for e in found["extreme"]), "N", "1e-10")
key("angle(bar)", y[0], "rad", "1e-10", " at event end")
key("omega(bar)", y[1], "rad/s", "1e-10", " at event end")
key("F", force(t, y), "N", "1e-10", " at event end")
