"""A beam with an overhang: the equilibrium of the beam, and its sections piece by piece."""
from printing import *

q, p, l, c = mpf(3), mpf(4), mpf(4), mpf(6)
b = (q * l * l / 2 + p * c) / l
a = q * l + p - b
print(f"expect reaction(A, beam) = (0 kN, {digits(a)} kN) within 1e-13")
print(f"expect reaction(B, beam) = (0 kN, {digits(b)} kN) within 1e-13")
