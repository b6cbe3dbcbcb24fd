"""Recompute the answer keys of `.mech` files: a reader of its own for the part of the language the examples use.

    python3 reader.py ../../../examples            # every file below
    python3 reader.py ../../../examples/first.mech

It reads a file into a planar.Mechanism, solves it and compares every `expect`. What it cannot judge it lists as skipped.
"""
import re
import sys
from pathlib import Path

from planar import *
import planar

BASE = {"m": 1, "mm": mpf("1e-3"), "cm": mpf("1e-2"), "km": 1000, "kg": 1, "g": mpf("1e-3"), "t": 1000, "N": 1, "kN": 1000, "MN": 10 ** 6,
        "s": 1, "ms": mpf("1e-3"), "min": 60, "h": 3600, "rad": 1, "deg": pi / 180, "rev": 2 * pi, "rpm": pi / 30, "J": 1, "kJ": 1000,
        "W": 1, "kW": 1000, "Pa": 1, "MPa": 10 ** 6, "%": mpf("0.01"), "Hz": 1}
RESERVED = set("""accelerating against along and as at between ccw cw for from in module moving near not of on or steps through to turning when within
parabolic harmonic cycloidal uniform poly345 poly4567 modified_trapezoid modified_sine""".split())
TOKEN = re.compile(r"""(?P<string>"[^"]*")|(?P<pose>\d+')|(?P<num>\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|(?P<name>[^\W\d][\w']*)|(?P<op>\.\.|<=|>=|[-+*/^@(),.:={}\[\]<>;])|(?P<nl>\n)|(?P<ws>[ \t]+)""")
FACTOR = re.compile(r"([A-Za-z%°]+)(?:\^(-?\d+))?")


class Wrong(Exception):
    pass


class Skip(Exception):
    pass


def unit_at(text, i):
    """Unit word at i: (value, end) or None."""
    m = FACTOR.match(text, i)
    if not m or m[1] not in BASE:
        return None
    value, i = BASE[m[1]] ** int(m[2] or 1), m.end()
    while i < len(text) and text[i] in "*/":
        n = FACTOR.match(text, i + 1)
        if not n or n[1] not in BASE:
            break
        f = BASE[n[1]] ** int(n[2] or 1)
        value = value * f if text[i] == "*" else value / f
        i = n.end()
    return value, i


def tokens(text):
    text = re.sub(r"//[^\n]*", "", text)
    out, i, depth = [], 0, 0
    while i < len(text):
        m = TOKEN.match(text, i)
        if not m:
            raise Wrong(f"cannot read {text[i:i + 20]!r}")
        kind, word, i = m.lastgroup, m[0], m.end()
        if kind == "ws":
            continue
        if kind == "num":
            j = i
            while j < len(text) and text[j] == " ":
                j += 1
            u = unit_at(text, j)
            inverse = re.compile(r"1/").match(text, j)
            if u and not inverse and not (text[j:].split()[0] if text[j:].split() else "") in RESERVED:
                out.append(("quantity", mpf(word) * u[0], word + " " + text[j:u[1]]))
                i = u[1]
            else:
                out.append(("quantity", mpf(word), word))
            continue
        if word in "([" and kind == "op":
            depth += 1
        if word in ")]" and kind == "op":
            depth -= 1
            while out and out[-1][0] == "nl":
                out.pop()
        if kind == "nl" or word == ";":
            prev = out[-1] if out else None
            if depth or not out or prev[0] == "nl" or prev[0] == "op" and prev[1] in ("+", "-", "*", "/", ",", "(", "[", "@", "^", "="):
                continue
            out.append(("nl", "\n", ";" if word == ";" else "\n"))
            continue
        out.append((kind, word, word))
    out.append(("nl", "\n", "\n"))
    return out


