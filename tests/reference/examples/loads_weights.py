"""Weights: scissor-like lifting arm with a platform on a parallelogram; the torque also from virtual work."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), D=(mpf("0.1"), mpf("0.2")))
m.bar("lower", "A-B", 1, S=(mpf("0.5"), 0))
m.bar("upper", "D-C", 1)
m.link("platform", B=(0, 0), C=(mpf("0.1"), mpf("0.2")), S=(mpf("0.25"), mpf("0.1")))
m.mass("lower", 21 / mpf("9.81"), "S")
m.mass("platform", 180 / mpf("9.81"), "S", J=mpf("0.5"))
m.revolute("A", "ground", "lower")
m.revolute("B", "lower", "platform")
m.revolute("C", "upper", "platform")
m.revolute("D", "ground", "upper")
m.drive("lower", deg(35), mpf("0.4"))
m.balance_torque("Mb", "lower")
s = m.solve(near={"C": (mpf("0.92"), mpf("0.77"))})
assert abs(s.angle("platform")) < mpf(10) ** -30
key("angle(platform)", s.angle("platform"), "deg")
key("omega(platform)", s.omega("platform"), "rad/s")
key("acceleration(platform.S)", s.acceleration("platform.S"), "m/s^2")
key("inertia_force(platform)", s.inertia_force("platform"), "N")
for pair, link in (("A", "lower"), ("B", "platform"), ("C", "platform"), ("D", "upper")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Mb", s.balance["Mb"], "N*m")
