"""The part of mpmath that the reference scripts use, on the decimal numbers of the standard library, so that they run
wherever Python does. With mpmath installed leave this folder off the path: the scripts print the same digits.

`mpf` keeps `mp.dps` digits and ten more; functions are summed as series after the argument is reduced.
"""
import decimal
import functools
from decimal import Decimal

GUARD = 10


def _number(x):
    if isinstance(x, mpf):
        return x.d
    if isinstance(x, Decimal):
        return x
    return Decimal(x)


class mpf:
    """A real number; `f` keeps the nearest double once it was asked for."""
    __slots__ = ("d", "f")

    def __init__(self, x=0):
        self.d = +_number(x)

    # two of the kind first: most operations are of this sort
    def __add__(self, o):
        if type(o) is mpf:
            x = _new(mpf)
            x.d = self.d + o.d
            return x
        return _made(self.d + _number(o)) if isinstance(o, _REAL) else _complex(self, o, "__add__")

    def __sub__(self, o):
        if type(o) is mpf:
            x = _new(mpf)
            x.d = self.d - o.d
            return x
        return _made(self.d - _number(o)) if isinstance(o, _REAL) else _complex(self, o, "__sub__")

    def __rsub__(self, o):
        return _made(_number(o) - self.d) if isinstance(o, _REAL) else _complex(self, o, "__rsub__")

    def __mul__(self, o):
        if type(o) is mpf:
            x = _new(mpf)
            x.d = self.d * o.d
            return x
        return _made(self.d * _number(o)) if isinstance(o, _REAL) else _complex(self, o, "__mul__")

    def __truediv__(self, o):
        if not isinstance(o, _REAL):
            return NotImplemented
        o = _number(o)
        if not o:
            raise ZeroDivisionError
        return _made(self.d / o)

    def __rtruediv__(self, o):
        if not isinstance(o, _REAL):
            return NotImplemented
        if not self.d:
            raise ZeroDivisionError
        return _made(_number(o) / self.d)

    def __mod__(self, o):
        b = _number(o)
        return _made(self.d - b * (self.d / b).to_integral_value(decimal.ROUND_FLOOR))

    def __pow__(self, o):
        if type(o) is int and o == 2:
            return _made(self.d * self.d)
        return _made(self.d ** _number(o))

    def __rpow__(self, o):
        return _made(_number(o) ** self.d)

    def __neg__(self):
        return _made(-self.d)

    def __pos__(self):
        return _made(+self.d)

    def __abs__(self):
        return _made(abs(self.d))

    def __float__(self):
        try:
            return self.f
        except AttributeError:
            self.f = float(self.d)
            return self.f

    def __int__(self):
        return int(self.d)

    def __bool__(self):
        return bool(self.d)

    def __hash__(self):
        return hash(self.d)

    def __eq__(self, o):
        return self.d == _number(o) if isinstance(o, (int, float, mpf)) else NotImplemented

    def __lt__(self, o):
        return self.d < _number(o)

    def __le__(self, o):
        return self.d <= _number(o)

    def __gt__(self, o):
        return self.d > _number(o)

    def __ge__(self, o):
        return self.d >= _number(o)

    def __complex__(self):
        return complex(float(self.d))

    def __repr__(self):
        return f"mpf('{self.d}')"

    def __str__(self):
        return nstr(self, 15)

    __radd__, __rmul__ = __add__, __mul__

    @property
    def real(self):
        return self

    @property
    def imag(self):
        return mpf(0)


_REAL, _new = (int, float, mpf), object.__new__


def _made(d):
    x = _new(mpf)
    x.d = d
    return x


def _complex(x, o, method):
    return getattr(mpc(x), method)(o) if isinstance(o, (complex, mpc)) else NotImplemented


def _epsilon():
    return Decimal(10) ** -(decimal.getcontext().prec + 2)


_PI = {}


def _pi():
    """Machin's formula, once for each number of digits."""
    digits = decimal.getcontext().prec
    if digits not in _PI:
        with decimal.localcontext() as c:
            c.prec = digits + 10

            def arctan(n):
                total, power, k, end = Decimal(0), Decimal(1) / n, 0, Decimal(10) ** -(digits + 8)
                while abs(power) > end:
                    total += (power / (2 * k + 1)) * (-1) ** k
                    power /= n * n
                    k += 1
                return total
            _PI[digits] = 4 * (4 * arctan(5) - arctan(239))
    return +_PI[digits]


class _Pi(mpf):
    """π to the digits of the moment."""
    __slots__ = ()

    def __init__(self):
        pass

    @property
    def d(self):
        return _pi()


