"""Humpage's gear: speeds relative to the arm, torques by power."""
from fractions import Fraction
from printing import *

A, B, C, D, E, speed, torque = 20, 60, 50, 24, 58, Fraction(300), Fraction(40)
# A (w_A - h) = -C p, and B (0 - h) = C p
arm = speed * A / (A + B)
planet = -A * (speed - arm) / C
output = arm + D * planet / E
M_E = -torque * speed / output


def line(name, x, unit):
    print(f"expect {name} = {mp.nstr(mpf(x.numerator) / x.denominator, 14)}{unit} within 1e-13".replace(".0 ", " "))


line("omega(arm)", arm, " rpm")
line("omega(planet)", planet, " rpm")
line("omega(output)", output, " rpm")
line("i", speed / output, "")
line("M_E", M_E, " N*m")
line("moment(CB, ground)", torque + M_E, " N*m")
