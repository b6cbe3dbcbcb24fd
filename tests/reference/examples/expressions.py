"""Tokens and expressions of the `.mech` language, as far as the examples use it."""
import re

from taylor import *

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