def _circle(x):
    """Sine and cosine together, by the series of a small angle, made small by thirds: sin 3a = 3 sin a − 4 sin³ a,
    cos 3a = 4 cos³ a − 3 cos a."""
    turn = 2 * _pi()
    x -= turn * (x / turn).to_integral_value()
    steps = 0
    while abs(x) > Decimal("0.01"):
        x /= 3
        steps += 1
    term, total, k, end, square = x, x, 1, _epsilon() * abs(x), -x * x
    while abs(term) > end:
        term *= square / ((k + 1) * (k + 2))
        total += term
        k += 2
    cosine = (1 - total * total).sqrt()
    for _ in range(steps):
        total, cosine = total * (3 - 4 * total * total), cosine * (4 * cosine * cosine - 3)
    return total, cosine


def _kept(f):
    # one angle is often taken several times in a row
    @functools.lru_cache(maxsize=256)
    def value(x, digits):
        with decimal.localcontext() as c:
            c.prec = digits + 10
            return f(x)
    return value


def _reduced(f):
    value = _kept(f)

    def function(x):
        return _made(+value(_number(x), decimal.getcontext().prec))
    return function


_circle = _kept(_circle)


def sin(x):
    return _made(+_circle(_number(x), decimal.getcontext().prec)[0])


def cos(x):
    return _made(+_circle(_number(x), decimal.getcontext().prec)[1])


def tan(x):
    sine, cosine = _circle(_number(x), decimal.getcontext().prec)
    return _made(sine / cosine)


def _atan(x):
    if abs(x) > 1:
        return (_pi() / 2).copy_sign(x) - _atan(1 / x)
    steps = 0
    while abs(x) > Decimal("0.05"):
        x /= 1 + (1 + x * x).sqrt()
        steps += 1
    power, total, k, end, square = x, x, 1, _epsilon(), x * x
    while power and abs(power) > end * abs(total):
        power = -power * square
        k += 2
        total += power / k
    return total * 2 ** steps


def _asin(x):
    if abs(x) > 1:
        raise ValueError(f"asin of {x}")
    return (_pi() / 2).copy_sign(x) if abs(x) == 1 else _atan(x / ((1 - x) * (1 + x)).sqrt())


atan, asin = _reduced(_atan), _reduced(_asin)
acos = _reduced(lambda x: _pi() / 2 - _asin(x))
exp = _reduced(lambda x: x.exp())
sqrt_real = _reduced(lambda x: x.sqrt())


def sqrt(x):
    if _number(x) < 0:
        raise ValueError(f"root of {x}")
    return sqrt_real(x)


def log(x, base=None):
    return _made(_number(x).ln()) if base is None else _made(_number(x).ln() / _number(base).ln())


def log10(x):
    return _made(_number(x).log10())


def atan2(y, x):
    y, x = mpf(y), mpf(x)
    if x > 0:
        return atan(y / x)
    if not x:
        return pi / 2 * sign(y)
    return atan(y / x) + (pi if y >= 0 else -pi)


def hypot(x, y):
    return sqrt(mpf(x) * x + mpf(y) * y)


def sign(x):
    return mpf((x > 0) - (x < 0))


def nint(x):
    return _made(_number(x).to_integral_value(decimal.ROUND_HALF_EVEN))


def floor(x):
    return _made(_number(x).to_integral_value(decimal.ROUND_FLOOR))


def radians(x):
    return mpf(x) * pi / 180


def degrees(x):
    return mpf(x) * 180 / pi


def linspace(a, b, n):
    a, b = mpf(a), mpf(b)
    return [a + (b - a) * i / (n - 1) for i in range(n)]


def nstr(x, n=6):
    if isinstance(x, (list, tuple)):
        return "[" + ", ".join(nstr(v, n) for v in x) + "]"
    d = _number(x)
    with decimal.localcontext() as c:
        c.prec = n
        d = +d
    if d == d.to_integral_value() and abs(d) < Decimal(10) ** n:
        return f"{int(d)}.0"
    digits = format(d.normalize(), "f") if -5 <= d.adjusted() < n else format(d.normalize(), "e")
    return digits


# ---------------------------------------------------------------- calculus
def _with_digits(digits, f):
    with decimal.localcontext() as c:
        c.prec = digits
        return f()


