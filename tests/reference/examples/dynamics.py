"""Motions under loads in doubles: equations of motion from places in closed form, integrated by extrapolation of order 16.

A scene is a function of time and of the free coordinates, which are numbers with two time derivatives. It returns terms
(m, s, F): a mass m (a moment of inertia) that moves along s (turns by s) under the force F (the torque F). With s = s(q) the
principle of virtual power is the sum of ds/dq (m s'' - F) = 0. Elimination, steps and roots are written out here.
"""
import math


class Jet:
    """Value and first two time derivatives."""
    __slots__ = ("a", "b", "c")

    def __init__(self, a, b=0.0, c=0.0):
        self.a, self.b, self.c = a, b, c

    def __add__(self, o):
        if isinstance(o, Jet):
            return Jet(self.a + o.a, self.b + o.b, self.c + o.c)
        return Jet(self.a + o, self.b, self.c)

    def __neg__(self):
        return Jet(-self.a, -self.b, -self.c)

    def __sub__(self, o):
        return self + (-o)

    def __rsub__(self, o):
        return -self + o

    def __mul__(self, o):
        if isinstance(o, Jet):
            return Jet(self.a * o.a, self.a * o.b + self.b * o.a, self.a * o.c + 2.0 * self.b * o.b + self.c * o.a)
        return Jet(self.a * o, self.b * o, self.c * o)

    def __truediv__(self, o):
        return self * chain(o, 1.0 / o.a, -1.0 / o.a ** 2, 2.0 / o.a ** 3) if isinstance(o, Jet) else self * (1.0 / o)

    def __rtruediv__(self, o):
        return Jet(float(o)) / self

    __radd__, __rmul__ = __add__, __mul__


def chain(x, f, f1, f2):
    """A function of x by its value and derivatives."""
    return Jet(f, f1 * x.b, f2 * x.b * x.b + f1 * x.c)


def cos(x):
    c, s = math.cos(x.a), math.sin(x.a)
    return chain(x, c, -s, -c)


def sin(x):
    c, s = math.cos(x.a), math.sin(x.a)
    return chain(x, s, c, -s)


def sqrt(x):
    r = math.sqrt(x.a)
    return chain(x, r, 0.5 / r, -0.25 / r ** 3)


def atan2(y, x):
    """Angle of (x, y)."""
    r2 = x * x + y * y
    rate = (x.a * y.b - y.a * x.b) / r2.a
    second = (x.a * y.c - y.a * x.c) / r2.a - rate * r2.b / r2.a
    return Jet(math.atan2(y.a, x.a), rate, second)


def point(x, y, angle, at):
    """A point of a link that stands at (x, y) and is turned by the angle."""
    c, s = cos(angle), sin(angle)
    return x + c * at[0] - s * at[1], y + s * at[0] + c * at[1]


