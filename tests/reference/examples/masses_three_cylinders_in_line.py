"""Three pistons in line: accelerations from the closed form of the piston, and Fourier integrals of the couple by the midpoint sum."""
from printing import *

r, l, m, z = mpf("0.06"), mpf("0.21"), mpf("2.5"), mpf("0.25")
omega = 1800 * 2 * pi / 60


def a(phi):
    c, s = mp.cos(phi), mp.sin(phi)
    w = mp.sqrt(l**2 - r**2 * s**2)
    return -(omega**2) * (r * c + r**2 * (c**2 - s**2) / w + r**4 * s**2 * c**2 / w**3)


def couple(phi):
    return -sum(k * z * m * a(phi + i * 2 * pi / 3) for i, k in enumerate((-1, 0, 1)))


def force(phi):
    return -sum(m * a(phi + i * 2 * pi / 3) for i in range(3))


def harmonic(f, n, steps=256):
    at = [(2 * i + 1) * pi / steps for i in range(steps)]
    c = 2 * sum(f(t) * mp.cos(n * t) for t in at) / steps
    s = 2 * sum(f(t) * mp.sin(n * t) for t in at) / steps
    return mp.hypot(c, s), mp.degrees(mp.atan2(s, c))


print(f"expect rocking_couple().y = {mp.nstr(couple(pi / 6), 14)} N*m within 1e-12 at shaft = 30 deg")
for n in (1, 2, 4):
    size, phase = harmonic(couple, n)
    within = "1e-11" if n == 4 else "1e-12"
    print(f"expect fourier(rocking_couple().y, {n}).amplitude = {mp.nstr(size, 14)} N*m within {within}")
    if n < 4:
        print(f"expect fourier(rocking_couple().y, {n}).phase = {int(mp.nint(phase))} deg within 1e-10 deg")
for n in (1, 2):
    print(f"expect fourier(shaking_force().x, {n}).amplitude = 0 N within 1e-8 N")
print(f"expect fourier(shaking_force().x, 6).amplitude = {mp.nstr(harmonic(force, 6)[0], 14)} N within 1e-9")
