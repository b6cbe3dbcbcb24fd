"""A30: three-hinged arch, a structure; horizontal thrust also by hand."""
from planar import *

m = Mechanism(gravity=(mpf(0), mpf(-10))).ground(A=(0, 0), B=(8, 0))
m.link("left_half", A=(0, 0), C=(4, 3), S=(mpf("1.5"), 2))
m.link("right_half", B=(0, 0), C=(-4, 3), S=(mpf("-1.5"), 2), K=(-3, mpf("2.7")))
m.mass("left_half", 1200, "S", J=1)
m.mass("right_half", 1200, "S", J=1)
m.revolute("A", "ground", "left_half")
m.revolute("B", "ground", "right_half")
m.revolute("C", "left_half", "right_half")
m.force("right_half", "K", (mpf(0), mpf(-20000)))
s = m.solve(left_of("C", "A", "B"))
up = (12000 * mpf("1.5") + 12000 * mpf("6.5") + 20000 * 5) / 8          # moments of everything about A give B's vertical part
assert abs(s.reaction("B", "right_half")[1] - up) < mpf(10) ** -25
thrust = (up * 4 - 12000 * mpf("2.5") - 20000) / 3                      # moments of the right half about C
assert abs(s.reaction("B", "right_half")[0] + thrust) < mpf(10) ** -25
key("position(C)", s.position("C"), "m")
key("reaction(A, left_half)", s.reaction("A", "left_half"), "kN")
key("reaction(B, right_half)", s.reaction("B", "right_half"), "kN")
key("reaction(C, right_half)", s.reaction("C", "right_half"), "kN")
