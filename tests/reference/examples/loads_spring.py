"""Springs: a lever in motion between two springs, one with damping between moving links."""
from planar import *

m = Mechanism().ground(A=(0, 0), D=(mpf("0.3"), 0), G=(mpf("0.35"), mpf("0.3")))
m.bar("crank", "A-B", mpf("0.08"), P=(mpf("0.05"), mpf("0.02")))
m.bar("coupler", "B-C", mpf("0.28"))
m.bar("rocker", "D-C", mpf("0.2"), Q=(mpf("0.12"), mpf("0.03")), S=(mpf("0.1"), 0))
m.mass("rocker", mpf("1.2"), "S", J=mpf("0.004"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.spring("ground.G", "rocker.Q", 4530, mpf("0.07785"))
m.spring("crank.P", "rocker.Q", 900, mpf("0.35"), damping=60)
m.drive("crank", deg(70), mpf(12))
m.balance_torque("Mb", "crank")
s = m.solve(left_of("C", "B", "D"))
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Mb", s.balance["Mb"], "N*m")
