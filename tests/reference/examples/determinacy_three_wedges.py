"""A30: three wedges without friction: forces only, 2n = P_L + 1."""
from planar import *

a, b = deg(60), deg(30)
m = Mechanism().ground(O=(0, 0), U=(mpf("-0.2"), 0), W=(mpf("0.2"), 0))
m.line("ground.floor", "O", 0)
m.line("ground.left", "U", deg(270))
m.line("ground.right", "W", deg(90))
m.link("wedge1", U=(0, 0)).link("wedge2", O=(0, 0), L=(mpf("-0.1"), mpf("0.05")), R=(mpf("0.1"), mpf("0.05"))).link("wedge3", W=(0, 0))
m.line("wedge1.down", "U", deg(270))
m.line("wedge1.face", "U", a)
m.line("wedge2.base", "O", 0)
m.line("wedge2.f12", "L", a)
m.line("wedge2.f23", "R", -b)
m.line("wedge3.up", "W", deg(90))
m.line("wedge3.face", "W", -b)
m.prismatic("A", "wedge1.down", "ground.left")
m.prismatic("B", "wedge1.face", "wedge2.f12")
m.prismatic("C", "wedge2.base", "ground.floor")
m.prismatic("D", "wedge3.face", "wedge2.f23")
m.prismatic("E", "wedge3.up", "ground.right")
m.drive("A", mpf(0))
m.force("wedge1", "U", (mpf(0), mpf(-1000)))
m.balance_force("Q", "wedge3", "W", deg(270))
s = m.solve()
assert abs(s.balance["Q"] - 3000) < mpf(10) ** -24              # P tan 60 / tan 30
for pair, link in (("A", "wedge1"), ("B", "wedge2"), ("C", "wedge2"), ("D", "wedge2"), ("E", "wedge3")):
    key(f"reaction({pair}, {link})", s.reaction(pair, link), "N")
key("Q", s.balance["Q"], "N")
