"""RRR dyad: four-bar over a turn, all links with mass, load on the rocker."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), D=(mpf("0.12"), mpf("0.01")))
m.bar("crank", "A-B", mpf("0.04"))
m.bar("coupler", "B-C", mpf("0.11"), S2=(mpf("0.06"), mpf("0.015")))
m.bar("rocker", "D-C", mpf("0.09"), S3=(mpf("0.045"), mpf("-0.005")))
m.mass("coupler", mpf("1.2"), "S2", J=mpf("0.0021"))
m.mass("rocker", mpf("0.9"), "S3", J=mpf("0.0015"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", mpf(0), rpm(120))
m.torque("rocker", mpf(-8))
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(left_of("C", "B", "D")), "crank", [deg(30 * i) for i in range(12)])
keys("angle(rocker)", [s.angle("rocker") for s in turn], "deg")
keys("omega(rocker)", [s.omega("rocker") for s in turn], "rad/s")
keys("alpha(rocker)", [s.alpha("rocker") for s in turn], "rad/s^2")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[3]
key("position(C)", s.position("C"), "mm", " at pose 4")
key("acceleration(coupler.S2)", s.acceleration("coupler.S2"), "m/s^2", " at pose 4")
for pair, link in (("A", "crank"), ("B", "coupler"), ("C", "rocker"), ("D", "rocker")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N", " at pose 4")
s = m.there(turn, "crank", deg(75))
key("reaction(B, coupler)", s.reaction("B", "coupler"), "N", " at crank = 75 deg")
key("Mb", s.balance["Mb"], "N*m", " at crank = 75 deg")
s = turn[3]
u, v = sub(s.position("B"), s.position("C")), sub(s.position("D"), s.position("C"))
mu = mp.acos(dot(u, v) / (mag(u) * mag(v)))
assert mu < pi / 2
key("transmission_angle(rrr)", mu, "deg", " at pose 4")
