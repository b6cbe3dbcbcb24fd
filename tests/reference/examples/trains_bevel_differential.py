"""A bevel differential: the cage by its crown, the side wheels opposite seen from it."""
from fractions import Fraction

cage = Fraction(900 * 16, 48)
print(f"expect omega(cage) = {cage} rpm within 1e-13")
for name, left in (("straight", 300), ("left held", 0)):
    print(f"// {name}: {2 * cage - left}")
