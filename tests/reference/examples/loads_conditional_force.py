"""Cutting force that acts on part of the forward stroke only; in-line crank-slider."""
from planar import *

m = Mechanism().ground(A=(0, 0))
m.line("ground.guide", "A", 0)
m.bar("crank", "A-B", mpf("0.1"))
m.bar("rod", "B-C", mpf("0.4"))
m.link("ram", C=(0, 0), Q=(mpf("0.1"), mpf("-0.03")))
m.mass("ram", 12, "C")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "rod")
m.revolute("C", "rod", "ram")
m.prismatic("G", "ram.C", "ground.guide")
m.drive("crank", deg(15), rpm(60))
low, stroke = mpf("0.3"), mpf("0.2")


def cutting(s):
    return mpf("0.05") < (s.displacement("G") - low) / stroke < mpf("0.95") and s.velocity("C")[0] > 0


m.force("ram", "Q", (mpf(-1400), mpf(0)), when=cutting)
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(ahead("C", "B", "G")), "crank", [deg(15 + 30 * i) for i in range(12)])
assert 2 < sum(cutting(s) for s in turn) < 7
key("stroke(G)", stroke, "mm")
keys("travel(G)", [s.displacement("G") - low for s in turn], "mm")
keys("reaction(C, ram)", [s.reaction("C", "ram") for s in turn], "N")
keys("moment(G, ram)", [s.moment("G", "ram") for s in turn], "N*m")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
