"""A small general solver for planar mechanisms, independent of the Rust code.

Position: Newton on the constraint equations of all pairs and drives at once, in the coordinates
(x, y, theta) of every moving link. Velocity and acceleration: the same constraint functions evaluated on
Taylor numbers (value, first and second time derivative). Forces: one linear system, the Newton-Euler
equations of every moving link at once. No groups, no closed forms, so nothing is shared with the solver
whose answers it checks. The last step of everything is done in mpmath with 40 digits.

Every solution is checked twice before a number leaves this file: all assembly modes are looked for from
random starts and the clauses must leave exactly one; and the virtual power of all loads, inertia forces and
balances is zero for the motion of each drive.
"""
import math
import random

import numpy
from mpmath import mp, mpf

mp.dps = 40
pi = mp.pi


def deg(value):
    return mpf(value) * pi / 180


def rpm(value):
    return mpf(value) * pi / 30


# ---------------------------------------------------------------- numbers with two time derivatives
class Taylor:
    """Value and first two time derivatives."""
    __slots__ = ("a", "b", "c")

    def __init__(self, a, b=0, c=0):
        self.a, self.b, self.c = a, b, c

    @staticmethod
    def of(x):
        return x if isinstance(x, Taylor) else Taylor(x)

    def __add__(self, o):
        o = Taylor.of(o)
        return Taylor(self.a + o.a, self.b + o.b, self.c + o.c)

    def __neg__(self):
        return Taylor(-self.a, -self.b, -self.c)

    def __sub__(self, o):
        return self + (-Taylor.of(o))

    def __rsub__(self, o):
        return Taylor.of(o) - self

    def __mul__(self, o):
        o = Taylor.of(o)
        return Taylor(self.a * o.a, self.a * o.b + self.b * o.a, self.a * o.c + 2 * self.b * o.b + self.c * o.a)

    def __truediv__(self, o):
        o = Taylor.of(o)
        a = self.a / o.a
        b = (self.b - a * o.b) / o.a
        return Taylor(a, b, (self.c - 2 * b * o.b - a * o.c) / o.a)

    __radd__, __rmul__ = __add__, __mul__


def cos(x):
    if isinstance(x, Taylor):
        c, s = mp.cos(x.a), mp.sin(x.a)
        return Taylor(c, -s * x.b, -c * x.b ** 2 - s * x.c)
    return math.cos(x) if isinstance(x, float) else mp.cos(x)


def sin(x):
    if isinstance(x, Taylor):
        c, s = mp.cos(x.a), mp.sin(x.a)
        return Taylor(s, c * x.b, -s * x.b ** 2 + c * x.c)
    return math.sin(x) if isinstance(x, float) else mp.sin(x)


def sqrt(x):
    if isinstance(x, Taylor):
        r = mp.sqrt(x.a)
        return Taylor(r, x.b / (2 * r), x.c / (2 * r) - x.b ** 2 / (4 * r ** 3))
    return math.sqrt(x) if isinstance(x, float) else mp.sqrt(x)


# ---------------------------------------------------------------- vectors are tuples
def add(u, v):
    return (u[0] + v[0], u[1] + v[1])


def sub(u, v):
    return (u[0] - v[0], u[1] - v[1])


def times(k, u):
    return (k * u[0], k * u[1])


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def left(u):
    """u turned by +90 deg."""
    return (-u[1], u[0])


def mag(u):
    return sqrt(dot(u, u))


def at(r, phi):
    """The language's `r @ phi`."""
    return (r * mp.cos(phi), r * mp.sin(phi))


class Link:
    def __init__(self, name, points):
        self.name, self.points = name, {k: (mpf(x), mpf(y)) for k, (x, y) in points.items()}
        self.lines, self.circles = {}, {}
        self.mass, self.centre, self.inertia = mpf(0), None, mpf(0)
        self.index, self.outer = None, False


class Frame:
    """Origin and direction of a link, in any of the number types."""

    def __init__(self, x, y, theta, fast=False):
        self.o, self.theta, self.fast = (x, y), theta, fast
        self.c, self.s = cos(theta), sin(theta)

    def turn(self, u):
        if self.fast:
            u = (float(u[0]), float(u[1]))
        return (self.c * u[0] - self.s * u[1], self.s * u[0] + self.c * u[1])

    def place(self, p):
        return add(self.o, self.turn(p))

    def direction(self, phi):
        """Unit vector at the angle phi of the link's own frame."""
        return self.turn((cos(float(phi)), sin(float(phi))) if self.fast else (mp.cos(phi), mp.sin(phi)))


