"""Harmonics of a piston: its force from the second derivative of the closed-form path, quadrature of 30 digits."""
from printing import *

r, l, m, w = mpf("0.1"), mpf("0.35"), mpf("2.14"), 1500 * 2 * pi / 60


def rate(q):
    return -r * mp.sin(q) - r**2 * mp.sin(q) * mp.cos(q) / mp.sqrt(l**2 - (r * mp.sin(q)) ** 2)


def force(q):
    u = mp.sqrt(l**2 - (r * mp.sin(q)) ** 2)
    second = -r * mp.cos(q) - r**2 * mp.cos(2 * q) / u - r**4 * (mp.sin(q) * mp.cos(q)) ** 2 / u**3
    return -m * w**2 * second


def term(f, n):
    """Equally spaced samples: their sum is exact to (r/l)^N."""
    angles = [2 * pi * k / 128 for k in range(128)]
    return [sum(f(q) * g(n * q) for q in angles) / 64 for g in (mp.cos, mp.sin)]


def lines(name, f, orders, unit):
    for n in orders:
        c, s = term(f, n)
        within = "1e-11" if n == 6 else "1e-12"
        print(f"expect fourier({name}, {n}).amplitude = {mp.nstr(mp.hypot(c, s), 14)} {unit} within {within}")


lines("F", force, (1, 2, 4, 6), "N")
# the torque moves the piston against its inertia force: M + F x' = 0
lines("M", lambda q: -force(q) * rate(q), (1, 2, 3), "N*m")
