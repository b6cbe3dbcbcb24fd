"""A beam with an overhang: the equilibrium of the beam, and its sections piece by piece."""
from printing import *

q, p, l, c = mpf(3), mpf(4), mpf(4), mpf(6)
b = (q * l * l / 2 + p * c) / l
a = q * l + p - b
x = a / q
cut = lambda value: digits(mpf(mp.nstr(value, 14)))
print(f"expect reaction(A, beam) = (0 kN, {digits(a)} kN) within 1e-13")
print(f"expect reaction(B, beam) = (0 kN, {digits(b)} kN) within 1e-13")
print(f"expect max(internal(beam).M) = {cut(a * x - q * x * x / 2)} kN*m within 1e-13")
print(f"expect argmax(internal(beam).M) = {cut(x)} m within 1e-13")
print(f"expect min(internal(beam).M) = {digits(a * l - q * l * l / 2)} kN*m within 1e-13")
print(f"expect argmin(internal(beam).M) = {digits(l)} m within 1e-13")
print(f"expect max(internal(beam).Q) = {digits(a)} kN within 1e-13")
print(f"expect min(internal(beam).Q) = {digits(a - q * l)} kN within 1e-13")
print(f"expect internal(beam, 0 m).Q = {digits(a)} kN within 1e-13")
print(f"expect internal(beam, 4 m).Q = {digits(a - q * l)} kN within 1e-13")
print(f"expect internal(beam, 5 m).Q = {digits(a - q * l + b)} kN within 1e-13")
