"""A30: class III group alone, its three outer hinges at given places."""
from planar import *

m = Mechanism()
m.link("o1", P=(0, 0)).link("o2", Q=(0, 0)).link("o3", R=(0, 0))
m.link("plate", A=(0, 0), B=(mpf("0.2"), 0), C=(mpf("0.08"), mpf("0.15")), S=(mpf("0.09"), mpf("0.05")))
m.bar("leg1", "P-A", mpf("0.18"))
m.bar("leg2", "Q-B", mpf("0.2"), K=(mpf("0.1"), 0))
m.bar("leg3", "R-C", mpf("0.16"))
for pair, o, leg in (("P", "o1", "leg1"), ("Q", "o2", "leg2"), ("R", "o3", "leg3")):
    m.revolute(pair, o, leg)
for pair, leg in (("A", "leg1"), ("B", "leg2"), ("C", "leg3")):
    m.revolute(pair, leg, "plate")
m.drive("o1.P", (mpf(0), mpf(0)))
m.drive("o2.Q", (mpf("0.35"), mpf("0.02")))
m.drive("o3.R", (mpf("0.12"), mpf("0.45")))
m.force("plate", "S", (mpf(80), mpf(-150)))
m.torque("plate", mpf(6))
m.force("leg2", "K", (mpf(-40), mpf(25)))
m.torque("leg3", mpf(-3))
s = m.solve(near={"plate.A": (mpf("0.03"), mpf("0.18")), "plate.B": (mpf("0.24"), mpf("0.19"))}, starts=400)
key("position(plate.A)", s.position("plate.A"), "mm")
key("position(plate.C)", s.position("plate.C"), "mm")
key("angle(plate)", s.angle("plate"), "deg")
for pair, link in (("P", "leg1"), ("Q", "leg2"), ("R", "leg3"), ("A", "plate"), ("B", "plate"), ("C", "plate")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
