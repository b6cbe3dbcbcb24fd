"""Read a `.mech` file into plain statements: the part of the language the examples use."""
from expressions import *


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
            pairs = [p.name()]
            while p.take(","):
                pairs.append(p.name())
            self.balances.append((n, "in", pairs))
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
