"""A bar whose hinge is led along a circle: one equation, with the acceleration of the hinge as a second weight."""
from dynamics import *

g, radius, w, mass, s, inertia = 9.81, 0.05, 12.0, 1.2, 0.25, 0.02


def f(t, y):
    # the hinge at radius (cos w t, sin 2 w t)
    ax, ay = -radius * w * w * math.cos(w * t), -radius * 4.0 * w * w * math.sin(2.0 * w * t)
    a, v = y
    return [v, -mass * s * ((g + ay) * math.cos(a) - ax * math.sin(a)) / (inertia + mass * s * s)]


t, y, found = integrate(f, [math.radians(-90), 0.0], 0.0, 2.0, 0.005, events=[("stands", lambda _, y: y[1])])
for k in (0, 1):
    key(f"time(stands{', 2' if k else ''})", found["stands"][k][0], "s", "1e-10", places=11)
key("angle(bar)", y[0], "rad", "1e-10", " at event end", places=11)
key("omega(bar)", y[1], "rad/s", "1e-10", " at event end", places=11)
x = radius * math.cos(w * t) + 0.5 * math.cos(y[0])
z = radius * math.sin(2.0 * w * t) + 0.5 * math.sin(y[0])
key("position(E)", (x, z), "m", "1e-10", " at event end", places=11)
