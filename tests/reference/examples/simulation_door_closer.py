"""A door, a spring with oil: one equation for the angle, the moment of the tube's force about the hinge."""
from dynamics import *

inertia, k, free, damping = 1.6 + 22.0 * 0.45 ** 2, 600.0, 0.33, 1500.0


def scene(_, q):
    x, y = point(Jet(0.0), Jet(0.0), q[0], (0.45, 0.06))
    length = sqrt((x - 0.1) * (x - 0.1) + (y + 0.08) * (y + 0.08))
    return [(inertia, q[0], 0.0), (0.0, length, -k * (length.a - free) - damping * length.b)]


f = rates(scene)
h = 1e-6
events = [
    ("end", lambda _, y: y[0] - math.radians(5)),
    ("half", lambda _, y: y[0] - math.radians(45)),
    ("fastest", lambda t, y: f(t, y)[1]),
]
t, y, found = integrate(f, [math.radians(90), 0.0], 0.0, 30.0, 0.001, events=events, stop="end")
key("time(shut)", t, "s", "1e-10")
key("time(half)", found["half"][0][0], "s", "1e-10")
key("omega(door)", y[1], "rad/s", "1e-10", " at event end")
key("min(omega(door))", min(s[1] for _, s in [*found["fastest"], (t, y)]), "rad/s", "1e-10")
key("kinetic_energy()", 0.5 * inertia * y[1] ** 2, "J", "1e-9", " at event end")
