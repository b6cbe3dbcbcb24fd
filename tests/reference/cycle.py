"""Quantities over the cycle of a crank-slider, by energies: M_b = d(T + V)/dphi - F dx/dphi at constant speed, each
derivative by series of 40 digits, integrals by Gauss-Legendre between the places where the load switches."""
from mpmath import mp, mpf, sin, cos, sqrt, pi, quad, findroot, taylor, diff

mp.dps = 40
r, l = mpf("0.1"), mpf("0.35")
a, J2 = mpf("0.12"), mpf("0.03")          # mass centre of the rod from B, its moment of inertia
m2, m3, g = mpf("2.5"), mpf(3), mpf("9.81")
n = mpf(1500)
w = n * 2 * pi / 60


def x(phi):
    return r * cos(phi) + sqrt(l**2 - (r * sin(phi)) ** 2)


def dx(phi):
    s = sqrt(l**2 - (r * sin(phi)) ** 2)
    return -r * sin(phi) - r**2 * sin(phi) * cos(phi) / s


def energy(phi):
    """Kinetic and potential energy at constant speed."""
    s = sqrt(l**2 - (r * sin(phi)) ** 2)
    w2 = -r * cos(phi) / s                 # of the rod over that of the crank
    # S at B + a (cos th, sin th), sin th = -r sin(phi)/l
    sth, cth = -r * sin(phi) / l, s / l
    vx = -r * sin(phi) - a * sth * w2
    vy = r * cos(phi) + a * cth * w2
    T = w**2 / 2 * (m2 * (vx**2 + vy**2) + J2 * w2**2 + m3 * dx(phi) ** 2)
    V = m2 * g * (r * sin(phi) + a * sth)
    return T + V


def Mb(phi, F=0):
    return diff(energy, phi) - F * dx(phi)


def root(f, near):
    return findroot(f, near, tol=mpf(10) ** -60)


def show(name, value):
    print(f"{name:32} {mp.nstr(value, 20)}")


# smooth
show("mean(velocity(C).x^2)", quad(lambda p: (w * dx(p)) ** 2, [0, pi / 2, pi, 3 * pi / 2, 2 * pi]) / (2 * pi))
top = root(lambda p: diff(dx, p), mpf("5.0"))
show("max(velocity(C).x)", w * dx(top))
show("argmax(velocity(C).x)", top)
show("mean(Mb^2)", quad(lambda p: Mb(p) ** 2, [i * pi / 4 for i in range(9)]) / (2 * pi))
show("mean(Mb)", quad(Mb, [i * pi / 4 for i in range(9)]) / (2 * pi))
# switching: on the way out (x grows from pi to 2 pi), between 0.2 and 0.7 of the stroke, -4 kN
least, stroke = l - r, 2 * r
on = root(lambda p: x(p) - least - stroke * mpf("0.2"), mpf("4.2"))
off = root(lambda p: x(p) - least - stroke * mpf("0.7"), mpf("5.2"))
F = mpf(-4000)


def loaded(phi):
    return Mb(phi, F if on < phi < off else 0)


ends = [0, pi / 2, pi, on, off, 2 * pi]
parts = [(u, v) for u, v in zip(ends, ends[1:])]


def over(f):
    return sum(quad(f, [u, (u + v) / 2, v]) for u, v in parts)


show("on", on)
show("off", off)
show("mean(Mb) loaded", over(loaded) / (2 * pi))
show("work of the load / 2 pi", -F * stroke / 2 / (2 * pi))
show("mean(Mb^2) loaded", over(lambda p: loaded(p) ** 2) / (2 * pi))
mean = -F * stroke / 2 / (2 * pi)


def W(phi):
    done = energy(phi) - energy(0) - mean * phi
    if phi > on:
        done -= F * (x(min(phi, off)) - x(on))
    return done


places = [0, on, off]
N = 2000
grid = [2 * pi * i / N for i in range(N + 1)]
values = [loaded(p) - mean for p in grid]
for i in range(N):
    if values[i] * values[i + 1] < 0 and not any(grid[i] <= e <= grid[i + 1] for e in (on, off)):
        places.append(findroot(lambda p: loaded(p) - mean, (grid[i], grid[i + 1]), solver="anderson", tol=mpf(10) ** -50))
most = max(places, key=W)
least_at = min(places, key=W)
show("greatest work at", most)
show("least work at", least_at)
show("[W]", W(most) - W(least_at))
show("J, delta 1/50", (W(most) - W(least_at)) / (w**2 / 50))
inertia = quad(lambda p: 2 * (energy(p) - m2 * g * (r * sin(p) - a * r * sin(p) / l)) / w**2, [i * pi / 4 for i in range(9)]) / (2 * pi)
show("mean reduced inertia of the links", inertia)
