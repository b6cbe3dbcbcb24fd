"""Balance force across the crank at its pin; the torque for comparison."""
from planar import *


def build():
    m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), D=(mpf("0.22"), mpf("-0.03")))
    m.bar("crank", "A-B", mpf("0.09"))
    m.bar("coupler", "B-C", mpf("0.2"), S=(mpf("0.1"), mpf("0.02")))
    m.bar("rocker", "D-C", mpf("0.16"))
    m.mass("coupler", mpf("1.5"), "S", J=mpf("0.005"))
    m.revolute("A", "ground", "crank")
    m.revolute("B", "crank", "coupler")
    m.revolute("C", "coupler", "rocker")
    m.revolute("D", "ground", "rocker")
    m.drive("crank", deg(75), mpf(10))
    m.torque("rocker", mpf(-12))
    return m


m = build()
m.balance_force("Fb", "crank", "B", deg(90), frame="crank")
s = m.solve(left_of("C", "B", "D"))
n = build()
n.balance_torque("Mb", "crank")
t = n.solve(left_of("C", "B", "D"))
assert abs(s.balance["Fb"] * mpf("0.09") - t.balance["Mb"]) < mpf(10) ** -25
key("Fb", s.balance["Fb"], "N")
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
