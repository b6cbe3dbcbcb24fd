"""A V-twin: both pistons along their lines by the closed-form path, equally spaced samples of 30 digits."""
from printing import *

r, l, m, w = mpf("0.075"), mpf("0.3"), mpf("11.5"), 500 * 2 * pi / 60


def along(q):
    u = mp.sqrt(l**2 - (r * mp.sin(q)) ** 2)
    return m * w**2 * (r * mp.cos(q) + r**2 * mp.cos(2 * q) / u + r**4 * (mp.sin(q) * mp.cos(q)) ** 2 / u**3)


def force(q, k):
    lines = (pi / 4, 3 * pi / 4)
    return sum(along(q - line) * (mp.cos(line), mp.sin(line))[k] for line in lines)


def amplitude(k, n):
    angles = [2 * pi * i / 128 for i in range(128)]
    c, s = (sum(force(q, k) * g(n * q) for q in angles) / 64 for g in (mp.cos, mp.sin))
    return mp.hypot(c, s)


for k, n in ((0, 1), (1, 1), (0, 2)):
    print(f"expect fourier(F.{'xy'[k]}, {n}).amplitude = {mp.nstr(amplitude(k, n), 14)} N within 1e-12")
