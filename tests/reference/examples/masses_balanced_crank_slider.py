"""A crank-slider with a counterweight: each mass times the second derivative of its own closed-form path."""
from printing import *

r, l, w = mpf("0.08"), mpf("0.32"), 900 * 2 * pi / 60
paths = [
    (mpf("1.4"), lambda q: (r * mp.cos(q), r * mp.sin(q))),
    (mpf("1.8"), lambda q: (-mpf("0.12") * mp.cos(q), -mpf("0.12") * mp.sin(q))),
    (mpf("2.1"), lambda q: (r * mp.cos(q) + mp.sqrt(l ** 2 - (r * mp.sin(q)) ** 2), mpf(0))),
]
q = pi / 3
x, y = (-sum(m * w ** 2 * mp.diff(lambda t: at(t)[k], q, 2) for m, at in paths) for k in (0, 1))
print(f"expect F_s = ({mp.nstr(x, 14)} N, {mp.nstr(y, 14)} N) within 1e-12")