def diff(f, x, n=1, **_):
    """Derivative by central differences of 8th order with as many digits more as they lose."""
    digits = decimal.getcontext().prec
    weights = {1: ["1/280", "-4/105", "1/5", "-4/5", "0", "4/5", "-1/5", "4/105", "-1/280"],
               2: ["-1/560", "8/315", "-1/5", "8/5", "-205/72", "8/5", "-1/5", "8/315", "-1/560"]}
    if n == 0:
        return mpf(f(mpf(x)))
    if n > 2:
        return diff(lambda t: diff(f, t, 2), x, n - 2)

    def differences():
        h = mpf(10) ** -(digits // 8 + 2)
        total = mpf(0)
        for i, weight in enumerate(weights[n]):
            if weight != "0":
                top, _, bottom = weight.partition("/")
                total = f(mpf(x) + (i - 4) * h) * int(top) / int(bottom or 1) + total
        return total / h ** n
    found = _with_digits(digits + n * (digits // 8 + 2) + 10, differences)
    return +found


def taylor(f, x, n):
    """Coefficients up to the order n."""
    values, factor = [], 1
    for k in range(n + 1):
        factor *= max(k, 1)
        values.append(diff(f, x, k) / factor)
    return values


def findroot(f, start, solver="secant", tol=None, **_):
    """The secant method from one start or two; from two on both sides of the root it stays between them. Several
    unknowns by Newton's method."""
    if isinstance(start, (tuple, list)):
        try:
            value = f(*start)
        except TypeError:
            value = None
        if isinstance(value, (tuple, list, matrix)):
            return _several(f, [mpf(x) for x in start])
    a, b = (mpf(start[0]), mpf(start[1])) if isinstance(start, (tuple, list)) else (mpf(start), mpf(start) + mpf("0.25"))
    fa, fb = f(a), f(b)
    between = isinstance(start, (tuple, list)) and fa * fb < 0
    end = mpf(10) ** -(mp.dps - 2)
    side = 0
    for _ in range(400):
        if fb == fa or not fb:
            return b
        c = b - fb * (b - a) / (fb - fa)
        fc = f(c)
        if abs(c - b) <= end * (1 + abs(c)) or not fc:
            return c
        if not between:
            a, fa, b, fb = b, fb, c, fc
        elif fb * fc < 0:
            a, fa, b, fb, side = b, fb, c, fc, 0
        else:
            # Anderson and Björck: the end that stays counts for less
            m = 1 - fc / fb
            fa, b, fb = fa * (m if m > 0 else mpf("0.5")), c, fc
    raise ValueError("no root")


def _several(f, x):
    end = mpf(10) ** -(mp.dps - 3)
    for _ in range(60):
        value = list(f(*x))
        step = mpf(10) ** -(mp.dps // 2)
        columns = [list(f(*[a + (step if i == j else 0) for i, a in enumerate(x)])) for j in range(len(x))]
        jacobian = matrix([[(c[i] - value[i]) / step for c in columns] for i in range(len(value))])
        move = lu_solve(jacobian, matrix(value))
        x = [a - b for a, b in zip(x, move)]
        if all(abs(b) <= end * (1 + abs(a)) for a, b in zip(x, move)):
            return matrix(x)
    raise ValueError("no root")


_NODES = {}


def _nodes(digits):
    """Nodes and weights of Gauss and Legendre on −1 … 1."""
    count = max(20, digits)
    if (count, digits) not in _NODES:
        nodes = []
        for i in range(1, count // 2 + 1):
            x = cos(pi * (mpf(i) - mpf("0.25")) / (count + mpf("0.5")))
            for _ in range(60):
                p, before = x, mpf(1)
                for k in range(2, count + 1):
                    p, before = ((2 * k - 1) * x * p - (k - 1) * before) / k, p
                slope = count * (x * p - before) / (x * x - 1)
                step = p / slope
                x -= step
                if abs(step) < mpf(10) ** -(digits - 2):
                    break
            weight = 2 / ((1 - x * x) * slope * slope)
            nodes += [(x, weight), (-x, weight)]
        _NODES[count, digits] = nodes
    return _NODES[count, digits]


def quad(f, points):
    """Integral over the points in turn: each part in four, Gauss and Legendre in each."""
    total = mpf(0)
    for a, b in zip(points, points[1:]):
        for i in range(4):
            lo, hi = (mpf(a) + (mpf(b) - a) * k / 4 for k in (i, i + 1))
            half, middle = (hi - lo) / 2, (hi + lo) / 2
            total += half * sum((w * f(middle + half * x) for x, w in _nodes(40)), mpf(0))
    return total


# ---------------------------------------------------------------- complex numbers
class mpc:
    """A complex number of two `mpf`."""

    def __init__(self, x, y=0):
        self.real, self.imag = mpf(x), mpf(y)

    @staticmethod
    def of(x):
        return x if isinstance(x, mpc) else mpc(x.real, x.imag)

    def __add__(self, o):
        o = mpc.of(o)
        return mpc(self.real + o.real, self.imag + o.imag)

    def __neg__(self):
        return mpc(-self.real, -self.imag)

    def __sub__(self, o):
        return self + -mpc.of(o)

    def __rsub__(self, o):
        return mpc.of(o) - self

    def __mul__(self, o):
        o = mpc.of(o)
        return mpc(self.real * o.real - self.imag * o.imag, self.real * o.imag + self.imag * o.real)

    def __truediv__(self, o):
        o = mpc.of(o)
        size = o.real * o.real + o.imag * o.imag
        top = self * mpc(o.real, -o.imag)
        return mpc(top.real / size, top.imag / size)

    def __pos__(self):
        return mpc(+self.real, +self.imag)

    def __abs__(self):
        return hypot(self.real, self.imag)

    __radd__, __rmul__ = __add__, __mul__


def expj(x):
    return mpc(cos(x), sin(x))


def conj(z):
    z = mpc.of(z)
    return mpc(z.real, -z.imag)


def im(z):
    return mpc.of(z).imag


# ---------------------------------------------------------------- matrices
class matrix:
    """A matrix of `mpf`; with one column it is indexed and iterated as a list."""

    def __init__(self, rows, columns=None):
        if isinstance(rows, matrix):
            self.rows, self.cols, self.a = rows.rows, rows.cols, list(rows.a)
        elif isinstance(rows, int):
            self.rows, self.cols = rows, rows if columns is None else columns
            self.a = [mpf(0)] * (self.rows * self.cols)
        else:
            rows = [r if isinstance(r, (list, tuple)) else [r] for r in rows]
            self.rows, self.cols = len(rows), len(rows[0]) if rows else 0
            self.a = [mpf(x) for r in rows for x in r]

    def _at(self, i):
        return i[0] * self.cols + i[1] if isinstance(i, tuple) else i

    def __getitem__(self, i):
        return self.a[self._at(i)]

    def __setitem__(self, i, x):
        self.a[self._at(i)] = mpf(x)

    def __len__(self):
        return self.rows if self.cols == 1 else self.rows * self.cols

    def __iter__(self):
        return iter(self.a)

    def copy(self):
        return matrix(self)

    def _each(self, f):
        out = matrix(self)
        out.a = [f(x) for x in self.a]
        return out

    def _both(self, o, f):
        out = matrix(self)
        out.a = [f(x, y) for x, y in zip(self.a, o.a)]
        return out

    def __neg__(self):
        return self._each(lambda x: -x)

    def __add__(self, o):
        return self._both(o, lambda x, y: x + y)

    def __sub__(self, o):
        return self._both(o, lambda x, y: x - y)

    def __mul__(self, o):
        if not isinstance(o, matrix):
            return self._each(lambda x: x * o)
        out = matrix(self.rows, o.cols)
        for i in range(self.rows):
            for j in range(o.cols):
                out[i, j] = sum((self[i, k] * o[k, j] for k in range(self.cols)), mpf(0))
        return out

    def __rmul__(self, o):
        return self * o

    def __truediv__(self, o):
        return self._each(lambda x: x / o)

    @property
    def T(self):
        out = matrix(self.cols, self.rows)
        for i in range(self.rows):
            for j in range(self.cols):
                out[j, i] = self[i, j]
        return out


def lu_solve(a, b):
    """The solution of a x = b; with more rows than columns that of least squares."""
    if a.rows > a.cols:
        return lu_solve(a.T * a, a.T * b)
    n = a.rows
    rows = [[a[i, j].d for j in range(n)] + [b[i].d] for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        head = rows[k]
        if not head[k]:
            raise ZeroDivisionError("matrix is numerically singular")
        for row in rows[k + 1:]:
            if row[k]:
                factor = row[k] / head[k]
                for j in range(k, n + 1):
                    row[j] -= factor * head[j]
    x = [Decimal(0)] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum((rows[k][j] * x[j] for j in range(k + 1, n)), Decimal(0))) / rows[k][k]
    return matrix([_made(v) for v in x])


# ---------------------------------------------------------------- precision
class _Digits:
    def __init__(self, digits):
        self.digits = digits

    def __enter__(self):
        self.before = mp.dps
        mp.dps = self.digits

    def __exit__(self, *_):
        mp.dps = self.before


class _Context:
    """`mp`: the number of digits, and all functions."""

    @property
    def dps(self):
        return decimal.getcontext().prec - GUARD

    @dps.setter
    def dps(self, digits):
        decimal.getcontext().prec = digits + GUARD

    @staticmethod
    def workdps(digits):
        return _Digits(digits)

    def __getattr__(self, name):
        return globals()[name]


decimal.getcontext().Emin, decimal.getcontext().Emax = decimal.MIN_EMIN, decimal.MAX_EMAX
mp = _Context()
mp.dps = 15
pi = _Pi()