class Parser:
    def __init__(self, toks):
        self.t, self.i = toks, 0

    def peek(self, k=0):
        return self.t[self.i + k][1] if self.i + k < len(self.t) else None

    def kind(self, k=0):
        return self.t[self.i + k][0] if self.i + k < len(self.t) else None

    def next(self):
        self.i += 1
        return self.t[self.i - 1][1]

    def take(self, *words):
        if self.kind() in ("name", "op") and self.peek() in words:
            return self.next()
        return None

    def need(self, word):
        if not self.take(word):
            raise Wrong(f"expected {word!r} at {[x[2] for x in self.t[self.i - 3:self.i + 4]]}")

    def name(self):
        if self.kind() != "name" or self.peek() in RESERVED:
            raise Wrong(f"expected a name at {[x[2] for x in self.t[self.i - 3:self.i + 4]]}")
        return self.next()

    def pref(self):
        n = self.name()
        return n + "." + self.name() if self.take(".") else n

    # expressions
    def expr(self):
        e = self.polar()
        while op := self.take("+", "-"):
            e = (op, e, self.polar())
        return e

    def polar(self):
        e = self.prod()
        return ("@", e, self.prod()) if self.take("@") else e

    def prod(self):
        e = self.unary()
        while op := self.take("*", "/"):
            e = (op, e, self.unary())
        return e

    def unary(self):
        if self.take("-"):
            return ("neg", self.unary())
        self.take("+")
        e = self.post()
        return ("^", e, self.unary()) if self.take("^") else e

    def post(self):
        e = self.atom()
        while self.peek() == "." and self.kind() == "op":
            self.next()
            e = (".", e, self.name())
        return e

    def atom(self):
        if self.kind() == "quantity":
            return ("num", self.next())
        if self.take("("):
            e = self.expr()
            if self.take(","):
                e = ("vec", e, self.expr())
            self.need(")")
            return e
        n = self.name()
        if self.take("("):
            args = []
            while not self.take(")"):
                if self.kind() == "name" and self.peek(1) == "=":
                    self.name()
                    self.next()
                args.append(self.expr())
                self.take(",")
            return ("call", n, args)
        return ("name", n)

    def condition(self):
        e = self.conj()
        while self.take("or"):
            e = ("or", e, self.conj())
        return e

    def conj(self):
        e = self.comparison()
        while self.take("and"):
            e = ("and", e, self.comparison())
        return e

    def comparison(self):
        parts = [self.expr()]
        while op := self.take("<", ">", "<=", ">="):
            parts += [op, self.expr()]
        return ("cmp", parts)

    def sense(self):
        return {"cw": -1, "ccw": 1, None: None}[self.take("cw", "ccw")]


def ref(e):
    if e[0] == "name":
        return e[1]
    if e[0] == "." and e[1][0] == "name":
        return e[1][1] + "." + e[2]
    raise Wrong(f"not a reference {e}")