def dyad(p, q, l1, l2, side):
    """The pin of two bars from p and q; side 1: left of p-q."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    d2 = dx * dx + dy * dy
    along = (d2 + (l1 * l1 - l2 * l2)) / d2 * 0.5
    across = sqrt(l1 * l1 / d2 - along * along) * float(side)
    return p[0] + dx * along - dy * across, p[1] + dy * along + dx * across


def weight(m, x, y, g):
    """Terms of a mass under its weight."""
    return [(m, x, 0.0), (m, y, -m * g)]


def solve(rows, right):
    """Elimination with the greatest pivot of each column."""
    n = len(right)
    a = [[*row, b] for row, b in zip(rows, right)]
    for k in range(n):
        p = max(range(k, n), key=lambda i: abs(a[i][k]))
        a[k], a[p] = a[p], a[k]
        for i in range(k + 1, n):
            f = a[i][k] / a[k][k]
            if f:
                a[i] = [x - f * y for x, y in zip(a[i], a[k])]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (a[k][n] - sum(a[k][j] * x[j] for j in range(k + 1, n))) / a[k][k]
    return x


def accelerations(scene, t, q, v):
    n = len(q)
    terms = scene(t, [Jet(a, b) for a, b in zip(q, v)])
    columns = [[s.b for _, s, _ in scene(t, [Jet(a, float(i == j)) for j, a in enumerate(q)])] for i in range(n)] if n > 1 else \
        [[s.b for _, s, _ in scene(t, [Jet(q[0], 1.0)])]]
    mass = [[sum(m * a * b for (m, _, _), a, b in zip(terms, columns[i], columns[j])) for j in range(n)] for i in range(n)]
    power = [sum((f - m * s.c) * a for (m, s, f), a in zip(terms, columns[i])) for i in range(n)]
    return solve(mass, power)


def rates(scene):
    """The scene as a system of first order."""
    def of(t, y):
        n = len(y) // 2
        return [*y[n:], *accelerations(scene, t, y[:n], y[n:])]
    return of


COLUMNS = 8


def extrapolated(f, t, y, h):
    """One step of Gragg's rule, extrapolated; the last two of the diagonal."""
    first = f(t, y)
    table = []
    for k in range(1, COLUMNS + 1):
        n = 2 * k
        s = h / n
        a, b = y, [u + s * w for u, w in zip(y, first)]
        for i in range(1, n):
            a, b = b, [u + 2.0 * s * w for u, w in zip(a, f(t + i * s, b))]
        last = f(t + h, b)
        row = [[0.5 * (u + w + s * z) for u, w, z in zip(a, b, last)]]
        for j in range(1, k):
            factor = 1.0 / ((n / (2.0 * (k - j))) ** 2 - 1.0)
            row.append([u + (u - w) * factor for u, w in zip(row[j - 1], table[-1][j - 1])])
        table.append(row)
    return table[-1][-1], table[-1][-2]


def integrate(f, y, t, end, h, tolerance=1e-14, events=(), stop=None):
    """From t to end. Every event (name, g) is a function g(t, y) whose zeros are found; `stop` names the one that ends
    the motion. Returns the last instant, the state there, and the zeros by name with their states."""
    found = {name: [] for name, _ in events}
    before = {name: g(t, y) for name, g in events}
    scale = [abs(u) for u in y]
    while t < end * (1.0 - 1e-15):
        h = min(h, end - t)
        new, other = extrapolated(f, t, y, h)
        # of coordinates and rates apart, each over the greatest of its kind
        half = len(y) // 2
        sizes = [max(1e-3, *(max(abs(u), s) for u, s in zip(new[i:i + half], scale[i:i + half]))) for i in (0, half)]
        wrong = max(abs(u - w) / sizes[i // half] for i, (u, w) in enumerate(zip(new, other)))
        factor = min(2.0, max(0.2, 0.8 * (tolerance / max(wrong, 1e-30)) ** (1.0 / 15.0)))
        if wrong > tolerance and h > 1e-9 * end:
            h *= factor if factor < 0.95 else 0.7
            continue
        step, passed = h, []
        for name, g in events:
            after = g(t + h, new)
            if before[name] * after < 0.0:
                passed.append((name, *zero(lambda s: g(t + s, extrapolated(f, t, y, s)[0]), h, before[name], after)))
            if after != 0.0:
                before[name] = after
        for name, s in sorted(passed, key=lambda e: e[1]):
            there = extrapolated(f, t, y, s)[0]
            found[name].append((t + s, there))
            if name == stop:
                return t + s, there, found
        t, y, h = t + step, new, h * factor
        scale = [max(s, abs(u)) for s, u in zip(scale, y)]
    return t, y, found


def zero(g, h, low, high):
    """A zero of g between 0 and h, where it has these values: by chords of which one end is halved (Illinois)."""
    a, b = 0.0, h
    for _ in range(60):
        s = b - high * (b - a) / (high - low)
        x = g(s)
        if abs(s - b) <= 1e-16 * h or x == 0.0:
            return (s,)
        if (x < 0.0) != (high < 0.0):
            a, low = b, high
        else:
            low *= 0.5
        b, high = s, x
    return (b,)


def key(text, value, unit="", within="1e-9", tail="", places=12):
    """Prints one `expect`, to as many figures as are sure."""
    def one(x):
        x = f"{x:.{places}g}"
        return (x if "." in x or "e" in x else x) + (f" {unit}" if unit else "")
    value = "(" + ", ".join(one(x) for x in value) + ")" if isinstance(value, tuple) else one(value)
    print(f"expect {text} = {value} within {within}{tail}")
