"""Four masses on a rotor: the sum of their first moments, and the mass that cancels it."""
from printing import *

parts = [(200, "0.2", 0), (300, "0.15", 45), (240, "0.25", 120), (260, "0.3", 255)]
x = sum(m * mpf(r) * mp.cos(mp.radians(a)) for m, r, a in parts)
y = sum(m * mpf(r) * mp.sin(mp.radians(a)) for m, r, a in parts)
size = mp.hypot(x, y)
print(f"expect m_b = {mp.nstr(size / mpf('0.2'), 14)} kg within 1e-12")
print(f"expect theta_b = {mp.nstr(mp.degrees(mp.atan2(-y, -x)) + 360, 14)} deg within 1e-12")
print(f"expect R_O = {mp.nstr(size * 100, 14)} N within 1e-12")
