"""Jerks of a shaper's lever and of the block in its slot, by logarithms of complex numbers."""
from cmath import exp, log, pi

# the pin of the crank, seen from the lever's pivot, is z = r e^(i theta); w = z'/z = (ln r)' + i theta'
a, height, length, omega = 0.1, 0.25, 0.45, 6 * pi
rows = []
for k in range(12):
    spin = a * exp(1j * (2 + 3 * k) * pi / 18)
    z = spin + 1j * height
    z1, z2, z3 = (spin * (1j * omega) ** n for n in (1, 2, 3))
    w = z1 / z
    w1 = z2 / z - w * w
    w2 = z3 / z - 3 * w * w1 - w ** 3
    theta, r = log(z).imag, abs(z)
    # e^(i theta) differentiated three times, and r = e^(Re ln z)
    v, v1, v2 = 1j * w.imag, 1j * w1.imag, 1j * w2.imag
    point = length * exp(1j * theta) * (v2 + 3 * v * v1 + v ** 3)
    u, u1, u2 = w.real, w1.real, w2.real
    rows.append((w2.imag, r * (u2 + 3 * u * u1 + u ** 3), point))


def keys(name, values, unit, within):
    print(f"expect {name} = " + ", ".join(f"{x!r} {unit}" for x in values) + f" within {within} {unit}")


keys("angular_jerk(lever)", [row[0] for row in rows], "rad/s^3", "1e-7")
keys("jerk(s)", [row[1] for row in rows], "m/s^3", "1e-8")
for k in (1, 5, 8):
    p = rows[k][2]
    print(f"expect jerk(lever.E) = ({p.real!r} m/s^3, {p.imag!r} m/s^3) within 1e-8 at pose {k + 1}")
