"""Point on line: the tip of a crank lifts a flat lever; position also in closed form."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), C=(mpf("-0.09"), mpf("0.03")))
m.bar("crank", "A-B", mpf("0.06"))
m.link("lever", C=(0, 0), P=(0, mpf("-0.01")), S=(mpf("0.1"), mpf("0.004")))
m.line("lever.face", "P", 0)
m.mass("lever", mpf("1.1"), "S", J=mpf("0.005"))
m.revolute("A", "ground", "crank")
m.revolute("C", "ground", "lever")
m.contact("N", "crank.B", "lever.face")
m.drive("crank", deg(60), mpf(5))
m.torque("lever", mpf(-4))
m.balance_torque("Mb", "crank")
first = m.solve(near={"lever.S": (mpf("0.01"), mpf("0.06"))})
turn = m.sweep(first, "crank", [deg(60 + 10 * i) for i in range(5)])
for s in turn:
    d = sub(s.position("crank.B"), s.position("lever.C"))
    assert abs(s.angle("lever") - mp.atan2(d[1], d[0]) - mp.asin(mpf("0.01") / mag(d))) < mpf(10) ** -30
    assert s.reaction("N", "lever")[1] > 0
keys("angle(lever)", [s.angle("lever") for s in turn], "deg")
keys("omega(lever)", [s.omega("lever") for s in turn], "rad/s")
keys("alpha(lever)", [s.alpha("lever") for s in turn], "rad/s^2")
keys("reaction(N, lever)", [s.reaction("N", "lever") for s in turn], "N")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[1]
key("reaction(C, lever)", s.reaction("C", "lever"), "N", " at pose 2")
key("reaction(A, crank)", s.reaction("A", "crank"), "N", " at pose 2")
