"""A bar between its weight and a spring: where the potential energy is least."""
from printing import *

m, g, l, h, k, free = mpf(4), mpf("9.81"), mpf(1), mpf("1.2"), mpf(60), mpf("0.4")


def length(q):
    return mp.sqrt(l ** 2 + h ** 2 - 2 * l * h * mp.sin(q))


def slope(q):
    return mp.cos(q) * (m * g * l / 2 - k * (length(q) - free) * l * h / length(q))


q = mp.findroot(slope, mpf("1.1"))
print(f"expect theta = {mp.nstr(mp.degrees(q), 14)} deg within 1e-12")
print(f"expect l_k = {mp.nstr(length(q), 14)} m within 1e-12")
if mp.diff(slope, q) > 0:
    print("expect stable()")
