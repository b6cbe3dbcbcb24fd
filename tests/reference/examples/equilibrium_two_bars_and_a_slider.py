"""The position of rest near 60 deg, and the force of the spring."""
from two_bars import *

q, stable = printed("0.98")
print(f"expect F_k = {mp.nstr(k * (2 * a * mp.cos(q) - free), 14)} N within 1e-12")
print(stable)
