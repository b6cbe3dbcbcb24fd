"""A small general solver for planar mechanisms, independent of the Rust code.

Position: Newton on the constraint equations of all pairs and drives at once, in the coordinates
(x, y, theta) of every moving link. Velocity and acceleration: the same constraint functions evaluated on
Taylor numbers (value, first and second time derivative). Forces: one linear system, the Newton-Euler
equations of every moving link at once. No groups, no closed forms, so nothing is shared with the solver
whose answers it checks. The last step of everything is done in mpmath with 40 digits.

Every solution is checked twice before a number leaves this file: all assembly modes are looked for from
random starts and the clauses must leave exactly one; and the virtual power of all loads, inertia forces and
balances is zero for the motion of each drive. Needs mpmath, or the stand-in in ../decimals.
"""
import math
import random

from pairs import *
from printing import *
from solution import Solution
from taylor import *


class Mechanism:
    def __init__(self, gravity=None):
        self.links = {"ground": Link("ground", {})}
        self.pairs, self.drives, self.loads, self.balances, self.springs = [], [], [], {}, []
        self.rows = None
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

    def balance_inside(self, name, *pairs):
        self.balances[name] = ("inside", *pairs)

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
        return list(self.equations(self.frames(q, fast), values, fast).values())

    def equations(self, f, values, fast=False, of=None):
        """What is left of each equation by its row; with `of` of those alone that can hold for that link."""
        out = {}
        pairs, after = self._rows(f)
        for p, row, links in pairs:
            if of is None or of in links:
                for x in p.residuals(f):
                    out[row] = x
                    row += 1
        for (what, *_), value, (row, links) in zip(self.drives, values, after):
            if of is not None and of not in links:
                continue
            for g, v in zip(self.driven(f, what), value):
                d = g - v
                if fast and (what in self.links or "." not in what and self.pair(what).kind == "revolute"):
                    d = math.remainder(d, 2 * math.pi)
                out[row] = d
                row += 1
            if "." in what:
                out[row] = f[what.split(".")[0]].theta
        return out

    def _rows(self, f):
        """Each pair with its first row and its links, and the same of each drive: found once."""
        of = (len(self.pairs), len(self.drives))
        if self.rows is None or self.rows[0] != of:
            row, pairs, drives = 0, [], []
            for p in self.pairs:
                pairs.append((p, row, (p.a, p.b)))
                row += len(p.residuals(f))
            for what, *_ in self.drives:
                name = what.split(".")[0]
                drives.append((row, (name,) if name in self.links else (self.pair(what).a, self.pair(what).b)))
                row += 3 if "." in what else 1
            self.rows = (of, pairs, drives)
        return self.rows[1:]

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
        q = [float(x) for x in start]
        vals = [[float(x) for x in v] for v in values]
        r = self.residuals(q, vals, True)
        before = math.inf
        for i in range(60):
            norm = max(abs(x) for x in r)
            if norm < 1e-11:
                return q
            if i % 6 == 5:
                if norm > 0.5 * before:                       # it wanders about: another start is cheaper
                    return None
                before = norm
            step = least_squares(self._differences(q, vals, r), [-x for x in r])
            k = 1.0
            while k > 1e-3:
                new = [a + k * b for a, b in zip(q, step)]
                rn = self.residuals(new, vals, True)
                if max(abs(x) for x in rn) < norm:
                    break
                k /= 2
            q, r = new, rn
        return None

    def _differences(self, q, values, r):
        """Columns of the Jacobian by differences, each as {row: value}: a link moves the equations of its own pairs alone."""
        h, f, columns = 1e-7, self.frames(q, True), []
        names = {k.index: k.name for k in self.moving()}
        for j in range(0, len(q), 3):
            name = names[j // 3]
            still = f[name]
            for i in range(3):
                p = q[j:j + 3]
                p[i] += h
                f[name] = Frame(*p, True)
                moved = self.equations(f, values, True, name)
                columns.append({i: (a - r[i]) / h for i, a in moved.items() if a != r[i]})
            f[name] = still
        return columns

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
            q = self._rough(start, values)
            if q is None or max(abs(x) for x in q) > 1e3 * scale + 1e3:
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


def least_squares(columns, right):
    """The step that leaves least of the equations, in double precision; damped where they are dependent."""
    n = len(columns)
    # the upper half of the normal equations, from the diagonal on, with the right side behind
    rows = []
    for i, u in enumerate(columns):
        u = list(u.items())
        row = [sum([a * v[k] for k, a in u if k in v]) for v in columns[i:]]
        row.append(sum([a * right[k] for k, a in u]))
        rows.append(row)
    scale = max((row[0] for row in rows), default=1.0)
    for row in rows:
        row[0] += 1e-13 * scale
    for k, head in enumerate(rows):
        if head[0] == 0:
            head[0] = 1e-13 * scale or 1.0
        for i in range(1, n - k):
            if head[i]:
                factor = head[i] / head[0]
                rows[k + i] = [a - factor * b for a, b in zip(rows[k + i], head[i:])]
    x = [0.0] * n
    for k in reversed(range(n)):
        row = rows[k]
        x[k] = (row[-1] - sum([a * b for a, b in zip(row[1:-1], x[k + 1:])])) / row[0]
    return x


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
