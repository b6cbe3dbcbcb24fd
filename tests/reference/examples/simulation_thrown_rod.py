"""A thrown rod: the mass centre on a parabola, the rod turns evenly; the first root of the height of an end by bisection."""
from printing import *

g, l, w = mpf("9.81"), mpf("0.8"), mpf(12)
x, y = lambda t: 4 * t, lambda t: mpf("1.5") + 6 * t - g * t * t / 2


def end(t, sign):
    c, s = mp.cos(w * t), mp.sin(w * t)
    r = sign * l / 2
    return x(t) + r * c, y(t) + r * s, 4 - w * r * s, 6 - g * t + w * r * c


def lands(sign):
    steps = 4000
    for i in range(steps):
        a, b = mpf(2 * i) / steps, mpf(2 * i + 2) / steps
        if end(a, sign)[1] > 0 >= end(b, sign)[1]:
            for _ in range(100):
                c = (a + b) / 2
                a, b = (c, b) if end(c, sign)[1] > 0 else (a, c)
            return a


xb, yb, vx, vy = end(mpf("0.5"), 1)
print(f"expect position(rod.B) = ({mp.nstr(xb, 14)} m, {mp.nstr(yb, 14)} m) within 1e-12 at time = 0.5 s")
print(f"expect velocity(rod.B) = ({mp.nstr(vx, 14)} m/s, {mp.nstr(vy, 14)} m/s) within 1e-12 at time = 0.5 s")
assert lands(1) < lands(-1)
print(f"expect time(b_lands) = {mp.nstr(lands(1), 14)} s within 1e-12")
