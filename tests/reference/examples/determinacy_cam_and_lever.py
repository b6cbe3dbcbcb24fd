"""A30: cam and oscillating follower, one link with a lower and a higher pair."""
from planar import *

m = Mechanism().ground(A=(0, 0), C=(mpf("0.12"), mpf("0.02")))
m.bar("cam", "A-O", mpf("0.02"))
m.circle("cam.rim", "O", mpf("0.05"))
m.link("lever", C=(0, 0), D=(mpf("0.1"), 0), E=(mpf("0.16"), 0))
m.circle("lever.roller", "D", mpf("0.01"))
m.revolute("A", "ground", "cam")
m.revolute("C", "ground", "lever")
m.contact("K", "cam.rim", "lever.roller")
m.drive("cam", deg(40))
m.torque("lever", mpf(12))
m.balance_torque("Mb", "cam")
s = m.solve(near={"lever.D": (mpf("0.055"), mpf("0.095"))})
assert s.normal("K", "lever") > 0
key("angle(lever)", s.angle("lever"), "deg")
key("normal(K, lever)", s.normal("K", "lever"), "N")
key("reaction(K, lever)", s.reaction("K", "lever"), "N")
key("reaction(C, lever)", s.reaction("C", "lever"), "N")
key("Mb", s.balance["Mb"], "N*m")
