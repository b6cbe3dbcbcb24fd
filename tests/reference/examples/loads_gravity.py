"""Gravity across the drawing: a four-bar on a slope, at rest."""
from planar import *

m = Mechanism(gravity=at(mpf("9.81"), deg(250))).ground(A=(0, 0), D=(mpf("0.5"), 0))
m.bar("crank", "A-B", mpf("0.15"), S=(mpf("0.06"), 0))
m.bar("coupler", "B-C", mpf("0.4"), S=(mpf("0.2"), mpf("0.05")))
m.bar("rocker", "D-C", mpf("0.3"), S=(mpf("0.12"), mpf("0.02")))
for link, mass in (("crank", 2), ("coupler", 5), ("rocker", mpf("3.5"))):
    m.mass(link, mass, "S")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", deg(50))
m.balance_torque("Mb", "crank")
s = m.solve(left_of("C", "B", "D"))
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Mb", s.balance["Mb"], "N*m")
total = add(s.reaction("A", "crank"), s.reaction("D", "rocker"))
assert mag(add(total, times(mpf("10.5"), m.gravity))) < mpf(10) ** -25
