"""Cam and lever with inertia: the cam torque from the power balance, M omega = -(Q - J_P alpha) omega_lever, with the law
differentiated by mpmath; nothing of the geometry of the contact is used."""
from mpmath import mp, mpf, sin, pi, radians, diff, nstr

mp.dps = 30
h, rise = radians(mpf(18)), radians(mpf(60))
dwell, fall = radians(mpf(10)), radians(mpf(70))
omega = mpf(300) * 2 * pi / 60
JP = mpf("0.01") + 2 * mpf("0.065") ** 2
Q = mpf(60)


def lift(phi):
    if phi < rise:
        x = phi / rise
        return h * (x - sin(2 * pi * x) / (2 * pi))
    if phi < rise + dwell:
        return h
    x = (phi - rise - dwell) / fall
    return h * (1 - (10 * x**3 - 15 * x**4 + 6 * x**5))


for deg in (15, 40, 65, 85, 120):
    phi = radians(mpf(deg))
    s1, s2 = diff(lift, phi), diff(lift, phi, 2)
    # the cam turns clockwise, and the rise turns the lever clockwise too
    w, a = -s1 * omega, -s2 * omega**2
    M = -(Q - JP * a) * w / -omega
    print(deg, "omega", nstr(w, 20), "alpha", nstr(a, 20), "M", nstr(M, 20))
