"""The first program: in-line crank-slider."""
from planar import *

m = Mechanism().ground(A=(0, 0))
m.line("ground.guide", "A", 0)
m.bar("crank", "A-B", mpf("0.1"))
m.bar("rod", "B-C", mpf("0.35"))
m.link("piston", C=(0, 0))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "rod")
m.revolute("C", "rod", "piston")
m.prismatic("D", "piston.C", "ground.guide")
m.drive("crank", deg(45), rpm(1500))
s = m.solve(ahead("C", "B", "D"))
key("v_C", s.velocity("C")[0], "m/s")
key("position(C)", s.position("C"), "mm")
key("omega(rod)", s.omega("rod"), "rad/s")
key("acceleration(C)", s.acceleration("C"), "m/s^2")
