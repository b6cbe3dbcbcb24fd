"""A flat follower on an eccentric: one equation, and Newton's second law for the follower's contact force."""
from dynamics import *

g, e, radius, m, disc, j, k, free, top, torque = 9.81, 0.012, 0.04, 1.0, 3.0, 0.004, 400.0, 0.14, 0.16, 0.9


def scene(_, q):
    x, y = cos(q[0]) * e, sin(q[0]) * e
    lift = y + radius
    spring = -k * (free - (top - lift.a))
    return [*weight(disc, x, y, g), (j, q[0], torque), (m, lift, spring - m * g)]


f = rates(scene)


def normal(t, y):
    phi, w, a = y[0], y[1], f(t, y)[1]
    s = radius + e * math.sin(phi)
    up = e * (math.cos(phi) * a - math.sin(phi) * w * w)
    return m * (up + g) + k * (free - (top - s))


def rate(t, y):
    h = 1e-5
    return normal(t + h, extrapolated(f, t, y, h)[0]) - normal(t - h, extrapolated(f, t, y, -h)[0])


y = [math.radians(20.0), 0.0]
t, y, found = integrate(f, y, 0.0, 0.5, 0.01, events=[("lift", normal), ("extreme", rate)], stop="lift")
key("time(lift)", t, "s", "1e-10")
key("angle(disc)", y[0], "rad", "1e-10", " at event lift")
key("omega(disc)", y[1], "rad/s", "1e-10", " at event end")
key("alpha(disc)", f(t, y)[1], "rad/s^2", "1e-9", " at event end")
key("max(normal(K, follower))", max(normal(*u) for u in found["extreme"]), "N", "1e-10")
