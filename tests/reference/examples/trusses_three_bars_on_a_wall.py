"""Three bars on a wall: the pins A, B and C in equilibrium."""
from trusses import *

pins = {"A": (mpf(3), mpf("7.2")), "B": (mpf(0), mpf("3.2")), "C": (mpf(0), mpf(0))}
ab, ac, bc, bx, by, cx = solved(pins, ["AB", "AC", "BC"], [("B", X), ("B", Y), ("C", X)], {"A": (48, 0)})
print(f"expect axial(ab) = {ab} kN within 1e-12")
print(f"expect axial(ac) = {ac} kN within 1e-12")
print(f"expect axial(bc) = {bc} kN within 1e-12")
print(f"expect B_x = {bx} kN within 1e-12")
print(f"expect C_x = {cx} kN within 1e-12")
