"""Counterweights in two planes: the two equations of forces and couples along each axis, solved by Cramer's rule."""
from printing import *

masses = [(200, "0.08", 0, "0"), (300, "0.07", 45, "0.3"), (400, "0.06", 115, "0.4"), (200, "0.08", 235, "0.7")]
z1, z2, radius = mpf("0.1"), mpf("0.5"), mpf("0.1")
found = []
for f in (mp.cos, mp.sin):
    of = [(m * mpf(r) * f(mp.radians(angle)), mpf(z)) for m, r, angle, z in masses]
    force, couple = -sum(u for u, z in of), -sum(u * z for u, z in of)
    found.append(((force * z2 - couple) / (z2 - z1), (couple - force * z1) / (z2 - z1)))
for name, x, y in zip("XY", *found):
    print(f"expect mass({name}) = {mp.nstr(mp.hypot(x, y) / radius, 14)} kg within 1e-12")
    print(f"expect angle({name}) = {mp.nstr(mp.degrees(mp.atan2(y, x)), 14)} deg within 1e-12")
print("expect mag(shaking_force()) = 0 N within 1e-9 N")
print("expect mag(rocking_couple()) = 0 N*m within 1e-9 N*m")
print("expect mag(rocking_couple(250 mm)) = 0 N*m within 1e-9 N*m")
