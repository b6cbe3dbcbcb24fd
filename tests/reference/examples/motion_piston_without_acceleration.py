"""A piston x = r cos q + sqrt(l^2 - r^2 sin^2 q): the roots of its second derivative, by Newton's method."""
from printing import *

r, l, w = mpf("0.1"), mpf("0.35"), 1500 * 2 * pi / 60
x = lambda q: r * mp.cos(q) + mp.sqrt(l**2 - (r * mp.sin(q)) ** 2)
q = mp.findroot(lambda q: mp.diff(x, q, 2), mp.radians(75))
v = w * mp.diff(x, q)
print(f"expect drive(turns) = {mp.nstr(mp.degrees(q), 14)} deg within 1e-13")
print(f"expect drive(turns, 2) = {mp.nstr(360 - mp.degrees(q), 14)} deg within 1e-13")
print(f"expect velocity(C).x = {mp.nstr(v, 14)} m/s within 1e-13 at event turns")
print(f"expect velocity(C).x = {mp.nstr(-v, 14)} m/s within 1e-13 at event turns 2")
print("expect count(turns) = 2")
