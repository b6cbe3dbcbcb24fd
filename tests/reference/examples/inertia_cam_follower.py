"""A05: disc cam with an in-line knife edge; the cam as a circle of 200 mm about A, A 100 mm from the pivot."""
from planar import *

m = Mechanism().ground(O=(0, 0))
m.line("ground.axis", "O", deg(90))
m.bar("disc", "O-A", mpf("0.1"))
m.circle("disc.rim", "A", mpf("0.2"))
m.link("follower", B=(0, 0))
m.mass("follower", 20, "B")
m.revolute("O", "ground", "disc")
m.prismatic("P", "follower.B", "ground.axis")
m.contact("K", "disc.rim", "follower.B")
m.drive("disc", mpf(0), mpf(20))
m.balance_torque("Mb", "disc")
s = m.solve(positive("P"))
r, R = mpf("0.1"), mpf("0.2")
assert abs(s.acceleration("follower.B")[1] - 400 * r ** 2 / sqrt(R ** 2 - r ** 2)) < mpf(10) ** -30
key("displacement(P)", s.displacement("P"), "mm")
key("velocity(follower.B)", s.velocity("follower.B"), "m/s")
key("acceleration(follower.B)", s.acceleration("follower.B"), "m/s^2")
key("inertia_force(follower)", s.inertia_force("follower"), "N")
key("reaction(K, follower)", s.reaction("K", "follower"), "N")
key("reaction(P, follower)", s.reaction("P", "follower"), "N")
key("Mb", s.balance["Mb"], "N*m")
