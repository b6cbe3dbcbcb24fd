"""Two speeds under torques linear in them: the exponential of a matrix, summed after halving."""
from printing import *

zs, zr, zp = 24, 72, 24
js, jr, jh, jp, mass, a = (mpf(x) for x in ("0.02", "0.15", "0.4", "4e-4", "1.2", "0.048"))
# speeds of all shafts over those of sun and carrier: wr = wh - (ws - wh) zs/zr, wp = wh - (ws - wh) zs/zp
i, n = mpf(zs) / zr, mpf(zs) / zp
rows = {"S": (1, 0), "H": (0, 1), "R": (-i, 1 + i), "P": (-n, 1 + n)}
inertia = {"S": js, "H": jh + mass * a * a, "R": jr, "P": jp}
damping = {"S": mpf("0.08"), "H": mpf("0.3"), "R": mpf("0.9"), "P": mpf(0)}


def quadratic(by):
    return [[sum(by[k] * rows[k][p] * rows[k][q] for k in rows) for q in (0, 1)] for p in (0, 1)]


def times(a, b):
    return [[sum(a[p][k] * b[k][q] for k in range(len(b))) for q in range(len(b[0]))] for p in range(len(a))]


m, c = quadratic(inertia), quadratic(damping)
det = m[0][0] * m[1][1] - m[0][1] * m[1][0]
inverse = [[m[1][1] / det, -m[0][1] / det], [-m[1][0] / det, m[0][0] / det]]
A = [[-x for x in row] for row in times(inverse, c)]
push = times(inverse, [[mpf(20)], [mpf(0)]])


def exponential(t):
    """Of [[A, push], [0, 0]] t, the last column of which are the speeds from rest."""
    B = [[*A[0], *push[0]], [*A[1], *push[1]], [mpf(0)] * 3]
    B = [[x * t / 1024 for x in row] for row in B]
    total = [[mpf(int(p == q)) for q in range(3)] for p in range(3)]
    term = total
    for k in range(1, 30):
        term = [[x / k for x in row] for row in times(term, B)]
        total = [[x + y for x, y in zip(*both)] for both in zip(total, term)]
    for _ in range(10):
        total = times(total, total)
    return total


for t in ("1", "8"):
    e = exponential(mpf(t))
    ws, wh = e[0][2], e[1][2]
    for name, (p, q) in rows.items():
        print(f"expect omega({name}) = {digits(p * ws + q * wh)} rad/s within 1e-11 at time = {t} s")
    # the planets are turned by the force F between teeth of sun and planets; ring and carrier give the rest
    rates = [A[p][0] * ws + A[p][1] * wh + push[p][0] for p in (0, 1)]
    force = (20 - damping["S"] * ws - js * rates[0]) / mpf("0.024")
    print(f"expect tangential_force(sp) = {digits(force)} N within 1e-10 at time = {t} s")
