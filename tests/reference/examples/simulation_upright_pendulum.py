"""A pendulum on a support that is shaken up and down; force of the support's drive from both masses."""
from dynamics import *

a, w, L, g, m, J, m_0 = 0.02, 200.0, 0.5, 9.81, 1.0, 0.01, 0.2


def support(t):
    return -a * w * w * math.cos(w * t)


def f(t, y):
    return [y[1], -m * L * math.cos(y[0]) * (g + support(t)) / (m * L * L + J)]


def force(t, y):
    turning = f(t, y)[1]
    rise = L * (math.cos(y[0]) * turning - math.sin(y[0]) * y[1] ** 2)
    return m_0 * (g + support(t)) + m * (g + support(t) + rise)


t, y, found = integrate(f, [math.radians(80), 0.0], 0.0, 0.5, 1e-3, events=[("upright", lambda _, y: y[0] - math.pi / 2)])
key("time(upright)", found["upright"][0][0], "s", "1e-9")
key("angle(bob)", y[0], "rad", "1e-9", " at time = 0.5 s")
key("omega(bob)", y[1], "rad/s", "1e-8", " at time = 0.5 s")
key("effort(G)", force(t, y), "N", "1e-8", " at time = 0.5 s")
t, y, _ = integrate(f, y, t, 1.0, 1e-3)
key("angle(bob)", y[0], "rad", "1e-9", " at event end")
key("omega(bob)", y[1], "rad/s", "1e-8", " at event end")
key("effort(G)", force(t, y), "N", "1e-8", " at event end")