class File:
    """One file as statements, in order."""

    def __init__(self, path):
        self.path = path
        text = path.read_text(encoding="utf-8")
        if text.startswith("mech 1\n"):
            text = text[len("mech 1\n"):]
        p = self.p = Parser(tokens(text))
        self.title, self.given, self.lets, self.links, self.pairs, self.drives = None, {}, [], [], [], []
        self.loads, self.balances, self.assemble, self.find, self.expects, self.groups = [], [], [], {}, [], []
        self.gravity, self.poses, self.springs, self.variants = None, [], [], []
        self.quantities = set()
        while p.i < len(p.t):
            if p.kind() == "nl":
                p.i += 1
                continue
            word = p.name()
            handler = getattr(self, "st_" + word, None)
            if not handler:
                raise Wrong(f"statement {word}")
            handler(word)
            if p.kind() != "nl":
                raise Wrong(f"{word}: what is left {[x[2] for x in p.t[p.i:p.i + 6]]}")

    def quantity(self, n):
        if n in self.quantities:
            raise Wrong(f"quantity {n} twice")
        self.quantities.add(n)
        return n

    def st_mechanism(self, _):
        self.title = self.p.next()

    def st_given(self, _):
        n = self.quantity(self.p.name())
        self.p.need("=")
        self.given[n] = self.p.expr()

    def st_let(self, _):
        n = self.quantity(self.p.name())
        self.p.need("=")
        self.lets.append((n, self.p.expr()))

    def st_gravity(self, _):
        self.gravity = self.p.expr()

    def body(self):
        p, out = self.p, []
        if not p.take("{"):
            return out
        while True:
            while p.kind() == "nl":
                p.i += 1
            if p.take("}"):
                return out
            w = p.name()
            if w == "line":
                n = p.name()
                p.need("through")
                t = p.name()
                out.append((w, n, t, "along", p.expr()) if p.take("along") else (w, n, t, p.next() and "to", p.name()))
            elif w == "circle":
                n = p.name()
                p.need("centre")
                c = p.name()
                p.need("radius")
                out.append((w, n, c, p.expr()))
            elif w in ("mass", "weight", "inertia") and p.peek() != ".":
                v = p.expr()
                out.append((w, v, p.name() if p.take("at", "about") else None))
            else:
                first = p.expr()
                if p.take("from"):
                    a = p.name()
                    second = p.expr()
                    p.need("from")
                    b = p.name()
                    out.append(("compass", w, first, a, second, b, p.take("left", "right")))
                else:
                    out.append(("point", w, first))
            if p.kind() != "nl" and p.peek() != "}":
                raise Wrong(f"member {w}: {[x[2] for x in p.t[p.i:p.i + 6]]}")

    def st_ground(self, _):
        if self.p.kind() == "quantity":
            self.p.next()
        self.links.insert(0, ("ground", None, self.body()))

    def st_link(self, _):
        p = self.p
        if p.kind() == "quantity":
            p.next()
        n, bar = p.name(), None
        if p.kind() == "name":
            a = p.name()
            p.need("-")
            b = p.name()
            bar = (a, b, p.expr())
        self.links.append((n, bar, self.body()))

    def pair_statement(self, kind):
        p = self.p
        n = p.name()
        p.need(":")
        ends = [p.pref()]
        while p.take("-"):
            ends.append(p.pref())
        props = {}
        if p.take("{"):
            while not p.take("}"):
                if p.kind() == "nl":
                    p.i += 1
                    continue
                w = p.name()
                props[w] = [p.expr()]
                while p.take(","):
                    props[w].append(p.expr())
        self.pairs.append((kind, n, ends, props))

    st_revolute = st_prismatic = st_slot = st_contact = st_cylinder = pair_statement

    def st_spring(self, kind):
        self.pair_statement(kind)
        self.springs.append(self.pairs.pop())

    def st_group(self, _):
        p = self.p
        n = p.name()
        p.need(":")
        members = [p.name()]
        while p.take(","):
            members.append(p.name())
        self.groups.append((n, members))

    def st_drive(self, _):
        p = self.p
        what = p.pref()
        p.need("=")
        values = [p.expr()]
        steps = speed = None
        if p.take(".."):
            end = p.expr()
            p.need("in")
            steps = (values[0], end, int(p.next()))
            p.need("steps")
        while p.take(","):
            values.append(p.expr())
        sense = None
        if p.take("at"):
            speed = p.expr()
            sense = p.sense()
        acc = p.expr() if p.take("accelerating") else None
        if p.take("turning", "moving"):
            p.next()
        self.drives.append((what, values, steps, speed, sense, acc))

    def st_pose(self, _):
        p = self.p
        n = p.t[p.i][2]
        p.next()
        p.need("at")
        w = p.pref()
        p.need("=")
        self.poses.append((n, w, p.expr()))

    def st_assemble(self, _):
        p = self.p
        while True:
            x = p.pref()
            if p.take("near"):
                self.assemble.append(("near", x, p.expr()))
            elif side := p.take("left", "right"):
                p.need("of")
                a = p.name()
                p.need("-")
                self.assemble.append((side, x, a, p.name()))
            elif p.take("ahead"):
                p.need("of")
                self.assemble.append(("ahead", x, p.name()))
            elif p.take("behind"):
                self.assemble.append(("behind", x, p.name()))
            else:
                op = p.take("<", ">")
                p.expr()
                self.assemble.append((op, x))
            if not p.take(","):
                return

    def load(self, kind):
        p = self.p
        if p.kind() == "name" and p.peek() not in RESERVED:
            self.quantity(p.name())
        place = None
        if p.take("in"):
            on = ("in", p.name())
        else:
            p.need("on")
            on = ("on", p.name())
            if p.take("at"):
                place = p.expr()
        p.need("=")
        value = p.expr()
        sense = p.sense()
        frame = p.name() if p.take("in") else None
        against = bool(p.take("against") and p.next())
        when = p.condition() if p.take("when") else None
        self.loads.append((kind, on, place, value, sense, frame, against, when))

    st_force = st_torque = load

    def st_balance(self, _):
        p = self.p
        kind = p.next()
        n = self.quantity(p.name())
        if p.take("in"):
            self.balances.append((n, "in", p.name()))
            return
        p.need("on")
        on = p.name()
        if kind == "torque":
            self.balances.append((n, "torque", on))
            return
        p.need("at")
        place = p.expr()
        p.need("along")
        along = p.expr()
        self.balances.append((n, "force", on, place, along, p.name() if p.take("in") else None))

    def st_find(self, _):
        p = self.p
        while True:
            n = None
            if p.kind() == "name" and p.peek(1) == "=":
                n = self.quantity(p.name())
                p.next()
            e = p.expr()
            if p.take("as"):
                while p.kind() != "nl" and p.peek() != ",":
                    p.next()
            if n:
                self.find[n] = e
            if not p.take(","):
                return

    def st_expect(self, _):
        p = self.p
        start = p.i
        parts = p.comparison()[1]
        values = None
        if p.take("="):
            values = [p.expr()]
            while p.take(","):
                values.append(p.expr())
        text = "".join(x[2] for x in p.t[start:p.i])
        within = where = None
        plain = False
        if p.take("within"):
            plain = " " not in p.t[p.i][2] and p.kind() == "quantity"
            within = p.expr()
        if p.take("at"):
            if p.take("pose"):
                where = ("pose", p.t[p.i][2])
                p.next()
            else:
                w = p.pref()
                p.need("=")
                where = ("drive", w, p.expr())
        self.expects.append((text, parts, values, within, plain, where))

    def st_variants(self, _):
        p = self.p
        p.need("{")
        rows, row = [], []
        while True:
            if p.kind() == "nl":
                p.i += 1
                if row:
                    rows.append(row)
                    row = []
                continue
            if p.take("}"):
                break
            if p.kind() == "name" and not rows:
                n = p.name()
                scale = mpf(1)
                if p.take("["):
                    text = ""
                    while not p.take("]"):
                        text += p.t[p.i][2]
                        p.next()
                    scale = unit_at(text, 0)[0]
                row.append((n, scale))
            else:
                sign = -1 if p.take("-") else 1
                row.append(sign * p.next())
            p.take(",")
        head = rows[0]
        self.variants = [{n: ("num", v * scale) for (n, scale), v in zip(head, r)} for r in rows[1:]]


# ---------------------------------------------------------------- evaluation
class Case:
    """One file with one row of givens."""

    def __init__(self, f, row):
        self.f, self.row = f, row
        self.names = {}
        for n, e in {**f.given, **row}.items():
            self.names[n] = e
        self.names.update(dict(f.lets))
        self.names.update(f.find)
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
        if n in ("min", "max", "mean", "integral", "argmax", "time_ratio", "transmission_angle", "pressure_angle"):
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
            a = args[0]
            if a[0] == "vec":
                return getattr(s, n)(ref(a[1]), under=ref(a[2]))
            r = ref(a)
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
                m.balance_inside(b[0], b[2])
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
            tol = self.value(within) if within else mpf("0.01") * planar.size(want)
            if plain and within:
                tol *= planar.size(want)
            if diff > tol / 1000 and diff > mpf(10) ** -15 * max(planar.size(want), mpf(10) ** -9):
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
