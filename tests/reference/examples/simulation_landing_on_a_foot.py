"""Two masses and a spring: free fall, one mass on the ground, and both in flight; closed forms of each."""
from dynamics import *

g, m1, m2, k, h = 9.81, 1.0, 3.0, 2000.0, 0.4
t1 = math.sqrt(2.0 * h / g)
w = math.sqrt(k / m2)
x0 = -m2 * g / k
a, b = -x0, -g * t1 / w
size, phase = math.hypot(a, b), math.atan2(b, a)
# the spring pulls with the foot's weight where x0 + size cos(w t - phase) = m1 g/k; on the way up
angle = math.acos((m1 * g / k - x0) / size)
t2 = (phase - angle) % (2.0 * math.pi) / w
v = size * w * math.sin(angle)
key("time(lands)", t1, "s", "1e-10")
key("time(lifts)", t1 + t2, "s", "1e-10")
key("displacement(H)", 0.3 + m1 * g / k, "m", "1e-10", " at event lifts")
key("relative_velocity(H)", v, "m/s", "1e-10", " at event lifts")
# in flight both swing about their common mass centre
u = math.sqrt(k * (m1 + m2) / (m1 * m2))
t = 0.8 - t1 - t2
x = m1 * g / k * math.cos(u * t) + v / u * math.sin(u * t)
centre = m2 * (0.3 + m1 * g / k) / (m1 + m2) + m2 * v / (m1 + m2) * t - 0.5 * g * t * t
key("displacement(G)", centre - m2 * (0.3 + x) / (m1 + m2), "m", "1e-9", " at event end")
key("displacement(H)", centre + m1 * (0.3 + x) / (m1 + m2), "m", "1e-9", " at event end")
key("energy()", m2 * g * 0.7 + m1 * g * 0.4 - m1 * g * h, "J", "1e-10", " at event end")
