"""Side wheels of 18 and 24 teeth: speeds by Willis, torques by power and by the balance about the axis."""
from fractions import Fraction
from printing import *

z_a, z_b, cage, left, torque = 18, 24, 1000, 1100, 600
right = cage - Fraction(z_a, z_b) * (left - cage)
print(f"expect omega(right_side) = {right} rpm within 1e-13")
for name, z in (("M_a", z_a), ("M_b", z_b)):
    value = Fraction(-torque * z, z_a + z_b)
    print(f"expect {name} = {mp.nstr(mpf(value.numerator) / value.denominator, 14)} N*m within 1e-13")
