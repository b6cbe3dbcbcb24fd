"""A bar that swings about its equilibrium: the curvature of the potential energy over the moment of inertia."""
from printing import *

m, g, l, h, k, free = mpf(4), mpf("9.81"), mpf(1), mpf("1.2"), mpf(60), mpf("0.4")


def slope(q):
    length = mp.sqrt(l ** 2 + h ** 2 - 2 * l * h * mp.sin(q))
    return mp.cos(q) * (m * g * l / 2 - k * (length - free) * l * h / length)


q = mp.findroot(slope, mpf("1.1"))
curvature = mp.diff(slope, q)
print(f"expect omega_0 = {mp.nstr(mp.sqrt(curvature / (m * l ** 2 / 3)), 14)} rad/s within 1e-12")
if curvature > 0:
    print("expect stable()")