# ---------------------------------------------------------------- pairs
class Pair:
    """`ends` are (link, point, line or circle); `a` is the first link, `b` the second."""
    kind = ""

    def __init__(self, m, name, a, pa, b, pb):
        self.m, self.name, self.a, self.pa, self.b, self.pb = m, name, a, pa, b, pb


class Revolute(Pair):
    kind = "revolute"

    def residuals(self, f):
        return list(sub(f[self.b].place(self.m.point(self.b, self.pb)), f[self.a].place(self.m.point(self.a, self.pa))))

    def coordinate(self, f):
        return f[self.b].theta - f[self.a].theta

    def wrenches(self, f):
        """Unknowns as (on, from, force, point, couple)."""
        p = f[self.a].place(self.m.point(self.a, self.pa))
        return [(self.b, self.a, (1, 0), p, 0), (self.b, self.a, (0, 1), p, 0)]


class Prismatic(Pair):
    """Point of a on a line of b, no relative turning; or a line of a along a line of b (`angle` is then found)."""
    kind = "prismatic"

    def __init__(self, m, name, a, pa, b, line, angle):
        super().__init__(m, name, a, pa, b, line)
        self.angle, self.contacts = angle, None

    def line(self, f):
        origin, phi = self.m.line_of(self.b, self.pb)
        return f[self.b].place(origin), f[self.b].direction(phi)

    def residuals(self, f):
        o, u = self.line(f)
        p = f[self.a].place(self.m.point(self.a, self.pa))
        if f.fast:
            turn = math.remainder(f[self.a].theta - f[self.b].theta - float(self.angle), 2 * math.pi)
        else:
            turn = f[self.a].theta - f[self.b].theta - self.angle
        return [cross(u, sub(p, o)), turn]

    def coordinate(self, f):
        o, u = self.line(f)
        return dot(u, sub(f[self.a].place(self.m.point(self.a, self.pa)), o))

    def wrenches(self, f):
        o, u = self.line(f)
        p = f[self.a].place(self.m.point(self.a, self.pa))
        return [(self.a, self.b, left(u), p, 0), (self.a, self.b, (0, 0), p, 1)]


class Slot(Prismatic):
    """Pin of a in a slot of b: a point on a line and nothing else."""
    kind = "slot"

    def residuals(self, f):
        return super().residuals(f)[:1]

    def wrenches(self, f):
        return super().wrenches(f)[:1]


class Contact(Pair):
    """Circle or point of a against circle, line or point of b; bodies outside one another."""
    kind = "contact"

    def profile(self, link, name):
        """('line', origin, phi) or ('circle', centre, radius) in the link's frame."""
        k = self.m.links[link]
        if name in k.lines:
            return ("line", *self.m.line_of(link, name))
        if name in k.circles:
            centre, radius = k.circles[name]
            return ("circle", k.points[centre], radius)
        return ("circle", k.points[name], mpf(0))

    def ends(self):
        """The circle first: (circle's link, centre, radius, other link, other profile)."""
        pa, pb = self.profile(self.a, self.pa), self.profile(self.b, self.pb)
        if pa[0] == "circle":
            return self.a, pa[1], pa[2], self.b, pb
        return self.b, pb[1], pb[2], self.a, pa

    def residuals(self, f):
        la, c, r, lb, other = self.ends()
        pc = f[la].place(c)
        if other[0] == "circle":
            d = sub(pc, f[lb].place(other[1]))
            reach = float(r + other[2]) if f.fast else r + other[2]
            return [dot(d, d) - reach * reach]
        h = self.height(f)
        r = float(r) if f.fast else r
        return [h * h - r * r] if r != 0 else [h]

    def height(self, f):
        """Distance of the circle's centre to the left of the line."""
        la, c, _, lb, other = self.ends()
        u = f[lb].direction(other[2])
        return cross(u, sub(f[la].place(c), f[lb].place(other[1])))

    def normal(self, f):
        """Unit normal into the circle's link and the point of contact."""
        la, c, r, lb, other = self.ends()
        pc = f[la].place(c)
        if other[0] == "circle":
            d = sub(pc, f[lb].place(other[1]))
            n = times(1 / mag(d), d)
        else:
            n = left(f[lb].direction(other[2]))
            if self.height(f) < 0 and r != 0:
                n = times(-1, n)
        return n, sub(pc, times(r, n))

    def wrenches(self, f):
        la, _, _, lb, _ = self.ends()
        n, p = self.normal(f)
        return [(la, lb, n, p, 0)]


class Cylinder(Pair):
    """A massless two-force member of variable length; constrains nothing by itself."""
    kind = "cylinder"

    def residuals(self, f):
        return []

    def ends(self, f):
        return f[self.a].place(self.m.point(self.a, self.pa)), f[self.b].place(self.m.point(self.b, self.pb))

    def coordinate(self, f):
        p, q = self.ends(f)
        return mag(sub(q, p))

    def wrenches(self, f):
        return []


