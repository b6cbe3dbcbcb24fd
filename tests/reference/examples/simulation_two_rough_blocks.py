"""Two blocks on a slope, each a mass point with friction of its own, and a spring between them."""
from dynamics import *
from sliding import follow

g, slope, k, free = 9.81, math.radians(8), 200.0, 0.3
masses, mu, mu_s = (2.0, 3.0), (0.2, 0.25), (0.3, 0.4)


def motion(senses, _, y):
    spring = k * (y[1] - y[0] - free)
    second, each = [], []
    for m, f, f_s, pull, s in zip(masses, mu, mu_s, (spring, -spring), senses):
        normal, load = m * g * math.cos(slope), pull - m * g * math.sin(slope)
        a = (load - s * f * normal) / m if s else 0.0
        second.append(a)
        each.append((a, -load, f_s * normal))
    return second, each


y, there, changes = follow(motion, lambda y: y[2:], [0.0, 0.3, 1.5, 0.0], 1.5, at=(0.5,))
seen = {}
for t, pair, before, after in changes:
    if before and after:
        continue
    event = f"{'PQ'[pair]}_{'slips' if after else 'sticks'}"
    seen[event] = seen.get(event, 0) + 1
    key(f"time({event}{f', {seen[event]}' if seen[event] > 1 else ''})", t, "s", "1e-10", places=11)
for text, x, unit in zip(("displacement(P)", "displacement(Q)", "relative_velocity(P)"), there[0.5], ("m", "m", "m/s")):
    key(text, x, unit, "1e-9", " at time = 0.5 s", places=10)
key("displacement(P)", y[0], "m", "1e-10", " at event end", places=10)
key("displacement(Q)", y[1], "m", "1e-10", " at event end", places=10)
key("friction(Q, upper)", motion([0, 0], 0.0, y)[1][1][1], "N", "1e-10", " at event end", places=10)
