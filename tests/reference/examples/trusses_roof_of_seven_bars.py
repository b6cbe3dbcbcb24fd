"""Seven bars: the pins A to E in equilibrium."""
from trusses import *

pins = {"A": (0, 0), "B": (2, 3), "C": (4, 0), "D": (6, 3), "E": (8, 0)}
pins = {name: (mpf(x), mpf(y)) for name, (x, y) in pins.items()}
bars = ["AB", "AC", "BC", "BD", "CD", "CE", "DE"]
found = solved(pins, bars, [("A", X), ("A", Y), ("E", Y)], {"B": (0, -6), "C": (0, -10), "D": (4, 0)})
for bar, force in zip(bars, found):
    print(f"expect axial({bar.lower()}) = {force} kN within 1e-13")
for name, force in zip(("A_x", "A_y", "E_y"), found[len(bars):]):
    print(f"expect {name} = {force} kN within 1e-12")