class Frames(dict):
    fast = False


# ---------------------------------------------------------------- the mechanism
class Mechanism:
    def __init__(self, gravity=None):
        self.links = {"ground": Link("ground", {})}
        self.pairs, self.drives, self.loads, self.balances, self.springs = [], [], [], {}, []
        self.gravity = (mpf(0), mpf(0)) if gravity is None else gravity
        self.pins = {}

    # ---- declaration
    def ground(self, **points):
        self.links["ground"] = Link("ground", points)
        return self

    def link(self, name, **points):
        self.links[name] = k = Link(name, points)
        k.index = len(self.links) - 2
        return self

    def bar(self, name, ends, length, **points):
        """`link NAME A-B length`."""
        a, b = ends.split("-")
        return self.link(name, **{a: (0, 0), b: (length, 0)}, **points)

    def line(self, ref, through, along=None, to=None):
        link, name = ref.split(".")
        self.links[link].lines[name] = (through, along, to)

    def circle(self, ref, centre, radius):
        link, name = ref.split(".")
        self.links[link].circles[name] = (centre, mpf(radius))

    def mass(self, link, mass, at=None, J=0, about=None):
        k = self.links[link]
        k.mass, k.inertia = mpf(mass), mpf(J)
        if at:
            k.centre = k.points[at]
        if about:
            arm = sub(k.points[about], k.centre) if mass else (0, 0)
            k.inertia = mpf(J) - mpf(mass) * dot(arm, arm)

    def point(self, link, name):
        return self.links[link].points[name]

    def line_of(self, link, name):
        k = self.links[link]
        through, along, to = k.lines[name]
        o = k.points[through]
        if to:
            d = sub(k.points[to], o)
            along = mp.atan2(d[1], d[0])
        return o, mpf(along)

    def _end(self, ref, default):
        link, _, part = ref.partition(".")
        return link, part or default

    def revolute(self, name, first, *others):
        a, pa = self._end(first, name)
        for other in others:
            b, pb = self._end(other, name)
            self.pairs.append(Revolute(self, name, a, pa, b, pb))

    def prismatic(self, name, first, second, angle=None, contacts=None):
        """`angle`: constant angle of the point's link to the line."""
        a, pa = self._end(first, name)
        b, line = self._end(second, name)
        _, phi = self.line_of(b, line)
        turn = phi + (angle or 0)
        if pa in self.links[a].lines:
            pa_line = self.links[a].lines[pa]
            turn = phi - self.line_of(a, pa)[1]
            pa = pa_line[0]
        p = Prismatic(self, name, a, pa, b, line, turn)
        p.contacts = contacts
        self.pairs.append(p)

    def slot(self, name, first, second):
        a, pa = self._end(first, name)
        b, line = self._end(second, name)
        self.pairs.append(Slot(self, name, a, pa, b, line, 0))

    def contact(self, name, first, second):
        a, pa = self._end(first, name)
        b, pb = self._end(second, name)
        self.pairs.append(Contact(self, name, a, pa, b, pb))

    def cylinder(self, name, first, second):
        a, pa = self._end(first, name)
        b, pb = self._end(second, name)
        self.pairs.append(Cylinder(self, name, a, pa, b, pb))

    def pair(self, name):
        return next(p for p in self.pairs if p.name == name)

    def drive(self, what, value, speed=None, accelerating=0):
        """A link's angle, a pair's coordinate, or `L.P` with vectors."""
        if "." in what:
            link, _ = what.split(".")
            self.links[link].outer = True
            accelerating = accelerating or (0, 0)
        self.drives.append([what, value, speed, accelerating])

    def force(self, link, where, value, frame=None, when=None):
        """`where`: a point's name or a place in the ground. `value`: vector, or a function of the solution."""
        self.loads.append(("force", link, where, value, frame, when))

    def torque(self, link, value, when=None):
        self.loads.append(("torque", link, None, value, None, when))

    def inside(self, pair, value):
        """A force in a sliding pair, a torque in a revolute, positive along the pair's coordinate."""
        self.loads.append(("inside", pair, None, value, None, None))

    def spring(self, first, second, stiffness, free_length, damping=0):
        self.springs.append((*first.split("."), *second.split("."), mpf(stiffness), mpf(free_length), mpf(damping)))

    def balance_torque(self, name, on):
        self.balances[name] = ("torque", on)

    def balance_force(self, name, on, where, along, frame=None):
        self.balances[name] = ("force", on, where, along, frame)

    def balance_inside(self, name, pair):
        self.balances[name] = ("inside", pair)

    # ---- equations
    def moving(self):
        return [k for k in self.links.values() if k.index is not None]

    def frames(self, q, fast=False):
        f = Frames()
        f.fast = fast
        zero = 0.0 if fast else mpf(0)
        f["ground"] = Frame(zero, zero, zero, fast)
        for k in self.moving():
            i = 3 * k.index
            f[k.name] = Frame(q[i], q[i + 1], q[i + 2], fast)
        return f

    def driven(self, f, what):
        """Present value of what a drive prescribes, as a list of numbers."""
        if "." in what:
            link, p = what.split(".")
            return list(f[link].place(self.point(link, p)))
        if what in self.links:
            return [f[what].theta]
        return [self.pair(what).coordinate(f)]

    def residuals(self, q, values, fast=False):
        f = self.frames(q, fast)
        out = []
        for p in self.pairs:
            out += p.residuals(f)
        for (what, *_), value in zip(self.drives, values):
            got = self.driven(f, what)
            for g, v in zip(got, value):
                d = g - v
                if fast and (what in self.links or "." not in what and self.pair(what).kind == "revolute"):
                    d = math.remainder(d, 2 * math.pi)
                out.append(d)
            if "." in what:
                out.append(f[what.split(".")[0]].theta)
        return out

    def drive_values(self, order=0):
        """Per drive a list of plain numbers: position, speed or acceleration."""
        out = []
        for d in self.drives:
            v = d[1 + order]
            v = 0 if v is None else v
            out.append([mpf(x) for x in v] if isinstance(v, tuple) else [mpf(v)])
        return out

    def jacobian(self, q):
        n = len(q)
        values = self.drive_values()
        columns = []
        for j in range(n):
            t = [Taylor(x, mpf(1 if i == j else 0)) for i, x in enumerate(q)]
            columns.append([r.b for r in map(Taylor.of, self.residuals(t, values))])
        return mp.matrix([[columns[j][i] for j in range(n)] for i in range(len(columns[0]))])

    # ---- position
    def _rough(self, start, values):
        """Damped Newton in double precision from a random start; None when it does not arrive."""
        q = numpy.array(start)
        vals = [[float(x) for x in v] for v in values]
        r = numpy.array(self.residuals(list(map(float, q)), vals, True), dtype=float)
        for _ in range(60):
            norm = numpy.abs(r).max()
            if norm < 1e-11:
                return q
            jac = numpy.empty((len(r), len(q)))
            for j in range(len(q)):
                h = 1e-7
                p = q.copy()
                p[j] += h
                jac[:, j] = (numpy.array(self.residuals(list(map(float, p)), vals, True), dtype=float) - r) / h
            step = numpy.linalg.lstsq(jac, -r, rcond=1e-12)[0]
            k = 1.0
            while k > 1e-3:
                new = q + k * step
                rn = numpy.array(self.residuals(list(map(float, new)), vals, True), dtype=float)
                if numpy.abs(rn).max() < norm:
                    break
                k /= 2
            q, r = new, rn
        return None

    def polish(self, q, values=None):
        values = values or self.drive_values()
        q = [mpf(float(x)) if not isinstance(x, mpf) else x for x in q]
        for k in self.moving():
            i = 3 * k.index + 2
            q[i] -= 2 * pi * mp.nint(q[i] / (2 * pi))
        for d, (what, *_) in zip(values, self.drives):       # angles near the drive's own turn
            if what in self.links:
                i = 3 * self.links[what].index + 2
                turns = mp.nint((d[0] - q[i]) / (2 * pi))
                q[i] += turns * 2 * pi
        # prismatic pairs compare angles: bring each angle to the drive's branch of its chain
        for p in self.pairs * 3:
            if p.kind == "prismatic":
                f = self.frames(q)
                ka, kb = self.links[p.a], self.links[p.b]
                d = f[p.a].theta - f[p.b].theta - p.angle
                turns = mp.nint(d / (2 * pi))
                fixed = [w.split(".")[0] for w, *_ in self.drives]
                if ka.index is not None and ka.name not in fixed:
                    q[3 * ka.index + 2] -= turns * 2 * pi
                elif kb.index is not None:
                    q[3 * kb.index + 2] += turns * 2 * pi
        for (what, *_), d in zip(self.drives, values):
            if "." not in what and what not in self.links and self.pair(what).kind == "revolute":
                p = self.pair(what)
                f = self.frames(q)
                turns = mp.nint((f[p.b].theta - f[p.a].theta - d[0]) / (2 * pi))
                q[3 * self.links[p.b].index + 2] -= turns * 2 * pi
        for _ in range(12):
            r = mp.matrix(self.residuals(q, values))
            if max(abs(x) for x in r) < mpf(10) ** -36:
                return q
            q = list(mp.matrix(q) - mp.lu_solve(self.jacobian(q), r))
        raise ValueError("no convergence: " + mp.nstr(max(abs(x) for x in r), 5))

    def poses(self, starts=150, seed=1):
        """All assembly modes that random starts find."""
        random.seed(seed)
        lengths = [1e-9] + [float(mag(p)) for k in self.links.values() for p in k.points.values()]
        scale = max(lengths) * 2
        values = self.drive_values()
        found = []
        for _ in range(starts):
            start = []
            for _ in self.moving():
                start += [random.uniform(-scale, scale), random.uniform(-scale, scale), random.uniform(-math.pi, math.pi)]
            try:
                q = self._rough(start, values)
            except numpy.linalg.LinAlgError:
                continue
            if q is None or max(abs(q)) > 1e3 * scale + 1e3:
                continue
            f = self.frames(list(map(float, q)), True)
            sign = [(f[k.name].o[0], f[k.name].o[1], scale * f[k.name].c, scale * f[k.name].s) for k in self.moving()]
            if all(max(abs(x - y) for a, b in zip(sign, old) for x, y in zip(a, b)) > 1e-6 * scale for old, _ in found):
                found.append((sign, q))
        out = []
        for _, q in found:
            try:
                out.append(Solution(self, self.polish(q)))
            except ZeroDivisionError:
                pass                                          # a singular pose: not an assembly mode anyone asks for
        return out

    def solve(self, *clauses, near=None, starts=150):
        """The one pose that fits the assembly clauses (see `left_of` and its like below)."""
        all_poses = self.poses(starts)
        fit = [s for s in all_poses if all(c(s) for c in clauses)]
        if near:
            fit.sort(key=lambda s: sum(dot(d, d) for d in [sub(s.position(p), xy) for p, xy in near.items()]))
            fit = fit[:1]
        if len(fit) != 1:
            raise ValueError(f"{len(all_poses)} poses, {len(fit)} fit")
        return fit[0].finish()

    def follow(self, before, steps=24):
        """The pose for the present drive values on the branch of `before`, in small steps."""
        q, end = before.q, self.drive_values()
        for i in range(1, steps + 1):
            mid = [[a + (b - a) * i / steps for a, b in zip(u, v)] for u, v in zip(before.values, end)]
            q = self._rough(list(map(float, q)), mid)
            if q is None:
                raise ValueError("the branch cannot be followed")
        return Solution(self, self.polish_near([mpf(float(x)) for x in q], end)).finish()

    def there(self, poses, what, value):
        """One more pose at a drive value, followed from the nearest of `poses`."""
        i = next(i for i, d in enumerate(self.drives) if d[0] == what)
        near = min(poses, key=lambda s: abs(s.values[i][0] - value))
        self.drives[i][1] = value
        return self.follow(near)

    def polish_near(self, q, values):
        for _ in range(30):
            r = mp.matrix(self.residuals(q, values))
            if max(abs(x) for x in r) < mpf(10) ** -36:
                return q
            q = list(mp.matrix(q) - mp.lu_solve(self.jacobian(q), r))
        raise ValueError("the branch cannot be followed")

    def sweep(self, first, what, values):
        """Poses at each value of drive `what`, followed from `first`."""
        d = next(d for d in self.drives if d[0] == what)
        out, s = [], first
        for v in values:
            d[1] = v
            s = self.follow(s)
            out.append(s)
        return out


