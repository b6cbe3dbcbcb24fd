"""A solved pose: motion from the Taylor numbers, forces from one Newton-Euler system of all links."""
from taylor import *


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
            return [w for pair in balance[1:] for w in self._inside(pair, mpf(1))]
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
