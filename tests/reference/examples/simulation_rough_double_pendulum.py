"""A double pendulum with friction circles in both hinges: Lagrange's equations with torques that follow the forces in the hinges."""
from dynamics import *
from sliding import follow

g = 9.81
mass, inertia, length = (1.5, 1.0), (0.02, 0.012), (0.4, 0.35)
middle, circle, at_rest = (0.2, 0.175), (0.004, 0.003), 1.5


def plain(y, torques):
    """Accelerations and hinge forces for given friction torques on the first rod from the ground, on the second from the first."""
    a, b, u, v = y
    (ca, sa), (cb, sb) = (math.cos(a), math.sin(a)), (math.cos(b), math.sin(b))
    (m, n), (i, j), (l, _), (r, s) = mass, inertia, length, middle
    # Lagrange's equations
    p, q, w = i + m * r * r + n * l * l, j + n * s * s, n * l * s
    c, d = w * (ca * cb + sa * sb), w * (sa * cb - ca * sb)
    one = torques[0] - torques[1] - d * v * v - (m * r + n * l) * g * ca
    two = torques[1] + d * u * u - n * s * g * cb
    det = p * q - c * c
    x, z = (q * one - c * two) / det, (p * two - c * one) / det
    # what accelerates the second rod's middle, and the first one's beside it
    hx, hy = l * (-sa * x - ca * u * u), l * (ca * x - sa * u * u)
    gx, gy = n * (hx + s * (-sb * z - cb * v * v)), n * (hy + s * (cb * z - sb * v * v) + g)
    fx, fy = gx + m * r / l * hx, gy + m * r / l * hy + m * g
    return (x, z), (math.hypot(fx, fy), math.hypot(gx, gy))


def motion(senses, _, y):
    def torques_at(forces, held):
        return [held[p] if s == 0 else -s * c * forces[p] for p, (s, c) in enumerate(zip(senses, circle))]

    def free(held):
        forces = (0.0, 0.0)
        for _ in range(60):
            second, new = plain(y, torques_at(forces, held))
            if max(abs(p - q) for p, q in zip(new, forces)) < 1e-14 * max(new):
                break
            forces = new
        return second, forces

    def relative(second):
        return [second[0], second[1] - second[0]]

    held = [0.0, 0.0]
    stuck = [p for p in (0, 1) if senses[p] == 0]
    for _ in range(8 if stuck else 0):
        # relative accelerations of what is held by differences of the torques that hold
        base = relative(free(held)[0])
        if max(abs(base[p]) for p in stuck) < 1e-14:
            break
        rows = []
        for q in stuck:
            other = list(held)
            other[q] += 1.0
            moved = relative(free(other)[0])
            rows.append([moved[p] - base[p] for p in stuck])
        step = solve([list(row) for row in zip(*rows)], [-base[p] for p in stuck])
        for p, x in zip(stuck, step):
            held[p] += x
    second, forces = free(held)
    each = [(a, held[p], at_rest * circle[p] * forces[p]) for p, a in enumerate(relative(second))]
    return second, each


y, there, changes = follow(motion, lambda y: [y[2], y[3] - y[2]], [math.radians(-80), math.radians(-75), 0.0, 0.0], 2.0, at=(1.0,))
seen = {}
for t, pair, before, after in changes:
    if before and after:
        continue
    event = f"{'AB'[pair]}_{'slips' if after else 'sticks'}"
    seen[event] = seen.get(event, 0) + 1
    key(f"time({event}{f', {seen[event]}' if seen[event] > 1 else ''})", t, "s", "1e-9", places=10)
for text, x, unit in zip(("angle(one)", "angle(two)", "omega(one)", "omega(two)"), there[1.0], ("rad", "rad", "rad/s", "rad/s")):
    key(text, x, unit, "1e-9", " at time = 1 s", places=10)
key("angle(one)", y[0], "rad", "1e-9", " at event end", places=10)
key("angle(two)", y[1], "rad", "1e-9", " at event end", places=10)
