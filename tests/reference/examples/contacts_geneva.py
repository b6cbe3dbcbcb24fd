"""Pin in slot: Geneva wheel with four slots while the pin is in; motion also in closed form."""
from planar import *

a = mpf("0.1")
r = a / sqrt(mpf(2))
m = Mechanism().ground(A=(0, 0), C=(a, 0))
m.bar("crank", "A-B", r)
m.link("wheel", C=(0, 0))
m.line("wheel.slot", "C", 0)
m.mass("wheel", 0, J=mpf("0.002"))
m.revolute("A", "ground", "crank")
m.revolute("C", "ground", "wheel")
m.slot("K", "crank.B", "wheel.slot")
m.drive("crank", deg(-40), rpm(60))
m.torque("wheel", mpf("0.3"))
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(positive("K")), "crank", [deg(-40 + 10 * i) for i in range(9)])
lam = r / a
for i, s in enumerate(turn):
    x = deg(-40 + 10 * i)
    d = 1 - 2 * lam * mp.cos(x) + lam ** 2
    assert abs(s.omega("wheel") + 2 * pi * lam * (mp.cos(x) - lam) / d) < mpf(10) ** -28
    assert abs(s.alpha("wheel") - (2 * pi) ** 2 * lam * (1 - lam ** 2) * mp.sin(x) / d ** 2) < mpf(10) ** -27
keys("angle(wheel)", [s.angle("wheel") for s in turn], "deg")
keys("displacement(K)", [s.displacement("K") for s in turn], "mm")
keys("omega(wheel)", [s.omega("wheel") for s in turn], "rad/s")
keys("alpha(wheel)", [s.alpha("wheel") for s in turn], "rad/s^2")
keys("relative_velocity(K)", [s.relative_velocity("K") for s in turn], "m/s")
keys("reaction(K, wheel)", [s.reaction("K", "wheel") for s in turn], "N")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[1]
key("coriolis(K)", s.coriolis("K"), "m/s^2", " at pose 2")
key("reaction(C, wheel)", s.reaction("C", "wheel"), "N", " at pose 2")
key("reaction(A, crank)", s.reaction("A", "crank"), "N", " at pose 2")
