"""Numbers with two time derivatives, and vectors as tuples; everything else is built on them."""
import math

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
