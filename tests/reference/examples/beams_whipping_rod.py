"""A uniform connecting rod that only its ends hold across its axis: its bending moment is that of a beam under m a across it."""
from printing import *

r, l, m, omega = mpf("0.1"), mpf("0.4"), mpf(3), 1200 * 2 * mp.pi / 60
q = mp.radians(75)
a = (r * mp.cos(q), r * mp.sin(q))
phi = mp.asin(-a[1] / l)
# the piston stays on the x axis: r sin q + l sin phi = 0
rate = -r * omega * mp.cos(q) / (l * mp.cos(phi))
gain = (r * omega**2 * mp.sin(q) + l * rate**2 * mp.sin(phi)) / (l * mp.cos(phi))
start = (-omega**2 * a[0], -omega**2 * a[1])
across = (-mp.sin(phi), mp.cos(phi))
# accelerations across the rod: of A, and what is added per length
first, more = start[0] * across[0] + start[1] * across[1], gain
load = lambda x: -m / l * (first + more * x)
left = -(load(mpf(0)) / 2 + (load(l) - load(mpf(0))) / 6) * l
Q = lambda x: left - m / l * (first * x + more * x * x / 2)
M = lambda x: left * x - m / l * (first * x**2 / 2 + more * x**3 / 6)
x = mp.findroot(Q, mpf("0.17"))
cut = lambda value: digits(mpf(mp.nstr(value, 14)))
print(f"expect min(internal(rod).M) = {cut(M(x))} N*m within 1e-12")
print(f"expect argmin(internal(rod).M) = {cut(1000 * x)} mm within 1e-12")
print(f"expect internal(rod, {cut(1000 * x)} mm).Q = 0 N within 1e-6 N")
print(f"expect internal(rod, 0 m).Q = {cut(left)} N within 1e-12")
