"""Force and torque against motion over a turn."""
from planar import *

m = Mechanism().ground(A=(0, 0), D=(mpf("0.25"), mpf("0.02")))
m.bar("crank", "A-B", mpf("0.07"))
m.bar("coupler", "B-C", mpf("0.22"), K=(mpf("0.1"), mpf("0.06")))
m.bar("rocker", "D-C", mpf("0.17"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", deg(0), rpm(60))
m.force("coupler", "K", lambda s: times(-mpf(90) / mag(s.velocity("coupler.K")), s.velocity("coupler.K")))
m.torque("rocker", lambda s: -7 * mp.sign(s.omega("rocker")))
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(left_of("C", "B", "D")), "crank", [deg(30 * i) for i in range(12)])
assert all(s.balance["Mb"] > 0 for s in turn)
keys("velocity(coupler.K)", [s.velocity("coupler.K") for s in turn], "m/s")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[6]
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N", " at pose 7")
