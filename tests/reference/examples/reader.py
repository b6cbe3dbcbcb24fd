"""Recompute the answer keys of `.mech` files: a reader of its own for the part of the language the examples use.

    python3 reader.py ../../../examples            # every file below
    python3 reader.py ../../../examples/first.mech

It reads a file into a planar.Mechanism, solves it and compares every `expect`. What it cannot judge it lists as skipped.
"""
import sys
from pathlib import Path

from mechfile import *
from planar import *
import printing


class Case:
    """One file with one row of givens."""

    def __init__(self, f, row):
        self.f, self.row = f, row
        self.names = {}
        for n, e in {**f.given, **row}.items():
            self.names[n] = e
        self.names.update(dict(f.lets))
        self.names.update(f.find)
        things = [n for n, *_ in f.links] + [n for _, n, *_ in f.pairs] + [n for n, _ in f.groups] + [n for _, n, *_ in f.springs]
        if len(set(things)) != len(things):
            raise Wrong("a name of a link, pair or group twice")
        self.s = None
        self.build()
        self.run()

    def value(self, e, s=None):
        s = s or self.s
        op = e[0]
        if op == "num":
            return mpf(e[1])
        if op == "name":
            if s and s.balance and e[1] in s.balance:
                return s.balance[e[1]]
            if e[1] == "pi":
                return +pi
            if e[1] not in self.names:
                raise Wrong(f"unknown name {e[1]}")
            return self.value(self.names[e[1]], s)
        if op == "vec":
            return (self.value(e[1], s), self.value(e[2], s))
        if op == "neg":
            v = self.value(e[1], s)
            return times(-1, v) if isinstance(v, tuple) else -v
        if op in "+-*/^@" and len(e) == 3:
            a, b = self.value(e[1], s), self.value(e[2], s)
            if op == "@":
                return at(a, b)
            if op == "^":
                return a ** b
            if isinstance(a, tuple) and isinstance(b, tuple):
                return add(a, b) if op == "+" else sub(a, b)
            if isinstance(a, tuple):
                return times(b if op == "*" else 1 / b, a)
            if isinstance(b, tuple):
                return times(a, b)
            return {"+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "/": lambda: a / b}[op]()
        if op == ".":
            v = self.value(e[1], s)
            return v[e[2]] if isinstance(v, dict) else v["xy".index(e[2])]
        if op == "call":
            return self.call(e[1], e[2], s)
        if op == "cmp":
            vals = [x if isinstance(x, str) else self.value(x, s) for x in e[1]]
            return all({"<": a < b, ">": a > b, "<=": a <= b, ">=": a >= b}[o] for a, o, b in zip(vals[::2], vals[1::2], vals[2::2]))
        if op == "and":
            return self.value(e[1], s) and self.value(e[2], s)
        if op == "or":
            return self.value(e[1], s) or self.value(e[2], s)
        raise Wrong(str(e))

    def call(self, n, args, s):
        plain = {"sqrt": mp.sqrt, "abs": abs, "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "asin": mp.asin, "acos": mp.acos, "atan": mp.atan,
                 "atan2": mp.atan2, "mag": mag, "dot": dot, "cross": cross}
        if n in plain:
            return plain[n](*(self.value(a, s) for a in args))
        if n in ("min", "max") and len(args) > 1:
            return {"min": min, "max": max}[n](self.value(a, s) for a in args)
        if n in ("min", "max", "mean", "integral", "argmax"):
            raise Skip(n)
        if n == "dir":
            return at(mpf(1), s.angle(ref(args[0])))
        if n == "unit":
            v = self.value(args[0], s)
            return times(1 / mag(v), v)
        if n in ("dead", "stroke", "travel"):
            lo, hi = self.extremes(ref(args[0]))
            if n == "stroke":
                return hi[0] - lo[0]
            if n == "travel":
                return s.displacement(ref(args[0])) - lo[0]
            return (lo, hi)[int(args[1][1]) - 1][1]
        if n in ("position", "velocity", "acceleration"):
            if len(args) == 2:
                return getattr(s, n)(ref(args[0]), under=ref(args[1]))
            r = ref(args[0])
            if "." not in r:
                self.shared(r)
            return getattr(s, n)(r)
        if n in ("angle", "omega", "alpha", "displacement", "relative_velocity", "relative_acceleration", "coriolis", "inertia_force", "inertia_torque", "line_offset"):
            return getattr(s, n)(ref(args[0]))
        if n in ("reaction", "moment", "normal"):
            j = ref(args[0])
            if len(args) == 1:
                return s.reaction(j, s.m.pair(j).b)
            return getattr(s, n)(j, ref(args[1]))
        if n == "contact_force":
            return s.contact_force(ref(args[0]), int(args[1][1]))
        if n == "time_ratio":
            lo, hi = self.extremes(ref(args[0]))
            way = (hi[1] - lo[1]) % (2 * pi)
            return max(way, 2 * pi - way) / min(way, 2 * pi - way)
        if n == "transmission_angle":
            return self.transmission(s, ref(args[0]))
        if n == "pressure_angle":
            p = s.m.pair(ref(args[0]))
            u = s.velocity(f"{p.b}.{p.pb}")                       # the examples ask it of a follower's point only
            return mp.acos(abs(dot(p.normal(s.f)[0], u)) / mag(u))
        if n == "inertia_arm":
            return abs(s.inertia_torque(ref(args[0]))) / mag(s.inertia_force(ref(args[0])))
        if n == "effort":
            return s.balance[f"effort({ref(args[0])})"]
        if n == "static_substitution":
            link, b, c = map(ref, args)
            return self.substitution(s, link, b, c)
        if n == "dynamic_substitution":
            link, b = map(ref, args)
            return self.substitution(s, link, b, None)
        raise Skip(n)

    def transmission(self, s, group):
        """Angle between the two links of a dyad at their common hinge; only where it is acute."""
        one, two = dict(self.f.groups)[group]
        pair = next(p for p in s.m.pairs if {p.a, p.b} == {one, two})
        c = s.position(pair.name)
        ends = [s.position(p.name) for p in s.m.pairs if len({p.a, p.b} & {one, two}) == 1]
        u, v = (sub(e, c) for e in ends)
        angle = mp.acos(dot(u, v) / (mag(u) * mag(v)))
        if angle > pi / 2:
            raise Skip("an obtuse transmission angle")
        return angle

    def shared(self, name):
        """A bare point name must be one place only."""
        having = [k.name for k in self.m.links.values() if name in k.points]
        pairs = [set(x.split(".")[0] for x in e) for k, n, e, _ in self.f.pairs if n == name and k == "revolute"]
        joined = set().union(*pairs) if pairs else set()
        for k, n, e, _ in self.f.pairs:
            if k == "revolute" and n == name:
                joined |= set(x.split(".")[0] for x in e)
        if len(having) > 1 and not set(having) <= joined:
            raise Wrong(f"point {name} is on {having}, joined are {joined}")

    def substitution(self, s, link, b, c):
        k = s.m.links[link]
        rb = sub(k.points[b], k.centre)
        lb = mag(rb)
        if c:
            lc = mag(sub(k.points[c], k.centre))
            p2 = k.points[c]
        else:
            lc = k.inertia / (k.mass * lb)
            p2 = sub(k.centre, times(lc / lb, rb))
        m1, m2 = k.mass * lc / (lb + lc), k.mass * lb / (lb + lc)
        k.points["second'"] = p2
        a1, a2 = s.acceleration(f"{link}.{b}"), s.acceleration(f"{link}.second'")
        return {"m1": m1, "m2": m2, "P2": p2, "l2": lc, "a2": a2, "F1": times(-m1, a1), "F2": times(-m2, a2), "dJ": k.inertia - m1 * lb ** 2 - m2 * lc ** 2}

    def extremes(self, pair):
        if not hasattr(self, "ends"):
            self.ends = {}
        if pair not in self.ends:
            drive = self.f.drives[0][0]
            keep = self.m.loads, self.m.balances
            self.m.loads, self.m.balances = [], {}
            self.ends[pair] = extremes(self.m, self.clauses, drive, pair, self.near)
            self.m.loads, self.m.balances = keep
        return self.ends[pair]

    def build(self):
        f = self.f
        g = self.value(f.gravity) if f.gravity else None
        if g is not None and not isinstance(g, tuple):
            g = (mpf(0), -g)
        m = self.m = Mechanism(g)
        for name, bar, body in f.links:
            points = {}
            if bar:
                points = {bar[0]: (mpf(0), mpf(0)), bar[1]: (self.value(bar[2]), mpf(0))}
            for mem in body:
                if mem[0] == "point":
                    if mem[1] in points:
                        raise Wrong(f"point {name}.{mem[1]} twice")
                    points[mem[1]] = self.value(mem[2])
                if mem[0] == "compass":
                    _, n, r1, a, r2, b, side = mem
                    r1, r2 = self.value(r1), self.value(r2)
                    d = sub(points[b], points[a])
                    l = mag(d)
                    x = (r1 ** 2 - r2 ** 2 + l ** 2) / (2 * l)
                    y = mp.sqrt(r1 ** 2 - x ** 2) * (1 if side == "left" else -1)
                    points[n] = add(points[a], add(times(x / l, d), times(y / l, left(d))))
            m.ground(**points) if name == "ground" else m.link(name, **points)
            for mem in body:
                if mem[0] == "line":
                    m.line(f"{name}.{mem[1]}", mem[2], along=self.value(mem[4]) if mem[3] == "along" else None, to=mem[4] if mem[3] == "to" else None)
                if mem[0] == "circle":
                    m.circle(f"{name}.{mem[1]}", mem[2], self.value(mem[3]))
            masses = [x for x in body if x[0] in ("mass", "weight")]
            inertia = [x for x in body if x[0] == "inertia"]
            if masses or inertia:
                mass = centre = None
                if masses:
                    mass = self.value(masses[0][1])
                    if masses[0][0] == "weight":
                        mass = mass / mag(m.gravity)
                    centre = masses[0][2] or next(iter(points))
                J = self.value(inertia[0][1]) if inertia else 0
                m.mass(name, mass or 0, centre, J=J, about=inertia[0][2] if inertia else None)
        for kind, n, ends, props in f.pairs:
            if kind == "revolute":
                m.revolute(n, *ends)
            elif kind == "prismatic":
                m.prismatic(n, *ends, angle=self.value(props["angle"][0]) if "angle" in props else None,
                            contacts=tuple(self.value(x) for x in props["contacts"]) if "contacts" in props else None)
            else:
                getattr(m, kind)(n, *ends)
        for _, n, (a, b), props in f.springs:
            m.spring(a, b, *(self.value(props[k][0]) if k in props else 0 for k in ("stiffness", "free_length", "damping")))
        self.clauses, self.near = [], {}
        for c in f.assemble:
            if c[0] == "near":
                x = c[1]
                self.near[x] = self.value(c[2])
            elif c[0] in ("left", "right"):
                self.clauses.append((left_of if c[0] == "left" else right_of)(*c[1:]))
            elif c[0] in ("ahead", "behind"):
                guide = next(n for k, n, e, _ in f.pairs if k == "prismatic" and (e[0].endswith("." + c[1])))
                self.clauses.append((ahead if c[0] == "ahead" else behind)(c[1], c[2], guide))
            else:
                self.clauses.append((positive if c[0] == ">" else negative)(c[1]))
        for what, values, steps, speed, sense, acc in f.drives:
            m.drive(what, self.value(("num", 0)) if "." not in what else (0, 0), None if speed is None else self.signed(speed, sense), self.value(acc) if acc else 0)
        for load in f.loads:
            self.add_load(load)
        for b in f.balances:
            if b[1] == "in":
                m.balance_inside(b[0], *b[2])
            elif b[1] == "torque":
                m.balance_torque(b[0], b[2])
            else:
                m.balance_force(b[0], b[2], b[3][1] if b[3][0] == "name" else self.value(b[3]), self.value(b[4]), b[5])

    def signed(self, speed, sense):
        v = self.value(speed)
        return times(sense or 1, v) if isinstance(v, tuple) else (sense or 1) * v

    def add_load(self, load):
        kind, on, place, value, sense, frame, against, when = load
        test = (lambda s: self.value(when, s)) if when else None
        amount = (lambda s: (lambda v: times(sense or 1, v) if isinstance(v, tuple) else (sense or 1) * v)(self.value(value, s)))
        if on[0] == "in":
            self.m.inside(on[1], amount)
        elif kind == "torque":
            if against:
                self.m.torque(on[1], lambda s: -amount(s) * mp.sign(s.omega(on[1])), when=test)
            else:
                self.m.torque(on[1], amount, when=test)
        else:
            where = place[1] if place and place[0] == "name" else (self.value(place) if place else next(iter(self.m.links[on[1]].points)))
            if against:
                def opposed(s):
                    v = s.velocity(f"{on[1]}.{where}")
                    return times(-amount(s) / mag(v), v) if mag(v) > mpf(10) ** -25 else (mpf(0), mpf(0))
                self.m.force(on[1], where, opposed, when=test)
            else:
                self.m.force(on[1], where, amount, frame=frame, when=test)

    def run(self):
        f, m = self.f, self.m
        lists = []
        for i, (what, values, steps, *_) in enumerate(f.drives):
            if steps:
                a, b, n = self.value(steps[0]), self.value(steps[1]), steps[2]
                vals = [a + (b - a) * k / n for k in range(n + 1)]
                if abs(abs(b - a) - 2 * pi) < mpf(10) ** -20 and (what in m.links or m.pair(what).kind == "revolute"):
                    vals = vals[:-1]
            else:
                vals = [self.value(v) for v in values]
            m.drives[i][1] = vals[0]
            lists.append(vals)
        first = m.solve(*self.clauses, near=self.near)
        longest = max(range(len(lists)), key=lambda i: len(lists[i])) if lists else None
        self.sols = [first]
        if lists and len(lists[longest]) > 1:
            self.what = f.drives[longest][0]
            self.sols = m.sweep(first, self.what, lists[longest])
        self.s = self.sols[0]
        self.named = {str(i + 1): s for i, s in enumerate(self.sols)}
        for n, w, e in f.poses:
            self.named[n] = self.elsewhere(w, e)

    def elsewhere(self, w, e):
        return self.m.there(self.sols, w, self.value(e))

    def expect(self, item):
        """(passed, got, wanted)"""
        text, parts, values, within, plain, where = item
        sols = self.sols
        if where:
            sols = [self.named[where[1]]] if where[0] == "pose" else [self.elsewhere(where[1], where[2])]
        if values is None:
            e = ("cmp", parts) if len(parts) > 1 else parts[0]
            return bool(self.value(e, sols[0])), None, None
        if len(values) > 1 and len(values) != len(sols):
            raise Wrong(f"{len(values)} values for {len(sols)} poses")
        if len(values) == 1 and len(sols) > 1 and not self.fixed(parts[0]):
            raise Wrong("one value in a sweep")
        ok, worst = True, None
        for v, s in zip(values, sols):
            want, got = self.value(v, s), self.value(parts[0], s)
            if isinstance(want, tuple) != isinstance(got, tuple):
                raise Wrong("a vector against a number")
            diff = mag(sub(want, got)) if isinstance(want, tuple) else abs(want - got)
            if parts[0][0] == "call" and parts[0][1] == "angle":
                diff = abs((want - got) - 2 * pi * mp.nint((want - got) / (2 * pi)))
            tol = self.value(within) if within else mpf("0.01") * printing.size(want)
            if plain and within:
                tol *= printing.size(want)
            if diff > tol / 1000 and diff > mpf(10) ** -15 * max(printing.size(want), mpf(10) ** -9):
                ok = False
                worst = (got, want)
        return ok, *(worst or (None, None))

    def fixed(self, e):
        return e[0] == "call" and e[1] in ("stroke", "dead", "min", "max", "mean", "time_ratio")


def check(path):
    good = True
    f = File(path)
    for row in f.variants or [{}]:
        case = Case(f, row)
        passed, skipped = 0, []
        for item in f.expects:
            try:
                ok, got, want = case.expect(item)
            except Skip as e:
                skipped.append(str(e))
                continue
            if ok:
                passed += 1
            else:
                good = False
                print(f"  WRONG {item[0]}: got {got}")
        if case.s.balance is None:
            print("  forces are not determinate")
        print(f"{path}: {passed} right" + (f", skipped {', '.join(skipped)}" if skipped else ""))
    return good


if __name__ == "__main__":
    files = [p for a in sys.argv[1:] for p in ([Path(a)] if a.endswith(".mech") else sorted(Path(a).rglob("*.mech")))]
    fine = True
    for p in files:
        try:
            fine &= check(p)
        except Exception as e:
            fine = False
            print(f"{p}: {type(e).__name__} {e}")
    sys.exit(0 if fine else 1)
