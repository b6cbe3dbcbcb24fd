"""Two parallelograms of equal bars: their cranks move as one pendulum."""
from dynamics import *

n = 2
k = 9.81 * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)


def f(_, y):
    return [y[1], -k * math.cos(y[0])]


t, y = 0.0, [math.pi / 2, -1.0]
t, y, found = integrate(f, y, t, 5.0, 0.01, events=[("level", lambda _, y: y[0] + math.pi)])
key("time(level)", found["level"][0][0], "s", "1e-9")
key("angle(r0)", y[0], "rad", "1e-9", " at time = 5 s")
key("omega(r2)", y[1], "rad/s", "1e-9", " at time = 5 s")
_, y, _ = integrate(f, y, t, 10.0, 0.01)
key("angle(r0)", y[0], "rad", "1e-9", " at event end")
key("angle(r2)", y[0], "rad", "1e-9", " at event end")
key("omega(r0)", y[1], "rad/s", "1e-9", " at event end")
key("angle(c2)", 0.0, "rad", "1e-9 rad", " at event end")
