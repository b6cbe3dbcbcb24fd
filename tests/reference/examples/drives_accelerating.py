"""Starting and stopping drives: angular acceleration of the crank."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), D=(mpf("0.4"), mpf("0.1")))
m.bar("crank", "A-B", mpf("0.1"), S=(mpf("0.03"), 0))
m.bar("coupler", "B-C", mpf("0.35"), S=(mpf("0.17"), mpf("0.03")))
m.bar("rocker", "D-C", mpf("0.25"), S=(mpf("0.1"), 0))
m.mass("crank", 4, "S", J=mpf("0.02"))
m.mass("coupler", mpf("2.5"), "S", J=mpf("0.03"))
m.mass("rocker", mpf("1.8"), "S", J=mpf("0.012"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", deg(45), mpf(-20), mpf(-5))
m.balance_torque("Mb", "crank")
s = m.solve(left_of("C", "B", "D"))
key("omega(crank)", s.omega("crank"), "rad/s")
key("alpha(crank)", s.alpha("crank"), "rad/s^2")
for link in ("coupler", "rocker"):
    key(f"omega({link})", s.omega(link), "rad/s")
    key(f"alpha({link})", s.alpha(link), "rad/s^2")
key("acceleration(C)", s.acceleration("C"), "m/s^2")
key("inertia_torque(crank)", s.inertia_torque("crank"), "N*m")
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Mb", s.balance["Mb"], "N*m")
