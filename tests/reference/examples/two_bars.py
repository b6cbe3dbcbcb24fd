"""Two bars of equal length with a slider: V = P a sin q + k (2 a cos q - x0)^2 / 2."""
from printing import *

a, load, k, free = mpf("0.3"), mpf(200), mpf(2000), mpf("0.3")


def slope(q):
    return load * a * mp.cos(q) - k * (2 * a * mp.cos(q) - free) * 2 * a * mp.sin(q)


def printed(near):
    q = mp.findroot(slope, mpf(near))
    print(f"expect theta = {mp.nstr(mp.degrees(q), 14)} deg within 1e-12")
    stable = "expect stable()" if mp.diff(slope, q) > 0 else "expect not stable()"
    return q, stable
