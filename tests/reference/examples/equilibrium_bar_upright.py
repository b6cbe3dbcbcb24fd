"""The same bar upright: where the potential energy is greatest."""
from printing import *

m, g, l, h, k, free = mpf(4), mpf("9.81"), mpf(1), mpf("1.2"), mpf(60), mpf("0.4")


def slope(q):
    length = mp.sqrt(l ** 2 + h ** 2 - 2 * l * h * mp.sin(q))
    return mp.cos(q) * (m * g * l / 2 - k * (length - free) * l * h / length)


q = pi / 2
print(f"expect theta = {digits(mpf(mp.nstr(mp.degrees(q), 14)))} deg within 1e-12")
if mp.diff(slope, q) < 0:
    print("expect not stable()")
