"""A rod between two guides: its angle moves as a pendulum, angle'' = -k cos(angle)."""
from dynamics import *

k = 3.0 * 9.81 / 2.0


def f(_, y):
    return [y[1], -k * math.cos(y[0])]


events = [("level", lambda _, y: y[0]), ("rest", lambda _, y: y[1])]
_, y, found = integrate(f, [math.radians(80), 0.0], 0.0, 4.0, 0.01, events=events)
key("time(level)", found["level"][0][0], "s", "1e-10")
key("time(level, 2)", found["level"][1][0], "s", "1e-10")
key("time(back)", found["rest"][1][0], "s", "1e-10")
key("angle(rod)", y[0], "rad", "1e-10", " at event end")
key("omega(rod)", y[1], "rad/s", "1e-9", " at event end", places=10)
