"""Engine crank-slider at 1500 rpm: inertia forces and reactions."""
from planar import *

l = mpf("0.35")
m = Mechanism().ground(A=(0, 0))
m.line("ground.guide", "A", 0)
m.bar("crank", "A-B", mpf("0.1"))
m.bar("rod", "B-C", l, S2=(l / 3, 0))
m.mass("rod", mpf("2.5"), "S2", J=mpf("0.0425"))
m.link("piston", C=(0, 0))
m.mass("piston", mpf("2.14"), "C")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "rod")
m.revolute("C", "rod", "piston")
m.prismatic("D", "piston.C", "ground.guide")
m.drive("crank", deg(45), rpm(1500))
m.balance_torque("Mb", "crank")
s = m.solve(ahead("C", "B", "D"))
key("F_I3", s.inertia_force("piston"), "N")
key("F_I2", s.inertia_force("rod"), "N")
key("M_I2", s.inertia_torque("rod"), "N*m")
for pair, link in (("A", "crank"), ("B", "rod"), ("C", "piston"), ("D", "piston")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Mb", s.balance["Mb"], "N*m")
