"""Pin in slot: Scotch yoke, the pin straight in the slot; motion also in closed form."""
from planar import *

r, w = mpf("0.05"), mpf(20)
m = Mechanism().ground(A=(0, 0), Q=(0, mpf("0.03")))
m.line("ground.guide", "Q", 0)
m.bar("crank", "A-B", r)
m.link("yoke", E=(0, 0), S=(mpf("0.06"), mpf("-0.01")), H=(mpf("0.15"), 0))
m.line("yoke.slot", "E", deg(90))
m.mass("yoke", mpf("1.8"), "S")
m.revolute("A", "ground", "crank")
m.prismatic("P", "yoke.E", "ground.guide", contacts=(mpf("0.05"), mpf("0.15")))
m.slot("K", "crank.B", "yoke.slot")
m.drive("crank", mpf(0), w)
m.force("yoke", "H", (mpf(-40), mpf(0)))
m.balance_torque("Mb", "crank")
turn = m.sweep(m.solve(), "crank", [deg(30 * i) for i in range(12)])
for i, s in enumerate(turn):
    x = deg(30 * i)
    assert abs(s.displacement("P") - r * mp.cos(x)) < mpf(10) ** -30
    assert abs(s.relative_acceleration("P") + r * w ** 2 * mp.cos(x)) < mpf(10) ** -28
    assert abs(s.balance["Mb"] - (40 - mpf("1.8") * r * w ** 2 * mp.cos(x)) * -r * mp.sin(x)) < mpf(10) ** -28
keys("displacement(P)", [s.displacement("P") for s in turn], "mm")
keys("displacement(K)", [s.displacement("K") for s in turn], "mm")
keys("relative_velocity(P)", [s.relative_velocity("P") for s in turn], "m/s")
keys("relative_acceleration(P)", [s.relative_acceleration("P") for s in turn], "m/s^2")
keys("Mb", [s.balance["Mb"] for s in turn], "N*m")
s = turn[4]
key("reaction(K, yoke)", s.reaction("K", "yoke"), "N", " at pose 5")
key("reaction(P, yoke)", s.reaction("P", "yoke"), "N", " at pose 5")
key("moment(P, yoke)", s.moment("P", "yoke"), "N*m", " at pose 5")
key("contact_force(P, 1)", s.contact_force("P", 1), "N", " at pose 5")
key("contact_force(P, 2)", s.contact_force("P", 2), "N", " at pose 5")
