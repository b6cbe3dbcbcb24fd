"""A30: truss of five bars on a pin and a sliding support; bar forces also by the method of joints."""
from planar import *

m = Mechanism().ground(A=(0, 0), O=(7, 0))
m.line("ground.floor", "O", 0)
m.bar("AE", "A-E", 3).bar("ED", "E-D", 4).bar("AC", "A-C", 5).bar("CD", "C-D", mag((mpf(4), mpf(4)))).bar("EC", "E-C", 4)
m.link("shoe", D=(0, 0))
m.revolute("A", "ground", "AE", "AC")
m.revolute("E", "EC", "AE", "ED")
m.revolute("C", "EC", "AC", "CD")
m.revolute("D", "shoe", "ED", "CD")
m.prismatic("F", "shoe.D", "ground.floor")
m.force("EC", "E", (mpf(0), mpf(-10000)))
m.force("EC", "C", (mpf(2000), mpf(0)))
s = m.solve(near={"C": (mpf(3), mpf(4)), "E": (mpf(3), mpf(0)), "shoe.D": (mpf(7), mpf(0))}, starts=400)
right = (10000 * 3 + 2000 * 4) / mpf(7)
assert abs(s.reaction("F", "shoe")[1] - right) < mpf(10) ** -25
assert abs(mag(s.reaction("D", "CD")) - right * sqrt(mpf(2))) < mpf(10) ** -25
key("position(C)", s.position("C"), "m")
key("reaction(A, AC)", s.reaction("A", "AC"), "kN")
key("reaction(A, AE)", s.reaction("A", "AE"), "kN")
key("reaction(E, AE)", s.reaction("E", "AE"), "kN")
key("reaction(E, ED)", s.reaction("E", "ED"), "kN")
key("reaction(C, AC)", s.reaction("C", "AC"), "kN")
key("reaction(C, CD)", s.reaction("C", "CD"), "kN")
key("reaction(D, CD)", s.reaction("D", "CD"), "kN")
key("reaction(F, shoe)", s.reaction("F", "shoe"), "kN")
key("moment(F, shoe)", s.moment("F", "shoe"), "kN*m")
