"""Flywheels of an engine and of a punch press, by energies: the work of the balance is the change of kinetic and potential
energy less the work of the loads, in closed form; its extremes are the roots of the difference to the mean torque."""
from mpmath import mp, mpf, sin, cos, sqrt, pi, quad, findroot, diff

mp.dps = 30


class Slider:
    """A crank-slider: crank r, rod l with its mass centre a from B; x is counted along the guide."""

    def __init__(self, r, l, a, m2, J2, m3, w, g=0):
        self.__dict__.update(r=mpf(r), l=mpf(l), a=mpf(a), m2=mpf(m2), J2=mpf(J2), m3=mpf(m3), w=w, g=mpf(g))

    def x(self, p):
        return self.r * cos(p) + sqrt(self.l**2 - (self.r * sin(p)) ** 2)

    def dx(self, p):
        s = sqrt(self.l**2 - (self.r * sin(p)) ** 2)
        return -self.r * sin(p) - self.r**2 * sin(p) * cos(p) / s

    def inertia(self, p):
        """Reduced to the crank."""
        r, l, a = self.r, self.l, self.a
        s = sqrt(l**2 - (r * sin(p)) ** 2)
        w2, sth, cth = -r * cos(p) / s, -r * sin(p) / l, s / l
        vx, vy = -r * sin(p) - a * sth * w2, r * cos(p) + a * cth * w2
        return self.m2 * (vx**2 + vy**2) + self.J2 * w2**2 + self.m3 * self.dx(p) ** 2

    def weights(self, p):
        """Potential energy, gravity along +x."""
        s = sqrt(self.l**2 - (self.r * sin(p)) ** 2)
        return -self.g * (self.m2 * (self.r * cos(p) + self.a * s / self.l) + self.m3 * self.x(p))

    def energy(self, p):
        return self.w**2 * self.inertia(p) / 2 + self.weights(p)


def key(name, value, unit, tail="within 1e-9"):
    print(f"expect {name} = {float(value)!r} {unit} {tail}".replace("  ", " "))


def flywheel(machine, done, ends, delta, ratio, shift):
    """`done(phi)` is the work of the loads from 0 on, `ends` where they switch; prints the key."""
    cycle = ends[-1]
    W0 = machine.energy(0)
    balance = lambda p: machine.energy(p) - W0 - done(p)
    mean = balance(cycle) / cycle
    work = lambda p: balance(p) - mean * p
    places = list(ends)
    for a, b in zip(ends, ends[1:]):
        inside = lambda p: diff(work, p, h=mpf(10) ** -12)
        n = 200
        grid = [a + (b - a) * (i + mpf("1e-6")) / n if i < n else b - (b - a) * mpf("1e-8") for i in range(n + 1)]
        values = [inside(p) for p in grid]
        for i in range(n):
            if values[i] * values[i + 1] < 0:
                places.append(findroot(inside, (grid[i], grid[i + 1]), solver="anderson", tol=mpf(10) ** -24))
    most, least = max(places, key=work), min(places, key=work)
    W = work(most) - work(least)
    J = W / (delta * (ratio * machine.w) ** 2)
    own = quad(machine.inertia, [cycle * i / 16 for i in range(17)]) / cycle / ratio**2
    key("mean(Mb)", mean, "N*m")
    key("fluctuation(J)", W, "J")
    key("argmax(work(J))", most + shift, "rad")
    key("argmax(-work(J))", least + shift, "rad")
    key("J", J, "kg*m^2")
    key("L", J - own, "kg*m^2")
    return J


print("// engine")
w = mpf(2400) * 2 * pi / 60
m = Slider("0.045", "0.15", "0.045", "0.8", "0.003", "0.6", w)
area = pi * mpf("0.088") ** 2 / 4
c0 = mpf("0.09") / 8
p0, p3, dp = mpf(100_000), mpf(4_000_000), mpf(10_000)
n = mpf("1.3")
c = lambda p: c0 + m.r + m.l - m.x(p)


def gas(p):
    """Work of the gases from 0 on: of p c^n = const, in closed form."""
    poly = lambda k, c_1, c_2: k * (c_1 ** (1 - n) - c_2 ** (1 - n)) / (n - 1)
    sum_ = mpf(0)
    q = min(p, pi)
    sum_ += area * (poly(p3 * c0**n, c0, c(q)) - p0 * (c(q) - c0))
    if p > pi:
        q = min(p, 2 * pi)
        sum_ += area * dp * (c(q) - c(pi))
    if p > 2 * pi:
        q = min(p, 3 * pi)
        sum_ -= area * dp * (c(q) - c0)
    if p > 3 * pi:
        sum_ += area * (poly((p0 - dp) * (9 * c0) ** n, 9 * c0, c(p)) - p0 * (c(p) - 9 * c0))
    return sum_


J = flywheel(m, gas, [mpf(0), pi, 2 * pi, 3 * pi, 4 * pi], mpf(1) / 60, 1, pi / 2)
b = sqrt(4 * J / (mpf("1.2") * pi * mpf("0.32") ** 3 * 7200))
key("rim(J).width", b * 1000, "mm")
key("rim(J).mass", 4 * J / mpf("0.32") ** 2, "kg")

print("// punch press")
m = Slider("0.04", "0.4", "0.13", 60, "1.2", 150, mpf(60) * 2 * pi / 60, "9.81")
# the drive's 90 deg is the upper end; counted from there
up = lambda p: p + pi
F, way = mpf(300_000), mpf("0.008")
far = m.r + m.l


class Shifted(Slider):
    def inertia(self, p):
        return Slider.inertia(self, p + pi)

    def weights(self, p):
        return Slider.weights(self, p + pi)


s = Shifted("0.04", "0.4", "0.13", 60, "1.2", 150, m.w, "9.81")
on = findroot(lambda p: m.x(p + pi) - (far - way), mpf("2.5"), tol=mpf(10) ** -40)
done = lambda p: -F * (m.x(min(p, pi) + pi) - (far - way)) if p > on else mpf(0)
J = flywheel(s, done, [mpf(0), on, pi, 2 * pi], mpf("0.1"), 8, pi / 2)
b = sqrt(4 * mpf("9.81") * J / (pi * mpf("0.8") ** 3 * mpf(70600)))
key("rim(J).width", b * 1000, "mm")
