"""A30: a crank alone under two weights."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf("-9.81"))).ground(A=(0, 0))
m.bar("crank", "A-B", mpf("0.4"), S=(mpf("0.15"), 0))
m.mass("crank", 3, "S")
m.revolute("A", "ground", "crank")
m.drive("crank", deg(30))
m.force("crank", "B", (mpf(0), mpf(-50)))
m.balance_torque("Mb", "crank")
s = m.solve()
assert abs(s.balance["Mb"] - (3 * mpf("9.81") * mpf("0.15") + 20) * mp.cos(deg(30))) < mpf(10) ** -30
key("reaction(A, crank)", s.reaction("A", "crank"), "N")
key("Mb", s.balance["Mb"], "N*m")
