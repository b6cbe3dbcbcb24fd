"""Named poses beside a sweep."""
from planar import *

m = Mechanism().ground(A=(0, 0), D=(mpf("0.3"), 0))
m.bar("crank", "A-B", mpf("0.1"))
m.bar("coupler", "B-C", mpf("0.26"), E=(mpf("0.13"), mpf("0.1")))
m.bar("rocker", "D-C", mpf("0.2"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", mpf(0), mpf(10))
m.torque("rocker", mpf(-20))
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(left_of("C", "B", "D")), "crank", [deg(45 * i) for i in range(8)])
key("position(coupler.E)", turn[0].position("coupler.E"), "mm", " at pose 1")
key("position(coupler.E)", turn[7].position("coupler.E"), "mm", " at pose 8")
for name, angle in (("2'", 60), ("upper", 100), ("last", 350)):
    s = m.there(turn, "crank", deg(angle))
    key("position(coupler.E)", s.position("coupler.E"), "mm", f" at pose {name}")
    key("velocity(coupler.E)", s.velocity("coupler.E"), "m/s", f" at pose {name}")
    key("acceleration(coupler.E)", s.acceleration("coupler.E"), "m/s^2", f" at pose {name}")
    key("reaction(C, rocker)", s.reaction("C", "rocker"), "N", f" at pose {name}")
    key("Mb", s.balance["Mb"], "N*m", f" at pose {name}")
