"""An engine with friction in all four pairs: the equations of Newton and Euler of crank, rod and piston, over the crank's angle.

Between multiples of 90 deg no sliding changes its sense; the friction of hinges and guide follows the forces by iteration."""
from dynamics import *

g, r, l, at = 9.81, 0.06, 0.21, 0.07
crank, rod, piston = (2.0, 0.03), (0.9, 0.006), 0.7
rho, mu = (0.003, 0.004, 0.002), 0.1
motor, drag, pressure = 12.0, 0.02, 80.0


def places(q):
    """The rod's middle, its angle and the piston's place."""
    x, y = r * cos(q), r * sin(q)
    c = sqrt(1.0 - (y / l) * (y / l))
    angle = atan2(-y / l, c)
    return x + at * c, y + at * (-y / l), angle, x + l * c


def forces(q, w, senses):
    bias = places(Jet(q, w))
    unit = places(Jet(q, 1.0))
    k, a0, v = [p.b for p in unit], [p.c for p in bias], [p.b for p in bias]
    phi = bias[2].a
    b, c = (r * math.cos(q), r * math.sin(q)), (bias[3].a, 0.0)
    s = (bias[0].a, bias[1].a)
    load = -pressure * (1.0 if senses[3] > 0 else 0.0)
    rubs = [0.0] * 4
    for _ in range(100):
        # unknowns: alpha, B on the rod, C on the piston, the normal force
        rows = [
            [rod[0] * k[0], -1.0, 0.0, 1.0, 0.0, 0.0],
            [rod[0] * k[1], 0.0, -1.0, 0.0, 1.0, 0.0],
            [rod[1] * k[2], b[1] - s[1], -(b[0] - s[0]), -(c[1] - s[1]), c[0] - s[0], 0.0],
            [piston * k[3], 0.0, 0.0, -1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 0.0, -1.0, -1.0],
            [crank[1], -b[1], b[0], 0.0, 0.0, 0.0],
        ]
        right = [
            -rod[0] * a0[0],
            -rod[0] * (a0[1] + g),
            -rod[1] * a0[2] + rubs[1] - rubs[2],
            -piston * a0[3] + load + rubs[3],
            -piston * g,
            motor - drag * w + rubs[0] - rubs[1],
        ]
        alpha, bx, by, cx, cy, n = solve(rows, right)
        a = math.hypot(bx, by + crank[0] * g)
        new = [-senses[0] * rho[0] * a, -senses[1] * rho[1] * math.hypot(bx, by),
               senses[2] * rho[2] * math.hypot(cx, cy), -senses[3] * mu * abs(n)]
        if max(abs(x - y) for x, y in zip(new, rubs)) < 1e-15 * max(abs(x) for x in new):
            break
        rubs = new
    return alpha, v[3], rubs


def system(senses):
    def f(q, y):
        alpha, v, rubs = forces(q, y[1], senses)
        return [1.0 / y[1], alpha / y[1], rubs[3] * v / y[1], 0.0]
    return f


y, q = [0.0, 40.0, 0.0, 0.0], math.radians(30)
ends = [math.radians(a) for a in (90, 180, 270, 350)]
for end in ends:
    middle = 0.5 * (q + end)
    rate, slide = (p.b for p in places(Jet(middle, 1.0))[2:])
    # of the crank, of the rod against it, of the rod against the piston, of the piston
    senses = [1.0, math.copysign(1.0, rate - 1.0), math.copysign(1.0, rate), math.copysign(1.0, slide)]
    _, y, _ = integrate(system(senses), y, q, end, 0.05)
    q = end
key("time(round)", y[0], "s", "1e-9", places=11)
key("omega(crank)", y[1], "rad/s", "1e-9", " at event round", places=11)
key("friction_work(D)", y[2], "J", "1e-8", " at event round", places=10)