def extremes(m, clauses, drive, pair, near=None):
    """The two drive values in [0, one turn) where the pair's coordinate is least and greatest, with their poses."""
    d = next(d for d in m.drives if d[0] == drive)
    keep = list(d)
    d[1], d[2], d[3] = mpf(0), mpf(1), mpf(0)
    first = m.solve(*clauses, near=near)
    n = 72
    ring = m.sweep(first, drive, [2 * pi * i / n for i in range(n + 1)])
    roots = []
    for s, t in zip(ring, ring[1:]):
        v, w = s.relative_velocity(pair), t.relative_velocity(pair)
        if v == 0 or v * w < 0:
            x0, x1 = (mpf(u.values[next(i for i, e in enumerate(m.drives) if e is d)][0]) for u in (s, t))
            d[1] = x0 + (x1 - x0) * (v / (v - w) if v != w else 0)
            u = m.follow(s)
            for _ in range(8):                                # Newton: the derivative of ds/dphi is its second derivative
                if abs(u.relative_velocity(pair)) < mpf(10) ** -34:
                    break
                d[1] = d[1] - u.relative_velocity(pair) / u.relative_acceleration(pair)
                u = m.follow(u, 2)
            roots.append((u.displacement(pair), d[1] % (2 * pi)))
    d[1:] = keep[1:]
    return min(roots), max(roots)


