"""A released rod: the part beyond a cut falls with the accelerations of its elements."""
from printing import *

m, l, g = mpf(6), mpf("1.5"), mpf("9.81")
alpha = 3 * g / (2 * l)
# Q = dM/dx, and M of the part beyond x: the integral of (s - x) m/l (g - alpha s)
M = lambda x: -mp.quad(lambda s: (s - x) * m / l * (g - alpha * s), [x, l])
Q = lambda x: mp.quad(lambda s: m / l * (g - alpha * s), [x, l])
cut = lambda value: digits(mpf(mp.nstr(value, 14)))
place, steepest = l / 3, g / alpha
print("expect effort(rod) = 0 N*m within 1e-12 N*m")
print(f"expect internal(rod, 0 m).Q = {cut(Q(mpf(0)))} N within 1e-12")
print(f"expect min(internal(rod).Q) = {cut(Q(steepest))} N within 1e-12")
print(f"expect argmin(internal(rod).Q) = {cut(steepest)} m within 1e-12")
print(f"expect max(internal(rod).M) = {cut(M(place))} N*m within 1e-12")
print(f"expect argmax(internal(rod).M) = {cut(place)} m within 1e-12")
print(f"expect internal(rod, 0.75 m).M = {cut(M(l / 2))} N*m within 1e-12")
