"""The six-bar of A35 with friction in every pair."""
from friction import with_friction
from planar import *

g = mpf("9.81")
m = Mechanism(gravity=(mpf(0), -g)).ground(A=(0, 0), D=(mpf("0.3"), mpf("-0.05")), Q=(0, mpf("0.12")))
m.line("ground.guide", "Q", 0)
m.bar("crank", "A-B", mpf("0.1"), G=(mpf("0.06"), 0))
m.bar("coupler", "B-C", mpf("0.3"), S2=(mpf("0.15"), 0))
m.mass("coupler", 50 / g, "S2", J=mpf("0.04"))
m.bar("rocker", "D-C", mpf("0.25"), E=(mpf("0.15"), 0))
m.bar("rod", "E-F", mpf("0.35"))
m.link("ram", F=(0, 0))
m.mass("ram", 80 / g, "F")
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.revolute("E", "rocker", "rod")
m.revolute("F", "rod", "ram")
m.prismatic("H", "ram.F", "ground.guide")
m.drive("crank", deg(60), mpf(20))
m.force("ram", "F", lambda s: (-400 * mp.sign(s.velocity("F")[0]), mpf(0)))
m.balance_force("Fb", "crank", "G", mpf(0))
s = m.solve(left_of("C", "B", "D"), ahead("F", "E", "H"))
laws = {name: mpf("0.004") for name in "ABCDEF"} | {"H": mpf("0.12")}
balance, r = with_friction(s, laws)
key("Fb", balance["Fb"], "N")
key("efficiency", s.balance["Fb"] / balance["Fb"], "")
for pair, link in (("F", "ram"), ("H", "ram"), ("E", "rod"), ("C", "rocker"), ("B", "coupler"), ("D", "rocker"), ("A", "crank")):
    key(f"reaction({pair}, {link})", r[(pair, link)], "N")
