"""A level rod: moments about its hinge at a small angle, with the spring and the damper upright."""
from printing import *

l, m, k, length, c, at = mpf("0.9"), mpf(3), mpf(800), mpf("0.3"), mpf(40), mpf("0.6")
free, g = mpf("0.31839375"), mpf("9.81")


def moment(q):
    x, y = l * mp.cos(q), l * mp.sin(q)
    d = mp.hypot(x - l, y + length)
    pull = k * (d - free)
    return -m * g * l / 2 * mp.cos(q) + pull * ((l - x) * -y + (-length - y) * x) / d


inertia = m * l ** 2 / 3
omega = mp.sqrt(-mp.diff(moment, mpf(0)) / inertia)
zeta = c * at ** 2 / (2 * inertia * omega)
print(f"expect omega_0 = {mp.nstr(omega, 14)} rad/s within 1e-12")
print(f"expect zeta = {mp.nstr(zeta, 14)} within 1e-12")
print(f"expect omega_d = {mp.nstr(omega * mp.sqrt(1 - zeta ** 2), 14)} rad/s within 1e-12")
