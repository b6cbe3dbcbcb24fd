"""B03: slotted group of the second kind, alone."""
from planar import *

m = Mechanism()
m.link("crank", C=(0, 0)).link("guide", B=(0, 0), A=(mpf("-0.015"), 0)).link("rod", C=(0, 0)).link("frame", A=(0, 0))
m.line("rod.axis", "C", 0)
m.revolute("A", "frame", "guide")
m.revolute("C", "crank", "rod")
m.prismatic("s", "guide.B", "rod.axis", contacts=(mpf("0.05"), mpf("-0.05")))
m.drive("frame.A", (mpf("0.5"), mpf("0.1")))
m.drive("crank.C", (mpf(0), mpf("0.25")))
m.force("guide", (mpf("0.51"), mpf("0.08")), (mpf(5), mpf(-30)))
m.torque("guide", mpf("0.8"))
m.force("rod", (mpf("0.2"), mpf("0.43")), (mpf(-60), mpf(-20)))
m.torque("rod", mpf(-4))
s = m.solve(positive("s"))
key("position(guide.B)", s.position("guide.B"), "m")
key("reaction(s, rod)", s.reaction("s", "rod"), "N")
