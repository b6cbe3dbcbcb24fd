"""A double pendulum of two points by Lagrange's equations."""
from dynamics import *

g = 9.81


def f(_, y):
    a, b, u, v = y
    c, s = math.cos(a - b), math.sin(a - b)
    # 2 a'' + c b'' = -s b'^2 - 2 g cos a, c a'' + b'' = s a'^2 - g cos b
    p, q = -s * v * v - 2.0 * g * math.cos(a), s * u * u - g * math.cos(b)
    det = 2.0 - c * c
    return [u, v, (p - c * q) / det, (2.0 * q - c * p) / det]


t, y, _ = integrate(f, [0.0, math.pi / 2, 0.0, 0.0], 0.0, 3.0, 0.01)
for text, x, unit in zip(("angle(one)", "angle(two)", "omega(one)", "omega(two)"), y, ("rad", "rad", "rad/s", "rad/s")):
    key(text, x, unit, "1e-9", " at event end", places=11)
