"""Two bars under one load: the pins A, B and C in equilibrium."""
from trusses import *

pins = {"A": (mpf(0), mpf(0)), "B": (mpf(2), mpf(0)), "C": (mpf(0), mpf("1.5"))}
ab, cb, ax, ay, cx, cy = solved(pins, ["AB", "CB"], [("A", X), ("A", Y), ("C", X), ("C", Y)], {"B": ("-1.2", "-5.6")})
print(f"expect axial(ab) = {ab} kN within 1e-13")
print(f"expect axial(cb) = {cb} kN within 1e-13")
print(f"expect reaction(A, ab) = ({ax} kN, {ay} kN) within 1e-13")
print(f"expect reaction(C, cb) = ({cx} kN, {cy} kN) within 1e-13")
