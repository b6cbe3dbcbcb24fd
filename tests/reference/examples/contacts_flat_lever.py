"""Circle on line: eccentric disc and flat oscillating lever over a turn; angle also in closed form."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0), C=(mpf("-0.11"), mpf("0.02")))
m.bar("disc", "A-O", mpf("0.015"))
m.circle("disc.rim", "O", mpf("0.04"))
m.link("lever", C=(0, 0), P=(0, mpf("-0.008")), S=(mpf("0.08"), mpf("0.005")), E=(mpf("0.2"), 0))
m.line("lever.face", "P", 0)
m.mass("lever", mpf("0.9"), "S", J=mpf("0.003"))
m.revolute("A", "ground", "disc")
m.revolute("C", "ground", "lever")
m.contact("N", "disc.rim", "lever.face")
m.drive("disc", mpf(0), mpf(-10))
m.force("lever", "E", (mpf(0), mpf(-70)), frame="lever")
m.balance_torque("Mb", "disc")
first = m.solve(near={"lever.S": (mpf("-0.03"), mpf("0.07"))})
turn = m.sweep(first, "disc", [deg(-30 * i) for i in range(12)])
for s in turn:
    d = sub(s.position("disc.O"), s.position("lever.C"))
    assert abs(s.angle("lever") - mp.atan2(d[1], d[0]) - mp.asin(mpf("0.048") / mag(d))) < mpf(10) ** -30
    assert s.normal("N", "lever") > 0
keys("angle(lever)", [s.angle("lever") for s in turn], "deg")
keys("omega(lever)", [s.omega("lever") for s in turn], "rad/s")
keys("alpha(lever)", [s.alpha("lever") for s in turn], "rad/s^2")
keys("normal(N, lever)", [s.normal("N", "lever") for s in turn], "N")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[2]
key("reaction(N, lever)", s.reaction("N", "lever"), "N", " at pose 3")
key("reaction(C, lever)", s.reaction("C", "lever"), "N", " at pose 3")
key("reaction(A, disc)", s.reaction("A", "disc"), "N", " at pose 3")
