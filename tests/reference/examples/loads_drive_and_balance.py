"""Drive at the crank, unknown force on the piston: what gas force does the load on the crank need?"""
from planar import *

m = Mechanism().ground(A=(0, 0), Q=(0, mpf("0.01")))
m.line("ground.bore", "Q", 0)
m.bar("crank", "A-B", mpf("0.05"))
m.bar("rod", "B-C", mpf("0.17"), S=(mpf("0.055"), 0))
m.link("piston", C=(0, 0))
m.mass("rod", mpf("0.9"), "S", J=mpf("0.004"))
m.mass("piston", mpf("0.7"), "C")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "rod")
m.revolute("C", "rod", "piston")
m.prismatic("D", "piston.C", "ground.bore")
m.drive("crank", deg(40), rpm(1200))
m.torque("crank", mpf(-80))
m.balance_force("Fg", "piston", "C", deg(180))
s = m.solve(ahead("C", "B", "D"))
key("Fg", s.balance["Fg"], "kN")
for pair, link in (("A", "crank"), ("B", "rod"), ("C", "piston"), ("D", "piston")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("moment(D, piston)", s.moment("D", "piston"), "N*m")
