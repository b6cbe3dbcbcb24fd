"""Links, their frames, and pairs: each gives its constraint equations and the wrenches it can carry."""
import math

from taylor import *


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
    doubles = None

    def residuals(self, f):
        first, second = f[self.a], f[self.b]
        if f.fast:
            (x, y), (u, v) = self.doubles or self._doubles()
            return [second.o[0] + (second.c * u - second.s * v) - (first.o[0] + (first.c * x - first.s * y)),
                    second.o[1] + (second.s * u + second.c * v) - (first.o[1] + (first.s * x + first.c * y))]
        return list(sub(second.place(self.m.point(self.b, self.pb)), first.place(self.m.point(self.a, self.pa))))

    def _doubles(self):
        """The two points in double precision, which the search for poses asks for again and again."""
        ends = ((self.a, self.pa), (self.b, self.pb))
        self.doubles = [tuple(map(float, self.m.point(*end))) for end in ends]
        return self.doubles

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
