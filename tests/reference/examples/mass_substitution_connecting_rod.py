"""A10: the crank-slider at 1500 rpm; vectors of the substituted inertia forces."""
from planar import *

g = mpf("9.8")
l, b, J = mpf("0.33"), mpf("0.11"), mpf("0.0425")
m2 = 25 / g
k = J / (m2 * b)
m = Mechanism().ground(A=(0, 0))
m.line("ground.guide", "A", 0)
m.bar("crank", "A-B", mpf("0.1"))
m.bar("rod", "B-C", l, S2=(b, 0), K=(b + k, 0))
m.mass("rod", m2, "S2", J=J)
m.link("piston", C=(0, 0))
m.mass("piston", 21 / g, "C")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "rod")
m.revolute("C", "rod", "piston")
m.prismatic("D", "piston.C", "ground.guide")
m.drive("crank", deg(45), rpm(1500))
s = m.solve(ahead("C", "B", "D"))
F_IB, F_IK = times(-m2 * k / (b + k), s.acceleration("B")), times(-m2 * b / (b + k), s.acceleration("rod.K"))
assert mag(sub(add(F_IB, F_IK), s.inertia_force("rod"))) < mpf(10) ** -28
c = l - b
key("F_I2", s.inertia_force("rod"), "N")
key("F_IB", F_IB, "N")
key("F_IK", F_IK, "N")
key("F_IB'", times(-m2 * c / l, s.acceleration("B")), "N")
key("F_IC'", times(-m2 * b / l, s.acceleration("C")), "N")
key("abs(static_substitution(rod, B, C).dJ)", abs(J - m2 * b * c), "kg*m^2")