def left_of(c, a, b):
    return lambda s: cross(sub(s.position(b), s.position(a)), sub(s.position(c), s.position(a))) > 0


def right_of(c, a, b):
    return lambda s: not left_of(c, a, b)(s)


def ahead(c, b, pair):
    def test(s):
        _, u = s.m.pair(pair).line(s.f)
        return dot(u, sub(s.position(c), s.position(b))) > 0
    return test


def behind(c, b, pair):
    return lambda s: not ahead(c, b, pair)(s)


def positive(pair):
    return lambda s: s.displacement(pair) > 0


def negative(pair):
    return lambda s: s.displacement(pair) < 0


# ---------------------------------------------------------------- a solved pose
class Solution:
    def __init__(self, m, q):
        self.m, self.q = m, q
        self.values = m.drive_values()
        self.f = m.frames(q)
        self.moves = all(d[2] is not None for d in m.drives) and bool(m.drives)

    # ---- motion
    def finish(self):
        m, n = self.m, len(self.q)
        jac = m.jacobian(self.q) if n else None
        self.jac = jac
        self.q1, self.q2 = [mpf(0)] * n, [mpf(0)] * n
        if self.moves:
            taylor = [[Taylor(p, v, a) for p, v, a in zip(*pva)] for pva in zip(m.drive_values(), m.drive_values(1), m.drive_values(2))]
            q = [Taylor(x) for x in self.q]
            r = mp.matrix([Taylor.of(x).b for x in m.residuals(q, taylor)])
            self.q1 = list(mp.lu_solve(jac, -r))
            q = [Taylor(x, v) for x, v in zip(self.q, self.q1)]
            r = mp.matrix([Taylor.of(x).c for x in m.residuals(q, taylor)])
            self.q2 = list(mp.lu_solve(jac, -r))
        self.t = m.frames([Taylor(*x) for x in zip(self.q, self.q1, self.q2)])
        self._forces()
        return self

    def _locate(self, ref):
        if ref in self.m.links:
            raise ValueError(ref)
        if "." in ref:
            return ref.split(".")
        for p in self.m.pairs:
            if p.name == ref and p.pa in self.m.links[p.a].points:
                return p.a, p.pa
        return next((k.name, ref) for k in self.m.links.values() if ref in k.points)

    def _point(self, ref, order, under=None):
        """`ref` = 'L.P', or a link with `under` = 'K.P': the point of L that lies under K.P now."""
        if under:
            link, p = ref, None
            k, name = under.split(".")
            w = sub(self.f[k].place(self.m.point(k, name)), self.f[link].o)
            f = self.f[link]
            local = (f.c * w[0] + f.s * w[1], -f.s * w[0] + f.c * w[1])
        else:
            link, p = self._locate(ref)
            local = self.m.point(link, p)
        x, y = self.t[link].place(local) if order else self.f[link].place(local)
        if order:
            x, y = Taylor.of(x), Taylor.of(y)
        return (x, y) if not order else ((x.b, y.b) if order == 1 else (x.c, y.c))

    def position(self, ref, under=None):
        return self._point(ref, 0, under)

    def velocity(self, ref, under=None):
        return self._point(ref, 1, under)

    def acceleration(self, ref, under=None):
        return self._point(ref, 2, under)

    def angle(self, link):
        return self.f[link].theta

    def omega(self, link):
        return Taylor.of(self.t[link].theta).b

    def alpha(self, link):
        return Taylor.of(self.t[link].theta).c

    def displacement(self, pair):
        return self.m.pair(pair).coordinate(self.f)

    def relative_velocity(self, pair):
        return Taylor.of(self.m.pair(pair).coordinate(self.t)).b

    def relative_acceleration(self, pair):
        return Taylor.of(self.m.pair(pair).coordinate(self.t)).c

    def coriolis(self, pair):
        p = self.m.pair(pair)
        _, u = p.line(self.f)
        return times(2 * self.omega(p.b) * self.relative_velocity(pair), left(u))

    def mass_centre(self, link, order=2):
        k = self.m.links[link]
        x, y = map(Taylor.of, self.t[link].place(k.centre))
        return [(x.a, y.a), (x.b, y.b), (x.c, y.c)][order]

    def inertia_force(self, link):
        k = self.m.links[link]
        return times(-k.mass, self.mass_centre(link)) if k.mass else (mpf(0), mpf(0))

    def inertia_torque(self, link):
        return -self.m.links[link].inertia * self.alpha(link)

    # ---- forces
    def _wrench(self, load):
        """A load as a list of (link, force, place, couple)."""
        kind, on, where, value, frame, when = load
        if when and not when(self):
            return []
        value = value(self) if callable(value) else value
        if kind == "torque":
            return [(on, (0, 0), (0, 0), value)]
        if kind == "inside":
            return self._inside(on, value)
        if frame:
            value = self.f[frame].turn(value)
        place = self.position(f"{on}.{where}") if isinstance(where, str) else where
        return [(on, value, place, 0)]

    def _inside(self, name, value):
        p = self.m.pair(name)
        if p.kind == "revolute":
            return [(p.b, (0, 0), (0, 0), value), (p.a, (0, 0), (0, 0), -value)]
        if p.kind == "cylinder":
            a, b = p.ends(self.f)
            u = times(1 / mag(sub(b, a)), sub(b, a))
            return [(p.b, times(value, u), b, 0), (p.a, times(-value, u), a, 0)]
        _, u = p.line(self.f)
        c = self.position(f"{p.a}.{p.pa}")
        return [(p.a, times(value, u), c, 0), (p.b, times(-value, u), c, 0)]

    def _spring(self, spring):
        la, pa, lb, pb, k, free, damping = spring
        a, b = self.t[la].place(self.m.point(la, pa)), self.t[lb].place(self.m.point(lb, pb))
        a, b = tuple(map(Taylor.of, a)), tuple(map(Taylor.of, b))
        length = mag(sub(b, a))
        tension = k * (length.a - free) + damping * length.b
        u = ((b[0].a - a[0].a) / length.a, (b[1].a - a[1].a) / length.a)
        return [(la, times(tension, u), (a[0].a, a[1].a), 0), (lb, times(-tension, u), (b[0].a, b[1].a), 0)]

    def _unit(self, balance):
        """The wrench of a unit balance."""
        if balance[0] == "torque":
            return [(balance[1], (0, 0), (0, 0), mpf(1))]
        if balance[0] == "inside":
            return self._inside(balance[1], mpf(1))
        _, on, where, along, frame = balance
        return self._wrench(("force", on, where, at(mpf(1), along), frame, None))

    def applied(self):
        out = [w for load in self.m.loads for w in self._wrench(load)]
        out += [w for s in self.m.springs for w in self._spring(s)]
        for k in self.m.moving():
            if k.mass and k.centre is not None:
                weight = times(k.mass, self.m.gravity)
                out.append((k.name, add(weight, self.inertia_force(k.name)), self.mass_centre(k.name, 0), self.inertia_torque(k.name)))
            elif k.inertia:
                out.append((k.name, (0, 0), (0, 0), self.inertia_torque(k.name)))
        return out

    def _forces(self):
        m = self.m
        self.balance, self.r = {}, {}
        balances = dict(m.balances)
        if not balances:
            for what, *_ in m.drives:
                if "." in what:
                    continue
                balances[f"effort({what})"] = ("torque", what) if what in m.links else ("inside", what)
        rows = {k.name: 3 * i for i, k in enumerate(k for k in m.moving() if not k.outer)}
        columns, names = [], []
        for p in m.pairs:
            for on, other, force, place, couple in p.wrenches(self.f):
                columns.append([(on, force, place, couple), (other, times(-1, force), place, -couple)])
                names.append((p, on, other, force, place, couple))
        for name, b in balances.items():
            columns.append(self._unit(b))
            names.append(name)
        n = 3 * len(rows)
        if n == 0:
            return
        keep = range(n)
        if all(p.kind == "prismatic" for p in m.pairs):       # no link can turn: forces only, 2n = P_L + unknown efforts
            keep = [i for i in range(n) if i % 3 != 2]
            pairs = [j for j, name in enumerate(names) if isinstance(name, str) or name[5] == 0]
            columns, names = [columns[j] for j in pairs], [names[j] for j in pairs]
        if len(columns) != len(keep):
            self.balance = None
            return

        def into(vector, wrench):
            link, force, place, couple = wrench
            if link in rows:
                i = rows[link]
                vector[i] += force[0]
                vector[i + 1] += force[1]
                vector[i + 2] += cross(place, force) + couple
        a, b = mp.matrix(len(keep), len(keep)), mp.matrix(len(keep), 1)
        for j, column in enumerate(columns):
            v = [mpf(0)] * n
            for w in column:
                into(v, w)
            for i, row in enumerate(keep):
                a[i, j] = v[row]
        v = [mpf(0)] * n
        for w in self.applied():
            into(v, w)
        for i, row in enumerate(keep):
            b[i] = -v[row]
        x = mp.lu_solve(a, b)
        assert max(abs(e) for e in a * x - b) < mpf(10) ** -25 * (1 + max(abs(e) for e in b)), "singular"
        for value, name in zip(x, names):
            if isinstance(name, str):
                self.balance[name] = value
                continue
            p, on, other, force, place, couple = name
            for link, sign in ((on, 1), (other, -1)):
                f0, m0 = self.r.get((p.name, link, other if link == on else on), ((mpf(0), mpf(0)), mpf(0)))
                self.r[(p.name, link, other if link == on else on)] = (add(f0, times(sign * value, force)), m0 + sign * value * couple)
        self._check_power(balances)

    def _check_power(self, balances):
        """Virtual power of everything applied is zero for each drive's motion."""
        m = self.m
        if not m.drives or any(k.outer for k in m.moving()):
            return
        wrenches = self.applied() + [(l, times(self.balance[n], f), p, self.balance[n] * c) for n, b in balances.items() for l, f, p, c in self._unit(b)]
        size = self.jac.rows
        count = len(m.drives)
        for i in range(count):
            e = mp.matrix(size, 1)
            e[size - count + i] = 1
            v = mp.lu_solve(self.jac, e)
            power, total = mpf(0), mpf(1)
            for link, force, place, couple in wrenches:
                if link == "ground":
                    continue
                k = 3 * m.links[link].index
                d = sub(place, self.f[link].o)
                part = dot(force, (v[k] - v[k + 2] * d[1], v[k + 1] + v[k + 2] * d[0])) + couple * v[k + 2]
                power += part
                total += abs(part)
            assert abs(power) < mpf(10) ** -24 * total, ("power", mp.nstr(power, 5))

    def reaction(self, pair, link):
        """Force on `link`; of a pin with several links, the sum on its first."""
        out = [v for (p, l, _), v in self.r.items() if p == pair and l == link]
        total = (mpf(0), mpf(0))
        for f, _ in out:
            total = add(total, f)
        assert out, (pair, link)
        return total

    def moment(self, pair, link):
        return sum(v[1] for (p, l, _), v in self.r.items() if p == pair and l == link)

    def normal(self, pair, link):
        p = self.m.pair(pair)
        if p.kind == "contact":
            n, _ = p.normal(self.f)
            if link != p.ends()[0]:
                n = times(-1, n)
        else:
            n = left(p.line(self.f)[1])
        return dot(n, self.reaction(pair, link))

    def contact_force(self, pair, which):
        p = self.m.pair(pair)
        a, b = p.contacts
        force, couple = self.normal(pair, p.a), self.moment(pair, p.a)
        return (couple - b * force) / (a - b) if which == 1 else (a * force - couple) / (a - b)

    def line_offset(self, pair):
        p = self.m.pair(pair)
        return self.displacement(pair) + self.moment(pair, p.a) / self.normal(pair, p.a)


# ---------------------------------------------------------------- printing keys
UNITS = {"m": 1, "mm": mpf("1e-3"), "m/s": 1, "m/s^2": 1, "rad": 1, "deg": mp.pi / 180, "rad/s": 1, "rad/s^2": 1, "N": 1, "kN": 1000,
         "N*m": 1, "kN*m": 1000, "kg": 1, "kg*m^2": 1, "J": 1, "W": 1, "": 1}


def digits(x):
    """Shortest text that reads back to the same double."""
    x = mpf(x)
    if abs(x) < mpf(10) ** -25:
        return "0"
    text = repr(float(x))
    if text.endswith(".0"):
        text = text[:-2]
    return text.replace("e-0", "e-").replace("e+", "e")


def written(value, unit):
    scale = UNITS[unit]
    space = " " if unit else ""
    if isinstance(value, (tuple, list)):
        return "(" + ", ".join(written(v, unit) for v in value) + ")"
    v = mpf(value) / scale
    if unit in ("deg", "rad"):
        turn = 2 * pi / scale
        v -= turn * mp.nint(v / turn)
    return digits(v) + space + unit


def size(value):
    return mag(value) if isinstance(value, (tuple, list)) else abs(mpf(value))


def key(text, value, unit="", tail=""):
    """Print one `expect`: relative within 1e-9, an expected zero within an amount."""
    if size(value) < mpf(10) ** -25:
        zero = f"(0 {unit}, 0 {unit})" if isinstance(value, (tuple, list)) else f"0 {unit}"
        print(f"expect {text} = {zero} within 1e-9 {unit}{tail}")
    else:
        print(f"expect {text} = {written(value, unit)} within 1e-9{tail}")


def keys(text, values, unit):
    """Print a list of expected values, one per pose, within 1e-9 of the greatest."""
    scale = max(size(v) for v in values) / UNITS[unit]
    places = [written(v, unit) for v in values]
    lines = [", ".join(places[i:i + 3]) for i in range(0, len(places), 3)]
    tol = f"1e{int(mp.floor(mp.log10(scale))) - 9} {unit}"
    print(f"expect {text} = " + ",\n            ".join(lines) + f" within {tol}")
